/* Changes of sign of a polynomial on [0, 1], by Bernstein's basis.
 *
 * In that basis the values of a polynomial lie between its coefficients, and it has at most as many roots as
 * its coefficients have changes of sign, and one if they have one. Pieces with more are cut in half.
 */
#include "observed.h"

#include <float.h>

enum { ROOT_LIMIT = 32, CUT_LIMIT = 64, ITERATION_LIMIT = 60 };

static const double last_correction = 1e-4; /* correction of a root; the method is of third order */

typedef struct {
    const double *c;
    int degree;
    double negligible; /* size of values whose sign does not matter */
    int count;
    double roots[ROOT_LIMIT];
} sign_changes;

static void to_bernstein(const double *c, int degree, double *b) {
    double factor = 1.0; /* 1/binomial(degree, k) */
    for (int k = 0; k <= degree; ++k) {
        b[k] = c[k] * factor;
        factor *= (k + 1) * series_reciprocal[degree - k];
    }
    for (int done = 1; done <= degree; ++done) {
        for (int k = degree; k >= done; --k) {
            b[k] += b[k - 1];
        }
    }
}

/* The value of a polynomial. Even and odd powers apart: one sum would wait for each of its terms. */
static double value_of(const double *c, int degree, double t) {
    const double square = t * t;
    int k = degree;
    double even = 0.0, odd = 0.0;
    if (k % 2 == 0) {
        even = c[k--];
    }
    for (; k > 0; k -= 2) {
        even = even * square + c[k - 1];
        odd = odd * square + c[k];
    }
    return even + t * odd;
}

/* The only root in an interval at whose ends the polynomial has opposite signs, by Halley's method. */
static double root_between(const sign_changes *of, double from, double to, bool rises, double guess) {
    double root = guess;
    for (int i = 0; i < ITERATION_LIMIT; ++i) {
        const expansion at = expansion_at(of->c, of->degree, root);
        if ((at.value > 0.0) == rises) {
            to = root;
        } else {
            from = root;
        }
        const double next =
            root - 2.0 * at.value * at.slope / (2.0 * at.slope * at.slope - at.value * at.curvature);
        const bool is_within = next > from && next < to;
        const double before = root;
        root = is_within ? next : 0.5 * (from + to);
        if (fabs(root - before) < (is_within ? last_correction : DBL_EPSILON)) {
            break;
        }
    }
    return root;
}

static void add_root(sign_changes *of, double root) {
    if (of->count < ROOT_LIMIT) {
        of->roots[of->count++] = root;
    }
}

/* A piece of the interval, and the coefficients there. */
typedef struct {
    double from, width;
    bool begins_at_root;
    double b[TERMS];
} piece;

/* Adds the root of a piece that has at most one. Returns whether the piece may have more. */
static bool may_have_more(sign_changes *of, const piece *at_hand) {
    const double *b = at_hand->b, from = at_hand->from, width = at_hand->width;
    const int n = of->degree;
    double largest = 0.0, guess = from, before = 0.0;
    int changes = 0;
    bool rises = false;
    for (int k = 0, at = 0; k <= n; ++k) {
        largest = real_max(largest, fabs(b[k]));
        if (b[k] == 0.0) {
            continue;
        }
        if (before * b[k] < 0.0) {
            ++changes;
            rises = b[k] > 0.0;
            guess = from + width * (at + (k - at) * before / (before - b[k])) / n;
        }
        before = b[k] > 0.0 ? real_max(b[k], DBL_MIN) : b[k];
        at = k;
    }
    if (changes == 0 || largest <= of->negligible) {
        return false;
    }
    if (changes == 1) {
        add_root(of, root_between(of, from, from + width, rises, guess));
    }
    return changes > 1;
}

/* Cuts a piece into its right half, which takes its place, and its left half. */
static void cut(piece *right, piece *left, int degree) {
    *left = *right;
    for (int k = 0; k <= degree; ++k) {
        left->b[k] = right->b[0];
        for (int i = 0; i < degree - k; ++i) {
            right->b[i] = 0.5 * (right->b[i] + right->b[i + 1]);
        }
    }
    left->width = right->width = 0.5 * right->width;
    right->from += right->width;
    right->begins_at_root = right->b[0] == 0.0;
}

/* Adds the roots on [0, 1] from left to right. When no cuts are left, the middle of a piece stands for its
 * roots. */
static void add_roots(sign_changes *of, const double *b) {
    piece pieces[CUT_LIMIT + 1]; /* the last one is the leftmost */
    pieces[0].from = 0.0;
    pieces[0].width = 1.0;
    pieces[0].begins_at_root = false;
    memcpy(pieces[0].b, b, sizeof pieces[0].b);
    for (int cuts = 0, count = 1; count > 0;) {
        piece *last = &pieces[count - 1];
        if (last->begins_at_root) {
            add_root(of, last->from);
            last->begins_at_root = false;
        }
        if (!may_have_more(of, last)) {
            --count;
        } else if (cuts == CUT_LIMIT) {
            add_root(of, last->from + 0.5 * last->width);
            --count;
        } else {
            cut(last, last + 1, of->degree);
            ++cuts;
            ++count;
        }
    }
}

static void add_piece(positive_pieces *pieces, double from, double to) {
    if (pieces->count > 0 && pieces->to[pieces->count - 1] == from) {
        pieces->to[pieces->count - 1] = to;
    } else {
        pieces->from[pieces->count] = from;
        pieces->to[pieces->count++] = to;
    }
}

/* The range of a polynomial on [0, 1], which is a mean of its partial sums. `weights` are those of its
 * coefficients: so the range is that of a derivative. `last` is the value at 1. */
typedef struct {
    double lowest, highest, last;
} range;

static range range_of(const double *c, int from, int degree, const double weights[SERIES_TERMS]) {
    double sum = weights[from] * c[from];
    range of = {sum, sum, sum};
    for (int k = from + 1; k <= degree; ++k) {
        sum += weights[k] * c[k];
        of.lowest = real_min(of.lowest, sum);
        of.highest = real_max(of.highest, sum);
    }
    of.last = sum;
    return of;
}

static bool keeps_sign(const range *of) {
    return of->lowest >= 0.0 || of->highest <= 0.0;
}

/* Adds the root of a polynomial that is seen to have no more than one. False if it may have more. */
static bool add_only_root(sign_changes *of) {
    const double *c = of->c;
    const range rate = range_of(c, 1, of->degree, first_derivative);
    double end = c[0];
    for (int k = 1; k <= of->degree; ++k) {
        end += c[k];
    }
    const bool changes = (c[0] < 0.0) != (end < 0.0);
    if (!keeps_sign(&rate)) {
        const range bend = range_of(c, 2, of->degree, second_derivative);
        const bool bends_away = c[0] < 0.0 ? bend.lowest >= 0.0 : bend.highest <= 0.0;
        if (!keeps_sign(&bend) || (!changes && !bends_away)) {
            return false;
        }
    }
    if (changes) {
        add_root(of, root_between(of, 0.0, 1.0, c[0] < 0.0, c[0] / (c[0] - end)));
    }
    return true;
}

/* Adds the roots of one more polynomial. */
static void add_sign_changes(sign_changes *of, const double *c, int degree) {
    double b[TERMS];
    of->c = c;
    of->degree = degree;
    if (!add_only_root(of)) {
        to_bernstein(c, degree, b);
        add_roots(of, b);
    }
}

static void sort(double *times, int count) {
    for (int i = 1; i < count; ++i) {
        const double time = times[i];
        int place = i;
        for (; place > 0 && times[place - 1] > time; --place) {
            times[place] = times[place - 1];
        }
        times[place] = time;
    }
}

double tdmf_integral_where_positive(const double *integral, int order, const double (*factors)[TERMS],
                                    int factor_count, double least, positive_pieces *pieces) {
    double sum = 0.0, before = 0.0, from = 0.0;
    sign_changes of;
    of.negligible = least;
    of.count = 0;
    for (int i = 0; i < factor_count; ++i) {
        add_sign_changes(&of, factors[i], order - 1);
    }
    sort(of.roots, of.count);
    pieces->count = 0;
    for (int i = 0; i <= of.count; ++i) {
        const double to = i < of.count ? of.roots[i] : 1.0, after = value_of(integral, order, to);
        if (after > before) {
            sum += after - before;
            add_piece(pieces, from, to);
        }
        before = after;
        from = to;
    }
    return sum;
}

double tdmf_integral_over(const double *g, int order, const positive_pieces *pieces) {
    double integral[TERMS] = {0.0}, sum = 0.0;
    integrate_polynomial(g, order, integral);
    for (int i = 0; i < pieces->count; ++i) {
        sum += value_of(integral, order, pieces->to[i]) - value_of(integral, order, pieces->from[i]);
    }
    return sum;
}

static void raise_largest(double *largest, double value, double *share, double at) {
    if (value > *largest) {
        *largest = value;
        *share = at;
    }
}

double tdmf_largest_in_step(const double *g, int order, double rounding, double largest, double *share) {
    double b[TERMS], rate[TERMS], end = 0.0, rates = 0.0, highest = g[0];
    for (int k = 1; k < order; ++k) {
        rate[k - 1] = k * g[k];
        rates += fabs(rate[k - 1]);
        end += g[k];
    }
    raise_largest(&largest, g[0], share, g[0] > largest + rounding ? 0.0 : *share);
    raise_largest(&largest, g[0] + end, share, 1.0);
    if (rates <= 2.0 * fabs(rate[0])) { /* the rate keeps its sign */
        return largest;
    }
    to_bernstein(g, order - 1, b);
    for (int k = 1; k < order; ++k) {
        highest = real_max(highest, b[k]);
        b[k - 1] = (order - 1) * (b[k] - b[k - 1]); /* those of the rate */
    }
    if (highest <= largest) {
        return largest;
    }
    sign_changes of = {.c = rate, .degree = order - 2};
    of.negligible = DBL_EPSILON * fabs(largest);
    add_roots(&of, b);
    for (int i = 0; i < of.count; ++i) {
        raise_largest(&largest, value_of(g, order - 1, of.roots[i]), share, of.roots[i]);
    }
    return largest;
}
