/* The hybrid automaton: guards, resets, and the chains of events that happen in zero time.
 *
 * A run is tdmf_start, then, as often as it takes: integrate tdmf_derivatives until one of tdmf_guards
 * reaches zero, and let tdmf_resolve take the transition. The caller owns all memory; nothing here allocates.
 */
#ifndef TDMF_SLIP_AUTOMATON_H
#define TDMF_SLIP_AUTOMATON_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/motion.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The margin is in units of the guarded quantity's scale: far above rounding, far below any solver's
 * tolerance. */
#define TDMF_GUARD_MARGIN 1e-12

/* Changes made by the transitions. */
typedef struct {
    bool state_changed; /* some element of the state jumped */
    bool mode_changed;  /* contact, phase, clamp, thrust or fall: the right-hand side is a different one */
    bool unresolved;    /* more than TDMF_CHAIN_LIMIT transitions were due at one instant */
} tdmf_resolution;

/* Begins a run at motion->time from motion->state: checks the start, finds contact mode and hip phase (an
 * impact, if the foot moves down at the ground), sets theta_LO = theta, and clears integrals and record. An
 * upright leg is driven only if it turns forward, or is at rest and the drive does not make it fall: a runner
 * that stands upright at rest stays so. Its foot is never in graze, for the hip has no lever on it: without
 * load, it stays if the load is about to grow. On refusal (the foot or body below the ground, the leg too
 * short, a value out of range or not finite) nothing is written.
 */
TDMF_API tdmf_refusal tdmf_start(tdmf_system system, tdmf_motion *motion);

/* Writes the time derivative of the state in the given mode (8): the right-hand side to integrate. That of a
 * fallen run is zero. It is finite for leg lengths at or below zero too, because a solver may try a state
 * beyond an event. The leg's rates are NaN if the contact or phase is invalid. `derivatives` may be `state`.
 */
TDMF_API void tdmf_derivatives(tdmf_system system, const tdmf_mode *mode,
                               const double state[TDMF_STATE_COUNT], double derivatives[TDMF_STATE_COUNT]);

/* Writes the values of all guards in the present mode. An event is due when its guard is zero or below. The
 * guards of a fallen run are 1. All are NaN if the contact or phase is invalid. */
TDMF_API void tdmf_guards(tdmf_system system, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                          double guards[TDMF_GUARD_COUNT]);

/* Returns the guard whose transition tdmf_resolve takes next, or TDMF_GUARD_COUNT if none is due. */
TDMF_API tdmf_guard tdmf_first_due(tdmf_system system, const tdmf_mode *mode,
                                   const double state[TDMF_STATE_COUNT]);

/* Takes every transition that is due at motion->time, in order, until no guard is at or below zero. It looks
 * at the guards' values only, so you may call it at any time: at an event, after an input has jumped, or with
 * nothing due. A leg whose rest length has jumped does its work on the spring. A chain that would not end
 * (none is known) is cut and reported as unresolved; so is an invalid contact or phase, and then nothing is
 * changed. */
TDMF_API tdmf_resolution tdmf_resolve(tdmf_system system, tdmf_motion *motion);

/* The largest number of transitions at one instant. */
enum { TDMF_CHAIN_LIMIT = 64 };

/* Records the ground force of this instant for the stride's peaks. Call it before you change an input during
 * a stance, so that a rising force is not lost. tdmf_resolve calls it itself. */
TDMF_API void tdmf_observe(tdmf_system system, tdmf_motion *motion);

#ifdef __cplusplus
}
#endif
#endif
