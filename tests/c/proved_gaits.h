/* The five published gaits with proved digits, by interval arithmetic and independently of this project: in a
 * box of radius 1e-32 around each apex there is exactly one fixed point of the stride map. */
#ifndef TDMF_TESTS_PROVED_GAITS_H
#define TDMF_TESTS_PROVED_GAITS_H

#include "tdmf_slip/automaton.h"
#include "tdmf_slip/return_map.h"

enum { PROVED_GAITS = 5, PROVED_EVENTS = 10 };

typedef struct {
    tdmf_guard guard;
    double time; /* after the apex */
} proved_event;

typedef struct {
    double friction, period, length;
    double apex[TDMF_SECTION_COUNT];
    int event_count;
    proved_event events[PROVED_EVENTS];
} proved_gait;

extern const proved_gait proved_gaits[PROVED_GAITS];

#endif
