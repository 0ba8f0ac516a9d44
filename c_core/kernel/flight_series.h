/* Flight: the centre of mass is exactly ballistic, so only the leg is expanded, and gravity drops out of its
 * equations with every sine and cosine. With M = 1/m + 1/m_f, v = rdot, w = thetadot and L = r^2 w,
 *
 *     vdot = r w^2 + M (k (l0 - r) - c v),      Ldot = M tau,      w = L/r^2,
 *     tau = G (theta_target - theta) - D w + tau_1 + tau_2 t.
 *
 * `real` is a number, or a vector of them: one number for each of several runners. */

typedef struct {
    real length[SERIES_TERMS];       /* r */
    real length_rate[SERIES_TERMS];  /* v */
    real angle[SERIES_TERMS];        /* theta */
    real momentum[SERIES_TERMS];     /* L */
    real angle_rate[SERIES_TERMS];   /* w, up to order - 1, as all that follows */
    real rate_square[SERIES_TERMS];  /* w^2 */
    real speed_square[SERIES_TERMS]; /* v^2 */
    flight_factors factors;
} flight_series;

/* What the series depend on, besides their first coefficients. */
typedef struct {
    real mobility;  /* M */
    real stiffness; /* M k */
    real damping;   /* M c */
    real free_length;
    real gain, rate_gain; /* M G, M D */
    real target;
    real torque, torque_rate; /* M tau_1, M tau_2 */
} flight_coefficients;

/* From length, angle, length rate and angle rate. */
static inline void expand_flight(const flight_coefficients *a, const real start[4], int order,
                                 flight_series *f) {
    const real inverse_square = 1.0 / (start[0] * start[0]);
    real r = start[0], theta = start[1], v = start[2], w = start[3];
    real square = r * r, L = square * w, across = r * w, centrifugal = across * w;
    const real across0 = across;
    f->rate_square[0] = w * w;
    f->speed_square[0] = v * v;
    for (int k = 0; k < order; ++k) {
        if (k > 0) {
            real sum[FLIGHT_PRODUCTS];
            flight_sums(&f->factors, k, sum);
            const real r0 = f->length[0], w0 = f->angle_rate[0], v0 = f->length_rate[0];
            square = sum[FLIGHT_LENGTH_LENGTH] + 2.0 * r0 * r;
            w = (L - sum[FLIGHT_SQUARE_RATE] - square * w0) * inverse_square;
            across = sum[FLIGHT_LENGTH_RATE] + r0 * w + r * w0;
            centrifugal = sum[FLIGHT_ACROSS_RATE] + across0 * w + across * w0;
            f->rate_square[k] = sum[FLIGHT_RATE_RATE] + 2.0 * w0 * w;
            f->speed_square[k] = sum[FLIGHT_SPEED_SPEED] + 2.0 * v0 * v;
        }
        const flight_factor factor = {r, square, across, w, v};
        flight_keep(&f->factors, k, &factor);
        f->length[k] = r;
        f->length_rate[k] = v;
        f->angle[k] = theta;
        f->momentum[k] = L;
        f->angle_rate[k] = w;
        real force = centrifugal - a->stiffness * r - a->damping * v;
        real torque = -a->gain * theta - a->rate_gain * w;
        if (k == 0) {
            force += a->stiffness * a->free_length;
            torque += a->gain * a->target + a->torque;
        } else if (k == 1) {
            torque += a->torque_rate;
        }
        r = v * series_reciprocal[k + 1];
        v = force * series_reciprocal[k + 1];
        theta = w * series_reciprocal[k + 1];
        L = torque * series_reciprocal[k + 1];
    }
    f->length[order] = r;
    f->length_rate[order] = v;
    f->angle[order] = theta;
    f->momentum[order] = L;
}

/* How far series of an order may be trusted, whatever their coefficients. Where the leg comes to rest terms
 * grow up to the one whose index is rate times time, however little is left to decay: in a longer step the
 * last ones do not tell what is left out. */
static inline real longest_flight_step(const flight_coefficients *a, real length, int order) {
    const real inverse_length = 1.0 / length;
    const real inverse_square = inverse_length * inverse_length;
    const real springs_back = real_sqrt(larger(a->stiffness, a->gain * inverse_square));
    const real comes_to_rest = larger(a->damping, a->rate_gain * inverse_square);
    return (double)order / larger(springs_back, comes_to_rest);
}
