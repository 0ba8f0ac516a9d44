/* Where in a step the first guard fires. */
#ifndef TDMF_SOLVER_LOCATE_H
#define TDMF_SOLVER_LOCATE_H

#include "pair.h"
#include "tdmf_slip/automaton.h"

/* What evaluates a guard inside a step. */
typedef struct {
    const tdmf_chart *chart;
    const tdmf_model *model;
    const tdmf_inputs *inputs; /* at the start of the step */
    const tdmf_input_rates *rates;
    const tdmf_mode *mode;
    tdmf_pair_step *step;
} tdmf_search;

/* The earliest fraction of the step at which the mode, the phase or the clamp has to change, or 2 if none has
 * to: the first guard at or below zero, the force peak left out. */
double tdmf_first_crossing(const tdmf_search *search, const tdmf_watch *start, const tdmf_watch *end);

/* The fraction at which one guard, positive at the start, crosses zero for good before `fraction`, or 2. */
double tdmf_guard_crossing(const tdmf_search *search, tdmf_guard guard, double fraction);

/* The fraction at which the hip's power changes its sign, known to differ at 0 and at `fraction`. */
double tdmf_power_reversal(const tdmf_search *search, double fraction);

#endif
