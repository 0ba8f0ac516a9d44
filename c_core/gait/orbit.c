/* Periodic gaits by Newton's method on the return map or the reduced one. */
#include "tdmf_slip/orbit.h"

#include "fixed_point.h"
#include "stride_limits.h"
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

/* Strides in a row that share their steps, see TDMF_STEP_LIMIT. */
typedef struct {
    apex_map *map;
    int coordinates;
    tdmf_solver *solver;
    tdmf_system system;
    const tdmf_seed *seeds;
    int count;
    double steps_left; /* for the next stride */
    tdmf_outcome last; /* how the solver's call for the last stride ended */
    tdmf_return strides[2];
} search;

static tdmf_return stride_from(search *search, const double *apex, bool derivatives) {
    tdmf_solver *solver = search->solver;
    const long step_limit = solver->step_limit;
    const int64_t steps_before = solver->steps;
    solver->step_limit = (long)search->steps_left;
    const tdmf_return stride =
        search->map(solver, search->system, apex, TDMF_LONGEST_STRIDE * search->system.model->scales.time,
                    derivatives, search->seeds, search->count);
    solver->step_limit = step_limit;
    search->steps_left -= (double)(solver->steps - steps_before);
    search->last = stride.outcome == TDMF_RETURN_UNSOLVED ? stride.solver : TDMF_ARRIVED;
    return stride;
}

static bool evaluate(void *context, int slot, tdmf_image *image) {
    search *search = context;
    tdmf_return *stride = &search->strides[slot];
    *stride = stride_from(search, image->point, true);
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
    if (search->solver == NULL || search->system.model == NULL || guess == NULL) {
        return refused;
    }
    tdmf_map map = {.count = search->coordinates, .evaluate = evaluate, .context = search};
    tdmf_section_scales(search->system.model, map.scales);
    search->steps_left = (double)search->solver->step_limit;
    const tdmf_fixed_point found = tdmf_find_fixed_point(&map, guess);
    tdmf_orbit orbit = {.iterations = found.iterations, .error = found.error};
    memcpy(orbit.apex, found.point, sizeof orbit.apex);
    orbit.stride = search->strides[found.slot];
    orbit.outcome = outcome_of(&found, &orbit.stride);
    if (orbit.outcome == TDMF_ORBIT_NOT_FOUND && search->last != TDMF_ARRIVED) {
        /* The solver's limits have stopped Newton's method: whether there is a gait is not known. */
        orbit.outcome = TDMF_ORBIT_UNSOLVED;
        orbit.stride.outcome = TDMF_RETURN_UNSOLVED;
        orbit.stride.solver = search->last;
    }
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

static int settle(search *search, int strides, double *apex) {
    if (search->solver == NULL || search->system.model == NULL) {
        return 0;
    }
    search->steps_left = (double)search->solver->step_limit;
    for (int i = 0; i < strides; ++i) {
        const tdmf_return stride = stride_from(search, apex, false);
        if (stride.outcome != TDMF_RETURN_CLOSED) {
            return i;
        }
        memcpy(apex, stride.apex, (size_t)search->coordinates * sizeof *apex);
        search->steps_left =
            tdmf_steps_of_next_stride(search->steps_left, (double)search->solver->step_limit);
    }
    return strides > 0 ? strides : 0;
}

int tdmf_settle(tdmf_solver *solver, tdmf_system system, int strides, double section[TDMF_SECTION_COUNT]) {
    search search = {
        .map = tdmf_return_map, .coordinates = TDMF_SECTION_COUNT, .solver = solver, .system = system};
    return settle(&search, strides, section);
}

int tdmf_settle_reduced(tdmf_solver *solver, tdmf_system system, int strides,
                        double apex[TDMF_REDUCED_COUNT]) {
    search search = {
        .map = tdmf_reduced_map, .coordinates = TDMF_REDUCED_COUNT, .solver = solver, .system = system};
    return settle(&search, strides, apex);
}
