/* The classic spring-mass runner on slopes and with a leg that retracts: against differences, against its own
 * motion turned back, and against what its physics says. SciPy integrates it in test_classic_slip.py. */
#include "compare.h"
#include "random.h"
#include "tdmf_slip/classic_slip.h"

#include <math.h>
#include <stdbool.h>

static const double degree = 0.017453292519943295;
static const double energy = 6000.0;

static tdmf_classic with(double degrees, double slope, double rate) {
    tdmf_classic slip = tdmf_classic_default();
    slip.touchdown_angle = degrees * degree;
    slip.ground_slope = slope * degree;
    slip.retraction_rate = rate;
    return slip;
}

static const tdmf_classic_variation *change_of(const tdmf_classic_step *step, int k) {
    const tdmf_classic_variation *changes[] = {&step->by_height, &step->by_energy, &step->by_touchdown_angle,
                                               &step->by_ground_slope, &step->by_retraction_rate};
    return changes[k];
}

/* A step whose k-th argument is changed by so much. */
static tdmf_classic_step shifted(tdmf_classic slip, double height, int k, double by) {
    slip.touchdown_angle += k == 2 ? by : 0.0;
    slip.ground_slope += k == 3 ? by : 0.0;
    slip.retraction_rate += k == 4 ? by : 0.0;
    return tdmf_classic_return_map(&slip, energy + (k == 1 ? by : 0.0), height + (k == 0 ? by : 0.0));
}

static void changes_are_those_of_the_step(void **state) {
    const double sizes[] = {1e-5, 1e-2, 1e-5, 1e-5, 1e-5};
    int compared = 0;
    (void)state;
    for (int i = 0; i < 36; ++i) {
        const tdmf_classic slip = with(36.0 + 2.0 * (i % 3), 4.0 * (i / 3 % 4) - 6.0, 0.15 * (i / 12) - 0.1);
        const tdmf_classic_step step = tdmf_classic_return_map(&slip, energy, 1.3);
        assert_int_equal(step.outcome, TDMF_CLASSIC_FLIES);
        for (int k = 0; k < 5; ++k, ++compared) {
            const double h = sizes[k];
            const tdmf_classic_step ahead = shifted(slip, 1.3, k, h), behind = shifted(slip, 1.3, k, -h);
            const tdmf_classic_variation *exact = change_of(&step, k);
            const double scale = k == 1 ? 1e-3 : 1.0;
            assert_close(exact->height, (ahead.next_height - behind.next_height) / (2.0 * h), 1e-6 * scale);
            assert_close(exact->length, (ahead.length - behind.length) / (2.0 * h), 1e-5 * scale);
            assert_close(exact->energy, (ahead.next_energy - behind.next_energy) / (2.0 * h), 2e-2 * scale);
        }
    }
    assert_int_equal(compared, 180);
}

static void a_step_takes_of_the_energy_what_it_climbs(void **state) {
    (void)state;
    for (double slope = -10.0; slope <= 15.0; slope += 5.0) {
        const tdmf_classic slip = with(40.0, slope, 0.1);
        const tdmf_classic_step step = tdmf_classic_return_map(&slip, energy, 1.3);
        assert_int_equal(step.outcome, TDMF_CLASSIC_FLIES);
        assert_true(step.length > 0.0);
        assert_relatively_close(step.next_energy,
                                energy - slip.mass * slip.gravity * step.length * tan(slip.ground_slope),
                                1e-13);
    }
}

/* Seen in a mirror, the step backwards lands where this one took off, on the slope that falls where this one
 * rises. */
static void time_can_be_turned_on_a_slope(void **state) {
    (void)state;
    for (double slope = -10.0; slope <= 5.0; slope += 5.0) {
        const tdmf_classic slip = with(42.0, slope, 0.0);
        const tdmf_classic_step step = tdmf_classic_return_map(&slip, energy, 1.4);
        assert_int_equal(step.outcome, TDMF_CLASSIC_FLIES);
        tdmf_classic mirrored = slip;
        mirrored.touchdown_angle = atan2(step.take_off.x, step.take_off.y);
        mirrored.ground_slope = -slip.ground_slope;
        const tdmf_classic_step back = tdmf_classic_return_map(&mirrored, step.next_energy, step.next_height);
        assert_close(back.next_height, 1.4, 1e-11);
        assert_relatively_close(back.next_energy, energy, 1e-12);
        assert_close(back.length, step.length, 1e-11);
        assert_close(back.stance_time, step.stance_time, 1e-12);
    }
}

/* A leg that retracts is, in one step, a leg that is held at the angle in which it comes down. */
static void retraction_is_an_angle_that_depends_on_the_fall(void **state) {
    (void)state;
    for (double rate = -0.2; rate < 0.7; rate += 0.2) {
        const tdmf_classic slip = with(44.0, 6.0, rate);
        const tdmf_classic_step step = tdmf_classic_return_map(&slip, energy, 1.5);
        assert_int_equal(step.outcome, TDMF_CLASSIC_FLIES);
        tdmf_classic at_rest = slip;
        at_rest.touchdown_angle = slip.touchdown_angle + rate * step.touchdown.vy / slip.gravity;
        at_rest.retraction_rate = 0.0;
        const tdmf_classic_step same = tdmf_classic_return_map(&at_rest, energy, 1.5);
        assert_close(step.next_height, same.next_height, 1e-12);
        assert_close(step.length, same.length, 1e-11);
        /* How that angle changes with the height, from the touchdown of the held leg, by the chain rule. */
        const double foot_fall = step.touchdown.vy - step.touchdown.vx * tan(slip.ground_slope);
        const double l0_swing = slip.free_length * (sin(at_rest.touchdown_angle) -
                                                    tan(slip.ground_slope) * cos(at_rest.touchdown_angle));
        const double time = -step.touchdown.vy / slip.gravity;
        const double by_height = 1.0 + tan(slip.ground_slope) * time * slip.gravity / step.touchdown.vx;
        const double time_by_height = -by_height / (foot_fall - rate * l0_swing);
        assert_close(step.by_height.height,
                     same.by_height.height - rate * time_by_height * same.by_touchdown_angle.height, 1e-11);
    }
}

/* Next to 0 the foot is found by another way than at 0. */
static void small_rates_and_slopes_are_next_to_none(void **state) {
    (void)state;
    const tdmf_classic level = with(40.0, 0.0, 0.0), nearly = with(40.0, 1e-13, 1e-14);
    const tdmf_classic_step step = tdmf_classic_return_map(&level, energy, 1.2);
    const tdmf_classic_step near = tdmf_classic_return_map(&nearly, energy, 1.2);
    assert_close(near.next_height, step.next_height, 1e-13);
    assert_close(near.length, step.length, 1e-12);
    assert_close(near.by_height.height, step.by_height.height, 1e-11);
    assert_close(near.by_retraction_rate.height, step.by_retraction_rate.height, 1e-11);
}

/* The leg's angle counts from the ground's normal. */
static void friction_holds_against_the_normal_of_the_ground(void **state) {
    (void)state;
    tdmf_classic slip = with(30.0, 12.0, 0.0);
    slip.friction = 1.01 * tan(18.0 * degree);
    const tdmf_classic_step early = tdmf_classic_return_map(&slip, energy, 1.3);
    assert_true(early.early_take_off);
    assert_close(atan2(early.take_off.x, early.take_off.y) + slip.ground_slope, atan(slip.friction), 1e-12);
    slip.friction = 0.99 * tan(18.0 * degree);
    assert_int_equal(tdmf_classic_return_map(&slip, energy, 1.3).outcome, TDMF_CLASSIC_SLIDES);
    slip.friction = INFINITY;
    slip.ground_slope = -slip.ground_slope;
    assert_true(tdmf_classic_return_map(&slip, energy, 1.3).stance_friction >= tan(42.0 * degree));
    /* A foot that is turned back as fast as the ground passes by needs no friction at its impact. */
    slip = with(80.0, 0.0, 0.0);
    const double speed = sqrt(2.0 * (energy / slip.mass - slip.gravity * 0.9));
    tdmf_classic_step step = tdmf_classic_return_map(&slip, energy, 0.9);
    for (int i = 0; i < 400; ++i) {
        slip.retraction_rate += 0.1 * (speed / step.touchdown.y - slip.retraction_rate);
        step = tdmf_classic_return_map(&slip, energy, 0.9);
        assert_int_equal(step.outcome, TDMF_CLASSIC_FLIES);
    }
    assert_close(step.impact_friction, 0.0, 1e-12);
}

static void what_comes_down_before_the_foot_has_fallen(void **state) {
    (void)state;
    /* A leg turned up beyond the horizontal. */
    tdmf_classic slip = with(80.0, 0.0, -20.0);
    assert_int_equal(tdmf_classic_return_map(&slip, energy, 1.3).outcome, TDMF_CLASSIC_FALLS);
    slip = with(40.0, 0.0, NAN);
    assert_int_equal(tdmf_classic_return_map(&slip, energy, 1.3).outcome, TDMF_CLASSIC_NO_START);
    slip = with(40.0, 58.0, 0.0);
    assert_int_equal(tdmf_classic_return_map(&slip, energy, 1.3).outcome, TDMF_CLASSIC_NO_START);
    slip.ground_slope = NAN;
    assert_int_equal(tdmf_classic_return_map(&slip, energy, 1.3).outcome, TDMF_CLASSIC_NO_START);
}

/* No gait repeats height and energy on a slope, for steps that fly have a length. */
static void random_steps_end_and_go_forwards(void **state) {
    random_source source = {20};
    int outcomes[TDMF_CLASSIC_TURNS_BACK + 1] = {0};
    (void)state;
    for (int i = 0; i < 5000; ++i) {
        tdmf_classic slip = with(random_uniform(&source, 1.0, 89.0), random_uniform(&source, -57.0, 57.0),
                                 random_uniform(&source, -3.0, 8.0));
        slip.friction = random_chance(&source, 0.5) ? INFINITY : random_magnitude(&source, 0.05, 5.0);
        slip.stiffness = random_magnitude(&source, 1e3, 1e6);
        const double height = random_uniform(&source, 0.2, 3.0);
        const double given = slip.mass * slip.gravity * height * random_uniform(&source, 1.0, 4.0);
        const tdmf_classic_step step = tdmf_classic_return_map(&slip, given, height);
        ++outcomes[step.outcome];
        if (step.outcome == TDMF_CLASSIC_FLIES) {
            const double climbed = slip.mass * slip.gravity * step.length * tan(slip.ground_slope) / given;
            const double left = step.next_energy / given;
            assert_true(step.length > 0.0 && step.next_height > 0.0);
            assert_true(step.early_take_off ? left <= 1.0 - climbed + 1e-12
                                            : fabs(left + climbed - 1.0) < 1e-11);
        }
    }
    for (int k = 0; k <= TDMF_CLASSIC_TURNS_BACK; ++k) {
        assert_true(outcomes[k] > 50);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(changes_are_those_of_the_step),
        cmocka_unit_test(a_step_takes_of_the_energy_what_it_climbs),
        cmocka_unit_test(time_can_be_turned_on_a_slope),
        cmocka_unit_test(retraction_is_an_angle_that_depends_on_the_fall),
        cmocka_unit_test(small_rates_and_slopes_are_next_to_none),
        cmocka_unit_test(friction_holds_against_the_normal_of_the_ground),
        cmocka_unit_test(what_comes_down_before_the_foot_has_fallen),
        cmocka_unit_test(random_steps_end_and_go_forwards),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
