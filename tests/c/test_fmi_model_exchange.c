/* Setting of values, and Model Exchange: refusals and their messages, and what stays as it was. */
#include "compare.h"
#include "fmi_interface.h"

#include "tdmf_slip/tdmf_slip.h"
#include "variables.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const fmi_experiment from_zero = {.start = 0.0};

static void *in_initialization(const fmi_interface *fmi) {
    void *instance = new_of_kind(fmi, EXCHANGE);
    assert_int_equal(fmi->enter_initialization(instance, &from_zero), FMI_OK);
    return instance;
}

static void *in_continuous_time_mode(const fmi_interface *fmi) {
    return begun(fmi, EXCHANGE, "");
}

/* ---- values ------------------------------------------------------------------------------------------- */

FMI_TEST(values_out_of_range_are_discarded_and_the_old_kept) {
    static const struct {
        const char *name;
        double value;
    } bad[] = {{"body.mass", -1.0},
               {"body.mass", 0.0},
               {"foot.mass", NAN},
               {"leg.stiffness", INFINITY},
               {"leg.damping", -1e-300},
               {"gravity", -9.81},
               {"hip.touchdown_angle", 2.0},
               {"hip.kp", -INFINITY},
               {"foot.y", -1e10},
               {"leg.length", 0.0},
               {"leg.angle_rate", NAN},
               {"ground.friction", -0.1},
               {"ground.friction", NAN},
               {"hip.external_torque", INFINITY},
               {"hip.external_torque", NAN}};
    void *instance = in_initialization(fmi);
    for (size_t i = 0; i < COUNT_OF(bad); ++i) {
        const double before = value_of(fmi, instance, bad[i].name);
        clear_messages();
        assert_int_equal(set_value(fmi, instance, bad[i].name, bad[i].value), FMI_DISCARD);
        assert_int_equal(message_count, 1);
        assert_string_equal(last_category, "logStatusDiscard");
        assert_non_null(strstr(last_message, bad[i].name));
        assert_non_null(strstr(last_message, "allowed from"));
        assert_true(value_of(fmi, instance, bad[i].name) == before);
    }
    assert_int_equal(fmi->exit_initialization(instance), FMI_OK);
}

FMI_TEST(enumerations_and_booleans_are_set_in_range_only) {
    static const int bad[] = {0, 3, INT32_MAX, INT32_MIN};
    void *instance = in_initialization(fmi);
    for (size_t i = 0; i < COUNT_OF(bad); ++i) {
        assert_int_equal(fmi->set_item(instance, reference_of("solver.method"), bad[i]), FMI_DISCARD);
        assert_int_equal(integer_of(fmi, instance, "solver.method"), SOLVER_NATIVE);
    }
    for (int truth = 0; truth < 2; ++truth) {
        assert_int_equal(fmi->set_truth(instance, reference_of("status.terminate_on_fall"), truth == 1),
                         FMI_OK);
        assert_int_equal(truth_of(fmi, instance, "status.terminate_on_fall"), truth == 1);
    }
}

FMI_TEST(checks_across_variables_wait_for_the_end_of_initialization) {
    void *instance = new_of_kind(fmi, EXCHANGE);
    set_values(fmi, instance, "leg.length=0.5 leg.min_length=0.6");
    assert_int_equal(fmi->enter_initialization(instance, &from_zero), FMI_OK);
    assert_int_equal(fmi->exit_initialization(instance), FMI_ERROR);
    assert_non_null(strstr(last_message, "leg.length = 0.5 m is refused: it must be at least"));
    assert_non_null(strstr(last_message, "leg.min_length"));
    set_values(fmi, instance, "leg.min_length=0.05"); /* and tried again */
    assert_int_equal(fmi->exit_initialization(instance), FMI_OK);
}

FMI_TEST(refuses_a_body_below_the_ground) {
    void *instance = new_of_kind(fmi, EXCHANGE);
    set_values(fmi, instance, "leg.angle=3.0 foot.y=0.0");
    assert_int_equal(fmi->enter_initialization(instance, &from_zero), FMI_OK);
    assert_int_equal(fmi->exit_initialization(instance), FMI_ERROR);
    assert_non_null(strstr(last_message, "body.y"));
}

FMI_TEST(refuses_wrong_types_outputs_and_null_arrays) {
    const uint32_t text = reference_of("stride.word"), output = reference_of("body.x");
    void *instance = in_continuous_time_mode(fmi);
    double value = 0.0;
    assert_int_equal(fmi->get_reals(instance, &text, 1, &value), FMI_ERROR);
    assert_non_null(strstr(last_message, "stride.word"));
    assert_int_equal(fmi->set_reals(instance, &output, 1, &value), FMI_ERROR);
    assert_non_null(strstr(last_message, "body.x cannot be set at any time"));
    assert_int_equal(fmi->get_reals(instance, &output, 1, NULL), FMI_ERROR);
    assert_int_equal(fmi->get_reals(instance, NULL, 0, NULL), FMI_OK);
}

FMI_TEST(refuses_bad_experiments) {
    static const fmi_experiment bad[] = {{true, 0.0, 0.0, true, 1.0},     {true, NAN, 0.0, true, 1.0},
                                         {true, 1e-6, NAN, true, 1.0},    {true, 1e-6, INFINITY, true, 1.0},
                                         {true, 1e-6, 2.0, true, 1.0},    {true, 1e-6, 0.0, true, NAN},
                                         {true, INFINITY, 0.0, true, 1.0}};
    void *instance = new_of_kind(fmi, EXCHANGE);
    for (size_t i = 0; i < COUNT_OF(bad); ++i) {
        assert_int_equal(fmi->enter_initialization(instance, &bad[i]), FMI_ERROR);
    }
    assert_int_equal(fmi->enter_initialization(instance, &from_zero), FMI_OK);
}

FMI_TEST(initialization_shows_what_would_start) {
    void *instance = in_initialization(fmi);
    double derivatives[CONTINUOUS_STATES], indicators[TDMF_GUARD_COUNT];
    set_values(fmi, instance, "foot.vy=-0.5");
    assert_int_equal(fmi->get_derivatives(instance, derivatives, CONTINUOUS_STATES), FMI_OK);
    assert_true(derivatives[STATE_FOOT_Y] == -0.5);
    assert_int_equal(fmi->get_indicators(instance, indicators, TDMF_GUARD_COUNT), FMI_OK);
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        assert_true(indicators[i] > 0.0);
    }
}

/* ---- running ------------------------------------------------------------------------------------------ */

FMI_TEST(starts_at_any_time) {
    static const char *const names[] = {"time", "apex.time", "event.last_time"};
    void *instance = new_of_kind(fmi, EXCHANGE);
    initialize_unit_at(fmi, instance, -12.5);
    for (int i = 0; i < 3; ++i) {
        assert_true(value_of(fmi, instance, names[i]) == -12.5);
    }
}

FMI_TEST(trial_states_give_finite_answers) {
    static const double wild[] = {0.0, -1.0, 1e-300, -DBL_MAX, DBL_MAX, INFINITY, -INFINITY};
    const int wild_count = (int)(COUNT_OF(wild));
    void *instance = in_continuous_time_mode(fmi);
    for (int element = 0; element < CONTINUOUS_STATES * wild_count; ++element) {
        double states[CONTINUOUS_STATES], derivatives[CONTINUOUS_STATES], indicators[TDMF_GUARD_COUNT];
        write_default_states(states);
        for (int i = 0; i <= element / wild_count; ++i) {
            states[i] = wild[(element + i) % wild_count];
        }
        const uint32_t last = reference_of("foot.x") + (uint32_t)(element / wild_count);
        assert_int_equal(fmi->set_states(instance, states, CONTINUOUS_STATES), FMI_OK);
        assert_int_equal(fmi->set_reals(instance, &last, 1, &wild[element % wild_count]), FMI_OK);
        assert_int_equal(fmi->get_derivatives(instance, derivatives, CONTINUOUS_STATES), FMI_OK);
        assert_int_equal(fmi->get_indicators(instance, indicators, TDMF_GUARD_COUNT), FMI_OK);
        assert_all_finite(derivatives, CONTINUOUS_STATES);
        assert_all_finite(indicators, TDMF_GUARD_COUNT);
    }
}

FMI_TEST(a_state_that_is_not_a_number_is_discarded) {
    void *instance = in_continuous_time_mode(fmi);
    for (int i = 0; i < CONTINUOUS_STATES; ++i) {
        double states[CONTINUOUS_STATES], after[CONTINUOUS_STATES];
        write_default_states(states);
        states[i] = NAN;
        assert_int_equal(fmi->set_states(instance, states, CONTINUOUS_STATES), FMI_DISCARD);
        assert_int_equal(fmi->get_states(instance, after, CONTINUOUS_STATES), FMI_OK);
        assert_true(!isnan(after[i]));
    }
    const uint32_t pair[] = {reference_of("foot.x"), reference_of("leg.length")};
    const double x = value_of(fmi, instance, "foot.x"), half_bad[] = {123.0, NAN};
    assert_int_equal(fmi->set_reals(instance, pair, 2, half_bad), FMI_DISCARD);
    assert_non_null(strstr(last_message, "leg.length is not a number"));
    assert_true(value_of(fmi, instance, "foot.x") == x);
}

/* Sets states in continuous-time mode, enters event mode, and updates. */
static void update_at(const fmi_interface *fmi, void *instance, const double states[CONTINUOUS_STATES],
                      update_answer *answer) {
    assert_int_equal(fmi->set_states(instance, states, CONTINUOUS_STATES), FMI_OK);
    assert_int_equal(fmi->enter_event_mode(instance), FMI_OK);
    assert_int_equal(fmi->update(instance, answer), FMI_OK);
}

FMI_TEST(event_mode_goes_by_the_guards) {
    void *instance = in_continuous_time_mode(fmi);
    double states[CONTINUOUS_STATES];
    update_answer answer;
    assert_int_equal(fmi->get_states(instance, states, CONTINUOUS_STATES), FMI_OK);
    update_at(fmi, instance, states, &answer);
    assert_false(answer.states_changed || answer.needs_update || answer.terminate ||
                 answer.nominals_changed || answer.next_time_defined);
    assert_int_equal(integer_of(fmi, instance, "event.count"), 0);
    assert_int_equal(fmi->enter_continuous_time_mode(instance), FMI_OK);
    states[STATE_FOOT_Y] = -1e-11;
    states[STATE_FOOT_VY] = -0.1;
    assert_int_equal(fmi->set_time(instance, 0.5), FMI_OK); /* no part of the start */
    update_at(fmi, instance, states, &answer);
    assert_true(answer.states_changed && !answer.terminate);
    assert_int_equal(integer_of(fmi, instance, "event.count"), 1);
    assert_true(value_of(fmi, instance, "foot.vy") == 0.0);
    assert_true(value_of(fmi, instance, "energy.impact_loss") > 0.0);
}

FMI_TEST(a_fall_freezes_and_asks_to_stop_where_the_parameter_says_so) {
    for (int i = 0; i < 3; ++i) {
        void *instance = new_of_kind(fmi, EXCHANGE);
        const bool stops = i > 0; /* by default, too */
        double states[CONTINUOUS_STATES], derivatives[CONTINUOUS_STATES];
        update_answer answer;
        if (i < 2) {
            assert_int_equal(fmi->set_truth(instance, reference_of("status.terminate_on_fall"), stops),
                             FMI_OK);
        }
        begin(fmi, instance, EXCHANGE);
        write_default_states(states);
        states[STATE_LEG_LENGTH] = 0.01;
        update_at(fmi, instance, states, &answer);
        assert_int_equal(answer.terminate, stops);
        assert_int_equal(fmi->enter_continuous_time_mode(instance), FMI_OK);
        assert_int_equal(fmi->get_derivatives(instance, derivatives, CONTINUOUS_STATES), FMI_OK);
        assert_all_are(derivatives, CONTINUOUS_STATES, 0.0);
        assert_true(value_of(fmi, instance, "leg.length") == 0.01);
    }
}

FMI_TEST(nominals_follow_the_parameters) {
    for (int early = 0; early < 2; ++early) { /* in initialization mode, and after it */
        double nominals[CONTINUOUS_STATES];
        void *instance = in_initialization(fmi);
        set_values(fmi, instance, "body.mass=4.0 leg.stiffness=100.0 leg.free_length=2.0");
        if (early == 0) {
            assert_int_equal(fmi->exit_initialization(instance), FMI_OK);
        }
        assert_int_equal(fmi->get_nominals(instance, nominals, CONTINUOUS_STATES), FMI_OK);
        assert_true(nominals[STATE_FOOT_X] == 2.0);
        assert_true(nominals[STATE_LEG_LENGTH] == 2.0);
        assert_true(nominals[STATE_FOOT_VX] == 10.0);
        assert_true(nominals[STATE_LEG_ANGLE_RATE] == 5.0);
        assert_true(nominals[STATE_HIP_WORK] == 400.0);
    }
}

/* Flight without an external force is a mode of its own. A force that an importer sets acts at once, and the
 * derivative by the force is right before. */
FMI_TEST(a_push_on_a_calm_flight_acts_at_once) {
    const uint32_t unknown = reference_of("der(leg.angle_rate)"), known = reference_of("body.external_fx");
    const double step = 1e-3;
    void *instance = in_continuous_time_mode(fmi);
    double found[2];
    const double before = derivative_of(fmi, instance, unknown, known);
    for (int i = 0; i < 2; ++i) {
        assert_int_equal(set_value(fmi, instance, "body.external_fx", i == 0 ? -step : step), FMI_OK);
        found[i] = value_of(fmi, instance, "der(leg.angle_rate)");
    }
    assert_true(fabs(before) > 0.5);
    assert_close(before, (found[1] - found[0]) / (2.0 * step), 1e-9);
    assert_close(derivative_of(fmi, instance, unknown, known), before, 1e-12);
}
