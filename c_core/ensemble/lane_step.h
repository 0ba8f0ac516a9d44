/* One step of a crew: expansion, first event, evaluation, in all lanes at once. The formulas are those of
 * step.c and crossing.c for a single runner, with inputs that are held. */
#ifndef TDMF_ENSEMBLE_LANE_STEP_H
#define TDMF_ENSEMBLE_LANE_STEP_H

#include "lane_math.h"
#include "lane_search.h"
#include "margins.h"

#include "members.h"

/* What a step has come to. */
typedef struct {
    choice at_event;
    choice late;  /* no time left to close the stride */
    choice stuck; /* no finite step, none left, or too stiff */
} lane_outcome;

/* ---- size --------------------------------------------------------------------------------------------- */

typedef struct {
    real last, last_but_one;
} lane_remainder;

static inline void note_remainder(lane_remainder *remainder, const real *c, int order, real unit) {
    const real allowed = 1.0 / larger(unit, real_abs(c[0]));
    remainder->last += real_abs(c[order]) * allowed;
    remainder->last_but_one += real_abs(c[order - 1]) * allowed;
}

static inline real trusted_size(const lane_remainder *remainder, real longest, int order, double tolerance) {
    const real by_last = rough_root(tolerance / remainder->last, order);
    const real by_last_but_one = rough_root(tolerance / remainder->last_but_one, order - 1);
    const choice known = is_finite(remainder->last + remainder->last_but_one);
    return pick(known, smaller(longest, smaller(by_last, by_last_but_one)), real_of(NAN));
}

static inline real power_of(real x, int n) {
    real power = real_of(1.0);
    for (; n > 0; n >>= 1, x *= x) {
        if (n & 1) {
            power *= x;
        }
    }
    return power;
}

/* As in step.c. */
static inline real size_for_loss(const member_frame *frame, const real *speed_square, real size, int order,
                                 double tolerance) {
    const real unit = frame->energy_scale / (frame->damping * frame->time_scale);
    lane_remainder remainder = {real_of(0.0), real_of(0.0)};
    note_remainder(&remainder, speed_square, order, unit);
    const choice too_long = remainder.last * power_of(size, order) > tolerance;
    return any(too_long) ? pick(too_long, trusted_size(&remainder, size, order, tolerance), size) : size;
}

/* ---- sums --------------------------------------------------------------------------------------------- */

/* Powers of a time, and what they integrate to. */
typedef struct {
    real power[SERIES_TERMS], integral[SERIES_TERMS];
} elapsed_time;

static inline void set_elapsed(elapsed_time *elapsed, real t, int order) {
    set_powers(elapsed->power, t, order + 1);
    for (int k = 0; k <= order; ++k) {
        elapsed->integral[k] = elapsed->power[k + 1] * series_reciprocal[k + 1];
    }
}

/* Smallest terms first. */
static inline real dot(const real *c, const real *weights, int order) {
    real sum = c[order] * weights[order];
    for (int k = order - 1; k >= 0; --k) {
        sum += c[k] * weights[k];
    }
    return sum;
}

/* ---- flight ------------------------------------------------------------------------------------------- */

/* r cos(theta), by (cos)' = -w sin and (sin)' = w cos. */
static inline void expand_drop(const flight_series *f, real sine0, real cosine0, int order,
                               real drop[SERIES_TERMS]) {
    real sine[SERIES_TERMS], cosine[SERIES_TERMS];
    sine[0] = sine0;
    cosine[0] = cosine0;
    for (int k = 0; k <= order; ++k) {
        real rise = real_of(0.0), fall = real_of(0.0), sum = real_of(0.0);
        for (int i = 0; i <= k; ++i) {
            rise += f->angle_rate[i] * cosine[k - i];
            fall += f->angle_rate[i] * sine[k - i];
            sum += f->length[i] * cosine[k - i];
        }
        drop[k] = sum;
        if (k < order) {
            sine[k + 1] = rise * series_reciprocal[k + 1];
            cosine[k + 1] = -fall * series_reciprocal[k + 1];
        }
    }
}

/* Begins a search within a step that is short enough for the leg: see size_without_pole in step.c. Returns
 * how much the length may change in it. */
static inline real search_without_pole(lane_search *search, real size, const real *length, int order,
                                       choice live, real due_below) {
    search_within(search, size, order, live, due_below);
    const real most = SERIES_MOST_CHANGE * length[0];
    const real change = spread_of(search, length, order);
    const choice too_long = live & (change > most);
    if (!any(too_long)) {
        return change;
    }
    search_within(search, pick(too_long, size * most / change, size), order, live, due_below);
    return spread_of(search, length, order);
}

/* Begins the search of a step whose motion may be trusted for a time. Returns how much the length may change.
 */
static inline real begin_search(lane_search *search, const member_progress *now, const member_frame *frame,
                                real trusted, const real *length, const real *speed_square, int order,
                                choice live, double tolerance) {
    const real summed = size_for_loss(frame, speed_square, trusted, order - 1, tolerance);
    const real size = smaller(frame->time_left - now->elapsed, summed);
    return search_without_pole(search, size, length, order, live,
                               tdmf_beyond_margin(tolerance) * frame->margin_factor);
}

static inline void watch_length(lane_search *search, const member_frame *frame, const real *length, int order,
                                real change) {
    const guard_series g = {length, real_of(1.0), length[0] - frame->min_length, order};
    if (!any(search->live & ~(g.start > change))) {
        return;
    }
    watch(search, TDMF_GUARD_LEG_TOO_SHORT, search->live, &g, search->due_below * frame->length_scale);
}

/* Lanes in which the leg may reach the ground by either end: a parabola is lowest at an end, and a leg does
 * not drop further than its longest at the angle that brings it nearest to the vertical. */
static inline choice may_reach_ground(const lane_search *search, const flying_member *m,
                                      const flight_series *f, int order, real longest, real com_y,
                                      real com_vy, real sine, real cosine) {
    const real t = search->size;
    const real lowest = smaller(com_y, com_y + t * (com_vy - 0.5 * m->frame.gravity * t));
    const real turn = spread_of(search, f->angle, order);
    const real change = turn * (real_abs(sine) + 0.5 * turn);
    const real down = m->share * longest * smaller(cosine + change, real_of(1.0));
    const real up = (1.0 - m->share) * longest * smaller(change - cosine, real_of(1.0));
    return search->live & ~(lowest > larger(larger(down, up), real_of(0.0)));
}

/* Heights of foot and body: a parabola and a share of the leg's drop. */
static inline void watch_heights(lane_search *search, const flying_member *m, const flight_series *f,
                                 int order, double tolerance, real longest, real com_y, real com_vy) {
    lane_remainder remainder = {real_of(0.0), real_of(0.0)};
    const real floor = search->due_below * m->frame.length_scale;
    real sine, cosine, drop[SERIES_TERMS], height[SERIES_TERMS];
    sine_and_cosine(f->angle[0], &sine, &cosine);
    const choice low = may_reach_ground(search, m, f, order, longest, com_y, com_vy, sine, cosine);
    if (!any(low)) {
        return;
    }
    expand_drop(f, sine, cosine, order, drop);
    note_remainder(&remainder, drop, order, m->frame.length_scale);
    note_found(search, low, trusted_size(&remainder, real_of(INFINITY), order, tolerance), bits_of(0),
               bits_of(0));
    for (int end = 0; end < 2; ++end) {
        const real share = end == 0 ? -m->share : 1.0 - m->share;
        for (int k = 0; k <= order; ++k) {
            height[k] = share * drop[k];
        }
        height[1] += com_vy;
        height[2] -= 0.5 * m->frame.gravity;
        const guard_series g = {height, real_of(1.0), com_y + height[0], order};
        watch(search, end == 0 ? TDMF_GUARD_TOUCHDOWN : TDMF_GUARD_BODY_DOWN, low, &g, floor);
    }
}

/* The centre of mass rises at com_vy - g t. */
static inline void watch_apex_in_flight(lane_search *search, const flying_member *m, real com_vy) {
    const real time = (com_vy - search->due_below * m->frame.speed_scale) / m->frame.gravity;
    note_found(search, search->live & (time <= search->size), larger(time, real_of(0.0)), bits_of(-1),
               bits_of(TDMF_GUARD_APEX));
}

static inline void watch_clamp(lane_search *search, const flying_member *m, const flight_series *f,
                               int order) {
    real argument[SERIES_TERMS];
    for (int k = 0; k < order; ++k) {
        argument[k] = -m->kp * f->angle[k] - m->kd * f->angle_rate[k];
    }
    const guard_series g = {argument, real_of(1.0), argument[0] + m->kp * m->target, order - 1};
    watch(search, TDMF_GUARD_CLAMP, search->live, &g,
          TDMF_BEYOND_DEAD_BAND * m->frame.margin_factor * m->frame.energy_scale);
}

static inline void fly_on(flying_member *m, const flight_series *f, int order, real t) {
    const flight_coefficients *a = &m->law;
    elapsed_time elapsed;
    set_elapsed(&elapsed, t, order);
    const real turned = dot(f->angle_rate, elapsed.integral, order - 1);
    m->now.work += m->inverse_mobility *
                   (a->gain * turned * (a->target - m->angle - 0.5 * turned) -
                    a->rate_gain * dot(f->rate_square, elapsed.integral, order - 1) + a->torque * turned);
    m->now.damper_loss += m->frame.damping * dot(f->speed_square, elapsed.integral, order - 1);
    m->length = dot(f->length, elapsed.power, order);
    m->length_rate = dot(f->length_rate, elapsed.power, order);
    m->angle = dot(f->angle, elapsed.power, order);
    m->angle_rate = dot(f->momentum, elapsed.power, order) / (m->length * m->length);
}

/* Lanes that have just been boarded and whose coefficients say that they are too stiff. */
static inline choice opens_too_stiff(const member_progress *now, const member_frame *frame, real longest) {
    const real ahead = smaller(frame->time_scale, frame->time_left);
    return (now->elapsed == 0.0) & (TDMF_STIFFNESS_LIMIT * longest < ahead);
}

/* What a size that is not a number, or none left, makes of a step. */
static inline lane_outcome move_on(member_progress *now, const member_frame *frame, lane_search *search,
                                   choice too_stiff, real end) {
    const choice next_span = now->span >= frame->time_scale;
    now->span = pick(next_span, real_of(0.0), now->span) + end;
    now->steps_in_span = pick(next_span, real_of(0.0), now->steps_in_span) + 1.0;
    const lane_outcome outcome = {
        .at_event = search->live & search->is_root & (search->time <= search->size) & ~too_stiff,
        .late = search->live & (now->elapsed + end >= frame->time_left),
        .stuck =
            search->live & (too_stiff | ~(now->elapsed + end > now->elapsed) | (now->steps_left <= 1.0) |
                            ((now->steps_in_span >= TDMF_STIFFNESS_LIMIT) & (now->span < frame->time_scale))),
    };
    now->elapsed += end;
    now->steps_left -= 1.0;
    return outcome;
}

static inline lane_outcome step_flying(flying_member *m, choice live, bool retracts, int order,
                                       double tolerance, flight_series *f) {
    lane_search search;
    lane_remainder remainder = {real_of(0.0), real_of(0.0)};
    const real start[4] = {m->length, m->angle, m->length_rate, m->angle_rate};
    expand_flight(&m->law, start, order, f);
    note_remainder(&remainder, f->length_rate, order - 1, m->frame.speed_scale);
    note_remainder(&remainder, f->angle_rate, order - 1, 1.0 / m->frame.time_scale);
    const real longest = longest_flight_step(&m->law, m->length, order);
    const real trusted = trusted_size(&remainder, longest, order - 1, tolerance);
    const real change = begin_search(&search, &m->now, &m->frame, trusted, f->length, f->speed_square, order,
                                     live, tolerance);
    const real com_y = m->com_y + m->now.elapsed * (m->com_vy - 0.5 * m->frame.gravity * m->now.elapsed);
    const real com_vy = m->com_vy - m->frame.gravity * m->now.elapsed;
    watch_length(&search, &m->frame, f->length, order, change);
    watch_heights(&search, m, f, order, tolerance, f->length[0] + change, com_y, com_vy);
    if (retracts) {
        watch_apex_in_flight(&search, m, com_vy);
        watch_clamp(&search, m, f, order);
    }
    march_up(&search);
    const real end = smaller(search.time, search.size);
    const choice too_stiff = opens_too_stiff(&m->now, &m->frame, longest);
    fly_on(m, f, order, end);
    return move_on(&m->now, &m->frame, &search, too_stiff, end);
}

/* ---- on the ground ------------------------------------------------------------------------------------ */

static inline void watch_standing_leg(lane_search *search, const standing_member *m, const ground_series *g,
                                      int order, real change) {
    const guard_series body = {g->y, real_of(1.0), g->y[0], order};
    watch(search, TDMF_GUARD_BODY_DOWN, search->live, &body, search->due_below * m->frame.length_scale);
    watch_length(search, &m->frame, g->length, order, change);
}

/* theta, by the body's place over the foot. */
static inline void watch_mid_stance(lane_search *search, const standing_member *m, const ground_series *g,
                                    int order) {
    const guard_series ahead = {g->x, real_of(-1.0), -g->x[0], order};
    watch(search, TDMF_GUARD_MID_STANCE, m->drives > 0.0, &ahead, 2.0 * search->due_below * g->length[0]);
}

static inline void watch_lift_off(lane_search *search, const standing_member *m, const ground_series *g,
                                  int order) {
    const guard_series press = {g->normal_force, real_of(1.0), g->normal_force[0], order - 1};
    watch(search, TDMF_GUARD_LIFT_OFF, search->live, &press, search->due_below * m->frame.force_scale);
}

/* mu f_y + f_x and mu f_y - f_x. */
static inline void watch_cone(lane_search *search, const standing_member *m, const ground_series *g,
                              int order) {
    const real room =
        m->cone_normal * (g->normal_force[0] - spread_of(search, g->normal_force, order - 1)) -
        m->cone_tangential * (real_abs(g->leg_force_x[0]) + spread_of(search, g->leg_force_x, order - 1));
    const choice near = search->live & ~(room > 0.0);
    if (!any(near)) {
        return;
    }
    for (int edge = 0; edge < 2; ++edge) {
        const real tangential = edge == 0 ? -m->cone_tangential : m->cone_tangential;
        const real start = m->cone_normal * g->normal_force[0] + tangential * g->leg_force_x[0];
        real distance[SERIES_TERMS];
        for (int k = 0; k < order; ++k) {
            distance[k] = m->cone_normal * g->normal_force[k] + tangential * g->leg_force_x[k];
        }
        const guard_series cone = {distance, real_of(1.0), start, order - 1};
        watch(search, edge == 0 ? TDMF_GUARD_SLIP_ONSET_POSITIVE : TDMF_GUARD_SLIP_ONSET_NEGATIVE, near,
              &cone, search->due_below * m->frame.force_scale);
    }
}

static inline void watch_slip(lane_search *search, const standing_member *m, const ground_series *g,
                              int order) {
    const guard_series speed = {g->foot_vx, m->slip_sign, m->slip_sign * g->foot_vx[0], order};
    watch(search, TDMF_GUARD_SLIP_VELOCITY_ZERO, search->live, &speed,
          search->due_below * m->frame.speed_scale);
}

/* X/r^2: what a torque presses the foot down with. */
static inline void expand_lever(const ground_series *g, int order, real lever[SERIES_TERMS]) {
    const real inverse_square = 1.0 / g->square[0];
    lever[0] = g->x[0] * inverse_square;
    for (int k = 1; k <= order; ++k) {
        real rest = g->x[k];
        for (int i = 0; i < k; ++i) {
            rest -= lever[i] * g->square[k - i];
        }
        lever[k] = rest * inverse_square;
    }
}

/* Ground force, times `sign`, under a law that graze excludes. */
static inline void watch_press(lane_search *search, const standing_member *m, const ground_series *g,
                               int order, double sign, const real *law, const real *lever) {
    const real start = sign * (g->axial_y[0] + law[0] * lever[0] + m->law.foot_weight);
    real press[SERIES_TERMS];
    for (int k = 0; k <= order; ++k) {
        real sum = g->axial_y[k];
        for (int i = 0; i <= k; ++i) {
            sum += law[i] * lever[k - i];
        }
        press[k] = sign * sum;
    }
    const guard_series guard = {press, real_of(1.0), start, order};
    watch(search, sign > 0.0 ? TDMF_GUARD_GRAZE_TO_FLIGHT : TDMF_GUARD_GRAZE_TO_CONTACT, search->live, &guard,
          search->due_below * m->frame.force_scale);
}

static inline void watch_graze(lane_search *search, const standing_member *m, const ground_series *g,
                               int order) {
    const choice retracts = m->rise_share > 0.0;
    const real zero = TDMF_ZERO_CLAMP_ARGUMENT * m->frame.energy_scale;
    real lever[SERIES_TERMS], law[SERIES_TERMS], stance[SERIES_TERMS];
    const guard_series rise = {g->vy, m->rise_share, m->rise_share * g->vy[0], order};
    watch(search, TDMF_GUARD_APEX, retracts, &rise, search->due_below * m->frame.speed_scale);
    law[0] = -m->kd * g->angle_rate[0] - m->kp * (m->angle - m->target);
    stance[0] = m->stance_law;
    for (int k = 1; k < order; ++k) {
        law[k] = -m->kd * g->angle_rate[k] - m->kp * g->angle_rate[k - 1] * series_reciprocal[k];
        stance[k] = real_of(0.0);
    }
    /* Where the clamp opens or closes the law has a kink, which ends the step. */
    const real leading = pick(real_abs(law[0]) > zero, law[0], law[1]);
    const real sign = pick(leading < 0.0, real_of(-1.0), real_of(1.0));
    const guard_series kink = {law, sign, sign * law[0], order - 1};
    watch(search, TDMF_GUARD_CLAMP, retracts, &kink, -2.0 * zero);
    const choice closed = retracts & ~(leading > 0.0);
    for (int k = 0; k < order; ++k) {
        law[k] = pick(closed, real_of(0.0), law[k]);
    }
    law[0] += m->law.torque;
    expand_lever(g, order - 1, lever);
    watch_press(search, m, g, order - 1, -1.0, stance, lever);
    watch_press(search, m, g, order - 1, 1.0, law, lever);
}

static inline void stand_on(standing_member *m, const ground_series *g, int order, bool slips, bool grazes,
                            real t) {
    elapsed_time elapsed;
    set_elapsed(&elapsed, t, order);
    m->now.work += dot(g->power, elapsed.integral, order - 1);
    m->now.damper_loss += m->frame.damping * dot(g->speed_square, elapsed.integral, order - 1);
    if (slips) {
        m->now.friction_loss += dot(g->friction_power, elapsed.integral, order - 1);
    }
    if (grazes) {
        m->angle += dot(g->angle_rate, elapsed.integral, order - 1);
    }
    m->x = dot(g->x, elapsed.power, order);
    m->y = dot(g->y, elapsed.power, order);
    m->vx = dot(g->vx, elapsed.power, order);
    m->vy = dot(g->vy, elapsed.power, order);
    if (slips || grazes) {
        m->foot_x += dot(g->foot_vx, elapsed.integral, order);
        m->foot_vx = dot(g->foot_vx, elapsed.power, order);
        m->vx += m->foot_vx;
    }
}

static inline lane_outcome step_standing(standing_member *m, choice live, bool slips, bool grazes, int order,
                                         double tolerance, ground_series *g) {
    lane_search search;
    lane_remainder remainder = {real_of(0.0), real_of(0.0)};
    const real start[GROUND_START_COUNT] = {m->x, m->y, m->vx, m->vy, m->foot_vx};
    expand_ground(&m->law, start, order, (ground_case){slips, grazes, true}, g);
    note_remainder(&remainder, g->normal_force, order - 1, m->frame.force_scale);
    note_remainder(&remainder, g->leg_force_x, order - 1, m->frame.force_scale);
    note_remainder(&remainder, g->foot_vx, order - 1, m->frame.speed_scale);
    const real longest = longest_ground_step(&m->law, slips || grazes, order);
    const real trusted = trusted_size(&remainder, longest, order - 1, tolerance);
    const real change = begin_search(&search, &m->now, &m->frame, trusted, g->length, g->speed_square, order,
                                     live, tolerance);
    watch_standing_leg(&search, m, g, order, change);
    if (grazes) {
        watch_graze(&search, m, g, order);
    } else {
        watch_lift_off(&search, m, g, order);
        watch_mid_stance(&search, m, g, order);
    }
    if (slips) {
        watch_slip(&search, m, g, order);
    } else if (!grazes) {
        watch_cone(&search, m, g, order);
    }
    march_up(&search);
    if (grazes) {
        search.is_root &= search.first != TDMF_GUARD_CLAMP;
    }
    const real end = smaller(search.time, search.size);
    const choice sticks = bits_of(slips || grazes ? 0 : -1);
    const choice too_stiff = sticks & opens_too_stiff(&m->now, &m->frame, longest);
    stand_on(m, g, order, slips, grazes, end);
    return move_on(&m->now, &m->frame, &search, too_stiff, end);
}

#endif
