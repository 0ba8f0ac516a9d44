/* The native solver: the driver of pages, from event to event, with the solver's limits, counters and log. */
#include "page_solver.h"

#include "event_log.h"
#include "run_state.h"

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

static tdmf_outcome outcome_of(tdmf_run_outcome outcome) {
    switch (outcome) {
    case TDMF_RUN_ARRIVED:
    case TDMF_RUN_STOPPED:
        return TDMF_ARRIVED;
    case TDMF_RUN_ENDED:
        return TDMF_FELL;
    case TDMF_RUN_TOO_MANY_STEPS:
        return TDMF_TOO_MANY_STEPS;
    case TDMF_RUN_ENDLESS_CHAIN:
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
    s->span_began = 0.0;
    s->has_stopped = s->stays_on_guard = s->has_event = false;
    tdmf_page_run *r = &s->run.run;
    r->tolerance = solver->relative_tolerance;
    r->order = tdmf_page_order(r->tolerance);
    r->observes = !solver->without_peaks_and_positive_work;
    r->dp = s->dp;
    r->dx = s->dx;
    r->shift = s->shift;
}

void tdmf_add_direction(tdmf_page_solver *s, const tdmf_page_direction *direction) {
    tdmf_page_run *r = &s->run.run;
    const int i = r->seed_count++;
    r->observes = true;
    s->shift[i] = 0.0;
    tdmf_take_parameters(s->run.is_plain, (const double *)&direction->p,
                         s->dp + i * s->run.model->parameter_count);
    tdmf_take_states(s->run.is_plain, (const double *)&direction->x, s->dx + i * s->run.model->state_count);
}

tdmf_page_direction tdmf_direction_at_end(const tdmf_page_solver *s, int i) {
    tdmf_page_direction direction;
    memset(&direction, 0, sizeof direction);
    tdmf_give_parameters(s->run.is_plain, s->dp + i * s->run.model->parameter_count, (double *)&direction.p);
    tdmf_give_states(s->run.is_plain, s->dx + i * s->run.model->state_count, (double *)&direction.x);
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
        tdmf_log_event(s->solver->log, &s->event);
    }
    s->has_event = false;
}

/* A chain in zero time is one event, by the name of its first, from the mode before to the mode after it.
 * Events at the start of a call are not logged. */
static void note_event(tdmf_page_solver *s, const tdmf_runner_run *before, const tdmf_event_row *row) {
    const tdmf_guard guard = tdmf_guard_of_event(tdmf_event_in_whole(s->run.is_plain, row->event));
    const tdmf_motion after = motion_at(s, &s->run);
    if (s->run.run.chain > 1 && s->has_event) {
        s->event.after = after.mode;
        return;
    }
    report_event(s);
    tdmf_motion at = motion_at(s, before);
    at.mode.rises |= guard == TDMF_GUARD_APEX; /* before the event */
    const bool has_guard = guard != TDMF_GUARD_CLAMP || at.mode.contact == TDMF_CONTACT_FLIGHT;
    const bool is_at_start = s->run.run.time == 0.0 && s->run.run.time_rest == 0.0;
    const tdmf_event event = {
        .time = after.time, .guard = (int)guard, .before = at.mode, .after = after.mode};
    s->event = event;
    memcpy(s->event.state, at.state, sizeof event.state);
    s->has_event = guard != TDMF_GUARD_COUNT && has_guard && !is_at_start;
}

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
    tdmf_runner_run before;
    tdmf_event_row row;
    double x_before[TDMF_PAGE_STATE_COUNT];
    r->log = &row;
    r->log_states = x_before;
    r->log_count = 0;
    r->log_size = s->motion != NULL && s->solver->log != NULL;
    const tdmf_run_outcome outcome = tdmf_drive_to_event(w->driver, &w->state, &w->at, until);
    if (tdmf_mode_in_whole(s->run.is_plain, mode) == MODE_slip_falling) {
        s->solver->layer_steps += r->steps - steps;
    }
    if (r->events == events) {
        return outcome;
    }
    if (tdmf_mode_in_whole(s->run.is_plain, r->mode) == MODE_fallen) {
        s->last_mode = tdmf_mode_in_whole(s->run.is_plain, mode);
    }
    s->solver->events += r->chain <= 1;
    if (r->log_count > 0) {
        before = s->run;
        before.run.mode = mode;
        memcpy(before.x, x_before, sizeof before.x);
        note_event(s, &before, &row);
    }
    return outcome;
}

/* Whether a runner takes more steps in a unit of time than a stiff one may; begins the next such span. */
static bool is_too_stiff(tdmf_page_solver *s) {
    const double time = s->run.run.time;
    const bool is_stiff = time - s->span_began < s->system.model->scales.time;
    s->span_began = time;
    return is_stiff;
}

/* The first step shows whether flight or stick is too stiff. Slip and graze may be over before it matters. */
static bool begins_too_stiff(const tdmf_page_solver *s, double duration) {
    const bool lasts = s->point.mode == MODE_stick || s->point.mode == MODE_flight_place_calm ||
                       s->point.mode == MODE_flight_retract_calm || s->point.mode == MODE_flight_rest_calm;
    const double span = fmin(s->system.model->scales.time, duration);
    return lasts && s->run.run.events == 0 && s->run.run.time * TDMF_STIFFNESS_LIMIT < span;
}

static void count_work(tdmf_solver *solver, const tdmf_page_run *r, long steps_before) {
    solver->steps += r->steps - steps_before;
    solver->evaluations += (r->steps - steps_before) * r->order;
}

static tdmf_run_outcome run_with(tdmf_page_solver *s, working_memory *w, double until, bool *stiff) {
    tdmf_page_run *r = &s->run.run;
    const long first = r->steps, last_step = first + s->solver->step_limit;
    tdmf_run_outcome outcome;
    *stiff = false;
    w->state.last_step = first + (s->solver->step_limit > 0);
    do {
        outcome = to_event(s, w, until);
        if (outcome != TDMF_RUN_TOO_MANY_STEPS || r->steps >= last_step) {
            continue;
        }
        *stiff = r->steps == first + 1 ? begins_too_stiff(s, until) : is_too_stiff(s);
        if (!*stiff) {
            const long span = r->steps == first + 1 ? TDMF_STIFFNESS_LIMIT - 1 : TDMF_STIFFNESS_LIMIT;
            w->state.last_step = last_step - r->steps > span ? r->steps + span : last_step;
            outcome = TDMF_RUN_GOES_ON;
        }
    } while (outcome == TDMF_RUN_GOES_ON);
    return outcome;
}

tdmf_outcome tdmf_run_page_solver(tdmf_page_solver *s, double duration, int stop_event) {
    tdmf_page_run *r = &s->run.run;
    working_memory w;
    const long steps = r->steps;
    bool stiff = false;
    r->memory = s->memory;
    r->stop_event = tdmf_event_of_whole(s->run.is_plain, stop_event);
    r->event_limit = s->solver->event_limit;
    w.driver = tdmf_begin_in_memory(&w.state, &w.at, s->run.model, r);
    const tdmf_run_outcome outcome = run_with(s, &w, duration, &stiff);
    if (outcome == TDMF_RUN_STOPPED && r->is_shifted && !s->stays_on_guard) {
        r->stop_event = -1;
        w.state.stops = false;
        run_with(s, &w, r->time + r->time_rest, &stiff); /* back to a fixed time */
    }
    report_event(s);
    count_work(s->solver, r, steps);
    s->has_stopped = outcome == TDMF_RUN_STOPPED;
    return stiff ? TDMF_TOO_STIFF : outcome_of(outcome);
}
