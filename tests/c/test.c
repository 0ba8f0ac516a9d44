#include "test.h"

#include <stdlib.h>

enum { MOST_TESTS = 64 };

static struct CMUnitTest tests[MOST_TESTS]; /* cmocka skips those without a function */
static size_t test_count;

void register_test(const char *name, CMUnitTestFunction test, const void *state) {
    if (test_count == MOST_TESTS) {
        print_error("more than %d tests in one program\n", MOST_TESTS);
        abort();
    }
    tests[test_count++] =
        (struct CMUnitTest){.name = name, .test_func = test, .initial_state = (void *)state};
}

int run_registered_tests(void) {
    return cmocka_run_group_tests(tests, NULL, NULL);
}
