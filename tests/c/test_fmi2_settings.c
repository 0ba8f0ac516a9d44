/* Tunable parameters and discrete inputs, which an importer may change in a run at events only: when they may
 * be set, what is refused, and that they are in force at once. */
#include "compare.h"
#include "fmi2_importer.h"
#include "simulation.h"

#include "tdmf_slip/tdmf_slip.h"
#include "variables.h"

#include <math.h>
#include <string.h>

enum { TUNABLE_PARAMETERS = 7, DISCRETE_INPUTS = 5, EITHER = TUNABLE_PARAMETERS + DISCRETE_INPUTS };

/* Lists the value references of all settings that change at events; asserts their number. */
static void list_settings(fmi2ValueReference found[EITHER]) {
    int parameters = 0, count = 0;
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        if (fmu_is_set_at_events(&fmu_variables[i])) {
            assert_true(count < EITHER);
            found[count++] = (fmi2ValueReference)i;
            parameters += fmu_variables[i].storage == STORED_PARAMETER ? 1 : 0;
        }
    }
    assert_int_equal(count, EITHER);
    assert_int_equal(parameters, TUNABLE_PARAMETERS);
}

static double value_at(fmi2Component component, fmi2ValueReference reference) {
    double value = (double)NAN;
    assert_int_equal(fmi2GetReal(component, &reference, 1, &value), fmi2OK);
    return value;
}

/* ---- when, and what ----------------------------------------------------------------------------------- */

/* Asserts that each setting takes a new value and refuses one beyond its range, alone and in one call with a
 * setting whose value is allowed. */
static void assert_all_are_set(fmi2Component component) {
    fmi2ValueReference settings[EITHER];
    list_settings(settings);
    for (int i = 0; i < EITHER; ++i) {
        const fmu_variable *variable = &fmu_variables[settings[i]];
        const fmi2ValueReference pair[] = {settings[(i + 1) % EITHER], settings[i]};
        const double other = value_at(component, pair[0]);
        const double wrong[] = {nextafter(variable->maximum, INFINITY),
                                nextafter(variable->minimum, -INFINITY), (double)NAN};
        const double value = 0.3 + 0.01 * i;
        assert_int_equal(fmi2SetReal(component, &settings[i], 1, &value), fmi2OK);
        for (int j = 0; j < 3; ++j) {
            const double values[] = {0.25, wrong[j]};
            assert_int_equal(fmi2SetReal(component, pair, 2, values), fmi2Discard);
            assert_non_null(strstr(last_message, variable->name));
        }
        assert_true(value_at(component, settings[i]) == value);
        assert_true(value_at(component, pair[0]) == other);
    }
}

TEST(they_are_set_before_the_start_and_in_event_mode) {
    fmi2Component component = new_instance();
    assert_all_are_set(component);
    assert_int_equal(fmi2Reset(component), fmi2OK);
    assert_int_equal(fmi2SetupExperiment(component, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
    assert_all_are_set(component);
    assert_int_equal(fmi2ExitInitializationMode(component), fmi2OK);
    assert_all_are_set(component);
}

TEST(they_are_set_between_communication_steps) {
    fmi2Component component = begun(&fmi2, STEPS, "");
    assert_all_are_set(component);
    assert_int_equal(fmi2DoStep(component, 0.0, 1.0, fmi2True), fmi2OK);
    assert_all_are_set(component);
}

/* Solvers of some importers set all inputs at each evaluation; after an event, to the values before it. */
TEST(in_continuous_time_mode_they_keep_their_values) {
    fmi2Component component = new_instance();
    fmi2ValueReference settings[EITHER];
    list_settings(settings);
    start_running(component);
    for (int i = 0; i < EITHER; ++i) {
        const double value = value_at(component, settings[i]);
        const double changed = value + 0.01;
        assert_int_equal(fmi2SetReal(component, &settings[i], 1, &value), fmi2OK);
        assert_int_equal(fmi2SetReal(component, &settings[i], 1, &changed), fmi2Warning);
        assert_non_null(strstr(last_message, fmu_variables[settings[i]].name));
        assert_true(value_at(component, settings[i]) == value);
    }
}

TEST(only_continuous_inputs_have_rates) {
    fmi2Component component = new_slave();
    const fmi2Integer first = 1;
    const double rate = 0.0;
    int continuous = 0, discrete = 0;
    initialize(component);
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmi2ValueReference reference = (fmi2ValueReference)i;
        const bool ramps = fmu_variables[i].variability == VARIABILITY_CONTINUOUS;
        if (fmu_variables[i].storage == STORED_INPUT) {
            assert_int_equal(fmi2SetRealInputDerivatives(component, &reference, 1, &first, &rate),
                             ramps ? fmi2OK : fmi2Error);
            *(ramps ? &continuous : &discrete) += 1;
        }
    }
    assert_int_equal(continuous, 5);
    assert_int_equal(discrete, DISCRETE_INPUTS);
}

/* ---- in force at once --------------------------------------------------------------------------------- */

static void put_on_the_ground(fmi2Component component) {
    set_values(
        &fmi2, component,
        "foot.y=0 foot.vx=0 foot.vy=0 leg.length=0.9 leg.angle=0.3 leg.length_rate=0 leg.angle_rate=-0.1");
}

TEST(a_setting_is_in_force_at_once) {
    fmi2Component component = new_instance();
    put_on_the_ground(component);
    initialize(component);
    assert_int_equal(get_whole(component, "hip.phase"), TDMF_PHASE_DRIVE);
    assert_close(get_real(component, "hip.torque"), -0.2, 0.0);
    set_values(&fmi2, component, "hip.stance_torque=0.15");
    assert_close(get_real(component, "hip.torque"), -0.15, 0.0);
    set_values(&fmi2, component, "control.stance_torque=0.02");
    assert_close(get_real(component, "hip.torque"), -0.17, 1e-16);
}

/* Run of the library whose settings change at time `change`. */
static simulation run_of_the_library(double change, double end) {
    tdmf_parameters parameters = tdmf_default_parameters();
    const tdmf_inputs inputs = tdmf_default_inputs();
    double state[TDMF_STATE_COUNT];
    tdmf_default_state(state);
    simulation run = simulation_in(&parameters, &inputs, state, tdmf_solver_default().relative_tolerance);
    assert_int_equal(simulation_advance(&run, change), TDMF_ARRIVED);
    parameters.hip.touchdown_angle = 0.72;
    parameters.hip.kp = 0.12;
    parameters.hip.kd = 0.11;
    parameters.hip.stance_torque = 0.21;
    parameters.hip.liftoff_angle_factor = 1.25;
    parameters.hip.retraction_rate = 0.01;
    run.inputs.control.touchdown_angle = -0.01;
    run.model = accepted_model(&parameters);
    assert_int_equal(simulation_advance(&run, end), TDMF_ARRIVED);
    return run;
}

TEST(co_simulation_goes_on_with_what_was_set) {
    static const char laws[] = "hip.touchdown_angle=0.72 hip.kp=0.12 hip.kd=0.11 hip.stance_torque=0.21 "
                               "hip.retraction_rate=0.01 hip.liftoff_angle_factor=1.25 "
                               "control.touchdown_angle=-0.01";
    for (int k = 0; k < 4; ++k) { /* in place, in contact, in retract, and in place again */
        const double change = 5.0 + 6.0 * k, end = 60.0;
        fmi2Component component = begun(&fmi2, STEPS, "");
        assert_int_equal(fmi2DoStep(component, 0.0, change, fmi2True), fmi2OK);
        set_values(&fmi2, component, laws);
        assert_int_equal(fmi2DoStep(component, change, end - change, fmi2True), fmi2OK);
        const tdmf_motion expected = run_of_the_library(change, end).motion;
        /* The library runs the plain page up to the change, whose sums are rounded otherwise. */
        assert_close(get_real(component, "leg.angle"), expected.state[TDMF_LEG_ANGLE], 1e-10);
        assert_close(get_real(component, "foot.x"), expected.state[TDMF_FOOT_X], 1e-10);
        assert_int_equal(get_whole(component, "event.count"), expected.state[TDMF_EVENT_COUNT]);
    }
}
