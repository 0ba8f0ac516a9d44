/* Flight: with M = 1/m + 1/m_f and the centre of mass ballistic,
 *
 *     rddot = r thetadot^2 + M F_s,      r thetaddot = M tau/r - 2 rdot thetadot.
 *
 * Ground: the equations of model/dynamics.c with y = vy = ay = 0. */
#ifndef TDMF_SOLVER_CHART_SLOPE_H
#define TDMF_SOLVER_CHART_SLOPE_H

#include "chart.h"

#include <math.h>

static inline double axial_force(const tdmf_chart *chart, const double z[CHART_COUNT]) {
    const tdmf_parameters *p = &chart->model->parameters;
    return p->leg.stiffness * (p->leg.free_length - z[CHART_LEG_LENGTH]) -
           p->leg.damping * z[CHART_LEG_LENGTH_RATE];
}

static inline void slope_in_flight(const tdmf_chart *chart, double elapsed, const double z[CHART_COUNT],
                                   double slope[CHART_COUNT]) {
    const tdmf_model *model = chart->model;
    const double both = model->inverse_body_mass + model->inverse_foot_mass;
    const double r = z[CHART_LEG_LENGTH];
    const double length_rate = z[CHART_LEG_LENGTH_RATE];
    const double angle_rate = z[CHART_LEG_ANGLE_RATE];
    const double inverse_length = 1.0 / fmax(r, chart->leg_floor);
    const double torque = chart->torque + elapsed * chart->torque_rate +
                          chart->angle_gain * (chart->angle_target - z[CHART_LEG_ANGLE]) -
                          chart->rate_gain * angle_rate;
    slope[CHART_LEG_LENGTH] = length_rate;
    slope[CHART_LEG_ANGLE] = angle_rate;
    slope[CHART_LEG_LENGTH_RATE] = r * angle_rate * angle_rate + both * axial_force(chart, z);
    slope[CHART_LEG_ANGLE_RATE] =
        (both * torque * inverse_length - 2.0 * length_rate * angle_rate) * inverse_length;
    slope[CHART_HIP_WORK] = torque * angle_rate;
    slope[CHART_DAMPER_LOSS] = model->parameters.leg.damping * length_rate * length_rate;
}

/* tau/r on the ground; graze takes what keeps the foot there, its sine kept off zero as in model/graze.c. */
static inline double torque_over_length(const tdmf_chart *chart, double elapsed, double press, double sine,
                                        double inverse_length) {
    if (chart->grazes) {
        return press / copysign(fmax(fabs(sine), 1e-12), sine);
    }
    return (chart->torque + elapsed * chart->torque_rate) * inverse_length;
}

static inline void slope_on_ground(const tdmf_chart *chart, double elapsed, const double z[CHART_COUNT],
                                   double slope[CHART_COUNT]) {
    const tdmf_model *model = chart->model;
    const double g = model->parameters.gravity;
    const double r = z[CHART_LEG_LENGTH];
    const double length_rate = z[CHART_LEG_LENGTH_RATE];
    const double angle_rate = z[CHART_LEG_ANGLE_RATE];
    const double sine = sin(z[CHART_LEG_ANGLE]);
    const double cosine = cos(z[CHART_LEG_ANGLE]);
    const double length = fmax(r, chart->leg_floor);
    const double inverse_length = 1.0 / length;
    const double along = axial_force(chart, z);
    const double press = along * cosine + chart->foot_weight;
    const double across = torque_over_length(chart, elapsed, press, sine, inverse_length);
    const double friction =
        (chart->signed_friction + elapsed * chart->signed_friction_rate) * (press - across * sine);
    const double ax =
        chart->foot_is_free * (along * sine + across * cosine - friction) * model->inverse_foot_mass;

    slope[CHART_LEG_LENGTH] = length_rate;
    slope[CHART_LEG_ANGLE] = angle_rate;
    slope[CHART_LEG_LENGTH_RATE] =
        r * angle_rate * angle_rate + along * model->inverse_body_mass - g * cosine + ax * sine;
    slope[CHART_LEG_ANGLE_RATE] =
        (across * model->inverse_body_mass + g * sine + ax * cosine - 2.0 * length_rate * angle_rate) *
        inverse_length;
    slope[CHART_HIP_WORK] = across * length * angle_rate;
    slope[CHART_DAMPER_LOSS] = model->parameters.leg.damping * length_rate * length_rate;
    slope[CHART_FOOT_X] = z[CHART_FOOT_VX];
    slope[CHART_FOOT_VX] = ax;
    slope[CHART_FRICTION_LOSS] = friction * z[CHART_FOOT_VX];
    slope[CHART_UNUSED] = 0.0;
}

static inline void chart_slope(const tdmf_chart *chart, double elapsed, const double z[CHART_COUNT],
                               double slope[CHART_COUNT]) {
    if (chart->in_flight) {
        slope_in_flight(chart, elapsed, z, slope);
    } else {
        slope_on_ground(chart, elapsed, z, slope);
    }
}

#endif
