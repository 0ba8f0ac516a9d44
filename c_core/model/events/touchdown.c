/* Touchdown: the foot comes down to the ground, with an impact. */
#include "touchdown.h"

#include "contact_change.h"
#include "event_declarations.h"
#include "ground_line.h"
#include "impact.h"
#include "record.h"

void tdmf_touch_down(tdmf_run *run) {
    tdmf_record_impact(&run->motion->record, tdmf_impact_along(run->system, &run->motion->mode.ground,
                                                               run->direction, run->motion->state));
    tdmf_record_event(run->motion);
    tdmf_come_to_ground(run);
}

/* A foot that is found below the ground without moving down was put there by rounding or by a coarse
 * importer: it is lifted to the ground and nothing is counted. */
void tdmf_take_touchdown(tdmf_run *run) {
    double *state = run->motion->state;
    const tdmf_ground_line *ground = &run->motion->mode.ground;
    const double rate = tdmf_velocity_off(ground, state[TDMF_FOOT_VX], state[TDMF_FOOT_VY]);
    if (rate < 0.0) {
        tdmf_touch_down(run);
        return;
    }
    tdmf_lift_to_ground(ground, state);
    if (rate == 0.0) {
        tdmf_record_event(run->motion);
        tdmf_come_to_ground(run);
    }
}
