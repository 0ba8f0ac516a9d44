/* The correspondence of a motion and the states of the runner's page. Times of the page are relative, so that
 * those before the motion are negative; they are written where they are not. */
#include "page_motion.h"

#include "contact_mode.h"
#include "ground_line.h"
#include "input_rates.h"
#include "instant.h"
#include "margins.h"
#include "page_fields.h"
#include "patch.h"
#include "rest_length.h"
#include "words.h"

#include <math.h>

static const double far_away = 1e12;  /* place of borders that are never reached */
static const double long_ago = -1.0;  /* a time before the motion */
static const double shortest = 1e-30; /* length in l0 that a leg of length zero is given */

static void write_rates(const tdmf_inputs *rates, runner_states *x) {
    x->friction_rate = rates->ground.friction;
    x->external_torque_rate = rates->hip.external_torque;
    x->extension_rate = rates->leg.extension;
    x->external_fx_rate = rates->body.external_fx;
    x->external_fy_rate = rates->body.external_fy;
}

/* ---- the record ---------------------------------------------------------------------------------------- */

static void read_open_stride(const tdmf_motion *motion, double cosine, runner_states *x) {
    const tdmf_open_stride *open = &motion->record.progress.open;
    const tdmf_instant now = tdmf_instant_of(motion);
    x->is_open = open->began_at_apex;
    x->apex_time = tdmf_time_between(now, open->start);
    x->x_then = open->start_com_x;
    x->y_then = open->start_com_y;
    x->work_then = open->start_hip_work;
    x->leg_work_then = open->start_leg_work;
    x->positive_work_then = open->start_positive_work;
    x->peak_force_so_far = open->peak_force;
    x->vertical_so_far = open->peak_vertical_force;
    x->touchdowns_so_far = open->touchdowns;
    x->slip_so_far = open->slip_distance;
    x->stance_so_far = open->stance_time;
    x->slid_from = open->contact_start_x / cosine;
    x->mode_began = tdmf_time_between(now, open->contact_start);
    x->word_so_far = tdmf_code_of_word(open->word);
    x->last_letter = tdmf_last_letter(open->word);
    x->bar_is_due = open->flew_since_letter;
}

static void read_record(const tdmf_record *record, runner_states *x) {
    const tdmf_stride *stride = &record->stride;
    const tdmf_apex *apex = &record->apex;
    x->events = record->event_count;
    x->last_event = long_ago;
    x->impact_loss = record->impact_loss;
    x->count = stride->count;
    x->apex_com_height = apex->com_height;
    x->apex_com_speed = apex->com_speed;
    x->apex_length = apex->leg_length;
    x->apex_angle = apex->leg_angle;
    x->apex_length_rate = apex->leg_length_rate;
    x->apex_angle_rate = apex->leg_angle_rate;
}

/* A time of the page's clock, which is rounded in each step; the time of the run is not. */
static tdmf_instant instant_of(const tdmf_page_point *point, tdmf_instant begin, double time) {
    return time == point->x.time ? tdmf_instant_after(tdmf_instant_after(begin, point->time), point->rest)
                                 : tdmf_instant_after(begin, time);
}

static void write_apex(tdmf_instant at, const runner_states *x, tdmf_record *record) {
    const tdmf_apex apex = {.time = at.time,
                            .com_height = x->apex_com_height,
                            .com_speed = x->apex_com_speed,
                            .leg_length = x->apex_length,
                            .leg_angle = x->apex_angle,
                            .leg_length_rate = x->apex_length_rate,
                            .leg_angle_rate = x->apex_angle_rate};
    record->apex = apex;
    record->progress.open.start = at;
}

static void write_open_stride(const tdmf_page_point *point, tdmf_instant begin, bool flies, double cosine,
                              const runner_states *x, tdmf_open_stride *open) {
    open->began_at_apex = x->is_open > 0.0;
    open->start_com_x = x->x_then;
    open->start_com_y = x->y_then;
    open->start_hip_work = x->work_then;
    open->start_leg_work = x->leg_work_then;
    open->start_positive_work = x->positive_work_then;
    open->peak_force = x->peak_force_so_far;
    open->peak_vertical_force = x->vertical_so_far;
    open->touchdowns = tdmf_count_of(x->touchdowns_so_far);
    open->slip_distance = x->slip_so_far;
    open->stance_time = x->stance_so_far;
    tdmf_write_word(x->word_so_far, open->word);
    open->flew_since_letter = flies || x->bar_is_due > 0.0;
    open->contact_start_x = x->slid_from * cosine;
    if (x->mode_began >= 0.0) {
        open->contact_start = instant_of(point, begin, x->mode_began);
    }
}

static void write_record(const tdmf_page_point *point, tdmf_instant begin, const tdmf_mode *mode,
                         const runner_states *x, tdmf_record *record) {
    record->event_count = tdmf_count_of(x->events);
    if (x->last_event >= 0.0) {
        record->last_event_time = instant_of(point, begin, x->last_event).time;
    }
    record->impact_loss = x->impact_loss;
    if (x->count > record->stride.count) {
        record->stride = tdmf_page_stride_of(x);
    }
    if (x->is_open > 0.0 && x->apex_time >= 0.0) {
        write_apex(instant_of(point, begin, x->apex_time), x, record);
    }
    write_open_stride(point, begin, mode->contact == TDMF_CONTACT_FLIGHT, mode->ground.cosine, x,
                      &record->progress.open);
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
    x->way = mode->contact == TDMF_CONTACT_SLIP_NEGATIVE ? -1.0 : 1.0;
    x->liftoff_angle = mode->liftoff_angle;
    x->swing = mode->phase == TDMF_PHASE_PLACE ? swing_place
               : mode->clamp_closed            ? swing_rest
                                               : swing_retract;
    x->driving = tdmf_is_loaded(mode) ? mode->phase == TDMF_PHASE_DRIVE : mode->mid_stance_pending;
    x->thrusting = mode->thrusts;
    x->rises_again = rises_again;
    x->touchdown_time = long_ago;
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
    mode->liftoff_angle = x->liftoff_angle;
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

/* The page measures heights from the line in force. From a distant line the foot's would lose digits. */
static double base_of(const tdmf_motion *motion) {
    const double height = motion->mode.ground.height, foot = motion->state[TDMF_FOOT_Y];
    const bool is_far = fabs(foot - height) > fabs(foot) + motion->state[TDMF_LEG_LENGTH];
    return motion->mode.contact == TDMF_CONTACT_FLIGHT && is_far ? 0.0 : height;
}

tdmf_page_point tdmf_page_of_motion(tdmf_system system, const tdmf_inputs *rates, const tdmf_motion *motion) {
    tdmf_page_point point = {.p = tdmf_page_parameters(&system.model->parameters, system.inputs),
                             .base = base_of(motion)};
    runner_states *x = &point.x;
    x->height = motion->mode.ground.height - point.base;
    point.p.ground_height -= point.base;
    point.p.notes_compression = 1.0; /* a thrust may be set after the call */
    tdmf_write_page_inputs(system.inputs, x);
    write_rates(rates, x);
    tdmf_read_page_state(motion->state, x);
    x->length = fmax(x->length, shortest * system.model->scales.length);
    x->leg_work += work_of_jump(system, motion);
    read_mode(&motion->mode, x);
    read_ground(system.model, motion, x, &point.p);
    read_open_stride(motion, motion->mode.ground.cosine, x);
    read_record(&motion->record, x);
    x->seen_y -= point.base;
    x->y_then -= point.base;
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
    const tdmf_instant begin = tdmf_instant_of(motion);
    const tdmf_mode_kind *kind = &tdmf_runner_model.modes[point->mode];
    runner_states x = point->x;
    if (kind->to_world) {
        kind->to_world((const double *)&point->p, (const double *)&point->x, (double *)&x);
    }
    x.seen_y += point->base;
    x.y_then += point->base;
    tdmf_write_page_state(&x, motion->state);
    write_mode(system, point, last_mode, &motion->mode);
    write_record(point, begin, &motion->mode, &x, &motion->record);
    motion->record.progress.now = instant_of(point, begin, point->x.time);
    motion->time = motion->record.progress.now.time;
}
