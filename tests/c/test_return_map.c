/* The return map's exact derivatives against differences, and gaits by Newton's method against the reference.
 */
#include "compare.h"
#include "differentiate.h"
#include "linear_equations.h"
#include "reference_gaits.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"
#include "stride_results.h"
#include "tdmf_slip/orbit.h"

#include <math.h>
#include <string.h>

enum {
    PARAMETERS = TDMF_PARAMETER_COUNT,
    INPUTS = sizeof(tdmf_inputs) / sizeof(double),
    COORDINATES = TDMF_SECTION_COUNT + PARAMETERS + INPUTS,
    STRIBECK_VELOCITY =
        TDMF_SECTION_COUNT + offsetof(tdmf_parameters, ground.stribeck_velocity) / sizeof(double),
    PATCH_BEGIN = TDMF_SECTION_COUNT + offsetof(tdmf_parameters, ground.patch_begin) / sizeof(double),
    PATCH_END = TDMF_SECTION_COUNT + offsetof(tdmf_parameters, ground.patch_end) / sizeof(double),
    THRUST = TDMF_SECTION_COUNT + offsetof(tdmf_parameters, leg.thrust) / sizeof(double),
    CONTROL_THRUST = TDMF_SECTION_COUNT + PARAMETERS + offsetof(tdmf_inputs, control.thrust) / sizeof(double),
    EXTERNAL_FX = TDMF_SECTION_COUNT + PARAMETERS + offsetof(tdmf_inputs, body.external_fx) / sizeof(double),
    GROUND_HEIGHT = TDMF_SECTION_COUNT + PARAMETERS + offsetof(tdmf_inputs, ground.height) / sizeof(double)
};

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

/* The k-th is a coordinate of the section, else a parameter, else an input. */
static double *coordinate(scene_at_apex *scene, int k) {
    if (k < TDMF_SECTION_COUNT) {
        return &scene->section[k];
    }
    k -= TDMF_SECTION_COUNT;
    return k < PARAMETERS ? (double *)&scene->parameters + k : (double *)&scene->inputs + (k - PARAMETERS);
}

static tdmf_return stride_of(const scene_at_apex *scene, bool derivatives, const tdmf_seed *seed) {
    tdmf_solver solver = solver_to(tight);
    const tdmf_model model = accepted_model(&scene->parameters);
    const tdmf_return stride =
        tdmf_measured_return_map(&solver, (tdmf_system){&model, &scene->inputs}, scene->section, longest,
                                 derivatives, seed, seed ? 1 : 0);
    assert_true(stride.outcome == TDMF_RETURN_CLOSED);
    return stride;
}

typedef struct {
    scene_at_apex scene;
    int coordinate;
} coordinate_line;

static void results_on_line(long double t, const void *context, double results[]) {
    coordinate_line moved = *(const coordinate_line *)context;
    *coordinate(&moved.scene, moved.coordinate) += (double)t;
    const tdmf_return stride = stride_of(&moved.scene, false, NULL);
    results_of(&stride, results);
}

static void exact_derivatives(const scene_at_apex *scene, int k, double derivatives[RESULTS]) {
    scene_at_apex unit;
    memset(&unit, 0, sizeof unit);
    *coordinate(&unit, k) = 1.0;
    const tdmf_seed seed = {unit.parameters, unit.inputs};
    const tdmf_return stride = stride_of(scene, true, &seed);
    derivatives_of(k < TDMF_SECTION_COUNT ? &stride.variations[k] : &stride.variations[TDMF_SECTION_COUNT],
                   derivatives);
}

/* Everything that is differentiated, to `tolerance` of the largest, or of 1. Errors: 1e-13 of the motion over
 * the step, and the step's eighth power times a ninth derivative. */
static void assert_differentiated(const scene_at_apex *scene, int k, double step, double tolerance) {
    const coordinate_line on = {*scene, k};
    double exact[RESULTS], differences[RESULTS], size = 1.0;
    exact_derivatives(scene, k, exact);
    derivatives_at_zero(results_on_line, &on, (long double)step, RESULTS, differences);
    for (int i = 0; i < RESULTS; ++i) {
        size = fmax(size, fabs(exact[i]));
    }
    for (int i = 0; i < RESULTS; ++i) {
        assert_close(exact[i], differences[i], tolerance * size);
    }
}

TEST(the_jacobian_is_that_of_the_map) {
    for (size_t i = 0; i < REFERENCE_GAITS; i += EVERY_OTHER) {
        const scene_at_apex scene = at_gait(&reference_gaits[i]);
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            assert_differentiated(&scene, k, 1e-3, 1e-9);
        }
    }
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
        assert_differentiated(&scene, k, 1e-5, 1e-7);
        assert_close(stride.apex[k], gait[k], 1e-9);
        trace += stride.variations[k].apex[k];
    }
    assert_close(trace, 0.897504 - 0.276227, 2e-6);
}

/* Where the coordinate is a parameter that the gait has the least of. */
static void leave_minimum(scene_at_apex *scene, int k) {
    scene_at_apex left = *scene;
    scene_leave_minima(&left.parameters);
    *coordinate(scene, k) = *coordinate(&left, k);
}

TEST(parameters_and_inputs_are_differentiated) {
    for (size_t i = 0; i < REFERENCE_GAITS; i += EVERY_OTHER) {
        for (int k = TDMF_SECTION_COUNT; k < COORDINATES; ++k) {
            scene_at_apex scene = at_gait(&reference_gaits[i]);
            if (k == PATCH_BEGIN || k == PATCH_END) { /* with a patch there is no map of six coordinates */
                continue;
            }
            if (k == STRIBECK_VELOCITY) { /* of no effect where the ratio is 1 */
                scene.parameters.ground.static_friction_ratio = 1.1;
            }
            if (k == THRUST || k == CONTROL_THRUST) { /* no less than 0 */
                scene.parameters.leg.thrust = 0.01;
            }
            /* Nothing depends on where the ground is, so that its height may move far. */
            const double unit = k == GROUND_HEIGHT ? 100.0 : 0.01;
            leave_minimum(&scene, k);
            const double step = 3e-5 * fmax(unit, fabs(*coordinate(&scene, k)));
            assert_differentiated(&scene, k, step, 1e-7);
        }
    }
}

/* A push along the ground changes the centre of mass's speed while an apex that comes later is waited for. */
TEST(under_a_push_along_the_ground_the_jacobian_is_that_of_the_map) {
    static const double pushes[] = {-1e-3, 1e-3};
    for (size_t i = 0; i < REFERENCE_GAITS; ++i) {
        scene_at_apex scene = at_gait(&reference_gaits[i]);
        scene.inputs.body.external_fx = pushes[i % 2];
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            assert_differentiated(&scene, k, 1e-4, 1e-8);
        }
        assert_differentiated(&scene, EXTERNAL_FX, 1e-6, 1e-7);
    }
}

/* No thrust is the least that there is, so that differences look ahead only: -11/6, 3, -3/2 and 1/3. */
TEST(a_thrust_of_zero_is_differentiated) {
    static const double weights[] = {-11.0 / 6.0, 3.0, -1.5, 1.0 / 3.0};
    static const double step = 1e-4;
    for (size_t i = 0; i < REFERENCE_GAITS; i += EVERY_OTHER) {
        for (int input = 0; input < 2; ++input) {
            scene_at_apex scene = at_gait(&reference_gaits[i]);
            const int k = input ? CONTROL_THRUST : THRUST;
            double exact[RESULTS], differences[RESULTS] = {0.0}, size = 1.0;
            assert_true(*coordinate(&scene, k) == 0.0);
            exact_derivatives(&scene, k, exact);
            for (int ahead = 0; ahead < 4; ++ahead) {
                const coordinate_line on = {scene, k};
                double results[RESULTS];
                results_on_line(ahead * step, &on, results);
                for (int r = 0; r < RESULTS; ++r) {
                    differences[r] += weights[ahead] * results[r] / step;
                }
            }
            for (int r = 0; r < RESULTS; ++r) {
                size = fmax(size, fabs(exact[r]));
            }
            for (int r = 0; r < RESULTS; ++r) {
                assert_close(exact[r], differences[r], 1e-6 * size);
            }
        }
    }
}

/* With a coarse solver the series find a touchdown where the model still sees the foot above the ground: it
 * is differentiated when it is taken. */
TEST(derivatives_are_as_good_as_the_strides) {
    enum { STRIDES = sample_of(1000) };
    random_source source = {23};
    const tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_seed friction;
    int compared = 0;
    const tdmf_model model = accepted_model(&parameters);
    memset(&friction, 0, sizeof friction);
    friction.inputs.ground.friction = 1.0;
    for (int i = 0; i < STRIDES; ++i) {
        scene_at_apex scene = at_gait(&reference_gaits[DEFAULT_GAIT]);
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            scene.section[k] += random_uniform(&source, -0.1, 0.1);
        }
        tdmf_solver coarse = tdmf_solver_default(), fine = coarse;
        coarse.relative_tolerance = 1e-7;
        fine.relative_tolerance = tight;
        const tdmf_return rough = tdmf_return_map(&coarse, (tdmf_system){&model, &scene.inputs},
                                                  scene.section, longest, true, &friction, 1);
        const tdmf_return exact = tdmf_return_map(&fine, (tdmf_system){&model, &scene.inputs}, scene.section,
                                                  longest, true, &friction, 1);
        if (exact.outcome != TDMF_RETURN_CLOSED || rough.stride.word_code != exact.stride.word_code) {
            continue;
        }
        ++compared;
        double size = 1.0;
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            size = fmax(size, fabs(exact.variations[TDMF_SECTION_COUNT].apex[k]));
        }
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            assert_close(rough.variations[TDMF_SECTION_COUNT].apex[k],
                         exact.variations[TDMF_SECTION_COUNT].apex[k], 1e-4 * size);
        }
    }
    assert_true(compared > STRIDES * 9 / 10);
}

TEST(what_is_too_much_is_refused) {
    const scene_at_apex scene = at_gait(&reference_gaits[DEFAULT_GAIT]);
    tdmf_seed seeds[TDMF_RETURN_MAP_SEEDS + 1];
    tdmf_solver solver = tdmf_solver_default();
    memset(seeds, 0, sizeof seeds);
    const tdmf_model model = accepted_model(&scene.parameters);
    const tdmf_return stride = tdmf_return_map(&solver, (tdmf_system){&model, &scene.inputs}, scene.section,
                                               longest, true, seeds, TDMF_RETURN_MAP_SEEDS + 1);
    assert_int_equal(stride.outcome, TDMF_RETURN_REFUSED);
    assert_int_equal(tdmf_return_map(&solver, (tdmf_system){&model, &scene.inputs}, scene.section, longest,
                                     true, seeds, -1)
                         .outcome,
                     TDMF_RETURN_REFUSED);
    solver.relative_tolerance = 0.0;
    assert_int_equal(
        tdmf_find_orbit(&solver, (tdmf_system){&model, &scene.inputs}, scene.section, NULL, 0).outcome,
        TDMF_ORBIT_NO_START);
}

static bool is_zero(const void *bytes, size_t size) {
    const unsigned char *byte = bytes;
    bool zero = true;
    for (size_t i = 0; i < size; ++i) {
        zero = zero && byte[i] == 0;
    }
    return zero;
}

TEST(what_did_not_happen_or_was_not_asked_for_is_zero) {
    scene_at_apex scene = at_gait(&reference_gaits[DEFAULT_GAIT]);
    const tdmf_return plain = stride_of(&scene, false, NULL);
    tdmf_solver solver = tdmf_solver_default();
    double section_state[TDMF_STATE_COUNT];
    assert_true(is_zero(plain.variations, sizeof plain.variations));
    const tdmf_model model = accepted_model(&scene.parameters);
    const tdmf_return late =
        tdmf_return_map(&solver, (tdmf_system){&model, &scene.inputs}, scene.section, 1.0, true, NULL, 0);
    assert_true(late.outcome == TDMF_RETURN_TOO_LONG);
    assert_true(is_zero(late.apex, sizeof late.apex) && is_zero(late.variations, sizeof late.variations));
    memset(section_state, 1, sizeof section_state);
    tdmf_section_state((tdmf_system){&model, &scene.inputs}, scene.section, section_state);
    assert_true(section_state[TDMF_FOOT_X] == 0.0);
    assert_true(is_zero(section_state + TDMF_MECHANICAL_COUNT,
                        (TDMF_STATE_COUNT - TDMF_MECHANICAL_COUNT) * sizeof *section_state));
}

TEST(only_what_asks_is_measured) {
    for (size_t i = 0; i < REFERENCE_GAITS; i += EVERY_OTHER) {
        const scene_at_apex scene = at_gait(&reference_gaits[i]);
        const tdmf_return measured = stride_of(&scene, true, NULL);
        tdmf_solver solver = solver_to(tight);
        const tdmf_model model = accepted_model(&scene.parameters);
        const tdmf_return plain = tdmf_return_map(&solver, (tdmf_system){&model, &scene.inputs},
                                                  scene.section, longest, true, NULL, 0);
        assert_true(is_zero(&plain.measures, sizeof plain.measures));
        assert_true(is_zero(&plain.variations[0].measures, sizeof plain.variations[0].measures));
        assert_true(measured.measures.squared_torque > 0.0);
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            assert_close(measured.apex[k], plain.apex[k], 1e-12);
        }
    }
}

TEST(the_lift_off_angle_is_that_of_the_last_lift_off) {
    for (size_t i = 0; i < REFERENCE_GAITS; i += EVERY_OTHER) {
        const scene_at_apex scene = at_gait(&reference_gaits[i]);
        tdmf_solver solver = tdmf_solver_default();
        tdmf_event_log log = {0};
        double angle = NAN;
        solver.log = &log;
        const tdmf_model model = accepted_model(&scene.parameters);
        const tdmf_return stride = tdmf_return_map(&solver, (tdmf_system){&model, &scene.inputs},
                                                   scene.section, longest, false, NULL, 0);
        assert_true(log.count <= TDMF_EVENT_CAPACITY);
        for (int k = 0; k < log.count; ++k) {
            angle = log.events[k].guard == TDMF_GUARD_LIFT_OFF ? log.events[k].state[TDMF_LEG_ANGLE] : angle;
        }
        assert_close(stride.liftoff_angle, angle, 1e-14);
    }
}

TEST(gaits_are_found_to_rounding) {
    int jacobians = 0;
    for (size_t i = 0; i < REFERENCE_GAITS; ++i) {
        const reference_gait *gait = &reference_gaits[i];
        const scene_at_apex scene = at_gait(gait);
        tdmf_solver solver = solver_to(tight);
        double guess[TDMF_SECTION_COUNT];
        const tdmf_model model = accepted_model(&scene.parameters);
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            guess[k] = scene.section[k] + 1e-3;
        }
        const tdmf_orbit orbit =
            tdmf_find_orbit(&solver, (tdmf_system){&model, &scene.inputs}, guess, NULL, 0);
        assert_int_equal(orbit.outcome, TDMF_ORBIT_FOUND);
        assert_true(orbit.iterations <= 5);
        assert_true(orbit.error < 1e-12);
        assert_string_equal(orbit.stride.stride.word, gait->word);
        jacobians += assert_reference_jacobian(&orbit.stride, gait);
        assert_relatively_close(orbit.stride.stride.period, gait->period, 1e-11);
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            assert_close(orbit.apex[k], scene.section[k], 2e-11);
        }
    }
    assert_int_equal(jacobians, REFERENCE_GAITS - PUBLISHED_GAITS);
}

TEST(what_is_no_gait_is_said_to_be_none) {
    scene_at_apex scene = at_gait(&reference_gaits[DEFAULT_GAIT]);
    tdmf_solver solver = tdmf_solver_default();
    const tdmf_model model = accepted_model(&scene.parameters);
    scene.section[TDMF_SECTION_COM_HEIGHT] = -1.0;
    assert_int_equal(
        tdmf_find_orbit(&solver, (tdmf_system){&model, &scene.inputs}, scene.section, NULL, 0).outcome,
        TDMF_ORBIT_NO_START);
    scene.section[TDMF_SECTION_COM_HEIGHT] = NAN;
    assert_int_equal(
        tdmf_find_orbit(&solver, (tdmf_system){&model, &scene.inputs}, scene.section, NULL, 0).outcome,
        TDMF_ORBIT_NO_START);
    scene.section[TDMF_SECTION_COM_HEIGHT] = 200.0;
    assert_int_equal(
        tdmf_find_orbit(&solver, (tdmf_system){&model, &scene.inputs}, scene.section, NULL, 0).outcome,
        TDMF_ORBIT_FELL);
    assert_int_equal(tdmf_settle(&solver, (tdmf_system){&model, &scene.inputs}, 10, scene.section), 0);
}

/* Neither trouble of the solver nor a stand is a fall. */
TEST(only_a_fall_is_called_one) {
    scene_at_apex scene = at_gait(&reference_gaits[DEFAULT_GAIT]);
    tdmf_model model = accepted_model(&scene.parameters);
    for (int limit = 0; limit < 3; ++limit) {
        tdmf_solver few_steps = tdmf_solver_default(), few_events = tdmf_solver_default();
        few_steps.step_limit = few_events.event_limit = limit;
        const tdmf_orbit tired =
            tdmf_find_orbit(&few_steps, (tdmf_system){&model, &scene.inputs}, scene.section, NULL, 0);
        assert_int_equal(tired.outcome, TDMF_ORBIT_UNSOLVED);
        assert_int_equal(tired.stride.solver, TDMF_TOO_MANY_STEPS);
        const tdmf_orbit busy =
            tdmf_find_orbit(&few_events, (tdmf_system){&model, &scene.inputs}, scene.section, NULL, 0);
        assert_int_equal(busy.outcome, TDMF_ORBIT_UNSOLVED);
        assert_int_equal(busy.stride.solver, TDMF_TOO_MANY_EVENTS);
    }
    /* It sinks into a stand, upright, and stays there. */
    const double stand[TDMF_SECTION_COUNT] = {1.0, 0.0, 1.0, 0.0, 0.0, 0.0};
    tdmf_solver solver = tdmf_solver_default();
    scene.parameters.hip.stance_torque = 0.0;
    scene.parameters.leg.damping = 2.0;
    scene.parameters.hip.touchdown_angle = 0.0;
    model = accepted_model(&scene.parameters);
    assert_int_equal(tdmf_find_orbit(&solver, (tdmf_system){&model, &scene.inputs}, stand, NULL, 0).outcome,
                     TDMF_ORBIT_NO_STRIDE);
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
        const int strides = tdmf_settle(&settling, system, 400, section);
        assert_true(strides > 1 && strides < 400);
        assert_int_equal(settling.strides, strides);
        assert_true(settling.steps <= most_steps(&settling));
        memcpy(section, scene.section, sizeof section);
        section[TDMF_SECTION_COM_SPEED] *= 1.3;
        const tdmf_orbit found = tdmf_find_orbit(&searching, system, section, NULL, 0);
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
    assert_int_equal(tdmf_settle(&usual, system, 400, section), 400);
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

/* On a slope, which the height is taken from. */
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
    for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
        assert_close(state[i], section[i], 1e-15);
    }
}
