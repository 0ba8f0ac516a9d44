/* Legal and illegal sequences of FMI 2.0 calls with any values: no crash, no leak, no hang, and no number
 * that is not one behind fmi2OK; what is saved can be restored. */
#include "instance.h" /* before cmocka, which takes a name of it for a macro */

#include "fmi2_importer.h"
#include "forge.h"
#include "fuzz.h"
#include "tdmf_slip/tdmf_slip.h"

#include <math.h>
#include <string.h>

typedef struct {
    random_source *source;
    bool careful; /* keeps to the call sequence, so that it gets far */
    fmi2Type type;
    fmi2Component component;
    fmi2FMUstate saved; /* of this instance or an earlier one */
    fmi2Byte bytes[8192];
    size_t size;
} subject;

/* ---- one call each ------------------------------------------------------------------------------------ */

static void get_any(void *self) {
    subject *on = self;
    const fmi2ValueReference reference = on->careful ? reference_of("com.y") : random_reference(on->source);
    double real = 0.0;
    int integer = 0;
    const char *text = "";
    expect_numbers((int)fmi2GetReal(on->component, &reference, 1, &real), &real, 1);
    if (on->careful) {
        return;
    }
    fmi2GetInteger(on->component, &reference, 1, &integer);
    fmi2GetBoolean(on->component, &reference, 1, &integer);
    if (fmi2GetString(on->component, &reference, 1, &text) == fmi2OK && strlen(text) >= WORD_CAPACITY) {
        die("a word too long");
    }
}

static void get_all(void *self) {
    subject *on = self;
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmi2ValueReference reference = (fmi2ValueReference)i;
        double real = 0.0;
        if (fmu_variables[i].type == VARIABLE_REAL) {
            expect_numbers((int)fmi2GetReal(on->component, &reference, 1, &real), &real, 1);
        }
    }
}

static void set_any(void *self) {
    subject *on = self;
    const fmi2ValueReference reference =
        on->careful ? random_setting(on->source, on->type == fmi2CoSimulation) : random_reference(on->source);
    const bool tame = reference < fmu_variable_count && random_chance(on->source, 0.7);
    const double real = tame ? tame_value(on->source, &fmu_variables[reference]) : random_value(on->source);
    const int integer = (int)random_index(on->source, 5) - 1;
    const char *text = "x";
    if (reference >= fmu_variable_count || fmu_variables[reference].type == VARIABLE_REAL) {
        fmi2SetReal(on->component, &reference, 1, &real);
    } else if (fmu_variables[reference].type == VARIABLE_BOOLEAN) {
        fmi2SetBoolean(on->component, &reference, 1, &integer);
    } else if (random_chance(on->source, 0.1)) {
        fmi2SetString(on->component, &reference, 1, &text);
    } else {
        fmi2SetInteger(on->component, &reference, 1, &integer);
    }
}

static void change_mode(void *self) {
    subject *on = self;
    fmi2EventInfo info;
    fmi2Boolean enter, stop;
    switch (on->careful ? 9 : random_index(on->source, 9)) {
    case 0:
        fmi2EnterInitializationMode(on->component);
        break;
    case 1:
        fmi2ExitInitializationMode(on->component);
        break;
    case 2:
        fmi2EnterEventMode(on->component);
        break;
    case 3:
        fmi2NewDiscreteStates(on->component, &info);
        break;
    case 4:
        fmi2EnterContinuousTimeMode(on->component);
        break;
    case 5:
        fmi2CompletedIntegratorStep(on->component, fmi2True, &enter, &stop);
        break;
    case 6:
        fmi2SetTime(on->component, random_value(on->source));
        break;
    case 7:
        fmi2SetupExperiment(on->component, random_chance(on->source, 0.5), random_value(on->source),
                            random_value(on->source), random_chance(on->source, 0.5),
                            random_value(on->source));
        break;
    default:
        if (!on->careful && random_chance(on->source, 0.1)) {
            fmi2Terminate(on->component);
        }
    }
}

/* Before the start any variable may be set; most of these runners run. */
static void set_before_start(subject *on) {
    for (int i = 0; i < 5; ++i) {
        const fmi2ValueReference reference = (fmi2ValueReference)random_index(on->source, fmu_variable_count);
        const fmu_variable *variable = &fmu_variables[reference];
        const bool settable = variable->settable_before_start && variable->type == VARIABLE_REAL;
        const double value =
            random_chance(on->source, 0.9) ? tame_value(on->source, variable) : random_value(on->source);
        if (settable) {
            fmi2SetReal(on->component, &reference, 1, &value);
        }
    }
}

static void start_over(void *self) {
    subject *on = self;
    fmi2EventInfo info;
    fmi2Reset(on->component);
    set_before_start(on);
    fmi2EnterInitializationMode(on->component);
    fmi2ExitInitializationMode(on->component);
    if (on->type == fmi2ModelExchange) {
        fmi2NewDiscreteStates(on->component, &info);
        fmi2EnterContinuousTimeMode(on->component);
    }
}

/* An event of the importer's, with a jump of what may be set at one. */
static void handle_event(void *self) {
    subject *on = self;
    fmi2EventInfo info;
    const fmi2ValueReference reference = random_setting(on->source, true);
    const double value = tame_value(on->source, &fmu_variables[reference]);
    if (on->type == fmi2ModelExchange) {
        fmi2EnterEventMode(on->component);
        fmi2SetReal(on->component, &reference, 1, &value);
        fmi2NewDiscreteStates(on->component, &info);
        fmi2EnterContinuousTimeMode(on->component);
    }
}

static void evaluate(void *self) {
    subject *on = self;
    if (on->careful && on->type != fmi2ModelExchange) {
        return;
    }
    double states[TDMF_STATE_COUNT], values[TDMF_GUARD_COUNT + TDMF_STATE_COUNT];
    tdmf_default_state(states);
    states[random_index(on->source, TDMF_STATE_COUNT)] = random_value(on->source);
    fmi2SetContinuousStates(on->component, states, TDMF_STATE_COUNT);
    expect_numbers((int)fmi2GetContinuousStates(on->component, values, TDMF_STATE_COUNT), values,
                   TDMF_STATE_COUNT);
    expect_numbers((int)fmi2GetDerivatives(on->component, values, TDMF_STATE_COUNT), values,
                   TDMF_STATE_COUNT);
    expect_numbers((int)fmi2GetEventIndicators(on->component, values, TDMF_GUARD_COUNT), values,
                   TDMF_GUARD_COUNT);
    expect_numbers((int)fmi2GetNominalsOfContinuousStates(on->component, values, TDMF_STATE_COUNT), values,
                   TDMF_STATE_COUNT);
}

static void differentiate(void *self) {
    subject *on = self;
    const fmi2ValueReference unknown =
        on->careful ? reference_of("der(foot.vx)") : random_reference(on->source);
    const fmi2ValueReference known = on->careful ? reference_of("leg.angle") : random_reference(on->source);
    const fmi2Integer order = (fmi2Integer)random_index(on->source, 3);
    const double seed = random_value(on->source);
    double value = 0.0;
    const fmi2Status status =
        fmi2GetDirectionalDerivative(on->component, &unknown, 1, &known, 1, &seed, &value);
    expect_numbers(fabs(seed) < 1e100 ? (int)status : (int)fmi2Discard, &value, 1);
    if (on->careful) {
        return;
    }
    fmi2SetRealInputDerivatives(on->component, &known, 1, &order, &seed);
    expect_numbers((int)fmi2GetRealOutputDerivatives(on->component, &unknown, 1, &order, &value), &value, 1);
}

static void limit_steps(subject *on) {
    ((struct instance *)on->component)->fmu.step_limit = STEPS_OF_A_CALL;
}

static void step(void *self) {
    subject *on = self;
    const fmi2ValueReference time_reference = reference_of("time");
    double time = 0.0;
    if ((on->careful && on->type != fmi2CoSimulation) ||
        fmi2GetReal(on->component, &time_reference, 1, &time) != fmi2OK) {
        return;
    }
    const bool wild = !on->careful && random_chance(on->source, 0.1);
    const double length = wild ? random_value(on->source) : random_magnitude(on->source, 1e-6, 1e2);
    limit_steps(on);
    fmi2DoStep(on->component, wild ? random_value(on->source) : time, length, fmi2True);
}

static void save_and_restore(void *self) {
    subject *on = self;
    switch (random_index(on->source, 5)) {
    case 0:
        if (fmi2GetFMUstate(on->component, &on->saved) == fmi2OK &&
            fmi2SetFMUstate(on->component, on->saved) != fmi2OK) {
            die("what was saved is not restored");
        }
        break;
    case 1:
        fmi2SetFMUstate(on->component, on->saved);
        break;
    case 2:
        if (on->saved != NULL && fmi2SerializedFMUstateSize(on->component, on->saved, &on->size) == fmi2OK) {
            fmi2SerializeFMUstate(on->component, on->saved, on->bytes, on->size);
        }
        break;
    case 3:
        if (random_chance(on->source, 0.5) && on->size > 0) {
            forge(on->source, (unsigned char *)on->bytes, on->size);
        }
        fmi2DeSerializeFMUstate(on->component, on->bytes, on->size, &on->saved);
        break;
    default:
        fmi2FreeFMUstate(on->component, &on->saved);
    }
}

/* With its events logged, a step goes another way. */
static void switch_logging(void *self) {
    subject *on = self;
    fmi2SetDebugLogging(on->component, random_chance(on->source, 0.5), 1, events_category);
}

/* ---- sequences ---------------------------------------------------------------------------------------- */

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size) {
    static void (*const calls[])(void *) = {get_any,        get_all,          set_any,  change_mode,
                                            switch_logging, start_over,       evaluate, differentiate,
                                            step,           save_and_restore, step,     handle_event};
    random_source source = {0};
    subject on;
    random_draw_from(bytes, size);
    memset(&on, 0, sizeof on);
    on.source = &source;
    on.careful = random_chance(&source, 0.5);
    on.type = random_chance(&source, 0.5) ? fmi2ModelExchange : fmi2CoSimulation;
    on.component = on.type == fmi2ModelExchange ? new_instance() : new_slave();
    start_over(&on);
    call_until_used_up(&source, calls, sizeof calls / sizeof calls[0], &on);
    fmi2FreeFMUstate(on.component, &on.saved);
    fmi2FreeInstance(on.component);
    return 0;
}
