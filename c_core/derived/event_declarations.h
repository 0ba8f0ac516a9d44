/* Derived from c_core/equations/events.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_EVENT_DECLARATIONS_H
#define TDMF_DERIVED_EVENT_DECLARATIONS_H

#include "events.h"

void tdmf_take_new_ground(tdmf_run *run);
void tdmf_take_fall(tdmf_run *run);
void tdmf_take_apex(tdmf_run *run);
void tdmf_take_touchdown(tdmf_run *run);
void tdmf_take_clamp(tdmf_run *run);
void tdmf_take_greatest_compression(tdmf_run *run);
void tdmf_take_mid_stance(tdmf_run *run);
void tdmf_take_lift_off(tdmf_run *run);
void tdmf_take_slip_onset_positive(tdmf_run *run);
void tdmf_take_slip_onset_negative(tdmf_run *run);
void tdmf_take_slip_velocity_zero(tdmf_run *run);
void tdmf_take_patch_border(tdmf_run *run);
void tdmf_take_graze_to_contact(tdmf_run *run);
void tdmf_take_graze_to_flight(tdmf_run *run);
double tdmf_armed_new_ground(const tdmf_evaluation *at);
double tdmf_armed_patch_border(const tdmf_evaluation *at);
double tdmf_armed_force_peak(const tdmf_evaluation *at);
double tdmf_armed_vertical_force_peak(const tdmf_evaluation *at);

#endif
