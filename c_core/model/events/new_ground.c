/* New ground: the line that was set last comes into force where the foot flies and is not below it. A foot
 * that stands keeps its ground, and one below a new step passes it on its way up. */
#include "event_declarations.h"
#include "ground_line.h"
#include "guard_laws.h"
#include "record.h"

/* Beside the line its side is not to be told: the foot must not move into it. */
static bool is_beside(const tdmf_evaluation *at, const tdmf_ground_line *line, double height) {
    return fabs(height) <=
           TDMF_AT_GROUND * at->model->scales.length + tdmf_rounding_of_height(line, at->state[TDMF_FOOT_X]);
}

double tdmf_armed_new_ground(const tdmf_evaluation *at) {
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
    return tdmf_new_ground_guard(at, &line) / at->model->scales.length;
}

void tdmf_take_new_ground(tdmf_run *run) {
    run->motion->mode.ground = tdmf_ground_line_set(run->system.inputs);
    tdmf_record_event(run->motion);
}
