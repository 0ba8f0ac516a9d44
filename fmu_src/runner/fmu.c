/* A runner with its settings, FMI left out. */
#include "variables.h"

#include "instant.h"
#include "tdmf_slip/cvode.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { NO_GUARD = -1 };

/* Events so far, to count from. */
typedef struct {
    int event_count; /* which ends at the largest int */
    double event_time;
    bool fallen;
} fmu_mark;

bool fmu_create(fmu *fmu, bool is_exchange) {
    fmu->is_exchange = is_exchange;
    return true;
}

void fmu_free(fmu *fmu) {
    (void)fmu; /* it owns nothing */
}

void fmu_reset(fmu *fmu) {
    const bool is_exchange = fmu->is_exchange;
    memset(fmu, 0, sizeof *fmu);
    fmu->is_exchange = is_exchange;
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmu_variable *variable = &fmu_variables[i];
        if (variable->settable_before_start) {
            fmu_set_number(fmu, variable, variable->start);
        }
    }
    tdmf_model_create(&fmu->model, &fmu->parameters);
    fmu->importer_tolerance = INFINITY;
    fmu->stop_time = INFINITY;
    fmu->solver = tdmf_solver_default();
}

const char *fmu_prepare(fmu *fmu, char text[FMU_TEXT]) {
    const tdmf_refusal refusal = tdmf_model_create(&fmu->model, &fmu->parameters);
    if (refusal.variable != NULL) {
        return tdmf_refusal_text(&refusal, text, FMU_TEXT);
    }
    fmu->solver.relative_tolerance = fmin(fmu->settings.solver.relative_tolerance, fmu->importer_tolerance);
    return NULL;
}

const char *fmu_start(fmu *fmu, char text[FMU_TEXT]) {
    struct fmu ready = *fmu;
    if (fmu_prepare(&ready, text) != NULL) {
        return text;
    }
    const tdmf_refusal refusal = tdmf_start(fmu_system(&ready), &ready.motion);
    if (refusal.variable != NULL) {
        return tdmf_refusal_text(&refusal, text, FMU_TEXT);
    }
    ready.accounted_leg = tdmf_leg_sample_of(ready.motion.time, ready.motion.state);
    *fmu = ready;
    return NULL;
}

bool fmu_has_begun(const fmu *fmu) {
    return fmu->motion.mode.contact != 0;
}

double fmu_time(const fmu *fmu) {
    return fmu->motion.time;
}

void fmu_set_time(fmu *fmu, double time) {
    fmu->motion.time = time;
}

static int as_integer(int64_t count) {
    return count < INT_MAX ? (int)count : INT_MAX;
}

void fmu_evaluate(const fmu *fmu, fmu_view *view) {
    tdmf_derivatives(fmu_system(fmu), &fmu->motion.mode, fmu->motion.state, view->derivatives);
    view->outputs = tdmf_outputs_of(fmu_system(fmu), &fmu->motion);
    fmu_event_indicators(fmu, view->guards);
    view->work.solver.steps = as_integer(fmu->solver.steps);
    view->work.solver.evaluations = as_integer(fmu->solver.evaluations);
    view->work.solver.layer_steps = as_integer(fmu->solver.layer_steps);
    memcpy(view->states, fmu->motion.state, sizeof view->states);
}

static void differentiate(const fmu *fmu, const tdmf_seed *seed, const tdmf_variation *variation,
                          fmu_view *view) {
    const tdmf_motion *motion = &fmu->motion;
    const tdmf_output_variation varied =
        tdmf_vary_outputs(fmu_system(fmu), &motion->mode, motion->state, seed, variation);
    memset(view, 0, sizeof *view);
    memcpy(view->derivatives, varied.derivatives, sizeof view->derivatives);
    memcpy(view->states, variation->state, sizeof view->states);
    view->outputs.body.x = varied.body.x;
    view->outputs.body.y = varied.body.y;
    view->outputs.body.vx = varied.body.vx;
    view->outputs.body.vy = varied.body.vy;
    view->outputs.com.x = varied.com.x;
    view->outputs.com.y = varied.com.y;
    view->outputs.com.vx = varied.com.vx;
    view->outputs.com.vy = varied.com.vy;
    view->outputs.contact.fx = varied.contact_fx;
    view->outputs.contact.fy = varied.contact_fy;
    view->outputs.contact.normal = varied.contact.normal;
    view->outputs.contact.tangential = varied.contact.tangential;
    view->outputs.leg.force = varied.leg_force;
    view->outputs.hip.torque = varied.torque;
    view->outputs.energy.kinetic = varied.energy.kinetic;
    view->outputs.energy.potential = varied.energy.potential;
    view->outputs.energy.elastic = varied.energy.elastic;
    view->outputs.energy.total = varied.energy.total;
}

void fmu_differentiate(const fmu *fmu, const struct fmu *seed, fmu_view *variation) {
    tdmf_seed model_seed = {seed->parameters, seed->inputs};
    tdmf_variation of_state = {.liftoff_angle = 0.0};
    memcpy(of_state.state, seed->motion.state, sizeof of_state.state);
    model_seed.inputs.ground.height = 0.0; /* a new line is in force from an event on */
    model_seed.inputs.ground.slope = 0.0;
    differentiate(fmu, &model_seed, &of_state, variation);
}

/* Where the run starts at an apex, the section is latched. */
static void differentiate_apex(const double of_state[TDMF_STATE_COUNT], double com_height, double time,
                               tdmf_outputs *variation) {
    variation->apex.time = time;
    variation->apex.com_height = com_height;
    variation->apex.com_speed = variation->com.vx;
    variation->apex.leg_length = of_state[TDMF_LEG_LENGTH];
    variation->apex.leg_angle = of_state[TDMF_LEG_ANGLE];
    variation->apex.leg_length_rate = of_state[TDMF_LEG_LENGTH_RATE];
    variation->apex.leg_angle_rate = of_state[TDMF_LEG_ANGLE_RATE];
}

void fmu_differentiate_start(const fmu *given, const struct fmu *started, struct fmu *seed,
                             fmu_view *variation) {
    const tdmf_seed model_seed = {seed->parameters, seed->inputs};
    const tdmf_start_variation start =
        tdmf_vary_start(fmu_system(started), given->motion.state, started->motion.state,
                        &started->motion.mode, &model_seed, seed->motion.state);
    differentiate(started, &model_seed, &start.variation, variation);
    variation->outputs.hip.liftoff_angle = start.variation.liftoff_angle;
    variation->outputs.energy.impact_loss = start.impact_loss;
    variation->outputs.event.last_time = seed->motion.time;
    if (started->motion.record.progress.open.began_at_apex) {
        differentiate_apex(start.variation.state, start.com_height, seed->motion.time, &variation->outputs);
    }
    for (int i = TDMF_MECHANICAL_COUNT; i < TDMF_STATE_COUNT; ++i) {
        seed->motion.state[i] = variation->states[i]; /* calculated at the start */
    }
}

void fmu_flow(const fmu *fmu, struct fmu *seed) {
    memset(seed, 0, sizeof *seed);
    tdmf_derivatives(fmu_system(fmu), &fmu->motion.mode, fmu->motion.state, seed->motion.state);
    seed->inputs = fmu->input_rates;
}

void fmu_states(const fmu *fmu, const fmu_view *view, double states[]) {
    memcpy(states, fmu->motion.state, sizeof fmu->motion.state);
    if (view != NULL) { /* the start calculates those that have no start value */
        memcpy(states + TDMF_MECHANICAL_COUNT, view->states + TDMF_MECHANICAL_COUNT,
               (TDMF_STATE_COUNT - TDMF_MECHANICAL_COUNT) * sizeof *states);
    }
}

void fmu_try_states(fmu *fmu, const double state[]) {
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        fmu->motion.state[i] = fmu_within_largest(state[i]);
    }
}

void fmu_derivatives(const fmu *fmu, double derivatives[]) {
    tdmf_derivatives(fmu_system(fmu), &fmu->motion.mode, fmu->motion.state, derivatives);
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        derivatives[i] = fmu_within_largest(derivatives[i]);
    }
}

void fmu_event_indicators(const fmu *fmu, double indicators[]) {
    tdmf_guards(fmu_system(fmu), &fmu->motion.mode, fmu->motion.state, indicators);
}

void fmu_nominals(const fmu *fmu, double nominals[]) {
    tdmf_state_scales(&fmu->model, nominals);
}

/* leg.extension has no rate in Model Exchange, and may change between events all the same. An update accounts
 * for the leg's work up to here, before inputs may jump. */
static void account_for_extension(fmu *fmu) {
    const tdmf_leg_sample leg = tdmf_leg_sample_of(fmu->motion.time, fmu->motion.state);
    fmu->leg_work_due +=
        tdmf_account_for_extension(fmu_system(fmu), &fmu->accounted_leg, &leg, &fmu->motion.mode);
    fmu->accounted_leg = leg;
}

bool fmu_complete_step(fmu *fmu) {
    if (!tdmf_rest_length_is_accounted_for(fmu_system(fmu), &fmu->motion.mode)) {
        return true;
    }
    account_for_extension(fmu); /* no work, from here on */
    return false;
}

void fmu_enter_event_mode(fmu *fmu) {
    tdmf_observe(fmu_system(fmu), &fmu->motion);
    if (fmu->is_exchange) {
        account_for_extension(fmu);
    }
}

bool fmu_asks_to_terminate(const fmu *fmu) {
    return fmu->is_exchange && fmu->motion.mode.fallen && fmu->settings.status.terminate_on_fall;
}

double fmu_longest_step(const fmu *fmu) {
    return tdmf_longest_step(fmu_system(fmu), &fmu->motion.mode, fmu->motion.state);
}

bool fmu_has_solver(const fmu *fmu) {
    return fmu->settings.solver.method != SOLVER_CVODE || tdmf_cvode_is_available();
}

/* ---- messages ------------------------------------------------------------------------------------------ */

static const char *name_of_guard(int guard) {
    static const char group[] = "guard.";
    size_t i = 0;
    while (fmu_variables[i].storage != STORED_GUARD || fmu_variables[i].offset != (size_t)guard) {
        ++i;
    }
    return fmu_variables[i].name + sizeof group - 1;
}

/* The clamp of the hip torque and the peak of the ground force are the solver's events, not the runner's. */
static bool is_event_of_runner(const tdmf_event *event) {
    return event->guard == TDMF_GUARD_TOUCHDOWN || event->before.contact != event->after.contact ||
           event->before.phase != event->after.phase || event->before.fallen != event->after.fallen;
}

static void report(const fmu_observer *observer, const tdmf_event *event) {
    const tdmf_mode *before = &event->before;
    const tdmf_mode *after = &event->after;
    char text[FMU_TEXT], time[TIME_CAPACITY];
    if (is_event_of_runner(event)) {
        snprintf(text, sizeof text, "%s at %s s: %s, %s -> %s, %s%s", name_of_guard(event->guard),
                 time_text(event->time, time), fmu_contact_mode_names[before->contact - 1],
                 fmu_hip_phase_names[before->phase - 1], fmu_contact_mode_names[after->contact - 1],
                 fmu_hip_phase_names[after->phase - 1], after->fallen ? ", fallen" : "");
        observer->on_event(observer->subject, text);
    }
}

/* ---- Co-Simulation ------------------------------------------------------------------------------------- */

static tdmf_outcome advance(fmu *fmu, double until) {
    const tdmf_instant start = tdmf_instant_of(&fmu->motion);
    const bool by_cvode = fmu->settings.solver.method == SOLVER_CVODE;
    const tdmf_outcome outcome = (by_cvode ? tdmf_cvode_advance : tdmf_native_advance)(
        &fmu->solver, fmu_system(fmu), &fmu->input_rates, until, &fmu->motion);
    fmu->inputs = tdmf_inputs_after(&fmu->inputs, &fmu->input_rates,
                                    tdmf_time_between(start, tdmf_instant_of(&fmu->motion)));
    return outcome;
}

static void report_to(void *observer, const tdmf_event *event) {
    report(observer, event);
}

/* Advances and reports every event. */
static tdmf_outcome advance_observed(fmu *fmu, double until, const fmu_observer *observer) {
    fmu_observer own = *observer;
    fmu->solver.on_event = report_to;
    fmu->solver.subject = &own;
    const tdmf_outcome outcome = advance(fmu, until);
    fmu->solver.on_event = NULL;
    fmu->solver.subject = NULL;
    return outcome;
}

/* Completes a run that has ended, or arrived at `until`. */
static const char *conclude(fmu *fmu, tdmf_outcome outcome, double until) {
    if (outcome == TDMF_FELL) {
        fmu->inputs = tdmf_inputs_after(&fmu->inputs, &fmu->input_rates, until - fmu->motion.time);
        fmu->motion.time = until;
    }
    return outcome == TDMF_ARRIVED || outcome == TDMF_FELL ? NULL : tdmf_outcome_text(outcome);
}

/* ---- up to the first event ---------------------------------------------------------------------------- */

static fmu_mark mark_of(const fmu *fmu) {
    const tdmf_motion *motion = &fmu->motion;
    const fmu_mark mark = {motion->record.event_count, motion->record.last_event_time, motion->mode.fallen};
    return mark;
}

static bool event_has_happened(const fmu *fmu, const fmu_mark *since) {
    const fmu_mark now = mark_of(fmu);
    return now.event_count != since->event_count || now.event_time != since->event_time ||
           now.fallen != since->fallen;
}

/* Advances until an event has been taken, and notes its guard; the clamp, which is none of FMI's business,
 * counts with the solver's events only. */
static tdmf_outcome advance_through_event(fmu *fmu, double until, const fmu_mark *since) {
    const long limit = fmu->solver.event_limit;
    tdmf_outcome outcome = TDMF_TOO_MANY_EVENTS;
    tdmf_event_log log;
    log.count = 0;
    fmu->solver.event_limit = 1;
    fmu->solver.log = &log;
    for (long i = 0; i < limit && outcome == TDMF_TOO_MANY_EVENTS && !event_has_happened(fmu, since); ++i) {
        log.count = 0;
        outcome = advance(fmu, until);
    }
    fmu->solver.event_limit = limit;
    fmu->solver.log = NULL;
    fmu->event_guard = log.count > 0 ? log.events[0].guard : NO_GUARD;
    return outcome;
}

/* An event that is due at `time` is seen to be due up to here: a little after its guard's zero. */
static double time_seen_due(const fmu *fmu, double time) {
    const double after = fmax(2.0 * fmu->event_lead, 1e-10 * fmu->model.scales.time);
    return fmax(time + after, nextafter(time, INFINITY));
}

/* The event, under inputs or settings that were set since it was found: it may be another one by now, or
 * none. */
static bool take_event_anew(fmu *fmu) {
    const tdmf_motion before = fmu->motion;
    const double time = before.time;
    const tdmf_inputs inputs = fmu->inputs;
    const fmu_mark mark = mark_of(fmu);
    tdmf_record *record = &fmu->motion.record;
    advance_through_event(fmu, time_seen_due(fmu, time), &mark);
    if (!event_has_happened(fmu, &mark)) {
        fmu->motion = before;
    }
    fmu->motion.time = time;
    record->last_event_time = fmin(record->last_event_time, time);
    record->apex.time = fmin(record->apex.time, time);
    fmu->inputs = inputs;
    return event_has_happened(fmu, &mark);
}

/* True if there was one. */
static bool take_pending_event(fmu *fmu) {
    if (!fmu->event_is_pending) {
        return false;
    }
    fmu->event_is_pending = false;
    if (memcmp(&fmu->parameters, &fmu->event_parameters, sizeof fmu->parameters) != 0 ||
        memcmp(&fmu->inputs, &fmu->event_inputs, sizeof fmu->inputs) != 0) {
        return take_event_anew(fmu);
    }
    fmu->motion = fmu->after_event;
    return true;
}

/* The guard by which the automaton takes its next transition now, or NO_GUARD. */
static int first_due(const fmu *fmu) {
    const tdmf_guard guard = tdmf_first_due(fmu_system(fmu), &fmu->motion.mode, fmu->motion.state);
    return guard == TDMF_GUARD_COUNT ? NO_GUARD : (int)guard;
}

static tdmf_resolution resolve(fmu *fmu) {
    const bool was_pending = take_pending_event(fmu);
    const double leg_work = fmu->leg_work_due;
    fmu->motion.state[TDMF_LEG_WORK] += leg_work;
    fmu->leg_work_due = 0.0;
    tdmf_resolution resolution = tdmf_resolve(fmu_system(fmu), &fmu->motion);
    resolution.state_changed |= was_pending || leg_work != 0.0;
    resolution.mode_changed |= was_pending;
    return resolution;
}

fmu_resolution fmu_update(fmu *fmu, const fmu_observer *observer) {
    const fmu_mark mark = mark_of(fmu);
    const bool pending = fmu->event_is_pending;
    tdmf_event event = {.guard = first_due(fmu), .before = fmu->motion.mode};
    memcpy(event.state, fmu->motion.state, sizeof event.state);
    const tdmf_resolution resolution = resolve(fmu);
    event.time = fmu->motion.time;
    event.after = fmu->motion.mode;
    if (pending) {
        event.guard = fmu->event_guard;
    }
    if (observer->on_event != NULL && event.guard != NO_GUARD && event_has_happened(fmu, &mark)) {
        report(observer, &event);
    }
    const fmu_resolution found = {resolution.state_changed, resolution.unresolved};
    return found;
}

const char *fmu_advance(fmu *fmu, double until, const fmu_observer *observer, char text[FMU_TEXT]) {
    (void)text;
    const bool observed = observer->on_event != NULL;
    if (observed || fmu->event_is_pending) {
        fmu_update(fmu, observer); /* an input may have jumped; unseen, that is the solver's to find */
    }
    return conclude(fmu, observed ? advance_observed(fmu, until, observer) : advance(fmu, until), until);
}

/* Integrates for a time that the clock may be too coarse for: it is set to 0 for that, which no event takes
 * note of as long as there is none. */
static void advance_by(fmu *fmu, double duration) {
    static const tdmf_instant zero = {0.0, 0.0};
    fmu->motion.time = zero.time;
    fmu->motion.record.progress.now = zero;
    advance(fmu, duration);
}

/* Leaves `unit`, which is at the start, where an event is about to happen. Integrating up to the event's very
 * time might take it, so the last bit before it is left out: some rounding errors, or what it takes. */
static void stand_before_event(fmu *fmu, tdmf_instant event, const fmu_mark *since) {
    const struct fmu start = *fmu;
    const double ahead = tdmf_time_between(tdmf_instant_of(&fmu->motion), event);
    double gap = 1e-13 * fmax(ahead, fmu->model.scales.time);
    while (gap < ahead) {
        advance_by(fmu, ahead - gap);
        if (!event_has_happened(fmu, since)) {
            break;
        }
        fmu->motion = start.motion;
        fmu->inputs = start.inputs;
        gap *= 8.0;
    }
    fmu->event_lead = gap;
    fmu->motion.time = event.time;
    fmu->motion.record.progress.now = event;
}

const char *fmu_advance_to_event(fmu *fmu, double until, const fmu_observer *observer, char text[FMU_TEXT]) {
    (void)text;
    fmu_update(fmu, observer); /* an input may have jumped, which is no event of this step */
    const fmu_mark mark = mark_of(fmu);
    struct fmu ahead = *fmu;
    const tdmf_outcome outcome = advance_through_event(&ahead, until, &mark);
    if (!event_has_happened(&ahead, &mark)) {
        *fmu = ahead;
        return conclude(fmu, outcome, until);
    }
    fmu->solver = ahead.solver;
    stand_before_event(fmu, tdmf_instant_of(&ahead.motion), &mark);
    fmu->inputs = ahead.inputs;
    fmu->event_guard = ahead.event_guard;
    fmu->event_parameters = ahead.parameters;
    fmu->event_inputs = ahead.inputs;
    fmu->after_event = ahead.motion;
    fmu->event_is_pending = true;
    return NULL;
}
