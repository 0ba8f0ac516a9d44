/* Events of the automaton. Each is a pair of a guard and a reset, with their variations; the table of
 * equations/events.py has them all, and says which mode watches which. */
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

/* tdmf_resolve, where the leg's direction is at hand. `reached` is the guard whose zero a solver has come to,
 * and which is due there, before its margin is passed; TDMF_GUARD_COUNT for none. */
tdmf_resolution tdmf_resolve_along(tdmf_system system, tdmf_motion *motion, tdmf_leg_direction direction,
                                   tdmf_guard reached);

/* The same, without the peaks of the ground force in the record. */
tdmf_resolution tdmf_resolve_unobserved(tdmf_system system, tdmf_motion *motion, tdmf_leg_direction direction,
                                        tdmf_guard reached);

/* The run in a mode as it is now, or in another that it might be in. */
tdmf_evaluation tdmf_evaluate_run(const tdmf_run *run, const tdmf_mode *mode);

/* tdmf_observe, where the instant has been evaluated already. */
void tdmf_observe_evaluated(const tdmf_evaluation *at, tdmf_motion *motion);

typedef struct {
    /* Positive while the event is to come, a pure number. */
    double (*guard)(const tdmf_evaluation *at);
    /* Its change along a direction, up to the guard's scale; `d` is that of `at`. NULL: no variation outlives
     * the event. */
    double (*vary_guard)(const tdmf_evaluation *at, const tdmf_evaluation *d);
    /* What the event makes of the run, its record included. NULL: nothing that the motion depends on. */
    void (*reset)(tdmf_run *run);
    /* What the reset makes of a change of the state; NULL where the state does not jump. */
    void (*vary_reset)(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_ground_line *ground,
                       const double before[TDMF_STATE_COUNT], const tdmf_local_seed *d,
                       double d_state[TDMF_STATE_COUNT]);
    bool is_impact; /* the foot comes to the ground with a velocity */
} tdmf_event_kind;

/* The event that a guard announces. */
const tdmf_event_kind *tdmf_event_kind_of(tdmf_guard guard);

/* Takes all that are due, as tdmf_resolve_along does, and sees to the peaks of the ground force if it
 * `observes`. False where the chain did not come to rest. */
bool tdmf_take_transitions(tdmf_run *run, tdmf_guard reached, bool observes);

/* The right-hand side and the ground are the same: contact, phase, zone, clamp, thrust, line and fall. */
static inline bool tdmf_same_mode(const tdmf_mode *a, const tdmf_mode *b) {
    return a->contact == b->contact && a->phase == b->phase && a->zone == b->zone &&
           a->liftoff_angle == b->liftoff_angle && a->mid_stance_pending == b->mid_stance_pending &&
           a->clamp_closed == b->clamp_closed && a->rest_length == b->rest_length &&
           a->ground.height == b->ground.height && a->ground.slope == b->ground.slope &&
           a->fallen == b->fallen;
}

#endif
