/* Reading and writing variables of the runner's unit by their row in the table. */
#include "variables.h"

#include <string.h>

static const void *storage_of(const fmu *fmu, const fmu_view *view, fmu_storage storage) {
    switch (storage) {
    case STORED_TIME:
        return &fmu->motion.time;
    case STORED_PARAMETER:
        return &fmu->parameters;
    case STORED_SETTING:
        return &fmu->settings;
    case STORED_INPUT:
        return &fmu->inputs;
    case STORED_STATE:
        return fmu->motion.state;
    case STORED_DERIVATIVE:
        return view->derivatives;
    case STORED_GUARD:
        return view->guards;
    case STORED_WORK:
        return &view->work;
    default:
        return &view->outputs;
    }
}

/* Vectors are indexed by element, structs by byte. */
static size_t byte_offset(const fmu_variable *variable) {
    const bool indexed = variable->storage == STORED_STATE || variable->storage == STORED_DERIVATIVE ||
                         variable->storage == STORED_GUARD;
    return indexed ? variable->offset * sizeof(double) : variable->offset;
}

const char *fmu_refuse_value(const fmu_variable *variable, double value, char text[FMU_TEXT]) {
    const tdmf_refusal refusal = {.variable = variable->name,
                                  .unit = variable->unit,
                                  .value = value,
                                  .minimum = variable->minimum,
                                  .maximum = variable->maximum};
    const bool allowed = value >= variable->minimum && value <= variable->maximum;
    return allowed ? NULL : tdmf_refusal_text(&refusal, text, FMU_TEXT);
}

double fmu_get_number(const fmu *fmu, const fmu_view *view, const fmu_variable *variable) {
    const char *address = (const char *)storage_of(fmu, view, variable->storage) + byte_offset(variable);
    if (variable->type == VARIABLE_REAL) {
        double value;
        memcpy(&value, address, sizeof value);
        return value;
    }
    if (variable->type == VARIABLE_BOOLEAN) {
        bool value;
        memcpy(&value, address, sizeof value);
        return value;
    }
    int value;
    memcpy(&value, address, sizeof value);
    return value;
}

const char *fmu_get_text(const fmu_view *view, const fmu_variable *variable) {
    return (const char *)&view->outputs + variable->offset;
}

void fmu_set_number(fmu *fmu, const fmu_variable *variable, double value) {
    /* Settable variables live in the unit; the view is never written through here. */
    char *address = (char *)(size_t)storage_of(fmu, NULL, variable->storage) + byte_offset(variable);
    if (variable->type == VARIABLE_REAL) {
        memcpy(address, &value, sizeof value);
    } else if (variable->type == VARIABLE_BOOLEAN) {
        const bool truth = value != 0.0;
        memcpy(address, &truth, sizeof truth);
    } else {
        const int number = (int)value;
        memcpy(address, &number, sizeof number);
    }
}

double fmu_get_number_rate(const fmu *fmu, const fmu_variable *input) {
    double rate;
    memcpy(&rate, (const char *)&fmu->input_rates + byte_offset(input), sizeof rate);
    return rate;
}

void fmu_set_number_rate(fmu *fmu, const fmu_variable *input, double rate) {
    memcpy((char *)&fmu->input_rates + byte_offset(input), &rate, sizeof rate);
}
