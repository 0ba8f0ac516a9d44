/* The runner without the clamp of (12) beside the clamped one: borders and random strides against
 * independent programs; and what a run does that goes from one law to the other. */
#include "references.h"

#include "compare.h"
#include "random.h"
#include "simulation.h"
#include "tdmf_slip/tdmf_slip.h"

#include <float.h>
#include <math.h>
#include <string.h>

static void begin(simulation *run, const tdmf_model *model, double friction, const double *section) {
    const tdmf_inputs inputs = inputs_at_friction(friction);
    *run = simulation_from(&model->parameters, &inputs, section, 1e-13);
}

/* ---- gaits --------------------------------------------------------------------------------------------- */

/* The leg reaches the apex near eta theta_LO, as in figure 5(b). */
TEST(the_leg_converges_to_the_angle_aimed_at) {
    for (int i = 0; i < REFERENCE_GAITS; ++i) {
        const reference_gait *gait = &reference_gaits[i];
        const tdmf_model model = table_1(false);
        simulation run;
        if (gait->swing_clamp) {
            continue;
        }
        begin(&run, &model, gait->friction, (const double *)&gait->apex);
        simulation_stride(&run);
        assert_close(last_apex_of(&run.motion).leg_angle, 1.2 * run.motion.state[TDMF_HIP_LIFTOFF_ANGLE],
                     1e-2);
    }
}

/* At 1e-9 of the friction from a border, the gait has the word of that side. */
TEST(borders_part_the_words) {
    for (int i = 0; i < FREE_BORDERS; ++i) {
        const free_border *border = &free_borders[i];
        const tdmf_model model = table_1(false);
        double guess[TDMF_SECTION_COUNT];
        memcpy(guess, &reference_gaits[i].apex, sizeof guess); /* a gait near this border */
        for (double side = -1.0; side < 2.0; side += 2.0) {
            const tdmf_inputs inputs = inputs_at_friction(border->friction * (1.0 + side * 1e-9));
            tdmf_solver solver = solver_to(1e-13);
            const tdmf_orbit found =
                find_orbit(TDMF_RETURN_MAP, &solver, (tdmf_system){&model, &inputs}, guess, NULL, 0);
            assert_int_equal(found.outcome, TDMF_ORBIT_FOUND);
            assert_string_equal(found.stride.stride.word, side > 0.0 ? border->above : border->below);
        }
    }
}

/* ---- random runners ------------------------------------------------------------------------------------ */

TEST(random_strides_are_those_of_the_reference) {
    int bounces = 0;
    for (int i = 0; i < FREE_STRIDES; ++i) {
        const free_stride *expected = &free_strides[i];
        const tdmf_model model = model_of_free_stride(expected, false);
        simulation run;
        double end[TDMF_SECTION_COUNT];
        begin(&run, &model, expected->friction, expected->start);
        simulation_stride(&run);
        const tdmf_stride stride = last_stride_of(&run.motion);
        tdmf_section_of_state(&model, &run.motion.mode.ground, run.motion.state, end);
        assert_string_equal(stride.word, expected->word);
        assert_int_equal(stride.touchdowns, expected->touchdowns);
        assert_relatively_close(stride.period, expected->period, 1e-9);
        assert_relatively_close(stride.length, expected->length, 1e-9);
        assert_relatively_close(stride.work, expected->work, 1e-9);
        assert_all_close(end, expected->end, TDMF_SECTION_COUNT, 1e-9, 1e-9);
        bounces += expected->touchdowns > 1;
    }
    assert_int_equal(bounces, 2);
}

/* ---- nothing of the clamp ------------------------------------------------------------------------------ */

/* Without gains there is nothing to clamp, and no torque that could hold a foot that lifts off: a graze would
 * have no width. */
TEST(without_gains_both_laws_are_one) {
    for (int i = 0; i < PUBLISHED_GAITS; ++i) {
        double states[2][TDMF_STATE_COUNT];
        for (int clamp = 0; clamp < 2; ++clamp) {
            tdmf_parameters parameters = table_1(clamp == 1).parameters;
            simulation run;
            parameters.hip.kp = parameters.hip.kd = 0.0;
            const tdmf_model model = accepted_model(&parameters);
            begin(&run, &model, reference_gaits[i].friction, (const double *)&reference_gaits[i].apex);
            run.motion.state[TDMF_LEG_ANGLE] = 0.5;
            run.motion.state[TDMF_LEG_ANGLE_RATE] = 0.0;
            assert_null(tdmf_start(SYSTEM_OF(&run), &run.motion).variable);
            run.solver.log = &run.log;
            tdmf_native_advance(&run.solver, SYSTEM_OF(&run), NULL, 16.0, &run.motion);
            int lifted_off = 0;
            for (int k = 0; k < run.log.count; ++k) {
                lifted_off += run.log.events[k].guard == TDMF_GUARD_LIFT_OFF;
                assert_true(run.log.events[k].after.contact != TDMF_CONTACT_GRAZE);
            }
            assert_int_equal(lifted_off, 1);
            memcpy(states[clamp], run.motion.state, sizeof states[clamp]);
        }
        assert_memory_equal(states[0], states[1], sizeof states[0]);
    }
}

/* A foot that is put on the ground is held there by the law of flight where that presses it down, with the
 * leg ahead by a servo that pulls; a clamp lets it go. */
TEST(a_resting_foot_is_held_by_a_servo_that_pulls) {
    int held = 0, let_go = 0, loaded = 0;
    random_source source = {1213};
    for (int i = 0; i < 20000; ++i) {
        const bool clamp = i % 2 == 1;
        simulation run = {.model = table_1(clamp), .inputs = inputs_at_friction(0.6)};
        double *at = run.motion.state;
        run.model.parameters.hip.kd = 0.5;
        at[TDMF_LEG_LENGTH] = random_uniform(&source, 0.9, 1.3);
        at[TDMF_LEG_ANGLE] = random_uniform(&source, -1.2, 1.2);
        at[TDMF_LEG_LENGTH_RATE] = random_uniform(&source, -1.0, 1.0);
        at[TDMF_LEG_ANGLE_RATE] = random_uniform(&source, -2.0, 2.0);
        const double angle = at[TDMF_LEG_ANGLE], length = at[TDMF_LEG_LENGTH];
        const double axial = 1.0 - length - 0.2 * at[TDMF_LEG_LENGTH_RATE];
        const double climb =
            at[TDMF_LEG_LENGTH_RATE] * cos(angle) - length * at[TDMF_LEG_ANGLE_RATE] * sin(angle);
        const double target = climb >= 0.0 ? 1.2 * angle : 0.6981317007977318;
        const double servo = -0.1 * (angle - target) - 0.5 * at[TDMF_LEG_ANGLE_RATE];
        const double flight = clamp && climb >= 0.0 ? fmax(servo, 0.0) : servo;
        const double stance = angle >= 0.0 ? -0.2 : 0.0, weight = 0.1 * 0.01;
        const double in_stance = axial * cos(angle) - stance / length * sin(angle) + weight;
        const double in_flight = axial * cos(angle) - flight / length * sin(angle) + weight;
        assert_null(tdmf_start(SYSTEM_OF(&run), &run.motion).variable);
        const tdmf_contact_mode contact = run.motion.mode.contact;
        if (in_stance > 0.0) {
            assert_true(tdmf_is_loaded(&run.motion.mode));
            ++loaded;
        } else {
            assert_int_equal(contact, in_flight > 0.0 ? TDMF_CONTACT_GRAZE : TDMF_CONTACT_FLIGHT);
        }
        if (climb >= 0.0 && servo < 0.0 && in_stance < 0.0) {
            held += contact == TDMF_CONTACT_GRAZE && !clamp && angle > 0.0;
            let_go += contact == TDMF_CONTACT_FLIGHT && clamp && angle > 0.0;
        }
    }
    assert_true(held > 20 && let_go > 20 && loaded > 1000);
}

/* A stride of a runner whose one gain is `gain`, which no model is made with where it is negative. */
static tdmf_return stride_with_gain(bool swing_clamp, int which, double gain) {
    static const double start[TDMF_SECTION_COUNT] = {1.4, 1.0, 1.0, 0.6, 0.0, 0.0};
    tdmf_model model = table_1(swing_clamp);
    const tdmf_inputs inputs = inputs_at_friction(0.6);
    const tdmf_seed seed = {.parameters = {.hip = {.kp = which == 0, .kd = which == 1}}};
    tdmf_solver solver = solver_to(1e-13);
    model.parameters.hip.kp = which == 0 ? gain : 0.0;
    model.parameters.hip.kd = which == 1 ? gain : 0.0;
    return return_map(&solver, (tdmf_system){&model, &inputs}, start, DBL_MAX, true, &seed, 1);
}

/* Along gains that are zero the torque grows from nothing: without a clamp it has a derivative, with one it
 * has a kink. */
TEST(without_a_clamp_gains_of_zero_have_derivatives) {
    static const double step = 1e-5;
    static const double offsets[] = {1.0, -1.0, 2.0, -2.0}, weights[] = {8.0, -8.0, -1.0, 1.0};
    for (int which = 0; which < 2; ++which) {
        const tdmf_return smooth = stride_with_gain(false, which, 0.0);
        const tdmf_return kinked = stride_with_gain(true, which, 0.0);
        double difference[TDMF_SECTION_COUNT] = {0.0};
        for (int k = 0; k < 4; ++k) {
            const tdmf_return moved = stride_with_gain(false, which, offsets[k] * step);
            assert_int_equal(moved.outcome, TDMF_RETURN_CLOSED);
            for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
                difference[i] += weights[k] * moved.apex[i] / (12.0 * step);
            }
        }
        for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
            const double exact = smooth.variations[TDMF_SECTION_COUNT].apex[i];
            assert_close(exact, difference[i], 1e-6 * (1.0 + fabs(exact)));
            assert_true(isnan(kinked.variations[TDMF_SECTION_COUNT].apex[i]));
        }
    }
}

/* ---- from one law to the other ------------------------------------------------------------------------- */

/* At an apex the swing is over, so its law no longer matters. */
TEST(from_an_apex_on_the_law_may_be_the_other) {
    for (int clamp = 0; clamp < 2; ++clamp) {
        const tdmf_model first = table_1(clamp == 0), second = table_1(clamp == 1);
        simulation goes_on, begins;
        double apex[TDMF_SECTION_COUNT], ends[2][TDMF_SECTION_COUNT];
        begin(&goes_on, &first, 0.6, (const double *)&reference_gaits[1].apex);
        simulation_stride(&goes_on);
        tdmf_section_of_state(&first, &goes_on.motion.mode.ground, goes_on.motion.state, apex);
        begin(&begins, &second, 0.6, apex);
        simulation_stride(&begins);
        goes_on.model = second;
        simulation_stride(&goes_on);
        tdmf_section_of_state(&first, &goes_on.motion.mode.ground, goes_on.motion.state, ends[0]);
        tdmf_section_of_state(&second, &begins.motion.mode.ground, begins.motion.state, ends[1]);
        assert_all_close(ends[0], ends[1], TDMF_SECTION_COUNT, 1e-12, 1e-12);
    }
}

/* A host that changes the law in mid-flight, which no unit allows, resolves the run as after any change: a
 * closed clamp opens where there is none, and closes where the servo pulls. */
TEST(in_flight_the_clamp_is_what_the_model_says) {
    const tdmf_model with = table_1(true), without = table_1(false);
    simulation run;
    begin(&run, &with, 0.6, (const double *)&reference_gaits[CLAMPED_GAIT].apex);
    assert_int_equal(tdmf_native_advance(&run.solver, SYSTEM_OF(&run), NULL, 20.0, &run.motion),
                     TDMF_ARRIVED);
    assert_int_equal(run.motion.mode.phase, TDMF_PHASE_RETRACT);
    assert_true(run.motion.mode.clamp_closed);
    run.model = without;
    assert_true(tdmf_resolve(SYSTEM_OF(&run), &run.motion).mode_changed);
    assert_false(run.motion.mode.clamp_closed);
    const double *at = run.motion.state;
    assert_close(OUTPUTS_OF(&run).hip.torque,
                 -0.1 * (at[TDMF_LEG_ANGLE] - 1.2 * run.motion.state[TDMF_HIP_LIFTOFF_ANGLE]) -
                     0.1 * at[TDMF_LEG_ANGLE_RATE],
                 1e-15);
    run.model = with;
    assert_true(tdmf_resolve(SYSTEM_OF(&run), &run.motion).mode_changed);
    assert_true(run.motion.mode.clamp_closed);
    assert_true(OUTPUTS_OF(&run).hip.torque == 0.0);
}
