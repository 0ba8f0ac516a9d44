/* Heights and frictions of the ground from deviates that may be correlated. */
#include "drawn_ground.h"

#include <math.h>

/* Largest friction, as on the page. */
static const double largest = 1e6;

typedef double deviate_of_number(uint64_t seed, uint64_t runner, uint32_t number);

/* Weighted sum of the deviates of a number and of the numbers before it; those before 0 wrap. */
static double weighted(deviate_of_number *deviate, const double *weights, int count, uint64_t seed,
                       uint64_t runner, uint32_t number) {
    double sum = 0.0;
    if (weights == NULL) {
        return deviate(seed, runner, number);
    }
    for (int j = 0; j < count; ++j) {
        sum += weights[j] * deviate(seed, runner, number - (uint32_t)j);
    }
    return sum;
}

double tdmf_drawn_step(const tdmf_ensemble_rules *rules, uint64_t runner, uint32_t number) {
    return rules->roughness * weighted(tdmf_ground_step, rules->step_weights, rules->step_weight_count,
                                       rules->seed, runner, number);
}

double tdmf_segment_height(const tdmf_ensemble_rules *rules, uint64_t runner, int64_t segment) {
    return rules->roughness == 0.0 ? 0.0 : tdmf_drawn_step(rules, runner, (uint32_t)segment);
}

double tdmf_drawn_friction(const tdmf_ensemble_rules *rules, double about, uint64_t runner, uint32_t number) {
    const double factor =
        exp(rules->friction_spread * weighted(tdmf_friction_deviate, rules->friction_weights,
                                              rules->friction_weight_count, rules->seed, runner, number));
    return fmin(largest, about * factor);
}
