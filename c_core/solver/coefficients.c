/* The coefficients of the two motions, made of the model's constants and laws by equations/constants.py. */
#include "coefficients.h"

#include "constant_laws.h"
#include "friction.h"
#include "ground_line_laws.h"

#include <math.h>

flight_coefficients tdmf_flight_coefficients(const tdmf_mode_equations *equations) {
    flight_coefficients coefficients = tdmf_flight_coefficients_of(equations->model, &equations->law,
                                                                   equations->rest_length, equations->push);
    coefficients.rest_length_rate = equations->rest_length_rate;
    coefficients.push_x_rate = equations->push_rate.x;
    coefficients.push_y_rate = equations->push_rate.y;
    return coefficients;
}

flight_coefficients tdmf_vary_flight_coefficients(const tdmf_mode_equations *equations, const tdmf_mode *mode,
                                                  const tdmf_local_seed *d) {
    const tdmf_model *model = equations->model;
    const tdmf_inputs *inputs = &equations->inputs;
    const tdmf_hip_law d_law =
        tdmf_vary_flight_law(model, inputs, &tdmf_zero_input_rates, mode, equations->place_time, &d->model,
                             &d->inputs, &tdmf_zero_input_rates, &d->mode, d->state[TDMF_HIP_PLACE_TIME]);
    flight_coefficients varied = tdmf_vary_flight_coefficients_of(
        model, &equations->law, equations->rest_length, equations->push, &d->model, &d_law,
        tdmf_vary_rest_length(model, inputs, mode, &d->model, &d->inputs, &d->mode),
        tdmf_vary_push(equations, d));
    if (tdmf_clamp_has_no_derivative(model, mode, d)) {
        varied.gain = NAN;
    }
    return varied;
}

ground_coefficients tdmf_ground_coefficients(const tdmf_mode_equations *equations) {
    const tdmf_ground_line *ground = &equations->ground;
    ground_coefficients coefficients = tdmf_ground_coefficients_of(
        equations->model, ground, &equations->law, equations->rest_length, equations->push,
        equations->friction, equations->friction_excess, equations->friction_fading);
    coefficients.friction_rate = equations->friction_rate;
    coefficients.gravity_x_rate = -tdmf_acceleration_along(ground, equations->push_rate);
    coefficients.gravity_y_rate = -tdmf_acceleration_off(ground, equations->push_rate);
    coefficients.rest_length_rate = equations->rest_length_rate;
    return coefficients;
}

/* Varies the law of stance, or in graze the torque from outside. */
static tdmf_hip_law vary_law_on_ground(const tdmf_mode_equations *equations, const tdmf_mode *mode,
                                       const tdmf_local_seed *d) {
    const tdmf_inputs *inputs = &equations->inputs, *zero = &tdmf_zero_input_rates;
    return tdmf_in_contact(mode) ? tdmf_vary_stance_law(equations->model, inputs, zero, mode, &d->model,
                                                        &d->inputs, zero, &d->mode)
                                 : tdmf_vary_external_law(inputs, zero, &d->inputs, zero);
}

ground_coefficients tdmf_vary_ground_coefficients(const tdmf_mode_equations *equations, const tdmf_mode *mode,
                                                  const tdmf_local_seed *d) {
    const tdmf_model *model = equations->model;
    const tdmf_inputs *inputs = &equations->inputs;
    const tdmf_hip_law d_law = vary_law_on_ground(equations, mode, d);
    const double sign = tdmf_sign_of_slip(mode);
    const double d_excess = equations->falls ? tdmf_vary_friction_excess(model, &d->model) : 0.0;
    const double d_fading = equations->falls ? tdmf_vary_friction_fading(model, sign, &d->model) : 0.0;
    ground_coefficients varied = tdmf_vary_ground_coefficients_of(
        model, &equations->ground, &equations->law, equations->rest_length, equations->push,
        equations->friction, equations->friction_excess, equations->friction_fading, &d->model,
        &d->mode.ground, &d_law, tdmf_vary_rest_length(model, inputs, mode, &d->model, &d->inputs, &d->mode),
        tdmf_vary_push(equations, d),
        tdmf_vary_signed_friction(model, inputs, mode->zone, sign, &d->model, &d->inputs), d_excess,
        d_fading);
    if (sign != 0.0 && tdmf_friction_has_no_derivative(model, d)) {
        varied.friction = NAN;
    }
    return varied;
}
