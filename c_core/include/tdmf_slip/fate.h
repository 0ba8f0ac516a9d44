/* Where runners end that start somewhere: on a gait, or on the ground. */
#ifndef TDMF_SLIP_FATE_H
#define TDMF_SLIP_FATE_H

#include "tdmf_slip/return_map.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
    TDMF_FATE_SETTLED,   /* on a gait */
    TDMF_FATE_FELL,      /* or closed no more stride */
    TDMF_FATE_UNDECIDED, /* neither within the strides allowed */
    TDMF_FATE_NO_START   /* the start is no apex above the ground */
} tdmf_fate_kind;

typedef struct {
    int kind;    /* a tdmf_fate_kind */
    int gait;    /* which, counted from 0; -1 for none */
    int strides; /* closed on the way */
} tdmf_fate;

/* When a runner counts as settled: its apex is this near that of a gait, over the section's scales; and how
 * many strides it has to get there. The distance has to be small enough for the gait to attract everything
 * within it. */
typedef struct {
    const double (*gaits)[TDMF_SECTION_COUNT];
    int gait_count;
    double distance;
    int most_strides;
} tdmf_fate_rules;

/* Follows each of `count` runners from its apex. A runner's fate depends on its own start alone, so that any
 * number of threads may work on parts of the same arrays, each with a solver of its own. */
void tdmf_find_fates(tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs,
                     const tdmf_fate_rules *rules, const double (*sections)[TDMF_SECTION_COUNT], long count,
                     tdmf_fate *fates);

#ifdef __cplusplus
}
#endif
#endif
