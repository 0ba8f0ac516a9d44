/* Values of a run at an instant: coordinates, rates, guards and outputs. */
#include "run.h"

#include <stdlib.h>
#include <string.h>

double *allocate_memory(instance *fmu) {
    const size_t whole = tdmf_run_memory_size(unit_model, 1),
                 part = unit_part == NULL ? 0 : tdmf_run_memory_size(unit_part->model, 1),
                 of_run = whole > part ? whole : part;
    fmu->memory = malloc((of_run + tdmf_size_of_instant(unit_model)) * sizeof *fmu->memory);
    fmu->instant = fmu->memory == NULL ? NULL : fmu->memory + of_run;
    return fmu->memory;
}

tdmf_page_instant instant_of(const instance *fmu) {
    return tdmf_instant_at(unit_model, fmu->run.motion.mode, parameters_of(fmu), states_of(fmu),
                           fmu->instant);
}

const char *number_out_of_range(const double numbers[]) {
    for (int i = 0; i < UNIT_NUMBER_COUNT; ++i) {
        if (!(numbers[i] >= unit_numbers[i].least && numbers[i] <= unit_numbers[i].most)) {
            return unit_numbers[i].name;
        }
    }
    return NULL;
}

void show_to_world(instance *fmu) {
    double room[UNIT_STATE_COUNT + 1];
    tdmf_show_to_world(unit_model, fmu->run.motion.mode, parameters_of(fmu), states_of(fmu), room);
}

void take_from_world(instance *fmu) {
    double room[UNIT_STATE_COUNT + 1];
    tdmf_take_from_world(unit_model, fmu->run.motion.shown, parameters_of(fmu), states_of(fmu), room);
}

/* ---- rates and guards ---------------------------------------------------------------------------------- */

/* Picks the continuous states of the unit from values by state. */
static void pick_states(const double *values, double picked[]) {
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        picked[i] = values[unit_states[i].index];
    }
}

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

static void indicators_at(const instance *fmu, const tdmf_page_instant *at, double indicators[]) {
    guard_state guards[TDMF_GUARD_LIMIT];
    tdmf_view_guards(at, fmu->run.watch, guards);
    for (int i = 0; i < UNIT_GUARD_COUNT; ++i) {
        const double value = indicator(at, guards, &unit_guards[i]);
        indicators[i] = isnan(value) ? 1.0 : value;
    }
}

/* Derivatives are limited as trial states are: an importer's solver then finds that its step was too long. */
static void derivatives_at(const instance *fmu, const tdmf_page_instant *at, double derivatives[]) {
    double rates[UNIT_STATE_COUNT + 1];
    tdmf_page_world_rates(at, rates);
    pick_states(rates, derivatives);
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        derivatives[i] = within_largest(derivatives[i]);
    }
}

/* ---- the view ------------------------------------------------------------------------------------------ */

/* A time of the page as the importer's clock shows it; 0 for one before the run. */
static double shown_time(const unit_run *run, double time) {
    return time < 0.0 ? 0.0 : time == run->motion.time ? run->time : run->epoch + time;
}

void evaluate(instance *fmu) {
    const tdmf_page_instant at = instant_of(fmu);
    unit_view *view = &fmu->view;
    memcpy(view->numbers, fmu->run.motion.numbers, sizeof view->numbers);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        if (unit_holds_time[i]) {
            view->numbers[UNIT_PARAMETER_COUNT + i] = shown_time(&fmu->run, states_of(fmu)[i]);
        }
    }
    derivatives_at(fmu, &at, view->derivatives);
    indicators_at(fmu, &at, view->guards);
    shown_mode_of(fmu)->outputs(parameters_of(fmu), states_of(fmu), view->outputs);
    for (int i = 0; i < UNIT_OUTPUT_COUNT; ++i) {
        view->outputs[i] = within_largest(view->outputs[i]); /* trial states may give any value */
    }
}

const instance *present_instance(const instance *fmu, instance *preview) {
    if (fmu->run.has_begun) {
        return fmu;
    }
    *preview = *fmu;
    if (!start(preview)) {
        answer(fmu, CALL_DISCARD, "no outputs yet: %s", preview->reason);
        return NULL;
    }
    return preview;
}

bool bring_view_up_to_date(instance *fmu) {
    if (!fmu->view_is_current && fmu->run.has_begun) {
        evaluate(fmu);
    } else if (!fmu->view_is_current) {
        instance preview;
        if (present_instance(fmu, &preview) == NULL) {
            return false;
        }
        evaluate(&preview);
        fmu->view = preview.view;
    }
    fmu->view_is_current = true;
    return true;
}

/* Writes at most WORD_CAPACITY characters. A negative number stands for the beginning of a longer word. */
const char *word_text(instance *fmu, size_t word) {
    const unit_word *row = &unit_words[word];
    const double base = (double)strlen(row->alphabet);
    double number = *place_of(fmu, row->storage, row->offset);
    char *text = fmu->words[word], letters[WORD_CAPACITY];
    int place = WORD_CAPACITY - 1;
    letters[place] = '\0';
    if (number < 0.0) {
        letters[--place] = '~';
        number = -number;
    }
    for (; number >= 1.0 && place > 0; number = floor(number / base)) {
        letters[--place] = row->alphabet[(int)fmod(number, base)];
    }
    memcpy(text, letters + place, (size_t)(WORD_CAPACITY - place));
    return text;
}

/* ---- values for importers' solvers --------------------------------------------------------------------- */

/* Before the run, the start calculates states without a start value. */
call_status get_states(instance *fmu, double states[], size_t count) {
    if (!array_is_given(fmu, states, count, UNIT_CONTINUOUS_COUNT)) {
        return CALL_ERROR;
    }
    if (!fmu->run.has_begun && !bring_view_up_to_date(fmu)) {
        return CALL_DISCARD;
    }
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        const bool is_calculated = !fmu->run.has_begun && !unit_states[i].has_start;
        const double *numbers = is_calculated ? fmu->view.numbers : fmu->run.motion.numbers;
        states[i] = numbers[UNIT_PARAMETER_COUNT + unit_states[i].index];
    }
    return CALL_OK;
}

/* Writes values of the run or, before it begins, of the run that would start now. */
static call_status get_values(const instance *fmu, double values[], size_t count, size_t wanted,
                              void (*write)(const instance *fmu, const tdmf_page_instant *at,
                                            double values[])) {
    instance preview;
    if (!array_is_given(fmu, values, count, wanted)) {
        return CALL_ERROR;
    }
    const instance *present = present_instance(fmu, &preview);
    if (present == NULL) {
        return CALL_DISCARD;
    }
    const tdmf_page_instant at = instant_of(present);
    write(present, &at, values);
    return CALL_OK;
}

call_status get_derivatives(const instance *fmu, double derivatives[], size_t count) {
    return get_values(fmu, derivatives, count, UNIT_CONTINUOUS_COUNT, derivatives_at);
}

call_status get_indicators(const instance *fmu, double indicators[], size_t count) {
    return get_values(fmu, indicators, count, UNIT_GUARD_COUNT, indicators_at);
}

call_status get_nominals(const instance *fmu, double nominals[], size_t count) {
    if (!array_is_given(fmu, nominals, count, UNIT_CONTINUOUS_COUNT)) {
        return CALL_ERROR;
    }
    const tdmf_page_instant at = instant_of(fmu);
    pick_states(at.scales, nominals);
    for (int i = 0; i < UNIT_NOMINAL_COUNT; ++i) {
        nominals[unit_nominals[i].state] = unit_nominals[i].size(at.p, at.x);
    }
    return CALL_OK;
}
