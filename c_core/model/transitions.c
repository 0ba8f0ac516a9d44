/* Resets of the automaton: what each event makes of state, mode and record. */
#include "transitions.h"

#include "leg.h"
#include "record.h"
#include "tdmf_slip/contact.h"
#include "tdmf_slip/dynamics.h"
#include "tdmf_slip/graze.h"
#include "tdmf_slip/hip.h"
#include "tdmf_slip/impact.h"
#include "tdmf_slip/kinematics.h"

static void enter_contact_mode(tdmf_run *run, tdmf_contact_mode entered) {
    tdmf_record_contact_change(run->record, run->time, run->mode, entered, run->state);
    run->mode->contact = entered;
}

/* Once begun, place lasts until the foot is loaded; else the centre of mass decides. */
static tdmf_hip_phase phase_off_ground(const tdmf_run *run) {
    if (run->mode->phase == TDMF_PHASE_PLACE) {
        return TDMF_PHASE_PLACE;
    }
    return tdmf_center_of_mass(run->model, run->state).vy >= 0.0 ? TDMF_PHASE_RETRACT : TDMF_PHASE_PLACE;
}

static bool clamp_holds(const tdmf_run *run) {
    return run->mode->phase == TDMF_PHASE_RETRACT &&
           tdmf_hip_retract_argument(run->model, run->mode, run->state) < 0.0;
}

/* Enters flight or graze, theta_LO unchanged. */
static void leave_ground(tdmf_run *run, tdmf_contact_mode entered, tdmf_hip_phase phase) {
    enter_contact_mode(run, entered);
    run->mode->phase = phase;
    run->mode->clamp_closed = clamp_holds(run);
}

void tdmf_fly(tdmf_run *run) {
    leave_ground(run, TDMF_CONTACT_FLIGHT, phase_off_ground(run));
}

/* The mode that the foot would be in if it left now, with theta_LO latched. */
static tdmf_mode mode_off_ground(const tdmf_run *run) {
    tdmf_mode off_ground = *run->mode;
    off_ground.phase = phase_off_ground(run);
    off_ground.liftoff_angle = run->state[TDMF_LEG_ANGLE];
    return off_ground;
}

/* Stick if friction can hold the foot at rest, else slip the way the excess drives it. */
static tdmf_contact_mode mode_of_resting_foot(const tdmf_run *run) {
    const double torque = tdmf_hip_stance_law(run->model, run->mode) + run->inputs->hip.external_torque;
    const tdmf_ground_force force = tdmf_sticking_force(run->model, torque, run->state);
    if (tdmf_inside_friction_cone(force, run->inputs->ground.friction)) {
        return TDMF_CONTACT_STICK;
    }
    return force.fx < 0.0 ? TDMF_CONTACT_SLIP_POSITIVE : TDMF_CONTACT_SLIP_NEGATIVE;
}

static tdmf_contact_mode mode_of_loaded_foot(const tdmf_run *run) {
    const double vx = run->state[TDMF_FOOT_VX];
    if (vx == 0.0) {
        return mode_of_resting_foot(run);
    }
    return vx > 0.0 ? TDMF_CONTACT_SLIP_POSITIVE : TDMF_CONTACT_SLIP_NEGATIVE;
}

static void load_foot(tdmf_run *run) {
    run->mode->phase = run->mode->mid_stance_pending ? TDMF_PHASE_DRIVE : TDMF_PHASE_COAST;
    run->mode->clamp_closed = false;
    enter_contact_mode(run, mode_of_loaded_foot(run));
}

static void meet_fate(tdmf_run *run, tdmf_foot_fate fate, const tdmf_mode *off_ground) {
    if (fate == TDMF_FOOT_LOADED) {
        load_foot(run);
        return;
    }
    run->mode->liftoff_angle = off_ground->liftoff_angle;
    leave_ground(run, fate == TDMF_FOOT_GRAZES ? TDMF_CONTACT_GRAZE : TDMF_CONTACT_FLIGHT, off_ground->phase);
}

/* Under the stance law of a drive. */
static double angle_acceleration_in_drive(const tdmf_run *run) {
    tdmf_mode driven = *run->mode;
    tdmf_run trial = *run;
    double derivatives[TDMF_STATE_COUNT];
    trial.mode = &driven;
    driven.mid_stance_pending = true;
    driven.phase = TDMF_PHASE_DRIVE;
    driven.contact = mode_of_loaded_foot(&trial);
    tdmf_derivatives(run->model, run->inputs, &driven, run->state, derivatives);
    return derivatives[TDMF_LEG_ANGLE_RATE];
}

/* A stance that begins with the foot ahead is driven until the leg is upright. One that begins upright is
 * past that if the leg falls, by itself or driven: else the margin of mid-stance would give it a pulse. */
static bool begins_with_drive(const tdmf_run *run) {
    const double angle = run->state[TDMF_LEG_ANGLE];
    const double rate = run->state[TDMF_LEG_ANGLE_RATE] * run->model->scales.time;
    if (angle < 0.0 || angle > TDMF_GUARD_MARGIN) {
        return angle > 0.0;
    }
    return fabs(rate) > TDMF_GUARD_MARGIN ? rate > 0.0 : angle_acceleration_in_drive(run) >= 0.0;
}

void tdmf_come_to_ground(tdmf_run *run) {
    run->mode->mid_stance_pending = begins_with_drive(run);
    const tdmf_mode off_ground = mode_off_ground(run);
    meet_fate(run, tdmf_fate_at_rest(run->model, run->inputs, &off_ground, run->state), &off_ground);
}

void tdmf_touch_down(tdmf_run *run) {
    tdmf_record_impact(run->record, tdmf_impact(run->model, run->inputs->ground.friction, run->state));
    tdmf_record_event(run->record, run->time);
    tdmf_come_to_ground(run);
}

void tdmf_reach_apex(tdmf_run *run) {
    run->mode->phase = TDMF_PHASE_PLACE;
    run->mode->clamp_closed = false;
    tdmf_record_apex(run->record, run->model, run->time, run->state);
}

/* ---- one transition out of each mode; true if there was one ------------------------------------------- */

static bool due(const double guards[TDMF_GUARD_COUNT], tdmf_guard guard) {
    return guards[guard] <= 0.0;
}

/* A foot that is found below the ground without moving down was put there by rounding or by a coarse
 * importer: it is lifted to the ground and nothing is counted. */
static void meet_ground(tdmf_run *run) {
    const double vy = run->state[TDMF_FOOT_VY];
    if (vy < 0.0) {
        tdmf_touch_down(run);
        return;
    }
    run->state[TDMF_FOOT_Y] = 0.0;
    if (vy == 0.0) {
        tdmf_record_event(run->record, run->time);
        tdmf_come_to_ground(run);
    }
}

static bool step_from_flight(tdmf_run *run, const double guards[TDMF_GUARD_COUNT]) {
    if (due(guards, TDMF_GUARD_APEX)) {
        tdmf_record_event(run->record, run->time);
        tdmf_reach_apex(run);
    } else if (due(guards, TDMF_GUARD_TOUCHDOWN)) {
        meet_ground(run);
    } else if (due(guards, TDMF_GUARD_CLAMP)) {
        run->mode->clamp_closed = !run->mode->clamp_closed;
    } else {
        return false;
    }
    return true;
}

static bool step_from_graze(tdmf_run *run, const double guards[TDMF_GUARD_COUNT]) {
    if (due(guards, TDMF_GUARD_APEX)) {
        run->mode->phase = TDMF_PHASE_PLACE; /* a stride closes in flight only */
    } else if (due(guards, TDMF_GUARD_GRAZE_TO_CONTACT)) {
        load_foot(run);
    } else if (due(guards, TDMF_GUARD_GRAZE_TO_FLIGHT)) {
        leave_ground(run, TDMF_CONTACT_FLIGHT, run->mode->phase);
    } else {
        return false;
    }
    tdmf_record_event(run->record, run->time);
    return true;
}

static void lift_off(tdmf_run *run) {
    const tdmf_mode off_ground = mode_off_ground(run);
    meet_fate(run, tdmf_fate_at_lift_off(run->model, run->inputs, &off_ground, run->state), &off_ground);
}

/* The slip comes to rest; a slip that only touches zero velocity and goes on is no event. */
static bool stop_slipping(tdmf_run *run) {
    tdmf_set_foot_velocity(0.0, 0.0, run->state);
    const tdmf_contact_mode entered = mode_of_resting_foot(run);
    if (entered == run->mode->contact) {
        return false;
    }
    enter_contact_mode(run, entered);
    return true;
}

static bool step_from_contact(tdmf_run *run, const double guards[TDMF_GUARD_COUNT]) {
    bool counts = true;
    if (due(guards, TDMF_GUARD_MID_STANCE)) {
        run->mode->mid_stance_pending = false;
        run->mode->phase = TDMF_PHASE_COAST;
    } else if (due(guards, TDMF_GUARD_LIFT_OFF)) {
        lift_off(run);
    } else if (due(guards, TDMF_GUARD_SLIP_ONSET_POSITIVE)) {
        enter_contact_mode(run, TDMF_CONTACT_SLIP_POSITIVE);
    } else if (due(guards, TDMF_GUARD_SLIP_ONSET_NEGATIVE)) {
        enter_contact_mode(run, TDMF_CONTACT_SLIP_NEGATIVE);
    } else if (due(guards, TDMF_GUARD_SLIP_VELOCITY_ZERO)) {
        counts = stop_slipping(run);
    } else {
        return false;
    }
    if (counts) {
        tdmf_record_event(run->record, run->time);
    }
    return true;
}

static bool fall(tdmf_run *run, const double guards[TDMF_GUARD_COUNT]) {
    if (due(guards, TDMF_GUARD_BODY_DOWN) || due(guards, TDMF_GUARD_LEG_TOO_SHORT)) {
        run->mode->fallen = true;
        return true;
    }
    return false;
}

/* Takes the one transition that is due first, if any is. */
static bool take_transition(tdmf_run *run, double sine, double cosine) {
    const tdmf_leg leg = tdmf_leg_at(run->model, run->state, sine, cosine);
    double guards[TDMF_GUARD_COUNT];
    tdmf_leg_guards(run->model, run->inputs, run->mode, run->state, &leg, guards);
    if (fall(run, guards)) {
        return true;
    }
    switch (run->mode->contact) {
    case TDMF_CONTACT_FLIGHT:
        return step_from_flight(run, guards);
    case TDMF_CONTACT_GRAZE:
        return step_from_graze(run, guards);
    default:
        return step_from_contact(run, guards);
    }
}

bool tdmf_take_transitions(tdmf_run *run) {
    /* No reset moves the leg. */
    const double sine = sin(run->state[TDMF_LEG_ANGLE]);
    const double cosine = cos(run->state[TDMF_LEG_ANGLE]);
    int links = 0;
    while (links < TDMF_CHAIN_LIMIT && take_transition(run, sine, cosine)) {
        ++links;
    }
    return links < TDMF_CHAIN_LIMIT;
}
