/* The hip's torques at an instant, with the inputs held, and their changes. */
#ifndef TDMF_MODEL_HIP_TORQUE_H
#define TDMF_MODEL_HIP_TORQUE_H

#include "ground_force.h"
#include "hip_law.h"

/* ---- of the servo of the flight law alone ------------------------------------------------------------- */

static inline double tdmf_servo_torque(const tdmf_model *model, const tdmf_inputs *inputs,
                                       const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    const tdmf_hip_law servo = tdmf_servo(model, inputs, mode, state[TDMF_HIP_PLACE_TIME]);
    return tdmf_law_torque(&servo, state);
}

static inline double tdmf_vary_servo_torque(const tdmf_model *model, const tdmf_inputs *inputs,
                                            const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                                            const tdmf_direction *d) {
    const tdmf_hip_law servo = tdmf_servo(model, inputs, mode, state[TDMF_HIP_PLACE_TIME]);
    const tdmf_hip_law d_servo = tdmf_vary_servo(model, mode, state[TDMF_HIP_PLACE_TIME], d);
    return tdmf_vary_law_torque(&servo, &d_servo, state, d->state);
}

/* ---- under the stance law, where the leg is evaluated -------------------------------------------------- */

static inline double tdmf_stance_torque(const tdmf_evaluation *at) {
    const tdmf_hip_law law = tdmf_stance_law(at->model, at->inputs, &tdmf_held_inputs, at->mode);
    return tdmf_law_torque(&law, at->state);
}

static inline double tdmf_vary_stance_torque(const tdmf_evaluation *at, const tdmf_direction *d) {
    const tdmf_hip_law law = tdmf_stance_law(at->model, at->inputs, &tdmf_held_inputs, at->mode);
    const tdmf_hip_law d_law = tdmf_vary_stance_law(at->mode, d);
    return tdmf_vary_law_torque(&law, &d_law, at->state, d->state);
}

/* ---- under the flight law in a mode, where the leg is evaluated ---------------------------------------- */

static inline double tdmf_flight_torque(const tdmf_evaluation *at, const tdmf_mode *mode) {
    const tdmf_hip_law law =
        tdmf_flight_law(at->model, at->inputs, &tdmf_held_inputs, mode, at->state[TDMF_HIP_PLACE_TIME]);
    return tdmf_law_torque(&law, at->state);
}

static inline double tdmf_vary_flight_torque(const tdmf_evaluation *at, const tdmf_mode *mode,
                                             const tdmf_direction *d) {
    const tdmf_hip_law law =
        tdmf_flight_law(at->model, at->inputs, &tdmf_held_inputs, mode, at->state[TDMF_HIP_PLACE_TIME]);
    const tdmf_hip_law d_law = tdmf_vary_flight_law(at->model, mode, at->state[TDMF_HIP_PLACE_TIME], d);
    return tdmf_vary_law_torque(&law, &d_law, at->state, d->state);
}

/* ---- the total torque in the mode, where the leg is evaluated ------------------------------------------ */

/* Not a number in a mode that there is not, so that nothing that follows from it passes for a result. */
static inline double tdmf_torque_in_mode(const tdmf_evaluation *at) {
    if (!tdmf_is_mode(at->mode)) {
        return (double)NAN;
    }
    switch (at->mode->contact) {
    case TDMF_CONTACT_GRAZE:
        return tdmf_graze_torque(at);
    case TDMF_CONTACT_FLIGHT:
        return tdmf_flight_torque(at, at->mode);
    default:
        return tdmf_stance_torque(at);
    }
}

static inline double tdmf_vary_torque_in_mode(const tdmf_evaluation *at, const tdmf_leg *d_leg,
                                              const tdmf_direction *d) {
    switch (at->mode->contact) {
    case TDMF_CONTACT_GRAZE:
        return tdmf_vary_graze_torque(at, d_leg, d);
    case TDMF_CONTACT_FLIGHT:
        return tdmf_vary_flight_torque(at, at->mode, d);
    default:
        return tdmf_vary_stance_torque(at, d);
    }
}

#endif
