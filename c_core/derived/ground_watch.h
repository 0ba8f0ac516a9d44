/* Derived from c_core/equations/events.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_GROUND_WATCH_H
#define TDMF_DERIVED_GROUND_WATCH_H

#include "ground_guards.h"

/* What ends a step, in the order of the table. */
static inline void watch_ground(event_search *search, const ground_constants *c, const ground_series *s,
                                const ground_coordinates *at, ground_case is, real length_change) {
    /* d + r cos theta', the height of the body over the ground: a fall. */
    watch_series(search, TDMF_GUARD_BODY_DOWN, search->live, s->y, broadcast(1.0), s->y[0], search->order,
                 search->beyond_margin * c->mode.length_scale);
    /* r less the least length: a fall. */
    watch_series(search, TDMF_GUARD_LEG_TOO_SHORT,
                 search->live & mask_not(s->length[0] - c->mode.guards.leg_min_length > length_change),
                 s->length, broadcast(1.0), s->length[0] - c->mode.guards.leg_min_length, search->order,
                 search->beyond_margin * c->mode.length_scale);
    if (is.grazes) {
        watch_graze(search, c, s, at->angle);
    }
    if (!is.grazes) {
        /* -rdot, of a leg that has not been compressed most in this stance. */
        watch_series(search, TDMF_GUARD_GREATEST_COMPRESSION, search->live & (c->awaits_thrust > 0.0),
                     s->length_rate, broadcast(-1.0), -s->length_rate[0], search->order - 1,
                     search->beyond_margin * c->mode.speed_scale);
    }
    watch_mid_stance(search, c, s);
    if (!is.grazes) {
        watch_forces(search, c, s, !is.slips, !is.slips && is.meets_border);
    }
    if (is.slips) {
        /* sgn(v_t) v_t, the speed of a foot that slips. */
        watch_series(search, TDMF_GUARD_SLIP_VELOCITY_ZERO, search->live, s->foot_vx, c->slip_sign,
                     c->slip_sign * s->foot_vx[0], search->order,
                     search->beyond_margin * c->mode.speed_scale);
    }
    if (is.slips) {
        if (is.meets_border) {
            watch_patch_border(search, c, s, at);
        }
    }
    search_pending(search);
}

#endif
