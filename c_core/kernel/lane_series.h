/* The series of several runners side by side. */
#ifndef TDMF_KERNEL_LANE_SERIES_H
#define TDMF_KERNEL_LANE_SERIES_H

#include "lanes.h"
#include "series.h"
#include "series_products.h"

/* Sums go inwards from both ends, so that a factor that is loaded serves twice, and squares are summed once
 * only. */
typedef struct {
    flight_factor of[SERIES_TERMS];
} flight_factors;

static inline void flight_sums(const flight_factors *factors, int k, real sum[FLIGHT_PRODUCTS]) {
    int i = 1, j = k - 1;
    for (int product = 0; product < FLIGHT_PRODUCTS; ++product) {
        sum[product] = real_of(0.0);
    }
    for (; i < j; ++i, --j) {
        const flight_factor *a = &factors->of[i];
        const flight_factor *b = &factors->of[j];
        sum[FLIGHT_LENGTH_LENGTH] += a->length * b->length;
        sum[FLIGHT_RATE_RATE] += a->angle_rate * b->angle_rate;
        sum[FLIGHT_SPEED_SPEED] += a->length_rate * b->length_rate;
        sum[FLIGHT_SQUARE_RATE] += a->square * b->angle_rate + b->square * a->angle_rate;
        sum[FLIGHT_LENGTH_RATE] += a->length * b->angle_rate + b->length * a->angle_rate;
        sum[FLIGHT_ACROSS_RATE] += a->across * b->angle_rate + b->across * a->angle_rate;
    }
    sum[FLIGHT_LENGTH_LENGTH] *= 2.0;
    sum[FLIGHT_RATE_RATE] *= 2.0;
    sum[FLIGHT_SPEED_SPEED] *= 2.0;
    if (i == j) {
        const flight_factor *a = &factors->of[i];
        sum[FLIGHT_LENGTH_LENGTH] += a->length * a->length;
        sum[FLIGHT_RATE_RATE] += a->angle_rate * a->angle_rate;
        sum[FLIGHT_SPEED_SPEED] += a->length_rate * a->length_rate;
        sum[FLIGHT_SQUARE_RATE] += a->square * a->angle_rate;
        sum[FLIGHT_LENGTH_RATE] += a->length * a->angle_rate;
        sum[FLIGHT_ACROSS_RATE] += a->across * a->angle_rate;
    }
}

static inline void flight_keep(flight_factors *factors, int k, const flight_factor *factor) {
    factors->of[k] = *factor;
}

typedef struct {
    ground_factor of[SERIES_TERMS];
} ground_factors;

static inline void place_sums(const ground_factors *factors, int k, real sum[PLACE_PRODUCTS]) {
    int i = 1, j = k - 1;
    for (int product = 0; product < PLACE_PRODUCTS; ++product) {
        sum[product] = real_of(0.0);
    }
    for (; i < j; ++i, --j) {
        const ground_factor *a = &factors->of[i];
        const ground_factor *b = &factors->of[j];
        sum[PLACE_X_X] += a->x * b->x;
        sum[PLACE_Y_Y] += a->y * b->y;
        sum[PLACE_LENGTH_LENGTH] += a->length * b->length;
    }
    for (int product = 0; product < PLACE_PRODUCTS; ++product) {
        sum[product] *= 2.0;
    }
    if (i == j) {
        const ground_factor *a = &factors->of[i];
        sum[PLACE_X_X] += a->x * a->x;
        sum[PLACE_Y_Y] += a->y * a->y;
        sum[PLACE_LENGTH_LENGTH] += a->length * a->length;
    }
}

static inline void place_keep(ground_factors *factors, int k, real x, real y, real length) {
    factors->of[k].x = x;
    factors->of[k].y = y;
    factors->of[k].length = length;
}

/* The products of one term by another that are not squares. */
static inline void add_ground_products(const ground_factor *a, const ground_factor *b, bool free,
                                       real sum[FREE_PRODUCTS]) {
    sum[LENGTH_AXIAL] += a->length * b->axial;
    sum[X_AXIAL] += a->x * b->axial;
    sum[Y_AXIAL] += a->y * b->axial;
    sum[SQUARE_TURNING] += a->square * b->turning;
    sum[X_TURNING] += a->x * b->turning;
    sum[Y_TURNING] += a->y * b->turning;
    sum[SQUARE_RATE] += a->square * b->angle_rate;
    if (free) {
        sum[Y_ACCELERATION] += a->y * b->acceleration;
        sum[LOSS] += a->loss_left * b->loss_right;
    }
}

static inline void ground_sums(const ground_factors *factors, int k, bool free, real sum[FREE_PRODUCTS]) {
    int i = 1, j = k - 1;
    for (int product = 0; product < FREE_PRODUCTS; ++product) {
        sum[product] = real_of(0.0);
    }
    for (; i < j; ++i, --j) {
        const ground_factor *a = &factors->of[i];
        const ground_factor *b = &factors->of[j];
        add_ground_products(a, b, free, sum);
        add_ground_products(b, a, free, sum);
        sum[SPEED_SPEED] += a->length_rate * b->length_rate;
    }
    sum[SPEED_SPEED] *= 2.0;
    if (i == j) {
        const ground_factor *a = &factors->of[i];
        add_ground_products(a, a, free, sum);
        sum[SPEED_SPEED] += a->length_rate * a->length_rate;
    }
}

static inline void ground_keep(ground_factors *factors, int k, bool free, const ground_factor *factor) {
    (void)free;
    factors->of[k] = *factor;
}

#include "flight_series.h"
#include "ground_series.h"

#endif
