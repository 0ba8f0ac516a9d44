/* Scaling of mass, stiffness and length with the dimensionless groups fixed gives the same motion in scaled
 * units: m by a, k by b, l0 by d scale time by sqrt(a/b), speed by d sqrt(b/a), force by b d, energy by b
 * d^2. */
#include "compare.h"
#include "scene.h"
#include "simulation.h"

#include <math.h>

static factors random_factors(random_source *source) {
    const factors factors = {random_magnitude(source, 1e-3, 1e3), random_magnitude(source, 1e-3, 1e4),
                             random_magnitude(source, 1e-2, 1e2)};
    return factors;
}

static runner scaled(const runner *original, const factors *by) {
    runner runner = *original;
    const tdmf_parameters parameters = scaled_parameters(runner.model.parameters, by);
    runner.model = accepted_model(&parameters);
    runner.inputs = scaled_inputs(runner.inputs, by);
    runner.motion.mode.ground.height *= by->length;
    for (int i = TDMF_FOOT_X; i <= TDMF_LEG_ANGLE_RATE; ++i) {
        runner.motion.state[i] *= factor_of_element(by, i);
    }
    runner.motion.state[TDMF_HIP_PLACE_TIME] *= time_factor(by);
    return runner;
}

/* They bring a runner down to m = k = l0 = 1. */
static factors to_unity(const tdmf_parameters *p) {
    const factors factors = {1.0 / p->body.mass, 1.0 / p->leg.stiffness, 1.0 / p->leg.free_length};
    return factors;
}

/* Guards are pure numbers: they don't know the units. */
TEST(guards_are_dimensionless) {
    random_source source = {51};
    for (int i = 0; i < 500; ++i) {
        const runner original = scene_random(&source, (tdmf_contact_mode)(TDMF_CONTACT_FLIGHT + i % 5));
        const factors by = to_unity(&original.model.parameters);
        const runner copy = scaled(&original, &by);
        const double light = original.model.parameters.body.mass / original.model.parameters.foot.mass;
        for (int guard = 0; guard < TDMF_GUARD_COUNT; ++guard) {
            const double expected = scene_guard(&original, (tdmf_guard)guard);
            assert_close(scene_guard(&copy, (tdmf_guard)guard), expected, 1e-12 * (light + fabs(expected)));
        }
    }
}

static void assert_same_gait(tdmf_stride copy, tdmf_stride stride, const factors *by) {
    const double tolerance = 1e-9;
    const double time = time_factor(by);
    assert_string_equal(copy.word, stride.word);
    assert_int_equal(copy.word_code, stride.word_code);
    assert_int_equal(copy.touchdowns, stride.touchdowns);
    assert_relatively_close(copy.period, stride.period * time, tolerance);
    assert_relatively_close(copy.length, stride.length * by->length, tolerance);
    assert_relatively_close(copy.speed, stride.speed * by->length / time, tolerance);
    assert_relatively_close(copy.work, stride.work * energy_factor(by), tolerance);
    assert_relatively_close(copy.positive_work, stride.positive_work * energy_factor(by), tolerance);
    assert_relatively_close(copy.cost_of_transport, stride.cost_of_transport, tolerance);
    assert_relatively_close(copy.stance_time, stride.stance_time * time, tolerance);
    assert_relatively_close(copy.duty_factor, stride.duty_factor, tolerance);
    assert_relatively_close(copy.slip_distance, stride.slip_distance * by->length, tolerance);
    assert_relatively_close(copy.peak_force, stride.peak_force * by->stiffness * by->length, tolerance);
    assert_relatively_close(copy.peak_vertical_force, stride.peak_vertical_force * by->stiffness * by->length,
                            tolerance);
}

TEST(gait_is_the_same_in_scaled_units) {
    random_source source = {52};
    const double step = 4e-3;
    runner original = runner_default(0.6);
    for (int i = 0; i < 6; ++i) {
        const factors by = random_factors(&source);
        runner copy = scaled(&original, &by);
        runner unit = original;
        runner_start(&unit);
        runner_start(&copy);
        runner_stride(&unit, step);
        runner_stride(&copy, step * time_factor(&by));
        assert_same_gait(last_stride_of(&copy.motion), last_stride_of(&unit.motion), &by);
    }
}
