/* Taylor series in time about the start of a step: what the solver knows of a motion. */
#ifndef TDMF_KERNEL_SERIES_H
#define TDMF_KERNEL_SERIES_H

/* A function of a kernel becomes part of its callers, so that for each case that they call it with, constants
 * all, there is a kernel without switches. C99 cannot ask for that; compilers that are not asked decide. */
#if defined(__GNUC__)
#define KERNEL static inline __attribute__((always_inline))
#elif defined(_MSC_VER)
#define KERNEL static __forceinline
#else
#define KERNEL static inline
#endif

/* Highest order, and the number of coefficients that a series has room for. */
enum { SERIES_ORDER_LIMIT = 28, SERIES_TERMS = SERIES_ORDER_LIMIT + 2 };

/* 1/k: integrating a series divides by its index, and a product is cheaper than a division. */
static const double series_reciprocal[SERIES_TERMS + 1] = {
    0.0,      1.0,      1.0 / 2,  1.0 / 3,  1.0 / 4,  1.0 / 5,  1.0 / 6,  1.0 / 7,
    1.0 / 8,  1.0 / 9,  1.0 / 10, 1.0 / 11, 1.0 / 12, 1.0 / 13, 1.0 / 14, 1.0 / 15,
    1.0 / 16, 1.0 / 17, 1.0 / 18, 1.0 / 19, 1.0 / 20, 1.0 / 21, 1.0 / 22, 1.0 / 23,
    1.0 / 24, 1.0 / 25, 1.0 / 26, 1.0 / 27, 1.0 / 28, 1.0 / 29, 1.0 / 30};

#endif
