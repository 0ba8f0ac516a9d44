/* A first variation in the coordinates of a mode, from event to event. */
#ifndef TDMF_SOLVER_MODE_VARIATION_H
#define TDMF_SOLVER_MODE_VARIATION_H

#include "motion_series.h"
#include "step.h"
#include "tdmf_slip/variation.h"

typedef struct {
    tdmf_mode_coordinates at;
    tdmf_point com;          /* in flight */
    tdmf_variation constant; /* what no series moves: the angle of lift-off and states without a series */
} tdmf_mode_variation;

/* The variation in a mode just opened on `state`. */
tdmf_mode_variation tdmf_open_mode_variation(const tdmf_mode_equations *equations,
                                             const double state[TDMF_STATE_COUNT], const tdmf_seed *seed,
                                             const tdmf_variation *variation);

/* Expands it along a step, and returns how long its series may be trusted: where the motion has come to rest,
 * they say what the motion's own series do not. */
double tdmf_expand_mode_variation(const tdmf_step *step, const tdmf_mode *mode, const tdmf_seed *seed,
                                  const tdmf_mode_variation *varied_mode, motion_variation *varied_series);

/* Takes it along the step, up to `elapsed`. */
void tdmf_advance_mode_variation(const tdmf_step *step, double elapsed, const tdmf_seed *seed,
                                 const motion_variation *varied_series, tdmf_mode_variation *varied_mode);

/* Back to a variation of the state at the equations' instant or, after tdmf_advance_mode_variation, at the
 * time reached, where the state is `state`. */
tdmf_variation tdmf_variation_in_mode(const tdmf_mode_equations *equations,
                                      const double state[TDMF_STATE_COUNT], const tdmf_seed *seed,
                                      const tdmf_mode_variation *varied_mode);

#endif
