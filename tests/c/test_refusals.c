/* Refusals: the values refused, the messages, and outputs left alone. */
#include "compare.h"
#include "scene.h"
#include "simulation.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <string.h>

typedef struct {
    const char *name;
    size_t offset;
} named_value;

#define PARAMETER(path)                                                                                      \
    { #path, offsetof(tdmf_parameters, path) }

static const named_value parameter_names[] = {
    PARAMETER(body.mass),
    PARAMETER(foot.mass),
    PARAMETER(leg.stiffness),
    PARAMETER(leg.damping),
    PARAMETER(leg.free_length),
    PARAMETER(leg.min_length),
    PARAMETER(gravity),
    PARAMETER(hip.stance_torque),
    PARAMETER(hip.touchdown_angle),
    PARAMETER(hip.kp),
    PARAMETER(hip.kd),
    PARAMETER(hip.liftoff_angle_factor),
};
enum { PARAMETER_NAMES = COUNT_OF(parameter_names) };

static void set(void *values, const named_value *which, double value) {
    memcpy((char *)values + which->offset, &value, sizeof value);
}

/* ---- parameters ------------------------------------------------------------------------------------- */

/* The shortest minimum of the longest leg, so that no bound across variables is in the way. */
static tdmf_parameters wide_parameters(const named_value *which) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.leg.min_length = 1e-9;
    if (strcmp(which->name, "leg.min_length") == 0) {
        parameters.leg.free_length = 1e6;
    }
    return parameters;
}

static tdmf_refusal create_with(const named_value *which, double value) {
    tdmf_parameters parameters = wide_parameters(which);
    tdmf_model model, untouched;
    memset(&model, 0x5a, sizeof model);
    memcpy(&untouched, &model, sizeof model);
    set(&parameters, which, value);
    const tdmf_refusal refusal = tdmf_model_create(&model, &parameters);
    if (refusal.variable != NULL) {
        assert_memory_equal(&model, &untouched, sizeof model);
    }
    return refusal;
}

static void assert_refuses_parameter(const named_value *which, double value) {
    const tdmf_refusal refusal = create_with(which, value);
    assert_non_null(refusal.variable);
    assert_string_equal(refusal.variable, which->name);
    assert_true(refusal.value == value || isnan(value));
    assert_true(refusal.minimum <= refusal.maximum);
}

TEST(every_parameter_has_a_range) {
    for (size_t i = 0; i < PARAMETER_NAMES; ++i) {
        const named_value *which = &parameter_names[i];
        const tdmf_refusal range = create_with(which, (double)NAN);
        assert_refuses_parameter(which, (double)NAN);
        assert_refuses_parameter(which, (double)INFINITY);
        assert_refuses_parameter(which, -(double)INFINITY);
        assert_refuses_parameter(which, nextafter(range.minimum, -DBL_MAX));
        assert_refuses_parameter(which, nextafter(range.maximum, DBL_MAX));
        assert_null(create_with(which, range.minimum).variable);
        assert_null(create_with(which, range.maximum).variable);
    }
}

TEST(ranges_exclude_what_makes_no_sense) {
    static const size_t positive[] = {0, 1, 2, 4, 5, 6};
    static const size_t not_negative[] = {3, 9, 10, 11};
    for (size_t i = 0; i < COUNT_OF(positive); ++i) {
        assert_refuses_parameter(&parameter_names[positive[i]], 0.0);
        assert_refuses_parameter(&parameter_names[positive[i]], -1.0);
    }
    for (size_t i = 0; i < COUNT_OF(not_negative); ++i) {
        assert_null(create_with(&parameter_names[not_negative[i]], 0.0).variable);
        assert_refuses_parameter(&parameter_names[not_negative[i]], -1e-300);
    }
}

TEST(minimum_length_may_not_exceed_the_free_length) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.leg.min_length = parameters.leg.free_length;
    tdmf_model model = accepted_model(&parameters);
    parameters.leg.min_length = nextafter(parameters.leg.free_length, 2.0);
    const tdmf_refusal refusal = tdmf_model_create(&model, &parameters);
    assert_string_equal(refusal.variable, "leg.min_length");
    assert_string_equal(refusal.bound_by, "leg.free_length");
    assert_string_equal(refusal.unit, "m");
    assert_true(refusal.value == parameters.leg.min_length);
    assert_true(refusal.maximum == parameters.leg.free_length);
}

/* 0 is another law, and not the end of this one. */
TEST(a_friction_may_fall_at_once_but_not_within_next_to_nothing) {
    tdmf_parameters parameters = tdmf_default_parameters();
    char text[256];
    parameters.body.mass = 80.0;
    parameters.leg.stiffness = 20480.0; /* k/m is 256/s2 */
    parameters.leg.free_length = 0.5;
    parameters.ground.stribeck_velocity = 8.001e-11;
    tdmf_model model = accepted_model(&parameters);
    parameters.ground.stribeck_velocity = 5e-324;
    const tdmf_refusal refusal = tdmf_model_create(&model, &parameters);
    assert_string_equal(refusal.variable, "ground.stribeck_velocity");
    assert_string_equal(tdmf_refusal_text(&refusal, text, sizeof text),
                        "ground.stribeck_velocity = 4.94065646e-324 m/s is refused: allowed from 8e-11 to "
                        "1e+09 m/s (or 0)");
    parameters.ground.stribeck_velocity = 0.0;
    model = accepted_model(&parameters);
}

TEST(scales_follow_from_the_parameters) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.body.mass = 80.0;
    parameters.leg.stiffness = 20000.0;
    parameters.leg.free_length = 0.5;
    const tdmf_model model = accepted_model(&parameters);
    assert_close(model.scales.length, 0.5, 0.0);
    assert_relatively_close(model.scales.time, sqrt(80.0 / 20000.0), 1e-15);
    assert_relatively_close(model.scales.speed, 0.5 * sqrt(20000.0 / 80.0), 1e-15);
    assert_relatively_close(model.scales.force, 10000.0, 1e-15);
    assert_relatively_close(model.scales.energy, 5000.0, 1e-15);
}

/* ---- inputs and starts ------------------------------------------------------------------------------ */

static tdmf_refusal check_friction(double friction) {
    tdmf_inputs inputs = tdmf_default_inputs();
    inputs.ground.friction = friction;
    return tdmf_check_inputs(&inputs);
}

static tdmf_refusal check_torque(double torque) {
    tdmf_inputs inputs = tdmf_default_inputs();
    inputs.hip.external_torque = torque;
    return tdmf_check_inputs(&inputs);
}

TEST(inputs_have_ranges) {
    static const double never[] = {(double)NAN, (double)INFINITY, -(double)INFINITY};
    for (int i = 0; i < 3; ++i) {
        assert_string_equal(check_friction(never[i]).variable, "ground.friction");
        assert_string_equal(check_torque(never[i]).variable, "hip.external_torque");
    }
    const tdmf_refusal range = check_friction(-1e-300);
    assert_string_equal(range.variable, "ground.friction");
    assert_null(check_friction(0.0).variable);
    assert_null(check_friction(range.maximum).variable);
    assert_non_null(check_friction(nextafter(range.maximum, DBL_MAX)).variable);
    assert_null(check_torque(-1.0).variable);
}

static void assert_refusal(const tdmf_refusal *refusal, const char *variable, const char *bound_by,
                           double minimum, double maximum) {
    assert_non_null(refusal->variable);
    assert_string_equal(refusal->variable, variable);
    assert_true(refusal->minimum == minimum && refusal->maximum == maximum);
    assert_true(bound_by == NULL || strcmp(refusal->bound_by, bound_by) == 0);
}

/* Tries to start, and asserts that a refusal left state, mode and record as they were. */
static tdmf_refusal start(runner *runner, double time) {
    memset(&runner->motion.mode, 0x5a, sizeof runner->motion.mode);
    memset(&runner->motion.record, 0x5a, sizeof runner->motion.record);
    scene_snapshot before;
    scene_take_snapshot(runner, &before);
    runner->motion.time = time;
    const tdmf_refusal refusal = tdmf_start(SYSTEM_OF(runner), &runner->motion);
    if (refusal.variable != NULL) {
        scene_assert_unchanged(runner, &before);
    }
    return refusal;
}

static void assert_refuses_start(int element, double value, const char *variable) {
    runner runner = runner_default(0.6);
    runner.motion.state[element] = value;
    const tdmf_refusal refusal = start(&runner, 0.0);
    assert_non_null(refusal.variable);
    assert_string_equal(refusal.variable, variable);
}

TEST(every_state_has_a_range) {
    static const char *const names[TDMF_MECHANICAL_COUNT] = {"foot.x",          "foot.y",        "leg.length",
                                                             "leg.angle",       "foot.vx",       "foot.vy",
                                                             "leg.length_rate", "leg.angle_rate"};
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        assert_refuses_start(i, (double)NAN, names[i]);
        assert_refuses_start(i, (double)INFINITY, names[i]);
        assert_refuses_start(i, -(double)INFINITY, names[i]);
        assert_refuses_start(i, -1e300, names[i]);
        assert_refuses_start(i, 1e300, names[i]);
    }
}

TEST(start_below_the_ground_is_refused) {
    assert_refuses_start(TDMF_FOOT_Y, -1.1e-12, "foot.y");
    runner runner = runner_default(0.6);
    runner.motion.state[TDMF_FOOT_Y] = 0.5;
    runner.motion.state[TDMF_LEG_LENGTH] = 1.0;
    runner.motion.state[TDMF_LEG_ANGLE] = 2.2; /* the body hangs 0.59 below the foot */
    const tdmf_refusal refusal = start(&runner, 0.0);
    assert_refusal(&refusal, "body.y", NULL, 0.0, 1e9);
    assert_close(refusal.value, 0.5 + cos(2.2), 1e-15);
    runner.motion.state[TDMF_FOOT_Y] = 0.6;
    assert_null(start(&runner, 0.0).variable);
    runner.motion.state[TDMF_FOOT_Y] = -cos(2.2); /* the body lies on it */
    assert_string_equal(start(&runner, 0.0).variable, "body.y");
}

TEST(start_with_too_short_a_leg_is_refused) {
    runner runner = runner_default(0.6);
    runner.motion.state[TDMF_LEG_LENGTH] = 0.05;
    assert_null(start(&runner, 0.0).variable);
    runner.motion.state[TDMF_LEG_LENGTH] = nextafter(0.05, 0.0);
    const tdmf_refusal refusal = start(&runner, 0.0);
    assert_refusal(&refusal, "leg.length", "leg.min_length", 0.05, 1e9);
    assert_true(refusal.value == runner.motion.state[TDMF_LEG_LENGTH]);
}

TEST(start_needs_a_finite_time_and_good_inputs) {
    runner runner = runner_default(0.6);
    assert_string_equal(start(&runner, (double)NAN).variable, "time");
    assert_string_equal(start(&runner, (double)INFINITY).variable, "time");
    runner.inputs.ground.friction = -1.0;
    assert_string_equal(start(&runner, 0.0).variable, "ground.friction");
    runner.inputs.ground.friction = 1.0;
    runner.inputs.hip.external_torque = (double)NAN;
    assert_string_equal(start(&runner, 0.0).variable, "hip.external_torque");
}

/* ---- words ------------------------------------------------------------------------------------------ */

static void assert_text(tdmf_refusal refusal, const char *expected) {
    char text[256];
    assert_string_equal(tdmf_refusal_text(&refusal, text, sizeof text), expected);
}

static const tdmf_refusal short_leg = {TDMF_OUT_OF_RANGE, "leg.length", 0, "m", 0.01, 0.05, 1e9,
                                       "leg.min_length"};
static const char short_leg_text[] =
    "leg.length = 0.01 m is refused: allowed from 0.05 to 1e+09 m (leg.min_length)";

TEST(text_names_variable_value_and_range) {
    const tdmf_refusal friction = {TDMF_OUT_OF_RANGE, "ground.friction", 0, "1", -0.5, 0.0, 1e6, NULL};
    const tdmf_refusal mass = {TDMF_OUT_OF_RANGE, "body.mass", 0, "kg", -(double)INFINITY, 1e-9, 1e9, NULL};
    const tdmf_refusal accepted = {0};
    assert_text(short_leg, short_leg_text);
    assert_text(friction, "ground.friction = -0.5 is refused: allowed from 0 to 1000000");
    assert_text(mass, "body.mass = -inf kg is refused: allowed from 1e-09 to 1e+09 kg");
    assert_text(accepted, "accepted");
}

/* Every refusal has its text, with name, value and range. NaN may be printed with a sign. */
TEST(refusals_speak) {
    char text[256];
    assert_text(create_with(&parameter_names[0], -2.5),
                "body.mass = -2.5 kg is refused: allowed from 1e-09 to 1e+09 kg");
    const tdmf_refusal no_number = create_with(&parameter_names[6], (double)NAN);
    tdmf_refusal_text(&no_number, text, sizeof text);
    assert_true(strncmp(text, "gravity = ", 10) == 0 && strstr(text, "nan m/s2 is refused") != NULL);
}

TEST(text_fits_any_capacity) {
    for (size_t capacity = 0; capacity <= sizeof short_leg_text; ++capacity) {
        char text[128];
        memset(text, '#', sizeof text);
        tdmf_refusal_text(&short_leg, text, capacity);
        assert_true(text[capacity] == '#');
        if (capacity > 0) {
            assert_int_equal(strlen(text), capacity - 1);
            assert_memory_equal(text, short_leg_text, capacity - 1);
        }
    }
}

static bool use_decimal_comma(void) {
    static const char *const names[] = {"de_DE.UTF-8", "de_DE.utf8",  "de_DE",
                                        "fr_FR.UTF-8", "fr_FR.utf8",  "it_IT.UTF-8",
                                        "es_ES.UTF-8", "ru_RU.UTF-8", "German_Germany"};
    for (size_t i = 0; i < COUNT_OF(names); ++i) {
        if (setlocale(LC_NUMERIC, names[i]) != NULL && strcmp(localeconv()->decimal_point, ",") == 0) {
            return true;
        }
    }
    return false;
}

TEST(text_has_a_decimal_point_in_any_locale) {
    if (!use_decimal_comma()) {
        skip();
    }
    char text[128];
    tdmf_refusal_text(&short_leg, text, sizeof text);
    setlocale(LC_NUMERIC, "C");
    assert_string_equal(text, short_leg_text);
}
