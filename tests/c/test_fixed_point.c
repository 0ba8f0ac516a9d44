/* Newton's method for fixed points, on maps whose fixed points are known: how near it comes, what it takes
 * for one, and that it shortens steps. */
#include "compare.h"
#include "fixed_point.h"

#include <math.h>

/* A map of a line, f, and its derivative. */
typedef struct {
    double (*value)(double z);
    double (*slope)(double z);
} line_map;

static bool evaluate(void *context, int slot, tdmf_image *image) {
    const line_map *f = context;
    (void)slot;
    image->next[0] = f->value(image->point[0]);
    image->jacobian[0][0] = f->slope(image->point[0]);
    return true;
}

static tdmf_fixed_point find(line_map f, double scale, double guess) {
    const tdmf_map map = {.count = 1, .scales = {scale}, .evaluate = evaluate, .context = &f};
    return tdmf_find_fixed_point(&map, &guess);
}

static double negative_sine(double z) {
    return -sin(z);
}

/* Newton's errors are squared: from some of these guesses one is 1e-9 to 1e-13, which is no end yet. */
TEST(it_goes_on_down_to_rounding) {
    static const double fixed = 0.73908513321516064;
    const line_map f = {cos, negative_sine};
    for (int i = 0; i <= 60; ++i) {
        const tdmf_fixed_point found = find(f, 1.0, fixed + pow(10.0, -0.1 * i));
        assert_int_equal(found.outcome, TDMF_FIXED_POINT_FOUND);
        assert_close(found.point[0], fixed, 2e-13);
        assert_true(found.error <= 1e-13);
    }
}

static double almost_touches(double z) {
    return z + z * z + 1e-8;
}

static double slope_of_almost_touching(double z) {
    return 1.0 + 2.0 * z;
}

/* The map misses a fixed point by 1e-8, which is rounding in units of 1e4. */
TEST(a_near_miss_is_no_fixed_point) {
    const line_map f = {almost_touches, slope_of_almost_touching};
    const tdmf_fixed_point none = find(f, 1.0, 0.1);
    assert_int_equal(none.outcome, TDMF_FIXED_POINT_NOT_FOUND);
    assert_close(none.error, 1e-8, 1e-9);
    assert_int_equal(find(f, 1e4, 0.1).outcome, TDMF_FIXED_POINT_FOUND);
}

static double less_arctangent(double z) {
    return z - atan(z);
}

static double slope_less_arctangent(double z) {
    return 1.0 - 1.0 / (1.0 + z * z);
}

/* Beyond 1.39 whole steps for the zero of atan go ever farther away. */
TEST(steps_that_make_it_worse_are_shortened) {
    static const double guesses[] = {1.5, 3.0, -10.0, 40.0};
    const line_map f = {less_arctangent, slope_less_arctangent};
    for (int i = 0; i < 4; ++i) {
        const tdmf_fixed_point found = find(f, 1.0, guesses[i]);
        assert_int_equal(found.outcome, TDMF_FIXED_POINT_FOUND);
        assert_close(found.point[0], 0.0, 1e-13);
    }
}

static double not_a_number(double z) {
    return z * (double)NAN;
}

TEST(nan_is_no_fixed_point) {
    const line_map f = {not_a_number, cos};
    assert_int_equal(find(f, 1.0, 1.0).outcome, TDMF_FIXED_POINT_NOT_FOUND);
}
