/* Reading and writing variables of a page's unit by their row in the table. */
#include "instance.h"

#include "run.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>

/* The number of the run that a parameter, an input or a state is. */
static double *number_of(const fmu *fmu, const fmu_variable *variable) {
    const bool is_state = variable->storage == STORED_STATE;
    return is_state ? &states_of(fmu)[unit_states[variable->offset].index]
                    : &parameters_of(fmu)[variable->offset];
}

double fmu_get_number(const fmu *fmu, const fmu_view *view, const fmu_variable *variable) {
    switch (variable->storage) {
    case STORED_TIME:
        return fmu->time;
    case STORED_SETTING:
        return fmu->settings[variable->offset];
    case STORED_START:
        return fmu->starts[variable->offset];
    case STORED_PARAMETER:
    case STORED_INPUT:
    case STORED_STATE:
        return *number_of(fmu, variable);
    case STORED_DERIVATIVE:
        return view->derivatives[variable->offset];
    case STORED_GUARD:
        return view->guards[variable->offset];
    case STORED_WORK:
        return fmin(view->work[variable->offset], INT_MAX);
    default:
        break;
    }
    const double *values = variable->storage == STORED_HELD ? view->numbers : view->outputs;
    const double value = values[variable->offset];
    if (variable->type != VARIABLE_INTEGER) {
        return value;
    }
    const bool is_code = variable->maximum < INT_MAX; /* code of a word; a long word has none */
    return is_code && !(value >= 0.0 && value <= variable->maximum) ? -1.0
                                                                    : fmin(fmax(value, -INT_MAX), INT_MAX);
}

void fmu_set_number(fmu *fmu, const fmu_variable *variable, double value) {
    if (variable->storage == STORED_TIME) {
        fmu->time = value;
    } else if (variable->storage == STORED_SETTING) {
        fmu->settings[variable->offset] = value;
    } else if (variable->storage == STORED_START) {
        fmu->starts[variable->offset] = value;
    } else {
        *number_of(fmu, variable) = value;
        if (fmu->is_exchange && fmu->has_begun) {
            take_immediate_events(fmu);
        }
    }
}

double *fmu_rate_of(fmu *fmu, const fmu_variable *input) {
    const bool is_state = input->offset >= UNIT_PARAMETER_COUNT;
    const int rate = is_state ? unit_input_rates[input->offset - UNIT_PARAMETER_COUNT] : -1;
    return rate < 0 ? NULL : &states_of(fmu)[rate];
}

char *value_text(const fmu_variable *variable, double value, char text[VALUE_CAPACITY]) {
    char number[NUMBER_CAPACITY];
    const bool has_unit = variable->unit != NULL;
    snprintf(text, VALUE_CAPACITY, "%s%s%s", number_text(value, number), has_unit ? " " : "",
             has_unit ? variable->unit : "");
    return text;
}

const char *fmu_refuse_value(const fmu_variable *variable, double value, char text[FMU_TEXT]) {
    char given[VALUE_CAPACITY];
    const char *allowed = unit_allowed[variable - fmu_variables];
    const bool has_unit = allowed != NULL && variable->unit != NULL;
    if (value >= variable->minimum && value <= variable->maximum) {
        return NULL;
    }
    snprintf(text, FMU_TEXT, "%s = %s is refused: %s%s%s%s", variable->name,
             value_text(variable, value, given), allowed == NULL ? "it has to be finite" : "allowed ",
             allowed == NULL ? "" : allowed, has_unit ? " " : "", has_unit ? variable->unit : "");
    return text;
}
