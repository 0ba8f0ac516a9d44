#include "at_instant.h"

#include "motion_instant.h"
#include "page_fields.h"

#include <string.h>

tdmf_stride last_stride_of(const tdmf_motion *motion) {
    return tdmf_page_stride_of((const void *)motion->state);
}

tdmf_apex last_apex_of(const tdmf_motion *motion) {
    return tdmf_page_apex_of((const void *)motion->state, motion->begun);
}

double last_event_of(const tdmf_motion *motion) {
    return motion->begun + motion->state[TDMF_EVENT_LAST_TIME];
}

tdmf_outputs outputs_of(tdmf_system system, const tdmf_motion *motion) {
    tdmf_outputs outputs;
    tdmf_outputs_of(system, motion, &outputs);
    return outputs;
}

double impact_on(tdmf_system system, const tdmf_ground_line *ground, double state[TDMF_STATE_COUNT]) {
    const tdmf_mode flies = {.contact = TDMF_CONTACT_FLIGHT,
                             .phase = TDMF_PHASE_PLACE,
                             .rest_length = system.model->parameters.leg.free_length,
                             .ground = *ground};
    tdmf_motion_instant instant;
    tdmf_begin_instant(&instant, system, &flies, state);
    const tdmf_mode_kind *mode = instant.at.mode;
    const double *p = instant.at.p, *x = instant.at.x;
    runner_states after = instant.point.x, seen;
    for (int i = 0; i < mode->guard_count; ++i) {
        const tdmf_guard_kind *kind = &mode->guards[i];
        if (kind->event == EVENT_touchdown) {
            const int next = kind->react(p, x, NULL, (double *)&after, kind->next);
            tdmf_show_to_world(&tdmf_runner_model, next, p, (double *)&after, (double *)&seen);
        }
    }
    after.seen_y += instant.point.base;
    memcpy(state, &after, sizeof after);
    return after.impact_loss;
}
