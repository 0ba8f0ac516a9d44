/* Rates, guards, outputs and their variations at an instant. */
#include "run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

double *allocate_memory(fmu *fmu) {
    const size_t whole = tdmf_run_memory_size(unit_model, 1),
                 part = unit_part == NULL ? 0 : tdmf_run_memory_size(unit_part->model, 1),
                 of_run = whole > part ? whole : part;
    fmu->memory = malloc((of_run + tdmf_size_of_instant(unit_model)) * sizeof *fmu->memory);
    fmu->instant = fmu->memory == NULL ? NULL : fmu->memory + of_run;
    return fmu->memory;
}

const tdmf_mode_kind *mode_of(const fmu *fmu) {
    return &unit_model->modes[fmu->motion.mode];
}

const tdmf_mode_kind *shown_mode_of(const fmu *fmu) {
    return &unit_model->modes[fmu->motion.shown];
}

/* Numbers of a run are never written through a constant one. */
double *parameters_of(const fmu *fmu) {
    return (double *)(size_t)fmu->motion.numbers;
}

double *states_of(const fmu *fmu) {
    return parameters_of(fmu) + UNIT_PARAMETER_COUNT;
}

tdmf_page_instant instant_of(const fmu *fmu) {
    return tdmf_instant_at(unit_model, fmu->motion.mode, parameters_of(fmu), states_of(fmu), fmu->instant);
}

/* NaN is out of every range. */
const char *number_out_of_range(const double numbers[]) {
    for (int i = 0; i < UNIT_NUMBER_COUNT; ++i) {
        if (!(numbers[i] >= unit_numbers[i].least && numbers[i] <= unit_numbers[i].most)) {
            return unit_numbers[i].name;
        }
    }
    return NULL;
}

/* ---- coordinates --------------------------------------------------------------------------------------- */

void show_to_world(fmu *fmu) {
    double room[UNIT_STATE_COUNT + 1];
    tdmf_show_to_world(unit_model, fmu->motion.mode, parameters_of(fmu), states_of(fmu), room);
}

void take_from_world(fmu *fmu) {
    double room[UNIT_STATE_COUNT + 1];
    tdmf_take_from_world(unit_model, fmu->motion.shown, parameters_of(fmu), states_of(fmu), room);
}

/* ---- guards -------------------------------------------------------------------------------------------- */

static double indicator(const tdmf_page_instant *at, const guard_state *guards, const unit_guard *row) {
    const tdmf_mode_kind *mode = at->mode;
    double least = INFINITY;
    for (int i = 0; i < mode->guard_count; ++i) {
        if ((row->events >> mode->guards[i].event & 1) != 0) {
            least = fmin(least, guards[i].value);
        }
    }
    for (int i = 0; row->events == 0 && i < mode->usual_count; ++i) {
        if (mode->watches[i].part == TDMF_LARGEST && mode->watches[i].into == row->into) {
            double value, rate;
            tdmf_page_observed(at, i, &value, &rate);
            return rate / at->scales[row->into];
        }
    }
    return isinf(least) ? 1.0 : least;
}

static void indicators_at(const fmu *fmu, const tdmf_page_instant *at, double indicators[]) {
    guard_state guards[TDMF_GUARD_LIMIT];
    tdmf_view_guards(at, fmu->watch, guards);
    for (int i = 0; i < UNIT_GUARD_COUNT; ++i) {
        const double value = indicator(at, guards, &unit_guards[i]);
        indicators[i] = isnan(value) ? 1.0 : value;
    }
}

void fmu_event_indicators(const fmu *fmu, double indicators[]) {
    const tdmf_page_instant at = instant_of(fmu);
    indicators_at(fmu, &at, indicators);
}

/* ---- rates --------------------------------------------------------------------------------------------- */

/* Picks the continuous states of the unit from values by state. */
static void pick_states(const double *values, double picked[]) {
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        picked[i] = values[unit_states[i].index];
    }
}

static void derivatives_at(const tdmf_page_instant *at, double derivatives[]) {
    double rates[UNIT_STATE_COUNT + 1];
    tdmf_page_world_rates(at, rates);
    pick_states(rates, derivatives);
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        derivatives[i] = fmu_within_largest(derivatives[i]);
    }
}

void fmu_derivatives(const fmu *fmu, double derivatives[]) {
    const tdmf_page_instant at = instant_of(fmu);
    derivatives_at(&at, derivatives);
}

void fmu_states(const fmu *fmu, const fmu_view *view, double states[]) {
    pick_states(states_of(fmu), states);
    for (int i = 0; view != NULL && i < UNIT_CONTINUOUS_COUNT; ++i) {
        states[i] = unit_states[i].has_start ? states[i] : view->states[i];
    }
}

void fmu_try_states(fmu *fmu, const double states[]) {
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        states_of(fmu)[unit_states[i].index] = fmu_within_largest(states[i]);
    }
    take_from_world(fmu);
}

void fmu_nominals(const fmu *fmu, double nominals[]) {
    const tdmf_page_instant at = instant_of(fmu);
    pick_states(at.scales, nominals);
    for (int i = 0; i < UNIT_NOMINAL_COUNT; ++i) {
        nominals[unit_nominals[i].state] = unit_nominals[i].size(at.p, at.x);
    }
}

/* ---- values of a run ----------------------------------------------------------------------------------- */

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

/* A time of the page as the importer's clock shows it; 0 for one before the run. */
static double shown_time(const fmu *fmu, double time) {
    return time < 0.0 ? 0.0 : time == fmu->motion.time ? fmu->time : fmu->epoch + time;
}

void fmu_evaluate(const fmu *fmu, fmu_view *view) {
    const tdmf_page_instant at = instant_of(fmu);
    memcpy(view->numbers, fmu->motion.numbers, sizeof view->numbers);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        if (unit_holds_time[i]) {
            view->numbers[UNIT_PARAMETER_COUNT + i] = shown_time(fmu, states_of(fmu)[i]);
        }
    }
    fmu_states(fmu, NULL, view->states);
    derivatives_at(&at, view->derivatives);
    indicators_at(fmu, &at, view->guards);
    shown_mode_of(fmu)->outputs(parameters_of(fmu), states_of(fmu), view->outputs);
    for (int i = 0; i < UNIT_OUTPUT_COUNT; ++i) {
        view->outputs[i] = fmu_within_largest(view->outputs[i]); /* trial states may give any value */
    }
    for (int i = 0; i < WORK_COUNT; ++i) {
        view->work[i] = (double)fmu->work[i];
    }
    for (int i = 0; i < UNIT_WORD_COUNT; ++i) {
        const double *of = unit_words[i].is_output ? view->outputs : states_of(fmu);
        write_word(of[unit_words[i].index], unit_words[i].alphabet, view->words[i]);
    }
}

/* ---- variations ---------------------------------------------------------------------------------------- */

void vary_at(const fmu *fmu, const double *dp, const double *dx, fmu_view *variation) {
    const tdmf_page_instant at = instant_of(fmu);
    double d_rates[UNIT_STATE_COUNT + 1];
    memset(variation, 0, sizeof *variation);
    memcpy(variation->numbers, dp, UNIT_PARAMETER_COUNT * sizeof *dp);
    memcpy(variation->numbers + UNIT_PARAMETER_COUNT, dx, UNIT_STATE_COUNT * sizeof *dx);
    tdmf_vary_page_rates(&at, dp, dx, d_rates);
    pick_states(d_rates, variation->derivatives);
    shown_mode_of(fmu)->vary_outputs(at.p, at.x, dp, dx, variation->outputs);
}

void fmu_flow(const fmu *fmu, struct fmu *seed) {
    const tdmf_page_instant at = instant_of(fmu);
    memset(seed, 0, sizeof *seed);
    tdmf_page_world_rates(&at, states_of(seed));
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        double *rate = &states_of(seed)[unit_states[i].index];
        *rate = fmu_within_largest(*rate);
    }
}
