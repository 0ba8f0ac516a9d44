/* Evaluation of the runner page's derived functions at a mode and a state. */
#include "motion_instant.h"

#include "contact_mode.h"
#include "input_rates.h"
#include "margins.h"
#include "page_solver.h"

#include <math.h>
#include <string.h>

void tdmf_begin_instant(tdmf_motion_instant *instant, tdmf_system system, const tdmf_mode *mode,
                        const double state[TDMF_STATE_COUNT]) {
    tdmf_motion motion;
    memset(&motion, 0, sizeof motion);
    motion.mode = *mode;
    if (!tdmf_is_mode(mode)) { /* results of the state alone are those of flight */
        motion.mode.contact = TDMF_CONTACT_FLIGHT;
        motion.mode.phase = TDMF_PHASE_PLACE;
    }
    memcpy(motion.state, state, sizeof motion.state);
    const tdmf_page_point point = tdmf_page_of_motion(system, &tdmf_zero_input_rates, &motion);
    tdmf_begin_instant_of_point(instant, &point);
}

void tdmf_begin_instant_of_point(tdmf_motion_instant *instant, const tdmf_page_point *point) {
    instant->point = *point;
    memset(instant->watch, WATCH_BELOW, sizeof instant->watch);
    instant->watch[EVENT_apex] = (point->above >> EVENT_apex & 1) != 0 ? WATCH_ABOVE : WATCH_BELOW;
    instant->at = tdmf_instant_at(&tdmf_runner_model, point->mode, (const double *)&instant->point.p,
                                  (const double *)&instant->point.x, instant->memory);
}

void tdmf_write_outputs(tdmf_motion_instant *instant) {
    instant->at.mode->outputs(instant->at.p, instant->at.x, instant->outputs);
}

/* ---- forces that are observed -------------------------------------------------------------------------- */

static tdmf_observed_force observed_force(const tdmf_motion_instant *instant, const double *into) {
    const tdmf_page_instant *at = &instant->at;
    tdmf_observed_force found = {0.0, 0.0};
    for (int i = 0; i < at->mode->usual_count; ++i) {
        if (at->x + at->mode->watches[i].into == into) {
            tdmf_page_observed(at, i, &found.force, &found.rate);
        }
    }
    return found;
}

tdmf_observed_force tdmf_normal_force_at(const tdmf_motion_instant *instant) {
    return observed_force(instant, &instant->point.x.peak_force_so_far);
}

tdmf_observed_force tdmf_vertical_force_at(const tdmf_motion_instant *instant) {
    return observed_force(instant, &instant->point.x.vertical_so_far);
}

/* ---- guards -------------------------------------------------------------------------------------------- */

static double peak_guard(const tdmf_motion_instant *instant, double rate, bool rising) {
    const runner_parameters *p = &instant->point.p;
    const double scale = p->stiffness * p->free_length * sqrt(p->stiffness / p->body_mass);
    return (rising ? rate : -rate) / scale + TDMF_DEAD_BAND;
}

/* On level ground the vertical force is the normal force, and is not watched twice. */
static void write_peak_guards(const tdmf_motion_instant *instant, const tdmf_mode *mode,
                              double guards[TDMF_GUARD_COUNT]) {
    if (tdmf_is_loaded(mode)) {
        guards[TDMF_GUARD_FORCE_PEAK] =
            peak_guard(instant, tdmf_normal_force_at(instant).rate, mode->ground_force_rising);
    }
    if (tdmf_is_loaded(mode) && mode->ground.slope != 0.0) {
        guards[TDMF_GUARD_VERTICAL_FORCE_PEAK] =
            peak_guard(instant, tdmf_vertical_force_at(instant).rate, mode->vertical_force_rising);
    }
}

void tdmf_write_guards(const tdmf_motion_instant *instant, const tdmf_mode *mode,
                       double guards[TDMF_GUARD_COUNT]) {
    const tdmf_mode_kind *kind = instant->at.mode;
    guard_state seen[TDMF_GUARD_LIMIT];
    tdmf_view_guards(&instant->at, instant->watch, seen);
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        guards[i] = INFINITY;
    }
    for (int i = 0; i < kind->guard_count; ++i) {
        const tdmf_guard guard = tdmf_guard_of_event(kind->guards[i].event);
        const bool must_rise = tdmf_has_to_cross(&kind->guards[i], instant->at.p, instant->at.x) &&
                               instant->watch[kind->guards[i].event] != WATCH_ABOVE;
        if (guard < TDMF_GUARD_COUNT && seen[i].is_watched) {
            guards[guard] = fmin(guards[guard], must_rise ? -seen[i].value : seen[i].value);
        }
    }
    write_peak_guards(instant, mode, guards);
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        guards[i] = guards[i] == INFINITY ? 1.0 : guards[i];
    }
}
