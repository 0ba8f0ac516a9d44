/* The native solver. The motion is expanded into Taylor series of its present mode, searched for the first
 * event as far as the series may be trusted, and goes on from there. No step is ever refused. */
#include "tdmf_slip/solver.h"

#include "evaluation.h"
#include "event_log.h"
#include "events.h"
#include "extrema.h"
#include "greatest_compression.h"
#include "input_rates.h"
#include "instant.h"
#include "margins.h"
#include "mode_variation.h"
#include "positive_work.h"
#include "record.h"
#include "request.h"
#include "saltation.h"
#include "step.h"
#include "step_limits.h"
#include "stride_measures.h"
#include "tdmf_slip/automaton.h"
#include "tdmf_slip/dynamics.h"

#include <math.h>
#include <string.h>

/* Where an integration ends, if not sooner: at the time asked for. */
typedef enum { AT_TIME, AT_APEX, AT_LIFT_OFF, AT_GROUND } integration_end;

typedef struct {
    tdmf_solver *solver;
    const tdmf_model *model;
    integration_end end;
    tdmf_inputs inputs; /* at motion->time */
    tdmf_inputs rates;
    bool inputs_ramp;
    tdmf_motion *motion; /* its state is that of the last event; the equations may be ahead of it */
    bool equations_are_ahead;
    tdmf_leg_direction direction; /* of the state */
    double until;
    series_orders orders;
    tdmf_mode_equations equations;
    tdmf_step step;
    step_count steps;
    long events_left;
    int events_in_span;
    int false_crossings; /* since the mode changed or a step was whole */
    /* First variations, if any: as of the last event, and where the equations are. */
    int count;
    bool varies_thrust, varies_push;
    const tdmf_seed *seeds;
    tdmf_variation *variations;
    tdmf_mode_variation varied_mode[TDMF_VARIATION_LIMIT];
    motion_variation varied_series[TDMF_VARIATION_LIMIT]; /* along the step */
    tdmf_measured *measured;                              /* of the stride, or NULL */
    tdmf_guard met;                                       /* AT_GROUND: what waits to be taken */
    bool flies;                                           /* AT_GROUND: since an event */
} integration;

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

static tdmf_system system_of(const integration *integration) {
    const tdmf_system system = {integration->model, &integration->inputs};
    return system;
}

/* Begins integrating in the present mode from the present state. */
static void open_mode(integration *integration) {
    const tdmf_motion *motion = integration->motion;
    tdmf_open_mode(&integration->equations, system_of(integration), &integration->rates, &motion->mode,
                   motion->state, integration->direction);
    integration->equations.awaits_thrust |=
        integration->varies_thrust && tdmf_is_loaded(&motion->mode) && !motion->mode.thrusts;
    integration->equations.is_forced |= integration->varies_push;
    integration->equations_are_ahead = false;
    for (int i = 0; i < integration->count; ++i) {
        integration->varied_mode[i] = tdmf_open_mode_variation(
            &integration->equations, motion->state, &integration->seeds[i], &integration->variations[i]);
    }
}

static void write_state(integration *integration, double elapsed, const tdmf_mode_coordinates *coordinates) {
    double *state = integration->motion->state;
    integration->direction = tdmf_state_in_mode(&integration->equations, elapsed, coordinates, state);
    for (int i = 0; i < integration->count; ++i) {
        integration->variations[i] = tdmf_variation_in_mode(
            &integration->equations, state, &integration->seeds[i], &integration->varied_mode[i]);
    }
}

/* Variations of the ground force at its peaks in the step, where it is the same at a time that is shifted. */
static void vary_peak_forces(integration *integration, double elapsed, bool normal, bool vertical) {
    const tdmf_motion *motion = integration->motion;
    const tdmf_mode_coordinates there = tdmf_step_at(&integration->step, elapsed);
    double state[TDMF_STATE_COUNT];
    memcpy(state, motion->state, sizeof state);
    tdmf_state_in_mode(&integration->equations, elapsed, &there, state);
    const tdmf_evaluation at = tdmf_evaluate(system_of(integration), &motion->mode, state);
    for (int i = 0; i < integration->count; ++i) {
        const tdmf_seed *seed = &integration->seeds[i];
        tdmf_mode_variation varied_mode = integration->varied_mode[i];
        tdmf_advance_mode_variation(&integration->step, elapsed, seed, &integration->varied_series[i],
                                    &varied_mode);
        const tdmf_variation variation =
            tdmf_variation_in_mode(&integration->equations, state, seed, &varied_mode);
        const tdmf_local_seed d = tdmf_local_seed_of(integration->model, seed, &variation);
        const tdmf_evaluation d_at = tdmf_vary_evaluation(&at, &d, d.state);
        tdmf_stance_variation *stance = &integration->varied_mode[i].constant.stance;
        stance->peak_force = normal ? d_at.force.normal : stance->peak_force;
        stance->peak_vertical_force =
            vertical ? tdmf_vary_vector_on(&at.mode->ground, at.force, &d_at.mode->ground, d_at.force).y
                     : stance->peak_vertical_force;
    }
}

/* Whether somebody asks for the hip's positive work and the peaks of the ground force. */
static bool records_peaks_and_positive_work(const integration *integration) {
    return !integration->solver->without_peaks_and_positive_work || integration->count > 0 ||
           integration->measured;
}

/* Adds the hip's work at positive power in the step. */
static void add_positive_work(integration *integration, double end, const tdmf_mode_coordinates *reached) {
    tdmf_mode_equations *equations = &integration->equations;
    equations->positive_work +=
        tdmf_positive_work(&integration->step, end, reached->work - equations->start.work);
}

/* Notes the largest peaks of the ground force. They change nothing but the record, so the step goes on. */
static void observe_ground_force(integration *integration, double end) {
    tdmf_motion *motion = integration->motion;
    if (!tdmf_in_contact(&motion->mode)) {
        return;
    }
    const tdmf_force_peaks peaks = tdmf_largest_peaks(&integration->step, end, &motion->mode);
    const bool normal = peaks.normal.force > motion->record.progress.open.peak_force;
    const bool vertical = peaks.vertical.force > motion->record.progress.open.peak_vertical_force;
    const bool at_once = normal && peaks.normal.time == peaks.vertical.time;
    tdmf_record_force(&motion->record, peaks.normal.force, peaks.vertical.force);
    if (normal) {
        vary_peak_forces(integration, peaks.normal.time, true, vertical && at_once);
    }
    if (vertical && !at_once) {
        vary_peak_forces(integration, peaks.vertical.time, false, true);
    }
}

/* Notes the greatest compression where it is no event: a thrust that is set later acts at once. */
static void observe_leg(integration *integration, double end) {
    tdmf_mode *mode = &integration->motion->mode;
    if (tdmf_is_loaded(mode) && !mode->thrusts && !integration->equations.awaits_thrust) {
        mode->thrusts = tdmf_leg_lengthens(&integration->step, end);
    }
}

/* A friction that falls stays at zero from then on. */
static double time_to_no_friction(const integration *integration) {
    return integration->rates.ground.friction < 0.0
               ? integration->inputs.ground.friction / -integration->rates.ground.friction
               : INFINITY;
}

static double time_left(const integration *integration) {
    const tdmf_instant until = {integration->until, 0.0};
    return tdmf_time_between(integration->motion->record.progress.now, until);
}

static void move_time(integration *integration, double elapsed) {
    tdmf_motion *motion = integration->motion;
    const tdmf_instant until = {integration->until, 0.0};
    motion->record.progress.now =
        elapsed < time_left(integration) ? tdmf_instant_after(motion->record.progress.now, elapsed) : until;
    motion->time = motion->record.progress.now.time;
}

static void move_inputs(integration *integration, double elapsed) {
    const bool friction_ends = elapsed >= time_to_no_friction(integration);
    if (!integration->inputs_ramp) {
        return;
    }
    integration->inputs = tdmf_inputs_after(&integration->inputs, &integration->rates, elapsed);
    if (friction_ends) {
        integration->inputs.ground.friction = 0.0;
        integration->rates.ground.friction = 0.0;
        tdmf_end_friction(&integration->equations);
    }
    integration->motion->mode.rest_length =
        tdmf_rest_length(integration->model, &integration->inputs, &integration->motion->mode);
}

static tdmf_event_state event_state_of(const integration *integration) {
    const tdmf_motion *motion = integration->motion;
    tdmf_event_state event_state;
    memcpy(event_state.state, motion->state, sizeof event_state.state);
    event_state.mode = motion->mode;
    event_state.peak_force = motion->record.progress.open.peak_force;
    event_state.peak_vertical_force = motion->record.progress.open.peak_vertical_force;
    tdmf_derivatives(system_of(integration), &event_state.mode, event_state.state, event_state.derivatives);
    return event_state;
}

static bool stance_is_over(const integration *integration) {
    return integration->end == AT_LIFT_OFF && !tdmf_in_contact(&integration->motion->mode);
}

/* A stance that is looked at alone has all of its work behind it. */
static tdmf_event_state event_state_after(const integration *integration) {
    tdmf_event_state event_state = event_state_of(integration);
    if (stance_is_over(integration)) {
        event_state.derivatives[TDMF_HIP_WORK] = 0.0;
    }
    return event_state;
}

static void log_event(const tdmf_solver *log, double time, tdmf_guard guard, const tdmf_event_state *before,
                      const tdmf_mode *after) {
    tdmf_event event = {.time = time, .guard = (int)guard, .before = before->mode, .after = *after};
    memcpy(event.state, before->state, sizeof event.state);
    tdmf_log_event(log, &event);
}

/* A stance that is looked at alone has no graze after it. */
static void end_thrust(integration *integration) {
    tdmf_motion *motion = integration->motion;
    tdmf_run run = {system_of(integration), motion, integration->direction};
    tdmf_end_thrust(&run);
}

static bool take_transitions(integration *integration, tdmf_guard reached) {
    tdmf_motion *motion = integration->motion;
    const tdmf_resolution taken =
        records_peaks_and_positive_work(integration)
            ? tdmf_resolve_along(system_of(integration), motion, integration->direction, reached)
            : tdmf_resolve_unobserved(system_of(integration), motion, integration->direction, reached);
    if (stance_is_over(integration)) {
        end_thrust(integration);
    }
    if (taken.unresolved) {
        integration->events_left = 0;
    }
    /* A thrust of 0 changes no mode, but whoever varies it asks for its event. */
    const bool thrusts = integration->equations.awaits_thrust && motion->mode.thrusts;
    integration->false_crossings = taken.mode_changed || thrusts ? 0 : integration->false_crossings + 1;
    return taken.state_changed || taken.mode_changed || thrusts;
}

/* Takes what is due now, on the motion and on its variations. Nothing may be: series know a guard up to the
 * tolerance, and the model finds it above its margin still. */
static bool resolve(integration *integration, const tdmf_step_end *end) {
    tdmf_motion *motion = integration->motion;
    tdmf_met_event met[TDMF_VARIATION_LIMIT];
    if (integration->count == 0 && !integration->solver->log && !integration->measured) {
        return take_transitions(integration, end->reached);
    }
    const tdmf_event_state before = event_state_of(integration);
    if (!take_transitions(integration, end->reached)) {
        return false;
    }
    const tdmf_event_state after = event_state_after(integration);
    log_event(integration->solver, motion->time, end->guard, &before, &after.mode);
    for (int i = 0; i < integration->count; ++i) {
        integration->variations[i] =
            tdmf_saltation(system_of(integration), end->guard, &before, &after, &integration->seeds[i],
                           &integration->variations[i], &met[i]);
    }
    if (integration->measured) {
        tdmf_measure_event(integration->measured, system_of(integration), &before, &after, integration->seeds,
                           met, integration->count);
    }
    return true;
}

static bool meets_ground(tdmf_guard guard) {
    return guard == TDMF_GUARD_TOUCHDOWN || guard == TDMF_GUARD_NEW_GROUND;
}

static bool flies(const integration *integration) {
    return integration->motion->mode.contact == TDMF_CONTACT_FLIGHT;
}

/* Takes the event that ends a step. */
static void stop_at_event(integration *integration, const tdmf_step_end *end,
                          const tdmf_mode_coordinates *reached) {
    --integration->events_left;
    write_state(integration, end->time, reached);
    move_time(integration, end->time);
    move_inputs(integration, end->time);
    if (integration->end == AT_GROUND && meets_ground(end->reached)) {
        integration->met = end->reached;
        integration->equations_are_ahead = false;
        return;
    }
    const bool flew = flies(integration);
    integration->solver->events += resolve(integration, end);
    integration->flies = flies(integration) && !flew;
    ++integration->events_in_span;
    open_mode(integration);
}

static void go_on(integration *integration, double elapsed, const tdmf_mode_coordinates *reached) {
    move_time(integration, elapsed);
    tdmf_shift_mode(&integration->equations, elapsed, reached);
    integration->equations_are_ahead = true;
    integration->false_crossings = 0;
    move_inputs(integration, elapsed);
}

static bool are_finite(const tdmf_mode_coordinates *c) {
    double coordinates[sizeof *c / sizeof(double)], sum = 0.0;
    memcpy(coordinates, c, sizeof coordinates);
    for (size_t i = 0; i < sizeof coordinates / sizeof coordinates[0]; ++i) {
        sum += coordinates[i];
    }
    return is_finite(sum);
}

/* The law of a mode that is opened tells whether it is too stiff. Slip and graze may be over before it
 * matters. */
static bool mode_is_too_stiff(const integration *integration) {
    const tdmf_contact_mode contact = integration->equations.contact;
    const bool lasts = contact == TDMF_CONTACT_FLIGHT || contact == TDMF_CONTACT_STICK;
    return lasts && !integration->equations_are_ahead &&
           opens_too_stiff(integration->step.longest,
                           real_min(integration->model->scales.time, time_left(integration)));
}

/* Whether one more step may be made, by the limits of a call and of stiffness. */
static tdmf_outcome may_step(const integration *integration) {
    if (no_steps_left(&integration->steps)) {
        return TDMF_TOO_MANY_STEPS;
    }
    if (!takes_too_many_steps(&integration->steps, integration->model->scales.time)) {
        return TDMF_ARRIVED;
    }
    return 2 * integration->events_in_span > TDMF_STIFFNESS_LIMIT ? TDMF_TOO_MANY_EVENTS : TDMF_TOO_STIFF;
}

static void count_one_step(integration *integration, double time) {
    const double scale = integration->model->scales.time;
    if (span_is_over(&integration->steps, scale)) {
        integration->events_in_span = 0;
    }
    count_step(&integration->steps, time, scale);
}

/* What ramps of inputs do along the step. */
static void add_ramps(const integration *integration, double elapsed, tdmf_mode_coordinates *reached) {
    if (integration->inputs_ramp && integration->equations.is_forced) {
        reached->leg_work += tdmf_step_leg_work(&integration->step, elapsed);
        reached->shortfall += tdmf_step_shortfall(&integration->step, elapsed);
    }
}

/* A push that grows may have turned a fall in place into a rise. */
static void update_rising(integration *integration) {
    tdmf_mode *mode = &integration->motion->mode;
    const double threshold = TDMF_DEAD_BAND * integration->model->scales.speed;
    if (integration->inputs_ramp && mode->contact == TDMF_CONTACT_FLIGHT && !mode->rises) {
        mode->rises = integration->equations.com.vy > threshold;
    }
}

/* Expands the variations, and shortens the step to what all of them can be trusted for. */
static void expand_variations(integration *integration) {
    tdmf_step *step = &integration->step;
    for (int i = 0; i < integration->count; ++i) {
        const double trusted =
            tdmf_expand_mode_variation(step, &integration->motion->mode, &integration->seeds[i],
                                       &integration->varied_mode[i], &integration->varied_series[i]);
        /* A size that is not a number stays one. */
        step->size = trusted < step->size ? trusted : step->size;
    }
}

static void measure_step(integration *integration, const tdmf_step_end *end) {
    const tdmf_measured_step taken = {.step = &integration->step,
                                      .motion = integration->motion,
                                      .end = end->time,
                                      .ends_at_event = end->is_event,
                                      .count = integration->count,
                                      .seeds = integration->seeds,
                                      .varied_mode = integration->varied_mode,
                                      .varied_series = integration->varied_series};
    tdmf_measure_step(integration->measured, &taken);
}

/* What the laws make of the step is the same in a whole mode, unless they drift. */
static void open_step(integration *integration) {
    const tdmf_mode_equations *equations = &integration->equations;
    const double margin_factor = tdmf_margin_factor(integration->false_crossings);
    if (!integration->equations_are_ahead || equations->drifts ||
        integration->step.margin_factor != margin_factor) {
        tdmf_step_open(&integration->step, equations, &integration->motion->mode, margin_factor);
    }
}

static tdmf_outcome advance_once(integration *integration) {
    tdmf_motion *motion = integration->motion;
    tdmf_step *step = &integration->step;
    const tdmf_outcome allowed = may_step(integration);
    if (allowed != TDMF_ARRIVED) {
        return allowed;
    }
    ++integration->solver->steps;
    update_rising(integration);
    open_step(integration);
    tdmf_step_expand(step, integration->orders, integration->solver->relative_tolerance);
    integration->solver->evaluations += step->order;
    integration->solver->layer_steps += step->in_layer;
    if (mode_is_too_stiff(integration)) {
        return TDMF_TOO_STIFF;
    }
    expand_variations(integration);
    if (integration->measured) {
        const double trusted = tdmf_measures_trust(step);
        step->size = trusted < step->size ? trusted : step->size;
    }
    if (!(step->size > 0.0)) {
        return TDMF_NO_PROGRESS;
    }
    tdmf_step_shorten(step, real_min(time_left(integration), time_to_no_friction(integration)));
    const tdmf_step_end end = tdmf_step_find_end(step, &motion->mode);
    tdmf_mode_coordinates reached = tdmf_step_at(step, end.time);
    add_ramps(integration, end.time, &reached);
    if (!are_finite(&reached)) {
        return TDMF_NO_PROGRESS;
    }
    count_one_step(integration, end.time);
    if (records_peaks_and_positive_work(integration)) {
        observe_ground_force(integration, end.time);
        add_positive_work(integration, end.time, &reached);
    }
    observe_leg(integration, end.time);
    if (integration->measured) {
        measure_step(integration, &end);
    }
    for (int i = 0; i < integration->count; ++i) {
        tdmf_advance_mode_variation(step, end.time, &integration->seeds[i], &integration->varied_series[i],
                                    &integration->varied_mode[i]);
    }
    if (end.is_event) {
        stop_at_event(integration, &end, &reached);
    } else {
        go_on(integration, end.time, &reached);
    }
    return TDMF_ARRIVED;
}

static bool begin(integration *integration, tdmf_solver *solver, tdmf_system system, const tdmf_inputs *rates,
                  double until, tdmf_motion *motion) {
    if (!tdmf_is_sound_request(solver, system, rates, until, motion)) {
        return false;
    }
    integration->solver = solver;
    integration->model = system.model;
    integration->end = AT_TIME;
    integration->inputs = *system.inputs;
    integration->rates = *rates;
    integration->inputs_ramp = !tdmf_are_zero_rates(rates);
    integration->motion = motion;
    integration->until = until;
    motion->record.progress.now = tdmf_instant_of(motion);
    integration->orders = tdmf_step_orders(solver->relative_tolerance);
    integration->steps = opened_steps((double)solver->step_limit);
    integration->events_left = solver->event_limit;
    integration->false_crossings = 0;
    integration->count = 0;
    integration->measured = NULL;
    integration->varies_thrust = integration->varies_push = false;
    integration->events_in_span = 0;
    integration->met = TDMF_GUARD_COUNT;
    integration->flies = false;
    /* An input may have jumped since the last call. */
    integration->direction = tdmf_leg_direction_of(motion->state);
    if (tdmf_resolve_along(system, motion, integration->direction, TDMF_GUARD_COUNT).unresolved) {
        integration->events_left = 0;
    }
    open_mode(integration);
    return true;
}

static bool is_at_end(const integration *integration, int strides_before) {
    const bool closed = integration->motion->record.stride.count > strides_before;
    switch (integration->end) {
    case AT_APEX:
        return closed;
    case AT_GROUND:
        return closed || integration->met != TDMF_GUARD_COUNT || integration->flies;
    default:
        return stance_is_over(integration);
    }
}

static tdmf_outcome advance(integration *integration) {
    tdmf_motion *motion = integration->motion;
    const int count = motion->record.stride.count;
    tdmf_outcome outcome = TDMF_ARRIVED;
    while (outcome == TDMF_ARRIVED && time_left(integration) > 0.0 && !motion->mode.fallen &&
           !is_at_end(integration, count)) {
        outcome = integration->events_left <= 0 ? TDMF_TOO_MANY_EVENTS : advance_once(integration);
    }
    if (integration->equations_are_ahead) {
        write_state(integration, 0.0, &integration->equations.start);
    }
    if (outcome != TDMF_ARRIVED) {
        return outcome;
    }
    /* The caller may change an input now. */
    tdmf_observe(system_of(integration), motion);
    return motion->mode.fallen ? TDMF_FELL : TDMF_ARRIVED;
}

static tdmf_stride_outcome advance_a_stride(integration *integration) {
    const tdmf_record *record = &integration->motion->record;
    const int count = record->stride.count;
    integration->end = AT_APEX;
    const tdmf_outcome outcome = advance(integration);
    const tdmf_stride_outcome result = {outcome, record->stride.count > count};
    integration->solver->strides += result.closed;
    return result;
}

static const tdmf_stride_outcome refused = {TDMF_REFUSED, false};

tdmf_stride_outcome tdmf_native_to_ground(tdmf_solver *solver, tdmf_system system, double until,
                                          tdmf_motion *motion, tdmf_guard *reached) {
    integration integration;
    *reached = TDMF_GUARD_COUNT;
    if (!begin(&integration, solver, system, tdmf_rates_or_zero(NULL), until, motion)) {
        return refused;
    }
    const int count = motion->record.stride.count;
    integration.end = AT_GROUND;
    const tdmf_outcome outcome = advance(&integration);
    *reached = integration.met;
    const tdmf_stride_outcome result = {outcome, motion->record.stride.count > count};
    return result;
}

static bool begin_varied(integration *integration, tdmf_solver *solver, tdmf_system system, double until,
                         tdmf_motion *motion, const tdmf_seed *seeds, tdmf_variation *variations, int count) {
    if (!tdmf_are_sound_seeds(seeds, count, TDMF_VARIATION_LIMIT) || (count > 0 && variations == NULL) ||
        !begin(integration, solver, system, tdmf_rates_or_zero(NULL), until, motion)) {
        return false;
    }
    integration->count = count;
    integration->seeds = seeds;
    integration->variations = variations;
    for (int i = 0; i < count; ++i) {
        integration->varies_thrust |=
            seeds[i].parameters.leg.thrust != 0.0 || seeds[i].inputs.control.thrust != 0.0;
        integration->varies_push |= tdmf_is_pushed(&seeds[i].inputs);
    }
    open_mode(integration);
    return true;
}

tdmf_stride_outcome tdmf_map_stride(tdmf_solver *solver, tdmf_system system, double until,
                                    tdmf_motion *motion, const tdmf_seed *seeds, tdmf_variation *variations,
                                    int count) {
    integration integration;
    return begin_varied(&integration, solver, system, until, motion, seeds, variations, count)
               ? advance_a_stride(&integration)
               : refused;
}

tdmf_stride_outcome tdmf_native_stride_measured(tdmf_solver *solver, tdmf_system system, double until,
                                                tdmf_motion *motion, const tdmf_seed *seeds,
                                                tdmf_variation *variations, int count,
                                                tdmf_measured *measured) {
    integration integration;
    if (!begin_varied(&integration, solver, system, until, motion, seeds, variations, count)) {
        return refused;
    }
    tdmf_measure_start(measured, system.model, motion, seeds, variations, count);
    integration.measured = measured;
    const tdmf_stride_outcome outcome = advance_a_stride(&integration);
    tdmf_measure_end(measured, motion);
    return outcome;
}

tdmf_stride_outcome tdmf_native_stance(tdmf_solver *solver, tdmf_system system, double until,
                                       tdmf_motion *motion, const tdmf_seed *seeds,
                                       tdmf_variation *variations, int count) {
    integration integration;
    if (!begin_varied(&integration, solver, system, until, motion, seeds, variations, count)) {
        return refused;
    }
    integration.end = AT_LIFT_OFF;
    const tdmf_outcome outcome = advance(&integration);
    const tdmf_stride_outcome result = {outcome, stance_is_over(&integration)};
    solver->strides += result.closed;
    return result;
}
