/* Turns that are no events. */
#include "turns.h"

#include "first_root.h"
#include "margins.h"

/* A polynomial in the step's share, and up to where it counts as zero. */
typedef struct {
    double c[SERIES_TERMS];
    int order;
    double zero;
} factor;

static factor factor_of(const tdmf_step *step, const double *series, int order, double zero) {
    factor f = {.order = order, .zero = zero};
    for (int k = 0; k <= order; ++k) {
        f.c[k] = series[k] * step->power[k];
    }
    return f;
}

static factor derivative_of(const tdmf_step *step, const double *series, int order, double zero) {
    factor f = {.order = order - 1, .zero = zero};
    for (int k = 0; k < order; ++k) {
        f.c[k] = (double)(k + 1) * series[k + 1] * step->power[k];
    }
    return f;
}

typedef struct {
    double least, most;
} partial_sums;

/* See event_search.h. */
static partial_sums sums_of(const factor *f) {
    double sum = f->c[0];
    partial_sums sums = {sum, sum};
    for (int k = 1; k <= f->order; ++k) {
        sum += f->c[k];
        sums.least = smaller(sums.least, sum);
        sums.most = larger(sums.most, sum);
    }
    return sums;
}

double tdmf_force_turn(const tdmf_step *step, bool rising, double from, double to) {
    const tdmf_scales *scales = &step->chart->model->scales;
    factor rate = derivative_of(step, step->series.ground.normal_force, step->order - 1, 0.0);
    const partial_sums sums = sums_of(&rate);
    if (rising ? sums.least > 0.0 : sums.most < 0.0) {
        return INFINITY;
    }
    for (int k = 0; k <= rate.order && !rising; ++k) {
        rate.c[k] = -rate.c[k];
    }
    const root turn = first_root(rate.c, rate.order, TDMF_BEYOND_DEAD_BAND * scales->force / scales->time,
                                 from / step->size, to / step->size, choice_of(true));
    return turn.is_root ? turn.time * step->size : INFINITY;
}

/* ---- the hip's power ---------------------------------------------------------------------------------- */

/* The factors of the power that may change their sign in the step. */
typedef struct {
    factor of[2];
    int count;
} changing_factors;

static void note_factor(changing_factors *changing, factor f) {
    const partial_sums sums = sums_of(&f);
    if (!(sums.least > 0.0 || sums.most < 0.0)) {
        changing->of[changing->count++] = f;
    }
}

static bool has_no_torque(const tdmf_step *step) {
    const tdmf_hip_law *law = &step->chart->law;
    const bool is_zero =
        law->torque == 0.0 && law->torque_rate == 0.0 && law->gain == 0.0 && law->rate_gain == 0.0;
    return is_zero && step->chart->contact != TDMF_CONTACT_GRAZE;
}

static changing_factors changing_factors_of(const tdmf_step *step) {
    const tdmf_scales *scales = &step->chart->model->scales;
    const double zero = TDMF_ZERO_POWER * scales->length * scales->length / scales->time;
    changing_factors changing = {.count = 0};
    if (step->chart->contact == TDMF_CONTACT_FLIGHT) {
        const double *momentum = step->series.flight.momentum;
        note_factor(&changing, factor_of(step, momentum, step->order, zero));
        note_factor(&changing, derivative_of(step, momentum, step->order, zero / scales->time));
    } else {
        const ground_series *g = &step->series.ground;
        const bool grazes = step->chart->contact == TDMF_CONTACT_GRAZE;
        note_factor(&changing, factor_of(step, g->moment, step->order, zero));
        note_factor(&changing, factor_of(step, g->torque, grazes ? step->order - 1 : 1, zero / scales->time));
    }
    return changing;
}

/* The first time after `from` at which the power changes its sign, or `end`. */
static double next_turn(const tdmf_step *step, const changing_factors *changing, double from, double end) {
    root first = {INFINITY, 0};
    for (int i = 0; i < changing->count; ++i) {
        const factor *f = &changing->of[i];
        const root found =
            first_sign_change(f->c, f->order, f->zero, from / step->size, end / step->size, choice_of(true));
        if (found.time < first.time || (found.time == first.time && found.is_root)) {
            first = found;
        }
    }
    return first.is_root ? smaller(first.time * step->size, end) : end;
}

double tdmf_positive_work(const tdmf_step *step, double end, double total) {
    double from = 0.0, done = 0.0, positive = 0.0;
    if (has_no_torque(step)) {
        return 0.0;
    }
    const changing_factors changing = changing_factors_of(step);
    if (changing.count == 0) {
        return larger(0.0, total);
    }
    for (int i = 0; i < TDMF_TURN_LIMIT && from < end; ++i) {
        const double to = next_turn(step, &changing, from, end);
        const double done_then = to < end ? tdmf_step_work(step, to) : total;
        positive += larger(0.0, done_then - done);
        done = done_then;
        from = to;
    }
    return positive;
}
