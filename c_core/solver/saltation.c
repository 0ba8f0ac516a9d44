/* With the guard g, the reset R, the right-hand sides f- and f+, and d_ for the variation of what follows, an
 * event shifts by dt and takes the variation over:
 *
 *     dt = -(g_x d_x + g_p d_p)/(g_x f-),      d_x+ = R_x (d_x + f- dt) + R_p d_p - f+ dt.
 *
 * The stance time of a stride ends or begins dt later; its slip distance has the place of the foot at the
 * event.
 *
 * Transitions that follow in zero time are decided by inequalities and shift with the first one; of all of
 * them, only the first moves the runner. */
#include "saltation.h"

#include "contact_change.h"
#include "evaluation.h"
#include "ground_line.h"

#include <math.h>
#include <string.h>

/* This holds to one side, at least. */
static bool has_no_friction(tdmf_system system, double x) {
    const tdmf_zone ahead = tdmf_zone_towards(system.model, x, 1.0);
    const tdmf_zone behind = tdmf_zone_towards(system.model, x, -1.0);
    return tdmf_friction_below(system.model, system.inputs, ahead) == 0.0 ||
           tdmf_friction_below(system.model, system.inputs, behind) == 0.0;
}

/* Where a neighbour's events differ in kind, no derivative tells what becomes of it: the foot met the ground
 * at another event's time, or without meeting it; or it stands where no friction holds it. */
static bool is_on_edge(tdmf_system system, bool impact, const tdmf_event_state *before,
                       const tdmf_event_state *after) {
    const bool flew = before->mode.contact == TDMF_CONTACT_FLIGHT;
    const bool landed = flew && (after->state[TDMF_FOOT_VX] != before->state[TDMF_FOOT_VX] ||
                                 after->state[TDMF_FOOT_VY] != before->state[TDMF_FOOT_VY]);
    const bool stands = after->mode.contact == TDMF_CONTACT_STICK;
    return impact != landed || (stands && has_no_friction(system, after->state[TDMF_FOOT_X]));
}

static tdmf_variation no_variation(void) {
    tdmf_variation none;
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        none.state[i] = NAN;
    }
    none.liftoff_angle = NAN;
    none.stance.stance_time = none.stance.slip_distance = none.stance.peak_force =
        none.stance.peak_vertical_force = NAN;
    return none;
}

static double vary_guard(const tdmf_event_kind *event, const tdmf_evaluation *at, const tdmf_local_seed *d,
                         const double d_state[TDMF_STATE_COUNT]) {
    const tdmf_evaluation d_at = tdmf_vary_evaluation(at, d, d_state);
    return event->vary_guard(at, &d_at);
}

/* Gives the time by which the event shifts. */
static double time_shift(const tdmf_event_kind *event, tdmf_system system, const tdmf_event_state *before,
                         const tdmf_local_seed *d) {
    const tdmf_evaluation at = tdmf_evaluate(system, &before->mode, before->state);
    return -vary_guard(event, &at, d, d->state) / vary_guard(event, &at, &tdmf_no_seed, before->derivatives);
}

static void shift_in_time(double dt, const double derivatives[TDMF_STATE_COUNT],
                          double d_state[TDMF_STATE_COUNT]) {
    for (int i = 0; i < TDMF_VARIED_COUNT; ++i) {
        d_state[i] += derivatives[i] * dt;
    }
}

/* The ground force on a side of the event, and its change where the event is met; `d` has the state's change
 * there. */
typedef struct {
    tdmf_evaluation at, d_at;
} varied_force;

static varied_force vary_force(tdmf_system system, const tdmf_event_state *event_state,
                               const tdmf_local_seed *d) {
    varied_force force;
    force.at = tdmf_evaluate(system, &event_state->mode, event_state->state);
    force.d_at = tdmf_vary_evaluation(&force.at, d, d->state);
    return force;
}

/* A peak that is met at the event is that of the side with the larger force. */
static void vary_peaks(tdmf_system system, const tdmf_event_state *before, const tdmf_event_state *after,
                       const tdmf_local_seed *d_before, const tdmf_local_seed *d_after,
                       tdmf_stance_variation *stance) {
    const varied_force from = vary_force(system, before, d_before);
    const varied_force to = vary_force(system, after, d_after);
    if (after->peak_force > before->peak_force) {
        const bool ends = from.at.force.normal > to.at.force.normal;
        stance->peak_force = ends ? from.d_at.force.normal : to.d_at.force.normal;
    }
    if (after->peak_vertical_force > before->peak_vertical_force) {
        const bool ends = tdmf_vector_on(&before->mode.ground, from.at.force).y >
                          tdmf_vector_on(&after->mode.ground, to.at.force).y;
        const varied_force *met = ends ? &from : &to;
        stance->peak_vertical_force = tdmf_vary_vector_on(&met->at.mode->ground, met->at.force,
                                                          &met->d_at.mode->ground, met->d_at.force)
                                          .y;
    }
}

/* Varies the path along the ground up to the foot. */
static double vary_path(const tdmf_event_state *at, const tdmf_local_seed *d) {
    return tdmf_vary_path_to(&at->mode.ground, at->state[TDMF_FOOT_X], &d->mode.ground,
                             d->state[TDMF_FOOT_X]);
}

/* What the event, which shifts by dt, makes of the record of a stance; the directions have the state's change
 * where it is met, on either side. */
static tdmf_stance_variation vary_stance(tdmf_system system, const tdmf_event_state *before,
                                         const tdmf_event_state *after, double dt,
                                         const tdmf_local_seed *d_before, const tdmf_local_seed *d_after,
                                         tdmf_stance_variation stance) {
    const int ends = tdmf_in_contact(&before->mode) - tdmf_in_contact(&after->mode);
    const double slip_ends = tdmf_slip_sign(&before->mode) - tdmf_slip_sign(&after->mode);
    stance.stance_time += ends * dt;
    stance.slip_distance += slip_ends * vary_path(before, d_after);
    if (after->peak_force > before->peak_force || after->peak_vertical_force > before->peak_vertical_force) {
        vary_peaks(system, before, after, d_before, d_after, &stance);
    }
    return stance;
}

tdmf_variation tdmf_saltation(tdmf_system system, tdmf_guard guard, const tdmf_event_state *before,
                              const tdmf_event_state *after, const tdmf_seed *seed,
                              const tdmf_variation *variation, tdmf_met_event *met) {
    const tdmf_event_kind *event = tdmf_event_kind_of(guard);
    const bool impact = event->is_impact;
    if (event->vary_guard == NULL || is_on_edge(system, impact, before, after)) {
        const tdmf_variation none = no_variation();
        met->shift = NAN;
        memcpy(met->before, none.state, sizeof met->before);
        memcpy(met->after, none.state, sizeof met->after);
        return none;
    }
    const tdmf_local_seed d = tdmf_local_seed_of(system.model, seed, variation);
    const double dt = time_shift(event, system, before, &d);
    tdmf_variation varied = *variation;
    shift_in_time(dt, before->derivatives, varied.state);
    met->shift = dt;
    memcpy(met->before, varied.state, sizeof met->before);
    if (event->vary_reset != NULL) {
        event->vary_reset(system.model, system.inputs, &before->mode.ground, before->state, &d, varied.state);
    }
    /* No event moves the leg, but many in a row may change its rest length. */
    varied.state[TDMF_LEG_WORK] += tdmf_vary_leg_work_between(
        system.model, system.inputs, before->state[TDMF_LEG_LENGTH], &before->mode, &after->mode, &d.model,
        &d.inputs, varied.state[TDMF_LEG_LENGTH], &d.mode, &d.mode);
    if (tdmf_latches_liftoff_angle(&before->mode, &after->mode, impact)) {
        varied.liftoff_angle = varied.state[TDMF_LEG_ANGLE];
    }
    memcpy(met->after, varied.state, sizeof met->after);
    tdmf_local_seed d_before = d, d_after = d;
    d_before.state = met->before;
    d_after.state = met->after;
    varied.stance = vary_stance(system, before, after, dt, &d_before, &d_after, varied.stance);
    shift_in_time(-dt, after->derivatives, varied.state);
    tdmf_constrain_variation(&after->mode, after->state, &d, varied.state);
    return varied;
}
