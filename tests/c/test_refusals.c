/* Refusals: the values refused, the messages, and outputs left alone. */
#include "compare.h"
#include "ranges.h"
#include "scene.h"
#include "simulation.h"

#include <float.h>
#include <locale.h>
#include <math.h>
#include <string.h>

/* ---- parameters ------------------------------------------------------------------------------------- */

static const tdmf_range *range_of(const char *name) {
    int i = 0;
    while (strcmp(tdmf_parameter_ranges[i].name, name) != 0) {
        ++i;
    }
    return &tdmf_parameter_ranges[i];
}

/* The shortest minimum of the longest leg and the widest patch, so that no bound across variables is in the
 * way of this parameter. */
static tdmf_refusal create_with(const tdmf_range *range, double value) {
    tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_model model, untouched;
    parameters.leg.min_length = 1e-9;
    if (strcmp(range->name, "leg.min_length") == 0) {
        parameters.leg.free_length = 1e6;
    }
    parameters.ground.patch_begin = range_of("ground.patch_begin")->minimum;
    parameters.ground.patch_end = range_of("ground.patch_end")->maximum;
    memset(&model, 0x5a, sizeof model);
    memcpy(&untouched, &model, sizeof model);
    memcpy((char *)&parameters + range->offset, &value, sizeof value);
    const tdmf_refusal refusal = tdmf_model_create(&model, &parameters);
    if (refusal.variable != NULL) {
        assert_memory_equal(&model, &untouched, sizeof model);
    }
    return refusal;
}

static void assert_refuses_parameter(const tdmf_range *range, double value) {
    const tdmf_refusal refusal = create_with(range, value);
    assert_non_null(refusal.variable);
    assert_string_equal(refusal.variable, range->name);
    assert_true(refusal.value == value || isnan(value));
    assert_true(refusal.minimum <= refusal.maximum);
}

TEST(every_parameter_has_a_range) {
    for (int i = 0; i < TDMF_PARAMETER_COUNT; ++i) {
        const tdmf_range *range = &tdmf_parameter_ranges[i];
        const double bad[] = {NAN, INFINITY, -INFINITY, nextafter(range->minimum, -DBL_MAX),
                              nextafter(range->maximum, DBL_MAX)};
        for (size_t k = 0; k < COUNT_OF(bad); ++k) {
            assert_refuses_parameter(range, bad[k]);
        }
        assert_null(create_with(range, range->minimum).variable);
        assert_null(create_with(range, range->maximum).variable);
    }
}

TEST(ranges_exclude_what_makes_no_sense) {
    static const char *const positive[] = {"body.mass",       "foot.mass",      "leg.stiffness",
                                           "leg.free_length", "leg.min_length", "gravity"};
    static const char *const not_negative[] = {"leg.damping", "hip.kp", "hip.kd", "hip.liftoff_angle_factor"};
    for (size_t i = 0; i < COUNT_OF(positive); ++i) {
        assert_refuses_parameter(range_of(positive[i]), 0.0);
        assert_refuses_parameter(range_of(positive[i]), -1.0);
    }
    for (size_t i = 0; i < COUNT_OF(not_negative); ++i) {
        assert_null(create_with(range_of(not_negative[i]), 0.0).variable);
        assert_refuses_parameter(range_of(not_negative[i]), -1e-300);
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
    parameters.body.mass = 80.0;
    parameters.leg.stiffness = 20480.0; /* k/m is 256/s2 */
    parameters.leg.free_length = 0.5;
    parameters.ground.stribeck_velocity = 8.001e-11;
    tdmf_model model = accepted_model(&parameters);
    parameters.ground.stribeck_velocity = 5e-324;
    const tdmf_refusal refusal = tdmf_model_create(&model, &parameters);
    assert_string_equal(refusal.variable, "ground.stribeck_velocity");
    assert_refusal_text(refusal,
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

static tdmf_refusal check_input(const tdmf_range *range, double value) {
    tdmf_inputs inputs = tdmf_default_inputs();
    memcpy((char *)&inputs + range->offset, &value, sizeof value);
    return tdmf_check_inputs(&inputs);
}

TEST(inputs_have_ranges) {
    for (int i = 0; i < TDMF_INPUT_COUNT; ++i) {
        const tdmf_range *range = &tdmf_input_ranges[i];
        const double bad[] = {NAN, INFINITY, -INFINITY, nextafter(range->minimum, -DBL_MAX),
                              nextafter(range->maximum, DBL_MAX)};
        for (size_t k = 0; k < COUNT_OF(bad); ++k) {
            assert_string_equal(check_input(range, bad[k]).variable, range->name);
        }
        assert_null(check_input(range, range->minimum).variable);
        assert_null(check_input(range, range->maximum).variable);
        assert_true((range->minimum == 0.0) == (strcmp(range->name, "ground.friction") == 0));
    }
}

static void assert_refusal(const tdmf_refusal *refusal, const char *variable, const char *bound_by,
                           double minimum, double maximum) {
    assert_non_null(refusal->variable);
    assert_string_equal(refusal->variable, variable);
    assert_true(refusal->minimum == minimum && refusal->maximum == maximum);
    assert_true(bound_by == NULL || strcmp(refusal->bound_by, bound_by) == 0);
}

/* Tries to start, and asserts that a refusal left state and mode as they were. */
static tdmf_refusal start(runner *runner, double time) {
    memset(&runner->motion.mode, 0x5a, sizeof runner->motion.mode);
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
    static const double bad[] = {NAN, INFINITY, -INFINITY, -1e300, 1e300};
    for (int i = 0; i < 5 * TDMF_MECHANICAL_COUNT; ++i) {
        assert_refuses_start(TDMF_FOOT_X + i / 5, bad[i % 5], tdmf_state_ranges[i / 5].name);
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

static const tdmf_refusal short_leg = {TDMF_OUT_OF_RANGE, "leg.length", 0, "m", 0.01, 0.05, 1e9,
                                       "leg.min_length"};
static const char short_leg_text[] =
    "leg.length = 0.01 m is refused: allowed from 0.05 to 1e+09 m (leg.min_length)";

TEST(text_names_variable_value_and_range) {
    const tdmf_refusal friction = {TDMF_OUT_OF_RANGE, "ground.friction", 0, "1", -0.5, 0.0, 1e6, NULL};
    const tdmf_refusal mass = {TDMF_OUT_OF_RANGE, "body.mass", 0, "kg", -(double)INFINITY, 1e-9, 1e9, NULL};
    const tdmf_refusal accepted = {0};
    assert_refusal_text(short_leg, short_leg_text);
    assert_refusal_text(friction, "ground.friction = -0.5 is refused: allowed from 0 to 1000000");
    assert_refusal_text(mass, "body.mass = -inf kg is refused: allowed from 1e-09 to 1e+09 kg");
    assert_refusal_text(accepted, "accepted");
}

/* Every refusal has its text, with name, value and range. NaN may be printed with a sign. */
TEST(refusals_speak) {
    char text[256];
    assert_refusal_text(create_with(range_of("body.mass"), -2.5),
                        "body.mass = -2.5 kg is refused: allowed from 1e-09 to 1e+09 kg");
    const tdmf_refusal no_number = create_with(range_of("gravity"), (double)NAN);
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
