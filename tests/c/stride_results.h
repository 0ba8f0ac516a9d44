/* Results of a stride from an apex, and their derivatives, in one row: the next apex, period, length, work,
 * stance time, slip distance, peak force, peak vertical force, and the measures that are smooth: the hip's
 * positive work has a kink where a power is zero for a while. */
#ifndef TDMF_TESTS_STRIDE_RESULTS_H
#define TDMF_TESTS_STRIDE_RESULTS_H

#include "tdmf_slip/return_map.h"

#include <string.h>

enum { RESULTS = TDMF_SECTION_COUNT + 12 };

static inline void write_smooth_measures(const tdmf_stride_measures *measures, double results[5]) {
    const double written[5] = {measures->positive_leg_work, measures->squared_torque, measures->friction_loss,
                               measures->greatest_slip_velocity, measures->greatest_foot_height};
    memcpy(results, written, sizeof written);
}

static inline void results_of(const tdmf_return *stride, double results[RESULTS]) {
    memcpy(results, stride->apex, sizeof stride->apex);
    results[TDMF_SECTION_COUNT] = stride->stride.period;
    results[TDMF_SECTION_COUNT + 1] = stride->stride.length;
    results[TDMF_SECTION_COUNT + 2] = stride->stride.work;
    results[TDMF_SECTION_COUNT + 3] = stride->stride.stance_time;
    results[TDMF_SECTION_COUNT + 4] = stride->stride.slip_distance;
    results[TDMF_SECTION_COUNT + 5] = stride->stride.peak_force;
    results[TDMF_SECTION_COUNT + 6] = stride->stride.peak_vertical_force;
    write_smooth_measures(&stride->measures, results + TDMF_SECTION_COUNT + 7);
}

static inline void derivatives_of(const tdmf_stride_variation *change, double derivatives[RESULTS]) {
    memcpy(derivatives, change->apex, sizeof change->apex);
    derivatives[TDMF_SECTION_COUNT] = change->period;
    derivatives[TDMF_SECTION_COUNT + 1] = change->length;
    derivatives[TDMF_SECTION_COUNT + 2] = change->work;
    derivatives[TDMF_SECTION_COUNT + 3] = change->stance_time;
    derivatives[TDMF_SECTION_COUNT + 4] = change->slip_distance;
    derivatives[TDMF_SECTION_COUNT + 5] = change->peak_force;
    derivatives[TDMF_SECTION_COUNT + 6] = change->peak_vertical_force;
    write_smooth_measures(&change->measures, derivatives + TDMF_SECTION_COUNT + 7);
}

#endif
