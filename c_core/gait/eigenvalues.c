/* Eigenvalues of a small matrix by the shifted QR algorithm on its Hessenberg form, in complex arithmetic
 * (Golub and Van Loan, Matrix Computations, 7.4 and 7.5). Complex numbers are pairs: not every compiler has
 * those of C99. */
#include "tdmf_slip/eigenvalues.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { SIZE = TDMF_SECTION_COUNT, SWEEP_LIMIT = 60 };
static const double pair_margin =
    1e-8; /* between an eigenvalue and the conjugate of its partner, over its size */

/* ---- complex numbers ------------------------------------------------------------------------------------
 */

typedef struct {
    double re, im;
} complex_number;

typedef complex_number matrix_rows[SIZE][SIZE];

static complex_number of_parts(double re, double im) {
    const complex_number z = {re, im};
    return z;
}

static double modulus(complex_number z) {
    return hypot(z.re, z.im);
}

static complex_number conjugate(complex_number z) {
    return of_parts(z.re, -z.im);
}

static complex_number sum(complex_number a, complex_number b) {
    return of_parts(a.re + b.re, a.im + b.im);
}

static complex_number difference(complex_number a, complex_number b) {
    return of_parts(a.re - b.re, a.im - b.im);
}

static complex_number product(complex_number a, complex_number b) {
    return of_parts(a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re);
}

static complex_number scaled(double factor, complex_number z) {
    return of_parts(factor * z.re, factor * z.im);
}

/* Gives the root whose real part is not negative. The smaller part follows from the larger, without
 * cancellation. */
static complex_number square_root(complex_number z) {
    const double larger = sqrt(0.5 * (modulus(z) + fabs(z.re)));
    if (!(larger > 0.0)) {
        return of_parts(0.0, 0.0);
    }
    const double smaller = 0.5 * z.im / larger;
    return z.re >= 0.0 ? of_parts(larger, smaller) : of_parts(fabs(smaller), copysign(larger, z.im));
}

/* ---- Hessenberg form ------------------------------------------------------------------------------------
 */

/* Turns two rows so that (a, b) in them becomes (norm, 0). */
typedef struct {
    complex_number c, s;
} rotation;

static rotation rotation_of(complex_number a, complex_number b) {
    const double norm = hypot(modulus(a), modulus(b));
    const rotation none = {{1.0, 0.0}, {0.0, 0.0}};
    const rotation made = {of_parts(a.re / norm, a.im / norm), of_parts(b.re / norm, b.im / norm)};
    return norm > 0.0 ? made : none;
}

/* Turns two rows in the columns from `from` to before `to`. */
static void rotate_rows(matrix_rows h, int i, int k, int from, int to, rotation r) {
    for (int j = from; j < to; ++j) {
        const complex_number a = h[i][j], b = h[k][j];
        h[i][j] = sum(product(conjugate(r.c), a), product(conjugate(r.s), b));
        h[k][j] = difference(product(r.c, b), product(r.s, a));
    }
}

static void rotate_columns(matrix_rows h, int i, int k, int from, int to, rotation r) {
    for (int j = from; j < to; ++j) {
        const complex_number a = h[j][i], b = h[j][k];
        h[j][i] = sum(product(r.c, a), product(r.s, b));
        h[j][k] = difference(product(conjugate(r.c), b), product(conjugate(r.s), a));
    }
}

/* Scales a row down and its column up by a power of two if that makes the two together smaller. */
static bool balance_row(int count, matrix_rows h, int i) {
    double row = 0.0, column = 0.0;
    for (int j = 0; j < count; ++j) {
        row += j == i ? 0.0 : modulus(h[i][j]);
        column += j == i ? 0.0 : modulus(h[j][i]);
    }
    if (!(row > 0.0 && column > 0.0)) {
        return false;
    }
    const double factor = exp2(round(0.5 * log2(row / column)));
    if (!(row / factor + column * factor < 0.95 * (row + column))) {
        return false;
    }
    for (int j = 0; j < count; ++j) {
        h[i][j] = scaled(1.0 / factor, h[i][j]);
        h[j][i] = scaled(factor, h[j][i]);
    }
    return true;
}

static void balance(int count, matrix_rows h) {
    for (bool changed = true; changed;) {
        changed = false;
        for (int i = 0; i < count; ++i) {
            changed |= balance_row(count, h, i);
        }
    }
}

static void make_hessenberg(int count, matrix_rows h) {
    for (int column = 0; column + 2 < count; ++column) {
        for (int row = count - 1; row > column + 1; --row) {
            const rotation r = rotation_of(h[row - 1][column], h[row][column]);
            rotate_rows(h, row - 1, row, column, count, r);
            rotate_columns(h, row - 1, row, 0, count, r);
            h[row][column] = of_parts(0.0, 0.0);
        }
    }
}

/* ---- QR algorithm ---------------------------------------------------------------------------------------
 */

/* Wilkinson's: the eigenvalue of the last two rows that is nearer to the last element. */
static complex_number shift_of(matrix_rows h, int last) {
    const complex_number a = h[last - 1][last - 1], d = h[last][last];
    const complex_number half = scaled(0.5, difference(a, d));
    const complex_number root =
        square_root(sum(product(half, half), product(h[last - 1][last], h[last][last - 1])));
    const complex_number one = sum(half, root), other = difference(half, root); /* from the last element */
    return sum(d, modulus(one) < modulus(other) ? one : other);
}

/* One step of the algorithm on the rows from `first` to `last`. */
static void sweep(matrix_rows h, int first, int last, complex_number shift) {
    rotation rotations[SIZE];
    for (int i = first; i <= last; ++i) {
        h[i][i] = difference(h[i][i], shift);
    }
    for (int i = first; i < last; ++i) {
        rotations[i] = rotation_of(h[i][i], h[i + 1][i]);
        rotate_rows(h, i, i + 1, i, last + 1, rotations[i]);
    }
    for (int i = first; i < last; ++i) {
        rotate_columns(h, i, i + 1, first, i + 2, rotations[i]);
    }
    for (int i = first; i <= last; ++i) {
        h[i][i] = sum(h[i][i], shift);
    }
}

/* The first row of the unreduced block that ends in `last`. */
static int block_start(matrix_rows h, int last) {
    for (int first = last; first > 0; --first) {
        const double beside = modulus(h[first - 1][first - 1]) + modulus(h[first][first]);
        if (!(modulus(h[first][first - 1]) > fmax(DBL_EPSILON * beside, DBL_MIN))) {
            h[first][first - 1] = of_parts(0.0, 0.0);
            return first;
        }
    }
    return 0;
}

/* Makes a Hessenberg matrix triangular. False if the iteration does not converge. */
static bool make_triangular(int count, matrix_rows h) {
    int sweeps = 0;
    for (int last = count - 1; last >= 0;) {
        const int first = block_start(h, last);
        if (first == last) {
            --last;
            sweeps = 0;
        } else if (++sweeps > SWEEP_LIMIT) {
            return false;
        } else {
            /* An exceptional shift from time to time, for matrices on which Wilkinson's shift cycles. */
            sweep(h, first, last,
                  sweeps % 10 != 0 ? shift_of(h, last) : of_parts(modulus(h[last][last - 1]), 0.0));
        }
    }
    return true;
}

static void sort_by_size(int count, complex_number *values) {
    for (int i = 1; i < count; ++i) {
        for (int k = i; k > 0 && modulus(values[k]) > modulus(values[k - 1]); --k) {
            const complex_number kept = values[k];
            values[k] = values[k - 1];
            values[k - 1] = kept;
        }
    }
}

/* A conjugate pair differs in size by rounding only: the one with the positive imaginary part comes first. */
static void order_pairs(int count, complex_number *values) {
    for (int i = 0; i + 1 < count; ++i) {
        const complex_number first = values[i], second = values[i + 1];
        const double apart = modulus(difference(first, conjugate(second)));
        if (first.im < 0.0 && second.im > 0.0 && apart <= pair_margin * modulus(first)) {
            values[i] = conjugate(first);
            values[i + 1] = conjugate(second);
        }
    }
}

/* Over a power of two, `exponent`, that makes the largest element about 1, so that no product overflows. */
static bool read_matrix(int count, const double *matrix, matrix_rows h, int *exponent) {
    double largest = 0.0;
    for (int i = 0; i < count * count; ++i) {
        if (!isfinite(matrix[i])) {
            return false;
        }
        largest = fmax(largest, fabs(matrix[i]));
    }
    frexp(largest, exponent);
    for (int i = 0; i < count * count; ++i) {
        h[i / count][i % count] = of_parts(ldexp(matrix[i], -*exponent), 0.0);
    }
    return true;
}

static bool write_pairs(int count, const complex_number *values, int exponent, double *pairs) {
    for (int i = 0; i < count; ++i) {
        if (!isfinite(ldexp(values[i].re, exponent)) || !isfinite(ldexp(values[i].im, exponent))) {
            return false;
        }
    }
    for (int i = 0; i < count; ++i) {
        pairs[2 * i] = ldexp(values[i].re, exponent);
        pairs[2 * i + 1] = ldexp(values[i].im, exponent);
    }
    return true;
}

bool tdmf_eigenvalues(int count, const double *matrix, double *pairs) {
    matrix_rows h;
    complex_number values[SIZE];
    int exponent = 0;
    memset(h, 0, sizeof h);
    if (count < 1 || count > SIZE || matrix == NULL || pairs == NULL ||
        !read_matrix(count, matrix, h, &exponent)) {
        return false;
    }
    balance(count, h);
    make_hessenberg(count, h);
    if (!make_triangular(count, h)) {
        return false;
    }
    for (int i = 0; i < count; ++i) {
        values[i] = h[i][i];
    }
    sort_by_size(count, values);
    order_pairs(count, values);
    return write_pairs(count, values, exponent, pairs);
}
