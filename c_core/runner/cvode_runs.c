/* The public function of cvode.h: a motion runs on the runner's page by CVODE. */
#include "tdmf_slip/cvode.h"

#include "automaton.h"
#include "event_log.h"
#include "input_rates.h"
#include "page_cvode.h"
#include "page_solver.h"
#include "request.h"

#include <string.h>

bool tdmf_cvode_is_available(void) {
    return tdmf_page_cvode_is_available();
}

typedef struct {
    tdmf_solver *options;
    tdmf_system system;
    tdmf_motion begun; /* motion at the beginning of the call */
    int last_mode;     /* mode of the page before the fall */
    tdmf_motion_instant instant;
    double memory[TDMF_SETTLING_MEMORY];
} cvode_run;

static tdmf_motion motion_at(const cvode_run *r) {
    tdmf_motion motion = r->begun;
    tdmf_motion_of_page(r->system, &r->instant.point, r->last_mode, &motion);
    return motion;
}

/* TDMF_GUARD_COUNT: an event of the page's own, or a thrust of 0, which changes nothing. */
static tdmf_guard guard_of_row(const cvode_run *r, const tdmf_event_row *row) {
    const runner_parameters *p = &r->instant.point.p;
    const bool thrusts = p->thrust + p->more_thrust > 0.0;
    return row->event == EVENT_greatest_compression && !thrusts ? TDMF_GUARD_COUNT
                                                                : tdmf_guard_of_event(row->event);
}

/* The guard by which a chain is logged: that of its first event, unless that is none. */
static tdmf_guard guard_of_chain(const cvode_run *r, const tdmf_chain *chain) {
    const tdmf_guard first = guard_of_row(r, &chain->first);
    return first < TDMF_GUARD_COUNT ? first : guard_of_row(r, &chain->last);
}

/* Takes the events that are due, and logs them unless the call begins with them. */
static bool take_events(cvode_run *r, bool is_start) {
    tdmf_chain chain;
    tdmf_page_point *point = &r->instant.point;
    const tdmf_motion before = motion_at(r);
    tdmf_page_run run = tdmf_run_at(point, r->memory);
    const bool is_settled =
        tdmf_take_due_events(&tdmf_runner_model, &run, r->instant.watch, r->instant.memory, &chain);
    r->last_mode = run.mode == MODE_fallen && chain.count > 0 ? chain.last.before : run.mode;
    point->mode = run.mode;
    point->above = (uint64_t)(r->instant.watch[EVENT_apex] == WATCH_ABOVE) << EVENT_apex;
    const tdmf_guard guard = chain.count > 0 ? guard_of_chain(r, &chain) : TDMF_GUARD_COUNT;
    if (guard < TDMF_GUARD_COUNT && !is_start) {
        tdmf_event event = {.time = before.time, .guard = (int)guard, .before = before.mode};
        event.after = motion_at(r).mode;
        memcpy(event.state, before.state, sizeof event.state);
        tdmf_log_event(r->options, &event);
        ++r->options->events;
    }
    return is_settled;
}

static tdmf_outcome run_to(cvode_run *r, double until) {
    tdmf_page_point *point = &r->instant.point;
    const int64_t steps_before = r->options->steps, events_before = r->options->events;
    bool is_settled = take_events(r, true);
    while (is_settled && point->mode != MODE_fallen) {
        tdmf_page_run run = tdmf_run_at(point, r->memory);
        run.tolerance = r->options->relative_tolerance;
        run.step_limit = r->options->step_limit - (long)(r->options->steps - steps_before);
        if (r->options->events - events_before >= r->options->event_limit) {
            return TDMF_TOO_MANY_EVENTS;
        }
        const tdmf_run_outcome outcome =
            tdmf_cvode_to_event(&tdmf_runner_model, &run, r->instant.watch, until, &r->options->evaluations);
        point->time = run.time;
        point->rest = run.time_rest;
        r->options->steps += run.steps;
        r->options->layer_steps += run.limited_steps;
        if (outcome != TDMF_RUN_STOPPED) {
            return outcome == TDMF_RUN_ARRIVED          ? TDMF_ARRIVED
                   : outcome == TDMF_RUN_TOO_MANY_STEPS ? TDMF_TOO_MANY_STEPS
                                                        : TDMF_NO_PROGRESS;
        }
        is_settled = take_events(r, false);
    }
    return is_settled ? TDMF_FELL : TDMF_TOO_MANY_EVENTS;
}

tdmf_outcome tdmf_cvode_advance(tdmf_solver *options, tdmf_system system, const tdmf_inputs *rates,
                                double until, tdmf_motion *motion) {
    const tdmf_inputs *given = tdmf_rates_or_zero(rates);
    if (!tdmf_cvode_is_available() || !tdmf_is_sound_request(options, system, given, until, motion)) {
        return TDMF_REFUSED;
    }
    if (motion->mode.fallen) {
        return TDMF_FELL;
    }
    cvode_run r = {.options = options, .system = system};
    motion->mode.clamp_closed &= system.model->parameters.hip.swing_clamp;
    tdmf_observe(system, motion);
    r.begun = *motion;
    const tdmf_page_point point = tdmf_page_of_motion(system, given, motion);
    tdmf_begin_instant_of_point(&r.instant, &point);
    r.last_mode = point.mode;
    const int64_t steps_before = options->steps;
    const tdmf_outcome outcome = run_to(&r, until - motion->begun);
    *motion = motion_at(&r);
    if (options->steps == steps_before &&
        motion->state[TDMF_EVENT_COUNT] == r.begun.state[TDMF_EVENT_COUNT]) {
        memcpy(motion->state + TDMF_FOOT_X, r.begun.state + TDMF_FOOT_X,
               TDMF_COORDINATE_COUNT * sizeof *motion->state); /* no rounding */
    }
    if (outcome == TDMF_ARRIVED) {
        motion->time = until;
    }
    const tdmf_inputs inputs = tdmf_inputs_after(
        system.inputs, given, r.instant.point.time - point.time + (r.instant.point.rest - point.rest));
    tdmf_observe((tdmf_system){system.model, &inputs}, motion);
    return outcome;
}
