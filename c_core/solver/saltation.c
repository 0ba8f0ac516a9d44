/* With the guard g, the reset R, the right-hand sides f- and f+, and d_ for the variation of what follows, an
 * event shifts by dt and takes the variation over:
 *
 *     dt = -(g_x d_x + g_p d_p)/(g_x f-),      d_x+ = R_x (d_x + f- dt) + R_p d_p - f+ dt.
 *
 * Transitions that follow in zero time are decided by inequalities and shift with the first one; of all of
 * them, only the impact moves the state. */
#include "saltation.h"

#include "tdmf_slip/contact.h"
#include "tdmf_slip/hip.h"

#include <math.h>
#include <string.h>

/* A runner, and a direction in all that a guard depends on. */
typedef struct {
    const tdmf_model *model;
    const tdmf_inputs *inputs;
    const tdmf_side *side;
    const double *d_state;
    const tdmf_change *change;
    double d_liftoff_angle;
} direction;

static double vary_touchdown(const direction *d) {
    return d->d_state[TDMF_FOOT_Y];
}

/* Vertical velocity of the centre of mass. */
static double vary_rise(const direction *d) {
    const double *x = d->side->state;
    const double body = d->model->parameters.body.mass;
    const double foot = d->model->parameters.foot.mass;
    const double total = d->model->total_mass;
    const double share = body / total;
    const double d_share =
        (d->change->parameters.body.mass * foot - body * d->change->parameters.foot.mass) / (total * total);
    const double sine = sin(x[TDMF_LEG_ANGLE]);
    const double cosine = cos(x[TDMF_LEG_ANGLE]);
    const double r = x[TDMF_LEG_LENGTH];
    const double angle_rate = x[TDMF_LEG_ANGLE_RATE];
    const double rise = x[TDMF_LEG_LENGTH_RATE] * cosine - r * angle_rate * sine;
    const double d_rise =
        d->d_state[TDMF_LEG_LENGTH_RATE] * cosine -
        (d->d_state[TDMF_LEG_LENGTH] * angle_rate + r * d->d_state[TDMF_LEG_ANGLE_RATE]) * sine -
        (x[TDMF_LEG_LENGTH_RATE] * sine + r * angle_rate * cosine) * d->d_state[TDMF_LEG_ANGLE];
    return d->d_state[TDMF_FOOT_VY] + share * d_rise + d_share * rise;
}

/* -kp (theta - target) - kd thetadot */
static double vary_servo(const direction *d) {
    const tdmf_parameters *p = &d->model->parameters;
    const tdmf_parameters *d_p = &d->change->parameters;
    const tdmf_mode *mode = &d->side->mode;
    const bool retracts = mode->phase == TDMF_PHASE_RETRACT;
    const double target =
        retracts ? p->hip.liftoff_angle_factor * mode->liftoff_angle : p->hip.touchdown_angle;
    const double d_target = retracts ? d_p->hip.liftoff_angle_factor * mode->liftoff_angle +
                                           p->hip.liftoff_angle_factor * d->d_liftoff_angle
                                     : d_p->hip.touchdown_angle;
    const double *x = d->side->state;
    return -d_p->hip.kp * (x[TDMF_LEG_ANGLE] - target) - p->hip.kp * (d->d_state[TDMF_LEG_ANGLE] - d_target) -
           d_p->hip.kd * x[TDMF_LEG_ANGLE_RATE] - p->hip.kd * d->d_state[TDMF_LEG_ANGLE_RATE];
}

/* Ground force on a foot that stays in place under a torque. */
static tdmf_ground_force vary_force(const direction *d, double torque, double d_torque) {
    const tdmf_parameters *p = &d->model->parameters;
    const tdmf_parameters *d_p = &d->change->parameters;
    const double *x = d->side->state;
    const double sine = sin(x[TDMF_LEG_ANGLE]);
    const double cosine = cos(x[TDMF_LEG_ANGLE]);
    const double r = x[TDMF_LEG_LENGTH];
    const double d_angle = d->d_state[TDMF_LEG_ANGLE];
    const double axial =
        p->leg.stiffness * (p->leg.free_length - r) - p->leg.damping * x[TDMF_LEG_LENGTH_RATE];
    const double d_axial = d_p->leg.stiffness * (p->leg.free_length - r) +
                           p->leg.stiffness * (d_p->leg.free_length - d->d_state[TDMF_LEG_LENGTH]) -
                           d_p->leg.damping * x[TDMF_LEG_LENGTH_RATE] -
                           p->leg.damping * d->d_state[TDMF_LEG_LENGTH_RATE];
    const double across = torque / r;
    const double d_across = (d_torque - across * d->d_state[TDMF_LEG_LENGTH]) / r;
    const tdmf_ground_force varied = {
        .fx = -d_axial * sine - d_across * cosine - (axial * cosine - across * sine) * d_angle,
        .fy = d_axial * cosine - d_across * sine - (axial * sine + across * cosine) * d_angle +
              d_p->foot.mass * p->gravity + p->foot.mass * d_p->gravity,
    };
    return varied;
}

static tdmf_ground_force vary_stance_force(const direction *d) {
    const tdmf_mode *mode = &d->side->mode;
    const double law = tdmf_hip_stance_law(d->model, mode);
    const double d_law = mode->mid_stance_pending ? -d->change->parameters.hip.stance_torque : 0.0;
    return vary_force(d, law + d->inputs->hip.external_torque, d_law + d->change->inputs.hip.external_torque);
}

/* In retract the law is max{servo, 0}, which has no derivative where the servo is 0 and does not stay so. */
static double vary_flight_law(const direction *d) {
    const tdmf_mode *mode = &d->side->mode;
    const double d_servo = vary_servo(d);
    if (mode->phase == TDMF_PHASE_PLACE) {
        return d_servo;
    }
    const double servo = tdmf_hip_retract_argument(d->model, mode, d->side->state);
    if (servo == 0.0) {
        return d_servo == 0.0 ? 0.0 : NAN;
    }
    return servo > 0.0 ? d_servo : 0.0;
}

static double vary_flight_press(const direction *d) {
    const double law = tdmf_hip_flight_law(d->model, &d->side->mode, d->side->state);
    const double d_law = vary_flight_law(d);
    return vary_force(d, law + d->inputs->hip.external_torque, d_law + d->change->inputs.hip.external_torque)
        .fy;
}

/* mu f_y + sign f_x */
static double vary_cone(const direction *d, double sign) {
    const double torque = tdmf_hip_stance_law(d->model, &d->side->mode) + d->inputs->hip.external_torque;
    const tdmf_ground_force force = tdmf_sticking_force(d->model, torque, d->side->state);
    const tdmf_ground_force d_force = vary_stance_force(d);
    return d->change->inputs.ground.friction * force.fy + d->inputs->ground.friction * d_force.fy +
           sign * d_force.fx;
}

/* Up to its scale, which neither moves a root nor, at a root, changes a ratio of variations. */
static double vary_guard(const direction *d, tdmf_guard guard) {
    switch (guard) {
    case TDMF_GUARD_TOUCHDOWN:
        return vary_touchdown(d);
    case TDMF_GUARD_APEX:
        return vary_rise(d);
    case TDMF_GUARD_CLAMP:
        return vary_servo(d);
    case TDMF_GUARD_LIFT_OFF:
        return vary_stance_force(d).fy;
    case TDMF_GUARD_SLIP_ONSET_POSITIVE:
        return vary_cone(d, 1.0);
    case TDMF_GUARD_SLIP_ONSET_NEGATIVE:
        return vary_cone(d, -1.0);
    case TDMF_GUARD_SLIP_VELOCITY_ZERO:
        return d->d_state[TDMF_FOOT_VX];
    case TDMF_GUARD_MID_STANCE:
        return d->d_state[TDMF_LEG_ANGLE];
    case TDMF_GUARD_GRAZE_TO_CONTACT:
        return vary_stance_force(d).fy;
    case TDMF_GUARD_GRAZE_TO_FLIGHT:
        return vary_flight_press(d);
    default:
        return NAN; /* a fall */
    }
}

/* The impact map differentiated: `d_state` is that of the state before. */
static void vary_impact(const tdmf_inputs *inputs, const double before[TDMF_STATE_COUNT],
                        const double after[TDMF_STATE_COUNT], const tdmf_change *change,
                        double d_state[TDMF_STATE_COUNT]) {
    const double *x = before;
    const double sine = sin(x[TDMF_LEG_ANGLE]);
    const double cosine = cos(x[TDMF_LEG_ANGLE]);
    const double r = x[TDMF_LEG_LENGTH];
    const double d_r = d_state[TDMF_LEG_LENGTH];
    const double d_angle = d_state[TDMF_LEG_ANGLE];
    const double along = x[TDMF_LEG_LENGTH_RATE];
    const double across = r * x[TDMF_LEG_ANGLE_RATE];
    const double d_along = d_state[TDMF_LEG_LENGTH_RATE];
    const double d_across = d_r * x[TDMF_LEG_ANGLE_RATE] + r * d_state[TDMF_LEG_ANGLE_RATE];
    const double vx = x[TDMF_FOOT_VX];
    const double vy = x[TDMF_FOOT_VY];
    const double friction = inputs->ground.friction;
    const double d_body_vx = d_state[TDMF_FOOT_VX] - d_along * sine - d_across * cosine -
                             (along * cosine - across * sine) * d_angle;
    const double d_body_vy = d_state[TDMF_FOOT_VY] + d_along * cosine - d_across * sine -
                             (along * sine + across * cosine) * d_angle;
    double d_vx = 0.0;
    if (fabs(vx) > friction * fabs(vy)) {
        const double d_change =
            change->inputs.ground.friction * fabs(vy) + friction * copysign(1.0, vy) * d_state[TDMF_FOOT_VY];
        d_vx = d_state[TDMF_FOOT_VX] - copysign(1.0, vx) * d_change;
    }
    const double d_relative_vx = d_body_vx - d_vx;
    const double along_after = after[TDMF_LEG_LENGTH_RATE];
    const double angle_rate_after = after[TDMF_LEG_ANGLE_RATE];
    d_state[TDMF_FOOT_Y] = 0.0;
    d_state[TDMF_FOOT_VX] = d_vx;
    d_state[TDMF_FOOT_VY] = 0.0;
    d_state[TDMF_LEG_LENGTH_RATE] =
        -d_relative_vx * sine + d_body_vy * cosine + r * angle_rate_after * d_angle;
    d_state[TDMF_LEG_ANGLE_RATE] =
        (-d_relative_vx * cosine - d_body_vy * sine - along_after * d_angle - angle_rate_after * d_r) / r;
}

/* A foot on the ground stays there, one that sticks stands: exactly, not by cancellation. */
static void keep_on_ground(const tdmf_mode *mode, double d_state[TDMF_STATE_COUNT]) {
    if (mode->contact == TDMF_CONTACT_FLIGHT) {
        return;
    }
    d_state[TDMF_FOOT_Y] = 0.0;
    d_state[TDMF_FOOT_VY] = 0.0;
    if (mode->contact == TDMF_CONTACT_STICK) {
        d_state[TDMF_FOOT_VX] = 0.0;
    }
}

/* Where a neighbour's events differ in kind, no derivative tells what becomes of it: the foot met the ground
 * at another event's time, or without meeting it; or it stands where no friction holds it. */
static bool is_on_edge(const tdmf_inputs *inputs, bool impact, const tdmf_side *before,
                       const tdmf_side *after) {
    const bool flew = before->mode.contact == TDMF_CONTACT_FLIGHT;
    const bool landed = flew && after->state[TDMF_FOOT_VY] != before->state[TDMF_FOOT_VY];
    const bool stands = after->mode.contact == TDMF_CONTACT_STICK;
    return impact != landed || (stands && inputs->ground.friction == 0.0);
}

static tdmf_variation no_variation(void) {
    tdmf_variation none;
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        none.state[i] = NAN;
    }
    none.liftoff_angle = NAN;
    return none;
}

tdmf_variation tdmf_saltation(const tdmf_model *model, const tdmf_inputs *inputs, tdmf_guard guard,
                              const tdmf_side *before, const tdmf_side *after, const tdmf_change *change,
                              const tdmf_variation *variation) {
    static const tdmf_change none = {0};
    const bool impact = guard == TDMF_GUARD_TOUCHDOWN;
    if (is_on_edge(inputs, impact, before, after)) {
        return no_variation();
    }
    const direction along_variation = {
        model, inputs, before, variation->state, change, variation->liftoff_angle};
    const direction along_motion = {model, inputs, before, before->derivatives, &none, 0.0};
    const double shift = -vary_guard(&along_variation, guard) / vary_guard(&along_motion, guard);
    tdmf_variation varied = *variation;
    for (int i = 0; i <= TDMF_HIP_WORK; ++i) {
        varied.state[i] += before->derivatives[i] * shift;
    }
    if (impact) {
        vary_impact(inputs, before->state, after->state, change, varied.state);
    }
    if ((impact || tdmf_in_contact(&before->mode)) && !tdmf_in_contact(&after->mode)) {
        varied.liftoff_angle = varied.state[TDMF_LEG_ANGLE];
    }
    for (int i = 0; i <= TDMF_HIP_WORK; ++i) {
        varied.state[i] -= after->derivatives[i] * shift;
    }
    keep_on_ground(&after->mode, varied.state);
    return varied;
}

/* Of m_f (|v-|^2 - |v+|^2)/2. */
static double vary_impact_loss(const tdmf_model *model, const double before[TDMF_STATE_COUNT],
                               const double after[TDMF_STATE_COUNT], const tdmf_change *change,
                               const double d_before[TDMF_STATE_COUNT],
                               const double d_after[TDMF_STATE_COUNT]) {
    const double vx = before[TDMF_FOOT_VX];
    const double vy = before[TDMF_FOOT_VY];
    const double vx_after = after[TDMF_FOOT_VX];
    return 0.5 * change->parameters.foot.mass * ((vx - vx_after) * (vx + vx_after) + vy * vy) +
           model->parameters.foot.mass *
               (vx * d_before[TDMF_FOOT_VX] - vx_after * d_after[TDMF_FOOT_VX] + vy * d_before[TDMF_FOOT_VY]);
}

tdmf_start_variation tdmf_vary_start(const tdmf_model *model, const tdmf_inputs *inputs,
                                     const double given[TDMF_STATE_COUNT],
                                     const double started[TDMF_STATE_COUNT], const tdmf_change *change,
                                     const double state_direction[TDMF_STATE_COUNT]) {
    static const tdmf_change nothing_given = {0};
    tdmf_start_variation varied = {0};
    change = change != NULL ? change : &nothing_given;
    double *d_state = varied.variation.state;
    memcpy(d_state, state_direction, TDMF_MECHANICAL_COUNT * sizeof *d_state);
    varied.variation.liftoff_angle = d_state[TDMF_LEG_ANGLE];
    if (given[TDMF_FOOT_Y] == 0.0 && given[TDMF_FOOT_VY] < 0.0) {
        vary_impact(inputs, given, started, change, d_state);
        varied.impact_loss = vary_impact_loss(model, given, started, change, state_direction, d_state);
    }
    return varied;
}
