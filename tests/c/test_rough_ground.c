/* Rough ground: its generator gives the published numbers, its steps are normal, and independent of one
 * another along strides, runners and seeds; and runners meet them, each its own. */
#include "compare.h"
#include "crowd.h"
#include "philox.h"
#include "random.h"
#include "reference_gaits.h"
#include "sample.h"
#include "simulation.h"

#include <math.h>
#include <string.h>

/* The known answers of Random123, for philox4x32 with ten rounds. */
TEST(philox_gives_the_published_words) {
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
    for (size_t i = 0; i < COUNT_OF(known); ++i) {
        uint32_t words[4];
        tdmf_philox(known[i].counter, known[i].key, words);
        assert_memory_equal(words, known[i].words, sizeof words);
    }
}

enum { STEPS = sample_of(1000000) };

static double step(int i) {
    return tdmf_ground_step(20261122u + (uint64_t)(i % 7), (uint64_t)(i % 1000) << 24, (uint32_t)(i / 1000));
}

/* The borders include whole numbers, where the sampler joins its pieces, and the tail. */
TEST(steps_have_the_distribution_function_of_a_normal_one) {
    static const double borders[] = {-4.0, -3.0, -2.0, -1.5,  -1.0, -0.6, -0.01, 0.0,
                                     0.01, 0.3,  0.99, 1.001, 1.7,  2.0,  2.3,   3.5};
    enum { BORDERS = COUNT_OF(borders) };
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

TEST(steps_are_independent_along_strides_runners_and_seeds) {
    enum { PAIRS = sample_of(100000) };
    static const counted neighbours[] = {
        {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {0, (uint64_t)1 << 32, 0}, {(uint64_t)1 << 32, 0, 0}};
    for (size_t n = 0; n < COUNT_OF(neighbours); ++n) {
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

/* ---- runners ------------------------------------------------------------------------------------------ */

enum { RUNNERS = sample_of(300), STRIDES = 12 };

static const uint64_t seed = 7;

/* Runners whose foot hangs low and swings forward at the apex, over steps as high as the foot. */
static crowd *gather_before_high_steps(double push) {
    random_source source = {11};
    crowd *crowd = make_crowd(RUNNERS, STRIDES, 1e-11);
    tdmf_ensemble_case *scenario = share_case(crowd);
    scenario->rules.seed = seed;
    scenario->rules.roughness = 0.4;
    scenario->inputs.body.external_fx = 0.1 * push;
    scenario->inputs.body.external_fy = push;
    for (int i = 0; i < RUNNERS; ++i) {
        crowd->starts[i][TDMF_SECTION_LEG_ANGLE] = random_uniform(&source, -0.12, 0.75);
        crowd->starts[i][TDMF_SECTION_LEG_ANGLE_RATE] = 0.2;
        crowd->starts[i][TDMF_SECTION_COM_HEIGHT] *= random_uniform(&source, 0.75, 1.1);
    }
    return crowd;
}

static void assert_same_last_apex(const tdmf_ensemble_end *end, const tdmf_motion *motion) {
    assert_int_equal(end->word_code, last_stride_of(motion).word_code);
    assert_close(end->time, last_apex_of(motion).time, 1e-6);
    assert_close(end->apex[TDMF_SECTION_COM_HEIGHT], last_apex_of(motion).com_height, 1e-8);
    assert_close(end->apex[TDMF_SECTION_LEG_ANGLE], last_apex_of(motion).leg_angle, 1e-8);
}

/* There is no push, one that lightens the runner, or one that weighs it down. */
TEST(runners_whose_ground_waits_meet_it_alike_in_all_lanes) {
    static const double pushes[] = {0.0, 2e-3, -2e-3};
    strides_by_hand *by_hand = allocate(RUNNERS, sizeof *by_hand);
    int waited = 0, passed = 0;
    for (int push = 0; push < 3; ++push) {
        int compared = 0;
        crowd *crowd = gather_before_high_steps(pushes[push]);
        note_strides(crowd, STRIDES);
        for (int i = 0; i < RUNNERS; ++i) {
            stride_by_hand(crowd, i, NULL, NULL, &by_hand[i]);
            waited += by_hand[i].waited;
            passed += by_hand[i].passed;
        }
        FOR_INSTRUCTIONS(set) {
            run_crowd(crowd, set);
            for (int i = 0; i < RUNNERS; ++i) {
                assert_strides_by_hand(crowd, i, &by_hand[i]);
                if (by_hand[i].closed > 0) {
                    assert_same_last_apex(&crowd->ends[i], &by_hand[i].motions[by_hand[i].closed - 1]);
                    ++compared;
                }
            }
        }
        assert_true(compared > RUNNERS * 9 / 10);
    }
    assert_true(waited > 3 * RUNNERS / 2 && passed > RUNNERS);
}

/* Weights are checked also where nothing is drawn. */
TEST(refuses_weights_that_are_no_numbers) {
    static const double none = NAN;
    for (int i = 0; i < 4; ++i) {
        crowd *crowd = gather_before_high_steps(0.0);
        tdmf_ensemble_rules *rules = &crowd->cases[0].rules;
        rules->roughness = i < 2 ? 0.0 : 0.4;
        *(i % 2 == 0 ? &rules->step_weights : &rules->friction_weights) = &none;
        *(i % 2 == 0 ? &rules->step_weight_count : &rules->friction_weight_count) = 1;
        assert_crowd_is_refused(crowd);
    }
}

TEST(refuses_a_roughness_that_is_none) {
    static const double none[] = {-1e-300, NAN, INFINITY};
    crowd *crowd = gather_before_high_steps(0.0);
    for (size_t i = 0; i < COUNT_OF(none); ++i) {
        crowd->cases[0].rules.roughness = none[i];
        assert_crowd_is_refused(crowd);
    }
    crowd->cases[0].rules.roughness = 0.05;
    crowd->ensemble.map = TDMF_REDUCED_MAP;
    assert_crowd_is_refused(crowd);
}
