/* The series of one runner. */
#ifndef TDMF_KERNEL_SCALAR_SERIES_H
#define TDMF_KERNEL_SCALAR_SERIES_H

#include "series.h"
#include "series_sums.h"

#include <math.h>
#include <stdbool.h>

typedef double real;

static inline real real_of(double x) {
    return x;
}

static inline real larger(real a, real b) {
    return a > b ? a : b;
}

static inline real real_sqrt(real x) {
    return sqrt(x);
}

#include "series_products.h"

#include "flight_series.h"
#include "ground_series.h"

#endif
