/* The power of the hip changes its sign where the torque does or the leg's angular rate, each of which is a
 * polynomial in the time since the start of the step. Times here are shares of the part that is looked at.
 *
 * Where a polynomial is monotone it changes its sign at most once, and then that shows at the ends: so the
 * rate in flight, whose momentum goes by the torque, between the zeros of this. What another may do is
 * bounded from the middle of a part on by its third derivative; a part of which neither a sign nor a
 * direction is known is halved.
 *
 * Work is stationary in the time of a turn, so that an error of the turn counts by its square. */
#include "positive_work.h"

#include "first_root.h"

#include <math.h>

/* A correction of Newton's method after which the next would be as small as its square, and count for no
 * more than the square of that. */
static const double small_correction = 1e-4;

/* Bisection alone would have come to the last bit. */
enum { CORRECTION_LIMIT = 60 };

/* In a part as short as this two changes of a sign are not told apart: what lies between them counts for no
 * more than its cube. */
static const double shortest_part = 1e-6;
enum { HALVING_LIMIT = 20 };

typedef struct {
    double c[SERIES_TERMS];
    int order;
} polynomial;

/* Times in ascending order. */
typedef struct {
    double at[2 * SERIES_TERMS];
    int count;
} zeros;

/* ---- polynomials on [0, 1] ---------------------------------------------------------------------------- */

/* What the sizes of the coefficients from `from` on add up to, each times its weight. */
static double sum_of_sizes(const double *series, const double *power, const double *weights, int from,
                           int order) {
    double sum[2] = {0.0, 0.0};
    int k = from;
    for (; k < order; k += 2) {
        for (int i = 0; i < 2; ++i) {
            sum[i] += weights[k + i] * fabs(series[k + i] * power[k + i]);
        }
    }
    if (k == order) {
        sum[0] += weights[k] * fabs(series[k] * power[k]);
    }
    return sum[0] + sum[1];
}

/* A polynomial on [0, 1] is a mean of its partial sums; see event_search.h. */
static bool keeps_sign(const polynomial *f) {
    double sum = f->c[0], minimum = sum, maximum = sum;
    for (int k = 1; k <= f->order; ++k) {
        sum += f->c[k];
        minimum = real_min(minimum, sum);
        maximum = real_max(maximum, sum);
    }
    return minimum > 0.0 || maximum < 0.0;
}

static void differentiate(const polynomial *f, polynomial *derivative) {
    derivative->order = f->order - 1;
    derivative->c[0] = f->c[1];
    for (int k = 1; k < f->order; ++k) {
        derivative->c[k] = first_derivative[k + 1] * f->c[k + 1];
    }
}

/* At the end of [0, 1]. */
static double end_of(const polynomial *f) {
    double even = f->c[0], odd = f->c[1];
    int k = 2;
    for (; k < f->order; k += 2) {
        even += f->c[k];
        odd += f->c[k + 1];
    }
    return even + odd + (k == f->order ? f->c[k] : 0.0);
}

/* A part of [0, 1], and the values at its ends. */
typedef struct {
    double from, to, start, end;
} part;

static double zero_of_chord(const part *in) {
    return in->from + (in->to - in->from) * (in->start / (in->start - in->end));
}

/* The zero of a polynomial between two times at which its signs differ, by Newton's method from a guess that
 * is within, and by bisection where that leads out. */
static double zero_between(const polynomial *f, const part *in, double guess) {
    double from = in->from, to = in->to;
    double t = guess;
    for (int i = 0; i < CORRECTION_LIMIT; ++i) {
        const expansion at = expansion_at(f->c, f->order, t);
        const bool before = (at.value < 0.0) == (in->start < 0.0);
        from = before ? t : from;
        to = before ? to : t;
        const double next = t - at.value / at.slope;
        const bool is_within = next >= from && next <= to;
        if (is_within && fabs(next - t) <= small_correction) {
            return next;
        }
        t = is_within ? next : 0.5 * (from + to);
    }
    return t;
}

/* From the middle of a part on, its third derivative is bounded by `bound`. */
typedef struct {
    bool is_monotone, keeps_sign;
} behaviour;

static behaviour behaviour_in(const part *in, const expansion *middle, double bound) {
    const double half = 0.5 * (in->to - in->from);
    const double slope_changes = half * (fabs(middle->curvature) + half * bound * (1.0 / 2));
    const double value_changes =
        half *
        (fabs(middle->slope) + half * (fabs(middle->curvature) * (1.0 / 2) + half * bound * (1.0 / 6)));
    const behaviour found = {fabs(middle->slope) >= slope_changes, !(fabs(middle->value) <= value_changes)};
    return found;
}

static bool changes_sign(const part *in) {
    return (in->start < 0.0 && in->end > 0.0) || (in->start > 0.0 && in->end < 0.0);
}

static void insert(zeros *all, double time) {
    int index = all->count++;
    for (; index > 0 && all->at[index - 1] > time; --index) {
        all->at[index] = all->at[index - 1];
    }
    all->at[index] = time;
}

/* By the parabola about the middle of a part, if its zero is within. */
static double guess_of_zero(const part *in, double time, const expansion *middle) {
    const double by_line = -middle->value / middle->slope;
    const double guess = time + by_line * (1.0 - 0.5 * by_line * middle->curvature / middle->slope);
    return guess >= in->from && guess <= in->to ? guess : zero_of_chord(in);
}

/* Adds all changes of a polynomial's sign. */
static void find_zeros(const polynomial *f, zeros *all) {
    part waiting[HALVING_LIMIT + 1];
    const part full = {0.0, 1.0, f->c[0], end_of(f)};
    const double bound = bound_of_derivative(f->c, third_derivative, f->order);
    const int limit = all->count + f->order;
    int count = 1;
    waiting[0] = full;
    while (count > 0 && all->count < limit) {
        const part in = waiting[--count];
        const double time = 0.5 * (in.from + in.to);
        const expansion middle = expansion_at(f->c, f->order, time);
        const behaviour is = behaviour_in(&in, &middle, bound);
        if (is.is_monotone || in.to - in.from < shortest_part) {
            if (changes_sign(&in)) {
                insert(all, zero_between(f, &in, guess_of_zero(&in, time, &middle)));
            }
        } else if (!is.keeps_sign) {
            const part first = {in.from, time, in.start, middle.value};
            const part second = {time, in.to, middle.value, in.end};
            waiting[count++] = second;
            waiting[count++] = first;
        }
    }
}

/* ---- the hip's power ---------------------------------------------------------------------------------- */

static bool has_no_torque(const tdmf_step *step) {
    return !tdmf_law_acts(&step->equations->law) && step->equations->contact != TDMF_CONTACT_GRAZE;
}

static void take_series(const double *series, const double *power, int order, polynomial *f) {
    f->order = order;
    f->c[0] = series[0];
    f->c[1] = series[1] * power[1];
    for (int k = 2; k <= order; ++k) {
        f->c[k] = series[k] * power[k];
    }
}

/* A torque that is linear in time has no more than two coefficients. */
static void leave_out_zeros(polynomial *f) {
    while (f->order > 1 && f->c[f->order] == 0.0) {
        --f->order;
    }
}

static void add_zeros_of(const polynomial *f, zeros *all) {
    if (!keeps_sign(f)) {
        find_zeros(f, all);
    }
}

/* Adds the zeros of a momentum to those of the torque, between which it is monotone. */
static void add_zeros_between(const polynomial *momentum, zeros *all) {
    zeros found;
    part in = {.to = 0.0, .end = momentum->c[0]};
    found.count = 0;
    for (int i = 0; i <= all->count; ++i) {
        in.from = in.to;
        in.start = in.end;
        in.to = i < all->count ? all->at[i] : 1.0;
        in.end = i < all->count ? expansion_at(momentum->c, momentum->order, in.to).value : end_of(momentum);
        if (changes_sign(&in)) {
            found.at[found.count++] = zero_between(momentum, &in, zero_of_chord(&in));
        }
    }
    for (int i = 0; i < found.count; ++i) {
        insert(all, found.at[i]);
    }
}

/* The rate has the sign of the momentum, and the torque that of the momentum's slope. Mostly neither
 * changes it. */
static void add_zeros_in_flight(const tdmf_step *step, const double *power, zeros *all) {
    const double *series = step->series.flight.momentum;
    const double slope = fabs(series[1] * power[1]);
    const double slope_changes = sum_of_sizes(series, power, first_derivative, 2, step->order);
    const bool torque_may_vanish = !(slope > slope_changes);
    polynomial momentum, torque;
    if (!torque_may_vanish && fabs(series[0]) > slope + slope_changes) {
        return;
    }
    take_series(series, power, step->order, &momentum);
    if (torque_may_vanish) {
        differentiate(&momentum, &torque);
        add_zeros_of(&torque, all);
    }
    add_zeros_between(&momentum, all);
}

/* Where the body is pushed the momentum's slope has what the push adds, too. */
static void add_zeros_in_pushed_flight(const tdmf_step *step, const double *power, zeros *all) {
    polynomial momentum, torque;
    take_series(step->series.flight.momentum, power, step->order, &momentum);
    differentiate(&momentum, &torque);
    for (int k = 0; k <= torque.order; ++k) {
        torque.c[k] -= step->series.flight.push_moment[k] * power[k + 1];
    }
    add_zeros_of(&momentum, all);
    add_zeros_of(&torque, all);
}

static void add_zeros_on_ground(const tdmf_step *step, const double *power, zeros *all) {
    const ground_series *g = &step->series.ground;
    polynomial moment, torque;
    take_series(g->moment, power, step->order, &moment);
    take_series(g->torque, power, step->order - 1, &torque);
    leave_out_zeros(&torque);
    add_zeros_of(&moment, all);
    add_zeros_of(&torque, all);
}

static void find_zeros_of_power(const tdmf_step *step, double end, zeros *all) {
    double of_end[SERIES_TERMS];
    const double *power = step->search.power;
    all->count = 0;
    if (end < step->size) {
        set_powers(of_end, end, step->order);
        power = of_end;
    }
    if (step->equations->contact == TDMF_CONTACT_FLIGHT && step->equations->is_forced) {
        add_zeros_in_pushed_flight(step, power, all);
    } else if (step->equations->contact == TDMF_CONTACT_FLIGHT) {
        add_zeros_in_flight(step, power, all);
    } else {
        add_zeros_on_ground(step, power, all);
    }
}

/* One more, if work is done in it. */
static void add_span(tdmf_spans *spans, double from, double to, double work) {
    if (spans != NULL && work > 0.0) {
        spans->from[spans->count] = from;
        spans->to[spans->count++] = to;
    }
}

/* The work done at positive power; where that is, for whoever asks. */
static double split_work(const tdmf_step *step, double end, double total, tdmf_spans *spans) {
    double from = 0.0, done = 0.0, positive = 0.0;
    if (has_no_torque(step)) {
        return 0.0;
    }
    zeros all;
    find_zeros_of_power(step, end, &all);
    for (int i = 0; i <= all.count; ++i) {
        const double to = i < all.count ? all.at[i] * end : end;
        const double done_then = i < all.count ? tdmf_step_work(step, to) : total;
        add_span(spans, from, to, done_then - done);
        positive += real_max(0.0, done_then - done);
        done = done_then;
        from = to;
    }
    return positive;
}

double tdmf_positive_work(const tdmf_step *step, double end, double total) {
    return split_work(step, end, total, NULL);
}

void tdmf_positive_spans(const tdmf_step *step, double end, double total, tdmf_spans *spans) {
    spans->count = 0;
    split_work(step, end, total, spans);
}
