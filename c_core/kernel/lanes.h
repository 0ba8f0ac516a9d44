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
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

typedef double real __attribute__((vector_size(8 * LANES)));
typedef int64_t bits __attribute__((vector_size(8 * LANES)));

typedef uint64_t pattern __attribute__((vector_size(8 * LANES))); /* for shifts to the left */

/* All bits are set in the lanes selected, none in the others: what comparing yields. */
typedef bits mask;

/* A small integer in each lane. */
typedef bits integer;

/* Inputs are held. */
enum { INPUTS_RAMP = 0 };

static inline real broadcast(double x) {
    return x - (real){0.0};
}

static inline bits bits_of(int64_t x) {
    return x - (bits){0};
}

static inline integer integer_of(int x) {
    return bits_of(x);
}

static inline mask mask_of(bool selected) {
    return bits_of(selected ? -1 : 0);
}

static inline mask mask_not(mask selected) {
    return ~selected;
}

/* Takes a in the lanes selected, b in the others. */
static inline real select(mask selected, real a, real b) {
#if LANES == 4
    return (real)_mm256_blendv_pd((__m256d)b, (__m256d)a, (__m256d)selected);
#else
    return (real)(((bits)a & selected) | ((bits)b & ~selected));
#endif
}

static inline integer select_integer(mask selected, integer a, integer b) {
    return (a & selected) | (b & ~selected);
}

static inline real real_abs(real x) {
    return (real)((bits)x & bits_of(INT64_MAX));
}

/* One instruction where there is such a one, which has select's rule for what is not a number. */
static inline real real_min(real a, real b) {
#if LANES == 8
    return (real)_mm512_min_pd((__m512d)a, (__m512d)b);
#elif LANES == 4
    return (real)_mm256_min_pd((__m256d)a, (__m256d)b);
#elif defined(__SSE2__)
    return (real)_mm_min_pd((__m128d)a, (__m128d)b);
#else
    return select(a < b, a, b);
#endif
}

static inline real real_max(real a, real b) {
#if LANES == 8
    return (real)_mm512_max_pd((__m512d)a, (__m512d)b);
#elif LANES == 4
    return (real)_mm256_max_pd((__m256d)a, (__m256d)b);
#elif defined(__SSE2__)
    return (real)_mm_max_pd((__m128d)a, (__m128d)b);
#else
    return select(a > b, a, b);
#endif
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

/* Gives a bit for each lane selected. */
static inline unsigned movemask(mask selected) {
#if LANES == 8
    return (unsigned)_mm512_movepi64_mask((__m512i)selected);
#elif LANES == 4
    return (unsigned)_mm256_movemask_pd((__m256d)selected);
#else
    unsigned lanes = 0;
    for (int lane = 0; lane < LANES; ++lane) {
        lanes |= (unsigned)(selected[lane] & 1) << lane;
    }
    return lanes;
#endif
}

static inline bool any(mask selected) {
    return movemask(selected) != 0;
}

/* Tells in which lanes a number is neither infinite nor not a number. */
static inline mask is_finite(real x) {
    return real_abs(x) < broadcast(INFINITY);
}

/* Whole numbers up to 2^51 as integers and back: added to this, they are the low bits of the sum. */
static const double integer_bias = 6755399441055744.0; /* 1.5 * 2^52 */

static inline bits bits_of_integer(real x) {
    return (bits)(x + integer_bias) - (bits)broadcast(integer_bias);
}

static inline real integer_of_bits(bits x) {
    return (real)(x + (bits)broadcast(integer_bias)) - integer_bias;
}

/* The high half of the bits of a number, and the number that has such a one. */
static inline real high_half(real x) {
    return integer_of_bits((bits)x >> 32);
}

static inline real with_high_half(real half) {
    return (real)((pattern)bits_of_integer(half) << 32);
}

#endif
