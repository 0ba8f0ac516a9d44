/* Periodic gaits at Table 1 values in units m = k = l0 = 1: the five published ones without the clamp of
 * (12), which is the default, the same five with the clamp, and two more without it. They were computed
 * independently of this project, in extended precision; every digit but the last two is trusted (of event
 * times, 12). */
#ifndef TDMF_TESTS_REFERENCE_GAITS_H
#define TDMF_TESTS_REFERENCE_GAITS_H

#include "integrate.h"
#include "tdmf_slip/return_map.h"

typedef enum {
    TOUCHDOWN = 1,
    SLIP_VELOCITY_ZERO,
    SLIP_ONSET,
    MID_STANCE,
    LIFT_OFF_INTO_GRAZE,
    GRAZE_END,
    CLAMP_RELEASE,
    APEX,
    THRUST_BEGINS
} reference_event_kind;

typedef struct {
    reference_event_kind kind;
    double time; /* after the apex */
} reference_event;

typedef struct {
    double friction;
    bool swing_clamp;
    const char *word;
    double period, length, speed, work, cost_of_transport, liftoff_angle;
    double positive_work, slip_distance, stance_time; /* 0 with the clamp, where no reference states them */
    struct {
        double com_height, com_speed, leg_length, leg_angle, leg_length_rate, leg_angle_rate;
    } apex;
    reference_event events[12]; /* the unused ones are 0 */
    /* Jacobian of the return map, good to 3e-9; or 0. */
    double jacobian[TDMF_SECTION_COUNT][TDMF_SECTION_COUNT];
} reference_gait;

/* Indices of gaits: the default runner's gait, and its gait with the clamp. The published gaits come first:
 * five without the clamp, five with it, both in the order of falling friction. */
enum {
    DEFAULT_GAIT = 2,
    PUBLISHED_GAITS = 5,
    CLAMPED_GAIT = PUBLISHED_GAITS + DEFAULT_GAIT,
    REFERENCE_GAITS = 2 * PUBLISHED_GAITS + 2,
    EVERY_OTHER = 2 /* step of an expensive test: it keeps every word and both readings */
};

extern const reference_gait reference_gaits[REFERENCE_GAITS];

/* Table 1, with the clamp or without. */
tdmf_model table_1(bool swing_clamp);

tdmf_inputs inputs_at_friction(double friction);

/* A runner started at the apex of a reference gait. */
runner runner_at_reference_apex(const reference_gait *gait);

/* Asserts that the events come in the reference's order, each within a tolerance of its time. The release of
 * the clamp has a wider tolerance of its own. Returns the number of events. */
int assert_reference_events(const tdmf_event_log *log, const reference_event *expected, double tolerance);

/* Each of the section's coordinates within an absolute tolerance of the reference. */
void assert_reference_apex(tdmf_apex apex, const reference_gait *gait, double tolerance);

/* The last stride and the apex that it ended at, to a relative tolerance (the apex and the distance slipped:
 * absolute). */
void assert_reference_stride(const tdmf_motion *motion, const reference_gait *gait, double tolerance);

/* The return map's Jacobian at the gait's apex, where the reference has one. Returns whether it has. */
bool assert_reference_jacobian(const tdmf_return *stride, const reference_gait *gait);

#endif
