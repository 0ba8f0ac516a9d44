/* Arguments of the calls of both FMI versions: which values are checked, and what a refused call leaves in
 * its output arguments; and what FMI 3.0 alone offers to an importer: types and adjoint derivatives. */
#include "instance.h" /* before cmocka, which has a macro fail */

#include "compare.h"
#include "fmi2_importer.h"
#include "fmi3_importer.h"

#include "guid.h"
#include "tdmf_slip/tdmf_slip.h"
#include "variables.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* A Model Exchange instance in continuous-time mode. */
static void *running(const fmi_interface *fmi) {
    return begun(fmi, EXCHANGE, "");
}

/* ---- counts and references ---------------------------------------------------------------------------- */

static void assert_miscounted(fmi3Status status) {
    assert_int_equal(status, fmi3Error);
    assert_non_null(strstr(last_message, "every variable is a scalar"));
    clear_messages();
}

TEST(as_many_values_as_references_are_wanted) {
    const fmi3ValueReference friction = reference_of("ground.friction"), word = reference_of("stride.word");
    double value = 0.5;
    fmi3String text = "x";
    fmi3Instance instance = running(&fmi3);
    for (size_t wrong = 0; wrong <= 2; wrong += 2) {
        assert_miscounted(fmi3GetFloat64(instance, &friction, 1, &value, wrong));
        assert_miscounted(fmi3SetFloat64(instance, &friction, 1, &value, wrong));
        assert_miscounted(fmi3GetString(instance, &word, 1, &text, wrong));
        assert_miscounted(fmi3SetString(instance, &word, 1, &text, wrong));
    }
    assert_true(get_float(instance, "ground.friction") == 0.6);
}

TEST(derivatives_want_as_many_seeds_and_values_as_there_are) {
    const fmi3ValueReference unknowns[] = {reference_of("body.x"), reference_of("body.y")};
    const fmi3ValueReference knowns[] = {reference_of("leg.angle"), reference_of("leg.length"),
                                         reference_of("foot.x")};
    static const double seeds[4] = {1.0, 2.0, 3.0, 4.0};
    double values[4] = {77.0, 77.0, 77.0, 77.0};
    fmi3Instance instance = running(&fmi3);
    for (int i = -1; i <= 1; i += 2) {
        const size_t two = (size_t)(2 + i), three = (size_t)(3 + i);
        assert_miscounted(
            fmi3GetDirectionalDerivative(instance, unknowns, 2, knowns, 3, seeds, three, values, 2));
        assert_miscounted(
            fmi3GetDirectionalDerivative(instance, unknowns, 2, knowns, 3, seeds, 3, values, two));
        assert_miscounted(fmi3GetAdjointDerivative(instance, unknowns, 2, knowns, 3, seeds, two, values, 3));
        assert_miscounted(
            fmi3GetAdjointDerivative(instance, unknowns, 2, knowns, 3, seeds, 2, values, three));
    }
    assert_all_are(values, 4, 77.0);
    assert_int_equal(fmi3GetDirectionalDerivative(instance, unknowns, 2, knowns, 3, seeds, 3, values, 2),
                     fmi3OK);
    assert_true(values[1] != 77.0 && values[2] == 77.0);
    assert_int_equal(fmi3GetAdjointDerivative(instance, unknowns, 2, knowns, 3, seeds, 2, values, 3), fmi3OK);
    assert_true(values[2] != 77.0 && values[3] == 77.0);
}

TEST(output_derivatives_want_values_for_each) {
    const fmi3ValueReference output = reference_of("body.y");
    const fmi3Int32 first = 1;
    double value = 77.0;
    fmi3Instance instance = new_stepper(false, false);
    initialize3(instance);
    assert_int_equal(fmi3GetOutputDerivatives(instance, &output, 1, &first, &value, 2), fmi3Error);
    assert_int_equal(fmi3GetOutputDerivatives(instance, &output, 1, &first, &value, 0), fmi3Error);
    assert_true(value == 77.0);
    for (fmi3Int32 order = -1; order <= 2; ++order) {
        assert_int_equal(fmi3GetOutputDerivatives(instance, &output, 1, &order, &value, 1),
                         order == 1 ? fmi3OK : fmi3Error);
    }
}

FMI_TEST(the_reference_after_the_last_is_unknown) {
    const uint32_t beyond = (uint32_t)fmu_variable_count, known = reference_of("foot.x");
    const double one = 1.0;
    double value = 77.0;
    void *instance = running(fmi);
    assert_int_equal(fmi->get_reals(instance, &beyond, 1, &value), FMI_ERROR);
    assert_non_null(strstr(last_message, "there is no value reference"));
    assert_int_equal(fmi->set_reals(instance, &beyond, 1, &one), FMI_ERROR);
    assert_int_equal(fmi->directional_derivative(instance, &beyond, 1, &known, 1, &one, &value), FMI_ERROR);
    assert_int_equal(fmi->directional_derivative(instance, &known, 1, &beyond, 1, &one, &value), FMI_ERROR);
    assert_true(value == 77.0);
}

FMI_TEST(arrays_are_neither_too_short_nor_too_long) {
    double values[TDMF_GUARD_COUNT + 1] = {0};
    void *instance = running(fmi);
    char count[8];
    snprintf(count, sizeof count, "%d", CONTINUOUS_STATES);
    for (int i = -1; i <= 1; i += 2) {
        const size_t states = (size_t)(CONTINUOUS_STATES + i), guards = (size_t)(TDMF_GUARD_COUNT + i);
        assert_int_equal(fmi->get_states(instance, values, states), FMI_ERROR);
        assert_non_null(strstr(last_message, count));
        assert_int_equal(fmi->set_states(instance, values, states), FMI_ERROR);
        assert_int_equal(fmi->get_derivatives(instance, values, states), FMI_ERROR);
        assert_non_null(strstr(last_message, count));
        assert_int_equal(fmi->get_nominals(instance, values, states), FMI_ERROR);
        assert_int_equal(fmi->get_indicators(instance, values, guards), FMI_ERROR);
    }
}

TEST(texts_are_set_nowhere_and_none_of_them_where_setting_is_allowed) {
    const fmi2ValueReference word = reference_of("stride.word");
    const fmi2String text = "x";
    fmi2Component component = running(&fmi2);
    assert_int_equal(fmi2SetString(component, NULL, 0, NULL), fmi2OK);
    assert_int_equal(fmi2SetString(component, &word, 1, &text), fmi2Error);
    assert_non_null(strstr(last_message, "stride.word cannot be set at any time"));
    assert_int_equal(fmi2Terminate(component), fmi2OK);
    assert_int_equal(fmi2SetString(component, NULL, 0, NULL), fmi2Error);
}

/* ---- answers ------------------------------------------------------------------------------------------- */

FMI_TEST(a_completed_step_asks_for_nothing) {
    bool enter = true, stop = true;
    void *instance = running(fmi);
    assert_int_equal(fmi->complete_step(instance, &enter, &stop), FMI_OK);
    assert_true(!enter && !stop);
}

TEST(counts_of_work_end_at_the_largest_integer) {
    fmi2Component component = new_slave();
    instance *inside = component;
    initialize(component);
    assert_int_equal(fmi2DoStep(component, 0.0, 1.0, fmi2True), fmi2OK);
    assert_true(get_whole(component, "solver.steps") > 0);
    inside->run.work[WORK_STEPS] = (int64_t)INT_MAX + 1;
    inside->run.work[WORK_EVALUATIONS] = INT64_MAX;
    inside->current = 0;
    assert_int_equal(get_whole(component, "solver.steps"), INT_MAX);
    assert_int_equal(get_whole(component, "solver.evaluations"), INT_MAX);
}

/* Instances can fail before the run, for example without memory. Their enumerations still have no value 0. */
TEST(an_instance_that_fails_before_its_run_shows_its_start) {
    const fmi2ValueReference mode = reference_of("contact.mode");
    fmi2Integer value = 77;
    fmi2Component component = new_slave();
    instance *inside = component;
    inside->run.state = FAILED;
    assert_int_equal(get_whole(component, "contact.mode"), TDMF_CONTACT_FLIGHT);
    assert_int_equal(get_whole(component, "hip.phase"), TDMF_PHASE_PLACE);
    inside->run.state = INSTANTIATED;
    set_values(&fmi2, component, "leg.min_length=2.0");
    inside->run.state = FAILED;
    assert_int_equal(fmi2GetInteger(component, &mode, 1, &value), fmi2Discard);
    assert_int_equal(value, 77);
}

/* The force of the instant before an input changes it counts for the peak of the stride. */
TEST(event_mode_is_entered_with_the_force_noted) {
    double states[CONTINUOUS_STATES];
    fmi2Component component = new_instance();
    const instance *inside = component;
    bool is_noted = false;
    set_values(&fmi2, component,
               "foot.y=0.0 foot.vx=0.0 foot.vy=0.0 leg.angle=0.1 leg.length=0.9 ground.friction=10.0");
    start_running(component);
    assert_int_equal(get_whole(component, "contact.mode"), TDMF_CONTACT_STICK);
    assert_int_equal(fmi2GetContinuousStates(component, states, CONTINUOUS_STATES), fmi2OK);
    const double before = get_real(component, "contact.fy");
    states[STATE_LEG_LENGTH] = 0.7;
    assert_int_equal(fmi2SetContinuousStates(component, states, CONTINUOUS_STATES), fmi2OK);
    const double force = get_real(component, "contact.fy");
    assert_true(force > 1.5 * before);
    assert_int_equal(fmi2EnterEventMode(component), fmi2OK);
    set_values(&fmi2, component, "hip.external_torque=1.0");
    assert_true(get_real(component, "contact.fy") < force);
    for (int i = 0; i < UNIT_NUMBER_COUNT; ++i) {
        is_noted |= fabs(inside->run.motion.numbers[i] - force) <= 1e-15 * force;
    }
    assert_true(is_noted);
}

/* ---- time ---------------------------------------------------------------------------------------------- */

static fmi_status initialize_from(const fmi_interface *fmi, void *instance, double start, bool has_stop,
                                  double stop) {
    const fmi_experiment experiment = {.start = start, .has_stop = has_stop, .stop = stop};
    const fmi_status status = fmi->enter_initialization(instance, &experiment);
    return status == FMI_OK ? fmi->exit_initialization(instance) : status;
}

FMI_TEST(a_run_may_stop_where_it_starts) {
    void *instance = new_of_kind(fmi, STEPS);
    assert_int_equal(initialize_from(fmi, instance, 2.0, true, nextafter(2.0, 0.0)), FMI_ERROR);
    assert_int_equal(initialize_from(fmi, instance, 2.0, true, 2.0), FMI_OK);
}

/* One step from the start of a runner whose leg turns at a rate. */
static step_answer step_of(fmi3Instance instance, double angle_rate, double end) {
    step_answer answer;
    assert_int_equal(fmi3Reset(instance), fmi3OK);
    assert_int_equal(set_float(instance, "leg.angle_rate", angle_rate), fmi3OK);
    initialize3(instance);
    assert_int_equal(fmi3EnterStepMode(instance), fmi3OK);
    assert_int_equal(do_step(instance, 0.0, end, &answer), fmi3OK);
    return answer;
}

/* A step that ends exactly at an event reports the event, but not an early return. The time of an event is
 * known more finely than the end of a step, so only every other runner's step can end at its event. */
TEST(a_step_that_ends_at_an_event_is_not_early) {
    enum { RUNNERS = 20 };
    int met = 0;
    fmi3Instance instance = new_stepper(true, true);
    for (int i = 0; i < RUNNERS; ++i) {
        const double angle_rate = 1e-3 * i;
        const step_answer first = step_of(instance, angle_rate, 20.0);
        assert_true(first.event && first.early);
        const double ends[] = {first.time, nextafter(first.time, INFINITY)};
        for (int j = 0; j < 2; ++j) {
            const step_answer answer = step_of(instance, angle_rate, ends[j]);
            assert_true(answer.early == (answer.event && answer.time < ends[j]));
            met += answer.event && answer.time == ends[j];
        }
    }
    assert_true(met > RUNNERS / 5);
}

/* ---- instantiation ------------------------------------------------------------------------------------ */

TEST(refuses_an_interface_it_does_not_have) {
    clear_messages();
    assert_null(fmi3InstantiateScheduledExecution("runner", FMU_GUID, NULL, false, false, NULL,
                                                  importer_logger, NULL, NULL, NULL));
    assert_non_null(strstr(last_message, "Scheduled Execution"));
}

static void called_back(fmi3InstanceEnvironment environment, fmi3Float64 time, fmi3Boolean set_requested,
                        fmi3Boolean get_allowed, fmi3Boolean step_finished, fmi3Boolean may_return_early,
                        fmi3Boolean *early_return, fmi3Float64 *early_return_time) {
    (void)environment;
    (void)time;
    (void)set_requested;
    (void)get_allowed;
    (void)step_finished;
    (void)may_return_early;
    (void)early_return;
    (void)early_return_time;
    fail_msg("the unit has called back");
}

/* Intermediate updates are an offer that the unit need not take up. */
TEST(an_importer_that_offers_intermediate_updates_is_never_called_back) {
    const fmi3ValueReference wanted[] = {reference_of("foot.x"), reference_of("leg.angle")};
    clear_messages();
    for (int way = 0; way < 4; ++way) {
        const fmi3Boolean event_mode = way >= 2, early_return = way % 2 == 1;
        double foot_x[2];
        for (int offers = 0; offers < 2; ++offers) {
            fmi3Instance instance = fmi3InstantiateCoSimulation(
                "runner", FMU_GUID, NULL, false, false, event_mode, early_return, offers ? wanted : NULL,
                offers ? 2 : 0, NULL, importer_logger, offers ? called_back : NULL);
            step_answer answer;
            assert_non_null(instance);
            free_after_test(instance, fmi3FreeInstance);
            initialize3(instance);
            if (event_mode) {
                update_and_go_on(&fmi3, instance, STEPS_WITH_EVENTS);
            }
            for (int i = 0; i < 4; ++i) { /* early, to the first event */
                assert_int_equal(do_step(instance, get_float(instance, "time"), 40.0, &answer), fmi3OK);
                if (answer.event) {
                    take_event(&fmi3, instance, STEPS_WITH_EVENTS, "");
                }
            }
            assert_int_equal(answer.event, way == 3);
            foot_x[offers] = get_float(instance, "foot.x");
        }
        assert_true(foot_x[0] == foot_x[1]);
    }
    assert_int_equal(message_count, 0);
}

/* ---- values ------------------------------------------------------------------------------------------- */

TEST(every_variable_is_read_by_its_own_type_only) {
    fmi3Instance instance = running(&fmi3);
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmi3ValueReference reference = (fmi3ValueReference)i;
        double real;
        fmi3Int32 integer;
        fmi3Int64 item;
        fmi3Boolean truth;
        fmi3String text;
        const fmu_variable_type type = fmu_variables[i].type;
        const fmi3Status found[] = {fmi3GetFloat64(instance, &reference, 1, &real, 1),
                                    fmi3GetInt32(instance, &reference, 1, &integer, 1),
                                    fmi3GetInt64(instance, &reference, 1, &item, 1),
                                    fmi3GetBoolean(instance, &reference, 1, &truth, 1),
                                    fmi3GetString(instance, &reference, 1, &text, 1)};
        static const fmu_variable_type types[] = {VARIABLE_REAL, VARIABLE_INTEGER, VARIABLE_ENUMERATION,
                                                  VARIABLE_BOOLEAN, VARIABLE_STRING};
        for (size_t j = 0; j < COUNT_OF(types); ++j) {
            assert_int_equal(found[j], types[j] == type ? fmi3OK : fmi3Error);
        }
    }
}

/* The values include some that do not fit an Integer of FMI 2.0. */
TEST(enumerations_are_set_in_range_only) {
    const fmi3ValueReference method = reference_of("solver.method");
    static const fmi3Int64 bad[] = {INT64_MAX, INT64_MIN, (INT64_C(1) << 32) + 2};
    fmi3Instance instance = new_exchange();
    for (size_t i = 0; i < COUNT_OF(bad); ++i) {
        assert_int_equal(fmi3SetInt64(instance, &method, 1, &bad[i], 1), fmi3Discard);
        assert_int_equal(get_int(instance, "solver.method"), 1);
    }
}

TEST(indicators_are_variables_too) {
    double indicators[TDMF_GUARD_COUNT];
    const fmi3ValueReference first = reference_of("guard.touchdown");
    fmi3Instance instance = running(&fmi3);
    assert_int_equal(fmi3GetEventIndicators(instance, indicators, TDMF_GUARD_COUNT), fmi3OK);
    assert_close(indicators[TDMF_GUARD_TOUCHDOWN], get_float(instance, "foot.y"), 1e-9);
    for (fmi3ValueReference i = 0; i < TDMF_GUARD_COUNT; ++i) {
        const fmi3ValueReference reference = first + i;
        double value;
        assert_int_equal(fmi3GetFloat64(instance, &reference, 1, &value, 1), fmi3OK);
        assert_true(value == indicators[i]);
    }
}

/* ---- derivatives -------------------------------------------------------------------------------------- */

TEST(derivatives_by_what_is_fixed_are_refused) {
    const fmi3ValueReference unknown = reference_of("body.x"), mass = reference_of("body.mass"),
                             known = reference_of("leg.angle");
    const double seed = 1.0, bad = NAN;
    double value;
    fmi3Instance instance = running(&fmi3);
    assert_int_equal(fmi3GetAdjointDerivative(instance, &unknown, 1, &known, 1, &bad, 1, &value, 1),
                     fmi3Discard);
    assert_int_equal(fmi3GetDirectionalDerivative(instance, &unknown, 1, &known, 1, &bad, 1, &value, 1),
                     fmi3Discard);
    assert_int_equal(fmi3GetAdjointDerivative(instance, &unknown, 1, &mass, 1, &seed, 1, &value, 1),
                     fmi3Error);
    assert_non_null(
        strstr(last_message, "body.mass is neither a state nor an input nor tunable, and the run has begun"));
    assert_int_equal(fmi3GetDirectionalDerivative(instance, &unknown, 1, &unknown, 1, &seed, 1, &value, 1),
                     fmi3Error);
    assert_int_equal(fmi3GetDirectionalDerivative(instance, &mass, 1, &known, 1, &seed, 1, &value, 1),
                     fmi3Error);
}
