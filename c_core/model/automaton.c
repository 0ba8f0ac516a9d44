/* The resolution of events. */
#include "tdmf_slip/automaton.h"

#include "contact_mode.h"
#include "events.h"
#include "greatest_compression.h"

#include <string.h>

tdmf_resolution tdmf_resolve_along(const tdmf_model *model, const tdmf_inputs *inputs, double time,
                                   double state[TDMF_STATE_COUNT], tdmf_leg_direction direction,
                                   tdmf_guard reached, tdmf_mode *mode, tdmf_record *record) {
    static const tdmf_resolution no_mode = {.unresolved = true};
    if (!tdmf_is_mode(mode)) {
        return no_mode;
    }
    const tdmf_mode mode_before = *mode;
    double state_before[TDMF_STATE_COUNT];
    memcpy(state_before, state, sizeof state_before);

    tdmf_run run = {model, inputs, time, state, mode, record, direction};
    if (!mode->fallen) {
        tdmf_account_for_rest_length(&run);
    }
    tdmf_observe_along(model, inputs, state, direction, mode, record);
    const bool resolved = tdmf_take_transitions(&run, reached);
    tdmf_observe_along(model, inputs, state, direction, mode, record);

    const tdmf_resolution resolution = {
        .state_changed = memcmp(state_before, state, sizeof state_before) != 0,
        .mode_changed = !tdmf_same_mode(&mode_before, mode),
        .unresolved = !resolved,
    };
    return resolution;
}

tdmf_resolution tdmf_resolve(const tdmf_model *model, const tdmf_inputs *inputs, double time,
                             double state[TDMF_STATE_COUNT], tdmf_mode *mode, tdmf_record *record) {
    return tdmf_resolve_along(model, inputs, time, state, tdmf_leg_direction_of(state), TDMF_GUARD_COUNT,
                              mode, record);
}
