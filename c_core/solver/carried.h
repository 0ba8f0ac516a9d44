/* A first variation in the coordinates of a chart, carried from event to event. */
#ifndef TDMF_SOLVER_CARRIED_H
#define TDMF_SOLVER_CARRIED_H

#include "motion_series.h"
#include "step.h"
#include "tdmf_slip/variation.h"

typedef struct {
    tdmf_coordinates at;
    double com_x, com_y, com_vx, com_vy; /* in flight */
    double liftoff_angle, place_time;
} tdmf_carried;

/* The variation of a chart just opened on `state`. */
tdmf_carried tdmf_carry(const tdmf_chart *chart, const double state[TDMF_STATE_COUNT],
                        const tdmf_change *change, const tdmf_variation *variation);

/* Expands it along a step, and returns how long its series may be trusted: where the motion has come to rest,
 * they say what the motion's own series do not. */
double tdmf_carried_expand(const tdmf_step *step, const tdmf_mode *mode, const tdmf_change *change,
                           const tdmf_carried *carried, motion_variation *tangent);

/* Carries it along the step, up to `elapsed`. */
void tdmf_carry_on(const tdmf_step *step, double elapsed, const tdmf_change *change,
                   const motion_variation *tangent, tdmf_carried *carried);

/* Back to a variation of the state at the chart's instant or, after tdmf_carry_on, at the time carried to,
 * where the state is `state`. */
tdmf_variation tdmf_carried_to(const tdmf_chart *chart, const double state[TDMF_STATE_COUNT],
                               const tdmf_change *change, const tdmf_carried *carried);

#endif
