/* Solvers of Co-Simulation on a page, and reports of the events that they take. */
#include "run.h"

#include "instance.h"
#include "page_cvode.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LOG_SIZE = 32 };

static const long event_limit = 100000; /* events in a call */
static const long stiff_steps = 10000; /* steps in a time scale of the page; beyond, its laws are too stiff */
static const double finest_tolerance = 1e-16;

static bool is_by_cvode(const fmu *fmu) {
    return !fmu->is_exchange && fmu->settings[SETTING_METHOD] == SOLVER_CVODE;
}

/* Sets the page's clock to the time of the motion, which may differ by rounding, and with the clock the times
 * that the page has recorded at this instant. */
static void set_clock(fmu *fmu) {
    double *x = states_of(fmu);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        if (unit_clock >= 0 && unit_holds_time[i] && x[i] == x[unit_clock]) {
            x[i] = fmu->motion.time;
        }
    }
    if (unit_clock >= 0) {
        x[unit_clock] = fmu->motion.time;
    }
}

tdmf_page_run run_of(fmu *fmu) {
    const page_motion *motion = &fmu->motion;
    const double wanted = fmin(fmu->settings[SETTING_TOLERANCE], fmu->importer_tolerance);
    const double tolerance = fmax(wanted, finest_tolerance);
    const tdmf_page_run run = {.p = parameters_of(fmu),
                               .x = states_of(fmu),
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

void keep_run(fmu *fmu, const tdmf_page_run *run) {
    page_motion *motion = &fmu->motion;
    motion->time = run->time;
    motion->time_rest = run->time_rest;
    motion->mode = run->mode;
    motion->chain = run->chain;
    motion->taken = run->taken;
    motion->above = run->above;
    motion->late = run->late;
    motion->shown = unit_model->modes[run->mode].keeps_outputs ? run->left : run->mode;
    fmu->work[WORK_STEPS] += run->steps;
    fmu->work[WORK_EVALUATIONS] += is_by_cvode(fmu) ? 0 : run->steps * run->order;
    fmu->work[WORK_LAYER_STEPS] += run->limited_steps;
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

static void append(char text[FMU_TEXT], const char *word) {
    const size_t length = strlen(text);
    snprintf(text + length, FMU_TEXT - length, "%s%s", length > 0 ? ", " : "", word);
}

/* Writes the name of a mode in messages: its enumerations, else its name in the page. One that ends the run
 * has the enumerations of the mode `left`. */
static void describe(const fmu *fmu, int mode, int left, const double *x, char text[FMU_TEXT]) {
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
void report(const fmu *fmu, const struct instance *observer, const tdmf_event_row *first,
            const double *before, const tdmf_event_row *last, const double *after) {
    char text[3 * FMU_TEXT], old_mode[FMU_TEXT], new_mode[FMU_TEXT], time[NUMBER_CAPACITY];
    describe(fmu, first->before, first->before, before, old_mode);
    describe(fmu, last->after, last->before, after, new_mode);
    snprintf(text, sizeof text, "%s at %s s: %s -> %s", unit_event_names[first->event],
             number_text(fmu->epoch + first->time, time), old_mode, new_mode);
    if (is_counted(first) || strcmp(old_mode, new_mode) != 0) {
        log_event(observer, text);
    }
}

/* Reports the events of a log, those of one instant together. */
static void report_log(const fmu *fmu, const struct instance *observer, const tdmf_page_run *run) {
    for (int i = 0, next; i < run->log_count; i = next) {
        for (next = i + 1; next < run->log_count && run->log[next].time == run->log[i].time; ++next) {
        }
        const double *before = run->log_states + i * UNIT_STATE_COUNT;
        const double *after = next < run->log_count ? run->log_states + next * UNIT_STATE_COUNT : run->x;
        report(fmu, observer, &run->log[i], before, &run->log[next - 1], after);
    }
}

bool has_arrived(tdmf_run_outcome outcome) {
    return outcome == TDMF_RUN_ARRIVED || outcome == TDMF_RUN_ENDED;
}

/* The typical size of a time. */
static double time_scale_of(const fmu *fmu) {
    const tdmf_page_instant at = instant_of(fmu);
    return unit_clock >= 0 ? at.scales[unit_clock] : 1.0;
}

/* ---- the driver ---------------------------------------------------------------------------------------- */

/* Writes events and states of a run on the part of the page as those of the page. `states` are those of the
 * whole page at the beginning. The rows of the page are wider, so that the last one is written first. */
static void give_log(tdmf_page_run *run, const double *states) {
    const int count = unit_part->model->state_count;
    double own[UNIT_STATE_COUNT + 1];
    for (int i = run->log_count - 1; i >= 0; --i) {
        tdmf_event_row *row = &run->log[i];
        row->event = tdmf_event_in_whole(unit_part, row->event);
        row->before = tdmf_mode_in_whole(unit_part, row->before);
        row->after = tdmf_mode_in_whole(unit_part, row->after);
        memcpy(own, run->log_states + i * count, (size_t)count * sizeof *own);
        memcpy(run->log_states + i * UNIT_STATE_COUNT, states, UNIT_STATE_COUNT * sizeof *states);
        tdmf_give_states(unit_part, own, run->log_states + i * UNIT_STATE_COUNT);
    }
}

/* Runs the driver on the part of the page, where the mode of the run has the number `mode`. */
static tdmf_run_outcome run_part(tdmf_page_run *whole, int mode, double until) {
    double p[UNIT_PARAMETER_COUNT + 1], x[UNIT_STATE_COUNT + 1];
    tdmf_page_run run = *whole;
    run.p = p;
    run.x = x;
    run.mode = mode;
    run.taken = tdmf_events_on_part(unit_part, whole->taken);
    run.above = tdmf_events_on_part(unit_part, whole->above);
    run.late = tdmf_events_on_part(unit_part, whole->late);
    run.log_count = 0; /* rows that are there are those of the page */
    if (whole->log_count < whole->log_size) {
        run.log += whole->log_count;
        run.log_states += whole->log_count * UNIT_STATE_COUNT;
    }
    run.log_size -= whole->log_count;
    tdmf_take_parameters(unit_part, whole->p, p);
    tdmf_take_states(unit_part, whole->x, x);
    const tdmf_run_outcome outcome = tdmf_page_run_to(unit_part->model, &run, until);
    const bool has_left = run.events > whole->events;
    give_log(&run, whole->x);
    tdmf_give_states(unit_part, x, whole->x);
    run.p = whole->p;
    run.x = whole->x;
    run.mode = tdmf_mode_in_whole(unit_part, run.mode);
    run.left = has_left ? tdmf_mode_in_whole(unit_part, run.left) : whole->left;
    run.taken = tdmf_events_in_whole(unit_part, run.taken);
    run.above = tdmf_events_in_whole(unit_part, run.above);
    run.late = tdmf_events_in_whole(unit_part, run.late);
    run.log = whole->log;
    run.log_states = whole->log_states;
    run.log_size = whole->log_size;
    run.log_count += whole->log_count;
    *whole = run;
    return outcome;
}

/* Runs the driver on the part of the page if the part has everything that acts, else on the page. Starts, in
 * the first mode, write states that the part may lack. */
static tdmf_run_outcome run_page(tdmf_page_run *run, double until) {
    const int mode = unit_part == NULL || run->mode == 0 ? -1 : tdmf_mode_on_part(unit_part, run->mode);
    const bool suits = mode >= 0 && unit_part->excess(run->p, run->x) == 0.0;
    return suits ? run_part(run, mode, until) : tdmf_page_run_to(unit_model, run, until);
}

/* Runs the driver up to a limit of steps or events; `run` has its log and its limit of events. Gives a run up
 * as stiff if it takes very many steps in a short time. */
static tdmf_run_outcome drive_on(fmu *fmu, double until, tdmf_page_run *run) {
    tdmf_run_outcome outcome;
    for (long left = run->step_limit;;) {
        const double began = run->time;
        const long steps = run->steps, events = run->events;
        run->step_limit = left < stiff_steps ? left : stiff_steps;
        outcome = run_page(run, until);
        left -= run->steps - steps;
        run->event_limit -= run->events - events;
        if (outcome != TDMF_RUN_TOO_MANY_STEPS || left <= 0) {
            break;
        }
        if (run->time - began < time_scale_of(fmu)) {
            outcome = TDMF_RUN_TOO_STIFF;
            break;
        }
    }
    keep_run(fmu, run);
    return outcome;
}

/* Runs the driver, and reports every event if there is an observer. `events` receives the number of events.
 */
static tdmf_run_outcome drive_native(fmu *fmu, double until, const struct instance *observer, long *events) {
    const bool is_observed = observer != NULL;
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
        outcome = drive_on(fmu, until, &run);
        *events += run.events;
        report_log(fmu, observer, &run);
    } while (is_observed && outcome == TDMF_RUN_TOO_MANY_EVENTS && *events < event_limit);
    return outcome;
}

bool settle(fmu *fmu, const struct instance *observer, tdmf_chain *chain) {
    const page_motion before = fmu->motion;
    tdmf_page_run run = run_of(fmu);
    const bool is_settled = tdmf_take_due_events(unit_model, &run, fmu->watch, fmu->instant, chain);
    keep_run(fmu, &run);
    if (is_settled && chain->count > 0 && observer != NULL) {
        report(fmu, observer, &chain->first, before.numbers + UNIT_PARAMETER_COUNT, &chain->last,
               states_of(fmu));
    }
    return is_settled;
}

/* Runs to `until`; with `row`, to the first chain of events that counts, which begins with this event and is
 * not taken: TDMF_RUN_STOPPED. */
static tdmf_run_outcome drive_by_cvode(fmu *fmu, double until, const struct instance *observer, long *events,
                                       tdmf_event_row *row) {
    for (*events = 0; *events < event_limit;) {
        const struct fmu before = *fmu;
        tdmf_chain chain;
        if (!settle(fmu, observer, &chain)) {
            return TDMF_RUN_ENDLESS_CHAIN;
        }
        if (row != NULL && chain.count > 0 && (is_counted(&chain.first) || is_counted(&chain.last))) {
            *fmu = before;
            *row = chain.first;
            return TDMF_RUN_STOPPED;
        }
        *events += chain.count > 0;
        if (mode_of(fmu)->ends) {
            return TDMF_RUN_ENDED;
        }
        tdmf_page_run run = run_of(fmu);
        show_to_world(fmu);
        const tdmf_run_outcome outcome =
            tdmf_cvode_to_event(unit_model, &run, fmu->watch, until, &fmu->work[WORK_EVALUATIONS]);
        keep_run(fmu, &run);
        if (outcome != TDMF_RUN_STOPPED) {
            return outcome;
        }
    }
    return TDMF_RUN_TOO_MANY_EVENTS;
}

tdmf_run_outcome drive(fmu *fmu, double until, const struct instance *observer, long *events) {
    return is_by_cvode(fmu) ? drive_by_cvode(fmu, until, observer, events, NULL)
                            : drive_native(fmu, until, observer, events);
}

static tdmf_run_outcome drive_native_to_event(fmu *fmu, double until, tdmf_event_row *row) {
    double states[UNIT_STATE_COUNT + 1];
    tdmf_run_outcome outcome = TDMF_RUN_TOO_MANY_EVENTS;
    for (long left = event_limit; outcome == TDMF_RUN_TOO_MANY_EVENTS && left > 0; --left) {
        const page_motion before = fmu->motion;
        tdmf_page_run run = run_of(fmu);
        run.log = row;
        run.log_states = states;
        run.log_size = 1;
        run.event_limit = 1;
        outcome = drive_on(fmu, until, &run);
        if (run.log_count > 0 && is_counted(row)) {
            fmu->motion = before;
            memcpy(states_of(fmu), states, UNIT_STATE_COUNT * sizeof *states);
            fmu->motion.time = row->time;
            fmu->motion.time_rest = 0.0;
            if (row->time > before.time) {
                fmu->motion.taken = 0;
                fmu->motion.chain = 0;
            }
            fmu->motion.above |= (uint64_t)1 << row->event;
            set_clock(fmu);
            return TDMF_RUN_STOPPED;
        }
    }
    return outcome;
}

tdmf_run_outcome drive_to_event(fmu *fmu, double until, tdmf_event_row *row) {
    long events;
    return is_by_cvode(fmu) ? drive_by_cvode(fmu, until, NULL, &events, row)
                            : drive_native_to_event(fmu, until, row);
}
