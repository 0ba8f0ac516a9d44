/* Events of the automaton. Each is a pair of a guard and a reset; the table of equations/events.py has them
 * all, and says which mode watches which. */
#ifndef TDMF_MODEL_EVENTS_H
#define TDMF_MODEL_EVENTS_H

#include "evaluation.h"
#include "margins.h"
#include "tdmf_slip/automaton.h"

/* A run as its resets see it: what is given, the instant, and what they may change. No reset moves the leg.
 */
typedef struct {
    tdmf_system system;
    tdmf_motion *motion;
    tdmf_leg_direction direction; /* of the leg in it */
} tdmf_run;

/* The run in a mode as it is now, or in another that it might be in. */
tdmf_evaluation tdmf_evaluate_run(const tdmf_run *run, const tdmf_mode *mode);

/* tdmf_observe, where the instant has been evaluated already. */
void tdmf_observe_evaluated(const tdmf_evaluation *at, tdmf_motion *motion);

/* Takes all that are due, and sees to the peaks of the ground force. False where the chain did not come to
 * rest. */
bool tdmf_take_transitions(tdmf_run *run);

/* The right-hand side and the ground are the same: contact, phase, zone, clamp, thrust, line and fall. */
static inline bool tdmf_same_mode(const tdmf_mode *a, const tdmf_mode *b) {
    return a->contact == b->contact && a->phase == b->phase && a->zone == b->zone &&
           a->liftoff_angle == b->liftoff_angle && a->mid_stance_pending == b->mid_stance_pending &&
           a->clamp_closed == b->clamp_closed && a->rest_length == b->rest_length &&
           a->ground.height == b->ground.height && a->ground.slope == b->ground.slope &&
           a->fallen == b->fallen;
}

#endif
