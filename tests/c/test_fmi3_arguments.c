/* What calls of both FMI versions look at in their arguments, and what they leave in those that they answer
 * in. */
#include "instance.h" /* before cmocka, which has a macro fail */

#include "compare.h"
#include "fmi2_importer.h"
#include "fmi3_importer.h"

#include "tdmf_slip/tdmf_slip.h"
#include "variables.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

/* A Model Exchange instance of either version in continuous-time mode. */
static fmi2Component running2(void) {
    fmi2Component component = new_instance();
    start_running(component);
    return component;
}

static fmi3Instance running3(void) {
    fmi3Instance instance = new_exchange();
    initialize3(instance);
    assert_int_equal(fmi3EnterContinuousTimeMode(instance), fmi3OK);
    return instance;
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
    fmi3Instance instance = running3();
    for (size_t wrong = 0; wrong <= 2; wrong += 2) {
        assert_miscounted(fmi3GetFloat64(instance, &friction, 1, &value, wrong));
        assert_miscounted(fmi3SetFloat64(instance, &friction, 1, &value, wrong));
        assert_miscounted(fmi3GetString(instance, &word, 1, &text, wrong));
        assert_miscounted(fmi3SetString(instance, &word, 1, &text, wrong));
    }
    assert_true(get_float(instance, "ground.friction") == 0.6);
    fmi3FreeInstance(instance);
}

TEST(derivatives_want_as_many_seeds_and_values_as_there_are) {
    const fmi3ValueReference unknowns[] = {reference_of("body.x"), reference_of("body.y")};
    const fmi3ValueReference knowns[] = {reference_of("leg.angle"), reference_of("leg.length"),
                                         reference_of("foot.x")};
    static const double seeds[4] = {1.0, 2.0, 3.0, 4.0};
    double values[4] = {77.0, 77.0, 77.0, 77.0};
    fmi3Instance instance = running3();
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
    for (int i = 0; i < 4; ++i) {
        assert_true(values[i] == 77.0);
    }
    assert_int_equal(fmi3GetDirectionalDerivative(instance, unknowns, 2, knowns, 3, seeds, 3, values, 2),
                     fmi3OK);
    assert_true(values[1] != 77.0 && values[2] == 77.0);
    assert_int_equal(fmi3GetAdjointDerivative(instance, unknowns, 2, knowns, 3, seeds, 2, values, 3), fmi3OK);
    assert_true(values[2] != 77.0 && values[3] == 77.0);
    fmi3FreeInstance(instance);
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
    fmi3FreeInstance(instance);
}

TEST(the_reference_after_the_last_is_unknown) {
    const fmi2ValueReference beyond = (fmi2ValueReference)fmu_variable_count, known = reference_of("foot.x");
    const double one = 1.0;
    double value = 77.0;
    fmi2Component component = running2();
    assert_int_equal(fmi2GetReal(component, &beyond, 1, &value), fmi2Error);
    assert_non_null(strstr(last_message, "there is no value reference"));
    assert_int_equal(fmi2SetReal(component, &beyond, 1, &one), fmi2Error);
    assert_int_equal(fmi2GetDirectionalDerivative(component, &beyond, 1, &known, 1, &one, &value), fmi2Error);
    assert_int_equal(fmi2GetDirectionalDerivative(component, &known, 1, &beyond, 1, &one, &value), fmi2Error);
    assert_true(value == 77.0);
    fmi2FreeInstance(component);
}

TEST(arrays_are_neither_too_short_nor_too_long) {
    double values[TDMF_GUARD_COUNT + 1] = {0};
    fmi2Component old = running2();
    fmi3Instance new = running3();
    for (int i = -1; i <= 1; i += 2) {
        const size_t states = (size_t)(TDMF_STATE_COUNT + i), guards = (size_t)(TDMF_GUARD_COUNT + i);
        assert_int_equal(fmi2GetContinuousStates(old, values, states), fmi2Error);
        assert_int_equal(fmi2SetContinuousStates(old, values, states), fmi2Error);
        assert_int_equal(fmi2GetDerivatives(old, values, states), fmi2Error);
        assert_int_equal(fmi2GetNominalsOfContinuousStates(old, values, states), fmi2Error);
        assert_int_equal(fmi2GetEventIndicators(old, values, guards), fmi2Error);
        assert_int_equal(fmi3GetContinuousStates(new, values, states), fmi3Error);
        assert_int_equal(fmi3SetContinuousStates(new, values, states), fmi3Error);
        assert_int_equal(fmi3GetContinuousStateDerivatives(new, values, states), fmi3Error);
        assert_int_equal(fmi3GetNominalsOfContinuousStates(new, values, states), fmi3Error);
        assert_int_equal(fmi3GetEventIndicators(new, values, guards), fmi3Error);
    }
    fmi2FreeInstance(old);
    fmi3FreeInstance(new);
}

TEST(texts_are_set_nowhere_and_none_of_them_where_setting_is_allowed) {
    const fmi2ValueReference word = reference_of("stride.word");
    const fmi2String text = "x";
    fmi2Component component = running2();
    assert_int_equal(fmi2SetString(component, NULL, 0, NULL), fmi2OK);
    assert_int_equal(fmi2SetString(component, &word, 1, &text), fmi2Error);
    assert_non_null(strstr(last_message, "stride.word cannot be set at any time"));
    assert_int_equal(fmi2Terminate(component), fmi2OK);
    assert_int_equal(fmi2SetString(component, NULL, 0, NULL), fmi2Error);
    fmi2FreeInstance(component);
}

/* ---- answers ------------------------------------------------------------------------------------------- */

TEST(a_completed_step_asks_for_nothing) {
    fmi2Boolean enter2 = fmi2True, stop2 = fmi2True;
    fmi3Boolean enter3 = true, stop3 = true;
    fmi2Component old = running2();
    fmi3Instance new = running3();
    assert_int_equal(fmi2CompletedIntegratorStep(old, fmi2True, &enter2, &stop2), fmi2OK);
    assert_int_equal(fmi3CompletedIntegratorStep(new, true, &enter3, &stop3), fmi3OK);
    assert_true(enter2 == fmi2False && stop2 == fmi2False && !enter3 && !stop3);
    fmi2FreeInstance(old);
    fmi3FreeInstance(new);
}

TEST(counts_of_work_end_at_the_largest_integer) {
    fmi2Component component = new_slave();
    instance *inside = component;
    initialize(component);
    assert_int_equal(fmi2DoStep(component, 0.0, 1.0, fmi2True), fmi2OK);
    assert_true(get_integer(component, "solver.steps") > 0);
    inside->fmu.work[WORK_STEPS] = (int64_t)INT_MAX + 1;
    inside->fmu.work[WORK_EVALUATIONS] = INT64_MAX;
    discard_view(inside);
    assert_int_equal(get_integer(component, "solver.steps"), INT_MAX);
    assert_int_equal(get_integer(component, "solver.evaluations"), INT_MAX);
    fmi2FreeInstance(component);
}

/* Out of memory, say: enumerations have no value 0, and there is a start to read. */
TEST(an_instance_that_fails_before_its_run_shows_its_start) {
    const fmi2ValueReference mode = reference_of("contact.mode");
    fmi2Integer value = 77;
    fmi2Component component = new_slave();
    instance *inside = component;
    inside->state = FAILED;
    assert_int_equal(get_integer(component, "contact.mode"), TDMF_CONTACT_FLIGHT);
    assert_int_equal(get_integer(component, "hip.phase"), TDMF_PHASE_PLACE);
    inside->state = INSTANTIATED;
    assert_int_equal(set_real(component, "leg.min_length", 2.0), fmi2OK);
    inside->state = FAILED;
    assert_int_equal(fmi2GetInteger(component, &mode, 1, &value), fmi2Discard);
    assert_int_equal(value, 77);
    fmi2FreeInstance(component);
}

/* The force of this instant is met before an input may change it: the stride's peak has it. */
TEST(event_mode_is_entered_with_the_force_noted) {
    double states[TDMF_STATE_COUNT];
    fmi2Component component = new_instance();
    const instance *inside = component;
    bool is_noted = false;
    assert_int_equal(set_real(component, "foot.y", 0.0), fmi2OK);
    assert_int_equal(set_real(component, "foot.vx", 0.0), fmi2OK);
    assert_int_equal(set_real(component, "foot.vy", 0.0), fmi2OK);
    assert_int_equal(set_real(component, "leg.angle", 0.1), fmi2OK);
    assert_int_equal(set_real(component, "leg.length", 0.9), fmi2OK);
    assert_int_equal(set_real(component, "ground.friction", 10.0), fmi2OK);
    start_running(component);
    assert_int_equal(get_integer(component, "contact.mode"), TDMF_CONTACT_STICK);
    assert_int_equal(fmi2GetContinuousStates(component, states, TDMF_STATE_COUNT), fmi2OK);
    const double before = get_real(component, "contact.fy");
    states[TDMF_LEG_LENGTH] = 0.7;
    assert_int_equal(fmi2SetContinuousStates(component, states, TDMF_STATE_COUNT), fmi2OK);
    const double force = get_real(component, "contact.fy");
    assert_true(force > 1.5 * before);
    assert_int_equal(fmi2EnterEventMode(component), fmi2OK);
    assert_int_equal(set_real(component, "hip.external_torque", 1.0), fmi2OK);
    assert_true(get_real(component, "contact.fy") < force);
    for (int i = 0; i < UNIT_NUMBER_COUNT; ++i) {
        is_noted |= fabs(inside->fmu.motion.numbers[i] - force) <= 1e-15 * force;
    }
    assert_true(is_noted);
    fmi2FreeInstance(component);
}

/* ---- time ---------------------------------------------------------------------------------------------- */

static fmi2Status initialize_from(fmi2Component component, double start, bool has_stop, double stop) {
    const fmi2Status status = fmi2SetupExperiment(component, fmi2False, 0.0, start, has_stop, stop);
    if (status != fmi2OK) {
        return status;
    }
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
    return fmi2ExitInitializationMode(component);
}

TEST(a_run_may_stop_where_it_starts) {
    fmi2Component component = new_slave();
    assert_int_equal(initialize_from(component, 2.0, true, nextafter(2.0, 0.0)), fmi2Error);
    assert_int_equal(initialize_from(component, 2.0, true, 2.0), fmi2OK);
    fmi2FreeInstance(component);
}

TEST(an_endless_tolerance_is_refused) {
    fmi2Component component = new_slave();
    assert_int_equal(fmi2SetupExperiment(component, fmi2True, INFINITY, 0.0, fmi2False, 0.0), fmi2Error);
    fmi2FreeInstance(component);
}

/* 0.1 + 0.2 > 0.3 in doubles. */
TEST(rounding_does_not_carry_a_step_beyond_the_stop_time) {
    fmi2Component component = new_slave();
    assert_true(0.1 + 0.2 > 0.3);
    assert_int_equal(initialize_from(component, 0.0, true, 0.3), fmi2OK);
    assert_int_equal(fmi2DoStep(component, 0.0, 0.1, fmi2True), fmi2OK);
    assert_int_equal(fmi2DoStep(component, 0.1, 0.2, fmi2True), fmi2OK);
    fmi2FreeInstance(component);
}

TEST(communication_points_are_off_by_rounding_only) {
    static const double epoch = 1.7e9, step = 1e-3;
    fmi2Component component = new_slave();
    assert_int_equal(initialize_from(component, 0.0, false, 0.0), fmi2OK);
    assert_int_equal(fmi2DoStep(component, 0.0, 1.0, fmi2True), fmi2OK);
    assert_int_equal(fmi2DoStep(component, 1.0 + 1e-4, 1.0, fmi2True), fmi2Error);
    assert_int_equal(fmi2DoStep(component, 1.0 + 1e-7, 1.0, fmi2True), fmi2OK);
    assert_int_equal(fmi2Reset(component), fmi2OK);
    assert_int_equal(initialize_from(component, epoch, false, 0.0), fmi2OK);
    assert_int_equal(fmi2DoStep(component, epoch, step, fmi2True), fmi2OK);
    assert_int_equal(fmi2DoStep(component, nextafter(epoch + step, INFINITY), step, fmi2True), fmi2OK);
    fmi2FreeInstance(component);
}

TEST(a_step_beyond_all_numbers_is_refused) {
    fmi2Component component = new_slave();
    initialize(component);
    assert_int_equal(fmi2DoStep(component, DBL_MAX, DBL_MAX, fmi2True), fmi2Error);
    assert_non_null(strstr(last_message, "not a positive number"));
    assert_int_equal(fmi2DoStep(component, 0.0, 1.0, fmi2True), fmi2OK);
    fmi2FreeInstance(component);
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

/* A step that ends at the very instant of an event has one to handle, but has not returned early. An event is
 * known finer than a step's end, so that only every other runner's step can end at its own. */
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
    fmi3FreeInstance(instance);
}

/* The apex is found again under an input set at it: its time is that of the event. */
TEST(an_apex_under_another_input_is_at_the_same_time) {
    step_answer step;
    update_answer after;
    double time = 0.0;
    fmi3Instance instance = new_stepper(true, true);
    initialize3(instance);
    assert_int_equal(fmi3EnterStepMode(instance), fmi3OK);
    for (int i = 0; i < 9; ++i) {
        assert_int_equal(do_step(instance, time, 30.0, &step), fmi3OK);
        assert_true(step.event);
        time = step.time;
        assert_int_equal(fmi3EnterEventMode(instance), fmi3OK);
        if (i == 8) {
            assert_int_equal(set_float(instance, "hip.external_torque", 1e-3), fmi3OK);
        }
        assert_int_equal(update(instance, &after), fmi3OK);
        assert_int_equal(fmi3EnterStepMode(instance), fmi3OK);
    }
    assert_int_equal(get_int(instance, "stride.count"), 1);
    assert_true(get_float(instance, "apex.time") == time);
    assert_true(get_float(instance, "event.last_time") == time);
    fmi3FreeInstance(instance);
}

/* ---- Co-Simulation of FMI 2.0 -------------------------------------------------------------------------- */

TEST(rates_are_numbers_and_set_in_their_states) {
    const fmi2ValueReference torque = reference_of("hip.external_torque");
    const fmi2Integer first = 1;
    static const double endless = -INFINITY, still = 0.0;
    fmi2Component slave = new_slave(), exchange = running2();
    assert_int_equal(fmi2SetRealInputDerivatives(slave, &torque, 1, &first, &still), fmi2OK);
    initialize(slave);
    assert_int_equal(fmi2SetRealInputDerivatives(slave, &torque, 1, &first, &endless), fmi2Discard);
    assert_int_equal(fmi2SetRealInputDerivatives(slave, &torque, 1, &first, NULL), fmi2Error);
    assert_int_equal(fmi2SetRealInputDerivatives(slave, &torque, 1, NULL, &still), fmi2Error);
    assert_int_equal(fmi2SetRealInputDerivatives(slave, &torque, 1, &first, &still), fmi2OK);
    assert_int_equal(fmi2Terminate(slave), fmi2OK);
    assert_int_equal(fmi2SetRealInputDerivatives(slave, &torque, 1, &first, &still), fmi2Error);
    assert_int_equal(fmi2SetRealInputDerivatives(exchange, &torque, 1, &first, &still), fmi2Error);
    fmi2FreeInstance(slave);
    fmi2FreeInstance(exchange);
}

/* The runner is frozen, its surroundings are not. */
TEST(inputs_go_on_at_their_rates_after_a_fall) {
    const fmi2ValueReference torque = reference_of("hip.external_torque");
    const fmi2Integer first = 1;
    const double rate = 1e-3;
    fmi2Component component = new_slave();
    assert_int_equal(set_real(component, "foot.y", 100.0), fmi2OK);
    initialize(component);
    assert_int_equal(fmi2SetRealInputDerivatives(component, &torque, 1, &first, &rate), fmi2OK);
    assert_int_equal(fmi2DoStep(component, 0.0, 2000.0, fmi2True), fmi2OK);
    assert_true(get_real(component, "event.last_time") < 1000.0);
    assert_close(get_real(component, "hip.external_torque"), 2.0, 1e-12);
    assert_int_equal(fmi2DoStep(component, 2000.0, 500.0, fmi2True), fmi2OK);
    assert_close(get_real(component, "hip.external_torque"), 2.5, 1e-12);
    fmi2FreeInstance(component);
}

/* With inputs that move, outputs go with them. */
TEST(output_derivatives_go_with_the_rates_of_inputs) {
    static const char *const names[] = {"contact.fx", "hip.torque"};
    static const double delta = 1e-5, rates[] = {-0.5, 0.2};
    const fmi2ValueReference inputs[] = {reference_of("ground.friction"),
                                         reference_of("hip.external_torque")};
    const fmi2Integer first[] = {1, 1};
    fmi2Component component = new_slave();
    initialize(component);
    assert_int_equal(fmi2DoStep(component, 0.0, 12.1, fmi2True), fmi2OK);
    assert_int_equal(get_integer(component, "contact.mode"), TDMF_CONTACT_SLIP_POSITIVE);
    assert_int_equal(fmi2SetRealInputDerivatives(component, inputs, 2, first, rates), fmi2OK);
    for (int i = 0; i < 2; ++i) {
        const fmi2ValueReference reference = reference_of(names[i]);
        double slope = 0.0;
        const double time = get_real(component, "time"), before = get_real(component, names[i]);
        assert_int_equal(fmi2DoStep(component, time, delta, fmi2True), fmi2OK);
        assert_int_equal(fmi2GetRealOutputDerivatives(component, &reference, 1, first, &slope), fmi2OK);
        assert_int_equal(fmi2DoStep(component, time + delta, delta, fmi2True), fmi2OK);
        assert_close((get_real(component, names[i]) - before) / (2.0 * delta), slope, 1e-7);
        assert_true(fabs(slope) > 0.01);
    }
    fmi2FreeInstance(component);
}

TEST(statuses_are_those_of_steps_that_are_done) {
    fmi2Status status = fmi2OK;
    double time = -1.0;
    fmi2Integer integer = 0;
    fmi2Boolean terminated = fmi2True;
    fmi2String text = NULL;
    fmi2Component component = new_slave();
    assert_int_equal(fmi2GetRealStatus(component, fmi2LastSuccessfulTime, &time), fmi2Error);
    assert_int_equal(fmi2GetBooleanStatus(component, fmi2Terminated, &terminated), fmi2Error);
    assert_int_equal(fmi2GetStatus(component, fmi2DoStepStatus, &status), fmi2Error);
    initialize(component);
    assert_int_equal(fmi2DoStep(component, 0.0, 2.0, fmi2True), fmi2OK);
    assert_int_equal(fmi2GetRealStatus(component, fmi2LastSuccessfulTime, &time), fmi2OK);
    assert_int_equal(fmi2GetBooleanStatus(component, fmi2Terminated, &terminated), fmi2OK);
    assert_true(time == 2.0 && terminated == fmi2False);
    assert_int_equal(fmi2GetRealStatus(component, fmi2Terminated, &time), fmi2Discard);
    assert_int_equal(fmi2GetBooleanStatus(component, fmi2LastSuccessfulTime, &terminated), fmi2Discard);
    assert_int_equal(fmi2GetIntegerStatus(component, fmi2DoStepStatus, &integer), fmi2Discard);
    assert_int_equal(fmi2GetStringStatus(component, fmi2PendingStatus, &text), fmi2Discard);
    assert_int_equal(fmi2GetStatus(component, fmi2DoStepStatus, &status), fmi2Discard);
    assert_int_equal(fmi2DoStep(component, 2.0, 2.0, fmi2True), fmi2OK);
    fmi2FreeInstance(component);
}
