/* With t the time since the apex, phi = theta0 - omega t the leg's angle and s = m/(m + m_f), the foot and
 * the body are at the heights above a ground of slope sigma
 *
 *     d = d_c - s r cos(phi - sigma),      d_m = d_c + (1 - s) r cos(phi - sigma),
 *
 * d_c being that of the ballistic centre of mass: both are a parabola less a swing A cos(phi). */
#include "prescribed_flight.h"

#include "free_fall_laws.h"
#include "ground_line.h"
#include "prescribed_flight_laws.h"
#include "swinging_height.h"

#include <math.h>

/* The lowest that the leg's direction can point in the descent is at one of its ends, or straight down. */
static bool body_may_come_first(const tdmf_swinging_height *foot, double time) {
    const double right_angle = 1.57;
    return fabs(foot->angle) > right_angle || fabs(foot->angle - foot->turning * time) > right_angle;
}

tdmf_descent tdmf_descend(tdmf_system system, const tdmf_ground_line *ground, tdmf_point apex) {
    double start[TDMF_STATE_COUNT];
    tdmf_prescribed_state(system.model, system.inputs, apex, 0.0, start);
    const double length = start[TDMF_LEG_LENGTH];
    const tdmf_vector a = tdmf_falling_acceleration(system.model, system.inputs);
    tdmf_swinging_height foot = {
        tdmf_height_over(ground, apex.x, apex.y), tdmf_velocity_off(ground, apex.vx, apex.vy),
        tdmf_velocity_off(ground, a.x, a.y),      system.model->body_share * length,
        start[TDMF_LEG_ANGLE] - ground->slope,    system.model->parameters.hip.retraction_rate};
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
