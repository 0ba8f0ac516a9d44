/* Variations of the maps in chart.c, and their way along a step. d_ stands for the variation of what follows.
 */
#include "carried.h"

#include <math.h>

/* Of the model's derived constants. */
typedef struct {
    double inverse_body_mass, inverse_foot_mass;
    double body_share; /* m/(m + m_f) */
} derived_change;

static derived_change change_of(const tdmf_model *model, const tdmf_change *change) {
    const double body = model->parameters.body.mass;
    const double foot = model->parameters.foot.mass;
    const double d_body = change->parameters.body.mass;
    const double d_foot = change->parameters.foot.mass;
    const derived_change derived = {
        .inverse_body_mass = -d_body * model->inverse_body_mass * model->inverse_body_mass,
        .inverse_foot_mass = -d_foot * model->inverse_foot_mass * model->inverse_foot_mass,
        .body_share = (d_body * foot - body * d_foot) / (model->total_mass * model->total_mass),
    };
    return derived;
}

/* ---- flight: the foot stands off the centre of mass by the body's share of the leg ----------------------
 */

typedef struct {
    double x, y, vx, vy;
} offset;

static offset vary_offset(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                          const tdmf_change *change, const tdmf_coordinates *d) {
    const double share = model->parameters.body.mass / model->total_mass;
    const double d_share = change_of(model, change).body_share;
    const double sine = sin(state[TDMF_LEG_ANGLE]);
    const double cosine = cos(state[TDMF_LEG_ANGLE]);
    const double r = state[TDMF_LEG_LENGTH];
    const double along = state[TDMF_LEG_LENGTH_RATE];
    const double across = r * state[TDMF_LEG_ANGLE_RATE];
    const double d_across = d->length * state[TDMF_LEG_ANGLE_RATE] + r * d->angle_rate;
    const double d_along = d->length_rate;
    const offset varied = {
        .x = d_share * r * sine + share * (d->length * sine + r * cosine * d->angle),
        .y = -d_share * r * cosine - share * (d->length * cosine - r * sine * d->angle),
        .vx = d_share * (along * sine + across * cosine) +
              share * (d_along * sine + d_across * cosine + (along * cosine - across * sine) * d->angle),
        .vy = d_share * (-along * cosine + across * sine) +
              share * (-d_along * cosine + d_across * sine + (along * sine + across * cosine) * d->angle),
    };
    return varied;
}

static void carry_flight(const tdmf_chart *chart, const double state[TDMF_STATE_COUNT],
                         const tdmf_change *change, const double d_state[TDMF_STATE_COUNT],
                         tdmf_carried *carried) {
    carried->at.length = d_state[TDMF_LEG_LENGTH];
    carried->at.angle = d_state[TDMF_LEG_ANGLE];
    carried->at.length_rate = d_state[TDMF_LEG_LENGTH_RATE];
    carried->at.angle_rate = d_state[TDMF_LEG_ANGLE_RATE];
    const offset foot = vary_offset(chart->model, state, change, &carried->at);
    carried->com_x = d_state[TDMF_FOOT_X] - foot.x;
    carried->com_y = d_state[TDMF_FOOT_Y] - foot.y;
    carried->com_vx = d_state[TDMF_FOOT_VX] - foot.vx;
    carried->com_vy = d_state[TDMF_FOOT_VY] - foot.vy;
}

static void flight_carried_to(const tdmf_chart *chart, const double state[TDMF_STATE_COUNT],
                              const tdmf_change *change, const tdmf_carried *carried,
                              double d_state[TDMF_STATE_COUNT]) {
    const offset foot = vary_offset(chart->model, state, change, &carried->at);
    d_state[TDMF_FOOT_X] = carried->com_x + foot.x;
    d_state[TDMF_FOOT_Y] = carried->com_y + foot.y;
    d_state[TDMF_FOOT_VX] = carried->com_vx + foot.vx;
    d_state[TDMF_FOOT_VY] = carried->com_vy + foot.vy;
    d_state[TDMF_LEG_LENGTH] = carried->at.length;
    d_state[TDMF_LEG_ANGLE] = carried->at.angle;
    d_state[TDMF_LEG_LENGTH_RATE] = carried->at.length_rate;
    d_state[TDMF_LEG_ANGLE_RATE] = carried->at.angle_rate;
}

/* Share of the servo in the varied torque. In retract that is max{servo, 0}, which gains that are both zero
 * have no derivative by. */
static double servo_share(const tdmf_parameters *p, const tdmf_parameters *d, const tdmf_mode *mode) {
    if (mode->phase != TDMF_PHASE_RETRACT) {
        return 1.0;
    }
    if (p->hip.kp == 0.0 && p->hip.kd == 0.0 && (d->hip.kp != 0.0 || d->hip.kd != 0.0)) {
        return NAN;
    }
    return mode->clamp_closed ? 0.0 : 1.0;
}

static flight_coefficients vary_flight_coefficients(const tdmf_chart *chart, const tdmf_mode *mode,
                                                    const tdmf_change *change, const tdmf_carried *carried) {
    const tdmf_model *model = chart->model;
    const tdmf_parameters *p = &model->parameters;
    const tdmf_parameters *d = &change->parameters;
    const derived_change derived = change_of(model, change);
    const double mobility = model->inverse_body_mass + model->inverse_foot_mass;
    const double d_mobility = derived.inverse_body_mass + derived.inverse_foot_mass;
    const bool retracts = mode->phase == TDMF_PHASE_RETRACT;
    const double servo = servo_share(p, d, mode);
    const flight_coefficients varied = {
        .mobility = d_mobility,
        .stiffness = d_mobility * p->leg.stiffness + mobility * d->leg.stiffness,
        .damping = d_mobility * p->leg.damping + mobility * d->leg.damping,
        .free_length = d->leg.free_length,
        .gain = servo * (d_mobility * p->hip.kp + mobility * d->hip.kp),
        .rate_gain = servo * (d_mobility * p->hip.kd + mobility * d->hip.kd),
        .target = retracts ? d->hip.liftoff_angle_factor * mode->liftoff_angle +
                                 p->hip.liftoff_angle_factor * carried->liftoff_angle
                           : d->hip.touchdown_angle,
        .torque = d_mobility * chart->torque + mobility * change->inputs.hip.external_torque,
    };
    return varied;
}

static void carry_flight_on(const tdmf_step *step, double t, const tdmf_change *change,
                            const flight_variation *tangent, tdmf_carried *carried) {
    const double d_gravity = change->parameters.gravity;
    carried->at.length = series_at(tangent->length, step->order, t);
    carried->at.length_rate = series_at(tangent->length_rate, step->order, t);
    carried->at.angle = series_at(tangent->angle, step->order, t);
    /* From the momentum r^2 w, which is known to one order more than w. */
    const double r = series_at(step->series.flight.length, step->order, t);
    const double momentum = series_at(step->series.flight.momentum, step->order, t);
    carried->at.angle_rate =
        (series_at(tangent->momentum, step->order, t) - 2.0 * momentum / r * carried->at.length) / (r * r);
    carried->at.work += series_integral(tangent->power, step->order - 1, t);
    carried->com_x += t * carried->com_vx;
    carried->com_y += t * (carried->com_vy - 0.5 * d_gravity * t);
    carried->com_vy -= t * d_gravity;
}

/* ---- on the ground --------------------------------------------------------------------------------------
 */

static void carry_ground(const double state[TDMF_STATE_COUNT], const double d_state[TDMF_STATE_COUNT],
                         tdmf_carried *carried) {
    tdmf_coordinates *d = &carried->at;
    const double sine = sin(state[TDMF_LEG_ANGLE]);
    const double cosine = cos(state[TDMF_LEG_ANGLE]);
    const double r = state[TDMF_LEG_LENGTH];
    const double along = state[TDMF_LEG_LENGTH_RATE];
    const double across = r * state[TDMF_LEG_ANGLE_RATE];
    const double d_r = d_state[TDMF_LEG_LENGTH];
    const double d_angle = d_state[TDMF_LEG_ANGLE];
    const double d_along = d_state[TDMF_LEG_LENGTH_RATE];
    const double d_across = d_r * state[TDMF_LEG_ANGLE_RATE] + r * d_state[TDMF_LEG_ANGLE_RATE];
    d->x = -d_r * sine - r * cosine * d_angle;
    d->y = d_r * cosine - r * sine * d_angle;
    d->foot_x = d_state[TDMF_FOOT_X];
    d->foot_vx = d_state[TDMF_FOOT_VX];
    d->vx = d->foot_vx - d_along * sine - d_across * cosine - (along * cosine - across * sine) * d_angle;
    d->vy = d_along * cosine - d_across * sine - (along * sine + across * cosine) * d_angle;
}

static void ground_carried_to(const double state[TDMF_STATE_COUNT], const tdmf_carried *carried,
                              double d_state[TDMF_STATE_COUNT]) {
    const tdmf_coordinates *d = &carried->at;
    const double r = state[TDMF_LEG_LENGTH];
    const double x = -r * sin(state[TDMF_LEG_ANGLE]);
    const double y = r * cos(state[TDMF_LEG_ANGLE]);
    const double along = state[TDMF_LEG_LENGTH_RATE];
    const double angle_rate = state[TDMF_LEG_ANGLE_RATE];
    const double vx = (along * x - r * angle_rate * y) / r;
    const double vy = (along * y + r * angle_rate * x) / r;
    const double d_vx = d->vx - d->foot_vx;
    const double d_r = (x * d->x + y * d->y) / r;
    d_state[TDMF_FOOT_X] = d->foot_x;
    d_state[TDMF_FOOT_Y] = 0.0;
    d_state[TDMF_FOOT_VX] = d->foot_vx;
    d_state[TDMF_FOOT_VY] = 0.0;
    d_state[TDMF_LEG_LENGTH] = d_r;
    d_state[TDMF_LEG_ANGLE] = (x * d->y - y * d->x) / (r * r);
    d_state[TDMF_LEG_LENGTH_RATE] = (d->x * vx + x * d_vx + d->y * vy + y * d->vy - along * d_r) / r;
    d_state[TDMF_LEG_ANGLE_RATE] =
        (d->x * vy + x * d->vy - d->y * vx - y * d_vx - 2.0 * r * angle_rate * d_r) / (r * r);
}

static ground_coefficients vary_ground_coefficients(const tdmf_chart *chart, const tdmf_mode *mode,
                                                    const tdmf_change *change) {
    const tdmf_parameters *p = &chart->model->parameters;
    const tdmf_parameters *d = &change->parameters;
    const derived_change derived = change_of(chart->model, change);
    const bool drives = tdmf_in_contact(mode) && mode->mid_stance_pending;
    const ground_coefficients varied = {
        .stiffness = d->leg.stiffness,
        .damping = d->leg.damping,
        .free_length = d->leg.free_length,
        .inverse_body_mass = derived.inverse_body_mass,
        .inverse_foot_mass = derived.inverse_foot_mass,
        .foot_weight = d->foot.mass * p->gravity + p->foot.mass * d->gravity,
        .gravity = d->gravity,
        .torque = change->inputs.hip.external_torque - (drives ? d->hip.stance_torque : 0.0),
        .friction = tdmf_slip_sign(mode) * change->inputs.ground.friction,
    };
    return varied;
}

static void carry_ground_on(const tdmf_step *step, double t, const ground_variation *tangent,
                            tdmf_carried *carried) {
    carried->at.x = series_at(tangent->x, step->order, t);
    carried->at.y = series_at(tangent->y, step->order, t);
    carried->at.foot_vx = series_at(tangent->foot_vx, step->order, t);
    carried->at.vx = series_at(tangent->vx, step->order, t) + carried->at.foot_vx;
    carried->at.vy = series_at(tangent->vy, step->order, t);
    carried->at.foot_x += series_integral(tangent->foot_vx, step->order, t);
    carried->at.work += series_integral(tangent->power, step->order - 1, t);
}

/* ---- both -----------------------------------------------------------------------------------------------
 */

tdmf_carried tdmf_carry(const tdmf_chart *chart, const double state[TDMF_STATE_COUNT],
                        const tdmf_change *change, const tdmf_variation *variation) {
    tdmf_carried carried = {.liftoff_angle = variation->liftoff_angle};
    carried.at.work = variation->state[TDMF_HIP_WORK];
    if (chart->contact == TDMF_CONTACT_FLIGHT) {
        carry_flight(chart, state, change, variation->state, &carried);
    } else {
        carry_ground(state, variation->state, &carried);
    }
    return carried;
}

/* Adds the sizes of a coordinate's coefficients. */
static void add_sizes(const double *c, double unit, int order, double sizes[SERIES_TERMS]) {
    for (int k = 0; k <= order; ++k) {
        sizes[k] += fabs(c[k]) / unit;
    }
}

double tdmf_carried_expand(const tdmf_step *step, const tdmf_mode *mode, const tdmf_change *change,
                           const tdmf_carried *carried, tdmf_tangent_series *tangent) {
    const tdmf_scales *scales = &step->chart->model->scales;
    const int order = step->order;
    const tdmf_coordinates *d = &carried->at;
    double sizes[SERIES_TERMS] = {0.0};
    if (step->chart->contact == TDMF_CONTACT_FLIGHT) {
        flight_variation *flight = &tangent->flight;
        const flight_coefficients varied = vary_flight_coefficients(step->chart, mode, change, carried);
        const flight_coefficients coefficients = tdmf_step_flight_coefficients(step->chart);
        const double start[4] = {d->length, d->angle, d->length_rate, d->angle_rate};
        vary_flight(&coefficients, &step->series.flight, &varied, start, order, flight);
        add_sizes(flight->length, scales->length, order, sizes);
        add_sizes(flight->length_rate, scales->speed, order, sizes);
        add_sizes(flight->angle, 1.0, order, sizes);
        add_sizes(flight->momentum, scales->speed * scales->length, order, sizes);
    } else {
        ground_variation *ground = &tangent->ground;
        const ground_coefficients varied = vary_ground_coefficients(step->chart, mode, change);
        const ground_coefficients coefficients = tdmf_step_ground_coefficients(step->chart);
        const double start[GROUND_START_COUNT] = {d->x, d->y, d->vx, d->vy, d->foot_vx};
        vary_ground(&coefficients, &step->series.ground, &varied, start, order, tdmf_step_ground_case(step),
                    ground);
        add_sizes(ground->x, scales->length, order, sizes);
        add_sizes(ground->y, scales->length, order, sizes);
        add_sizes(ground->vx, scales->speed, order, sizes);
        add_sizes(ground->vy, scales->speed, order, sizes);
        add_sizes(ground->foot_vx, scales->speed, order, sizes);
    }
    return tdmf_step_trusts_terms(step, sizes);
}

void tdmf_carry_on(const tdmf_step *step, double elapsed, const tdmf_change *change,
                   const tdmf_tangent_series *tangent, tdmf_carried *carried) {
    if (step->chart->contact == TDMF_CONTACT_FLIGHT) {
        carry_flight_on(step, elapsed, change, &tangent->flight, carried);
    } else {
        carry_ground_on(step, elapsed, &tangent->ground, carried);
    }
}

tdmf_variation tdmf_carried_to(const tdmf_chart *chart, const double state[TDMF_STATE_COUNT],
                               const tdmf_change *change, const tdmf_carried *carried) {
    tdmf_variation variation = {.liftoff_angle = carried->liftoff_angle};
    variation.state[TDMF_HIP_WORK] = carried->at.work;
    if (chart->contact == TDMF_CONTACT_FLIGHT) {
        flight_carried_to(chart, state, change, carried, variation.state);
    } else {
        ground_carried_to(state, carried, variation.state);
    }
    return variation;
}
