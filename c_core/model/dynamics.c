/* The right-hand side as the world asks for it; equations/dynamics.py has the laws. */
#include "dynamics.h"

#include "dynamics_laws.h"
#include "input_rates.h"
#include "ranges.h"

#include <string.h>

void tdmf_derivatives(tdmf_system system, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                      double derivatives[TDMF_STATE_COUNT]) {
    if (mode->fallen) {
        memset(derivatives, 0, TDMF_STATE_COUNT * sizeof *derivatives);
        return;
    }
    double rates[TDMF_STATE_COUNT];
    const tdmf_evaluation at = tdmf_evaluate(system, mode, state);
    tdmf_rates_at(&at, tdmf_is_pushed(system.inputs) ? tdmf_external_power(&at) : 0.0, rates);
    memcpy(derivatives, rates, sizeof rates);
}

void tdmf_state_scales(const tdmf_model *model, double scales[TDMF_STATE_COUNT]) {
    const tdmf_scales *units = &model->scales;
    const double of_quantity[TDMF_QUANTITY_COUNT] = {
        [TDMF_QUANTITY_LENGTH] = units->length,  [TDMF_QUANTITY_ANGLE] = 1.0,
        [TDMF_QUANTITY_VELOCITY] = units->speed, [TDMF_QUANTITY_ANGULAR_VELOCITY] = 1.0 / units->time,
        [TDMF_QUANTITY_TIME] = units->time,      [TDMF_QUANTITY_TORQUE] = units->energy,
        [TDMF_QUANTITY_ENERGY] = units->energy,
    };
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        scales[i] = of_quantity[tdmf_state_quantities[i]];
    }
    if (tdmf_friction_falls(model)) {
        const double layer = model->parameters.ground.stribeck_velocity;
        scales[TDMF_FOOT_VX] = layer < units->speed ? layer : units->speed;
    }
}

/* No force depends on the work done. */
tdmf_ground_force tdmf_force_rate(const tdmf_evaluation *at) {
    double rates[TDMF_STATE_COUNT];
    tdmf_rates_at(at, 0.0, rates);
    return tdmf_vary_evaluation(at, &tdmf_no_seed, rates).force;
}

double tdmf_ground_force_rate(tdmf_system system, const tdmf_mode *mode,
                              const double state[TDMF_STATE_COUNT]) {
    const tdmf_evaluation at = tdmf_evaluate(system, mode, state);
    return tdmf_force_rate(&at).normal;
}
