/* Numerical differentiation, for derivations that share no formula with the core. */
#ifndef TDMF_TESTS_DIFFERENTIATE_H
#define TDMF_TESTS_DIFFERENTIATE_H

typedef long double (*function_of_time)(long double t, const void *context);
typedef void (*functions_of_time)(long double t, const void *context, double values[]);

/* df/dt at t = 0 by the central difference of eighth order. */
long double derivative_at_zero(function_of_time f, const void *context, long double step);

/* The same for several functions that are computed together. */
enum { FUNCTIONS_LIMIT = 20 };
void derivatives_at_zero(functions_of_time f, const void *context, long double step, int count,
                         double derivatives[]);

#endif
