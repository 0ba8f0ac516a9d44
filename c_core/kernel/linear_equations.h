/* Linear equations of the size that Newton's method needs. */
#ifndef TDMF_KERNEL_LINEAR_EQUATIONS_H
#define TDMF_KERNEL_LINEAR_EQUATIONS_H

#include <stdbool.h>

/* Coordinates of a map, at the most. */
enum { TDMF_MAP_LIMIT = 8 };

/* Solves a x = b for n unknowns, n up to TDMF_MAP_LIMIT + 1, by elimination with row exchanges; both are
 * overwritten. False where a is singular. */
bool tdmf_solve_linear(int n, double a[][TDMF_MAP_LIMIT + 1], double *b);

#endif
