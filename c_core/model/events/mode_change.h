/* What events make of a mode that change it alone. */
#ifndef TDMF_MODEL_MODE_CHANGE_H
#define TDMF_MODEL_MODE_CHANGE_H

#include "events.h"
#include "patch.h"

/* A foot that slips does so on what lies ahead of it. */
static inline void tdmf_set_contact(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                    tdmf_contact_mode contact, tdmf_mode *mode) {
    mode->contact = contact;
    const double sign = tdmf_sign_of_slip(mode);
    mode->zone = sign == 0.0 ? TDMF_ZONE_BEFORE : tdmf_zone_towards(model, state[TDMF_FOOT_X], sign);
}

/* The contact that follows an event which changes no state, but for what is due in it at once: a foot that
 * comes to rest sticks. */
static inline tdmf_contact_mode tdmf_contact_after(const tdmf_mode *before, tdmf_guard taken) {
    switch (taken) {
    case TDMF_GUARD_SLIP_ONSET_POSITIVE:
        return TDMF_CONTACT_SLIP_POSITIVE;
    case TDMF_GUARD_SLIP_ONSET_NEGATIVE:
        return TDMF_CONTACT_SLIP_NEGATIVE;
    case TDMF_GUARD_SLIP_VELOCITY_ZERO:
        return TDMF_CONTACT_STICK;
    default:
        return before->contact;
    }
}

/* What such an event makes of the mode. In graze a drive waits for the foot to be loaded again, and ends
 * alike. */
static inline void tdmf_change_mode(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                    tdmf_guard taken, tdmf_mode *mode) {
    const tdmf_contact_mode contact = tdmf_contact_after(mode, taken);
    if (contact != mode->contact) {
        tdmf_set_contact(model, state, contact, mode);
    } else if (taken == TDMF_GUARD_CLAMP) {
        mode->clamp_closed = !mode->clamp_closed;
    } else if (taken == TDMF_GUARD_MID_STANCE) {
        mode->mid_stance_pending = false;
        mode->phase = tdmf_is_loaded(mode) ? TDMF_PHASE_COAST : mode->phase;
    }
}

/* The same in a run, whose record notes a contact that is over and counts the event. */
void tdmf_take_mode_change(tdmf_run *run, tdmf_guard taken);

#endif
