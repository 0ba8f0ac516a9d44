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
    const tdmf_parameters *dparameters;
    const tdmf_inputs *dinputs;
    const double *state, *dstate;
    double dliftoff_angle;
    tdmf_leg leg, dleg;
    double torque, dtorque;
    double across, dacross; /* tau/r */
    tdmf_ground_force force, dforce;
} point;

static tdmf_leg change_of_leg(const tdmf_model *model, const tdmf_leg *leg,
                              const tdmf_parameters *dparameters, const double dstate[TDMF_STATE_COUNT]) {
    const tdmf_parameters *p = &model->parameters;
    const double dlength = dstate[TDMF_LEG_LENGTH];
    const bool floored = leg->length < 0.5 * p->leg.min_length;
    const double dbounded = floored ? 0.5 * dparameters->leg.min_length : dlength;
    const tdmf_leg dleg = {
        .length = dlength,
        .inverse_length = -leg->inverse_length * leg->inverse_length * dbounded,
        .length_rate = dstate[TDMF_LEG_LENGTH_RATE],
        .angle_rate = dstate[TDMF_LEG_ANGLE_RATE],
        .sine = leg->cosine * dstate[TDMF_LEG_ANGLE],
        .cosine = -leg->sine * dstate[TDMF_LEG_ANGLE],
        .axial_force = dparameters->leg.stiffness * (p->leg.free_length - leg->length) +
                       p->leg.stiffness * (dparameters->leg.free_length - dlength) -
                       dparameters->leg.damping * leg->length_rate -
                       p->leg.damping * dstate[TDMF_LEG_LENGTH_RATE],
    };
    return dleg;
}

static double change_of_foot_weight(const point *at) {
    const tdmf_parameters *p = &at->model->parameters;
    return at->dparameters->foot.mass * p->gravity + p->foot.mass * at->dparameters->gravity;
}

/* tau sin/r = F_s cos + m_f g, differentiated. */
static double change_of_graze_torque(const point *at) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg *dleg = &at->dleg;
    const double dpress =
        dleg->axial_force * leg->cosine + leg->axial_force * dleg->cosine + change_of_foot_weight(at);
    const double sine = tdmf_leg_graze_sine(leg);
    const double dsine = sine == leg->sine ? dleg->sine : 0.0;
    const double lever = sine * leg->inverse_length;
    const double dlever = dsine * leg->inverse_length + sine * dleg->inverse_length;
    return (dpress - at->torque * dlever) / lever;
}

/* -kp (theta - target) - kd thetadot, differentiated. */
static double change_of_flight_law(const point *at) {
    const tdmf_parameters *p = &at->model->parameters;
    const tdmf_parameters *dp = at->dparameters;
    const double liftoff_angle = at->mode->liftoff_angle;
    const bool places = at->mode->phase == TDMF_PHASE_PLACE;
    const double target = places ? p->hip.touchdown_angle : p->hip.liftoff_angle_factor * liftoff_angle;
    const double dtarget = places ? dp->hip.touchdown_angle
                                  : dp->hip.liftoff_angle_factor * liftoff_angle +
                                        p->hip.liftoff_angle_factor * at->dliftoff_angle;
    return -dp->hip.kp * (at->state[TDMF_LEG_ANGLE] - target) -
           p->hip.kp * (at->dstate[TDMF_LEG_ANGLE] - dtarget) - dp->hip.kd * at->leg.angle_rate -
           p->hip.kd * at->dleg.angle_rate;
}

static double change_of_torque(const point *at) {
    const bool clamped = at->mode->phase == TDMF_PHASE_RETRACT && at->mode->clamp_closed;
    const bool drives = at->mode->mid_stance_pending;
    switch (at->mode->contact) {
    case TDMF_CONTACT_GRAZE:
        return change_of_graze_torque(at);
    case TDMF_CONTACT_FLIGHT:
        return at->dinputs->hip.external_torque + (clamped ? 0.0 : change_of_flight_law(at));
    default:
        return at->dinputs->hip.external_torque - (drives ? at->dparameters->hip.stance_torque : 0.0);
    }
}

static tdmf_ground_force change_of_force(const point *at) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg *dleg = &at->dleg;
    tdmf_ground_force dforce = {0.0, 0.0};
    if (!tdmf_in_contact(at->mode)) {
        return dforce;
    }
    dforce.fy = dleg->axial_force * leg->cosine + leg->axial_force * dleg->cosine - at->dacross * leg->sine -
                at->across * dleg->sine + change_of_foot_weight(at);
    if (at->mode->contact == TDMF_CONTACT_STICK) {
        dforce.fx = -dleg->axial_force * leg->sine - leg->axial_force * dleg->sine -
                    at->dacross * leg->cosine - at->across * dleg->cosine;
    } else {
        dforce.fx = -tdmf_slip_sign(at->mode) *
                    (at->dinputs->ground.friction * at->force.fy + at->inputs->ground.friction * dforce.fy);
    }
    return dforce;
}

static tdmf_point change_of_foot_acceleration(const point *at, tdmf_point *acceleration) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg *dleg = &at->dleg;
    const double inverse_mass = at->model->inverse_foot_mass;
    const double dinverse_mass = -inverse_mass * inverse_mass * at->dparameters->foot.mass;
    tdmf_point change = {0.0, 0.0, 0.0, 0.0};
    memset(acceleration, 0, sizeof *acceleration);
    if (at->mode->contact != TDMF_CONTACT_STICK) {
        const double force = at->force.fx + leg->axial_force * leg->sine + at->across * leg->cosine;
        const double dforce = at->dforce.fx + dleg->axial_force * leg->sine + leg->axial_force * dleg->sine +
                              at->dacross * leg->cosine + at->across * dleg->cosine;
        acceleration->vx = inverse_mass * force;
        change.vx = inverse_mass * dforce + dinverse_mass * force;
    }
    if (at->mode->contact == TDMF_CONTACT_FLIGHT) {
        const double force = -leg->axial_force * leg->cosine + at->across * leg->sine;
        const double dforce = -dleg->axial_force * leg->cosine - leg->axial_force * dleg->cosine +
                              at->dacross * leg->sine + at->across * dleg->sine;
        acceleration->vy = inverse_mass * force - at->model->parameters.gravity;
        change.vy = inverse_mass * dforce + dinverse_mass * force - at->dparameters->gravity;
    }
    return change;
}

static void change_of_leg_acceleration(const point *at, double derivatives[TDMF_STATE_COUNT]) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg *dleg = &at->dleg;
    const double g = at->model->parameters.gravity;
    const double dg = at->dparameters->gravity;
    const double inverse_mass = at->model->inverse_body_mass;
    const double dinverse_mass = -inverse_mass * inverse_mass * at->dparameters->body.mass;
    tdmf_point foot;
    const tdmf_point dfoot = change_of_foot_acceleration(at, &foot);
    const double turn = at->across * inverse_mass + g * leg->sine + foot.vx * leg->cosine +
                        foot.vy * leg->sine - 2.0 * leg->length_rate * leg->angle_rate;
    const double dturn = at->dacross * inverse_mass + at->across * dinverse_mass + dg * leg->sine +
                         g * dleg->sine + dfoot.vx * leg->cosine + foot.vx * dleg->cosine +
                         dfoot.vy * leg->sine + foot.vy * dleg->sine -
                         2.0 * (dleg->length_rate * leg->angle_rate + leg->length_rate * dleg->angle_rate);
    derivatives[TDMF_FOOT_VX] = dfoot.vx;
    derivatives[TDMF_FOOT_VY] = dfoot.vy;
    derivatives[TDMF_LEG_LENGTH_RATE] =
        dleg->length * leg->angle_rate * leg->angle_rate +
        2.0 * leg->length * leg->angle_rate * dleg->angle_rate + dleg->axial_force * inverse_mass +
        leg->axial_force * dinverse_mass - dg * leg->cosine - g * dleg->cosine + dfoot.vx * leg->sine +
        foot.vx * dleg->sine - dfoot.vy * leg->cosine - foot.vy * dleg->cosine;
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
        at->dparameters->leg.damping * at->leg.length_rate * at->leg.length_rate +
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
    const double *state = at->state;
    const double *dstate = at->dstate;
    const tdmf_point body = tdmf_body(state);
    const double total = at->model->total_mass;
    const double share = at->model->parameters.body.mass / total;
    const double dshare = (at->dparameters->body.mass * at->model->parameters.foot.mass -
                           at->model->parameters.body.mass * at->dparameters->foot.mass) /
                          (total * total);
    const tdmf_point dcom = {
        .x = dstate[TDMF_FOOT_X] + share * (dbody.x - dstate[TDMF_FOOT_X]) +
             dshare * (body.x - state[TDMF_FOOT_X]),
        .y = dstate[TDMF_FOOT_Y] + share * (dbody.y - dstate[TDMF_FOOT_Y]) +
             dshare * (body.y - state[TDMF_FOOT_Y]),
        .vx = dstate[TDMF_FOOT_VX] + share * (dbody.vx - dstate[TDMF_FOOT_VX]) +
              dshare * (body.vx - state[TDMF_FOOT_VX]),
        .vy = dstate[TDMF_FOOT_VY] + share * (dbody.vy - dstate[TDMF_FOOT_VY]) +
              dshare * (body.vy - state[TDMF_FOOT_VY]),
    };
    return dcom;
}

static tdmf_energy change_of_energy(const point *at, tdmf_point dbody) {
    const tdmf_parameters *p = &at->model->parameters;
    const tdmf_parameters *dp = at->dparameters;
    const tdmf_point body = tdmf_body(at->state);
    const double y = at->state[TDMF_FOOT_Y];
    const double vx = at->state[TDMF_FOOT_VX];
    const double vy = at->state[TDMF_FOOT_VY];
    const double compression = p->leg.free_length - at->leg.length;
    tdmf_energy denergy = {
        .kinetic = 0.5 * dp->body.mass * (body.vx * body.vx + body.vy * body.vy) +
                   p->body.mass * (body.vx * dbody.vx + body.vy * dbody.vy) +
                   0.5 * dp->foot.mass * (vx * vx + vy * vy) +
                   p->foot.mass * (vx * at->dstate[TDMF_FOOT_VX] + vy * at->dstate[TDMF_FOOT_VY]),
        .potential = dp->gravity * (p->body.mass * body.y + p->foot.mass * y) +
                     p->gravity * (dp->body.mass * body.y + p->body.mass * dbody.y + dp->foot.mass * y +
                                   p->foot.mass * at->dstate[TDMF_FOOT_Y]),
        .elastic = 0.5 * dp->leg.stiffness * compression * compression +
                   p->leg.stiffness * compression * (dp->leg.free_length - at->dleg.length),
    };
    denergy.total = denergy.kinetic + denergy.potential + denergy.elastic;
    return denergy;
}

tdmf_tangent tdmf_tangent_along(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                                const double state[TDMF_STATE_COUNT], const tdmf_change *change,
                                const tdmf_variation *variation) {
    static const tdmf_change nothing_given = {0};
    static const tdmf_variation nothing_varied = {0};
    change = change != NULL ? change : &nothing_given;
    variation = variation != NULL ? variation : &nothing_varied;
    point at = {.model = model,
                .inputs = inputs,
                .mode = mode,
                .dparameters = &change->parameters,
                .dinputs = &change->inputs,
                .state = state,
                .dstate = variation->state,
                .dliftoff_angle = variation->liftoff_angle};
    at.leg = tdmf_leg_of(model, state);
    at.dleg = change_of_leg(model, &at.leg, &change->parameters, variation->state);
    at.torque = tdmf_leg_hip_torque(model, inputs, mode, state, &at.leg);
    at.dtorque = change_of_torque(&at);
    at.across = at.torque * at.leg.inverse_length;
    at.dacross = at.dtorque * at.leg.inverse_length + at.torque * at.dleg.inverse_length;
    at.force = tdmf_leg_contact_force(model, inputs, mode, at.torque, &at.leg);
    at.dforce = change_of_force(&at);

    tdmf_tangent tangent;
    change_of_derivatives(&at, tangent.derivatives);
    tangent.body = change_of_body(&at);
    tangent.com = change_of_center_of_mass(&at, tangent.body);
    tangent.contact = at.dforce;
    tangent.torque = at.dtorque;
    tangent.energy = change_of_energy(&at, tangent.body);
    return tangent;
}
