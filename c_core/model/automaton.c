/* The resolution of events. */
#include "tdmf_slip/automaton.h"

#include "dynamics.h"
#include "events.h"
#include "record.h"

#include <string.h>

void tdmf_observe(const tdmf_model *model, const tdmf_inputs *inputs, const double state[TDMF_STATE_COUNT],
                  tdmf_mode *mode, tdmf_record *record) {
    if (!tdmf_in_contact(mode)) {
        return;
    }
    tdmf_record_force(record, tdmf_contact_force(model, inputs, mode, state).fy);
    mode->ground_force_rising = tdmf_ground_force_rate(model, inputs, mode, state) > 0.0;
}

tdmf_resolution tdmf_resolve(const tdmf_model *model, const tdmf_inputs *inputs, double time,
                             double state[TDMF_STATE_COUNT], tdmf_mode *mode, tdmf_record *record) {
    const tdmf_mode mode_before = *mode;
    double state_before[TDMF_STATE_COUNT];
    memcpy(state_before, state, sizeof state_before);

    tdmf_run run = {model, inputs, time, state, mode, record};
    tdmf_observe(model, inputs, state, mode, record);
    const bool resolved = tdmf_take_transitions(&run);
    tdmf_observe(model, inputs, state, mode, record);

    const tdmf_resolution resolution = {
        .state_changed = memcmp(state_before, state, sizeof state_before) != 0,
        .mode_changed = !tdmf_same_mode(&mode_before, mode),
        .unresolved = !resolved,
    };
    return resolution;
}
