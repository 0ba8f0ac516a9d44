/* The functions of solver.h: a motion runs on the runner's page. */
#include "input_rates.h"
#include "page_solver.h"
#include "refusal.h"
#include "request.h"
#include "tdmf_slip/automaton.h"

#include <math.h>
#include <string.h>

tdmf_solver tdmf_solver_default(void) {
    const tdmf_solver solver = {
        .relative_tolerance = 1e-11, .step_limit = TDMF_STEP_LIMIT, .event_limit = TDMF_EVENT_LIMIT};
    return solver;
}

const char *tdmf_outcome_text(tdmf_outcome outcome) {
    switch (outcome) {
    case TDMF_ARRIVED:
        return "arrived";
    case TDMF_FELL:
        return "the runner fell";
    case TDMF_TOO_STIFF:
        return "the runner is too stiff for the native solver, which would make too many steps in a time of "
               "sqrt(m/k); CVODE (solver.method = cvode) takes stiff runners";
    case TDMF_TOO_MANY_STEPS:
        return "too many steps in one call";
    case TDMF_TOO_MANY_EVENTS:
        return "too many events";
    case TDMF_NO_PROGRESS:
        return "no step, however short, has a finite result";
    default:
        return "the state, an input, its rate, the tolerance or the time asked for is out of range";
    }
}

static tdmf_outcome run_motion(tdmf_solver *solver, tdmf_system system, const tdmf_inputs *rates,
                               double until, int stop_event, tdmf_motion *motion) {
    const tdmf_motion before = *motion;
    if (motion->mode.fallen) {
        return TDMF_FELL;
    }
    const tdmf_page_point point = tdmf_page_of_motion(system, rates, motion);
    tdmf_page_solver s;
    tdmf_begin_page_solver(&s, solver, system, &point, tdmf_suits_plain_page(&point));
    s.motion = &before;
    const tdmf_outcome outcome = tdmf_run_page_solver(&s, until - motion->begun, stop_event);
    if (outcome == TDMF_TOO_STIFF && s.run.run.steps == 1) {
        tdmf_resolve(system, motion); /* not begun, but an input may have jumped */
        return outcome;
    }
    tdmf_end_runner_run(&s.run, &s.point);
    tdmf_motion_of_page(system, &s.point, s.last_mode, motion);
    if (s.run.run.steps == 0 && s.run.run.events == 0) { /* removes the rounding of the two maps */
        memcpy(motion->state + TDMF_FOOT_X, before.state + TDMF_FOOT_X,
               TDMF_COORDINATE_COUNT * sizeof *motion->state);
    }
    if (outcome == TDMF_ARRIVED && !s.has_stopped) {
        motion->time = until;
    }
    const tdmf_inputs inputs =
        tdmf_inputs_after(system.inputs, rates, s.point.time - point.time + (s.point.rest - point.rest));
    tdmf_observe((tdmf_system){system.model, &inputs}, motion);
    return outcome;
}

tdmf_outcome tdmf_native_advance(tdmf_solver *solver, tdmf_system system, const tdmf_inputs *rates,
                                 double until, tdmf_motion *motion) {
    const tdmf_inputs *given = tdmf_rates_or_zero(rates);
    return tdmf_is_sound_request(solver, system, given, until, motion)
               ? run_motion(solver, system, given, until, -1, motion)
               : TDMF_REFUSED;
}

tdmf_stride_outcome tdmf_native_stride(tdmf_solver *solver, tdmf_system system, double until,
                                       tdmf_motion *motion) {
    tdmf_stride_outcome result = {TDMF_REFUSED, false};
    if (!tdmf_is_sound_request(solver, system, &tdmf_zero_input_rates, until, motion)) {
        return result;
    }
    const double strides = motion->state[TDMF_STRIDE_COUNT];
    do { /* the first apex may open a stride and close none */
        result.outcome = run_motion(solver, system, &tdmf_zero_input_rates, until, EVENT_apex, motion);
        result.closed = motion->state[TDMF_STRIDE_COUNT] > strides;
    } while (result.outcome == TDMF_ARRIVED && !result.closed && motion->time < until);
    solver->strides += result.closed;
    return result;
}
