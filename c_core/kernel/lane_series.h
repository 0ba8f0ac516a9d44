/* The series of several runners side by side. */
#ifndef TDMF_KERNEL_LANE_SERIES_H
#define TDMF_KERNEL_LANE_SERIES_H

#include "lanes.h"
#include "series.h"

#include "series_products.h"

#include "flight_series.h"
#include "ground_series.h"

#endif
