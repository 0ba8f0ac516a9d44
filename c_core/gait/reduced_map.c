/* A stride of the reduced map and its variations, which go through the impact and the stance as those of the
 * full model do. At lift-off they are those at a fixed time, with the centre of mass ballistic from there. */
#include "tdmf_slip/reduced_map.h"

#include "coordinate_laws.h"
#include "event_log.h"
#include "free_fall_laws.h"
#include "ground_line.h"
#include "leg.h"
#include "patch.h"
#include "prescribed_flight_laws.h"
#include "reduced_stride.h"
#include "request.h"
#include "return_record.h"
#include "seed.h"
#include "tdmf_slip/dynamics.h"
#include "tdmf_slip/energy.h"

#include <string.h>

/* ---- variations --------------------------------------------------------------------------------------- */

typedef struct {
    int count;
    tdmf_seed seeds[TDMF_VARIATION_LIMIT];
    tdmf_variation variations[TDMF_VARIATION_LIMIT];
} stride_variations;

static void open_variations(stride_variations *varied, const tdmf_seed *seeds, int count) {
    varied->count = TDMF_REDUCED_COUNT + count;
    for (int i = 0; i < count; ++i) {
        varied->seeds[TDMF_REDUCED_COUNT + i] = seeds[i];
    }
}

/* Takes the variations from the apex through the impact. */
static void touch_down(stride_variations *varied, tdmf_system system, tdmf_point apex,
                       const tdmf_motion *motion, const tdmf_event_state *before) {
    tdmf_event_state after = {.mode = motion->mode,
                              .peak_force = motion->record.progress.open.peak_force,
                              .peak_vertical_force = motion->record.progress.open.peak_vertical_force};
    memcpy(after.state, motion->state, sizeof after.state);
    tdmf_derivatives(system, &after.mode, after.state, after.derivatives);
    for (int i = 0; i < varied->count; ++i) {
        const tdmf_local_seed d = tdmf_local_seed_of(system.model, &varied->seeds[i], NULL);
        const double d_height = i == TDMF_REDUCED_COM_HEIGHT;
        const tdmf_point d_apex = {.y = d_height + d.mode.ground.height, .vx = i == TDMF_REDUCED_COM_SPEED};
        tdmf_variation falling = {.liftoff_angle = 0.0};
        tdmf_vary_prescribed_state(system.model, system.inputs, apex, before->state[TDMF_HIP_PLACE_TIME],
                                   &d.model, &d.inputs, d_apex, 0.0, falling.state);
        varied->variations[i] =
            tdmf_saltation(system, TDMF_GUARD_TOUCHDOWN, before, &after, &varied->seeds[i], &falling);
    }
}

/* Takes a variation from lift-off, the state given, to the next apex. */
static tdmf_stride_variation fly(tdmf_system system, const tdmf_ground_line *ground,
                                 const double state[TDMF_STATE_COUNT], const tdmf_seed *seed,
                                 const tdmf_variation *variation) {
    const tdmf_local_seed d = tdmf_local_seed_of(system.model, seed, NULL);
    const tdmf_point com = tdmf_center_of_mass(system.model, state);
    const tdmf_point d_com = tdmf_vary_center_of_mass_along(system.model, state, tdmf_leg_direction_of(state),
                                                            &d.model, variation->state);
    const tdmf_model *model = system.model;
    const tdmf_inputs *inputs = system.inputs;
    const double time = tdmf_rise_time(model, inputs, com);
    const double d_time = tdmf_vary_rise_time(model, inputs, com, &d.model, &d.inputs, d_com);
    const tdmf_point d_apex =
        tdmf_vary_ballistic_under(model, inputs, com, time, &d.model, &d.inputs, d_com, d_time);
    const double apex_x = tdmf_ballistic_under(model, inputs, com, time).x;
    const double d_ground_height = tdmf_vary_ground_height_at(ground, apex_x, &d.mode.ground, d_apex.x);
    tdmf_stride_variation result = {.apex = {d_apex.y - d_ground_height, d_apex.vx},
                                    .period = d_time,
                                    .length = d_apex.x,
                                    .work =
                                        variation->state[TDMF_HIP_WORK] + variation->state[TDMF_LEG_WORK]};
    tdmf_write_stance_variation(&variation->stance, &result);
    return result;
}

/* ---- the map ------------------------------------------------------------------------------------------ */

typedef struct {
    tdmf_system system;
    tdmf_motion motion;
    tdmf_point from;         /* the centre of mass at the apex */
    tdmf_event_state before; /* the impact */
    double lift_off[TDMF_STATE_COUNT];
    double leg_loss;
    stride_variations varied;
} run;

/* The energy less what the external force has given is kept over a flight. */
static double energy_of(const run *run, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    return tdmf_mechanical_energy(run->system, mode, state).total - state[TDMF_ENERGY_EXTERNAL_WORK];
}

static void log_event(tdmf_event_log *log, const tdmf_motion *motion, tdmf_guard guard,
                      const tdmf_mode *before, const double state[TDMF_STATE_COUNT]) {
    tdmf_event event = {.time = motion->time, .guard = (int)guard, .before = *before, .after = motion->mode};
    memcpy(event.state, state, sizeof event.state);
    tdmf_log_event(log, &event);
}

/* Goes from the apex into contact. */
static tdmf_return_outcome descend(run *run, const double apex[TDMF_REDUCED_COUNT], double until,
                                   tdmf_event_log *log) {
    const tdmf_return_outcome begun = tdmf_reduced_begin(run->system, apex, &run->motion);
    if (begun != TDMF_RETURN_CLOSED) {
        return begun;
    }
    const double energy_at_apex = energy_of(run, &run->motion.mode, run->motion.state);
    run->from = tdmf_center_of_mass(run->system.model, run->motion.state);
    const tdmf_return_outcome landed =
        tdmf_reduced_touch_down(run->system, until, &run->motion, &run->before);
    if (landed == TDMF_RETURN_CLOSED) {
        log_event(log, &run->motion, TDMF_GUARD_TOUCHDOWN, &run->before.mode, run->before.state);
        run->leg_loss = energy_at_apex - energy_of(run, &run->before.mode, run->before.state);
        touch_down(&run->varied, run->system, run->from, &run->motion, &run->before);
    }
    return landed;
}

static tdmf_return_outcome stand(run *run, tdmf_solver *solver, double until, tdmf_outcome *outcome) {
    stride_variations *varied = &run->varied;
    const tdmf_stride_outcome stance =
        tdmf_native_stance(solver, run->system, run->motion.time + until, &run->motion, varied->seeds,
                           varied->variations, varied->count);
    *outcome = stance.outcome;
    return tdmf_return_outcome_of(stance);
}

static tdmf_return_outcome rise(run *run, tdmf_event_log *log) {
    const tdmf_mode lifted_off = run->motion.mode;
    memcpy(run->lift_off, run->motion.state, sizeof run->lift_off);
    const tdmf_return_outcome risen = tdmf_reduced_fly(run->system, &run->motion);
    run->leg_loss += energy_of(run, &run->motion.mode, run->lift_off) -
                     energy_of(run, &run->motion.mode, run->motion.state);
    if (risen == TDMF_RETURN_CLOSED) {
        log_event(log, &run->motion, TDMF_GUARD_APEX, &lifted_off, run->motion.state);
    }
    return risen;
}

static void write_stride(const run *run, tdmf_return *result) {
    const tdmf_record *record = &run->motion.record;
    const stride_variations *varied = &run->varied;
    result->apex[TDMF_REDUCED_COM_HEIGHT] = record->apex.com_height;
    result->apex[TDMF_REDUCED_COM_SPEED] = record->apex.com_speed;
    result->liftoff_angle = run->lift_off[TDMF_LEG_ANGLE];
    tdmf_write_return(record, run->lift_off, result);
    result->external_work = run->motion.state[TDMF_ENERGY_EXTERNAL_WORK]; /* in flight, too */
    result->leg_loss = run->leg_loss;
    for (int i = 0; i < varied->count; ++i) {
        result->variations[i] = fly(run->system, &run->motion.mode.ground, run->lift_off, &varied->seeds[i],
                                    &varied->variations[i]);
    }
}

tdmf_return tdmf_reduced_map(tdmf_solver *solver, tdmf_system system, const double apex[TDMF_REDUCED_COUNT],
                             double until, bool derivatives, const tdmf_seed *seeds, int count) {
    run run = {.system = system};
    tdmf_return result;
    memset(&result, 0, sizeof result);
    if (!tdmf_is_sound_solver(solver) || system.model == NULL || system.inputs == NULL || apex == NULL ||
        tdmf_has_patch(system.model) || !tdmf_are_sound_seeds(seeds, count, TDMF_REDUCED_MAP_SEEDS)) {
        result.outcome = TDMF_RETURN_REFUSED;
        return result;
    }
    if (derivatives) {
        open_variations(&run.varied, seeds, count);
    }
    result.outcome = descend(&run, apex, until, solver->log);
    if (result.outcome == TDMF_RETURN_CLOSED) {
        result.outcome = stand(&run, solver, until, &result.solver);
    }
    if (result.outcome == TDMF_RETURN_CLOSED) {
        result.outcome = rise(&run, solver->log);
    }
    if (result.outcome == TDMF_RETURN_CLOSED) {
        write_stride(&run, &result);
    }
    return result;
}
