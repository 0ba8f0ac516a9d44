/* Derived from c_core/equations/events.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_FLIGHT_WATCH_H
#define TDMF_DERIVED_FLIGHT_WATCH_H

#include "flight_guards.h"

/* r less the least length: a fall. */
static inline void watch_leg_too_short_in_flight(event_search *search, const flight_constants *c,
                                                 const flight_series *s, real length_change) {
    const guard_series g = {s->length, broadcast(1.0), s->length[0] - c->mode.guards.leg_min_length,
                            search->order};
    const mask watching = search->live & mask_not(g.start > length_change);
    if (any(watching)) {
        watch(search, TDMF_GUARD_LEG_TOO_SHORT, watching, &g, search->beyond_margin * c->mode.length_scale);
    }
}

/* What ends a step, in the order of the table. */
static inline void watch_flight(event_search *search, const flight_constants *c, const flight_series *s,
                                const ballistic *com, flight_case is, real length_change, double tolerance) {
    if (is.awaits_ground) {
        watch_new_ground(search, c, s, tolerance, com);
    }
    watch_heights(search, c, s, tolerance, s->length[0] + length_change, com);
    watch_leg_too_short_in_flight(search, c, s, length_change);
    watch_apex(search, c, com, is.rising);
    if (is.retracts) {
        watch_clamp(search, c, s);
    }
    search_pending(search);
}

#endif
