/* Quantities of a stride that are met along it and change nothing: integrals, and the greatest of what has a
 * turn, each with its first variations. Only strides that are asked for them pay for them. */
#ifndef TDMF_SOLVER_STRIDE_MEASURES_H
#define TDMF_SOLVER_STRIDE_MEASURES_H

#include "mode_variation.h"
#include "saltation.h"
#include "tdmf_slip/return_map.h"

typedef struct {
    tdmf_stride_measures so_far;
    tdmf_stride_measures varied[TDMF_VARIATION_LIMIT]; /* at a fixed time, as variations are */
} tdmf_measured;

/* A step of the motion, with as many variations as there are. */
typedef struct {
    const tdmf_step *step;
    const tdmf_motion *motion; /* its state is of the last event */
    double end;
    bool ends_at_event; /* what is met there is the event's */
    int count;
    const tdmf_seed *seeds;
    const tdmf_mode_variation *varied_mode; /* at the step's start */
    const motion_variation *varied_series;  /* along it */
} tdmf_measured_step;

/* How far the foot's height may be trusted to be known along a step in flight; else infinity. */
double tdmf_measures_trust(const tdmf_step *step);

/* Begins to measure at the apex where a stride begins. */
void tdmf_measure_start(tdmf_measured *measured, const tdmf_model *model, const tdmf_motion *motion,
                        const tdmf_seed *seeds, const tdmf_variation *variations, int count);

/* Measures along a step that has been searched for its end. */
void tdmf_measure_step(tdmf_measured *measured, const tdmf_measured_step *taken);

/* Measures at an event, with what each variation is there. */
void tdmf_measure_event(tdmf_measured *measured, tdmf_system system, const tdmf_event_state *before,
                        const tdmf_event_state *after, const tdmf_seed *seeds, const tdmf_met_event *met,
                        int count);

/* Ends the measures at the apex where the stride closes; the variation of that number meets it later by
 * `shift`. */
void tdmf_measure_end(tdmf_measured *measured, const tdmf_motion *motion);
void tdmf_vary_measured_end(tdmf_measured *measured, int number, tdmf_system system,
                            const tdmf_motion *motion, const double derivatives[TDMF_STATE_COUNT],
                            double shift);

/* As tdmf_native_stride_varied, by the series of return maps and ensembles. */
tdmf_stride_outcome tdmf_map_stride(tdmf_solver *solver, tdmf_system system, double until,
                                    tdmf_motion *motion, const tdmf_seed *seeds, tdmf_variation *variations,
                                    int count);

/* The same, and measures the stride. */
tdmf_stride_outcome tdmf_native_stride_measured(tdmf_solver *solver, tdmf_system system, double until,
                                                tdmf_motion *motion, const tdmf_seed *seeds,
                                                tdmf_variation *variations, int count,
                                                tdmf_measured *measured);

#endif
