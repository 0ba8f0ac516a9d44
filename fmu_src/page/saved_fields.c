/* The fields of a saved run of a page, but for those that follow from the rest. */
#include "saved_values.h"

#include "unit_instant.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* The name of a parameter or a state: that of its variable, else the page's own. */
static const char *name_of_number(int place) {
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmu_variable *v = &fmu_variables[i];
        const bool is_number =
            v->storage == STORED_PARAMETER || v->storage == STORED_INPUT || v->storage == STORED_HELD;
        const size_t offset = v->storage == STORED_STATE
                                  ? (size_t)(UNIT_PARAMETER_COUNT + unit_states[v->offset].index)
                                  : v->offset;
        if ((is_number || v->storage == STORED_STATE) && v->type != VARIABLE_STRING &&
            offset == (size_t)place) {
            return v->name;
        }
    }
    return place < UNIT_PARAMETER_COUNT ? unit_model->parameter_names[place]
                                        : unit_model->state_names[place - UNIT_PARAMETER_COUNT];
}

static void pass_number(transfer *bytes, double *numbers, int place, double least, double most) {
    if (pass(bytes, &numbers[place], sizeof *numbers) &&
        !(numbers[place] >= least && numbers[place] <= most)) {
        require(bytes, false, name_of_number(place));
    }
}

/* Parameters within their ranges, and states that are finite. Trial states of an importer's solver and states
 * on their way to an event may be out of the range of starts. */
static void pass_numbers(transfer *bytes, double *numbers) {
    double largest[UNIT_STATE_COUNT + 1];
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        largest[i] = unit_input_rates[i] < 0 ? largest_sum : fmu_largest_state;
    }
    for (int i = 0; i < FMU_STATE_COUNT; ++i) {
        largest[unit_states[i].index] = unit_states[i].has_start ? fmu_largest_state : largest_sum;
    }
    for (int i = 0; i < UNIT_PARAMETER_COUNT; ++i) {
        pass_number(bytes, numbers, i, unit_model->parameter_least[i], unit_model->parameter_most[i]);
    }
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        pass_number(bytes, numbers, UNIT_PARAMETER_COUNT + i, -largest[i], largest[i]);
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
    pass_integer(bytes, "the mode that is shown", &motion->shown, 0, unit_model->mode_count - 1);
    const tdmf_mode_kind *modes = unit_model->modes;
    require(bytes,
            motion->shown == motion->mode ||
                (modes[motion->mode].keeps_outputs && !modes[motion->shown].ends),
            "the mode that is shown");
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
    pass_flag(bytes, "the pending event", &fmu->event_is_pending);
    pass_flag(bytes, "whether an input has jumped", &fmu->has_jumped);
    pass_settings(bytes, fmu);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        pass_between(bytes, unit_model->state_names[i], &fmu->starts[i], -largest_sum, largest_sum);
    }
    pass_motion(bytes, &fmu->motion);
    pass_time(bytes, "the time", &fmu->time);
    pass_time(bytes, "the start time", &fmu->epoch);
    pass_numbers(bytes, fmu->accounted);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        pass_between(bytes, "a rate", &fmu->accounted_rates[i], -DBL_MAX, DBL_MAX);
    }
    pass_time(bytes, "the time", &fmu->accounted_time);
    for (int i = 0; i < UNIT_EVENT_COUNT; ++i) {
        pass(bytes, &fmu->watch[i], sizeof fmu->watch[i]);
        require(bytes, fmu->watch[i] <= WATCH_RISING, "how a guard was seen");
    }
    for (int i = 0; i < WORK_COUNT; ++i) {
        pass_work(bytes, "the work done", &fmu->work[i]);
    }
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

/* In Co-Simulation the states in the world's coordinates follow from those of the mode. */
static void require_coordinates(transfer *bytes, const fmu *fmu) {
    struct fmu shown = *fmu;
    const tdmf_page_instant at = instant_of(fmu);
    show_to_world(&shown);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        const double value = states_of(fmu)[i], seen = states_of(&shown)[i];
        if (!(fabs(value - seen) <= 1e-9 * (at.scales[i] + fabs(value)))) {
            require(bytes, false, name_of_number(UNIT_PARAMETER_COUNT + i));
        }
    }
}

/* States keep the page's bounds, and times that are held have passed. */
static void require_bounds(transfer *bytes, const page_motion *motion, bool is_exchange) {
    const double *x = motion->numbers + UNIT_PARAMETER_COUNT;
    for (int i = 0; i < UNIT_BOUND_COUNT; ++i) {
        const unit_bound *row = &unit_bounds[i];
        const double value = x[row->state];
        if (!(is_exchange && row->moves) &&
            !(value >= row->least && value <= row->most && (!row->is_whole || value == floor(value)))) {
            require(bytes, false, name_of_number(UNIT_PARAMETER_COUNT + row->state));
        }
    }
    for (int i = 0; i < UNIT_STATE_COUNT && !is_exchange; ++i) {
        if (unit_holds_time[i] && x[i] > motion->time) {
            require(bytes, false, name_of_number(UNIT_PARAMETER_COUNT + i));
        }
    }
}

/* Booleans and enumerations are whole numbers. */
static void require_whole(transfer *bytes, const fmu *fmu) {
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmu_variable *variable = &fmu_variables[i];
        if (variable->type != VARIABLE_REAL &&
            (variable->storage == STORED_PARAMETER || variable->storage == STORED_SETTING)) {
            const double value = fmu_get_number(fmu, NULL, variable);
            const bool is_one = value >= variable->minimum && value <= variable->maximum;
            require(bytes, is_one && value == floor(value), variable->name);
        }
    }
}

static bool clocks_agree(const fmu *fmu) {
    const double digit = 4.0 * DBL_EPSILON * fmax(fabs(fmu->time), fabs(fmu->epoch));
    return fabs(fmu->time - fmu->epoch - fmu->motion.time) <= digit &&
           (unit_clock < 0 || states_of(fmu)[unit_clock] == fmu->motion.time);
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
    require_whole(bytes, fmu);
    require(bytes,
            !fmu->event_is_pending || (run->interface == CO_SIMULATION_WITH_EVENT_MODE && fmu->has_begun &&
                                       fmu->after_event.time == fmu->motion.time),
            "the pending event");
    if (fmu->has_begun) {
        require(bytes, clocks_agree(fmu), "the time");
        require_bounds(bytes, &fmu->motion, fmu->is_exchange);
        require_bounds(bytes, &fmu->after_event, fmu->is_exchange);
    }
    if (bytes->refused == NULL && fmu->has_begun && run->interface != MODEL_EXCHANGE) {
        require_coordinates(bytes, fmu);
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
    run->fmu.is_exchange = run->interface == MODEL_EXCHANGE;
    if (source.refused == NULL && run->fmu.has_begun && fmu_prepare(&run->fmu, reason) != NULL) {
        return reason;
    }
    if (run->fmu.is_exchange && run->fmu.has_begun) {
        take_from_world(&run->fmu);
    }
    require_agreement(&source, run);
    return reason_of(&source, reason, capacity);
}
