/* Parameters and inputs: defaults, ranges, refusals, and the constants derived once.
 *
 * Scales of the paper's normalisation (section 5): length l0, time sqrt(m/k), and what follows from them. */
#include "tdmf_slip/parameters.h"

#include "input_rates.h"
#include "margins.h"
#include "ranges.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

static const tdmf_refusal accepted = {0};

static double value_at(const void *values, size_t offset) {
    double value;
    memcpy(&value, (const char *)values + offset, sizeof value);
    return value;
}

static void fill_with_starts(void *values, const tdmf_range *ranges, size_t count) {
    for (size_t i = 0; i < count; ++i) {
        memcpy((char *)values + ranges[i].offset, &ranges[i].start, sizeof(double));
    }
}

static tdmf_refusal first_out_of_range(const void *values, const tdmf_range *ranges, size_t count) {
    for (size_t i = 0; i < count; ++i) {
        const double value = value_at(values, ranges[i].offset);
        if (!tdmf_in_range(&ranges[i], value)) {
            return tdmf_out_of_range(&ranges[i], value);
        }
    }
    return accepted;
}

static const tdmf_range *parameter_range(size_t offset) {
    const tdmf_range *range = tdmf_parameter_ranges;
    while (range->offset != offset) {
        ++range;
    }
    return range;
}

tdmf_parameters tdmf_default_parameters(void) {
    tdmf_parameters parameters = {0};
    fill_with_starts(&parameters, tdmf_parameter_ranges, TDMF_PARAMETER_COUNT);
    for (size_t i = 0; i < tdmf_parameter_flag_count; ++i) {
        const tdmf_flag *flag = &tdmf_parameter_flags[i];
        memcpy((char *)&parameters + flag->offset, &flag->start, sizeof flag->start);
    }
    return parameters;
}

tdmf_inputs tdmf_default_inputs(void) {
    tdmf_inputs inputs = {0};
    fill_with_starts(&inputs, tdmf_input_ranges, TDMF_INPUT_COUNT);
    return inputs;
}

static tdmf_scales scales_of(const tdmf_parameters *p) {
    const double length = p->leg.free_length;
    const double time = sqrt(p->body.mass / p->leg.stiffness);
    const tdmf_scales scales = {
        .length = length,
        .time = time,
        .speed = length / time,
        .force = p->leg.stiffness * length,
        .energy = p->leg.stiffness * length * length,
    };
    return scales;
}

static tdmf_refusal refused_parameter(const tdmf_parameters *parameters, size_t offset,
                                      const char *bound_by) {
    tdmf_refusal refusal = tdmf_out_of_range(parameter_range(offset), value_at(parameters, offset));
    refusal.bound_by = bound_by;
    return refusal;
}

/* Limits that depend on other parameters. */
static tdmf_refusal first_beyond_another(const tdmf_parameters *p) {
    tdmf_refusal refusal = accepted;
    const double narrowest = TDMF_NARROWEST_LAYER * scales_of(p).speed;
    if (p->leg.min_length > p->leg.free_length) {
        refusal = refused_parameter(p, offsetof(tdmf_parameters, leg.min_length), "leg.free_length");
        refusal.maximum = p->leg.free_length;
    } else if (p->ground.patch_begin > p->ground.patch_end) {
        refusal = refused_parameter(p, offsetof(tdmf_parameters, ground.patch_end), "ground.patch_begin");
        refusal.minimum = p->ground.patch_begin;
    } else if (p->ground.stribeck_velocity > 0.0 && p->ground.stribeck_velocity < narrowest) {
        refusal = refused_parameter(p, offsetof(tdmf_parameters, ground.stribeck_velocity), "or 0");
        refusal.minimum = narrowest;
    }
    return refusal;
}

tdmf_refusal tdmf_model_create(tdmf_model *model, const tdmf_parameters *parameters) {
    if (model == NULL || parameters == NULL) {
        return tdmf_absent(model == NULL ? "model" : "parameters");
    }
    tdmf_refusal refusal = first_out_of_range(parameters, tdmf_parameter_ranges, TDMF_PARAMETER_COUNT);
    if (refusal.variable != NULL) {
        return refusal;
    }
    refusal = first_beyond_another(parameters);
    if (refusal.variable != NULL) {
        return refusal;
    }
    const double body_mass = parameters->body.mass, foot_mass = parameters->foot.mass;
    const tdmf_model made = {.parameters = *parameters,
                             .scales = scales_of(parameters),
                             .inverse_body_mass = 1.0 / body_mass,
                             .inverse_foot_mass = 1.0 / foot_mass,
                             .inverse_reduced_mass = 1.0 / body_mass + 1.0 / foot_mass,
                             .total_mass = body_mass + foot_mass,
                             .body_share = body_mass / (body_mass + foot_mass)};
    *model = made;
    return accepted;
}

tdmf_refusal tdmf_check_inputs(const tdmf_inputs *inputs) {
    return inputs == NULL ? tdmf_absent("inputs")
                          : first_out_of_range(inputs, tdmf_input_ranges, TDMF_INPUT_COUNT);
}

const tdmf_inputs tdmf_zero_input_rates = {.ground = {.friction = 0.0}};

bool tdmf_are_zero_rates(const tdmf_inputs *rates) {
    for (size_t i = 0; i < TDMF_INPUT_COUNT; ++i) {
        if (value_at(rates, tdmf_input_ranges[i].offset) != 0.0) {
            return false;
        }
    }
    return true;
}

tdmf_inputs tdmf_inputs_after(const tdmf_inputs *inputs, const tdmf_inputs *rates, double elapsed) {
    const tdmf_inputs *given = tdmf_rates_or_zero(rates);
    tdmf_inputs after = *inputs;
    for (size_t i = 0; i < TDMF_INPUT_COUNT; ++i) {
        const size_t offset = tdmf_input_ranges[i].offset;
        const double value = value_at(inputs, offset) + elapsed * value_at(given, offset);
        memcpy((char *)&after + offset, &value, sizeof value);
    }
    after.ground.friction = fmax(0.0, after.ground.friction);
    return after;
}
