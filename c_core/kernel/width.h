/* How many runners a file steps side by side: TDMF_LANES, or one. `real` holds a number for each of them,
 * `choice` says of each whether it is chosen. The kernel is written once over these. */
#ifndef TDMF_KERNEL_WIDTH_H
#define TDMF_KERNEL_WIDTH_H

#ifdef TDMF_LANES
#include "lane_math.h"
#else
#include "width_one.h"
#endif

#endif
