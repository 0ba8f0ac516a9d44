/* On the ground, in its own axes, X along the line and Y away from it: the body's position (X, Y) as seen
 * from the foot, so that no sine is needed. With U the body's speed relative to the foot, u the foot's, r^2 =
 * X^2 + Y^2, F = k (l - r) - c rdot, a = F/r, b = tau/r^2 and -(g_x, g_y) the acceleration of gravity, the
 * leg lifts the body with P, and leg and weight push the foot along the line with T:
 *
 *     P = a Y + b X,      T = b Y - a X - m_f g_x,      f_n = P + m_f g_y,
 *     f_t = -T (stick), -mu sgn(u) f_n (slip),
 *     Xdot = U,   Ydot = V,   m Udot = -T - m_f g_x - m g_x - m udot,   m Vdot = P - m g_y,
 *     m_f udot = T + f_t,     d(X V - Y U)/dt = tau/m - g_y X + g_x Y + Y udot,
 *     X V - Y U = r^2 w,      w = thetadot,      tau w = b (X V - Y U).
 *
 * Graze takes the torque that makes f_n = 0: b = -(a Y + m_f g_y)/X. */
#ifndef TDMF_KERNEL_GROUND_SERIES_H
#define TDMF_KERNEL_GROUND_SERIES_H

#include "series_products.h"

typedef struct {
    real x[SERIES_TERMS], y[SERIES_TERMS];   /* X, Y */
    real vx[SERIES_TERMS], vy[SERIES_TERMS]; /* U, V */
    real foot_vx[SERIES_TERMS];              /* u */
    real length[SERIES_TERMS];               /* r */
    real square[SERIES_TERMS];               /* r^2 */
    real moment[SERIES_TERMS];               /* X V - Y U */
    real length_rate[SERIES_TERMS];          /* rdot, up to order - 1, as all that follows */
    real axial[SERIES_TERMS];                /* a */
    real axial_y[SERIES_TERMS];              /* a Y */
    real turning[SERIES_TERMS];              /* b */
    real normal_force[SERIES_TERMS];         /* f_n */
    real tangential_push[SERIES_TERMS];      /* T */
    real friction[SERIES_TERMS];             /* -f_t, in slip */
    real foot_acceleration[SERIES_TERMS];    /* udot */
    real torque[SERIES_TERMS];               /* tau */
    real angle_rate[SERIES_TERMS];           /* w, in graze */
    real power[SERIES_TERMS];                /* tau w */
    real speed_square[SERIES_TERMS];         /* rdot^2 */
    real friction_power[SERIES_TERMS];       /* -f_t u */
} ground_series;

typedef struct {
    real stiffness, damping, rest_length;
    real inverse_body_mass, inverse_foot_mass;
    real foot_weight_x, foot_weight_y; /* m_f g_x, m_f g_y */
    real gravity_x, gravity_y;         /* g_x, g_y */
    real torque, torque_rate;
    real friction, friction_rate; /* with the sign of u */
    real gravity_x_rate, gravity_y_rate, rest_length_rate;
} ground_coefficients;

enum { GROUND_X, GROUND_Y, GROUND_VX, GROUND_VY, GROUND_FOOT_VX, GROUND_START_COUNT };

/* Which terms there are. The foot is free unless it sticks; slip and graze exclude each other. Where there is
 * no torque, nothing turns the leg. */
typedef struct {
    bool slips, grazes, turns;
} ground_case;

/* What all coefficients are divided by. */
typedef struct {
    real length, square, x;
} ground_inverses;

/* The inner terms of half of X^2 + Y^2 and of half of r^2. */
typedef struct {
    real squares, lengths;
} position_sums;

/* Adds the terms with coefficient i of one factor and j of the other. */
KERNEL void add_position_terms(const ground_series *g, int i, int j, position_sums *sum) {
    sum->squares += g->x[i] * g->x[j];
    sum->squares += g->y[i] * g->y[j];
    sum->lengths += g->length[i] * g->length[j];
}

/* The terms with coefficient i of both factors. */
KERNEL position_sums position_squares(const ground_series *g, int i) {
    const position_sums sum = {
        .squares = 0.5 * (g->x[i] * g->x[i] + g->y[i] * g->y[i]),
        .lengths = 0.5 * (g->length[i] * g->length[i]),
    };
    return sum;
}

/* Position and length of coefficient k + 1, and the length's rate of coefficient k. */
KERNEL void expand_position(const ground_inverses *inverse, int k, const position_sums *sum,
                            ground_series *g) {
    const int next = k + 1;
    g->x[next] = g->vx[k] * series_reciprocal[next];
    g->y[next] = g->vy[k] * series_reciprocal[next];
    const real squares = sum->squares + g->x[0] * g->x[next] + g->y[0] * g->y[next];
    g->square[next] = 2.0 * squares;
    g->length[next] = (squares - sum->lengths) * inverse->length;
    g->length_rate[k] = (double)next * g->length[next];
}

/* The inner terms of coefficient k of r a, X a, Y a, r^2 b, X b, Y b, r^2 w, Y udot, of the powers b (X V - Y
 * U) and -f_t u, and half those of rdot^2. */
typedef struct {
    real length_axial, x_axial, y_axial, square_turning, x_turning, y_turning, square_rate;
    real y_acceleration, turning_moment, friction_speed, speed_speed;
} ground_sums;

static inline ground_sums no_ground_terms(void) {
    const real zero = real_of(0.0);
    const ground_sums none = {zero, zero, zero, zero, zero, zero, zero, zero, zero, zero, zero};
    return none;
}

/* Adds those with coefficient i of the first factor and j of the second, but for rdot^2. */
KERNEL void add_mixed_terms(const ground_series *g, ground_case is, int i, int j, ground_sums *sum) {
    sum->length_axial += g->length[i] * g->axial[j];
    sum->x_axial += g->x[i] * g->axial[j];
    sum->y_axial += g->y[i] * g->axial[j];
    if (is.turns) {
        sum->square_turning += g->square[i] * g->turning[j];
        sum->x_turning += g->x[i] * g->turning[j];
        sum->y_turning += g->y[i] * g->turning[j];
        sum->turning_moment += g->moment[i] * g->turning[j];
    }
    if (is.slips || is.grazes) {
        sum->y_acceleration += g->y[i] * g->foot_acceleration[j];
    }
    if (is.slips) {
        sum->friction_speed += g->foot_vx[i] * g->friction[j];
    }
    if (is.grazes) {
        sum->square_rate += g->square[i] * g->angle_rate[j];
    }
}

/* Adds those with coefficient i of one factor and j of the other. */
KERNEL void add_ground_terms(const ground_series *g, ground_case is, int i, int j, ground_sums *sum) {
    add_mixed_terms(g, is, j, i, sum);
    add_mixed_terms(g, is, i, j, sum);
    sum->speed_speed += g->length_rate[i] * g->length_rate[j];
}

/* Those with coefficient i of both factors. */
KERNEL ground_sums ground_squares(const ground_series *g, ground_case is, int i) {
    ground_sums sum = no_ground_terms();
    add_mixed_terms(g, is, i, i, &sum);
    sum.speed_speed = 0.5 * (g->length_rate[i] * g->length_rate[i]);
    return sum;
}

/* Coefficient k of a product, from its inner terms. */
KERNEL real with_outer_terms(real inner, const real *a, const real *b, int k) {
    return k == 0 ? a[0] * b[0] : inner + a[k] * b[0] + a[0] * b[k];
}

/* Coefficient k of what is constant but for a ramp. */
KERNEL real coefficient(int k, real value, real rate) {
    return k == 0 ? value : INPUTS_RAMP && k == 1 ? rate : real_of(0.0);
}

/* Coefficient k of what leg and weight push the body and the foot with. Returns P. */
KERNEL real expand_leg_force(const ground_coefficients *c, const ground_inverses *inverse, ground_case is,
                             int k, const ground_sums *sum, ground_series *g) {
    const real force = -c->stiffness * g->length[k] - c->damping * g->length_rate[k];
    const real spring = force + c->stiffness * coefficient(k, c->rest_length, c->rest_length_rate);
    const real axial = k == 0 ? spring : spring - sum->length_axial - g->axial[0] * g->length[k];
    g->axial[k] = axial * inverse->length;
    g->axial_y[k] = with_outer_terms(sum->y_axial, g->y, g->axial, k);
    const real axial_x = with_outer_terms(sum->x_axial, g->x, g->axial, k);
    const real weight = k == 0 ? c->foot_weight_x : real_of(0.0);
    if (!is.turns) {
        g->turning[k] = real_of(0.0);
        g->tangential_push[k] = -axial_x - weight;
        return g->axial_y[k];
    }
    if (is.grazes) {
        const real rest = k == 0 ? c->foot_weight_y : sum->x_turning + g->turning[0] * g->x[k];
        g->turning[k] = -(g->axial_y[k] + rest) * inverse->x;
        g->torque[k] = with_outer_terms(sum->square_turning, g->square, g->turning, k);
    } else {
        const real rest = k == 0 ? real_of(0.0) : sum->square_turning + g->turning[0] * g->square[k];
        g->turning[k] = (g->torque[k] - rest) * inverse->square;
    }
    g->tangential_push[k] = with_outer_terms(sum->y_turning, g->y, g->turning, k) - axial_x - weight;
    if (is.grazes) {
        return k == 0 ? -c->foot_weight_y : real_of(0.0);
    }
    return g->axial_y[k] + with_outer_terms(sum->x_turning, g->x, g->turning, k);
}

/* Coefficient k of the ground's force on the foot, and of the foot's acceleration. */
KERNEL void expand_contact(const ground_coefficients *c, ground_case is, int k, real lift, ground_series *g) {
    real force = g->tangential_push[k];
    g->normal_force[k] = is.grazes ? real_of(0.0) : k == 0 ? lift + c->foot_weight_y : lift;
    if (is.slips) {
        g->friction[k] = c->friction * g->normal_force[k];
        if (k > 0) {
            g->friction[k] += c->friction_rate * g->normal_force[k - 1];
        }
        force -= g->friction[k];
    }
    g->foot_acceleration[k] = is.slips || is.grazes ? force * c->inverse_foot_mass : real_of(0.0);
}

/* Coefficient k of what changes the energy. */
KERNEL void expand_powers(const ground_inverses *inverse, ground_case is, int k, const ground_sums *sum,
                          ground_series *g) {
    const real v0 = g->length_rate[0];
    g->speed_square[k] = k == 0 ? v0 * v0 : 2.0 * (sum->speed_speed + v0 * g->length_rate[k]);
    g->power[k] = is.turns ? with_outer_terms(sum->turning_moment, g->moment, g->turning, k) : real_of(0.0);
    g->friction_power[k] =
        is.slips ? with_outer_terms(sum->friction_speed, g->foot_vx, g->friction, k) : real_of(0.0);
    if (is.grazes) {
        const real rest = k == 0 ? real_of(0.0) : sum->square_rate + g->angle_rate[0] * g->square[k];
        g->angle_rate[k] = (g->moment[k] - rest) * inverse->square;
    }
}

/* From coefficient k of positions, velocities and moment to the next ones. */
KERNEL void expand_ground_on(const ground_coefficients *c, const ground_inverses *inverse, ground_case is,
                             int k, const position_sums *position, const ground_sums *sum, ground_series *g) {
    const double divide = series_reciprocal[k + 1];
    expand_position(inverse, k, position, g);
    const real lift = expand_leg_force(c, inverse, is, k, sum, g);
    expand_contact(c, is, k, lift, g);
    expand_powers(inverse, is, k, sum, g);
    const real acceleration_y = lift * c->inverse_body_mass;
    real push =
        (k == 0 ? g->tangential_push[0] + c->foot_weight_x : g->tangential_push[k]) * c->inverse_body_mass;
    real turn = g->torque[k] * c->inverse_body_mass - c->gravity_y * g->x[k] + c->gravity_x * g->y[k];
    if (is.slips || is.grazes) {
        push += g->foot_acceleration[k];
        turn += with_outer_terms(sum->y_acceleration, g->y, g->foot_acceleration, k);
    }
    g->foot_vx[k + 1] = g->foot_acceleration[k] * divide;
    if (INPUTS_RAMP && k > 0) {
        turn += c->gravity_x_rate * g->y[k - 1] - c->gravity_y_rate * g->x[k - 1];
    }
    g->vx[k + 1] = -(push + coefficient(k, c->gravity_x, c->gravity_x_rate)) * divide;
    g->vy[k + 1] = (acceleration_y - coefficient(k, c->gravity_y, c->gravity_y_rate)) * divide;
    g->moment[k + 1] = turn * divide;
}

/* The first two coefficients, which have no inner terms but those of a position. */
KERNEL void begin_ground(const ground_coefficients *c, const ground_inverses *inverse, ground_case is,
                         ground_series *g) {
    const ground_sums none = no_ground_terms();
    const position_sums no_position = {real_of(0.0), real_of(0.0)};
    expand_ground_on(c, inverse, is, 0, &no_position, &none, g);
    const position_sums position = position_squares(g, 1);
    expand_ground_on(c, inverse, is, 1, &position, &none, g);
}

/* As expand_flight_by_two. Positions are one coefficient ahead. */
KERNEL void expand_ground_by_two(const ground_coefficients *c, const ground_inverses *inverse, ground_case is,
                                 int k, ground_series *g) {
    const int middle = k / 2;
    position_sums position = {real_of(0.0), real_of(0.0)}, next_position = position_squares(g, middle + 1);
    ground_sums sum = ground_squares(g, is, middle), next = no_ground_terms();
    add_position_terms(g, middle, middle + 1, &position);
    for (int i = middle, j = middle + 2; i > 1; --i, ++j) {
        add_position_terms(g, i, j, &next_position);
        add_position_terms(g, i - 1, j, &position);
    }
    for (int i = middle, j = middle + 1; i > 1; --i, ++j) {
        add_ground_terms(g, is, i, j, &next);
        add_ground_terms(g, is, i - 1, j, &sum);
    }
    expand_ground_on(c, inverse, is, k, &position, &sum, g);
    add_position_terms(g, 1, k + 1, &next_position);
    add_ground_terms(g, is, 1, k, &next);
    expand_ground_on(c, inverse, is, k + 1, &next_position, &next, g);
}

/* An odd order gets one coefficient more. The case is a constant wherever this is inlined. */
KERNEL void expand_ground(const ground_coefficients *coefficients, const real start[GROUND_START_COUNT],
                          int order, ground_case is, ground_series *g) {
    const ground_coefficients c = *coefficients;
    const real x = start[GROUND_X], y = start[GROUND_Y];
    g->x[0] = x;
    g->y[0] = y;
    g->foot_vx[0] = start[GROUND_FOOT_VX];
    g->vx[0] = start[GROUND_VX] - start[GROUND_FOOT_VX];
    g->vy[0] = start[GROUND_VY];
    g->square[0] = x * x + y * y;
    g->length[0] = real_sqrt(g->square[0]);
    g->moment[0] = x * g->vy[0] - y * g->vx[0];
    g->torque[0] = c.torque;
    g->torque[1] = c.torque_rate;
    for (int k = 2; k <= order; ++k) {
        g->torque[k] = real_of(0.0);
    }
    const real inverse_length = 1.0 / g->length[0];
    const ground_inverses inverse = {
        .length = inverse_length,
        .square = inverse_length * inverse_length,
        .x = is.grazes ? 1.0 / x : real_of(0.0),
    };
    begin_ground(&c, &inverse, is, g);
    for (int k = 2; k < order; k += 2) {
        expand_ground_by_two(&c, &inverse, is, k, g);
    }
}

/* The same, where the case is known at run time only. */
static inline void expand_ground_by_case(const ground_coefficients *c, const real start[GROUND_START_COUNT],
                                         int order, ground_case is, ground_series *g) {
    const ground_case sticks = {false, false, false}, sticks_and_turns = {false, false, true};
    const ground_case slips = {true, false, false}, slips_and_turns = {true, false, true};
    const ground_case grazes = {false, true, true};
    if (is.grazes) {
        expand_ground(c, start, order, grazes, g);
    } else if (is.slips && is.turns) {
        expand_ground(c, start, order, slips_and_turns, g);
    } else if (is.slips) {
        expand_ground(c, start, order, slips, g);
    } else if (is.turns) {
        expand_ground(c, start, order, sticks_and_turns, g);
    } else {
        expand_ground(c, start, order, sticks, g);
    }
}

/* As longest_flight_step. */
static inline real longest_ground_step(const ground_coefficients *c, bool free, int order) {
    const real mobility = free ? c->inverse_body_mass + c->inverse_foot_mass : c->inverse_body_mass;
    const real springs_back = real_sqrt(mobility * c->stiffness);
    return (double)order / larger(springs_back, mobility * c->damping);
}

/* The first variation of a motion on the ground. */
typedef struct {
    real x[SERIES_TERMS], y[SERIES_TERMS], vx[SERIES_TERMS], vy[SERIES_TERMS], foot_vx[SERIES_TERMS];
    real length[SERIES_TERMS], length_rate[SERIES_TERMS], square[SERIES_TERMS], moment[SERIES_TERMS];
    real axial[SERIES_TERMS], axial_y[SERIES_TERMS], turning[SERIES_TERMS];
    real normal_force[SERIES_TERMS], tangential_push[SERIES_TERMS], power[SERIES_TERMS];
} ground_variation;

/* expand_position, differentiated. */
static inline void vary_position(const ground_series *g, int k, ground_variation *t) {
    const int next = k + 1;
    t->x[next] = t->vx[k] * series_reciprocal[next];
    t->y[next] = t->vy[k] * series_reciprocal[next];
    t->square[next] = 2.0 * (product(g->x, t->x, next) + product(g->y, t->y, next));
    t->length[next] = (0.5 * t->square[next] - product_so_far(t->length, g->length, next)) / g->length[0];
    t->length_rate[k] = (double)next * t->length[next];
    t->moment[k] = vary_product(g->x, t->x, g->vy, t->vy, k) - vary_product(g->y, t->y, g->vx, t->vx, k);
}

/* expand_leg_force, differentiated. Returns the variation of P. */
static inline real vary_leg_force(const ground_coefficients *c, const ground_series *g,
                                  const ground_coefficients *d, bool grazes, int k, ground_variation *t) {
    real d_force = -c->stiffness * t->length[k] - d->stiffness * g->length[k] -
                   c->damping * t->length_rate[k] - d->damping * g->length_rate[k];
    const real d_torque = k == 0 ? d->torque : k == 1 ? d->torque_rate : real_of(0.0);
    const real d_lift_in_graze = k == 0 ? -d->foot_weight_y : real_of(0.0);
    d_force += c->stiffness * coefficient(k, d->rest_length, d->rest_length_rate) +
               d->stiffness * coefficient(k, c->rest_length, c->rest_length_rate);
    t->axial[k] = vary_quotient(g->axial, t->axial, g->length, t->length, d_force, k);
    t->axial_y[k] = vary_product(g->axial, t->axial, g->y, t->y, k);
    if (grazes) {
        t->turning[k] = vary_quotient(g->turning, t->turning, g->x, t->x, d_lift_in_graze - t->axial_y[k], k);
    } else {
        t->turning[k] = vary_quotient(g->turning, t->turning, g->square, t->square, d_torque, k);
    }
    t->tangential_push[k] = vary_product(g->turning, t->turning, g->y, t->y, k) -
                            vary_product(g->axial, t->axial, g->x, t->x, k) -
                            (k == 0 ? d->foot_weight_x : real_of(0.0));
    t->power[k] = vary_product(g->turning, t->turning, g->moment, t->moment, k);
    return grazes ? d_lift_in_graze : t->axial_y[k] + vary_product(g->turning, t->turning, g->x, t->x, k);
}

/* The foot's acceleration and the normal force, differentiated. */
static inline real vary_contact(const ground_coefficients *c, const ground_series *g,
                                const ground_coefficients *d, ground_case is, int k, real d_lift,
                                ground_variation *t) {
    real force = g->tangential_push[k];
    real d_force = t->tangential_push[k];
    t->normal_force[k] = is.grazes ? real_of(0.0) : k == 0 ? d_lift + d->foot_weight_y : d_lift;
    if (is.slips) {
        force -= g->friction[k];
        d_force -= c->friction * t->normal_force[k] + d->friction * g->normal_force[k];
        if (k > 0) {
            d_force -= c->friction_rate * t->normal_force[k - 1] + d->friction_rate * g->normal_force[k - 1];
        }
    }
    return is.slips || is.grazes ? d_force * c->inverse_foot_mass + force * d->inverse_foot_mass
                                 : real_of(0.0);
}

/* What the leg and gravity take of the body's speed along the line, differentiated. */
static inline real vary_body_push(const ground_coefficients *c, const ground_series *g,
                                  const ground_coefficients *d, int k, const ground_variation *t) {
    const real push = k == 0 ? g->tangential_push[0] + c->foot_weight_x : g->tangential_push[k];
    const real d_push = k == 0 ? t->tangential_push[0] + d->foot_weight_x : t->tangential_push[k];
    const real sum = d_push * c->inverse_body_mass + push * d->inverse_body_mass;
    return sum + coefficient(k, d->gravity_x, d->gravity_x_rate);
}

/* The recurrence of expand_ground, differentiated: `d` is the variation of the coefficients, `start` that of
 * what the motion starts from. */
static inline void vary_ground(const ground_coefficients *c, const ground_series *g,
                               const ground_coefficients *d, const real start[GROUND_START_COUNT], int order,
                               ground_case is, ground_variation *t) {
    t->x[0] = start[GROUND_X];
    t->y[0] = start[GROUND_Y];
    t->foot_vx[0] = start[GROUND_FOOT_VX];
    t->vx[0] = start[GROUND_VX] - start[GROUND_FOOT_VX];
    t->vy[0] = start[GROUND_VY];
    t->square[0] = 2.0 * (g->x[0] * t->x[0] + g->y[0] * t->y[0]);
    t->length[0] = 0.5 * t->square[0] / g->length[0];
    for (int k = 0; k < order; ++k) {
        const double divide = series_reciprocal[k + 1];
        vary_position(g, k, t);
        const real d_lift = vary_leg_force(c, g, d, is.grazes, k, t);
        const real d_acceleration = vary_contact(c, g, d, is, k, d_lift, t);
        const real lift = k == 0 ? g->normal_force[0] - c->foot_weight_y : g->normal_force[k];
        const real d_acceleration_y = d_lift * c->inverse_body_mass + lift * d->inverse_body_mass;
        t->foot_vx[k + 1] = d_acceleration * divide;
        t->vx[k + 1] = -(vary_body_push(c, g, d, k, t) + d_acceleration) * divide;
        t->vy[k + 1] = (d_acceleration_y - coefficient(k, d->gravity_y, d->gravity_y_rate)) * divide;
    }
}

#endif
