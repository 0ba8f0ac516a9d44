/* Derived from c_core/equations/events.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_FLIGHT_WATCH_H
#define TDMF_DERIVED_FLIGHT_WATCH_H

#include "flight_guards.h"

/* What ends a step, in the order of the table. */
static inline void watch_flight(event_search *search, const flight_constants *c, const flight_series *s,
                                const ballistic *com, flight_case is, real length_change, double tolerance) {
    if (is.awaits_ground) {
        watch_new_ground(search, c, s, tolerance, com);
    }
    watch_heights(search, c, s, tolerance, s->length[0] + length_change, com);
    /* r less the least length: a fall. */
    watch_series(search, TDMF_GUARD_LEG_TOO_SHORT,
                 search->live & mask_not(s->length[0] - c->mode.guards.leg_min_length > length_change),
                 s->length, broadcast(1.0), s->length[0] - c->mode.guards.leg_min_length, search->order,
                 search->beyond_margin * c->mode.length_scale);
    watch_apex(search, c, com, is.rising);
    if (is.clamped) {
        watch_clamp(search, c, s);
    }
    search_pending(search);
}

#endif
