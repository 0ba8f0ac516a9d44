/* Events of a leg that stands that take more than a series; derived/ground_watch.h has them all. */
#ifndef TDMF_KERNEL_GROUND_GUARDS_H
#define TDMF_KERNEL_GROUND_GUARDS_H

#include "event_search.h"
#include "graze_guards.h"
#include "ground_step.h"
#include "guard_series.h"

/* Watches theta by where the body is over the foot, seen along the vertical. */
static inline void watch_mid_stance(event_search *search, const ground_constants *c, const ground_series *g) {
    const mask drives = c->drives > 0.0;
    const real floor = 2.0 * search->beyond_margin * g->length[0];
    real ahead_of_foot[SERIES_TERMS];
    if (!any(drives)) {
        return;
    }
    if (any(mask_not(c->slope_sine == 0.0))) {
        expand_ahead(g->x, g->y, c->slope_sine, c->slope_cosine, search->order, ahead_of_foot);
        const guard_series ahead = {ahead_of_foot, broadcast(1.0), ahead_of_foot[0], search->order};
        watch(search, TDMF_GUARD_MID_STANCE, drives, &ahead, floor);
    } else {
        const guard_series ahead = {g->x, broadcast(-1.0), -g->x[0], search->order};
        watch(search, TDMF_GUARD_MID_STANCE, drives, &ahead, floor);
    }
}

/* How far a foot that slips is from the border ahead, along the line; its velocity integrated. */
static inline void watch_patch_border(event_search *search, const ground_constants *c, const ground_series *g,
                                      const ground_coordinates *at) {
    const real start = c->slip_sign * (c->border.ahead - at->foot_x);
    real distance[SERIES_TERMS];
    distance[0] = start;
    for (int k = 1; k <= search->order; ++k) {
        distance[k] = -c->slip_sign * g->foot_vx[k - 1] * series_reciprocal[k];
    }
    const guard_series border = {distance, broadcast(1.0), start, search->order};
    watch(search, TDMF_GUARD_PATCH_BORDER, search->live, &border,
          search->beyond_margin * c->mode.length_scale);
}

/* Watches one edge of the friction cone. */
static inline void watch_edge(event_search *search, const ground_constants *c, const ground_series *g,
                              const friction_cone *cone, double sign, mask near) {
    const int order = search->order - 1;
    real room[SERIES_TERMS];
    expand_room(g->normal_force, g->tangential_push, cone, broadcast(sign), order, room);
    const guard_series edge = {room, broadcast(1.0), room[0], order};
    watch(search, sign > 0.0 ? TDMF_GUARD_SLIP_ONSET_POSITIVE : TDMF_GUARD_SLIP_ONSET_NEGATIVE, near, &edge,
          search->beyond_margin * c->mode.force_scale);
}

/* What is left in the cone, and on a border in both. */
static inline real smallest_room(const ground_constants *c, bool on_border, real normal, real drifted,
                                 real tangential) {
    const real room = tdmf_smallest_room(&c->cone, normal, drifted, tangential);
    return on_border ? real_min(room, tdmf_smallest_room(&c->border.cone, normal, drifted, tangential))
                     : room;
}

/* Lift-off and the cone, by partial sums of the forces: see event_search.h. Both edges of the cone are as
 * near as the nearer. */
static inline void watch_forces(event_search *search, const ground_constants *c, const ground_series *g,
                                bool sticks, bool on_border) {
    const int order = search->order - 1;
    real normal = g->normal_force[0], tangential = g->tangential_push[0];
    real min_normal = normal;
    real min_room = smallest_room(c, on_border, normal, broadcast(0.0), tangential);
    for (int k = 1; k <= order; ++k) {
        const real drifted = INPUTS_RAMP ? search->size * normal : broadcast(0.0);
        normal += g->normal_force[k] * search->power[k];
        min_normal = real_min(min_normal, normal);
        if (sticks) {
            tangential += g->tangential_push[k] * search->power[k];
            min_room = real_min(min_room, smallest_room(c, on_border, normal, drifted, tangential));
        }
    }
    const mask may_lift = search->live & mask_not(min_normal > 0.0);
    if (any(may_lift)) {
        const guard_series force = {g->normal_force, broadcast(1.0), g->normal_force[0], order};
        search_closer(search, TDMF_GUARD_LIFT_OFF, may_lift, &force,
                      search->beyond_margin * c->mode.force_scale);
    }
    const mask may_slip = search->live & mask_not(min_room > 0.0);
    if (sticks && any(may_slip)) {
        watch_edge(search, c, g, &c->cone, 1.0, may_slip);
        watch_edge(search, c, g, on_border ? &c->border.cone : &c->cone, -1.0, may_slip);
    }
}

#endif
