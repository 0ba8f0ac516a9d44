/* Resets of the events that hardly more than change the mode. */
#include "contact_change.h"
#include "coordinate_laws.h"
#include "event_declarations.h"
#include "guard_laws.h"
#include "mode_change.h"
#include "record.h"

/* ---- the hip ------------------------------------------------------------------------------------------- */

/* The servo of retract changes its sign, and the clamp of (12) opens or closes. Neither a contact nor a phase
 * changes, so that it is not counted. */
void tdmf_take_clamp(tdmf_run *run) {
    tdmf_change_mode(run->system.model, run->motion->state, TDMF_GUARD_CLAMP, &run->motion->mode);
}

/* The leg falls through the vertical, and drive turns into coast. */
void tdmf_take_mid_stance(tdmf_run *run) {
    tdmf_take_mode_change(run, TDMF_GUARD_MID_STANCE);
}

/* ---- the foot ------------------------------------------------------------------------------------------ */

/* The ground force vanishes; flight or graze begins. */
void tdmf_take_lift_off(tdmf_run *run) {
    tdmf_unload_foot(run);
    tdmf_record_event(run->motion);
}

void tdmf_take_slip_onset_positive(tdmf_run *run) {
    tdmf_take_mode_change(run, TDMF_GUARD_SLIP_ONSET_POSITIVE);
}

void tdmf_take_slip_onset_negative(tdmf_run *run) {
    tdmf_take_mode_change(run, TDMF_GUARD_SLIP_ONSET_NEGATIVE);
}

/* The foot sticks, or slips the other way. A slip that only touches zero velocity and goes on is not counted,
 * unless it does so across a border. */
void tdmf_take_slip_velocity_zero(tdmf_run *run) {
    tdmf_set_foot_velocity_along(run->motion->state, run->direction, 0.0, 0.0, run->motion->state);
    const tdmf_contact_mode entered = tdmf_mode_of_resting_foot(run, &run->motion->mode);
    if (entered != run->motion->mode.contact) {
        tdmf_enter_contact_mode(run, entered);
        tdmf_record_event(run->motion);
    } else {
        const tdmf_zone zone = tdmf_zone_towards(run->system.model, run->motion->state[TDMF_FOOT_X],
                                                 tdmf_sign_of_slip(&run->motion->mode));
        if (zone != run->motion->mode.zone) {
            run->motion->mode.zone = zone;
            tdmf_record_event(run->motion);
        }
    }
}

/* The foot slips on from one zone to the next; force and friction are others, the mode is the same. */
void tdmf_take_patch_border(tdmf_run *run) {
    const int onward = tdmf_sign_of_slip(&run->motion->mode) > 0.0 ? 1 : -1;
    run->motion->mode.zone = (tdmf_zone)((int)run->motion->mode.zone + onward);
    tdmf_record_event(run->motion);
}

/* Where no border is ahead there is nothing to reach. */
double tdmf_armed_patch_border(const tdmf_evaluation *at) {
    return tdmf_slips_to_border(at->model, at->mode)
               ? tdmf_patch_border_guard(at, tdmf_sign_of_slip(at->mode) > 0.0) / at->model->scales.length +
                     TDMF_GUARD_MARGIN
               : 1.0;
}

/* The stance law loads a grazing foot again. */
void tdmf_take_graze_to_contact(tdmf_run *run) {
    tdmf_load_foot(run);
    tdmf_record_event(run->motion);
}

/* The flight law lifts it. */
void tdmf_take_graze_to_flight(tdmf_run *run) {
    tdmf_fly_on(run);
    tdmf_record_event(run->motion);
}

/* ---- falls --------------------------------------------------------------------------------------------- */

/* The body reaches the ground, or the leg its minimum: the run is over. */
void tdmf_take_fall(tdmf_run *run) {
    run->motion->mode.fallen = true;
}
