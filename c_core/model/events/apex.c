/* Apex: the centre of mass is highest. The hip goes from retract to place; in flight a stride closes, also
 * where the hip is in place already, which it then begins anew. An apex is to come only while the centre of
 * mass rises. In place it may begin to: an upward force lifts it. */
#include "apex.h"

#include "kinematics.h"
#include "record.h"

static double vertical_velocity(const tdmf_evaluation *at) {
    const tdmf_leg_direction direction = {at->leg.sine, at->leg.cosine};
    const tdmf_point center = tdmf_center_of_mass_along(at->model, at->state, direction);
    const double scale = at->model->scales.speed;
    return at->mode->rises ? tdmf_armed(center.vy, scale)
                           : tdmf_armed_against_turning(center.vy, scale, true);
}

static double vary_vertical_velocity(const tdmf_evaluation *at, const tdmf_direction *d,
                                     const tdmf_evaluation *d_at) {
    const tdmf_leg_direction direction = {at->leg.sine, at->leg.cosine};
    (void)d_at;
    const double rate =
        tdmf_vary_center_of_mass_along(at->model, at->state, direction, &d->model, d->state).vy;
    return at->mode->rises ? rate : -rate;
}

static void begin_place(tdmf_run *run) {
    run->mode->phase = TDMF_PHASE_PLACE;
    run->mode->clamp_closed = false;
    run->mode->rises = false;
    run->state[TDMF_HIP_PLACE_TIME] = 0.0;
}

void tdmf_pass_apex(tdmf_run *run) {
    begin_place(run);
    tdmf_record_apex(run->record, run->model, &run->mode->ground, run->time, run->state);
}

static void reset(tdmf_run *run) {
    if (!run->mode->rises) {
        run->mode->rises = true;
        return;
    }
    tdmf_record_event(run->record, run->time);
    if (run->mode->contact == TDMF_CONTACT_GRAZE) {
        begin_place(run); /* a stride closes in flight only */
    } else {
        tdmf_pass_apex(run);
    }
}

static void vary_reset(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_ground_line *ground,
                       const double before[TDMF_STATE_COUNT], const double after[TDMF_STATE_COUNT],
                       const tdmf_direction *d, double d_state[TDMF_STATE_COUNT]) {
    (void)model;
    (void)inputs;
    (void)ground;
    (void)before;
    (void)after;
    (void)d;
    d_state[TDMF_HIP_PLACE_TIME] = 0.0;
}

const tdmf_event_kind tdmf_apex_event = {vertical_velocity, vary_vertical_velocity, reset, vary_reset};
