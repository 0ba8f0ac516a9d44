/* The series of the motions, for the width that a file is compiled for. */
#ifndef TDMF_KERNEL_MOTION_SERIES_H
#define TDMF_KERNEL_MOTION_SERIES_H

#include "width.h"

#ifdef TDMF_LANES
#include "lane_series.h"
#else
#include "scalar_series.h"
#endif

#endif
