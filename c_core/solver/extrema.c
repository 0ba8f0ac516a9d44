/* Finds extrema that are no events. */
#include "extrema.h"

#include "first_root.h"
#include "margins.h"
#include "series_sums.h"

/* As many as a series can have. */
enum { EXTREMUM_LIMIT = SERIES_ORDER_LIMIT };

/* A factor is a polynomial in the step's share. */
typedef struct {
    double c[SERIES_TERMS];
    int order;
} factor;

static factor factor_of(const tdmf_step *step, const double *series, int order) {
    factor f;
    f.order = order;
    for (int k = 0; k <= order; ++k) {
        f.c[k] = series[k] * step->search.power[k];
    }
    return f;
}

static factor derivative_of(const tdmf_step *step, const double *series, int order) {
    factor f;
    f.order = order - 1;
    for (int k = 0; k < order; ++k) {
        f.c[k] = (double)(k + 1) * series[k + 1] * step->search.power[k];
    }
    return f;
}

/* The minimum of the partial sums of a series' derivative, times a sign and the size of the step; see
 * event_search.h. */
static double min_rate(const tdmf_step *step, const double *series, int order, double sign) {
    double sum = sign * series[1] * step->search.power[1], minimum = sum;
    for (int k = 2; k <= order; ++k) {
        sum += sign * first_derivative[k] * (series[k] * step->search.power[k]);
        minimum = real_min(minimum, sum);
    }
    return minimum;
}

/* The first time after `from`, up to `to`, at which a force turns from rising to falling or back; else
 * infinity. */
static double next_force_extremum(const tdmf_step *step, const double *force, bool rising, double from,
                                  double to) {
    const tdmf_scales *scales = &step->equations->model->scales;
    if (min_rate(step, force, step->order - 1, rising ? 1.0 : -1.0) > 0.0) {
        return INFINITY;
    }
    factor rate = derivative_of(step, force, step->order - 1);
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
    factor shortening = factor_of(step, rate, order);
    for (int k = 0; k <= order; ++k) {
        shortening.c[k] = -shortening.c[k];
    }
    return first_root(shortening.c, order, 0.0, 0.0, end / step->size, mask_of(true)).is_root;
}
