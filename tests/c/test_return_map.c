/* The return map: what it leaves out, refuses and calls a fall, and gaits by Newton's method against the
 * reference. (Its derivatives against differences: test_random_strides.c.) */
#include "compare.h"
#include "linear_equations.h"
#include "reference_gaits.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"
#include "tdmf_slip/tdmf_slip.h"

#include <math.h>
#include <string.h>

static const double tight = 1e-13;
static const double longest = 1e3;

typedef struct {
    tdmf_parameters parameters;
    tdmf_inputs inputs;
    double section[TDMF_SECTION_COUNT];
} scene_at_apex;

static scene_at_apex at_gait(const reference_gait *gait) {
    scene_at_apex scene = {tdmf_default_parameters(), tdmf_default_inputs(), {0.0}};
    scene.parameters.hip.swing_clamp = gait->swing_clamp;
    scene.inputs.ground.friction = gait->friction;
    memcpy(scene.section, &gait->apex, sizeof scene.section);
    return scene;
}

static tdmf_return map_of(tdmf_solver *solver, const scene_at_apex *scene, double until, bool derivatives,
                          const tdmf_seed *seeds, int count) {
    const tdmf_model model = accepted_model(&scene->parameters);
    return return_map(solver, (tdmf_system){&model, &scene->inputs}, scene->section, until, derivatives,
                      seeds, count);
}

static tdmf_orbit orbit_from(tdmf_solver *solver, const scene_at_apex *scene,
                             const double section[TDMF_SECTION_COUNT]) {
    const tdmf_model model = accepted_model(&scene->parameters);
    return find_orbit(TDMF_RETURN_MAP, solver, (tdmf_system){&model, &scene->inputs}, section, NULL, 0);
}

static tdmf_return stride_of(const scene_at_apex *scene, bool derivatives, const tdmf_seed *seed) {
    tdmf_solver solver = solver_to(tight);
    const tdmf_model model = accepted_model(&scene->parameters);
    const tdmf_return stride = measured_return_map(&solver, (tdmf_system){&model, &scene->inputs},
                                                   scene->section, longest, derivatives, seed, seed ? 1 : 0);
    assert_true(stride.outcome == TDMF_RETURN_CLOSED);
    return stride;
}

/* The foot comes to rest on its leg in a hundredth of a flight. The eigenvalues' sum is known by differences
 * in extended precision, three or four of the six are nearly zero. */
TEST(a_light_foot_on_a_damped_leg_has_the_jacobian_of_the_map) {
    scene_at_apex scene = at_gait(&reference_gaits[CLAMPED_GAIT]);
    const double gait[TDMF_SECTION_COUNT] = {2.36872145397, 0.728558540103,   1.0000189456,
                                             1.00348047412, 3.6001825915e-09, 0.0617147693284};
    double trace = 0.0;
    scene.parameters.foot.mass = 0.005;
    scene.parameters.leg.damping = 1.0;
    memcpy(scene.section, gait, sizeof gait);
    const tdmf_return stride = stride_of(&scene, true, NULL);
    for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
        assert_close(stride.apex[k], gait[k], 1e-9);
        trace += stride.variations[k].apex[k];
    }
    assert_close(trace, 0.897504 - 0.276227, 2e-6);
}

/* With a coarse solver the series find a touchdown before the model's foot has reached the ground. The event
 * is differentiated at the time at which it is taken. */
TEST(derivatives_are_as_good_as_the_strides) {
    enum { STRIDES = sample_of(1000) };
    random_source source = {23};
    tdmf_seed friction;
    int compared = 0;
    memset(&friction, 0, sizeof friction);
    friction.inputs.ground.friction = 1.0;
    for (int i = 0; i < STRIDES; ++i) {
        scene_at_apex scene = at_gait(&reference_gaits[DEFAULT_GAIT]);
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            scene.section[k] += random_uniform(&source, -0.1, 0.1);
        }
        tdmf_solver coarse = solver_to(1e-7), fine = solver_to(tight);
        const tdmf_return rough = map_of(&coarse, &scene, longest, true, &friction, 1);
        const tdmf_return exact = map_of(&fine, &scene, longest, true, &friction, 1);
        if (exact.outcome != TDMF_RETURN_CLOSED || rough.stride.word_code != exact.stride.word_code) {
            continue;
        }
        ++compared;
        double size = 1.0;
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            size = fmax(size, fabs(exact.variations[TDMF_SECTION_COUNT].apex[k]));
        }
        assert_all_close(rough.variations[TDMF_SECTION_COUNT].apex, exact.variations[TDMF_SECTION_COUNT].apex,
                         TDMF_SECTION_COUNT, 1e-4 * size, 0.0);
    }
    assert_true(compared > STRIDES * 9 / 10);
}

static bool is_zero(const void *bytes, size_t size) {
    const unsigned char *byte = bytes;
    bool zero = true;
    for (size_t i = 0; i < size; ++i) {
        zero = zero && byte[i] == 0;
    }
    return zero;
}

TEST(results_that_are_absent_or_not_requested_are_zero) {
    scene_at_apex scene = at_gait(&reference_gaits[DEFAULT_GAIT]), high = scene;
    const tdmf_return plain = stride_of(&scene, false, NULL);
    tdmf_solver solver = tdmf_solver_default();
    double section_state[TDMF_STATE_COUNT];
    assert_true(is_zero(plain.variations, sizeof plain.variations));
    const tdmf_model model = accepted_model(&scene.parameters);
    const tdmf_return late = map_of(&solver, &scene, 1.0, true, NULL, 0);
    assert_true(late.outcome == TDMF_RETURN_TOO_LONG);
    assert_true(is_zero(late.apex, sizeof late.apex) && is_zero(late.variations, sizeof late.variations));
    high.section[TDMF_SECTION_COM_HEIGHT] = 200.0;
    const tdmf_system system = {&model, &scene.inputs};
    const tdmf_return reduced = reduced_map(&solver, system, scene.section, longest, false, NULL, 0);
    const tdmf_return fell = reduced_map(&solver, system, high.section, longest, true, NULL, 0);
    assert_true(is_zero(reduced.variations, sizeof reduced.variations));
    assert_true(is_zero(fell.apex, sizeof fell.apex) && is_zero(&fell.stride, sizeof fell.stride));
    assert_true(is_zero(fell.variations, sizeof fell.variations));
    memset(section_state, 1, sizeof section_state);
    tdmf_section_state((tdmf_system){&model, &scene.inputs}, scene.section, section_state);
    assert_true(section_state[TDMF_FOOT_X] == 0.0);
    assert_true(is_zero(section_state, TDMF_FOOT_X * sizeof *section_state));
    assert_true(is_zero(section_state + TDMF_LEG_ANGLE_RATE + 1,
                        (TDMF_STATE_COUNT - TDMF_LEG_ANGLE_RATE - 1) * sizeof *section_state));
}

TEST(only_what_asks_is_measured) {
    for (size_t i = 0; i < REFERENCE_GAITS; i += EVERY_OTHER) {
        const scene_at_apex scene = at_gait(&reference_gaits[i]);
        const tdmf_return measured = stride_of(&scene, true, NULL);
        tdmf_solver solver = solver_to(tight);
        const tdmf_return plain = map_of(&solver, &scene, longest, true, NULL, 0);
        assert_true(is_zero(&plain.measures, sizeof plain.measures));
        assert_true(is_zero(&plain.variations[0].measures, sizeof plain.variations[0].measures));
        assert_true(measured.measures.squared_torque > 0.0);
        assert_all_close(measured.apex, plain.apex, TDMF_SECTION_COUNT, 1e-12, 0.0);
    }
}

TEST(gaits_are_found_to_rounding) {
    int jacobians = 0;
    for (size_t i = 0; i < REFERENCE_GAITS; ++i) {
        const reference_gait *gait = &reference_gaits[i];
        const scene_at_apex scene = at_gait(gait);
        tdmf_solver solver = solver_to(tight);
        double guess[TDMF_SECTION_COUNT];
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            guess[k] = scene.section[k] + 1e-3;
        }
        const tdmf_orbit orbit = orbit_from(&solver, &scene, guess);
        assert_int_equal(orbit.outcome, TDMF_ORBIT_FOUND);
        assert_true(orbit.iterations <= 5);
        assert_true(orbit.error < 1e-12);
        assert_string_equal(orbit.stride.stride.word, gait->word);
        jacobians += assert_reference_jacobian(&orbit.stride, gait);
        assert_relatively_close(orbit.stride.liftoff_angle, gait->liftoff_angle, 1e-11);
        assert_relatively_close(orbit.stride.stride.period, gait->period, 1e-11);
        assert_all_close(orbit.apex, scene.section, TDMF_SECTION_COUNT, 2e-11, 0.0);
    }
    assert_int_equal(jacobians, REFERENCE_GAITS - PUBLISHED_GAITS);
}

TEST(a_search_without_a_gait_reports_none) {
    static const struct {
        double height;
        tdmf_orbit_outcome outcome;
    } guesses[] = {{-1.0, TDMF_ORBIT_NO_START}, {NAN, TDMF_ORBIT_NO_START}, {200.0, TDMF_ORBIT_FELL}};
    for (int i = 0; i < 2 * 3; ++i) {
        const tdmf_apex_map map = i % 2 == 0 ? TDMF_RETURN_MAP : TDMF_REDUCED_MAP;
        scene_at_apex scene = at_gait(&reference_gaits[DEFAULT_GAIT]);
        tdmf_solver solver = tdmf_solver_default();
        const tdmf_model model = accepted_model(&scene.parameters);
        const tdmf_system system = {&model, &scene.inputs};
        scene.section[TDMF_SECTION_COM_HEIGHT] = guesses[i / 2].height;
        assert_int_equal(find_orbit(map, &solver, system, scene.section, NULL, 0).outcome,
                         guesses[i / 2].outcome);
        assert_int_equal(settle(map, &solver, system, 10, scene.section), 0);
    }
}

/* Solver failures and a standing runner are not falls. */
TEST(only_a_fall_is_called_one) {
    scene_at_apex scene = at_gait(&reference_gaits[DEFAULT_GAIT]);
    for (int limit = 0; limit < 3; ++limit) {
        tdmf_solver few_steps = tdmf_solver_default(), few_events = tdmf_solver_default();
        few_steps.step_limit = few_events.event_limit = limit;
        const tdmf_orbit tired = orbit_from(&few_steps, &scene, scene.section);
        assert_int_equal(tired.outcome, TDMF_ORBIT_UNSOLVED);
        assert_int_equal(tired.stride.solver, TDMF_TOO_MANY_STEPS);
        const tdmf_orbit busy = orbit_from(&few_events, &scene, scene.section);
        assert_int_equal(busy.outcome, TDMF_ORBIT_UNSOLVED);
        assert_int_equal(busy.stride.solver, TDMF_TOO_MANY_EVENTS);
    }
    /* It sinks into a stand, upright, and stays there. */
    const double stand[TDMF_SECTION_COUNT] = {1.0, 0.0, 1.0, 0.0, 0.0, 0.0};
    tdmf_solver solver = tdmf_solver_default();
    scene.parameters.hip.stance_torque = 0.0;
    scene.parameters.leg.damping = 2.0;
    scene.parameters.hip.touchdown_angle = 0.0;
    assert_int_equal(orbit_from(&solver, &scene, stand).outcome, TDMF_ORBIT_NO_STRIDE);
}

/* Steps of so many strides, by the rule in solver.h, where each closes or is the last. */
static int64_t most_steps(const tdmf_solver *solver) {
    return solver->step_limit + (solver->strides + 1) * solver->step_limit / TDMF_STEP_SHARE;
}

/* A stride of this runner takes more than 40 steps. */
TEST(strides_of_a_search_share_their_steps) {
    const scene_at_apex scene = at_gait(&reference_gaits[DEFAULT_GAIT]);
    double section[TDMF_SECTION_COUNT];
    const tdmf_model model = accepted_model(&scene.parameters);
    const tdmf_system system = {&model, &scene.inputs};
    for (int limit = 200; limit <= 800; limit += 200) {
        tdmf_solver settling = tdmf_solver_default(), searching = tdmf_solver_default();
        settling.step_limit = searching.step_limit = limit;
        memcpy(section, scene.section, sizeof section);
        const int strides = settle(TDMF_RETURN_MAP, &settling, system, 400, section);
        assert_true(strides > 1 && strides < 400);
        assert_int_equal(settling.strides, strides);
        assert_true(settling.steps <= most_steps(&settling));
        memcpy(section, scene.section, sizeof section);
        section[TDMF_SECTION_COM_SPEED] *= 1.3;
        const tdmf_orbit found = find_orbit(TDMF_RETURN_MAP, &searching, system, section, NULL, 0);
        assert_true(searching.steps <= limit);
        if (found.outcome != TDMF_ORBIT_FOUND) {
            assert_int_equal(found.outcome, TDMF_ORBIT_UNSOLVED);
            assert_int_equal(found.stride.solver, TDMF_TOO_MANY_STEPS);
        }
        assert_int_equal(found.outcome, limit < 400 ? TDMF_ORBIT_UNSOLVED : found.outcome);
        assert_int_equal(settling.step_limit, limit);
    }
    tdmf_solver usual = tdmf_solver_default();
    memcpy(section, scene.section, sizeof section);
    assert_int_equal(settle(TDMF_RETURN_MAP, &usual, system, 400, section), 400);
}

TEST(linear_systems_are_solved) {
    /* The first pivot is zero, so that rows have to be exchanged. */
    double a[TDMF_MAP_LIMIT + 1][TDMF_MAP_LIMIT + 1] = {{0.0, 2.0, 1.0}, {1.0, 1.0, 1.0}, {4.0, 0.0, 3.0}};
    double b[3] = {7.0, 6.0, 13.0};
    assert_true(tdmf_solve_linear(3, a, b));
    assert_close(b[0], 1.0, 1e-15);
    assert_close(b[1], 2.0, 1e-15);
    assert_close(b[2], 3.0, 1e-15);
    double singular[TDMF_MAP_LIMIT + 1][TDMF_MAP_LIMIT + 1] = {{1.0, 2.0}, {2.0, 4.0}};
    assert_false(tdmf_solve_linear(2, singular, b));
}

/* The ground is sloped; a section measures height from it. */
TEST(a_section_comes_back_from_its_state) {
    const double section[TDMF_SECTION_COUNT] = {1.8, 1.25, 0.97, 0.9, -0.02, 0.3};
    const tdmf_parameters parameters = tdmf_default_parameters();
    const tdmf_model model = accepted_model(&parameters);
    tdmf_inputs inputs = tdmf_default_inputs();
    inputs.ground.slope = 0.2;
    inputs.ground.height = -0.3;
    double state[TDMF_STATE_COUNT];
    tdmf_section_state((tdmf_system){&model, &inputs}, section, state);
    const tdmf_ground_line ground = tdmf_ground_line_of(inputs.ground.height, inputs.ground.slope);
    tdmf_section_of_state(&model, &ground, state, state);
    assert_all_close(state, section, TDMF_SECTION_COUNT, 1e-15, 0.0);
}
