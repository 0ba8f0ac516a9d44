/* On the ground: the body's place (X, Y) as seen from the foot, so that no sine is needed. With U the body's
 * speed relative to the foot, u the foot's, r^2 = X^2 + Y^2, F = k (l0 - r) - c rdot, a = F/r and b =
 * tau/r^2, the leg pushes the body with P upwards and pulls the foot with H:
 *
 *     P = a Y + b X,      H = b Y - a X,      f_y = P + m_f g,      f_x = -H (stick), -mu sgn(u) f_y (slip)
 *     Xdot = U,   Ydot = V,   m Udot = -H - m udot,   m Vdot = P - m g,   m_f udot = H + f_x
 *     thetadot = w = (X V - Y U)/r^2,      d(X V - Y U)/dt = tau/m - g X + Y udot.
 *
 * Graze takes the torque that makes f_y = 0: b = -(a Y + m_f g)/X.
 *
 * `real` is a number, or a vector of them: one number for each of several runners. */

typedef struct {
    real x[SERIES_TERMS], y[SERIES_TERMS];   /* X, Y */
    real vx[SERIES_TERMS], vy[SERIES_TERMS]; /* U, V */
    real foot_vx[SERIES_TERMS];              /* u */
    real length[SERIES_TERMS];               /* r */
    real square[SERIES_TERMS];               /* r^2 */
    real moment[SERIES_TERMS];               /* X V - Y U */
    real normal_force[SERIES_TERMS];         /* f_y, up to order - 1, as all that follows */
    real leg_force_x[SERIES_TERMS];          /* H */
    real axial_y[SERIES_TERMS];              /* a Y */
    real angle_rate[SERIES_TERMS];           /* w */
    real torque[SERIES_TERMS];               /* tau */
    real power[SERIES_TERMS];                /* tau w */
    real speed_square[SERIES_TERMS];         /* rdot^2 */
    real friction_power[SERIES_TERMS];       /* -f_x u */
    ground_factors factors;
} ground_series;

typedef struct {
    real stiffness, damping, free_length;
    real inverse_body_mass, inverse_foot_mass;
    real foot_weight; /* m_f g */
    real gravity;
    real torque, torque_rate;
    real friction, friction_rate; /* with the sign of u */
} ground_coefficients;

enum { GROUND_X, GROUND_Y, GROUND_VX, GROUND_VY, GROUND_FOOT_VX, GROUND_START_COUNT };

/* What is known of coefficient k before its forces, and of coefficient 0. */
typedef struct {
    real inverse_length, inverse_square, inverse_x;
    real a, b, w, v;
    real ax, ay, bx, by;
    real a0, b0, v0, friction0, acceleration0;
} ground_step;

/* Place and length of coefficient k + 1, and the length's rate of coefficient k. */
static inline void expand_place(ground_series *g, int k, ground_step *now) {
    real sum[PLACE_PRODUCTS];
    const int next = k + 1;
    const real x = g->vx[k] * series_reciprocal[next];
    const real y = g->vy[k] * series_reciprocal[next];
    place_sums(&g->factors, next, sum);
    const real square = sum[PLACE_X_X] + sum[PLACE_Y_Y] + 2.0 * (g->x[0] * x + g->y[0] * y);
    const real length = 0.5 * (square - sum[PLACE_LENGTH_LENGTH]) * now->inverse_length;
    place_keep(&g->factors, next, x, y, length);
    g->x[next] = x;
    g->y[next] = y;
    g->square[next] = square;
    g->length[next] = length;
    now->v = (double)next * length;
}

/* Coefficient k of what the leg pushes with and turns at. */
static inline void expand_leg(const ground_coefficients *c, ground_series *g, int k, bool grazes,
                              const real sum[FREE_PRODUCTS], ground_step *now) {
    const real x = g->x[k], y = g->y[k], r = g->length[k], s = g->square[k];
    const real x0 = g->x[0], y0 = g->y[0];
    real push = -c->stiffness * r - c->damping * now->v;
    if (k == 0) {
        push += c->stiffness * c->free_length;
        now->a = push * now->inverse_length;
        now->ax = now->a * x;
        now->ay = now->a * y;
        now->b = grazes ? -(now->ay + c->foot_weight) * now->inverse_x : c->torque * now->inverse_square;
        now->bx = now->b * x;
        now->by = now->b * y;
        now->w = g->moment[0] * now->inverse_square;
        g->speed_square[0] = now->v * now->v;
        now->a0 = now->a;
        now->b0 = now->b;
        now->v0 = now->v;
        return;
    }
    const real a0 = now->a0, b0 = now->b0, w0 = g->angle_rate[0];
    now->a = (push - sum[LENGTH_AXIAL] - a0 * r) * now->inverse_length;
    now->ax = sum[X_AXIAL] + a0 * x + now->a * x0;
    now->ay = sum[Y_AXIAL] + a0 * y + now->a * y0;
    now->b = grazes ? -(now->ay + sum[X_TURNING] + b0 * x) * now->inverse_x
                    : (g->torque[k] - sum[SQUARE_TURNING] - b0 * s) * now->inverse_square;
    now->bx = sum[X_TURNING] + b0 * x + now->b * x0;
    now->by = sum[Y_TURNING] + b0 * y + now->b * y0;
    now->w = (g->moment[k] - sum[SQUARE_RATE] - w0 * s) * now->inverse_square;
    g->speed_square[k] = sum[SPEED_SPEED] + 2.0 * now->v0 * now->v;
}

/* Coefficient k of the torque and its power. */
static inline void expand_power(ground_series *g, int k, bool grazes, const real sum[FREE_PRODUCTS],
                                const ground_step *now) {
    const real w0 = k == 0 ? now->w : g->angle_rate[0];
    if (!grazes) {
        g->power[k] = g->torque[0] * now->w;
        if (k > 0) {
            g->power[k] += g->torque[1] * g->angle_rate[k - 1];
        }
        return;
    }
    g->torque[k] = now->b0 * g->square[k];
    if (k > 0) {
        g->torque[k] += sum[SQUARE_TURNING] + now->b * g->square[0];
    }
    g->power[k] = g->torque[k] * w0;
    if (k > 0) {
        g->power[k] += sum[LOSS] + g->torque[0] * now->w;
    }
}

/* The foot is free unless it sticks; `slips` and `grazes` exclude each other. Constants wherever this is
 * inlined. */
static inline void expand_ground(const ground_coefficients *c, const real start[GROUND_START_COUNT],
                                 int order, bool slips, bool grazes, ground_series *g) {
    const bool free = slips || grazes;
    const real x0 = start[GROUND_X], y0 = start[GROUND_Y];
    ground_step now;
    g->x[0] = x0;
    g->y[0] = y0;
    g->foot_vx[0] = start[GROUND_FOOT_VX];
    g->vx[0] = start[GROUND_VX] - start[GROUND_FOOT_VX];
    g->vy[0] = start[GROUND_VY];
    g->square[0] = x0 * x0 + y0 * y0;
    g->length[0] = real_sqrt(g->square[0]);
    g->moment[0] = x0 * g->vy[0] - y0 * g->vx[0];
    now.inverse_length = 1.0 / g->length[0];
    now.inverse_square = now.inverse_length * now.inverse_length;
    now.friction0 = real_of(0.0);
    now.acceleration0 = real_of(0.0);
    now.inverse_x = grazes ? 1.0 / x0 : real_of(0.0);
    for (int k = 0; k < order; ++k) {
        g->torque[k] = k == 0 ? c->torque : k == 1 ? c->torque_rate : real_of(0.0);
    }
    for (int k = 0; k < order; ++k) {
        const double divide = series_reciprocal[k + 1];
        real sum[FREE_PRODUCTS];
        real acceleration = real_of(0.0), friction = real_of(0.0), lever = real_of(0.0);
        expand_place(g, k, &now);
        ground_sums(&g->factors, k, free, sum);
        expand_leg(c, g, k, grazes, sum, &now);
        expand_power(g, k, grazes, sum, &now);
        real lift = now.ay + now.bx;
        g->axial_y[k] = now.ay;
        g->leg_force_x[k] = now.by - now.ax;
        g->normal_force[k] = grazes ? real_of(0.0) : k == 0 ? lift + c->foot_weight : lift;
        g->friction_power[k] = real_of(0.0);
        if (slips) {
            friction = c->friction * g->normal_force[k];
            if (k > 0) {
                friction += c->friction_rate * g->normal_force[k - 1];
            }
            g->friction_power[k] = friction * g->foot_vx[0];
            if (k > 0) {
                g->friction_power[k] += sum[LOSS] + now.friction0 * g->foot_vx[k];
            }
        }
        if (free) {
            acceleration = (g->leg_force_x[k] - friction) * c->inverse_foot_mass;
            lever = y0 * acceleration;
            if (k > 0) {
                lever += sum[Y_ACCELERATION] + now.acceleration0 * g->y[k];
            }
        }
        if (k == 0) {
            now.friction0 = friction;
            now.acceleration0 = acceleration;
        }
        const ground_factor factor = {.length = g->length[k],
                                      .x = g->x[k],
                                      .y = g->y[k],
                                      .square = g->square[k],
                                      .axial = now.a,
                                      .turning = now.b,
                                      .angle_rate = now.w,
                                      .length_rate = now.v,
                                      .acceleration = acceleration,
                                      .loss_left = grazes ? g->torque[k] : friction,
                                      .loss_right = grazes ? now.w : g->foot_vx[k]};
        ground_keep(&g->factors, k, free, &factor);
        g->angle_rate[k] = now.w;
        g->foot_vx[k + 1] = acceleration * divide;
        g->vx[k + 1] = -(g->leg_force_x[k] * c->inverse_body_mass + acceleration) * divide;
        lift = lift * c->inverse_body_mass;
        g->vy[k + 1] = (k == 0 ? lift - c->gravity : lift) * divide;
        g->moment[k + 1] = (g->torque[k] * c->inverse_body_mass - c->gravity * g->x[k] + lever) * divide;
    }
}

/* As longest_flight_step. */
static inline real longest_ground_step(const ground_coefficients *c, bool free, int order) {
    const real mobility = free ? c->inverse_body_mass + c->inverse_foot_mass : c->inverse_body_mass;
    const real springs_back = real_sqrt(mobility * c->stiffness);
    return (double)order / larger(springs_back, mobility * c->damping);
}
