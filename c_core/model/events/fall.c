/* Falls: the body reaches the ground, or the leg its minimum. The run is over, so neither has a variation. */
#include "events.h"
#include "ground_line.h"

static double body_height(const tdmf_evaluation *at) {
    const double foot_height =
        tdmf_height_over(&at->mode->ground, at->state[TDMF_FOOT_X], at->state[TDMF_FOOT_Y]);
    return tdmf_armed(foot_height + at->leg.length * at->leg.ground_cosine, at->model->scales.length);
}

static double room_in_leg(const tdmf_evaluation *at) {
    return tdmf_armed(at->leg.length - at->model->parameters.leg.min_length, at->model->scales.length);
}

static void fall(tdmf_run *run) {
    run->mode->fallen = true;
}

const tdmf_event_kind tdmf_body_down = {.guard = body_height, .reset = fall};
const tdmf_event_kind tdmf_leg_too_short = {.guard = room_in_leg, .reset = fall};
