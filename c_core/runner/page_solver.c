/* The native solver: the driver of pages, from event to event, with the solver's limits, counters and log. */
#include "page_solver.h"

#include "event_log.h"
#include "run_state.h"

#include <limits.h>
#include <math.h>
#include <string.h>

tdmf_guard tdmf_guard_of_event(int event) {
    switch (event) {
    case EVENT_new_ground:
        return TDMF_GUARD_NEW_GROUND;
    case EVENT_falls:
        return TDMF_GUARD_BODY_DOWN;
    case EVENT_collapses:
        return TDMF_GUARD_LEG_TOO_SHORT;
    case EVENT_apex:
    case EVENT_apex_in_graze:
        return TDMF_GUARD_APEX;
    case EVENT_touchdown:
        return TDMF_GUARD_TOUCHDOWN;
    case EVENT_clamp:
    case EVENT_release:
        return TDMF_GUARD_CLAMP;
    case EVENT_greatest_compression:
        return TDMF_GUARD_GREATEST_COMPRESSION;
    case EVENT_mid_stance:
        return TDMF_GUARD_MID_STANCE;
    case EVENT_lift_off:
        return TDMF_GUARD_LIFT_OFF;
    case EVENT_slips_forward:
        return TDMF_GUARD_SLIP_ONSET_POSITIVE;
    case EVENT_slips_backward:
        return TDMF_GUARD_SLIP_ONSET_NEGATIVE;
    case EVENT_comes_to_rest:
        return TDMF_GUARD_SLIP_VELOCITY_ZERO;
    case EVENT_crosses_border:
        return TDMF_GUARD_PATCH_BORDER;
    case EVENT_graze_to_contact:
        return TDMF_GUARD_GRAZE_TO_CONTACT;
    case EVENT_graze_to_flight:
        return TDMF_GUARD_GRAZE_TO_FLIGHT;
    default:
        return TDMF_GUARD_COUNT;
    }
}

/* An endless chain is one of events if no step was made in it, else one of steps too short for the clock. */
static tdmf_outcome outcome_of(const tdmf_page_solver *s, tdmf_run_outcome outcome) {
    switch (outcome) {
    case TDMF_RUN_ARRIVED:
    case TDMF_RUN_STOPPED:
        return TDMF_ARRIVED;
    case TDMF_RUN_ENDED:
        return TDMF_FELL;
    case TDMF_RUN_TOO_MANY_STEPS:
        return TDMF_TOO_MANY_STEPS;
    case TDMF_RUN_ENDLESS_CHAIN:
        return s->run.run.steps > s->chain_began ? TDMF_TOO_STIFF : TDMF_TOO_MANY_EVENTS;
    case TDMF_RUN_TOO_MANY_EVENTS:
        return TDMF_TOO_MANY_EVENTS;
    default:
        return TDMF_NO_PROGRESS;
    }
}

void tdmf_begin_page_solver(tdmf_page_solver *s, tdmf_solver *solver, tdmf_system system,
                            const tdmf_page_point *point, bool is_plain) {
    s->solver = solver;
    s->system = system;
    s->motion = NULL;
    s->point = *point;
    tdmf_begin_runner_run(&s->run, point, is_plain);
    s->last_mode = point->mode;
    s->span_began = point->time;
    s->chain_began = 0;
    s->has_stopped = s->stays_on_guard = s->has_event = s->is_counted = false;
    tdmf_page_run *r = &s->run.run;
    r->tolerance = solver->relative_tolerance;
    r->order = tdmf_page_order(r->tolerance);
    r->observes = solver->without_peaks_and_positive_work ? TDMF_OBSERVE_NOTHING : TDMF_OBSERVE_USUAL;
    r->dp = s->dp;
    r->dx = s->dx;
    r->shift = s->shift;
}

void tdmf_add_direction(tdmf_page_solver *s, const tdmf_page_direction *direction) {
    tdmf_page_run *r = &s->run.run;
    const int i = r->seed_count++;
    r->observes = TDMF_OBSERVE_USUAL;
    s->shift[i] = 0.0;
    tdmf_take_parameters(s->run.page, &direction->p, s->dp + i * s->run.page->model->parameter_count);
    tdmf_take_states(s->run.page, &direction->x, s->dx + i * s->run.page->model->state_count);
}

tdmf_page_direction tdmf_direction_at_end(const tdmf_page_solver *s, int i) {
    tdmf_page_direction direction;
    memset(&direction, 0, sizeof direction);
    tdmf_give_parameters(s->run.page, s->dp + i * s->run.page->model->parameter_count, &direction.p);
    tdmf_give_states(s->run.page, s->dx + i * s->run.page->model->state_count, &direction.x);
    return direction;
}

/* ---- the log ------------------------------------------------------------------------------------------- */

/* The motion at an instant of the run. */
static tdmf_motion motion_at(const tdmf_page_solver *s, const tdmf_runner_run *run) {
    tdmf_motion motion = *s->motion;
    tdmf_page_point point = s->point;
    tdmf_end_runner_run(run, &point);
    tdmf_motion_of_page(s->system, &point, s->last_mode, &motion);
    return motion;
}

static void report_event(tdmf_page_solver *s) {
    if (s->has_event) {
        tdmf_log_event(s->solver, &s->event);
    }
    s->has_event = false;
}

/* TDMF_GUARD_COUNT, too, for a thrust of 0, which changes nothing. */
static tdmf_guard guard_of_row(const tdmf_page_solver *s, const tdmf_event_row *row) {
    const int event = tdmf_event_in_whole(s->run.page, row->event);
    const bool thrusts = s->point.p.thrust + s->point.p.more_thrust > 0.0;
    return event == EVENT_greatest_compression && !thrusts ? TDMF_GUARD_COUNT : tdmf_guard_of_event(event);
}

static bool is_at_start(const tdmf_page_solver *s) {
    return s->run.run.time == s->point.time && s->run.run.time_rest == s->point.rest;
}

/* A chain in zero time is one event, by the name of its first, from the mode before to the mode after it.
 * Events at the start of a call are not logged. */
static void note_event(tdmf_page_solver *s, const tdmf_runner_run *before, tdmf_guard guard) {
    const tdmf_motion after = motion_at(s, &s->run);
    if (s->run.run.chain > 1 && s->has_event) {
        s->event.after = after.mode;
        return;
    }
    report_event(s);
    tdmf_motion at = motion_at(s, before);
    at.mode.rises |= guard == TDMF_GUARD_APEX; /* before the event */
    const bool has_guard = guard != TDMF_GUARD_CLAMP || at.mode.contact == TDMF_CONTACT_FLIGHT;
    const tdmf_event event = {
        .time = after.time, .guard = (int)guard, .before = at.mode, .after = after.mode};
    s->event = event;
    memcpy(s->event.state, at.state, sizeof event.state);
    s->has_event = guard != TDMF_GUARD_COUNT && has_guard && !is_at_start(s);
}

/* Counts a chain in zero time as one event, unless the call begins with it or all of it is the page's own. */
static void count_event(tdmf_page_solver *s, tdmf_guard guard) {
    s->is_counted &= s->run.run.chain > 1;
    if (!s->is_counted && guard != TDMF_GUARD_COUNT && !is_at_start(s)) {
        s->is_counted = true;
        ++s->solver->events;
        --s->events_left;
    }
}

/* Share of a turn, or of its length, that the leg changes in a step of a stiff law. */
static const double slow_change = 0.01;

/* ---- the run ------------------------------------------------------------------------------------------- */

typedef struct {
    run_state state;
    mode_start at;
    tdmf_driver *driver;
} working_memory;

/* Goes on to the next event. */
static tdmf_run_outcome to_event(tdmf_page_solver *s, working_memory *w, double until) {
    tdmf_page_run *r = &s->run.run;
    const int mode = r->mode;
    const long events = r->events, steps = r->steps;
    const bool notes = s->motion != NULL && (s->solver->log != NULL || s->solver->on_event != NULL);
    tdmf_runner_run before;
    tdmf_event_row row;
    double x_before[TDMF_PAGE_STATE_COUNT];
    r->log = &row;
    r->log_states = notes ? x_before : NULL;
    r->log_count = 0;
    r->log_size = 1;
    const tdmf_run_outcome outcome = tdmf_drive_to_event(w->driver, &w->state, &w->at, until);
    if (tdmf_mode_in_whole(s->run.page, mode) == MODE_slip_falling) {
        s->solver->layer_steps += r->steps - steps;
    }
    if (r->events == events) {
        return outcome;
    }
    if (tdmf_mode_in_whole(s->run.page, r->mode) == MODE_fallen) {
        s->last_mode = tdmf_mode_in_whole(s->run.page, mode);
    }
    const tdmf_guard guard = guard_of_row(s, &row);
    s->chain_began = r->chain > 1 ? s->chain_began : r->steps;
    count_event(s, guard);
    if (notes) {
        before = s->run;
        before.run.mode = mode;
        memcpy(before.x, x_before, sizeof before.x);
        note_event(s, &before, guard);
    }
    return outcome;
}

/* True if a runner has taken too many steps within a unit of time. Begins the next span of steps. */
static bool is_too_stiff(tdmf_page_solver *s) {
    const double time = s->run.run.time;
    const bool is_stiff = time - s->span_began < s->system.model->scales.time;
    s->span_began = time;
    return is_stiff;
}

/* Rate at which the leg turns or changes its length. A fast leg needs short steps without being stiff. */
static double speed_of_leg(const tdmf_page_point *point) {
    runner_states x = point->x;
    tdmf_runner_model.modes[point->mode].to_world((const double *)&point->p, (const double *)&point->x,
                                                  (double *)&x);
    return fmax(fabs(x.angle_rate), fabs(x.length_rate) / x.length);
}

/* The series of flight and stick tells at once whether they are too stiff; slip and graze may be over before
 * it matters. A guard may end the first step sooner. */
static bool begins_too_stiff(const tdmf_page_solver *s, double reach, double until) {
    const bool lasts = s->point.mode == MODE_stick || s->point.mode == MODE_flight_calm;
    const double span = fmin(s->system.model->scales.time, until - s->point.time);
    const bool is_short = lasts && s->run.run.events == 0 && reach * TDMF_STIFFNESS_LIMIT < span;
    return is_short && reach * speed_of_leg(&s->point) < slow_change;
}

static void count_work(tdmf_solver *solver, const tdmf_page_run *r, long steps_before) {
    solver->steps += r->steps - steps_before;
    solver->evaluations += (r->steps - steps_before) * r->order;
}

/* The limit that a run has come to where the kernel makes no more steps, or TDMF_ARRIVED: then it may go on.
 */
static tdmf_outcome limit_of_steps(tdmf_page_solver *s, working_memory *w, double until, long first) {
    const tdmf_page_run *r = &s->run.run;
    const long last_step = first + s->solver->step_limit;
    const bool is_first = r->steps == first + 1;
    const long span = is_first ? TDMF_STIFFNESS_LIMIT - 1 : TDMF_STIFFNESS_LIMIT;
    if (r->steps >= last_step) {
        return TDMF_TOO_MANY_STEPS;
    }
    if (is_first ? begins_too_stiff(s, w->state.reach, until) : is_too_stiff(s)) {
        return TDMF_TOO_STIFF;
    }
    w->state.last_step = last_step - r->steps > span ? r->steps + span : last_step;
    return TDMF_ARRIVED;
}

/* Runs to an end, to the stop event or to a limit. No limit cuts a chain in zero time: a motion does not keep
 * what the chain remembers. */
static tdmf_run_outcome run_with(tdmf_page_solver *s, working_memory *w, double until, tdmf_outcome *limit) {
    const long first = s->run.run.steps;
    tdmf_run_outcome outcome;
    *limit = TDMF_ARRIVED;
    w->state.last_step = first + (s->solver->step_limit > 0);
    do {
        w->state.stops |= *limit != TDMF_ARRIVED || s->events_left <= 0;
        outcome = to_event(s, w, until);
        if (outcome == TDMF_RUN_TOO_MANY_STEPS) {
            *limit = limit_of_steps(s, w, until, first);
            w->state.last_step = *limit == TDMF_ARRIVED ? w->state.last_step : LONG_MAX;
            outcome = TDMF_RUN_GOES_ON;
        }
    } while (outcome == TDMF_RUN_GOES_ON);
    return outcome;
}

tdmf_outcome tdmf_run_page_solver(tdmf_page_solver *s, double until, int stop_event) {
    tdmf_page_run *r = &s->run.run;
    working_memory w;
    const long steps = r->steps;
    tdmf_outcome limit;
    r->memory = s->memory;
    r->stop_event = tdmf_event_on_part(s->run.page, stop_event);
    r->event_limit = LONG_MAX - r->events;
    s->events_left = s->solver->event_limit;
    w.driver = tdmf_begin_in_memory(&w.state, &w.at, s->run.page->model, r);
    const tdmf_run_outcome outcome = run_with(s, &w, until, &limit);
    const bool stands = outcome == TDMF_RUN_STOPPED;
    s->has_stopped = stands && r->stop_event >= 0 && (r->taken >> r->stop_event & 1) != 0;
    if (stands && !s->stays_on_guard) {
        tdmf_leave_guard(w.driver, &w.state, &w.at);
    }
    report_event(s);
    count_work(s->solver, r, steps);
    if (!stands || s->has_stopped) {
        return outcome_of(s, outcome);
    }
    const bool is_over = !(until - r->time - r->time_rest > 0.0);
    return is_over ? TDMF_ARRIVED : limit != TDMF_ARRIVED ? limit : TDMF_TOO_MANY_EVENTS;
}
