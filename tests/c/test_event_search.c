/* What a step is seen by not to have an event, and what the search notes: on guards whose zeros are known. */
#include "compare.h"
#include "ground_guards.h"
#include "random.h"

#include <math.h>
#include <string.h>

enum { LONGEST = 9 };

static const double step_size = 2.0;

static event_search search_of_order(int order) {
    event_search search;
    memset(&search, 0, sizeof search);
    search.size = step_size;
    set_powers(search.power, step_size, order);
    begin_search(&search, order, mask_of(true), -1e-12);
    return search;
}

/* In the share of the step, as the search has them; a series is one in time. */
static void in_time(const double *shares, int order, double series[SERIES_TERMS]) {
    memset(series, 0, SERIES_TERMS * sizeof *series);
    for (int k = 0; k <= order; ++k) {
        series[k] = shares[k] / pow(step_size, k);
    }
}

/* ---- bounds -------------------------------------------------------------------------------------------- */

/* The series 2 + 0 t + ... - 3 t^last is as low as -1 at the end of the step, by one term alone. */
static void the_least_sum_knows_every_term(void **state) {
    (void)state;
    for (int order = 1; order <= LONGEST; ++order) {
        const event_search search = search_of_order(order);
        for (int term = 1; term <= order; ++term) {
            double shares[SERIES_TERMS] = {2.0}, series[SERIES_TERMS];
            shares[term] = -3.0;
            in_time(shares, order, series);
            const guard_series guard = {series, 1.0, 2.0, order};
            assert_close(min_partial_sum(&search, &guard), -1.0, 1e-15);
            const guard_series turned = {series, -1.0, -2.0, order};
            assert_close(min_partial_sum(&search, &turned), -2.0, 1e-15);
        }
    }
}

/* A dip in the middle is a partial sum that later terms make good again. */
static void the_least_sum_is_no_higher_than_the_polynomial(void **state) {
    random_source source = {41};
    (void)state;
    for (int i = 0; i < 500; ++i) {
        const int order = 1 + i % LONGEST;
        const event_search search = search_of_order(order);
        double shares[SERIES_TERMS] = {0.0}, series[SERIES_TERMS];
        for (int k = 0; k <= order; ++k) {
            shares[k] = random_uniform(&source, -1.0, 1.0);
        }
        in_time(shares, order, series);
        const guard_series guard = {series, 1.0, series[0], order};
        const double lower_bound = min_partial_sum(&search, &guard);
        for (int k = 0; k <= 20; ++k) {
            assert_true(expansion_at(shares, order, 0.05 * k).value >= lower_bound - 1e-14);
        }
    }
}

static void the_spread_knows_every_term(void **state) {
    (void)state;
    for (int order = 1; order <= LONGEST; ++order) {
        const event_search search = search_of_order(order);
        for (int term = 1; term <= order; ++term) {
            for (double sign = -1.0; sign < 2.0; sign += 2.0) {
                double shares[SERIES_TERMS] = {5.0}, series[SERIES_TERMS];
                shares[term] = 3.0 * sign;
                in_time(shares, order, series);
                assert_close(largest_deviation(&search, series, order), 3.0, 1e-15);
            }
        }
    }
}

/* ---- a force that vanishes for a part of the step ------------------------------------------------------ */

static ground_constants standing_on(double friction) {
    ground_constants c;
    memset(&c, 0, sizeof c);
    c.mode.margin_factor = c.mode.force_scale = c.mode.energy_scale = 1.0;
    c.cone.normal = friction;
    c.cone.tangential = 1.0;
    return c;
}

/* f_n = (s - 1/4) (s - 1/2) in the share s of the step: it begins and ends above zero. */
static void a_force_that_comes_back_within_the_step_has_lifted_the_foot(void **state) {
    static const double shares[] = {0.125, -0.75, 1.0};
    (void)state;
    for (int sticks = 0; sticks < 2; ++sticks) {
        const ground_constants c = standing_on(1e3);
        event_search search = search_of_order(8);
        ground_series g;
        memset(&g, 0, sizeof g);
        in_time(shares, 2, g.normal_force);
        watch_forces(&search, &c, &g, sticks, false);
        search_pending(&search);
        assert_int_equal(guard_of_end(search.end), TDMF_GUARD_LIFT_OFF);
        assert_close(search.time, 0.25, 1e-11);
    }
}

/* The same of the room within the cone: |f_t| = 1 - (s - 1/4) (s - 1/2) under f_n = 1 and mu = 1. */
static void a_push_that_leaves_the_cone_for_a_while_slips(void **state) {
    static const double shares[] = {1.0 - 0.125, 0.75, -1.0};
    (void)state;
    for (double sign = -1.0; sign < 2.0; sign += 2.0) {
        const ground_constants c = standing_on(1.0);
        event_search search = search_of_order(8);
        ground_series g;
        memset(&g, 0, sizeof g);
        g.normal_force[0] = 1.0;
        in_time(shares, 2, g.tangential_push);
        for (int k = 0; k <= 2; ++k) {
            g.tangential_push[k] *= sign;
        }
        watch_forces(&search, &c, &g, true, false);
        search_pending(&search);
        assert_int_equal(guard_of_end(search.end),
                         sign > 0.0 ? TDMF_GUARD_SLIP_ONSET_POSITIVE : TDMF_GUARD_SLIP_ONSET_NEGATIVE);
        assert_close(search.time, 0.25, 1e-11);
    }
}

/* ---- the kink of the clamp ----------------------------------------------------------------------------- */

/* The argument of the clamp in graze passes zero at 0.3 of the step, down or up. There the law has a kink, at
 * which the step ends; up to there the torque is the argument, or nothing. */
static void a_step_in_graze_ends_at_the_kink_of_the_clamp(void **state) {
    (void)state;
    for (double sign = -1.0; sign < 2.0; sign += 2.0) {
        const double shares[] = {0.3 * sign, -1.0 * sign};
        const ground_constants c = standing_on(1.0);
        event_search search = search_of_order(8);
        double torque[SERIES_TERMS];
        in_time(shares, 1, torque);
        clamp_servo(&search, &c, mask_of(true), 7, torque);
        search_pending(&search);
        assert_int_equal(search.end, KINK);
        assert_close(search.time, 0.3, 1e-11);
        assert_close(torque[0], sign > 0.0 ? 0.3 : 0.0, 1e-15);
        assert_close(torque[1], sign > 0.0 ? -0.5 : 0.0, 1e-15);
    }
}

/* A leg that is placed has no clamp. */
static void without_a_clamp_there_is_no_kink(void **state) {
    static const double shares[] = {0.3, -1.0};
    const ground_constants c = standing_on(1.0);
    event_search search = search_of_order(8);
    double torque[SERIES_TERMS];
    (void)state;
    in_time(shares, 1, torque);
    clamp_servo(&search, &c, mask_of(false), 7, torque);
    search_pending(&search);
    assert_true(search.time == INFINITY);
    assert_close(torque[1], -0.5, 1e-15);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_least_sum_knows_every_term),
        cmocka_unit_test(the_least_sum_is_no_higher_than_the_polynomial),
        cmocka_unit_test(the_spread_knows_every_term),
        cmocka_unit_test(a_force_that_comes_back_within_the_step_has_lifted_the_foot),
        cmocka_unit_test(a_push_that_leaves_the_cone_for_a_while_slips),
        cmocka_unit_test(a_step_in_graze_ends_at_the_kink_of_the_clamp),
        cmocka_unit_test(without_a_clamp_there_is_no_kink),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
