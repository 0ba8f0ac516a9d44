/* Rates of the guards against numerical differentiation along the motion, inputs moving too. */
#include "compare.h"
#include "differentiate.h"
#include "scene.h"

#include <math.h>

/* A runner whose inputs move too. */
typedef struct {
    const runner *runner;
    tdmf_inputs input_rates;
    double derivatives[TDMF_STATE_COUNT];
    tdmf_guard guard;
} driven_flow;

static long double guard_on_flow(long double t, const void *context) {
    const driven_flow *flow = context;
    runner moved = *flow->runner;
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        moved.state[i] += (double)t * flow->derivatives[i];
    }
    moved.inputs.ground.friction += (double)t * flow->input_rates.ground.friction;
    moved.inputs.hip.external_torque += (double)t * flow->input_rates.hip.external_torque;
    return (long double)scene_guard(&moved, flow->guard);
}

/* The flight law in graze has the kink of its clamp, across which there is nothing to differentiate. */
static bool near_the_kink(const driven_flow *flow) {
    const runner *runner = flow->runner;
    const double change = runner->model.parameters.hip.kp * flow->derivatives[TDMF_LEG_ANGLE] +
                          runner->model.parameters.hip.kd * flow->derivatives[TDMF_LEG_ANGLE_RATE];
    const double argument = tdmf_hip_retract_argument(&runner->model, &runner->mode, runner->state);
    return flow->guard == TDMF_GUARD_GRAZE_TO_FLIGHT && runner->mode.phase == TDMF_PHASE_RETRACT &&
           fabs(argument) < 5.0 * scene_short_time(runner) * fabs(change);
}

static void assert_guard_rate(const driven_flow *flow, double rate) {
    const runner *runner = flow->runner;
    const double step = scene_short_time(runner);
    const double numerical = (double)derivative_at_zero(guard_on_flow, flow, (long double)step);
    const double value = scene_guard(runner, flow->guard);
    const double tolerance = scene_force_tolerance(runner) / runner->model.scales.force / (100.0 * step);
    assert_close(numerical, rate, tolerance + 1e-11 * (fabs(value) / step + fabs(rate)));
}

static void guard_rates_agree(const runner *runner) {
    driven_flow flow = {.runner = runner,
                        .input_rates = {.ground.friction = 0.3 / runner->model.scales.time,
                                        .hip.external_torque =
                                            -0.2 * runner->model.scales.energy / runner->model.scales.time}};
    tdmf_derivatives(&runner->model, &runner->inputs, &runner->mode, runner->state, flow.derivatives);
    const tdmf_watch watch = tdmf_watch_guards(&runner->model, &runner->inputs, &flow.input_rates,
                                               &runner->mode, runner->state, flow.derivatives);
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        assert_true(watch.value[i] == scene_guard(runner, (tdmf_guard)i));
        flow.guard = (tdmf_guard)i;
        if (i == TDMF_GUARD_FORCE_PEAK) {
            assert_true(watch.rate[i] == 0.0); /* a rate itself */
        } else if (!near_the_kink(&flow)) {
            assert_guard_rate(&flow, watch.rate[i]);
        }
    }
}

static void guard_rates_are_the_guards_derivatives(void **unused) {
    (void)unused;
    for (int contact = TDMF_CONTACT_FLIGHT; contact <= TDMF_CONTACT_GRAZE; ++contact) {
        random_source source = {3000 + (uint64_t)contact};
        for (int i = 0; i < 300; ++i) {
            const runner runner = scene_random(&source, (tdmf_contact_mode)contact);
            guard_rates_agree(&runner);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(guard_rates_are_the_guards_derivatives),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
