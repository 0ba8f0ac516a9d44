/* The coefficients of the two motions, made of the model's constants and laws. */
#include "coefficients.h"

#include "friction.h"
#include "ground_force.h"
#include "input_rates.h"

#include <math.h>

/* The leg's and the hip's law by the mobility M: linear in either, so that the variation is made of the same
 * products. */
static flight_coefficients times_mobility(double mobility, const tdmf_parameters *p, double rest_length,
                                          const tdmf_hip_law *law) {
    const flight_coefficients coefficients = {
        .mobility = mobility,
        .stiffness = mobility * p->leg.stiffness,
        .damping = mobility * p->leg.damping,
        .rest_length = rest_length,
        .gain = mobility * law->gain,
        .rate_gain = mobility * law->rate_gain,
        .target = law->target,
        .torque = mobility * law->torque,
        .torque_rate = mobility * tdmf_law_drift(law),
    };
    return coefficients;
}

flight_coefficients tdmf_flight_coefficients(const tdmf_mode_equations *equations) {
    return times_mobility(equations->model->mobility, &equations->model->parameters, equations->rest_length,
                          &equations->law);
}

flight_coefficients tdmf_vary_flight_coefficients(const tdmf_mode_equations *equations, const tdmf_mode *mode,
                                                  const tdmf_direction *d) {
    const tdmf_model *model = equations->model;
    const tdmf_hip_law d_law = tdmf_vary_flight_law(model, mode, equations->place_time, d);
    const flight_coefficients by_mobility =
        times_mobility(d->model.mobility, &model->parameters, equations->rest_length, &equations->law);
    flight_coefficients varied = times_mobility(model->mobility, &d->model.parameters,
                                                tdmf_vary_rest_length(false, &d->model, &d->inputs), &d_law);
    varied.mobility = d->model.mobility;
    varied.stiffness += by_mobility.stiffness;
    varied.damping += by_mobility.damping;
    varied.gain += by_mobility.gain;
    varied.rate_gain += by_mobility.rate_gain;
    varied.torque += by_mobility.torque;
    varied.torque_rate =
        by_mobility.torque_rate + model->mobility * tdmf_vary_law_drift(&equations->law, &d_law);
    if (tdmf_clamp_has_no_derivative(model, mode, d)) {
        varied.gain = NAN;
    }
    return varied;
}

flight_forcing tdmf_flight_forcing(const tdmf_mode_equations *equations) {
    const flight_forcing forcing = {.push_x = equations->push.x,
                                    .push_y = equations->push.y,
                                    .push_x_rate = equations->push_rate.x,
                                    .push_y_rate = equations->push_rate.y,
                                    .rest_length_rate = equations->rest_length_rate};
    return forcing;
}

flight_forcing tdmf_vary_flight_forcing(const tdmf_mode_equations *equations, const tdmf_direction *d) {
    const tdmf_fall d_push = tdmf_vary_push(equations, d);
    const flight_forcing varied = {.push_x = d_push.x, .push_y = d_push.y};
    return varied;
}

ground_coefficients tdmf_ground_coefficients(const tdmf_mode_equations *equations) {
    const tdmf_model *model = equations->model;
    const tdmf_parameters *p = &model->parameters;
    const tdmf_fall fall = tdmf_fall_of_body(model, equations->push);
    const ground_coefficients coefficients = {
        .stiffness = p->leg.stiffness,
        .damping = p->leg.damping,
        .rest_length = equations->rest_length,
        .inverse_body_mass = model->inverse_body_mass,
        .inverse_foot_mass = model->inverse_foot_mass,
        .foot_weight_x = tdmf_foot_weight(model) * equations->ground.sine,
        .foot_weight_y = tdmf_foot_weight(model) * equations->ground.cosine,
        .gravity_x = -tdmf_along_line(&equations->ground, fall),
        .gravity_y = -tdmf_off_line(&equations->ground, fall),
        .torque = equations->law.torque,
        .torque_rate = equations->law.torque_rate,
        .friction = equations->friction,
        .friction_rate = equations->friction_rate,
        .gravity_x_rate = -tdmf_along_line(&equations->ground, equations->push_rate),
        .gravity_y_rate = -tdmf_off_line(&equations->ground, equations->push_rate),
        .rest_length_rate = equations->rest_length_rate,
    };
    return coefficients;
}

ground_coefficients tdmf_vary_ground_coefficients(const tdmf_mode_equations *equations, const tdmf_mode *mode,
                                                  const tdmf_direction *d) {
    const tdmf_parameters *d_p = &d->model.parameters;
    const tdmf_hip_law d_law = tdmf_in_contact(mode) ? tdmf_vary_stance_law(mode, d)
                                                     : tdmf_external_law(&d->inputs, &tdmf_held_inputs);
    const tdmf_ground_line *ground = &equations->ground;
    const double d_slope = d->mode.ground.slope;
    const double weight = tdmf_foot_weight(equations->model);
    const double d_weight = tdmf_vary_foot_weight(equations->model, &d->model);
    const tdmf_fall fall = tdmf_fall_of_body(equations->model, equations->push);
    const tdmf_fall d_fall = tdmf_fall_of_body(&d->model, tdmf_vary_push(equations, d));
    const ground_coefficients varied = {
        .stiffness = d_p->leg.stiffness,
        .damping = d_p->leg.damping,
        .rest_length = tdmf_vary_rest_length(equations->thrust_acts, &d->model, &d->inputs),
        .inverse_body_mass = d->model.inverse_body_mass,
        .inverse_foot_mass = d->model.inverse_foot_mass,
        .foot_weight_x = d_weight * ground->sine + weight * ground->cosine * d_slope,
        .foot_weight_y = d_weight * ground->cosine - weight * ground->sine * d_slope,
        .gravity_x = -tdmf_along_line(ground, d_fall) - tdmf_off_line(ground, fall) * d_slope,
        .gravity_y = -tdmf_off_line(ground, d_fall) + tdmf_along_line(ground, fall) * d_slope,
        .torque = d_law.torque,
        .friction = tdmf_signed_friction(&d->inputs, mode),
    };
    return varied;
}
