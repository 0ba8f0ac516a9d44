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

/* The mode that follows an event which changes no state, but for what is due in it at once; of a foot that
 * comes to rest, that in which friction holds it. */
static inline tdmf_mode tdmf_mode_after(const tdmf_model *model, const double state[TDMF_STATE_COUNT],
                                        const tdmf_mode *before, tdmf_guard taken) {
    tdmf_mode after = *before;
    switch (taken) {
    case TDMF_GUARD_CLAMP:
        after.clamp_closed = !before->clamp_closed;
        break;
    case TDMF_GUARD_MID_STANCE: /* in graze the drive waits for the foot to be loaded again, and ends alike */
        after.mid_stance_pending = false;
        after.phase = tdmf_is_loaded(before) ? TDMF_PHASE_COAST : before->phase;
        break;
    case TDMF_GUARD_SLIP_ONSET_POSITIVE:
        tdmf_set_contact(model, state, TDMF_CONTACT_SLIP_POSITIVE, &after);
        break;
    case TDMF_GUARD_SLIP_ONSET_NEGATIVE:
        tdmf_set_contact(model, state, TDMF_CONTACT_SLIP_NEGATIVE, &after);
        break;
    case TDMF_GUARD_SLIP_VELOCITY_ZERO:
        tdmf_set_contact(model, state, TDMF_CONTACT_STICK, &after);
        break;
    default:
        break;
    }
    return after;
}

/* Enters a mode that follows such an event, and counts that; the record notes a contact that is over. */
void tdmf_enter_mode(tdmf_run *run, const tdmf_mode *entered);

#endif
