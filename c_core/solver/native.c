/* The native solver. The motion is expanded into Taylor series of its present mode, searched for the first
 * event as far as the series may be trusted, and goes on from there. No step is ever refused. */
#include "tdmf_slip/solver.h"

#include "carried.h"
#include "event_log.h"
#include "events.h"
#include "input_rates.h"
#include "margins.h"
#include "record.h"
#include "request.h"
#include "saltation.h"
#include "series_sums.h"
#include "step.h"
#include "step_limits.h"
#include "tdmf_slip/automaton.h"
#include "tdmf_slip/dynamics.h"
#include "turns.h"

#include <math.h>
#include <string.h>

typedef struct {
    tdmf_solver *solver;
    const tdmf_model *model;
    tdmf_inputs inputs; /* at motion->time */
    tdmf_inputs rates;
    tdmf_motion *motion; /* its state is that of the last event; the chart may be ahead of it */
    bool chart_is_ahead;
    tdmf_leg_direction direction; /* of the state */
    double until;
    int order; /* of the series */
    tdmf_chart chart;
    tdmf_step step;
    step_count steps;
    long events_left;
    int events_in_span;
    int false_crossings; /* since the mode changed or a step was whole */
    /* First variations, if any: as of the last event, and where the chart is. */
    int count;
    const tdmf_change *changes;
    tdmf_variation *variations;
    tdmf_carried carried[TDMF_VARIATION_LIMIT];
    motion_variation tangents[TDMF_VARIATION_LIMIT]; /* along the step */
} march;

tdmf_solver tdmf_solver_default(void) {
    const tdmf_solver solver = {.relative_tolerance = 1e-11, .step_limit = 200000, .event_limit = 100000};
    return solver;
}

const char *tdmf_outcome_text(tdmf_outcome outcome) {
    switch (outcome) {
    case TDMF_ARRIVED:
        return "arrived";
    case TDMF_FELL:
        return "the runner fell";
    case TDMF_TOO_STIFF:
        return "the runner is too stiff for the native solver, which would make more than 10000 steps in a "
               "time of sqrt(m/k); CVODE (solver.method = cvode) takes stiff runners";
    case TDMF_TOO_MANY_STEPS:
        return "too many steps in one call";
    case TDMF_TOO_MANY_EVENTS:
        return "too many events";
    case TDMF_NO_PROGRESS:
        return "no step, however short, has a finite result";
    default:
        return "an input, its rate, the tolerance or the time asked for is out of range";
    }
}

/* Begins integrating in the present mode from the present state. */
static void open_mode(march *march) {
    const tdmf_motion *motion = march->motion;
    tdmf_chart_open(&march->chart, march->model, &march->inputs, &march->rates, &motion->mode, motion->state,
                    march->direction);
    march->chart_is_ahead = false;
    for (int i = 0; i < march->count; ++i) {
        march->carried[i] =
            tdmf_carry(&march->chart, motion->state, &march->changes[i], &march->variations[i]);
    }
}

static void write_state(march *march, double elapsed, const tdmf_coordinates *coordinates) {
    double *state = march->motion->state;
    march->direction = tdmf_chart_state(&march->chart, elapsed, coordinates, state);
    for (int i = 0; i < march->count; ++i) {
        march->variations[i] = tdmf_carried_to(&march->chart, state, &march->changes[i], &march->carried[i]);
    }
}

/* Notes the peaks of the ground force. They change nothing but the record, so the step goes on. */
static void observe_ground_force(march *march, double end) {
    tdmf_mode *mode = &march->motion->mode;
    double *peak = &march->motion->record.open.peak_force;
    double from = 0.0;
    for (int i = 0; tdmf_in_contact(mode) && i < TDMF_TURN_LIMIT; ++i) {
        from = tdmf_force_turn(&march->step, mode->ground_force_rising, from, end);
        if (!(from <= end)) {
            return;
        }
        if (mode->ground_force_rising) {
            *peak =
                larger(*peak, series_at(march->step.series.ground.normal_force, march->step.order - 1, from));
        }
        mode->ground_force_rising = !mode->ground_force_rising;
    }
}

/* A friction that falls stays at zero from then on. */
static double time_to_no_friction(const march *march) {
    return march->rates.ground.friction < 0.0 ? march->inputs.ground.friction / -march->rates.ground.friction
                                              : INFINITY;
}

static double time_left(const march *march) {
    const tdmf_instant until = {march->until, 0.0};
    return tdmf_time_between(march->motion->record.now, until);
}

static void move_time(march *march, double elapsed) {
    tdmf_motion *motion = march->motion;
    const tdmf_instant until = {march->until, 0.0};
    motion->record.now = elapsed < time_left(march) ? tdmf_instant_after(motion->record.now, elapsed) : until;
    motion->time = motion->record.now.time;
}

static void move_inputs(march *march, double elapsed) {
    const bool friction_ends = elapsed >= time_to_no_friction(march);
    march->inputs = tdmf_inputs_after(&march->inputs, &march->rates, elapsed);
    if (friction_ends) {
        march->inputs.ground.friction = 0.0;
        march->rates.ground.friction = 0.0;
        tdmf_chart_end_friction(&march->chart);
    }
}

static tdmf_side side_of(const march *march) {
    const tdmf_motion *motion = march->motion;
    tdmf_side side;
    memcpy(side.state, motion->state, sizeof side.state);
    side.mode = motion->mode;
    tdmf_derivatives(march->model, &march->inputs, &side.mode, side.state, side.derivatives);
    return side;
}

static void log_event(tdmf_event_log *log, double time, tdmf_guard guard, const tdmf_side *before,
                      const tdmf_mode *after) {
    tdmf_event event = {.time = time, .guard = (int)guard, .before = before->mode, .after = *after};
    memcpy(event.state, before->state, sizeof event.state);
    tdmf_log_event(log, &event);
}

static bool take_transitions(march *march) {
    tdmf_motion *motion = march->motion;
    const tdmf_resolution taken =
        tdmf_resolve_along(march->model, &march->inputs, motion->time, motion->state, march->direction,
                           &motion->mode, &motion->record);
    if (taken.unresolved) {
        march->events_left = 0;
    }
    march->false_crossings = taken.mode_changed ? 0 : march->false_crossings + 1;
    return taken.state_changed || taken.mode_changed;
}

/* Takes what is due now, on the motion and on its variations. Nothing may be: series know a guard up to the
 * tolerance, and the model finds it above its margin still. */
static bool resolve(march *march, tdmf_guard guard) {
    tdmf_motion *motion = march->motion;
    if (march->count == 0 && !march->solver->log) {
        return take_transitions(march);
    }
    const tdmf_side before = side_of(march);
    if (!take_transitions(march)) {
        return false;
    }
    const tdmf_side after = side_of(march);
    log_event(march->solver->log, motion->time, guard, &before, &after.mode);
    for (int i = 0; i < march->count; ++i) {
        march->variations[i] = tdmf_saltation(march->model, &march->inputs, guard, &before, &after,
                                              &march->changes[i], &march->variations[i]);
    }
    return true;
}

/* Takes the event that is due after `elapsed`. */
static void stop_at_event(march *march, tdmf_guard guard, double elapsed, const tdmf_coordinates *reached) {
    --march->events_left;
    write_state(march, elapsed, reached);
    move_time(march, elapsed);
    move_inputs(march, elapsed);
    march->solver->events += resolve(march, guard);
    ++march->events_in_span;
    open_mode(march);
}

static void go_on(march *march, double elapsed, const tdmf_coordinates *reached) {
    move_time(march, elapsed);
    tdmf_chart_shift(&march->chart, elapsed, reached);
    march->chart_is_ahead = true;
    march->false_crossings = 0;
    move_inputs(march, elapsed);
}

static bool are_finite(const tdmf_coordinates *c) {
    return is_finite(c->length + c->angle + c->length_rate + c->angle_rate + c->x + c->y + c->vx + c->vy +
                     c->foot_x + c->foot_vx + c->work + c->damper_loss + c->friction_loss);
}

/* By the law of a mode that is opened. Slip and graze may be over before it matters. */
static bool mode_is_too_stiff(const march *march) {
    const tdmf_contact_mode contact = march->chart.contact;
    const bool lasts = contact == TDMF_CONTACT_FLIGHT || contact == TDMF_CONTACT_STICK;
    return lasts && !march->chart_is_ahead &&
           opens_too_stiff(march->step.longest, smaller(march->model->scales.time, time_left(march)));
}

/* Whether one more step may be made, by the limits of a call and of stiffness. */
static tdmf_outcome may_step(const march *march) {
    if (no_steps_left(&march->steps)) {
        return TDMF_TOO_MANY_STEPS;
    }
    if (!takes_too_many_steps(&march->steps, march->model->scales.time)) {
        return TDMF_ARRIVED;
    }
    return 2 * march->events_in_span > TDMF_STIFFNESS_LIMIT ? TDMF_TOO_MANY_EVENTS : TDMF_TOO_STIFF;
}

static void note_step(march *march, double time) {
    const double scale = march->model->scales.time;
    if (span_is_over(&march->steps, scale)) {
        march->events_in_span = 0;
    }
    count_step(&march->steps, time, scale);
}

/* Expands the variations, and shortens the step to what all of them can be trusted for. */
static void expand_variations(march *march) {
    tdmf_step *step = &march->step;
    for (int i = 0; i < march->count; ++i) {
        const double trusted = tdmf_carried_expand(step, &march->motion->mode, &march->changes[i],
                                                   &march->carried[i], &march->tangents[i]);
        /* A size that is not a number stays one. */
        step->size = trusted < step->size ? trusted : step->size;
    }
}

static tdmf_outcome advance_once(march *march) {
    tdmf_motion *motion = march->motion;
    tdmf_step *step = &march->step;
    const tdmf_outcome allowed = may_step(march);
    if (allowed != TDMF_ARRIVED) {
        return allowed;
    }
    ++march->solver->steps;
    tdmf_step_expand(step, &march->chart, &motion->mode, tdmf_margin_factor(march->false_crossings),
                     march->order, march->solver->relative_tolerance);
    march->solver->evaluations += step->order;
    if (mode_is_too_stiff(march)) {
        return TDMF_TOO_STIFF;
    }
    expand_variations(march);
    if (!(step->size > 0.0)) {
        return TDMF_NO_PROGRESS;
    }
    tdmf_step_shorten(step, smaller(time_left(march), time_to_no_friction(march)));
    const tdmf_step_end end = tdmf_step_find_end(step, &motion->mode);
    const tdmf_coordinates reached = tdmf_step_at(step, end.time);
    if (!are_finite(&reached)) {
        return TDMF_NO_PROGRESS;
    }
    note_step(march, end.time);
    observe_ground_force(march, end.time);
    march->chart.positive_work += tdmf_positive_work(step, end.time, reached.work - march->chart.start.work);
    for (int i = 0; i < march->count; ++i) {
        tdmf_carry_on(step, end.time, &march->changes[i], &march->tangents[i], &march->carried[i]);
    }
    if (end.is_event) {
        stop_at_event(march, end.guard, end.time, &reached);
    } else {
        go_on(march, end.time, &reached);
    }
    return TDMF_ARRIVED;
}

static bool begin(march *march, tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs,
                  const tdmf_inputs *rates, double until, tdmf_motion *motion) {
    if (!tdmf_is_sound_request(solver, inputs, rates, until, motion)) {
        return false;
    }
    march->solver = solver;
    march->model = model;
    march->inputs = *inputs;
    march->rates = *rates;
    march->motion = motion;
    march->until = until;
    motion->record.now = tdmf_record_instant(&motion->record, motion->time);
    march->order = tdmf_step_order(solver->relative_tolerance);
    march->steps = opened_steps((double)solver->step_limit);
    march->events_left = solver->event_limit;
    march->false_crossings = 0;
    march->count = 0;
    march->events_in_span = 0;
    /* An input may have jumped since the last call. */
    march->direction = tdmf_leg_direction_of(motion->state);
    tdmf_resolve_along(model, inputs, motion->time, motion->state, march->direction, &motion->mode,
                       &motion->record);
    open_mode(march);
    return true;
}

/* Until the time asked for or, if asked, until one more stride has closed. */
static tdmf_outcome advance(march *march, bool one_stride) {
    tdmf_motion *motion = march->motion;
    const int count = motion->record.stride.count;
    tdmf_outcome outcome = TDMF_ARRIVED;
    while (outcome == TDMF_ARRIVED && time_left(march) > 0.0 && !motion->mode.fallen &&
           !(one_stride && motion->record.stride.count > count)) {
        outcome = march->events_left <= 0 ? TDMF_TOO_MANY_EVENTS : advance_once(march);
    }
    if (march->chart_is_ahead) {
        write_state(march, 0.0, &march->chart.start);
    }
    if (outcome != TDMF_ARRIVED) {
        return outcome;
    }
    /* The caller may change an input now. */
    tdmf_observe(march->model, &march->inputs, motion->state, &motion->mode, &motion->record);
    return motion->mode.fallen ? TDMF_FELL : TDMF_ARRIVED;
}

tdmf_outcome tdmf_native_advance(tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs,
                                 const tdmf_inputs *rates, double until, tdmf_motion *motion) {
    march march;
    const bool begun = begin(&march, solver, model, inputs, tdmf_rates_or_held(rates), until, motion);
    return begun ? advance(&march, false) : TDMF_REFUSED;
}

static tdmf_stride_outcome advance_a_stride(march *march) {
    const tdmf_record *record = &march->motion->record;
    const int count = record->stride.count;
    const tdmf_outcome outcome = advance(march, true);
    const tdmf_stride_outcome result = {outcome, record->stride.count > count};
    return result;
}

static const tdmf_stride_outcome refused = {TDMF_REFUSED, false};

tdmf_stride_outcome tdmf_native_stride(tdmf_solver *solver, const tdmf_model *model,
                                       const tdmf_inputs *inputs, double until, tdmf_motion *motion) {
    march march;
    return begin(&march, solver, model, inputs, tdmf_rates_or_held(NULL), until, motion)
               ? advance_a_stride(&march)
               : refused;
}

tdmf_stride_outcome tdmf_native_stride_varied(tdmf_solver *solver, const tdmf_model *model,
                                              const tdmf_inputs *inputs, double until, tdmf_motion *motion,
                                              const tdmf_change *changes, tdmf_variation *variations,
                                              int count) {
    march march;
    if (count < 0 || count > TDMF_VARIATION_LIMIT ||
        !begin(&march, solver, model, inputs, tdmf_rates_or_held(NULL), until, motion)) {
        return refused;
    }
    march.count = count;
    march.changes = changes;
    march.variations = variations;
    open_mode(&march);
    return advance_a_stride(&march);
}
