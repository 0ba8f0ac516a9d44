/* A motion at an instant, on the runner's page: every public function of an instant reads it. */
#ifndef TDMF_RUNNER_MOTION_INSTANT_H
#define TDMF_RUNNER_MOTION_INSTANT_H

#include "page_exchange.h"
#include "page_motion.h"
#include "page_places.h"

/* Memory for an instant of the runner's page, which a test checks. */
enum { TDMF_INSTANT_MEMORY = 2944 };

typedef struct {
    tdmf_page_point point;
    unsigned char watch[EVENT_COUNT]; /* a watch_state for each event */
    tdmf_page_instant at;
    double outputs[OUTPUT_COUNT]; /* written by tdmf_write_outputs */
    double memory[TDMF_INSTANT_MEMORY];
} tdmf_motion_instant;

/* The instant of a mode and a state. */
void tdmf_begin_instant(tdmf_motion_instant *instant, tdmf_system system, const tdmf_mode *mode,
                        const double state[TDMF_STATE_COUNT]);

/* The instant of a point of the page, where its guards are seen for the first time. */
void tdmf_begin_instant_of_point(tdmf_motion_instant *instant, const tdmf_page_point *point);

/* Writes the outputs of the page. Heights are above the ground line, like all heights of the page. */
void tdmf_write_outputs(tdmf_motion_instant *instant);

/* The value, in N, and the rate, N/s, of the normal force, or of the vertical force, of a loaded foot. */
typedef struct {
    double force, rate;
} tdmf_observed_force;

tdmf_observed_force tdmf_normal_force_at(const tdmf_motion_instant *instant);
tdmf_observed_force tdmf_vertical_force_at(const tdmf_motion_instant *instant);

/* Writes the guards that an instant watches; others are 1. */
void tdmf_write_guards(const tdmf_motion_instant *instant, const tdmf_mode *mode,
                       double guards[TDMF_GUARD_COUNT]);

#endif
