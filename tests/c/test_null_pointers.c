/* Pointers that may be NULL: with them a call does what it does with the value that they stand for, bit for
 * bit. */
#include "compare.h"
#include "integrate.h"
#include "simulation.h"

#include "tdmf_slip/cvode.h"

#include <string.h>

static const tdmf_inputs no_rates = {.ground = {.friction = 0.0}};
static const tdmf_seed nothing_given = {0};

static runner started(void) {
    runner runner = runner_default(0.6);
    runner_start(&runner);
    return runner;
}

TEST(without_rates_inputs_are_held) {
    solver_call *const solvers[] = {tdmf_native_advance, tdmf_cvode_advance};
    const runner runner = started();
    for (int i = 0; i < 1 + tdmf_cvode_is_available(); ++i) {
        tdmf_motion given = runner.motion, none = given;
        tdmf_solver solver = tdmf_solver_default();
        assert_int_equal(solvers[i](&solver, SYSTEM_OF(&runner), &no_rates, 30.0, &given), TDMF_ARRIVED);
        assert_int_equal(solvers[i](&solver, SYSTEM_OF(&runner), NULL, 30.0, &none), TDMF_ARRIVED);
        assert_all_close(none.state, given.state, TDMF_STATE_COUNT, 0.0, 0.0);
        assert_int_equal(none.state[TDMF_EVENT_COUNT], given.state[TDMF_EVENT_COUNT]);
    }
    const tdmf_inputs later = tdmf_inputs_after(&runner.inputs, NULL, 7.0);
    assert_true(later.ground.friction == runner.inputs.ground.friction);
    assert_true(later.hip.external_torque == runner.inputs.hip.external_torque);
}

TEST(without_a_direction_nothing_changes) {
    const runner runner = started();
    const tdmf_variation length_seed = {.state = {[TDMF_LEG_LENGTH] = 1.0}};
    const double zeros[TDMF_STATE_COUNT] = {0.0};
    const tdmf_mode *mode = &runner.motion.mode;
    const double *state = runner.motion.state;
    double given[TDMF_STATE_COUNT], no_change[TDMF_STATE_COUNT], none[TDMF_STATE_COUNT];
    tdmf_outputs nothing;
    tdmf_vary_outputs(SYSTEM_OF(&runner), mode, state, &nothing_given, &length_seed, given, &nothing);
    tdmf_vary_outputs(SYSTEM_OF(&runner), mode, state, NULL, &length_seed, no_change, &nothing);
    tdmf_vary_outputs(SYSTEM_OF(&runner), mode, state, NULL, NULL, none, &nothing);
    assert_all_close(no_change, given, TDMF_STATE_COUNT, 0.0, 0.0);
    assert_all_close(none, zeros, TDMF_STATE_COUNT, 0.0, 0.0);
    assert_true(nothing.body.x == 0.0 && nothing.com.x == 0.0);
    double before[TDMF_STATE_COUNT];
    memcpy(before, runner.motion.state, sizeof before);
    before[TDMF_FOOT_Y] = 0.0;
    before[TDMF_FOOT_VY] = -0.3;
    tdmf_variation varied, unchanged;
    tdmf_vary_start(SYSTEM_OF(&runner), before, &nothing_given, length_seed.state, &varied);
    tdmf_vary_start(SYSTEM_OF(&runner), before, NULL, length_seed.state, &unchanged);
    assert_all_close(unchanged.state, varied.state, TDMF_STATE_COUNT, 0.0, 0.0);
}

static void default_section(double section[TDMF_SECTION_COUNT]) {
    const double values[TDMF_SECTION_COUNT] = {1.33, 1.13, 1.004, 1.24, 0.0, 0.217};
    memcpy(section, values, sizeof values);
}

TEST(arrays_of_no_elements_may_be_absent) {
    const runner runner = started();
    tdmf_solver solver = tdmf_solver_default();
    double section[TDMF_SECTION_COUNT];
    default_section(section);
    const tdmf_return none = return_map(&solver, SYSTEM_OF(&runner), section, 1e3, true, NULL, 0);
    const tdmf_return one = return_map(&solver, SYSTEM_OF(&runner), section, 1e3, true, &nothing_given, 1);
    assert_true(none.outcome == TDMF_RETURN_CLOSED && one.outcome == TDMF_RETURN_CLOSED);
    assert_all_close(none.apex, one.apex, TDMF_SECTION_COUNT, 0.0, 0.0);
    assert_all_close(none.variations[0].apex, one.variations[0].apex, TDMF_SECTION_COUNT, 0.0, 0.0);
    tdmf_motion motion = runner.motion, varied = motion;
    assert_true(tdmf_native_stride(&solver, SYSTEM_OF(&runner), 1e3, &motion).closed);
    assert_true(tdmf_native_stride_varied(&solver, SYSTEM_OF(&runner), 1e3, &varied, NULL, NULL, 0).closed);
    assert_all_close(varied.state, motion.state, TDMF_STATE_COUNT, 0.0, 0.0);
    const tdmf_orbit plain = find_orbit(TDMF_RETURN_MAP, &solver, SYSTEM_OF(&runner), section, NULL, 0);
    const tdmf_orbit with_seed =
        find_orbit(TDMF_RETURN_MAP, &solver, SYSTEM_OF(&runner), section, &nothing_given, 1);
    assert_int_equal(plain.outcome, with_seed.outcome);
    assert_all_close(plain.apex, with_seed.apex, TDMF_SECTION_COUNT, 0.0, 0.0);
    const tdmf_refusal accepted = {0};
    assert_null(tdmf_refusal_text(&accepted, NULL, 0));
}
