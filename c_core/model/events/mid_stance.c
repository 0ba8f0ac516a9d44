/* Mid-stance: the leg falls through the vertical, and drive turns into coast. In graze the drive waits, for
 * the foot to be loaded again, and ends alike. */
#include "events.h"
#include "record.h"

static double leg_angle(const tdmf_evaluation *at) {
    return at->mode->mid_stance_pending ? tdmf_armed(at->state[TDMF_LEG_ANGLE], 1.0) : 1.0;
}

static double vary_leg_angle(const tdmf_evaluation *at, const tdmf_direction *d,
                             const tdmf_evaluation *d_at) {
    (void)at;
    (void)d_at;
    return d->state[TDMF_LEG_ANGLE];
}

static void reset(tdmf_run *run) {
    run->mode->mid_stance_pending = false;
    if (tdmf_in_contact(run->mode)) {
        run->mode->phase = TDMF_PHASE_COAST;
    }
    tdmf_record_event(run->record, run->time);
}

const tdmf_event_kind tdmf_mid_stance = {leg_angle, vary_leg_angle, reset, NULL};
