/* Several numbers side by side, one for each of LANES runners, in the compiler's vector types. */
#ifndef TDMF_KERNEL_LANES_H
#define TDMF_KERNEL_LANES_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

/* As many as the registers hold of the instructions that this is compiled for: 8 for AVX-512, 4 for AVX2. */
#define LANES TDMF_LANES

#if LANES > 2
#include <immintrin.h>
#endif

typedef double real __attribute__((vector_size(8 * LANES)));
typedef int64_t bits __attribute__((vector_size(8 * LANES)));

typedef uint64_t pattern __attribute__((vector_size(8 * LANES))); /* for shifts to the left */

/* All bits set in the lanes chosen, none in the others: what comparing yields. */
typedef bits choice;

/* A small whole number. */
typedef bits whole;

/* Inputs are held. */
enum { INPUTS_RAMP = 0 };

static inline real real_of(double x) {
    return x - (real){0.0};
}

static inline bits bits_of(int64_t x) {
    return x - (bits){0};
}

static inline whole whole_of(int x) {
    return bits_of(x);
}

static inline choice choice_of(bool chosen) {
    return bits_of(chosen ? -1 : 0);
}

static inline choice not(choice chosen) {
    return ~chosen;
}

/* a in the lanes chosen, b in the others. */
static inline real pick(choice chosen, real a, real b) {
    return (real)(((bits)a & chosen) | ((bits)b & ~chosen));
}

static inline whole pick_whole(choice chosen, whole a, whole b) {
    return (a & chosen) | (b & ~chosen);
}

static inline real real_abs(real x) {
    return (real)((bits)x & bits_of(INT64_MAX));
}

static inline real smaller(real a, real b) {
    return pick(a < b, a, b);
}

static inline real larger(real a, real b) {
    return pick(a > b, a, b);
}

static inline real real_sqrt(real x) {
#if LANES == 8
    return (real)_mm512_sqrt_pd((__m512d)x);
#elif LANES == 4
    return (real)_mm256_sqrt_pd((__m256d)x);
#else
    real root;
    for (int lane = 0; lane < LANES; ++lane) {
        root[lane] = sqrt(x[lane]);
    }
    return root;
#endif
}

static inline real real_exp(real x) {
    for (int lane = 0; lane < LANES; ++lane) {
        x[lane] = exp(x[lane]);
    }
    return x;
}

/* A bit for each lane chosen. */
static inline unsigned lanes_of(choice chosen) {
#if LANES == 8
    return (unsigned)_mm512_movepi64_mask((__m512i)chosen);
#elif LANES == 4
    return (unsigned)_mm256_movemask_pd((__m256d)chosen);
#else
    unsigned lanes = 0;
    for (int lane = 0; lane < LANES; ++lane) {
        lanes |= (unsigned)(chosen[lane] & 1) << lane;
    }
    return lanes;
#endif
}

static inline bool any(choice chosen) {
    return lanes_of(chosen) != 0;
}

/* Neither infinite nor not a number. */
static inline choice is_finite(real x) {
    return real_abs(x) < real_of(INFINITY);
}

/* Whole numbers up to 2^51 as integers and back: added to this, they are the low bits of the sum. */
static const double whole_bias = 6755399441055744.0; /* 1.5 * 2^52 */

static inline bits bits_of_whole(real x) {
    return (bits)(x + whole_bias) - (bits)real_of(whole_bias);
}

static inline real whole_of_bits(bits x) {
    return (real)(x + (bits)real_of(whole_bias)) - whole_bias;
}

/* The high half of the bits of a number, and the number that has such a one. */
static inline real high_half(real x) {
    return whole_of_bits((bits)x >> 32);
}

static inline real with_high_half(real half) {
    return (real)((pattern)bits_of_whole(half) << 32);
}

#endif
