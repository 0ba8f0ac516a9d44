/* With the return map P and its Jacobian J, a step of Newton's method solves (I - J) dz = P(z) - z. */
#include "tdmf_slip/orbit.h"

#include "linear_equations.h"

#include <math.h>
#include <string.h>

enum { ITERATION_LIMIT = 40, SHORTENING_LIMIT = 12 };

/* In sqrt(m/k): a stride that takes longer counts as none. */
static const double longest_stride = 1e4;

/* Errors below this are rounding. */
static const double converged = 1e-13;
static const double good_enough = 1e-11;

void tdmf_section_scales(const tdmf_model *model, double scales[TDMF_SECTION_COUNT]) {
    const tdmf_scales *s = &model->scales;
    const double values[TDMF_SECTION_COUNT] = {s->length, s->speed, s->length, 1.0, s->speed, 1.0 / s->time};
    memcpy(scales, values, sizeof values);
}

static double error_of(const tdmf_model *model, const double section[TDMF_SECTION_COUNT],
                       const double next[TDMF_SECTION_COUNT]) {
    double scales[TDMF_SECTION_COUNT];
    double error = 0.0;
    tdmf_section_scales(model, scales);
    for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
        const double difference = fabs(next[i] - section[i]) / scales[i];
        error = difference > error || isnan(difference) ? difference : error;
    }
    return error;
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

/* The stride from a section into the orbit. */
static bool try_section(tdmf_orbit *orbit, tdmf_solver *solver, const tdmf_model *model,
                        const tdmf_inputs *inputs, const double section[TDMF_SECTION_COUNT],
                        const tdmf_change *change) {
    memcpy(orbit->section, section, sizeof orbit->section);
    orbit->stride = tdmf_return_map(solver, model, inputs, section, longest_stride * model->scales.time, true,
                                    change, change ? 1 : 0);
    if (!orbit->stride.began_at_apex || !orbit->stride.outcome.closed) {
        orbit->outcome = why_not(&orbit->stride);
        return false;
    }
    orbit->error = error_of(model, section, orbit->stride.apex);
    return true;
}

static bool newton_step(const tdmf_orbit *orbit, double step[TDMF_SECTION_COUNT]) {
    double a[TDMF_SECTION_COUNT][TDMF_SECTION_COUNT + 1];
    for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            a[i][k] = (i == k ? 1.0 : 0.0) - orbit->stride.by_section[k].apex[i];
        }
        step[i] = orbit->stride.apex[i] - orbit->section[i];
    }
    return tdmf_solve_linear(TDMF_SECTION_COUNT, a, step);
}

/* Goes a step, or the part of it that makes the error smaller. */
static bool improve(tdmf_orbit *orbit, tdmf_solver *solver, const tdmf_model *model,
                    const tdmf_inputs *inputs, const double step[TDMF_SECTION_COUNT],
                    const tdmf_change *change) {
    const tdmf_orbit before = *orbit;
    double share = 1.0;
    for (int i = 0; i < SHORTENING_LIMIT; ++i) {
        double section[TDMF_SECTION_COUNT];
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            section[k] = before.section[k] + share * step[k];
        }
        if (try_section(orbit, solver, model, inputs, section, change) && orbit->error < before.error) {
            return true;
        }
        share *= 0.5;
    }
    *orbit = before;
    return false;
}

tdmf_orbit tdmf_find_orbit(tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs,
                           const double guess[TDMF_SECTION_COUNT], const tdmf_change *change) {
    tdmf_orbit orbit;
    memset(&orbit, 0, sizeof orbit);
    if (!try_section(&orbit, solver, model, inputs, guess, change)) {
        return orbit;
    }
    for (; orbit.iterations < ITERATION_LIMIT && orbit.error > converged; ++orbit.iterations) {
        double step[TDMF_SECTION_COUNT];
        if (!newton_step(&orbit, step) || !improve(&orbit, solver, model, inputs, step, change)) {
            break;
        }
    }
    orbit.outcome = orbit.error <= good_enough ? TDMF_ORBIT_FOUND : TDMF_ORBIT_NOT_FOUND;
    return orbit;
}

int tdmf_settle(tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs, int strides,
                double section[TDMF_SECTION_COUNT]) {
    for (int i = 0; i < strides; ++i) {
        const tdmf_return stride = tdmf_return_map(solver, model, inputs, section,
                                                   longest_stride * model->scales.time, false, NULL, 0);
        if (!stride.outcome.closed) {
            return i;
        }
        memcpy(section, stride.apex, sizeof stride.apex);
    }
    return strides;
}
