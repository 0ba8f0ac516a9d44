/* The units of either version with the clamp of (12) and without: hip.swing_clamp, a fixed Boolean. */
#include "variables.h" /* before cmocka, which takes a name of it for a macro */

#include "compare.h"
#include "fmi_interface.h"
#include "reference_gaits.h"
#include "tdmf_slip/cvode.h"

#include <string.h>

static uint32_t clamp_reference(void) {
    return reference_of("hip.swing_clamp");
}

static void set_clamp(const fmi_interface *fmi, void *instance, bool clamp) {
    assert_int_equal(fmi->set_truth(instance, clamp_reference(), clamp), FMI_OK);
}

/* A rising runner whose leg is behind and swings forward, so that the servo pulls the leg back. */
static void *new_rising(const fmi_interface *fmi, fmi_kind kind, bool clamp) {
    void *instance = new_of_kind(fmi, kind);
    set_clamp(fmi, instance, clamp);
    set_values(fmi, instance, "foot.y=1.0 foot.vy=0.3 leg.angle=-0.6 leg.angle_rate=0.5");
    begin(fmi, instance, kind);
    assert_int_equal(integer_of(fmi, instance, "hip.phase_index"), TDMF_PHASE_RETRACT);
    return instance;
}

/* ---- as a variable ------------------------------------------------------------------------------------- */

FMI_TEST(it_is_set_before_the_start_and_never_after) {
    for (fmi_kind kind = EXCHANGE; kind < fmi->kinds; ++kind) {
        for (int clamp = 0; clamp < 2; ++clamp) {
            void *instance = new_of_kind(fmi, kind);
            assert_true(truth_of(fmi, instance, "hip.swing_clamp") ==
                        tdmf_default_parameters().hip.swing_clamp);
            set_clamp(fmi, instance, clamp == 1);
            begin(fmi, instance, kind);
            assert_int_equal(fmi->set_truth(instance, clamp_reference(), clamp == 0), FMI_ERROR);
            assert_true(truth_of(fmi, instance, "hip.swing_clamp") == (clamp == 1));
        }
    }
}

/* ---- strides ------------------------------------------------------------------------------------------- */

static void assert_stride(const fmi_interface *fmi, const reference_gait *gait, int method,
                          double tolerance) {
    const tdmf_model model = table_1(gait->swing_clamp);
    void *instance = new_of_kind(fmi, STEPS);
    set_apex(fmi, instance, &model, gait->friction, (const double *)&gait->apex);
    assert_int_equal(fmi->set_item(instance, reference_of("solver.method"), method), FMI_OK);
    set_values(fmi, instance, "solver.relative_tolerance=1e-12");
    begin(fmi, instance, STEPS);
    step_by(fmi, instance, gait->period + 0.1);
    assert_int_equal(integer_of(fmi, instance, "stride.count"), 1);
    assert_relatively_close(value_of(fmi, instance, "stride.period"), gait->period, tolerance);
    assert_relatively_close(value_of(fmi, instance, "stride.speed"), gait->speed, tolerance);
    assert_relatively_close(value_of(fmi, instance, "stride.work"), gait->work, tolerance);
    assert_close(value_of(fmi, instance, "apex.leg_angle"), gait->apex.leg_angle, tolerance);
}

FMI_TEST(strides_are_those_of_the_reference) {
    for (int i = 0; i < REFERENCE_GAITS; ++i) {
        assert_stride(fmi, &reference_gaits[i], SOLVER_NATIVE, 1e-10);
        if (tdmf_cvode_is_available()) {
            assert_stride(fmi, &reference_gaits[i], SOLVER_CVODE, 1e-7);
        }
    }
}

/* ---- torque, indicator, derivatives -------------------------------------------------------------------- */

FMI_TEST(without_it_the_indicator_is_constant_and_the_servo_pulls) {
    for (int clamp = 0; clamp < 2; ++clamp) {
        double indicators[TDMF_GUARD_COUNT], states[CONTINUOUS_STATES];
        void *instance = new_rising(fmi, EXCHANGE, clamp == 1);
        const double servo = -0.1 * (-0.6 + 1.2 * 0.6) - 0.1 * 0.5;
        assert_close(value_of(fmi, instance, "hip.torque"), clamp == 1 ? 0.0 : servo, 1e-15);
        assert_int_equal(fmi->get_states(instance, states, CONTINUOUS_STATES), FMI_OK);
        for (int i = 0; i < 20; ++i) {
            assert_int_equal(fmi->get_indicators(instance, indicators, TDMF_GUARD_COUNT), FMI_OK);
            assert_true((indicators[TDMF_GUARD_CLAMP] == 1.0) == (clamp == 0));
            assert_true(value_of(fmi, instance, "guard.clamp") == indicators[TDMF_GUARD_CLAMP]);
            states[STATE_LEG_ANGLE_RATE] -= 0.1; /* through the zero of the servo's torque */
            assert_int_equal(fmi->set_states(instance, states, CONTINUOUS_STATES), FMI_OK);
        }
    }
}

FMI_TEST(without_it_derivatives_are_those_of_the_servo) {
    static const struct {
        const char *known;
        double of_torque;
    } columns[] = {{"leg.angle", -0.1},
                   {"leg.angle_rate", -0.1},
                   {"hip.kp", -0.12},
                   {"hip.kd", -0.5},
                   {"hip.liftoff_angle_factor", -0.06},
                   {"hip.external_torque", 1.0}};
    const uint32_t torque = reference_of("hip.torque");
    for (int clamp = 0; clamp < 2; ++clamp) {
        void *instance = new_rising(fmi, EXCHANGE, clamp == 1);
        for (size_t i = 0; i < COUNT_OF(columns); ++i) {
            const bool outside = strcmp(columns[i].known, "hip.external_torque") == 0;
            const double derivative = derivative_of(fmi, instance, torque, reference_of(columns[i].known));
            assert_close(derivative, clamp == 0 || outside ? columns[i].of_torque : 0.0, 1e-15);
        }
    }
}
