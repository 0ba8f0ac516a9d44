/* Runs with changed parameters, resumed in FMI 3.0 as fmusim does it: the state is restored in a fresh
 * instance, start values follow, and the run goes on without initialization. */
#include "instance.h" /* before cmocka, which takes a name of it for a macro */

#include "compare.h"
#include "fmi2_importer.h"
#include "fmi3_importer.h"

#include <math.h>
#include <string.h>

typedef enum { EXCHANGE, STEPS, STEPS_WITH_EVENTS, KINDS } kind;

static const double step_size = 1e-3; /* s, of Euler's method */

static void change(fmi3Instance instance) {
    assert_int_equal(set_float(instance, "body.mass", 1.25), fmi3OK);
    assert_int_equal(set_float(instance, "leg.damping", 0.3), fmi3OK);
    assert_int_equal(set_float(instance, "ground.friction", 0.4), fmi3OK);
}

static void update_and_go_on(fmi3Instance instance, kind kind) {
    update_answer answer;
    assert_int_equal(update(instance, &answer), fmi3OK);
    assert_int_equal(kind == EXCHANGE ? fmi3EnterContinuousTimeMode(instance) : fmi3EnterStepMode(instance),
                     fmi3OK);
}

static fmi3Instance new_of_kind(kind kind) {
    return kind == EXCHANGE ? new_exchange() : new_stepper(kind == STEPS_WITH_EVENTS, true);
}

static void begin(fmi3Instance instance, kind kind) {
    initialize3(instance);
    if (kind != STEPS) {
        update_and_go_on(instance, kind);
    }
}

/* ---- one way to go on for each interface ----------------------------------------------------------------
 */

static void integrate_a_step(fmi3Instance instance) {
    double states[TDMF_STATE_COUNT], slopes[TDMF_STATE_COUNT];
    double before[TDMF_GUARD_COUNT], after[TDMF_GUARD_COUNT];
    bool event = false;
    assert_int_equal(fmi3GetEventIndicators(instance, before, TDMF_GUARD_COUNT), fmi3OK);
    assert_int_equal(fmi3GetContinuousStates(instance, states, TDMF_STATE_COUNT), fmi3OK);
    assert_int_equal(fmi3GetContinuousStateDerivatives(instance, slopes, TDMF_STATE_COUNT), fmi3OK);
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        states[i] += step_size * slopes[i];
    }
    assert_int_equal(fmi3SetTime(instance, get_float(instance, "time") + step_size), fmi3OK);
    assert_int_equal(fmi3SetContinuousStates(instance, states, TDMF_STATE_COUNT), fmi3OK);
    assert_int_equal(fmi3GetEventIndicators(instance, after, TDMF_GUARD_COUNT), fmi3OK);
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        event |= (before[i] > 0.0) != (after[i] > 0.0);
    }
    if (event) {
        assert_int_equal(fmi3EnterEventMode(instance), fmi3OK);
        update_and_go_on(instance, EXCHANGE);
    }
}

/* For `duration`; with events, to the first one after it, which is left to be taken. */
static void go_on(fmi3Instance instance, kind kind, double duration) {
    const double start = get_float(instance, "time");
    step_answer step = {.event = false};
    if (kind == EXCHANGE) {
        for (int i = 0; i < (int)(duration / step_size); ++i) {
            integrate_a_step(instance);
        }
        return;
    }
    do {
        if (step.event) {
            assert_int_equal(fmi3EnterEventMode(instance), fmi3OK);
            update_and_go_on(instance, kind);
        }
        const double time = get_float(instance, "time");
        const double length = kind == STEPS ? start + duration - time : 100.0;
        assert_int_equal(do_step(instance, time, length, &step), fmi3OK);
    } while (get_float(instance, "time") < start + duration);
    assert_true(step.event == (kind == STEPS_WITH_EVENTS));
}

/* Takes the event that go_on has left. */
static void take_event(fmi3Instance instance, kind kind) {
    if (kind == STEPS_WITH_EVENTS) {
        assert_int_equal(fmi3EnterEventMode(instance), fmi3OK);
        update_and_go_on(instance, kind);
    }
}

/* ---- resuming -------------------------------------------------------------------------------------------
 */

static void restore(fmi3Instance instance, const fmi3Byte bytes[SERIALIZED_BYTES], size_t size) {
    fmi3FMUState saved = NULL;
    assert_int_equal(fmi3DeserializeFMUState(instance, bytes, size, &saved), fmi3OK);
    assert_int_equal(fmi3SetFMUState(instance, saved), fmi3OK);
    assert_int_equal(fmi3FreeFMUState(instance, &saved), fmi3OK);
}

/* All that the instances would save. */
static void assert_same(fmi3Instance a, fmi3Instance b) {
    fmi3Byte of_a[SERIALIZED_BYTES], of_b[SERIALIZED_BYTES];
    const size_t size = serialize3(a, of_a);
    assert_int_equal(serialize3(b, of_b), size);
    assert_memory_equal(of_a, of_b, size);
}

static void a_changed_run_is_resumed(void **unused) {
    (void)unused;
    for (kind kind = EXCHANGE; kind < KINDS; ++kind) {
        fmi3Byte bytes[SERIALIZED_BYTES];
        fmi3Instance straight = new_of_kind(kind), resumed = new_of_kind(kind);
        change(straight);
        begin(straight, kind);
        go_on(straight, kind, 13.0);
        restore(resumed, bytes, serialize3(straight, bytes));
        assert_same(straight, resumed);
        assert_true(get_float(resumed, "body.mass") == 1.25);
        take_event(straight, kind);
        take_event(resumed, kind);
        assert_int_equal(set_float(straight, "ground.friction", 0.3), fmi3OK);
        assert_int_equal(set_float(resumed, "ground.friction", 0.3), fmi3OK);
        go_on(straight, kind, 10.0);
        go_on(resumed, kind, 10.0);
        assert_same(straight, resumed);
        assert_true(get_float(straight, "energy.impact_loss") > 0.0);
        fmi3FreeInstance(straight);
        fmi3FreeInstance(resumed);
    }
}

/* Looks into the instance: a field that was forgotten shows itself in other runs only. Nothing is remembered
 * of the last event that was taken. */
static void a_saved_state_holds_all_of_a_unit(void **unused) {
    (void)unused;
    int pending = 0;
    for (kind kind = EXCHANGE; kind < KINDS; ++kind) {
        fmi3Instance straight = new_of_kind(kind);
        change(straight);
        begin(straight, kind);
        go_on(straight, kind, 5.0);
        for (int i = 0; i < 100; ++i) {
            fmi3Byte bytes[SERIALIZED_BYTES];
            fmi3Instance restored = new_of_kind(kind);
            take_event(straight, kind);
            go_on(straight, kind, 0.2);
            restore(restored, bytes, serialize3(straight, bytes));
            const fmu *a = &((const instance *)straight)->fmu, *b = &((const instance *)restored)->fmu;
            assert_int_equal(a->event_is_pending, kind == STEPS_WITH_EVENTS);
            pending += a->event_is_pending;
            assert_memory_equal(a, b, a->event_is_pending ? sizeof *a : offsetof(fmu, event_is_pending));
            fmi3FreeInstance(restored);
        }
        fmi3FreeInstance(straight);
    }
    assert_int_equal(pending, 100);
}

static void a_state_from_before_the_start_takes_more_start_values(void **unused) {
    (void)unused;
    for (kind kind = EXCHANGE; kind < KINDS; ++kind) {
        fmi3Byte bytes[SERIALIZED_BYTES];
        fmi3Instance first = new_of_kind(kind), second = new_of_kind(kind), straight = new_of_kind(kind);
        change(first);
        restore(second, bytes, serialize3(first, bytes));
        change(straight);
        assert_int_equal(set_float(second, "hip.kp", 0.12), fmi3OK);
        assert_int_equal(set_float(straight, "hip.kp", 0.12), fmi3OK);
        begin(second, kind);
        begin(straight, kind);
        go_on(second, kind, 13.0);
        go_on(straight, kind, 13.0);
        assert_same(second, straight);
        fmi3FreeInstance(first);
        fmi3FreeInstance(second);
        fmi3FreeInstance(straight);
    }
}

/* Model Exchange and Co-Simulation; the other way round is in test_fmi3_co_simulation.c. */
static void a_changed_run_of_fmi3_goes_on_in_fmi2(void **unused) {
    (void)unused;
    for (kind kind = EXCHANGE; kind <= STEPS; ++kind) {
        fmi3Byte bytes[SERIALIZED_BYTES];
        fmi2FMUstate saved = NULL;
        fmi3Instance instance = new_of_kind(kind);
        fmi2Component old = kind == EXCHANGE ? new_instance() : new_slave();
        change(instance);
        begin(instance, kind);
        go_on(instance, kind, 13.0);
        const size_t size = serialize3(instance, bytes);
        assert_int_equal(fmi2DeSerializeFMUstate(old, (const fmi2Byte *)bytes, size, &saved), fmi2OK);
        assert_int_equal(fmi2SetFMUstate(old, saved), fmi2OK);
        assert_int_equal(fmi2FreeFMUstate(old, &saved), fmi2OK);
        assert_true(get_real(old, "body.mass") == 1.25);
        if (kind == STEPS) {
            go_on(instance, kind, 10.0);
            assert_int_equal(fmi2DoStep(old, 13.0, 10.0, fmi2True), fmi2OK);
        }
        assert_true(get_real(old, "leg.angle") == get_float(instance, "leg.angle"));
        assert_true(get_real(old, "der(leg.angle_rate)") == get_float(instance, "der(leg.angle_rate)"));
        fmi3FreeInstance(instance);
        fmi2FreeInstance(old);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_changed_run_is_resumed),
        cmocka_unit_test(a_saved_state_holds_all_of_a_unit),
        cmocka_unit_test(a_state_from_before_the_start_takes_more_start_values),
        cmocka_unit_test(a_changed_run_of_fmi3_goes_on_in_fmi2),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
