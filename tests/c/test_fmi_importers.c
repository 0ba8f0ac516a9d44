/* Unusual calls of importers such as PyFMI, FMUChecker and fmusim, in both FMI versions. The standards allow
 * them, or they must at least not harm the instance. */
#include "compare.h"
#include "fmi2_importer.h"
#include "fmi3_importer.h"

#include "tdmf_slip/tdmf_slip.h"
#include "variables.h"

#include <math.h>
#include <string.h>

/* ---- reading before initialization, as PyFMI's load_fmu and get --------------------------------------- */

/* Calculated variables have the values with which the run would begin now, as after the start. */
FMI_TEST(all_is_read_before_initialization) {
    static double before[256];
    int starts = 0;
    void *instance = new_of_kind(fmi, EXCHANGE);
    assert_true(fmu_variable_count <= 256);
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmu_variable *variable = &fmu_variables[i];
        if (variable->settable_before_start && variable->type == VARIABLE_REAL) {
            assert_true(value_of(fmi, instance, variable->name) == variable->start);
            ++starts;
        }
    }
    assert_int_equal(starts, START_VALUES);
    assert_int_equal(integer_of(fmi, instance, "solver.method"), SOLVER_NATIVE);
    set_values(fmi, instance, "gravity=0.02 foot.vy=-0.1");
    for (int pass = 0; pass < 2; ++pass) {
        for (size_t i = 0; i < fmu_variable_count; ++i) {
            if (fmu_variables[i].type == VARIABLE_REAL) {
                const double value = value_of(fmi, instance, fmu_variables[i].name);
                before[i] = pass == 0 ? value : before[i];
                assert_true(value == before[i]);
            }
        }
        if (pass == 0) {
            initialize_unit(fmi, instance);
        }
    }
    assert_true(before[reference_of("gravity")] == 0.02);
    assert_int_equal(integer_of(fmi, instance, "contact.mode"), TDMF_CONTACT_FLIGHT);
}

/* Enumerations never read 0, which is not one of their values, not even after a refusal. */
FMI_TEST(enumerations_have_a_value_of_theirs_after_refusals) {
    for (int kind = EXCHANGE; kind < (int)fmi->kinds; ++kind) {
        step_answer answer;
        void *instance = new_of_kind(fmi, (fmi_kind)kind);
        assert_int_equal(fmi->do_step(instance, 0.0, 1.0, &answer), FMI_ERROR);
        assert_int_equal(fmi->enter_event_mode(instance), FMI_ERROR);
        assert_int_equal(integer_of(fmi, instance, "contact.mode"), TDMF_CONTACT_FLIGHT);
        assert_int_equal(integer_of(fmi, instance, "hip.phase"), TDMF_PHASE_PLACE);
    }
}

/* Calculated values are refused, because the run cannot begin; the refusal leaves all output arguments alone.
 */
TEST(contradicting_start_values_are_read_and_what_follows_is_not) {
    const fmi2ValueReference mode = reference_of("contact.mode"), word = reference_of("stride.word"),
                             height = reference_of("body.y");
    int number = 77;
    double real = 77.0;
    const char *text = "as it was";
    fmi2Component component = new_instance();
    set_values(&fmi2, component, "leg.min_length=2.0");
    assert_true(get_real(component, "leg.min_length") == 2.0);
    assert_int_equal(fmi2GetInteger(component, &mode, 1, &number), fmi2Discard);
    assert_non_null(strstr(last_message, "leg.min_length"));
    assert_int_equal(fmi2GetReal(component, &height, 1, &real), fmi2Discard);
    assert_int_equal(fmi2GetString(component, &word, 1, &text), fmi2Discard);
    assert_true(number == 77 && real == 77.0 && strcmp(text, "as it was") == 0);
    set_values(&fmi2, component, "leg.min_length=0.1");
    start_running(component);
}

/* ---- states by their value references, as PyFMI's get_state_space_representation ---------------------- */

/* The states are those of a flight, each of them changed. */
FMI_TEST(states_set_one_by_one_are_states_set_as_a_whole) {
    double states[CONTINUOUS_STATES], expected[CONTINUOUS_STATES], found[CONTINUOUS_STATES];
    const uint32_t first = reference_of("foot.x");
    void *whole = new_of_kind(fmi, EXCHANGE), *single = new_of_kind(fmi, EXCHANGE);
    begin(fmi, whole, EXCHANGE);
    begin(fmi, single, EXCHANGE);
    assert_int_equal(fmi->get_states(whole, states, CONTINUOUS_STATES), FMI_OK);
    for (uint32_t i = 0; i < CONTINUOUS_STATES; ++i) {
        const uint32_t reference = first + i;
        states[i] += 0.01 * (i + 1);
        assert_int_equal(fmi->set_reals(single, &reference, 1, &states[i]), FMI_OK);
    }
    assert_int_equal(fmi->set_states(whole, states, CONTINUOUS_STATES), FMI_OK);
    assert_int_equal(fmi->get_derivatives(whole, expected, CONTINUOUS_STATES), FMI_OK);
    assert_int_equal(fmi->get_derivatives(single, found, CONTINUOUS_STATES), FMI_OK);
    assert_memory_equal(found, expected, sizeof found);
    assert_true(value_of(fmi, single, "body.y") == value_of(fmi, whole, "body.y"));
}

/* States with reinit = false can be set in event mode of Model Exchange only (FMI 3.0.2, section 2.3.5). */
TEST(event_mode_takes_states_that_no_event_changes) {
    int taken = 0;
    fmi3Instance exchange = new_exchange(), stepper = new_stepper(true, true);
    initialize3(exchange);
    initialize3(stepper);
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        if (fmu_variables[i].storage == STORED_STATE) {
            const char *name = fmu_variables[i].name;
            const bool jumps = fmu_variables[i].changes_at_events;
            assert_int_equal(set_float(exchange, name, 0.9), jumps ? fmi3Error : fmi3OK);
            assert_int_equal(set_float(stepper, name, 0.9), fmi3Error);
            assert_non_null(strstr(last_message, "cannot be set in event mode"));
            taken += jumps ? 0 : 1;
        }
    }
    assert_true(taken >= 8);
    assert_true(get_float(exchange, "leg.length") == 0.9);
    static const char *const jumping[] = {"foot.y",         "foot.vx",        "foot.vy", "leg.length_rate",
                                          "leg.angle_rate", "hip.place_time", "leg.work"};
    for (size_t i = 0; i < COUNT_OF(jumping); ++i) {
        assert_true(fmu_variables[reference_of(jumping[i])].changes_at_events);
    }
}

FMI_TEST(states_stay_the_units_own_in_co_simulation) {
    void *instance = begun(fmi, STEPS, "");
    assert_int_equal(set_value(fmi, instance, "foot.x", 1.0), FMI_ERROR);
    assert_non_null(strstr(last_message, "foot.x cannot be set"));
    step_by(fmi, instance, 1.0);
}

/* ---- asking for nothing -------------------------------------------------------------------------------- */

#define TYPES_OF_NONE(DO) DO(Float32) DO(Int8) DO(UInt8) DO(Int16) DO(UInt16) DO(UInt32) DO(UInt64)
#define OTHER_TYPES(DO)   DO(Float64) DO(Int32) DO(Int64) DO(Boolean) DO(String)

#define ASKS_FOR_NONE(Type)                                                                                  \
    assert_int_equal(fmi3Get##Type(instance, NULL, 0, NULL, 0), fmi3OK);                                     \
    assert_int_equal(fmi3Set##Type(instance, NULL, 0, NULL, 0), fmi3OK);

#define ASKS_FOR_ONE(Type)                                                                                   \
    assert_int_equal(fmi3Get##Type(instance, &reference, 1, NULL, 1), fmi3Error);                            \
    assert_int_equal(fmi3Get##Type(instance, &reference, 0, NULL, 1), fmi3Error);                            \
    assert_int_equal(fmi3Set##Type(instance, &reference, 1, NULL, 1), fmi3Error);                            \
    assert_int_equal(fmi3Set##Type(instance, &reference, 1, NULL, 0), fmi3Error);                            \
    assert_non_null(strstr(last_message, "no variable of type " #Type));

TEST(none_of_what_the_unit_lacks_is_given_and_one_refused) {
    const fmi3ValueReference reference = 0;
    fmi3Instance instance = new_exchange();
    initialize3(instance);
    TYPES_OF_NONE(ASKS_FOR_NONE)
    OTHER_TYPES(ASKS_FOR_NONE)
    assert_int_equal(fmi3GetBinary(instance, NULL, 0, NULL, NULL, 0), fmi3OK);
    assert_int_equal(fmi3SetBinary(instance, NULL, 0, NULL, NULL, 0), fmi3OK);
    assert_int_equal(fmi3GetClock(instance, NULL, 0, NULL), fmi3OK);
    assert_int_equal(fmi3SetClock(instance, NULL, 0, NULL), fmi3OK);
    assert_int_equal(fmi3GetIntervalDecimal(instance, NULL, 0, NULL, NULL), fmi3OK);
    assert_int_equal(fmi3GetIntervalFraction(instance, NULL, 0, NULL, NULL, NULL), fmi3OK);
    assert_int_equal(fmi3GetShiftDecimal(instance, NULL, 0, NULL), fmi3OK);
    assert_int_equal(fmi3GetShiftFraction(instance, NULL, 0, NULL, NULL), fmi3OK);
    assert_int_equal(fmi3SetIntervalDecimal(instance, NULL, 0, NULL), fmi3OK);
    assert_int_equal(fmi3SetIntervalFraction(instance, NULL, 0, NULL, NULL), fmi3OK);
    assert_int_equal(fmi3SetShiftDecimal(instance, NULL, 0, NULL), fmi3OK);
    assert_int_equal(fmi3SetShiftFraction(instance, NULL, 0, NULL, NULL), fmi3OK);
    assert_int_equal(message_count, 0);
    TYPES_OF_NONE(ASKS_FOR_ONE)
    assert_int_equal(fmi3GetBinary(instance, &reference, 1, NULL, NULL, 1), fmi3Error);
    assert_int_equal(fmi3SetBinary(instance, &reference, 1, NULL, NULL, 1), fmi3Error);
    assert_int_equal(fmi3GetClock(instance, &reference, 1, NULL), fmi3Error);
    assert_int_equal(fmi3GetIntervalDecimal(instance, &reference, 1, NULL, NULL), fmi3Error);
    assert_int_equal(fmi3SetShiftFraction(instance, &reference, 1, NULL, NULL), fmi3Error);
    assert_int_equal(fmi3ActivateModelPartition(instance, reference, 0.0), fmi3Error);
    assert_int_equal(fmi3EnterConfigurationMode(instance), fmi3Error);
    assert_non_null(strstr(last_message, "structural parameter"));
    assert_int_equal(fmi3EnterContinuousTimeMode(instance), fmi3OK); /* all that has done no harm */
}

TEST(discrete_states_are_evaluated_by_doing_nothing) {
    update_answer answer;
    for (int i = 0; i < 2; ++i) {
        fmi3Instance instance = i == 0 ? new_exchange() : new_stepper(true, true);
        assert_int_equal(fmi3EvaluateDiscreteStates(instance), fmi3Error);
        initialize3(instance);
        assert_int_equal(fmi3EvaluateDiscreteStates(instance), fmi3OK);
        assert_int_equal(update(instance, &answer), fmi3OK);
    }
}

/* ---- after an error ------------------------------------------------------------------------------------ */

/* An instance that failed, because a ramp of an input was too steep for its step. */
static fmi2Component failed_slave(void) {
    const fmi2ValueReference friction = reference_of("ground.friction");
    const fmi2Integer first = 1;
    const double rate = 1e200;
    fmi2Component component = begun(&fmi2, STEPS, "");
    assert_int_equal(fmi2SetRealInputDerivatives(component, &friction, 1, &first, &rate), fmi2OK);
    assert_int_equal(fmi2DoStep(component, 0.0, 11.0, fmi2True), fmi2Error);
    return component;
}

TEST(a_failed_step_leaves_what_may_be_read_and_saved) {
    fmi2FMUstate saved = NULL;
    fmi2Component component = failed_slave();
    assert_int_equal(get_whole(component, "contact.mode"), TDMF_CONTACT_FLIGHT);
    assert_int_equal(get_whole(component, "hip.phase"), TDMF_PHASE_PLACE);
    assert_true(isfinite(get_real(component, "body.y")));
    assert_int_equal(fmi2GetFMUstate(component, &saved), fmi2OK);
    assert_int_equal(fmi2SetFMUstate(component, saved), fmi2OK);
    assert_int_equal(fmi2DoStep(component, 0.0, 1.0, fmi2True), fmi2Error); /* still the failed one */
    assert_non_null(strstr(last_message, "after an error"));
    assert_int_equal(set_real(component, "ground.friction", 0.6), fmi2Error);
    assert_int_equal(fmi2Terminate(component), fmi2Error);
    assert_int_equal(fmi2FreeFMUstate(component, &saved), fmi2OK);
    assert_int_equal(fmi2Reset(component), fmi2OK);
    initialize(component);
    assert_int_equal(fmi2DoStep(component, 0.0, 1.0, fmi2True), fmi2OK);
}
