/* New ground: the line that was set last comes into force where the foot flies and is not below it. A foot
 * that stands keeps its ground, and one below a new step passes it on its way up. */
#include "events.h"
#include "ground_line.h"
#include "record.h"

/* Beside the line its side is not to be told: the foot must not move into it. */
static bool is_beside(const tdmf_evaluation *at, const tdmf_ground_line *line, double height) {
    return fabs(height) <=
           TDMF_AT_GROUND * at->model->scales.length + tdmf_rounding_of_height(line, at->state[TDMF_FOOT_X]);
}

static double depth_of_foot(const tdmf_evaluation *at) {
    const double *state = at->state;
    if (!tdmf_ground_is_pending(at->inputs, at->mode)) {
        return 1.0;
    }
    const tdmf_ground_line line = tdmf_ground_line_set(at->inputs);
    const double height = tdmf_height_over(&line, state[TDMF_FOOT_X], state[TDMF_FOOT_Y]);
    if (is_beside(at, &line, height)) {
        const bool moves_in = tdmf_velocity_off(&line, state[TDMF_FOOT_VX], state[TDMF_FOOT_VY]) < 0.0;
        return moves_in ? TDMF_AT_GROUND : -TDMF_AT_GROUND;
    }
    return -height / at->model->scales.length;
}

static double vary_depth_of_foot(const tdmf_evaluation *at, const tdmf_direction *d,
                                 const tdmf_evaluation *d_at) {
    const tdmf_ground_line line = tdmf_ground_line_set(at->inputs);
    (void)d_at;
    return -tdmf_vary_height_over(&line, at->state[TDMF_FOOT_X], at->state[TDMF_FOOT_Y], &d->mode.ground,
                                  d->state[TDMF_FOOT_X], d->state[TDMF_FOOT_Y]);
}

static void reset(tdmf_run *run) {
    run->mode->ground = tdmf_ground_line_set(run->inputs);
    tdmf_record_event(run->record, run->time);
}

const tdmf_event_kind tdmf_new_ground = {depth_of_foot, vary_depth_of_foot, reset, NULL};
