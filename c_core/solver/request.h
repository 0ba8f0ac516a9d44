/* What a solver is asked for: neither solver starts on what makes no sense, as no step would show it. */
#ifndef TDMF_SOLVER_REQUEST_H
#define TDMF_SOLVER_REQUEST_H

#include "contact_mode.h"
#include "input_rates.h"
#include "tdmf_slip/solver.h"

#include <math.h>
#include <string.h>

/* A share that steps may err by. */
static inline bool tdmf_is_tolerance(double relative_tolerance) {
    return relative_tolerance > 0.0 && relative_tolerance < 1.0;
}

/* Inputs, those at the end included, are within their ranges: beyond, numbers overflow. None ramps that
 * changes at events only: between them no guard looks at it. */
static inline bool tdmf_are_sound_inputs(const tdmf_inputs *inputs, const tdmf_inputs *rates,
                                         double duration) {
    if (tdmf_check_inputs(inputs).variable != NULL || !tdmf_are_rates(rates)) {
        return false;
    }
    const tdmf_inputs last =
        tdmf_are_zero_rates(rates) ? *inputs : tdmf_inputs_after(inputs, rates, duration);
    return tdmf_check_inputs(&last).variable == NULL;
}

static inline bool tdmf_is_sound_solver(const tdmf_solver *solver) {
    return solver != NULL && tdmf_is_tolerance(solver->relative_tolerance) &&
           (solver->log == NULL || solver->log->count >= 0);
}

static inline bool tdmf_is_finite_state(const double state[TDMF_STATE_COUNT]) {
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        if (!isfinite(state[i])) {
            return false;
        }
    }
    return true;
}

/* A mode that a run may be in: a loaded foot is driven or coasts, any other is retracted or placed. The word
 * ends within its array. */
static inline bool tdmf_is_sound_motion(const tdmf_motion *motion) {
    const tdmf_mode *mode = &motion->mode;
    const bool stance = mode->phase == TDMF_PHASE_DRIVE || mode->phase == TDMF_PHASE_COAST;
    return tdmf_is_mode(mode) && stance == tdmf_is_loaded(mode) && tdmf_is_finite_state(motion->state) &&
           memchr(motion->record.progress.open.word, '\0', TDMF_WORD_CAPACITY) != NULL;
}

/* Changes of parameters and inputs, at the most so many. */
static inline bool tdmf_are_sound_seeds(const tdmf_seed *seeds, int count, int limit) {
    return count >= 0 && count <= limit && (count == 0 || seeds != NULL);
}

static inline bool tdmf_is_sound_request(const tdmf_solver *solver, tdmf_system system,
                                         const tdmf_inputs *rates, double until, const tdmf_motion *motion) {
    return tdmf_is_sound_solver(solver) && system.model != NULL && system.inputs != NULL && motion != NULL &&
           tdmf_is_sound_motion(motion) && until >= motion->time &&
           tdmf_are_sound_inputs(system.inputs, rates, until - motion->time);
}

#endif
