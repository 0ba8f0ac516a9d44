/* Greatest compression: a leg in contact that has shortened begins to lengthen, and its thrust is on from
 * then until flight begins, once in a stance. */
#include "greatest_compression.h"

#include "event_declarations.h"
#include "record.h"

void tdmf_account_for_rest_length(tdmf_run *run) {
    const double rest_length = tdmf_rest_length(run->system.model, run->system.inputs, &run->motion->mode);
    if (rest_length != run->motion->mode.rest_length) {
        run->motion->state[TDMF_LEG_WORK] +=
            tdmf_leg_work_of_jump(run->system.model, run->motion->state[TDMF_LEG_LENGTH],
                                  run->motion->mode.rest_length, rest_length);
        run->motion->mode.rest_length = rest_length;
    }
}

/* A thrust of 0 changes nothing and is not counted. */
void tdmf_take_greatest_compression(tdmf_run *run) {
    const double before = run->motion->mode.rest_length;
    run->motion->mode.thrusts = true;
    tdmf_account_for_rest_length(run);
    if (run->motion->mode.rest_length != before) {
        tdmf_record_event(run->motion);
    }
}

void tdmf_thrust_if_due(tdmf_run *run) {
    if (!run->motion->mode.thrusts && run->motion->state[TDMF_LEG_LENGTH_RATE] >= 0.0) {
        tdmf_take_greatest_compression(run);
    }
}

void tdmf_end_thrust(tdmf_run *run) {
    run->motion->mode.thrusts = false;
    tdmf_account_for_rest_length(run);
}
