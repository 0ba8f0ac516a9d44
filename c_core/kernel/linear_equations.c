/* Elimination with row exchanges. */
#include "linear_equations.h"

#include <math.h>

bool tdmf_solve_linear(int n, double a[][TDMF_MAP_LIMIT + 1], double *b) {
    for (int column = 0; column < n; ++column) {
        int pivot = column;
        for (int row = column + 1; row < n; ++row) {
            pivot = fabs(a[row][column]) > fabs(a[pivot][column]) ? row : pivot;
        }
        if (!(fabs(a[pivot][column]) > 0.0)) {
            return false;
        }
        for (int k = 0; k < n; ++k) {
            const double exchanged = a[column][k];
            a[column][k] = a[pivot][k];
            a[pivot][k] = exchanged;
        }
        const double exchanged = b[column];
        b[column] = b[pivot];
        b[pivot] = exchanged;
        for (int row = column + 1; row < n; ++row) {
            const double factor = a[row][column] / a[column][column];
            for (int k = column; k < n; ++k) {
                a[row][k] -= factor * a[column][k];
            }
            b[row] -= factor * b[column];
        }
    }
    for (int row = n - 1; row >= 0; --row) {
        for (int k = row + 1; k < n; ++k) {
            b[row] -= a[row][k] * b[k];
        }
        b[row] /= a[row][row];
    }
    return true;
}
