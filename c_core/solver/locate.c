/* Event location on the dense output.
 *
 * A guard that is negative at the end of a step has crossed. One that is positive at both ends may have
 * dipped in between: it is looked at where its value and rate at both ends, by a cubic, come near zero. Roots
 * are found by the Anderson-Bjorck variant of false position, which keeps a bracket. */
#include "locate.h"

#include "chart_slope.h"

#include <math.h>

static const double never = 2.0;

/* Share of the smaller end value below which the cubic's minimum calls for a closer look. */
static const double suspicious_dip = 0.5;

enum { DIP_SAMPLES = 16, ROOT_ITERATIONS = 100 };

typedef double (*step_function)(const tdmf_search *search, int which, double fraction);

static double guard_at(const tdmf_search *search, int which, double fraction) {
    double z[CHART_COUNT];
    double state[TDMF_STATE_COUNT];
    double guards[TDMF_GUARD_COUNT];
    const double elapsed = fraction * search->step->size;
    const tdmf_inputs inputs = tdmf_inputs_after(search->inputs, search->rates, elapsed);
    tdmf_pair_within(search->chart, search->step, fraction, z);
    tdmf_chart_state(search->chart, elapsed, z, state);
    tdmf_guards(search->model, &inputs, search->mode, state, guards);
    return guards[which];
}

static double power_at(const tdmf_search *search, int sign, double fraction) {
    double z[CHART_COUNT];
    double slope[CHART_COUNT];
    tdmf_pair_within(search->chart, search->step, fraction, z);
    chart_slope(search->chart, fraction * search->step->size, z, slope);
    return sign * slope[CHART_HIP_WORK];
}

/* The root of a function that is positive at `before` and not at `after`; returned from the side where it is
 * not. */
static double root(step_function function, const tdmf_search *search, int which, double before,
                   double after) {
    double value_before = function(search, which, before);
    double value_after = function(search, which, after);
    if (!(value_before > 0.0)) {
        return before;
    }
    for (int i = 0; i < ROOT_ITERATIONS && value_after < 0.0; ++i) {
        double guess = after - value_after * (after - before) / (value_after - value_before);
        if (!(guess > before && guess < after)) {
            guess = 0.5 * (before + after);
            if (!(guess > before && guess < after)) {
                break;
            }
        }
        const double value = function(search, which, guess);
        const double share = value > 0.0 ? 1.0 - value / value_before : 1.0 - value / value_after;
        if (value > 0.0) {
            value_after *= share > 0.0 ? share : 0.5;
            before = guess;
            value_before = value;
        } else {
            value_before *= share > 0.0 ? share : 0.5;
            after = guess;
            value_after = value;
        }
    }
    return after;
}

/* The lowest value of the cubic through both ends' values and rates is near zero, or below. */
static bool may_dip(double value_0, double rate_0, double value_1, double rate_1, double size) {
    if (!(rate_0 < 0.0 && rate_1 > 0.0)) {
        return false;
    }
    /* The tangents from both ends bound a convex function from below. */
    const double lowest = (value_0 * rate_1 - value_1 * rate_0 + rate_0 * rate_1 * size) / (rate_1 - rate_0);
    return lowest < suspicious_dip * fmin(value_0, value_1);
}

/* First sampled interval that ends at or below zero. */
static double crossing_in_dip(const tdmf_search *search, int which) {
    for (int i = 1; i < DIP_SAMPLES; ++i) {
        const double after = (double)i / DIP_SAMPLES;
        if (guard_at(search, which, after) <= 0.0) {
            return root(guard_at, search, which, (double)(i - 1) / DIP_SAMPLES, after);
        }
    }
    return never;
}

double tdmf_first_crossing(const tdmf_search *search, const tdmf_watch *start, const tdmf_watch *end) {
    double first = never;
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        double fraction = never;
        if (i == TDMF_GUARD_FORCE_PEAK) {
            continue;
        }
        if (end->value[i] <= 0.0) {
            fraction = root(guard_at, search, i, 0.0, 1.0);
        } else if (may_dip(start->value[i], start->rate[i], end->value[i], end->rate[i],
                           search->step->size)) {
            fraction = crossing_in_dip(search, i);
        }
        first = fmin(first, fraction);
    }
    return first;
}

double tdmf_guard_crossing(const tdmf_search *search, tdmf_guard guard, double fraction) {
    return guard_at(search, (int)guard, fraction) <= 0.0 ? root(guard_at, search, (int)guard, 0.0, fraction)
                                                         : never;
}

double tdmf_power_reversal(const tdmf_search *search, double fraction) {
    const int sign = power_at(search, 1, 0.0) > 0.0 ? 1 : -1;
    return root(power_at, search, sign, 0.0, fraction);
}
