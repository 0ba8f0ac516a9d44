/* A runner between lanes: what it takes along, and the events it meets. */
#include "runner.h"

#include "events.h"
#include "extrema.h"
#include "friction.h"
#include "ground_line.h"
#include "hip_law.h"
#include "input_rates.h"
#include "margins.h"
#include "positive_work.h"
#include "record.h"
#include "reduced_stride.h"
#include "static_assert.h"
#include "step_constants.h"
#include "stride_limits.h"
#include "stride_measures.h"
#include "tdmf_slip/automaton.h"

#include "members.h"

#include <math.h>
#include <string.h>

static bool coasts(const tdmf_runner *runner) {
    const tdmf_hip_law law =
        tdmf_stance_law(runner->model, &runner->inputs, &tdmf_zero_input_rates, &runner->motion.mode);
    return !tdmf_law_acts(&law);
}

/* Batch of a runner in flight. Each group of flight batches has falling, rising and clamped runners in this
 * order. */
static batch_kind batch_in_flight(const tdmf_runner *runner) {
    const tdmf_mode *mode = &runner->motion.mode;
    const bool waits = tdmf_ground_is_pending(&runner->inputs, mode);
    const batch_kind place = tdmf_is_pushed(&runner->inputs)
                                 ? waits ? BATCH_PLACE_FORCED_AND_WAIT : BATCH_PLACE_FORCED
                             : waits ? BATCH_PLACE_AND_WAIT
                                     : BATCH_PLACE;
    if (tdmf_has_clamp(runner->model, mode)) {
        return (batch_kind)(place + (BATCH_CLAMPED - BATCH_PLACE));
    }
    return mode->rises ? (batch_kind)(place + (BATCH_RISE - BATCH_PLACE)) : place;
}

batch_kind tdmf_runner_batch(const tdmf_runner *runner) {
    const tdmf_mode *mode = &runner->motion.mode;
    switch (mode->contact) {
    case TDMF_CONTACT_FLIGHT:
        return batch_in_flight(runner);
    case TDMF_CONTACT_STICK:
        if (tdmf_is_on_border(runner->model, runner->motion.state[TDMF_FOOT_X])) {
            return BATCH_STICK_ON_BORDER;
        }
        return coasts(runner) ? BATCH_STICK_AND_COAST : BATCH_STICK;
    case TDMF_CONTACT_GRAZE:
        return BATCH_GRAZE;
    default:
        if (tdmf_slips_to_border(runner->model, mode)) {
            return tdmf_friction_falls(runner->model) ? BATCH_FALLING_SLIP_TO_BORDER : BATCH_SLIP_TO_BORDER;
        }
        return tdmf_friction_falls(runner->model) ? BATCH_FALLING_SLIP
               : coasts(runner)                   ? BATCH_SLIP_AND_COAST
                                                  : BATCH_SLIP;
    }
}

static double time_left_of(const tdmf_runner *runner) {
    return TDMF_LONGEST_STRIDE * runner->model->scales.time - (runner->motion.time - runner->stride_began);
}

/* A field that is added to a member and forgotten below does not compile. */
TDMF_STATIC_ASSERT(sizeof(flying_member) == sizeof(member_progress) + sizeof(flight_coordinates) +
                                                2 * sizeof(real) + 2 * sizeof(height_above) +
                                                sizeof(flight_constants),
                   every_field_of_a_flying_member_is_filled);
TDMF_STATIC_ASSERT(sizeof(standing_member) == sizeof(member_progress) + sizeof(ground_coordinates) +
                                                  sizeof(real) + sizeof(ground_constants) +
                                                  sizeof(friction_layer),
                   every_field_of_a_standing_member_is_filled);

static flying_member flying_fields(const tdmf_runner *runner) {
    const tdmf_mode_equations *equations = &runner->equations;
    const ballistic com = tdmf_step_center_of_mass(equations);
    const flying_member m = {
        .now = {0.0, runner->steps},
        .at = tdmf_step_flight_coordinates(&equations->start),
        .time_left = time_left_of(runner),
        .com = com.ground,
        .rise_rate = com.rise_rate,
        .constants = tdmf_step_flight_constants(equations, &runner->motion.mode,
                                                tdmf_margin_factor(runner->false_crossings)),
        .com_over_new_ground = com.new_ground,
    };
    return m;
}

static const friction_layer no_layer = {INFINITY, 0.0};

static void write_standing_fields(const tdmf_runner *runner, standing_member *m) {
    const tdmf_mode_equations *equations = &runner->equations;
    const member_progress now = {0.0, runner->steps};
    m->now = now;
    m->at = tdmf_step_ground_coordinates(&equations->start);
    m->time_left = time_left_of(runner);
    m->constants = tdmf_step_ground_constants(equations, &runner->motion.mode,
                                              tdmf_margin_factor(runner->false_crossings));
    m->layer = equations->falls ? tdmf_step_friction_layer(equations) : no_layer;
}

int tdmf_runner_load(tdmf_runner *runner, double *fields) {
    const tdmf_motion *motion = &runner->motion;
    tdmf_open_mode(&runner->equations, tdmf_runner_system(runner), &tdmf_zero_input_rates, &motion->mode,
                   motion->state, runner->direction);
    if (motion->mode.contact == TDMF_CONTACT_FLIGHT) {
        *(flying_member *)fields = flying_fields(runner);
        return runner->equations.ground_waits || runner->equations.is_forced ? RARE_FIELDS
               : tdmf_has_clamp(runner->model, &motion->mode)                ? CLAMPED_FIELDS
                                                                             : FLYING_FIELDS;
    }
    write_standing_fields(runner, (standing_member *)fields);
    return runner->equations.falls || runner->equations.meets_border ? RARE_STANDING_FIELDS
           : motion->mode.contact == TDMF_CONTACT_GRAZE              ? GRAZING_FIELDS
                                                                     : STANDING_FIELDS;
}

static member_progress read_flying(const double *fields, tdmf_mode_coordinates *at) {
    flying_member m;
    memcpy(&m, fields, offsetof(flying_member, time_left));
    tdmf_step_set_flight(at, &m.at);
    return m.now;
}

static member_progress read_standing(const double *fields, tdmf_mode_coordinates *at) {
    standing_member m;
    memcpy(&m, fields, offsetof(standing_member, time_left));
    tdmf_step_set_ground(at, &m.at);
    return m.now;
}

/* Writes the state that the lane has come to. */
static void store(tdmf_runner *runner, const double *fields) {
    tdmf_motion *motion = &runner->motion;
    tdmf_mode_coordinates at = runner->equations.start;
    const member_progress now =
        motion->mode.contact == TDMF_CONTACT_FLIGHT ? read_flying(fields, &at) : read_standing(fields, &at);
    runner->direction = tdmf_state_in_mode(&runner->equations, now.elapsed, &at, motion->state);
    tdmf_runner_pass_time(runner, now.elapsed);
    runner->steps = now.steps;
}

/* ---- what is noted of steps --------------------------------------------------------------------------- */

bool tdmf_records_strides(const tdmf_ensemble *ensemble) {
    return ensemble->strides != NULL;
}

static void take_series(double *to, const tdmf_lane_step *lane, int series) {
    memcpy(to, lane->series[series], sizeof lane->series[series]);
}

/* A step in flight as the native solver has it, as far as it takes for the hip's power. Returns the work. */
static double read_flight_step(const tdmf_lane_step *lane, tdmf_mode_equations *equations, tdmf_step *step) {
    const flying_member *before = (const flying_member *)lane->before;
    const flying_member *after = (const flying_member *)lane->after;
    flight_series *flight = &step->series.flight;
    tdmf_step_set_flight(&equations->start, &before->at);
    step->constants.flight = before->constants;
    take_series(flight->momentum, lane, TDMF_RECORDED_MOMENTUM);
    take_series(flight->angle, lane, TDMF_RECORDED_ANGLE);
    take_series(flight->rate_square, lane, TDMF_RECORDED_RATE_SQUARE);
    take_series(flight->push_moment, lane, TDMF_RECORDED_PUSH_MOMENT);
    return after->at.done.work - before->at.done.work;
}

static double read_ground_step(const tdmf_lane_step *lane, tdmf_step *step) {
    const standing_member *before = (const standing_member *)lane->before;
    const standing_member *after = (const standing_member *)lane->after;
    ground_series *ground = &step->series.ground;
    take_series(ground->normal_force, lane, TDMF_RECORDED_NORMAL_FORCE);
    take_series(tdmf_step_ground_case(step).slips ? ground->friction_force : ground->tangential_push, lane,
                TDMF_RECORDED_TANGENTIAL);
    take_series(ground->moment, lane, TDMF_RECORDED_MOMENT);
    take_series(ground->torque, lane, TDMF_RECORDED_TORQUE);
    take_series(ground->power, lane, TDMF_RECORDED_POWER);
    return after->at.done.work - before->at.done.work;
}

static void record_peak_forces(tdmf_motion *motion, const tdmf_step *step, double end) {
    const tdmf_force_peaks peaks = tdmf_largest_peaks(step, end, &motion->mode);
    tdmf_record_force(&motion->record, peaks.normal.force, peaks.vertical.force);
}

void tdmf_runner_record_step(tdmf_runner *runner, const tdmf_lane_step *lane) {
    tdmf_mode_equations equations = runner->equations;
    tdmf_step step;
    step.equations = &equations;
    step.order = lane->order;
    step.size = lane->size;
    set_powers(step.search.power, lane->size, lane->order);
    const double work = runner->motion.mode.contact == TDMF_CONTACT_FLIGHT
                            ? read_flight_step(lane, &equations, &step)
                            : read_ground_step(lane, &step);
    runner->equations.positive_work += tdmf_positive_work(&step, lane->end, work);
    if (tdmf_in_contact(&runner->motion.mode)) {
        record_peak_forces(&runner->motion, &step, lane->end);
    }
}

/* ---- events ------------------------------------------------------------------------------------------- */

/* Whether the runner is where the stance of the reduced map is over, and its flight to the next apex. */
static bool has_lifted_off(const tdmf_runner *runner) {
    return runner->map == TDMF_REDUCED_MAP && !tdmf_in_contact(&runner->motion.mode);
}

static bool fly(tdmf_runner *runner) {
    const tdmf_return_outcome outcome = tdmf_reduced_fly(tdmf_runner_system(runner), &runner->motion);
    if (outcome != TDMF_RETURN_CLOSED) {
        tdmf_runner_give_up_reduced(runner, outcome);
        return false;
    }
    return tdmf_runner_close_stride(runner);
}

static bool flies(const tdmf_mode *mode) {
    return mode->contact == TDMF_CONTACT_FLIGHT;
}

/* A terrain before an event: there may be no segment where the foot has come down, or it has a friction
 * of its own. Returns the guard that is still reached. */
static tdmf_guard meet_segment(tdmf_runner *runner, tdmf_guard reached, bool *ended) {
    *ended = false;
    if (reached != TDMF_GUARD_TOUCHDOWN || !tdmf_has_terrain(&runner->its_case->rules)) {
        return reached;
    }
    return tdmf_meets_segment(runner, ended) ? reached : TDMF_GUARD_COUNT;
}

/* A terrain after one: the foot flies, or is over a height that it was below. */
static bool look_at_terrain(tdmf_runner *runner, const tdmf_mode *before, tdmf_guard reached) {
    const bool looks =
        tdmf_has_terrain(&runner->its_case->rules) && flies(&runner->motion.mode) &&
        (!flies(before) || reached == TDMF_GUARD_NEW_GROUND || reached == TDMF_GUARD_TOUCHDOWN);
    return !looks || tdmf_look_at_terrain(runner);
}

bool tdmf_runner_take_event(tdmf_runner *runner, const double *fields, tdmf_guard reached) {
    tdmf_motion *motion = &runner->motion;
    const tdmf_mode before = motion->mode;
    bool ended;
    store(runner, fields);
    reached = meet_segment(runner, reached, &ended);
    if (ended) {
        return false;
    }
    tdmf_run run = {tdmf_runner_system(runner), motion, runner->direction};
    const bool resolved = tdmf_take_transitions(&run, reached, tdmf_records_strides(runner->ensemble));
    if (motion->mode.fallen) {
        tdmf_runner_give_up(runner, TDMF_FATE_FELL);
        return false;
    }
    if (!look_at_terrain(runner, &before, reached)) {
        return false;
    }
    runner->false_crossings = tdmf_same_mode(&before, &motion->mode) ? runner->false_crossings + 1 : 0;
    if (!resolved || --runner->events_left <= 0) {
        tdmf_runner_give_up(runner, TDMF_FATE_UNSOLVED);
        return false;
    }
    if (has_lifted_off(runner)) {
        return fly(runner);
    }
    return motion->record.stride.count == runner->end->strides || tdmf_runner_close_stride(runner);
}

static tdmf_fate fate_of(tdmf_outcome outcome) {
    switch (outcome) {
    case TDMF_FELL:
        return TDMF_FATE_FELL;
    case TDMF_ARRIVED: /* where a stride takes too long */
        return TDMF_FATE_UNDECIDED;
    default:
        return TDMF_FATE_UNSOLVED;
    }
}

/* Takes the event at which the native solver has left the terrain to the runner. False where the run has
 * ended. */
static bool take_left_event(tdmf_runner *runner, const tdmf_mode *before, tdmf_guard reached) {
    tdmf_motion *motion = &runner->motion;
    bool ended = false;
    if (reached == TDMF_GUARD_COUNT) {
        return look_at_terrain(runner, before, reached);
    }
    const tdmf_mode at_event = motion->mode;
    reached = meet_segment(runner, reached, &ended);
    if (ended) {
        return false;
    }
    const tdmf_resolution taken =
        tdmf_resolve_along(tdmf_runner_system(runner), motion, runner->direction, reached);
    if (motion->mode.fallen || taken.unresolved) {
        tdmf_runner_give_up(runner, motion->mode.fallen ? TDMF_FATE_FELL : TDMF_FATE_UNSOLVED);
        return false;
    }
    return look_at_terrain(runner, &at_event, reached);
}

/* A stride over a terrain, from one meeting with a height of it to the next. False where the run has
 * ended. */
static bool stride_over_terrain(tdmf_runner *runner, tdmf_solver *solver, double until) {
    tdmf_motion *motion = &runner->motion;
    while (motion->record.stride.count == runner->end->strides) {
        const tdmf_mode before = motion->mode;
        tdmf_guard reached;
        const int64_t steps_before = solver->steps;
        solver->step_limit = (long)runner->steps.left;
        const tdmf_stride_outcome part =
            tdmf_native_to_ground(solver, tdmf_runner_system(runner), until, motion, &reached);
        runner->steps.left -= (double)(solver->steps - steps_before);
        runner->direction = tdmf_leg_direction_of(motion->state);
        const bool goes_on = part.outcome == TDMF_ARRIVED && (part.closed || motion->time < until);
        if (!goes_on || --runner->events_left <= 0) {
            tdmf_runner_give_up(runner, goes_on ? TDMF_FATE_UNSOLVED : fate_of(part.outcome));
            return false;
        }
        if (!take_left_event(runner, &before, reached)) {
            return false;
        }
    }
    return tdmf_runner_close_stride(runner);
}

bool tdmf_runner_stride(tdmf_runner *runner, tdmf_solver *solver) {
    const tdmf_model *model = runner->model;
    const bool reduced = runner->map == TDMF_REDUCED_MAP;
    const double until = runner->stride_began + TDMF_LONGEST_STRIDE * model->scales.time;
    if (tdmf_has_terrain(&runner->its_case->rules)) {
        return stride_over_terrain(runner, solver, until);
    }
    const int64_t steps_before = solver->steps;
    solver->step_limit = (long)runner->steps.left;
    const tdmf_stride_outcome stride = reduced
                                           ? tdmf_native_stance(solver, (tdmf_system){model, &runner->inputs},
                                                                until, &runner->motion, NULL, NULL, 0)
                                           : tdmf_map_stride(solver, (tdmf_system){model, &runner->inputs},
                                                             until, &runner->motion, NULL, NULL, 0);
    runner->steps.left -= (double)(solver->steps - steps_before);
    runner->direction = tdmf_leg_direction_of(runner->motion.state);
    if (!stride.closed) {
        tdmf_runner_give_up(runner, fate_of(stride.outcome));
        return false;
    }
    return reduced ? fly(runner) : tdmf_runner_close_stride(runner);
}

void tdmf_runner_give_up(tdmf_runner *runner, tdmf_fate fate) {
    runner->end->fate = (int)fate;
    runner->end->gait = -1;
}

void tdmf_runner_give_up_reduced(tdmf_runner *runner, tdmf_return_outcome outcome) {
    tdmf_runner_give_up(runner, outcome == TDMF_RETURN_FELL ? TDMF_FATE_FELL : TDMF_FATE_NO_STRIDE);
}
