/* A block of a region of attraction: many starts, each with its fate, two side by side in a vector register.
 */
#include "live.h"

#include <string.h>

enum { BLOCK_CAPACITY = 512 };

static double starts[BLOCK_CAPACITY][TDMF_SECTION_COUNT];
static double apices[BLOCK_CAPACITY][TDMF_POINT_LIMIT], gait[1][TDMF_POINT_LIMIT];
static tdmf_ensemble_end ends[BLOCK_CAPACITY];
static int fates[BLOCK_CAPACITY][2]; /* a tdmf_fate, and the strides until then */

LIVE_EXPORT(live_block_capacity)
int live_block_capacity(void) {
    return BLOCK_CAPACITY;
}

LIVE_EXPORT(live_starts)
double *live_starts(void) {
    return &starts[0][0];
}

LIVE_EXPORT(live_fates)
int *live_fates(void) {
    return &fates[0][0];
}

/* Runs the first `count` starts; they may settle on the gait whose apex is in the section. */
LIVE_EXPORT(live_run_block)
bool live_run_block(int count, double tolerance, double distance, int max_strides) {
    const tdmf_ensemble_case runner = {.model = &live.model,
                                       .inputs = live.inputs,
                                       .rules = {.gaits = (const double(*)[TDMF_POINT_LIMIT])gait,
                                                 .gait_count = 1,
                                                 .distance = distance,
                                                 .max_strides = max_strides}};
    const tdmf_ensemble ensemble = {.cases = &runner,
                                    .case_count = 1,
                                    .starts = (const double(*)[TDMF_POINT_LIMIT])apices,
                                    .count = count,
                                    .relative_tolerance = tolerance,
                                    .threads = 1,
                                    .instructions = TDMF_BEST_INSTRUCTIONS};
    memcpy(gait[0], live.section, sizeof live.section);
    for (int i = 0; i < count && i < BLOCK_CAPACITY; ++i) {
        memcpy(apices[i], starts[i], sizeof starts[i]);
    }
    if (count > BLOCK_CAPACITY || tdmf_run_ensemble(&ensemble, ends, NULL).code != TDMF_ACCEPTED) {
        return false;
    }
    for (int i = 0; i < count; ++i) {
        fates[i][0] = ends[i].fate;
        fates[i][1] = ends[i].strides;
    }
    return true;
}
