/* The first root of a polynomial, none missed. */
#ifndef TDMF_SOLVER_FIRST_ROOT_H
#define TDMF_SOLVER_FIRST_ROOT_H

#include "series.h"

#include <math.h>
#include <stdbool.h>

typedef struct {
    double c[SERIES_TERMS];
    int order;
} tdmf_polynomial;

/* How far from 0 polynomials are looked at: powers of that time, and the weights of coefficients in the bound
 * of a third derivative. */
typedef struct {
    double power[SERIES_TERMS];
    double third[SERIES_TERMS];
} tdmf_reach;

void tdmf_reach_to(tdmf_reach *reach, double size, int order);

/* Within reach a series differs by no more than this from its first coefficient. */
double tdmf_spread(const double *c, int order, const tdmf_reach *reach);

/* What a search has found: the time of a root, or how far there is none. */
typedef struct {
    double time;
    bool is_root;
} tdmf_root;

/* The first t in [from, to] at which the polynomial, times `sign`, is no larger than `floor`, which is below
 * zero. Without one, time is infinity, or less than `to` where the search took too long: there is no root
 * before. `from` is not negative and `to` within reach. Coefficients 1 and 2 are read whatever the order. */
tdmf_root tdmf_first_root(const tdmf_polynomial *polynomial, const tdmf_reach *reach, double sign,
                          double floor, double from, double to);

/* The first t in (from, to] at which the polynomial changes its sign; values up to `floor` count as zero. */
tdmf_root tdmf_first_sign_change(const tdmf_polynomial *polynomial, const tdmf_reach *reach, double floor,
                                 double from, double to);

#endif
