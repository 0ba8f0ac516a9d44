/* Periodic gaits by Newton's method on the return map or the reduced one. */
#include "tdmf_slip/orbit.h"

#include "fixed_point.h"
#include "longest_stride.h"
#include "tdmf_slip/reduced_map.h"

#include <string.h>

void tdmf_section_scales(const tdmf_model *model, double scales[TDMF_SECTION_COUNT]) {
    const tdmf_scales *s = &model->scales;
    const double values[TDMF_SECTION_COUNT] = {s->length, s->speed, s->length, 1.0, s->speed, 1.0 / s->time};
    memcpy(scales, values, sizeof values);
}

/* What a stride that has not closed makes of a search. */
static tdmf_orbit_outcome why_not(tdmf_return_outcome outcome) {
    switch (outcome) {
    case TDMF_RETURN_REFUSED:
    case TDMF_RETURN_NO_START:
        return TDMF_ORBIT_NO_START;
    case TDMF_RETURN_FELL:
        return TDMF_ORBIT_FELL;
    case TDMF_RETURN_UNSOLVED:
        return TDMF_ORBIT_UNSOLVED;
    default:
        return TDMF_ORBIT_NO_STRIDE;
    }
}

typedef tdmf_return apex_map(tdmf_solver *solver, tdmf_system system, const double *apex, double until,
                             bool derivatives, const tdmf_seed *seeds, int count);

typedef struct {
    apex_map *map;
    int coordinates;
    tdmf_solver *solver;
    tdmf_system system;
    const tdmf_seed *seeds;
    int count;
    tdmf_return strides[2];
} search;

static bool evaluate(void *context, int slot, tdmf_image *image) {
    search *search = context;
    tdmf_return *stride = &search->strides[slot];
    *stride = search->map(search->solver, search->system, image->point,
                          TDMF_LONGEST_STRIDE * search->system.model->scales.time, true, search->seeds,
                          search->count);
    for (int i = 0; i < search->coordinates; ++i) {
        image->next[i] = stride->apex[i];
        for (int k = 0; k < search->coordinates; ++k) {
            image->jacobian[i][k] = stride->variations[k].apex[i];
        }
    }
    return stride->outcome == TDMF_RETURN_CLOSED;
}

static tdmf_orbit_outcome outcome_of(const tdmf_fixed_point *found, const tdmf_return *stride) {
    switch (found->outcome) {
    case TDMF_FIXED_POINT_FOUND:
        return TDMF_ORBIT_FOUND;
    case TDMF_FIXED_POINT_NOT_FOUND:
        return TDMF_ORBIT_NOT_FOUND;
    default:
        return why_not(stride->outcome);
    }
}

static tdmf_orbit find(search *search, const double *guess) {
    static const tdmf_orbit refused = {.outcome = TDMF_ORBIT_NO_START,
                                       .stride = {.outcome = TDMF_RETURN_REFUSED}};
    if (search->system.model == NULL || guess == NULL) {
        return refused;
    }
    tdmf_map map = {.count = search->coordinates, .evaluate = evaluate, .context = search};
    tdmf_section_scales(search->system.model, map.scales);
    const tdmf_fixed_point found = tdmf_find_fixed_point(&map, guess);
    tdmf_orbit orbit = {.iterations = found.iterations, .error = found.error};
    memcpy(orbit.apex, found.point, sizeof orbit.apex);
    orbit.stride = search->strides[found.slot];
    orbit.outcome = outcome_of(&found, &orbit.stride);
    return orbit;
}

tdmf_orbit tdmf_find_orbit(tdmf_solver *solver, tdmf_system system, const double guess[TDMF_SECTION_COUNT],
                           const tdmf_seed *seeds, int count) {
    search search = {.map = tdmf_return_map,
                     .coordinates = TDMF_SECTION_COUNT,
                     .solver = solver,
                     .system = system,
                     .seeds = seeds,
                     .count = count};
    return find(&search, guess);
}

tdmf_orbit tdmf_find_reduced_orbit(tdmf_solver *solver, tdmf_system system,
                                   const double guess[TDMF_REDUCED_COUNT], const tdmf_seed *seeds,
                                   int count) {
    search search = {.map = tdmf_reduced_map,
                     .coordinates = TDMF_REDUCED_COUNT,
                     .solver = solver,
                     .system = system,
                     .seeds = seeds,
                     .count = count};
    return find(&search, guess);
}

static int settle(apex_map *map, int coordinates, tdmf_solver *solver, tdmf_system system, int strides,
                  double *apex) {
    for (int i = 0; system.model != NULL && i < strides; ++i) {
        const tdmf_return stride =
            map(solver, system, apex, TDMF_LONGEST_STRIDE * system.model->scales.time, false, NULL, 0);
        if (stride.outcome != TDMF_RETURN_CLOSED) {
            return i;
        }
        memcpy(apex, stride.apex, (size_t)coordinates * sizeof *apex);
    }
    return system.model != NULL && strides > 0 ? strides : 0;
}

int tdmf_settle(tdmf_solver *solver, tdmf_system system, int strides, double section[TDMF_SECTION_COUNT]) {
    return settle(tdmf_return_map, TDMF_SECTION_COUNT, solver, system, strides, section);
}

int tdmf_settle_reduced(tdmf_solver *solver, tdmf_system system, int strides,
                        double apex[TDMF_REDUCED_COUNT]) {
    return settle(tdmf_reduced_map, TDMF_REDUCED_COUNT, solver, system, strides, apex);
}
