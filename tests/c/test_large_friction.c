/* Friction so large that a user means "never slips": the foot then slips just before it leaves the ground,
 * where the edge of the cone is known to mu times the rounding of a force. */
#include "compare.h"
#include "integrate.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"

#include "tdmf_slip/cvode.h"
#include "tdmf_slip/orbit.h"

#include <math.h>
#include <string.h>

static const double frictions[] = {1e3, 3e3, 1e4, 1e5, 3e5, 1e6};
enum { FRICTIONS = sizeof frictions / sizeof *frictions, STRIDES = sample_of(300), STEPS_OF_A_STRIDE = 500 };

static const tdmf_inputs no_rates = {.ground = {.friction = 0.0}};

static runner started(double friction) {
    runner runner = runner_default(friction);
    runner_start(&runner);
    return runner;
}

/* f_y = |f_x|/mu + distance: the guard, mu times the distance, is as exact as the forces on both edges. */
TEST(the_cones_guard_rounds_like_the_forces) {
    int compared = 0;
    for (int i = 0; i < FRICTIONS; ++i) {
        for (double angle = -1.0; angle < 1.1; angle += 0.25) {
            runner runner = scene_on_ground(TDMF_CONTACT_STICK, angle, 1e-9);
            runner.inputs.ground.friction = frictions[i];
            const tdmf_ground_force force =
                tdmf_sticking_force(SYSTEM_OF(&runner), &runner.motion.mode, 0.0, runner.motion.state);
            const long double edge = fabsl((long double)force.tangential) / (long double)frictions[i];
            const double value = (double)((long double)force.normal - edge);
            const double positive = scene_guard(&runner, TDMF_GUARD_SLIP_ONSET_POSITIVE);
            const double negative = scene_guard(&runner, TDMF_GUARD_SLIP_ONSET_NEGATIVE);
            assert_close((fmin(positive, negative) - TDMF_GUARD_MARGIN) / frictions[i], value, 1e-15);
            ++compared;
        }
    }
    assert_int_equal(compared, FRICTIONS * 9);
}

/* A foot that cannot slip but for an instant: the stride differs from that at 1e6 by what 1/mu makes of it.
 */
TEST(every_stride_closes_in_few_steps) {
    double periods[FRICTIONS];
    for (int i = 0; i < FRICTIONS; ++i) {
        const runner runner = started(frictions[i]);
        tdmf_motion motion = runner.motion;
        tdmf_solver solver = tdmf_solver_default();
        for (int stride = 0; stride < STRIDES; ++stride) {
            const int64_t steps = solver.steps;
            const tdmf_stride_outcome outcome = tdmf_native_stride(&solver, SYSTEM_OF(&runner), 1e9, &motion);
            assert_true(outcome.closed);
            assert_true(solver.steps - steps < STEPS_OF_A_STRIDE);
            assert_string_equal(motion.record.stride.word, "0+");
        }
        periods[i] = motion.record.stride.period;
    }
    for (int i = 0; i < FRICTIONS; ++i) {
        assert_relatively_close(periods[i], periods[FRICTIONS - 1], 1e-9 + 1e-3 / frictions[i]);
    }
}

TEST(the_two_solvers_agree) {
    if (!tdmf_cvode_is_available()) {
        return;
    }
    for (int i = 0; i < FRICTIONS; ++i) {
        const runner runner = started(frictions[i]);
        tdmf_motion native = runner.motion, cvode = native;
        tdmf_solver solver = tdmf_solver_default();
        assert_int_equal(tdmf_native_advance(&solver, SYSTEM_OF(&runner), &no_rates, 110.0, &native),
                         TDMF_ARRIVED);
        assert_int_equal(tdmf_cvode_advance(&solver, SYSTEM_OF(&runner), &no_rates, 110.0, &cvode),
                         TDMF_ARRIVED);
        assert_int_equal(native.record.event_count, cvode.record.event_count);
        assert_int_equal(native.record.stride.count, 4);
        for (int k = 0; k < TDMF_MECHANICAL_COUNT; ++k) {
            assert_close(native.state[k], cvode.state[k], 1e-6);
        }
    }
}

/* The period is that which runs of the unit by CVODE settle to. */
TEST(the_gait_of_a_light_foot_is_found) {
    const double degree = 0.017453292519943295;
    tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_inputs inputs = tdmf_default_inputs();
    tdmf_solver solver = solver_to(1e-13);
    double state[TDMF_STATE_COUNT];
    parameters.foot.mass = 0.02;
    parameters.hip.touchdown_angle = 49.6715 * degree;
    inputs.ground.friction = 1000.0;
    const tdmf_model model = accepted_model(&parameters);
    tdmf_default_state(state);
    const tdmf_point com = tdmf_center_of_mass(&model, state);
    double section[TDMF_SECTION_COUNT] = {com.y,
                                          com.vx,
                                          state[TDMF_LEG_LENGTH],
                                          state[TDMF_LEG_ANGLE],
                                          state[TDMF_LEG_LENGTH_RATE],
                                          state[TDMF_LEG_ANGLE_RATE]};
    assert_int_equal(tdmf_settle(&solver, (tdmf_system){&model, &inputs}, 400, section), 400);
    const tdmf_orbit orbit = tdmf_find_orbit(&solver, (tdmf_system){&model, &inputs}, section, NULL, 0);
    assert_int_equal(orbit.outcome, TDMF_ORBIT_FOUND);
    assert_string_equal(orbit.stride.stride.word, "0+");
    assert_relatively_close(orbit.stride.stride.period, 25.36965, 3e-7);
}
