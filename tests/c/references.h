/* Reference values beside the published gaits, by programs that share nothing with the library. */
#ifndef TDMF_TESTS_REFERENCES_H
#define TDMF_TESTS_REFERENCES_H

#include "reference_gaits.h"
#include "tdmf_slip/automaton.h"

/* ---- proved gaits -------------------------------------------------------------------------------------- */

/* The five published gaits with proved digits, by interval arithmetic and independently of this project: in a
 * box of radius 1e-32 around each apex there is exactly one fixed point of the stride map. */

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

/* ---- strides in extended precision --------------------------------------------------------------------- */

/* Single strides from stated apices, integrated with 30 digits by a program that shares nothing with the
 * library, tests/extended_precision. Body mass and free length are 1, what is not stated is Table
 * 1's. Each start is integrated with the clamp of the swing and without it. */

enum { EXTENDED_STRIDES = 18 };

typedef struct {
    double gravity, friction, stiffness, damping, stance_torque, kp, kd;
    bool swing_clamp;
    double start[TDMF_SECTION_COUNT];
    int apex_count; /* coordinates of the apex that are known: all, or those of the centre of mass */
    double apex[TDMF_SECTION_COUNT];
    int event_count;
    proved_event events[PROVED_EVENTS]; /* the last is the apex */
} extended_stride;

extern const extended_stride extended_strides[EXTENDED_STRIDES];

static inline tdmf_parameters parameters_of_stride(const extended_stride *stride) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.gravity = stride->gravity;
    parameters.leg.stiffness = stride->stiffness;
    parameters.leg.damping = stride->damping;
    parameters.hip.stance_torque = stride->stance_torque;
    parameters.hip.kp = stride->kp;
    parameters.hip.kd = stride->kd;
    parameters.hip.swing_clamp = stride->swing_clamp;
    return parameters;
}

/* ---- gaits beyond the paper ---------------------------------------------------------------------------- */

/* Periodic gaits of runners that go beyond the paper: on slopes, with swing-leg retraction, with a static
 * friction larger than the sliding one, also where friction falls with speed, with a thrust of the leg, and
 * pushed by a force; all else is as in Table 1. The swing is clamped.
 * They were computed independently of this project, in extended precision, and are good to 1e-12; their
 * Jacobians, by differences, to 3e-9. */

typedef struct {
    double slope, touchdown_angle; /* degrees */
    double retraction_rate, static_friction_ratio, stribeck_velocity;
    double thrust;
    double external_fx, external_fy;
    reference_gait gait; /* its work is that of hip and leg */
    double rise, leg_work, external_work;
    double damper_loss, friction_loss, impact_loss; /* per stride */
} further_gait;

enum { FURTHER_GAITS = 28 };

extern const further_gait further_gaits[FURTHER_GAITS];

tdmf_parameters parameters_of_further_gait(const further_gait *further);
tdmf_inputs inputs_of_further_gait(const further_gait *further);

/* A runner started at the gait's apex. */
runner runner_at_further_apex(const further_gait *further);

/* ---- a swing without the clamp ------------------------------------------------------------------------- */

/* The runner without the clamp of (12): borders between words, and single strides of random runners. Two
 * independent programs agree on them, to 1e-9 at the least; the digits are those of one in extended
 * precision. */

/* A border between gait words: `above` at larger friction, `below` at smaller. */
typedef struct {
    double friction;
    const char *above, *below;
} free_border;

/* A stride of a runner from an apex. All other parameters have the values of Table 1. */
typedef struct {
    double friction, body_mass, foot_mass, stiffness, damping, free_length, gravity;
    double stance_torque, touchdown_angle, kp, kd, liftoff_angle_factor;
    double start[TDMF_SECTION_COUNT], end[TDMF_SECTION_COUNT];
    const char *word;
    double period, length, work;
    int touchdowns;
} free_stride;

enum { FREE_BORDERS = 5, FREE_STRIDES = 40 };

extern const free_border free_borders[FREE_BORDERS];
extern const free_stride free_strides[FREE_STRIDES];

/* The runner of a stride, with the clamp or without. */
tdmf_model model_of_free_stride(const free_stride *stride, bool swing_clamp);

/* ---- runs over a patch --------------------------------------------------------------------------------- */

/* Runs over a patch of ground, and two without one, by an independent program in extended precision. */

enum { PATCH_RUNS = 9, MAX_STRIDES_OF_RUN = 9, MAX_CROSSINGS = 3 };

typedef struct {
    double friction, static_friction_ratio, stribeck_velocity, slope; /* a ratio of 0: 1 */
    double begin, end, patch_friction;
    double start[TDMF_SECTION_COUNT]; /* with the foot at x = 0 */
    int strides;
    const char *words[MAX_STRIDES_OF_RUN];
    double end_apex[TDMF_SECTION_COUNT], end_foot_x, end_time;
    double first_apex[TDMF_SECTION_COUNT], first_foot_x; /* after one stride, if reported */
    int crossings;
    double crossing_times[MAX_CROSSINGS];
    struct {
        double period, speed, cost_of_transport, slip_distance, friction_loss;
    } last;                                              /* last stride, if reported */
    double fall_time, fall_state[TDMF_MECHANICAL_COUNT]; /* the fall after it */
} patch_run;

extern const patch_run patch_runs[PATCH_RUNS];

tdmf_parameters parameters_of_patch_run(const patch_run *run);
tdmf_inputs inputs_of_patch_run(const patch_run *run);

/* ---- gaits of the reduced map -------------------------------------------------------------------------- */

/* Fixed points of the reduced map in units m = k = l0 = 1, the rest from Table 1. They were computed
 * independently of this project, in extended precision: values to 1e-12, eigenvalues to 1e-9. */

typedef struct {
    double friction, touchdown_angle;                     /* degrees */
    double retraction_rate, static_friction_ratio, slope; /* slope in degrees */
    const char *word;
    double apex[TDMF_REDUCED_COUNT];
    double period, length, speed;
    double eigenvalues[TDMF_REDUCED_COUNT];
    double work;
} reduced_gait;

enum { REDUCED_GAITS = 9 };

extern const reduced_gait reduced_gaits[REDUCED_GAITS];

/* Its parameters and friction. */
tdmf_parameters parameters_of_reduced_gait(const reduced_gait *gait);
tdmf_inputs inputs_of_reduced_gait(const reduced_gait *gait);

#endif
