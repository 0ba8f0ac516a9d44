/* The fields of a saved run of a page. One function writes them, reads and checks them, or only counts their
 * bytes, so that what is written and what is read cannot differ. What follows from the rest is left out. */
#include "saved_fields.h"

#include "page_instant.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Beyond whatever is added up along a run, and far enough from overflow for differences and products. */
static const double largest_sum = 1e200;

typedef struct {
    unsigned char *target;       /* written to, or NULL */
    const unsigned char *source; /* read from, or NULL */
    size_t offset;
    const char *refused; /* the first field that may not be what it is */
} transfer;

static void pass(transfer *bytes, void *value, size_t size) {
    if (bytes->target != NULL) {
        memcpy(bytes->target + bytes->offset, value, size);
    }
    if (bytes->source != NULL) {
        memcpy(value, bytes->source + bytes->offset, size);
    }
    bytes->offset += size;
}

static void require(transfer *bytes, bool allowed, const char *name) {
    if (!allowed && bytes->refused == NULL) {
        bytes->refused = name;
    }
}

/* NaN lies between nothing. */
static void pass_between(transfer *bytes, const char *name, double *value, double least, double most) {
    pass(bytes, value, sizeof *value);
    require(bytes, *value >= least && *value <= most, name);
}

static void pass_integer(transfer *bytes, const char *name, int *value, int least, int most) {
    pass(bytes, value, sizeof *value);
    if (!(*value >= least && *value <= most)) {
        require(bytes, false, name);
        *value = least;
    }
}

/* A bool never holds anything but its two values. */
static void pass_flag(transfer *bytes, const char *name, bool *value) {
    unsigned char flag = *value;
    pass(bytes, &flag, sizeof flag);
    require(bytes, flag <= 1, name);
    *value = flag == 1;
}

/* Parameters within their ranges, and states that are finite. Trial states of an importer's solver and states
 * on their way to an event may be out of the range of starts. */
static void pass_numbers(transfer *bytes, double *numbers) {
    for (int i = 0; i < UNIT_PARAMETER_COUNT; ++i) {
        pass_between(bytes, unit_model->parameter_names[i], &numbers[i], unit_model->parameter_least[i],
                     unit_model->parameter_most[i]);
    }
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        pass_between(bytes, unit_model->state_names[i], &numbers[UNIT_PARAMETER_COUNT + i], -largest_sum,
                     largest_sum);
    }
}

static void pass_time(transfer *bytes, double *time) {
    pass(bytes, time, sizeof *time);
    require(bytes, fmu_is_time(*time), "the time");
}

static void pass_motion(transfer *bytes, page_motion *motion) {
    pass_numbers(bytes, motion->numbers);
    pass_time(bytes, &motion->time);
    const double digit = DBL_EPSILON * fabs(motion->time);
    pass_between(bytes, "the rest of the time", &motion->time_rest, -digit, digit);
    pass(bytes, &motion->taken, sizeof motion->taken);
    pass(bytes, &motion->above, sizeof motion->above);
    pass(bytes, &motion->late, sizeof motion->late);
    pass_integer(bytes, "the mode", &motion->mode, 0, unit_model->mode_count - 1);
    pass_integer(bytes, "the chain of events", &motion->chain, 0, TDMF_PAGE_CHAIN_LIMIT + 1);
}

static void pass_settings(transfer *bytes, fmu *fmu) {
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmu_variable *variable = &fmu_variables[i];
        if (variable->storage == STORED_SETTING) {
            pass_between(bytes, variable->name, &fmu->settings[variable->offset], variable->minimum,
                         variable->maximum);
        }
    }
    pass_between(bytes, "the importer's tolerance", &fmu->importer_tolerance, DBL_MIN * DBL_EPSILON,
                 INFINITY);
    pass_between(bytes, "the stop time", &fmu->stop_time, -DBL_MAX, INFINITY);
}

static void pass_work(transfer *bytes, int64_t *count) {
    pass(bytes, count, sizeof *count);
    require(bytes, *count >= 0 && *count <= INT64_MAX / 2, "the work done");
}

static void pass_run(transfer *bytes, saved_run *run) {
    fmu *fmu = &run->fmu;
    int interface = (int)run->interface, state = (int)run->state;
    pass_integer(bytes, "the interface", &interface, MODEL_EXCHANGE, CO_SIMULATION_WITH_EVENT_MODE);
    pass_integer(bytes, "the state of the call sequence", &state, INSTANTIATED, ANYWHERE);
    run->interface = (interface_kind)interface;
    run->state = (call_state)state;
    pass_flag(bytes, "whether the run has begun", &fmu->has_begun);
    pass_flag(bytes, "whether an input has jumped", &fmu->has_jumped);
    pass_settings(bytes, fmu);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        pass_between(bytes, unit_model->state_names[i], &fmu->starts[i], -largest_sum, largest_sum);
    }
    pass_motion(bytes, &fmu->motion);
    pass_numbers(bytes, fmu->accounted);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        pass_between(bytes, "a rate", &fmu->accounted_rates[i], -DBL_MAX, DBL_MAX);
    }
    pass_time(bytes, &fmu->accounted_time);
    for (int i = 0; i < UNIT_EVENT_COUNT; ++i) {
        pass(bytes, &fmu->watch[i], sizeof fmu->watch[i]);
        require(bytes, fmu->watch[i] <= WATCH_RISING, "how a guard was seen");
    }
    pass_work(bytes, &fmu->steps);
    pass_work(bytes, &fmu->evaluations);
    pass_flag(bytes, "the pending event", &fmu->event_is_pending);
    pass_integer(bytes, "the pending event", &fmu->event, 0, UNIT_EVENT_COUNT);
    pass_motion(bytes, &fmu->after_event);
    pass_numbers(bytes, fmu->event_numbers);
}

/* What is left empty before the start, or without an event, is made allowed. */
static void fill(saved_run *run) {
    fmu *fmu = &run->fmu;
    if (!fmu->has_begun) {
        memcpy(fmu->accounted, fmu->motion.numbers, sizeof fmu->accounted);
    }
    if (!fmu->event_is_pending) {
        fmu->after_event = fmu->motion;
        memcpy(fmu->event_numbers, fmu->motion.numbers, sizeof fmu->event_numbers);
    }
}

/* ---- what has to agree -------------------------------------------------------------------------------- */

/* In Co-Simulation, where the world's states follow from those of the mode. */
static bool coordinates_agree(const fmu *fmu) {
    struct fmu shown = *fmu;
    const instant at = instant_of(fmu);
    unit_model->scales(parameters_of(fmu), at.scales, at.event_scales);
    show_to_world(&shown);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        const double value = states_of(fmu)[i], seen = states_of(&shown)[i];
        if (!(fabs(value - seen) <= 1e-9 * (at.scales[i] + fabs(value)))) {
            return false;
        }
    }
    return true;
}

static bool rates_are_finite(const fmu *fmu) {
    double derivatives[FMU_STATE_COUNT + 1];
    bool finite = true;
    fmu_derivatives(fmu, derivatives);
    for (int i = 0; i < FMU_STATE_COUNT; ++i) {
        finite &= fabs(derivatives[i]) < 1e60;
    }
    return finite;
}

static void require_agreement(transfer *bytes, const saved_run *run) {
    const fmu *fmu = &run->fmu;
    require(bytes, state_suits_interface(run->state, run->interface, fmu->has_begun),
            "the state of the call sequence");
    require(bytes,
            !fmu->event_is_pending || (run->interface == CO_SIMULATION_WITH_EVENT_MODE && fmu->has_begun &&
                                       fmu->after_event.time == fmu->motion.time),
            "the pending event");
    if (bytes->refused == NULL && fmu->has_begun && run->interface != MODEL_EXCHANGE) {
        require(bytes, coordinates_agree(fmu), "a state in the world's coordinates");
        require(bytes, rates_are_finite(fmu), "a state, which has no finite rate");
    }
}

/* ---- a run -------------------------------------------------------------------------------------------- */

size_t saved_run_size(void) {
    static const saved_run none;
    saved_run run = none;
    transfer bytes = {0};
    pass_run(&bytes, &run);
    return bytes.offset;
}

void write_saved_run(saved_run *run, unsigned char *bytes) {
    transfer target = {.target = bytes};
    fill(run);
    pass_run(&target, run);
}

const char *read_saved_run(const unsigned char *bytes, saved_run *run, char *reason, size_t capacity) {
    transfer source = {.source = bytes};
    fmu_reset(&run->fmu);
    pass_run(&source, run);
    require_agreement(&source, run);
    if (source.refused != NULL) {
        snprintf(reason, capacity, "%s is out of range or contradicts the rest", source.refused);
        return reason;
    }
    return NULL;
}
