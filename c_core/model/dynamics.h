/* Accelerations at an instant that has been evaluated, and their variations. */
#ifndef TDMF_MODEL_DYNAMICS_H
#define TDMF_MODEL_DYNAMICS_H

#include "evaluation.h"
#include "tdmf_slip/dynamics.h"

typedef struct {
    double foot_ax, foot_ay; /* m/s2 */
    double length;           /* rddot, m/s2 */
    double angle;            /* thetaddot, rad/s2 */
} tdmf_acceleration;

tdmf_acceleration tdmf_accelerate(const tdmf_evaluation *at);

/* The change of tdmf_derivatives, of a run that has not fallen. */
void tdmf_vary_rates_of_state(const tdmf_evaluation *at, const tdmf_evaluation *d,
                              double derivatives[TDMF_STATE_COUNT]);

/* Rate of the force that would hold the foot still under the torque of `at`, N/s: inputs held, leg moving as
 * in the mode. */
double tdmf_normal_force_rate(const tdmf_evaluation *at);

#endif
