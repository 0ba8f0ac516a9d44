/* The first root of a polynomial: found where it is known, missed nowhere, and every march ends. */
#include "compare.h"
#include "first_root.h"
#include "random.h"

#include <float.h>

static const double level = -2e-13;

static double first_root(const tdmf_polynomial *p, double to) {
    tdmf_reach reach;
    tdmf_root root = {0.0, false};
    tdmf_reach_to(&reach, to, p->order);
    for (int i = 0; i < 1000 && !root.is_root && root.time < to; ++i) {
        root = tdmf_first_root(p, &reach, 1.0, level, root.time, to);
    }
    return root.time;
}

/* c times the product of (t - root). */
static tdmf_polynomial with_roots(double c, const double *roots, int count) {
    tdmf_polynomial p = {{c}, 0};
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

/* What rounding of the coefficients may do to a value on [0, 1]. */
static double rounding_of(const double *roots, int count) {
    double size = 1.0;
    for (int i = 0; i < count; ++i) {
        size *= 1.0 + fabs(roots[i]);
    }
    return count * DBL_EPSILON * size;
}

/* Roots anywhere, some outside the reach and some close together; the polynomial is positive at 0. What is
 * found is a root to rounding, and before it the polynomial is positive wherever one looks. */
static void the_first_of_many_roots(void **state) {
    enum { RUNS = 5000, MOST = 12, LOOKS = 400 };
    random_source source = {41};
    int found_some = 0;
    (void)state;
    for (int run = 0; run < RUNS; ++run) {
        const int count = 1 + (int)random_uniform(&source, 0.0, MOST - 1e-9);
        double roots[MOST];
        double sign = 1.0;
        for (int i = 0; i < count; ++i) {
            roots[i] = random_uniform(&source, -1.0, 2.0);
            if (i > 0 && random_chance(&source, 0.2)) {
                roots[i] = roots[i - 1] + random_magnitude(&source, 1e-5, 1e-2);
            }
            sign = roots[i] > 0.0 ? -sign : sign;
        }
        const tdmf_polynomial p = with_roots(sign, roots, count);
        const double found = first_root(&p, 1.0);
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
static void a_touch_is_judged_by_its_depth(void **state) {
    (void)state;
    for (double depth = 1e-4; depth > 1e-12; depth *= 0.1) {
        tdmf_polynomial p = {{0.25 + depth, -1.0, 1.0, 0.0}, 3};
        assert_true(first_root(&p, 1.0) == INFINITY);
        p.c[0] = 0.25 - depth;
        assert_close(first_root(&p, 1.0), 0.5 - sqrt(depth), 1e-6);
    }
}

static void a_double_root_ends_the_march(void **state) {
    (void)state;
    const tdmf_polynomial p = {{0.25, -1.0, 1.0, 0.0}, 3};
    const double found = first_root(&p, 1.0);
    assert_true(found == INFINITY || fabs(found - 0.5) < 1e-5);
}

static void what_is_due_at_once_is_found_at_once(void **state) {
    (void)state;
    const tdmf_polynomial p = {{-1.0, 5.0, 0.0, 0.0}, 3};
    assert_true(first_root(&p, 1.0) == 0.0);
    const tdmf_polynomial nothing = {{NAN, 0.0, 0.0, 0.0}, 3};
    assert_true(first_root(&nothing, 1.0) == 0.0);
}

static void signs_change_one_after_the_other(void **state) {
    (void)state;
    const double roots[] = {0.2, 0.5, 0.9};
    const tdmf_polynomial p = with_roots(1.0, roots, 3);
    tdmf_reach reach;
    tdmf_reach_to(&reach, 1.0, p.order);
    double t = 0.0;
    for (int i = 0; i < 3; ++i) {
        t = tdmf_first_sign_change(&p, &reach, 1e-14, t, 1.0).time;
        assert_close(t, roots[i], 1e-12);
    }
    assert_true(tdmf_first_sign_change(&p, &reach, 1e-14, t, 1.0).time == INFINITY);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_of_many_roots),
        cmocka_unit_test(a_touch_is_judged_by_its_depth),
        cmocka_unit_test(a_double_root_ends_the_march),
        cmocka_unit_test(what_is_due_at_once_is_found_at_once),
        cmocka_unit_test(signs_change_one_after_the_other),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
