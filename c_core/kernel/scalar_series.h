/* The series of one runner. */
#ifndef TDMF_KERNEL_SCALAR_SERIES_H
#define TDMF_KERNEL_SCALAR_SERIES_H

#include "series.h"
#include "series_sums.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

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

/* Several products at once. Side by side, in pairs, they fill vector registers, which not every compiler
 * finds out by itself. */
#if defined(__GNUC__) && !defined(TDMF_EXTENDED_PRECISION)
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

typedef struct {
    real left[SERIES_TERMS][FLIGHT_PRODUCTS], right[SERIES_TERMS][FLIGHT_PRODUCTS];
} flight_factors;

static inline void flight_sums(const flight_factors *factors, int k, real sum[FLIGHT_PRODUCTS]) {
    SUM_PRODUCTS(FLIGHT_PRODUCTS, sum, factors->left, factors->right, k);
}

static inline void flight_keep(flight_factors *factors, int k, const flight_factor *f) {
    const real left[FLIGHT_PRODUCTS] = {f->length, f->square,     f->length,
                                        f->across, f->angle_rate, f->length_rate};
    const real right[FLIGHT_PRODUCTS] = {f->length,     f->angle_rate, f->angle_rate,
                                         f->angle_rate, f->angle_rate, f->length_rate};
    for (int lane = 0; lane < FLIGHT_PRODUCTS; ++lane) {
        factors->left[k][lane] = left[lane];
        factors->right[k][lane] = right[lane];
    }
}

enum { PLACE_PAIRED = PLACE_PRODUCTS + 1 };

typedef struct {
    real place[SERIES_TERMS][PLACE_PAIRED];
    real left[SERIES_TERMS][FREE_PRODUCTS], right[SERIES_TERMS][FREE_PRODUCTS];
} ground_factors;

static inline void place_sums(const ground_factors *factors, int k, real sum[PLACE_PRODUCTS]) {
    real paired[PLACE_PAIRED];
    SUM_PRODUCTS(PLACE_PAIRED, paired, factors->place, factors->place, k);
    memcpy(sum, paired, PLACE_PRODUCTS * sizeof *sum);
}

static inline void place_keep(ground_factors *factors, int k, real x, real y, real length) {
    const real place[PLACE_PAIRED] = {x, y, length, 0.0};
    for (int lane = 0; lane < PLACE_PAIRED; ++lane) {
        factors->place[k][lane] = place[lane];
    }
}

static inline void ground_sums(const ground_factors *factors, int k, bool free, real sum[FREE_PRODUCTS]) {
    if (free) {
        SUM_PRODUCTS(FREE_PRODUCTS, sum, factors->left, factors->right, k);
    } else {
        SUM_PRODUCTS(STICK_PRODUCTS, sum, factors->left, factors->right, k);
    }
}

static inline void ground_keep(ground_factors *factors, int k, bool free, const ground_factor *f) {
    const real left[FREE_PRODUCTS] = {f->length, f->x,      f->y,           f->square, f->x,
                                      f->y,      f->square, f->length_rate, f->y,      f->loss_left};
    const real right[FREE_PRODUCTS] = {f->axial,        f->axial,     f->axial,      f->turning,
                                       f->turning,      f->turning,   f->angle_rate, f->length_rate,
                                       f->acceleration, f->loss_right};
    for (int lane = 0; lane < (free ? FREE_PRODUCTS : STICK_PRODUCTS); ++lane) {
        factors->left[k][lane] = left[lane];
        factors->right[k][lane] = right[lane];
    }
}

#include "flight_series.h"
#include "ground_series.h"

#endif
