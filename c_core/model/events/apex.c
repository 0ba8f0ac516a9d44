/* Apex: the centre of mass is highest, and the hip goes from retract to place. In flight it closes a
 * stride. */
#include "apex.h"

#include "kinematics.h"
#include "record.h"

static double vertical_velocity(const tdmf_evaluation *at) {
    const tdmf_leg_direction direction = {at->leg.sine, at->leg.cosine};
    const tdmf_point center = tdmf_center_of_mass_along(at->model, at->state, direction);
    return tdmf_armed(center.vy, at->model->scales.speed);
}

static double vary_vertical_velocity(const tdmf_evaluation *at, const tdmf_direction *d,
                                     const tdmf_evaluation *d_at) {
    const tdmf_leg_direction direction = {at->leg.sine, at->leg.cosine};
    (void)d_at;
    return tdmf_vary_center_of_mass(at->model, at->state, direction, &d->model, d->state).vy;
}

static void begin_place(tdmf_run *run) {
    run->mode->phase = TDMF_PHASE_PLACE;
    run->mode->clamp_closed = false;
}

void tdmf_pass_apex(tdmf_run *run) {
    begin_place(run);
    tdmf_record_apex(run->record, run->model, run->time, run->state);
}

static void reset(tdmf_run *run) {
    tdmf_record_event(run->record, run->time);
    if (run->mode->contact == TDMF_CONTACT_GRAZE) {
        begin_place(run); /* a stride closes in flight only */
    } else {
        tdmf_pass_apex(run);
    }
}

const tdmf_event_kind tdmf_apex_event = {vertical_velocity, vary_vertical_velocity, reset, NULL};
