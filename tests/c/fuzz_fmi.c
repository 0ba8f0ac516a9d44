/* Legal and illegal sequences of calls with any values: no crash, no leak, no hang, and no number that is not
 * one behind a good status; what is saved can be restored. It is built for each version of FMI: FUZZED is the
 * version's table of calls. How bytes are drawn fits the saved inputs of tests/c/corpus. */
#include "instance.h" /* before cmocka, which takes a name of it for a macro */

#include "fmi2_importer.h"
#include "fmi3_importer.h"
#include "forge.h"
#include "fuzz.h"
#include "tdmf_slip/tdmf_slip.h"

#include <math.h>
#include <string.h>

static const fmi_interface *const fmi = &FUZZED;

typedef struct {
    random_source *source;
    bool careful; /* keeps to the call sequence, so that it gets far */
    fmi_kind kind;
    bool returns_early; /* with events */
    void *instance;
    void *saved; /* state of this instance or an earlier one */
    unsigned char bytes[SERIALIZED_BYTES];
    size_t size;
} subject;

static bool is_fmi2(void) {
    return fmi == &fmi2;
}

/* ---- one call each ------------------------------------------------------------------------------------ */

static void get_text(const subject *on, uint32_t reference) {
    const char *text = "";
    const int status = is_fmi2() ? (int)fmi2GetString(on->instance, &reference, 1, &text)
                                 : (int)fmi3GetString(on->instance, &reference, 1, &text, 1);
    if (status == FMI_OK && strlen(text) >= WORD_CAPACITY) {
        die("a word too long");
    }
}

static void get_any(void *self) {
    subject *on = self;
    const uint32_t reference = on->careful ? reference_of("com.y") : random_reference(on->source);
    double real = 0.0;
    int integer = 0;
    bool truth = false;
    fmi3Float32 single = 0.0F;
    expect_numbers((int)fmi->get_reals(on->instance, &reference, 1, &real), &real, 1);
    if (on->careful) {
        return;
    }
    fmi->get_integer(on->instance, reference, &integer);
    fmi->get_item(on->instance, reference, &integer);
    if (is_fmi2()) {
        fmi->get_truth(on->instance, reference, &truth);
    } else {
        fmi3GetBoolean(on->instance, &reference, 1, &truth, random_index(on->source, 3));
        if (random_chance(on->source, 0.1)) {
            fmi3GetFloat32(on->instance, &reference, 1, &single, 1);
        }
    }
    get_text(on, reference);
}

static void get_all(void *self) {
    subject *on = self;
    for (uint32_t i = 0; i < fmu_variable_count; ++i) {
        double real = 0.0;
        if (fmu_variables[i].type == VARIABLE_REAL) {
            expect_numbers((int)fmi->get_reals(on->instance, &i, 1, &real), &real, 1);
        }
    }
}

/* A Boolean of FMI 2.0 may be any integer. */
static void set_other(const subject *on, uint32_t reference, int item) {
    static const char *const text = "x";
    const bool is_truth = fmu_variables[reference].type == VARIABLE_BOOLEAN;
    if (!is_fmi2()) {
        const bool truth = random_chance(on->source, 0.5);
        if (is_truth) {
            fmi->set_truth(on->instance, reference, truth);
        } else if (fmu_variables[reference].type == VARIABLE_STRING) {
            fmi3SetString(on->instance, &reference, 1, &text, 1);
        } else {
            fmi->set_item(on->instance, reference, item);
        }
    } else if (is_truth) {
        fmi2SetBoolean(on->instance, &reference, 1, &item);
    } else if (random_chance(on->source, 0.1)) {
        fmi2SetString(on->instance, &reference, 1, &text);
    } else {
        fmi->set_item(on->instance, reference, item);
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
    const int item = (int)random_index(on->source, 5) - 1;
    if (!is_there || fmu_variables[reference].type == VARIABLE_REAL) {
        fmi->set_reals(on->instance, &reference, 1, &real);
    } else {
        set_other(on, reference, item);
    }
}

static void begin_any_experiment(const subject *on) {
    fmi_experiment experiment;
    experiment.has_tolerance = random_chance(on->source, 0.5);
    experiment.tolerance = random_value(on->source);
    experiment.start = random_value(on->source);
    experiment.has_stop = random_chance(on->source, 0.5);
    experiment.stop = random_value(on->source);
    fmi->enter_initialization(on->instance, &experiment);
}

static void change_mode(void *self) {
    subject *on = self;
    update_answer answer;
    bool enter = false, stop = false;
    size_t count;
    switch (on->careful ? 9 : random_index(on->source, is_fmi2() ? 9 : 10)) {
    case 0:
        begin_any_experiment(on);
        break;
    case 1:
        fmi->exit_initialization(on->instance);
        break;
    case 2:
        fmi->enter_event_mode(on->instance);
        break;
    case 3:
        fmi->update(on->instance, &answer);
        break;
    case 4:
        fmi->enter_continuous_time_mode(on->instance);
        break;
    case 5:
        fmi->complete_step(on->instance, &enter, &stop);
        break;
    case 6:
        fmi->set_time(on->instance, random_value(on->source));
        break;
    case 7:
        if (is_fmi2()) {
            fmi2EnterInitializationMode(on->instance);
        } else {
            fmi3EnterStepMode(on->instance);
        }
        break;
    default:
        if (!is_fmi2()) {
            fmi3GetNumberOfContinuousStates(on->instance, &count);
        }
        if (!on->careful && random_chance(on->source, 0.1)) {
            fmi->terminate(on->instance);
        }
    }
}

/* Sets some variables at random before the start; most of these runners run. */
static void set_before_start(const subject *on) {
    for (int i = 0; i < 5; ++i) {
        const uint32_t reference = (uint32_t)random_index(on->source, fmu_variable_count);
        const fmu_variable *variable = &fmu_variables[reference];
        const double value =
            random_chance(on->source, 0.9) ? tame_value(on->source, variable) : random_value(on->source);
        if (variable->settable_before_start && variable->type == VARIABLE_REAL) {
            fmi->set_reals(on->instance, &reference, 1, &value);
        }
    }
}

/* An event iteration, in which a setting may jump, and back to the mode in which time advances. */
static void handle_event(const subject *on, double probability_of_jump) {
    update_answer answer;
    if (probability_of_jump == 1.0 || (!is_fmi2() && random_chance(on->source, probability_of_jump))) {
        const uint32_t reference = random_setting(on->source, true);
        const double value = tame_value(on->source, &fmu_variables[reference]);
        fmi->set_reals(on->instance, &reference, 1, &value);
    }
    fmi->update(on->instance, &answer);
    (on->kind == EXCHANGE ? fmi->enter_continuous_time_mode : fmi->enter_step_mode)(on->instance);
}

static void start_over(void *self) {
    subject *on = self;
    fmi->reset(on->instance);
    set_before_start(on);
    fmi->enter_initialization(on->instance, &(fmi_experiment){.start = 0.0});
    fmi->exit_initialization(on->instance);
    if (on->kind != STEPS) {
        handle_event(on, 0.5);
    }
}

/* An event of the importer's own. */
static void make_event(void *self) {
    subject *on = self;
    if (on->kind == EXCHANGE) {
        fmi->enter_event_mode(on->instance);
        handle_event(on, 1.0);
    }
}

static void evaluate(void *self) {
    subject *on = self;
    if (on->careful && on->kind != EXCHANGE) {
        return;
    }
    double states[CONTINUOUS_STATES], values[TDMF_GUARD_COUNT + CONTINUOUS_STATES];
    write_default_states(states);
    states[random_index(on->source, CONTINUOUS_STATES)] = random_value(on->source);
    fmi->set_states(on->instance, states, CONTINUOUS_STATES);
    expect_numbers((int)fmi->get_states(on->instance, values, CONTINUOUS_STATES), values, CONTINUOUS_STATES);
    expect_numbers((int)fmi->get_derivatives(on->instance, values, CONTINUOUS_STATES), values,
                   CONTINUOUS_STATES);
    expect_numbers((int)fmi->get_indicators(on->instance, values, TDMF_GUARD_COUNT), values,
                   TDMF_GUARD_COUNT);
    expect_numbers((int)fmi->get_nominals(on->instance, values, CONTINUOUS_STATES), values,
                   CONTINUOUS_STATES);
}

static void differentiate(void *self) {
    subject *on = self;
    const uint32_t unknown = on->careful ? reference_of("der(foot.vx)") : random_reference(on->source);
    const uint32_t known = on->careful ? reference_of("leg.angle") : random_reference(on->source);
    const int order = (int)random_index(on->source, 3);
    const double seed = random_value(on->source);
    const bool is_tame = fabs(seed) < 1e100;
    double value = 0.0;
    const fmi_status status =
        fmi->directional_derivative(on->instance, &unknown, 1, &known, 1, &seed, &value);
    expect_numbers(is_tame ? (int)status : (int)FMI_DISCARD, &value, 1);
    if (!is_fmi2()) {
        const fmi3Status adjoint =
            fmi3GetAdjointDerivative(on->instance, &unknown, 1, &known, 1, &seed, 1, &value, 1);
        expect_numbers(is_tame ? (int)adjoint : (int)fmi3Discard, &value, 1);
    }
    if (on->careful) {
        return;
    }
    if (is_fmi2()) {
        fmi2SetRealInputDerivatives(on->instance, &known, 1, &order, &seed);
    }
    expect_numbers((int)fmi->output_derivative(on->instance, unknown, order, &value), &value, 1);
}

static void step(void *self) {
    subject *on = self;
    const uint32_t time_reference = reference_of("time");
    step_answer answer = {.event = false};
    double time = 0.0;
    if ((on->careful && on->kind == EXCHANGE) ||
        fmi->get_reals(on->instance, &time_reference, 1, &time) != FMI_OK) {
        return;
    }
    const bool wild = !on->careful && random_chance(on->source, 0.1);
    const double length = wild ? random_value(on->source) : random_magnitude(on->source, 1e-6, 1e2);
    const double from = wild ? random_value(on->source) : time;
    ((struct instance *)on->instance)->step_limit = STEPS_OF_A_CALL;
    if (fmi->do_step(on->instance, from, length, &answer) != FMI_OK) {
        return;
    }
    if (answer.event && !on->returns_early) {
        die("an event that was not asked for");
    }
    if (!(answer.time >= time && answer.time <= from + length) ||
        answer.early != (answer.time < from + length)) {
        die("a step to nowhere");
    }
    if (answer.event && random_chance(on->source, 0.9) && fmi->enter_event_mode(on->instance) == FMI_OK) {
        handle_event(on, 0.5);
    }
}

static void save_and_restore(void *self) {
    subject *on = self;
    switch (random_index(on->source, 5)) {
    case 0:
        if (fmi->save(on->instance, &on->saved) == FMI_OK &&
            fmi->restore(on->instance, on->saved) != FMI_OK) {
            die("what was saved is not restored");
        }
        break;
    case 1:
        fmi->restore(on->instance, on->saved);
        break;
    case 2:
        if (on->saved != NULL && fmi->measure(on->instance, on->saved, &on->size) == FMI_OK) {
            if (on->size > sizeof on->bytes) {
                die("a saved state too long");
            }
            fmi->serialize(on->instance, on->saved, on->bytes, on->size);
        }
        break;
    case 3:
        if (random_chance(on->source, 0.5) && on->size > 0) {
            forge(on->source, on->bytes, on->size);
        }
        fmi->deserialize(on->instance, on->bytes, on->size, &on->saved);
        break;
    default:
        fmi->free_saved(on->instance, &on->saved);
    }
}

/* A step takes another code path while events are logged. */
static void switch_logging(void *self) {
    subject *on = self;
    fmi->set_logging(on->instance, random_chance(on->source, 0.5), 1, events_category);
}

/* ---- sequences ---------------------------------------------------------------------------------------- */

/* Co-Simulation with event mode in FMI 3.0 comes in two forms, without and with early return. */
static void instantiate(subject *on) {
    const size_t way = is_fmi2() ? !random_chance(on->source, 0.5) : random_index(on->source, KINDS + 1);
    on->kind = way < KINDS ? (fmi_kind)way : STEPS_WITH_EVENTS;
    on->returns_early = way == KINDS;
    on->instance =
        on->kind == STEPS_WITH_EVENTS ? new_stepper(true, on->returns_early) : new_of_kind(fmi, on->kind);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size) {
    static void (*const calls[])(void *) = {get_any,        get_all,          set_any,  change_mode,
                                            switch_logging, start_over,       evaluate, differentiate,
                                            step,           save_and_restore, step,     make_event};
    const size_t call_count = COUNT_OF(calls);
    random_source source = {0};
    subject on;
    random_draw_from(bytes, size);
    memset(&on, 0, sizeof on);
    on.source = &source;
    on.careful = random_chance(&source, 0.5);
    instantiate(&on);
    start_over(&on);
    call_until_used_up(&source, calls, is_fmi2() ? call_count : call_count - 1, &on);
    fmi->free_saved(on.instance, &on.saved);
    end_test();
    return 0;
}
