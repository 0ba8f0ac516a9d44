/* Friction so large that a user means "never slips": the foot then slips just before it leaves the ground,
 * where the edge of the cone is known to mu times the rounding of a force. */
#include "compare.h"
#include "integrate.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"

#include "tdmf_slip/cvode.h"
#include "tdmf_slip/tdmf_slip.h"

#include <math.h>
#include <string.h>

static const double frictions[] = {1e3, 3e3, 1e4, 1e5, 3e5, 1e6};
enum { FRICTIONS = COUNT_OF(frictions), STRIDES = sample_of(300), STEPS_OF_A_STRIDE = 500 };

static simulation started(double friction) {
    const runner runner = runner_default(friction);
    return simulation_of(&runner, 1e-11);
}

/* f_y = |f_x|/mu + distance: the guard, mu times the distance, is as exact as the forces on both edges. */
TEST(the_cones_guard_rounds_like_the_forces) {
    int compared = 0;
    for (int i = 0; i < FRICTIONS; ++i) {
        for (double angle = -1.0; angle < 1.1; angle += 0.25) {
            runner runner = scene_on_ground(TDMF_CONTACT_STICK, angle, 1e-9);
            runner.inputs.ground.friction = frictions[i];
            const tdmf_outputs now = OUTPUTS_OF(&runner);
            const long double edge = fabsl((long double)now.contact.tangential) / (long double)frictions[i];
            const double value = (double)((long double)now.contact.normal - edge);
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
        simulation run = started(frictions[i]);
        for (int stride = 0; stride < STRIDES; ++stride) {
            const int64_t steps = run.solver.steps;
            simulation_stride(&run);
            assert_true(run.solver.steps - steps < STEPS_OF_A_STRIDE);
            assert_string_equal(last_stride_of(&run.motion).word, "0+");
        }
        periods[i] = last_stride_of(&run.motion).period;
    }
    for (int i = 0; i < FRICTIONS; ++i) {
        assert_relatively_close(periods[i], periods[FRICTIONS - 1], 1e-9 + 1e-3 / frictions[i]);
    }
}

TEST(the_two_solvers_agree) {
    for (int i = 0; i < FRICTIONS && tdmf_cvode_is_available(); ++i) {
        simulation native = started(frictions[i]), cvode = native;
        assert_int_equal(simulation_advance(&native, 110.0), TDMF_ARRIVED);
        assert_int_equal(simulation_advance_by(tdmf_cvode_advance, &cvode, 110.0), TDMF_ARRIVED);
        assert_int_equal(native.motion.state[TDMF_EVENT_COUNT], cvode.motion.state[TDMF_EVENT_COUNT]);
        assert_int_equal(native.motion.state[TDMF_STRIDE_COUNT], 4);
        assert_all_close(&native.motion.state[TDMF_FOOT_X], &cvode.motion.state[TDMF_FOOT_X],
                         TDMF_MECHANICAL_COUNT, 1e-6, 0.0);
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
    assert_int_equal(settle(TDMF_RETURN_MAP, &solver, (tdmf_system){&model, &inputs}, 400, section), 400);
    const tdmf_orbit orbit =
        find_orbit(TDMF_RETURN_MAP, &solver, (tdmf_system){&model, &inputs}, section, NULL, 0);
    assert_int_equal(orbit.outcome, TDMF_ORBIT_FOUND);
    assert_string_equal(orbit.stride.stride.word, "0+");
    assert_relatively_close(orbit.stride.stride.period, 25.36965, 3e-7);
}
