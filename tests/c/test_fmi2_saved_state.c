/* Saved and serialized states: bit for bit across instances, in the middle of every mode, and what is
 * refused. */
#include "compare.h"
#include "fmi2_importer.h"

#include "fmu.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static void step(fmi2Component component, double length) {
    assert_int_equal(fmi2DoStep(component, get_real(component, "time"), length, fmi2True), fmi2OK);
}

/* All that two instances have to say, compared bit for bit. */
static void assert_same(fmi2Component a, fmi2Component b) {
    static const char *names[] = {"time",
                                  "foot.x",
                                  "foot.y",
                                  "leg.length",
                                  "leg.angle",
                                  "foot.vx",
                                  "foot.vy",
                                  "hip.work",
                                  "leg.length_rate",
                                  "leg.angle_rate",
                                  "stride.period",
                                  "stride.length",
                                  "apex.time",
                                  "stride.peak_force",
                                  "stride.peak_vertical_force",
                                  "event.last_time",
                                  "energy.impact_loss"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i) {
        const double of_a = get_real(a, names[i]);
        const double of_b = get_real(b, names[i]);
        assert_memory_equal(&of_a, &of_b, sizeof of_a);
    }
    assert_int_equal(get_integer(a, "event.count"), get_integer(b, "event.count"));
    assert_int_equal(get_integer(a, "stride.count"), get_integer(b, "stride.count"));
    assert_int_equal(get_integer(a, "stride.word_code"), get_integer(b, "stride.word_code"));
}

static void restore(fmi2Component component, const fmi2Byte bytes[SERIALIZED_BYTES], size_t size) {
    fmi2FMUstate saved = NULL;
    assert_int_equal(fmi2DeSerializeFMUstate(component, bytes, size, &saved), fmi2OK);
    assert_int_equal(fmi2SetFMUstate(component, saved), fmi2OK);
    assert_int_equal(fmi2FreeFMUstate(component, &saved), fmi2OK);
}

/* Steps of 0.03 stop in every mode of the stance, the graze of 0.08 included. */
static void co_simulation_goes_on_as_if_never_stopped(void **unused) {
    (void)unused;
    bool seen[TDMF_CONTACT_GRAZE + 1] = {false};
    fmi2Component straight = new_slave();
    initialize(straight);
    step(straight, 11.8);
    for (int i = 0; i < 50; ++i) {
        fmi2Byte bytes[SERIALIZED_BYTES];
        fmi2Component other = new_slave();
        step(straight, 0.03);
        seen[get_integer(straight, "contact.mode")] = true;
        const size_t size = serialize2(straight, bytes);
        restore(other, bytes, size);
        assert_same(straight, other);
        step(other, 20.0);
        fmi2Component again = new_slave();
        restore(again, bytes, size);
        step(again, 20.0);
        assert_same(other, again);
        fmi2FreeInstance(other);
        fmi2FreeInstance(again);
    }
    for (int mode = TDMF_CONTACT_FLIGHT; mode <= TDMF_CONTACT_GRAZE; ++mode) {
        assert_true(seen[mode]);
    }
    fmi2FreeInstance(straight);
}

static void model_exchange_restores_its_call_state(void **unused) {
    (void)unused;
    fmi2FMUstate saved = NULL;
    double states[TDMF_STATE_COUNT];
    double derivatives[2][TDMF_STATE_COUNT];
    fmi2Component component = new_instance();
    start_running(component);
    assert_int_equal(fmi2GetFMUstate(component, &saved), fmi2OK);
    assert_int_equal(fmi2GetDerivatives(component, derivatives[0], TDMF_STATE_COUNT), fmi2OK);
    memset(states, 0, sizeof states);
    states[TDMF_LEG_LENGTH] = 0.9;
    assert_int_equal(fmi2SetContinuousStates(component, states, TDMF_STATE_COUNT), fmi2OK);
    assert_int_equal(fmi2EnterEventMode(component), fmi2OK);
    assert_int_equal(fmi2SetFMUstate(component, saved), fmi2OK);
    assert_int_equal(fmi2GetDerivatives(component, derivatives[1], TDMF_STATE_COUNT), fmi2OK);
    assert_memory_equal(derivatives[0], derivatives[1], sizeof derivatives[0]);
    assert_int_equal(fmi2SetTime(component, 1.0), fmi2OK);
    assert_int_equal(fmi2SetContinuousStates(component, states, TDMF_STATE_COUNT),
                     fmi2OK); /* continuous again */
    assert_int_equal(fmi2FreeFMUstate(component, &saved), fmi2OK);
    fmi2FreeInstance(component);
}

/* Fails in its first step: the runner is too stiff. */
static fmi2Component new_failed(fmi2FMUstate *before) {
    fmi2Component component = new_slave();
    assert_int_equal(set_real(component, "hip.kd", 2.5e13), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
    assert_int_equal(fmi2GetFMUstate(component, before), fmi2OK);
    assert_int_equal(fmi2ExitInitializationMode(component), fmi2OK);
    assert_int_equal(fmi2DoStep(component, 0.0, 1.0, fmi2True), fmi2Error);
    return component;
}

static void an_error_is_left_by_an_older_state(void **unused) {
    (void)unused;
    fmi2FMUstate saved = NULL;
    fmi2Component component = new_failed(&saved);
    assert_int_equal(fmi2SetFMUstate(component, saved), fmi2OK);
    assert_int_equal(set_real(component, "hip.kd", 0.1), fmi2OK);
    assert_int_equal(fmi2ExitInitializationMode(component), fmi2OK);
    step(component, 1.0);
    assert_int_equal(fmi2FreeFMUstate(component, &saved), fmi2OK);
    fmi2FreeInstance(component);
}

/* Either version's standard lets a failed instance be saved: restored, it has failed. */
static void an_instance_after_an_error_is_saved_as_such(void **unused) {
    (void)unused;
    fmi2Byte bytes[SERIALIZED_BYTES];
    fmi2FMUstate saved = NULL;
    fmi2Component failed = new_failed(&saved), other = new_slave();
    initialize(other);
    step(other, 1.0);
    restore(other, bytes, serialize2(failed, bytes));
    assert_true(get_real(other, "hip.kd") == 2.5e13);
    assert_int_equal(fmi2DoStep(other, 0.0, 1.0, fmi2True), fmi2Error);
    assert_non_null(strstr(last_message, "after an error"));
    assert_int_equal(fmi2FreeFMUstate(failed, &saved), fmi2OK);
    fmi2FreeInstance(failed);
    fmi2FreeInstance(other);
}

/* ---- refusals ----------------------------------------------------------------------------------------- */

static void assert_bytes_refused(const fmi2Byte bytes[SERIALIZED_BYTES], size_t size, const char *reason) {
    fmi2FMUstate saved = NULL;
    fmi2Component component = new_slave();
    fmi2Component twin = new_slave();
    initialize(component);
    initialize(twin);
    step(component, 12.0);
    step(twin, 12.0);
    assert_int_equal(fmi2DeSerializeFMUstate(component, bytes, size, &saved), fmi2Discard);
    assert_non_null(strstr(last_message, reason));
    assert_null(saved);
    assert_same(component, twin);
    step(component, 5.0);
    fmi2FreeInstance(component);
    fmi2FreeInstance(twin);
}

static void bytes_that_are_no_state_are_refused(void **unused) {
    (void)unused;
    fmi2Byte good[SERIALIZED_BYTES] = {0};
    fmi2Byte bad[SERIALIZED_BYTES];
    fmi2Component component = new_slave();
    initialize(component);
    const size_t size = serialize2(component, good);
    fmi2FreeInstance(component);
    assert_bytes_refused(good, size - 1, "bytes are no state");
    assert_bytes_refused(good, size + 1, "bytes are no state");
    assert_bytes_refused(good, 0, "bytes are no state");
    memcpy(bad, good, sizeof bad);
    bad[size - 9] = (fmi2Byte)(bad[size - 9] ^ 1);
    assert_bytes_refused(bad, size, "changed");
    memcpy(bad, good, sizeof bad);
    bad[3] = (fmi2Byte)(bad[3] ^ 1);
    assert_bytes_refused(bad, size, "another version");
    memset(bad, 0, sizeof bad);
    assert_bytes_refused(bad, size, "another program");
}

static void states_of_other_interfaces_are_refused(void **unused) {
    (void)unused;
    fmi2FMUstate saved = NULL;
    fmi2Component slave = new_slave();
    fmi2Component exchange = new_instance();
    initialize(slave);
    assert_int_equal(fmi2GetFMUstate(slave, &saved), fmi2OK);
    assert_int_equal(fmi2SetFMUstate(exchange, saved), fmi2Discard);
    assert_non_null(strstr(last_message, "interface"));
    assert_int_equal(fmi2SetFMUstate(slave, NULL), fmi2Discard);
    assert_int_equal(fmi2FreeFMUstate(slave, &saved), fmi2OK);
    assert_int_equal(fmi2FreeFMUstate(slave, &saved), fmi2OK); /* a null pointer is nothing to free */
    fmi2FreeInstance(slave);
    fmi2FreeInstance(exchange);
}

/* fmusim 0.0.39 frees a state so. It stays the caller's, who has lost it. */
static void a_state_passed_where_its_address_is_due_is_left_alone(void **unused) {
    (void)unused;
    fmi2FMUstate saved = NULL;
    fmi2Component component = new_slave(), twin = new_slave();
    initialize(component);
    initialize(twin);
    step(component, 12.0);
    step(twin, 12.0);
    assert_int_equal(fmi2GetFMUstate(component, &saved), fmi2OK);
    step(component, 5.0);
    assert_int_equal(fmi2FreeFMUstate(component, saved), fmi2OK);
    assert_int_equal(fmi2SetFMUstate(component, saved), fmi2OK);
    assert_same(component, twin);
    assert_int_equal(fmi2FreeFMUstate(component, &saved), fmi2OK);
    assert_null(saved);
    fmi2FreeInstance(component);
    fmi2FreeInstance(twin);
}

/* ---- as fmusim resumes a run: restore, then start values, then on without initialization --------------- */

static void change(fmi2Component component) {
    assert_int_equal(set_real(component, "body.mass", 1.25), fmi2OK);
    assert_int_equal(set_real(component, "leg.damping", 0.3), fmi2OK);
    assert_int_equal(set_real(component, "solver.relative_tolerance", 1e-8), fmi2OK);
    assert_int_equal(set_real(component, "ground.friction", 0.4), fmi2OK);
}

static void assert_changed(fmi2Component component) {
    assert_true(get_real(component, "body.mass") == 1.25);
    assert_true(get_real(component, "leg.damping") == 0.3);
    assert_true(get_real(component, "solver.relative_tolerance") == 1e-8);
}

static void a_changed_run_of_co_simulation_is_resumed(void **unused) {
    (void)unused;
    fmi2Byte bytes[SERIALIZED_BYTES];
    fmi2Component straight = new_slave(), resumed = new_slave();
    change(straight);
    initialize(straight);
    step(straight, 13.0);
    restore(resumed, bytes, serialize2(straight, bytes));
    assert_changed(resumed);
    assert_int_equal(set_real(resumed, "ground.friction", 0.3), fmi2OK);
    assert_int_equal(set_real(straight, "ground.friction", 0.3), fmi2OK);
    step(straight, 20.0);
    step(resumed, 20.0);
    assert_same(straight, resumed);
    assert_true(get_real(straight, "energy.impact_loss") > 0.0);
    fmi2FreeInstance(straight);
    fmi2FreeInstance(resumed);
}

/* Euler's method, with what it needs done at events. */
static void integrate(fmi2Component component, int steps) {
    const double h = 1e-3;
    double states[TDMF_STATE_COUNT], slopes[TDMF_STATE_COUNT];
    double before[TDMF_GUARD_COUNT], after[TDMF_GUARD_COUNT];
    double time = get_real(component, "time");
    for (int i = 0; i < steps; ++i) {
        bool event = false;
        assert_int_equal(fmi2GetEventIndicators(component, before, TDMF_GUARD_COUNT), fmi2OK);
        assert_int_equal(fmi2GetContinuousStates(component, states, TDMF_STATE_COUNT), fmi2OK);
        assert_int_equal(fmi2GetDerivatives(component, slopes, TDMF_STATE_COUNT), fmi2OK);
        for (int j = 0; j < TDMF_STATE_COUNT; ++j) {
            states[j] += h * slopes[j];
        }
        time += h;
        assert_int_equal(fmi2SetTime(component, time), fmi2OK);
        assert_int_equal(fmi2SetContinuousStates(component, states, TDMF_STATE_COUNT), fmi2OK);
        assert_int_equal(fmi2GetEventIndicators(component, after, TDMF_GUARD_COUNT), fmi2OK);
        for (int j = 0; j < TDMF_GUARD_COUNT; ++j) {
            event |= (before[j] > 0.0) != (after[j] > 0.0);
        }
        if (event) {
            fmi2EventInfo info;
            assert_int_equal(fmi2EnterEventMode(component), fmi2OK);
            assert_int_equal(fmi2NewDiscreteStates(component, &info), fmi2OK);
            assert_int_equal(fmi2EnterContinuousTimeMode(component), fmi2OK);
        }
    }
}

static void a_changed_run_of_model_exchange_is_resumed(void **unused) {
    (void)unused;
    fmi2Byte bytes[SERIALIZED_BYTES];
    fmi2Component straight = new_instance(), resumed = new_instance();
    change(straight);
    start_running(straight);
    integrate(straight, 13000);
    restore(resumed, bytes, serialize2(straight, bytes));
    assert_changed(resumed);
    assert_int_equal(set_real(resumed, "ground.friction", 0.3), fmi2OK);
    assert_int_equal(set_real(straight, "ground.friction", 0.3), fmi2OK);
    integrate(straight, 10000);
    integrate(resumed, 10000);
    assert_same(straight, resumed);
    assert_true(get_real(straight, "energy.impact_loss") > 0.0);
    fmi2FreeInstance(straight);
    fmi2FreeInstance(resumed);
}

/* Saved before initialization or in it, the run begins from the start values that the state holds, but for
 * those set since. */
static void a_state_from_before_the_start_takes_more_start_values(void **unused) {
    (void)unused;
    for (int mode = 0; mode < 2; ++mode) {
        fmi2Byte bytes[SERIALIZED_BYTES];
        fmi2Component first = new_slave(), second = new_slave(), straight = new_slave();
        change(first);
        if (mode == 1) {
            assert_int_equal(fmi2EnterInitializationMode(first), fmi2OK);
        }
        restore(second, bytes, serialize2(first, bytes));
        assert_int_equal(set_real(second, "hip.kp", 0.12), fmi2OK);
        if (mode == 0) {
            assert_int_equal(fmi2EnterInitializationMode(second), fmi2OK);
        }
        assert_int_equal(fmi2ExitInitializationMode(second), fmi2OK);
        change(straight);
        assert_int_equal(set_real(straight, "hip.kp", 0.12), fmi2OK);
        initialize(straight);
        step(second, 20.0);
        step(straight, 20.0);
        assert_same(second, straight);
        fmi2FreeInstance(first);
        fmi2FreeInstance(second);
        fmi2FreeInstance(straight);
    }
}

/* The state of a run with other parameters: these, what follows from them and what was shown of the old ones
 * are gone. */
static void restoring_replaces_parameters_and_what_follows_from_them(void **unused) {
    (void)unused;
    fmi2FMUstate saved = NULL;
    fmi2Component light = new_slave(), heavy = new_slave();
    initialize(light);
    step(light, 13.0);
    assert_int_equal(fmi2GetFMUstate(light, &saved), fmi2OK);
    assert_int_equal(set_real(heavy, "body.mass", 2.0), fmi2OK);
    assert_int_equal(set_real(heavy, "ground.friction", 10.0), fmi2OK);
    assert_int_equal(fmi2SetupExperiment(heavy, fmi2True, 1e-3, 0.0, fmi2True, 14.0), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(heavy), fmi2OK);
    assert_int_equal(fmi2ExitInitializationMode(heavy), fmi2OK);
    step(heavy, 13.0);
    assert_true(get_real(heavy, "stride.period") != 1.0 && get_real(heavy, "energy.total") > 0.0);
    assert_int_equal(fmi2SetFMUstate(heavy, saved), fmi2OK);
    assert_true(get_real(heavy, "body.mass") == 1.0);
    assert_true(get_real(heavy, "energy.total") == get_real(light, "energy.total"));
    assert_true(get_real(heavy, "contact.fy") == get_real(light, "contact.fy"));
    assert_same(light, heavy);
    step(light, 20.0);
    step(heavy, 20.0); /* beyond its own stop time */
    assert_same(light, heavy);
    assert_int_equal(fmi2FreeFMUstate(light, &saved), fmi2OK);
    fmi2FreeInstance(light);
    fmi2FreeInstance(heavy);
}

static void ramp(fmi2Component component, const char *name, double rate) {
    const fmi2ValueReference reference = reference_of(name);
    const fmi2Integer order = 1;
    assert_int_equal(fmi2SetRealInputDerivatives(component, &reference, 1, &order, &rate), fmi2OK);
}

/* Rates of inputs, the stop time and the counters of work go with the run. */
static void ramps_and_the_stop_time_are_saved(void **unused) {
    (void)unused;
    fmi2Byte bytes[SERIALIZED_BYTES];
    fmi2Component component = new_slave(), other = new_slave();
    assert_int_equal(fmi2SetupExperiment(component, fmi2False, 0.0, 0.0, fmi2True, 20.0), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
    assert_int_equal(fmi2ExitInitializationMode(component), fmi2OK);
    step(component, 11.0);
    ramp(component, "hip.external_torque", 1e-3);
    ramp(component, "ground.friction", -1e-2);
    restore(other, bytes, serialize2(component, bytes));
    step(component, 9.0);
    step(other, 9.0);
    assert_same(component, other);
    assert_true(get_real(other, "hip.external_torque") != 0.0 && get_real(other, "ground.friction") < 0.6);
    assert_true(get_real(other, "hip.external_torque") == get_real(component, "hip.external_torque"));
    assert_true(get_real(other, "ground.friction") == get_real(component, "ground.friction"));
    assert_int_equal(get_integer(other, "solver.steps"), get_integer(component, "solver.steps"));
    assert_int_equal(get_integer(other, "solver.evaluations"), get_integer(component, "solver.evaluations"));
    assert_int_equal(fmi2DoStep(other, 20.0, 1.0, fmi2True), fmi2Error);
    assert_non_null(strstr(last_message, "stop time"));
    fmi2FreeInstance(component);
    fmi2FreeInstance(other);
}

/* What was set since is forgotten with the rest. */
static void restoring_undoes_everything(void **unused) {
    (void)unused;
    fmi2FMUstate saved = NULL, again = NULL;
    fmi2Byte bytes[2][SERIALIZED_BYTES];
    size_t size = 0;
    fmi2Component component = new_slave();
    initialize(component);
    step(component, 13.0);
    assert_int_equal(fmi2GetFMUstate(component, &saved), fmi2OK);
    ramp(component, "hip.external_torque", 1e-3);
    step(component, 5.0);
    assert_int_equal(fmi2SetFMUstate(component, saved), fmi2OK);
    assert_int_equal(fmi2GetFMUstate(component, &again), fmi2OK);
    assert_int_equal(fmi2SerializedFMUstateSize(component, saved, &size), fmi2OK);
    assert_int_equal(fmi2SerializeFMUstate(component, saved, bytes[0], size), fmi2OK);
    assert_int_equal(fmi2SerializeFMUstate(component, again, bytes[1], size), fmi2OK);
    assert_memory_equal(bytes[0], bytes[1], size);
    assert_int_equal(fmi2FreeFMUstate(component, &saved), fmi2OK);
    assert_int_equal(fmi2FreeFMUstate(component, &again), fmi2OK);
    fmi2FreeInstance(component);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(co_simulation_goes_on_as_if_never_stopped),
        cmocka_unit_test(model_exchange_restores_its_call_state),
        cmocka_unit_test(an_error_is_left_by_an_older_state),
        cmocka_unit_test(bytes_that_are_no_state_are_refused),
        cmocka_unit_test(states_of_other_interfaces_are_refused),
        cmocka_unit_test(a_state_passed_where_its_address_is_due_is_left_alone),
        cmocka_unit_test(an_instance_after_an_error_is_saved_as_such),
        cmocka_unit_test(a_changed_run_of_co_simulation_is_resumed),
        cmocka_unit_test(a_changed_run_of_model_exchange_is_resumed),
        cmocka_unit_test(a_state_from_before_the_start_takes_more_start_values),
        cmocka_unit_test(restoring_replaces_parameters_and_what_follows_from_them),
        cmocka_unit_test(ramps_and_the_stop_time_are_saved),
        cmocka_unit_test(restoring_undoes_everything),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
