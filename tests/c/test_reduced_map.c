/* The reduced map: its fixed points against the reference, its derivatives against differences, and what
 * becomes of a stride that has no next apex. */
#include "compare.h"
#include "differentiate.h"
#include "random.h"
#include "references.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"
#include "stride_results.h"

#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

static const double tight = 1e-13;
static const double longest = 1e4;

enum {
    PARAMETERS = TDMF_PARAMETER_COUNT,
    INPUTS = sizeof(tdmf_inputs) / sizeof(double),
    COORDINATES = TDMF_REDUCED_COUNT + PARAMETERS + INPUTS,
    PATCH_BEGIN = TDMF_REDUCED_COUNT + offsetof(tdmf_parameters, ground.patch_begin) / sizeof(double),
    PATCH_END = TDMF_REDUCED_COUNT + offsetof(tdmf_parameters, ground.patch_end) / sizeof(double),
    GROUND_HEIGHT = TDMF_REDUCED_COUNT + PARAMETERS + offsetof(tdmf_inputs, ground.height) / sizeof(double)
};

/* Parameters, inputs and apex that determine a stride. */
typedef struct {
    tdmf_parameters parameters;
    tdmf_inputs inputs;
    double apex[TDMF_REDUCED_COUNT];
} apex_scene;

static apex_scene at_gait(const reduced_gait *gait) {
    apex_scene scene = {parameters_of_reduced_gait(gait), inputs_of_reduced_gait(gait), {0.0}};
    memcpy(scene.apex, gait->apex, sizeof scene.apex);
    return scene;
}

static tdmf_return stride_by(tdmf_solver *solver, const apex_scene *scene, double until, bool derivatives,
                             const tdmf_seed *seeds, int count) {
    const tdmf_model model = accepted_model(&scene->parameters);
    return reduced_map(solver, (tdmf_system){&model, &scene->inputs}, scene->apex, until, derivatives, seeds,
                       count);
}

static tdmf_return stride_from(const apex_scene *scene, double tolerance, bool derivatives,
                               const tdmf_seed *seeds, int count) {
    tdmf_solver solver = tdmf_solver_default();
    solver.relative_tolerance = tolerance;
    return stride_by(&solver, scene, longest, derivatives, seeds, count);
}

static tdmf_orbit orbit_from(const apex_scene *scene, double tolerance) {
    const tdmf_model model = accepted_model(&scene->parameters);
    tdmf_solver solver = solver_to(tolerance);
    return find_orbit(TDMF_REDUCED_MAP, &solver, (tdmf_system){&model, &scene->inputs}, scene->apex, NULL, 0);
}

/* ---- fixed points ------------------------------------------------------------------------------------- */

/* They are real, and the larger one comes first. */
static void eigenvalues_of(const tdmf_return *stride, double eigenvalues[2]) {
    const double a = stride->variations[0].apex[0], b = stride->variations[1].apex[0];
    const double c = stride->variations[0].apex[1], d = stride->variations[1].apex[1];
    const double middle = 0.5 * (a + d), root = sqrt(0.25 * (a - d) * (a - d) + b * c);
    eigenvalues[0] = middle + root;
    eigenvalues[1] = middle - root;
}

TEST(gaits_of_the_reference_are_found_and_stay_where_they_are) {
    for (int i = 0; i < REDUCED_GAITS; ++i) {
        const reduced_gait *gait = &reduced_gaits[i];
        apex_scene scene = at_gait(gait);
        double eigenvalues[2];
        const tdmf_return stride = stride_from(&scene, tight, true, NULL, 0);
        assert_int_equal(stride.outcome, TDMF_RETURN_CLOSED);
        assert_string_equal(stride.stride.word, gait->word);
        assert_close(stride.apex[0], gait->apex[0], 1e-11);
        assert_close(stride.apex[1], gait->apex[1], 1e-11);
        assert_close(stride.stride.period, gait->period, 1e-10);
        assert_close(stride.stride.length, gait->length, 1e-10);
        assert_close(stride.stride.speed, gait->speed, 1e-11);
        assert_close(stride.stride.work, gait->work, 1e-11);
        eigenvalues_of(&stride, eigenvalues);
        assert_close(eigenvalues[0], gait->eigenvalues[0], 1e-9);
        assert_close(eigenvalues[1], gait->eigenvalues[1], 1e-9);
        scene.apex[0] += 0.02;
        scene.apex[1] -= 0.02;
        const tdmf_orbit orbit = orbit_from(&scene, tight);
        assert_int_equal(orbit.outcome, TDMF_ORBIT_FOUND);
        assert_true(orbit.iterations <= 6);
        assert_close(orbit.apex[0], gait->apex[0], 1e-11);
        assert_close(orbit.apex[1], gait->apex[1], 1e-11);
        assert_string_equal(orbit.stride.stride.word, gait->word);
    }
}

/* ---- derivatives -------------------------------------------------------------------------------------- */

static double *coordinate(apex_scene *scene, int k) {
    if (k < TDMF_REDUCED_COUNT) {
        return &scene->apex[k];
    }
    k -= TDMF_REDUCED_COUNT;
    return k < PARAMETERS ? (double *)&scene->parameters + k : (double *)&scene->inputs + (k - PARAMETERS);
}

typedef struct {
    apex_scene scene;
    int coordinate;
} coordinate_line;

static void results_on_line(long double t, const void *context, double results[]) {
    coordinate_line moved = *(const coordinate_line *)context;
    *coordinate(&moved.scene, moved.coordinate) += (double)t;
    const tdmf_return stride = stride_from(&moved.scene, tight, false, NULL, 0);
    assert_int_equal(stride.outcome, TDMF_RETURN_CLOSED);
    results_of(&stride, results);
}

static void exact_derivatives(const apex_scene *scene, int k, double derivatives[RESULTS]) {
    apex_scene unit;
    memset(&unit, 0, sizeof unit);
    *coordinate(&unit, k) = 1.0;
    const tdmf_seed seed = {unit.parameters, unit.inputs};
    const tdmf_return stride = stride_from(scene, tight, true, &seed, 1);
    derivatives_of(&stride.variations[k < TDMF_REDUCED_COUNT ? k : TDMF_REDUCED_COUNT], derivatives);
}

/* Allows `tolerance` relative to the largest derivative, or to 1, and the error of the differences: 1e-13 of
 * the motion over the step. */
static void assert_differentiated(const apex_scene *scene, int k, double step, double tolerance) {
    const coordinate_line on = {*scene, k};
    double exact[RESULTS], differences[RESULTS], size = 1.0;
    exact_derivatives(scene, k, exact);
    derivatives_at_zero(results_on_line, &on, (long double)step, RESULTS, differences);
    for (int i = 0; i < RESULTS; ++i) {
        size = fmax(size, fabs(exact[i]));
    }
    assert_all_close(exact, differences, RESULTS, tolerance * size, 0.0);
}

/* A torque from outside does work up to lift-off and makes the work of a stance depend on all. */
TEST(parameters_and_inputs_are_differentiated) {
    for (int i = 0; i < REDUCED_GAITS; ++i) {
        apex_scene scene = at_gait(&reduced_gaits[i]);
        scene.apex[0] += 0.01;
        scene.parameters.hip.retraction_rate += 1e-3;
        scene.parameters.ground.static_friction_ratio += 0.01;
        scene.parameters.leg.thrust = 0.01;
        scene_leave_minima(&scene.parameters);
        scene.inputs.hip.external_torque = -0.003;
        scene.inputs.leg.extension = 0.02;
        scene.inputs.control.touchdown_angle = 0.01;
        scene.inputs.ground.slope = 0.01 * (i % 3 - 1);
        scene.inputs.ground.height = 0.3;
        for (int k = 0; k < COORDINATES; ++k) {
            if (k == PATCH_BEGIN || k == PATCH_END) { /* the map has no patch */
                continue;
            }
            /* The results do not depend on the ground's height, so the difference may move it far. */
            const double unit = k == GROUND_HEIGHT ? 100.0 : 0.01;
            assert_differentiated(&scene, k, 4e-5 * fmax(unit, fabs(*coordinate(&scene, k))), 1e-7);
        }
    }
}

/* ---- energy and scaling ------------------------------------------------------------------------------- */

static void assert_energy_closes(const apex_scene *scene, const tdmf_return *stride) {
    const double before = scene->apex[TDMF_SECTION_COM_SPEED], after = stride->apex[TDMF_SECTION_COM_SPEED];
    const tdmf_parameters *p = &scene->parameters;
    assert_close((p->body.mass + p->foot.mass) *
                     (p->gravity * stride->stride.rise + 0.5 * (after - before) * (after + before)),
                 stride->stride.work + stride->external_work - stride->damper_loss - stride->friction_loss -
                     stride->impact_loss - stride->leg_loss,
                 1e-12);
}

static apex_scene random_scene(random_source *source) {
    apex_scene scene = at_gait(&reduced_gaits[2]);
    scene.parameters.foot.mass *= random_magnitude(source, 0.3, 3.0);
    scene.parameters.leg.damping *= random_magnitude(source, 0.3, 3.0);
    scene.parameters.hip.stance_torque *= random_magnitude(source, 0.3, 2.0);
    scene.parameters.hip.touchdown_angle = random_uniform(source, 0.3, 1.2);
    scene.parameters.hip.retraction_rate = random_uniform(source, -0.05, 0.05);
    scene.parameters.ground.static_friction_ratio = random_uniform(source, 1.0, 1.5);
    scene.inputs.ground.friction = random_magnitude(source, 0.05, 5.0);
    scene.inputs.hip.external_torque = random_uniform(source, -0.02, 0.02);
    scene.parameters.leg.thrust = random_chance(source, 0.5) ? 0.0 : random_uniform(source, 0.0, 0.05);
    scene.inputs.leg.extension = random_chance(source, 0.5) ? 0.0 : random_uniform(source, -0.05, 0.05);
    scene.inputs.control.stance_torque = random_uniform(source, -0.05, 0.05);
    scene.inputs.body.external_fx = random_uniform(source, -1e-3, 1e-3);
    scene.inputs.body.external_fy = random_uniform(source, -2e-3, 2e-3);
    scene.inputs.ground.height = random_uniform(source, -1.0, 1.0);
    scene.inputs.ground.slope = random_chance(source, 0.5) ? 0.0 : random_uniform(source, -0.2, 0.2);
    scene.apex[0] = random_uniform(source, 0.8, 3.0);
    scene.apex[1] = random_uniform(source, -0.5, 2.0);
    return scene;
}

TEST(the_energy_of_the_centre_of_mass_closes) {
    enum { STRIDES = 300 };
    random_source source = {5};
    int compared = 0;
    for (int i = 0; i < STRIDES; ++i) {
        const apex_scene scene = random_scene(&source);
        const tdmf_return stride = stride_from(&scene, tight, false, NULL, 0);
        if (stride.outcome == TDMF_RETURN_CLOSED) {
            ++compared;
            assert_energy_closes(&scene, &stride);
            assert_true(stride.damper_loss >= 0.0 && stride.friction_loss >= 0.0 &&
                        stride.impact_loss >= 0.0);
        }
    }
    assert_true(compared > 150);
}

/* Mass by a, stiffness by b, length by d: time by sqrt(a/b), speed by d sqrt(b/a), energy by b d^2. */
TEST(a_scaled_runner_makes_the_scaled_stride) {
    enum { STRIDES = 200 };
    random_source source = {6};
    int compared = 0;
    for (int i = 0; i < STRIDES; ++i) {
        const apex_scene scene = random_scene(&source);
        const factors by = {random_magnitude(&source, 1e-2, 1e2), random_magnitude(&source, 1e-2, 1e4),
                            random_magnitude(&source, 0.1, 10.0)};
        const double time = time_factor(&by), speed = by.length / time;
        apex_scene scaled = {scaled_parameters(scene.parameters, &by),
                             scaled_inputs(scene.inputs, &by),
                             {scene.apex[0] * by.length, scene.apex[1] * speed}};
        const tdmf_return a = stride_from(&scene, tight, true, NULL, 0);
        tdmf_solver solver = solver_to(tight);
        const tdmf_return b = stride_by(&solver, &scaled, longest * time, true, NULL, 0);
        assert_int_equal(a.outcome, b.outcome);
        assert_string_equal(a.stride.word, b.stride.word);
        if (a.outcome != TDMF_RETURN_CLOSED) {
            continue;
        }
        ++compared;
        assert_close(a.apex[0], b.apex[0] / by.length, 1e-10);
        assert_close(a.apex[1], b.apex[1] / speed, 1e-10);
        assert_close(a.stride.period, b.stride.period / time, 1e-9);
        assert_close(a.stride.work, b.stride.work / energy_factor(&by), 1e-10);
        assert_close(a.variations[1].apex[0], b.variations[1].apex[0] * speed / by.length, 1e-7);
    }
    assert_true(compared > 100);
}

/* An input that adds to a setting has the effect of a change of the setting. */
TEST(control_and_extension_are_settings) {
    apex_scene scene = at_gait(&reduced_gaits[2]), set = scene;
    scene.inputs.control.touchdown_angle = 0.05;
    scene.inputs.control.stance_torque = 0.03;
    scene.inputs.control.thrust = 0.02;
    set.parameters.hip.touchdown_angle += 0.05;
    set.parameters.hip.stance_torque += 0.03;
    set.parameters.leg.thrust = 0.02;
    const tdmf_return a = stride_from(&scene, tight, false, NULL, 0);
    const tdmf_return b = stride_from(&set, tight, false, NULL, 0);
    scene.inputs.leg.extension = 0.1;
    set.parameters.leg.free_length += 0.1;
    const tdmf_return c = stride_from(&scene, tight, false, NULL, 0);
    const tdmf_return d = stride_from(&set, tight, false, NULL, 0);
    for (int i = 0; i < TDMF_REDUCED_COUNT; ++i) {
        assert_close(a.apex[i], b.apex[i], 1e-12);
        assert_close(c.apex[i], d.apex[i], 1e-11);
    }
    assert_true(fabs(a.apex[0] - c.apex[0]) > 1e-3);
}

/* ---- what has no next apex ---------------------------------------------------------------------------- */

static tdmf_return_outcome outcome_from(const apex_scene *scene) {
    return stride_from(scene, tight, true, NULL, 0).outcome;
}

static void set_if_given(double *value, double given) {
    *value = isnan(given) ? *value : given;
}

TEST(a_stride_that_does_not_close_says_why) {
    static const struct {
        double apex[TDMF_REDUCED_COUNT]; /* NAN: of the gait */
        double angle, retraction, torque, damping, friction;
        tdmf_return_outcome expected;
    } cases[] = {
        /* The foot hangs 0.696 below the centre of mass. */
        {{0.5, NAN}, NAN, NAN, NAN, NAN, NAN, TDMF_RETURN_NO_START},
        /* The spring gives way. */
        {{200.0, NAN}, NAN, NAN, NAN, NAN, NAN, TDMF_RETURN_FELL},
        /* The leg is past horizontal before the foot is down. */
        {{3.0, NAN}, NAN, -0.15, NAN, NAN, NAN, TDMF_RETURN_FELL},
        /* The drive is over at once, and it goes down over its leg. */
        {{2.3, 1.4}, 0.1, NAN, NAN, NAN, NAN, TDMF_RETURN_NO_APEX},
        /* It sinks into a stand, upright, and stays there. */
        {{1.0, 0.0}, 0.0, NAN, 0.0, 2.0, NAN, TDMF_RETURN_TOO_LONG},
        /* It comes backwards, so that the leg grows, and its damper pulls at the foot. */
        {{0.6, -2.0}, 1.2, NAN, NAN, 2.0, 50.0, TDMF_RETURN_NO_STANCE},
    };
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        apex_scene scene = at_gait(&reduced_gaits[2]);
        set_if_given(&scene.apex[0], cases[i].apex[0]);
        set_if_given(&scene.apex[1], cases[i].apex[1]);
        set_if_given(&scene.parameters.hip.touchdown_angle, cases[i].angle);
        set_if_given(&scene.parameters.hip.retraction_rate, cases[i].retraction);
        set_if_given(&scene.parameters.hip.stance_torque, cases[i].torque);
        set_if_given(&scene.parameters.leg.damping, cases[i].damping);
        set_if_given(&scene.inputs.ground.friction, cases[i].friction);
        assert_int_equal(outcome_from(&scene), cases[i].expected);
    }
}

/* At the next apex the foot is placed below the ground, behind the body, so that the impact does not load it.
 * That is the next stride's end. */
TEST(a_stride_closes_where_the_next_has_no_stance) {
    apex_scene scene = {tdmf_default_parameters(), tdmf_default_inputs(), {1.0157, 1.5229}};
    scene.parameters.hip.touchdown_angle = -0.3593;
    scene.parameters.hip.retraction_rate = 0.8107;
    scene.parameters.leg.damping = 0.07;
    scene.inputs.ground.friction = 0.98;
    const tdmf_return stride = stride_from(&scene, tight, true, NULL, 0);
    assert_int_equal(stride.outcome, TDMF_RETURN_CLOSED);
    assert_energy_closes(&scene, &stride);
    memcpy(scene.apex, stride.apex, sizeof scene.apex);
    assert_int_equal(outcome_from(&scene), TDMF_RETURN_NO_START);
}

/* A runner that is pushed up by more than its weight neither lands nor returns. */
TEST(a_runner_that_is_held_up_has_no_stride) {
    apex_scene scene = at_gait(&reduced_gaits[2]);
    const tdmf_parameters *p = &scene.parameters;
    scene.inputs.body.external_fy = 1.5 * (p->body.mass + p->foot.mass) * p->gravity;
    const tdmf_return_outcome outcome = outcome_from(&scene);
    assert_true(outcome == TDMF_RETURN_NO_TOUCHDOWN || outcome == TDMF_RETURN_REFUSED);
}

TEST(nan_and_values_out_of_range_are_refused) {
    static const double bad[] = {NAN, INFINITY, -INFINITY, 1e300};
    const apex_scene gait = at_gait(&reduced_gaits[2]);
    tdmf_seed seeds[TDMF_REDUCED_MAP_SEEDS + 1];
    tdmf_solver solver = tdmf_solver_default();
    for (int k = 0; k < TDMF_REDUCED_COUNT; ++k) {
        for (size_t i = 0; i < COUNT_OF(bad); ++i) {
            apex_scene scene = gait;
            scene.apex[k] = bad[i];
            const tdmf_return_outcome outcome = outcome_from(&scene);
            assert_true(outcome == TDMF_RETURN_REFUSED || outcome == TDMF_RETURN_NO_START);
        }
    }
    apex_scene scene = gait;
    scene.inputs.ground.friction = -1.0;
    assert_int_equal(outcome_from(&scene), TDMF_RETURN_REFUSED);
    memset(seeds, 0, sizeof seeds);
    assert_int_equal(stride_from(&gait, tight, true, seeds, TDMF_REDUCED_MAP_SEEDS + 1).outcome,
                     TDMF_RETURN_REFUSED);
    assert_int_equal(stride_from(&gait, tight, true, seeds, -1).outcome, TDMF_RETURN_REFUSED);
    assert_int_equal(stride_from(&gait, tight, true, seeds, TDMF_REDUCED_MAP_SEEDS).outcome,
                     TDMF_RETURN_CLOSED);
    assert_int_equal(stride_from(&gait, 0.0, true, NULL, 0).outcome, TDMF_RETURN_REFUSED);
    assert_int_equal(stride_by(&solver, &gait, NAN, false, NULL, 0).outcome, TDMF_RETURN_REFUSED);
    solver.step_limit = 2;
    const tdmf_return tired = stride_by(&solver, &gait, longest, true, NULL, 0);
    assert_int_equal(tired.outcome, TDMF_RETURN_UNSOLVED);
    assert_int_equal(tired.solver, TDMF_TOO_MANY_STEPS);
}

TEST(a_runner_settles_on_the_gait) {
    apex_scene scene = at_gait(&reduced_gaits[2]);
    const tdmf_model model = accepted_model(&scene.parameters);
    tdmf_solver solver = tdmf_solver_default();
    scene.apex[0] += 0.05;
    assert_int_equal(settle(TDMF_REDUCED_MAP, &solver, (tdmf_system){&model, &scene.inputs}, 200, scene.apex),
                     200);
    assert_close(scene.apex[0], reduced_gaits[2].apex[0], 1e-8);
}

/* ---- events ------------------------------------------------------------------------------------------- */

TEST(a_log_has_the_events_of_a_stride) {
    const apex_scene scene = at_gait(&reduced_gaits[0]); /* 0+ */
    static const int expected[] = {TDMF_GUARD_TOUCHDOWN, TDMF_GUARD_MID_STANCE,
                                   TDMF_GUARD_SLIP_ONSET_POSITIVE, TDMF_GUARD_LIFT_OFF, TDMF_GUARD_APEX};
    enum { EVENTS = COUNT_OF(expected) };
    tdmf_event_log log = {0};
    tdmf_solver solver = tdmf_solver_default();
    solver.log = &log;
    const tdmf_return stride = stride_by(&solver, &scene, INFINITY, false, NULL, 0);
    assert_int_equal(log.count, EVENTS);
    for (int i = 0; i < EVENTS; ++i) {
        assert_int_equal(log.events[i].guard, expected[i]);
        assert_true(i == 0 || log.events[i].time > log.events[i - 1].time);
    }
    assert_close(log.events[3].time - log.events[0].time, stride.stride.stance_time, 1e-12);
    assert_close(log.events[4].time, stride.stride.period, 1e-12);
    assert_close(log.events[3].state[TDMF_LEG_ANGLE], stride.liftoff_angle, 0.0);
}

TEST(a_fall_is_the_last_event_under_the_largest_limit) {
    apex_scene scene = at_gait(&reduced_gaits[0]);
    tdmf_event_log log = {0};
    tdmf_solver solver = tdmf_solver_default();
    solver.event_limit = LONG_MAX;
    assert_int_equal(stride_by(&solver, &scene, INFINITY, false, NULL, 0).outcome, TDMF_RETURN_CLOSED);
    scene.apex[0] = 200.0;
    solver.log = &log;
    assert_int_equal(stride_by(&solver, &scene, INFINITY, false, NULL, 0).outcome, TDMF_RETURN_FELL);
    assert_int_equal(log.count, 2);
    assert_false(log.events[0].after.fallen);
    assert_true(log.events[1].after.fallen);
}

/* ---- the flight down ---------------------------------------------------------------------------------- */

/* Heights of foot and body above the ground, some time after the apex: the centre of mass is ballistic, and
 * the leg is where it is placed. */
typedef struct {
    double foot, body;
} heights;

static heights heights_after(const apex_scene *scene, double time) {
    const tdmf_parameters *p = &scene->parameters;
    const tdmf_inputs *inputs = &scene->inputs;
    const double mass = p->body.mass + p->foot.mass, incline = tan(inputs->ground.slope);
    const double length = p->leg.free_length + inputs->leg.extension;
    const double angle =
        p->hip.touchdown_angle + inputs->control.touchdown_angle - p->hip.retraction_rate * time;
    const double x = time * (scene->apex[1] + 0.5 * time * inputs->body.external_fx / mass);
    const double y = scene->apex[0] + 0.5 * time * time * (inputs->body.external_fy / mass - p->gravity);
    const double above = y - incline * x;
    const double swing = length * (cos(angle) + incline * sin(angle));
    const heights result = {above - p->body.mass / mass * swing, above + p->foot.mass / mass * swing};
    return result;
}

static tdmf_event first_event(const apex_scene *scene) {
    tdmf_event_log log = {0};
    tdmf_solver solver = solver_to(tight);
    solver.log = &log;
    stride_by(&solver, scene, INFINITY, false, NULL, 0);
    assert_true(log.count > 0);
    return log.events[0];
}

/* The leg turns many times in the fall: the first of many heights zero is the touchdown. Sampled densely. */
TEST(the_first_touchdown_is_found_however_the_leg_turns) {
    enum { SCENES = 200, SAMPLES = sample_of(20000) };
    random_source source = {7};
    int feet = 0, bodies = 0;
    for (int i = 0; i < SCENES; ++i) {
        apex_scene scene = random_scene(&source);
        scene.parameters.hip.retraction_rate = random_uniform(&source, -3.0, 3.0);
        if (heights_after(&scene, 0.0).foot <= 0.0) {
            continue;
        }
        const tdmf_event first = first_event(&scene);
        const bool body_first = first.guard == TDMF_GUARD_BODY_DOWN;
        for (int k = 0; k < SAMPLES; ++k) {
            const heights there = heights_after(&scene, first.time * k / SAMPLES);
            assert_true(there.foot > 0.0 && there.body > 0.0);
        }
        const heights down = heights_after(&scene, first.time);
        assert_true(body_first || first.guard == TDMF_GUARD_TOUCHDOWN);
        assert_close(body_first ? down.body : down.foot, 0.0, 1e-11);
        feet += !body_first;
        bodies += body_first;
    }
    assert_true(feet > 100 && bodies > 10);
}

/* Its leg turns fast and just misses the ground at first, which then falls away beneath it for long. */
TEST(a_runner_off_a_slope_comes_down_much_later) {
    apex_scene scene = at_gait(&reduced_gaits[2]);
    scene.parameters.hip.touchdown_angle = -0.8;
    scene.parameters.hip.retraction_rate = -4.0;
    scene.parameters.gravity = 0.1;
    scene.inputs.ground.slope = 0.7;
    scene.apex[0] = 1.1;
    scene.apex[1] = -80.0;
    /* A stone would take so long; the leg is as short as nothing beside the way. */
    assert_relatively_close(first_event(&scene).time, 2.0 * 80.0 * tan(0.7) / 0.1, 1e-2);
}

/* ---- how long a stride may take ----------------------------------------------------------------------- */

/* The flight down and the stance may each take as long as is asked for, counted from where each begins; and a
 * touchdown that is not found is not one at once. */
TEST(descent_and_stance_have_their_own_times) {
    const apex_scene scene = at_gait(&reduced_gaits[2]);
    tdmf_solver solver = tdmf_solver_default();
    const double descent = first_event(&scene).time;
    const double stance = stride_by(&solver, &scene, longest, false, NULL, 0).stride.stance_time;
    const double longer = fmax(descent, stance);
    const tdmf_return_outcome missed = descent < stance ? TDMF_RETURN_TOO_LONG : TDMF_RETURN_NO_TOUCHDOWN;
    assert_true(longer * 1.01 < descent + stance);
    assert_int_equal(stride_by(&solver, &scene, longer * 1.01, false, NULL, 0).outcome, TDMF_RETURN_CLOSED);
    assert_int_equal(stride_by(&solver, &scene, longer * 0.99, false, NULL, 0).outcome, missed);
    assert_int_equal(stride_by(&solver, &scene, descent * (1.0 - 1e-9), false, NULL, 0).outcome,
                     TDMF_RETURN_NO_TOUCHDOWN);
    assert_int_not_equal(stride_by(&solver, &scene, descent * (1.0 + 1e-9), false, NULL, 0).outcome,
                         TDMF_RETURN_NO_TOUCHDOWN);
}
