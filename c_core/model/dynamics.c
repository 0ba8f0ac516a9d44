/* The equations of motion (8)-(9), solved for the accelerations by writing Newton's law for each point mass.
 * With u = (-sin, cos), t = (-cos, -sin) and the ground force (f_x, f_y) of the mode:
 *
 *     foot:  m_f ax = f_x + F_s sin + (tau/r) cos        m_f ay = f_y - F_s cos + (tau/r) sin - m_f g
 *     body:  u.a_body = F_s/m - g cos                    t.a_body = tau/(m r) + g sin
 *     leg:   rddot = r thetadot^2 + u.(a_body - a_foot)
 *            r thetaddot = t.(a_body - a_foot) - 2 rdot thetadot
 *
 * A foot on the ground has ay = 0, and one that sticks ax = 0, exactly and not by cancellation. */
#include "tdmf_slip/dynamics.h"

#include "leg.h"

#include <string.h>

typedef struct {
    double ax, ay;
} foot_acceleration;

static foot_acceleration accelerate_foot(const tdmf_model *model, const tdmf_mode *mode, const tdmf_leg *leg,
                                         double across, tdmf_ground_force force) {
    foot_acceleration foot = {0.0, 0.0};
    if (mode->contact != TDMF_CONTACT_STICK) {
        foot.ax = (force.fx + leg->axial_force * leg->sine + across * leg->cosine) * model->inverse_foot_mass;
    }
    if (mode->contact == TDMF_CONTACT_FLIGHT) {
        foot.ay = (-leg->axial_force * leg->cosine + across * leg->sine) * model->inverse_foot_mass -
                  model->parameters.gravity;
    }
    return foot;
}

static void derivatives_of_leg(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                               const double state[TDMF_STATE_COUNT], const tdmf_leg *leg,
                               double derivatives[TDMF_STATE_COUNT]) {
    const double g = model->parameters.gravity;
    const double torque = tdmf_leg_hip_torque(model, inputs, mode, state, leg);
    const double across = torque * leg->inverse_length;
    const tdmf_ground_force force = tdmf_leg_contact_force(model, inputs, mode, torque, leg);
    const foot_acceleration foot = accelerate_foot(model, mode, leg, across, force);

    const double body_along = leg->axial_force * model->inverse_body_mass - g * leg->cosine;
    const double body_across = across * model->inverse_body_mass + g * leg->sine;
    const double foot_along = -foot.ax * leg->sine + foot.ay * leg->cosine;
    const double foot_across = -foot.ax * leg->cosine - foot.ay * leg->sine;
    const double power = torque * leg->angle_rate;

    derivatives[TDMF_FOOT_X] = state[TDMF_FOOT_VX];
    derivatives[TDMF_FOOT_Y] = state[TDMF_FOOT_VY];
    derivatives[TDMF_LEG_LENGTH] = leg->length_rate;
    derivatives[TDMF_LEG_ANGLE] = leg->angle_rate;
    derivatives[TDMF_FOOT_VX] = foot.ax;
    derivatives[TDMF_FOOT_VY] = foot.ay;
    derivatives[TDMF_LEG_LENGTH_RATE] =
        leg->length * leg->angle_rate * leg->angle_rate + body_along - foot_along;
    derivatives[TDMF_LEG_ANGLE_RATE] =
        (body_across - foot_across - 2.0 * leg->length_rate * leg->angle_rate) * leg->inverse_length;
    derivatives[TDMF_HIP_WORK] = power;
    derivatives[TDMF_ENERGY_DAMPER_LOSS] =
        model->parameters.leg.damping * leg->length_rate * leg->length_rate;
    derivatives[TDMF_ENERGY_FRICTION_LOSS] = -force.fx * state[TDMF_FOOT_VX];
    derivatives[TDMF_HIP_POSITIVE_WORK] = fmax(power, 0.0);
}

void tdmf_derivatives(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                      const double state[TDMF_STATE_COUNT], double derivatives[TDMF_STATE_COUNT]) {
    if (mode->fallen) {
        memset(derivatives, 0, TDMF_STATE_COUNT * sizeof *derivatives);
        return;
    }
    const tdmf_leg leg = tdmf_leg_of(model, state);
    derivatives_of_leg(model, inputs, mode, state, &leg, derivatives);
}

double tdmf_leg_ground_force_rate(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                                  const double state[TDMF_STATE_COUNT], const tdmf_leg *leg) {
    double derivatives[TDMF_STATE_COUNT];
    derivatives_of_leg(model, inputs, mode, state, leg, derivatives);
    const double torque = tdmf_leg_hip_torque(model, inputs, mode, state, leg);
    return tdmf_leg_sticking_force_rate(model, torque, 0.0, derivatives[TDMF_LEG_LENGTH_RATE], leg).fy;
}

double tdmf_ground_force_rate(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                              const double state[TDMF_STATE_COUNT]) {
    const tdmf_leg leg = tdmf_leg_of(model, state);
    return tdmf_leg_ground_force_rate(model, inputs, mode, state, &leg);
}
