/* The native solver: takes a run from one time to another, event by event.
 *
 *     tdmf_solver solver = tdmf_solver_default();
 *     while (tdmf_native_advance(&solver, system, NULL, motion.time + 0.01, &motion) == TDMF_ARRIVED)
 *         draw(&motion);
 *
 * The solver expands the motion in each contact mode into Taylor series. The tolerance decides the length
 * and the order of a step. Guards are polynomials in time; the search for their first root cannot jump over
 * one. Nothing is allocated and nothing is kept between calls, so you may copy a solver like any value.
 */
#ifndef TDMF_SLIP_SOLVER_H
#define TDMF_SLIP_SOLVER_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/motion.h"
#include "tdmf_slip/parameters.h"

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* An event that the solver has located and taken. */
typedef struct {
    double time;                    /* s */
    int guard;                      /* the tdmf_guard that fired */
    tdmf_mode before, after;        /* the mode that it ended, and the one that it began */
    double state[TDMF_STATE_COUNT]; /* before */
} tdmf_event;

/* A log of events. Events beyond its capacity are only counted. */
enum { TDMF_EVENT_CAPACITY = 32 };
typedef struct {
    int count; /* number of events, also of those not logged; set it to 0 first */
    tdmf_event events[TDMF_EVENT_CAPACITY]; /* the first events, in order */
} tdmf_event_log;

/* Default limits of one call of a solver. A typical stride takes some 50 steps. An event ends its step, so a
 * limit of steps also bounds events.
 *
 * Strides that settle on a gait, or that one runner of an ensemble makes, share their steps. The first stride
 * may take step_limit steps. Each later stride may take the steps left over and step_limit / TDMF_STEP_SHARE
 * more, but never more than step_limit. All strides of Newton's method together may take step_limit steps. */
enum { TDMF_STEP_LIMIT = 200000, TDMF_EVENT_LIMIT = 100000, TDMF_STEP_SHARE = 40 };

/* Settings of the native solver, and its counters. */
typedef struct {
    double relative_tolerance; /* tolerance of a step, in the runner's scales; above 0 and below 1 */
    long step_limit;           /* steps in one call; see TDMF_STEP_LIMIT */
    long event_limit;          /* events in one call, and in each stride of several */
    tdmf_event_log *log;       /* log of events; or NULL */
    /* Called for each event, with `subject`, right after it was taken; or NULL. */
    void (*on_event)(void *subject, const tdmf_event *event);
    void *subject;
    /* Saves time by not observing the hip's positive work and the peaks of the ground force, on which nothing
     * else depends. They stay as they are. Ignored if derivatives are computed. */
    bool without_peaks_and_positive_work;
    tdmf_refusal refusal; /* why the last call was refused, if it was */
    /* Work done so far. */
    int64_t steps, events;
    int64_t strides;     /* strides closed; of the reduced map, stances */
    int64_t evaluations; /* evaluations of the right-hand side, or of a coefficient of its series */
    int64_t layer_steps; /* steps at slip speeds at which friction falls with speed */
} tdmf_solver;

/* The native solver gives up a stiff runner: one that needs more steps than this within sqrt(m/k). In flight
 * and in stick the coefficients of the first step tell; elsewhere the steps are counted. CVODE takes stiff
 * runners. */
enum { TDMF_STIFFNESS_LIMIT = 10000 };

/* Outcome of a solver's call. */
typedef enum {
    TDMF_ARRIVED,         /* the run stands at the time asked for */
    TDMF_FELL,            /* the runner fell, and the motion is frozen there */
    TDMF_TOO_STIFF,       /* the native solver gave up: see TDMF_STIFFNESS_LIMIT */
    TDMF_TOO_MANY_STEPS,  /* the step limit was reached */
    TDMF_TOO_MANY_EVENTS, /* the event limit was reached */
    TDMF_NO_PROGRESS,     /* no step, however short, has a finite result */
    TDMF_REFUSED          /* nothing was done: solver->refusal says why */
} tdmf_outcome;

/* Returns the default solver: tolerance 1e-11, and limits that no call of up to a thousand strides reaches.
 */
TDMF_API tdmf_solver tdmf_solver_default(void);

/* Integrates `motion` up to the time `until` and takes every event on the way. The system's inputs are those
 * at motion->time. `rates` says how fast they change; NULL means that they are held. Whatever the outcome,
 * the motion is valid and stands where the solver got to. A fallen run stays as it is.
 *
 * A request is refused, with the motion untouched and the reason in solver->refusal, for
 *
 *   - a tolerance out of range, and inputs that are out of range or leave it by their rates;
 *   - rates that are not finite, and a rate other than 0 of an input that changes at events only;
 *   - a time that is NaN or before the present one, and a number of the motion that is not finite;
 *   - a contact or phase that is invalid, and two that exclude each other;
 *   - a log that counts less than 0, and any pointer other than `rates` that is NULL. */
TDMF_API tdmf_outcome tdmf_native_advance(tdmf_solver *solver, tdmf_system system, const tdmf_inputs *rates,
                                          double until, tdmf_motion *motion);

/* Outcome of the integration of a stride. */
typedef struct {
    tdmf_outcome outcome; /* TDMF_ARRIVED: the run stands at `until`, or where the stride closed */
    bool closed;          /* the stride has closed; tdmf_outputs_of has its quantities */
} tdmf_stride_outcome;

/* Integrates until one more stride has closed, but not beyond the time `until`. Inputs are held. */
TDMF_API tdmf_stride_outcome tdmf_native_stride(tdmf_solver *solver, tdmf_system system, double until,
                                                tdmf_motion *motion);

/* The largest number of directions along which a stride is differentiated. */
enum { TDMF_VARIATION_LIMIT = 8 };

/* Returns an outcome in words, a static string. */
TDMF_API const char *tdmf_outcome_text(tdmf_outcome outcome);

#ifdef __cplusplus
}
#endif
#endif
