/* Finds extrema that are no events. */
#include "extrema.h"

#include "first_root.h"
#include "margins.h"
#include "series_sums.h"

/* As many as a series can have. */
enum { EXTREMUM_LIMIT = SERIES_ORDER_LIMIT };

/* A polynomial in the step's share, and up to where it counts as zero. */
typedef struct {
    double c[SERIES_TERMS];
    int order;
    double zero;
    bool is_monotone;
} factor;

static factor factor_of(const tdmf_step *step, const double *series, int order, double zero) {
    factor f = {.order = order, .zero = zero};
    for (int k = 0; k <= order; ++k) {
        f.c[k] = series[k] * step->search.power[k];
    }
    return f;
}

static factor derivative_of(const tdmf_step *step, const double *series, int order, double zero) {
    factor f = {.order = order - 1, .zero = zero};
    for (int k = 0; k < order; ++k) {
        f.c[k] = (double)(k + 1) * series[k + 1] * step->search.power[k];
    }
    return f;
}

/* The range of the partial sums of a series; see event_search.h. */
typedef struct {
    double sum, minimum, maximum;
} partial_sums;

static inline partial_sums with_term(partial_sums sums, double term) {
    const double sum = sums.sum + term;
    const partial_sums next = {sum, real_min(sums.minimum, sum), real_max(sums.maximum, sum)};
    return next;
}

static bool keep_sign(partial_sums sums) {
    return sums.minimum > 0.0 || sums.maximum < 0.0;
}

/* Partial sums of a series and of its derivative are taken times the size of the step. */
typedef struct {
    partial_sums value, rate;
} series_sums;

static series_sums sums_of(const tdmf_step *step, const double *series, int order) {
    const double first = series[1] * step->search.power[1];
    const partial_sums start = {series[0], series[0], series[0]};
    partial_sums value = with_term(start, first);
    partial_sums rate = {first, first, first};
    for (int k = 2; k <= order; ++k) {
        const double term = series[k] * step->search.power[k];
        value = with_term(value, term);
        rate = with_term(rate, (double)k * term);
    }
    const series_sums sums = {value, rate};
    return sums;
}

/* The first time after `from`, up to `to`, at which a force turns from rising to falling or back; else
 * infinity. */
static double next_force_extremum(const tdmf_step *step, const double *force, bool rising, double from,
                                  double to) {
    const tdmf_scales *scales = &step->equations->model->scales;
    const partial_sums slope = sums_of(step, force, step->order - 1).rate;
    if (rising ? slope.minimum > 0.0 : slope.maximum < 0.0) {
        return INFINITY;
    }
    factor rate = derivative_of(step, force, step->order - 1, 0.0);
    for (int k = 0; k <= rate.order && !rising; ++k) {
        rate.c[k] = -rate.c[k];
    }
    const root extremum = first_root(rate.c, rate.order, TDMF_BEYOND_DEAD_BAND * scales->force / scales->time,
                                     from / step->size, to / step->size, mask_of(true));
    return extremum.is_root ? extremum.time * step->size : INFINITY;
}

static tdmf_peak largest_peak(const tdmf_step *step, const double *series, double end, bool *rising) {
    tdmf_peak peak = {INFINITY, -INFINITY};
    double from = 0.0;
    for (int i = 0; i < EXTREMUM_LIMIT; ++i) {
        from = next_force_extremum(step, series, *rising, from, end);
        if (!(from <= end)) {
            break;
        }
        const double force = series_at(series, step->order - 1, from);
        if (*rising && force > peak.force) {
            peak.force = force;
            peak.time = from;
        }
        *rising = !*rising;
    }
    return peak;
}

static void write_vertical_force(const tdmf_step *step, double series[SERIES_TERMS]) {
    const ground_series *g = &step->series.ground;
    const tdmf_ground_line *ground = &step->equations->ground;
    const double *against = tdmf_step_ground_case(step).slips ? g->friction_force : g->tangential_push;
    for (int k = 0; k < step->order; ++k) {
        series[k] = ground->cosine * g->normal_force[k] - ground->sine * against[k];
    }
}

/* On level ground both forces are one. */
tdmf_force_peaks tdmf_largest_peaks(const tdmf_step *step, double end, tdmf_mode *mode) {
    tdmf_force_peaks peaks;
    peaks.normal = largest_peak(step, step->series.ground.normal_force, end, &mode->ground_force_rising);
    if (step->equations->ground.sine == 0.0) {
        peaks.vertical = peaks.normal;
        mode->vertical_force_rising = mode->ground_force_rising;
    } else {
        double vertical[SERIES_TERMS];
        write_vertical_force(step, vertical);
        peaks.vertical = largest_peak(step, vertical, end, &mode->vertical_force_rising);
    }
    return peaks;
}

/* Most steps are seen not to by their partial sums, or to by their end. */
bool tdmf_leg_lengthens(const tdmf_step *step, double end) {
    const double *rate = step->series.ground.length_rate;
    const int order = step->order - 1;
    double sum = rate[0], maximum = sum;
    for (int k = 1; k <= order; ++k) {
        sum += rate[k] * step->search.power[k];
        maximum = real_max(maximum, sum);
    }
    if (maximum < 0.0) {
        return false;
    }
    if (series_at(rate, order, end) >= 0.0) {
        return true;
    }
    factor shortening = factor_of(step, rate, order, 0.0);
    for (int k = 0; k <= order; ++k) {
        shortening.c[k] = -shortening.c[k];
    }
    return first_root(shortening.c, order, 0.0, 0.0, end / step->size, mask_of(true)).is_root;
}

/* ---- the hip's power ---------------------------------------------------------------------------------- */

/* The factors of the power that may change their sign in the step. */
typedef struct {
    factor of[2];
    int count;
} changing_factors;

static bool has_no_torque(const tdmf_step *step) {
    const tdmf_hip_law *law = &step->equations->law;
    const bool is_zero =
        law->torque == 0.0 && law->torque_rate == 0.0 && law->gain == 0.0 && law->rate_gain == 0.0;
    return is_zero && step->equations->contact != TDMF_CONTACT_GRAZE;
}

/* A monotone factor changes its sign at most once, and then it shows at the end, a share of the step. */
static void add_factor(changing_factors *changing, const factor *f, double end) {
    partial_sums rates = {f->c[1], f->c[1], f->c[1]};
    for (int k = 2; k <= f->order; ++k) {
        rates = with_term(rates, (double)k * f->c[k]);
    }
    const bool is_monotone = keep_sign(rates);
    if (is_monotone) {
        const double start = fabs(f->c[0]) > f->zero ? f->c[0] : f->c[1];
        if (start * series_at(f->c, f->order, end) > 0.0) {
            return;
        }
    }
    changing->of[changing->count] = *f;
    changing->of[changing->count++].is_monotone = is_monotone;
}

/* The torque follows from what it makes of the momentum. */
static factor torque_in_flight(const tdmf_step *step, double zero) {
    const flight_series *flight = &step->series.flight;
    factor f = derivative_of(step, flight->momentum, step->order, zero);
    for (int k = 0; k <= f.order && step->equations->is_forced; ++k) {
        f.c[k] -= flight->push_moment[k] * step->search.power[k];
    }
    return f;
}

static void add_factors_in_flight(const tdmf_step *step, double zero, double end,
                                  changing_factors *changing) {
    const double *momentum = step->series.flight.momentum;
    const series_sums sums = sums_of(step, momentum, step->order);
    if (!keep_sign(sums.value)) {
        const factor f = factor_of(step, momentum, step->order, zero);
        add_factor(changing, &f, end);
    }
    if (step->equations->is_forced || !keep_sign(sums.rate)) {
        const factor f = torque_in_flight(step, zero / step->equations->model->scales.time);
        add_factor(changing, &f, end);
    }
}

static void add_factors_on_ground(const tdmf_step *step, double zero, double end,
                                  changing_factors *changing) {
    const ground_series *g = &step->series.ground;
    const int torque_order = step->equations->contact == TDMF_CONTACT_GRAZE ? step->order - 1 : 1;
    if (!keep_sign(sums_of(step, g->moment, step->order).value)) {
        const factor f = factor_of(step, g->moment, step->order, zero);
        add_factor(changing, &f, end);
    }
    if (!keep_sign(sums_of(step, g->torque, torque_order).value)) {
        const factor f = factor_of(step, g->torque, torque_order, zero / step->equations->model->scales.time);
        add_factor(changing, &f, end);
    }
}

/* The first time after `from` at which the power changes its sign, or `end`. */
static double next_sign_change(const tdmf_step *step, changing_factors *changing, double from, double end) {
    root first = {INFINITY, 0, INFINITY};
    int next = 0;
    for (int i = 0; i < changing->count; ++i) {
        const factor *f = &changing->of[i];
        const root found =
            first_sign_change(f->c, f->order, f->zero, from / step->size, end / step->size, mask_of(true));
        if (found.time < first.time || (found.time == first.time && found.is_root)) {
            first = found;
            next = i;
        }
    }
    if (first.is_root && changing->of[next].is_monotone) {
        changing->of[next] = changing->of[--changing->count];
    }
    return first.is_root ? real_min(first.time * step->size, end) : end;
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
    const tdmf_scales *scales = &step->equations->model->scales;
    const double zero = TDMF_ZERO_POWER * scales->length * scales->length / scales->time;
    changing_factors changing;
    changing.count = 0;
    if (step->equations->contact == TDMF_CONTACT_FLIGHT) {
        add_factors_in_flight(step, zero, end / step->size, &changing);
    } else {
        add_factors_on_ground(step, zero, end / step->size, &changing);
    }
    if (changing.count == 0) {
        add_span(spans, 0.0, end, total);
        return real_max(0.0, total);
    }
    for (int i = 0; i < EXTREMUM_LIMIT && from < end; ++i) {
        const double to = next_sign_change(step, &changing, from, end);
        const double done_then = to < end ? tdmf_step_work(step, to) : total;
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
