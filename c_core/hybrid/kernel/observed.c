/* Pieces of a step in which an observed quantity, or its rate, keeps its sign. */
#include "observed.h"

enum { PIECE_LIMIT = 32 };

static const double sign_margin = 1e-7; /* of an observed quantity, relative to its largest coefficient */

/* The end of a piece of [from, 1] in which a polynomial, scaled to the step, keeps its sign. */
static double end_of_sign(const double *g, int degree, double from) {
    double largest = 0.0;
    for (int k = 0; k <= degree; ++k) {
        largest = real_max(largest, real_abs(g[k]));
    }
    const root found = first_sign_change(g, degree, sign_margin * largest, from, 1.0, true);
    return found.is_root && found.time < 1.0 ? found.time : 1.0;
}

double tdmf_integral_of_pieces(const double *g, const double *integral, int order, double size) {
    double power[TERMS], sum = 0.0, from = 0.0, before = 0.0;
    for (int pieces = 0; pieces < PIECE_LIMIT && from < 1.0; ++pieces) {
        from = end_of_sign(g, order - 1, from);
        set_powers(power, from * size, order);
        const double after = sum_of(integral, power, order);
        sum += real_max(0.0, after - before);
        before = after;
    }
    return sum;
}

double tdmf_largest_of_pieces(const double *g, int order, double largest) {
    double rate[TERMS], power[TERMS], from = 0.0;
    for (int k = 1; k < order; ++k) {
        rate[k - 1] = k * g[k];
    }
    for (int pieces = 0; pieces < PIECE_LIMIT && from < 1.0; ++pieces) {
        from = end_of_sign(rate, order - 2, from);
        set_powers(power, from, order);
        largest = real_max(largest, sum_of(g, power, order - 1));
    }
    return largest;
}
