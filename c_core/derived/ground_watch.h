/* Derived from c_core/equations/events.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_GROUND_WATCH_H
#define TDMF_DERIVED_GROUND_WATCH_H

#include "ground_guards.h"

/* d + r cos theta', the height of the body over the ground: a fall. */
static inline void watch_body_down_on_ground(event_search *search, const ground_constants *c,
                                             const ground_series *s) {
    const guard_series g = {s->y, broadcast(1.0), s->y[0], search->order};
    const mask watching = search->live;
    if (any(watching)) {
        watch(search, TDMF_GUARD_BODY_DOWN, watching, &g, search->beyond_margin * c->mode.length_scale);
    }
}

/* r less the least length: a fall. */
static inline void watch_leg_too_short_on_ground(event_search *search, const ground_constants *c,
                                                 const ground_series *s, real length_change) {
    const guard_series g = {s->length, broadcast(1.0), s->length[0] - c->mode.guards.leg_min_length,
                            search->order};
    const mask watching = search->live & mask_not(g.start > length_change);
    if (any(watching)) {
        watch(search, TDMF_GUARD_LEG_TOO_SHORT, watching, &g, search->beyond_margin * c->mode.length_scale);
    }
}

/* -rdot, of a leg that has not been compressed most in this stance. */
static inline void watch_greatest_compression_on_ground(event_search *search, const ground_constants *c,
                                                        const ground_series *s) {
    const guard_series g = {s->length_rate, broadcast(-1.0), -s->length_rate[0], search->order - 1};
    const mask watching = search->live & (c->awaits_thrust > 0.0);
    if (any(watching)) {
        watch(search, TDMF_GUARD_GREATEST_COMPRESSION, watching, &g,
              search->beyond_margin * c->mode.speed_scale);
    }
}

/* sgn(v_t) v_t, the speed of a foot that slips. */
static inline void watch_slip_velocity_zero_on_ground(event_search *search, const ground_constants *c,
                                                      const ground_series *s) {
    const guard_series g = {s->foot_vx, c->slip_sign, c->slip_sign * s->foot_vx[0], search->order};
    const mask watching = search->live;
    if (any(watching)) {
        watch(search, TDMF_GUARD_SLIP_VELOCITY_ZERO, watching, &g,
              search->beyond_margin * c->mode.speed_scale);
    }
}

/* What ends a step, in the order of the table. */
static inline void watch_ground(event_search *search, const ground_constants *c, const ground_series *s,
                                const ground_coordinates *at, ground_case is, real length_change) {
    watch_body_down_on_ground(search, c, s);
    watch_leg_too_short_on_ground(search, c, s, length_change);
    if (is.grazes) {
        watch_graze(search, c, s, at->angle);
    }
    if (!is.grazes) {
        watch_greatest_compression_on_ground(search, c, s);
    }
    watch_mid_stance(search, c, s);
    if (!is.grazes) {
        watch_forces(search, c, s, !is.slips);
    }
    if (is.slips) {
        watch_slip_velocity_zero_on_ground(search, c, s);
    }
    search_pending(search);
}

#endif
