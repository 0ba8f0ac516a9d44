/* A runner with its settings, FMI left out. */
#include "unit.h"

#include "tdmf_slip/cvode.h"
#include "variables.h"

#include <limits.h>
#include <math.h>
#include <string.h>

enum { NO_GUARD = -1 };

/* Where events are counted from. */
typedef struct {
    int event_count; /* which ends at the largest int */
    double event_time;
    bool fallen;
} unit_mark;

const double unit_largest_state = 1e60;
static const double largest_time = 1e100;

void unit_reset(unit *unit) {
    memset(unit, 0, sizeof *unit);
    for (size_t i = 0; i < unit_variable_count; ++i) {
        const unit_variable *variable = &unit_variables[i];
        if (variable->settable_before_start) {
            unit_set_number(unit, variable, variable->start);
        }
    }
    tdmf_model_create(&unit->model, &unit->parameters);
    unit->importer_tolerance = INFINITY;
    unit->stop_time = INFINITY;
    unit->solver = tdmf_solver_default();
}

tdmf_refusal unit_prepare(unit *unit) {
    const tdmf_refusal refusal = tdmf_model_create(&unit->model, &unit->parameters);
    if (refusal.variable == NULL) {
        unit->solver.relative_tolerance =
            fmin(unit->settings.solver.relative_tolerance, unit->importer_tolerance);
    }
    return refusal;
}

tdmf_refusal unit_start(unit *unit) {
    struct unit ready = *unit;
    tdmf_refusal refusal = unit_prepare(&ready);
    if (refusal.variable == NULL) {
        refusal = tdmf_start(&ready.model, &ready.inputs, ready.motion.time, ready.motion.state,
                             &ready.motion.mode, &ready.motion.record);
    }
    if (refusal.variable == NULL) {
        ready.accounted_leg = tdmf_leg_sample_of(ready.motion.time, ready.motion.state);
        *unit = ready;
    }
    return refusal;
}

bool unit_has_begun(const unit *unit) {
    return unit->motion.mode.contact != 0;
}

static int as_integer(int64_t count) {
    return count < INT_MAX ? (int)count : INT_MAX;
}

void unit_evaluate(const unit *unit, unit_view *view) {
    tdmf_derivatives(&unit->model, &unit->inputs, &unit->motion.mode, unit->motion.state, view->derivatives);
    view->outputs = tdmf_outputs_of(&unit->model, &unit->inputs, &unit->motion.mode, &unit->motion.record,
                                    unit->motion.state);
    unit_event_indicators(unit, view->guards);
    view->work.solver.steps = as_integer(unit->solver.steps);
    view->work.solver.evaluations = as_integer(unit->solver.evaluations);
    memcpy(view->states, unit->motion.state, sizeof view->states);
}

static void differentiate(const unit *unit, const tdmf_change *change, const tdmf_variation *variation,
                          unit_view *view) {
    const tdmf_motion *motion = &unit->motion;
    const tdmf_tangent tangent =
        tdmf_tangent_along(&unit->model, &unit->inputs, &motion->mode, motion->state, change, variation);
    memset(view, 0, sizeof *view);
    memcpy(view->derivatives, tangent.derivatives, sizeof view->derivatives);
    memcpy(view->states, variation->state, sizeof view->states);
    view->outputs.body.x = tangent.body.x;
    view->outputs.body.y = tangent.body.y;
    view->outputs.body.vx = tangent.body.vx;
    view->outputs.body.vy = tangent.body.vy;
    view->outputs.com.x = tangent.com.x;
    view->outputs.com.y = tangent.com.y;
    view->outputs.com.vx = tangent.com.vx;
    view->outputs.com.vy = tangent.com.vy;
    view->outputs.contact.fx = tangent.contact_fx;
    view->outputs.contact.fy = tangent.contact_fy;
    view->outputs.contact.normal = tangent.contact.normal;
    view->outputs.contact.tangential = tangent.contact.tangential;
    view->outputs.leg.force = tangent.leg_force;
    view->outputs.hip.torque = tangent.torque;
    view->outputs.energy.kinetic = tangent.energy.kinetic;
    view->outputs.energy.potential = tangent.energy.potential;
    view->outputs.energy.elastic = tangent.energy.elastic;
    view->outputs.energy.total = tangent.energy.total;
}

void unit_differentiate(const unit *unit, const struct unit *direction, unit_view *change) {
    tdmf_change along = {direction->parameters, direction->inputs};
    tdmf_variation variation = {.liftoff_angle = 0.0};
    memcpy(variation.state, direction->motion.state, sizeof variation.state);
    along.inputs.ground.height = 0.0; /* a new line is in force from an event on */
    along.inputs.ground.slope = 0.0;
    differentiate(unit, &along, &variation, change);
}

/* Where the run starts at an apex, the section is latched. */
static void differentiate_apex(const double variation[TDMF_STATE_COUNT], double com_height, double time,
                               tdmf_outputs *change) {
    change->apex.time = time;
    change->apex.com_height = com_height;
    change->apex.com_speed = change->com.vx;
    change->apex.leg_length = variation[TDMF_LEG_LENGTH];
    change->apex.leg_angle = variation[TDMF_LEG_ANGLE];
    change->apex.leg_length_rate = variation[TDMF_LEG_LENGTH_RATE];
    change->apex.leg_angle_rate = variation[TDMF_LEG_ANGLE_RATE];
}

void unit_differentiate_start(const unit *given, const struct unit *started, const struct unit *direction,
                              unit_view *change) {
    const tdmf_change along = {direction->parameters, direction->inputs};
    const tdmf_start_variation varied =
        tdmf_vary_start(&started->model, &started->inputs, given->motion.state, started->motion.state,
                        &started->motion.mode, &along, direction->motion.state);
    differentiate(started, &along, &varied.variation, change);
    change->outputs.hip.liftoff_angle = varied.variation.liftoff_angle;
    change->outputs.energy.impact_loss = varied.impact_loss;
    change->outputs.event.last_time = direction->motion.time;
    if (started->motion.record.open.began_at_apex) {
        differentiate_apex(varied.variation.state, varied.com_height, direction->motion.time,
                           &change->outputs);
    }
}

void unit_flow(const unit *unit, struct unit *direction) {
    memset(direction, 0, sizeof *direction);
    tdmf_derivatives(&unit->model, &unit->inputs, &unit->motion.mode, unit->motion.state,
                     direction->motion.state);
    direction->inputs = unit->input_rates;
}

bool unit_is_time(double time) {
    return fabs(time) <= largest_time;
}

static double within_largest(double value) {
    const double bounded = value < unit_largest_state ? value : unit_largest_state;
    return bounded > -unit_largest_state ? bounded : -unit_largest_state;
}

bool unit_try_state(unit *unit, const double state[TDMF_STATE_COUNT]) {
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        if (isnan(state[i])) {
            return false;
        }
    }
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        unit->motion.state[i] = within_largest(state[i]);
    }
    return true;
}

void unit_event_indicators(const unit *unit, double indicators[TDMF_GUARD_COUNT]) {
    tdmf_guards(&unit->model, &unit->inputs, &unit->motion.mode, unit->motion.state, indicators);
}

void unit_nominals(const unit *unit, double nominals[TDMF_STATE_COUNT]) {
    tdmf_state_scales(&unit->model, nominals);
}

void unit_observe(unit *unit) {
    tdmf_observe(&unit->model, &unit->inputs, unit->motion.state, &unit->motion.mode, &unit->motion.record);
}

bool unit_extension_has_changed(const unit *unit) {
    return !tdmf_rest_length_is_accounted_for(&unit->model, &unit->inputs, &unit->motion.mode);
}

void unit_account_for_extension(unit *unit) {
    const tdmf_leg_sample leg = tdmf_leg_sample_of(unit->motion.time, unit->motion.state);
    unit->leg_work_due += tdmf_account_for_extension(&unit->model, &unit->inputs, &unit->accounted_leg, &leg,
                                                     &unit->motion.mode);
    unit->accounted_leg = leg;
}

const char *unit_settings_obstacle(const unit *unit) {
    if (unit->settings.solver.method == SOLVER_CVODE && !tdmf_cvode_is_available()) {
        return "solver.method = cvode is refused: this unit was built without SUNDIALS; allowed: native";
    }
    return NULL;
}

/* Set by the importer, time may be elsewhere than where the solver left off. */
static tdmf_instant instant_of(const unit *unit) {
    const tdmf_instant set = {unit->motion.time, 0.0};
    return unit->motion.record.now.time == set.time ? unit->motion.record.now : set;
}

static tdmf_outcome advance(unit *unit, double until) {
    const tdmf_instant start = instant_of(unit);
    const bool by_cvode = unit->settings.solver.method == SOLVER_CVODE;
    const tdmf_outcome outcome = (by_cvode ? tdmf_cvode_advance : tdmf_native_advance)(
        &unit->solver, &unit->model, &unit->inputs, &unit->input_rates, until, &unit->motion);
    unit->inputs =
        tdmf_inputs_after(&unit->inputs, &unit->input_rates, tdmf_time_between(start, instant_of(unit)));
    return outcome;
}

/* The same, and tells of every event. */
static tdmf_outcome advance_observed(unit *unit, double until, const unit_observer *observer) {
    const long limit = unit->solver.event_limit;
    tdmf_outcome outcome = TDMF_TOO_MANY_EVENTS;
    tdmf_event_log log;
    unit->solver.event_limit = TDMF_EVENT_CAPACITY;
    unit->solver.log = &log;
    for (long i = 0; i < limit && outcome == TDMF_TOO_MANY_EVENTS; i += TDMF_EVENT_CAPACITY) {
        log.count = 0;
        outcome = advance(unit, until);
        for (int j = 0; j < log.count; ++j) {
            observer->note(observer->subject, &log.events[j]);
        }
    }
    unit->solver.event_limit = limit;
    unit->solver.log = NULL;
    return outcome;
}

/* What remains to be done where a run has got to. */
static const char *conclude(unit *unit, tdmf_outcome outcome, double until) {
    if (outcome == TDMF_FELL) {
        unit->inputs = tdmf_inputs_after(&unit->inputs, &unit->input_rates, until - unit->motion.time);
        unit->motion.time = until;
    }
    return outcome == TDMF_ARRIVED || outcome == TDMF_FELL ? NULL : tdmf_outcome_text(outcome);
}

/* ---- up to the first event ---------------------------------------------------------------------------- */

static unit_mark mark_of(const unit *unit) {
    const tdmf_motion *motion = &unit->motion;
    const unit_mark mark = {motion->record.event_count, motion->record.last_event_time, motion->mode.fallen};
    return mark;
}

static bool event_has_happened(const unit *unit, const unit_mark *since) {
    const unit_mark now = mark_of(unit);
    return now.event_count != since->event_count || now.event_time != since->event_time ||
           now.fallen != since->fallen;
}

/* Advances until an event has been taken, and notes its guard; the clamp, which is none of FMI's business,
 * counts with the solver's events only. */
static tdmf_outcome advance_through_event(unit *unit, double until, const unit_mark *since) {
    const long limit = unit->solver.event_limit;
    tdmf_outcome outcome = TDMF_TOO_MANY_EVENTS;
    tdmf_event_log log;
    log.count = 0;
    unit->solver.event_limit = 1;
    unit->solver.log = &log;
    for (long i = 0; i < limit && outcome == TDMF_TOO_MANY_EVENTS && !event_has_happened(unit, since); ++i) {
        log.count = 0;
        outcome = advance(unit, until);
    }
    unit->solver.event_limit = limit;
    unit->solver.log = NULL;
    unit->event_guard = log.count > 0 ? log.events[0].guard : NO_GUARD;
    return outcome;
}

/* Up to when an event that is due at `time` is seen to be: a little after its guard's zero. */
static double time_seen_due(const unit *unit, double time) {
    const double after = fmax(2.0 * unit->event_lead, 1e-10 * unit->model.scales.time);
    return fmax(time + after, nextafter(time, INFINITY));
}

/* The event, under inputs or settings that were set since it was found: it may be another one by now, or
 * none. */
static bool take_event_anew(unit *unit) {
    const tdmf_motion before = unit->motion;
    const double time = before.time;
    const tdmf_inputs inputs = unit->inputs;
    const unit_mark mark = mark_of(unit);
    tdmf_record *record = &unit->motion.record;
    advance_through_event(unit, time_seen_due(unit, time), &mark);
    if (!event_has_happened(unit, &mark)) {
        unit->motion = before;
    }
    unit->motion.time = time;
    record->last_event_time = fmin(record->last_event_time, time);
    record->apex.time = fmin(record->apex.time, time);
    unit->inputs = inputs;
    return event_has_happened(unit, &mark);
}

/* True if there was one. */
static bool take_pending_event(unit *unit) {
    if (!unit->event_is_pending) {
        return false;
    }
    unit->event_is_pending = false;
    if (memcmp(&unit->parameters, &unit->event_parameters, sizeof unit->parameters) != 0 ||
        memcmp(&unit->inputs, &unit->event_inputs, sizeof unit->inputs) != 0) {
        return take_event_anew(unit);
    }
    unit->motion = unit->after_event;
    return true;
}

/* The guard by which the automaton takes its next transition now, or NO_GUARD. */
static int first_due(const unit *unit) {
    const tdmf_guard guard =
        tdmf_first_due(&unit->model, &unit->inputs, &unit->motion.mode, unit->motion.state);
    return guard == TDMF_GUARD_COUNT ? NO_GUARD : (int)guard;
}

static tdmf_resolution resolve(unit *unit) {
    const bool was_pending = take_pending_event(unit);
    const double leg_work = unit->leg_work_due;
    unit->motion.state[TDMF_LEG_WORK] += leg_work;
    unit->leg_work_due = 0.0;
    tdmf_resolution resolution = tdmf_resolve(&unit->model, &unit->inputs, unit->motion.time,
                                              unit->motion.state, &unit->motion.mode, &unit->motion.record);
    resolution.state_changed |= was_pending || leg_work != 0.0;
    resolution.mode_changed |= was_pending;
    return resolution;
}

tdmf_resolution unit_update(unit *unit, const unit_observer *observer) {
    const unit_mark mark = mark_of(unit);
    const bool pending = unit->event_is_pending;
    tdmf_event event = {.guard = first_due(unit), .before = unit->motion.mode};
    memcpy(event.state, unit->motion.state, sizeof event.state);
    const tdmf_resolution resolution = resolve(unit);
    event.time = unit->motion.time;
    event.after = unit->motion.mode;
    if (pending) {
        event.guard = unit->event_guard;
    }
    if (observer->note != NULL && event.guard != NO_GUARD && event_has_happened(unit, &mark)) {
        observer->note(observer->subject, &event);
    }
    return resolution;
}

const char *unit_advance(unit *unit, double until, const unit_observer *observer) {
    const bool observed = observer->note != NULL;
    if (observed || unit->event_is_pending) {
        unit_update(unit, observer); /* an input may have jumped; unseen, that is the solver's to find */
    }
    return conclude(unit, observed ? advance_observed(unit, until, observer) : advance(unit, until), until);
}

/* Integrates for a time that the clock may be too coarse for: it is set to 0 for that, which no event takes
 * note of as long as there is none. */
static void advance_by(unit *unit, double duration) {
    static const tdmf_instant zero = {0.0, 0.0};
    unit->motion.time = zero.time;
    unit->motion.record.now = zero;
    advance(unit, duration);
}

/* Leaves `unit`, which is at the start, where an event is about to happen. Integrating up to the event's very
 * time might take it, so the last bit before it is left out: some rounding errors, or what it takes. */
static void stand_before_event(unit *unit, tdmf_instant event, const unit_mark *since) {
    const struct unit start = *unit;
    const double ahead = tdmf_time_between(instant_of(unit), event);
    double gap = 1e-13 * fmax(ahead, unit->model.scales.time);
    while (gap < ahead) {
        advance_by(unit, ahead - gap);
        if (!event_has_happened(unit, since)) {
            break;
        }
        unit->motion = start.motion;
        unit->inputs = start.inputs;
        gap *= 8.0;
    }
    unit->event_lead = gap;
    unit->motion.time = event.time;
    unit->motion.record.now = event;
}

const char *unit_advance_to_event(unit *unit, double until, const unit_observer *observer) {
    unit_update(unit, observer); /* an input may have jumped, which is no event of this step */
    const unit_mark mark = mark_of(unit);
    struct unit ahead = *unit;
    const tdmf_outcome outcome = advance_through_event(&ahead, until, &mark);
    if (!event_has_happened(&ahead, &mark)) {
        *unit = ahead;
        return conclude(unit, outcome, until);
    }
    unit->solver = ahead.solver;
    stand_before_event(unit, instant_of(&ahead), &mark);
    unit->inputs = ahead.inputs;
    unit->event_guard = ahead.event_guard;
    unit->event_parameters = ahead.parameters;
    unit->event_inputs = ahead.inputs;
    unit->after_event = ahead.motion;
    unit->event_is_pending = true;
    return NULL;
}
