/* CVODE beside the native solver: limits and refusals of a call are the same. That the two agree on a run is
 * tested through the unit. */
#include "tdmf_slip/cvode.h"

#include "compare.h"
#include "reference_gaits.h"
#include "scene.h"

#include <math.h>
#include <string.h>

static const tdmf_input_rates held = {0.0, 0.0};

typedef struct {
    runner runner;
    tdmf_motion motion;
    tdmf_solver solver;
} run;

static run begin(void) {
    run run;
    memset(&run, 0, sizeof run);
    run.runner = runner_at_reference_apex(&reference_gaits[2]);
    run.solver = tdmf_solver_default();
    run.motion.time = run.runner.time;
    memcpy(run.motion.state, run.runner.state, sizeof run.motion.state);
    run.motion.mode = run.runner.mode;
    run.motion.record = run.runner.record;
    run.solver.relative_tolerance = 1e-9;
    return run;
}

static tdmf_outcome advance(run *run, double until) {
    return tdmf_cvode_advance(&run->solver, &run->runner.model, &run->runner.inputs, &held, until,
                              &run->motion);
}

static void limits_are_those_of_a_call(void **state) {
    (void)state;
    if (!tdmf_cvode_is_available()) {
        skip();
    }
    for (long limit = 0; limit < 3000; limit += 600) {
        run run = begin();
        run.solver.step_limit = limit;
        assert_int_equal(advance(&run, 300.0), TDMF_TOO_MANY_STEPS);
        assert_int_equal(run.solver.steps, limit);
        assert_true(limit == 0 ? run.motion.time == 0.0 : run.motion.time > 0.005 * (double)limit);
        run.solver = tdmf_solver_default();
        run.solver.relative_tolerance = 1e-9;
        assert_int_equal(advance(&run, 300.0), TDMF_ARRIVED);
        assert_int_equal(run.motion.record.stride.count, 12);
    }
}

static void requests_without_sense_are_refused(void **state) {
    (void)state;
    run run = begin();
    const tdmf_motion before = run.motion;
    assert_int_equal(advance(&run, NAN), TDMF_REFUSED);
    assert_int_equal(advance(&run, -1.0), TDMF_REFUSED);
    run.solver.relative_tolerance = NAN;
    assert_int_equal(advance(&run, 1.0), TDMF_REFUSED);
    run.solver.relative_tolerance = 1e-9;
    run.runner.inputs.ground.friction = NAN;
    assert_int_equal(advance(&run, 1.0), TDMF_REFUSED);
    assert_memory_equal(&run.motion, &before, sizeof before);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(limits_are_those_of_a_call),
        cmocka_unit_test(requests_without_sense_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
