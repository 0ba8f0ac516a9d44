/* The series of the kernel against the equations that they solve, coefficient by coefficient, and their
 * variations against differences. */
#include "compare.h"
#include "motion_series.h"
#include "random.h"

#include <math.h>
#include <string.h>

enum { MIN_ORDER = 8, RUNS = 20 };

/* ---- equations ---------------------------------------------------------------------------------------- */

/* What an equation's terms add up to, which is nothing. */
typedef struct {
    double sum, size;
} balance;

static void add(balance *balance, double term) {
    balance->sum += term;
    balance->size += fabs(term);
}

/* Coefficient k of a product. */
static void add_product(balance *balance, double factor, const double *a, const double *b, int k) {
    for (int i = 0; i <= k; ++i) {
        add(balance, factor * a[i] * b[k - i]);
    }
}

static int balanced;

/* Up to the rounding of all these terms, and of those that the coefficients in them have been made of. */
static void assert_balance(const balance *balance) {
    assert_close(balance->sum, 0.0, 2e-13 * balance->size);
    ++balanced;
}

/* Asserts that c = a b in coefficient k. */
static void assert_product(const double *c, const double *a, const double *b, int k) {
    balance balance = {0.0, 0.0};
    add(&balance, c[k]);
    add_product(&balance, -1.0, a, b, k);
    assert_balance(&balance);
}

/* Asserts that a' = rate in coefficient k. */
static void assert_rate(const double *a, const double *rate, int k) {
    balance balance = {0.0, 0.0};
    add(&balance, (k + 1) * a[k + 1]);
    add(&balance, -rate[k]);
    assert_balance(&balance);
}

/* ---- flight ------------------------------------------------------------------------------------------- */

enum {
    FLIGHT_COEFFICIENTS = sizeof(flight_coefficients) / sizeof(double),
    FLIGHT_START = sizeof(flight_start) / sizeof(double)
};

static void draw(random_source *source, double *numbers, int count) {
    for (int i = 0; i < count; ++i) {
        numbers[i] = random_uniform(source, 0.2, 1.2);
    }
}

/* Coefficient k of what is constant but for a ramp. */
static double ramp(int k, double value, double rate) {
    return k == 0 ? value : k == 1 ? rate : 0.0;
}

/* Sine and cosine of the angle, and what the push adds to the force along the leg and to the torque. */
static void assert_push(const flight_coefficients *c, const flight_series *f, int k, balance *force,
                        balance *torque) {
    const double x[] = {c->push_x, c->push_x_rate}, y[] = {c->push_y, c->push_y_rate};
    balance sine = {0.0, 0.0}, cosine = {0.0, 0.0};
    if (k > 0) {
        add(&sine, -k * f->sine[k]);
        add_product(&sine, 1.0, f->angle_rate, f->cosine, k - 1);
        assert_balance(&sine);
        add(&cosine, -k * f->cosine[k]);
        add_product(&cosine, -1.0, f->angle_rate, f->sine, k - 1);
        assert_balance(&cosine);
    }
    for (int i = 0; i < 2 && i <= k; ++i) {
        add(force, y[i] * f->cosine[k - i] - x[i] * f->sine[k - i]);
        for (int j = 0; j <= k - i; ++j) {
            const int rest = k - i - j;
            add(torque, -f->length[j] * (x[i] * f->cosine[rest] + y[i] * f->sine[rest]));
        }
    }
}

/* Without a push no rest length ramps either. */
static void assert_flight(const flight_coefficients *c, bool pushed, const flight_series *f, int order) {
    const double stiffness = c->inverse_reduced_mass * c->stiffness, gain = c->inverse_reduced_mass * c->gain;
    for (int k = 0; k < order; ++k) {
        balance force = {0.0, 0.0}, torque = {0.0, 0.0};
        if (pushed) {
            assert_push(c, f, k, &force, &torque);
        }
        assert_rate(f->length, f->length_rate, k);
        assert_rate(f->angle, f->angle_rate, k);
        assert_product(f->square, f->length, f->length, k);
        assert_product(f->momentum, f->square, f->angle_rate, k);
        assert_product(f->rate_square, f->angle_rate, f->angle_rate, k);
        assert_product(f->speed_square, f->length_rate, f->length_rate, k);
        add(&force, -(k + 1) * f->length_rate[k + 1]);
        add_product(&force, 1.0, f->length, f->rate_square, k);
        add(&force, stiffness * ramp(k, c->rest_length, pushed ? c->rest_length_rate : 0.0));
        add(&force, -stiffness * f->length[k]);
        add(&force, -c->inverse_reduced_mass * c->damping * f->length_rate[k]);
        assert_balance(&force);
        add(&torque, -(k + 1) * f->momentum[k + 1]);
        add(&torque, k == 0 ? gain * c->target : 0.0);
        add(&torque, -gain * f->angle[k]);
        add(&torque, -c->inverse_reduced_mass * c->rate_gain * f->angle_rate[k]);
        add(&torque, c->inverse_reduced_mass * ramp(k, c->torque, c->torque_rate));
        assert_balance(&torque);
    }
}

static void flight_solves_its_equations_at_any_order(void **state) {
    random_source source = {2611};
    (void)state;
    balanced = 0;
    for (int order = MIN_ORDER; order <= SERIES_ORDER_LIMIT; ++order) {
        for (int run = 0; run < RUNS; ++run) {
            flight_coefficients coefficients;
            flight_start start;
            flight_series f;
            draw(&source, &coefficients.inverse_reduced_mass, FLIGHT_COEFFICIENTS);
            draw(&source, &start.length, FLIGHT_START);
            expand_flight_by_case(&coefficients, &start, order, false, &f);
            assert_flight(&coefficients, false, &f, order);
            expand_flight_by_case(&coefficients, &start, order, true, &f);
            assert_flight(&coefficients, true, &f, order);
        }
    }
    assert_int_equal(balanced, 21 * RUNS * (18 * (MIN_ORDER + SERIES_ORDER_LIMIT) / 2 - 2));
}

/* ---- on the ground ------------------------------------------------------------------------------------ */

enum {
    GROUND_COEFFICIENTS = sizeof(ground_coefficients) / sizeof(double),
    GROUND_START = sizeof(ground_start) / sizeof(double)
};

static const ground_case cases[] = {
    {.slips = false, .grazes = false, .has_torque = false},
    {.slips = false, .grazes = false, .has_torque = true},
    {.slips = true, .grazes = false, .has_torque = false},
    {.slips = true, .grazes = false, .has_torque = true},
    {.slips = false, .grazes = true, .has_torque = true},
    {.slips = true, .has_torque = true, .falls = true},
};
enum { CASES = sizeof cases / sizeof cases[0] };

static void draw_ground(random_source *source, ground_case is, ground_coefficients *c, ground_start *start) {
    draw(source, &c->stiffness, GROUND_COEFFICIENTS);
    draw(source, &start->x, GROUND_START);
    if (!is.has_torque) {
        c->torque = c->torque_rate = 0.0;
    }
}

/* mu (1 + (rho - 1) e), where e' = -s v'/v_s e. */
static void assert_falling_friction(const ground_coefficients *c, const ground_series *g, int k) {
    balance coefficient = {0.0, 0.0}, decay = {0.0, 0.0};
    add(&coefficient, -g->coefficient[k]);
    add(&coefficient, ramp(k, c->friction, c->friction_rate));
    add(&coefficient, c->friction * c->excess * g->decay[k]);
    add(&coefficient, k > 0 ? c->friction_rate * c->excess * g->decay[k - 1] : 0.0);
    assert_balance(&coefficient);
    if (k == 0) {
        assert_close(g->decay[0], exp(c->fading * g->foot_vx[0]), 1e-15 * g->decay[0]);
        return;
    }
    add(&decay, -k * g->decay[k]);
    for (int i = 1; i <= k; ++i) {
        add(&decay, c->fading * i * g->foot_vx[i] * g->decay[k - i]);
    }
    assert_balance(&decay);
}

/* The forces of leg and ground, from those that the series hold. */
static void assert_forces(const ground_coefficients *c, const ground_series *g, ground_case is, int k) {
    balance leg = {0.0, 0.0}, along = {0.0, 0.0}, up = {0.0, 0.0}, friction = {0.0, 0.0};
    add_product(&leg, -1.0, g->length, g->axial, k);
    add(&leg, c->stiffness * ramp(k, c->rest_length, c->rest_length_rate));
    add(&leg, -c->stiffness * g->length[k]);
    add(&leg, -c->damping * g->length_rate[k]);
    assert_balance(&leg);
    if (is.grazes) {
        assert_product(g->axial_y, g->axial, g->y, k);
    }
    assert_product(g->torque, g->square, g->turning, k);
    add(&along, -g->tangential_push[k]);
    add_product(&along, 1.0, g->turning, g->y, k);
    add_product(&along, -1.0, g->axial, g->x, k);
    add(&along, k == 0 ? -c->foot_weight_x : 0.0);
    assert_balance(&along);
    add(&up, -g->normal_force[k]);
    add_product(&up, 1.0, g->turning, g->x, k);
    add_product(&up, 1.0, g->axial, g->y, k);
    add(&up, k == 0 ? c->foot_weight_y : 0.0);
    assert_balance(&up);
    if (is.slips) {
        add(&friction, -g->friction_force[k]);
        if (is.falls) {
            add_product(&friction, 1.0, g->coefficient, g->normal_force, k);
            assert_falling_friction(c, g, k);
        } else {
            add(&friction, c->friction * g->normal_force[k]);
            add(&friction, k > 0 ? c->friction_rate * g->normal_force[k - 1] : 0.0);
        }
        assert_balance(&friction);
    }
    if (is.grazes) {
        assert_true(g->normal_force[k] == 0.0);
    } else {
        assert_true(g->torque[k] == (k == 0 ? c->torque : k == 1 ? c->torque_rate : 0.0));
    }
}

static void assert_motion(const ground_coefficients *c, const ground_series *g, ground_case is, int k) {
    balance along = {0.0, 0.0}, up = {0.0, 0.0}, moment = {0.0, 0.0}, foot = {0.0, 0.0};
    assert_rate(g->x, g->vx, k);
    assert_rate(g->y, g->vy, k);
    assert_rate(g->length, g->length_rate, k);
    assert_product(g->square, g->length, g->length, k);
    add(&foot, -(k + 1) * g->foot_vx[k + 1]);
    if (is.slips || is.grazes) {
        add(&foot, c->inverse_foot_mass * g->tangential_push[k]);
        add(&foot, is.slips ? -c->inverse_foot_mass * g->friction_force[k] : 0.0);
    }
    assert_balance(&foot);
    add(&along, -(k + 1) * g->vx[k + 1]);
    add(&along, -c->inverse_body_mass * g->tangential_push[k]);
    add(&along, k == 0 ? -c->inverse_body_mass * c->foot_weight_x : 0.0);
    add(&along, -(k + 1) * g->foot_vx[k + 1]);
    add(&along, -ramp(k, c->gravity_x, c->gravity_x_rate));
    assert_balance(&along);
    add(&up, -(k + 1) * g->vy[k + 1]);
    add(&up, c->inverse_body_mass * g->normal_force[k]);
    add(&up, k == 0 ? -c->inverse_body_mass * c->foot_weight_y : 0.0);
    add(&up, -ramp(k, c->gravity_y, c->gravity_y_rate));
    assert_balance(&up);
    add(&moment, -g->moment[k]);
    add_product(&moment, 1.0, g->x, g->vy, k);
    add_product(&moment, -1.0, g->y, g->vx, k);
    assert_balance(&moment);
}

static void assert_powers(const ground_series *g, ground_case is, int k) {
    balance power = {0.0, 0.0};
    assert_product(g->speed_square, g->length_rate, g->length_rate, k);
    /* tau w = b L. */
    add(&power, -g->power[k]);
    add_product(&power, 1.0, g->turning, g->moment, k);
    assert_balance(&power);
    if (is.slips) {
        assert_product(g->friction_power, g->friction_force, g->foot_vx, k);
    }
    if (is.grazes) {
        assert_product(g->moment, g->square, g->angle_rate, k);
        assert_product(g->power, g->torque, g->angle_rate, k);
    }
}

static void the_ground_solves_its_equations_at_any_order(void **state) {
    random_source source = {2612};
    int coefficients_seen = 0;
    (void)state;
    for (int order = MIN_ORDER; order <= SERIES_ORDER_LIMIT; ++order) {
        for (int run = 0; run < CASES * RUNS; ++run) {
            const ground_case is = cases[run % CASES];
            ground_coefficients c;
            ground_start start;
            ground_series g;
            draw_ground(&source, is, &c, &start);
            expand_ground(&c, &start, order, is, &g);
            for (int k = 0; k < order; ++k) {
                assert_forces(&c, &g, is, k);
                assert_motion(&c, &g, is, k);
                assert_powers(&g, is, k);
                ++coefficients_seen;
            }
        }
    }
    assert_int_equal(coefficients_seen, 21 * CASES * RUNS * (MIN_ORDER + SERIES_ORDER_LIMIT) / 2);
}

/* A leg that coasts is one that turns with no torque. */
static void no_torque_is_a_torque_of_zero(void **state) {
    enum { ORDER = 18 };
    random_source source = {2613};
    (void)state;
    for (int run = 0; run < 2 * RUNS; ++run) {
        const bool slips = run % 2 == 1;
        const ground_case coasts = {.slips = slips}, has_torque = {.slips = slips, .has_torque = true};
        ground_coefficients c;
        ground_start start;
        static ground_series a, b;
        draw_ground(&source, coasts, &c, &start);
        expand_ground(&c, &start, ORDER, coasts, &a);
        expand_ground(&c, &start, ORDER, has_torque, &b);
        for (int k = 0; k <= ORDER; ++k) {
            assert_true(a.x[k] == b.x[k] && a.y[k] == b.y[k] && a.vx[k] == b.vx[k] && a.vy[k] == b.vy[k]);
            assert_true(a.foot_vx[k] == b.foot_vx[k] && a.moment[k] == b.moment[k]);
        }
    }
}

/* ---- variations --------------------------------------------------------------------------------------- */

enum { VARIED_ORDER = 18 };
/* How far to either side values are taken for a difference: its error falls with the fourth power of this. */
enum { STEPS = 4 };
static const double steps[STEPS] = {1e-5, -1e-5, 2e-5, -2e-5};

/* A derivative against the difference of values at these sides. */
static void assert_derivative(const double *d, const double *at[STEPS]) {
    for (int k = 0; k < VARIED_ORDER; ++k) {
        const double difference = (8.0 * (at[0][k] - at[1][k]) - (at[2][k] - at[3][k])) / (12.0 * steps[0]);
        assert_close(d[k], difference, 1e-7 * (1.0 + fabs(difference)));
        ++balanced;
    }
}

/* The same of one member of the variation `t`, which `side` has the values of. */
#define ASSERT_VARIES(member)                                                                                \
    assert_derivative(t.member, (const double *[]){shifted[0].member, shifted[1].member, shifted[2].member,  \
                                                   shifted[3].member})

/* numbers + share * change. */
static void move(const double *numbers, const double *change, double share, int count, double *moved) {
    for (int i = 0; i < count; ++i) {
        moved[i] = numbers[i] + share * change[i];
    }
}

static void flight_varies_as_it_changes(void **state) {
    random_source source = {2614};
    (void)state;
    balanced = 0;
    for (int run = 0; run < RUNS; ++run) {
        flight_coefficients c, d, moved;
        const bool pushed = run % 2 == 1;
        flight_start start, d_start, moved_start;
        flight_series f, shifted[STEPS];
        flight_variation t;
        draw(&source, &c.inverse_reduced_mass, FLIGHT_COEFFICIENTS);
        draw(&source, &d.inverse_reduced_mass, FLIGHT_COEFFICIENTS);
        draw(&source, &start.length, FLIGHT_START);
        draw(&source, &d_start.length, FLIGHT_START);
        expand_flight_by_case(&c, &start, VARIED_ORDER, pushed, &f);
        vary_flight_by_case(&c, &start, &f, &d, &d_start, VARIED_ORDER, pushed, &t);
        for (int i = 0; i < STEPS; ++i) {
            const double share = steps[i];
            move(&c.inverse_reduced_mass, &d.inverse_reduced_mass, share, FLIGHT_COEFFICIENTS,
                 &moved.inverse_reduced_mass);
            move(&start.length, &d_start.length, share, FLIGHT_START, &moved_start.length);
            expand_flight_by_case(&moved, &moved_start, VARIED_ORDER, pushed, &shifted[i]);
        }
        ASSERT_VARIES(length);
        ASSERT_VARIES(length_rate);
        ASSERT_VARIES(angle);
        ASSERT_VARIES(momentum);
    }
    assert_int_equal(balanced, RUNS * 4 * VARIED_ORDER);
}

static void the_ground_varies_as_it_changes(void **state) {
    random_source source = {2615};
    (void)state;
    balanced = 0;
    for (int run = 0; run < CASES * RUNS; ++run) {
        const ground_case is = cases[run % CASES], has_torque = {is.slips, is.grazes, true, is.falls, false};
        ground_coefficients c, d, moved;
        ground_start start, d_start, moved_start;
        ground_series g, shifted[STEPS];
        ground_variation t;
        draw_ground(&source, is, &c, &start);
        draw_ground(&source, has_torque, &d, &d_start);
        expand_ground(&c, &start, VARIED_ORDER, is, &g);
        vary_ground(&c, &start, &g, &d, &d_start, VARIED_ORDER, is, &t);
        for (int i = 0; i < STEPS; ++i) {
            const double share = steps[i];
            move(&c.stiffness, &d.stiffness, share, GROUND_COEFFICIENTS, &moved.stiffness);
            move(&start.x, &d_start.x, share, GROUND_START, &moved_start.x);
            expand_ground(&moved, &moved_start, VARIED_ORDER, has_torque, &shifted[i]);
        }
        ASSERT_VARIES(x);
        ASSERT_VARIES(vx);
        ASSERT_VARIES(vy);
        ASSERT_VARIES(foot_vx);
        ASSERT_VARIES(power);
        ASSERT_VARIES(moment);
    }
    assert_int_equal(balanced, CASES * RUNS * 6 * VARIED_ORDER);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flight_solves_its_equations_at_any_order),
        cmocka_unit_test(the_ground_solves_its_equations_at_any_order),
        cmocka_unit_test(no_torque_is_a_torque_of_zero),
        cmocka_unit_test(flight_varies_as_it_changes),
        cmocka_unit_test(the_ground_varies_as_it_changes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
