/* The native solver: takes a run from one time to another, event by event.
 *
 * The motion of each contact mode is expanded into Taylor series, as long and of as high an order as the
 * tolerance asks for; guards are polynomials in time, whose first root is found by a search that cannot
 * jump over one. Nothing is allocated and nothing is kept between calls, so that a solver may be copied like
 * any value.
 */
#ifndef TDMF_SLIP_SOLVER_H
#define TDMF_SLIP_SOLVER_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/motion.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/variation.h"

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

/* Log of events. Those beyond its capacity are only counted. */
enum { TDMF_EVENT_CAPACITY = 32 };
typedef struct {
    int count;                              /* of all events, noted or not; 0 to begin with */
    tdmf_event events[TDMF_EVENT_CAPACITY]; /* the first ones, in order */
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
    double relative_tolerance; /* of a step, in the runner's scales; above 0 and below 1 */
    long step_limit;           /* steps in one call; see TDMF_STEP_LIMIT */
    long event_limit;          /* events in one call, and in each stride of several */
    tdmf_event_log *log;       /* or NULL */
    /* Called for each event, with `subject`, right after it was taken; or NULL. */
    void (*on_event)(void *subject, const tdmf_event *event);
    void *subject;
    /* Leaves out of the record what nothing else depends on: the hip's positive work and the peaks of the
     * ground force, which stay as they are. Not so where variations are carried along. */
    bool without_peaks_and_positive_work;
    tdmf_refusal refusal; /* why the last call was refused, if it was */
    /* Work done so far. */
    int64_t steps, events;
    int64_t strides;     /* closed; of the reduced map stances */
    int64_t evaluations; /* of the right-hand side, or of a coefficient of its series */
    int64_t layer_steps; /* of the steps, those in the layer where friction falls with speed */
} tdmf_solver;

/* The native solver gives up a runner that takes more steps than this within sqrt(m/k): at once where its
 * coefficients say so in flight or in stick, where runners spend their time, else when the steps are made.
 * CVODE is made for such runners. */
enum { TDMF_STIFFNESS_LIMIT = 10000 };

/* Tells how a call of a solver ended. */
typedef enum {
    TDMF_ARRIVED,         /* at the time asked for */
    TDMF_FELL,            /* at the fall; the motion stays there */
    TDMF_TOO_STIFF,       /* for the native solver: see TDMF_STIFFNESS_LIMIT */
    TDMF_TOO_MANY_STEPS,  /* the step limit was reached */
    TDMF_TOO_MANY_EVENTS, /* the event limit was reached */
    TDMF_NO_PROGRESS,     /* no step, however short, has a finite result */
    TDMF_REFUSED          /* not begun: see tdmf_native_advance */
} tdmf_outcome;

/* Default tolerance 1e-11, and limits that no call over a thousand strides reaches. */
TDMF_API tdmf_solver tdmf_solver_default(void);

/* Integrates `motion` up to `until`, taking every event on the way. `inputs` are those at motion->time,
 * `rates` how fast they change, NULL where they are held. On every outcome the motion is valid and stands
 * where the solver got to. A fallen run stays as it is. Refused, with nothing touched, are
 *
 *   - a tolerance out of range, and inputs that are out of range or leave it by their rates;
 *   - rates that are not finite, and a rate other than 0 of an input that changes at events only;
 *   - a time that is NaN or before the present one, and a state that is not finite;
 *   - a contact or phase that is invalid, and two that exclude each other;
 *   - a log that counts less than 0, and any pointer other than `rates` that is NULL. */
TDMF_API tdmf_outcome tdmf_native_advance(tdmf_solver *solver, tdmf_system system, const tdmf_inputs *rates,
                                          double until, tdmf_motion *motion);

/* Tells how the integration of a stride ended. */
typedef struct {
    tdmf_outcome outcome; /* TDMF_ARRIVED: at `until`, or where the stride closed */
    bool closed;          /* the stride has closed, and is the record's last */
} tdmf_stride_outcome;

/* Integrates until one more stride has closed, with the inputs held, but not beyond `until`. */
TDMF_API tdmf_stride_outcome tdmf_native_stride(tdmf_solver *solver, tdmf_system system, double until,
                                                tdmf_motion *motion);

/* As many directions are integrated at once: the section's six coordinates and two parameters. */
enum { TDMF_VARIATION_LIMIT = 8 };

/* As tdmf_native_stride, and carries `count` variations along, each with the change of parameters that it
 * belongs to: at the call they are those of `motion` at its time, on return those at the time it stands at
 * then. More than TDMF_VARIATION_LIMIT, or less than 0, are refused, as are NULL for some of them and all
 * that tdmf_native_advance refuses.
 *
 * Variations also limit the steps. They are not finite where none exists:
 *   - on the edge of an event: a crossing is a touch, two events coincide, or a foot stands without friction;
 *   - along a gain, if both gains are zero and hip.swing_clamp is true. */
TDMF_API tdmf_stride_outcome tdmf_native_stride_varied(tdmf_solver *solver, tdmf_system system, double until,
                                                       tdmf_motion *motion, const tdmf_seed *seeds,
                                                       tdmf_variation *variations, int count);

/* Says an outcome in words. */
TDMF_API const char *tdmf_outcome_text(tdmf_outcome outcome);

#ifdef __cplusplus
}
#endif
#endif
