/* One step of the native solver: the motion from a chart's instant on, as Taylor series. */
#ifndef TDMF_SOLVER_STEP_H
#define TDMF_SOLVER_STEP_H

#include "chart.h"
#include "first_root.h"
#include "scalar_series.h"

typedef struct {
    const tdmf_chart *chart;
    int order;
    double tolerance;
    double longest; /* that the coefficients of the mode allow */
    double size;
    tdmf_reach reach;
    union {
        flight_series flight;
        ground_series ground;
    } series;
} tdmf_step;

/* The order at which steps of a relative tolerance cost least. */
int tdmf_step_order(double tolerance);

/* Which terms the series of a step on the ground have. */
ground_case tdmf_step_ground_case(const tdmf_step *step);

/* Expands the motion of a chart and finds how long the series may be trusted: step->size, not a number
 * where the series is not finite. */
void tdmf_step_expand(tdmf_step *step, const tdmf_chart *chart, int order, double tolerance);

/* How far another series of the step's order may be trusted, which is near `unit` in size. */
double tdmf_step_trusts(const tdmf_step *step, const double *c, double unit);

/* The same of series none of which has a unit, so that the largest of their terms has to serve: no further
 * than the step itself. `sizes` are those of their coefficients, up to the step's order; infinity where they
 * are not finite. */
double tdmf_step_trusts_terms(const tdmf_step *step, const double sizes[SERIES_TERMS]);

/* Coordinates at a time within the step. */
tdmf_coordinates tdmf_step_at(const tdmf_step *step, double elapsed);

/* Hip work since the step's start. */
double tdmf_step_work(const tdmf_step *step, double elapsed);

#endif
