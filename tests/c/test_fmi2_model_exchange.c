/* The unit's FMI 2.0 calls: what they refuse, with which words, and what stays as it was. */
#include "fmi2_importer.h"

#include "fmu.h"
#include "guid.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static int make(void **state) {
    *state = new_instance();
    return 0;
}

static int release(void **state) {
    fmi2FreeInstance(*state);
    return 0;
}

/* ---- instantiation ------------------------------------------------------------------------------------ */

static void assert_not_made(const char *name, fmi2Type type, const char *guid, const char *reason) {
    clear_messages();
    assert_null(fmi2Instantiate(name, type, guid, NULL, &importer_callbacks, fmi2False, fmi2False));
    assert_int_equal(message_count, 1);
    assert_non_null(strstr(last_message, reason));
    assert_null(fmi2Instantiate(name, type, guid, NULL, NULL, fmi2False, fmi2False));
}

static void refuses_wrong_name_guid_and_type(void **state) {
    (void)state;
    assert_not_made("", fmi2ModelExchange, FMU_GUID, "name");
    assert_not_made(NULL, fmi2ModelExchange, FMU_GUID, "name");
    assert_not_made("runner", fmi2ModelExchange, "{another}", "guid");
    assert_not_made("runner", fmi2ModelExchange, NULL, "guid");
    assert_not_made("runner", (fmi2Type)7, FMU_GUID, "neither");
}

static void runs_without_logger_and_callbacks(void **state) {
    (void)state;
    fmi2Component component =
        fmi2Instantiate("runner", fmi2ModelExchange, FMU_GUID, NULL, NULL, fmi2False, fmi2True);
    assert_non_null(component);
    start_running(component);
    assert_int_equal(fmi2SetTime(component, NAN), fmi2Error);
    fmi2FreeInstance(component);
    fmi2FreeInstance(NULL);
}

static void refuses_null_components(void **state) {
    (void)state;
    double value = 0.0;
    fmi2ValueReference reference = 0;
    fmi2EventInfo info;
    assert_int_equal(fmi2GetReal(NULL, &reference, 1, &value), fmi2Error);
    assert_int_equal(fmi2SetReal(NULL, &reference, 1, &value), fmi2Error);
    assert_int_equal(fmi2SetTime(NULL, 0.0), fmi2Error);
    assert_int_equal(fmi2NewDiscreteStates(NULL, &info), fmi2Error);
    assert_int_equal(fmi2Reset(NULL), fmi2Error);
    assert_int_equal(fmi2GetFMUstate(NULL, NULL), fmi2Error);
}

/* ---- call sequence ------------------------------------------------------------------------------------ */

typedef fmi2Status (*plain_call)(fmi2Component);

static fmi2Status call_new_discrete_states(fmi2Component component) {
    fmi2EventInfo info;
    return fmi2NewDiscreteStates(component, &info);
}

static fmi2Status call_set_time(fmi2Component component) {
    return fmi2SetTime(component, 0.0);
}

static fmi2Status call_set_states(fmi2Component component) {
    double states[TDMF_STATE_COUNT];
    tdmf_default_state(states);
    return fmi2SetContinuousStates(component, states, TDMF_STATE_COUNT);
}

static fmi2Status call_get_states(fmi2Component component) {
    double states[TDMF_STATE_COUNT];
    return fmi2GetContinuousStates(component, states, TDMF_STATE_COUNT);
}

static fmi2Status call_get_derivatives(fmi2Component component) {
    double derivatives[TDMF_STATE_COUNT];
    return fmi2GetDerivatives(component, derivatives, TDMF_STATE_COUNT);
}

static fmi2Status call_get_indicators(fmi2Component component) {
    double indicators[TDMF_GUARD_COUNT];
    return fmi2GetEventIndicators(component, indicators, TDMF_GUARD_COUNT);
}

static fmi2Status call_get_nominals(fmi2Component component) {
    double nominals[TDMF_STATE_COUNT];
    return fmi2GetNominalsOfContinuousStates(component, nominals, TDMF_STATE_COUNT);
}

static fmi2Status call_completed_step(fmi2Component component) {
    fmi2Boolean enter, stop;
    return fmi2CompletedIntegratorStep(component, fmi2True, &enter, &stop);
}

static fmi2Status call_setup(fmi2Component component) {
    return fmi2SetupExperiment(component, fmi2False, 0.0, 0.0, fmi2False, 0.0);
}

static fmi2Status call_get_real(fmi2Component component) {
    const fmi2ValueReference reference = reference_of("foot.x");
    double value;
    return fmi2GetReal(component, &reference, 1, &value);
}

static fmi2Status call_set_input(fmi2Component component) {
    return set_real(component, "ground.friction", 0.6);
}

static fmi2Status call_set_state(fmi2Component component) {
    return set_real(component, "foot.vx", 1.0);
}

static fmi2Status call_set_parameter(fmi2Component component) {
    return set_real(component, "body.mass", 1.0);
}

static fmi2Status call_derivative(fmi2Component component) {
    const fmi2ValueReference unknown = reference_of("body.y"), known = reference_of("leg.angle");
    const double seed = 1.0;
    double value;
    return fmi2GetDirectionalDerivative(component, &unknown, 1, &known, 1, &seed, &value);
}

static fmi2Status call_set_logging(fmi2Component component) {
    return fmi2SetDebugLogging(component, fmi2False, 1, events_category);
}

static fmi2Status call_save_state(fmi2Component component) {
    fmi2FMUstate saved = NULL;
    const fmi2Status status = fmi2GetFMUstate(component, &saved);
    assert_int_equal(fmi2FreeFMUstate(component, &saved), fmi2OK);
    return status;
}

enum {
    BEFORE = 1,
    INITIALIZING = 2,
    EVENT = 4,
    CONTINUOUS = 8,
    ENDED = 16,
    EVERYWHERE = 31,
    STATE_COUNT = 5
};

/* The table of FMI 2.0, section 3.2.3, and start values beside it, which importers ask for in good time. */
static const struct {
    const char *name;
    plain_call call;
    unsigned allowed;
} calls[] = {
    {"fmi2SetupExperiment", call_setup, BEFORE},
    {"fmi2EnterInitializationMode", fmi2EnterInitializationMode, BEFORE},
    {"fmi2ExitInitializationMode", fmi2ExitInitializationMode, INITIALIZING},
    {"fmi2EnterEventMode", fmi2EnterEventMode, EVENT | CONTINUOUS},
    {"fmi2NewDiscreteStates", call_new_discrete_states, EVENT},
    {"fmi2EnterContinuousTimeMode", fmi2EnterContinuousTimeMode, EVENT},
    {"fmi2CompletedIntegratorStep", call_completed_step, CONTINUOUS},
    {"fmi2SetTime", call_set_time, EVENT | CONTINUOUS},
    {"fmi2SetContinuousStates", call_set_states, CONTINUOUS},
    {"fmi2GetContinuousStates", call_get_states, INITIALIZING | EVENT | CONTINUOUS | ENDED},
    {"fmi2GetDerivatives", call_get_derivatives, INITIALIZING | EVENT | CONTINUOUS | ENDED},
    {"fmi2GetEventIndicators", call_get_indicators, INITIALIZING | EVENT | CONTINUOUS | ENDED},
    {"fmi2GetNominalsOfContinuousStates", call_get_nominals, EVERYWHERE},
    {"fmi2GetReal", call_get_real, EVERYWHERE},
    {"fmi2SetReal", call_set_input, BEFORE | INITIALIZING | EVENT | CONTINUOUS},
    {"fmi2SetReal", call_set_state, BEFORE | INITIALIZING | CONTINUOUS},
    {"fmi2SetReal", call_set_parameter, BEFORE | INITIALIZING},
    {"fmi2GetDirectionalDerivative", call_derivative, EVERYWHERE},
    {"fmi2SetDebugLogging", call_set_logging, EVERYWHERE},
    {"fmi2GetFMUstate", call_save_state, EVERYWHERE},
    {"fmi2Terminate", fmi2Terminate, EVENT | CONTINUOUS},
    {"fmi2Reset", fmi2Reset, BEFORE | INITIALIZING | EVENT | CONTINUOUS | ENDED},
};

static fmi2Component instance_in_state(int index) {
    fmi2Component component = new_instance();
    switch (1 << index) {
    case BEFORE:
        break;
    case INITIALIZING:
        assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
        break;
    case EVENT:
        initialize(component);
        break;
    case CONTINUOUS:
        start_running(component);
        break;
    default:
        start_running(component);
        assert_int_equal(fmi2Terminate(component), fmi2OK);
    }
    clear_messages();
    return component;
}

static void follows_the_call_sequence_and_stays_as_it_was_where_that_is_broken(void **state) {
    int refused = 0;
    (void)state;
    for (size_t i = 0; i < sizeof calls / sizeof calls[0]; ++i) {
        for (int where = 0; where < STATE_COUNT; ++where) {
            const bool allowed = (calls[i].allowed & (1u << where)) != 0;
            unsigned char before[SERIALIZED_BYTES], after[SERIALIZED_BYTES];
            fmi2Component component = instance_in_state(where);
            const size_t size = save_bytes(&fmi2, component, before);
            assert_int_equal(calls[i].call(component), allowed ? fmi2OK : fmi2Error);
            assert_int_equal(message_count, allowed ? 0 : 1);
            if (!allowed) {
                assert_non_null(strstr(last_message, calls[i].name));
                assert_string_equal(last_category, "logStatusError");
                assert_int_equal(save_bytes(&fmi2, component, after), size);
                assert_memory_equal(before, after, size);
                ++refused;
            }
            fmi2FreeInstance(component);
        }
    }
    assert_int_equal(refused, 46);
}

/* As an importer's slip, mended: start values that contradict each other are set right and tried again. */
static void start_values_may_be_mended_after_a_refusal(void **state) {
    fmi2Component component = *state;
    assert_int_equal(set_real(component, "leg.min_length", 2.0), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
    assert_int_equal(fmi2ExitInitializationMode(component), fmi2Error);
    assert_int_equal(set_real(component, "leg.min_length", 0.05), fmi2OK);
    assert_int_equal(fmi2ExitInitializationMode(component), fmi2OK);
    assert_int_equal(call_new_discrete_states(component), fmi2OK);
}

/* ---- values ------------------------------------------------------------------------------------------- */

static void assert_discarded(fmi2Component component, const char *name, double value) {
    clear_messages();
    assert_int_equal(set_real(component, name, value), fmi2Discard);
    assert_int_equal(message_count, 1);
    assert_string_equal(last_category, "logStatusDiscard");
    assert_non_null(strstr(last_message, name));
    assert_non_null(strstr(last_message, "allowed from"));
}

static void discards_values_out_of_range_and_keeps_the_old(void **state) {
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
               {"hip.external_torque", INFINITY}};
    fmi2Component component = *state;
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        const double before = get_real(component, bad[i].name);
        assert_discarded(component, bad[i].name, bad[i].value);
        assert_true(get_real(component, bad[i].name) == before);
    }
    assert_int_equal(fmi2ExitInitializationMode(component), fmi2OK);
}

static void sets_all_or_nothing(void **state) {
    const fmi2ValueReference references[] = {reference_of("body.mass"), reference_of("foot.mass")};
    const double values[] = {2.0, -1.0};
    assert_int_equal(fmi2EnterInitializationMode(*state), fmi2OK);
    assert_int_equal(fmi2SetReal(*state, references, 2, values), fmi2Discard);
    assert_true(get_real(*state, "body.mass") == 1.0);
}

static void checks_across_variables_wait_for_the_end_of_initialization(void **state) {
    fmi2Component component = *state;
    assert_int_equal(set_real(component, "leg.length", 0.5), fmi2OK);
    assert_int_equal(set_real(component, "leg.min_length", 0.6), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
    assert_int_equal(fmi2ExitInitializationMode(component), fmi2Error);
    assert_non_null(strstr(last_message, "leg.length = 0.5 m is refused: allowed from 0.6"));
    assert_non_null(strstr(last_message, "leg.min_length"));
}

static void refuses_a_body_below_the_ground(void **state) {
    fmi2Component component = *state;
    assert_int_equal(set_real(component, "leg.angle", 3.0), fmi2OK);
    assert_int_equal(set_real(component, "foot.y", 0.0), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
    assert_int_equal(fmi2ExitInitializationMode(component), fmi2Error);
    assert_non_null(strstr(last_message, "body.y"));
}

static void refuses_unknown_references_wrong_types_and_outputs(void **state) {
    const fmi2ValueReference none = 100000, text = reference_of("stride.word"),
                             output = reference_of("body.x");
    double value = 0.0;
    start_running(*state);
    assert_int_equal(fmi2GetReal(*state, &none, 1, &value), fmi2Error);
    assert_non_null(strstr(last_message, "100000"));
    assert_int_equal(fmi2GetReal(*state, &text, 1, &value), fmi2Error);
    assert_non_null(strstr(last_message, "stride.word"));
    assert_int_equal(fmi2SetReal(*state, &output, 1, &value), fmi2Error);
    assert_non_null(strstr(last_message, "body.x cannot be set at any time"));
}

static void refuses_parameters_after_the_start(void **state) {
    start_running(*state);
    assert_int_equal(set_real(*state, "body.mass", 2.0), fmi2Error);
    assert_non_null(strstr(last_message, "body.mass cannot be set in continuous-time mode"));
}

static void refuses_null_and_wrong_arrays(void **state) {
    const fmi2ValueReference reference = 0;
    double values[TDMF_STATE_COUNT];
    initialize(*state);
    assert_int_equal(fmi2GetDerivatives(*state, values, TDMF_STATE_COUNT - 1), fmi2Error);
    assert_non_null(strstr(last_message, "14"));
    assert_int_equal(fmi2GetReal(*state, &reference, 1, NULL), fmi2Error);
    assert_int_equal(fmi2GetReal(*state, NULL, 0, NULL), fmi2OK);
    assert_int_equal(fmi2NewDiscreteStates(*state, NULL), fmi2Error);
}

static void refuses_bad_experiments(void **state) {
    static const struct {
        double tolerance, start, stop;
    } bad[] = {{0.0, 0.0, 1.0},       {NAN, 0.0, 1.0},  {1e-6, NAN, 1.0},
               {1e-6, INFINITY, 1.0}, {1e-6, 2.0, 1.0}, {1e-6, 0.0, NAN}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        assert_int_equal(
            fmi2SetupExperiment(*state, fmi2True, bad[i].tolerance, bad[i].start, fmi2True, bad[i].stop),
            fmi2Error);
    }
    assert_int_equal(call_setup(*state), fmi2OK);
}

/* ---- running ------------------------------------------------------------------------------------------ */

static void starts_at_any_time(void **state) {
    assert_int_equal(fmi2SetupExperiment(*state, fmi2False, 0.0, -12.5, fmi2False, 0.0), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(*state), fmi2OK);
    assert_int_equal(fmi2ExitInitializationMode(*state), fmi2OK);
    assert_true(get_real(*state, "time") == -12.5);
    assert_true(get_real(*state, "apex.time") == -12.5);
    assert_true(get_real(*state, "event.last_time") == -12.5);
}

static void trial_states_give_finite_answers(void **state) {
    static const double wild[] = {0.0, -1.0, 1e-300, -DBL_MAX, DBL_MAX, INFINITY, -INFINITY};
    const int wild_count = (int)(sizeof wild / sizeof wild[0]);
    start_running(*state);
    for (int element = 0; element < TDMF_STATE_COUNT * wild_count; ++element) {
        double states[TDMF_STATE_COUNT], derivatives[TDMF_STATE_COUNT], indicators[TDMF_GUARD_COUNT];
        tdmf_default_state(states);
        for (int i = 0; i <= element / wild_count; ++i) {
            states[i] = wild[(element + i) % wild_count];
        }
        assert_int_equal(fmi2SetContinuousStates(*state, states, TDMF_STATE_COUNT), fmi2OK);
        assert_int_equal(fmi2GetDerivatives(*state, derivatives, TDMF_STATE_COUNT), fmi2OK);
        assert_int_equal(fmi2GetEventIndicators(*state, indicators, TDMF_GUARD_COUNT), fmi2OK);
        for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
            assert_true(isfinite(derivatives[i]));
        }
        for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
            assert_true(isfinite(indicators[i]));
        }
    }
}

static void discards_a_state_that_is_not_a_number(void **state) {
    double states[TDMF_STATE_COUNT], after[TDMF_STATE_COUNT];
    start_running(*state);
    tdmf_default_state(states);
    states[TDMF_LEG_ANGLE] = NAN;
    assert_int_equal(fmi2SetContinuousStates(*state, states, TDMF_STATE_COUNT), fmi2Discard);
    assert_int_equal(fmi2GetContinuousStates(*state, after, TDMF_STATE_COUNT), fmi2OK);
    assert_true(!isnan(after[TDMF_LEG_ANGLE]));
    assert_int_equal(call_set_states(*state), fmi2OK);
}

/* Puts the foot below the ground, moving down, and enters event mode there. */
static void land(fmi2Component component, fmi2EventInfo *info) {
    double states[TDMF_STATE_COUNT];
    assert_int_equal(fmi2GetContinuousStates(component, states, TDMF_STATE_COUNT), fmi2OK);
    states[TDMF_FOOT_Y] = -1e-12;
    states[TDMF_FOOT_VY] = -0.1;
    assert_int_equal(fmi2SetContinuousStates(component, states, TDMF_STATE_COUNT), fmi2OK);
    assert_int_equal(fmi2EnterEventMode(component), fmi2OK);
    assert_int_equal(fmi2NewDiscreteStates(component, info), fmi2OK);
}

static void event_mode_goes_by_the_guards(void **state) {
    fmi2EventInfo info;
    start_running(*state);
    assert_int_equal(fmi2EnterEventMode(*state), fmi2OK);
    assert_int_equal(fmi2NewDiscreteStates(*state, &info), fmi2OK);
    assert_int_equal(info.valuesOfContinuousStatesChanged, fmi2False);
    assert_int_equal(info.newDiscreteStatesNeeded, fmi2False);
    assert_int_equal(get_integer(*state, "event.count"), 0);
    assert_int_equal(fmi2EnterContinuousTimeMode(*state), fmi2OK);
    land(*state, &info);
    assert_int_equal(info.valuesOfContinuousStatesChanged, fmi2True);
    assert_int_equal(info.terminateSimulation, fmi2False);
    assert_int_equal(get_integer(*state, "event.count"), 1);
    assert_true(get_real(*state, "foot.vy") == 0.0);
    assert_true(get_real(*state, "energy.impact_loss") > 0.0);
}

static void shorten_leg(fmi2Component component, fmi2EventInfo *info) {
    double states[TDMF_STATE_COUNT];
    tdmf_default_state(states);
    states[TDMF_LEG_LENGTH] = 0.01;
    assert_int_equal(fmi2SetContinuousStates(component, states, TDMF_STATE_COUNT), fmi2OK);
    assert_int_equal(fmi2EnterEventMode(component), fmi2OK);
    assert_int_equal(fmi2NewDiscreteStates(component, info), fmi2OK);
}

static void a_fall_asks_to_stop_and_freezes(void **state) {
    fmi2EventInfo info;
    double derivatives[TDMF_STATE_COUNT];
    start_running(*state);
    shorten_leg(*state, &info);
    assert_int_equal(info.terminateSimulation, fmi2True);
    assert_int_equal(fmi2EnterContinuousTimeMode(*state), fmi2OK);
    assert_int_equal(fmi2GetDerivatives(*state, derivatives, TDMF_STATE_COUNT), fmi2OK);
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        assert_true(derivatives[i] == 0.0);
    }
    assert_true(get_real(*state, "leg.length") == 0.01);
}

static void a_fall_goes_unasked_where_the_parameter_says_so(void **state) {
    const fmi2ValueReference reference = reference_of("status.terminate_on_fall");
    const fmi2Boolean no = fmi2False;
    fmi2EventInfo info;
    assert_int_equal(fmi2SetBoolean(*state, &reference, 1, &no), fmi2OK);
    start_running(*state);
    shorten_leg(*state, &info);
    assert_int_equal(info.terminateSimulation, fmi2False);
}

static void nominals_follow_the_parameters(void **state) {
    double nominals[TDMF_STATE_COUNT];
    assert_int_equal(set_real(*state, "body.mass", 4.0), fmi2OK);
    assert_int_equal(set_real(*state, "leg.stiffness", 100.0), fmi2OK);
    assert_int_equal(set_real(*state, "leg.free_length", 2.0), fmi2OK);
    initialize(*state);
    assert_int_equal(fmi2GetNominalsOfContinuousStates(*state, nominals, TDMF_STATE_COUNT), fmi2OK);
    assert_true(nominals[TDMF_FOOT_X] == 2.0);
    assert_true(nominals[TDMF_FOOT_VX] == 10.0);
    assert_true(nominals[TDMF_LEG_ANGLE_RATE] == 5.0);
    assert_true(nominals[TDMF_HIP_WORK] == 400.0);
}

#define ON_FRESH_INSTANCE(test) cmocka_unit_test_setup_teardown(test, make, release)

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(refuses_wrong_name_guid_and_type),
        cmocka_unit_test(runs_without_logger_and_callbacks),
        cmocka_unit_test(refuses_null_components),
        cmocka_unit_test(follows_the_call_sequence_and_stays_as_it_was_where_that_is_broken),
        ON_FRESH_INSTANCE(start_values_may_be_mended_after_a_refusal),
        ON_FRESH_INSTANCE(discards_values_out_of_range_and_keeps_the_old),
        ON_FRESH_INSTANCE(sets_all_or_nothing),
        ON_FRESH_INSTANCE(checks_across_variables_wait_for_the_end_of_initialization),
        ON_FRESH_INSTANCE(refuses_a_body_below_the_ground),
        ON_FRESH_INSTANCE(refuses_unknown_references_wrong_types_and_outputs),
        ON_FRESH_INSTANCE(refuses_parameters_after_the_start),
        ON_FRESH_INSTANCE(refuses_null_and_wrong_arrays),
        ON_FRESH_INSTANCE(refuses_bad_experiments),
        ON_FRESH_INSTANCE(starts_at_any_time),
        ON_FRESH_INSTANCE(trial_states_give_finite_answers),
        ON_FRESH_INSTANCE(discards_a_state_that_is_not_a_number),
        ON_FRESH_INSTANCE(event_mode_goes_by_the_guards),
        ON_FRESH_INSTANCE(a_fall_asks_to_stop_and_freezes),
        ON_FRESH_INSTANCE(a_fall_goes_unasked_where_the_parameter_says_so),
        ON_FRESH_INSTANCE(nominals_follow_the_parameters),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
