/* Legal and illegal sequences of FMI 3.0 calls with any values: no crash, no leak, no hang, and no number
 * that is not one behind fmi3OK; what is saved can be restored. */
#include "instance.h" /* before cmocka, which takes a name of it for a macro */

#include "fmi3_importer.h"
#include "forge.h"
#include "fuzz.h"
#include "tdmf_slip/tdmf_slip.h"

#include <math.h>
#include <string.h>

typedef struct {
    random_source *source;
    bool careful; /* keeps to the call sequence, so that it gets far */
    fmi_kind kind;
    bool returns_early; /* with events */
    fmi3Instance instance;
    fmi3FMUState saved; /* of this instance or an earlier one */
    fmi3Byte bytes[8192];
    size_t size;
} subject;

/* ---- one call each ------------------------------------------------------------------------------------ */

static void get_any(void *self) {
    subject *on = self;
    const uint32_t reference = on->careful ? reference_of("com.y") : random_reference(on->source);
    double real = 0.0;
    fmi3Int32 integer = 0;
    fmi3Int64 item = 0;
    fmi3Boolean truth = false;
    fmi3Float32 single = 0.0F;
    const char *text = "";
    expect_numbers((int)fmi3GetFloat64(on->instance, &reference, 1, &real, 1), &real, 1);
    if (on->careful) {
        return;
    }
    fmi3GetInt32(on->instance, &reference, 1, &integer, 1);
    fmi3GetInt64(on->instance, &reference, 1, &item, 1);
    fmi3GetBoolean(on->instance, &reference, 1, &truth, random_index(on->source, 3));
    if (random_chance(on->source, 0.1)) {
        fmi3GetFloat32(on->instance, &reference, 1, &single, 1);
    }
    if (fmi3GetString(on->instance, &reference, 1, &text, 1) == fmi3OK && strlen(text) >= WORD_CAPACITY) {
        die("a word too long");
    }
}

static void get_all(void *self) {
    subject *on = self;
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const uint32_t reference = (uint32_t)i;
        double real = 0.0;
        if (fmu_variables[i].type == VARIABLE_REAL) {
            expect_numbers((int)fmi3GetFloat64(on->instance, &reference, 1, &real, 1), &real, 1);
        }
    }
}

static void set_any(void *self) {
    subject *on = self;
    const uint32_t reference =
        on->careful ? random_setting(on->source, on->kind == STEPS) : random_reference(on->source);
    const bool is_there = reference < fmu_variable_count;
    const double real = is_there && random_chance(on->source, 0.7)
                            ? tame_value(on->source, &fmu_variables[reference])
                            : random_value(on->source);
    const fmi3Int64 item = (fmi3Int64)random_index(on->source, 5) - 1;
    const fmi3Boolean truth = random_chance(on->source, 0.5);
    const char *text = "x";
    switch (is_there ? fmu_variables[reference].type : VARIABLE_REAL) {
    case VARIABLE_BOOLEAN:
        fmi3SetBoolean(on->instance, &reference, 1, &truth, 1);
        break;
    case VARIABLE_ENUMERATION:
        fmi3SetInt64(on->instance, &reference, 1, &item, 1);
        break;
    case VARIABLE_STRING:
        fmi3SetString(on->instance, &reference, 1, &text, 1);
        break;
    default:
        fmi3SetFloat64(on->instance, &reference, 1, &real, 1);
    }
}

static void change_mode(void *self) {
    subject *on = self;
    update_answer answer;
    fmi3Boolean enter, stop;
    size_t count;
    switch (on->careful ? 10 : random_index(on->source, 10)) {
    case 0:
        fmi3EnterInitializationMode(on->instance, random_chance(on->source, 0.5), random_value(on->source),
                                    random_value(on->source), random_chance(on->source, 0.5),
                                    random_value(on->source));
        break;
    case 1:
        fmi3ExitInitializationMode(on->instance);
        break;
    case 2:
        fmi3EnterEventMode(on->instance);
        break;
    case 3:
        update(on->instance, &answer);
        break;
    case 4:
        fmi3EnterContinuousTimeMode(on->instance);
        break;
    case 5:
        fmi3CompletedIntegratorStep(on->instance, true, &enter, &stop);
        break;
    case 6:
        fmi3SetTime(on->instance, random_value(on->source));
        break;
    case 7:
        fmi3EnterStepMode(on->instance);
        break;
    case 8:
        fmi3GetNumberOfContinuousStates(on->instance, &count);
        break;
    default:
        if (!on->careful && random_chance(on->source, 0.1)) {
            fmi3Terminate(on->instance);
        }
    }
}

/* Before the start any variable may be set; most of these runners run. */
static void set_before_start(subject *on) {
    for (int i = 0; i < 5; ++i) {
        const uint32_t reference = (uint32_t)random_index(on->source, fmu_variable_count);
        const fmu_variable *variable = &fmu_variables[reference];
        const double value =
            random_chance(on->source, 0.9) ? tame_value(on->source, variable) : random_value(on->source);
        if (variable->settable_before_start && variable->type == VARIABLE_REAL) {
            fmi3SetFloat64(on->instance, &reference, 1, &value, 1);
        }
    }
}

/* An event iteration, with a jump of what may be set then, and back to where time goes on. */
static void handle_event(subject *on) {
    update_answer answer;
    if (random_chance(on->source, 0.5)) {
        const uint32_t reference = random_setting(on->source, true);
        const double value = tame_value(on->source, &fmu_variables[reference]);
        fmi3SetFloat64(on->instance, &reference, 1, &value, 1);
    }
    update(on->instance, &answer);
    if (on->kind == EXCHANGE) {
        fmi3EnterContinuousTimeMode(on->instance);
    } else {
        fmi3EnterStepMode(on->instance);
    }
}

static void start_over(void *self) {
    subject *on = self;
    fmi3Reset(on->instance);
    set_before_start(on);
    fmi3EnterInitializationMode(on->instance, false, 0.0, 0.0, false, 0.0);
    fmi3ExitInitializationMode(on->instance);
    if (on->kind != STEPS) {
        handle_event(on);
    }
}

static void evaluate(void *self) {
    subject *on = self;
    if (on->careful && on->kind != EXCHANGE) {
        return;
    }
    double states[TDMF_STATE_COUNT], values[TDMF_GUARD_COUNT + TDMF_STATE_COUNT];
    tdmf_default_state(states);
    states[random_index(on->source, TDMF_STATE_COUNT)] = random_value(on->source);
    fmi3SetContinuousStates(on->instance, states, TDMF_STATE_COUNT);
    expect_numbers((int)fmi3GetContinuousStates(on->instance, values, TDMF_STATE_COUNT), values,
                   TDMF_STATE_COUNT);
    expect_numbers((int)fmi3GetContinuousStateDerivatives(on->instance, values, TDMF_STATE_COUNT), values,
                   TDMF_STATE_COUNT);
    expect_numbers((int)fmi3GetEventIndicators(on->instance, values, TDMF_GUARD_COUNT), values,
                   TDMF_GUARD_COUNT);
    expect_numbers((int)fmi3GetNominalsOfContinuousStates(on->instance, values, TDMF_STATE_COUNT), values,
                   TDMF_STATE_COUNT);
}

static void differentiate(void *self) {
    subject *on = self;
    const uint32_t unknown = on->careful ? reference_of("der(foot.vx)") : random_reference(on->source);
    const uint32_t known = on->careful ? reference_of("leg.angle") : random_reference(on->source);
    const fmi3Int32 order = (fmi3Int32)random_index(on->source, 3);
    const double seed = random_value(on->source);
    double value = 0.0;
    fmi3Status status =
        fmi3GetDirectionalDerivative(on->instance, &unknown, 1, &known, 1, &seed, 1, &value, 1);
    expect_numbers(fabs(seed) < 1e100 ? (int)status : (int)fmi3Discard, &value, 1);
    status = fmi3GetAdjointDerivative(on->instance, &unknown, 1, &known, 1, &seed, 1, &value, 1);
    expect_numbers(fabs(seed) < 1e100 ? (int)status : (int)fmi3Discard, &value, 1);
    if (!on->careful) {
        expect_numbers((int)fmi3GetOutputDerivatives(on->instance, &unknown, 1, &order, &value, 1), &value,
                       1);
    }
}

static void limit_steps(subject *on) {
    ((struct instance *)on->instance)->fmu.step_limit = STEPS_OF_A_CALL;
}

static void step(void *self) {
    subject *on = self;
    const uint32_t time_reference = reference_of("time");
    step_answer answer = {false, false, false, 0.0};
    double time = 0.0;
    if ((on->careful && on->kind == EXCHANGE) ||
        fmi3GetFloat64(on->instance, &time_reference, 1, &time, 1) != fmi3OK) {
        return;
    }
    const bool wild = !on->careful && random_chance(on->source, 0.1);
    const double length = wild ? random_value(on->source) : random_magnitude(on->source, 1e-6, 1e2);
    const double from = wild ? random_value(on->source) : time;
    limit_steps(on);
    if (do_step(on->instance, from, length, &answer) != fmi3OK) {
        return;
    }
    if (answer.event && !on->returns_early) {
        die("an event that was not asked for");
    }
    if (!(answer.time >= time && answer.time <= from + length) ||
        answer.early != (answer.time < from + length)) {
        die("a step to nowhere");
    }
    if (answer.event && random_chance(on->source, 0.9) && fmi3EnterEventMode(on->instance) == fmi3OK) {
        handle_event(on);
    }
}

static void save_and_restore(void *self) {
    subject *on = self;
    switch (random_index(on->source, 5)) {
    case 0:
        if (fmi3GetFMUState(on->instance, &on->saved) == fmi3OK &&
            fmi3SetFMUState(on->instance, on->saved) != fmi3OK) {
            die("what was saved is not restored");
        }
        break;
    case 1:
        fmi3SetFMUState(on->instance, on->saved);
        break;
    case 2:
        if (on->saved != NULL && fmi3SerializedFMUStateSize(on->instance, on->saved, &on->size) == fmi3OK) {
            if (on->size > sizeof on->bytes) {
                die("a saved state too long");
            }
            fmi3SerializeFMUState(on->instance, on->saved, on->bytes, on->size);
        }
        break;
    case 3:
        if (random_chance(on->source, 0.5) && on->size > 0) {
            forge(on->source, (unsigned char *)on->bytes, on->size);
        }
        fmi3DeserializeFMUState(on->instance, on->bytes, on->size, &on->saved);
        break;
    default:
        fmi3FreeFMUState(on->instance, &on->saved);
    }
}

/* With its events logged, a step goes another way. */
static void switch_logging(void *self) {
    subject *on = self;
    fmi3SetDebugLogging(on->instance, random_chance(on->source, 0.5), 1, events_category);
}

/* ---- sequences ---------------------------------------------------------------------------------------- */

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size) {
    static void (*const calls[])(void *) = {get_any,        get_all,          set_any,  change_mode,
                                            switch_logging, start_over,       evaluate, differentiate,
                                            step,           save_and_restore, step};
    random_source source = {0};
    subject on;
    random_draw_from(bytes, size);
    memset(&on, 0, sizeof on);
    on.source = &source;
    on.careful = random_chance(&source, 0.5);
    const size_t way = random_index(&source, KINDS + 1); /* with events by two ways, the last returns early */
    on.kind = way < KINDS ? (fmi_kind)way : STEPS_WITH_EVENTS;
    on.returns_early = way == KINDS;
    on.instance = on.kind == EXCHANGE ? new_exchange() : new_stepper(on.kind != STEPS, on.returns_early);
    start_over(&on);
    call_until_used_up(&source, calls, sizeof calls / sizeof calls[0], &on);
    fmi3FreeFMUState(on.instance, &on.saved);
    fmi3FreeInstance(on.instance);
    return 0;
}
