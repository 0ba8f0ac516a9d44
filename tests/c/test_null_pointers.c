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
    const tdmf_orbit plain = find_orbit(TDMF_RETURN_MAP, &solver, SYSTEM_OF(&runner), section, NULL, 0);
    const tdmf_orbit with_seed =
        find_orbit(TDMF_RETURN_MAP, &solver, SYSTEM_OF(&runner), section, &nothing_given, 1);
    assert_int_equal(plain.outcome, with_seed.outcome);
    assert_all_close(plain.apex, with_seed.apex, TDMF_SECTION_COUNT, 0.0, 0.0);
    const tdmf_refusal accepted = {0};
    assert_null(tdmf_refusal_text(&accepted, NULL, 0));
}
