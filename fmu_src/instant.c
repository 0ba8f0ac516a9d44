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
    tdmf_show_to_world(unit_model, fmu->run.motion.mode, parameters_of(fmu), states_in(fmu), room);
}

void take_from_world(instance *fmu) {
    double room[UNIT_STATE_COUNT + 1];
    tdmf_take_from_world(unit_model, fmu->run.motion.shown, parameters_of(fmu), states_in(fmu), room);
}

/* ---- the view ------------------------------------------------------------------------------------------ */

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

static void write_indicators(instance *fmu) {
    const tdmf_page_instant at = instant_of(fmu);
    guard_state guards[TDMF_GUARD_LIMIT];
    tdmf_view_guards(&at, fmu->run.watch, guards);
    for (int i = 0; i < UNIT_GUARD_COUNT; ++i) {
        const double value = indicator(&at, guards, &unit_guards[i]);
        fmu->view.guards[i] = isnan(value) ? 1.0 : value;
    }
}

/* Derivatives are limited as trial states are: an importer's solver then finds that its step was too long. */
static void write_derivatives(instance *fmu) {
    const tdmf_page_instant at = instant_of(fmu);
    double rates[UNIT_STATE_COUNT + 1];
    tdmf_page_world_rates(&at, rates);
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        fmu->view.derivatives[i] = within_largest(rates[unit_states[i].index]);
    }
}

/* Outputs are limited, because trial states may give any value. */
static void write_outputs(instance *fmu) {
    shown_mode_of(fmu)->outputs(parameters_of(fmu), states_of(fmu), fmu->view.outputs);
    for (int i = 0; i < UNIT_OUTPUT_COUNT; ++i) {
        fmu->view.outputs[i] = within_largest(fmu->view.outputs[i]);
    }
}

/* A time of the page as the importer's clock shows it; 0 for one before the run. */
static double shown_time(const unit_run *run, double time) {
    return time < 0.0 ? 0.0 : time == run->motion.time ? run->time : run->epoch + time;
}

static void write_numbers(instance *fmu) {
    double *states = fmu->view.numbers + UNIT_PARAMETER_COUNT;
    memcpy(fmu->view.numbers, fmu->run.motion.numbers, sizeof fmu->view.numbers);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        states[i] = unit_holds_time[i] ? shown_time(&fmu->run, states[i]) : states[i];
    }
}

void evaluate(instance *fmu, fmu_storage storage) {
    static void (*const writers[STORAGE_COUNT])(instance * fmu) = {[STORED_DERIVATIVE] = write_derivatives,
                                                                   [STORED_OUTPUT] = write_outputs,
                                                                   [STORED_HELD] = write_numbers,
                                                                   [STORED_GUARD] = write_indicators};
    if (writers[storage] != NULL) {
        writers[storage](fmu);
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

bool bring_up_to_date(instance *fmu, fmu_storage storage) {
    if ((fmu->current >> storage & 1) == 0 && fmu->run.has_begun) {
        evaluate(fmu, storage);
        fmu->current |= 1u << storage;
    } else if ((fmu->current >> storage & 1) == 0) {
        instance preview;
        if (present_instance(fmu, &preview) == NULL) {
            return false;
        }
        for (int i = 0; i < STORAGE_COUNT; ++i) {
            evaluate(&preview, (fmu_storage)i);
        }
        fmu->view = preview.view;
        fmu->current = (1u << STORAGE_COUNT) - 1;
    }
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
    if (!fmu->run.has_begun && !bring_up_to_date(fmu, STORED_HELD)) {
        return CALL_DISCARD;
    }
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        const bool is_calculated = !fmu->run.has_begun && !unit_states[i].has_start;
        const double *numbers = is_calculated ? fmu->view.numbers : fmu->run.motion.numbers;
        states[i] = numbers[UNIT_PARAMETER_COUNT + unit_states[i].index];
    }
    return CALL_OK;
}

static call_status get_values(instance *fmu, fmu_storage storage, double values[], size_t count,
                              size_t wanted) {
    if (!array_is_given(fmu, values, count, wanted)) {
        return CALL_ERROR;
    }
    if (!bring_up_to_date(fmu, storage)) {
        return CALL_DISCARD;
    }
    for (size_t i = 0; i < count; ++i) {
        values[i] = *place_of(fmu, storage, i);
    }
    return CALL_OK;
}

call_status get_derivatives(instance *fmu, double derivatives[], size_t count) {
    return get_values(fmu, STORED_DERIVATIVE, derivatives, count, UNIT_CONTINUOUS_COUNT);
}

call_status get_indicators(instance *fmu, double indicators[], size_t count) {
    return get_values(fmu, STORED_GUARD, indicators, count, UNIT_GUARD_COUNT);
}

call_status get_nominals(const instance *fmu, double nominals[], size_t count) {
    if (!array_is_given(fmu, nominals, count, UNIT_CONTINUOUS_COUNT)) {
        return CALL_ERROR;
    }
    const tdmf_page_instant at = instant_of(fmu);
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        nominals[i] = at.scales[unit_states[i].index];
    }
    for (int i = 0; i < UNIT_NOMINAL_COUNT; ++i) {
        nominals[unit_nominals[i].state] = unit_nominals[i].size(at.p, at.x);
    }
    return CALL_OK;
}
