/* Apex: the centre of mass is highest. The hip goes from retract to place; in flight a stride closes, also
 * where the hip is in place already, which it then begins anew. An apex is to come only while the centre of
 * mass rises. In place it may begin to: an upward force lifts it.
 *
 * Where gravity is weak the margin of a velocity is a long time. As the dead band already keeps an apex from
 * being met twice, it does with a margin that only tells it from an exact zero. */
#include "apex.h"

#include "event_declarations.h"
#include "hip_laws.h"
#include "record.h"

static void begin_place(tdmf_run *run) {
    run->motion->mode.phase = TDMF_PHASE_PLACE;
    run->motion->mode.clamp_closed = false;
    run->motion->mode.rises = false;
    tdmf_begin_place(run->motion->state);
}

void tdmf_pass_apex(tdmf_run *run) {
    begin_place(run);
    tdmf_record_apex(run->motion, run->system.model);
}

void tdmf_take_apex(tdmf_run *run) {
    if (!run->motion->mode.rises) {
        run->motion->mode.rises = true;
        return;
    }
    tdmf_record_event(run->motion);
    if (run->motion->mode.contact == TDMF_CONTACT_GRAZE) {
        begin_place(run); /* a stride closes in flight only */
    } else {
        tdmf_pass_apex(run);
    }
}
