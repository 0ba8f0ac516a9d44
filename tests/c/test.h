/* Tests that register themselves, so that each stands in one place:
 *
 *     TEST(a_claim_that_must_hold) {
 *         assert_true(...);
 *     }
 *
 * A program runs the tests of its file, in their order. */
#ifndef TDMF_TESTS_TEST_H
#define TDMF_TESTS_TEST_H

#include "count_of.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Adds a test, whose function is handed `state`. */
void register_test(const char *name, CMUnitTestFunction test, const void *state);

/* Frees a thing when the test ends, also where it fails; returns it. */
void *free_after_test(void *thing, void (*free_thing)(void *thing));

/* Zeros until the test ends; asserts that there is room. */
void *allocate(int count, size_t size);

/* Frees what waits for the end of the test, for programs whose tests are not registered. */
void end_test(void);

/* Runs all tests that are registered; returns how many fail. */
int run_registered_tests(void);

/* A function that runs before main. */
#define BEFORE_MAIN(name) __attribute__((constructor)) static void name(void)

#define TEST(name)                                                                                           \
    static void name(void);                                                                                  \
    static void run_##name(void **state) {                                                                   \
        (void)state;                                                                                         \
        name();                                                                                              \
    }                                                                                                        \
    BEFORE_MAIN(register_##name) {                                                                           \
        register_test(#name, run_##name, NULL);                                                              \
    }                                                                                                        \
    static void name(void)

#endif
