/* Expansion, step size and evaluation.
 *
 * A step is as long as the last two coefficients allow: were the series cut there, what is left out would be
 * as small as the tolerance, and no longer than coefficients can be trusted to fall from there on. On the
 * ground that is asked of the forces themselves, because events are located on them. */
#include "step.h"

#include "coefficients.h"

#include <float.h>

int tdmf_step_order(double tolerance) {
    const int order = (int)ceil(-2.0 * log10(tolerance));
    return order < 8 ? 8 : order > SERIES_ORDER_LIMIT ? SERIES_ORDER_LIMIT : order;
}

ground_case tdmf_step_ground_case(const tdmf_step *step) {
    const tdmf_chart *chart = step->chart;
    const bool grazes = chart->contact == TDMF_CONTACT_GRAZE;
    const ground_case is = {
        .slips = chart->contact != TDMF_CONTACT_STICK && !grazes,
        .grazes = grazes,
        .turns = grazes || chart->law.torque != 0.0 || chart->law.torque_rate != 0.0,
    };
    return is;
}

/* These two expand, and return how far the series may be trusted, whatever their coefficients. */
static double expand_leg_in_flight(tdmf_step *step) {
    const tdmf_coordinates *at = &step->chart->start;
    const flight_coefficients coefficients = tdmf_flight_coefficients(step->chart);
    const double start[4] = {at->length, at->angle, at->length_rate, at->angle_rate};
    expand_flight(&coefficients, start, step->order, &step->series.flight);
    return longest_flight_step(&coefficients, at->length, step->order);
}

static double expand_standing_leg(tdmf_step *step) {
    const tdmf_coordinates *at = &step->chart->start;
    const ground_coefficients coefficients = tdmf_ground_coefficients(step->chart);
    const double start[GROUND_START_COUNT] = {at->x, at->y, at->vx, at->vy, at->foot_vx};
    expand_ground_by_case(&coefficients, start, step->order, tdmf_step_ground_case(step),
                          &step->series.ground);
    return longest_ground_step(&coefficients, step->chart->contact != TDMF_CONTACT_STICK, step->order);
}

/* x^(1/n) within a few per cent, and the same on every platform. */
static double rough_root(double x, int n) {
    int exponent;
    const double mantissa = frexp(fmin(fmax(x, DBL_MIN), DBL_MAX), &exponent);
    const double logarithm = ((double)exponent + 2.0 * (mantissa - 1.0)) / n;
    const double whole = floor(logarithm);
    return ldexp(1.0 + 0.67 * (logarithm - whole), (int)whole);
}

/* The last two coefficients, summed over the coordinates in their units, so that one that is not a number
 * shows.
 */
typedef struct {
    double last, last_but_one;
    int order;
} remainder_of_series;

static void note_remainder(remainder_of_series *remainder, const double *c, double unit) {
    const double allowed = 1.0 / fmax(unit, fabs(c[0]));
    remainder->last += fabs(c[remainder->order]) * allowed;
    remainder->last_but_one += fabs(c[remainder->order - 1]) * allowed;
}

static double trusted_size(const remainder_of_series *remainder, double longest, double tolerance) {
    double size = longest;
    if (!isfinite(remainder->last + remainder->last_but_one)) {
        return NAN;
    }
    if (remainder->last > 0.0) {
        size = fmin(size, rough_root(tolerance / remainder->last, remainder->order));
    }
    if (remainder->last_but_one > 0.0) {
        size = fmin(size, rough_root(tolerance / remainder->last_but_one, remainder->order - 1));
    }
    return size;
}

/* Where the length's coefficients add up to less than itself it has no zero for any complex time in reach:
 * what is divided by it has no pole there, which coefficients might not show, be it ever so weak. */
static double size_without_pole(const double *length, int order, double size) {
    const double most = SERIES_MOST_CHANGE * length[0];
    double change = 0.0;
    for (int k = order; k > 0; --k) {
        change = (change + fabs(length[k])) * size;
    }
    return change > most ? size * most / change : size;
}

static double power_of(double x, int n) {
    double power = 1.0;
    for (; n > 0; n >>= 1, x *= x) {
        power *= n & 1 ? x : 1.0;
    }
    return power;
}

/* Where a leg does not turn, its motion is a sum of exponentials, whose coefficients fall sooner than those
 * of their square, the damper's power. */
static double size_for_loss(const tdmf_step *step, const double *speed_square, double size) {
    const tdmf_model *model = step->chart->model;
    const double unit = model->scales.energy / (model->parameters.leg.damping * model->scales.time);
    remainder_of_series remainder = {0.0, 0.0, step->order - 1};
    note_remainder(&remainder, speed_square, unit);
    return remainder.last * power_of(size, remainder.order) > step->tolerance
               ? trusted_size(&remainder, size, step->tolerance)
               : size;
}

void tdmf_step_expand(tdmf_step *step, const tdmf_chart *chart, int order, double tolerance) {
    const tdmf_scales *scales = &chart->model->scales;
    const bool flies = chart->contact == TDMF_CONTACT_FLIGHT;
    remainder_of_series remainder = {0.0, 0.0, 0};
    step->chart = chart;
    step->order = order;
    step->tolerance = tolerance;
    remainder.order = order - 1;
    if (flies) {
        step->longest = expand_leg_in_flight(step);
        note_remainder(&remainder, step->series.flight.length_rate, scales->speed);
        note_remainder(&remainder, step->series.flight.angle_rate, 1.0 / scales->time);
    } else {
        step->longest = expand_standing_leg(step);
        note_remainder(&remainder, step->series.ground.normal_force, scales->force);
        note_remainder(&remainder, step->series.ground.leg_force_x, scales->force);
        note_remainder(&remainder, step->series.ground.foot_vx, scales->speed);
    }
    const double *length = flies ? step->series.flight.length : step->series.ground.length;
    const double *speed_square = flies ? step->series.flight.speed_square : step->series.ground.speed_square;
    const double size = trusted_size(&remainder, step->longest, tolerance);
    step->size = size_without_pole(length, order - 1, size_for_loss(step, speed_square, size));
}

double tdmf_step_trusts(const tdmf_step *step, const double *c, double unit) {
    remainder_of_series remainder = {0.0, 0.0, step->order};
    note_remainder(&remainder, c, unit);
    return trusted_size(&remainder, INFINITY, step->tolerance);
}

/* The largest term but the last two. */
static double largest_term(const double *sizes, int order, double t) {
    double power = 1.0;
    double largest = 0.0;
    for (int k = 0; k < order - 1; ++k) {
        largest = fmax(largest, sizes[k] * power);
        power *= t;
    }
    return largest;
}

/* In a shorter step the largest term may be smaller, too, so the size is approached from above. */
double tdmf_step_trusts_terms(const tdmf_step *step, const double sizes[SERIES_TERMS]) {
    enum { ITERATION_LIMIT = 40 };
    static const double settled = 0.95;
    const int order = step->order;
    const remainder_of_series remainder = {sizes[order], sizes[order - 1], order};
    double size = step->size;
    for (int i = 0; i < ITERATION_LIMIT; ++i) {
        const double largest = largest_term(sizes, order, size);
        if (!isfinite(largest + remainder.last + remainder.last_but_one)) {
            return INFINITY;
        }
        const double shorter = trusted_size(&remainder, size, step->tolerance * largest);
        if (shorter >= settled * size) {
            return shorter;
        }
        size = shorter;
    }
    return size;
}

static double flight_work(const tdmf_step *step, double t) {
    const tdmf_chart *chart = step->chart;
    const flight_series *f = &step->series.flight;
    const int order = step->order;
    const double turned = series_integral(f->angle_rate, order - 1, t);
    double work = chart->law.gain * turned * (chart->law.target - chart->start.angle - 0.5 * turned) -
                  chart->law.rate_gain * series_integral(f->rate_square, order - 1, t) +
                  chart->law.torque * turned;
    if (chart->law.torque_rate != 0.0) {
        /* By parts: the integral of t w. */
        const double angle_integral = series_integral(f->angle, order, t) - t * chart->start.angle;
        work += chart->law.torque_rate * (t * turned - angle_integral);
    }
    return work;
}

double tdmf_step_work(const tdmf_step *step, double elapsed) {
    return step->chart->contact == TDMF_CONTACT_FLIGHT
               ? flight_work(step, elapsed)
               : series_integral(step->series.ground.power, step->order - 1, elapsed);
}

static void flight_at(const tdmf_step *step, double t, tdmf_coordinates *at) {
    const flight_series *f = &step->series.flight;
    const double damping = step->chart->model->parameters.leg.damping;
    at->length = series_at(f->length, step->order, t);
    at->length_rate = series_at(f->length_rate, step->order, t);
    at->angle = series_at(f->angle, step->order, t);
    at->angle_rate = series_at(f->momentum, step->order, t) / (at->length * at->length);
    at->damper_loss += damping * series_integral(f->speed_square, step->order - 1, t);
}

static void ground_at(const tdmf_step *step, double t, tdmf_coordinates *at) {
    const ground_series *g = &step->series.ground;
    const double damping = step->chart->model->parameters.leg.damping;
    at->x = series_at(g->x, step->order, t);
    at->y = series_at(g->y, step->order, t);
    at->foot_vx = series_at(g->foot_vx, step->order, t);
    at->vx = series_at(g->vx, step->order, t) + at->foot_vx;
    at->vy = series_at(g->vy, step->order, t);
    at->foot_x += series_integral(g->foot_vx, step->order, t);
    at->damper_loss += damping * series_integral(g->speed_square, step->order - 1, t);
    at->friction_loss += series_integral(g->friction_power, step->order - 1, t);
}

tdmf_coordinates tdmf_step_at(const tdmf_step *step, double elapsed) {
    tdmf_coordinates at = step->chart->start;
    if (step->chart->contact == TDMF_CONTACT_FLIGHT) {
        flight_at(step, elapsed, &at);
    } else {
        ground_at(step, elapsed, &at);
    }
    at.work += tdmf_step_work(step, elapsed);
    return at;
}
