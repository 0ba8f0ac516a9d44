/* Touchdown: the foot comes down to the ground, with an impact. */
#include "touchdown.h"

#include "contact_change.h"
#include "ground_line.h"
#include "impact.h"
#include "record.h"

static double foot_height(const tdmf_evaluation *at) {
    const double x = at->state[TDMF_FOOT_X];
    const double height = tdmf_height_over(&at->mode->ground, x, at->state[TDMF_FOOT_Y]);
    return tdmf_armed(height + tdmf_rounding_of_height(&at->mode->ground, x), at->model->scales.length);
}

static double vary_foot_height(const tdmf_evaluation *at, const tdmf_direction *d,
                               const tdmf_evaluation *d_at) {
    (void)d_at;
    return tdmf_vary_height_over(&at->mode->ground, at->state[TDMF_FOOT_X], at->state[TDMF_FOOT_Y],
                                 &d->mode.ground, d->state[TDMF_FOOT_X], d->state[TDMF_FOOT_Y]);
}

void tdmf_touch_down(tdmf_run *run) {
    tdmf_record_impact(run->record, tdmf_impact_along(run->model, run->inputs, &run->mode->ground,
                                                      run->direction, run->state));
    tdmf_record_event(run->record, run->time);
    tdmf_come_to_ground(run);
}

/* A foot that is found below the ground without moving down was put there by rounding or by a coarse
 * importer: it is lifted to the ground and nothing is counted. */
static void reset(tdmf_run *run) {
    double *state = run->state;
    const tdmf_ground_line *ground = &run->mode->ground;
    const double rate = tdmf_velocity_off(ground, state[TDMF_FOOT_VX], state[TDMF_FOOT_VY]);
    if (rate < 0.0) {
        tdmf_touch_down(run);
        return;
    }
    tdmf_lift_to_ground(ground, state);
    if (rate == 0.0) {
        tdmf_record_event(run->record, run->time);
        tdmf_come_to_ground(run);
    }
}

static void vary_reset(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_ground_line *ground,
                       const double before[TDMF_STATE_COUNT], const double after[TDMF_STATE_COUNT],
                       const tdmf_direction *d, double d_state[TDMF_STATE_COUNT]) {
    (void)after;
    tdmf_vary_impact(model, inputs, ground, before, d, d_state);
}

const tdmf_event_kind tdmf_touchdown = {foot_height, vary_foot_height, reset, vary_reset};
