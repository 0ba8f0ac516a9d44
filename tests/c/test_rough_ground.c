/* Rough ground: its generator gives the published numbers, and its steps are normal, and independent of one
 * another along strides, runners and seeds. */
#include "compare.h"
#include "philox.h"
#include "tdmf_slip/ensemble.h"

#include <math.h>
#include <string.h>

/* The known answers of Random123, for philox4x32 with ten rounds. */
static void philox_gives_the_published_words(void **unused) {
    (void)unused;
    static const struct {
        uint32_t counter[4], key[2], words[4];
    } known[] = {
        {{0, 0, 0, 0}, {0, 0}, {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}},
        {{0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff},
         {0xffffffff, 0xffffffff},
         {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}},
        {{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
         {0xa4093822, 0x299f31d0},
         {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}},
    };
    for (size_t i = 0; i < sizeof known / sizeof known[0]; ++i) {
        uint32_t words[4];
        tdmf_philox(known[i].counter, known[i].key, words);
        assert_memory_equal(words, known[i].words, sizeof words);
    }
}

enum { STEPS = 1000000 };

static double step(int i) {
    return tdmf_ground_step(20261122u + (uint64_t)(i % 7), (uint64_t)(i % 1000) << 24, (uint32_t)(i / 1000));
}

/* By moments up to the sixth: 0, 1, 0, 3, 0, 15, whose estimates have the variances 1, 2, 15, 96, 945, 10170
 * over the number of steps. */
static void steps_have_the_moments_of_a_normal_distribution(void **unused) {
    (void)unused;
    static const double moments[] = {0.0, 1.0, 0.0, 3.0, 0.0, 15.0};
    static const double variances[] = {1.0, 2.0, 15.0, 96.0, 945.0, 10170.0};
    double sums[6] = {0.0};
    for (int i = 0; i < STEPS; ++i) {
        const double size = step(i);
        double power = 1.0;
        for (int n = 0; n < 6; ++n) {
            power *= size;
            sums[n] += power;
        }
    }
    for (int n = 0; n < 6; ++n) {
        assert_close(sums[n] / STEPS, moments[n], 4.0 * sqrt(variances[n] / STEPS));
    }
}

/* At borders of whole numbers too, where the sampler puts its parts together, and in the tail. */
static void steps_have_the_distribution_function_of_a_normal_one(void **unused) {
    (void)unused;
    static const double borders[] = {-4.0, -3.0, -2.0, -1.5,  -1.0, -0.6, -0.01, 0.0,
                                     0.01, 0.3,  0.99, 1.001, 1.7,  2.0,  2.3,   3.5};
    enum { BORDERS = sizeof borders / sizeof borders[0] };
    long below[BORDERS] = {0};
    for (int i = 0; i < STEPS; ++i) {
        const double size = step(i);
        for (int n = 0; n < BORDERS; ++n) {
            below[n] += size < borders[n];
        }
    }
    for (int n = 0; n < BORDERS; ++n) {
        const double share = 0.5 * erfc(-borders[n] / sqrt(2.0));
        assert_close((double)below[n] / STEPS, share, 4.0 * sqrt(share * (1.0 - share) / STEPS));
    }
}

typedef struct {
    uint64_t seed, runner;
    uint32_t stride;
} counted;

static double step_of(counted of) {
    return tdmf_ground_step(of.seed, of.runner, of.stride);
}

static void steps_are_independent_along_strides_runners_and_seeds(void **unused) {
    (void)unused;
    enum { PAIRS = 100000 };
    static const counted neighbours[] = {
        {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, (uint64_t)1 << 32, 0}, {(uint64_t)1 << 32, 0, 0}};
    for (size_t n = 0; n < sizeof neighbours / sizeof neighbours[0]; ++n) {
        double products = 0.0;
        for (uint32_t i = 0; i < PAIRS; ++i) {
            const counted one = {3 * i, 5 * (uint64_t)i, 7 * i};
            const counted other = {one.seed + neighbours[n].seed, one.runner + neighbours[n].runner,
                                   one.stride + neighbours[n].stride};
            products += step_of(one) * step_of(other);
        }
        assert_close(products / PAIRS, 0.0, 4.0 / sqrt(PAIRS));
    }
}

static void a_step_is_the_same_whatever_was_drawn_before(void **unused) {
    (void)unused;
    const double first = tdmf_ground_step(1, 2, 3);
    (void)tdmf_ground_step(4, 5, 6);
    assert_true(tdmf_ground_step(1, 2, 3) == first);
    assert_true(tdmf_ground_step(1, 2, 4) != first);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(philox_gives_the_published_words),
        cmocka_unit_test(steps_have_the_moments_of_a_normal_distribution),
        cmocka_unit_test(steps_have_the_distribution_function_of_a_normal_one),
        cmocka_unit_test(steps_are_independent_along_strides_runners_and_seeds),
        cmocka_unit_test(a_step_is_the_same_whatever_was_drawn_before),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
