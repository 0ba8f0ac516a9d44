/* A run of any page: its start, events, steps of an importer's solver, and steps of Co-Simulation. In Model
 * Exchange the importer integrates; the unit gives derivatives and event indicators, and takes events. In
 * Co-Simulation the unit integrates. Both interfaces have event mode. */
#include "run.h"

#include "page_cvode.h"
#include "run_state.h"

#include <float.h>
#include <string.h>

const double rounding_at_event = 1e-9;

/* Sets the importer's time and with it the page's. */
static void set_clocks(instance *fmu, double time) {
    fmu->run.time = time;
    fmu->run.motion.time = time - fmu->run.epoch;
    fmu->run.motion.time_rest = 0.0;
    if (unit_clock >= 0) {
        states_in(fmu)[unit_clock] = fmu->run.motion.time;
    }
}

/* True unless states are larger than those of any motion. */
static bool is_within_motion(instance *fmu) {
    const char *name = number_out_of_range(fmu->run.motion.numbers);
    return name == NULL || refuse(fmu, "%.200s is larger than in any motion", name);
}

static bool refuse_outcome(instance *fmu, tdmf_run_outcome outcome) {
    const tdmf_page_run run = run_of(fmu);
    tdmf_run_message(unit_model, &run, outcome, fmu->reason, sizeof fmu->reason);
    return false;
}

/* ---- the start ----------------------------------------------------------------------------------------- */

call_status set_experiment(instance *fmu, bool tolerance_defined, double tolerance, double start_time,
                           bool stop_time_defined, double stop_time) {
    if (!is_time(start_time)) {
        return answer(fmu, CALL_ERROR, "the start time is not finite or beyond 1e100 s");
    }
    if (stop_time_defined && !(stop_time >= start_time)) {
        return answer(fmu, CALL_ERROR, "the stop time lies before the start time, or is not a number");
    }
    if (tolerance_defined && !(tolerance > 0.0 && isfinite(tolerance))) {
        return answer(fmu, CALL_ERROR, "the tolerance is not a positive number");
    }
    set_clocks(fmu, start_time);
    fmu->run.importer_tolerance = tolerance_defined ? tolerance : INFINITY;
    fmu->run.stop_time = stop_time_defined ? stop_time : INFINITY;
    fmu->current = 0;
    return CALL_OK;
}

bool requirements_are_met(instance *fmu, bool of_parameters) {
    for (int i = 0; i < UNIT_REQUIREMENT_COUNT; ++i) {
        const unit_requirement *row = &unit_requirements[i];
        if (row->of_parameters == of_parameters &&
            !(row->margin(parameters_of(fmu), states_of(fmu)) >= 0.0)) {
            const fmu_variable *of = &fmu_variables[row->variable],
                               *bound = row->bound < 0 ? NULL : &fmu_variables[row->bound];
            char value[VALUE_CAPACITY], limit[VALUE_CAPACITY] = "";
            evaluate(fmu, storage_of(fmu, of));
            if (bound != NULL) {
                evaluate(fmu, storage_of(fmu, bound));
                value_text(bound, number_of(fmu, bound), limit);
            }
            return refuse(fmu, "%s = %s is refused: it must be %s%s%s", of->name,
                          value_text(of, number_of(fmu, of), value), row->allowed, bound != NULL ? " = " : "",
                          limit);
        }
    }
    return true;
}

void begin_time(instance *fmu) {
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        if (fmu_variables[i].storage == STORED_START) {
            states_in(fmu)[fmu_variables[i].offset] = fmu->run.starts[fmu_variables[i].offset];
        }
    }
    fmu->run.epoch = UNIT_CLOCK_IS_RELATIVE ? fmu->run.time : 0.0;
    set_clocks(fmu, fmu->run.time);
}

bool start(instance *fmu) {
    unit_run *run = &fmu->run;
    long events;
    begin_time(fmu);
    if (!requirements_are_met(fmu, true) || !requirements_are_met(fmu, false)) {
        return false;
    }
    const tdmf_run_outcome outcome = drive(fmu, run->motion.time, false, NULL, &events);
    if (!has_arrived(outcome)) {
        return refuse_outcome(fmu, outcome);
    }
    run->has_begun = 1;
    show_to_world(fmu);
    if (!is_within_motion(fmu)) {
        return false;
    }
    account_for_all(fmu);
    for (int i = 0; i < UNIT_EVENT_COUNT; ++i) {
        run->watch[i] = (run->motion.late >> i & 1) != 0 ? WATCH_RISING : WATCH_BELOW;
    }
    if (is_exchange(fmu)) {
        take_from_world(fmu);
        complete_step(fmu);
    }
    return true;
}

call_status exit_initialization(instance *fmu) {
    instance begun = *fmu;
    if (fmu->run.settings[SETTING_METHOD] != SOLVER_NATIVE && !tdmf_page_cvode_is_available()) {
        return answer(fmu, CALL_ERROR,
                      "solver.method = cvode is refused: this unit was built without "
                      "SUNDIALS; allowed: native");
    }
    if (!start(&begun)) {
        return answer(fmu, CALL_ERROR, "%s", begun.reason);
    }
    fmu->run = begun.run;
    fmu->run.state = fmu->run.interface == CO_SIMULATION ? STEP_MODE : EVENT_MODE;
    fmu->current = 0;
    return CALL_OK;
}

/* ---- events -------------------------------------------------------------------------------------------- */

/* Records largest values, which an importer's solver shows at its steps only. */
static void observe(instance *fmu) {
    const tdmf_page_instant at = instant_of(fmu);
    tdmf_note_largest(&at, states_in(fmu));
}

void take_immediate_events(instance *fmu) {
    const tdmf_mode_kind *mode = mode_of(fmu);
    for (int i = 0, taken = 0; i < mode->guard_count && taken < TDMF_PAGE_CHAIN_LIMIT; ++i) {
        const tdmf_guard_kind *kind = &mode->guards[i];
        const bool is_immediate = (unit_immediate_events >> kind->event & 1) != 0;
        if (is_immediate && tdmf_is_watched(kind, parameters_of(fmu), states_of(fmu))) {
            tdmf_page_run run = run_of(fmu);
            tdmf_take_event_now(unit_model, kind, &run, fmu->run.watch);
            keep_run(fmu, &run);
            mode = mode_of(fmu);
            i = -1;
            ++taken;
        }
    }
}

double guard_of_pending_event(const instance *fmu, const tdmf_guard_kind **kind) {
    const tdmf_page_instant at = instant_of(fmu);
    for (int i = 0; i < at.mode->guard_count; ++i) {
        *kind = &at.mode->guards[i];
        if ((*kind)->event == fmu->run.event) {
            double value, rate;
            tdmf_page_guard(&at, i, &value, &rate);
            return value / at.event_scales[fmu->run.event];
        }
    }
    return INFINITY;
}

/* Takes the pending event, unless values that were set since it was found avert it. */
static bool take_pending_event(instance *fmu) {
    if (!fmu->run.event_is_pending) {
        return false;
    }
    const bool is_changed = memcmp(fmu->run.motion.numbers, fmu->run.accounted, sizeof fmu->run.accounted);
    const tdmf_guard_kind *kind;
    fmu->run.event_is_pending = 0;
    account_for_jumps(fmu);
    const double guard = guard_of_pending_event(fmu, &kind);
    if (isinf(guard) || (is_changed && guard > rounding_at_event)) {
        return false;
    }
    const unit_motion before = fmu->run.motion;
    tdmf_page_run run = run_of(fmu);
    const tdmf_event_row row = tdmf_take_event_now(unit_model, kind, &run, fmu->run.watch);
    keep_run(fmu, &run);
    account_for_all(fmu);
    if (logs_events(fmu)) {
        report(fmu, &row, before.numbers + UNIT_PARAMETER_COUNT, &row, states_of(fmu));
    }
    return true;
}

/* Restores states that an event has made NaN, because of a trial state. */
static void keep_numbers(instance *fmu, const unit_run *begun) {
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        const int place = UNIT_PARAMETER_COUNT + unit_states[i].index;
        double *number = &fmu->run.motion.numbers[place];
        *number = isnan(*number) ? begun->motion.numbers[place] : *number;
    }
}

/* Takes all events that are due. If they are refused, the run is as it was. */
static bool take_events(instance *fmu, bool *state_changed) {
    const unit_run begun = fmu->run;
    bool is_resolved;
    bool changed = take_pending_event(fmu) | (fmu->run.has_jumped != 0);
    fmu->run.has_jumped = 0;
    changed |= account_for_jumps(fmu);
    if (is_exchange(fmu)) {
        tdmf_chain chain;
        observe(fmu);
        is_resolved = settle(fmu, logs_events(fmu), &chain);
        observe(fmu);
        changed |= chain.count > 0;
    } else {
        long events;
        is_resolved = has_arrived(drive(fmu, fmu->run.motion.time, logs_events(fmu), NULL, &events));
        changed |= events > 0;
    }
    if (changed) {
        show_to_world(fmu);
        if (is_exchange(fmu)) {
            keep_numbers(fmu, &begun);
            take_from_world(fmu); /* the importer's states are the ones that count */
        }
        account_for_all(fmu);
    }
    *state_changed = changed;
    if (!is_resolved) {
        refuse(fmu, "the events at this instant do not come to an end");
    } else if (is_within_motion(fmu)) {
        return true;
    }
    fmu->run = begun;
    return false;
}

call_status enter_event_mode(instance *fmu) {
    if (is_exchange(fmu)) {
        observe(fmu);
        fmu->run.has_jumped |= account_for_drifts(fmu);
    }
    fmu->run.state = EVENT_MODE;
    fmu->current = 0;
    return CALL_OK;
}

/* Discards the view. A call that did not succeed ends the run: the reason is reported. */
static call_status conclude_call(instance *fmu, bool succeeded) {
    fmu->current = 0;
    if (succeeded) {
        return CALL_OK;
    }
    fmu->run.state = FAILED;
    return answer(fmu, CALL_ERROR, "%s", fmu->reason);
}

/* The longest step of an importer's solver is reported as a time event, which no solver steps over. */
call_status update_discrete_states(instance *fmu, discrete_update *update) {
    const call_status status = conclude_call(fmu, take_events(fmu, &update->states_changed));
    if (status == CALL_OK && is_exchange(fmu)) {
        const tdmf_mode_kind *mode = mode_of(fmu);
        const double longest = tdmf_longest_step_of_law(mode, parameters_of(fmu), states_of(fmu));
        update->terminate = mode->ends && fmu->run.settings[SETTING_TERMINATES] != 0.0;
        update->next_time_defined = isfinite(longest);
        update->next_time = update->next_time_defined ? fmu->run.time + longest : 0.0;
    }
    return status;
}

/* ---- Model Exchange ------------------------------------------------------------------------------------ */

bool complete_step(instance *fmu) {
    const tdmf_page_instant at = instant_of(fmu);
    guard_state guards[TDMF_GUARD_LIMIT];
    bool asks = quantity_has_jumped(fmu);
    tdmf_view_guards(&at, fmu->run.watch, guards);
    tdmf_note_guards(&at, guards, fmu->run.watch);
    tdmf_note_largest(&at, states_in(fmu));
    if (!asks) {
        account_for_all(fmu);
    }
    for (int i = 0; i < at.mode->guard_count; ++i) {
        asks |= guards[i].is_due; /* an importer passed over the guard, or an input lets it be watched */
    }
    fmu->current = 0;
    return asks;
}

call_status set_time(instance *fmu, double time) {
    if (!is_time(time)) {
        return answer(fmu, CALL_ERROR, "the time is not finite or beyond 1e100 s");
    }
    set_clocks(fmu, time);
    fmu->current = 0;
    return CALL_OK;
}

/* Trial states of a solver are limited, so that all values stay finite. */
call_status set_states(instance *fmu, const double states[], size_t count) {
    if (!array_is_given(fmu, states, count, UNIT_CONTINUOUS_COUNT)) {
        return CALL_ERROR;
    }
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        if (isnan(states[i])) {
            return answer(fmu, CALL_DISCARD, "a state is not a number");
        }
    }
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        states_in(fmu)[unit_states[i].index] = within_largest(states[i]);
    }
    take_from_world(fmu);
    fmu->current = 0;
    return CALL_OK;
}

/* ---- Co-Simulation ------------------------------------------------------------------------------------- */

/* True unless a ramp has brought an input out of its range. */
static bool inputs_are_in_range(instance *fmu) {
    char refusal[TEXT_CAPACITY];
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmu_variable *input = &fmu_variables[i];
        const double *rate = input->storage == STORED_INPUT ? rate_in(fmu, input) : NULL;
        if (rate != NULL && *rate != 0.0 && !is_allowed(fmu, input, number_of(fmu, input))) {
            memcpy(refusal, fmu->reason, sizeof refusal);
            return refuse(fmu, "its rate brings an input out of range: %.200s", refusal);
        }
    }
    return true;
}

/* Completes a run that the driver has brought to its end or to `until`. A run that has ended stays readable,
 * frozen. */
static bool arrive(instance *fmu, tdmf_run_outcome outcome, double until) {
    const double rest = until - fmu->run.epoch - fmu->run.motion.time;
    for (int i = 0; outcome == TDMF_RUN_ENDED && i < UNIT_STATE_COUNT; ++i) {
        const int rate = unit_input_rates[i];
        states_in(fmu)[i] += rate >= 0 ? states_of(fmu)[rate] * rest : 0.0;
    }
    if (!has_arrived(outcome)) {
        return refuse_outcome(fmu, outcome);
    }
    if (outcome != TDMF_RUN_ENDED && !inputs_are_in_range(fmu)) {
        return false;
    }
    set_clocks(fmu, until);
    return true;
}

/* Moves the run on to `until`, or to the first event on the way that counts: at its exact time, before it is
 * taken. A jump of an input is no event of this step. */
static bool advance(instance *fmu, double until, bool stops_at_event) {
    const unit_run begun = fmu->run;
    tdmf_event_row stop;
    bool changed, succeeded = true;
    long events;
    if (!stops_at_event) {
        take_pending_event(fmu);
        account_for_jumps(fmu);
    } else if (!take_events(fmu, &changed)) {
        return false;
    }
    const tdmf_run_outcome outcome = drive(fmu, until - fmu->run.epoch, !stops_at_event && logs_events(fmu),
                                           stops_at_event ? &stop : NULL, &events);
    if (outcome == TDMF_RUN_STOPPED) {
        fmu->run.time = fmu->run.epoch + fmu->run.motion.time;
        fmu->run.event_is_pending = 1;
        fmu->run.event = stop.event;
    } else {
        succeeded = arrive(fmu, outcome, until);
    }
    if (succeeded) {
        show_to_world(fmu);
        succeeded = is_within_motion(fmu);
    }
    if (succeeded) {
        account_for_all(fmu);
    } else {
        fmu->run = begun;
    }
    return succeeded;
}

/* Error that is tolerated in the times of importers, which add them up or scale them: rounding, and a share
 * of the step. */
static double clock_rounding(double time, double step) {
    return 16.0 * DBL_EPSILON * fabs(time) + 1e-6 * step;
}

call_status make_step(instance *fmu, double time, double step, bool stop_at_event) {
    char length[NUMBER_CAPACITY], clock[NUMBER_CAPACITY];
    if (!(step > 0.0 && is_time(time + step))) {
        return answer(fmu, CALL_ERROR, "the step is not a positive number");
    }
    if (!(time + step > time)) {
        return answer(fmu, CALL_ERROR, "a step of %s s is lost in the rounding of the time, %s s",
                      number_text(step, length), number_text(time, clock));
    }
    const double allowed = clock_rounding(time, step);
    if (!(fabs(time - fmu->run.time) <= allowed)) {
        return answer(fmu, CALL_ERROR, "the communication point is not where the last step ended");
    }
    if (time + step > fmu->run.stop_time + allowed) {
        return answer(fmu, CALL_ERROR, "the step goes beyond the stop time, %s s",
                      number_text(fmu->run.stop_time, clock));
    }
    return conclude_call(fmu, advance(fmu, time + step, stop_at_event));
}
