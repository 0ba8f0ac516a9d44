/* Fixed points of the reduced map by Newton's method. */
#include "fixed_point.h"
#include "longest_stride.h"
#include "tdmf_slip/reduced_map.h"

#include <string.h>

static tdmf_orbit_outcome why_not(tdmf_reduced_outcome outcome) {
    switch (outcome) {
    case TDMF_REDUCED_REFUSED:
    case TDMF_REDUCED_FOOT_BELOW:
        return TDMF_ORBIT_NO_START;
    case TDMF_REDUCED_FELL:
        return TDMF_ORBIT_FELL;
    case TDMF_REDUCED_UNSOLVED:
        return TDMF_ORBIT_UNSOLVED;
    default:
        return TDMF_ORBIT_NO_STRIDE;
    }
}

typedef struct {
    tdmf_solver *solver;
    const tdmf_model *model;
    const tdmf_inputs *inputs;
    const tdmf_seed *seeds;
    int count;
    tdmf_reduced_return strides[2];
} search;

static bool evaluate(void *context, int slot, tdmf_image *image) {
    search *search = context;
    tdmf_reduced_return *stride = &search->strides[slot];
    *stride = tdmf_reduced_map(search->solver, search->model, search->inputs, image->point,
                               TDMF_LONGEST_STRIDE * search->model->scales.time, true, search->seeds,
                               search->count);
    for (int i = 0; i < TDMF_REDUCED_COUNT; ++i) {
        image->next[i] = stride->apex[i];
        for (int k = 0; k < TDMF_REDUCED_COUNT; ++k) {
            image->jacobian[i][k] = stride->by_section[k].apex[i];
        }
    }
    return stride->outcome == TDMF_REDUCED_CLOSED;
}

static tdmf_orbit_outcome outcome_of(const tdmf_fixed_point *found, const tdmf_reduced_return *stride) {
    switch (found->outcome) {
    case TDMF_FIXED_POINT_FOUND:
        return TDMF_ORBIT_FOUND;
    case TDMF_FIXED_POINT_NOT_FOUND:
        return TDMF_ORBIT_NOT_FOUND;
    default:
        return why_not(stride->outcome);
    }
}

tdmf_reduced_orbit tdmf_find_reduced_orbit(tdmf_solver *solver, const tdmf_model *model,
                                           const tdmf_inputs *inputs, const double guess[TDMF_REDUCED_COUNT],
                                           const tdmf_seed *seeds, int count) {
    static const tdmf_reduced_orbit refused = {.outcome = TDMF_ORBIT_NO_START,
                                               .stride = {.outcome = TDMF_REDUCED_REFUSED}};
    if (model == NULL || guess == NULL) {
        return refused;
    }
    search search = {.solver = solver, .model = model, .inputs = inputs, .seeds = seeds, .count = count};
    const tdmf_map map = {TDMF_REDUCED_COUNT, {model->scales.length, model->scales.speed}, evaluate, &search};
    const tdmf_fixed_point found = tdmf_find_fixed_point(&map, guess);
    tdmf_reduced_orbit orbit = {.iterations = found.iterations, .error = found.error};
    memcpy(orbit.apex, found.point, sizeof orbit.apex);
    orbit.stride = search.strides[found.slot];
    orbit.outcome = outcome_of(&found, &orbit.stride);
    return orbit;
}

int tdmf_settle_reduced(tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs, int strides,
                        double apex[TDMF_REDUCED_COUNT]) {
    for (int i = 0; model != NULL && i < strides; ++i) {
        const tdmf_reduced_return stride = tdmf_reduced_map(
            solver, model, inputs, apex, TDMF_LONGEST_STRIDE * model->scales.time, false, NULL, 0);
        if (stride.outcome != TDMF_REDUCED_CLOSED) {
            return i;
        }
        memcpy(apex, stride.apex, sizeof stride.apex);
    }
    return model != NULL && strides > 0 ? strides : 0;
}
