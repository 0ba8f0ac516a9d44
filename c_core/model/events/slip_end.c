/* End of a slip: the foot's velocity vanishes; the foot sticks, or slips the other way. */
#include "contact_change.h"
#include "contact_mode.h"
#include "ground_line.h"
#include "kinematics.h"
#include "record.h"

static double velocity_of_foot(const tdmf_evaluation *at) {
    return tdmf_velocity_along(&at->mode->ground, at->state[TDMF_FOOT_VX], at->state[TDMF_FOOT_VY]);
}

static double slip_speed(const tdmf_evaluation *at) {
    return tdmf_armed(tdmf_sign_of_slip(at->mode) * velocity_of_foot(at), at->model->scales.speed);
}

static double vary_slip_speed(const tdmf_evaluation *at, const tdmf_direction *d,
                              const tdmf_evaluation *d_at) {
    const double d_velocity =
        tdmf_vary_velocity_along(&at->mode->ground, at->state[TDMF_FOOT_VX], at->state[TDMF_FOOT_VY],
                                 &d->mode.ground, d->state[TDMF_FOOT_VX], d->state[TDMF_FOOT_VY]);
    (void)d_at;
    return tdmf_sign_of_slip(at->mode) * d_velocity;
}

/* A slip that only touches zero velocity and goes on is not counted. */
static void reset(tdmf_run *run) {
    tdmf_set_foot_velocity_along(0.0, 0.0, run->direction, run->state);
    const tdmf_contact_mode entered = tdmf_mode_of_resting_foot(run);
    if (entered != run->mode->contact) {
        tdmf_enter_contact_mode(run, entered);
        tdmf_record_event(run->record, run->time);
    }
}

const tdmf_event_kind tdmf_slip_end = {slip_speed, vary_slip_speed, reset, NULL};
