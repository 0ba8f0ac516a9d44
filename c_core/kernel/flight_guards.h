/* Events of flight that take more than a series; derived/flight_watch.h has them all. */
#ifndef TDMF_KERNEL_FLIGHT_GUARDS_H
#define TDMF_KERNEL_FLIGHT_GUARDS_H

#include "event_search.h"
#include "flight_step.h"
#include "guard_series.h"

/* The centre of mass is lowest at an end of the step, or not as low as this where it is pushed up. */
static inline real lowest_center_of_mass(const event_search *search, const flight_constants *c,
                                         const ballistic *com) {
    const real t = search->size;
    const real gravity = real_max(c->normal_gravity, broadcast(0.0));
    real rate = com->ground.rate - 0.5 * gravity * t;
    if (INPUTS_RAMP) {
        rate -= real_abs(com->normal_jerk) * t * t * (1.0 / 6);
    }
    return real_min(com->ground.height, com->ground.height + t * rate);
}

/* How far the ends of the leg are below the centre of mass. */
typedef struct {
    real foot, body;
} leg_drops;

/* No end drops further than that of the longest leg at the angle that brings it nearest to the ground's
 * normal. */
static inline leg_drops max_drops(const event_search *search, const flight_constants *c,
                                  const flight_series *f, real longest, real sine, real cosine) {
    const real rotation = largest_deviation(search, f->angle, search->order);
    const real change = rotation * (real_abs(sine) + 0.5 * rotation);
    const real down = c->body_share * longest * real_min(cosine + change, broadcast(1.0));
    const real up = (1.0 - c->body_share) * longest * real_min(change - cosine, broadcast(1.0));
    const leg_drops drops = {real_max(down, broadcast(0.0)), real_max(up, broadcast(0.0))};
    return drops;
}

/* A leg that spins at a steady rate has long steps, and a drop that is not. */
static inline void trust_drop(event_search *search, const flight_constants *c, const real *drop,
                              double tolerance, mask lanes) {
    series_remainder remainder = {broadcast(0.0), broadcast(0.0)};
    add_to_remainder(&remainder, drop, search->order, c->mode.length_scale);
    const real trusted = trusted_size(&remainder, broadcast(INFINITY), search->order, broadcast(tolerance));
    record_end(search, lanes, trusted / search->size, integer_of(KINK));
}

/* The height of an end of the leg: a parabola and a share of the leg's drop. */
static inline void watch_height(event_search *search, int guard, mask low, const flight_constants *c,
                                const real *drop, real share, const ballistic *com) {
    const int order = search->order;
    real height[SERIES_TERMS];
    if (!any(low)) {
        return;
    }
    for (int k = 1; k <= order; ++k) {
        height[k] = share * drop[k];
    }
    height[1] += com->ground.rate;
    height[2] -= 0.5 * c->normal_gravity;
    if (INPUTS_RAMP) {
        height[3] += com->normal_jerk * (1.0 / 6);
    }
    const guard_series g = {height, broadcast(1.0), com->ground.height + share * drop[0], order};
    watch(search, guard, low, &g, search->beyond_margin * c->mode.length_scale);
}

/* The heights of foot and body. Mostly one of them is seen to be out of reach. */
static inline void watch_heights(event_search *search, const flight_constants *c, const flight_series *f,
                                 double tolerance, real longest, const ballistic *com) {
    const real lowest = lowest_center_of_mass(search, c, com);
    const mask low = search->live & mask_not(lowest > longest * real_max(c->body_share, 1.0 - c->body_share));
    real sine, cosine, drop[SERIES_TERMS];
    if (!any(low)) {
        return;
    }
    sine_and_cosine(f->angle[0] - c->slope, &sine, &cosine);
    const leg_drops drops = max_drops(search, c, f, longest, sine, cosine);
    const mask foot_is_low = low & mask_not(lowest > drops.foot);
    const mask body_is_low = low & mask_not(lowest > drops.body);
    if (!any(foot_is_low | body_is_low)) {
        return;
    }
    expand_drop(f->length, f->angle, c->slope, f->angle_rate, search->order, drop);
    trust_drop(search, c, drop, tolerance, foot_is_low | body_is_low);
    watch_height(search, TDMF_GUARD_TOUCHDOWN, foot_is_low, c, drop, -c->body_share, com);
    watch_height(search, TDMF_GUARD_BODY_DOWN, body_is_low, c, drop, 1.0 - c->body_share, com);
}

/* The foot comes up from below a ground that waits for that. */
static inline void watch_new_ground(event_search *search, const flight_constants *c, const flight_series *f,
                                    double tolerance, const ballistic *com) {
    real drop[SERIES_TERMS], depth[SERIES_TERMS];
    expand_drop(f->length, f->angle, c->new_slope, f->angle_rate, search->order, drop);
    trust_drop(search, c, drop, tolerance, search->live);
    depth[1] = c->body_share * drop[1] - com->new_ground.rate;
    for (int k = 2; k <= search->order; ++k) {
        depth[k] = c->body_share * drop[k];
    }
    depth[2] += 0.5 * c->new_normal_gravity;
    if (INPUTS_RAMP) {
        depth[3] -= com->new_normal_jerk * (1.0 / 6);
    }
    const guard_series g = {depth, broadcast(1.0), c->body_share * drop[0] - com->new_ground.height,
                            search->order};
    watch(search, TDMF_GUARD_NEW_GROUND, search->live, &g, search->beyond_margin * c->mode.length_scale);
}

/* The centre of mass rises at a rate that falls by g, unless it is pushed up. */
static inline void watch_apex_in_flight(event_search *search, const flight_constants *c,
                                        const ballistic *com) {
    const real gravity = c->mode.gravity;
    const real time = real_max(com->rise_rate, broadcast(0.0)) / (gravity * search->size);
    record_end(search, search->live & (gravity > 0.0) & (time <= 1.0), time, integer_of(TDMF_GUARD_APEX));
}

/* The same where the push on the body ramps; until the centre of mass rises, for a kink where it begins to.
 */
static inline void watch_ramped_apex(event_search *search, const flight_constants *c, const ballistic *com,
                                     bool rising) {
    real rate[SERIES_TERMS];
    rate[1] = -c->mode.gravity;
    rate[2] = 0.5 * com->rise_jerk;
    const guard_series rise = {rate, broadcast(rising ? 1.0 : -1.0),
                               rising ? com->rise_rate : -com->rise_rate, 2};
    watch(search, rising ? TDMF_GUARD_APEX : KINK, search->live, &rise,
          (rising ? search->beyond_margin : broadcast(TDMF_BEYOND_DEAD_BAND)) * c->mode.speed_scale);
}

/* What the clamp is decided by. */
static inline void watch_clamp(event_search *search, const flight_constants *c, const flight_series *f) {
    const int order = search->order - 1;
    real torque[SERIES_TERMS];
    expand_torque(&c->servo, f->angle, f->angle_rate, order, torque);
    const guard_series g = {torque, broadcast(1.0), torque[0], order};
    watch(search, TDMF_GUARD_CLAMP, search->live, &g,
          TDMF_BEYOND_DEAD_BAND * c->mode.margin_factor * c->mode.energy_scale);
}

static inline void watch_apex(event_search *search, const flight_constants *c, const ballistic *com,
                              bool rising) {
    if (INPUTS_RAMP && any(mask_not(com->rise_jerk == 0.0))) {
        watch_ramped_apex(search, c, com, rising);
    } else if (rising) {
        watch_apex_in_flight(search, c, com);
    }
}

#endif
