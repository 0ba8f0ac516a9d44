/* The hip's work at positive power: a step's part of it, and where in the step it is done. */
#ifndef TDMF_SOLVER_POSITIVE_WORK_H
#define TDMF_SOLVER_POSITIVE_WORK_H

#include "step.h"

/* Gives the part of the hip's work since the start of the step that is done up to `end` at positive power;
 * all of it is `total`. */
double tdmf_positive_work(const tdmf_step *step, double end, double total);

/* Parts of a step. */
typedef struct {
    int count;
    double from[2 * SERIES_TERMS + 1], to[2 * SERIES_TERMS + 1];
} tdmf_spans;

/* Where in the step up to `end` the hip's power is positive. */
void tdmf_positive_spans(const tdmf_step *step, double end, double total, tdmf_spans *spans);

#endif
