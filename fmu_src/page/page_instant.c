/* Rates, guards, outputs and their variations at an instant. */
#include "page_instant.h"

#include "page_margins.h"
#include "run_state.h"

#include <math.h>
#include <string.h>

enum { FEW_TERMS = 4, FEW_ORDER = 2 }; /* values and rates need no more */

static size_t series_size(void) {
    return (size_t)unit_model->series_count * TERMS;
}

size_t instant_size(void) {
    const size_t states = (size_t)unit_model->state_count, parameters = (size_t)unit_model->parameter_count;
    return tdmf_run_memory_size(unit_model, 1) + 2 * series_size() + 2 * (size_t)unit_model->constant_count +
           3 * states + (size_t)unit_model->event_count + parameters + 1;
}

const tdmf_mode_kind *mode_of(const fmu *fmu) {
    return &unit_model->modes[fmu->motion.mode];
}

/* Numbers of a run are never written through a constant one. */
double *parameters_of(const fmu *fmu) {
    return (double *)(size_t)fmu->motion.numbers;
}

double *states_of(const fmu *fmu) {
    return parameters_of(fmu) + UNIT_PARAMETER_COUNT;
}

instant instant_of(const fmu *fmu) {
    const tdmf_motion_kind *motion = mode_of(fmu)->motion;
    instant at;
    double *free_memory = fmu->memory + tdmf_run_memory_size(unit_model, 1);
    at.s = (double(*)[TERMS])(void *)free_memory;
    at.t = at.s + unit_model->series_count;
    at.c = (double *)(at.t + unit_model->series_count);
    at.d = at.c + unit_model->constant_count;
    at.scales = at.d + unit_model->constant_count;
    at.event_scales = at.scales + unit_model->state_count;
    at.x = at.event_scales + unit_model->event_count;
    at.dx = at.x + unit_model->state_count;
    at.dp = at.dx + unit_model->state_count;
    mode_of(fmu)->open(parameters_of(fmu), states_of(fmu), at.c);
    for (int i = 0; i < unit_model->series_count; ++i) {
        memset(at.s[i], 0, FEW_TERMS * sizeof(double));
    }
    for (int i = 0; i < motion->moving_count; ++i) {
        at.s[i][0] = states_of(fmu)[motion->moving[i]];
    }
    motion->expand(at.c, FEW_ORDER, at.s[0]);
    return at;
}

/* ---- coordinates --------------------------------------------------------------------------------------- */

static void map_states(fmu *fmu, tdmf_change *map) {
    double after[UNIT_STATE_COUNT + 1];
    if (map != NULL) {
        memcpy(after, states_of(fmu), UNIT_STATE_COUNT * sizeof *after);
        map(parameters_of(fmu), states_of(fmu), after);
        memcpy(states_of(fmu), after, UNIT_STATE_COUNT * sizeof *after);
    }
}

void show_to_world(fmu *fmu) {
    map_states(fmu, mode_of(fmu)->to_world);
}

void take_from_world(fmu *fmu) {
    map_states(fmu, mode_of(fmu)->from_world);
}

/* ---- guards -------------------------------------------------------------------------------------------- */

static void polynomial_at(const fmu *fmu, const instant *at, int number, double *value, double *rate) {
    double g[TERMS] = {0.0};
    mode_of(fmu)->motion->polynomials[number](at->c, at->s[0], FEW_ORDER, g);
    *value = g[0];
    *rate = g[1];
}

void observed_at(const fmu *fmu, const instant *at, int watch, double *value, double *rate) {
    polynomial_at(fmu, at, mode_of(fmu)->guard_count + watch, value, rate);
}

void guards_at(const fmu *fmu, const instant *at, guard_state guards[TDMF_GUARD_LIMIT]) {
    const tdmf_mode_kind *mode = mode_of(fmu);
    unit_model->scales(parameters_of(fmu), at->scales, at->event_scales);
    for (int i = 0; i < mode->guard_count; ++i) {
        const tdmf_guard_kind *kind = &mode->guards[i];
        const watch_state seen = (watch_state)fmu->watch[kind->event];
        const bool must_rise = kind->is_crossing && seen != WATCH_ABOVE;
        double value, rate;
        polynomial_at(fmu, at, i, &value, &rate);
        value = value / at->event_scales[kind->event] + (must_rise ? -zero_margin : zero_margin);
        const bool rises = seen == WATCH_RISING && value <= 0.0 && rate > 0.0;
        guards[i].is_watched =
            kind->is_watched == NULL || kind->is_watched(parameters_of(fmu), states_of(fmu)) != 0.0;
        guards[i].rises = rises;
        guards[i].value = rises || !guards[i].is_watched ? 1.0 : value;
        guards[i].is_due = guards[i].value <= 0.0 && !must_rise;
    }
}

static double indicator(const fmu *fmu, const instant *at, const guard_state *guards, const unit_guard *row) {
    const tdmf_mode_kind *mode = mode_of(fmu);
    double least = INFINITY;
    for (int i = 0; i < mode->guard_count; ++i) {
        if ((row->events >> mode->guards[i].event & 1) != 0) {
            least = fmin(least, guards[i].value);
        }
    }
    for (int i = 0; row->events == 0 && i < mode->usual_count; ++i) {
        if (mode->watches[i].part == TDMF_LARGEST && mode->watches[i].into == row->into) {
            double value, rate;
            observed_at(fmu, at, i, &value, &rate);
            return rate / at->scales[row->into];
        }
    }
    return isinf(least) ? 1.0 : least;
}

static void indicators_at(const fmu *fmu, const instant *at, double indicators[]) {
    guard_state guards[TDMF_GUARD_LIMIT];
    guards_at(fmu, at, guards);
    for (int i = 0; i < FMU_GUARD_COUNT; ++i) {
        const double value = indicator(fmu, at, guards, &unit_guards[i]);
        indicators[i] = isnan(value) ? 1.0 : value;
    }
}

void fmu_event_indicators(const fmu *fmu, double indicators[]) {
    const instant at = instant_of(fmu);
    indicators_at(fmu, &at, indicators);
}

/* ---- rates --------------------------------------------------------------------------------------------- */

void rates_at(const fmu *fmu, const instant *at, double *rates) {
    const tdmf_mode_kind *mode = mode_of(fmu);
    memset(rates, 0, UNIT_STATE_COUNT * sizeof *rates);
    for (int i = 0; i < mode->motion->moving_count; ++i) {
        rates[mode->motion->moving[i]] = at->s[i][1];
    }
    for (int i = 0; i < mode->usual_count; ++i) {
        double value, rate;
        if (mode->watches[i].part == TDMF_POSITIVE_INTEGRAL) {
            observed_at(fmu, at, i, &value, &rate);
            rates[mode->watches[i].into] += fmax(value, 0.0);
        }
    }
}

/* Picks the continuous states of the unit from values by state. The world's may have values of their own. */
static void pick_states(const double *values, const double *of_world, double picked[]) {
    for (int i = 0; i < FMU_STATE_COUNT; ++i) {
        const bool is_mapped = of_world != NULL && unit_states[i].in_world;
        picked[i] = (is_mapped ? of_world : values)[unit_states[i].index];
    }
}

static void derivatives_at(const fmu *fmu, const instant *at, double derivatives[]) {
    const tdmf_mode_kind *mode = mode_of(fmu);
    double rates[UNIT_STATE_COUNT + 1];
    rates_at(fmu, at, rates);
    if (mode->world_rates != NULL) {
        memcpy(at->x, states_of(fmu), UNIT_STATE_COUNT * sizeof *at->x);
        mode->world_rates(parameters_of(fmu), states_of(fmu), at->x);
    }
    pick_states(rates, mode->world_rates != NULL ? at->x : NULL, derivatives);
    for (int i = 0; i < FMU_STATE_COUNT; ++i) {
        derivatives[i] = fmu_within_largest(derivatives[i]);
    }
}

void fmu_derivatives(const fmu *fmu, double derivatives[]) {
    const instant at = instant_of(fmu);
    derivatives_at(fmu, &at, derivatives);
}

void fmu_states(const fmu *fmu, const fmu_view *view, double states[]) {
    pick_states(states_of(fmu), NULL, states);
    for (int i = 0; view != NULL && i < FMU_STATE_COUNT; ++i) {
        states[i] = unit_states[i].has_start ? states[i] : view->states[i];
    }
}

void fmu_try_states(fmu *fmu, const double states[]) {
    for (int i = 0; i < FMU_STATE_COUNT; ++i) {
        states_of(fmu)[unit_states[i].index] = fmu_within_largest(states[i]);
    }
    take_from_world(fmu);
}

void fmu_nominals(const fmu *fmu, double nominals[]) {
    const instant at = instant_of(fmu);
    unit_model->scales(parameters_of(fmu), at.scales, at.event_scales);
    pick_states(at.scales, NULL, nominals);
}

/* ---- all that follows ---------------------------------------------------------------------------------- */

/* Writes at most WORD_CAPACITY characters. A negative number stands for the beginning of a longer word. */
static void write_word(double number, const char *alphabet, char *text) {
    const double base = (double)strlen(alphabet);
    char letters[WORD_CAPACITY];
    int place = WORD_CAPACITY - 1;
    letters[place] = '\0';
    if (number < 0.0) {
        letters[--place] = '~';
        number = -number;
    }
    for (; number >= 1.0 && place > 0; number = floor(number / base)) {
        letters[--place] = alphabet[(int)fmod(number, base)];
    }
    memcpy(text, letters + place, (size_t)(WORD_CAPACITY - place));
}

void fmu_evaluate(const fmu *fmu, fmu_view *view) {
    const instant at = instant_of(fmu);
    memcpy(view->numbers, fmu->motion.numbers, sizeof view->numbers);
    fmu_states(fmu, NULL, view->states);
    derivatives_at(fmu, &at, view->derivatives);
    indicators_at(fmu, &at, view->guards);
    mode_of(fmu)->outputs(parameters_of(fmu), states_of(fmu), view->outputs);
    view->work[WORK_STEPS] = (double)fmu->steps;
    view->work[WORK_EVALUATIONS] = (double)fmu->evaluations;
    view->work[WORK_LAYER_STEPS] = 0.0;
    for (int i = 0; i < UNIT_WORD_COUNT; ++i) {
        const double *of = unit_words[i].is_output ? view->outputs : states_of(fmu);
        write_word(of[unit_words[i].index], unit_words[i].alphabet, view->words[i]);
    }
}

/* ---- variations ---------------------------------------------------------------------------------------- */

static void vary_integrals(const fmu *fmu, const instant *at, double *d_rates) {
    const tdmf_mode_kind *mode = mode_of(fmu);
    for (int i = 0; i < mode->usual_count; ++i) {
        double value, rate, dg[TERMS] = {0.0};
        if (mode->watches[i].part == TDMF_POSITIVE_INTEGRAL) {
            observed_at(fmu, at, i, &value, &rate);
            mode->motion->vary_observed[i](at->c, at->s[0], at->d, at->t[0], FEW_ORDER, dg);
            d_rates[mode->watches[i].into] += value > 0.0 ? dg[0] : 0.0;
        }
    }
}

void vary_at(const fmu *fmu, const double *dp, const double *dx, fmu_view *variation) {
    const tdmf_mode_kind *mode = mode_of(fmu);
    const double *p = parameters_of(fmu), *x = states_of(fmu);
    const instant at = instant_of(fmu);
    double d_rates[UNIT_STATE_COUNT + 1] = {0.0}, of_world[UNIT_STATE_COUNT + 1];
    memset(variation, 0, sizeof *variation);
    memcpy(variation->numbers, dp, UNIT_PARAMETER_COUNT * sizeof *dp);
    memcpy(variation->numbers + UNIT_PARAMETER_COUNT, dx, UNIT_STATE_COUNT * sizeof *dx);
    mode->vary_open(p, x, dp, dx, at.d);
    for (int i = 0; i < unit_model->series_count; ++i) {
        memset(at.t[i], 0, FEW_TERMS * sizeof(double));
    }
    for (int i = 0; i < mode->motion->moving_count; ++i) {
        at.t[i][0] = dx[mode->motion->moving[i]];
    }
    mode->motion->vary(at.c, at.s[0], at.d, FEW_ORDER, at.t[0]);
    for (int i = 0; i < mode->motion->moving_count; ++i) {
        d_rates[mode->motion->moving[i]] = at.t[i][1];
    }
    vary_integrals(fmu, &at, d_rates);
    if (mode->vary_world_rates != NULL) {
        memcpy(of_world, dx, UNIT_STATE_COUNT * sizeof *dx);
        mode->vary_world_rates(p, x, dp, dx, of_world);
    }
    pick_states(d_rates, mode->vary_world_rates != NULL ? of_world : NULL, variation->derivatives);
    mode->vary_outputs(p, x, dp, dx, variation->outputs);
}

void fmu_differentiate(const fmu *fmu, const struct fmu *seed, fmu_view *variation) {
    const tdmf_mode_kind *mode = mode_of(fmu);
    const double *dp = parameters_of(seed);
    double dx[UNIT_STATE_COUNT + 1];
    memcpy(dx, states_of(seed), UNIT_STATE_COUNT * sizeof *dx);
    if (mode->vary_from_world != NULL) {
        mode->vary_from_world(parameters_of(fmu), states_of(fmu), dp, states_of(seed), dx);
    }
    vary_at(fmu, dp, dx, variation);
}

void fmu_flow(const fmu *fmu, struct fmu *seed) {
    double derivatives[FMU_STATE_COUNT + 1];
    memset(seed, 0, sizeof *seed);
    const instant at = instant_of(fmu);
    rates_at(fmu, &at, states_of(seed));
    derivatives_at(fmu, &at, derivatives);
    for (int i = 0; i < FMU_STATE_COUNT; ++i) {
        states_of(seed)[unit_states[i].index] = derivatives[i];
    }
}
