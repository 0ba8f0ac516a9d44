/* Eigenvalues of small matrices: those that are known, and of random matrices the sums of the eigenvalues'
 * powers, which are the traces of the matrix's powers and leave no other eigenvalues. */
#include "compare.h"
#include "random.h"

#include "tdmf_slip/eigenvalues.h"

#include <complex.h>
#include <float.h>
#include <math.h>
#include <string.h>

enum { SIZE = TDMF_SECTION_COUNT };

static const double half_turn = 3.14159265358979324;

static double size_of(const double *pair) {
    return hypot(pair[0], pair[1]);
}

/* Asserts eigenvalues that are real; `expected` is sorted by size. */
static void assert_are(int count, const double *matrix, const double *expected, double tolerance) {
    double pairs[2 * SIZE];
    assert_true(tdmf_eigenvalues(count, matrix, pairs));
    for (int i = 0; i < count; ++i) {
        assert_close(pairs[2 * i], expected[i], tolerance);
        assert_close(pairs[2 * i + 1], 0.0, tolerance);
    }
}

TEST(eigenvalues_of_a_triangle_are_on_the_diagonal) {
    static const double matrix[] = {-3.0, 2.0, 9.0, 0.0, 0.5, 4.0, 0.0, 0.0, 1.0};
    static const double expected[] = {-3.0, 1.0, 0.5};
    static const double zeros[SIZE * SIZE] = {0.0};
    assert_are(3, matrix, expected, 1e-15);
    assert_are(1, matrix, expected, 0.0);
    assert_are(SIZE, zeros, zeros, 0.0);
}

/* All of one size and apart by a sixth of a turn: no shift tells one from another, at first. */
TEST(eigenvalues_of_a_cycle_are_roots_of_unity) {
    double matrix[SIZE * SIZE] = {0.0}, pairs[2 * SIZE];
    bool met[SIZE] = {false};
    for (int i = 0; i < SIZE; ++i) {
        matrix[SIZE * i + (i + 1) % SIZE] = 1.0;
    }
    assert_true(tdmf_eigenvalues(SIZE, matrix, pairs));
    for (int i = 0; i < SIZE; ++i) {
        const double sixths = atan2(pairs[2 * i + 1], pairs[2 * i]) / half_turn * (SIZE / 2);
        const int nearest = ((int)lround(sixths) + SIZE) % SIZE;
        assert_close(size_of(&pairs[2 * i]), 1.0, 1e-14);
        assert_close(sixths, round(sixths), 1e-14);
        assert_false(met[nearest]);
        met[nearest] = true;
    }
}

/* (0.7 - x)^6 = 1e-12: a Jordan block whose corner is not quite 0, so that rounding counts for a lot. */
TEST(eigenvalues_of_a_nearly_defective_matrix_are_on_a_circle) {
    double matrix[SIZE * SIZE] = {0.0}, pairs[2 * SIZE], together = 0.0;
    for (int i = 0; i < SIZE; ++i) {
        matrix[SIZE * i + i] = 0.7;
        matrix[SIZE * i + (i + 1) % SIZE] = i + 1 < SIZE ? 1.0 : 1e-12;
    }
    assert_true(tdmf_eigenvalues(SIZE, matrix, pairs));
    for (int i = 0; i < SIZE; ++i) {
        assert_close(hypot(pairs[2 * i] - 0.7, pairs[2 * i + 1]), 0.01, 1e-5);
        together += pairs[2 * i];
    }
    assert_close(together, 0.7 * SIZE, 1e-13);
}

static double complex sum_of_powers(const double pairs[2 * SIZE], int power) {
    double complex total = 0.0;
    for (int i = 0; i < SIZE; ++i) {
        total += cpow(pairs[2 * i] + pairs[2 * i + 1] * I, power);
    }
    return total;
}

static void multiply(const double a[SIZE * SIZE], const double b[SIZE * SIZE], double c[SIZE * SIZE]) {
    for (int i = 0; i < SIZE; ++i) {
        for (int k = 0; k < SIZE; ++k) {
            c[SIZE * i + k] = 0.0;
            for (int j = 0; j < SIZE; ++j) {
                c[SIZE * i + k] += a[SIZE * i + j] * b[SIZE * j + k];
            }
        }
    }
}

static double trace(const double matrix[SIZE * SIZE]) {
    double sum = 0.0;
    for (int i = 0; i < SIZE; ++i) {
        sum += matrix[SIZE * i + i];
    }
    return sum;
}

static void assert_suit(const double matrix[SIZE * SIZE], const double pairs[2 * SIZE], double norm) {
    double power[SIZE * SIZE], next[SIZE * SIZE];
    memcpy(power, matrix, sizeof power);
    for (int k = 1; k <= SIZE; ++k) {
        const double complex sum = sum_of_powers(pairs, k);
        const double tolerance = 1e-13 * pow(norm, k);
        assert_close(creal(sum), trace(power), tolerance);
        assert_close(cimag(sum), 0.0, tolerance);
        multiply(matrix, power, next);
        memcpy(power, next, sizeof power);
    }
}

/* Rows over magnitudes, so that balancing has something to do, and some elements zero. */
TEST(sums_of_their_powers_are_traces) {
    enum { MATRICES = 500 };
    int not_real = 0;
    for (uint64_t seed = 0; seed < MATRICES; ++seed) {
        random_source source = {seed};
        double matrix[SIZE * SIZE], pairs[2 * SIZE], norm = 0.0;
        for (int i = 0; i < SIZE; ++i) {
            const double size = random_magnitude(&source, 0.1, 10.0);
            for (int k = 0; k < SIZE; ++k) {
                matrix[SIZE * i + k] =
                    random_chance(&source, 0.2) ? 0.0 : size * random_uniform(&source, -1.0, 1.0);
                norm = hypot(norm, matrix[SIZE * i + k]);
            }
        }
        assert_true(tdmf_eigenvalues(SIZE, matrix, pairs));
        assert_suit(matrix, pairs, norm);
        for (int i = 0; i < SIZE; ++i) {
            not_real += pairs[2 * i + 1] != 0.0;
            assert_true(i == 0 || size_of(&pairs[2 * i]) <= size_of(&pairs[2 * i - 2]));
            assert_true(i == 0 || !(pairs[2 * i - 1] < -0.1 * norm && pairs[2 * i + 1] > 0.1 * norm &&
                                    fabs(pairs[2 * i - 1] + pairs[2 * i + 1]) < 1e-12 * norm));
        }
    }
    assert_true(not_real > MATRICES);
}

/* They grow with the matrix, up to the largest numbers and down to the least. */
TEST(a_factor_of_the_matrix_is_theirs) {
    static const double matrix[] = {0.25, -0.5, 0.5, 0.25}, smallest[] = {0x1p-1074};
    for (int exponent = -1000; exponent <= 1022; exponent += 2022) {
        double scaled[4], pairs[4];
        for (int i = 0; i < 4; ++i) {
            scaled[i] = ldexp(matrix[i], exponent);
        }
        assert_true(tdmf_eigenvalues(2, scaled, pairs));
        assert_close(ldexp(pairs[0], -exponent), 0.25, 1e-15);
        assert_close(fabs(ldexp(pairs[1], -exponent)), 0.5, 1e-15);
        assert_close(ldexp(pairs[1] + pairs[3], -exponent), 0.0, 1e-15);
    }
    assert_are(1, smallest, smallest, 0.0);
}

TEST(a_matrix_without_eigenvalues_is_refused) {
    static const double all_largest[] = {DBL_MAX, DBL_MAX, DBL_MAX, DBL_MAX};
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    double matrix[(SIZE + 1) * (SIZE + 1)] = {1.0}, pairs[2 * SIZE + 2] = {7.0};
    assert_false(tdmf_eigenvalues(2, all_largest, pairs)); /* twice the largest number */
    for (int i = 0; i < 3; ++i) {
        matrix[3] = bad[i];
        assert_false(tdmf_eigenvalues(2, matrix, pairs));
        assert_true(tdmf_eigenvalues(1, matrix, pairs + 2));
    }
    matrix[3] = 0.0;
    assert_false(tdmf_eigenvalues(0, matrix, pairs));
    assert_false(tdmf_eigenvalues(-1, matrix, pairs));
    assert_false(tdmf_eigenvalues(SIZE + 1, matrix, pairs));
    assert_false(tdmf_eigenvalues(2, NULL, pairs));
    assert_false(tdmf_eigenvalues(2, matrix, NULL));
    assert_true(pairs[0] == 7.0);
}
