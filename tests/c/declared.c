#include "declared.h"

#include "count_of.h"
#include "ranges.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A unit is a product of powers of length, mass and stiffness. */
typedef struct {
    double length, mass, stiffness;
} dimension;

/* A second is sqrt(m/k) here. */
static const dimension si_kg = {0, 1, 0}, si_m = {1, 0, 0}, si_s = {0, 0.5, -0.5}, si_rad = {0, 0, 0};
static const dimension si_newton = {1, 0, 1}, si_joule = {2, 0, 1}, no_unit = {0, 0, 0};

static void unknown(const char *what, const char *name) {
    fprintf(stderr, "no %s of the tests: %s\n", what, name);
    abort();
}

static dimension dimension_of_factor(const char *name, size_t length) {
    static const struct {
        const char *name;
        const dimension *dimension;
    } known[] = {{"kg", &si_kg},  {"m", &si_m},      {"s", &si_s},    {"rad", &si_rad},
                 {"1", &no_unit}, {"N", &si_newton}, {"J", &si_joule}};
    for (size_t i = 0; i < COUNT_OF(known); ++i) {
        if (strlen(known[i].name) == length && memcmp(known[i].name, name, length) == 0) {
            return *known[i].dimension;
        }
    }
    unknown("unit", name);
    return no_unit;
}

/* Dimension of a unit in the table's notation, such as "kg.m2/s2". */
static dimension dimension_of(const char *unit) {
    dimension product = no_unit;
    double sign = 1.0;
    while (unit != NULL && *unit != '\0') {
        const size_t length = strcspn(unit, "./23");
        const dimension factor = dimension_of_factor(unit, length);
        unit += length;
        const double power = sign * (*unit == '2' || *unit == '3' ? *unit++ - '0' : 1);
        product.length += power * factor.length;
        product.mass += power * factor.mass;
        product.stiffness += power * factor.stiffness;
        sign = *unit == '/' ? -1.0 : sign;
        unit += *unit != '\0';
    }
    return product;
}

static double unit_of(const tdmf_parameters *p, const tdmf_range *range) {
    const dimension d = dimension_of(range->unit);
    return pow(p->leg.free_length, d.length) * pow(p->body.mass, d.mass) * pow(p->leg.stiffness, d.stiffness);
}

static double clip(const tdmf_range *range, double value) {
    return fmax(range->minimum, fmin(range->maximum, value));
}

/* A value from a whole range; a range that reaches 0 is drawn over fifteen decades below its end. */
static double value_in_range(random_source *source, const tdmf_range *range) {
    const double end = range->maximum;
    const double sign = range->minimum < 0.0 && random_chance(source, 0.5) ? -1.0 : 1.0;
    return sign * random_magnitude(source, range->minimum > 0.0 ? range->minimum : 1e-15 * end, end);
}

/* Centre of the values drawn: the start value, or a hundredth of the unit if the start value is 0. */
static double typical_value(const tdmf_range *range) {
    return range->start == 0.0 ? 0.01 : range->start;
}

static double value_of(random_source *source, const tdmf_range *range, double unit, double decades) {
    if (random_chance(source, 0.03)) {
        return clip(range, 0.0);
    }
    if (isinf(decades) || random_chance(source, 0.01)) {
        return value_in_range(source, range);
    }
    const double sign = random_chance(source, 0.05 * fmin(decades, 4.0)) ? -1.0 : 1.0;
    return clip(range,
                sign * typical_value(range) * unit * pow(10.0, random_uniform(source, -decades, decades)));
}

static const tdmf_range *row_at(const tdmf_range *rows, size_t count, size_t offset) {
    for (size_t i = 0; i < count; ++i) {
        if (rows[i].offset == offset) {
            return &rows[i];
        }
    }
    unknown("row", "an offset");
    return NULL;
}

static const tdmf_range *parameter_at(size_t offset) {
    return row_at(tdmf_parameter_ranges, TDMF_PARAMETER_COUNT, offset);
}

static const tdmf_range *input_at(size_t offset) {
    return row_at(tdmf_input_ranges, TDMF_INPUT_COUNT, offset);
}

tdmf_inputs declared_inputs(random_source *source, const tdmf_parameters *parameters, double decades) {
    const tdmf_range *friction = input_at(offsetof(tdmf_inputs, ground.friction));
    const tdmf_range *external_torque = input_at(offsetof(tdmf_inputs, hip.external_torque));
    tdmf_inputs inputs = tdmf_default_inputs();
    inputs.ground.friction = value_of(source, friction, unit_of(parameters, friction), decades);
    /* Its start is 0: a share of the stance torque. */
    const tdmf_range *torque = parameter_at(offsetof(tdmf_parameters, hip.stance_torque));
    inputs.hip.external_torque =
        random_chance(source, 0.5)
            ? 0.0
            : clip(external_torque, 0.1 * value_of(source, torque, unit_of(parameters, torque), decades));
    return inputs;
}

void declared_further_inputs(random_source *source, const tdmf_parameters *parameters, double decades,
                             tdmf_inputs *inputs) {
    for (int i = 0; i < TDMF_INPUT_COUNT; ++i) {
        const tdmf_range *range = &tdmf_input_ranges[i];
        const bool is_further = range->offset != offsetof(tdmf_inputs, ground.friction) &&
                                range->offset != offsetof(tdmf_inputs, hip.external_torque);
        if (is_further && random_chance(source, 0.5)) {
            const double value = value_of(source, range, unit_of(parameters, range), decades);
            *(double *)((char *)inputs + range->offset) = random_chance(source, 0.5) ? -value : value;
        }
    }
}

static double *member_of(tdmf_parameters *parameters, const tdmf_range *range) {
    return (double *)((char *)parameters + range->offset);
}

/* A parameter that is drawn first, because the units of the others are made of it. */
static bool is_scale(const tdmf_range *range) {
    return range->offset == offsetof(tdmf_parameters, body.mass) ||
           range->offset == offsetof(tdmf_parameters, leg.stiffness) ||
           range->offset == offsetof(tdmf_parameters, leg.free_length);
}

declared_runner declared_random(random_source *source, double decades) {
    declared_runner runner = {.parameters = tdmf_default_parameters()};
    for (int i = 0; i < TDMF_PARAMETER_COUNT; ++i) {
        const tdmf_range *range = &tdmf_parameter_ranges[i];
        if (is_scale(range)) {
            *member_of(&runner.parameters, range) = value_in_range(source, range);
        }
    }
    for (int i = 0; i < TDMF_PARAMETER_COUNT; ++i) {
        const tdmf_range *range = &tdmf_parameter_ranges[i];
        if (!is_scale(range)) {
            *member_of(&runner.parameters, range) =
                value_of(source, range, unit_of(&runner.parameters, range), decades);
        }
    }
    runner.parameters.leg.min_length =
        fmin(runner.parameters.leg.min_length, runner.parameters.leg.free_length);
    const tdmf_range *fall = parameter_at(offsetof(tdmf_parameters, ground.stribeck_velocity));
    if (runner.parameters.ground.stribeck_velocity < 1e-10 * unit_of(&runner.parameters, fall)) {
        runner.parameters.ground.stribeck_velocity = 0.0;
    }
    /* No more than its end, so that half of the patches are none. */
    runner.parameters.ground.patch_begin =
        fmin(runner.parameters.ground.patch_begin, runner.parameters.ground.patch_end);
    runner.parameters.hip.swing_clamp = random_truth(*source);
    runner.inputs = declared_inputs(source, &runner.parameters, decades);
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        const tdmf_range *range = &tdmf_state_ranges[i];
        const double near = TDMF_FOOT_X + i == TDMF_LEG_ANGLE || TDMF_FOOT_X + i == TDMF_LEG_LENGTH
                                ? fmin(decades, 0.3)
                                : decades;
        runner.state[TDMF_FOOT_X + i] =
            value_of(source, range, unit_of(&runner.parameters, range), isinf(decades) ? decades : near);
    }
    return runner;
}

void declared_settings(random_source *source, double decades, tdmf_parameters *parameters) {
    for (int i = 0; i < TDMF_PARAMETER_COUNT; ++i) {
        const tdmf_range *range = &tdmf_parameter_ranges[i];
        if (range->at_events && random_chance(source, 0.5)) {
            *member_of(parameters, range) = value_of(source, range, unit_of(parameters, range), decades);
        }
    }
}
