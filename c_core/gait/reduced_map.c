/* A stride of the reduced map and its variations, which go through the impact and the stance as those of the
 * full model do. At lift-off they are those at a fixed time, with the centre of mass ballistic from there. */
#include "tdmf_slip/reduced_map.h"

#include "event_log.h"
#include "ground_line.h"
#include "prescribed_flight.h"
#include "reduced_stride.h"
#include "request.h"
#include "tdmf_slip/dynamics.h"
#include "tdmf_slip/energy.h"

#include <string.h>

/* ---- variations --------------------------------------------------------------------------------------- */

typedef struct {
    int count;
    tdmf_seed seeds[TDMF_VARIATION_LIMIT];
    tdmf_variation variations[TDMF_VARIATION_LIMIT];
} bundle;

static void open_bundle(bundle *bundle, const tdmf_seed *seeds, int count) {
    bundle->count = TDMF_REDUCED_COUNT + count;
    for (int i = 0; i < count; ++i) {
        bundle->seeds[TDMF_REDUCED_COUNT + i] = seeds[i];
    }
}

/* From the apex through the impact. */
static void touch_down(bundle *bundle, const tdmf_model *model, const tdmf_inputs *inputs, tdmf_point apex,
                       const tdmf_motion *motion, const tdmf_event_state *before) {
    tdmf_event_state after = {.mode = motion->mode,
                              .peak_force = motion->record.open.peak_force,
                              .peak_vertical_force = motion->record.open.peak_vertical_force};
    memcpy(after.state, motion->state, sizeof after.state);
    tdmf_derivatives(model, inputs, &after.mode, after.state, after.derivatives);
    for (int i = 0; i < bundle->count; ++i) {
        const tdmf_local_seed d = tdmf_local_seed_of(model, &bundle->seeds[i], NULL);
        const double d_height = i == TDMF_REDUCED_COM_HEIGHT;
        const tdmf_point d_apex = {.y = d_height + d.mode.ground.height, .vx = i == TDMF_REDUCED_COM_SPEED};
        tdmf_variation falling = {.liftoff_angle = 0.0};
        tdmf_vary_prescribed_state(model, inputs, &d, apex, d_apex, before->state[TDMF_HIP_PLACE_TIME],
                                   before->state, falling.state);
        bundle->variations[i] =
            tdmf_saltation(model, inputs, TDMF_GUARD_TOUCHDOWN, before, &after, &bundle->seeds[i], &falling);
    }
}

/* From lift-off, the state given, to the next apex. */
static tdmf_reduced_variation fly(const tdmf_model *model, const tdmf_inputs *inputs,
                                  const tdmf_ground_line *ground, const double state[TDMF_STATE_COUNT],
                                  const tdmf_seed *change, const tdmf_variation *variation) {
    const tdmf_local_seed d = tdmf_local_seed_of(model, change, NULL);
    const tdmf_point com = tdmf_center_of_mass(model, state);
    const tdmf_point d_com = tdmf_vary_center_of_mass_along(model, state, tdmf_leg_direction_of(state),
                                                            &d.model, variation->state);
    const double time = tdmf_time_to_apex(model, inputs, com);
    const double d_time = tdmf_vary_time_to_apex(model, inputs, &d, com, d_com);
    const tdmf_point d_apex = tdmf_vary_ballistic(model, inputs, &d, com, d_com, time, d_time);
    const double apex_x = tdmf_center_of_mass_after(model, inputs, com, time).x;
    const double d_ground_height = tdmf_vary_ground_height_at(ground, apex_x, &d.mode.ground, d_apex.x);
    const tdmf_reduced_variation result = {.apex = {d_apex.y - d_ground_height, d_apex.vx},
                                           .period = d_time,
                                           .length = d_apex.x,
                                           .work = variation->state[TDMF_HIP_WORK] +
                                                   variation->state[TDMF_LEG_WORK],
                                           .stance_time = variation->stance.stance_time,
                                           .slip_distance = variation->stance.slip_distance,
                                           .peak_force = variation->stance.peak_force,
                                           .peak_vertical_force = variation->stance.peak_vertical_force};
    return result;
}

/* From the state at lift-off. */
static void close_bundle(const bundle *bundle, const tdmf_model *model, const tdmf_inputs *inputs,
                         const tdmf_ground_line *ground, const double lift_off[TDMF_STATE_COUNT],
                         tdmf_reduced_return *result) {
    for (int i = 0; i < bundle->count; ++i) {
        const tdmf_reduced_variation change =
            fly(model, inputs, ground, lift_off, &bundle->seeds[i], &bundle->variations[i]);
        if (i < TDMF_REDUCED_COUNT) {
            result->by_section[i] = change;
        } else {
            result->by_parameter[i - TDMF_REDUCED_COUNT] = change;
        }
    }
}

/* ---- the map ------------------------------------------------------------------------------------------ */

typedef struct {
    const tdmf_model *model;
    const tdmf_inputs *inputs;
    tdmf_motion motion;
    tdmf_point from;         /* the centre of mass at the apex */
    tdmf_event_state before; /* the impact */
    double lift_off[TDMF_STATE_COUNT];
    double leg_loss;
    bundle bundle;
} run;

/* Less what the external force has given: over a flight it is kept. */
static double energy_of(const run *run, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    return tdmf_mechanical_energy(run->model, run->inputs, mode, state).total -
           state[TDMF_ENERGY_EXTERNAL_WORK];
}

static void log_event(tdmf_event_log *log, const tdmf_motion *motion, tdmf_guard guard,
                      const tdmf_mode *before, const double state[TDMF_STATE_COUNT]) {
    tdmf_event event = {.time = motion->time, .guard = (int)guard, .before = *before, .after = motion->mode};
    memcpy(event.state, state, sizeof event.state);
    tdmf_log_event(log, &event);
}

/* From the apex into contact. */
static tdmf_reduced_outcome descend(run *run, const double apex[TDMF_REDUCED_COUNT], double until,
                                    tdmf_event_log *log) {
    const tdmf_reduced_outcome begun = tdmf_reduced_begin(run->model, run->inputs, apex, &run->motion);
    if (begun != TDMF_REDUCED_CLOSED) {
        return begun;
    }
    const double energy_at_apex = energy_of(run, &run->motion.mode, run->motion.state);
    run->from = tdmf_center_of_mass(run->model, run->motion.state);
    const tdmf_reduced_outcome landed =
        tdmf_reduced_touch_down(run->model, run->inputs, until, &run->motion, &run->before);
    if (landed == TDMF_REDUCED_CLOSED) {
        log_event(log, &run->motion, TDMF_GUARD_TOUCHDOWN, &run->before.mode, run->before.state);
        run->leg_loss = energy_at_apex - energy_of(run, &run->before.mode, run->before.state);
        touch_down(&run->bundle, run->model, run->inputs, run->from, &run->motion, &run->before);
    }
    return landed;
}

static tdmf_reduced_outcome outcome_of_stance(tdmf_stride_outcome stance) {
    if (stance.closed) {
        return TDMF_REDUCED_CLOSED;
    }
    switch (stance.outcome) {
    case TDMF_ARRIVED:
        return TDMF_REDUCED_STUCK;
    case TDMF_FELL:
        return TDMF_REDUCED_FELL;
    case TDMF_REFUSED:
        return TDMF_REDUCED_REFUSED;
    default:
        return TDMF_REDUCED_UNSOLVED;
    }
}

static tdmf_reduced_outcome stand(run *run, tdmf_solver *solver, double until, tdmf_outcome *outcome) {
    bundle *bundle = &run->bundle;
    const tdmf_stride_outcome stance =
        tdmf_native_stance(solver, run->model, run->inputs, run->motion.time + until, &run->motion,
                           bundle->seeds, bundle->variations, bundle->count);
    *outcome = stance.outcome;
    return outcome_of_stance(stance);
}

static tdmf_reduced_outcome rise(run *run, tdmf_event_log *log) {
    const tdmf_mode lifted_off = run->motion.mode;
    memcpy(run->lift_off, run->motion.state, sizeof run->lift_off);
    const tdmf_reduced_outcome risen = tdmf_reduced_fly(run->model, run->inputs, &run->motion);
    run->leg_loss += energy_of(run, &run->motion.mode, run->lift_off) -
                     energy_of(run, &run->motion.mode, run->motion.state);
    if (risen == TDMF_REDUCED_CLOSED) {
        log_event(log, &run->motion, TDMF_GUARD_APEX, &lifted_off, run->motion.state);
    }
    return risen;
}

static void record_stride(const run *run, tdmf_reduced_return *result) {
    const tdmf_record *record = &run->motion.record;
    result->apex[TDMF_REDUCED_COM_HEIGHT] = record->apex.com_height;
    result->apex[TDMF_REDUCED_COM_SPEED] = record->apex.com_speed;
    result->stride = record->stride;
    result->liftoff_angle = run->lift_off[TDMF_LEG_ANGLE];
    result->external_work = run->motion.state[TDMF_ENERGY_EXTERNAL_WORK];
    result->damper_loss = run->lift_off[TDMF_ENERGY_DAMPER_LOSS];
    result->friction_loss = run->lift_off[TDMF_ENERGY_FRICTION_LOSS];
    result->impact_loss = record->impact_loss;
    result->leg_loss = run->leg_loss;
    close_bundle(&run->bundle, run->model, run->inputs, &run->motion.mode.ground, run->lift_off, result);
}

tdmf_reduced_return tdmf_reduced_map(tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs,
                                     const double apex[TDMF_REDUCED_COUNT], double until, bool derivatives,
                                     const tdmf_seed *seeds, int count) {
    run run = {.model = model, .inputs = inputs};
    tdmf_reduced_return result;
    memset(&result, 0, sizeof result);
    if (!tdmf_is_sound_solver(solver) || model == NULL || inputs == NULL || apex == NULL ||
        !tdmf_are_sound_seeds(seeds, count, TDMF_REDUCED_MAP_SEEDS)) {
        result.outcome = TDMF_REDUCED_REFUSED;
        return result;
    }
    if (derivatives) {
        open_bundle(&run.bundle, seeds, count);
    }
    result.outcome = descend(&run, apex, until, solver->log);
    if (result.outcome == TDMF_REDUCED_CLOSED) {
        result.outcome = stand(&run, solver, until, &result.solver);
    }
    if (result.outcome == TDMF_REDUCED_CLOSED) {
        result.outcome = rise(&run, solver->log);
    }
    if (result.outcome == TDMF_REDUCED_CLOSED) {
        record_stride(&run, &result);
    }
    return result;
}

const char *tdmf_reduced_outcome_text(tdmf_reduced_outcome outcome) {
    switch (outcome) {
    case TDMF_REDUCED_CLOSED:
        return "the stride has a next apex";
    case TDMF_REDUCED_FOOT_BELOW:
        return "the foot is not above the ground at the apex";
    case TDMF_REDUCED_NO_TOUCHDOWN:
        return "the foot does not come down in the time that a stride may take";
    case TDMF_REDUCED_NO_STANCE:
        return "the impact leaves the foot without load";
    case TDMF_REDUCED_STUCK:
        return "the foot does not leave the ground in the time that a stride may take";
    case TDMF_REDUCED_NO_APEX:
        return "the centre of mass does not rise at lift-off";
    case TDMF_REDUCED_FELL:
        return "the runner fell";
    case TDMF_REDUCED_UNSOLVED:
        return "the solver did not get through the stance";
    default:
        return "a value is out of range";
    }
}
