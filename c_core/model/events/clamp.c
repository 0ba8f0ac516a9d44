/* Clamp: the servo of retract changes its sign, and the clamp of (12) opens or closes. */
#include "events.h"

static double servo_torque(const tdmf_evaluation *at) {
    return tdmf_armed_against_turning(tdmf_servo_torque(at->model, at->inputs, at->mode, at->state),
                                      at->model->scales.energy, at->mode->clamp_closed);
}

static double vary_servo_torque(const tdmf_evaluation *at, const tdmf_direction *d,
                                const tdmf_evaluation *d_at) {
    (void)d;
    return tdmf_vary_servo_torque(at->model, at->inputs, at->mode, at->state, d_at->model, d_at->inputs,
                                  d_at->mode, d_at->state);
}

/* Neither a contact nor a phase changes, so that it is not counted. */
static void reset(tdmf_run *run) {
    run->mode->clamp_closed = !run->mode->clamp_closed;
}

const tdmf_event_kind tdmf_clamp = {servo_torque, vary_servo_torque, reset, NULL};
