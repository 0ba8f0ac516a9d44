/* Periodic gaits by Newton's method on the return map or the reduced one. */
#include "tdmf_slip/return_map.h"

#include "fixed_point.h"
#include "mapped_stride.h"
#include "stride_limits.h"

#include <string.h>

void tdmf_section_scales(const tdmf_model *model, double scales[TDMF_SECTION_COUNT]) {
    const tdmf_scales *s = &model->scales;
    const double values[TDMF_SECTION_COUNT] = {s->length, s->speed, s->length, 1.0, s->speed, 1.0 / s->time};
    memcpy(scales, values, sizeof values);
}

/* Outcome of a search that ended with a stride that did not close. */
static tdmf_orbit_outcome outcome_of_open_stride(tdmf_return_outcome outcome) {
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

/* Strides in a row that share their steps, see TDMF_STEP_LIMIT. */
typedef struct {
    const tdmf_stride_request *request;
    int coordinates;
    double steps_left; /* steps left for the next stride */
    tdmf_outcome last; /* outcome of the solver's call for the last stride */
    tdmf_return strides[2];
} search;

/* False for a request without what the first stride needs. */
static bool begin_search(search *search, const tdmf_stride_request *request) {
    if (request == NULL || request->solver == NULL || request->system.model == NULL ||
        request->apex == NULL) {
        return false;
    }
    search->request = request;
    search->coordinates =
        request->map == TDMF_REDUCED_MAP ? (int)TDMF_REDUCED_COUNT : (int)TDMF_SECTION_COUNT;
    search->steps_left = (double)request->solver->step_limit;
    search->last = TDMF_ARRIVED;
    return true;
}

static void run_from(search *search, const double *apex, bool derivatives, tdmf_return *stride) {
    tdmf_stride_request request = *search->request;
    tdmf_solver *solver = request.solver;
    const long step_limit = solver->step_limit;
    const int64_t steps_before = solver->steps;
    request.apex = apex;
    request.until = 0.0;
    request.foot_x = NULL;
    request.derivatives = derivatives;
    request.measures = false;
    solver->step_limit = tdmf_step_limit_of(search->steps_left);
    tdmf_run_stride(&request, stride);
    solver->step_limit = step_limit;
    search->steps_left -= (double)(solver->steps - steps_before);
    search->last = stride->outcome == TDMF_RETURN_UNSOLVED ? stride->solver : TDMF_ARRIVED;
}

static bool evaluate(void *context, int slot, tdmf_image *image) {
    search *search = context;
    tdmf_return *stride = &search->strides[slot];
    run_from(search, image->point, true, stride);
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
        return outcome_of_open_stride(stride->outcome);
    }
}

void tdmf_find_orbit(const tdmf_stride_request *request, tdmf_orbit *orbit) {
    search search;
    memset(orbit, 0, sizeof *orbit);
    if (!begin_search(&search, request)) {
        tdmf_is_sound_stride(&orbit->stride.refusal, request);
        orbit->outcome = TDMF_ORBIT_NO_START;
        orbit->stride.outcome = TDMF_RETURN_REFUSED;
        return;
    }
    tdmf_map map = {.count = search.coordinates, .evaluate = evaluate, .context = &search};
    tdmf_section_scales(request->system.model, map.scales);
    const tdmf_fixed_point found = tdmf_find_fixed_point(&map, request->apex);
    orbit->iterations = found.iterations;
    orbit->error = found.error;
    memcpy(orbit->apex, found.point, sizeof orbit->apex);
    orbit->stride = search.strides[found.slot];
    orbit->outcome = outcome_of(&found, &orbit->stride);
    if (orbit->outcome == TDMF_ORBIT_NOT_FOUND && search.last != TDMF_ARRIVED) {
        /* The solver's limits have stopped Newton's method: whether there is a gait is not known. */
        orbit->outcome = TDMF_ORBIT_UNSOLVED;
        orbit->stride.outcome = TDMF_RETURN_UNSOLVED;
        orbit->stride.solver = search.last;
    }
}

int tdmf_settle(const tdmf_stride_request *request, int strides, double *apex) {
    search search;
    double at[TDMF_SECTION_COUNT];
    if (apex == NULL || !begin_search(&search, request)) {
        return 0;
    }
    const size_t size = (size_t)search.coordinates * sizeof *apex;
    memcpy(at, request->apex, size);
    int closed = 0;
    for (; closed < strides; ++closed) {
        run_from(&search, at, false, &search.strides[0]);
        if (search.strides[0].outcome != TDMF_RETURN_CLOSED) {
            break;
        }
        memcpy(at, search.strides[0].apex, size);
        search.steps_left = tdmf_steps_of_next_stride(search.steps_left, (double)request->solver->step_limit);
    }
    memcpy(apex, at, size);
    return closed;
}
