/* The steps of the automaton that a start shares with a running one. */
#ifndef TDMF_MODEL_TRANSITIONS_H
#define TDMF_MODEL_TRANSITIONS_H

#include "tdmf_slip/automaton.h"

/* The right-hand side is the same: contact, phase, clamp and fall. */
static inline bool tdmf_same_mode(const tdmf_mode *a, const tdmf_mode *b) {
    return a->contact == b->contact && a->phase == b->phase && a->liftoff_angle == b->liftoff_angle &&
           a->mid_stance_pending == b->mid_stance_pending && a->clamp_closed == b->clamp_closed &&
           a->fallen == b->fallen;
}

/* A run as its transitions see it: what is given, the instant, and what they may change. */
typedef struct {
    const tdmf_model *model;
    const tdmf_inputs *inputs;
    double time;
    double *state;
    tdmf_mode *mode;
    tdmf_record *record;
} tdmf_run;

/* Enters flight, in the phase that the centre of mass decides. */
void tdmf_fly(tdmf_run *run);

/* A foot at y = vy = 0 after an impact or at a start: contact, flight or graze. */
void tdmf_come_to_ground(tdmf_run *run);

/* The foot hits the ground. */
void tdmf_touch_down(tdmf_run *run);

/* The centre of mass is highest in flight. */
void tdmf_reach_apex(tdmf_run *run);

/* Takes all that are due, as tdmf_resolve does, but does not look at the ground force for its peak. False
 * where the chain did not come to rest. */
bool tdmf_take_transitions(tdmf_run *run);

#endif
