/* The resolution of events. */
#include "tdmf_slip/automaton.h"

#include "contact_mode.h"
#include "events.h"
#include "greatest_compression.h"

#include <string.h>

tdmf_resolution tdmf_resolve(tdmf_system system, tdmf_motion *motion) {
    static const tdmf_resolution no_mode = {.unresolved = true};
    if (!tdmf_is_mode(&motion->mode)) {
        return no_mode;
    }
    const tdmf_mode mode_before = motion->mode;
    double state_before[TDMF_STATE_COUNT];
    memcpy(state_before, motion->state, sizeof state_before);

    tdmf_run run = {system, motion, tdmf_leg_direction_of(motion->state)};
    /* The host may have changed hip.swing_clamp since the last call. */
    motion->mode.clamp_closed = motion->mode.clamp_closed && tdmf_has_clamp(system.model, &motion->mode);
    if (!motion->mode.fallen) {
        tdmf_account_for_rest_length(&run);
    }
    const bool resolved = tdmf_take_transitions(&run);

    const tdmf_resolution resolution = {
        .state_changed = memcmp(state_before, motion->state, sizeof state_before) != 0,
        .mode_changed = !tdmf_same_mode(&mode_before, &motion->mode),
        .unresolved = !resolved,
    };
    return resolution;
}
