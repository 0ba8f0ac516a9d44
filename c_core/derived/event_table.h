/* Derived from c_core/equations/events.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_EVENT_TABLE_H
#define TDMF_DERIVED_EVENT_TABLE_H

#include "event_declarations.h"
#include "friction_laws.h"
#include "guard_laws.h"

#include <string.h>

static double armed_body_down(const tdmf_evaluation *at) {
    return tdmf_body_down_guard(at) / at->model->scales.length + TDMF_GUARD_MARGIN;
}

static double armed_leg_too_short(const tdmf_evaluation *at) {
    return tdmf_leg_too_short_guard(at) / at->model->scales.length + TDMF_GUARD_MARGIN;
}

static double armed_apex(const tdmf_evaluation *at) {
    return tdmf_apex_guard(at) / at->model->scales.speed +
           (at->mode->rises ? TDMF_APEX_MARGIN : TDMF_DEAD_BAND);
}

static void vary_take_apex(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_ground_line *ground,
                           const double before[TDMF_STATE_COUNT], const tdmf_direction *d,
                           double d_state[TDMF_STATE_COUNT]) {
    double d_before[TDMF_STATE_COUNT];
    memcpy(d_before, d_state, sizeof d_before);
    tdmf_vary_apex_jump(model, inputs, ground, before, tdmf_leg_direction_of(before), &d->model, &d->inputs,
                        &d->mode.ground, d_before, d_state);
}

static double armed_touchdown(const tdmf_evaluation *at) {
    return (tdmf_touchdown_guard(at) + tdmf_rounding_at_foot(at)) / at->model->scales.length +
           TDMF_GUARD_MARGIN;
}

static double armed_clamp(const tdmf_evaluation *at) {
    return tdmf_clamp_guard(at) / at->model->scales.energy + TDMF_DEAD_BAND;
}

static double armed_greatest_compression(const tdmf_evaluation *at) {
    return at->mode->thrusts
               ? 1.0
               : tdmf_greatest_compression_guard(at) / at->model->scales.speed + TDMF_GUARD_MARGIN;
}

static double armed_mid_stance(const tdmf_evaluation *at) {
    return !at->mode->mid_stance_pending ? 1.0 : tdmf_mid_stance_guard(at) + TDMF_GUARD_MARGIN;
}

static double armed_lift_off(const tdmf_evaluation *at) {
    return tdmf_lift_off_guard(at) / at->model->scales.force + TDMF_GUARD_MARGIN;
}

static double armed_slip_onset_positive(const tdmf_evaluation *at) {
    return tdmf_slip_onset_positive_guard(at) /
               (at->model->scales.force * tdmf_cone_width(at->model, at->inputs)) +
           TDMF_GUARD_MARGIN;
}

static double armed_slip_onset_negative(const tdmf_evaluation *at) {
    return tdmf_slip_onset_negative_guard(at) /
               (at->model->scales.force * tdmf_cone_width(at->model, at->inputs)) +
           TDMF_GUARD_MARGIN;
}

static double armed_slip_velocity_zero(const tdmf_evaluation *at) {
    return tdmf_slip_velocity_zero_guard(at, tdmf_sign_of_slip(at->mode)) / at->model->scales.speed +
           TDMF_GUARD_MARGIN;
}

static double vary_slip_velocity_zero(const tdmf_evaluation *at, const tdmf_evaluation *d) {
    return tdmf_vary_slip_velocity_zero_guard(at, tdmf_sign_of_slip(at->mode), d);
}

static double armed_graze_to_contact(const tdmf_evaluation *at) {
    return tdmf_graze_to_contact_guard(at) / at->model->scales.force + TDMF_GUARD_MARGIN;
}

static double armed_graze_to_flight(const tdmf_evaluation *at) {
    return tdmf_graze_to_flight_guard(at) / at->model->scales.force + TDMF_GUARD_MARGIN;
}

static const tdmf_event_kind kinds[TDMF_GUARD_COUNT] = {
    [TDMF_GUARD_NEW_GROUND] = {.guard = tdmf_armed_new_ground,
                               .vary_guard = tdmf_vary_armed_new_ground,
                               .reset = tdmf_take_new_ground,
                               .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_BODY_DOWN] = {.guard = armed_body_down,
                              .reset = tdmf_take_fall,
                              .reach = TDMF_REACH_WITHIN_MARGIN},
    [TDMF_GUARD_LEG_TOO_SHORT] = {.guard = armed_leg_too_short,
                                  .reset = tdmf_take_fall,
                                  .reach = TDMF_REACH_WITHIN_MARGIN},
    [TDMF_GUARD_APEX] = {.guard = armed_apex,
                         .vary_guard = tdmf_vary_apex_guard,
                         .reset = tdmf_take_apex,
                         .vary_reset = vary_take_apex,
                         .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_TOUCHDOWN] = {.guard = armed_touchdown,
                              .vary_guard = tdmf_vary_touchdown_guard,
                              .reset = tdmf_take_touchdown,
                              .vary_reset = tdmf_vary_take_touchdown,
                              .reach = TDMF_REACH_WITHIN_DEAD_BAND,
                              .is_impact = true},
    [TDMF_GUARD_CLAMP] = {.guard = armed_clamp,
                          .vary_guard = tdmf_vary_clamp_guard,
                          .reset = tdmf_take_clamp,
                          .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_GREATEST_COMPRESSION] = {.guard = armed_greatest_compression,
                                         .vary_guard = tdmf_vary_greatest_compression_guard,
                                         .reset = tdmf_take_greatest_compression,
                                         .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_MID_STANCE] = {.guard = armed_mid_stance,
                               .vary_guard = tdmf_vary_mid_stance_guard,
                               .reset = tdmf_take_mid_stance,
                               .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_LIFT_OFF] = {.guard = armed_lift_off,
                             .vary_guard = tdmf_vary_lift_off_guard,
                             .reset = tdmf_take_lift_off,
                             .reach = TDMF_REACH_WITHIN_MARGIN},
    [TDMF_GUARD_SLIP_ONSET_POSITIVE] = {.guard = armed_slip_onset_positive,
                                        .vary_guard = tdmf_vary_slip_onset_positive_guard,
                                        .reset = tdmf_take_slip_onset_positive,
                                        .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_SLIP_ONSET_NEGATIVE] = {.guard = armed_slip_onset_negative,
                                        .vary_guard = tdmf_vary_slip_onset_negative_guard,
                                        .reset = tdmf_take_slip_onset_negative,
                                        .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_SLIP_VELOCITY_ZERO] = {.guard = armed_slip_velocity_zero,
                                       .vary_guard = vary_slip_velocity_zero,
                                       .reset = tdmf_take_slip_velocity_zero,
                                       .reach = TDMF_REACH_WITHIN_DEAD_BAND},
    [TDMF_GUARD_FORCE_PEAK] = {.guard = tdmf_armed_force_peak},
    [TDMF_GUARD_VERTICAL_FORCE_PEAK] = {.guard = tdmf_armed_vertical_force_peak},
    [TDMF_GUARD_GRAZE_TO_CONTACT] = {.guard = armed_graze_to_contact,
                                     .vary_guard = tdmf_vary_graze_to_contact_guard,
                                     .reset = tdmf_take_graze_to_contact,
                                     .reach = TDMF_REACH_WITHIN_MARGIN},
    [TDMF_GUARD_GRAZE_TO_FLIGHT] = {.guard = armed_graze_to_flight,
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
