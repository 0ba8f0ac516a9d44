/* First variations of ReducedRunner along two seeds at once, by motions of two lanes. */
#define TDMF_LANES 2
#define TDMF_LANES_ARE_SEEDS

#include "reduced_runner_motions.c"

#include "seeds.h"

const tdmf_seed_kind tdmf_reduced_runner_seeds = {
    TDMF_OF_WIDTH(tdmf_reduced_runner_motions), fill_seed_lanes, vary_seed_lanes, read_seed_lane};
