/* Jumps of quantities that change other states. */
#include "run.h"

#include <string.h>

void account_for_all(instance *fmu) {
    memcpy(fmu->run.accounted, fmu->run.motion.numbers, sizeof fmu->run.accounted);
    if (is_exchange(fmu) && unit_model->set_count > 0) {
        const tdmf_page_instant at = instant_of(fmu);
        tdmf_page_rates(&at, fmu->run.accounted_rates);
        fmu->run.accounted_time = fmu->run.motion.time;
    }
}

static int index_of(const tdmf_set_kind *kind) {
    return kind->is_state ? UNIT_PARAMETER_COUNT + kind->index : kind->index;
}

static bool has_jumped(const instance *fmu, const tdmf_set_kind *kind) {
    const int place = index_of(kind);
    return kind->set[fmu->run.motion.mode] != NULL &&
           fmu->run.motion.numbers[place] != fmu->run.accounted[place];
}

bool quantity_has_jumped(const instance *fmu) {
    bool found = false;
    for (int i = 0; i < unit_model->set_count; ++i) {
        found |= has_jumped(fmu, &unit_model->sets[i]);
    }
    return found;
}

/* Adds to `change` what a jump between two values of a quantity changes, at given states. */
static void add_change(const instance *fmu, const tdmf_set_kind *kind, const double *states, double from,
                       double to, double factor, double *change) {
    double numbers[UNIT_NUMBER_COUNT + 1], after[UNIT_STATE_COUNT + 1];
    double *x = numbers + UNIT_PARAMETER_COUNT;
    memcpy(numbers, fmu->run.motion.numbers, UNIT_PARAMETER_COUNT * sizeof *numbers);
    memcpy(x, states, UNIT_STATE_COUNT * sizeof *x);
    numbers[index_of(kind)] = from;
    memcpy(after, x, UNIT_STATE_COUNT * sizeof *after);
    kind->set[fmu->run.motion.mode](numbers, x, to, after);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        change[i] += factor * (after[i] - x[i]);
    }
}

bool account_for_jumps(instance *fmu) {
    bool found = false;
    for (int i = 0; i < unit_model->set_count; ++i) {
        const tdmf_set_kind *kind = &unit_model->sets[i];
        if (has_jumped(fmu, kind)) {
            double change[UNIT_STATE_COUNT + 1] = {0.0};
            const double *numbers = fmu->run.motion.numbers;
            add_change(fmu, kind, states_of(fmu), fmu->run.accounted[index_of(kind)], numbers[index_of(kind)],
                       1.0, change);
            for (int j = 0; j < UNIT_STATE_COUNT; ++j) {
                states_in(fmu)[j] += change[j];
            }
            found = true;
        }
    }
    account_for_all(fmu);
    if (found) {
        show_to_world(fmu);
    }
    return found;
}

/* An input of Model Exchange has no rate. What it has changed along a step is the integral over it, by
 * Simpson's rule with the cubic through both ends, less what a jump at the end would change. */
static void correct_for_drift(const instance *fmu, const tdmf_set_kind *kind, double *change) {
    const double *start = fmu->run.accounted + UNIT_PARAMETER_COUNT, *end = states_of(fmu);
    const double first = fmu->run.accounted[index_of(kind)], last = fmu->run.motion.numbers[index_of(kind)];
    const double jump = last - first, eighth = (fmu->run.motion.time - fmu->run.accounted_time) / 8.0;
    double middle[UNIT_STATE_COUNT + 1], rates[UNIT_STATE_COUNT + 1];
    const tdmf_page_instant at = instant_of(fmu);
    tdmf_page_rates(&at, rates);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        middle[i] = 0.5 * (start[i] + end[i]) + eighth * (fmu->run.accounted_rates[i] - rates[i]);
    }
    const double *const places[] = {start, middle, end};
    const double values[] = {first, 0.5 * (first + last), last};
    const double halves[] = {jump / 12.0, jump / 3.0, jump / 12.0};
    for (int i = 0; i < 3; ++i) {
        add_change(fmu, kind, places[i], values[i] - halves[i], values[i] + halves[i], 1.0, change);
        add_change(fmu, kind, end, values[i] - halves[i], values[i] + halves[i], -1.0, change);
    }
}

bool account_for_drifts(instance *fmu) {
    double change[UNIT_STATE_COUNT + 1] = {0.0};
    for (int i = 0; i < unit_model->set_count; ++i) {
        if (has_jumped(fmu, &unit_model->sets[i])) {
            correct_for_drift(fmu, &unit_model->sets[i], change);
        }
    }
    const bool found = account_for_jumps(fmu);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        states_in(fmu)[i] += change[i];
    }
    if (found) {
        account_for_all(fmu);
    }
    return found;
}
