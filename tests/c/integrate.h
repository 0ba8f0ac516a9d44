/* A plain integrator for tests: classical Runge-Kutta with a fixed step, events located by bisecting the
 * step. Slow and simple on purpose; it shares nothing with the solvers it helps to judge. */
#ifndef TDMF_TESTS_INTEGRATE_H
#define TDMF_TESTS_INTEGRATE_H

#include "at_instant.h"
#include "system_of.h"

typedef struct {
    tdmf_model model;
    tdmf_inputs inputs;
    tdmf_motion motion;
    long resolutions; /* calls of tdmf_resolve at a guard */
} runner;

/* A step of Runge and Kutta's classical method, from time t on, for `count` unknowns. */
enum { UNKNOWNS_LIMIT = TDMF_STATE_COUNT };
typedef void (*rates_at)(const void *context, double t, const double x[], double rates[]);
void runge_kutta(int count, rates_at f, const void *context, double t, double step, const double x[],
                 double after[]);

/* Table 1 and its default start; asserts that the library accepts them. */
runner runner_default(double friction);

/* Starts from runner->motion.state at time 0; asserts acceptance. */
void runner_start(runner *runner);

/* One step of at most `step`, shortened to the first guard that fires, which is then resolved. Returns false
 * where the run cannot go on: fallen, or a state that is not finite. */
bool runner_advance(runner *runner, double step);

/* Until one more stride has closed; asserts that one does. */
void runner_stride(runner *runner, double step);

#endif
