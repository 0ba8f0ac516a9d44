/* Passing single values of a saved run. */
#include "saved_values.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

bool pass(transfer *bytes, void *value, size_t size) {
    if (bytes->target != NULL) {
        memcpy(bytes->target + bytes->offset, value, size);
    }
    if (bytes->source != NULL) {
        memcpy(value, bytes->source + bytes->offset, size);
    }
    bytes->offset += size;
    return bytes->source != NULL;
}

void require(transfer *bytes, bool allowed, const char *name) {
    if (!allowed && bytes->refused == NULL) {
        bytes->refused = name;
    }
}

void pass_between(transfer *bytes, const char *name, double *value, double least, double most) {
    if (pass(bytes, value, sizeof *value)) {
        require(bytes, *value >= least && *value <= most, name);
    }
}

void pass_integer(transfer *bytes, const char *name, int *value, int least, int most) {
    if (pass(bytes, value, sizeof *value) && !(*value >= least && *value <= most)) {
        require(bytes, false, name);
        *value = least;
    }
}

void pass_time(transfer *bytes, const char *name, double *value) {
    if (pass(bytes, value, sizeof *value)) {
        require(bytes, fmu_is_time(*value), name);
    }
}

void pass_work(transfer *bytes, const char *name, int64_t *value) {
    if (pass(bytes, value, sizeof *value)) {
        require(bytes, *value >= 0 && *value <= INT64_MAX / 2, name);
    }
}

void pass_flag(transfer *bytes, const char *name, bool *value) {
    unsigned char flag = *value;
    if (pass(bytes, &flag, sizeof flag)) {
        require(bytes, flag <= 1, name);
        *value = flag == 1;
    }
}

void pass_calls(transfer *bytes, saved_run *run) {
    int interface = (int)run->interface, state = (int)run->state;
    pass_integer(bytes, "the interface", &interface, MODEL_EXCHANGE, CO_SIMULATION_WITH_EVENT_MODE);
    pass_integer(bytes, "the state of the call sequence", &state, INSTANTIATED, ANYWHERE);
    run->interface = (interface_kind)interface;
    run->state = (call_state)state;
}

void require_calls(transfer *bytes, const saved_run *run) {
    require(bytes, state_suits_interface(run->state, run->interface, fmu_has_begun(&run->fmu)),
            "the state of the call sequence");
}

void pass_experiment(transfer *bytes, fmu *fmu) {
    pass_between(bytes, "the importer's tolerance", &fmu->importer_tolerance, DBL_MIN * DBL_EPSILON,
                 INFINITY);
    pass_between(bytes, "the stop time", &fmu->stop_time, -DBL_MAX, INFINITY);
}

const char *reason_of(const transfer *bytes, char *reason, size_t capacity) {
    if (bytes->refused == NULL) {
        return NULL;
    }
    snprintf(reason, capacity, "%s is out of range or contradicts the rest", bytes->refused);
    return reason;
}
