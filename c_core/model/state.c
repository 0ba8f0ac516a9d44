/* Small questions about state and mode. */
#include "tdmf_slip/state.h"

#include "ranges.h"

bool tdmf_in_contact(const tdmf_mode *mode) {
    return mode->contact == TDMF_CONTACT_STICK || mode->contact == TDMF_CONTACT_SLIP_POSITIVE ||
           mode->contact == TDMF_CONTACT_SLIP_NEGATIVE;
}

double tdmf_slip_sign(const tdmf_mode *mode) {
    switch (mode->contact) {
    case TDMF_CONTACT_SLIP_POSITIVE:
        return 1.0;
    case TDMF_CONTACT_SLIP_NEGATIVE:
        return -1.0;
    default:
        return 0.0;
    }
}

void tdmf_default_state(double state[TDMF_STATE_COUNT]) {
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        state[i] = i < TDMF_MECHANICAL_COUNT ? tdmf_state_ranges[i].start : 0.0;
    }
}
