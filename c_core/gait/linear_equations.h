/* Linear equations in as many unknowns as Newton's method on the section has. */
#ifndef TDMF_GAIT_LINEAR_EQUATIONS_H
#define TDMF_GAIT_LINEAR_EQUATIONS_H

#include "tdmf_slip/return_map.h"

/* Solves a x = b for n unknowns, n up to TDMF_SECTION_COUNT + 1, by elimination with row exchanges; both are
 * overwritten. False where a is singular. */
bool tdmf_solve_linear(int n, double a[][TDMF_SECTION_COUNT + 1], double *b);

#endif
