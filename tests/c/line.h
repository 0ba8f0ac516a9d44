/* A straight line through a runner, in all that its motion depends on: what a directional derivative is held
 * against. */
#ifndef TDMF_TESTS_LINE_H
#define TDMF_TESTS_LINE_H

#include "scene.h"
#include "tdmf_slip/tdmf_slip.h"

enum { PARAMETERS = TDMF_PARAMETER_COUNT };

typedef struct {
    const runner *runner;
    tdmf_seed seed;
    double d_state[TDMF_STATE_COUNT];
} line;

/* The runner at t on the line. Numbers that may be zero, such as gains, may become negative there. */
runner line_at(const line *line, double t);

/* A direction of the size of the runner's own units in every parameter, input and mechanical coordinate. */
line line_random(random_source *source, const runner *runner);

/* A step for differences in which no coordinate goes far, per unit of the direction. */
#define LINE_STEP 1e-3

#endif
