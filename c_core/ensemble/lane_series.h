/* The series of several runners side by side. */
#ifndef TDMF_ENSEMBLE_LANE_SERIES_H
#define TDMF_ENSEMBLE_LANE_SERIES_H

#include "lanes.h"
#include "series.h"
#include "series_products.h"

typedef struct {
    flight_factor of[SERIES_TERMS];
} flight_factors;

static inline void flight_sums(const flight_factors *factors, int k, real sum[FLIGHT_PRODUCTS]) {
    for (int i = 0; i < FLIGHT_PRODUCTS; ++i) {
        sum[i] = real_of(0.0);
    }
    for (int term = 1; term < k; ++term) {
        const flight_factor *a = &factors->of[term];
        const flight_factor *b = &factors->of[k - term];
        sum[FLIGHT_LENGTH_LENGTH] += a->length * b->length;
        sum[FLIGHT_SQUARE_RATE] += a->square * b->angle_rate;
        sum[FLIGHT_LENGTH_RATE] += a->length * b->angle_rate;
        sum[FLIGHT_ACROSS_RATE] += a->across * b->angle_rate;
        sum[FLIGHT_RATE_RATE] += a->angle_rate * b->angle_rate;
        sum[FLIGHT_SPEED_SPEED] += a->length_rate * b->length_rate;
    }
}

static inline void flight_keep(flight_factors *factors, int k, const flight_factor *factor) {
    factors->of[k] = *factor;
}

typedef struct {
    ground_factor of[SERIES_TERMS];
} ground_factors;

static inline void place_sums(const ground_factors *factors, int k, real sum[PLACE_PRODUCTS]) {
    for (int i = 0; i < PLACE_PRODUCTS; ++i) {
        sum[i] = real_of(0.0);
    }
    for (int term = 1; term < k; ++term) {
        const ground_factor *a = &factors->of[term];
        const ground_factor *b = &factors->of[k - term];
        sum[PLACE_X_X] += a->x * b->x;
        sum[PLACE_Y_Y] += a->y * b->y;
        sum[PLACE_LENGTH_LENGTH] += a->length * b->length;
    }
}

static inline void place_keep(ground_factors *factors, int k, real x, real y, real length) {
    factors->of[k].x = x;
    factors->of[k].y = y;
    factors->of[k].length = length;
}

static inline void ground_sums(const ground_factors *factors, int k, bool free, real sum[FREE_PRODUCTS]) {
    for (int i = 0; i < FREE_PRODUCTS; ++i) {
        sum[i] = real_of(0.0);
    }
    for (int term = 1; term < k; ++term) {
        const ground_factor *a = &factors->of[term];
        const ground_factor *b = &factors->of[k - term];
        sum[LENGTH_AXIAL] += a->length * b->axial;
        sum[X_AXIAL] += a->x * b->axial;
        sum[Y_AXIAL] += a->y * b->axial;
        sum[SQUARE_TURNING] += a->square * b->turning;
        sum[X_TURNING] += a->x * b->turning;
        sum[Y_TURNING] += a->y * b->turning;
        sum[SQUARE_RATE] += a->square * b->angle_rate;
        sum[SPEED_SPEED] += a->length_rate * b->length_rate;
        if (free) {
            sum[Y_ACCELERATION] += a->y * b->acceleration;
            sum[LOSS] += a->loss_left * b->loss_right;
        }
    }
}

static inline void ground_keep(ground_factors *factors, int k, bool free, const ground_factor *factor) {
    (void)free;
    factors->of[k] = *factor;
}

#include "flight_series.h"
#include "ground_series.h"

#endif
