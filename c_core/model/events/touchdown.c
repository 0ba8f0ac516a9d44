/* Touchdown: the foot comes down to the ground, with an impact. */
#include "touchdown.h"

#include "contact_change.h"
#include "impact.h"
#include "record.h"

static double foot_height(const tdmf_evaluation *at) {
    return tdmf_armed(at->state[TDMF_FOOT_Y], at->model->scales.length);
}

static double vary_foot_height(const tdmf_evaluation *at, const tdmf_direction *d,
                               const tdmf_evaluation *d_at) {
    (void)at;
    (void)d_at;
    return d->state[TDMF_FOOT_Y];
}

void tdmf_touch_down(tdmf_run *run) {
    tdmf_record_impact(run->record, tdmf_impact_along(run->model, run->inputs, run->direction, run->state));
    tdmf_record_event(run->record, run->time);
    tdmf_come_to_ground(run);
}

/* A foot that is found below the ground without moving down was put there by rounding or by a coarse
 * importer: it is lifted to the ground and nothing is counted. */
static void reset(tdmf_run *run) {
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

static void vary_reset(const tdmf_model *model, const tdmf_inputs *inputs,
                       const double before[TDMF_STATE_COUNT], const double after[TDMF_STATE_COUNT],
                       const tdmf_direction *d, double d_state[TDMF_STATE_COUNT]) {
    tdmf_vary_impact(model, inputs, before, after, d, d_state);
}

const tdmf_event_kind tdmf_touchdown = {foot_height, vary_foot_height, reset, vary_reset};
