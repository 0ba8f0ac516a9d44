/* The equations of motion (8)-(9), solved for the accelerations by writing Newton's law for each point mass.
 * With u = (-sin, cos), t = (-cos, -sin) and the ground force (f_x, f_y) of the mode:
 *
 *     foot:  m_f ax = f_x + F_s sin + (tau/r) cos        m_f ay = f_y - F_s cos + (tau/r) sin - m_f g
 *     body:  u.a_body = F_s/m + u.a                      t.a_body = tau/(m r) + t.a
 *     leg:   rddot = r thetadot^2 + u.(a_body - a_foot)
 *            r thetaddot = t.(a_body - a_foot) - 2 rdot thetadot
 *
 * with a = (0, -g) + (external force)/m.
 *
 * A foot on the ground is accelerated along it alone, and one that sticks not at all, exactly and not by
 * cancellation. In a
 * variation d_ stands for the change of what follows. */
#include "dynamics.h"

#include "free_fall.h"
#include "ground_force.h"
#include "ground_line.h"
#include "hip_law.h"
#include "input_rates.h"
#include "kinematics.h"

#include <string.h>

typedef struct {
    double x, y;
} force_on_foot;

static force_on_foot push_foot(const tdmf_evaluation *at) {
    const tdmf_leg *leg = &at->leg;
    const double across = at->torque * leg->inverse_length;
    const force_on_foot force = {
        .x = leg->axial_force * leg->sine + across * leg->cosine,
        .y = -leg->axial_force * leg->cosine + across * leg->sine,
    };
    return force;
}

static force_on_foot vary_push_on_foot(const tdmf_evaluation *at, const tdmf_evaluation *d) {
    const tdmf_leg *leg = &at->leg, *d_leg = &d->leg;
    const double across = at->torque * leg->inverse_length;
    const double d_across = d->torque * leg->inverse_length + at->torque * d_leg->inverse_length;
    const force_on_foot d_force = {
        .x = d_leg->axial_force * leg->sine + leg->axial_force * d_leg->sine + d_across * leg->cosine +
             across * d_leg->cosine,
        .y = -d_leg->axial_force * leg->cosine - leg->axial_force * d_leg->cosine + d_across * leg->sine +
             across * d_leg->sine,
    };
    return d_force;
}

/* What leg and weight push the foot with along the ground. */
static double push_along(const tdmf_evaluation *at) {
    const tdmf_leg *leg = &at->leg;
    const double across = at->torque * leg->inverse_length;
    return leg->axial_force * leg->ground_sine + across * leg->ground_cosine -
           tdmf_foot_weight(at->model) * at->mode->ground.sine;
}

static double vary_push_along(const tdmf_evaluation *at, const tdmf_evaluation *d) {
    const tdmf_leg *leg = &at->leg, *d_leg = &d->leg;
    const tdmf_ground_line *line = &at->mode->ground;
    const double across = at->torque * leg->inverse_length;
    const double d_across = d->torque * leg->inverse_length + at->torque * d_leg->inverse_length;
    return d_leg->axial_force * leg->ground_sine + leg->axial_force * d_leg->ground_sine +
           d_across * leg->ground_cosine + across * d_leg->ground_cosine -
           tdmf_vary_foot_weight(at->model, d->model) * line->sine -
           tdmf_foot_weight(at->model) * line->cosine * d->mode->ground.slope;
}

/* Along the ground, of a foot that slips or grazes. */
static double acceleration_along(const tdmf_evaluation *at) {
    return (at->force.tangential + push_along(at)) * at->model->inverse_foot_mass;
}

static void accelerate_foot(const tdmf_evaluation *at, tdmf_acceleration *a) {
    a->foot_ax = a->foot_ay = 0.0;
    if (at->mode->contact == TDMF_CONTACT_FLIGHT) {
        const force_on_foot push = push_foot(at);
        a->foot_ax = push.x * at->model->inverse_foot_mass;
        a->foot_ay = push.y * at->model->inverse_foot_mass - at->model->parameters.gravity;
    } else if (at->mode->contact != TDMF_CONTACT_STICK) {
        const double along = acceleration_along(at);
        a->foot_ax = along * at->mode->ground.cosine;
        a->foot_ay = along * at->mode->ground.sine;
    }
}

static void vary_acceleration_along(const tdmf_evaluation *at, const tdmf_evaluation *d,
                                    tdmf_acceleration *d_a) {
    const tdmf_ground_line *line = &at->mode->ground;
    const double along = acceleration_along(at);
    const double turned = along * d->mode->ground.slope;
    const double d_along = (d->force.tangential + vary_push_along(at, d)) * at->model->inverse_foot_mass +
                           (at->force.tangential + push_along(at)) * d->model->inverse_foot_mass;
    d_a->foot_ax = d_along * line->cosine - turned * line->sine;
    d_a->foot_ay = d_along * line->sine + turned * line->cosine;
}

static void vary_foot_acceleration(const tdmf_evaluation *at, const tdmf_evaluation *d,
                                   tdmf_acceleration *d_a) {
    d_a->foot_ax = d_a->foot_ay = 0.0;
    if (at->mode->contact == TDMF_CONTACT_FLIGHT) {
        const force_on_foot push = push_foot(at);
        const force_on_foot d_push = vary_push_on_foot(at, d);
        d_a->foot_ax = d_push.x * at->model->inverse_foot_mass + push.x * d->model->inverse_foot_mass;
        d_a->foot_ay = d_push.y * at->model->inverse_foot_mass + push.y * d->model->inverse_foot_mass -
                       d->model->parameters.gravity;
    } else if (at->mode->contact != TDMF_CONTACT_STICK) {
        vary_acceleration_along(at, d, d_a);
    }
}

static tdmf_fall fall_of_body(const tdmf_evaluation *at) {
    return tdmf_fall_of_body(at->model, tdmf_push_on_body(at->model, at->inputs));
}

static tdmf_fall vary_fall_of_body(const tdmf_evaluation *at, const tdmf_evaluation *d) {
    return tdmf_fall_of_body(d->model, tdmf_vary_push_on_body(at->model, at->inputs, d->model, d->inputs));
}

/* t.(a_body - a_foot) - 2 rdot thetadot */
static double turning(const tdmf_evaluation *at, const tdmf_acceleration *a) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_fall fall = fall_of_body(at);
    return at->torque * leg->inverse_length * at->model->inverse_body_mass -
           (fall.x * leg->cosine + fall.y * leg->sine) + a->foot_ax * leg->cosine + a->foot_ay * leg->sine -
           2.0 * leg->length_rate * leg->angle_rate;
}

static inline tdmf_acceleration accelerate(const tdmf_evaluation *at) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_fall fall = fall_of_body(at);
    tdmf_acceleration a;
    accelerate_foot(at, &a);
    a.length = leg->length * leg->angle_rate * leg->angle_rate +
               leg->axial_force * at->model->inverse_body_mass + (fall.y * leg->cosine - fall.x * leg->sine) +
               a.foot_ax * leg->sine - a.foot_ay * leg->cosine;
    a.angle = turning(at, &a) * leg->inverse_length;
    return a;
}

tdmf_acceleration tdmf_accelerate(const tdmf_evaluation *at) {
    return accelerate(at);
}

static tdmf_acceleration vary_acceleration(const tdmf_evaluation *at, const tdmf_evaluation *d) {
    const tdmf_leg *leg = &at->leg, *d_leg = &d->leg;
    const tdmf_model *model = at->model, *d_model = d->model;
    const tdmf_fall fall = fall_of_body(at), d_fall = vary_fall_of_body(at, d);
    tdmf_acceleration a, d_a;
    accelerate_foot(at, &a);
    vary_foot_acceleration(at, d, &d_a);
    d_a.length = d_leg->length * leg->angle_rate * leg->angle_rate +
                 2.0 * leg->length * leg->angle_rate * d_leg->angle_rate +
                 d_leg->axial_force * model->inverse_body_mass +
                 leg->axial_force * d_model->inverse_body_mass + d_fall.y * leg->cosine +
                 fall.y * d_leg->cosine - d_fall.x * leg->sine - fall.x * d_leg->sine +
                 d_a.foot_ax * leg->sine + a.foot_ax * d_leg->sine - d_a.foot_ay * leg->cosine -
                 a.foot_ay * d_leg->cosine;
    const double d_across = d->torque * leg->inverse_length + at->torque * d_leg->inverse_length;
    const double d_turning =
        d_across * model->inverse_body_mass + at->torque * leg->inverse_length * d_model->inverse_body_mass -
        d_fall.x * leg->cosine - fall.x * d_leg->cosine - d_fall.y * leg->sine - fall.y * d_leg->sine +
        d_a.foot_ax * leg->cosine + a.foot_ax * d_leg->cosine + d_a.foot_ay * leg->sine +
        a.foot_ay * d_leg->sine -
        2.0 * (d_leg->length_rate * leg->angle_rate + leg->length_rate * d_leg->angle_rate);
    d_a.angle = d_turning * leg->inverse_length + turning(at, &a) * d_leg->inverse_length;
    return d_a;
}

/* ---- the power of the external force ------------------------------------------------------------------ */

static double power_of(const tdmf_inputs *inputs, tdmf_point body) {
    return inputs->body.external_fx * body.vx + inputs->body.external_fy * body.vy;
}

static double external_power(const tdmf_evaluation *at) {
    const tdmf_leg_direction direction = {at->leg.sine, at->leg.cosine};
    return tdmf_is_pushed(at->inputs) ? power_of(at->inputs, tdmf_body_along(at->state, direction)) : 0.0;
}

static double vary_external_power(const tdmf_evaluation *at, const tdmf_evaluation *d) {
    const tdmf_leg_direction direction = {at->leg.sine, at->leg.cosine};
    return power_of(d->inputs, tdmf_body_along(at->state, direction)) +
           power_of(at->inputs, tdmf_vary_body(at->state, direction, d->state));
}

/* ---- the right-hand side ------------------------------------------------------------------------------ */

/* Of positions and velocities: the same for values and variations. */
static void rates_of_motion(const tdmf_evaluation *at, const tdmf_acceleration *a,
                            double derivatives[TDMF_STATE_COUNT]) {
    derivatives[TDMF_FOOT_X] = at->state[TDMF_FOOT_VX];
    derivatives[TDMF_FOOT_Y] = at->state[TDMF_FOOT_VY];
    derivatives[TDMF_LEG_LENGTH] = at->leg.length_rate;
    derivatives[TDMF_LEG_ANGLE] = at->leg.angle_rate;
    derivatives[TDMF_FOOT_VX] = a->foot_ax;
    derivatives[TDMF_FOOT_VY] = a->foot_ay;
    derivatives[TDMF_LEG_LENGTH_RATE] = a->length;
    derivatives[TDMF_LEG_ANGLE_RATE] = a->angle;
}

static double slip_velocity(const tdmf_evaluation *at) {
    return tdmf_velocity_along(&at->mode->ground, at->state[TDMF_FOOT_VX], at->state[TDMF_FOOT_VY]);
}

static double vary_slip_velocity(const tdmf_evaluation *at, const tdmf_evaluation *d) {
    return tdmf_vary_velocity_along(&at->mode->ground, at->state[TDMF_FOOT_VX], at->state[TDMF_FOOT_VY],
                                    &d->mode->ground, d->state[TDMF_FOOT_VX], d->state[TDMF_FOOT_VY]);
}

static void rates_of_state(const tdmf_evaluation *at, double derivatives[TDMF_STATE_COUNT]) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_acceleration a = accelerate(at);
    const double power = at->torque * leg->angle_rate;
    rates_of_motion(at, &a, derivatives);
    derivatives[TDMF_HIP_WORK] = power;
    derivatives[TDMF_HIP_PLACE_TIME] = tdmf_place_time_rate(at->mode);
    derivatives[TDMF_LEG_WORK] = 0.0; /* with the inputs held */
    derivatives[TDMF_ENERGY_EXTERNAL_WORK] = external_power(at);
    derivatives[TDMF_ENERGY_DAMPER_LOSS] =
        at->model->parameters.leg.damping * leg->length_rate * leg->length_rate;
    derivatives[TDMF_ENERGY_FRICTION_LOSS] = -at->force.tangential * slip_velocity(at);
    derivatives[TDMF_HIP_POSITIVE_WORK] = power > 0.0 ? power : 0.0;
}

void tdmf_vary_rates_of_state(const tdmf_evaluation *at, const tdmf_evaluation *d,
                              double derivatives[TDMF_STATE_COUNT]) {
    const tdmf_leg *leg = &at->leg, *d_leg = &d->leg;
    const tdmf_acceleration d_a = vary_acceleration(at, d);
    const double d_power = d->torque * leg->angle_rate + at->torque * d_leg->angle_rate;
    rates_of_motion(d, &d_a, derivatives);
    derivatives[TDMF_HIP_WORK] = d_power;
    derivatives[TDMF_HIP_PLACE_TIME] = 0.0;
    derivatives[TDMF_LEG_WORK] = 0.0;
    derivatives[TDMF_ENERGY_EXTERNAL_WORK] = vary_external_power(at, d);
    derivatives[TDMF_ENERGY_DAMPER_LOSS] =
        d->model->parameters.leg.damping * leg->length_rate * leg->length_rate +
        2.0 * at->model->parameters.leg.damping * leg->length_rate * d_leg->length_rate;
    derivatives[TDMF_ENERGY_FRICTION_LOSS] =
        -d->force.tangential * slip_velocity(at) - at->force.tangential * vary_slip_velocity(at, d);
    derivatives[TDMF_HIP_POSITIVE_WORK] = at->torque * leg->angle_rate > 0.0 ? d_power : 0.0;
}

void tdmf_derivatives(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                      const double state[TDMF_STATE_COUNT], double derivatives[TDMF_STATE_COUNT]) {
    if (mode->fallen) {
        memset(derivatives, 0, TDMF_STATE_COUNT * sizeof *derivatives);
        return;
    }
    double rates[TDMF_STATE_COUNT];
    const tdmf_evaluation at = tdmf_evaluate(model, inputs, mode, state);
    rates_of_state(&at, rates);
    memcpy(derivatives, rates, sizeof rates);
}

double tdmf_normal_force_rate(const tdmf_evaluation *at) {
    static const tdmf_model unchanged = {0};
    static const tdmf_hip_law still = {0};
    static const tdmf_mode held = {0};
    const tdmf_acceleration a = accelerate(at);
    const double rates[TDMF_STATE_COUNT] = {[TDMF_LEG_LENGTH] = at->leg.length_rate,
                                            [TDMF_LEG_ANGLE] = at->leg.angle_rate,
                                            [TDMF_LEG_LENGTH_RATE] = a.length,
                                            [TDMF_LEG_ANGLE_RATE] = a.angle};
    const tdmf_hip_law law = tdmf_stance_law(at->model, at->inputs, &tdmf_held_inputs, at->mode);
    const double torque_rate = tdmf_vary_law_torque(&law, &still, at->state, rates);
    const tdmf_evaluation d = {.model = &unchanged,
                               .mode = &held,
                               .leg =
                                   tdmf_vary_leg(at->model, &at->leg, &unchanged, 0.0, &held.ground, rates)};
    return tdmf_vary_force_under(at, &d, at->torque, torque_rate).normal;
}

double tdmf_ground_force_rate(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                              const double state[TDMF_STATE_COUNT]) {
    const tdmf_evaluation at = tdmf_evaluate(model, inputs, mode, state);
    return tdmf_normal_force_rate(&at);
}
