/* The fields of a saved run of a page, but for those that follow from the rest. */
#include "saved_values.h"

#include "unit_instant.h"

#include <float.h>
#include <math.h>
#include <string.h>

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

static void pass_motion(transfer *bytes, page_motion *motion) {
    pass_numbers(bytes, motion->numbers);
    pass_time(bytes, "the time", &motion->time);
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
    pass_experiment(bytes, fmu);
}

static void pass_run(transfer *bytes, saved_run *run) {
    fmu *fmu = &run->fmu;
    pass_calls(bytes, run);
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
    pass_time(bytes, "the time", &fmu->accounted_time);
    for (int i = 0; i < UNIT_EVENT_COUNT; ++i) {
        pass(bytes, &fmu->watch[i], sizeof fmu->watch[i]);
        require(bytes, fmu->watch[i] <= WATCH_RISING, "how a guard was seen");
    }
    pass_work(bytes, "the work done", &fmu->steps);
    pass_work(bytes, "the work done", &fmu->evaluations);
    pass_flag(bytes, "the pending event", &fmu->event_is_pending);
    pass_integer(bytes, "the pending event", &fmu->event, 0, UNIT_EVENT_COUNT);
    pass_motion(bytes, &fmu->after_event);
    pass_numbers(bytes, fmu->event_numbers);
}

/* Gives fields that are empty before the start, or without an event, values that are allowed. */
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

/* Whether the states in the world's coordinates follow from those of the mode, as in Co-Simulation. */
static bool coordinates_agree(const fmu *fmu) {
    struct fmu shown = *fmu;
    const tdmf_page_instant at = instant_of(fmu);
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
        finite &= fabs(derivatives[i]) < fmu_largest_state;
    }
    return finite;
}

static void require_agreement(transfer *bytes, const saved_run *run) {
    const fmu *fmu = &run->fmu;
    require_calls(bytes, run);
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
    return reason_of(&source, reason, capacity);
}
