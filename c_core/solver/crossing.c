/* The guards of model/guards.c as polynomials in time. What a guard is made of has been expanded with the
 * motion, so that a guard is a sum of series, as exact as the step, and no crossing is missed, however short.
 *
 * A polynomial is zero a little after its guard: what it finds due is due to the model beyond rounding. */
#include "crossing.h"

#include "first_root.h"
#include "friction.h"
#include "ground_force.h"
#include "margins.h"

typedef struct {
    const tdmf_step *step;
    double margin_factor;
    double beyond_margin; /* where a guard is due */
    tdmf_crossing first;
} search;

/* Of two findings, the one that ends a step sooner. */
static tdmf_root sooner(tdmf_root a, tdmf_root b) {
    return b.time < a.time || (b.time == a.time && b.is_root) ? b : a;
}

static void note(search *search, tdmf_guard guard, tdmf_root found) {
    const tdmf_root first = sooner(search->first.at, found);
    if (first.time != search->first.at.time || first.is_root != search->first.at.is_root) {
        search->first.at = first;
        search->first.guard = guard;
    }
}

/* A series that is `above` zero at the start of the step stays there. */
static bool stays_above(const search *search, double above, const double *c, int order) {
    return above > tdmf_spread(c, order, &search->step->reach);
}

static tdmf_polynomial scaled(const double *c, double factor, int order) {
    tdmf_polynomial p;
    p.order = order;
    p.c[0] = p.c[1] = p.c[2] = 0.0;
    for (int k = 0; k <= order; ++k) {
        p.c[k] = factor * c[k];
    }
    return p;
}

static void add(tdmf_polynomial *p, const double *c, double factor) {
    for (int k = 0; k <= p->order; ++k) {
        p->c[k] += factor * c[k];
    }
}

static void add_parabola(tdmf_polynomial *p, double value, double rate, double curvature) {
    p->c[0] += value;
    p->c[1] += rate;
    p->c[2] += curvature;
}

static void add_line(tdmf_polynomial *p, double value, double rate) {
    p->c[0] += value;
    p->c[1] += rate;
}

/* Adds the product of two series. */
static void add_product(tdmf_polynomial *p, const double *a, const double *b) {
    for (int i = 0; i <= p->order; ++i) {
        for (int k = i; k <= p->order; ++k) {
            p->c[k] += a[i] * b[k - i];
        }
    }
}

static tdmf_polynomial derivative(const double *c, double factor, int order) {
    tdmf_polynomial p;
    p.order = order - 1;
    for (int k = 0; k < order; ++k) {
        p.c[k] = factor * (double)(k + 1) * c[k + 1];
    }
    return p;
}

/* Notes the first time at which the polynomial, in units of `scale`, falls to `floor`. */
static void watch(search *search, tdmf_guard guard, const tdmf_polynomial *p, double scale, double floor) {
    const double to = fmin(search->step->size, search->first.at.time);
    note(search, guard,
         tdmf_first_root(p, &search->step->reach, 1.0, search->margin_factor * floor * scale, 0.0, to));
}

static void watch_length(search *search, const double *length) {
    const tdmf_model *model = search->step->chart->model;
    tdmf_polynomial p = scaled(length, 1.0, search->step->order);
    p.c[0] -= model->parameters.leg.min_length;
    watch(search, TDMF_GUARD_LEG_TOO_SHORT, &p, model->scales.length, search->beyond_margin);
}

/* ---- flight ------------------------------------------------------------------------------------------- */

/* r cos(theta), by (cos)' = -w sin and (sin)' = w cos. */
static void expand_drop(const flight_series *f, double sine0, double cosine0, int order,
                        double drop[SERIES_TERMS]) {
    double sine[SERIES_TERMS], cosine[SERIES_TERMS];
    sine[0] = sine0;
    cosine[0] = cosine0;
    for (int k = 0; k < order; ++k) {
        double rise = 0.0;
        double fall = 0.0;
        for (int i = 0; i <= k; ++i) {
            rise += f->angle_rate[i] * cosine[k - i];
            fall += f->angle_rate[i] * sine[k - i];
        }
        sine[k + 1] = rise * series_reciprocal[k + 1];
        cosine[k + 1] = -fall * series_reciprocal[k + 1];
    }
    for (int k = 0; k <= order; ++k) {
        drop[k] = 0.0;
        for (int i = 0; i <= k; ++i) {
            drop[k] += f->length[i] * cosine[k - i];
        }
    }
}

static double center_of_mass_height(const tdmf_chart *chart, double t) {
    return chart->com_y + t * (chart->com_vy - 0.5 * chart->model->parameters.gravity * t);
}

/* Whether the leg may reach the ground by either end: a parabola is lowest at an end, and a leg does not drop
 * further than its longest at the angle that brings it nearest to the vertical. */
static bool may_reach_ground(const tdmf_step *step, double share, double longest, double sine,
                             double cosine) {
    const tdmf_chart *chart = step->chart;
    const double lowest = fmin(chart->com_y, center_of_mass_height(chart, step->size));
    const double turn = tdmf_spread(step->series.flight.angle, step->order, &step->reach);
    const double change = turn * (fabs(sine) + 0.5 * turn);
    const double down = share * longest * fmin(1.0, cosine + change);
    const double up = (1.0 - share) * longest * fmin(1.0, change - cosine);
    return !(lowest > fmax(0.0, fmax(down, up)));
}

static void watch_heights(search *search, double longest) {
    const tdmf_step *step = search->step;
    const tdmf_chart *chart = step->chart;
    const flight_series *f = &step->series.flight;
    const double share = chart->model->body_share;
    const double length = chart->model->scales.length;
    const double sine = sin(f->angle[0]), cosine = cos(f->angle[0]);
    double drop[SERIES_TERMS];
    if (!may_reach_ground(step, share, longest, sine, cosine)) {
        return;
    }
    expand_drop(f, sine, cosine, step->order, drop);
    /* A leg that spins at a steady rate has long steps, and a drop that is not. */
    const tdmf_root trusted = {tdmf_step_trusts(step, drop, length), false};
    note(search, TDMF_GUARD_COUNT, trusted);
    tdmf_polynomial foot = scaled(drop, -share, step->order);
    tdmf_polynomial body = scaled(drop, 1.0 - share, step->order);
    const double curvature = -0.5 * chart->model->parameters.gravity;
    add_parabola(&foot, chart->com_y, chart->com_vy, curvature);
    add_parabola(&body, chart->com_y, chart->com_vy, curvature);
    watch(search, TDMF_GUARD_TOUCHDOWN, &foot, length, search->beyond_margin);
    watch(search, TDMF_GUARD_BODY_DOWN, &body, length, search->beyond_margin);
}

static void watch_flight(search *search, const tdmf_mode *mode) {
    const tdmf_step *step = search->step;
    const tdmf_chart *chart = step->chart;
    const tdmf_model *model = chart->model;
    const flight_series *f = &step->series.flight;
    const double spread = tdmf_spread(f->length, step->order, &step->reach);
    if (f->length[0] - spread <= model->parameters.leg.min_length) {
        watch_length(search, f->length);
    }
    watch_heights(search, f->length[0] + spread);
    if (mode->phase != TDMF_PHASE_RETRACT) {
        return;
    }
    const tdmf_polynomial rise = {{chart->com_vy, -model->parameters.gravity, 0.0}, 2};
    watch(search, TDMF_GUARD_APEX, &rise, model->scales.speed, search->beyond_margin);
    const double sign = mode->clamp_closed ? -1.0 : 1.0;
    tdmf_polynomial clamp = scaled(f->angle, -sign * chart->servo.gain, step->order - 1);
    add(&clamp, f->angle_rate, -sign * chart->servo.rate_gain);
    clamp.c[0] += sign * chart->servo.gain * chart->servo.target;
    watch(search, TDMF_GUARD_CLAMP, &clamp, model->scales.energy, TDMF_BEYOND_DEAD_BAND);
}

/* ---- on the ground ------------------------------------------------------------------------------------ */

static void watch_standing_leg(search *search) {
    const tdmf_step *step = search->step;
    const tdmf_model *model = step->chart->model;
    const ground_series *g = &step->series.ground;
    if (!stays_above(search, g->y[0], g->y, step->order)) {
        const tdmf_polynomial body = scaled(g->y, 1.0, step->order);
        watch(search, TDMF_GUARD_BODY_DOWN, &body, model->scales.length, search->beyond_margin);
    }
    if (!stays_above(search, g->length[0] - model->parameters.leg.min_length, g->length, step->order)) {
        watch_length(search, g->length);
    }
}

/* theta, by the body's place over the foot. */
static void watch_mid_stance(search *search) {
    const ground_series *g = &search->step->series.ground;
    if (stays_above(search, -g->x[0], g->x, search->step->order)) {
        return;
    }
    const tdmf_polynomial ahead = scaled(g->x, -1.0, search->step->order);
    watch(search, TDMF_GUARD_MID_STANCE, &ahead, 2.0 * g->length[0], search->beyond_margin);
}

/* mu f_y + sign f_x, by the weights of the largest friction in the step. */
static void watch_cone(search *search, double sign) {
    const tdmf_chart *chart = search->step->chart;
    const ground_series *g = &search->step->series.ground;
    const double friction = chart->static_friction;
    const double rate = chart->static_friction_rate;
    const double weight = tdmf_cone_of(fmax(friction, friction + rate * search->step->size)).tangential;
    tdmf_polynomial room = scaled(g->normal_force, weight * friction, search->step->order - 1);
    add(&room, g->leg_force_x, -sign * weight);
    if (rate != 0.0) {
        for (int k = 1; k <= room.order; ++k) {
            room.c[k] += weight * rate * g->normal_force[k - 1];
        }
    }
    watch(search, sign > 0.0 ? TDMF_GUARD_SLIP_ONSET_POSITIVE : TDMF_GUARD_SLIP_ONSET_NEGATIVE, &room,
          search->step->chart->model->scales.force, search->beyond_margin);
}

static void watch_forces(search *search, bool sticks) {
    const tdmf_step *step = search->step;
    const ground_series *g = &step->series.ground;
    const int order = step->order - 1;
    const double press_spread = tdmf_spread(g->normal_force, order, &step->reach);
    if (!(g->normal_force[0] > press_spread)) {
        const tdmf_polynomial press = scaled(g->normal_force, 1.0, order);
        watch(search, TDMF_GUARD_LIFT_OFF, &press, step->chart->model->scales.force, search->beyond_margin);
    }
    if (!sticks) {
        return;
    }
    const double room =
        step->chart->static_friction * (g->normal_force[0] - press_spread) - fabs(g->leg_force_x[0]);
    if (step->chart->static_friction_rate != 0.0 || !stays_above(search, room, g->leg_force_x, order)) {
        watch_cone(search, 1.0);
        watch_cone(search, -1.0);
    }
}

static void watch_contact(search *search, const tdmf_mode *mode) {
    const tdmf_step *step = search->step;
    const ground_series *g = &step->series.ground;
    const double sign = tdmf_slip_sign(mode);
    watch_standing_leg(search);
    watch_forces(search, mode->contact == TDMF_CONTACT_STICK);
    if (mode->phase == TDMF_PHASE_DRIVE && step->chart->turn == 0.0) {
        watch_mid_stance(search);
    }
    if (sign != 0.0 && !stays_above(search, sign * g->foot_vx[0], g->foot_vx, step->order)) {
        const tdmf_polynomial speed = scaled(g->foot_vx, sign, step->order);
        watch(search, TDMF_GUARD_SLIP_VELOCITY_ZERO, &speed, step->chart->model->scales.speed,
              search->beyond_margin);
    }
}

/* ---- graze -------------------------------------------------------------------------------------------- */

/* The servo's torque along the motion. */
static tdmf_polynomial servo_torque(const tdmf_step *step, double angle) {
    const tdmf_hip_law *servo = &step->chart->servo;
    const double *rate = step->series.ground.angle_rate;
    tdmf_polynomial torque = scaled(rate, -servo->rate_gain, step->order - 1);
    torque.c[0] += servo->gain * (servo->target - angle) + servo->torque;
    torque.c[1] += servo->torque_rate;
    for (int k = 1; k <= torque.order; ++k) {
        torque.c[k] -= servo->gain * rate[k - 1] * series_reciprocal[k];
    }
    return torque;
}

/* X/r^2: what a torque presses the foot down with. */
static void expand_lever(const ground_series *g, int order, double lever[SERIES_TERMS]) {
    for (int k = 0; k <= order; ++k) {
        lever[k] = g->x[k];
        for (int i = 0; i < k; ++i) {
            lever[k] -= lever[i] * g->square[k - i];
        }
        lever[k] /= g->square[0];
    }
}

/* Ground force, times `sign`, under the torque of a law that graze excludes. */
static void watch_normal_force(search *search, const double lever[SERIES_TERMS], double sign,
                               tdmf_polynomial torque) {
    const tdmf_chart *chart = search->step->chart;
    const ground_series *g = &search->step->series.ground;
    tdmf_polynomial force = scaled(g->axial_y, sign, torque.order);
    force.c[0] += sign * tdmf_foot_weight(chart->model);
    for (int k = 0; k <= torque.order; ++k) {
        torque.c[k] *= sign;
    }
    add_product(&force, torque.c, lever);
    watch(search, sign > 0.0 ? TDMF_GUARD_GRAZE_TO_FLIGHT : TDMF_GUARD_GRAZE_TO_CONTACT, &force,
          chart->model->scales.force, search->beyond_margin);
}

static void watch_graze(search *search, const tdmf_mode *mode) {
    const tdmf_step *step = search->step;
    const tdmf_chart *chart = step->chart;
    const tdmf_model *model = chart->model;
    const ground_series *g = &step->series.ground;
    const int order = step->order - 1;
    const double zero = TDMF_ZERO_CLAMP_ARGUMENT * model->scales.energy;
    double lever[SERIES_TERMS];
    tdmf_polynomial flight = servo_torque(step, atan2(-chart->start.x, chart->start.y) + chart->turn);
    const double closed[SERIES_TERMS] = {0.0};
    tdmf_polynomial stance = scaled(closed, 0.0, order);
    add_line(&stance, chart->stance_law.torque, chart->stance_law.torque_rate);
    expand_lever(g, order, lever);
    watch_standing_leg(search);
    if (mode->phase == TDMF_PHASE_RETRACT) {
        const tdmf_polynomial rise = scaled(g->vy, model->body_share, step->order);
        watch(search, TDMF_GUARD_APEX, &rise, model->scales.speed, search->beyond_margin);
        tdmf_root kink = tdmf_first_sign_change(&flight, &step->reach, zero, 0.0, step->size);
        kink.is_root = false;
        note(search, TDMF_GUARD_CLAMP, kink);
        const bool pulls = fabs(flight.c[0]) > zero ? flight.c[0] > 0.0 : flight.c[1] > 0.0;
        if (!pulls) {
            flight = scaled(closed, 0.0, order);
        }
    }
    add_line(&flight, chart->law.torque, chart->law.torque_rate);
    watch_normal_force(search, lever, -1.0, stance);
    watch_normal_force(search, lever, 1.0, flight);
}

/* ---- all ---------------------------------------------------------------------------------------------- */

tdmf_crossing tdmf_first_crossing(const tdmf_step *step, const tdmf_mode *mode, double margin_factor) {
    search search = {
        step, margin_factor, tdmf_beyond_margin(step->tolerance), {{INFINITY, false}, TDMF_GUARD_COUNT}};
    if (mode->contact == TDMF_CONTACT_FLIGHT) {
        watch_flight(&search, mode);
    } else if (mode->contact == TDMF_CONTACT_GRAZE) {
        watch_graze(&search, mode);
    } else {
        watch_contact(&search, mode);
    }
    return search.first;
}

tdmf_root tdmf_force_turn(const tdmf_step *step, bool rising, double from, double to) {
    const tdmf_scales *scales = &step->chart->model->scales;
    const tdmf_polynomial rate =
        derivative(step->series.ground.normal_force, rising ? 1.0 : -1.0, step->order - 1);
    return tdmf_first_root(&rate, &step->reach, 1.0, TDMF_BEYOND_DEAD_BAND * scales->force / scales->time,
                           from, to);
}

bool tdmf_power_keeps_sign(const tdmf_step *step) {
    const tdmf_reach *reach = &step->reach;
    if (step->chart->contact == TDMF_CONTACT_FLIGHT) {
        double torque[SERIES_TERMS];
        const double *momentum = step->series.flight.momentum;
        for (int k = 0; k < step->order; ++k) {
            torque[k] = (double)(k + 1) * momentum[k + 1];
        }
        return fabs(momentum[0]) > tdmf_spread(momentum, step->order, reach) &&
               fabs(torque[0]) > tdmf_spread(torque, step->order - 1, reach);
    }
    const double *moment = step->series.ground.moment;
    const double *torque = step->series.ground.torque;
    const double torque_spread = tdmf_spread(torque, step->order - 1, reach);
    return (torque[0] == 0.0 && torque_spread == 0.0) ||
           (fabs(torque[0]) > torque_spread && fabs(moment[0]) > tdmf_spread(moment, step->order, reach));
}

tdmf_root tdmf_power_turn(const tdmf_step *step, double from, double to) {
    const tdmf_scales *scales = &step->chart->model->scales;
    const bool flies = step->chart->contact == TDMF_CONTACT_FLIGHT;
    const tdmf_polynomial momentum =
        scaled(flies ? step->series.flight.momentum : step->series.ground.moment, 1.0, step->order);
    const tdmf_polynomial torque = flies ? derivative(step->series.flight.momentum, 1.0, step->order)
                                         : scaled(step->series.ground.torque, 1.0, step->order - 1);
    const double inverse_mobility = scales->length * scales->length / scales->time;
    return sooner(
        tdmf_first_sign_change(&momentum, &step->reach, TDMF_ZERO_POWER * inverse_mobility, from, to),
        tdmf_first_sign_change(&torque, &step->reach, TDMF_ZERO_POWER * inverse_mobility / scales->time, from,
                               to));
}
