/* Features of Co-Simulation that only FMI 2.0 has: rates of inputs, which are part of a saved state, and the
 * status of steps. */
#include "compare.h"
#include "fmi2_importer.h"
#include "tdmf_slip/tdmf_slip.h"

#include <math.h>
#include <string.h>

static const fmi2Integer first = 1;

static fmi2Status set_rate(fmi2Component component, const char *name, fmi2Integer order, double rate) {
    const fmi2ValueReference reference = reference_of(name);
    return fmi2SetRealInputDerivatives(component, &reference, 1, &order, &rate);
}

TEST(an_input_goes_on_at_its_rate_until_it_is_set) {
    fmi2Component component = begun(&fmi2, STEPS, "");
    assert_int_equal(set_rate(component, "ground.friction", 1, -0.01), fmi2OK);
    step_by(&fmi2, component, 10.0);
    step_by(&fmi2, component, 10.0);
    assert_close(get_real(component, "ground.friction"), 0.4, 1e-12);
    set_values(&fmi2, component, "ground.friction=0.5");
    step_by(&fmi2, component, 20.0);
    assert_true(get_real(component, "ground.friction") == 0.5);
}

/* The power of a leg that lengthens follows from the rate of its extension. */
TEST(a_rate_that_is_set_is_in_the_next_derivatives) {
    fmi2Component component = begun(&fmi2, STEPS, "");
    while (get_whole(component, "contact.mode_index") == TDMF_CONTACT_FLIGHT) {
        step_by(&fmi2, component, 1.0);
    }
    assert_true(get_real(component, "der(leg.work)") == 0.0);
    assert_int_equal(set_rate(component, "leg.extension", 1, 1e-3), fmi2OK);
    assert_true(get_real(component, "der(leg.work)") != 0.0);
}

/* A fall freezes the runner, but not the inputs, which belong to the importer. */
TEST(an_input_goes_on_at_its_rate_after_a_fall) {
    fmi2Component component = begun(&fmi2, STEPS, "foot.y=100.0");
    assert_int_equal(set_rate(component, "hip.external_torque", 1, 1e-3), fmi2OK);
    step_by(&fmi2, component, 2000.0);
    const double x = get_real(component, "foot.x");
    assert_true(get_real(component, "event.last_time") < 1000.0);
    assert_close(get_real(component, "hip.external_torque"), 2.0, 1e-12);
    assert_int_equal(set_rate(component, "ground.friction", 1, 1e-3), fmi2OK);
    step_by(&fmi2, component, 500.0);
    assert_close(get_real(component, "hip.external_torque"), 2.5, 1e-12);
    assert_close(get_real(component, "ground.friction"), 0.6 + 0.5, 1e-12);
    assert_true(get_real(component, "foot.x") == x);
}

TEST(rates_are_numbers_of_inputs_and_set_in_their_states) {
    const fmi2ValueReference torque = reference_of("hip.external_torque");
    const double still = 0.0;
    fmi2Component slave = new_slave(), exchange = new_instance();
    assert_int_equal(set_rate(exchange, "hip.external_torque", 1, still), fmi2Error);
    assert_non_null(strstr(last_message, "not allowed in Model Exchange"));
    start_running(exchange);
    assert_int_equal(set_rate(slave, "hip.external_torque", 1, still), fmi2OK);
    initialize(slave);
    assert_int_equal(set_rate(slave, "hip.external_torque", 1, NAN), fmi2Discard);
    assert_int_equal(set_rate(slave, "hip.external_torque", 1, -INFINITY), fmi2Discard);
    assert_int_equal(set_rate(slave, "hip.external_torque", 2, still), fmi2Error);
    assert_int_equal(set_rate(slave, "body.mass", 1, still), fmi2Error);
    assert_int_equal(fmi2SetRealInputDerivatives(slave, &torque, 1, &first, NULL), fmi2Error);
    assert_int_equal(fmi2SetRealInputDerivatives(slave, &torque, 1, NULL, &still), fmi2Error);
    assert_int_equal(set_rate(slave, "hip.external_torque", 1, still), fmi2OK);
    assert_int_equal(fmi2Terminate(slave), fmi2OK);
    assert_int_equal(set_rate(slave, "hip.external_torque", 1, still), fmi2Error);
    assert_int_equal(set_rate(exchange, "hip.external_torque", 1, still), fmi2Error);
}

/* Ramps so steep that the input leaves its range in the step, and would overflow. */
TEST(rates_beyond_reason_end_in_a_message) {
    static const double rates[] = {1e7, 1e150, 1e200, 1e300};
    for (size_t i = 0; i < COUNT_OF(rates); ++i) {
        fmi2Component component = begun(&fmi2, STEPS, "");
        assert_int_equal(set_rate(component, "ground.friction", 1, rates[i]), fmi2OK);
        assert_int_equal(fmi2DoStep(component, 0.0, 11.0, fmi2True), fmi2Error);
        assert_non_null(strstr(last_message, "out of range"));
    }
}

/* Outputs move with the inputs that move. */
TEST(output_derivatives_go_with_the_rates_of_inputs) {
    static const char *const names[] = {"contact.fx", "hip.torque"};
    static const double delta = 1e-5;
    fmi2Component component = begun(&fmi2, STEPS, "");
    step_by(&fmi2, component, 12.1);
    assert_int_equal(get_whole(component, "contact.mode"), TDMF_CONTACT_SLIP_POSITIVE);
    assert_int_equal(set_rate(component, "ground.friction", 1, -0.5), fmi2OK);
    assert_int_equal(set_rate(component, "hip.external_torque", 1, 0.2), fmi2OK);
    for (int i = 0; i < 2; ++i) {
        double slope = 0.0;
        const double before = get_real(component, names[i]);
        step_by(&fmi2, component, delta);
        assert_int_equal(fmi2.output_derivative(component, reference_of(names[i]), 1, &slope), FMI_OK);
        step_by(&fmi2, component, delta);
        assert_close((get_real(component, names[i]) - before) / (2.0 * delta), slope, 1e-7);
        assert_true(fabs(slope) > 0.01);
    }
}

/* Restoring a state also replaces rates that were set since it was saved. */
TEST(rates_go_with_a_saved_run) {
    fmi2Component component = begun(&fmi2, STEPS, ""), other = new_slave();
    step_by(&fmi2, component, 11.0);
    assert_int_equal(set_rate(component, "hip.external_torque", 1, 1e-3), fmi2OK);
    assert_int_equal(set_rate(component, "ground.friction", 1, -1e-2), fmi2OK);
    const serialized state = serialize(&fmi2, component);
    assert_int_equal(restore(&fmi2, other, &state), FMI_OK);
    step_by(&fmi2, component, 9.0);
    step_by(&fmi2, other, 9.0);
    assert_true(get_real(other, "hip.external_torque") != 0.0 && get_real(other, "ground.friction") < 0.6);
    const serialized end = serialize(&fmi2, component);
    assert_state(&fmi2, other, &end);
    assert_int_equal(set_rate(component, "body.external_fx", 1, 1e-3), fmi2OK);
    assert_int_equal(restore(&fmi2, component, &state), FMI_OK);
    assert_state(&fmi2, component, &state);
}

TEST(statuses_are_those_of_steps_that_are_done) {
    fmi2Status status = fmi2OK;
    double time = -1.0;
    fmi2Integer integer = 0;
    fmi2Boolean terminated = fmi2True;
    fmi2String text = NULL;
    fmi2Component component = new_slave();
    assert_int_equal(fmi2GetRealStatus(component, fmi2LastSuccessfulTime, &time), fmi2Error);
    assert_int_equal(fmi2GetBooleanStatus(component, fmi2Terminated, &terminated), fmi2Error);
    assert_int_equal(fmi2GetStatus(component, fmi2DoStepStatus, &status), fmi2Error);
    initialize(component);
    step_by(&fmi2, component, 2.0);
    assert_int_equal(fmi2GetRealStatus(component, fmi2LastSuccessfulTime, &time), fmi2OK);
    assert_int_equal(fmi2GetBooleanStatus(component, fmi2Terminated, &terminated), fmi2OK);
    assert_true(time == 2.0 && terminated == fmi2False);
    assert_int_equal(fmi2GetRealStatus(component, fmi2Terminated, &time), fmi2Discard);
    assert_int_equal(fmi2GetBooleanStatus(component, fmi2LastSuccessfulTime, &terminated), fmi2Discard);
    assert_int_equal(fmi2GetIntegerStatus(component, fmi2DoStepStatus, &integer), fmi2Discard);
    assert_int_equal(fmi2GetStringStatus(component, fmi2PendingStatus, &text), fmi2Discard);
    assert_int_equal(fmi2GetStatus(component, fmi2DoStepStatus, &status), fmi2Discard);
    assert_int_equal(fmi2CancelStep(component), fmi2Error);
    step_by(&fmi2, component, 2.0);
}
