/* One step of the explicit pair of orders 8(5,3), and its dense output. */
#ifndef TDMF_SOLVER_PAIR_H
#define TDMF_SOLVER_PAIR_H

#include "chart.h"

#include <stdbool.h>

enum { PAIR_STAGES = 12, PAIR_ALL_STAGES = 16, PAIR_DENSE_TERMS = 7 };

typedef struct {
    double size;
    double start[CHART_COUNT];
    double end[CHART_COUNT];
    double slopes[PAIR_ALL_STAGES][CHART_COUNT]; /* [0] at the start, [12] at the end */
    double dense[PAIR_DENSE_TERMS][CHART_COUNT];
    bool has_dense;
} tdmf_pair_step;

/* Takes a step of step->size from step->start, whose slope is in step->slopes[0]: end, and the slope there.
 */
void tdmf_pair_take(const tdmf_chart *chart, tdmf_pair_step *step);

/* Norm of the estimated error, each coordinate in units of `allowed`: 1 is just good enough. */
double tdmf_pair_error(const tdmf_chart *chart, tdmf_pair_step *step, const double allowed[CHART_COUNT]);

/* Coordinates at a fraction of the step, 0 to 1, from the dense output, which is made when first asked for.
 */
void tdmf_pair_within(const tdmf_chart *chart, tdmf_pair_step *step, double fraction, double z[CHART_COUNT]);

#endif
