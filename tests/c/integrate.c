#include "integrate.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

runner runner_default(double friction) {
    runner runner;
    memset(&runner, 0, sizeof runner);
    const tdmf_parameters parameters = tdmf_default_parameters();
    assert_null(tdmf_model_create(&runner.model, &parameters).variable);
    runner.inputs = tdmf_default_inputs();
    runner.inputs.ground.friction = friction;
    runner.motion.mode.ground = tdmf_ground_line_of(0.0, 0.0);
    tdmf_default_state(runner.motion.state);
    return runner;
}

void runner_start(runner *runner) {
    runner->motion.time = 0.0;
    assert_null(tdmf_start(SYSTEM_OF(runner), &runner->motion).variable);
}

void runge_kutta(int count, rates_at f, const void *context, double t, double step, const double x[],
                 double after[]) {
    static const double reach[] = {0.0, 0.5, 0.5, 1.0};
    static const double weight[] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    double rates[UNKNOWNS_LIMIT] = {0.0}, sum[UNKNOWNS_LIMIT];
    memcpy(sum, x, (size_t)count * sizeof *sum);
    for (int stage = 0; stage < 4; ++stage) {
        double trial[UNKNOWNS_LIMIT];
        for (int i = 0; i < count; ++i) {
            trial[i] = x[i] + step * reach[stage] * rates[i];
        }
        f(context, t + reach[stage] * step, trial, rates);
        for (int i = 0; i < count; ++i) {
            sum[i] += step * weight[stage] * rates[i];
        }
    }
    memcpy(after, sum, (size_t)count * sizeof *sum);
}

static void rates_of_runner(const void *context, double t, const double state[], double rates[]) {
    const runner *runner = context;
    (void)t;
    tdmf_derivatives(SYSTEM_OF(runner), &runner->motion.mode, state, rates);
}

/* The state after a step that passes over all guards. */
static void move(const runner *runner, double step, double after[TDMF_STATE_COUNT]) {
    runge_kutta(TDMF_STATE_COUNT, rates_of_runner, runner, 0.0, step, runner->motion.state, after);
}

static bool any_due(const runner *runner, const double state[TDMF_STATE_COUNT]) {
    double guards[TDMF_GUARD_COUNT];
    tdmf_guards(SYSTEM_OF(runner), &runner->motion.mode, state, guards);
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        if (guards[i] <= 0.0) {
            return true;
        }
    }
    return false;
}

/* The shortest step, to the last bit, after which some guard has fired. */
static double step_to_event(const runner *runner, double step) {
    double before = 0.0;
    double after = step;
    for (;;) {
        const double middle = 0.5 * (before + after);
        if (middle <= before || middle >= after) {
            return after;
        }
        double state[TDMF_STATE_COUNT];
        move(runner, middle, state);
        if (any_due(runner, state)) {
            after = middle;
        } else {
            before = middle;
        }
    }
}

static bool all_finite(const double state[TDMF_STATE_COUNT]) {
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        if (!isfinite(state[i])) {
            return false;
        }
    }
    return true;
}

bool runner_advance(runner *runner, double step) {
    double after[TDMF_STATE_COUNT];
    move(runner, step, after);
    const bool event = any_due(runner, after);
    if (event) {
        step = step_to_event(runner, step);
        move(runner, step, after);
    }
    if (!all_finite(after)) {
        return false;
    }
    runner->motion.time += step;
    memcpy(runner->motion.state, after, sizeof after);
    if (event) {
        ++runner->resolutions;
        assert_false(tdmf_resolve(SYSTEM_OF(runner), &runner->motion).unresolved);
    }
    return !runner->motion.mode.fallen;
}

void runner_stride(runner *runner, double step) {
    const double count = runner->motion.state[TDMF_STRIDE_COUNT];
    while (runner->motion.state[TDMF_STRIDE_COUNT] == count) {
        assert_true(runner_advance(runner, step));
    }
}
