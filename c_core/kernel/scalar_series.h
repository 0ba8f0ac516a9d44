/* The series of one runner. */
#ifndef TDMF_KERNEL_SCALAR_SERIES_H
#define TDMF_KERNEL_SCALAR_SERIES_H

#include "series.h"
#include "series_sums.h"
#include "width_one.h"

#include "series_products.h"

#include "flight_series.h"
#include "ground_series.h"

#endif
