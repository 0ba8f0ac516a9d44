/* The hip's law as data: in every phase it is affine in the leg's angle, its rate and time,
 *
 *     tau = gain (target + target_rate t - theta) - rate_gain thetadot + torque + torque_rate t,
 *
 * with t counted from now. hip.c has the laws themselves. */
#ifndef TDMF_MODEL_HIP_LAW_H
#define TDMF_MODEL_HIP_LAW_H

#include "direction.h"

typedef struct {
    double gain, rate_gain; /* N.m/rad, N.m.s/rad */
    double target;          /* rad */
    double target_rate;     /* rad/s */
    double torque;          /* N.m */
    double torque_rate;     /* N.m/s */
} tdmf_hip_law;

/* The torque from outside alone. `rates` are those of the inputs. */
tdmf_hip_law tdmf_external_law(const tdmf_inputs *inputs, const tdmf_inputs *rates);

/* On a loaded foot, with the external torque. */
tdmf_hip_law tdmf_stance_law(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_inputs *rates,
                             const tdmf_mode *mode);

/* Off the ground, with the external torque and the clamp as the mode has it; `place_time` is the time since
 * place began, if it has. */
tdmf_hip_law tdmf_flight_law(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_inputs *rates,
                             const tdmf_mode *mode, double place_time);

/* The servo of the flight law alone: its torque is what the clamp is decided by. */
tdmf_hip_law tdmf_servo(const tdmf_model *model, const tdmf_mode *mode, double place_time);

/* The same, varied; the clamp is held. */
tdmf_hip_law tdmf_vary_stance_law(const tdmf_mode *mode, const tdmf_direction *d);
tdmf_hip_law tdmf_vary_flight_law(const tdmf_model *model, const tdmf_mode *mode, double place_time,
                                  const tdmf_direction *d);
tdmf_hip_law tdmf_vary_servo(const tdmf_model *model, const tdmf_mode *mode, double place_time,
                             const tdmf_direction *d);

/* The servo is zero whatever the leg does, but not along the direction: no derivative tells what the clamp
 * makes of it. */
bool tdmf_clamp_has_no_derivative(const tdmf_model *model, const tdmf_mode *mode, const tdmf_direction *d);

/* How fast the time since place began runs: 1 in place, else 0. */
static inline double tdmf_place_time_rate(const tdmf_mode *mode) {
    return mode->phase == TDMF_PHASE_PLACE ? 1.0 : 0.0;
}

/* Makes it the law some time later. */
static inline void tdmf_shift_law(tdmf_hip_law *law, double elapsed) {
    law->target += elapsed * law->target_rate;
    law->torque += elapsed * law->torque_rate;
}

/* How fast the torque of a law changes while the leg stands still, N.m/s, and its change. */
static inline double tdmf_law_drift(const tdmf_hip_law *law) {
    return law->torque_rate + law->gain * law->target_rate;
}
double tdmf_vary_law_drift(const tdmf_hip_law *law, const tdmf_hip_law *d_law);

/* The torque that a law applies now, N.m, and its change. */
double tdmf_law_torque(const tdmf_hip_law *law, const double state[TDMF_STATE_COUNT]);
double tdmf_vary_law_torque(const tdmf_hip_law *law, const tdmf_hip_law *d_law,
                            const double state[TDMF_STATE_COUNT], const double d_state[TDMF_STATE_COUNT]);

#endif
