/* The events of a leg that stands. */
#ifndef TDMF_KERNEL_GROUND_GUARDS_H
#define TDMF_KERNEL_GROUND_GUARDS_H

#include "event_search.h"
#include "graze_guards.h"
#include "ground_step.h"
#include "guard_series.h"

static inline void watch_standing_leg(event_search *search, const ground_constants *c, const ground_series *g,
                                      real length_change) {
    const guard_series body = {g->y, real_of(1.0), g->y[0], search->order};
    watch(search, TDMF_GUARD_BODY_DOWN, search->live, &body, search->beyond_margin * c->mode.length_scale);
    watch_length(search, &c->mode, g->length, search->order, length_change);
}

/* theta, by the body's place over the foot, seen along the vertical. */
static inline void watch_mid_stance(event_search *search, const ground_constants *c, const ground_series *g) {
    const choice drives = c->drives > 0.0;
    const real floor = 2.0 * search->beyond_margin * g->length[0];
    real ahead_of_foot[SERIES_TERMS];
    if (!any(drives)) {
        return;
    }
    if (any(not(c->slope_sine == 0.0))) {
        expand_ahead(g->x, g->y, c->slope_sine, c->slope_cosine, search->order, ahead_of_foot);
        const guard_series ahead = {ahead_of_foot, real_of(1.0), ahead_of_foot[0], search->order};
        watch(search, TDMF_GUARD_MID_STANCE, drives, &ahead, floor);
    } else {
        const guard_series ahead = {g->x, real_of(-1.0), -g->x[0], search->order};
        watch(search, TDMF_GUARD_MID_STANCE, drives, &ahead, floor);
    }
}

/* The leg's length stops falling. */
static inline void watch_greatest_compression(event_search *search, const ground_constants *c,
                                              const ground_series *g) {
    const choice awaits = c->awaits_thrust > 0.0;
    const guard_series shortening = {g->length_rate, real_of(-1.0), -g->length_rate[0], search->order - 1};
    if (any(awaits)) {
        watch(search, TDMF_GUARD_GREATEST_COMPRESSION, awaits, &shortening,
              search->beyond_margin * c->mode.speed_scale);
    }
}

/* One edge of the friction cone: mu f_n + sign f_t. */
static inline void watch_edge(event_search *search, const ground_constants *c, const ground_series *g,
                              double sign, choice near) {
    const int order = search->order - 1;
    real room[SERIES_TERMS];
    expand_room(g->normal_force, g->tangential_push, c->cone_normal, c->cone_normal_rate, c->cone_tangential,
                real_of(sign), order, room);
    const guard_series edge = {room, real_of(1.0), room[0], order};
    watch(search, sign > 0.0 ? TDMF_GUARD_SLIP_ONSET_POSITIVE : TDMF_GUARD_SLIP_ONSET_NEGATIVE, near, &edge,
          search->beyond_margin * c->mode.force_scale);
}

/* Lift-off and the cone, by partial sums of the forces: see event_search.h. Both edges of the cone are as
 * near as the nearer. */
static inline void watch_forces(event_search *search, const ground_constants *c, const ground_series *g,
                                bool sticks) {
    const int order = search->order - 1;
    real normal = g->normal_force[0], tangential = g->tangential_push[0];
    real least_normal = normal;
    real least_room = c->cone_normal * normal - c->cone_tangential * real_abs(tangential);
    for (int k = 1; k <= order; ++k) {
        const real before = normal;
        normal += g->normal_force[k] * search->power[k];
        least_normal = smaller(least_normal, normal);
        if (sticks) {
            tangential += g->tangential_push[k] * search->power[k];
            real room = c->cone_normal * normal - c->cone_tangential * real_abs(tangential);
            if (INPUTS_RAMP) {
                room += c->cone_normal_rate * search->size * before;
            }
            least_room = smaller(least_room, room);
        }
    }
    const choice may_lift = search->live & not(least_normal > 0.0);
    if (any(may_lift)) {
        const guard_series force = {g->normal_force, real_of(1.0), g->normal_force[0], order};
        search_closer(search, TDMF_GUARD_LIFT_OFF, may_lift, &force,
                      search->beyond_margin * c->mode.force_scale);
    }
    const choice may_slip = search->live & not(least_room > 0.0);
    if (sticks && any(may_slip)) {
        watch_edge(search, c, g, 1.0, may_slip);
        watch_edge(search, c, g, -1.0, may_slip);
    }
}

static inline void watch_slip(event_search *search, const ground_constants *c, const ground_series *g) {
    const guard_series speed = {g->foot_vx, c->slip_sign, c->slip_sign * g->foot_vx[0], search->order};
    watch(search, TDMF_GUARD_SLIP_VELOCITY_ZERO, search->live, &speed,
          search->beyond_margin * c->mode.speed_scale);
}

static inline void watch_ground(event_search *search, const ground_constants *c, const ground_series *g,
                                const ground_coordinates *at, ground_case is, real length_change) {
    watch_standing_leg(search, c, g, length_change);
    watch_mid_stance(search, c, g);
    if (is.grazes) {
        watch_graze(search, c, g, at->angle);
    } else {
        watch_forces(search, c, g, !is.slips);
        watch_greatest_compression(search, c, g);
    }
    if (is.slips) {
        watch_slip(search, c, g);
    }
    search_pending(search);
}

#endif
