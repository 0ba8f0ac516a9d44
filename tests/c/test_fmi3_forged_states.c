/* Serialized states that were changed and given a right checksum. A state that makes no sense is refused and
 * changes nothing; a run can go on from every state that is accepted. Any FMI version and interface reads the
 * same bytes. */
#include "instance.h" /* before cmocka, which takes a name of it for a macro */
#include "sample.h"

#include "compare.h"
#include "fmi3_importer.h"
#include "forge.h"
#include "tdmf_slip/tdmf_slip.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <string.h>

static fmi3Instance new_that_logs(fmi_kind kind) {
    fmi3Instance instance = new_of_kind(&fmi3, kind);
    assert_int_equal(fmi3SetDebugLogging(instance, true, 0, NULL), fmi3OK);
    return instance;
}

/* An instance in the swing after the second stance; with events, before the first touchdown, which is still
 * to be taken. */
static fmi3Instance new_on_its_way(fmi_kind kind) {
    step_answer step = {false, false, false, 0.0};
    fmi3Instance instance = new_that_logs(kind);
    begin(&fmi3, instance, kind);
    if (kind != EXCHANGE) {
        assert_int_equal(do_step(instance, 0.0, 40.0, &step), fmi3OK);
        assert_true(step.event == (kind == STEPS_WITH_EVENTS));
    }
    return instance;
}

/* An instance at 41 s, where no event is pending. */
static fmi3Instance new_past_its_event(fmi_kind kind) {
    fmi3Instance instance = new_on_its_way(kind);
    if (kind == STEPS_WITH_EVENTS) {
        take_event(&fmi3, instance, kind, "");
    }
    run_to(&fmi3, instance, 41.0, 41.0);
    return instance;
}

static void assert_numbers(fmi3Instance instance) {
    for (uint32_t i = 0; i < fmu_variable_count; ++i) {
        double value = 0.0;
        if (fmu_variables[i].type == VARIABLE_REAL && fmi3GetFloat64(instance, &i, 1, &value, 1) == fmi3OK) {
            assert_true(!isnan(value));
        }
    }
}

/* Limits the steps of a call, because forged parameters may be arbitrarily stiff. */
static void limit_steps(fmi3Instance instance) {
    ((struct instance *)instance)->step_limit = 200;
}

/* Runs on, past the end of the open stride if the steps suffice, from any state of the call sequence. */
static void go_on(fmi3Instance instance, fmi_kind kind) {
    step_answer step = {false, false, false, 0.0};
    update_answer answer;
    assert_numbers(instance);
    limit_steps(instance);
    const double time = get_float(instance, "time");
    if (kind == EXCHANGE) {
        fmi3EnterEventMode(instance);
        update(instance, &answer);
        assert_numbers(instance);
        return;
    }
    if (do_step(instance, time, 30.0, &step) == fmi3OK && step.event &&
        fmi3EnterEventMode(instance) == fmi3OK) {
        update(instance, &answer);
    }
    assert_numbers(instance);
}

/* ---- every field ----------------------------------------------------------------------------------------
 */

static const struct {
    size_t size;
    union {
        int integer;
        double number;
        unsigned char bytes[8];
    } value;
} forgeries[] = {
    {4, {.integer = 50000000}}, {4, {.integer = -1}},   {4, {.integer = INT_MAX}}, {4, {.integer = 3}},
    {8, {.number = NAN}},       {8, {.number = 1e300}}, {8, {.number = -1e300}},   {8, {.number = 5e-324}},
    {8, {.number = DBL_MAX}},   {8, {.number = 1e50}},  {1, {.integer = 2}},       {1, {.integer = 255}},
};

static void forge_everywhere(fmi_kind kind, long *refused, long *accepted) {
    serialized good, bad;
    fmi3Instance instance = new_on_its_way(kind);
    good = serialize(&fmi3, instance);
    for (size_t f = 0; f < COUNT_OF(forgeries); ++f) {
        /* A share of the places, others with each forgery. */
        for (size_t offset = FORGE_CONTENT + f % TDMF_SAMPLE_DIVISOR; offset + forgeries[f].size <= good.size;
             offset += TDMF_SAMPLE_DIVISOR) {
            bad = good;
            memcpy(bad.bytes + offset, forgeries[f].value.bytes, forgeries[f].size);
            forge_checksum(bad.bytes, bad.size);
            if (restore(&fmi3, instance, &bad) == FMI_OK) {
                ++*accepted;
                go_on(instance, kind);
                assert_int_equal(restore(&fmi3, instance, &good), FMI_OK);
            } else {
                ++*refused;
                assert_non_null(strstr(last_message, "refused"));
                assert_state(&fmi3, instance, &good);
            }
        }
    }
}

TEST(whatever_is_forged_is_refused_or_goes_on) {
    for (fmi_kind kind = EXCHANGE; kind < KINDS; ++kind) {
        long refused = 0, accepted = 0;
        forge_everywhere(kind, &refused, &accepted);
        assert_true(refused > sample_of(2000) && accepted > sample_of(1000));
    }
}

/* ---- single fields --------------------------------------------------------------------------------------
 */

/* Offset of the first copy of a value in the bytes; asserts that there is one. */
static size_t offset_of(const serialized *state, const void *value, size_t size) {
    size_t offset = FORGE_CONTENT;
    while (offset + size < state->size && memcmp(state->bytes + offset, value, size) != 0) {
        ++offset;
    }
    assert_memory_equal(state->bytes + offset, value, size);
    return offset;
}

static void assert_refused(fmi_kind kind, serialized *state, const char *reason) {
    serialized own;
    fmi3Instance instance = new_on_its_way(kind);
    forge_checksum(state->bytes, state->size);
    own = serialize(&fmi3, instance);
    assert_int_equal(restore(&fmi3, instance, state), FMI_DISCARD);
    assert_non_null(strstr(last_message, reason));
    assert_state(&fmi3, instance, &own);
    go_on(instance, kind);
}

/* Forges each copy of a number in the state of an instance. Returns how often the forged state is refused
 * with this reason; otherwise the instance goes on. */
static int refusals(fmi3Instance instance, fmi_kind kind, double number, double forged, const char *reason) {
    serialized good;
    int refused = 0;
    good = serialize(&fmi3, instance);
    for (size_t offset = FORGE_CONTENT; offset + sizeof number <= good.size; ++offset) {
        if (memcmp(good.bytes + offset, &number, sizeof number) == 0) {
            serialized bad = good;
            memcpy(bad.bytes + offset, &forged, sizeof forged);
            forge_checksum(bad.bytes, bad.size);
            if (restore(&fmi3, instance, &bad) == FMI_OK) {
                go_on(instance, kind);
            } else {
                refused += strstr(last_message, reason) != NULL;
            }
            assert_int_equal(restore(&fmi3, instance, &good), FMI_OK);
        }
    }
    return refused;
}

static void replace_number(serialized *state, double from, double to) {
    memcpy(state->bytes + offset_of(state, &from, sizeof from), &to, sizeof to);
}

TEST(a_parameter_out_of_range_is_refused) {
    serialized state;
    fmi3Instance instance = new_stepper(false, false);
    set_values(&fmi3, instance, "body.mass=1.25 leg.min_length=0.0625");
    initialize3(instance);
    state = serialize(&fmi3, instance);
    serialized bad = state;
    replace_number(&bad, 1.25, -1.25);
    assert_refused(STEPS, &bad, "body.mass is out of range");
    bad = state;
    replace_number(&bad, 0.0625, 2.0); /* within its own range, but longer than the leg */
    assert_refused(STEPS, &bad, "leg.min_length = 2 m is refused");
}

/* The slope is stored as an input and as the slope of the ground line. A word is stored as its code. A count
 * is a whole number. A pending event is at the time of the run, which is stored several times. */
TEST(a_number_that_cannot_be_is_refused_wherever_it_stands) {
    static const struct {
        const char *name;
        fmi_kind kind;
        double factor, added;
        int least;
        const char *reason;
    } cases[] = {{"ground.slope", STEPS, 1e4, 0.0, 3, "slope"},
                 {"hip.swing_clamp", STEPS, 0.5, 0.0, 1, "hip.swing_clamp"},
                 {"hip.swing_clamp", STEPS, 2.0, 0.0, 1, "hip.swing_clamp"},
                 {"hip.place_time", STEPS, -1.0, 0.0, 1, "hip.place_time"},
                 {"stride.word_code", STEPS, 1.0, 0.5, 1, "stride.word_code"},
                 {"event.count", STEPS, 1.0, 0.5, 1, "event.count"},
                 {"stride.count", STEPS, 1.0, 0.5, 1, "stride.count"},
                 {"event.last_time", STEPS, 0.0, 57.0, 1, "event.last_time"},
                 {"apex.time", STEPS, 0.0, 57.0, 1, "apex.time"},
                 {"time", STEPS_WITH_EVENTS, 1.0, 1.0, 3, "refused"}};
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        step_answer step;
        fmi3Instance instance = new_that_logs(cases[i].kind);
        set_values(&fmi3, instance, "ground.slope=-1e-3 hip.swing_clamp=1");
        begin(&fmi3, instance, cases[i].kind);
        assert_int_equal(do_step(instance, 0.0, 56.0, &step), fmi3OK);
        const fmu_variable_type type = fmu_variables[reference_of(cases[i].name)].type;
        const double number = type == VARIABLE_REAL      ? get_float(instance, cases[i].name)
                              : type == VARIABLE_BOOLEAN ? truth_of(&fmi3, instance, cases[i].name)
                                                         : get_int(instance, cases[i].name);
        assert_true(number != 0.0);
        assert_true(refusals(instance, cases[i].kind, number, cases[i].factor * number + cases[i].added,
                             cases[i].reason) >= cases[i].least);
    }
}

/* Without these checks a foot might graze for ever. */
TEST(a_hop_that_cannot_have_been_is_refused) {
    static const struct {
        int state;
        double forged;
        const char *name;
    } cases[] = {{TDMF_HIP_HAS_HOPPED, 0.5, "has_hopped"},
                 {TDMF_HIP_HAS_HOPPED, NAN, "has_hopped"},
                 {TDMF_HIP_HOP_TIME, NAN, "hop_time"},
                 {TDMF_HIP_HOP_TIME, 57.0, "hop_time"}};
    const size_t numbers = FORGE_CONTENT + offsetof(unit_run, motion.numbers);
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        serialized state = serialize(&fmi3, new_on_its_way(STEPS));
        const size_t place = numbers + (size_t)(UNIT_PARAMETER_COUNT + cases[i].state) * sizeof(double);
        memcpy(state.bytes + place, &cases[i].forged, sizeof(double));
        assert_refused(STEPS, &state, cases[i].name);
    }
}

/* Beyond 1e100 s differences of times might overflow. */
TEST(a_time_beyond_any_clock_is_refused) {
    static const double times[] = {1e101, -1e101, INFINITY, NAN};
    for (int i = 0; i < 4; ++i) {
        serialized state;
        step_answer step;
        fmi3Instance instance = new_on_its_way(STEPS), fresh = new_exchange(),
                     exchange = new_on_its_way(EXCHANGE);
        state = serialize(&fmi3, instance);
        replace_number(&state, get_float(instance, "time"), times[i]);
        assert_refused(STEPS, &state, "time is out of range");
        assert_int_equal(do_step(instance, 40.0, fabs(times[i]), &step), fmi3Error);
        assert_int_equal(fmi3EnterInitializationMode(fresh, false, 0.0, times[i], false, 0.0), fmi3Error);
        assert_int_equal(fmi3SetTime(exchange, times[i]), fmi3Error);
        assert_true(get_float(exchange, "time") == 0.0);
    }
}

/* The foot sticks in the saved state, and is lifted to its height in flight. */
TEST(a_contact_in_the_air_is_refused) {
    serialized state;
    fmi3Instance instance = new_stepper(false, false);
    step_answer step;
    initialize3(instance);
    assert_int_equal(do_step(instance, 0.0, 1.0, &step), fmi3OK);
    state = serialize(&fmi3, instance);
    const double foot_y = get_float(instance, "foot.y");
    assert_true(foot_y > 0.0);
    assert_int_equal(do_step(instance, 1.0, 12.0, &step), fmi3OK);
    assert_int_equal(get_int(instance, "contact.mode"), TDMF_CONTACT_STICK);
    const size_t offset = offset_of(&state, &foot_y, sizeof foot_y);
    state = serialize(&fmi3, instance);
    memcpy(state.bytes + offset, &foot_y, sizeof foot_y);
    assert_refused(STEPS, &state, "foot.y");
}

/* Four kinds of contradictions:
 *
 * - The interface lacks the state of the call sequence.
 * - The run goes on without having begun, or has begun but does not run.
 * - An event is pending in an interface without pending events.
 * - Whether an event is pending is neither 0 nor 1. */
TEST(a_state_that_contradicts_itself_is_refused) {
    static const char call_state[] = "the state of the call sequence", event[] = "the pending event";
    static const struct {
        fmi_kind kind;
        size_t offset;
        int bytes[2]; /* of two successive fields, or of the first one alone if the second is -1 */
        const char *reason;
    } cases[] = {{EXCHANGE, FORGE_CALL_STATE, {STEP_MODE, -1}, call_state},
                 {EXCHANGE, FORGE_CALL_STATE, {EVENT_MODE | CONTINUOUS_TIME_MODE, -1}, call_state},
                 {EXCHANGE, FORGE_CALL_STATE, {INSTANTIATED, -1}, call_state},
                 {STEPS, FORGE_CALL_STATE, {EVENT_MODE, -1}, call_state},
                 {STEPS, FORGE_CALL_STATE, {STEP_MODE | FAILED, -1}, call_state},
                 {STEPS, FORGE_CALL_STATE, {INITIALIZATION_MODE, -1}, call_state},
                 {STEPS, FORGE_CALL_STATE, {STEP_MODE, 0}, call_state},
                 {STEPS_WITH_EVENTS, FORGE_CALL_STATE, {CONTINUOUS_TIME_MODE, -1}, call_state},
                 {STEPS_WITH_EVENTS, FORGE_CALL_STATE, {0, -1}, call_state},
                 {STEPS_WITH_EVENTS, FORGE_CALL_STATE, {INSTANTIATED, -1}, call_state},
                 {STEPS_WITH_EVENTS, FORGE_CALL_STATE, {INSTANTIATED, 0}, "refused"},
                 {STEPS_WITH_EVENTS, FORGE_CONTENT, {CO_SIMULATION, STEP_MODE}, event},
                 {STEPS_WITH_EVENTS, FORGE_CONTENT, {MODEL_EXCHANGE, EVENT_MODE}, event},
                 {STEPS_WITH_EVENTS, FORGE_PENDING, {2, -1}, event}};
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        serialized state = serialize(&fmi3, new_on_its_way(cases[i].kind));
        memcpy(state.bytes + cases[i].offset, cases[i].bytes, (cases[i].bytes[1] < 0 ? 1 : 2) * sizeof(int));
        assert_refused(cases[i].kind, &state, cases[i].reason);
    }
}

/* The event of the first touchdown, claimed in the swing after the second stance. */
TEST(an_event_far_from_its_guard_is_not_pending) {
    enum { PENDING = 4, EVENT = 12 };
    serialized at_event, state;
    at_event = serialize(&fmi3, new_on_its_way(STEPS_WITH_EVENTS));
    fmi3Instance instance = new_past_its_event(STEPS_WITH_EVENTS);
    state = serialize(&fmi3, instance);
    assert_int_equal(state.bytes[FORGE_PENDING], 0);
    memcpy(state.bytes + FORGE_PENDING, at_event.bytes + FORGE_PENDING, PENDING);
    memcpy(state.bytes + FORGE_BEGUN + EVENT, at_event.bytes + FORGE_BEGUN + EVENT, sizeof(int32_t));
    assert_refused(STEPS_WITH_EVENTS, &state, "the pending event");
}

TEST(a_run_that_has_not_begun_does_not_run) {
    serialized state = serialize(&fmi3, new_that_logs(STEPS));
    const int running = STEP_MODE;
    memcpy(state.bytes + FORGE_CALL_STATE, &running, sizeof running);
    assert_refused(STEPS, &state, "the state of the call sequence");
}

TEST(work_that_no_run_has_done_is_refused) {
    static const int64_t claims[] = {-1, INT64_MAX};
    for (int i = 0; i < 2; ++i) {
        serialized state;
        fmi3Instance instance = new_on_its_way(STEPS);
        state = serialize(&fmi3, instance);
        const int64_t steps = get_int(instance, "solver.steps");
        memcpy(state.bytes + offset_of(&state, &steps, sizeof steps), &claims[i], sizeof steps);
        assert_refused(STEPS, &state, "the work done");
    }
}

/* Writes the largest Integer into the bytes of `state` that hold this counter. */
static void fill_counter(serialized *state, fmi_kind kind, const char *name) {
    const serialized good = *state;
    const double full = INT_MAX;
    fmi3Instance instance = new_that_logs(kind);
    size_t offset = FORGE_CONTENT;
    do {
        assert_true(offset + sizeof full <= good.size);
        *state = good;
        memcpy(state->bytes + offset++, &full, sizeof full);
        forge_checksum(state->bytes, state->size);
    } while (restore(&fmi3, instance, state) != FMI_OK || get_int(instance, name) != INT_MAX);
}

/* The largest count there is: the run goes on as ever, and the counters stay where they are. */
TEST(a_full_counter_stays_full) {
    static const char *counters[] = {"event.count", "stride.count"};
    for (fmi_kind kind = STEPS; kind < KINDS; ++kind) {
        for (int c = 0; c < 2; ++c) {
            serialized state;
            fmi3Instance instance = new_past_its_event(kind), other = new_that_logs(kind);
            state = serialize(&fmi3, instance);
            fill_counter(&state, kind, counters[c]);
            assert_int_equal(restore(&fmi3, other, &state), FMI_OK);
            const int events = run_to(&fmi3, instance, 100.0, 100.0);
            assert_int_equal(run_to(&fmi3, other, 100.0, 100.0), events);
            assert_true(events > 10 || kind == STEPS);
            assert_int_equal(get_int(other, counters[c]), INT_MAX);
            assert_true(get_float(other, "leg.angle") == get_float(instance, "leg.angle"));
            assert_true(get_float(other, "hip.work") == get_float(instance, "hip.work"));
        }
    }
}

/* Every byte of the header is looked at, whether or not the checksum covers it. */
TEST(a_header_that_is_not_ours_is_refused) {
    serialized good = serialize(&fmi3, new_on_its_way(STEPS));
    fmi3Instance instance = new_on_its_way(STEPS);
    for (size_t i = 0; i < FORGE_CONTENT; ++i) {
        serialized bad = good;
        bad.bytes[i] = (fmi3Byte)(bad.bytes[i] ^ 0x10);
        assert_int_equal(restore(&fmi3, instance, &bad), FMI_DISCARD);
        assert_non_null(strstr(last_message, i < FORGE_BYTE_ORDER ? "another version"
                                             : i < FORGE_CHECKSUM ? "another kind of machine"
                                                                  : "changed"));
        assert_state(&fmi3, instance, &good);
    }
}
