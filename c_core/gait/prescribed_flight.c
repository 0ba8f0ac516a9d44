/* With t the time since the apex, phi = theta0 - omega t the leg's angle and s = m/(m + m_f), the foot and
 * the body are at the heights above a ground of slope sigma
 *
 *     d = d_c - s r cos(phi - sigma),      d_m = d_c + (1 - s) r cos(phi - sigma),
 *
 * d_c being that of the ballistic centre of mass: both are a parabola less a swing A cos(phi). */
#include "prescribed_flight.h"

#include "free_fall.h"
#include "ground_line.h"
#include "prescribed_flight_laws.h"
#include "swinging_height.h"

#include <math.h>
#include <string.h>

/* ---- the centre of mass ------------------------------------------------------------------------------- */

static tdmf_vector acceleration_of(tdmf_system system) {
    return tdmf_com_acceleration(system.model, tdmf_push_on_body(system.model, system.inputs));
}

static tdmf_vector vary_acceleration(tdmf_system system, const tdmf_local_seed *d) {
    return tdmf_vary_com_acceleration(
        system.model, tdmf_push_on_body(system.model, system.inputs), &d->model,
        tdmf_vary_push_on_body(system.model, system.inputs, &d->model, &d->inputs));
}

static const tdmf_vector steady = {0.0, 0.0};

tdmf_point tdmf_vary_ballistic(tdmf_system system, const tdmf_local_seed *d, tdmf_point from,
                               tdmf_point d_from, double t, double d_time) {
    return tdmf_vary_ballistic_after(from, acceleration_of(system), steady, t, d_from,
                                     vary_acceleration(system, d), steady, d_time);
}

double tdmf_time_to_apex(tdmf_system system, tdmf_point from) {
    const tdmf_vector a = acceleration_of(system);
    return a.y < 0.0 ? tdmf_rise_time(from, a) : INFINITY;
}

double tdmf_vary_time_to_apex(tdmf_system system, const tdmf_local_seed *d, tdmf_point from,
                              tdmf_point d_from) {
    return tdmf_vary_rise_time(from, acceleration_of(system), d_from, vary_acceleration(system, d));
}

/* ---- the leg ------------------------------------------------------------------------------------------ */

void tdmf_prescribed_state(tdmf_system system, tdmf_point apex, double time, double state[TDMF_STATE_COUNT]) {
    tdmf_placed_leg(system.model, system.inputs, time, state);
    const tdmf_point center = tdmf_center_of_mass_after(system, apex, time);
    tdmf_set_foot(tdmf_foot_below(system.model, center, state, tdmf_leg_direction_of(state)), state);
}

void tdmf_prescribed_derivatives(tdmf_system system, const double state[TDMF_STATE_COUNT],
                                 double derivatives[TDMF_STATE_COUNT]) {
    memset(derivatives, 0, TDMF_STATE_COUNT * sizeof *derivatives);
    tdmf_prescribed_rates(system.model, state, tdmf_leg_direction_of(state), acceleration_of(system),
                          derivatives);
}

void tdmf_vary_prescribed_state(tdmf_system system, const tdmf_local_seed *d, tdmf_point apex,
                                tdmf_point d_apex, double time, const double state[TDMF_STATE_COUNT],
                                double d_state[TDMF_STATE_COUNT]) {
    memset(d_state, 0, TDMF_STATE_COUNT * sizeof *d_state);
    tdmf_vary_placed_leg(system.model, system.inputs, time, &d->model, &d->inputs, 0.0, d_state);
    const tdmf_point center = tdmf_center_of_mass_after(system, apex, time);
    const tdmf_point d_center = tdmf_vary_ballistic(system, d, apex, d_apex, time, 0.0);
    tdmf_set_foot(tdmf_vary_foot_below(system.model, center, state, tdmf_leg_direction_of(state), &d->model,
                                       d_center, d_state),
                  d_state);
}

/* ---- the way down ------------------------------------------------------------------------------------- */

/* The lowest that the leg's direction can point in the descent is at one of its ends, or straight down. */
static bool body_may_come_first(const tdmf_swinging_height *foot, double time) {
    const double right_angle = 1.57;
    return fabs(foot->angle) > right_angle || fabs(foot->angle - foot->turning * time) > right_angle;
}

tdmf_descent tdmf_descend(tdmf_system system, const tdmf_ground_line *ground, tdmf_point apex) {
    double apex_leg[TDMF_STATE_COUNT];
    tdmf_placed_leg(system.model, system.inputs, 0.0, apex_leg);
    const double length = apex_leg[TDMF_LEG_LENGTH];
    const tdmf_vector a = acceleration_of(system);
    tdmf_swinging_height foot = {
        tdmf_height_over(ground, apex.x, apex.y), tdmf_velocity_off(ground, apex.vx, apex.vy),
        tdmf_velocity_off(ground, a.x, a.y),      system.model->body_share * length,
        apex_leg[TDMF_LEG_ANGLE] - ground->slope, system.model->parameters.hip.retraction_rate};
    tdmf_swinging_height body = foot;
    body.swing = foot.swing - length;
    tdmf_descent descent = {INFINITY, false};
    if (foot.curvature < 0.0) {
        descent.time = tdmf_first_zero(&foot);
        if (body_may_come_first(&foot, descent.time)) {
            const double body_down = tdmf_first_zero(&body);
            descent.body_first = body_down <= descent.time;
            descent.time = descent.body_first ? body_down : descent.time;
        }
    }
    return descent;
}
