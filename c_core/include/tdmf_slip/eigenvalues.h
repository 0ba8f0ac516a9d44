/* Eigenvalues of a return map's Jacobian: a gait is stable where all of them are smaller than 1. */
#ifndef TDMF_SLIP_EIGENVALUES_H
#define TDMF_SLIP_EIGENVALUES_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/return_map.h"

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Eigenvalues of a real matrix of `count` rows and columns, row after row in `matrix`: into `pairs` the real
 * and the imaginary part of each, the largest first by size, and of a conjugate pair that with the positive
 * imaginary part. False, with `pairs` as they were, for a count below 1 or above TDMF_SECTION_COUNT, for
 * NULL, for a matrix that is not finite or whose eigenvalues are not, and where they do not converge. */
TDMF_API bool tdmf_eigenvalues(int count, const double *matrix, double *pairs);

#ifdef __cplusplus
}
#endif
#endif
