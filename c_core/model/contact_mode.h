/* Inline versions of the questions about a mode in state.h, for callers that ask at every evaluation. */
#ifndef TDMF_MODEL_CONTACT_MODE_H
#define TDMF_MODEL_CONTACT_MODE_H

#include "tdmf_slip/state.h"

/* Contact and phase are valid enumerators. */
static inline bool tdmf_is_mode(const tdmf_mode *mode) {
    const int contact = (int)mode->contact, phase = (int)mode->phase;
    return contact >= TDMF_CONTACT_FLIGHT && contact <= TDMF_CONTACT_GRAZE && phase >= TDMF_PHASE_DRIVE &&
           phase <= TDMF_PHASE_PLACE;
}

static inline bool tdmf_is_loaded(const tdmf_mode *mode) {
    return mode->contact == TDMF_CONTACT_STICK || mode->contact == TDMF_CONTACT_SLIP_POSITIVE ||
           mode->contact == TDMF_CONTACT_SLIP_NEGATIVE;
}

static inline double tdmf_sign_of_slip(const tdmf_mode *mode) {
    switch (mode->contact) {
    case TDMF_CONTACT_SLIP_POSITIVE:
        return 1.0;
    case TDMF_CONTACT_SLIP_NEGATIVE:
        return -1.0;
    default:
        return 0.0;
    }
}

#endif
