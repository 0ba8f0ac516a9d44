/* Reading and writing variables by their row in the table. */
#include "variables.h"

#include <string.h>

static const void *storage_of(const unit *unit, const unit_view *view, unit_storage storage) {
    switch (storage) {
    case STORED_TIME:
        return &unit->motion.time;
    case STORED_PARAMETER:
        return &unit->parameters;
    case STORED_SETTING:
        return &unit->settings;
    case STORED_INPUT:
        return &unit->inputs;
    case STORED_STATE:
        return unit->motion.state;
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
static size_t byte_offset(const unit_variable *variable) {
    const bool indexed = variable->storage == STORED_STATE || variable->storage == STORED_DERIVATIVE ||
                         variable->storage == STORED_GUARD;
    return indexed ? variable->place * sizeof(double) : variable->place;
}

bool unit_is_set_at_events(const unit_variable *variable) {
    return variable->variability == VARIABILITY_TUNABLE ||
           (variable->storage == STORED_INPUT && variable->variability == VARIABILITY_DISCRETE);
}

tdmf_refusal unit_refuse_value(const unit_variable *variable, double value) {
    tdmf_refusal refusal = {
        .unit = variable->unit, .value = value, .minimum = variable->minimum, .maximum = variable->maximum};
    const bool allowed = value >= variable->minimum && value <= variable->maximum;
    refusal.variable = allowed ? NULL : variable->name;
    return refusal;
}

double unit_get_number(const unit *unit, const unit_view *view, const unit_variable *variable) {
    const char *place = (const char *)storage_of(unit, view, variable->storage) + byte_offset(variable);
    if (variable->type == VARIABLE_REAL) {
        double value;
        memcpy(&value, place, sizeof value);
        return value;
    }
    int value;
    memcpy(&value, place, sizeof value);
    return value;
}

const char *unit_get_text(const unit_view *view, const unit_variable *variable) {
    return (const char *)&view->outputs + variable->place;
}

void unit_set_number(unit *unit, const unit_variable *variable, double value) {
    /* Settable variables live in the unit; the view is never written through here. */
    char *place = (char *)(size_t)storage_of(unit, NULL, variable->storage) + byte_offset(variable);
    if (variable->type == VARIABLE_REAL) {
        memcpy(place, &value, sizeof value);
    } else {
        const int number = (int)value;
        memcpy(place, &number, sizeof number);
    }
}

double unit_get_number_rate(const unit *unit, const unit_variable *input) {
    double rate;
    memcpy(&rate, (const char *)&unit->input_rates + byte_offset(input), sizeof rate);
    return rate;
}

void unit_set_number_rate(unit *unit, const unit_variable *input, double rate) {
    memcpy((char *)&unit->input_rates + byte_offset(input), &rate, sizeof rate);
}
