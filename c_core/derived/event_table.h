/* Derived from c_core/equations/events.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_EVENT_TABLE_H
#define TDMF_DERIVED_EVENT_TABLE_H

#include "event_declarations.h"
#include "guard_laws.h"

static const tdmf_event_kind kinds[TDMF_GUARD_COUNT] = {
    [TDMF_GUARD_NEW_GROUND] = {.guard = tdmf_armed_new_ground,
                               .vary_guard = tdmf_vary_armed_new_ground,
                               .reset = tdmf_take_new_ground,
                               .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_BODY_DOWN] = {.guard = tdmf_body_down_guard,
                              .reset = tdmf_take_fall,
                              .reach = TDMF_REACH_WITHIN_MARGIN},
    [TDMF_GUARD_LEG_TOO_SHORT] = {.guard = tdmf_leg_too_short_guard,
                                  .reset = tdmf_take_fall,
                                  .reach = TDMF_REACH_WITHIN_MARGIN},
    [TDMF_GUARD_APEX] = {.guard = tdmf_apex_guard,
                         .vary_guard = tdmf_vary_apex_guard,
                         .reset = tdmf_take_apex,
                         .vary_reset = tdmf_vary_take_apex,
                         .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_TOUCHDOWN] = {.guard = tdmf_touchdown_guard,
                              .vary_guard = tdmf_vary_touchdown_guard,
                              .reset = tdmf_take_touchdown,
                              .vary_reset = tdmf_vary_take_touchdown,
                              .reach = TDMF_REACH_WITHIN_DEAD_BAND,
                              .is_impact = true},
    [TDMF_GUARD_CLAMP] = {.guard = tdmf_clamp_guard,
                          .vary_guard = tdmf_vary_clamp_guard,
                          .reset = tdmf_take_clamp,
                          .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_GREATEST_COMPRESSION] = {.guard = tdmf_greatest_compression_guard,
                                         .vary_guard = tdmf_vary_greatest_compression_guard,
                                         .reset = tdmf_take_greatest_compression,
                                         .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_MID_STANCE] = {.guard = tdmf_mid_stance_guard,
                               .vary_guard = tdmf_vary_mid_stance_guard,
                               .reset = tdmf_take_mid_stance,
                               .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_LIFT_OFF] = {.guard = tdmf_lift_off_guard,
                             .vary_guard = tdmf_vary_lift_off_guard,
                             .reset = tdmf_take_lift_off,
                             .reach = TDMF_REACH_WITHIN_MARGIN},
    [TDMF_GUARD_SLIP_ONSET_POSITIVE] = {.guard = tdmf_slip_onset_positive_guard,
                                        .vary_guard = tdmf_vary_slip_onset_positive_guard,
                                        .reset = tdmf_take_slip_onset_positive,
                                        .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_SLIP_ONSET_NEGATIVE] = {.guard = tdmf_slip_onset_negative_guard,
                                        .vary_guard = tdmf_vary_slip_onset_negative_guard,
                                        .reset = tdmf_take_slip_onset_negative,
                                        .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_SLIP_VELOCITY_ZERO] = {.guard = tdmf_slip_velocity_zero_guard,
                                       .vary_guard = tdmf_vary_slip_velocity_zero_guard,
                                       .reset = tdmf_take_slip_velocity_zero,
                                       .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_PATCH_BORDER] = {.guard = tdmf_armed_patch_border,
                                 .vary_guard = tdmf_vary_armed_patch_border,
                                 .reset = tdmf_take_patch_border,
                                 .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_FORCE_PEAK] = {.guard = tdmf_armed_force_peak},
    [TDMF_GUARD_VERTICAL_FORCE_PEAK] = {.guard = tdmf_armed_vertical_force_peak},
    [TDMF_GUARD_GRAZE_TO_CONTACT] = {.guard = tdmf_graze_to_contact_guard,
                                     .vary_guard = tdmf_vary_graze_to_contact_guard,
                                     .reset = tdmf_take_graze_to_contact,
                                     .reach = TDMF_REACH_WITHIN_MARGIN},
    [TDMF_GUARD_GRAZE_TO_FLIGHT] = {.guard = tdmf_graze_to_flight_guard,
                                    .vary_guard = tdmf_vary_armed_graze_to_flight,
                                    .reset = tdmf_take_graze_to_flight,
                                    .reach = TDMF_REACH_WITHIN_MARGIN},
};

/* In the order in which they are taken at one instant. */
static const watched in_flight[] = {
    {TDMF_GUARD_NEW_GROUND, ALWAYS},    {TDMF_GUARD_BODY_DOWN, ALWAYS}, {TDMF_GUARD_LEG_TOO_SHORT, ALWAYS},
    {TDMF_GUARD_APEX, RETRACT | PLACE}, {TDMF_GUARD_TOUCHDOWN, ALWAYS}, {TDMF_GUARD_CLAMP, RETRACT},
};
enum { OBSERVED_IN_FLIGHT = 0 };

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
enum { OBSERVED_IN_STICK = 2 };

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
enum { OBSERVED_IN_SLIP = 2 };

static const watched in_graze[] = {
    {TDMF_GUARD_BODY_DOWN, ALWAYS},
    {TDMF_GUARD_LEG_TOO_SHORT, ALWAYS},
    {TDMF_GUARD_APEX, RETRACT},
    {TDMF_GUARD_MID_STANCE, ALWAYS},
    {TDMF_GUARD_GRAZE_TO_CONTACT, ALWAYS},
    {TDMF_GUARD_GRAZE_TO_FLIGHT, ALWAYS},
};
enum { OBSERVED_IN_GRAZE = 0 };

#define END(events) ((events) + sizeof(events) / sizeof((events)[0]))
#define LIST(events, observed)                                                                               \
    { events, END(events) - (observed), END(events) }

static const watch_list watched_by[] = {
    [TDMF_CONTACT_FLIGHT] = LIST(in_flight, OBSERVED_IN_FLIGHT),
    [TDMF_CONTACT_STICK] = LIST(in_stick, OBSERVED_IN_STICK),
    [TDMF_CONTACT_SLIP_POSITIVE] = LIST(in_slip, OBSERVED_IN_SLIP),
    [TDMF_CONTACT_SLIP_NEGATIVE] = LIST(in_slip, OBSERVED_IN_SLIP),
    [TDMF_CONTACT_GRAZE] = LIST(in_graze, OBSERVED_IN_GRAZE),
};

#endif
