/* A block of a region of attraction: many starts, each with its fate, two side by side in a vector register.
 */
#include "live.h"

enum { BLOCK_CAPACITY = 512 };

static double starts[BLOCK_CAPACITY][TDMF_SECTION_COUNT];
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
    const tdmf_ensemble_case runner = {&live.model,
                                       live.inputs,
                                       {.gaits = (const double(*)[TDMF_SECTION_COUNT])live.section,
                                        .gait_count = 1,
                                        .distance = distance,
                                        .max_strides = max_strides}};
    const tdmf_ensemble ensemble = {.cases = &runner,
                                    .case_count = 1,
                                    .starts = (const double(*)[TDMF_SECTION_COUNT])starts,
                                    .count = count,
                                    .relative_tolerance = tolerance,
                                    .threads = 1,
                                    .instructions = TDMF_BEST_INSTRUCTIONS};
    if (count > BLOCK_CAPACITY || !tdmf_run_ensemble(&ensemble, ends, NULL)) {
        return false;
    }
    for (int i = 0; i < count; ++i) {
        fates[i][0] = ends[i].fate;
        fates[i][1] = ends[i].strides;
    }
    return true;
}
