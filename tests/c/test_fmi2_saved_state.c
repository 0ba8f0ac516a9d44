/* Rates of inputs, which FMI 2.0 alone sets, are part of a saved state. */
#include "compare.h"
#include "fmi2_importer.h"

static void ramp(fmi2Component component, const char *name, double rate) {
    const fmi2ValueReference reference = reference_of(name);
    const fmi2Integer order = 1;
    assert_int_equal(fmi2SetRealInputDerivatives(component, &reference, 1, &order, &rate), fmi2OK);
}

TEST(rates_go_with_the_run) {
    static const char *const names[] = {"hip.external_torque", "ground.friction", "foot.x", "leg.angle"};
    unsigned char bytes[2][SERIALIZED_BYTES];
    fmi2Component component = new_slave(), other = new_slave();
    initialize(component);
    step_by(&fmi2, component, 11.0);
    ramp(component, "hip.external_torque", 1e-3);
    ramp(component, "ground.friction", -1e-2);
    const size_t size = save_bytes(&fmi2, component, bytes[0]);
    assert_int_equal(restore_bytes(&fmi2, other, bytes[0], size), FMI_OK);
    step_by(&fmi2, component, 9.0);
    step_by(&fmi2, other, 9.0);
    assert_true(get_real(other, "hip.external_torque") != 0.0 && get_real(other, "ground.friction") < 0.6);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i) {
        assert_true(get_real(other, names[i]) == get_real(component, names[i]));
    }
    assert_int_equal(save_bytes(&fmi2, component, bytes[0]), size);
    assert_int_equal(save_bytes(&fmi2, other, bytes[1]), size);
    assert_memory_equal(bytes[0], bytes[1], size);
    fmi2FreeInstance(component);
    fmi2FreeInstance(other);
}

/* A rate set since is forgotten with the rest. */
TEST(restoring_undoes_rates) {
    unsigned char bytes[2][SERIALIZED_BYTES];
    fmi2FMUstate saved = NULL;
    fmi2Component component = new_slave();
    initialize(component);
    step_by(&fmi2, component, 13.0);
    assert_int_equal(fmi2GetFMUstate(component, &saved), fmi2OK);
    const size_t size = save_bytes(&fmi2, component, bytes[0]);
    ramp(component, "hip.external_torque", 1e-3);
    step_by(&fmi2, component, 5.0);
    assert_int_equal(fmi2SetFMUstate(component, saved), fmi2OK);
    assert_int_equal(save_bytes(&fmi2, component, bytes[1]), size);
    assert_memory_equal(bytes[0], bytes[1], size);
    assert_int_equal(fmi2FreeFMUstate(component, &saved), fmi2OK);
    fmi2FreeInstance(component);
}
