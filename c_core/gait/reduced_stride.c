/* Flight, impact and apex of the reduced map. */
#include "reduced_stride.h"

#include "event_declarations.h"
#include "greatest_compression.h"
#include "ground_line.h"
#include "instant.h"
#include "prescribed_flight.h"
#include "prescribed_flight_laws.h"
#include "tdmf_slip/automaton.h"

#include <math.h>
#include <string.h>

/* The state at an apex, integrals zero. */
static void write_apex(tdmf_system system, tdmf_point apex, double state[TDMF_STATE_COUNT]) {
    tdmf_prescribed_state(system.model, system.inputs, apex, 0.0, state);
    /* The leg begins to turn at the apex. Here it is at rest, so that no rounding moves the centre of mass.
     */
    state[TDMF_LEG_ANGLE_RATE] = 0.0;
    state[TDMF_FOOT_VX] = apex.vx;
    state[TDMF_FOOT_VY] = 0.0;
}

static tdmf_run run_of(tdmf_system system, tdmf_motion *motion) {
    const tdmf_run run = {system, motion, tdmf_leg_direction_of(motion->state)};
    return run;
}

/* In flight the external force works on the way of the centre of mass. */
static void push_along(const tdmf_inputs *inputs, tdmf_point from, tdmf_motion *motion, tdmf_point to) {
    motion->state[TDMF_ENERGY_EXTERNAL_WORK] +=
        inputs->body.external_fx * (to.x - from.x) + inputs->body.external_fy * (to.y - from.y);
}

static void move_time(tdmf_motion *motion, double elapsed) {
    motion->record.progress.now = tdmf_instant_after(motion->record.progress.now, elapsed);
    motion->time = motion->record.progress.now.time;
}

tdmf_return_outcome tdmf_reduced_begin(tdmf_system system, const double apex[TDMF_REDUCED_COUNT],
                                       tdmf_motion *motion) {
    const tdmf_ground_line ground = tdmf_ground_line_set(system.inputs);
    memset(motion, 0, sizeof *motion);
    tdmf_reduced_state(system, apex, motion->state);
    if (tdmf_foot_over_ground(&ground, motion->state).y <= 0.0) {
        return TDMF_RETURN_NO_START;
    }
    if (tdmf_start(system, motion).variable != NULL || !motion->record.progress.open.began_at_apex) {
        return TDMF_RETURN_REFUSED;
    }
    return TDMF_RETURN_CLOSED;
}

void tdmf_reduced_reset_leg(tdmf_system system, tdmf_motion *motion) {
    write_apex(system, tdmf_center_of_mass(system.model, motion->state), motion->state);
    motion->mode.ground = tdmf_ground_line_set(system.inputs);
    motion->mode.rest_length = tdmf_rest_length(system.model, system.inputs, &motion->mode);
}

tdmf_return_outcome tdmf_reduced_touch_down(tdmf_system system, double until, tdmf_motion *motion) {
    const tdmf_ground_line *ground = &motion->mode.ground;
    const tdmf_point apex = tdmf_center_of_mass(system.model, motion->state);
    if (tdmf_foot_over_ground(ground, motion->state).y <= 0.0) {
        return TDMF_RETURN_NO_START;
    }
    const tdmf_descent descent = tdmf_descend(system, ground, apex);
    if (!(descent.time <= until) || isinf(descent.time)) {
        return TDMF_RETURN_NO_TOUCHDOWN;
    }
    move_time(motion, descent.time);
    push_along(system.inputs, apex, motion, tdmf_center_of_mass_after(system, apex, descent.time));
    tdmf_prescribed_state(system.model, system.inputs, apex, descent.time, motion->state);
    if (descent.body_first) {
        return TDMF_RETURN_FELL;
    }
    tdmf_lift_to_ground(ground, motion->state); /* up to rounding it is there */
    tdmf_run run = run_of(system, motion);
    tdmf_take_touchdown(&run);
    tdmf_resolve_along(system, motion, run.direction, TDMF_GUARD_COUNT);
    return tdmf_in_contact(&motion->mode) ? TDMF_RETURN_CLOSED : TDMF_RETURN_NO_STANCE;
}

tdmf_return_outcome tdmf_reduced_fly(tdmf_system system, tdmf_motion *motion) {
    const tdmf_point lift_off = tdmf_center_of_mass(system.model, motion->state);
    tdmf_run standing = run_of(system, motion);
    tdmf_end_thrust(&standing);
    const double time = tdmf_rise_time(system.model, system.inputs, lift_off);
    if (!(lift_off.vy > 0.0) || !(time > 0.0) || isinf(time)) {
        return TDMF_RETURN_NO_APEX;
    }
    tdmf_point apex = tdmf_center_of_mass_after(system, lift_off, time);
    apex.vy = 0.0;
    push_along(system.inputs, lift_off, motion, apex);
    write_apex(system, apex, motion->state);
    move_time(motion, time);
    motion->mode.contact = TDMF_CONTACT_FLIGHT; /* also where the full model would graze */
    tdmf_run run = run_of(system, motion);
    motion->mode.rises = true;
    tdmf_take_apex(&run);
    return TDMF_RETURN_CLOSED;
}
