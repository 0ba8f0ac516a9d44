/* What Co-Simulation of FMI 2.0 alone has: rates of inputs, and the status of steps. */
#include "compare.h"
#include "fmi2_importer.h"

#include <math.h>
#include <string.h>

/* A test of a fresh instance, `component`. */
#define TEST_OF_INSTANCE(name)                                                                               \
    static void name##_of(fmi2Component component);                                                          \
    TEST(name) {                                                                                             \
        fmi2Component component = new_slave();                                                               \
        name##_of(component);                                                                                \
        fmi2FreeInstance(component);                                                                         \
    }                                                                                                        \
    static void name##_of(fmi2Component component)

static void run(fmi2Component component, double from, double to, double step) {
    const long steps = lround((to - from) / step);
    for (long i = 0; i < steps; ++i) {
        const double time = from + (double)i * step;
        assert_int_equal(fmi2DoStep(component, time, step, fmi2True), fmi2OK);
    }
}

static fmi2Status set_rate(fmi2Component component, const char *name, fmi2Integer order, double rate) {
    const fmi2ValueReference reference = reference_of(name);
    return fmi2SetRealInputDerivatives(component, &reference, 1, &order, &rate);
}

TEST_OF_INSTANCE(an_input_goes_on_at_its_rate_until_it_is_set) {
    initialize(component);
    assert_int_equal(set_rate(component, "ground.friction", 1, -0.01), fmi2OK);
    run(component, 0.0, 20.0, 10.0);
    assert_close(get_real(component, "ground.friction"), 0.4, 1e-12);
    assert_int_equal(set_real(component, "ground.friction", 0.5), fmi2OK);
    run(component, 20.0, 40.0, 10.0);
    assert_true(get_real(component, "ground.friction") == 0.5);
}

/* A fall freezes the runner; inputs are the importer's, and go on. */
TEST_OF_INSTANCE(an_input_goes_on_at_its_rate_after_a_fall) {
    assert_int_equal(set_real(component, "foot.y", 100.0), fmi2OK);
    initialize(component);
    run(component, 0.0, 2100.0, 100.0);
    const double x = get_real(component, "foot.x");
    assert_int_equal(set_rate(component, "ground.friction", 1, 1e-3), fmi2OK);
    run(component, 2100.0, 2300.0, 10.0);
    assert_close(get_real(component, "ground.friction"), 0.6 + 0.2, 1e-12);
    assert_true(get_real(component, "foot.x") == x);
}

TEST_OF_INSTANCE(bad_rates_are_refused) {
    initialize(component);
    assert_int_equal(set_rate(component, "ground.friction", 1, NAN), fmi2Discard);
    assert_int_equal(set_rate(component, "ground.friction", 2, 0.0), fmi2Error);
    assert_int_equal(fmi2Reset(component), fmi2OK);
    assert_int_equal(set_rate(component, "body.mass", 1, 0.0), fmi2Error);
}

/* So steep that the input leaves its range in the step, and would overflow. */
TEST_OF_INSTANCE(rates_beyond_reason_end_in_a_message) {
    static const double rates[] = {1e7, 1e150, 1e200, 1e300};
    for (size_t i = 0; i < sizeof rates / sizeof rates[0]; ++i) {
        initialize(component);
        assert_int_equal(set_rate(component, "ground.friction", 1, rates[i]), fmi2OK);
        assert_int_equal(fmi2DoStep(component, 0.0, 11.0, fmi2True), fmi2Error);
        assert_non_null(strstr(last_message, "out of range"));
        assert_int_equal(fmi2Reset(component), fmi2OK);
    }
}

TEST_OF_INSTANCE(nothing_is_asynchronous) {
    fmi2Status status;
    double time = 0.0;
    initialize(component);
    run(component, 0.0, 5.0, 5.0);
    assert_int_equal(fmi2GetStatus(component, fmi2DoStepStatus, &status), fmi2Discard);
    assert_int_equal(fmi2GetRealStatus(component, fmi2LastSuccessfulTime, &time), fmi2OK);
    assert_true(time == 5.0);
    assert_int_equal(fmi2CancelStep(component), fmi2Error);
}
