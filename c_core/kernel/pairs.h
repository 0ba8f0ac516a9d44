/* Sums for two consecutive coefficients of series, side by side in one register where the compiler has
 * vectors. Both ways of writing them give equal bits. */
#ifndef TDMF_KERNEL_PAIRS_H
#define TDMF_KERNEL_PAIRS_H

#include "series.h"
#include "width.h"

#include <string.h>

#if defined(__GNUC__) && !defined(TDMF_LANES)
typedef double pair __attribute__((vector_size(16)));

KERNEL pair pair_of(real low, real high) {
    return (pair){low, high};
}

KERNEL real part_of(pair a, int high) {
    return a[high];
}

/* Adds a[0] b and a[1] b. */
KERNEL void add_products(pair *sum, const real *a, real b) {
    pair both;
    memcpy(&both, a, sizeof both);
    *sum += both * b;
}

/* Adds a[0] b[0] and a[1] b[1]. */
KERNEL void add_terms(pair *sum, const real *a, const real *b) {
    pair of_a, of_b;
    memcpy(&of_a, a, sizeof of_a);
    memcpy(&of_b, b, sizeof of_b);
    *sum += of_a * of_b;
}

/* Adds |a[0]| b[0] and |a[1]| b[1]. */
KERNEL void add_magnitudes(pair *sum, const real *a, const real *b) {
    typedef long long pattern_pair __attribute__((vector_size(16)));
    const pattern_pair without_sign = {INT64_MAX, INT64_MAX};
    pattern_pair size;
    pair of_b;
    memcpy(&size, a, sizeof size);
    memcpy(&of_b, b, sizeof of_b);
    *sum += (pair)(size & without_sign) * of_b;
}

KERNEL pair scaled_pair(pair a, real b) {
    return a * b;
}

KERNEL void store_pair(pair a, real *into) {
    memcpy(into, &a, sizeof a);
}
#else
typedef struct {
    real part[2];
} pair;

KERNEL pair pair_of(real low, real high) {
    const pair both = {{low, high}};
    return both;
}

KERNEL real part_of(pair a, int high) {
    return a.part[high];
}

KERNEL void add_products(pair *sum, const real *a, real b) {
    sum->part[0] += a[0] * b;
    sum->part[1] += a[1] * b;
}

KERNEL void add_terms(pair *sum, const real *a, const real *b) {
    sum->part[0] += a[0] * b[0];
    sum->part[1] += a[1] * b[1];
}

KERNEL void add_magnitudes(pair *sum, const real *a, const real *b) {
    sum->part[0] += real_abs(a[0]) * b[0];
    sum->part[1] += real_abs(a[1]) * b[1];
}

KERNEL pair scaled_pair(pair a, real b) {
    return pair_of(a.part[0] * b, a.part[1] * b);
}

KERNEL void store_pair(pair a, real *into) {
    into[0] = a.part[0];
    into[1] = a.part[1];
}
#endif

/* Powers of a time, two at a time; there may be three more than asked for. */
KERNEL void set_power_pairs(real power[SERIES_TERMS], real t, int order) {
    const real square = t * t, fourth = square * square;
    pair first = pair_of(t, square), second = scaled_pair(first, square);
    power[0] = broadcast(1.0);
    store_pair(first, power + 1);
    store_pair(second, power + 3);
    for (int k = 5; k <= order; k += 4) {
        first = scaled_pair(first, fourth);
        second = scaled_pair(second, fourth);
        store_pair(first, power + k);
        store_pair(second, power + k + 2);
    }
}

/* Adds the terms of coefficients i - 1 and i of one factor of a product and j of the other. */
KERNEL void add_both_products(pair *sum, const real *a, const real *b, int i, int j) {
    add_products(sum, a + i - 1, b[j]);
    add_products(sum, b + i - 1, a[j]);
}

/* The terms in the middle of the sums of coefficients 2 i and 2 i + 1 of a product, and of half a square. */
KERNEL pair middle_of_product(const real *a, const real *b, int i) {
    return pair_of(a[i] * b[i], broadcast(0.0));
}

KERNEL pair middle_of_square(const real *a, int i) {
    return pair_of(0.5 * (a[i] * a[i]), broadcast(0.0));
}

/* The terms in the middle of the sums of coefficients 2 i + 1 and 2 i + 2. */
KERNEL pair next_middle_of_product(const real *a, const real *b, int i) {
    return pair_of(a[i] * b[i + 1] + b[i] * a[i + 1], a[i + 1] * b[i + 1]);
}

KERNEL pair next_middle_of_square(const real *a, int i) {
    return pair_of(a[i] * a[i + 1], 0.5 * (a[i + 1] * a[i + 1]));
}

#endif
