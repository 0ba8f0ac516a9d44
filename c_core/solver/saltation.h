/* Saltation: what an event makes of a first variation. */
#ifndef TDMF_SOLVER_SALTATION_H
#define TDMF_SOLVER_SALTATION_H

#include "tdmf_slip/automaton.h"
#include "tdmf_slip/variation.h"

/* The runner as it is on one side of an event. */
typedef struct {
    double state[TDMF_STATE_COUNT];
    double derivatives[TDMF_STATE_COUNT];
    tdmf_mode mode;
    double peak_force, peak_vertical_force; /* of the stride under way, so far */
} tdmf_event_state;

/* How a variation meets an event. */
typedef struct {
    double shift; /* s, by which the event is later */
    double before[TDMF_STATE_COUNT],
        after[TDMF_STATE_COUNT]; /* of the state where it is met, on either side */
} tdmf_met_event;

/* The variation after an event that `guard` has fired, from that before it, each at a fixed time, and how it
 * meets the event. It is not a number where there is no derivative. */
tdmf_variation tdmf_saltation(tdmf_system system, tdmf_guard guard, const tdmf_event_state *before,
                              const tdmf_event_state *after, const tdmf_seed *seed,
                              const tdmf_variation *variation, tdmf_met_event *met);

#endif
