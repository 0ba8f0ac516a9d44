#include "compare.h"

#include <math.h>
#include <stdio.h>

void assert_close_at(double actual, double expected, double tolerance, const char *text, const char *file,
                     int line) {
    if (!(fabs(actual - expected) <= tolerance)) {
        print_error("%s = %.17g, expected %.17g within %.3g; it is off by %.3g\n", text, actual, expected,
                    tolerance, actual - expected);
        _fail(file, line);
    }
}

void assert_relatively_close_at(double actual, double expected, double tolerance, const char *text,
                                const char *file, int line) {
    assert_close_at(actual, expected, tolerance * fabs(expected), text, file, line);
}

void assert_all_close_at(const double *actual, const double *expected, int count, double absolute,
                         double relative, const char *text, const char *file, int line) {
    for (int i = 0; i < count; ++i) {
        char element[256];
        snprintf(element, sizeof element, "%s, element %d", text, i);
        assert_close_at(actual[i], expected[i], absolute + relative * fabs(expected[i]), element, file, line);
    }
}

void assert_all_at(const double *values, int count, const double *value, const char *text, const char *file,
                   int line) {
    for (int i = 0; i < count; ++i) {
        if (!(value != NULL ? values[i] == *value : isfinite(values[i]))) {
            print_error("%s, element %d: %.17g\n", text, i, values[i]);
            _fail(file, line);
        }
    }
}
