#include "declared.h"

#include "ranges.h"

#include <math.h>
#include <string.h>

/* In powers of length, mass and stiffness; rows as in the tables of ranges. */
typedef struct {
    double length, mass, stiffness;
} dimension;

enum {
    BODY_MASS = 0,
    LEG_STIFFNESS = 2,
    FREE_LENGTH = 4,
    STANCE_TORQUE = 7,
    RETRACTION_RATE = 12,
    THRUST = 14
};
enum { GROUND_HEIGHT = 2 };

static const dimension of_parameter[] = {{0, 1, 0},     {0, 1, 0},  {0, 0, 1},      {0, 0.5, 0.5}, {1, 0, 0},
                                         {1, 0, 0},     {1, -1, 1}, {2, 0, 1},      {0, 0, 0},     {2, 0, 1},
                                         {2, 0.5, 0.5}, {0, 0, 0},  {0, -0.5, 0.5}, {0, 0, 0},     {1, 0, 0}};
static const dimension of_input[] = {{0, 0, 0}, {2, 0, 1}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0},
                                     {1, 0, 1}, {1, 0, 1}, {0, 0, 0}, {2, 0, 1}, {1, 0, 0}};
static const dimension of_state[] = {{1, 0, 0},      {1, 0, 0},      {1, 0, 0},      {0, 0, 0},
                                     {1, -0.5, 0.5}, {1, -0.5, 0.5}, {1, -0.5, 0.5}, {0, -0.5, 0.5}};

static double unit_of(const tdmf_parameters *p, const dimension *d) {
    return pow(p->leg.free_length, d->length) * pow(p->body.mass, d->mass) *
           pow(p->leg.stiffness, d->stiffness);
}

static double clip(const tdmf_range *range, double value) {
    return fmax(range->minimum, fmin(range->maximum, value));
}

/* Where a range reaches 0, fifteen decades below its end. */
static double anywhere(random_source *source, const tdmf_range *range) {
    const double end = range->maximum;
    const double sign = range->minimum < 0.0 && random_chance(source, 0.5) ? -1.0 : 1.0;
    return sign * random_magnitude(source, range->minimum > 0.0 ? range->minimum : 1e-15 * end, end);
}

/* Around what: a hundredth of the unit, which is for a push the weight. */
static double typical_value(const tdmf_range *range) {
    return range->start == 0.0 ? 0.01 : range->start;
}

static double value_of(random_source *source, const tdmf_range *range, double unit, double decades) {
    if (random_chance(source, 0.03)) {
        return clip(range, 0.0);
    }
    if (isinf(decades) || random_chance(source, 0.01)) {
        return anywhere(source, range);
    }
    const double sign = random_chance(source, 0.05 * fmin(decades, 4.0)) ? -1.0 : 1.0;
    return clip(range,
                sign * typical_value(range) * unit * pow(10.0, random_uniform(source, -decades, decades)));
}

tdmf_inputs declared_inputs(random_source *source, const tdmf_parameters *parameters, double decades) {
    tdmf_inputs inputs = tdmf_default_inputs();
    inputs.ground.friction =
        value_of(source, &tdmf_input_ranges[0], unit_of(parameters, &of_input[0]), decades);
    /* Its start is 0: a share of the stance torque. */
    const tdmf_range torque = tdmf_parameter_ranges[STANCE_TORQUE];
    inputs.hip.external_torque =
        random_chance(source, 0.5)
            ? 0.0
            : clip(&tdmf_input_ranges[1],
                   0.1 * value_of(source, &torque, unit_of(parameters, &of_input[1]), decades));
    return inputs;
}

void declared_further_inputs(random_source *source, const tdmf_parameters *parameters, double decades,
                             tdmf_inputs *inputs) {
    for (int i = GROUND_HEIGHT; i < TDMF_INPUT_COUNT; ++i) {
        const tdmf_range *range = &tdmf_input_ranges[i];
        if (random_chance(source, 0.5)) {
            const double value = value_of(source, range, unit_of(parameters, &of_input[i]), decades);
            *(double *)((char *)inputs + range->offset) = random_chance(source, 0.5) ? -value : value;
        }
    }
}

static double *place_of(tdmf_parameters *parameters, int row) {
    return (double *)((char *)parameters + tdmf_parameter_ranges[row].offset);
}

declared_runner declared_random(random_source *source, double decades) {
    static const int scales[] = {BODY_MASS, LEG_STIFFNESS, FREE_LENGTH};
    declared_runner runner = {.parameters = tdmf_default_parameters()};
    for (int i = 0; i < 3; ++i) {
        *place_of(&runner.parameters, scales[i]) = anywhere(source, &tdmf_parameter_ranges[scales[i]]);
    }
    for (int i = 0; i < (int)tdmf_parameter_count; ++i) {
        if (i != scales[0] && i != scales[1] && i != scales[2]) {
            *place_of(&runner.parameters, i) = value_of(
                source, &tdmf_parameter_ranges[i], unit_of(&runner.parameters, &of_parameter[i]), decades);
        }
    }
    runner.parameters.leg.min_length =
        fmin(runner.parameters.leg.min_length, runner.parameters.leg.free_length);
    runner.inputs = declared_inputs(source, &runner.parameters, decades);
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        const double range = i == TDMF_LEG_ANGLE || i == TDMF_LEG_LENGTH ? fmin(decades, 0.3) : decades;
        runner.state[i] = value_of(source, &tdmf_state_ranges[i], unit_of(&runner.parameters, &of_state[i]),
                                   isinf(decades) ? decades : range);
    }
    return runner;
}

void declared_settings(random_source *source, double decades, tdmf_parameters *parameters) {
    for (int i = STANCE_TORQUE; i <= THRUST; ++i) {
        const bool is_setting = i <= RETRACTION_RATE || i == THRUST;
        if (is_setting && random_chance(source, 0.5)) {
            *place_of(parameters, i) =
                value_of(source, &tdmf_parameter_ranges[i], unit_of(parameters, &of_parameter[i]), decades);
        }
    }
}
