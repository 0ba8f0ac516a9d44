/* One step of the pair, its error and its dense output. */
#include "pair.h"

#include "chart_slope.h"
#include "pair_formulas.h"

#include <math.h>
#include <string.h>

/* Coordinates and slope of one stage. A macro, because the name of a formula cannot be an argument. */
#define EVALUATE(stage, z)                                                                                   \
    do {                                                                                                     \
        pair_stage_##stage(count, step->size, step->start, step->slopes, z);                                 \
        chart_slope(chart, pair_node[stage] * step->size, z, step->slopes[stage]);                           \
    } while (0)

/* Inlined with a constant count, so that loops over coordinates unroll into vector operations. */
static inline void take(const tdmf_chart *chart, tdmf_pair_step *step, int count) {
    double z[CHART_COUNT];
    memcpy(z, step->start, sizeof z);
    EVALUATE(1, z);
    EVALUATE(2, z);
    EVALUATE(3, z);
    EVALUATE(4, z);
    EVALUATE(5, z);
    EVALUATE(6, z);
    EVALUATE(7, z);
    EVALUATE(8, z);
    EVALUATE(9, z);
    EVALUATE(10, z);
    EVALUATE(11, z);
    memcpy(step->end, step->start, sizeof step->end);
    EVALUATE(12, step->end);
    step->has_dense = false;
}

void tdmf_pair_take(const tdmf_chart *chart, tdmf_pair_step *step) {
    if (chart->in_flight) {
        take(chart, step, CHART_FLIGHT_COUNT);
    } else {
        take(chart, step, CHART_COUNT);
    }
}

static inline double error(tdmf_pair_step *step, const double allowed[CHART_COUNT], int count) {
    double norm_5 = 0.0;
    double norm_3 = 0.0;
    for (int i = 0; i < count; ++i) {
        const double error_5 = pair_error_5(step->slopes, i) / allowed[i];
        const double error_3 = pair_error_3(step->slopes, i) / allowed[i];
        norm_5 += error_5 * error_5;
        norm_3 += error_3 * error_3;
    }
    if (norm_5 == 0.0 && norm_3 == 0.0) {
        return 0.0;
    }
    return step->size * norm_5 / sqrt((norm_5 + 0.01 * norm_3) * count);
}

double tdmf_pair_error(const tdmf_chart *chart, tdmf_pair_step *step, const double allowed[CHART_COUNT]) {
    return chart->in_flight ? error(step, allowed, CHART_FLIGHT_COUNT) : error(step, allowed, CHART_COUNT);
}

static inline void make_dense(const tdmf_chart *chart, tdmf_pair_step *step, int count) {
    double z[CHART_COUNT];
    memcpy(z, step->start, sizeof z);
    EVALUATE(13, z);
    EVALUATE(14, z);
    EVALUATE(15, z);
    for (int i = 0; i < count; ++i) {
        const double change = step->end[i] - step->start[i];
        step->dense[0][i] = change;
        step->dense[1][i] = step->size * step->slopes[0][i] - change;
        step->dense[2][i] = 2.0 * change - step->size * (step->slopes[PAIR_STAGES][i] + step->slopes[0][i]);
        step->dense[3][i] = step->size * pair_dense_3(step->slopes, i);
        step->dense[4][i] = step->size * pair_dense_4(step->slopes, i);
        step->dense[5][i] = step->size * pair_dense_5(step->slopes, i);
        step->dense[6][i] = step->size * pair_dense_6(step->slopes, i);
    }
    step->has_dense = true;
}

#undef EVALUATE

static inline void interpolate(const tdmf_pair_step *step, double fraction, int count,
                               double z[CHART_COUNT]) {
    memcpy(z, step->start, sizeof step->start);
    for (int i = 0; i < count; ++i) {
        double value = 0.0;
        for (int term = PAIR_DENSE_TERMS - 1; term >= 0; --term) {
            value = (value + step->dense[term][i]) * (term % 2 == 0 ? fraction : 1.0 - fraction);
        }
        z[i] += value;
    }
}

void tdmf_pair_within(const tdmf_chart *chart, tdmf_pair_step *step, double fraction, double z[CHART_COUNT]) {
    if (chart->in_flight) {
        if (!step->has_dense) {
            make_dense(chart, step, CHART_FLIGHT_COUNT);
        }
        interpolate(step, fraction, CHART_FLIGHT_COUNT, z);
    } else {
        if (!step->has_dense) {
            make_dense(chart, step, CHART_COUNT);
        }
        interpolate(step, fraction, CHART_COUNT, z);
    }
}
