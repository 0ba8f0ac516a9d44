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

/* |actual - expected| <= absolute + relative |expected|, for each of `count` numbers. */
#define assert_all_close(actual, expected, count, absolute, relative)                                        \
    assert_all_close_at(actual, expected, count, absolute, relative, #actual, __FILE__, __LINE__)

/* Each of `count` numbers is finite, or is `value`. */
#define assert_all_finite(values, count) assert_all_at(values, count, NULL, #values, __FILE__, __LINE__)
#define assert_all_are(values, count, value)                                                                 \
    assert_all_at(values, count, &(double){value}, #values, __FILE__, __LINE__)

void assert_all_close_at(const double *actual, const double *expected, int count, double absolute,
                         double relative, const char *text, const char *file, int line);
void assert_all_at(const double *values, int count, const double *value, const char *text, const char *file,
                   int line);
void assert_close_at(double actual, double expected, double tolerance, const char *text, const char *file,
                     int line);
void assert_relatively_close_at(double actual, double expected, double tolerance, const char *text,
                                const char *file, int line);

#endif
