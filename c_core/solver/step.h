/* One step of the native solver: the motion from an instant on, as Taylor series. */
#ifndef TDMF_SOLVER_STEP_H
#define TDMF_SOLVER_STEP_H

#include "event_search.h"
#include "step_constants.h"
#include "tdmf_slip/automaton.h"

typedef struct {
    const tdmf_mode_equations *equations;
    double margin_factor;
    int order;
    double tolerance;
    double longest; /* that the law of the mode allows */
    bool in_layer;  /* where friction falls, and a step may be no longer */
    double size;
    double length_change; /* in the step, of the leg */
    event_search search;
    union {
        flight_constants flight;
        ground_constants ground;
    } constants;
    friction_layer layer; /* slip, where friction falls with speed */
    union {
        flight_series flight;
        ground_series ground;
    } series;
} tdmf_step;

/* What ends a step: an event if it is due within it. */
typedef struct {
    double time;
    bool is_event;
    tdmf_guard guard;
    tdmf_guard reached; /* the same, if the step ends at its zero: see tdmf_resolve_along */
} tdmf_step_end;

/* The orders at which steps of a relative tolerance cost least. */
series_orders tdmf_step_orders(double tolerance);

/* Which terms the series of a step on the ground have. */
ground_case tdmf_step_ground_case(const tdmf_step *step);

/* Makes a step ready for a mode that has just been opened, or whose laws have drifted since. */
void tdmf_step_open(tdmf_step *step, const tdmf_mode_equations *equations, const tdmf_mode *mode,
                    double margin_factor);

/* Expands the motion of the mode and finds how long its series may be trusted: step->size, not a number
 * where they are not finite. */
void tdmf_step_expand(tdmf_step *step, series_orders orders, double tolerance);

/* Shortens the step to `longest` and so that the leg keeps its length nearly enough. Before this a step is
 * only expanded. */
void tdmf_step_shorten(tdmf_step *step, double longest);

/* The first time within the step at which the mode, the phase or the clamp has to change. Without one, the
 * time up to which the step may be used: its size, or less where a law has a kink, a guard is known no
 * further, or the search took too long. */
tdmf_step_end tdmf_step_find_end(tdmf_step *step, const tdmf_mode *mode);

/* How far a series may be trusted that has no unit, so that the largest of its terms has to serve: no further
 * than the step itself. `sizes` are those of its coefficients, up to the step's order; infinity where they
 * are not finite. */
double tdmf_step_trusts_terms(const tdmf_step *step, const double sizes[SERIES_TERMS]);

/* Coordinates at a time within the step. */
tdmf_mode_coordinates tdmf_step_at(const tdmf_step *step, double time);

/* Where inputs ramp, what the step adds to the coordinates' leg work and to their shortfall of external work.
 */
double tdmf_step_leg_work(const tdmf_step *step, double time);
double tdmf_step_shortfall(const tdmf_step *step, double time);

/* Hip work since the step's start. */
double tdmf_step_work(const tdmf_step *step, double time);

#endif
