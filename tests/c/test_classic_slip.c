/* The classic spring-mass runner against values computed independently, and against what its physics says. */
#include "compare.h"
#include "tdmf_slip/classic_slip.h"

#include <math.h>
#include <stdbool.h>

static const double degree = 0.017453292519943295;
static const double energy = 6000.0;

static tdmf_classic at_angle(double degrees) {
    tdmf_classic slip = tdmf_classic_default();
    slip.touchdown_angle = degrees * degree;
    return slip;
}

static double energy_of(const tdmf_classic *slip, tdmf_classic_point at) {
    const double compression = slip->free_length - hypot(at.x, at.y);
    return slip->mass * (0.5 * (at.vx * at.vx + at.vy * at.vy) + slip->gravity * at.y) +
           0.5 * slip->stiffness * compression * compression;
}

/* These were computed independently in extended precision. */
typedef struct {
    double degrees, stable, stable_slope, impact_friction, unstable, unstable_slope;
} recorded_gait;

static const recorded_gait recorded[] = {
    {40.0, 1.03696, -0.0603, 4.939, 3.54806, 3.7622},
    {42.0, 1.17889, 0.1626, 3.852, 3.06865, 2.7634},
    {44.0, 1.50393, 0.5428, 2.798, 2.40934, 1.6600},
};

static void gaits_are_where_they_were_found(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof recorded / sizeof recorded[0]; ++i) {
        const recorded_gait *known = &recorded[i];
        const tdmf_classic slip = at_angle(known->degrees);
        double height = 0.0;
        assert_true(tdmf_classic_fixed_point(&slip, energy, known->stable + 0.01, &height));
        const tdmf_classic_step step = tdmf_classic_return_map(&slip, energy, height);
        assert_close(height, known->stable, 1.5e-5);
        assert_close(step.next_height, height, 1e-12);
        assert_close(step.by_height.height, known->stable_slope, 1.5e-4);
        assert_close(step.impact_friction, known->impact_friction, 1.5e-3);
        assert_close(step.stance_friction, tan(known->degrees * degree), 1e-11);
        assert_true(tdmf_classic_fixed_point(&slip, energy, known->unstable + 0.01, &height));
        assert_close(height, known->unstable, 1.5e-5);
        assert_close(tdmf_classic_return_map(&slip, energy, height).by_height.height, known->unstable_slope,
                     1.5e-4);
    }
}

static void two_gaits_meet_in_a_fold(void **state) {
    const tdmf_classic slip = at_angle(40.0);
    double angle = 44.0 * degree;
    double height = 2.0;
    (void)state;
    assert_true(tdmf_classic_fold(&slip, energy, &angle, &height));
    assert_close(angle / degree, 44.59, 0.005);
    const tdmf_classic there = at_angle(angle / degree);
    const tdmf_classic_step step = tdmf_classic_return_map(&there, energy, height);
    assert_close(step.next_height, height, 1e-10);
    assert_close(step.by_height.height, 1.0, 1e-8);
}

static void energy_is_kept_and_time_can_be_turned(void **state) {
    int flights = 0;
    (void)state;
    for (double degrees = 20.0; degrees < 50.0; degrees += 3.0) {
        const tdmf_classic slip = at_angle(degrees);
        const tdmf_classic_step step = tdmf_classic_return_map(&slip, energy, 1.2);
        for (int i = 0; i <= 10; ++i) {
            const tdmf_classic_point at = tdmf_classic_stance(&slip, energy, 1.2, 0.1 * i * step.stance_time);
            assert_relatively_close(energy_of(&slip, at), energy, 1e-12);
        }
        if (step.outcome != TDMF_CLASSIC_FLIES) {
            continue;
        }
        ++flights;
        assert_relatively_close(step.next_energy, energy, 1e-12);
        /* Run backwards: land where it took off, with its velocity turned, and it takes off where it landed.
         */
        tdmf_classic mirrored = slip;
        mirrored.touchdown_angle = atan2(step.take_off.x, step.take_off.y);
        const tdmf_classic_step back = tdmf_classic_return_map(&mirrored, energy, step.next_height);
        assert_close(back.next_height, 1.2, 1e-10);
        assert_close(back.stance_time, step.stance_time, 1e-11);
    }
    assert_int_equal(flights, 7);
}

/* A foot below the body or behind it: the next step after one that was pushed off far from upright. */
static void a_leg_may_land_upright_or_behind(void **state) {
    int flights = 0, falls = 0;
    (void)state;
    for (double degrees = -40.0; degrees <= 0.0; degrees += 1.0) {
        for (double speed = 0.1; speed < 4.0; speed += 0.1) {
            const tdmf_classic slip = at_angle(degrees);
            const double height = 1.2, slow = slip.mass * (0.5 * speed * speed + slip.gravity * height);
            const tdmf_classic_step step = tdmf_classic_return_map(&slip, slow, height);
            /* A leg that lengthens at touchdown cannot be compressed. */
            const double rate = step.touchdown.x * step.touchdown.vx + step.touchdown.y * step.touchdown.vy;
            if (rate > 0.0) {
                assert_int_equal(step.outcome, TDMF_CLASSIC_FALLS);
                assert_true(step.stance_time < 1e-6);
                ++falls;
                continue;
            }
            if (step.outcome != TDMF_CLASSIC_FLIES) {
                continue;
            }
            ++flights;
            assert_relatively_close(step.next_energy, slow, 1e-12);
            tdmf_classic mirrored = slip;
            mirrored.touchdown_angle = atan2(step.take_off.x, step.take_off.y);
            const tdmf_classic_step back = tdmf_classic_return_map(&mirrored, slow, step.next_height);
            assert_close(back.next_height, height, 1e-10);
            assert_close(back.stance_time, step.stance_time, 1e-11);
        }
    }
    assert_true(flights >= 10);
    assert_true(falls >= 10);
}

static void derivatives_are_those_of_the_map(void **state) {
    const double small = 1e-5;
    (void)state;
    for (double height = 1.0; height < 3.0; height += 0.4) {
        const tdmf_classic slip = at_angle(41.0), ahead = at_angle(41.0 + small / degree),
                           behind = at_angle(41.0 - small / degree);
        const tdmf_classic_step step = tdmf_classic_return_map(&slip, energy, height);
        const double by_height = (tdmf_classic_return_map(&slip, energy, height + small).next_height -
                                  tdmf_classic_return_map(&slip, energy, height - small).next_height) /
                                 (2.0 * small);
        const double by_angle = (tdmf_classic_return_map(&ahead, energy, height).next_height -
                                 tdmf_classic_return_map(&behind, energy, height).next_height) /
                                (2.0 * small);
        assert_close(step.by_height.height, by_height, 1e-6);
        assert_close(step.by_touchdown_angle.height, by_angle, 1e-5);
    }
}

/* Figure 3 of the paper: too little friction at touchdown, and in the second half of the stance. */
static void friction_ends_a_stance_in_two_ways(void **state) {
    (void)state;
    tdmf_classic slip = at_angle(30.0);
    slip.friction = 0.9 * tan(30.0 * degree);
    assert_int_equal(tdmf_classic_return_map(&slip, energy, 1.2).outcome, TDMF_CLASSIC_SLIDES);
    slip.friction = INFINITY;
    const tdmf_classic_step holding = tdmf_classic_return_map(&slip, energy, 1.2);
    const double needed = holding.take_off.x / holding.take_off.y;
    assert_true(needed > 1.1 * tan(30.0 * degree));
    slip.friction = 0.95 * needed;
    const tdmf_classic_step early = tdmf_classic_return_map(&slip, energy, 1.2);
    assert_true(early.early_take_off);
    assert_close(early.take_off.x / early.take_off.y, slip.friction, 1e-12);
    /* What was left in the spring is gone. */
    const double compression = slip.free_length - hypot(early.take_off.x, early.take_off.y);
    assert_true(compression > 0.0);
    assert_relatively_close(early.next_energy, energy - 0.5 * slip.stiffness * compression * compression,
                            1e-12);
}

/* A slow runner with a leg put far forward: the mass does not get over the foot, and falls back behind it. */
static void friction_is_needed_where_the_leg_turns_back(void **state) {
    enum { LOOKS = 2000 };
    (void)state;
    tdmf_classic slip = tdmf_classic_default();
    slip.touchdown_angle = 0.2;
    const double slow = slip.mass * (0.5 * 0.2 * 0.2 + slip.gravity * 1.35);
    const tdmf_classic_step holding = tdmf_classic_return_map(&slip, slow, 1.35);
    double steepest = 0.0;
    for (int i = 0; i <= LOOKS; ++i) {
        const tdmf_classic_point at = tdmf_classic_stance(&slip, slow, 1.35, holding.stance_time * i / LOOKS);
        steepest = fmax(steepest, fabs(at.x / at.y));
    }
    assert_int_equal(holding.outcome, TDMF_CLASSIC_TURNS_BACK);
    assert_true(holding.take_off.x < 0.0 && steepest > 1.5 * tan(0.2));
    assert_close(holding.stance_friction, steepest, 1e-9);
    slip.friction = 0.99 * steepest;
    assert_int_equal(tdmf_classic_return_map(&slip, slow, 1.35).outcome, TDMF_CLASSIC_SLIDES);
    slip.friction = 1.01 * steepest;
    assert_int_equal(tdmf_classic_return_map(&slip, slow, 1.35).outcome, TDMF_CLASSIC_TURNS_BACK);
}

static void what_cannot_start_is_refused(void **state) {
    (void)state;
    tdmf_classic slip = at_angle(40.0);
    assert_int_equal(tdmf_classic_return_map(&slip, energy, 0.5).outcome, TDMF_CLASSIC_NO_START);
    assert_int_equal(tdmf_classic_return_map(&slip, energy, 100.0).outcome, TDMF_CLASSIC_NO_START);
    assert_int_equal(tdmf_classic_return_map(&slip, NAN, 1.0).outcome, TDMF_CLASSIC_NO_START);
    assert_true(isnan(tdmf_classic_stance(&slip, energy, 1.2, NAN).x));
    slip.mass = NAN;
    assert_int_equal(tdmf_classic_return_map(&slip, energy, 1.0).outcome, TDMF_CLASSIC_NO_START);
    slip = at_angle(40.0);
    slip.friction = NAN;
    assert_int_equal(tdmf_classic_return_map(&slip, energy, 1.0).outcome, TDMF_CLASSIC_NO_START);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gaits_are_where_they_were_found),
        cmocka_unit_test(two_gaits_meet_in_a_fold),
        cmocka_unit_test(energy_is_kept_and_time_can_be_turned),
        cmocka_unit_test(a_leg_may_land_upright_or_behind),
        cmocka_unit_test(derivatives_are_those_of_the_map),
        cmocka_unit_test(friction_ends_a_stance_in_two_ways),
        cmocka_unit_test(friction_is_needed_where_the_leg_turns_back),
        cmocka_unit_test(what_cannot_start_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
