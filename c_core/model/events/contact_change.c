/* Changes between flight, graze and contact. */
#include "contact_change.h"

#include "coordinate_laws.h"
#include "dynamics_laws.h"
#include "friction.h"
#include "graze.h"
#include "graze_laws.h"
#include "greatest_compression.h"
#include "ground_line.h"
#include "mode_change.h"
#include "record.h"

void tdmf_enter_contact_mode(tdmf_run *run, tdmf_contact_mode entered) {
    tdmf_record_contact_change(run->motion, entered);
    tdmf_set_contact(run->system.model, run->motion->state, entered, &run->motion->mode);
}

void tdmf_take_mode_change(tdmf_run *run, tdmf_guard taken) {
    const tdmf_contact_mode entered = tdmf_contact_after(&run->motion->mode, taken);
    if (entered != run->motion->mode.contact) {
        tdmf_record_contact_change(run->motion, entered);
    }
    tdmf_change_mode(run->system.model, run->motion->state, taken, &run->motion->mode);
    tdmf_record_event(run->motion);
}

/* ---- off the ground ----------------------------------------------------------------------------------- */

static double rise_rate(const tdmf_run *run) {
    return tdmf_center_of_mass_along(run->system.model, run->motion->state, run->direction).vy;
}

/* In place an apex has been passed, maybe at this instant: the centre of mass rises anew beyond the dead band
 * only. */
static bool rises_in_place(const tdmf_run *run) {
    return rise_rate(run) > TDMF_DEAD_BAND * run->system.model->scales.speed;
}

/* Once begun, place lasts until the foot is loaded; else the centre of mass decides. */
static tdmf_hip_phase phase_off_ground(const tdmf_run *run) {
    if (run->motion->mode.phase == TDMF_PHASE_PLACE) {
        return TDMF_PHASE_PLACE;
    }
    return rise_rate(run) >= 0.0 ? TDMF_PHASE_RETRACT : TDMF_PHASE_PLACE;
}

/* Enters flight or graze, theta_LO unchanged. */
static void leave_ground(tdmf_run *run, tdmf_contact_mode entered, tdmf_hip_phase phase) {
    tdmf_enter_contact_mode(run, entered);
    if (entered == TDMF_CONTACT_FLIGHT) {
        tdmf_end_thrust(run);
    }
    run->motion->mode.phase = phase;
    run->motion->mode.rises = phase == TDMF_PHASE_RETRACT || rises_in_place(run);
    run->motion->mode.clamp_closed = tdmf_has_clamp(run->system.model, &run->motion->mode) &&
                                     tdmf_servo_torque(run->system.model, run->system.inputs,
                                                       &run->motion->mode, run->motion->state) < 0.0;
}

void tdmf_fly(tdmf_run *run) {
    leave_ground(run, TDMF_CONTACT_FLIGHT, phase_off_ground(run));
}

void tdmf_fly_on(tdmf_run *run) {
    leave_ground(run, TDMF_CONTACT_FLIGHT, run->motion->mode.phase);
}

/* The mode that the foot would be in if it left now, with theta_LO latched. */
static tdmf_mode mode_off_ground(const tdmf_run *run) {
    tdmf_mode off_ground = run->motion->mode;
    off_ground.contact = TDMF_CONTACT_FLIGHT;
    off_ground.phase = phase_off_ground(run);
    off_ground.liftoff_angle = run->motion->state[TDMF_LEG_ANGLE];
    return off_ground;
}

/* ---- on the ground ------------------------------------------------------------------------------------ */

tdmf_contact_mode tdmf_mode_of_resting_foot(const tdmf_run *run, const tdmf_mode *mode) {
    const tdmf_evaluation at = tdmf_evaluate_run(run, mode);
    const tdmf_ground_force force = tdmf_force_in_stance(&at);
    const tdmf_zone zone = tdmf_zone_towards(at.model, at.state[TDMF_FOOT_X], -force.tangential);
    if (tdmf_inside_friction_cone(force, tdmf_static_friction(at.model, at.inputs, zone))) {
        return TDMF_CONTACT_STICK;
    }
    return force.tangential < 0.0 ? TDMF_CONTACT_SLIP_POSITIVE : TDMF_CONTACT_SLIP_NEGATIVE;
}

static tdmf_contact_mode mode_of_loaded_foot(const tdmf_run *run, const tdmf_mode *mode) {
    const double *state = run->motion->state;
    const double velocity = tdmf_velocity_along(&mode->ground, state[TDMF_FOOT_VX], state[TDMF_FOOT_VY]);
    if (velocity == 0.0) {
        return tdmf_mode_of_resting_foot(run, mode);
    }
    return velocity > 0.0 ? TDMF_CONTACT_SLIP_POSITIVE : TDMF_CONTACT_SLIP_NEGATIVE;
}

void tdmf_load_foot(tdmf_run *run) {
    tdmf_thrust_if_due(run);
    run->motion->mode.phase = run->motion->mode.mid_stance_pending ? TDMF_PHASE_DRIVE : TDMF_PHASE_COAST;
    run->motion->mode.clamp_closed = false;
    tdmf_end_place(run->motion->state);
    tdmf_enter_contact_mode(run, mode_of_loaded_foot(run, &run->motion->mode));
}

/* ---- one or the other --------------------------------------------------------------------------------- */

/* Enters flight or graze in a mode off the ground, or any loaded contact, for which stick stands. */
static void enter(tdmf_run *run, tdmf_contact_mode entered, const tdmf_mode *off_ground) {
    if (entered == TDMF_CONTACT_STICK) {
        tdmf_load_foot(run);
        return;
    }
    run->motion->mode.liftoff_angle = off_ground->liftoff_angle;
    leave_ground(run, entered, off_ground->phase);
}

/* Gives the acceleration that the leg's angle would have under the stance law of a drive. */
static double angle_acceleration_in_drive(const tdmf_run *run) {
    tdmf_mode driven = run->motion->mode;
    driven.mid_stance_pending = true;
    driven.phase = TDMF_PHASE_DRIVE;
    tdmf_set_contact(run->system.model, run->motion->state, mode_of_loaded_foot(run, &driven), &driven);
    const tdmf_evaluation at = tdmf_evaluate_run(run, &driven);
    double rates[TDMF_STATE_COUNT];
    tdmf_rates_at(&at, 0.0, rates);
    return rates[TDMF_LEG_ANGLE_RATE];
}

/* A stance that begins with the foot ahead is driven until the leg is upright. One that begins upright is
 * past that if the leg falls, by itself or driven: else the margin of mid-stance would give it a pulse. */
static bool begins_with_drive(const tdmf_run *run) {
    const double angle = run->motion->state[TDMF_LEG_ANGLE];
    const double rate = run->motion->state[TDMF_LEG_ANGLE_RATE] * run->system.model->scales.time;
    if (angle < 0.0 || angle > TDMF_GUARD_MARGIN) {
        return angle > 0.0;
    }
    return fabs(rate) > TDMF_GUARD_MARGIN ? rate > 0.0 : angle_acceleration_in_drive(run) >= 0.0;
}

void tdmf_come_to_ground(tdmf_run *run) {
    tdmf_thrust_if_due(run);
    run->motion->mode.mid_stance_pending = begins_with_drive(run);
    const tdmf_mode off_ground = mode_off_ground(run);
    const tdmf_evaluation at = tdmf_evaluate_run(run, &off_ground);
    enter(run, tdmf_contact_of_resting_foot(&at), &off_ground);
}

void tdmf_unload_foot(tdmf_run *run) {
    const tdmf_mode off_ground = mode_off_ground(run);
    const tdmf_evaluation at = tdmf_evaluate_run(run, &off_ground);
    const double force = tdmf_force_in_stance(&at).normal;
    const bool jumped = force < -TDMF_UNLOADED_FORCE * run->system.model->scales.force;
    enter(run, jumped ? tdmf_contact_of_resting_foot(&at) : tdmf_contact_after_lift_off(&at), &off_ground);
}
