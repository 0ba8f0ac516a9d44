/* Solvers of Co-Simulation on a page, and reports of the events that they take. */
#include "page_cvode.h"
#include "run.h"

#include <stdio.h>
#include <string.h>

enum { LOG_SIZE = 32 };

static const long event_limit = 100000; /* events in a call */
static const long stiff_steps = 10000; /* steps in a time scale of the page; beyond, its laws are too stiff */
static const double finest_tolerance = 1e-16;

static bool is_by_cvode(const instance *fmu) {
    return !is_exchange(fmu) && fmu->run.settings[SETTING_METHOD] == SOLVER_CVODE;
}

/* Sets the page's clock to the time of the motion, which may differ by rounding, and with the clock the times
 * that the page has recorded at this instant. */
static void set_clock(instance *fmu) {
    double *x = states_in(fmu);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        if (unit_clock >= 0 && unit_holds_time[i] && x[i] == x[unit_clock]) {
            x[i] = fmu->run.motion.time;
        }
    }
    if (unit_clock >= 0) {
        x[unit_clock] = fmu->run.motion.time;
    }
}

tdmf_page_run run_of(instance *fmu) {
    const unit_motion *motion = &fmu->run.motion;
    const double wanted = fmin(fmu->run.settings[SETTING_TOLERANCE], fmu->run.importer_tolerance);
    const double tolerance = fmax(wanted, finest_tolerance);
    const tdmf_page_run run = {.p = parameters_in(fmu),
                               .x = states_in(fmu),
                               .memory = fmu->memory,
                               .time = motion->time,
                               .time_rest = motion->time_rest,
                               .mode = motion->mode,
                               .left = motion->shown,
                               .chain = (int)motion->chain,
                               .taken = motion->taken,
                               .above = motion->above,
                               .late = motion->late,
                               .tolerance = tolerance,
                               .order = tdmf_page_order(tolerance),
                               .stop_event = -1,
                               .observes = TDMF_OBSERVE_USUAL,
                               .step_limit = (long)fmu->step_limit,
                               .event_limit = event_limit};
    return run;
}

void keep_run(instance *fmu, const tdmf_page_run *run) {
    unit_motion *motion = &fmu->run.motion;
    motion->time = run->time;
    motion->time_rest = run->time_rest;
    motion->mode = run->mode;
    motion->chain = run->chain;
    motion->taken = run->taken;
    motion->above = run->above;
    motion->late = run->late;
    motion->shown = unit_model->modes[run->mode].keeps_outputs ? run->left : run->mode;
    fmu->run.work[WORK_STEPS] += run->steps;
    fmu->run.work[WORK_EVALUATIONS] += is_by_cvode(fmu) ? 0 : run->steps * run->order;
    fmu->run.work[WORK_LAYER_STEPS] += run->limited_steps;
    set_clock(fmu);
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

static void append(char text[TEXT_CAPACITY], const char *word) {
    const size_t length = strlen(text);
    snprintf(text + length, TEXT_CAPACITY - length, "%s%s", length > 0 ? ", " : "", word);
}

/* Writes the name of a mode in messages: its enumerations, else its name in the page. One that ends the run
 * has the enumerations of the mode `left`. */
static void describe(const instance *fmu, int mode, int left, const double *x, char text[TEXT_CAPACITY]) {
    double outputs[UNIT_OUTPUT_COUNT + 1];
    text[0] = '\0';
    unit_model->modes[unit_model->modes[mode].keeps_outputs ? left : mode].outputs(parameters_of(fmu), x,
                                                                                   outputs);
    for (int i = 0; i < UNIT_ENUMERATION_COUNT; ++i) {
        const unit_enumeration *of = &unit_enumerations[i];
        append(text, of->names[(int)outputs[of->output] - 1]);
    }
    if (text[0] == '\0' || unit_model->modes[mode].ends) {
        append(text, unit_model->mode_names[mode]);
    }
}

/* Reports events at one instant, with the states before the first and after the last of them. */
void report(const instance *fmu, const tdmf_event_row *first, const double *before,
            const tdmf_event_row *last, const double *after) {
    char text[3 * TEXT_CAPACITY], old_mode[TEXT_CAPACITY], new_mode[TEXT_CAPACITY], time[NUMBER_CAPACITY];
    describe(fmu, first->before, first->before, before, old_mode);
    describe(fmu, last->after, last->before, after, new_mode);
    snprintf(text, sizeof text, "%s at %s s: %s -> %s", unit_event_names[first->event],
             number_text(fmu->run.epoch + first->time, time), old_mode, new_mode);
    if (is_counted(first) || strcmp(old_mode, new_mode) != 0) {
        log_event(fmu, text);
    }
}

/* Reports the events of a log, those of one instant together. */
static void report_log(const instance *fmu, const tdmf_page_run *run) {
    for (int i = 0, next; i < run->log_count; i = next) {
        for (next = i + 1; next < run->log_count && run->log[next].time == run->log[i].time; ++next) {
        }
        const double *before = run->log_states + i * UNIT_STATE_COUNT;
        const double *after = next < run->log_count ? run->log_states + next * UNIT_STATE_COUNT : run->x;
        report(fmu, &run->log[i], before, &run->log[next - 1], after);
    }
}

bool has_arrived(tdmf_run_outcome outcome) {
    return outcome == TDMF_RUN_ARRIVED || outcome == TDMF_RUN_ENDED;
}

/* The typical size of a time. */
static double time_scale_of(const instance *fmu) {
    const tdmf_page_instant at = instant_of(fmu);
    return unit_clock >= 0 ? at.scales[unit_clock] : 1.0;
}

/* ---- the driver ---------------------------------------------------------------------------------------- */

/* Moves a run from the page to its part, where the run's mode has the number `mode`. `p` and `x` receive the
 * part's parameters and states. */
static void go_to_part(tdmf_page_run *run, int mode, double *p, double *x) {
    tdmf_take_parameters(unit_part, run->p, p);
    tdmf_take_states(unit_part, run->x, x);
    run->p = p;
    run->x = x;
    run->mode = mode;
    run->taken = tdmf_events_on_part(unit_part, run->taken);
    run->above = tdmf_events_on_part(unit_part, run->above);
    run->late = tdmf_events_on_part(unit_part, run->late);
}

/* Writes the log of a run on the part as one of the page, whose other states are those of `whole`. The rows
 * of the page are wider, so that the last one is written first. */
static void give_log(tdmf_page_run *run, const double *whole) {
    const int count = unit_part->model->state_count;
    double own[UNIT_STATE_COUNT + 1];
    for (int i = run->log_count - 1; i >= 0; --i) {
        tdmf_event_row *row = &run->log[i];
        row->event = tdmf_event_in_whole(unit_part, row->event);
        row->before = tdmf_mode_in_whole(unit_part, row->before);
        row->after = tdmf_mode_in_whole(unit_part, row->after);
        memcpy(own, run->log_states + i * count, (size_t)count * sizeof *own);
        memcpy(run->log_states + i * UNIT_STATE_COUNT, whole, UNIT_STATE_COUNT * sizeof *whole);
        tdmf_give_states(unit_part, own, run->log_states + i * UNIT_STATE_COUNT);
    }
}

/* Moves a run from the part back to the page. `whole` is the run before it was moved to the part. */
static void return_from_part(tdmf_page_run *run, const tdmf_page_run *whole) {
    give_log(run, whole->x);
    tdmf_give_states(unit_part, run->x, whole->x);
    run->p = whole->p;
    run->x = whole->x;
    run->mode = tdmf_mode_in_whole(unit_part, run->mode);
    run->left = run->events > whole->events ? tdmf_mode_in_whole(unit_part, run->left) : whole->left;
    run->taken = tdmf_events_in_whole(unit_part, run->taken);
    run->above = tdmf_events_in_whole(unit_part, run->above);
    run->late = tdmf_events_in_whole(unit_part, run->late);
}

/* Runs the driver up to a limit of steps or events; `run` has its log and its limit of events. A run
 * that takes very many steps in a short time is given up as stiff. The run is on the part of the page if the
 * part has everything that acts. Starts, in the first mode, write states that the part may lack. */
static tdmf_run_outcome drive_on(instance *fmu, double until, tdmf_page_run *run) {
    const tdmf_page_run whole = *run;
    const int mode = unit_part == NULL || run->mode == 0 ? -1 : tdmf_mode_on_part(unit_part, run->mode);
    const bool on_part = mode >= 0 && unit_part->excess(run->p, run->x) == 0.0;
    double p[UNIT_PARAMETER_COUNT + 1], x[UNIT_STATE_COUNT + 1];
    tdmf_run_outcome outcome = TDMF_RUN_TOO_MANY_STEPS;
    if (on_part) {
        go_to_part(run, mode, p, x);
    }
    while (outcome == TDMF_RUN_TOO_MANY_STEPS && run->steps < whole.step_limit) {
        const double began = run->time;
        const long left = whole.step_limit - run->steps;
        run->step_limit = left < stiff_steps ? left : stiff_steps;
        run->event_limit = whole.event_limit - run->events;
        outcome = tdmf_page_run_to(on_part ? unit_part->model : unit_model, run, until);
        const bool goes_on = outcome == TDMF_RUN_TOO_MANY_STEPS && run->steps < whole.step_limit;
        if (goes_on && run->time - began < time_scale_of(fmu)) {
            outcome = TDMF_RUN_TOO_STIFF;
        }
    }
    if (on_part) {
        return_from_part(run, &whole);
    }
    keep_run(fmu, run);
    return outcome;
}

/* Moves the run back to just before an event that it has taken, with the states at that time. */
static void return_to_event(instance *fmu, const unit_motion *before, const tdmf_event_row *row,
                            const double *states) {
    unit_motion *motion = &fmu->run.motion;
    *motion = *before;
    memcpy(states_in(fmu), states, UNIT_STATE_COUNT * sizeof *states);
    motion->time = row->time;
    motion->time_rest = 0.0;
    motion->taken = row->time > before->time ? 0 : motion->taken;
    motion->chain = row->time > before->time ? 0 : motion->chain;
    motion->above |= (uint64_t)1 << row->event;
    set_clock(fmu);
}

/* Reports come from a log, which is read as often as it is full. A stop needs a log of one event. */
static tdmf_run_outcome drive_native(instance *fmu, double until, bool reports, tdmf_event_row *stop,
                                     long *events) {
    const int size = stop != NULL ? 1 : reports ? LOG_SIZE : 0;
    tdmf_run_outcome outcome;
    tdmf_event_row log[LOG_SIZE];
    double states[LOG_SIZE * (UNIT_STATE_COUNT + 1)];
    do {
        const unit_motion before = fmu->run.motion;
        tdmf_page_run run = run_of(fmu);
        run.log = log;
        run.log_states = states;
        run.log_size = size;
        run.event_limit = size > 0 ? size : event_limit;
        outcome = drive_on(fmu, until, &run);
        *events += run.events;
        if (stop != NULL && run.log_count > 0 && is_counted(&log[0])) {
            return_to_event(fmu, &before, &log[0], states);
            *stop = log[0];
            return TDMF_RUN_STOPPED;
        }
        if (reports) {
            report_log(fmu, &run);
        }
    } while (size > 0 && outcome == TDMF_RUN_TOO_MANY_EVENTS && *events < event_limit);
    return outcome;
}

/* ---- CVODE --------------------------------------------------------------------------------------------- */

bool settle(instance *fmu, bool reports, tdmf_chain *chain) {
    const unit_motion before = fmu->run.motion;
    tdmf_page_run run = run_of(fmu);
    const bool is_settled = tdmf_take_due_events(unit_model, &run, fmu->run.watch, fmu->instant, chain);
    keep_run(fmu, &run);
    if (is_settled && chain->count > 0 && reports) {
        report(fmu, &chain->first, before.numbers + UNIT_PARAMETER_COUNT, &chain->last, states_of(fmu));
    }
    return is_settled;
}

static tdmf_run_outcome drive_by_cvode(instance *fmu, double until, bool reports, tdmf_event_row *stop,
                                       long *events) {
    while (*events < event_limit) {
        const unit_run before = fmu->run;
        tdmf_chain chain;
        if (!settle(fmu, reports, &chain)) {
            return TDMF_RUN_ENDLESS_CHAIN;
        }
        if (stop != NULL && chain.count > 0 && (is_counted(&chain.first) || is_counted(&chain.last))) {
            fmu->run = before;
            *stop = chain.first;
            return TDMF_RUN_STOPPED;
        }
        *events += chain.count > 0;
        if (mode_of(fmu)->ends) {
            return TDMF_RUN_ENDED;
        }
        tdmf_page_run run = run_of(fmu);
        show_to_world(fmu);
        const tdmf_run_outcome outcome =
            tdmf_cvode_to_event(unit_model, &run, fmu->run.watch, until, &fmu->run.work[WORK_EVALUATIONS]);
        keep_run(fmu, &run);
        if (outcome != TDMF_RUN_STOPPED) {
            return outcome;
        }
    }
    return TDMF_RUN_TOO_MANY_EVENTS;
}

tdmf_run_outcome drive(instance *fmu, double until, bool reports, tdmf_event_row *stop, long *events) {
    *events = 0;
    return (is_by_cvode(fmu) ? drive_by_cvode : drive_native)(fmu, until, reports, stop, events);
}
