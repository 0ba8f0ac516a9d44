/* The inputs and the mode of a motion on the runner's page, and back. */
#include "page_motion.h"

#include "contact_mode.h"
#include "ground_line.h"
#include "input_rates.h"
#include "margins.h"
#include "page_fields.h"
#include "patch.h"
#include "rest_length.h"

#include <math.h>
#include <string.h>

static const double far_away = 1e12;  /* place of borders that are never reached */
static const double shortest = 1e-30; /* length in l0 that a leg of length zero is given */

static void write_rates(const tdmf_inputs *rates, runner_states *x) {
    x->friction_rate = rates->ground.friction;
    x->external_torque_rate = rates->hip.external_torque;
    x->extension_rate = rates->leg.extension;
    x->external_fx_rate = rates->body.external_fx;
    x->external_fy_rate = rates->body.external_fy;
}

/* ---- time and heights ---------------------------------------------------------------------------------- */

/* Sets the clock of the page where the caller has set the time of the motion anew. An event later than the
 * clock would keep the next events from counting, and a later hop the foot from landing. A touchdown at this
 * instant counts as earlier than the call, and so does a hop if the time was set. */
static void read_clock(const tdmf_motion *motion, tdmf_page_point *point) {
    runner_states *x = &point->x;
    if (motion->begun + x->time == motion->time) {
        point->rest = motion->clock_rest;
    } else {
        x->time = motion->time - motion->begun;
        x->hop_time = fmin(x->hop_time, nextafter(x->time, -INFINITY));
    }
    point->time = x->time;
    x->last_event = fmin(x->last_event, x->time);
    x->hop_time = fmin(x->hop_time, x->time);
    if (x->touchdown_time >= x->time) {
        x->touchdown_time = nextafter(x->time, -INFINITY);
    }
}

/* Sets the clock of the page, and the times of events at this instant, to the time of the run, which is
 * rounded less. */
static void write_clock(double time, runner_states *x) {
    double *const times[] = {&x->last_event, &x->mode_began, &x->apex_time, &x->touchdown_time, &x->hop_time};
    for (size_t i = 0; i < sizeof times / sizeof *times; ++i) {
        *times[i] = *times[i] == x->time ? time : *times[i];
    }
    x->time = time;
}

static void raise_heights(double by, runner_states *x) {
    x->height += by;
    x->seen_y += by;
    x->com_y += by;
    x->y_then += by;
}

/* The page measures heights from the line in force. From a distant line the foot's would lose digits. */
static double base_of(const tdmf_motion *motion) {
    const double height = motion->mode.ground.height, foot = motion->state[TDMF_FOOT_Y];
    const bool is_far = fabs(foot - height) > fabs(foot) + motion->state[TDMF_LEG_LENGTH];
    return motion->mode.contact == TDMF_CONTACT_FLIGHT && is_far ? 0.0 : height;
}

/* ---- the mode ------------------------------------------------------------------------------------------ */

static bool is_pushed(const runner_states *x) {
    return x->external_fx != 0.0 || x->external_fy != 0.0 || x->external_fx_rate != 0.0 ||
           x->external_fy_rate != 0.0;
}

/* True if a slip is so slow that friction depends on its speed. */
static bool is_in_layer(const runner_states *x, const runner_parameters *p) {
    const bool friction_falls = p->stribeck_velocity > 0.0 && p->static_ratio > 1.0;
    return friction_falls && fabs(x->seen_vx) <= TDMF_LAYER_WIDTH * p->stribeck_velocity * cos(x->slope);
}

static int page_mode_of(const tdmf_mode *mode, const runner_states *x, const runner_parameters *p) {
    if (mode->fallen) {
        return MODE_fallen;
    }
    switch (mode->contact) {
    case TDMF_CONTACT_STICK:
        return MODE_stick;
    case TDMF_CONTACT_GRAZE:
        return MODE_graze;
    case TDMF_CONTACT_FLIGHT:
        return is_pushed(x) ? MODE_flight_pushed : MODE_flight_calm;
    default:
        return is_in_layer(x, p) ? MODE_slip_falling : MODE_slip_constant;
    }
}

/* The segments that stand for a patch: before it, on it, behind it. */
static double friction_of_segment(const runner_parameters *p, tdmf_zone zone) {
    return zone == TDMF_ZONE_PATCH ? p->patch_friction : -1.0;
}

static void read_ground(const tdmf_model *model, const tdmf_motion *motion, runner_states *x,
                        const runner_parameters *p) {
    const tdmf_mode *mode = &motion->mode;
    const double foot_x = motion->state[TDMF_FOOT_X], way = tdmf_sign_of_slip(mode);
    const bool has_patch = tdmf_has_patch(model);
    const double begin = has_patch ? p->patch_begin : far_away, end = has_patch ? p->patch_end : far_away;
    const tdmf_zone zone = way != 0.0 ? mode->zone : tdmf_zone_towards(model, foot_x, 1.0);
    const tdmf_zone behind = way != 0.0 ? mode->zone : tdmf_zone_towards(model, foot_x, -1.0);
    x->height = mode->ground.height;
    x->slope = mode->ground.slope;
    x->segment = zone;
    x->segment_begin = zone == TDMF_ZONE_BEFORE ? -far_away : zone == TDMF_ZONE_PATCH ? begin : end;
    x->segment_end = zone == TDMF_ZONE_BEFORE ? begin : zone == TDMF_ZONE_PATCH ? end : far_away;
    x->friction_ahead = friction_of_segment(p, zone);
    x->friction_behind = friction_of_segment(p, behind);
}

/* Values of the page's state `swing`. */
static const double swing_rest = 0.0, swing_retract = 1.0, swing_place = 2.0;

static void read_mode(const tdmf_mode *mode, runner_states *x) {
    const bool rises_again = mode->phase == TDMF_PHASE_PLACE && mode->rises;
    x->way = tdmf_sign_of_slip(mode) != 0.0 ? tdmf_sign_of_slip(mode) : x->way;
    if (!tdmf_is_loaded(mode)) {
        x->swing = mode->phase == TDMF_PHASE_PLACE ? swing_place
                   : mode->clamp_closed            ? swing_rest
                                                   : swing_retract;
    }
    x->driving = tdmf_is_loaded(mode) ? mode->phase == TDMF_PHASE_DRIVE : mode->mid_stance_pending;
    x->thrusting = mode->thrusts;
    x->rises_again = rises_again;
}

static tdmf_contact_mode contact_of(int mode, double way) {
    switch (mode) {
    case MODE_stick:
        return TDMF_CONTACT_STICK;
    case MODE_slip_constant:
    case MODE_slip_falling:
        return way > 0.0 ? TDMF_CONTACT_SLIP_POSITIVE : TDMF_CONTACT_SLIP_NEGATIVE;
    case MODE_graze:
        return TDMF_CONTACT_GRAZE;
    default:
        return TDMF_CONTACT_FLIGHT;
    }
}

/* True if an apex is to come. While the leg is placed, one comes if the centre of mass rises again or is
 * pushed. */
static bool rises(const tdmf_model *model, const tdmf_page_point *point, const tdmf_mode *mode) {
    const runner_states *x = &point->x;
    const tdmf_ground_line *ground = &mode->ground;
    const double along = x->foot_vx + model->body_share * x->vx, off = model->body_share * x->vy;
    const bool may_rise = x->rises_again > 0.0 || (point->above >> EVENT_apex & 1) != 0;
    if (mode->phase == TDMF_PHASE_RETRACT) {
        return true;
    }
    return mode->contact == TDMF_CONTACT_FLIGHT
               ? may_rise && x->com_vy > 0.0
               : ground->sine * along + ground->cosine * off > TDMF_DEAD_BAND * model->scales.speed;
}

/* A line that came into force during the call is the line that the inputs set. */
static tdmf_ground_line line_in_force(tdmf_system system, const tdmf_page_point *point) {
    const runner_states *x = &point->x;
    const bool is_set = x->height == point->p.ground_height + x->segment_height;
    const double height =
        is_set && x->segment_height == 0.0 ? system.inputs->ground.height : point->base + x->height;
    return tdmf_ground_line_of(height, x->slope);
}

/* Writes the mode of a point, and keeps those parts of the mode before that the page has no name for. */
static void write_mode(tdmf_system system, const tdmf_page_point *point, int last_mode, tdmf_mode *mode) {
    const runner_states *x = &point->x;
    const bool fallen = point->mode == MODE_fallen;
    const int at = fallen ? last_mode : point->mode;
    if (at == MODE_fallen) {
        return; /* it had fallen before */
    }
    tdmf_inputs inputs = *system.inputs;
    inputs.leg.extension = x->extension;
    mode->contact = contact_of(at, x->way);
    if (x->height != mode->ground.height - point->base || mode->ground.slope != x->slope) {
        mode->ground = line_in_force(system, point);
    }
    if (tdmf_is_loaded(mode)) {
        mode->phase = x->driving > 0.0 ? TDMF_PHASE_DRIVE : TDMF_PHASE_COAST;
    } else {
        mode->phase = x->swing > swing_retract ? TDMF_PHASE_PLACE : TDMF_PHASE_RETRACT;
    }
    mode->zone = tdmf_sign_of_slip(mode) != 0.0 ? (tdmf_zone)(int)x->segment : TDMF_ZONE_BEFORE;
    mode->mid_stance_pending = x->driving > 0.0;
    mode->clamp_closed = !tdmf_is_loaded(mode) && x->swing < swing_retract;
    mode->thrusts = x->thrusting > 0.0;
    mode->rises = !tdmf_is_loaded(mode) && rises(system.model, point, mode);
    mode->rest_length = tdmf_rest_length(system.model, &inputs, mode);
    mode->fallen = fallen;
}

/* ---- the motion ---------------------------------------------------------------------------------------- */

/* Works that a jump of the rest length since the motion was written has done on the spring. */
static double work_of_jump(tdmf_system system, const tdmf_motion *motion) {
    const double before = motion->mode.rest_length;
    const double after = tdmf_rest_length(system.model, system.inputs, &motion->mode);
    return after == before ? 0.0
                           : tdmf_work_of_change(system.model, motion->state[TDMF_LEG_LENGTH], before, after);
}

tdmf_page_point tdmf_page_of_motion(tdmf_system system, const tdmf_inputs *rates, const tdmf_motion *motion) {
    tdmf_page_point point = {.p = tdmf_page_parameters(&system.model->parameters, system.inputs),
                             .base = base_of(motion)};
    runner_states *x = &point.x;
    memcpy(x, motion->state, sizeof *x);
    read_clock(motion, &point);
    point.p.notes_compression = 1.0; /* a thrust may be set after the call */
    tdmf_write_page_inputs(system.inputs, x);
    write_rates(rates, x);
    x->length = fmax(x->length, shortest * system.model->scales.length);
    x->leg_work += work_of_jump(system, motion);
    read_mode(&motion->mode, x);
    read_ground(system.model, motion, x, &point.p);
    raise_heights(-point.base, x);
    point.p.ground_height -= point.base;
    point.mode = page_mode_of(&motion->mode, x, &point.p);
    point.above = (uint64_t)(x->rises_again > 0.0) << EVENT_apex;
    const tdmf_mode_kind *mode = &tdmf_runner_model.modes[point.mode];
    if (mode->from_world) {
        const runner_states seen = *x;
        mode->from_world((const double *)&point.p, (const double *)&seen, (double *)x);
    }
    return point;
}

void tdmf_motion_of_page(tdmf_system system, const tdmf_page_point *point, int last_mode,
                         tdmf_motion *motion) {
    const tdmf_mode_kind *kind = &tdmf_runner_model.modes[point->mode];
    runner_states x = point->x;
    if (kind->to_world) {
        kind->to_world((const double *)&point->p, (const double *)&point->x, (double *)&x);
    }
    write_mode(system, point, last_mode, &motion->mode);
    raise_heights(point->base, &x);
    write_clock(point->time, &x);
    memcpy(motion->state, &x, sizeof x);
    motion->clock_rest = point->rest;
    motion->time = motion->begun + point->time;
}
