/* The impact map: whether it sticks is decided here, the rest by equations/impact.py. */
#include "impact.h"

#include "friction.h"
#include "ground_line.h"
#include "impact_laws.h"

#include <math.h>

/* An impact is told apart by where the foot lands, the side to which it slips, and whether friction holds it.
 */
typedef struct {
    tdmf_zone zone;
    double sign;
    bool sticks;
} impact_kind;

static impact_kind kind_of(tdmf_system system, const tdmf_ground_line *ground,
                           const double state[TDMF_STATE_COUNT]) {
    const double along = tdmf_velocity_along(ground, state[TDMF_FOOT_VX], state[TDMF_FOOT_VY]);
    const double off = tdmf_velocity_off(ground, state[TDMF_FOOT_VX], state[TDMF_FOOT_VY]);
    const tdmf_zone zone = tdmf_zone_towards(system.model, state[TDMF_FOOT_X], along);
    const double stopped =
        tdmf_stopped_speed(system.model, system.inputs, zone, fabs(off), tdmf_friction_falls(system.model));
    const impact_kind kind = {zone, copysign(1.0, along), fabs(along) <= stopped};
    return kind;
}

/* Writes what an impact leaves of the state, or of a change of it. */
static double write_after(const tdmf_after_impact *after, double state[TDMF_STATE_COUNT]) {
    state[TDMF_FOOT_X] = after->foot_x;
    state[TDMF_FOOT_Y] = after->foot_y;
    state[TDMF_FOOT_VX] = after->foot_vx;
    state[TDMF_FOOT_VY] = after->foot_vy;
    state[TDMF_LEG_LENGTH_RATE] = after->leg_length_rate;
    state[TDMF_LEG_ANGLE_RATE] = after->leg_angle_rate;
    return after->loss;
}

double tdmf_impact_along(tdmf_system system, const tdmf_ground_line *ground, tdmf_leg_direction direction,
                         double state[TDMF_STATE_COUNT]) {
    const impact_kind kind = kind_of(system, ground, state);
    const tdmf_after_impact after =
        tdmf_impact_with(system.model, system.inputs, kind.zone, ground, state, direction, kind.sign,
                         kind.sticks, tdmf_friction_falls(system.model));
    return write_after(&after, state);
}

double tdmf_impact(tdmf_system system, const tdmf_ground_line *ground, double state[TDMF_STATE_COUNT]) {
    return tdmf_impact_along(system, ground, tdmf_leg_direction_of(state), state);
}

double tdmf_vary_impact(tdmf_system system, const tdmf_ground_line *ground,
                        const double before[TDMF_STATE_COUNT], const tdmf_local_seed *d,
                        double d_state[TDMF_STATE_COUNT]) {
    const impact_kind kind = kind_of(system, ground, before);
    const tdmf_after_impact d_after = tdmf_vary_impact_with(
        system.model, system.inputs, kind.zone, ground, before, tdmf_leg_direction_of(before), kind.sign,
        kind.sticks, tdmf_friction_falls(system.model), &d->model, &d->inputs, &d->mode.ground, d_state);
    return write_after(&d_after, d_state);
}
