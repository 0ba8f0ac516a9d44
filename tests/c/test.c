#include "test.h"

#include <stdlib.h>

enum { MOST_TESTS = 64 };

static struct CMUnitTest tests[MOST_TESTS]; /* cmocka skips those without a function */
static size_t test_count;

typedef struct {
    void *thing;
    void (*free_thing)(void *thing);
} kept_thing;

static kept_thing *kept;
static size_t kept_count;

void *free_after_test(void *thing, void (*free_thing)(void *thing)) {
    kept_thing *more = realloc(kept, (kept_count + 1) * sizeof *kept);
    assert_non_null(more);
    kept = more;
    kept[kept_count++] = (kept_thing){thing, free_thing};
    return thing;
}

void *allocate(int count, size_t size) {
    void *memory = calloc((size_t)count, size);
    assert_non_null(memory);
    return free_after_test(memory, free);
}

void end_test(void) {
    while (kept_count > 0) {
        --kept_count;
        kept[kept_count].free_thing(kept[kept_count].thing);
    }
    free(kept);
    kept = NULL;
}

static int tear_down(void **state) {
    (void)state;
    end_test();
    return 0;
}

void register_test(const char *name, CMUnitTestFunction test, const void *state) {
    if (test_count == MOST_TESTS) {
        print_error("more than %d tests in one program\n", MOST_TESTS);
        abort();
    }
    tests[test_count++] = (struct CMUnitTest){
        .name = name, .test_func = test, .teardown_func = tear_down, .initial_state = (void *)state};
}

int run_registered_tests(void) {
    return cmocka_run_group_tests(tests, NULL, NULL);
}
