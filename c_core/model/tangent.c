/* The equations of leg.h, hip.c, contact.c, dynamics.c, kinematics.c and energy.c, differentiated by hand
 * along a direction; a name with `d` in front is the change of the quantity without it. */
#include "tdmf_slip/tangent.h"

#include "leg.h"
#include "tdmf_slip/hip.h"

#include <string.h>

/* Values and changes of what the other quantities are made of. */
typedef struct {
    const tdmf_model *model;
    const tdmf_inputs *inputs;
    const tdmf_mode *mode;
    const double *state, *dstate;
    tdmf_leg leg, dleg;
    double torque, dtorque;
    double across, dacross; /* tau/r */
    tdmf_ground_force force, dforce;
} point;

static tdmf_leg change_of_leg(const tdmf_model *model, const tdmf_leg *leg,
                              const double dstate[TDMF_STATE_COUNT]) {
    const double dlength = dstate[TDMF_LEG_LENGTH];
    const bool floored = leg->length < 0.5 * model->parameters.leg.min_length;
    const tdmf_leg dleg = {
        .length = dlength,
        .inverse_length = floored ? 0.0 : -leg->inverse_length * leg->inverse_length * dlength,
        .length_rate = dstate[TDMF_LEG_LENGTH_RATE],
        .angle_rate = dstate[TDMF_LEG_ANGLE_RATE],
        .sine = leg->cosine * dstate[TDMF_LEG_ANGLE],
        .cosine = -leg->sine * dstate[TDMF_LEG_ANGLE],
        .axial_force = -model->parameters.leg.stiffness * dlength -
                       model->parameters.leg.damping * dstate[TDMF_LEG_LENGTH_RATE],
    };
    return dleg;
}

/* tau sin/r = F_s cos + m_f g, differentiated. */
static double change_of_graze_torque(const point *at) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg *dleg = &at->dleg;
    const double dpress = dleg->axial_force * leg->cosine + leg->axial_force * dleg->cosine;
    const double lever = leg->sine * leg->inverse_length;
    const double dlever = dleg->sine * leg->inverse_length + leg->sine * dleg->inverse_length;
    return lever == 0.0 ? 0.0 : (dpress - at->torque * dlever) / lever;
}

static double change_of_torque(const point *at, const tdmf_inputs *dinputs) {
    const tdmf_parameters *p = &at->model->parameters;
    const bool clamped = at->mode->phase == TDMF_PHASE_RETRACT && at->mode->clamp_closed;
    switch (at->mode->contact) {
    case TDMF_CONTACT_GRAZE:
        return change_of_graze_torque(at);
    case TDMF_CONTACT_FLIGHT:
        return dinputs->hip.external_torque -
               (clamped ? 0.0 : p->hip.kp * at->dstate[TDMF_LEG_ANGLE] + p->hip.kd * at->dleg.angle_rate);
    default:
        return dinputs->hip.external_torque;
    }
}

static tdmf_ground_force change_of_force(const point *at, const tdmf_inputs *dinputs) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg *dleg = &at->dleg;
    tdmf_ground_force dforce = {0.0, 0.0};
    if (!tdmf_in_contact(at->mode)) {
        return dforce;
    }
    dforce.fy = dleg->axial_force * leg->cosine + leg->axial_force * dleg->cosine - at->dacross * leg->sine -
                at->across * dleg->sine;
    if (at->mode->contact == TDMF_CONTACT_STICK) {
        dforce.fx = -dleg->axial_force * leg->sine - leg->axial_force * dleg->sine -
                    at->dacross * leg->cosine - at->across * dleg->cosine;
    } else {
        dforce.fx = -tdmf_slip_sign(at->mode) *
                    (dinputs->ground.friction * at->force.fy + at->inputs->ground.friction * dforce.fy);
    }
    return dforce;
}

static tdmf_point change_of_foot_acceleration(const point *at, tdmf_point *acceleration) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg *dleg = &at->dleg;
    const double inverse_mass = at->model->inverse_foot_mass;
    tdmf_point change = {0.0, 0.0, 0.0, 0.0};
    memset(acceleration, 0, sizeof *acceleration);
    if (at->mode->contact != TDMF_CONTACT_STICK) {
        acceleration->vx =
            inverse_mass * (at->force.fx + leg->axial_force * leg->sine + at->across * leg->cosine);
        change.vx =
            inverse_mass * (at->dforce.fx + dleg->axial_force * leg->sine + leg->axial_force * dleg->sine +
                            at->dacross * leg->cosine + at->across * dleg->cosine);
    }
    if (at->mode->contact == TDMF_CONTACT_FLIGHT) {
        acceleration->vy = inverse_mass * (-leg->axial_force * leg->cosine + at->across * leg->sine) -
                           at->model->parameters.gravity;
        change.vy = inverse_mass * (-dleg->axial_force * leg->cosine - leg->axial_force * dleg->cosine +
                                    at->dacross * leg->sine + at->across * dleg->sine);
    }
    return change;
}

static void change_of_leg_acceleration(const point *at, double derivatives[TDMF_STATE_COUNT]) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg *dleg = &at->dleg;
    const double g = at->model->parameters.gravity;
    const double inverse_mass = at->model->inverse_body_mass;
    tdmf_point foot;
    const tdmf_point dfoot = change_of_foot_acceleration(at, &foot);
    const double turn = at->across * inverse_mass + g * leg->sine + foot.vx * leg->cosine +
                        foot.vy * leg->sine - 2.0 * leg->length_rate * leg->angle_rate;
    const double dturn = at->dacross * inverse_mass + g * dleg->sine + dfoot.vx * leg->cosine +
                         foot.vx * dleg->cosine + dfoot.vy * leg->sine + foot.vy * dleg->sine -
                         2.0 * (dleg->length_rate * leg->angle_rate + leg->length_rate * dleg->angle_rate);
    derivatives[TDMF_FOOT_VX] = dfoot.vx;
    derivatives[TDMF_FOOT_VY] = dfoot.vy;
    derivatives[TDMF_LEG_LENGTH_RATE] = dleg->length * leg->angle_rate * leg->angle_rate +
                                        2.0 * leg->length * leg->angle_rate * dleg->angle_rate +
                                        dleg->axial_force * inverse_mass - g * dleg->cosine +
                                        dfoot.vx * leg->sine + foot.vx * dleg->sine - dfoot.vy * leg->cosine -
                                        foot.vy * dleg->cosine;
    derivatives[TDMF_LEG_ANGLE_RATE] = dturn * leg->inverse_length + turn * dleg->inverse_length;
}

static void change_of_derivatives(const point *at, double derivatives[TDMF_STATE_COUNT]) {
    const double *state = at->state;
    const double *dstate = at->dstate;
    const double dpower = at->dtorque * at->leg.angle_rate + at->torque * at->dleg.angle_rate;
    memset(derivatives, 0, TDMF_STATE_COUNT * sizeof *derivatives);
    if (at->mode->fallen) {
        return;
    }
    derivatives[TDMF_FOOT_X] = dstate[TDMF_FOOT_VX];
    derivatives[TDMF_FOOT_Y] = dstate[TDMF_FOOT_VY];
    derivatives[TDMF_LEG_LENGTH] = dstate[TDMF_LEG_LENGTH_RATE];
    derivatives[TDMF_LEG_ANGLE] = dstate[TDMF_LEG_ANGLE_RATE];
    change_of_leg_acceleration(at, derivatives);
    derivatives[TDMF_HIP_WORK] = dpower;
    derivatives[TDMF_ENERGY_DAMPER_LOSS] =
        2.0 * at->model->parameters.leg.damping * at->leg.length_rate * at->dleg.length_rate;
    derivatives[TDMF_ENERGY_FRICTION_LOSS] =
        -at->dforce.fx * state[TDMF_FOOT_VX] - at->force.fx * dstate[TDMF_FOOT_VX];
    derivatives[TDMF_HIP_POSITIVE_WORK] = at->torque * at->leg.angle_rate > 0.0 ? dpower : 0.0;
}

static tdmf_point change_of_body(const point *at) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg *dleg = &at->dleg;
    const double across = leg->length * leg->angle_rate;
    const double dacross = dleg->length * leg->angle_rate + leg->length * dleg->angle_rate;
    const tdmf_point dbody = {
        .x = at->dstate[TDMF_FOOT_X] - dleg->length * leg->sine - leg->length * dleg->sine,
        .y = at->dstate[TDMF_FOOT_Y] + dleg->length * leg->cosine + leg->length * dleg->cosine,
        .vx = at->dstate[TDMF_FOOT_VX] - dleg->length_rate * leg->sine - leg->length_rate * dleg->sine -
              dacross * leg->cosine - across * dleg->cosine,
        .vy = at->dstate[TDMF_FOOT_VY] + dleg->length_rate * leg->cosine + leg->length_rate * dleg->cosine -
              dacross * leg->sine - across * dleg->sine,
    };
    return dbody;
}

static tdmf_point change_of_center_of_mass(const point *at, tdmf_point dbody) {
    const double *dstate = at->dstate;
    const double share = at->model->parameters.body.mass / at->model->total_mass;
    const tdmf_point dcom = {
        .x = dstate[TDMF_FOOT_X] + share * (dbody.x - dstate[TDMF_FOOT_X]),
        .y = dstate[TDMF_FOOT_Y] + share * (dbody.y - dstate[TDMF_FOOT_Y]),
        .vx = dstate[TDMF_FOOT_VX] + share * (dbody.vx - dstate[TDMF_FOOT_VX]),
        .vy = dstate[TDMF_FOOT_VY] + share * (dbody.vy - dstate[TDMF_FOOT_VY]),
    };
    return dcom;
}

static tdmf_energy change_of_energy(const point *at, tdmf_point dbody) {
    const tdmf_parameters *p = &at->model->parameters;
    const tdmf_point body = tdmf_body(at->state);
    tdmf_energy denergy = {
        .kinetic = p->body.mass * (body.vx * dbody.vx + body.vy * dbody.vy) +
                   p->foot.mass * (at->state[TDMF_FOOT_VX] * at->dstate[TDMF_FOOT_VX] +
                                   at->state[TDMF_FOOT_VY] * at->dstate[TDMF_FOOT_VY]),
        .potential = p->gravity * (p->body.mass * dbody.y + p->foot.mass * at->dstate[TDMF_FOOT_Y]),
        .elastic = -p->leg.stiffness * (p->leg.free_length - at->leg.length) * at->dleg.length,
    };
    denergy.total = denergy.kinetic + denergy.potential + denergy.elastic;
    return denergy;
}

tdmf_tangent tdmf_tangent_along(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                                const double state[TDMF_STATE_COUNT], const tdmf_inputs *input_direction,
                                const double state_direction[TDMF_STATE_COUNT]) {
    point at = {.model = model, .inputs = inputs, .mode = mode, .state = state, .dstate = state_direction};
    at.leg = tdmf_leg_of(model, state);
    at.dleg = change_of_leg(model, &at.leg, state_direction);
    at.torque = tdmf_leg_hip_torque(model, inputs, mode, state, &at.leg);
    at.dtorque = change_of_torque(&at, input_direction);
    at.across = at.torque * at.leg.inverse_length;
    at.dacross = at.dtorque * at.leg.inverse_length + at.torque * at.dleg.inverse_length;
    at.force = tdmf_leg_contact_force(model, inputs, mode, at.torque, &at.leg);
    at.dforce = change_of_force(&at, input_direction);

    tdmf_tangent tangent;
    change_of_derivatives(&at, tangent.derivatives);
    tangent.body = change_of_body(&at);
    tangent.com = change_of_center_of_mass(&at, tangent.body);
    tangent.contact = at.dforce;
    tangent.torque = at.dtorque;
    tangent.energy = change_of_energy(&at, tangent.body);
    return tangent;
}
