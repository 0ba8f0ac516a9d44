/* A runner at an apex: where it begins and where a stride closes, what it is set to, and its ground. */
#include "runner.h"

#include "drawn_ground.h"
#include "events.h"
#include "ground_line.h"
#include "reduced_stride.h"
#include "settings.h"
#include "settled.h"
#include "stride_limits.h"
#include "tdmf_slip/automaton.h"
#include "tdmf_slip/orbit.h"
#include "threads.h"

#include <math.h>
#include <string.h>

static double step_limit(const tdmf_ensemble *ensemble) {
    return ensemble->step_limit > 0 ? (double)ensemble->step_limit : (double)TDMF_STEP_LIMIT;
}

static void open_stride(tdmf_runner *runner, double steps_left) {
    runner->stride_began = runner->motion.time;
    runner->steps = opened_steps(steps_left);
    runner->events_left = TDMF_EVENT_LIMIT;
    runner->false_crossings = 0;
}

/* ---- what is set -------------------------------------------------------------------------------------- */

/* Where the stride under way is noted, or NULL. */
static tdmf_ensemble_stride *open_stride_record(const tdmf_runner *runner) {
    const tdmf_ensemble *ensemble = runner->ensemble;
    const int stride = runner->end->strides - ensemble->first_stride;
    return ensemble->strides && stride >= 0 && stride < ensemble->stride_count
               ? &ensemble->strides[runner->index * ensemble->stride_count + stride]
               : NULL;
}

static void set_all(tdmf_runner *runner, const int *settings, const double *values, int count) {
    for (int i = 0; i < count; ++i) {
        tdmf_write_setting(settings[i], values[i], &runner->set.parameters, &runner->inputs);
    }
}

static void set_given(tdmf_runner *runner, const tdmf_given_settings *given) {
    int stride = runner->end->strides - given->first;
    stride = stride < 0 ? 0 : stride < given->strides ? stride : given->strides - 1;
    const double *values = &given->values[(runner->index * given->strides + stride) * given->count];
    set_all(runner, given->settings, values, given->count);
}

static void set_by_law(tdmf_runner *runner, const tdmf_affine_law *law) {
    double values[TDMF_SETTING_LIMIT];
    tdmf_ensemble_stride *record = open_stride_record(runner);
    const tdmf_ensemble_end *end = runner->end;
    tdmf_affine_settings(law, end->apex, runner->number, (uint32_t)end->strides, values);
    set_all(runner, law->settings, values, law->count);
    if (record) {
        memcpy(record->set, values, (size_t)law->count * sizeof *values);
    }
}

static bool is_set(const tdmf_runner *runner) {
    return runner->model == &runner->set;
}

/* The settings of the stride that begins. */
static void set(tdmf_runner *runner) {
    const tdmf_affine_law *law = runner->its_case->rules.law;
    if (runner->ensemble->given) {
        set_given(runner, runner->ensemble->given);
    }
    if (law) {
        set_by_law(runner, law);
    }
}

/* ---- from an apex on ---------------------------------------------------------------------------------- */

/* Goes from an apex of the reduced map into contact; from an apex of the return map the runner flies on.
 * Returns false where the run has ended. */
static bool leave_apex(tdmf_runner *runner) {
    if (runner->map != TDMF_REDUCED_MAP) {
        return true;
    }
    const tdmf_return_outcome outcome = tdmf_reduced_touch_down(
        tdmf_runner_system(runner), TDMF_LONGEST_STRIDE * runner->model->scales.time, &runner->motion);
    runner->direction = tdmf_leg_direction_of(runner->motion.state);
    if (outcome != TDMF_RETURN_CLOSED) {
        tdmf_runner_give_up_reduced(runner, outcome);
        return false;
    }
    return true;
}

/* Takes what has become due by new settings and ground. False where the run has ended. */
static bool resolve(tdmf_runner *runner) {
    tdmf_motion *motion = &runner->motion;
    const tdmf_resolution resolution =
        tdmf_resolve_along(tdmf_runner_system(runner), motion, runner->direction, TDMF_GUARD_COUNT);
    if (motion->mode.fallen || resolution.unresolved) {
        tdmf_runner_give_up(runner, motion->mode.fallen ? TDMF_FATE_FELL : TDMF_FATE_UNSOLVED);
        return false;
    }
    return true;
}

static bool steps_by_stride(const tdmf_runner *runner) {
    const tdmf_ensemble_rules *rules = &runner->its_case->rules;
    return rules->roughness != 0.0 && !tdmf_has_terrain(rules);
}

static void step_ground(tdmf_runner *runner) {
    runner->inputs.ground.height +=
        tdmf_drawn_step(&runner->its_case->rules, runner->number, (uint32_t)runner->end->strides);
}

static void draw_friction(tdmf_runner *runner) {
    const tdmf_ensemble_case *its_case = runner->its_case;
    runner->inputs.ground.friction = tdmf_drawn_friction(&its_case->rules, its_case->inputs.ground.friction,
                                                         runner->number, (uint32_t)runner->end->strides);
}

/* The foot is below the step that has just come. */
static bool trips(const tdmf_runner *runner) {
    const tdmf_ground_line step = tdmf_ground_line_set(&runner->inputs);
    return runner->its_case->rules.trips && tdmf_foot_over_ground(&step, runner->motion.state).y < 0.0;
}

/* False where the run has ended: a runner that has not got onto its last ground in a whole stride is below
 * it. */
static bool is_above_ground(tdmf_runner *runner) {
    if (tdmf_ground_is_pending(&runner->inputs, &runner->motion.mode)) {
        tdmf_runner_give_up(runner, TDMF_FATE_FELL);
        return false;
    }
    return true;
}

static void record_beginning(tdmf_runner *runner) {
    tdmf_ensemble_stride *record = open_stride_record(runner);
    if (record) {
        record->began = 1;
        record->ground_height = tdmf_has_terrain(&runner->its_case->rules) ? tdmf_height_below(runner)
                                                                           : runner->inputs.ground.height;
    }
}

/* Goes on from an apex with the settings of the stride that begins. Returns false where the run has ended. */
static bool begin_stride(tdmf_runner *runner) {
    const bool is_rough = steps_by_stride(runner);
    if (is_rough) {
        step_ground(runner);
    }
    if (runner->its_case->rules.friction_spread != 0.0 && !tdmf_has_terrain(&runner->its_case->rules)) {
        draw_friction(runner);
    }
    record_beginning(runner);
    if (is_rough && trips(runner)) {
        tdmf_runner_give_up(runner, TDMF_FATE_FELL);
        return false;
    }
    if (runner->map == TDMF_REDUCED_MAP) {
        return leave_apex(runner);
    }
    return !(is_rough || is_set(runner)) || resolve(runner);
}

/* Goes on from the apex at which a stride has closed. Returns false where the run has ended. */
static bool begin_next_stride(tdmf_runner *runner) {
    if ((is_set(runner) || steps_by_stride(runner)) && !tdmf_has_terrain(&runner->its_case->rules) &&
        !is_above_ground(runner)) {
        return false;
    }
    if (is_set(runner)) {
        set(runner);
        if (runner->map == TDMF_REDUCED_MAP) {
            tdmf_reduced_reset_leg(tdmf_runner_system(runner), &runner->motion);
        }
    }
    return begin_stride(runner);
}

/* ---- where a run begins ------------------------------------------------------------------------------- */

static double start_foot_x(const tdmf_runner *runner) {
    return runner->ensemble->foot_x ? runner->ensemble->foot_x[runner->index] : 0.0;
}

/* Puts the motion at the apex that a runner starts from. Returns false where it is none. */
static bool start(tdmf_runner *runner, const double section[TDMF_SECTION_COUNT]) {
    const tdmf_model *model = runner->model;
    tdmf_motion *motion = &runner->motion;
    if (tdmf_has_terrain(&runner->its_case->rules)) {
        runner->inputs.ground.height = tdmf_enter_terrain(runner, start_foot_x(runner));
    }
    if (runner->map == TDMF_REDUCED_MAP) {
        return tdmf_reduced_begin((tdmf_system){model, &runner->inputs}, section, motion) ==
               TDMF_RETURN_CLOSED;
    }
    motion->time = 0.0;
    tdmf_section_state_at((tdmf_system){model, &runner->inputs}, start_foot_x(runner), section,
                          motion->state);
    return !tdmf_start((tdmf_system){model, &runner->inputs}, motion).variable &&
           motion->record.progress.open.began_at_apex;
}

static void meet(tdmf_runner *runner, const tdmf_ensemble *ensemble, int64_t index, tdmf_ensemble_end *end) {
    runner->ensemble = ensemble;
    runner->index = index;
    runner->its_case = &ensemble->cases[ensemble->case_of ? ensemble->case_of[index] : 0];
    runner->model = runner->its_case->model;
    runner->map = ensemble->map;
    runner->number = ensemble->first_number + (uint64_t)index;
    runner->inputs = runner->its_case->inputs;
    runner->end = end;
    if (ensemble->given || runner->its_case->rules.law) {
        runner->set = *runner->its_case->model;
        runner->model = &runner->set;
    }
}

/* On this gait, if it is one. */
static bool settles(tdmf_runner *runner, int gait) {
    runner->end->gait = gait;
    if (gait >= 0) {
        runner->end->fate = TDMF_FATE_SETTLED;
    }
    return gait >= 0;
}

static bool begin(tdmf_runner *runner) {
    static const tdmf_ensemble_end nothing_yet = {.fate = TDMF_FATE_UNDECIDED, .gait = -1};
    const double *section = runner->ensemble->starts[runner->index];
    tdmf_ensemble_end *end = runner->end;
    *end = nothing_yet;
    memcpy(end->apex, section, sizeof end->apex);
    end->foot_x = start_foot_x(runner);
    if (runner->ensemble->checkpoints) {
        runner->ensemble->checkpoints[runner->index].stands = false;
    }
    if (is_set(runner)) {
        set(runner);
    }
    if (!start(runner, section)) {
        end->fate = TDMF_FATE_NO_START;
        return false;
    }
    runner->direction = tdmf_leg_direction_of(runner->motion.state);
    open_stride(runner, step_limit(runner->ensemble));
    if (tdmf_has_terrain(&runner->its_case->rules) && !tdmf_look_at_terrain(runner)) {
        return false;
    }
    return runner->its_case->rules.max_strides > 0 && !settles(runner, tdmf_gait_of_ball(runner, section)) &&
           begin_stride(runner);
}

/* Where it stood at the end of an earlier call. */
static bool go_on(tdmf_runner *runner) {
    tdmf_ensemble_checkpoint *checkpoint = &runner->ensemble->checkpoints[runner->index];
    if (!checkpoint->stands || runner->end->strides >= runner->its_case->rules.max_strides) {
        return false;
    }
    checkpoint->stands = false;
    runner->end->fate = TDMF_FATE_UNDECIDED;
    runner->motion = checkpoint->motion;
    runner->direction = tdmf_leg_direction_of(runner->motion.state);
    runner->inputs.ground.height = checkpoint->ground_height;
    if (tdmf_has_terrain(&runner->its_case->rules)) {
        tdmf_resume_terrain(runner, checkpoint->seen_x, checkpoint->seen_y);
    }
    open_stride(runner, step_limit(runner->ensemble));
    return begin_next_stride(runner);
}

bool tdmf_runner_begin(tdmf_runner *runner, const tdmf_ensemble *ensemble, int64_t index,
                       tdmf_ensemble_end *end) {
    meet(runner, ensemble, index, end);
    return ensemble->goes_on ? go_on(runner) : begin(runner);
}

/* ---- where a stride closes ---------------------------------------------------------------------------- */

static void record_apex(tdmf_runner *runner) {
    const tdmf_record *record = &runner->motion.record;
    const double *state = runner->motion.state;
    tdmf_ensemble_end *end = runner->end;
    const double apex[TDMF_SECTION_COUNT] = {record->apex.com_height,      record->apex.com_speed,
                                             record->apex.leg_length,      record->apex.leg_angle,
                                             record->apex.leg_length_rate, record->apex.leg_angle_rate};
    memcpy(end->apex, apex, sizeof apex);
    if (tdmf_has_terrain(&runner->its_case->rules)) {
        end->apex[0] += runner->motion.mode.ground.height - tdmf_height_below(runner);
    }
    end->foot_x = state[TDMF_FOOT_X];
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

/* Records the stride that has closed between these ends. */
static void record_stride(const tdmf_runner *runner, const tdmf_ensemble_end *before,
                          tdmf_ensemble_stride *record) {
    const tdmf_ensemble_end *end = runner->end;
    memcpy(record->apex, end->apex, sizeof record->apex);
    record->foot_x = end->foot_x;
    record->stride = runner->motion.record.stride;
    record->liftoff_angle = runner->motion.mode.liftoff_angle;
    record->external_work = end->external_work - before->external_work;
    record->damper_loss = end->damper_loss - before->damper_loss;
    record->friction_loss = end->friction_loss - before->friction_loss;
    record->impact_loss = end->impact_loss - before->impact_loss;
}

static void stand(const tdmf_runner *runner) {
    tdmf_ensemble_checkpoint *checkpoints = runner->ensemble->checkpoints;
    if (checkpoints) {
        const tdmf_ensemble_checkpoint checkpoint = {.stands = true,
                                                     .motion = runner->motion,
                                                     .ground_height = runner->inputs.ground.height,
                                                     .seen_x = runner->terrain.x,
                                                     .seen_y = runner->terrain.y};
        checkpoints[runner->index] = checkpoint;
    }
}

bool tdmf_runner_close_stride(tdmf_runner *runner) {
    tdmf_ensemble_end *end = runner->end;
    tdmf_ensemble_stride *record = open_stride_record(runner);
    const tdmf_ensemble_end before = *end;
    record_apex(runner);
    if (record) {
        record_stride(runner, &before, record);
    }
    open_stride(runner, tdmf_steps_of_next_stride(runner->steps.left, step_limit(runner->ensemble)));
    ++end->strides;
    if (settles(runner, tdmf_gait_reached(runner, end->apex))) {
        return false;
    }
    if (tdmf_is_raised(runner->ensemble->stop)) {
        tdmf_runner_give_up(runner, TDMF_FATE_STOPPED);
        stand(runner);
        return false;
    }
    if (end->strides >= runner->its_case->rules.max_strides) {
        stand(runner);
        return false;
    }
    return begin_next_stride(runner);
}
