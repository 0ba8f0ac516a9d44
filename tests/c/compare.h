/* Comparison of doubles for tests, with both values in the message. Brings in test.h. */
#ifndef TDMF_TESTS_COMPARE_H
#define TDMF_TESTS_COMPARE_H

#include "test.h"

/* |actual - expected| <= tolerance; NaN is close to nothing. */
#define assert_close(actual, expected, tolerance)                                                            \
    assert_close_at(actual, expected, tolerance, #actual, __FILE__, __LINE__)

/* |actual - expected| <= tolerance |expected| */
#define assert_relatively_close(actual, expected, tolerance)                                                 \
    assert_relatively_close_at(actual, expected, tolerance, #actual, __FILE__, __LINE__)

void assert_close_at(double actual, double expected, double tolerance, const char *text, const char *file,
                     int line);
void assert_relatively_close_at(double actual, double expected, double tolerance, const char *text,
                                const char *file, int line);

#endif
