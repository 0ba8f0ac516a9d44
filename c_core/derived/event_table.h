/* Derived from c_core/equations/events.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_EVENT_TABLE_H
#define TDMF_DERIVED_EVENT_TABLE_H

#include "event_declarations.h"
#include "guard_laws.h"

static const event_kind kinds[TDMF_GUARD_COUNT] = {
    [TDMF_GUARD_NEW_GROUND] = {.guard = tdmf_armed_new_ground, .reset = tdmf_take_new_ground},
    [TDMF_GUARD_BODY_DOWN] = {.guard = tdmf_body_down_guard, .reset = tdmf_take_fall},
    [TDMF_GUARD_LEG_TOO_SHORT] = {.guard = tdmf_leg_too_short_guard, .reset = tdmf_take_fall},
    [TDMF_GUARD_APEX] = {.guard = tdmf_apex_guard, .reset = tdmf_take_apex},
    [TDMF_GUARD_TOUCHDOWN] = {.guard = tdmf_touchdown_guard, .reset = tdmf_take_touchdown},
    [TDMF_GUARD_CLAMP] = {.guard = tdmf_clamp_guard, .reset = tdmf_take_clamp},
    [TDMF_GUARD_GREATEST_COMPRESSION] = {.guard = tdmf_greatest_compression_guard,
                                         .reset = tdmf_take_greatest_compression},
    [TDMF_GUARD_MID_STANCE] = {.guard = tdmf_mid_stance_guard, .reset = tdmf_take_mid_stance},
    [TDMF_GUARD_LIFT_OFF] = {.guard = tdmf_lift_off_guard, .reset = tdmf_take_lift_off},
    [TDMF_GUARD_SLIP_ONSET_POSITIVE] = {.guard = tdmf_slip_onset_positive_guard,
                                        .reset = tdmf_take_slip_onset_positive},
    [TDMF_GUARD_SLIP_ONSET_NEGATIVE] = {.guard = tdmf_slip_onset_negative_guard,
                                        .reset = tdmf_take_slip_onset_negative},
    [TDMF_GUARD_SLIP_VELOCITY_ZERO] = {.guard = tdmf_slip_velocity_zero_guard,
                                       .reset = tdmf_take_slip_velocity_zero},
    [TDMF_GUARD_PATCH_BORDER] = {.guard = tdmf_armed_patch_border, .reset = tdmf_take_patch_border},
    [TDMF_GUARD_FORCE_PEAK] = {.guard = tdmf_armed_force_peak},
    [TDMF_GUARD_VERTICAL_FORCE_PEAK] = {.guard = tdmf_armed_vertical_force_peak},
    [TDMF_GUARD_GRAZE_TO_CONTACT] = {.guard = tdmf_graze_to_contact_guard,
                                     .reset = tdmf_take_graze_to_contact},
    [TDMF_GUARD_GRAZE_TO_FLIGHT] = {.guard = tdmf_graze_to_flight_guard, .reset = tdmf_take_graze_to_flight},
};

/* In the order in which they are taken at one instant. */
static const watched in_flight[] = {
    {TDMF_GUARD_NEW_GROUND, ALWAYS},    {TDMF_GUARD_BODY_DOWN, ALWAYS}, {TDMF_GUARD_LEG_TOO_SHORT, ALWAYS},
    {TDMF_GUARD_APEX, RETRACT | PLACE}, {TDMF_GUARD_TOUCHDOWN, ALWAYS}, {TDMF_GUARD_CLAMP, RETRACT},
};

static tdmf_guard first_due_in_flight(const tdmf_evaluation *at, int phase) {
    (void)phase;
    if (tdmf_armed_new_ground(at) <= 0.0) {
        return TDMF_GUARD_NEW_GROUND;
    }
    if (tdmf_body_down_guard(at) <= 0.0) {
        return TDMF_GUARD_BODY_DOWN;
    }
    if (tdmf_leg_too_short_guard(at) <= 0.0) {
        return TDMF_GUARD_LEG_TOO_SHORT;
    }
    if ((phase & (RETRACT | PLACE)) != 0 && tdmf_apex_guard(at) <= 0.0) {
        return TDMF_GUARD_APEX;
    }
    if (tdmf_touchdown_guard(at) <= 0.0) {
        return TDMF_GUARD_TOUCHDOWN;
    }
    if ((phase & (RETRACT)) != 0 && tdmf_clamp_guard(at) <= 0.0) {
        return TDMF_GUARD_CLAMP;
    }
    return TDMF_GUARD_COUNT;
}

static const watched in_stick[] = {
    {TDMF_GUARD_BODY_DOWN, ALWAYS},
    {TDMF_GUARD_LEG_TOO_SHORT, ALWAYS},
    {TDMF_GUARD_GREATEST_COMPRESSION, ALWAYS},
    {TDMF_GUARD_MID_STANCE, ALWAYS},
    {TDMF_GUARD_LIFT_OFF, ALWAYS},
    {TDMF_GUARD_SLIP_ONSET_POSITIVE, ALWAYS},
    {TDMF_GUARD_SLIP_ONSET_NEGATIVE, ALWAYS},
    {TDMF_GUARD_FORCE_PEAK, ALWAYS},
    {TDMF_GUARD_VERTICAL_FORCE_PEAK, ALWAYS},
};

static tdmf_guard first_due_in_stick(const tdmf_evaluation *at, int phase) {
    (void)phase;
    if (tdmf_body_down_guard(at) <= 0.0) {
        return TDMF_GUARD_BODY_DOWN;
    }
    if (tdmf_leg_too_short_guard(at) <= 0.0) {
        return TDMF_GUARD_LEG_TOO_SHORT;
    }
    if (tdmf_greatest_compression_guard(at) <= 0.0) {
        return TDMF_GUARD_GREATEST_COMPRESSION;
    }
    if (tdmf_mid_stance_guard(at) <= 0.0) {
        return TDMF_GUARD_MID_STANCE;
    }
    if (tdmf_lift_off_guard(at) <= 0.0) {
        return TDMF_GUARD_LIFT_OFF;
    }
    if (tdmf_slip_onset_positive_guard(at) <= 0.0) {
        return TDMF_GUARD_SLIP_ONSET_POSITIVE;
    }
    if (tdmf_slip_onset_negative_guard(at) <= 0.0) {
        return TDMF_GUARD_SLIP_ONSET_NEGATIVE;
    }
    return TDMF_GUARD_COUNT;
}

static const watched in_slip[] = {
    {TDMF_GUARD_BODY_DOWN, ALWAYS},
    {TDMF_GUARD_LEG_TOO_SHORT, ALWAYS},
    {TDMF_GUARD_GREATEST_COMPRESSION, ALWAYS},
    {TDMF_GUARD_MID_STANCE, ALWAYS},
    {TDMF_GUARD_LIFT_OFF, ALWAYS},
    {TDMF_GUARD_SLIP_VELOCITY_ZERO, ALWAYS},
    {TDMF_GUARD_PATCH_BORDER, ALWAYS},
    {TDMF_GUARD_FORCE_PEAK, ALWAYS},
    {TDMF_GUARD_VERTICAL_FORCE_PEAK, ALWAYS},
};

static tdmf_guard first_due_in_slip(const tdmf_evaluation *at, int phase) {
    (void)phase;
    if (tdmf_body_down_guard(at) <= 0.0) {
        return TDMF_GUARD_BODY_DOWN;
    }
    if (tdmf_leg_too_short_guard(at) <= 0.0) {
        return TDMF_GUARD_LEG_TOO_SHORT;
    }
    if (tdmf_greatest_compression_guard(at) <= 0.0) {
        return TDMF_GUARD_GREATEST_COMPRESSION;
    }
    if (tdmf_mid_stance_guard(at) <= 0.0) {
        return TDMF_GUARD_MID_STANCE;
    }
    if (tdmf_lift_off_guard(at) <= 0.0) {
        return TDMF_GUARD_LIFT_OFF;
    }
    if (tdmf_slip_velocity_zero_guard(at) <= 0.0) {
        return TDMF_GUARD_SLIP_VELOCITY_ZERO;
    }
    if (tdmf_armed_patch_border(at) <= 0.0) {
        return TDMF_GUARD_PATCH_BORDER;
    }
    return TDMF_GUARD_COUNT;
}

static const watched in_graze[] = {
    {TDMF_GUARD_BODY_DOWN, ALWAYS},
    {TDMF_GUARD_LEG_TOO_SHORT, ALWAYS},
    {TDMF_GUARD_APEX, RETRACT},
    {TDMF_GUARD_MID_STANCE, ALWAYS},
    {TDMF_GUARD_GRAZE_TO_CONTACT, ALWAYS},
    {TDMF_GUARD_GRAZE_TO_FLIGHT, ALWAYS},
};

static tdmf_guard first_due_in_graze(const tdmf_evaluation *at, int phase) {
    (void)phase;
    if (tdmf_body_down_guard(at) <= 0.0) {
        return TDMF_GUARD_BODY_DOWN;
    }
    if (tdmf_leg_too_short_guard(at) <= 0.0) {
        return TDMF_GUARD_LEG_TOO_SHORT;
    }
    if ((phase & (RETRACT)) != 0 && tdmf_apex_guard(at) <= 0.0) {
        return TDMF_GUARD_APEX;
    }
    if (tdmf_mid_stance_guard(at) <= 0.0) {
        return TDMF_GUARD_MID_STANCE;
    }
    if (tdmf_graze_to_contact_guard(at) <= 0.0) {
        return TDMF_GUARD_GRAZE_TO_CONTACT;
    }
    if (tdmf_graze_to_flight_guard(at) <= 0.0) {
        return TDMF_GUARD_GRAZE_TO_FLIGHT;
    }
    return TDMF_GUARD_COUNT;
}

#define END(events) ((events) + sizeof(events) / sizeof((events)[0]))
#define LIST(contact)                                                                                        \
    { in_##contact, END(in_##contact), first_due_in_##contact }

static const watch_list watched_by[] = {
    [TDMF_CONTACT_FLIGHT] = LIST(flight),      [TDMF_CONTACT_STICK] = LIST(stick),
    [TDMF_CONTACT_SLIP_POSITIVE] = LIST(slip), [TDMF_CONTACT_SLIP_NEGATIVE] = LIST(slip),
    [TDMF_CONTACT_GRAZE] = LIST(graze),
};

#endif
