/* The automaton for solvers of one's own: guards, and chains of events in zero time, by the runner's page. */
#include "tdmf_slip/automaton.h"

#include "automaton.h"
#include "contact_mode.h"
#include "input_rates.h"
#include "kinematics.h"
#include "motion_instant.h"
#include "page_fields.h"
#include "page_solver.h"

#include <math.h>
#include <string.h>

/* ---- guards -------------------------------------------------------------------------------------------- */

void tdmf_guards(tdmf_system system, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                 double guards[TDMF_GUARD_COUNT]) {
    tdmf_motion_instant instant;
    if (tdmf_is_mode(mode)) {
        tdmf_begin_instant(&instant, system, mode, state);
        tdmf_write_guards(&instant, mode, guards);
        return;
    }
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        guards[i] = NAN;
    }
}

/* The order of events that are due is the page's; what only the record or an apex to come knows is last. */
tdmf_guard tdmf_first_due(tdmf_system system, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    tdmf_motion_instant instant;
    double guards[TDMF_GUARD_COUNT];
    if (!tdmf_is_mode(mode)) {
        return TDMF_GUARD_COUNT;
    }
    tdmf_begin_instant(&instant, system, mode, state);
    tdmf_write_guards(&instant, mode, guards);
    for (int i = 0; i < instant.at.mode->guard_count; ++i) {
        const tdmf_guard guard = tdmf_guard_of_event(instant.at.mode->guards[i].event);
        if (guard < TDMF_GUARD_COUNT && guards[guard] <= 0.0) {
            return guard;
        }
    }
    return guards[TDMF_GUARD_FORCE_PEAK] <= 0.0            ? TDMF_GUARD_FORCE_PEAK
           : guards[TDMF_GUARD_VERTICAL_FORCE_PEAK] <= 0.0 ? TDMF_GUARD_VERTICAL_FORCE_PEAK
                                                           : TDMF_GUARD_COUNT;
}

/* ---- peaks of the ground force --------------------------------------------------------------------------
 */

void tdmf_observe(tdmf_system system, tdmf_motion *motion) {
    tdmf_mode *mode = &motion->mode;
    double *peak = &motion->state[TDMF_STRIDE_PEAK_FORCE_SO_FAR];
    double *vertical_peak = &motion->state[TDMF_STRIDE_VERTICAL_SO_FAR];
    tdmf_motion_instant instant;
    if (!tdmf_is_loaded(mode) || mode->fallen) {
        return;
    }
    tdmf_begin_instant(&instant, system, mode, motion->state);
    const tdmf_observed_force normal = tdmf_normal_force_at(&instant);
    const tdmf_observed_force vertical = tdmf_vertical_force_at(&instant);
    *peak = fmax(*peak, normal.force);
    *vertical_peak = fmax(*vertical_peak, vertical.force);
    mode->ground_force_rising = normal.rate > 0.0;
    mode->vertical_force_rising = vertical.rate > 0.0;
}

/* ---- chains -------------------------------------------------------------------------------------------- */

/* The states, with the world's coordinates up to date. */
static void write_world_state(const tdmf_page_point *point, double state[TDMF_STATE_COUNT]) {
    runner_states room;
    memcpy(state, &point->x, sizeof point->x);
    tdmf_show_to_world(&tdmf_runner_model, point->mode, (const double *)&point->p, state, (double *)&room);
}

/* Coordinates that no event changes keep their values. The maps to the page and back would round them. */
bool tdmf_settle_motion(tdmf_system system, tdmf_motion_instant *instant, tdmf_motion *motion,
                        tdmf_chain *chain) {
    tdmf_page_point *point = &instant->point;
    double memory[TDMF_SETTLING_MEMORY], given[TDMF_STATE_COUNT], before[TDMF_STATE_COUNT],
        after[TDMF_STATE_COUNT];
    write_world_state(point, before);
    tdmf_page_run run = tdmf_run_at(point, memory);
    const bool is_settled =
        tdmf_take_due_events(&tdmf_runner_model, &run, instant->watch, instant->memory, chain);
    int last_mode = point->mode;
    if (chain->count > 0 && run.mode == MODE_fallen) {
        last_mode = chain->last.before;
    }
    point->mode = run.mode;
    point->above = (uint64_t)(instant->watch[EVENT_apex] == WATCH_ABOVE) << EVENT_apex;
    memcpy(given, motion->state, sizeof given);
    tdmf_motion_of_page(system, point, last_mode, motion);
    write_world_state(point, after);
    for (int i = TDMF_FOOT_X; i < TDMF_FOOT_X + TDMF_COORDINATE_COUNT; ++i) {
        motion->state[i] = after[i] == before[i] ? given[i] : motion->state[i];
    }
    return is_settled;
}

tdmf_page_run tdmf_run_at(tdmf_page_point *point, double *memory) {
    const tdmf_page_run run = {.p = (double *)&point->p,
                               .x = (double *)&point->x,
                               .memory = memory,
                               .time = point->time,
                               .time_rest = point->rest,
                               .mode = point->mode,
                               .above = point->above,
                               .stop_event = -1,
                               .observes = TDMF_OBSERVE_USUAL,
                               .step_limit = TDMF_STEP_LIMIT,
                               .event_limit = TDMF_EVENT_LIMIT};
    return run;
}

/* Events change mechanical states, the work of the leg and the clock of its placing. */
static bool has_jumped(const double *before, const double *after) {
    const size_t size = TDMF_MECHANICAL_COUNT * sizeof *before;
    return memcmp(before + TDMF_FOOT_X, after + TDMF_FOOT_X, size) != 0 ||
           before[TDMF_LEG_WORK] != after[TDMF_LEG_WORK] ||
           before[TDMF_HIP_PLACE_TIME] != after[TDMF_HIP_PLACE_TIME];
}

/* The right-hand side and the ground are the same: contact, phase, zone, clamp, thrust, line and fall. */
static bool same_mode(const tdmf_mode *a, const tdmf_mode *b) {
    return a->contact == b->contact && a->phase == b->phase && a->zone == b->zone &&
           a->mid_stance_pending == b->mid_stance_pending && a->clamp_closed == b->clamp_closed &&
           a->rest_length == b->rest_length && a->ground.height == b->ground.height &&
           a->ground.slope == b->ground.slope && a->fallen == b->fallen;
}

/* Rounding or a coarse solver may leave a rising foot below the ground in flight. That is no touchdown. */
static void lift_sunken_foot(tdmf_motion *motion) {
    const tdmf_ground_line *ground = &motion->mode.ground;
    const tdmf_point foot = tdmf_foot_over_ground(ground, motion->state);
    if (motion->mode.contact == TDMF_CONTACT_FLIGHT && foot.y < 0.0 && foot.vy > 0.0) {
        motion->state[TDMF_FOOT_X] = ground->cosine * foot.x;
        motion->state[TDMF_FOOT_Y] = ground->height + ground->sine * foot.x;
    }
}

tdmf_resolution tdmf_resolve(tdmf_system system, tdmf_motion *motion) {
    static const tdmf_resolution no_mode = {.unresolved = true};
    const tdmf_motion before = *motion;
    tdmf_motion_instant instant;
    tdmf_chain chain;
    if (!tdmf_is_mode(&motion->mode)) {
        return no_mode;
    }
    const tdmf_resolution frozen = {.unresolved = false};
    if (motion->mode.fallen) {
        return frozen;
    }
    /* The host may have changed hip.swing_clamp since the last call. */
    motion->mode.clamp_closed &= system.model->parameters.hip.swing_clamp;
    lift_sunken_foot(motion);
    tdmf_observe(system, motion);
    const tdmf_page_point point = tdmf_page_of_motion(system, &tdmf_zero_input_rates, motion);
    tdmf_begin_instant_of_point(&instant, &point);
    const bool is_settled = tdmf_settle_motion(system, &instant, motion, &chain);
    tdmf_observe(system, motion);
    const tdmf_resolution resolution = {
        .state_changed = has_jumped(before.state, motion->state),
        .mode_changed = !same_mode(&before.mode, &motion->mode),
        .unresolved = !is_settled,
    };
    return resolution;
}
