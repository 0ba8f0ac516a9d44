/* The unit's FMI 3.0 calls: what they refuse, in which state and with which words, and what stays as it was.
 */
#include "compare.h"
#include "fmi3_importer.h"

#include "fmu.h"
#include "guid.h"
#include "variables.h"

#include <math.h>
#include <string.h>

/* ---- instantiation ------------------------------------------------------------------------------------ */

static void assert_not_made(const char *name, const char *token, const char *reason) {
    clear_messages();
    assert_null(fmi3InstantiateModelExchange(name, token, NULL, false, false, NULL, importer_logger));
    assert_int_equal(message_count, 1);
    assert_non_null(strstr(last_message, reason));
    assert_null(fmi3InstantiateModelExchange(name, token, NULL, false, false, NULL, NULL));
    assert_null(fmi3InstantiateCoSimulation(name, token, NULL, false, false, true, true, NULL, 0, NULL,
                                            importer_logger, NULL));
    assert_int_equal(message_count, 2);
}

static void refuses_wrong_name_and_token(void **state) {
    (void)state;
    assert_not_made("", FMU_GUID, "name");
    assert_not_made(NULL, FMU_GUID, "name");
    assert_not_made("runner", "{another}", "token");
    assert_not_made("runner", NULL, "token");
}

static void refuses_an_interface_it_does_not_have(void **state) {
    (void)state;
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
static void an_importer_that_offers_intermediate_updates_is_never_called_back(void **state) {
    const fmi3ValueReference wanted[] = {reference_of("foot.x"), reference_of("leg.angle")};
    (void)state;
    clear_messages();
    for (int way = 0; way < 4; ++way) {
        const fmi3Boolean event_mode = way >= 2, early_return = way % 2 == 1;
        double foot_x[2];
        for (int offers = 0; offers < 2; ++offers) {
            fmi3Instance instance = fmi3InstantiateCoSimulation(
                "runner", FMU_GUID, NULL, false, false, event_mode, early_return, offers ? wanted : NULL,
                offers ? 2 : 0, NULL, importer_logger, offers ? called_back : NULL);
            step_answer answer;
            update_answer updated;
            assert_non_null(instance);
            initialize3(instance);
            if (event_mode) {
                assert_int_equal(update(instance, &updated), fmi3OK);
                assert_int_equal(fmi3EnterStepMode(instance), fmi3OK);
            }
            for (int i = 0; i < 4; ++i) { /* early, to the first event */
                assert_int_equal(do_step(instance, get_float(instance, "time"), 40.0, &answer), fmi3OK);
                if (answer.event) {
                    assert_int_equal(fmi3EnterEventMode(instance), fmi3OK);
                    assert_int_equal(update(instance, &updated), fmi3OK);
                    assert_int_equal(fmi3EnterStepMode(instance), fmi3OK);
                }
            }
            assert_int_equal(answer.event, way == 3);
            foot_x[offers] = get_float(instance, "foot.x");
            fmi3FreeInstance(instance);
        }
        assert_true(foot_x[0] == foot_x[1]);
    }
    assert_int_equal(message_count, 0);
}

static void refuses_null_instances(void **state) {
    double value = 0.0;
    const fmi3ValueReference reference = 0;
    const fmi3Int32 order = 1;
    step_answer answer;
    (void)state;
    assert_int_equal(fmi3GetFloat64(NULL, &reference, 1, &value, 1), fmi3Error);
    assert_int_equal(fmi3SetFloat64(NULL, &reference, 1, &value, 1), fmi3Error);
    assert_int_equal(fmi3GetFloat64(NULL, &reference, 1, &value, 2), fmi3Error);
    assert_int_equal(fmi3EnterEventMode(NULL), fmi3Error);
    assert_int_equal(fmi3EnterStepMode(NULL), fmi3Error);
    assert_int_equal(fmi3SetTime(NULL, 0.0), fmi3Error);
    assert_int_equal(do_step(NULL, 0.0, 1.0, &answer), fmi3Error);
    assert_int_equal(fmi3GetClock(NULL, &reference, 1, NULL), fmi3Error);
    assert_int_equal(fmi3Reset(NULL), fmi3Error);
    assert_int_equal(fmi3GetOutputDerivatives(NULL, &reference, 1, &order, &value, 1), fmi3Error);
    assert_int_equal(fmi3GetOutputDerivatives(NULL, &reference, 1, &order, &value, 2), fmi3Error);
    fmi3FreeInstance(NULL);
}

static void runs_without_logger(void **state) {
    (void)state;
    fmi3Instance instance = fmi3InstantiateModelExchange("runner", FMU_GUID, NULL, false, true, NULL, NULL);
    assert_non_null(instance);
    initialize3(instance);
    assert_int_equal(fmi3SetTime(instance, NAN), fmi3Error);
    fmi3FreeInstance(instance);
}

/* ---- call sequence ------------------------------------------------------------------------------------ */

typedef fmi3Status (*plain_call)(fmi3Instance);

static fmi3Status call_enter_initialization(fmi3Instance instance) {
    return fmi3EnterInitializationMode(instance, false, 0.0, 0.0, false, 0.0);
}

static fmi3Status call_update(fmi3Instance instance) {
    update_answer answer;
    return update(instance, &answer);
}

static fmi3Status call_do_step(fmi3Instance instance) {
    step_answer answer;
    return do_step(instance, 0.0, 1.0, &answer);
}

static fmi3Status call_set_time(fmi3Instance instance) {
    return fmi3SetTime(instance, 0.0);
}

static fmi3Status call_set_states(fmi3Instance instance) {
    double states[TDMF_STATE_COUNT];
    tdmf_default_state(states);
    return fmi3SetContinuousStates(instance, states, TDMF_STATE_COUNT);
}

static fmi3Status call_get_states(fmi3Instance instance) {
    double states[TDMF_STATE_COUNT];
    return fmi3GetContinuousStates(instance, states, TDMF_STATE_COUNT);
}

static fmi3Status call_get_derivatives(fmi3Instance instance) {
    double derivatives[TDMF_STATE_COUNT];
    return fmi3GetContinuousStateDerivatives(instance, derivatives, TDMF_STATE_COUNT);
}

static fmi3Status call_get_indicators(fmi3Instance instance) {
    double indicators[TDMF_GUARD_COUNT];
    return fmi3GetEventIndicators(instance, indicators, TDMF_GUARD_COUNT);
}

static fmi3Status call_get_nominals(fmi3Instance instance) {
    double nominals[TDMF_STATE_COUNT];
    return fmi3GetNominalsOfContinuousStates(instance, nominals, TDMF_STATE_COUNT);
}

static fmi3Status call_completed_step(fmi3Instance instance) {
    fmi3Boolean enter, stop;
    return fmi3CompletedIntegratorStep(instance, true, &enter, &stop);
}

static fmi3Status call_get(fmi3Instance instance) {
    const fmi3ValueReference reference = reference_of("foot.x");
    double value;
    return fmi3GetFloat64(instance, &reference, 1, &value, 1);
}

static fmi3Status call_set_input(fmi3Instance instance) {
    return set_float(instance, "ground.friction", 0.6);
}

static fmi3Status call_set_state(fmi3Instance instance) {
    return set_float(instance, "foot.vx", 1.0);
}

/* One that no event makes jump: reinit = false. */
static fmi3Status call_set_smooth_state(fmi3Instance instance) {
    return set_float(instance, "foot.x", 1.0);
}

static fmi3Status call_set_parameter(fmi3Instance instance) {
    return set_float(instance, "body.mass", 1.0);
}

static fmi3Status call_set_logging(fmi3Instance instance) {
    return fmi3SetDebugLogging(instance, false, 1, events_category);
}

static fmi3Status call_save_state(fmi3Instance instance) {
    fmi3FMUState saved = NULL;
    const fmi3Status status = fmi3GetFMUState(instance, &saved);
    assert_int_equal(fmi3FreeFMUState(instance, &saved), fmi3OK);
    return status;
}

static fmi3Status call_counts(fmi3Instance instance) {
    size_t states = 0, indicators = 0;
    const fmi3Status status = fmi3GetNumberOfContinuousStates(instance, &states);
    assert_int_equal(fmi3GetNumberOfEventIndicators(instance, &indicators), status);
    assert_int_equal(states, TDMF_STATE_COUNT);
    assert_int_equal(indicators, TDMF_GUARD_COUNT);
    return status;
}

static fmi3Status call_derivative(fmi3Instance instance) {
    const fmi3ValueReference unknown = reference_of("body.y"), known = reference_of("leg.angle");
    const double seed = 1.0;
    double value;
    const fmi3Status status =
        fmi3GetDirectionalDerivative(instance, &unknown, 1, &known, 1, &seed, 1, &value, 1);
    return status == fmi3OK ? fmi3GetAdjointDerivative(instance, &unknown, 1, &known, 1, &seed, 1, &value, 1)
                            : status;
}

static fmi3Status call_output_derivative(fmi3Instance instance) {
    const fmi3ValueReference reference = reference_of("body.y");
    const fmi3Int32 order = 1;
    double value;
    return fmi3GetOutputDerivatives(instance, &reference, 1, &order, &value, 1);
}

/* Where an instance can be: Model Exchange first, then Co-Simulation with event mode, then without. */
enum {
    ME_BEFORE = 1,
    ME_INITIALIZING = 2,
    ME_EVENT = 4,
    ME_CONTINUOUS = 8,
    ME_ENDED = 16,
    CS_EVENT = 32,
    CS_STEP = 64,
    CS_PLAIN_STEP = 128,
    CS_ENDED = 256,
    SITUATIONS = 9,
    EVENT = ME_EVENT | CS_EVENT,
    STEP = CS_STEP | CS_PLAIN_STEP,
    ENDED = ME_ENDED | CS_ENDED,
    RUN = EVENT | ME_CONTINUOUS | STEP,
    EVALUABLE = ME_INITIALIZING | EVENT | ME_CONTINUOUS | ENDED,
    EVERYWHERE = (1 << SITUATIONS) - 1
};

/* The state machines of FMI 3.0, sections 2.3, 3.2 and 4.2, and start values beside them, which importers ask
 * for in good time. */
static const struct {
    const char *name;
    plain_call call;
    unsigned allowed;
} calls[] = {
    {"fmi3EnterInitializationMode", call_enter_initialization, ME_BEFORE},
    {"fmi3ExitInitializationMode", fmi3ExitInitializationMode, ME_INITIALIZING},
    {"fmi3EnterEventMode", fmi3EnterEventMode, ME_CONTINUOUS | CS_STEP},
    {"fmi3UpdateDiscreteStates", call_update, EVENT},
    {"fmi3EnterContinuousTimeMode", fmi3EnterContinuousTimeMode, ME_EVENT},
    {"fmi3EnterStepMode", fmi3EnterStepMode, CS_EVENT},
    {"fmi3DoStep", call_do_step, STEP},
    {"fmi3CompletedIntegratorStep", call_completed_step, ME_CONTINUOUS},
    {"fmi3SetTime", call_set_time, ME_EVENT | ME_CONTINUOUS},
    {"fmi3SetContinuousStates", call_set_states, ME_CONTINUOUS},
    {"fmi3GetContinuousStates", call_get_states, EVALUABLE},
    {"fmi3GetContinuousStateDerivatives", call_get_derivatives, EVALUABLE},
    {"fmi3GetEventIndicators", call_get_indicators, EVALUABLE},
    {"fmi3GetNominalsOfContinuousStates", call_get_nominals, ME_BEFORE | EVALUABLE},
    {"fmi3GetFloat64", call_get, EVERYWHERE},
    {"fmi3SetFloat64", call_set_input, EVERYWHERE & ~ENDED},
    {"fmi3SetFloat64", call_set_state, ME_BEFORE | ME_INITIALIZING | ME_CONTINUOUS},
    {"fmi3SetFloat64", call_set_smooth_state, ME_BEFORE | ME_INITIALIZING | ME_EVENT | ME_CONTINUOUS},
    {"fmi3SetFloat64", call_set_parameter, ME_BEFORE | ME_INITIALIZING},
    {"fmi3SetDebugLogging", call_set_logging, EVERYWHERE},
    {"fmi3GetFMUState", call_save_state, EVERYWHERE},
    {"fmi3EvaluateDiscreteStates", fmi3EvaluateDiscreteStates, EVENT},
    {"fmi3GetNumberOf", call_counts, EVERYWHERE},
    {"fmi3GetDirectionalDerivative", call_derivative, EVERYWHERE},
    {"fmi3GetOutputDerivatives", call_output_derivative, STEP | ENDED},
    {"fmi3Terminate", fmi3Terminate, RUN},
    {"fmi3Reset", fmi3Reset, EVERYWHERE},
};

static fmi3Instance instance_at(unsigned situation) {
    const bool exchange = situation <= ME_ENDED;
    fmi3Instance instance = exchange ? new_exchange() : new_stepper(situation != CS_PLAIN_STEP, false);
    if (situation == ME_INITIALIZING) {
        assert_int_equal(call_enter_initialization(instance), fmi3OK);
    } else if (situation != ME_BEFORE) {
        initialize3(instance);
    }
    if (situation == ME_CONTINUOUS) {
        assert_int_equal(fmi3EnterContinuousTimeMode(instance), fmi3OK);
    } else if (situation == CS_STEP) {
        assert_int_equal(fmi3EnterStepMode(instance), fmi3OK);
    } else if ((situation & ENDED) != 0) {
        assert_int_equal(fmi3Terminate(instance), fmi3OK);
    }
    clear_messages();
    return instance;
}

static void follows_the_call_sequence_and_stays_as_it_was_where_that_is_broken(void **state) {
    int refused = 0;
    (void)state;
    for (size_t i = 0; i < sizeof calls / sizeof calls[0]; ++i) {
        for (unsigned situation = 1; situation < EVERYWHERE; situation <<= 1) {
            const bool allowed = (calls[i].allowed & situation) != 0;
            fmi3Byte before[SERIALIZED_BYTES], after[SERIALIZED_BYTES];
            fmi3Instance instance = instance_at(situation);
            const size_t size = save_bytes(&fmi3, instance, before);
            assert_int_equal(calls[i].call(instance), allowed ? fmi3OK : fmi3Error);
            assert_int_equal(message_count, allowed ? 0 : 1);
            if (!allowed) {
                assert_non_null(strstr(last_message, calls[i].name));
                assert_string_equal(last_category, "logStatusError");
                assert_int_equal(save_bytes(&fmi3, instance, after), size);
                assert_memory_equal(before, after, size);
                ++refused;
            }
            fmi3FreeInstance(instance);
        }
    }
    assert_int_equal(refused, 123);
}

static void refuses_what_the_unit_does_not_have(void **state) {
    const fmi3ValueReference reference = reference_of("foot.x");
    fmi3Float32 single = 0.0F;
    fmi3Instance instance = new_exchange();
    (void)state;
    initialize3(instance);
    assert_int_equal(fmi3GetFloat32(instance, &reference, 1, &single, 1), fmi3Error);
    assert_string_equal(last_message, "fmi3GetFloat32: the unit has no variable of type Float32");
    assert_int_equal(fmi3EnterConfigurationMode(instance), fmi3Error);
    assert_non_null(strstr(last_message, "structural parameter"));
    assert_int_equal(fmi3SetClock(instance, &reference, 1, NULL), fmi3Error);
    assert_non_null(strstr(last_message, "clock"));
    fmi3FreeInstance(instance);
}

/* ---- values ------------------------------------------------------------------------------------------- */

static void every_variable_is_read_by_its_own_type_only(void **state) {
    fmi3Instance instance = instance_at(ME_EVENT);
    (void)state;
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
        for (size_t j = 0; j < sizeof types / sizeof types[0]; ++j) {
            assert_int_equal(found[j], types[j] == type ? fmi3OK : fmi3Error);
        }
    }
    fmi3FreeInstance(instance);
}

static void values_out_of_range_are_discarded_and_the_old_kept(void **state) {
    static const struct {
        const char *name;
        double value;
    } bad[] = {{"body.mass", -1.0}, {"foot.mass", NAN},        {"leg.stiffness", INFINITY},
               {"foot.y", -1e10},   {"ground.friction", -0.1}, {"hip.external_torque", NAN},
               {"leg.length", 0.0}, {"hip.kp", -INFINITY}};
    fmi3Instance instance = instance_at(ME_INITIALIZING);
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        const double before = get_float(instance, bad[i].name);
        clear_messages();
        assert_int_equal(set_float(instance, bad[i].name, bad[i].value), fmi3Discard);
        assert_int_equal(message_count, 1);
        assert_non_null(strstr(last_message, bad[i].name));
        assert_non_null(strstr(last_message, "allowed from"));
        assert_true(get_float(instance, bad[i].name) == before);
    }
    assert_int_equal(fmi3ExitInitializationMode(instance), fmi3OK);
    fmi3FreeInstance(instance);
}

static void enumerations_and_booleans_are_set_in_range_only(void **state) {
    const fmi3ValueReference method = reference_of("solver.method");
    const fmi3ValueReference stop = reference_of("status.terminate_on_fall");
    static const fmi3Int64 bad[] = {0, 3, INT64_MAX, INT64_MIN};
    const fmi3Boolean no = false;
    fmi3Boolean value = true;
    fmi3Instance instance = instance_at(ME_INITIALIZING);
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        assert_int_equal(fmi3SetInt64(instance, &method, 1, &bad[i], 1), fmi3Discard);
        assert_int_equal(get_enumeration(instance, "solver.method"), 1);
    }
    assert_int_equal(fmi3SetBoolean(instance, &stop, 1, &no, 1), fmi3OK);
    assert_int_equal(fmi3GetBoolean(instance, &stop, 1, &value, 1), fmi3OK);
    assert_false(value);
    fmi3FreeInstance(instance);
}

static void wrong_counts_references_and_arrays_are_refused(void **state) {
    const fmi3ValueReference reference = 0, none = 100000;
    double values[TDMF_STATE_COUNT] = {0};
    fmi3Instance instance = instance_at(ME_EVENT);
    (void)state;
    assert_int_equal(fmi3GetFloat64(instance, &reference, 1, values, 2), fmi3Error);
    assert_non_null(strstr(last_message, "scalar"));
    assert_int_equal(fmi3GetFloat64(instance, &none, 1, values, 1), fmi3Error);
    assert_non_null(strstr(last_message, "100000"));
    assert_int_equal(fmi3GetFloat64(instance, &reference, 1, NULL, 1), fmi3Error);
    assert_int_equal(fmi3GetFloat64(instance, NULL, 0, NULL, 0), fmi3OK);
    assert_int_equal(fmi3GetContinuousStates(instance, values, TDMF_STATE_COUNT - 1), fmi3Error);
    assert_non_null(strstr(last_message, "14"));
    fmi3FreeInstance(instance);
}

static void bad_experiments_and_bad_starts_are_refused(void **state) {
    static const struct {
        double tolerance, start, stop;
    } bad[] = {{0.0, 0.0, 1.0}, {NAN, 0.0, 1.0}, {1e-6, NAN, 1.0}, {1e-6, 2.0, 1.0}, {1e-6, 0.0, NAN}};
    fmi3Instance instance = new_exchange();
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        assert_int_equal(
            fmi3EnterInitializationMode(instance, true, bad[i].tolerance, bad[i].start, true, bad[i].stop),
            fmi3Error);
    }
    assert_int_equal(set_float(instance, "leg.length", 0.5), fmi3OK);
    assert_int_equal(set_float(instance, "leg.min_length", 0.6), fmi3OK);
    assert_int_equal(call_enter_initialization(instance), fmi3OK);
    assert_int_equal(fmi3ExitInitializationMode(instance), fmi3Error);
    assert_non_null(strstr(last_message, "leg.length = 0.5 m is refused: allowed from 0.6"));
    fmi3FreeInstance(instance);
}

static void initialization_shows_what_would_start(void **state) {
    double derivatives[TDMF_STATE_COUNT], indicators[TDMF_GUARD_COUNT];
    fmi3Instance instance = instance_at(ME_INITIALIZING);
    (void)state;
    assert_int_equal(set_float(instance, "foot.vy", -0.5), fmi3OK);
    assert_int_equal(fmi3GetContinuousStateDerivatives(instance, derivatives, TDMF_STATE_COUNT), fmi3OK);
    assert_true(derivatives[TDMF_FOOT_Y] == -0.5);
    assert_int_equal(fmi3GetEventIndicators(instance, indicators, TDMF_GUARD_COUNT), fmi3OK);
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        assert_true(indicators[i] > 0.0);
    }
    fmi3FreeInstance(instance);
}

static void indicators_are_variables_too(void **state) {
    double indicators[TDMF_GUARD_COUNT];
    const fmi3ValueReference first = reference_of("guard.touchdown");
    fmi3Instance instance = instance_at(ME_CONTINUOUS);
    (void)state;
    assert_int_equal(fmi3GetEventIndicators(instance, indicators, TDMF_GUARD_COUNT), fmi3OK);
    assert_close(indicators[TDMF_GUARD_TOUCHDOWN], get_float(instance, "foot.y"), 1e-9);
    for (fmi3ValueReference i = 0; i < TDMF_GUARD_COUNT; ++i) {
        const fmi3ValueReference reference = first + i;
        double value;
        assert_int_equal(fmi3GetFloat64(instance, &reference, 1, &value, 1), fmi3OK);
        assert_true(value == indicators[i]);
    }
    fmi3FreeInstance(instance);
}

/* ---- running in Model Exchange ------------------------------------------------------------------------ */

/* Puts the foot below the ground, moving down, and updates there. */
static void land(fmi3Instance instance, update_answer *answer) {
    double states[TDMF_STATE_COUNT];
    assert_int_equal(fmi3GetContinuousStates(instance, states, TDMF_STATE_COUNT), fmi3OK);
    states[TDMF_FOOT_Y] = -1e-12;
    states[TDMF_FOOT_VY] = -0.1;
    assert_int_equal(fmi3SetContinuousStates(instance, states, TDMF_STATE_COUNT), fmi3OK);
    assert_int_equal(fmi3EnterEventMode(instance), fmi3OK);
    assert_int_equal(update(instance, answer), fmi3OK);
}

static void event_mode_goes_by_the_guards(void **state) {
    update_answer answer;
    fmi3Instance instance = instance_at(ME_CONTINUOUS);
    (void)state;
    assert_int_equal(fmi3EnterEventMode(instance), fmi3OK);
    assert_int_equal(update(instance, &answer), fmi3OK);
    assert_false(answer.states_changed || answer.needs_update || answer.terminate ||
                 answer.nominals_changed || answer.next_time_defined);
    assert_int_equal(fmi3EnterContinuousTimeMode(instance), fmi3OK);
    land(instance, &answer);
    assert_true(answer.states_changed && !answer.terminate);
    assert_int_equal(get_int(instance, "event.count"), 1);
    assert_true(get_float(instance, "foot.vy") == 0.0);
    fmi3FreeInstance(instance);
}

static void a_fall_asks_to_stop_where_the_parameter_says_so(void **state) {
    const fmi3ValueReference reference = reference_of("status.terminate_on_fall");
    (void)state;
    for (int i = 0; i < 2; ++i) {
        const fmi3Boolean stop = i == 1;
        double states[TDMF_STATE_COUNT];
        update_answer answer;
        fmi3Instance instance = new_exchange();
        assert_int_equal(fmi3SetBoolean(instance, &reference, 1, &stop, 1), fmi3OK);
        initialize3(instance);
        assert_int_equal(fmi3EnterContinuousTimeMode(instance), fmi3OK);
        tdmf_default_state(states);
        states[TDMF_LEG_LENGTH] = 0.01;
        assert_int_equal(fmi3SetContinuousStates(instance, states, TDMF_STATE_COUNT), fmi3OK);
        assert_int_equal(fmi3EnterEventMode(instance), fmi3OK);
        assert_int_equal(update(instance, &answer), fmi3OK);
        assert_int_equal(answer.terminate, stop);
        fmi3FreeInstance(instance);
    }
}

static void trial_states_are_cut_or_discarded(void **state) {
    double states[TDMF_STATE_COUNT], derivatives[TDMF_STATE_COUNT];
    fmi3Instance instance = instance_at(ME_CONTINUOUS);
    (void)state;
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        tdmf_default_state(states);
        states[i] = INFINITY;
        assert_int_equal(fmi3SetContinuousStates(instance, states, TDMF_STATE_COUNT), fmi3OK);
        assert_int_equal(fmi3GetContinuousStateDerivatives(instance, derivatives, TDMF_STATE_COUNT), fmi3OK);
        for (int j = 0; j < TDMF_STATE_COUNT; ++j) {
            assert_true(isfinite(derivatives[j]));
        }
        states[i] = NAN;
        assert_int_equal(fmi3SetContinuousStates(instance, states, TDMF_STATE_COUNT), fmi3Discard);
    }
    fmi3FreeInstance(instance);
}

/* ---- derivatives -------------------------------------------------------------------------------------- */

enum { UNKNOWNS = 3, KNOWNS = 4 };
static const char *const unknown_names[UNKNOWNS] = {"der(foot.vx)", "contact.fy", "energy.kinetic"};
static const char *const known_names[KNOWNS] = {"leg.length", "leg.angle", "leg.angle_rate",
                                                "hip.external_torque"};

/* A Model Exchange instance that slips on the ground. */
static fmi3Instance slipping(void) {
    fmi3Instance instance = new_exchange();
    assert_int_equal(set_float(instance, "foot.y", 0.0), fmi3OK);
    assert_int_equal(set_float(instance, "foot.vy", 0.0), fmi3OK);
    assert_int_equal(set_float(instance, "leg.length", 0.8), fmi3OK);
    assert_int_equal(set_float(instance, "leg.angle", 0.4), fmi3OK);
    initialize3(instance);
    assert_int_equal(fmi3EnterContinuousTimeMode(instance), fmi3OK);
    assert_int_equal(get_enumeration(instance, "contact.mode"), TDMF_CONTACT_SLIP_POSITIVE);
    return instance;
}

static double difference(fmi3Instance instance, const char *unknown, const char *known) {
    static const double delta = 1e-6;
    double states[TDMF_STATE_COUNT], values[2];
    assert_int_equal(fmi3GetContinuousStates(instance, states, TDMF_STATE_COUNT), fmi3OK);
    for (int i = 0; i < 2; ++i) {
        const double shift = i == 0 ? -delta : delta;
        const fmi3ValueReference reference = reference_of(known);
        if (fmu_variables[reference].storage == STORED_INPUT) {
            assert_int_equal(set_float(instance, known, shift), fmi3OK);
            values[i] = get_float(instance, unknown);
            assert_int_equal(set_float(instance, known, 0.0), fmi3OK);
        } else {
            double moved[TDMF_STATE_COUNT];
            memcpy(moved, states, sizeof moved);
            moved[fmu_variables[reference].offset] += shift;
            assert_int_equal(fmi3SetContinuousStates(instance, moved, TDMF_STATE_COUNT), fmi3OK);
            values[i] = get_float(instance, unknown);
            assert_int_equal(fmi3SetContinuousStates(instance, states, TDMF_STATE_COUNT), fmi3OK);
        }
    }
    return (values[1] - values[0]) / (2.0 * delta);
}

/* Column by column against central differences, and both ways round: seeds' J v = (J' seeds)' v. */
static void directional_and_adjoint_derivatives_are_one_matrix(void **state) {
    static const double weights[UNKNOWNS] = {0.3, -2.0, 1.7};
    fmi3ValueReference unknowns[UNKNOWNS], knowns[KNOWNS];
    double adjoint[KNOWNS];
    fmi3Instance instance = slipping();
    (void)state;
    for (int i = 0; i < UNKNOWNS; ++i) {
        unknowns[i] = reference_of(unknown_names[i]);
    }
    for (int j = 0; j < KNOWNS; ++j) {
        knowns[j] = reference_of(known_names[j]);
    }
    assert_int_equal(fmi3GetAdjointDerivative(instance, unknowns, UNKNOWNS, knowns, KNOWNS, weights, UNKNOWNS,
                                              adjoint, KNOWNS),
                     fmi3OK);
    for (int j = 0; j < KNOWNS; ++j) {
        const double one = 1.0;
        double column[UNKNOWNS];
        double sum = 0.0;
        assert_int_equal(fmi3GetDirectionalDerivative(instance, unknowns, UNKNOWNS, &knowns[j], 1, &one, 1,
                                                      column, UNKNOWNS),
                         fmi3OK);
        for (int i = 0; i < UNKNOWNS; ++i) {
            assert_close(column[i], difference(instance, unknown_names[i], known_names[j]), 1e-7);
            sum += weights[i] * column[i];
        }
        assert_close(adjoint[j], sum, 1e-12);
    }
    fmi3FreeInstance(instance);
}

/* In initialization mode they are those of the run that would start. */
static void derivatives_are_there_before_the_run(void **state) {
    const fmi3ValueReference unknown = reference_of("der(foot.vy)"), known = reference_of("leg.length");
    const double seed = 1.0;
    double before, after;
    fmi3Instance instance = new_exchange();
    (void)state;
    assert_int_equal(fmi3EnterInitializationMode(instance, false, 0.0, 0.0, false, 0.0), fmi3OK);
    assert_int_equal(set_float(instance, "leg.stiffness", 3.0), fmi3OK);
    assert_int_equal(fmi3GetDirectionalDerivative(instance, &unknown, 1, &known, 1, &seed, 1, &before, 1),
                     fmi3OK);
    assert_int_equal(fmi3ExitInitializationMode(instance), fmi3OK);
    assert_int_equal(fmi3GetDirectionalDerivative(instance, &unknown, 1, &known, 1, &seed, 1, &after, 1),
                     fmi3OK);
    assert_true(before == after && before != 0.0);
    fmi3FreeInstance(instance);
}

static void nominals_are_those_of_the_parameters_set(void **state) {
    double nominals[TDMF_STATE_COUNT];
    fmi3Instance instance = new_exchange();
    (void)state;
    assert_int_equal(fmi3EnterInitializationMode(instance, false, 0.0, 0.0, false, 0.0), fmi3OK);
    assert_int_equal(set_float(instance, "leg.free_length", 2.0), fmi3OK);
    assert_int_equal(fmi3GetNominalsOfContinuousStates(instance, nominals, TDMF_STATE_COUNT), fmi3OK);
    assert_true(nominals[TDMF_LEG_LENGTH] == 2.0);
    fmi3FreeInstance(instance);
}

static void derivatives_by_what_is_fixed_are_refused(void **state) {
    const fmi3ValueReference unknown = reference_of("body.x"), mass = reference_of("body.mass"),
                             known = reference_of("leg.angle");
    const double seed = 1.0, bad = NAN;
    double value;
    fmi3Instance instance = slipping();
    (void)state;
    assert_int_equal(fmi3GetAdjointDerivative(instance, &unknown, 1, &known, 1, &bad, 1, &value, 1),
                     fmi3Discard);
    assert_int_equal(fmi3GetDirectionalDerivative(instance, &unknown, 1, &known, 1, &bad, 1, &value, 1),
                     fmi3Discard);
    assert_int_equal(fmi3GetAdjointDerivative(instance, &unknown, 1, &mass, 1, &seed, 1, &value, 1),
                     fmi3Error);
    assert_non_null(strstr(last_message, "body.mass"));
    fmi3FreeInstance(instance);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(refuses_wrong_name_and_token),
        cmocka_unit_test(refuses_an_interface_it_does_not_have),
        cmocka_unit_test(an_importer_that_offers_intermediate_updates_is_never_called_back),
        cmocka_unit_test(refuses_null_instances),
        cmocka_unit_test(runs_without_logger),
        cmocka_unit_test(follows_the_call_sequence_and_stays_as_it_was_where_that_is_broken),
        cmocka_unit_test(refuses_what_the_unit_does_not_have),
        cmocka_unit_test(every_variable_is_read_by_its_own_type_only),
        cmocka_unit_test(values_out_of_range_are_discarded_and_the_old_kept),
        cmocka_unit_test(enumerations_and_booleans_are_set_in_range_only),
        cmocka_unit_test(wrong_counts_references_and_arrays_are_refused),
        cmocka_unit_test(bad_experiments_and_bad_starts_are_refused),
        cmocka_unit_test(initialization_shows_what_would_start),
        cmocka_unit_test(indicators_are_variables_too),
        cmocka_unit_test(event_mode_goes_by_the_guards),
        cmocka_unit_test(a_fall_asks_to_stop_where_the_parameter_says_so),
        cmocka_unit_test(trial_states_are_cut_or_discarded),
        cmocka_unit_test(directional_and_adjoint_derivatives_are_one_matrix),
        cmocka_unit_test(derivatives_are_there_before_the_run),
        cmocka_unit_test(nominals_are_those_of_the_parameters_set),
        cmocka_unit_test(derivatives_by_what_is_fixed_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
