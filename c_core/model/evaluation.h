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

typedef struct {
    const tdmf_model *model;
    const tdmf_inputs *inputs;
    const tdmf_mode *mode;
    const double *state;
    tdmf_leg leg;
    double torque;           /* tau, total */
    double friction;         /* mu below a foot that slips */
    tdmf_ground_force force; /* of the mode */
} tdmf_evaluation;

/* The foot is below the body: sin(theta'), which no torque's lever may be made of, is as good as zero. */
static inline bool tdmf_is_upright(const tdmf_leg *leg) {
    return fabs(leg->ground_sine) <= TDMF_SMALLEST_SINE;
}

/* What stands for the sine then. */
static inline double tdmf_sine_away_from_zero(const tdmf_leg *leg) {
    return copysign(TDMF_SMALLEST_SINE, leg->ground_sine);
}

/* Where the leg is at hand. The other arguments are not copied. The torque is not a number in a mode that
 * there is not, so that nothing that follows from it passes for a result. */
static inline tdmf_evaluation tdmf_evaluate_leg(tdmf_system system, const tdmf_mode *mode,
                                                const double state[TDMF_STATE_COUNT], const tdmf_leg *leg) {
    tdmf_evaluation at;
    at.model = system.model;
    at.inputs = system.inputs;
    at.mode = mode;
    at.state = state;
    at.leg = *leg;
    at.torque = tdmf_is_mode(mode) ? tdmf_torque_in(system.model, system.inputs, mode, state, &at.leg,
                                                    tdmf_is_upright(leg), tdmf_sine_away_from_zero(leg))
                                   : (double)NAN;
    at.friction = tdmf_friction_below(system.model, system.inputs, mode->zone);
    at.force = tdmf_force_in(system.model, at.friction, &mode->ground, state, &at.leg, at.torque,
                             mode->contact, tdmf_sign_of_slip(mode), tdmf_friction_falls(system.model));
    return at;
}

static inline tdmf_evaluation tdmf_evaluate(tdmf_system system, const tdmf_mode *mode,
                                            const double state[TDMF_STATE_COUNT]) {
    const tdmf_leg leg = tdmf_leg_of(system, mode, state);
    return tdmf_evaluate_leg(system, mode, state, &leg);
}

/* The vertical component of a force of the ground on the foot, and its variation. */
static inline double tdmf_vertical_force(const tdmf_ground_line *line, tdmf_ground_force force) {
    return tdmf_vector_on(line, force.tangential, force.normal).y;
}

static inline double tdmf_vary_vertical_force(const tdmf_evaluation *at, const tdmf_evaluation *d) {
    return tdmf_vary_vector_on(&at->mode->ground, at->force.tangential, at->force.normal, &d->mode->ground,
                               d->force.tangential, d->force.normal)
        .y;
}

/* What the height of the foot may be wrong by. */
static inline double tdmf_rounding_at_foot(const tdmf_evaluation *at) {
    return tdmf_rounding_of_height(&at->mode->ground, at->state[TDMF_FOOT_X]);
}

/* How what is evaluated changes along a direction, in the same shape; the mode is held but for its lift-off
 * angle. */
tdmf_evaluation tdmf_vary_evaluation(const tdmf_evaluation *at, const tdmf_local_seed *d);

#endif
