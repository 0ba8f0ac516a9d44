/* Eigenvalues of a small matrix by the shifted QR algorithm on its Hessenberg form, in complex arithmetic
 * (Golub and Van Loan, Matrix Computations, 7.4 and 7.5). The core has no use for them, and what pages may
 * load has no room for LAPACK. */
#include "live.h"

#include <complex.h>
#include <float.h>
#include <math.h>

enum { SIZE = TDMF_SECTION_COUNT, SWEEP_LIMIT = 60 };

typedef double complex matrix[SIZE][SIZE];

/* Turns rows i and i + 1, from a column on, so that (a, b) in them becomes (norm, 0). */
typedef struct {
    double complex c, s;
} rotation;

static rotation rotation_of(double complex a, double complex b) {
    const double norm = hypot(cabs(a), cabs(b));
    const rotation none = {1.0, 0.0};
    const rotation made = {a / norm, b / norm};
    return norm > 0.0 ? made : none;
}

static void turn_rows(matrix h, int i, int k, int from, int to, rotation r) {
    for (int j = from; j < to; ++j) {
        const double complex a = h[i][j], b = h[k][j];
        h[i][j] = conj(r.c) * a + conj(r.s) * b;
        h[k][j] = r.c * b - r.s * a;
    }
}

static void turn_columns(matrix h, int i, int k, int from, int to, rotation r) {
    for (int j = from; j < to; ++j) {
        const double complex a = h[j][i], b = h[j][k];
        h[j][i] = r.c * a + r.s * b;
        h[j][k] = conj(r.c) * b - conj(r.s) * a;
    }
}

/* Powers of two on the diagonal of a similarity make rows and columns alike in size. */
static void balance(int count, matrix h) {
    for (bool changed = true; changed;) {
        changed = false;
        for (int i = 0; i < count; ++i) {
            double row = 0.0, column = 0.0;
            for (int j = 0; j < count; ++j) {
                row += j == i ? 0.0 : cabs(h[i][j]);
                column += j == i ? 0.0 : cabs(h[j][i]);
            }
            if (!(row > 0.0 && column > 0.0)) {
                continue;
            }
            const double factor = exp2(round(0.5 * log2(row / column)));
            if (row / factor + column * factor < 0.95 * (row + column)) {
                for (int j = 0; j < count; ++j) {
                    h[i][j] /= factor;
                    h[j][i] *= factor;
                }
                changed = true;
            }
        }
    }
}

static void make_hessenberg(int count, matrix h) {
    for (int column = 0; column + 2 < count; ++column) {
        for (int row = count - 1; row > column + 1; --row) {
            const rotation r = rotation_of(h[row - 1][column], h[row][column]);
            turn_rows(h, row - 1, row, column, count, r);
            turn_columns(h, row - 1, row, 0, count, r);
            h[row][column] = 0.0;
        }
    }
}

/* Wilkinson's: the eigenvalue of the last two rows that is nearer to the last element. */
static double complex shift_of(matrix h, int last) {
    const double complex a = h[last - 1][last - 1], d = h[last][last];
    const double complex half = 0.5 * (a - d);
    const double complex root = csqrt(half * half + h[last - 1][last] * h[last][last - 1]);
    const double complex one = d + half + root, other = d + half - root;
    return cabs(one - d) < cabs(other - d) ? one : other;
}

/* One step of the algorithm on the rows from `first` to `last`. */
static void sweep(matrix h, int first, int last, double complex shift) {
    rotation rotations[SIZE];
    for (int i = first; i <= last; ++i) {
        h[i][i] -= shift;
    }
    for (int i = first; i < last; ++i) {
        rotations[i] = rotation_of(h[i][i], h[i + 1][i]);
        turn_rows(h, i, i + 1, i, last + 1, rotations[i]);
    }
    for (int i = first; i < last; ++i) {
        turn_columns(h, i, i + 1, first, i + 2, rotations[i]);
    }
    for (int i = first; i <= last; ++i) {
        h[i][i] += shift;
    }
}

/* The first row of the unreduced block that ends in `last`. */
static int block_start(matrix h, int last) {
    int first = last;
    while (first > 0) {
        const double beside = cabs(h[first - 1][first - 1]) + cabs(h[first][first]);
        if (!(cabs(h[first][first - 1]) > fmax(DBL_EPSILON * beside, DBL_MIN))) {
            h[first][first - 1] = 0.0;
            break;
        }
        --first;
    }
    return first;
}

static void sort(int count, double *pairs) {
    for (int i = 1; i < count; ++i) {
        for (int k = i;
             k > 0 && hypot(pairs[2 * k], pairs[2 * k + 1]) > hypot(pairs[2 * k - 2], pairs[2 * k - 1]);
             --k) {
            for (int part = 0; part < 2; ++part) {
                const double kept = pairs[2 * k + part];
                pairs[2 * k + part] = pairs[2 * k - 2 + part];
                pairs[2 * k - 2 + part] = kept;
            }
        }
    }
}

bool live_eigenvalues(int count, const double *given, double *pairs) {
    matrix h;
    for (int i = 0; i < count * count; ++i) {
        if (!isfinite(given[i])) {
            return false;
        }
        h[i / count][i % count] = given[i];
    }
    balance(count, h);
    make_hessenberg(count, h);
    int sweeps = 0;
    for (int last = count - 1; last >= 0;) {
        const int first = block_start(h, last);
        if (first == last) {
            pairs[2 * last] = creal(h[last][last]);
            pairs[2 * last + 1] = cimag(h[last][last]);
            --last;
            sweeps = 0;
        } else if (++sweeps > SWEEP_LIMIT) {
            return false;
        } else {
            /* Now and then another shift, for those that go round in circles. */
            sweep(h, first, last, sweeps % 10 ? shift_of(h, last) : cabs(h[last][last - 1]));
        }
    }
    sort(count, pairs);
    return true;
}
