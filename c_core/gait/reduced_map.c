/* The reduced map: strides of its own page, whose parameters and states are some of the runner's page. A
 * stride runs to touchdown, to lift-off and to the next apex, as the times allowed for these parts differ. */

#include "event_log.h"
#include "ground_line.h"
#include "kinematics.h"
#include "mapped_stride.h"
#include "page_fields.h"
#include "page_solver.h"
#include "reduced_stride.h"
#include "refusal.h"
#include "request.h"
#include "tdmf_slip/automaton.h"

#include <math.h>
#include <string.h>

enum { STATES = TDMF_PAGE_STATE_COUNT, PARAMETERS = TDMF_PAGE_PARAMETER_COUNT };

/* Longest time of a stride in the runner's unit of time, even if the caller sets no limit. */
static const double longest_time = 1e12;

/* The log of a stride that is made alone. */
typedef struct {
    tdmf_event_row rows[TDMF_EVENT_CAPACITY];
    double states[TDMF_EVENT_CAPACITY * STATES];
} event_rows;

typedef tdmf_reduced_stride stride;

/* ---- the runner's page --------------------------------------------------------------------------------- */

static runner_states states_of(const tdmf_page_part *page, const double *own) {
    runner_states x;
    memset(&x, 0, sizeof x);
    tdmf_give_states(page, own, &x);
    return x;
}

/* A point of the runner's page with the leg placed for touchdown; after lift-off, with the leg as it left the
 * ground. Modes that only the map's page has use the world's coordinates, as the fallen runner does. */
static tdmf_page_point point_at(const stride *s, const double *x, int mode, double time) {
    const int mode_of_runner = tdmf_mode_in_whole(s->page, mode);
    const tdmf_page_point point = {
        .p = tdmf_page_parameters(&s->system.model->parameters, s->system.inputs),
        .x = states_of(s->page, x),
        .mode = mode_of_runner >= 0 ? mode_of_runner : MODE_fallen,
        .time = time,
    };
    return point;
}

/* `last_mode`: the mode in which the runner fell, if it has. */
static tdmf_motion motion_at(const stride *s, const double *x, int mode, int last_mode, double time) {
    const tdmf_page_point point = point_at(s, x, mode, time);
    tdmf_motion motion = s->start;
    tdmf_motion_of_page(s->system, &point, tdmf_mode_in_whole(s->page, last_mode), &motion);
    return motion;
}

/* ---- the start ----------------------------------------------------------------------------------------- */

/* Writes the states of a run at its first apex, with the leg at rest. `inputs` has the states before it. */
static void enter(const tdmf_page_part *page, const double *p, const double *apex, double *inputs,
                  double *x) {
    memcpy(x, inputs, (size_t)page->model->state_count * sizeof *x);
    page->model->sections->enter(p, inputs, apex, x);
}

static void read_system(const tdmf_page_part *page, tdmf_system system, double *p, double *x) {
    const runner_parameters parameters = tdmf_page_parameters(&system.model->parameters, system.inputs);
    runner_states inputs = states_of(page, page->model->state_defaults);
    tdmf_write_page_inputs(system.inputs, &inputs);
    tdmf_take_parameters(page, &parameters, p);
    tdmf_take_states(page, &inputs, x);
}

void tdmf_reduced_state(tdmf_system system, const double apex[TDMF_REDUCED_COUNT],
                        double state[TDMF_STATE_COUNT]) {
    double p[PARAMETERS], inputs[STATES], x[STATES];
    read_system(&tdmf_reduced_runner_part, system, p, inputs);
    enter(&tdmf_reduced_runner_part, p, apex, inputs, x);
    const runner_states world = states_of(&tdmf_reduced_runner_part, x);
    memcpy(state, &world, sizeof world);
}

/* Begins the motion of a stride. TDMF_RETURN_CLOSED where it has an apex. */
static tdmf_return_outcome begin_motion(const tdmf_stride_request *request, tdmf_motion *motion,
                                        tdmf_refusal *why) {
    const tdmf_system system = request->system;
    const tdmf_ground_line ground = tdmf_ground_line_set(system.inputs);
    memset(motion, 0, sizeof *motion);
    tdmf_reduced_state(system, request->apex, motion->state);
    if (tdmf_foot_over_ground(&ground, motion->state).y <= 0.0) {
        return TDMF_RETURN_NO_START;
    }
    const bool begins =
        tdmf_accepts(why, tdmf_start(system, motion)) && motion->state[TDMF_STRIDE_IS_OPEN] > 0.0;
    return begins ? TDMF_RETURN_CLOSED : TDMF_RETURN_REFUSED;
}

/* The variation by a coordinate, or along a seed. */
static void begin_variation(stride *s, const double *start, const double *apex, const tdmf_seed *seed,
                            int coordinate) {
    static const tdmf_seed none = {0};
    const tdmf_model_kind *model = s->page->model;
    const tdmf_section_kind *section = model->sections;
    const tdmf_seed *given = seed ? seed : &none;
    const int i = s->run.seed_count++;
    const runner_parameters of_whole = tdmf_page_parameters(&given->parameters, &given->inputs);
    runner_states d_inputs;
    double d_start[STATES], d_apex[TDMF_REDUCED_COUNT] = {0.0};
    memset(&d_inputs, 0, sizeof d_inputs);
    tdmf_write_page_inputs(&given->inputs, &d_inputs);
    double *dp = s->dp + i * model->parameter_count, *dx = s->dx + i * model->state_count;
    tdmf_take_parameters(s->page, &of_whole, dp);
    tdmf_take_states(s->page, &d_inputs, d_start);
    if (!seed) {
        d_apex[coordinate] = 1.0;
    }
    memcpy(dx, d_start, (size_t)model->state_count * sizeof *dx);
    section->vary_enter(s->p, start, dp, d_start, apex, d_apex, dx);
    s->shift[i] = 0.0;
}

static void begin(stride *s, const tdmf_stride_request *request) {
    const double *apex = request->apex;
    const bool derivatives = request->derivatives;
    double start[STATES];
    s->run = tdmf_run_default(s->page->model, s->p, s->x, NULL);
    read_system(s->page, s->system, s->p, start);
    enter(s->page, s->p, apex, start, s->x);
    s->run.dp = s->dp;
    s->run.dx = s->dx;
    s->run.shift = s->shift;
    s->run.tolerance = s->solver->relative_tolerance;
    s->run.order = tdmf_page_order(s->run.tolerance);
    s->run.observes = derivatives || !s->solver->without_peaks_and_positive_work ? TDMF_OBSERVE_USUAL
                                                                                 : TDMF_OBSERVE_NOTHING;
    for (int k = 0; k < TDMF_REDUCED_COUNT && derivatives; ++k) {
        begin_variation(s, start, apex, NULL, k);
    }
    for (int k = 0; k < request->seed_count && derivatives; ++k) {
        begin_variation(s, start, apex, &request->seeds[k], 0);
    }
}

/* ---- the run ------------------------------------------------------------------------------------------- */

static tdmf_return_outcome outcome_of_mode(const char *mode) {
    static const struct {
        const char *name;
        tdmf_return_outcome outcome;
    } ends[] = {{"no_start", TDMF_RETURN_NO_START},
                {"no_stance", TDMF_RETURN_NO_STANCE},
                {"no_apex", TDMF_RETURN_NO_APEX}};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; ++i) {
        if (strcmp(ends[i].name, mode) == 0) {
            return ends[i].outcome;
        }
    }
    return TDMF_RETURN_FELL;
}

/* The parts of a stride: the event of the runner's page to which each runs. */
enum { TO_TOUCHDOWN, TO_LIFT_OFF, TO_APEX };
static const int event_of_part[] = {EVENT_touchdown, EVENT_lift_off, EVENT_apex};

/* Sets the run's next stop, its limits and its longest time. */
static void aim(stride *s) {
    const double longest = longest_time * s->system.model->scales.time;
    const double duration = s->part == TO_APEX ? INFINITY : s->until;
    s->run.step_limit = s->solver->step_limit - s->run.steps;
    s->run.event_limit = s->solver->event_limit - s->run.events;
    s->run.stop_event = tdmf_event_on_part(s->page, event_of_part[s->part]);
    s->end = s->run.time + (duration < longest ? duration : longest);
}

static tdmf_return_outcome outcome_of_run(stride *s, tdmf_run_outcome outcome) {
    static const tdmf_return_outcome late[] = {TDMF_RETURN_NO_TOUCHDOWN, TDMF_RETURN_TOO_LONG,
                                               TDMF_RETURN_NO_APEX};
    switch (outcome) {
    case TDMF_RUN_STOPPED:
        return TDMF_RETURN_CLOSED;
    case TDMF_RUN_ARRIVED:
        return late[s->part];
    case TDMF_RUN_ENDED: /* an apex below the ground is the next apex, too */
        return s->part == TO_APEX && (s->run.taken >> s->run.stop_event & 1u) != 0
                   ? TDMF_RETURN_CLOSED
                   : outcome_of_mode(s->page->model->mode_names[s->run.mode]);
    case TDMF_RUN_TOO_MANY_STEPS:
        s->ended = TDMF_TOO_MANY_STEPS;
        return TDMF_RETURN_UNSOLVED;
    case TDMF_RUN_ENDLESS_CHAIN:
    case TDMF_RUN_TOO_MANY_EVENTS:
        s->ended = TDMF_TOO_MANY_EVENTS;
        return TDMF_RETURN_UNSOLVED;
    default:
        s->ended = TDMF_NO_PROGRESS;
        return TDMF_RETURN_UNSOLVED;
    }
}

bool tdmf_reduced_stride_goes_on(stride *s, tdmf_run_outcome outcome) {
    s->outcome = outcome_of_run(s, outcome);
    if (s->outcome != TDMF_RETURN_CLOSED || s->part == TO_APEX) {
        return false;
    }
    if (s->part == TO_LIFT_OFF) {
        memcpy(s->lift_off, s->x, sizeof s->x);
    }
    ++s->part;
    aim(s);
    return true;
}

/* ---- the log ------------------------------------------------------------------------------------------- */

/* The event of a row of the log, without the mode after it. */
static tdmf_event event_at(const stride *s, int number) {
    const tdmf_event_row *row = &s->run.log[number];
    const double *x = s->run.log_states + number * s->page->model->state_count;
    const tdmf_motion before = motion_at(s, x, row->before, row->before, row->time);
    tdmf_event event = {.time = row->time,
                        .guard = (int)tdmf_guard_of_event(tdmf_event_in_whole(s->page, row->event)),
                        .before = before.mode};
    memcpy(event.state, before.state, sizeof event.state);
    return event;
}

/* Logs the events of the run up to the apex. A chain in zero time is one event, by the name of its first. */
static void log_events(const stride *s) {
    const int count = s->run.log_count < s->run.log_size ? s->run.log_count : s->run.log_size;
    tdmf_event event;
    bool is_open = false;
    for (int i = 0; i < count; ++i) {
        const tdmf_event_row *row = &s->run.log[i];
        const double *after =
            i + 1 < count ? s->run.log_states + (i + 1) * s->page->model->state_count : s->x;
        const bool has_guard =
            tdmf_guard_of_event(tdmf_event_in_whole(s->page, row->event)) != TDMF_GUARD_COUNT;
        if (is_open && row->time != s->run.log[i - 1].time) {
            tdmf_log_event(s->solver, &event);
            is_open = false;
        }
        if (!is_open && has_guard && tdmf_mode_in_whole(s->page, row->before) >= 0) {
            event = event_at(s, i);
            is_open = true;
        }
        if (is_open && tdmf_mode_in_whole(s->page, row->after) >= 0) {
            event.after = motion_at(s, after, row->after, row->before, row->time).mode;
        }
        if (tdmf_event_in_whole(s->page, row->event) == EVENT_apex) {
            break;
        }
    }
    if (is_open) {
        tdmf_log_event(s->solver, &event);
    }
}

/* ---- the result ---------------------------------------------------------------------------------------- */

/* Energy of the leg's motion about the centre of mass, and of its spring. */
static double energy_of_leg(const tdmf_model *model, double length_rate, double turning_speed,
                            double compression) {
    const double reduced_mass = model->parameters.body.mass * model->parameters.foot.mass / model->total_mass;
    return 0.5 * (reduced_mass * (length_rate * length_rate + turning_speed * turning_speed) +
                  model->parameters.leg.stiffness * compression * compression);
}

/* The energy left in the leg at lift-off, less the energy that it is given for touchdown. */
static double leg_loss_of(const stride *s) {
    const tdmf_model *model = s->system.model;
    const runner_states x = states_of(s->page, s->lift_off);
    const double rest_length = model->parameters.leg.free_length + s->system.inputs->leg.extension;
    const double given = energy_of_leg(model, 0.0, rest_length * model->parameters.hip.retraction_rate, 0.0);
    return energy_of_leg(model, x.length_rate, x.momentum / x.length, rest_length - x.length) - given;
}

static tdmf_stride_variation variation_of(const tdmf_page_part *page, const double *own) {
    const runner_states d = states_of(page, own);
    const tdmf_stride_variation variation = {
        .apex = {d.apex_com_height, d.apex_com_speed},
        .period = d.period,
        .length = d.distance,
        .work = d.work_of_stride,
        .stance_time = d.stance_time,
        .slip_distance = d.slip_distance,
        .peak_force = d.peak_force,
        .peak_vertical_force = d.peak_vertical_force,
    };
    return variation;
}

static void write_stride(const stride *s, tdmf_return *result) {
    const runner_states x = states_of(s->page, s->x), lift_off = states_of(s->page, s->lift_off);
    result->apex[TDMF_SECTION_COM_HEIGHT] = x.apex_com_height;
    result->apex[TDMF_SECTION_COM_SPEED] = x.apex_com_speed;
    result->liftoff_angle = lift_off.liftoff_angle;
    tdmf_write_return(&x, result);
    result->impact_loss = lift_off.impact_loss; /* without a touchdown at the apex */
    result->leg_loss = leg_loss_of(s);
    for (int i = 0; i < s->run.seed_count; ++i) {
        result->variations[i] = variation_of(s->page, s->dx + i * s->page->model->state_count);
    }
}

/* Chooses the plain page, which is faster, if it has all that acts on the runner and all that changes. */
static const tdmf_page_part *page_of(const tdmf_stride_request *request) {
    const tdmf_system system = request->system;
    tdmf_page_point point = {.p = tdmf_page_parameters(&system.model->parameters, system.inputs)};
    tdmf_write_page_inputs(system.inputs, &point.x);
    return tdmf_suits_plain_page_varied(&point, request->seeds, request->seed_count)
               ? &tdmf_plain_reduced_runner_part
               : &tdmf_reduced_runner_part;
}

bool tdmf_begin_reduced_stride(stride *s, const tdmf_stride_request *request, tdmf_return *result) {
    memset(result, 0, sizeof *result);
    result->outcome = TDMF_RETURN_REFUSED;
    if (!tdmf_is_sound_stride(&result->refusal, request)) {
        return false;
    }
    s->solver = request->solver;
    s->system = request->system;
    s->page = page_of(request);
    s->until = tdmf_longest_of(request);
    s->part = TO_TOUCHDOWN;
    s->ended = TDMF_ARRIVED;
    result->outcome = begin_motion(request, &s->start, &result->refusal);
    if (result->outcome == TDMF_RETURN_CLOSED) {
        begin(s, request);
        aim(s);
    }
    return result->outcome == TDMF_RETURN_CLOSED;
}

void tdmf_close_reduced_stride(stride *s, tdmf_return *result) {
    result->outcome = s->outcome;
    result->solver = s->ended;
    s->solver->strides += s->part == TO_APEX;
    s->solver->steps += s->run.steps;
    s->solver->events += s->run.events;
    s->solver->evaluations += s->run.steps * s->run.order;
    log_events(s);
    if (s->outcome == TDMF_RETURN_CLOSED) {
        write_stride(s, result);
    }
}

void tdmf_run_reduced_stride(const tdmf_stride_request *request, tdmf_return *result) {
    double memory[TDMF_PAGE_MEMORY];
    event_rows log;
    stride s;
    if (tdmf_begin_reduced_stride(&s, request, result)) {
        s.run.memory = memory;
        s.run.log = log.rows;
        s.run.log_states = log.states;
        s.run.log_size = s.solver->log ? TDMF_EVENT_CAPACITY : 0;
        while (tdmf_reduced_stride_goes_on(&s, tdmf_page_run_to(s.page->model, &s.run, s.end))) {
        }
        tdmf_close_reduced_stride(&s, result);
    }
}
