/* The series of one runner. */
#ifndef TDMF_SOLVER_SCALAR_SERIES_H
#define TDMF_SOLVER_SCALAR_SERIES_H

#include "series.h"
#include "series_sums.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

typedef double real;

static inline real real_of(double x) {
    return x;
}

static inline real real_sqrt(real x) {
    return sqrt(x);
}

/* Coefficient k of several products of series at once, less the terms with coefficient 0 of a factor: those
 * hold the newest coefficients, which are not in the tables yet. Side by side, in pairs, they fill vector
 * registers, which not every compiler finds out by itself. */
#if defined(__GNUC__)
typedef double pair __attribute__((vector_size(16), aligned(8)));
#define SUM_PRODUCTS(count, sum, left, right, k)                                                             \
    do {                                                                                                     \
        pair pairs[(count) / 2];                                                                             \
        for (int lane = 0; lane < (count) / 2; ++lane) {                                                     \
            pairs[lane] = (pair){0.0, 0.0};                                                                  \
        }                                                                                                    \
        for (int term = 1; term < (k); ++term) {                                                             \
            const pair *a = (const pair *)(const void *)(left)[term];                                        \
            const pair *b = (const pair *)(const void *)(right)[(k)-term];                                   \
            for (int lane = 0; lane < (count) / 2; ++lane) {                                                 \
                pairs[lane] += a[lane] * b[lane];                                                            \
            }                                                                                                \
        }                                                                                                    \
        memcpy(sum, pairs, sizeof pairs);                                                                    \
    } while (0)
#else
#define SUM_PRODUCTS(count, sum, left, right, k)                                                             \
    do {                                                                                                     \
        for (int lane = 0; lane < (count); ++lane) {                                                         \
            (sum)[lane] = 0.0;                                                                               \
        }                                                                                                    \
        for (int term = 1; term < (k); ++term) {                                                             \
            for (int lane = 0; lane < (count); ++lane) {                                                     \
                (sum)[lane] += (left)[term][lane] * (right)[(k)-term][lane];                                 \
            }                                                                                                \
        }                                                                                                    \
    } while (0)
#endif

#include "flight_series.h"
#include "ground_series.h"

#endif
