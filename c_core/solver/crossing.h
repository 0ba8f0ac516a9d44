/* When in a step the first event is due. */
#ifndef TDMF_SOLVER_CROSSING_H
#define TDMF_SOLVER_CROSSING_H

#include "step.h"
#include "tdmf_slip/automaton.h"

/* What ends a step: a guard where `at.is_root`. */
typedef struct {
    tdmf_root at;
    tdmf_guard guard;
} tdmf_crossing;

/* The first time within the step at which the mode, the phase or the clamp has to change, guards being due
 * `margin_factor` times as far below zero as at first. Without one, the time up to which the step may be
 * used: a law has a kink there, a guard is known no further, or the search took too long; else infinity. */
tdmf_crossing tdmf_first_crossing(const tdmf_step *step, const tdmf_mode *mode, double margin_factor);

/* The first time after `from`, up to `to`, at which the ground force turns from rising to falling or back. In
 * contact only. */
tdmf_root tdmf_force_turn(const tdmf_step *step, bool rising, double from, double to);

/* The hip's power is sure to have one sign throughout the step. */
bool tdmf_power_keeps_sign(const tdmf_step *step);

/* The first time after `from`, up to `to`, at which the hip's power changes its sign. */
tdmf_root tdmf_power_turn(const tdmf_step *step, double from, double to);

#endif
