/* A runner between lanes: what it takes along, and the events it meets. */
#include "runner.h"

#include "events.h"
#include "ground_line.h"
#include "hip_law.h"
#include "input_rates.h"
#include "longest_stride.h"
#include "margins.h"
#include "reduced_stride.h"
#include "step_constants.h"
#include "tdmf_slip/automaton.h"
#include "tdmf_slip/orbit.h"

#include "members.h"

#include <math.h>
#include <string.h>

/* A stride is given up after so many steps or events; none that closes comes near. */
static const long step_limit = 200000;
static const long event_limit = 100000;

static void open_stride(tdmf_runner *runner) {
    runner->stride_began = runner->motion.time;
    runner->steps = opened_steps((double)step_limit);
    runner->events_left = event_limit;
    runner->false_crossings = 0;
}

/* Of the reduced map: how a stride that does not close ends the run. */
static tdmf_fate fate_of_reduced(tdmf_reduced_outcome outcome) {
    return outcome == TDMF_REDUCED_FELL ? TDMF_FATE_FELL : TDMF_FATE_NO_STRIDE;
}

/* From an apex of the reduced map into contact; an apex of the return map is flown on from. False where the
 * run has ended. */
static bool leave_apex(tdmf_runner *runner) {
    const tdmf_ensemble_case *its_case = runner->its_case;
    if (runner->map != TDMF_REDUCED_MAP) {
        return true;
    }
    const tdmf_reduced_outcome outcome =
        tdmf_reduced_touch_down(its_case->model, &runner->inputs,
                                TDMF_LONGEST_STRIDE * its_case->model->scales.time, &runner->motion, NULL);
    runner->direction = tdmf_leg_direction_of(runner->motion.state);
    if (outcome != TDMF_REDUCED_CLOSED) {
        tdmf_runner_give_up(runner, fate_of_reduced(outcome));
        return false;
    }
    return true;
}

/* At each apex of a runner on rough ground. False where the run has ended: one that has not got onto its last
 * step in a whole stride is below the ground. */
static bool step_ground(tdmf_runner *runner) {
    const tdmf_ensemble_case *its_case = runner->its_case;
    const tdmf_ensemble_rules *rules = &its_case->rules;
    tdmf_motion *motion = &runner->motion;
    if (rules->roughness == 0.0) {
        return true;
    }
    if (tdmf_ground_is_pending(&runner->inputs, &motion->mode)) {
        tdmf_runner_give_up(runner, TDMF_FATE_FELL);
        return false;
    }
    const double step = tdmf_ground_step(rules->seed, runner->number, (uint32_t)runner->end->strides);
    runner->inputs.ground.height += rules->roughness * step;
    const tdmf_resolution resolution =
        tdmf_resolve_along(its_case->model, &runner->inputs, motion->time, motion->state, runner->direction,
                           &motion->mode, &motion->record);
    if (motion->mode.fallen || resolution.unresolved) {
        tdmf_runner_give_up(runner, motion->mode.fallen ? TDMF_FATE_FELL : TDMF_FATE_UNSOLVED);
        return false;
    }
    return true;
}

/* At the apex that a runner starts from. False where it is none. */
static bool start(tdmf_runner *runner, const double section[TDMF_SECTION_COUNT]) {
    const tdmf_model *model = runner->its_case->model;
    tdmf_motion *motion = &runner->motion;
    if (runner->map == TDMF_REDUCED_MAP) {
        return tdmf_reduced_begin(model, &runner->inputs, section, motion) == TDMF_REDUCED_CLOSED;
    }
    motion->time = 0.0;
    tdmf_section_state(model, &runner->inputs, section, motion->state);
    return !tdmf_start(model, &runner->inputs, 0.0, motion->state, &motion->mode, &motion->record).variable &&
           motion->record.open.began_at_apex;
}

bool tdmf_runner_begin(tdmf_runner *runner, const tdmf_ensemble *ensemble, int64_t index,
                       tdmf_ensemble_end *end) {
    static const tdmf_ensemble_end nothing_yet = {.fate = TDMF_FATE_UNDECIDED, .gait = -1};
    const double *section = ensemble->starts[index];
    runner->its_case = &ensemble->cases[ensemble->case_of ? ensemble->case_of[index] : 0];
    runner->map = ensemble->map;
    runner->number = ensemble->first_number + (uint64_t)index;
    runner->inputs = runner->its_case->inputs;
    runner->end = end;
    *end = nothing_yet;
    memcpy(end->apex, section, sizeof end->apex);
    if (!start(runner, section)) {
        end->fate = TDMF_FATE_NO_START;
        return false;
    }
    runner->direction = tdmf_leg_direction_of(runner->motion.state);
    open_stride(runner);
    return runner->its_case->rules.most_strides > 0 && step_ground(runner) && leave_apex(runner);
}

static bool coasts(const tdmf_runner *runner) {
    const tdmf_ensemble_case *its_case = runner->its_case;
    const tdmf_hip_law law =
        tdmf_stance_law(its_case->model, &runner->inputs, &tdmf_held_inputs, &runner->motion.mode);
    return law.torque == 0.0;
}

static batch_kind batch_in_forced_flight(const tdmf_mode *mode, bool waits) {
    if (mode->phase == TDMF_PHASE_RETRACT) {
        return waits ? BATCH_RETRACT_FORCED_AND_WAIT : BATCH_RETRACT_FORCED;
    }
    if (mode->rises) {
        return waits ? BATCH_RISE_FORCED_AND_WAIT : BATCH_RISE_FORCED;
    }
    return waits ? BATCH_PLACE_FORCED_AND_WAIT : BATCH_PLACE_FORCED;
}

static batch_kind batch_in_flight(const tdmf_runner *runner) {
    const tdmf_mode *mode = &runner->motion.mode;
    const tdmf_inputs *inputs = &runner->inputs;
    const bool waits = tdmf_ground_is_pending(inputs, mode);
    if (tdmf_is_pushed(inputs)) {
        return batch_in_forced_flight(mode, waits);
    }
    if (mode->phase == TDMF_PHASE_RETRACT) {
        return waits ? BATCH_RETRACT_AND_WAIT : BATCH_RETRACT;
    }
    if (mode->rises) {
        return waits ? BATCH_RISE_AND_WAIT : BATCH_PLACE_AND_RISE;
    }
    return waits ? BATCH_PLACE_AND_WAIT : BATCH_PLACE;
}

batch_kind tdmf_runner_batch(const tdmf_runner *runner) {
    const tdmf_mode *mode = &runner->motion.mode;
    switch (mode->contact) {
    case TDMF_CONTACT_FLIGHT:
        return batch_in_flight(runner);
    case TDMF_CONTACT_STICK:
        return coasts(runner) ? BATCH_STICK_AND_COAST : BATCH_STICK;
    case TDMF_CONTACT_GRAZE:
        return BATCH_GRAZE;
    default:
        return coasts(runner) ? BATCH_SLIP_AND_COAST : BATCH_SLIP;
    }
}

static double time_left_of(const tdmf_runner *runner) {
    return TDMF_LONGEST_STRIDE * runner->its_case->model->scales.time -
           (runner->motion.time - runner->stride_began);
}

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

static standing_member standing_fields(const tdmf_runner *runner) {
    const tdmf_mode_equations *equations = &runner->equations;
    const standing_member m = {
        .now = {0.0, runner->steps},
        .at = tdmf_step_ground_coordinates(&equations->start),
        .time_left = time_left_of(runner),
        .constants = tdmf_step_ground_constants(equations, &runner->motion.mode,
                                                tdmf_margin_factor(runner->false_crossings)),
    };
    return m;
}

int tdmf_runner_load(tdmf_runner *runner, double *fields) {
    const tdmf_motion *motion = &runner->motion;
    tdmf_open_mode(&runner->equations, runner->its_case->model, &runner->inputs, &tdmf_held_inputs,
                   &motion->mode, motion->state, runner->direction);
    if (motion->mode.contact == TDMF_CONTACT_FLIGHT) {
        *(flying_member *)fields = flying_fields(runner);
        return runner->equations.ground_waits || runner->equations.is_forced ? SELDOM_FIELDS
               : motion->mode.phase == TDMF_PHASE_RETRACT                    ? RETRACTING_FIELDS
                                                                             : FLYING_FIELDS;
    }
    *(standing_member *)fields = standing_fields(runner);
    return motion->mode.contact == TDMF_CONTACT_GRAZE ? GRAZING_FIELDS : STANDING_FIELDS;
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
    motion->record.now = tdmf_instant_after(motion->record.now, now.elapsed);
    motion->time = motion->record.now.time;
    runner->steps = now.steps;
}

static void note_apex(tdmf_runner *runner) {
    const tdmf_record *record = &runner->motion.record;
    const double *state = runner->motion.state;
    tdmf_ensemble_end *end = runner->end;
    const double apex[TDMF_SECTION_COUNT] = {record->apex.com_height,      record->apex.com_speed,
                                             record->apex.leg_length,      record->apex.leg_angle,
                                             record->apex.leg_length_rate, record->apex.leg_angle_rate};
    memcpy(end->apex, apex, sizeof apex);
    end->time = record->apex.time;
    end->distance += record->stride.length;
    end->hip_work = state[TDMF_HIP_WORK];
    end->leg_work = state[TDMF_LEG_WORK];
    end->work = end->hip_work + end->leg_work;
    end->external_work = state[TDMF_ENERGY_EXTERNAL_WORK];
    end->damper_loss = state[TDMF_ENERGY_DAMPER_LOSS];
    end->friction_loss = state[TDMF_ENERGY_FRICTION_LOSS];
    end->impact_loss = record->impact_loss;
    end->word_code = record->stride.word_code;
}

/* The gait that an apex is near, or -1. */
static int gait_near(const tdmf_runner *runner, const double apex[TDMF_SECTION_COUNT]) {
    const tdmf_ensemble_case *its_case = runner->its_case;
    const tdmf_ensemble_rules *rules = &its_case->rules;
    double scales[TDMF_SECTION_COUNT];
    const int coordinates = runner->map == TDMF_REDUCED_MAP ? TDMF_REDUCED_COUNT : TDMF_SECTION_COUNT;
    tdmf_section_scales(its_case->model, scales);
    for (int gait = 0; gait < rules->gait_count; ++gait) {
        bool is_near = true;
        for (int i = 0; i < coordinates; ++i) {
            is_near = is_near && fabs(apex[i] - rules->gaits[gait][i]) <= rules->distance * scales[i];
        }
        if (is_near) {
            return gait;
        }
    }
    return -1;
}

/* False where the stride that has closed was the last. */
static bool close_stride(tdmf_runner *runner) {
    const tdmf_ensemble_case *its_case = runner->its_case;
    tdmf_ensemble_end *end = runner->end;
    note_apex(runner);
    open_stride(runner);
    ++end->strides;
    end->gait = gait_near(runner, end->apex);
    if (end->gait >= 0) {
        end->fate = TDMF_FATE_SETTLED;
        return false;
    }
    return end->strides < its_case->rules.most_strides && step_ground(runner) && leave_apex(runner);
}

/* Whether the runner is where the stance of the reduced map is over, and its flight to the next apex. */
static bool has_lifted_off(const tdmf_runner *runner) {
    return runner->map == TDMF_REDUCED_MAP && !tdmf_in_contact(&runner->motion.mode);
}

static bool fly(tdmf_runner *runner) {
    const tdmf_ensemble_case *its_case = runner->its_case;
    const tdmf_reduced_outcome outcome = tdmf_reduced_fly(its_case->model, &runner->inputs, &runner->motion);
    if (outcome != TDMF_REDUCED_CLOSED) {
        tdmf_runner_give_up(runner, fate_of_reduced(outcome));
        return false;
    }
    return close_stride(runner);
}

bool tdmf_runner_take_event(tdmf_runner *runner, const double *fields) {
    tdmf_motion *motion = &runner->motion;
    const tdmf_mode before = motion->mode;
    store(runner, fields);
    tdmf_run run = {runner->its_case->model, &runner->inputs, motion->time,     motion->state,
                    &motion->mode,           &motion->record, runner->direction};
    const bool resolved = tdmf_take_transitions(&run);
    if (motion->mode.fallen) {
        tdmf_runner_give_up(runner, TDMF_FATE_FELL);
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
    return motion->record.stride.count == runner->end->strides || close_stride(runner);
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

bool tdmf_runner_stride(tdmf_runner *runner, tdmf_solver *solver) {
    const tdmf_ensemble_case *its_case = runner->its_case;
    const bool reduced = runner->map == TDMF_REDUCED_MAP;
    const double until = runner->stride_began + TDMF_LONGEST_STRIDE * its_case->model->scales.time;
    const tdmf_stride_outcome stride =
        reduced ? tdmf_native_stance(solver, its_case->model, &runner->inputs, until, &runner->motion, NULL,
                                     NULL, 0)
                : tdmf_native_stride(solver, its_case->model, &runner->inputs, until, &runner->motion);
    if (!stride.closed) {
        tdmf_runner_give_up(runner, fate_of(stride.outcome));
        return false;
    }
    return reduced ? fly(runner) : close_stride(runner);
}

void tdmf_runner_give_up(tdmf_runner *runner, tdmf_fate fate) {
    runner->end->fate = (int)fate;
    runner->end->gait = -1;
}
