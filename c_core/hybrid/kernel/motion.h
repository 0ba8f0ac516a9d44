/* The motion of a mode, as a step uses it: states are Taylor series, guards polynomials in time. Written over
 * `real`, so that the derived file of a page's motions is compiled once for each width.
 */
#ifndef TDMF_KERNEL_MOTION_H
#define TDMF_KERNEL_MOTION_H

#include "page_series.h"

typedef void tdmf_expand(const real *constants, int order, real *series);
typedef void tdmf_vary(const real *constants, const real *series, const real *d_constants, int order,
                       real *varied);
typedef void tdmf_bounds(const real *constants, const real *series, const real *power, int order,
                         uint64_t watched, interval *bounds);

/* A guard or an observed quantity as a polynomial in time, of less than `order` in degree. */
typedef void (*tdmf_polynomial)(const real *constants, const real *series, int order, real *g);

/* The first variation of an observed quantity as a polynomial in time; `d_series` is written by tdmf_vary. */
typedef void (*tdmf_vary_polynomial)(const real *constants, const real *series, const real *d_constants,
                                     const real *d_series, int order, real *dg);

/* The first series are those of the states that move, then come states that only the motion has. */
typedef struct {
    int moving_count, extra_count, series_count, constant_count;
    const int *moving;  /* indices of the moving states among the states of the model */
    const int *degrees; /* degrees of states that are polynomials in time; a large number for others */
    int judged_count;
    const int *judged; /* series whose last coefficients control the size of a step */
    const int *
        divided; /* states by whose squares these are divided, or -1: their errors grow where that is small */
    int divisor_count;
    const int *divisors;                /* series that occur as divisors */
    const tdmf_polynomial *polynomials; /* guards, then observed quantities */
    tdmf_expand *expand;
    tdmf_vary *vary;
    const tdmf_vary_polynomial *vary_observed;
    const int *integrals; /* series whose rate is the observed quantity, or -1 */
    const int *factors;   /* two for each observed quantity: series whose signs decide its own, or -1 */
    tdmf_bounds *bounds;  /* bounds of guards and observed quantities; NULL: none is bounded */
} tdmf_motion_kind;

/* The name of a table or function of this width. Two lanes have two names, as a library may have them for
 * batches and for seeds. */
#define TDMF_JOINED(name, width)  name##_##width
#define TDMF_NAME_OF(name, width) TDMF_JOINED(name, width)
#ifdef TDMF_LANES_ARE_SEEDS
#define TDMF_OF_WIDTH(name) TDMF_NAME_OF(name, seeds)
#elif defined(TDMF_LANES)
#define TDMF_OF_WIDTH(name) TDMF_NAME_OF(name, TDMF_LANES)
#else
#define TDMF_OF_WIDTH(name) name
#endif

#endif
