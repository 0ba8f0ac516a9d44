/* Runs over a patch of ground, and two without one, by an independent program in extended precision. */
#ifndef TDMF_TESTS_PATCH_RUNS_H
#define TDMF_TESTS_PATCH_RUNS_H

#include "integrate.h"
#include "tdmf_slip/return_map.h"

enum { PATCH_RUNS = 9, MAX_STRIDES_OF_RUN = 9, MAX_CROSSINGS = 3 };

typedef struct {
    double friction, static_friction_ratio, stribeck_velocity, slope; /* a ratio of 0: 1 */
    double begin, end, patch_friction;
    double start[TDMF_SECTION_COUNT]; /* with the foot at x = 0 */
    int strides;
    const char *words[MAX_STRIDES_OF_RUN];
    double end_apex[TDMF_SECTION_COUNT], end_foot_x, end_time;
    double first_apex[TDMF_SECTION_COUNT], first_foot_x; /* after one stride, where it is told */
    int crossings;
    double crossing_times[MAX_CROSSINGS];
    struct {
        double period, speed, cost_of_transport, slip_distance, friction_loss;
    } last;                                              /* last stride, if reported */
    double fall_time, fall_state[TDMF_MECHANICAL_COUNT]; /* the fall after it */
} patch_run;

extern const patch_run patch_runs[PATCH_RUNS];

tdmf_parameters parameters_of_patch_run(const patch_run *run);
tdmf_inputs inputs_of_patch_run(const patch_run *run);

#endif
