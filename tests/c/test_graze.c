/* Runs through graze, followed by every solver. */
#include "compare.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"

#include "tdmf_slip/cvode.h"

#include <math.h>
#include <string.h>

/* ---- a leg that passes upright in graze ---------------------------------------------------------------- */

/* On a slope of 0.4 a leg is set down nearly upright and falls through the vertical while the foot grazes.
 * That ends the drive; under the law of coast the ground loads the foot, which slips backward from there. */
static runner runner_that_passes_upright(void) {
    runner runner = {.inputs = tdmf_default_inputs()};
    const tdmf_parameters parameters = tdmf_default_parameters();
    const double start[TDMF_STATE_COUNT] = {
        [TDMF_LEG_LENGTH] = 0.95, [TDMF_LEG_ANGLE] = 0.05, [TDMF_LEG_ANGLE_RATE] = -0.6};
    runner.model = accepted_model(&parameters);
    runner.inputs.ground.slope = 0.4;
    memcpy(runner.motion.state, start, sizeof start);
    runner_start(&runner);
    assert_int_equal(runner.motion.mode.contact, TDMF_CONTACT_GRAZE);
    assert_true(runner.motion.mode.mid_stance_pending);
    return runner;
}

/* Events of a run that goes on from a runner's motion. */
static tdmf_event_log events_until(solver_call *solve, const runner *runner, double end) {
    tdmf_motion motion = runner->motion;
    tdmf_solver solver = tdmf_solver_default();
    tdmf_event_log log = {0};
    solver.log = &log;
    solve(&solver, SYSTEM_OF(runner), NULL, end, &motion);
    return log;
}

/* The times are those of an independent program. */
static void assert_slips_after_mid_stance(const tdmf_event_log *log) {
    assert_true(log->count >= 2);
    const tdmf_event *upright = &log->events[0], *unloaded = &log->events[1];
    assert_int_equal(upright->guard, TDMF_GUARD_MID_STANCE);
    assert_int_equal(upright->before.contact, TDMF_CONTACT_GRAZE);
    assert_close(upright->time, 0.0767, 5e-5);
    assert_close(upright->state[TDMF_LEG_ANGLE], 0.0, 1e-9);
    assert_int_equal(upright->after.contact, TDMF_CONTACT_SLIP_NEGATIVE);
    assert_int_equal(upright->after.phase, TDMF_PHASE_COAST);
    assert_false(upright->after.mid_stance_pending);
    assert_int_equal(unloaded->guard, TDMF_GUARD_LIFT_OFF);
    assert_close(unloaded->time, 0.2560, 5e-5);
    assert_int_equal(unloaded->after.contact, TDMF_CONTACT_GRAZE);
}

TEST(a_leg_that_passes_upright_in_graze_ends_its_drive) {
    solver_call *const solvers[] = {tdmf_native_advance, tdmf_cvode_advance};
    const runner runner = runner_that_passes_upright();
    for (int i = 0; i < 1 + tdmf_cvode_is_available(); ++i) {
        const tdmf_event_log log = events_until(solvers[i], &runner, 0.3);
        assert_slips_after_mid_stance(&log);
    }
}

TEST(an_outer_integrator_passes_upright_in_graze) {
    runner runner = runner_that_passes_upright();
    while (runner.motion.mode.contact == TDMF_CONTACT_GRAZE) {
        assert_true(runner_advance(&runner, 1e-3) && runner.motion.time < 0.1);
    }
    assert_close(runner.motion.time, 0.0767, 5e-5);
    assert_int_equal(runner.motion.mode.contact, TDMF_CONTACT_SLIP_NEGATIVE);
    assert_int_equal(runner.motion.mode.phase, TDMF_PHASE_COAST);
}

/* ---- the kink of the clamp ----------------------------------------------------------------------------- */

static bool is_between_its_exits(const runner *runner) {
    return runner->motion.mode.phase == TDMF_PHASE_RETRACT &&
           scene_guard(runner, TDMF_GUARD_GRAZE_TO_CONTACT) > 0.0 &&
           scene_guard(runner, TDMF_GUARD_GRAZE_TO_FLIGHT) > 0.0 &&
           scene_guard(runner, TDMF_GUARD_APEX) > 0.0;
}

/* Follows a retracting foot in graze until it leaves; how often the clamp has opened or closed by then, or 0
 * where the foot does not leave, or passes upright or an apex before. */
static int kinks_until_exit(runner *runner) {
    const double step = 0.2 * scene_short_time(runner), longest = runner->model.scales.time;
    int kinks = 0;
    while (runner->motion.mode.contact == TDMF_CONTACT_GRAZE) {
        const double before = scene_retract_law(runner), angle = runner->motion.state[TDMF_LEG_ANGLE];
        if (!runner_advance(runner, step) || runner->motion.time > longest ||
            angle * runner->motion.state[TDMF_LEG_ANGLE] <= 0.0) {
            return 0;
        }
        kinks += before * scene_retract_law(runner) < 0.0;
    }
    return runner->motion.mode.phase == TDMF_PHASE_PLACE ? 0 : kinks;
}

/* The clamp is no event in graze, but the law under which the foot may lift off is another beyond it. Where
 * the foot is loaded by coast, with no torque either, the band between the laws has closed by then: this is
 * of drive. */
TEST(a_foot_leaves_graze_by_the_law_beyond_the_kink_of_the_clamp) {
    enum { SCENES = TDMF_SAMPLE_DIVISOR > 1 ? 14000 : 40000 };
    random_source source = {77};
    int compared = 0, lifted = 0;
    for (int i = 0; i < SCENES; ++i) {
        runner at = scene_random(&source, TDMF_CONTACT_GRAZE);
        at.motion.mode.mid_stance_pending = at.motion.state[TDMF_LEG_ANGLE] > 0.0;
        runner plain = at;
        if (!is_between_its_exits(&at) || kinks_until_exit(&plain) == 0) {
            continue;
        }
        const tdmf_event_log log =
            events_until(tdmf_native_advance, &at, plain.motion.time + at.model.scales.time);
        int exit = 0;
        while (exit < log.count && log.events[exit].after.contact == TDMF_CONTACT_GRAZE) {
            ++exit;
        }
        assert_true(exit < log.count && exit < TDMF_EVENT_CAPACITY);
        assert_close(log.events[exit].time, plain.motion.time, 1e-6 * at.model.scales.time);
        assert_int_equal(log.events[exit].after.contact, plain.motion.mode.contact);
        ++compared;
        lifted += plain.motion.mode.contact == TDMF_CONTACT_FLIGHT;
    }
    assert_true(compared >= SCENES / 1400 && lifted >= SCENES / 4000);
}
