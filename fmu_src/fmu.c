/* A run of any page: its start, events in Model Exchange, and steps of Co-Simulation. */
#include "instance.h"
#include "run.h"
#include "run_state.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const long usual_step_limit = 1000000; /* steps in a call */
const double rounding_at_event = 1e-9;

void fmu_reset(fmu *fmu) {
    const struct fmu kept = {
        .is_exchange = fmu->is_exchange,
        .memory = fmu->memory,
        .instant = fmu->instant,
        .step_limit = usual_step_limit,
        .settings =
            {[SETTING_TOLERANCE] = 1e-11, [SETTING_TERMINATES] = 1.0, [SETTING_METHOD] = SOLVER_NATIVE},
        .importer_tolerance = INFINITY,
        .stop_time = INFINITY};
    *fmu = kept;
    memcpy(parameters_of(fmu), unit_model->parameter_defaults, UNIT_PARAMETER_COUNT * sizeof(double));
    memcpy(states_of(fmu), unit_model->state_defaults, UNIT_STATE_COUNT * sizeof(double));
    memcpy(fmu->starts, unit_model->state_defaults, UNIT_STATE_COUNT * sizeof(double));
}

const char *unmet_requirement(const fmu *fmu, bool of_parameters, char text[FMU_TEXT]) {
    for (int i = 0; i < UNIT_REQUIREMENT_COUNT; ++i) {
        const unit_requirement *row = &unit_requirements[i];
        if (row->of_parameters == of_parameters &&
            !(row->margin(parameters_of(fmu), states_of(fmu)) >= 0.0)) {
            const fmu_variable *of = &fmu_variables[row->variable],
                               *bound = row->bound < 0 ? NULL : &fmu_variables[row->bound];
            fmu_view view;
            char value[VALUE_CAPACITY], limit[VALUE_CAPACITY] = "";
            fmu_evaluate(fmu, &view);
            if (bound != NULL) {
                value_text(bound, fmu_get_number(fmu, &view, bound), limit);
            }
            snprintf(text, FMU_TEXT, "%s = %s is refused: it must be %s%s%s", of->name,
                     value_text(of, fmu_get_number(fmu, &view, of), value), row->allowed,
                     bound != NULL ? " = " : "", limit);
            return text;
        }
    }
    return NULL;
}

void fmu_set_time(fmu *fmu, double time) {
    fmu->time = time;
    fmu->motion.time = time - fmu->epoch;
    fmu->motion.time_rest = 0.0;
    if (unit_clock >= 0) {
        states_of(fmu)[unit_clock] = fmu->motion.time;
    }
}

/* ---- events of Model Exchange -------------------------------------------------------------------------- */

/* Records largest values, which an importer's solver shows at its steps only. */
static void observe(fmu *fmu) {
    const tdmf_page_instant at = instant_of(fmu);
    tdmf_note_largest(&at, states_of(fmu));
}

void take_immediate_events(fmu *fmu) {
    const tdmf_mode_kind *mode = mode_of(fmu);
    for (int i = 0, taken = 0; i < mode->guard_count && taken < TDMF_PAGE_CHAIN_LIMIT; ++i) {
        const tdmf_guard_kind *kind = &mode->guards[i];
        const bool is_immediate = (unit_immediate_events >> kind->event & 1) != 0;
        if (is_immediate && tdmf_is_watched(kind, parameters_of(fmu), states_of(fmu))) {
            tdmf_page_run run = run_of(fmu);
            tdmf_take_event_now(unit_model, kind, &run, fmu->watch);
            keep_run(fmu, &run);
            mode = mode_of(fmu);
            i = -1;
            ++taken;
        }
    }
}

/* The run just after inputs that are 0 have begun to move along a direction: some inputs act from then on. */
static struct fmu moved_along(const fmu *fmu, const struct fmu *seed) {
    struct fmu moved = *fmu;
    double *x = states_of(&moved);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        if (unit_input_rates[i] >= 0 && x[i] == 0.0 && states_of(seed)[i] != 0.0) {
            x[i] = copysign(DBL_MIN, states_of(seed)[i]);
        }
    }
    take_immediate_events(&moved);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        x[i] = unit_input_rates[i] >= 0 ? states_of(fmu)[i] : x[i];
    }
    return moved;
}

void fmu_differentiate(const fmu *fmu, const struct fmu *seed, fmu_view *variation) {
    const struct fmu moved = moved_along(fmu, seed);
    const tdmf_mode_kind *mode = shown_mode_of(&moved);
    const double *dp = parameters_of(seed);
    double dx[UNIT_STATE_COUNT + 1];
    memcpy(dx, states_of(seed), UNIT_STATE_COUNT * sizeof *dx);
    if (mode->vary_from_world != NULL) {
        mode->vary_from_world(parameters_of(fmu), states_of(fmu), dp, states_of(seed), dx);
    }
    vary_at(&moved, dp, dx, variation);
}

bool fmu_complete_step(fmu *fmu) {
    const tdmf_page_instant at = instant_of(fmu);
    guard_state guards[TDMF_GUARD_LIMIT];
    bool asks = false;
    tdmf_view_guards(&at, fmu->watch, guards);
    tdmf_note_guards(&at, guards, fmu->watch);
    tdmf_note_largest(&at, states_of(fmu));
    for (int i = 0; i < at.mode->guard_count; ++i) {
        asks |= guards[i].is_due; /* an importer passed over the guard, or an input lets it be watched */
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

double guard_of_pending_event(const fmu *fmu, const tdmf_guard_kind **kind) {
    const tdmf_page_instant at = instant_of(fmu);
    for (int i = 0; i < at.mode->guard_count; ++i) {
        *kind = &at.mode->guards[i];
        if ((*kind)->event == fmu->event) {
            double value, rate;
            tdmf_page_guard(&at, i, &value, &rate);
            return value / at.event_scales[fmu->event];
        }
    }
    return INFINITY;
}

/* Takes the pending event, unless values that were set since it was found avert it. */
static bool take_pending_event(fmu *fmu, const struct instance *observer) {
    if (!fmu->event_is_pending) {
        return false;
    }
    const bool is_changed = memcmp(fmu->motion.numbers, fmu->accounted, sizeof fmu->accounted) != 0;
    const tdmf_guard_kind *kind;
    fmu->event_is_pending = 0;
    account_for_jumps(fmu);
    const double guard = guard_of_pending_event(fmu, &kind);
    if (isinf(guard) || (is_changed && guard > rounding_at_event)) {
        return false;
    }
    const page_motion before = fmu->motion;
    tdmf_page_run run = run_of(fmu);
    const tdmf_event_row row = tdmf_take_event_now(unit_model, kind, &run, fmu->watch);
    keep_run(fmu, &run);
    account_for_all(fmu);
    if (observer != NULL) {
        report(fmu, observer, &row, before.numbers + UNIT_PARAMETER_COUNT, &row, states_of(fmu));
    }
    return true;
}

/* True if states are larger than those of any motion; `text` receives the name of the first. */
static bool is_beyond_motion(const fmu *fmu, char text[FMU_TEXT]) {
    const char *name = number_out_of_range(fmu->motion.numbers);
    if (name != NULL) {
        snprintf(text, FMU_TEXT, "%.200s is larger than in any motion", name);
    }
    return name != NULL;
}

/* Restores states that an event has made NaN, because of a trial state. */
static void keep_numbers(fmu *fmu, const double states[]) {
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        double *x = &states_of(fmu)[unit_states[i].index];
        *x = isnan(*x) ? states[i] : *x;
    }
}

const char *fmu_update(fmu *fmu, const struct instance *observer, bool *state_changed, char text[FMU_TEXT]) {
    const struct fmu begun = *fmu;
    double states[UNIT_CONTINUOUS_COUNT + 1];
    bool is_resolved;
    fmu_states(fmu, NULL, states);
    bool changed = take_pending_event(fmu, observer) | (fmu->has_jumped != 0);
    fmu->has_jumped = 0;
    changed |= account_for_jumps(fmu);
    if (fmu->is_exchange) {
        tdmf_chain chain;
        observe(fmu);
        is_resolved = settle(fmu, observer, &chain);
        observe(fmu);
        changed |= chain.count > 0;
    } else {
        long events;
        is_resolved = has_arrived(drive(fmu, fmu->motion.time, observer, &events));
        changed |= events > 0;
    }
    if (changed) {
        show_to_world(fmu);
        if (fmu->is_exchange) {
            keep_numbers(fmu, states);
            take_from_world(fmu); /* the importer's states are the ones that count */
        }
        account_for_all(fmu);
    }
    *state_changed = changed;
    if (!is_resolved) {
        snprintf(text, FMU_TEXT, "the events at this instant do not come to an end");
    } else if (!is_beyond_motion(fmu, text)) {
        return NULL;
    }
    *fmu = begun;
    return text;
}

/* ---- Co-Simulation ------------------------------------------------------------------------------------- */

static void write_obstacle(fmu *fmu, tdmf_run_outcome outcome, char text[FMU_TEXT]) {
    const tdmf_page_run run = run_of(fmu);
    tdmf_run_message(unit_model, &run, outcome, text, FMU_TEXT);
}

/* Refuses if a ramp has brought an input out of its range. */
static const char *input_out_of_range(fmu *fmu, char text[FMU_TEXT]) {
    char refusal[FMU_TEXT];
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmu_variable *input = &fmu_variables[i];
        const double *rate = input->storage == STORED_INPUT ? fmu_rate_of(fmu, input) : NULL;
        if (rate != NULL && *rate != 0.0 &&
            fmu_refuse_value(input, fmu_get_number(fmu, NULL, input), refusal) != NULL) {
            snprintf(text, FMU_TEXT, "its rate brings an input out of range: %.200s", refusal);
            return text;
        }
    }
    return NULL;
}

/* Completes a run that the driver has brought to its end or to `until`; otherwise returns to `begun`. */
static const char *conclude(fmu *fmu, const struct fmu *begun, tdmf_run_outcome outcome, double until,
                            char text[FMU_TEXT]) {
    if (outcome == TDMF_RUN_ENDED) {
        for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
            const int rate = unit_input_rates[i];
            states_of(fmu)[i] +=
                rate >= 0 ? states_of(fmu)[rate] * (until - fmu->epoch - fmu->motion.time) : 0.0;
        }
    }
    if (!has_arrived(outcome)) {
        write_obstacle(fmu, outcome, text);
    } else if (outcome == TDMF_RUN_ENDED || input_out_of_range(fmu, text) == NULL) {
        fmu_set_time(fmu, until);
        show_to_world(fmu);
        if (!is_beyond_motion(fmu, text)) {
            account_for_all(fmu);
            return NULL;
        }
    }
    *fmu = *begun;
    return text;
}

const char *fmu_advance(fmu *fmu, double until, bool stops_at_event, const struct instance *observer,
                        char text[FMU_TEXT]) {
    const struct fmu begun = *fmu;
    tdmf_run_outcome outcome;
    tdmf_event_row row;
    long events;
    if (stops_at_event) {
        bool changed; /* a jump of an input is no event of this step */
        if (fmu_update(fmu, observer, &changed, text) != NULL) {
            return text;
        }
        outcome = drive_to_event(fmu, until - fmu->epoch, &row);
    } else {
        take_pending_event(fmu, observer);
        account_for_jumps(fmu);
        outcome = drive(fmu, until - fmu->epoch, observer, &events);
    }
    if (!stops_at_event || outcome != TDMF_RUN_STOPPED) {
        return conclude(fmu, &begun, outcome, until, text);
    }
    show_to_world(fmu);
    if (is_beyond_motion(fmu, text)) {
        *fmu = begun;
        return text;
    }
    fmu->time = fmu->epoch + fmu->motion.time;
    account_for_all(fmu);
    fmu->event_is_pending = 1;
    fmu->event = row.event;
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

const char *fmu_start(fmu *fmu, char text[FMU_TEXT]) {
    struct fmu ready = *fmu;
    long events;
    apply_starts(&ready);
    if (unmet_requirement(&ready, true, text) != NULL || unmet_requirement(&ready, false, text) != NULL) {
        return text;
    }
    ready.epoch = UNIT_CLOCK_IS_RELATIVE ? ready.time : 0.0;
    fmu_set_time(&ready, ready.time);
    const tdmf_run_outcome outcome = drive(&ready, ready.motion.time, NULL, &events);
    if (!has_arrived(outcome)) {
        write_obstacle(&ready, outcome, text);
        return text;
    }
    ready.has_begun = 1;
    show_to_world(&ready);
    if (is_beyond_motion(&ready, text)) {
        return text;
    }
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
    const double shift_of_times = UNIT_CLOCK_IS_RELATIVE ? seed->time : 0.0;
    begun.epoch = UNIT_CLOCK_IS_RELATIVE ? begun.time : 0.0;
    seed->epoch = shift_of_times;
    fmu_set_time(&begun, begun.time);
    fmu_set_time(seed, seed->time);
    apply_starts(&begun);
    apply_starts(seed);
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        double *of_state = &states_of(seed)[unit_states[i].index];
        *of_state = unit_states[i].has_start ? *of_state : 0.0; /* the value that it had does not matter */
    }
    memcpy(dx, states_of(seed), UNIT_STATE_COUNT * sizeof *dx);
    tdmf_page_run run = run_of(&begun);
    run.seed_count = 1;
    run.dp = parameters_of(seed);
    run.dx = dx;
    run.shift = &shift;
    tdmf_page_run_to(unit_model, &run, run.time);
    const struct fmu moved = moved_along(started, seed);
    vary_at(&moved, parameters_of(seed), dx, variation);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        const bool is_time = unit_holds_time[i] && states_of(started)[i] >= 0.0;
        variation->numbers[UNIT_PARAMETER_COUNT + i] += is_time ? shift_of_times : 0.0;
    }
    memcpy(shown, dx, UNIT_STATE_COUNT * sizeof *dx);
    if (mode_of(started)->vary_to_world != NULL) {
        mode_of(started)->vary_to_world(parameters_of(started), states_of(started), parameters_of(seed), dx,
                                        shown);
    }
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        if (!unit_states[i].has_start) { /* the start calculates it */
            states_of(seed)[unit_states[i].index] = shown[unit_states[i].index];
        }
    }
}
