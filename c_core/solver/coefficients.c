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
    flight_coefficients varied =
        tdmf_vary_flight_coefficients_in(equations->model, &equations->inputs, mode, equations->place_time,
                                         &d->model, &d->inputs, &d->mode, d->state[TDMF_HIP_PLACE_TIME]);
    if (tdmf_clamp_has_no_derivative(equations->model, mode, d)) {
        varied.gain = NAN;
    }
    return varied;
}

ground_coefficients tdmf_ground_coefficients(const tdmf_mode_equations *equations) {
    const tdmf_ground_line *ground = &equations->ground;
    const tdmf_vector push_rate = equations->push_rate;
    ground_coefficients coefficients = tdmf_ground_coefficients_of(
        equations->model, ground, &equations->law, equations->rest_length, equations->push,
        equations->friction, equations->friction_excess, equations->friction_fading);
    coefficients.friction_rate = equations->friction_rate;
    coefficients.gravity_x_rate = -tdmf_velocity_along(ground, push_rate.x, push_rate.y);
    coefficients.gravity_y_rate = -tdmf_velocity_off(ground, push_rate.x, push_rate.y);
    coefficients.rest_length_rate = equations->rest_length_rate;
    return coefficients;
}

ground_coefficients tdmf_vary_ground_coefficients(const tdmf_mode_equations *equations, const tdmf_mode *mode,
                                                  const tdmf_local_seed *d) {
    const double sign = tdmf_sign_of_slip(mode);
    ground_coefficients varied = tdmf_vary_ground_coefficients_in(
        equations->model, &equations->inputs, mode, sign, equations->falls, &d->model, &d->inputs, &d->mode);
    if (sign != 0.0 && tdmf_friction_has_no_derivative(equations->model, d)) {
        varied.friction = NAN;
    }
    return varied;
}
