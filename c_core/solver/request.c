/* Requests that solvers refuse. */
#include "request.h"

#include "contact_mode.h"
#include "input_rates.h"
#include "ranges.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

static bool is_sound_tolerance(tdmf_refusal *why, double relative_tolerance) {
    if (relative_tolerance > 0.0 && relative_tolerance < 1.0) {
        return true;
    }
    const tdmf_refusal refusal = {.code = TDMF_OUT_OF_RANGE,
                                  .variable = "solver.relative_tolerance",
                                  .unit = "1",
                                  .value = relative_tolerance,
                                  .maximum = 1.0,
                                  .bound_by = "both excluded"};
    return tdmf_accepts(why, refusal);
}

bool tdmf_is_sound_solver(tdmf_refusal *why, const tdmf_solver *solver) {
    return tdmf_accepts_pointer(why, "solver", solver) &&
           is_sound_tolerance(why, solver->relative_tolerance) &&
           (solver->log == NULL ||
            tdmf_accepts_number(why, "solver.log.count", "1", solver->log->count, 0.0, INT_MAX));
}

bool tdmf_is_sound_system(tdmf_refusal *why, tdmf_system system) {
    return tdmf_accepts_pointer(why, "system.model", system.model) &&
           tdmf_accepts_pointer(why, "system.inputs", system.inputs);
}

bool tdmf_are_sound_seeds(tdmf_refusal *why, const tdmf_seed *seeds, int count, int limit) {
    return tdmf_accepts_array(why, "seeds", seeds, "seed_count", count, limit);
}

/* Rates are finite. None ramps that changes at events only: between them no guard looks at it. */
static bool are_sound_rates(tdmf_refusal *why, const tdmf_inputs *rates) {
    for (int i = 0; i < TDMF_INPUT_COUNT; ++i) {
        const tdmf_range *range = &tdmf_input_ranges[i];
        const double most = range->continuous ? DBL_MAX : 0.0;
        double rate;
        memcpy(&rate, (const char *)rates + range->offset, sizeof rate);
        if (!tdmf_accepts_number(why, range->name, "1/s", rate, -most, most)) {
            why->bound_by = range->continuous ? "its rate" : "its rate: it changes at events only";
            return false;
        }
    }
    return true;
}

/* Inputs, those at the end included, are within their ranges: beyond, numbers overflow. */
static bool are_sound_inputs(tdmf_refusal *why, const tdmf_inputs *inputs, const tdmf_inputs *rates,
                             double duration) {
    if (!tdmf_accepts(why, tdmf_check_inputs(inputs)) || !are_sound_rates(why, rates)) {
        return false;
    }
    const tdmf_inputs last =
        tdmf_are_zero_rates(rates) ? *inputs : tdmf_inputs_after(inputs, rates, duration);
    const bool is_accepted = tdmf_accepts(why, tdmf_check_inputs(&last));
    if (!is_accepted) {
        why->bound_by = "where its rate takes it";
    }
    return is_accepted;
}

/* A mode that a run may be in: a loaded foot is driven or coasts, any other is retracted or placed. */
static bool is_sound_mode(tdmf_refusal *why, const tdmf_mode *mode) {
    const bool stance = mode->phase == TDMF_PHASE_DRIVE || mode->phase == TDMF_PHASE_COAST;
    return tdmf_accepts_number(why, "motion.mode.contact", "1", (int)mode->contact, TDMF_CONTACT_FLIGHT,
                               TDMF_CONTACT_GRAZE) &&
           tdmf_accepts_number(why, "motion.mode.phase", "1", (int)mode->phase, TDMF_PHASE_DRIVE,
                               TDMF_PHASE_PLACE) &&
           tdmf_accepts_if(why, stance == tdmf_is_loaded(mode), TDMF_EXCLUDED, "motion.mode.phase", 0,
                           "a loaded foot is driven or coasts, any other is retracted or placed");
}

static bool is_finite(tdmf_refusal *why, const char *name, const char *unit, double value) {
    return tdmf_accepts_number(why, name, unit, value, -DBL_MAX, DBL_MAX);
}

static bool is_sound_motion(tdmf_refusal *why, const tdmf_motion *motion) {
    const tdmf_mode *mode = &motion->mode;
    bool is_sound = is_sound_mode(why, mode) && is_finite(why, "motion.time", "s", motion->time) &&
                    is_finite(why, "motion.begun", "s", motion->begun) &&
                    is_finite(why, "motion.clock_rest", "s", motion->clock_rest) &&
                    is_finite(why, "motion.mode.rest_length", "m", mode->rest_length) &&
                    is_finite(why, "motion.mode.ground.height", "m", mode->ground.height) &&
                    is_finite(why, "motion.mode.ground.slope", "rad", mode->ground.slope) &&
                    is_finite(why, "motion.mode.ground.sine", "1", mode->ground.sine) &&
                    is_finite(why, "motion.mode.ground.cosine", "1", mode->ground.cosine);
    for (int i = 0; is_sound && i < TDMF_STATE_COUNT; ++i) {
        is_sound = tdmf_accepts_element(why, "motion.state[]", i, motion->state[i], -DBL_MAX, DBL_MAX);
    }
    return is_sound;
}

bool tdmf_is_sound_request(tdmf_solver *solver, tdmf_system system, const tdmf_inputs *rates, double until,
                           const tdmf_motion *motion) {
    tdmf_refusal why = {.code = TDMF_ACCEPTED};
    const bool is_sound = tdmf_is_sound_solver(&why, solver) && tdmf_is_sound_system(&why, system) &&
                          tdmf_accepts_pointer(&why, "motion", motion) && is_sound_motion(&why, motion) &&
                          tdmf_accepts_number(&why, "until", "s", until, motion->time, INFINITY) &&
                          are_sound_inputs(&why, system.inputs, rates, until - motion->time);
    if (solver != NULL) {
        solver->refusal = why;
    }
    return is_sound;
}
