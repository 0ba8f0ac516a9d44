/* A stride from apex to apex, as a run of the runner's page. The page's section writes the coordinates of an
 * apex, so that variations at the next one are those on the section. */
#include "tdmf_slip/return_map.h"

#include "ground_line.h"
#include "input_rates.h"
#include "kinematics.h"
#include "mapped_stride.h"
#include "page_fields.h"
#include "patch.h"
#include "reduced_stride.h"
#include "refusal.h"
#include "request.h"
#include "stride_limits.h"
#include "tdmf_slip/automaton.h"

#include <math.h>
#include <string.h>

void tdmf_section_state(tdmf_system system, const double section[TDMF_SECTION_COUNT],
                        double state[TDMF_STATE_COUNT]) {
    const double com_height = section[TDMF_SECTION_COM_HEIGHT], com_speed = section[TDMF_SECTION_COM_SPEED];
    const double leg[TDMF_STATE_COUNT] = {[TDMF_LEG_LENGTH] = section[TDMF_SECTION_LEG_LENGTH],
                                          [TDMF_LEG_ANGLE] = section[TDMF_SECTION_LEG_ANGLE],
                                          [TDMF_LEG_LENGTH_RATE] = section[TDMF_SECTION_LEG_LENGTH_RATE],
                                          [TDMF_LEG_ANGLE_RATE] = section[TDMF_SECTION_LEG_ANGLE_RATE]};
    memcpy(state, leg, sizeof leg);
    const tdmf_ground_line ground = tdmf_ground_line_set(system.inputs);
    const tdmf_point body = tdmf_body(state); /* seen from a foot at rest in the origin */
    const double ground_height = tdmf_ground_height_at(&ground, system.model->body_share * body.x);
    state[TDMF_FOOT_Y] = com_height + ground_height - system.model->body_share * body.y;
    state[TDMF_FOOT_VX] = com_speed - system.model->body_share * body.vx;
    state[TDMF_FOOT_VY] = -system.model->body_share * body.vy;
}

void tdmf_section_state_at(tdmf_system system, double foot_x, const double section[TDMF_SECTION_COUNT],
                           double state[TDMF_STATE_COUNT]) {
    const tdmf_ground_line ground = tdmf_ground_line_set(system.inputs);
    tdmf_section_state(system, section, state);
    state[TDMF_FOOT_Y] += tdmf_ground_height_at(&ground, foot_x) - tdmf_ground_height_at(&ground, 0.0);
    state[TDMF_FOOT_X] = foot_x;
}

void tdmf_section_of_state(const tdmf_model *model, const tdmf_ground_line *ground,
                           const double state[TDMF_STATE_COUNT], double section[TDMF_SECTION_COUNT]) {
    const tdmf_point com = tdmf_center_of_mass(model, state);
    const double coordinates[TDMF_SECTION_COUNT] = {
        [TDMF_SECTION_COM_HEIGHT] = com.y - tdmf_ground_height_at(ground, com.x),
        [TDMF_SECTION_COM_SPEED] = com.vx,
        [TDMF_SECTION_LEG_LENGTH] = state[TDMF_LEG_LENGTH],
        [TDMF_SECTION_LEG_ANGLE] = state[TDMF_LEG_ANGLE],
        [TDMF_SECTION_LEG_LENGTH_RATE] = state[TDMF_LEG_LENGTH_RATE],
        [TDMF_SECTION_LEG_ANGLE_RATE] = state[TDMF_LEG_ANGLE_RATE]};
    memcpy(section, coordinates, sizeof coordinates);
}

bool tdmf_is_sound_stride(tdmf_refusal *why, const tdmf_stride_request *request) {
    const bool is_reduced = request != NULL && request->map == TDMF_REDUCED_MAP;
    const int most = is_reduced ? (int)TDMF_REDUCED_MAP_SEEDS : (int)TDMF_RETURN_MAP_SEEDS;
    return tdmf_accepts_pointer(why, "request", request) && tdmf_is_sound_solver(why, request->solver) &&
           tdmf_is_sound_system(why, request->system) &&
           tdmf_accepts_number(why, "map", "1", (int)request->map, TDMF_RETURN_MAP, TDMF_REDUCED_MAP) &&
           tdmf_accepts_pointer(why, "apex", request->apex) &&
           tdmf_accepts_number(why, "until", "s", request->until, 0.0, INFINITY) &&
           tdmf_are_sound_seeds(why, request->seeds, request->seed_count, most - (request->foot_x != NULL)) &&
           tdmf_accepts_if(why, !is_reduced || request->foot_x == NULL, TDMF_EXCLUDED, "foot_x", 0,
                           "the reduced map has no place of the foot") &&
           tdmf_accepts_if(why, request->foot_x != NULL || !tdmf_has_patch(request->system.model),
                           TDMF_EXCLUDED, "ground.patch_end", 0,
                           "on a slippery patch a stride depends on foot_x");
}

double tdmf_longest_of(const tdmf_stride_request *request) {
    return request->until > 0.0 ? request->until : TDMF_LONGEST_STRIDE * request->system.model->scales.time;
}

/* False where the start is no apex. */
static bool begin_motion(const tdmf_stride_request *request, tdmf_motion *motion, tdmf_refusal *why) {
    const double foot_x = request->foot_x == NULL ? 0.0 : *request->foot_x;
    motion->time = 0.0;
    tdmf_section_state_at(request->system, foot_x, request->apex, motion->state);
    return tdmf_accepts(why, tdmf_start(request->system, motion)) && motion->state[TDMF_STRIDE_IS_OPEN] > 0.0;
}

/* ---- results of both maps ------------------------------------------------------------------------------ */

void tdmf_write_return(const runner_states *x, tdmf_return *result) {
    result->stride = tdmf_page_stride_of(x);
    result->external_work = x->external_work;
    result->damper_loss = x->damper_loss;
    result->friction_loss = x->friction_loss;
    result->impact_loss = x->impact_loss;
}

const char *tdmf_return_outcome_text(tdmf_return_outcome outcome) {
    switch (outcome) {
    case TDMF_RETURN_CLOSED:
        return "the stride has a next apex";
    case TDMF_RETURN_NO_START:
        return "there is no apex above the ground";
    case TDMF_RETURN_NO_TOUCHDOWN:
        return "the foot does not come down in the time that a stride may take";
    case TDMF_RETURN_NO_STANCE:
        return "the impact leaves the foot without load";
    case TDMF_RETURN_TOO_LONG:
        return "no stride was completed within the time limit";
    case TDMF_RETURN_NO_APEX:
        return "the centre of mass does not rise at lift-off";
    case TDMF_RETURN_FELL:
        return "the runner fell";
    case TDMF_RETURN_UNSOLVED:
        return "the solver could not follow the runner";
    default:
        return "a value is out of range";
    }
}

/* ---- variations ---------------------------------------------------------------------------------------- */

/* The change of the start along coordinate i of the section, along a seed, or along x. On the page's section
 * the foot is at x = 0; here it is at a given place. */
static tdmf_page_direction direction_at_start(const tdmf_stride_request *request,
                                              const tdmf_page_point *point, int i) {
    static const tdmf_seed none = {0};
    const int number = i - TDMF_SECTION_COUNT;
    const bool is_seed = number >= 0 && number < request->seed_count;
    const double along_x = number == request->seed_count ? 1.0 : 0.0, rise = tan(point->x.slope);
    const double *p = (const double *)&point->p, *x = (const double *)&point->x;
    double along[TDMF_SECTION_COUNT] = {0.0};
    tdmf_page_direction d = tdmf_direction_of_seed(is_seed ? &request->seeds[number] : &none);
    const double *dp = (const double *)&d.p;
    if (number < 0) {
        along[i] = 1.0;
    }
    d.x.height = d.p.ground_height;
    d.x.slope = d.p.ground_slope;
    runner_states seen = d.x;
    tdmf_runner_model.sections->vary_enter(p, x, dp, (const double *)&d.x, request->apex, along,
                                           (double *)&seen);
    seen.seen_y +=
        rise * along_x + (1.0 + rise * rise) * d.x.slope * (request->foot_x ? *request->foot_x : 0.0);
    seen.seen_x = along_x;
    d.x = seen;
    tdmf_runner_model.modes[point->mode].vary_from_world(p, x, dp, (const double *)&seen, (double *)&d.x);
    d.x.x_then = d.x.com_x;
    d.x.y_then = d.x.com_y;
    d.x.liftoff_angle = d.x.angle;
    return d;
}

static void forget_direction(tdmf_page_direction *d) {
    double *values = (double *)&d->x;
    for (int i = 0; i < TDMF_PAGE_STATE_COUNT; ++i) {
        values[i] = NAN;
    }
}

static tdmf_stride_measures measures_of(const runner_states *x) {
    const tdmf_stride_measures measures = {.positive_hip_work = x->positive_work,
                                           .positive_leg_work = x->positive_leg_work,
                                           .squared_torque = x->squared_torque,
                                           .friction_loss = x->friction_loss,
                                           .greatest_slip_velocity = x->greatest_slip_velocity,
                                           .greatest_foot_height = x->greatest_foot_height};
    return measures;
}

static tdmf_stride_variation variation_at_end(const tdmf_page_point *point, const tdmf_page_direction *d) {
    runner_states seen = d->x;
    tdmf_runner_model.modes[point->mode].vary_to_world((const double *)&point->p, (const double *)&point->x,
                                                       (const double *)&d->p, (const double *)&d->x,
                                                       (double *)&seen);
    const tdmf_stride_variation variation = {
        .apex = {d->x.apex_com_height, d->x.apex_com_speed, d->x.apex_length, d->x.apex_angle,
                 d->x.apex_length_rate, d->x.apex_angle_rate},
        .period = d->x.period,
        .length = d->x.distance,
        .work = d->x.work_of_stride,
        .stance_time = d->x.stance_time,
        .slip_distance = d->x.slip_distance,
        .peak_force = d->x.peak_force,
        .peak_vertical_force = d->x.peak_vertical_force,
        .foot_x = seen.seen_x,
    };
    return variation;
}

/* ---- the stride ---------------------------------------------------------------------------------------- */

static void add_directions(tdmf_mapped_stride *s) {
    const tdmf_stride_request *request = s->request;
    const tdmf_page_point *point = &s->solver.point;
    const double rise = tan(point->x.slope);
    for (int i = 0; i < TDMF_SECTION_COUNT + request->seed_count + (request->foot_x != NULL); ++i) {
        const tdmf_page_direction d = direction_at_start(request, point, i);
        const double d_rise = (1.0 + rise * rise) * d.x.slope;
        s->d_clearance[i] = d.x.seen_y - d.x.height - rise * d.x.seen_x - d_rise * point->x.seen_x;
        tdmf_add_direction(&s->solver, &d);
    }
}

static bool is_kinked(const tdmf_stride_request *request, int i) {
    const int number = i - TDMF_SECTION_COUNT;
    return number >= 0 && number < request->seed_count &&
           tdmf_is_kinked(&request->system.model->parameters, &request->seeds[number]);
}

static void write_variations(const tdmf_mapped_stride *s, tdmf_return *result) {
    for (int i = 0; i < s->solver.run.run.seed_count; ++i) {
        tdmf_page_direction d = tdmf_direction_at_end(&s->solver, i);
        if (is_kinked(s->request, i)) {
            forget_direction(&d);
        }
        tdmf_stride_variation *variation = &result->variations[i];
        *variation = variation_at_end(&s->solver.point, &d);
        variation->foot_clearance = s->d_clearance[i];
        if (s->request->measures) {
            variation->measures = measures_of(&d.x);
        }
    }
}

static void write_stride(const tdmf_mapped_stride *s, tdmf_return *result) {
    const tdmf_page_point *point = &s->solver.point;
    const runner_states *x = &point->x;
    const double apex[TDMF_SECTION_COUNT] = {x->apex_com_height, x->apex_com_speed,   x->apex_length,
                                             x->apex_angle,      x->apex_length_rate, x->apex_angle_rate};
    runner_states seen = *x;
    tdmf_runner_model.modes[point->mode].to_world((const double *)&point->p, (const double *)x,
                                                  (double *)&seen);
    memcpy(result->apex, apex, sizeof apex);
    result->foot_x = seen.seen_x;
    result->liftoff_angle = x->liftoff_angle;
    tdmf_write_return(x, result);
    if (s->request->measures) {
        result->measures = measures_of(x);
    }
    write_variations(s, result);
}

/* Begins the run of a stride whose start is an apex. */
static void begin_run(tdmf_mapped_stride *s) {
    const tdmf_stride_request *request = s->request;
    const int seeds = request->derivatives ? request->seed_count : 0;
    const tdmf_inputs rates = tdmf_rates_with_varied_push(&tdmf_zero_input_rates, request->seeds, seeds);
    tdmf_page_point point = tdmf_page_of_motion(request->system, &rates, &s->start);
    const bool is_plain = tdmf_suits_plain_page_varied(&point, request->seeds, seeds);
    point.p.notes_compression = !is_plain; /* the plain page has no thrust */
    tdmf_begin_page_solver(&s->solver, request->solver, request->system, &point, is_plain);
    s->solver.motion = &s->start;
    s->solver.stays_on_guard = true;
    if (request->derivatives) {
        add_directions(s);
    }
    if (request->measures) {
        s->solver.run.run.observes = TDMF_OBSERVE_ALL;
    }
}

bool tdmf_begin_mapped_stride(tdmf_mapped_stride *s, const tdmf_stride_request *request,
                              tdmf_return *result) {
    memset(result, 0, sizeof *result);
    s->request = request;
    if (!tdmf_is_sound_stride(&result->refusal, request)) {
        result->outcome = TDMF_RETURN_REFUSED;
        return false;
    }
    if (!begin_motion(request, &s->start, &result->refusal)) {
        result->outcome = TDMF_RETURN_NO_START;
        return false;
    }
    const double *state = s->start.state;
    result->foot_clearance =
        state[TDMF_FOOT_Y] - tdmf_ground_height_at(&s->start.mode.ground, state[TDMF_FOOT_X]);
    begin_run(s);
    return true;
}

void tdmf_close_mapped_stride(tdmf_mapped_stride *s, tdmf_return *result) {
    ++s->solver.solver->strides;
    tdmf_end_runner_run(&s->solver.run, &s->solver.point);
    write_stride(s, result);
}

/* Outcome of a stride from the end of the solver's call for it. */
static tdmf_return_outcome outcome_of(tdmf_outcome ended, bool has_closed) {
    if (has_closed) {
        return TDMF_RETURN_CLOSED;
    }
    switch (ended) {
    case TDMF_ARRIVED:
        return TDMF_RETURN_TOO_LONG;
    case TDMF_FELL:
        return TDMF_RETURN_FELL;
    case TDMF_REFUSED:
        return TDMF_RETURN_REFUSED;
    default:
        return TDMF_RETURN_UNSOLVED;
    }
}

void tdmf_run_stride(const tdmf_stride_request *request, tdmf_return *result) {
    tdmf_mapped_stride s;
    if (request != NULL && request->map == TDMF_REDUCED_MAP) {
        tdmf_run_reduced_stride(request, result);
    } else if (tdmf_begin_mapped_stride(&s, request, result)) {
        result->solver = tdmf_run_page_solver(&s.solver, tdmf_longest_of(request), EVENT_apex);
        result->outcome = outcome_of(result->solver, s.solver.has_stopped);
        if (result->outcome == TDMF_RETURN_CLOSED) {
            tdmf_close_mapped_stride(&s, result);
        }
    }
}
