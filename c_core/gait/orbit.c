/* Periodic gaits by Newton's method on the return map. */
#include "tdmf_slip/orbit.h"

#include "fixed_point.h"
#include "longest_stride.h"

#include <string.h>

void tdmf_section_scales(const tdmf_model *model, double scales[TDMF_SECTION_COUNT]) {
    const tdmf_scales *s = &model->scales;
    const double values[TDMF_SECTION_COUNT] = {s->length, s->speed, s->length, 1.0, s->speed, 1.0 / s->time};
    memcpy(scales, values, sizeof values);
}

/* What a stride that has not closed makes of a search. */
static tdmf_orbit_outcome why_not(const tdmf_return *stride) {
    if (!stride->began_at_apex) {
        return TDMF_ORBIT_NO_START;
    }
    switch (stride->outcome.outcome) {
    case TDMF_REFUSED:
        return TDMF_ORBIT_NO_START;
    case TDMF_FELL:
        return TDMF_ORBIT_FELL;
    case TDMF_ARRIVED:
        return TDMF_ORBIT_NO_STRIDE;
    default:
        return TDMF_ORBIT_UNSOLVED;
    }
}

typedef struct {
    tdmf_solver *solver;
    const tdmf_model *model;
    const tdmf_inputs *inputs;
    const tdmf_seed *seed;
    tdmf_return strides[2];
} search;

static bool evaluate(void *context, int slot, tdmf_image *image) {
    search *search = context;
    tdmf_return *stride = &search->strides[slot];
    *stride = tdmf_return_map(search->solver, search->model, search->inputs, image->point,
                              TDMF_LONGEST_STRIDE * search->model->scales.time, true, search->seed,
                              search->seed ? 1 : 0);
    if (!stride->began_at_apex || !stride->outcome.closed) {
        return false;
    }
    for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
        image->next[i] = stride->apex[i];
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            image->jacobian[i][k] = stride->by_section[k].apex[i];
        }
    }
    return true;
}

static tdmf_orbit_outcome outcome_of(const tdmf_fixed_point *found, const tdmf_return *stride) {
    switch (found->outcome) {
    case TDMF_FIXED_POINT_FOUND:
        return TDMF_ORBIT_FOUND;
    case TDMF_FIXED_POINT_NOT_FOUND:
        return TDMF_ORBIT_NOT_FOUND;
    default:
        return why_not(stride);
    }
}

tdmf_orbit tdmf_find_orbit(tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs,
                           const double guess[TDMF_SECTION_COUNT], const tdmf_seed *seed) {
    static const tdmf_orbit refused = {.outcome = TDMF_ORBIT_NO_START};
    if (model == NULL || guess == NULL) {
        return refused;
    }
    search search = {.solver = solver, .model = model, .inputs = inputs, .seed = seed};
    tdmf_map map = {.count = TDMF_SECTION_COUNT, .evaluate = evaluate, .context = &search};
    tdmf_section_scales(model, map.scales);
    const tdmf_fixed_point found = tdmf_find_fixed_point(&map, guess);
    tdmf_orbit orbit = {.iterations = found.iterations, .error = found.error};
    memcpy(orbit.section, found.point, sizeof orbit.section);
    orbit.stride = search.strides[found.slot];
    orbit.outcome = outcome_of(&found, &orbit.stride);
    return orbit;
}

int tdmf_settle(tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs, int strides,
                double section[TDMF_SECTION_COUNT]) {
    for (int i = 0; model != NULL && i < strides; ++i) {
        const tdmf_return stride = tdmf_return_map(solver, model, inputs, section,
                                                   TDMF_LONGEST_STRIDE * model->scales.time, false, NULL, 0);
        if (!stride.outcome.closed) {
            return i;
        }
        memcpy(section, stride.apex, sizeof stride.apex);
    }
    return model != NULL && strides > 0 ? strides : 0;
}
