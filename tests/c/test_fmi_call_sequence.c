/* Life cycle of an instance: how it is made, in which state each call is refused, with which words, and what
 * stays as it was. */
#include "compare.h"
#include "fmi2_importer.h"
#include "fmi3_importer.h"

#include "guid.h"

#include <math.h>
#include <string.h>

static const fmi_experiment from_zero = {.start = 0.0};

/* ---- instantiation ------------------------------------------------------------------------------------ */

static void assert_not_made(const fmi_interface *fmi, const char *name, const char *token,
                            const char *reason) {
    for (fmi_kind kind = EXCHANGE; kind < fmi->kinds; ++kind) {
        clear_messages();
        assert_null(fmi->instantiate(kind, name, token, true, false));
        assert_int_equal(message_count, 1);
        assert_non_null(strstr(last_message, reason));
        assert_null(fmi->instantiate(kind, name, token, false, false));
        assert_int_equal(message_count, 1);
    }
}

FMI_TEST(refuses_wrong_name_and_token) {
    const char *const reason = fmi == &fmi2 ? "guid" : "token";
    assert_not_made(fmi, "", FMU_GUID, "name");
    assert_not_made(fmi, NULL, FMU_GUID, "name");
    assert_not_made(fmi, "runner", "{another}", reason);
    assert_not_made(fmi, "runner", NULL, reason);
}

TEST(fmi2_refuses_a_type_that_is_none) {
    clear_messages();
    assert_null(
        fmi2Instantiate("runner", (fmi2Type)7, FMU_GUID, NULL, &importer_callbacks, fmi2False, fmi2False));
    assert_int_equal(message_count, 1);
    assert_non_null(strstr(last_message, "neither"));
}

FMI_TEST(runs_without_logger) {
    void *instance = fmi->instantiate(EXCHANGE, "runner", FMU_GUID, false, true);
    assert_non_null(instance);
    free_after_test(instance, fmi->free);
    begin(fmi, instance, EXCHANGE);
    assert_int_equal(fmi->set_time(instance, NAN), FMI_ERROR);
}

FMI_TEST(refuses_null_instances) {
    const uint32_t reference = 0;
    double value = 0.0;
    void *saved = NULL;
    update_answer updated;
    step_answer step;
    assert_int_equal(fmi->get_reals(NULL, &reference, 1, &value), FMI_ERROR);
    assert_int_equal(fmi->set_reals(NULL, &reference, 1, &value), FMI_ERROR);
    assert_int_equal(fmi->enter_event_mode(NULL), FMI_ERROR);
    assert_int_equal(fmi->set_time(NULL, 0.0), FMI_ERROR);
    assert_int_equal(fmi->update(NULL, &updated), FMI_ERROR);
    assert_int_equal(fmi->do_step(NULL, 0.0, 1.0, &step), FMI_ERROR);
    assert_int_equal(fmi->output_derivative(NULL, reference, 1, &value), FMI_ERROR);
    assert_int_equal(fmi->save(NULL, NULL), FMI_ERROR);
    assert_int_equal(fmi->save(NULL, &saved), FMI_ERROR);
    assert_int_equal(fmi->reset(NULL), FMI_ERROR);
    fmi->free(NULL);
}

/* ---- call sequence ------------------------------------------------------------------------------------ */

/* Defines a call for the table below. */
#define CALL(name, ...)                                                                                      \
    static fmi_status call_##name(const fmi_interface *fmi, void *instance) {                                \
        (void)fmi;                                                                                           \
        return (fmi_status)(__VA_ARGS__);                                                                    \
    }

static double numbers[CONTINUOUS_STATES + TDMF_GUARD_COUNT]; /* room for answers */
static update_answer updated;
static step_answer stepped;
static bool truths[2];
static uint32_t reference, unknown, known; /* of foot.x, body.y and leg.angle */
static const double one = 1.0;

CALL(enter_initialization, fmi->enter_initialization(instance, &from_zero))
/* FMI 2.0 allows initialization without fmi2SetupExperiment. */
CALL(enter_initialization_of_fmi2, fmi2EnterInitializationMode(instance))
CALL(exit_initialization, fmi->exit_initialization(instance))
CALL(enter_event_mode, fmi->enter_event_mode(instance))
CALL(update, fmi->update(instance, &updated))
CALL(enter_continuous_time_mode, fmi->enter_continuous_time_mode(instance))
CALL(enter_step_mode, fmi->enter_step_mode(instance))
CALL(do_step, fmi->do_step(instance, 0.0, 1.0, &stepped))
CALL(completed_step, fmi->complete_step(instance, &truths[0], &truths[1]))
CALL(set_time, fmi->set_time(instance, 0.0))
CALL(get_states, fmi->get_states(instance, numbers, CONTINUOUS_STATES))
CALL(get_derivatives, fmi->get_derivatives(instance, numbers, CONTINUOUS_STATES))
CALL(get_indicators, fmi->get_indicators(instance, numbers, TDMF_GUARD_COUNT))
CALL(get_nominals, fmi->get_nominals(instance, numbers, CONTINUOUS_STATES))
CALL(get, fmi->get_reals(instance, &reference, 1, numbers))
CALL(set_input, set_value(fmi, instance, "ground.friction", 0.6))
CALL(set_state, set_value(fmi, instance, "foot.vx", 1.0))
/* No event makes this state jump: reinit = false. */
CALL(set_smooth_state, set_value(fmi, instance, "foot.x", 1.0))
CALL(set_parameter, set_value(fmi, instance, "body.mass", 1.0))
CALL(set_logging, fmi->set_logging(instance, false, 1, events_category))
CALL(evaluate_discrete_states, fmi3EvaluateDiscreteStates(instance))
CALL(directional_derivative, fmi->directional_derivative(instance, &unknown, 1, &known, 1, &one, numbers))
CALL(adjoint_derivative, fmi3GetAdjointDerivative(instance, &unknown, 1, &known, 1, &one, 1, numbers, 1))
CALL(output_derivative, fmi->output_derivative(instance, unknown, 1, numbers))
CALL(terminate, fmi->terminate(instance))
CALL(reset, fmi->reset(instance))

static fmi_status call_set_states(const fmi_interface *fmi, void *instance) {
    double states[CONTINUOUS_STATES];
    write_default_states(states);
    return fmi->set_states(instance, states, CONTINUOUS_STATES);
}

static fmi_status call_save(const fmi_interface *fmi, void *instance) {
    void *saved = NULL;
    const fmi_status status = fmi->save(instance, &saved);
    assert_int_equal(fmi->free_saved(instance, &saved), FMI_OK);
    return status;
}

static fmi_status call_counts(const fmi_interface *fmi, void *instance) {
    size_t states = 0, indicators = 0;
    (void)fmi;
    const fmi3Status status = fmi3GetNumberOfContinuousStates(instance, &states);
    assert_int_equal(fmi3GetNumberOfEventIndicators(instance, &indicators), status);
    assert_int_equal(states, CONTINUOUS_STATES);
    assert_int_equal(indicators, TDMF_GUARD_COUNT);
    return (fmi_status)status;
}

/* States of an instance: Model Exchange first, then Co-Simulation with event mode, then without. */
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
    OF_FMI3_ALONE = CS_EVENT | CS_STEP,
    EVENT = ME_EVENT | CS_EVENT,
    STEP = CS_STEP | CS_PLAIN_STEP,
    ENDED = ME_ENDED | CS_ENDED,
    RUN = EVENT | ME_CONTINUOUS | STEP,
    EVALUABLE = ME_INITIALIZING | EVENT | ME_CONTINUOUS | ENDED,
    EVERYWHERE = (1 << SITUATIONS) - 1
};

typedef struct {
    const char *name; /* NULL where the version does not have the call */
    unsigned allowed;
} rule;

/* Rules of a call that both versions have, with the same states. */
#define ALIKE(name, allowed)                                                                                 \
    {"fmi2" name, allowed}, {                                                                                \
        "fmi3" name, allowed                                                                                 \
    }
#define NONE                                                                                                 \
    { NULL, 0 }

/* Rules from the table of FMI 2.0, section 3.2.3, and from the state machines of FMI 3.0, sections 2.3, 3.2
 * and 4.2. In addition, values may be read before initialization, because importers do. */
static const struct {
    fmi_status (*call)(const fmi_interface *fmi, void *instance);
    rule fmi2, fmi3;
} calls[] = {
    {call_enter_initialization,
     {"fmi2SetupExperiment", ME_BEFORE},
     {"fmi3EnterInitializationMode", ME_BEFORE}},
    {call_enter_initialization_of_fmi2, {"fmi2EnterInitializationMode", ME_BEFORE}, NONE},
    {call_exit_initialization, ALIKE("ExitInitializationMode", ME_INITIALIZING)},
    {call_enter_event_mode,
     {"fmi2EnterEventMode", ME_EVENT | ME_CONTINUOUS},
     {"fmi3EnterEventMode", ME_CONTINUOUS | CS_STEP}},
    {call_update, {"fmi2NewDiscreteStates", EVENT}, {"fmi3UpdateDiscreteStates", EVENT}},
    {call_enter_continuous_time_mode, ALIKE("EnterContinuousTimeMode", ME_EVENT)},
    {call_enter_step_mode, NONE, {"fmi3EnterStepMode", CS_EVENT}},
    {call_do_step, ALIKE("DoStep", STEP)},
    {call_completed_step, ALIKE("CompletedIntegratorStep", ME_CONTINUOUS)},
    {call_set_time, ALIKE("SetTime", ME_EVENT | ME_CONTINUOUS)},
    {call_set_states, ALIKE("SetContinuousStates", ME_CONTINUOUS)},
    {call_get_states, ALIKE("GetContinuousStates", EVALUABLE)},
    {call_get_derivatives,
     {"fmi2GetDerivatives", EVALUABLE},
     {"fmi3GetContinuousStateDerivatives", EVALUABLE}},
    {call_get_indicators, ALIKE("GetEventIndicators", EVALUABLE)},
    {call_get_nominals, ALIKE("GetNominalsOfContinuousStates", ME_BEFORE | EVALUABLE)},
    {call_get, {"fmi2GetReal", EVERYWHERE}, {"fmi3GetFloat64", EVERYWHERE}},
    {call_set_input, {"fmi2SetReal", EVERYWHERE & ~ENDED}, {"fmi3SetFloat64", EVERYWHERE & ~ENDED}},
    {call_set_state,
     {"fmi2SetReal", ME_BEFORE | ME_INITIALIZING | ME_CONTINUOUS},
     {"fmi3SetFloat64", ME_BEFORE | ME_INITIALIZING | ME_CONTINUOUS}},
    {call_set_smooth_state,
     {"fmi2SetReal", ME_BEFORE | ME_INITIALIZING | ME_EVENT | ME_CONTINUOUS},
     {"fmi3SetFloat64", ME_BEFORE | ME_INITIALIZING | ME_EVENT | ME_CONTINUOUS}},
    {call_set_parameter,
     {"fmi2SetReal", ME_BEFORE | ME_INITIALIZING},
     {"fmi3SetFloat64", ME_BEFORE | ME_INITIALIZING}},
    {call_set_logging, ALIKE("SetDebugLogging", EVERYWHERE)},
    {call_save, {"fmi2GetFMUstate", EVERYWHERE}, {"fmi3GetFMUState", EVERYWHERE}},
    {call_evaluate_discrete_states, NONE, {"fmi3EvaluateDiscreteStates", EVENT}},
    {call_counts, NONE, {"fmi3GetNumberOf", EVERYWHERE}},
    {call_directional_derivative, ALIKE("GetDirectionalDerivative", EVERYWHERE)},
    {call_adjoint_derivative, NONE, {"fmi3GetAdjointDerivative", EVERYWHERE}},
    {call_output_derivative,
     {"fmi2GetRealOutputDerivatives", STEP | CS_ENDED},
     {"fmi3GetOutputDerivatives", STEP | CS_ENDED}},
    {call_terminate, ALIKE("Terminate", RUN)},
    {call_reset, ALIKE("Reset", EVERYWHERE)},
};

static void *instance_at(const fmi_interface *fmi, unsigned situation) {
    const bool has_events = fmi->kinds > STEPS_WITH_EVENTS && situation != CS_PLAIN_STEP;
    void *instance = new_of_kind(fmi, situation <= ME_ENDED ? EXCHANGE
                                      : has_events          ? STEPS_WITH_EVENTS
                                                            : STEPS);
    if (situation == ME_INITIALIZING) {
        assert_int_equal(fmi->enter_initialization(instance, &from_zero), FMI_OK);
    } else if (situation != ME_BEFORE) {
        initialize_unit(fmi, instance);
    }
    if (situation == ME_CONTINUOUS || situation == CS_STEP) {
        update_and_go_on(fmi, instance, situation == ME_CONTINUOUS ? EXCHANGE : STEPS_WITH_EVENTS);
    } else if ((situation & ENDED) != 0) {
        assert_int_equal(fmi->terminate(instance), FMI_OK);
    }
    clear_messages();
    return instance;
}

/* Makes a call in a situation and checks its answer. True if the call was refused. */
static bool check(const fmi_interface *fmi, size_t i, unsigned situation) {
    const rule rule = fmi == &fmi2 ? calls[i].fmi2 : calls[i].fmi3;
    const bool allowed = (rule.allowed & situation) != 0;
    if (rule.name == NULL) {
        return false;
    }
    void *instance = instance_at(fmi, situation);
    const serialized before = serialize(fmi, instance);
    const fmi_status status = calls[i].call(fmi, instance);
    if (status != (allowed ? FMI_OK : FMI_ERROR)) {
        fail_msg("%s gives status %d in situation %u", rule.name, (int)status, situation);
    }
    assert_int_equal(message_count, allowed ? 0 : 1);
    if (!allowed) {
        assert_non_null(strstr(last_message, rule.name));
        assert_string_equal(last_category, "logStatusError");
        assert_state(fmi, instance, &before);
    }
    return !allowed;
}

FMI_TEST(follows_the_call_sequence_and_stays_as_it_was_where_that_is_broken) {
    int refused = 0;
    reference = reference_of("foot.x");
    unknown = reference_of("body.y");
    known = reference_of("leg.angle");
    for (size_t i = 0; i < COUNT_OF(calls); ++i) {
        for (unsigned situation = 1; situation < EVERYWHERE; situation <<= 1) {
            if (fmi != &fmi2 || (situation & OF_FMI3_ALONE) == 0) {
                refused += check(fmi, i, situation);
            }
        }
    }
    assert_int_equal(refused, fmi == &fmi2 ? 88 : 124);
}

FMI_TEST(a_call_that_an_interface_lacks_is_refused_with_the_name_of_the_interface) {
    step_answer step;
    void *exchange = new_of_kind(fmi, EXCHANGE), *steps = new_of_kind(fmi, STEPS);
    begin(fmi, exchange, EXCHANGE);
    begin(fmi, steps, STEPS);
    assert_int_equal(fmi->do_step(exchange, 0.0, 1.0, &step), FMI_ERROR);
    assert_non_null(strstr(last_message, "DoStep: not allowed in Model Exchange"));
    assert_int_equal(fmi->set_time(steps, 1.0), FMI_ERROR);
    assert_non_null(strstr(last_message, "SetTime: not allowed in Co-Simulation without event mode"));
    assert_int_equal(fmi->update(steps, &updated), FMI_ERROR);
    assert_non_null(strstr(last_message, "DiscreteStates: not allowed in Co-Simulation without event mode"));
}

TEST(fmi2_wants_room_for_an_update) {
    void *instance = new_of_kind(&fmi2, EXCHANGE);
    initialize_unit(&fmi2, instance);
    assert_int_equal(fmi2NewDiscreteStates(instance, NULL), fmi2Error);
}

TEST(fmi3_wants_room_for_each_answer_of_an_update) {
    void *instance = new_of_kind(&fmi3, EXCHANGE);
    initialize_unit(&fmi3, instance);
    for (int missing = 0; missing < 6; ++missing) {
        fmi3Boolean truths[5];
        fmi3Float64 time;
        fmi3Boolean *room[5];
        for (int i = 0; i < 5; ++i) {
            room[i] = i == missing ? NULL : &truths[i];
        }
        assert_int_equal(fmi3UpdateDiscreteStates(instance, room[0], room[1], room[2], room[3], room[4],
                                                  missing == 5 ? NULL : &time),
                         fmi3Error);
    }
}
