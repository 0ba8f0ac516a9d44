/* Numerical differentiation, for derivations that share no formula with the core. */
#ifndef TDMF_TESTS_DIFFERENTIATE_H
#define TDMF_TESTS_DIFFERENTIATE_H

typedef long double (*function_of_time)(long double t, const void *context);

/* df/dt at t = 0 by the central difference of eighth order. */
long double derivative_at_zero(function_of_time f, const void *context, long double step);

#endif
