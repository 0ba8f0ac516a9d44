/* A run of any page: its start, events in Model Exchange, and the driver's work in Co-Simulation. */
#include "jumps.h"

#include "run_state.h"
#include "variables.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LOG_SIZE = 32 };

static const long step_limit = 1000000, event_limit = 100000; /* of a call */
static const double finest_tolerance = 1e-16;

bool fmu_create(fmu *fmu, bool is_exchange) {
    fmu->is_exchange = is_exchange;
    fmu->memory = malloc(instant_size() * sizeof *fmu->memory);
    return fmu->memory != NULL;
}

void fmu_free(fmu *fmu) {
    free(fmu->memory);
}

void fmu_reset(fmu *fmu) {
    const struct fmu kept = {
        .is_exchange = fmu->is_exchange,
        .memory = fmu->memory,
        .settings =
            {[SETTING_TOLERANCE] = 1e-11, [SETTING_TERMINATES] = 1.0, [SETTING_METHOD] = SOLVER_NATIVE},
        .importer_tolerance = INFINITY,
        .stop_time = INFINITY};
    *fmu = kept;
    memcpy(parameters_of(fmu), unit_model->parameter_defaults, UNIT_PARAMETER_COUNT * sizeof(double));
    memcpy(states_of(fmu), unit_model->state_defaults, UNIT_STATE_COUNT * sizeof(double));
    memcpy(fmu->starts, unit_model->state_defaults, UNIT_STATE_COUNT * sizeof(double));
}

const char *fmu_prepare(fmu *fmu, char text[FMU_TEXT]) {
    (void)fmu, (void)text;
    return NULL; /* parameters are in force as they are */
}

bool fmu_has_begun(const fmu *fmu) {
    return fmu->has_begun;
}

double fmu_time(const fmu *fmu) {
    return fmu->motion.time;
}

void fmu_set_time(fmu *fmu, double time) {
    fmu->motion.time = time;
    fmu->motion.time_rest = 0.0;
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        if (unit_is_clock[i]) {
            states_of(fmu)[i] = time;
        }
    }
}

bool fmu_has_solver(const fmu *fmu) {
    return fmu->settings[SETTING_METHOD] == SOLVER_NATIVE;
}

bool fmu_asks_to_terminate(const fmu *fmu) {
    return fmu->is_exchange && mode_of(fmu)->ends && fmu->settings[SETTING_TERMINATES] != 0.0;
}

double fmu_longest_step(const fmu *fmu) {
    return tdmf_longest_step_of_law(mode_of(fmu), parameters_of(fmu), states_of(fmu));
}

/* ---- the driver ---------------------------------------------------------------------------------------- */

static tdmf_page_run run_of(fmu *fmu) {
    const page_motion *motion = &fmu->motion;
    const double wanted = fmin(fmu->settings[SETTING_TOLERANCE], fmu->importer_tolerance);
    const double tolerance = fmax(wanted, finest_tolerance);
    const tdmf_page_run run = {.p = parameters_of(fmu),
                               .x = states_of(fmu),
                               .memory = fmu->memory,
                               .time = motion->time,
                               .time_rest = motion->time_rest,
                               .mode = motion->mode,
                               .chain = motion->chain,
                               .taken = motion->taken,
                               .above = motion->above,
                               .late = motion->late,
                               .tolerance = tolerance,
                               .order = tdmf_page_order(tolerance),
                               .stop_event = -1,
                               .observes = TDMF_OBSERVE_USUAL,
                               .step_limit = step_limit,
                               .event_limit = event_limit};
    return run;
}

static void keep_run(fmu *fmu, const tdmf_page_run *run) {
    page_motion *motion = &fmu->motion;
    motion->time = run->time;
    motion->time_rest = run->time_rest;
    motion->mode = run->mode;
    motion->chain = run->chain;
    motion->taken = run->taken;
    motion->above = run->above;
    motion->late = run->late;
    fmu->steps += run->steps;
}

static bool is_counted(const tdmf_event_row *row) {
    const tdmf_mode_kind *before = &unit_model->modes[row->before];
    for (int i = 0; i < before->guard_count; ++i) {
        if (before->guards[i].event == row->event) {
            return before->guards[i].is_counted || unit_model->modes[row->after].ends;
        }
    }
    return false;
}

static void append(char text[FMU_TEXT], const char *word) {
    const size_t length = strlen(text);
    snprintf(text + length, FMU_TEXT - length, "%s%s", length > 0 ? ", " : "", word);
}

/* Writes the name of a mode in messages: its enumerations, else its name in the page. */
static void describe(const fmu *fmu, int mode, const double *x, char text[FMU_TEXT]) {
    double outputs[UNIT_OUTPUT_COUNT + 1];
    text[0] = '\0';
    unit_model->modes[mode].outputs(parameters_of(fmu), x, outputs);
    for (int i = 0; i < UNIT_ENUMERATION_COUNT; ++i) {
        const unit_enumeration *of = &unit_enumerations[i];
        append(text, of->names[(int)outputs[of->output] - 1]);
    }
    if (text[0] == '\0' || unit_model->modes[mode].ends) {
        append(text, unit_model->mode_names[mode]);
    }
}

/* Reports events at one instant, with the states before the first and after the last of them. */
static void report(const fmu *fmu, const fmu_observer *observer, const tdmf_event_row *first,
                   const double *before, const tdmf_event_row *last, const double *after) {
    char text[3 * FMU_TEXT], old_mode[FMU_TEXT], new_mode[FMU_TEXT], time[TIME_CAPACITY];
    describe(fmu, first->before, before, old_mode);
    describe(fmu, last->after, after, new_mode);
    snprintf(text, sizeof text, "%s at %s s: %s -> %s", unit_event_names[first->event],
             time_text(first->time, time), old_mode, new_mode);
    if (is_counted(first) || strcmp(old_mode, new_mode) != 0) {
        observer->on_event(observer->subject, text);
    }
}

/* Reports the events of a log, those of one instant together. */
static void report_log(const fmu *fmu, const fmu_observer *observer, const tdmf_page_run *run) {
    for (int i = 0, next; i < run->log_count; i = next) {
        for (next = i + 1; next < run->log_count && run->log[next].time == run->log[i].time; ++next) {
        }
        const double *before = run->log_states + i * UNIT_STATE_COUNT;
        const double *after = next < run->log_count ? run->log_states + next * UNIT_STATE_COUNT : run->x;
        report(fmu, observer, &run->log[i], before, &run->log[next - 1], after);
    }
}

static bool has_arrived(tdmf_run_outcome outcome) {
    return outcome == TDMF_RUN_ARRIVED || outcome == TDMF_RUN_ENDED;
}

/* Runs the driver, and reports every event if there is an observer. `events` receives the number of events.
 */
static tdmf_run_outcome drive(fmu *fmu, double until, const fmu_observer *observer, long *events) {
    const bool is_observed = observer->on_event != NULL;
    tdmf_run_outcome outcome;
    tdmf_event_row log[LOG_SIZE];
    double states[LOG_SIZE * (UNIT_STATE_COUNT + 1)];
    *events = 0;
    do {
        tdmf_page_run run = run_of(fmu);
        run.log = log;
        run.log_states = states;
        run.log_size = is_observed ? LOG_SIZE : 0;
        run.event_limit = is_observed ? LOG_SIZE : event_limit;
        outcome = tdmf_page_run_to(unit_model, &run, until);
        keep_run(fmu, &run);
        *events += run.events;
        report_log(fmu, observer, &run);
    } while (is_observed && outcome == TDMF_RUN_TOO_MANY_EVENTS && *events < event_limit);
    return outcome;
}

static const char *message(fmu *fmu, tdmf_run_outcome outcome, char text[FMU_TEXT]) {
    const tdmf_page_run run = run_of(fmu);
    tdmf_run_message(unit_model, &run, outcome, text, FMU_TEXT);
    return text;
}

/* ---- events of Model Exchange -------------------------------------------------------------------------- */

/* Largest values, which an importer's solver shows at its steps only. */
static void observe(fmu *fmu) {
    const tdmf_page_instant at = instant_of(fmu);
    tdmf_note_largest(&at, states_of(fmu));
}

/* Takes the events that are due, until none is. False where they do not come to an end. */
static bool settle(fmu *fmu, const fmu_observer *observer, bool *changed) {
    const page_motion before = fmu->motion;
    tdmf_page_run run = run_of(fmu);
    tdmf_chain chain;
    const bool is_settled =
        tdmf_take_due_events(unit_model, &run, fmu->watch, memory_of_instant(fmu), &chain);
    keep_run(fmu, &run);
    *changed |= chain.count > 0;
    if (is_settled && chain.count > 0 && observer->on_event != NULL) {
        report(fmu, observer, &chain.first, before.numbers + UNIT_PARAMETER_COUNT, &chain.last,
               states_of(fmu));
    }
    return is_settled;
}

bool fmu_complete_step(fmu *fmu) {
    const tdmf_page_instant at = instant_of(fmu);
    guard_state guards[TDMF_GUARD_LIMIT];
    bool asks = false;
    tdmf_view_guards(&at, fmu->watch, guards);
    tdmf_note_guards(&at, guards, fmu->watch);
    tdmf_note_largest(&at, states_of(fmu));
    for (int i = 0; i < at.mode->guard_count; ++i) {
        asks |= guards[i].is_due; /* where an importer has passed over it, or an input lets it be watched */
    }
    if (quantity_has_jumped(fmu)) {
        return true;
    }
    account_for_all(fmu);
    return asks;
}

void fmu_enter_event_mode(fmu *fmu) {
    if (fmu->is_exchange) {
        observe(fmu);
        fmu->has_jumped |= account_for_drifts(fmu);
    }
}

/* ---- events ahead of Co-Simulation with event mode ----------------------------------------------------- */

/* Takes the event at which the run stands, unless something was set since: then the driver decides. */
static bool take_pending_event(fmu *fmu, const fmu_observer *observer) {
    if (!fmu->event_is_pending) {
        return false;
    }
    fmu->event_is_pending = false;
    if (memcmp(fmu->motion.numbers, fmu->event_numbers, sizeof fmu->event_numbers) != 0) {
        return false;
    }
    const tdmf_event_row row = {fmu->motion.time, fmu->event, fmu->motion.mode, fmu->after_event.mode};
    const page_motion before = fmu->motion;
    fmu->motion = fmu->after_event;
    account_for_all(fmu);
    if (observer->on_event != NULL) {
        report(fmu, observer, &row, before.numbers + UNIT_PARAMETER_COUNT, &row, states_of(fmu));
    }
    return true;
}

fmu_resolution fmu_update(fmu *fmu, const fmu_observer *observer) {
    fmu_resolution found = {false, false};
    bool changed = take_pending_event(fmu, observer) | fmu->has_jumped;
    fmu->has_jumped = false;
    changed |= account_for_jumps(fmu);
    if (fmu->is_exchange) {
        observe(fmu);
        found.unresolved = !settle(fmu, observer, &changed);
        observe(fmu);
    } else {
        long events;
        found.unresolved = !has_arrived(drive(fmu, fmu->motion.time, observer, &events));
        changed |= events > 0;
    }
    if (changed) {
        show_to_world(fmu);
        if (fmu->is_exchange) {
            take_from_world(fmu); /* what follows is then that of the states as the importer has them */
        }
        account_for_all(fmu);
    }
    found.state_changed = changed;
    return found;
}

/* ---- Co-Simulation ------------------------------------------------------------------------------------- */

/* An input that its ramp has brought out of its range; NULL: there is none. */
static const char *input_out_of_range(const fmu *fmu, char text[FMU_TEXT]) {
    char refusal[FMU_TEXT];
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmu_variable *input = &fmu_variables[i];
        if (input->storage == STORED_INPUT && fmu_get_number_rate(fmu, input) != 0.0 &&
            fmu_refuse_value(input, fmu_get_number(fmu, NULL, input), refusal) != NULL) {
            snprintf(text, FMU_TEXT, "its rate brings an input out of range: %.200s", refusal);
            return text;
        }
    }
    return NULL;
}

/* Completes a run that the driver has brought to its end or to `until`. */
static const char *conclude(fmu *fmu, tdmf_run_outcome outcome, double until, char text[FMU_TEXT]) {
    if (outcome == TDMF_RUN_ENDED) {
        for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
            const int rate = unit_input_rates[i];
            states_of(fmu)[i] += rate >= 0 ? states_of(fmu)[rate] * (until - fmu->motion.time) : 0.0;
        }
        fmu_set_time(fmu, until);
    }
    show_to_world(fmu);
    account_for_all(fmu);
    if (outcome == TDMF_RUN_ARRIVED && input_out_of_range(fmu, text) != NULL) {
        return text;
    }
    return has_arrived(outcome) ? NULL : message(fmu, outcome, text);
}

const char *fmu_advance(fmu *fmu, double until, const fmu_observer *observer, char text[FMU_TEXT]) {
    long events;
    take_pending_event(fmu, observer);
    account_for_jumps(fmu);
    const tdmf_run_outcome outcome = drive(fmu, until, observer, &events);
    return conclude(fmu, outcome, until, text);
}

const char *fmu_advance_to_event(fmu *fmu, double until, const fmu_observer *observer, char text[FMU_TEXT]) {
    fmu_update(fmu, observer); /* an input may have jumped, which is no event of this step */
    struct fmu ahead = *fmu;
    double states[UNIT_STATE_COUNT + 1];
    page_motion before;
    tdmf_event_row row;
    tdmf_run_outcome outcome;
    bool counted;
    long left = event_limit;
    do {
        before = ahead.motion;
        tdmf_page_run run = run_of(&ahead);
        run.log = &row;
        run.log_states = states;
        run.log_size = 1;
        run.event_limit = 1;
        outcome = tdmf_page_run_to(unit_model, &run, until);
        keep_run(&ahead, &run);
        counted = run.log_count > 0 && is_counted(&row);
    } while (outcome == TDMF_RUN_TOO_MANY_EVENTS && !counted && --left > 0);
    if (!counted) {
        *fmu = ahead;
        return conclude(fmu, outcome, until, text);
    }
    fmu->steps = ahead.steps;
    fmu->motion = before;
    memcpy(states_of(fmu), states, UNIT_STATE_COUNT * sizeof *states);
    fmu->motion.time = row.time;
    fmu->motion.time_rest = 0.0;
    fmu->motion.taken = 0;
    fmu->motion.chain = 0;
    fmu->motion.above |= (uint64_t)1 << row.event;
    show_to_world(fmu);
    account_for_all(fmu);
    fmu->event_is_pending = true;
    fmu->event = row.event;
    fmu->after_event = ahead.motion;
    memcpy(fmu->event_numbers, fmu->motion.numbers, sizeof fmu->event_numbers);
    return NULL;
}

/* ---- the start ----------------------------------------------------------------------------------------- */

/* Puts start values in coordinates other than the world's into the states. */
static void apply_starts(fmu *fmu) {
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        if (fmu_variables[i].storage == STORED_START) {
            states_of(fmu)[fmu_variables[i].offset] = fmu->starts[fmu_variables[i].offset];
        }
    }
}

static const char *unmet_requirement(const fmu *fmu, char text[FMU_TEXT]) {
    for (int i = 0; i < UNIT_REQUIREMENT_COUNT; ++i) {
        const unit_requirement *row = &unit_requirements[i];
        if (!(row->margin(parameters_of(fmu), states_of(fmu)) >= 0.0)) {
            const fmu_variable *of = &fmu_variables[row->variable];
            char value[TIME_CAPACITY];
            snprintf(text, FMU_TEXT, "%s = %s%s%s is refused: it must be %s", of->name,
                     time_text(fmu_get_number(fmu, NULL, of), value), of->unit == NULL ? "" : " ",
                     of->unit == NULL ? "" : of->unit, row->allowed);
            return text;
        }
    }
    return NULL;
}

const char *fmu_start(fmu *fmu, char text[FMU_TEXT]) {
    struct fmu ready = *fmu;
    const fmu_observer nobody = {NULL, NULL};
    long events;
    apply_starts(&ready);
    if (unmet_requirement(&ready, text) != NULL) {
        return text;
    }
    fmu_set_time(&ready, ready.motion.time);
    const tdmf_run_outcome outcome = drive(&ready, ready.motion.time, &nobody, &events);
    if (!has_arrived(outcome)) {
        return message(&ready, outcome, text);
    }
    ready.has_begun = true;
    show_to_world(&ready);
    account_for_all(&ready);
    for (int i = 0; i < UNIT_EVENT_COUNT; ++i) {
        ready.watch[i] = (ready.motion.late >> i & 1) != 0 ? WATCH_RISING : WATCH_BELOW;
    }
    *fmu = ready;
    if (fmu->is_exchange) {
        take_from_world(fmu);
        fmu_complete_step(fmu);
    }
    return NULL;
}

void fmu_differentiate_start(const fmu *given, const struct fmu *started, struct fmu *seed,
                             fmu_view *variation) {
    struct fmu begun = *given;
    double shift = 0.0, dx[UNIT_STATE_COUNT + 1], shown[UNIT_STATE_COUNT + 1];
    fmu_set_time(&begun, begun.motion.time);
    fmu_set_time(seed, seed->motion.time);
    apply_starts(&begun);
    apply_starts(seed);
    memcpy(dx, states_of(seed), UNIT_STATE_COUNT * sizeof *dx);
    tdmf_page_run run = run_of(&begun);
    run.seed_count = 1;
    run.dp = parameters_of(seed);
    run.dx = dx;
    run.shift = &shift;
    tdmf_page_run_to(unit_model, &run, run.time);
    vary_at(started, parameters_of(seed), dx, variation);
    memcpy(shown, dx, UNIT_STATE_COUNT * sizeof *dx);
    if (mode_of(started)->vary_to_world != NULL) {
        mode_of(started)->vary_to_world(parameters_of(started), states_of(started), parameters_of(seed), dx,
                                        shown);
    }
    for (int i = 0; i < FMU_STATE_COUNT; ++i) {
        if (!unit_states[i].has_start) { /* the start calculates it */
            states_of(seed)[unit_states[i].index] = shown[unit_states[i].index];
        }
    }
}
