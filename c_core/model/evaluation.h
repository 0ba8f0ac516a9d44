/* A runner at one instant, for all that reads it: the leg, the hip's torque and the ground force, evaluated
 * once and in the one order in which each follows from those before it. In line: a right-hand side is hardly
 * more than this. */
#ifndef TDMF_MODEL_EVALUATION_H
#define TDMF_MODEL_EVALUATION_H

#include "contact_mode.h"
#include "friction.h"
#include "ground_force_laws.h"
#include "ground_line.h"
#include "hip_law.h"
#include "leg.h"
#include "margins.h"
#include "seed.h"

/* The foot is below the body: sin(theta'), which no torque's lever may be made of, is as good as zero. */
static inline bool tdmf_is_upright(const tdmf_leg *leg) {
    return fabs(leg->ground_sine) <= TDMF_SMALLEST_SINE;
}

/* What stands for the sine then. */
static inline double tdmf_sine_away_from_zero(const tdmf_leg *leg) {
    return copysign(TDMF_SMALLEST_SINE, leg->ground_sine);
}

/* Where the leg's direction is at hand. The other arguments are not copied. The torque is not a number in a
 * mode that there is not, so that nothing that follows from it passes for a result. */
static inline tdmf_evaluation tdmf_evaluate_along(tdmf_system system, const tdmf_mode *mode,
                                                  const double state[TDMF_STATE_COUNT],
                                                  tdmf_leg_direction direction) {
    tdmf_evaluation at = {.model = system.model, .inputs = system.inputs, .mode = mode, .state = state};
    at.leg = tdmf_leg_along(system.model, system.inputs, mode, state, direction);
    at.torque = tdmf_is_mode(mode)
                    ? tdmf_torque_in(&at, tdmf_is_upright(&at.leg), tdmf_sine_away_from_zero(&at.leg))
                    : (double)NAN;
    at.force = tdmf_force_in(&at, tdmf_sign_of_slip(mode), tdmf_friction_falls(system.model));
    return at;
}

static inline tdmf_evaluation tdmf_evaluate(tdmf_system system, const tdmf_mode *mode,
                                            const double state[TDMF_STATE_COUNT]) {
    return tdmf_evaluate_along(system, mode, state, tdmf_leg_direction_of(state));
}

/* What the height of the foot may be wrong by. */
static inline double tdmf_rounding_at_foot(const tdmf_evaluation *at) {
    return tdmf_rounding_of_height(&at->mode->ground, at->state[TDMF_FOOT_X]);
}

/* How what is evaluated changes along a direction, in the same shape; the mode is held but for its lift-off
 * angle. The state's change stands in place of the direction's own. */
tdmf_evaluation tdmf_vary_evaluation(const tdmf_evaluation *at, const tdmf_local_seed *d,
                                     const double d_state[TDMF_STATE_COUNT]);

#endif
