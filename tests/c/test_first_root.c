/* The first root of a polynomial: found where it is known, missed nowhere, and every search ends. */
#include "compare.h"
#include "first_root.h"
#include "random.h"
#include "sample.h"

#include <float.h>

static const double level = -2e-13;

typedef struct {
    double c[SERIES_TERMS];
    int order;
} polynomial;

/* First root in [0, 1]; a search that stops early is resumed. */
static double root_of(const polynomial *p) {
    root found = {0.0, 0, 0.0};
    for (int i = 0; i < 1000 && !found.is_root && found.time < 1.0; ++i) {
        found = first_root(p->c, p->order, level, found.time, 1.0, 1);
    }
    return found.time;
}

/* c times the product of (t - root). */
static polynomial with_roots(double c, const double *roots, int count) {
    polynomial p = {{c}, 0};
    for (int i = 0; i < count; ++i) {
        p.c[p.order + 1] = 0.0;
        for (int k = p.order + 1; k > 0; --k) {
            p.c[k] = p.c[k - 1] - roots[i] * p.c[k];
        }
        p.c[0] *= -roots[i];
        ++p.order;
    }
    while (p.order < 3) {
        p.c[++p.order] = 0.0;
    }
    return p;
}

static double product(double c, const double *roots, int count, double t) {
    double value = c;
    for (int i = 0; i < count; ++i) {
        value *= t - roots[i];
    }
    return value;
}

/* Bound on the rounding error of a value on [0, 1], from the coefficients. */
static double rounding_of(const double *roots, int count) {
    double size = 1.0;
    for (int i = 0; i < count; ++i) {
        size *= 1.0 + fabs(roots[i]);
    }
    return count * DBL_EPSILON * size;
}

/* Roots anywhere, some outside the reach and some close together; the polynomial is positive at 0. The search
 * finds a root to rounding, and the polynomial is positive at sampled points before it. */
TEST(the_first_of_many_roots) {
    enum { RUNS = sample_of(5000), ROOT_LIMIT = 12, LOOKS = 400 };
    random_source source = {41};
    int found_some = 0;
    for (int run = 0; run < RUNS; ++run) {
        const int count = 1 + (int)random_uniform(&source, 0.0, ROOT_LIMIT - 1e-9);
        double roots[ROOT_LIMIT];
        double sign = 1.0;
        for (int i = 0; i < count; ++i) {
            roots[i] = random_uniform(&source, -1.0, 2.0);
            if (i > 0 && random_chance(&source, 0.2)) {
                roots[i] = roots[i - 1] + random_magnitude(&source, 1e-5, 1e-2);
            }
            sign = roots[i] > 0.0 ? -sign : sign;
        }
        const polynomial p = with_roots(sign, roots, count);
        const double found = root_of(&p);
        const double rounding = -level + rounding_of(roots, count);
        if (found <= 1.0) {
            assert_close(product(sign, roots, count, found), 0.0, rounding);
            ++found_some;
        }
        for (int i = 0; i < LOOKS; ++i) {
            assert_true(product(sign, roots, count, fmin(found, 1.0) * i / LOOKS) > -rounding);
        }
    }
    assert_true(found_some > RUNS / 4);
}

/* A dip that ends above the level is passed, one that goes through it is not, however shallow. */
TEST(a_touch_is_judged_by_its_depth) {
    for (double depth = 1e-4; depth > 1e-12; depth *= 0.1) {
        polynomial p = {{0.25 + depth, -1.0, 1.0, 0.0}, 3};
        assert_true(root_of(&p) == INFINITY);
        p.c[0] = 0.25 - depth;
        assert_close(root_of(&p), 0.5 - sqrt(depth), 1e-6);
    }
}

TEST(a_double_root_ends_the_search) {
    const polynomial p = {{0.25, -1.0, 1.0, 0.0}, 3};
    const double found = root_of(&p);
    assert_true(found == INFINITY || fabs(found - 0.5) < 1e-5);
}

TEST(a_root_at_the_start_is_found_at_once) {
    const polynomial p = {{-1.0, 5.0, 0.0, 0.0}, 3};
    assert_true(root_of(&p) == 0.0);
    const polynomial nothing = {{NAN, 0.0, 0.0, 0.0}, 3};
    assert_true(root_of(&nothing) == 0.0);
}
