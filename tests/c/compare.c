#include "compare.h"

#include <math.h>

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
