/* Periodic gaits at Table 1 values in units m = k = l0 = 1, with the clamp of (12). They were computed
 * independently of this project, in extended precision; every digit but the last two is trusted (of event
 * times, all 13). */
#ifndef TDMF_TESTS_REFERENCE_GAITS_H
#define TDMF_TESTS_REFERENCE_GAITS_H

#include "integrate.h"
#include "tdmf_slip/solver.h"

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
    const char *word;
    double period, length, speed, work, cost_of_transport, liftoff_angle;
    struct {
        double com_height, com_speed, leg_length, leg_angle, leg_length_rate, leg_angle_rate;
    } apex;
    reference_event events[12]; /* the unused ones are 0 */
} reference_gait;

enum { REFERENCE_GAITS = 5 };

extern const reference_gait reference_gaits[REFERENCE_GAITS];

/* A runner started at the apex of a reference gait. */
runner runner_at_reference_apex(const reference_gait *gait);

/* Asserts that the events come in the reference's order, each within a tolerance of its time. The release of
 * the clamp has a wider tolerance of its own. Returns the number of events. */
int assert_reference_events(const tdmf_event_log *log, const reference_event *expected, double tolerance);

/* Each of the section's coordinates within an absolute tolerance of the reference. */
void assert_reference_apex(const tdmf_apex *apex, const reference_gait *gait, double tolerance);

#endif
