/* A runner between lanes: what it takes along, and the events it meets. */
#include "runner.h"

#include "coefficients.h"
#include "events.h"
#include "friction.h"
#include "input_rates.h"
#include "margins.h"
#include "scalar_series.h"
#include "step.h"
#include "tdmf_slip/automaton.h"
#include "tdmf_slip/orbit.h"

#include "members.h"

#include <math.h>
#include <string.h>

/* A stride is given up after so many steps or events; none that closes comes near. */
static const long step_limit = 200000;
static const long event_limit = 100000;

/* In sqrt(m/k): a stride that takes longer counts as none. */
static const double longest_stride = 1e4;

static void open_stride(tdmf_runner *runner) {
    runner->stride_began = runner->motion.time;
    runner->steps_left = step_limit;
    runner->events_left = event_limit;
    runner->span = 0.0;
    runner->steps_in_span = 0.0;
    runner->false_crossings = 0;
}

bool tdmf_runner_begin(tdmf_runner *runner, const tdmf_ensemble_case *its_case,
                       const double section[TDMF_SECTION_COUNT], tdmf_ensemble_end *end) {
    static const tdmf_ensemble_end nothing_yet = {.fate = TDMF_FATE_UNDECIDED, .gait = -1};
    tdmf_motion *motion = &runner->motion;
    runner->its_case = its_case;
    runner->end = end;
    *end = nothing_yet;
    memcpy(end->apex, section, sizeof end->apex);
    motion->time = 0.0;
    tdmf_section_state(its_case->model, section, motion->state);
    if (tdmf_start(its_case->model, &its_case->inputs, 0.0, motion->state, &motion->mode, &motion->record)
            .variable ||
        !motion->record.open.began_at_apex) {
        end->fate = TDMF_FATE_NO_START;
        return false;
    }
    open_stride(runner);
    return its_case->rules.most_strides > 0;
}

crew_kind tdmf_runner_crew(const tdmf_runner *runner) {
    const tdmf_mode *mode = &runner->motion.mode;
    switch (mode->contact) {
    case TDMF_CONTACT_FLIGHT:
        return mode->phase == TDMF_PHASE_RETRACT ? CREW_RETRACT : CREW_PLACE;
    case TDMF_CONTACT_STICK:
        return CREW_STICK;
    case TDMF_CONTACT_GRAZE:
        return CREW_GRAZE;
    default:
        return CREW_SLIP;
    }
}

static member_progress progress_of(const tdmf_runner *runner) {
    const tdmf_coordinates *at = &runner->chart.start;
    const member_progress now = {
        .elapsed = 0.0,
        .steps_left = (double)runner->steps_left,
        .span = runner->span,
        .steps_in_span = runner->steps_in_span,
        .work = at->work,
        .damper_loss = at->damper_loss,
        .friction_loss = at->friction_loss,
    };
    return now;
}

static member_frame frame_of(const tdmf_runner *runner) {
    const tdmf_model *model = runner->its_case->model;
    const member_frame frame = {
        .time_left = longest_stride * model->scales.time - (runner->motion.time - runner->stride_began),
        .margin_factor = tdmf_margin_factor(runner->false_crossings),
        .min_length = model->parameters.leg.min_length,
        .damping = model->parameters.leg.damping,
        .gravity = model->parameters.gravity,
        .length_scale = model->scales.length,
        .time_scale = model->scales.time,
        .speed_scale = model->scales.speed,
        .force_scale = model->scales.force,
        .energy_scale = model->scales.energy,
    };
    return frame;
}

static flying_member flying_fields(const tdmf_runner *runner) {
    const tdmf_chart *chart = &runner->chart;
    const tdmf_model *model = runner->its_case->model;
    const tdmf_mode *mode = &runner->motion.mode;
    const double watched = mode->clamp_closed ? -1.0 : 1.0;
    const flying_member m = {
        .now = progress_of(runner),
        .frame = frame_of(runner),
        .law = tdmf_flight_coefficients(chart),
        .inverse_mobility = 1.0 / model->mobility,
        .length = chart->start.length,
        .angle = chart->start.angle,
        .length_rate = chart->start.length_rate,
        .angle_rate = chart->start.angle_rate,
        .com_y = chart->com_y,
        .com_vy = chart->com_vy,
        .share = model->body_share,
        .kp = watched * chart->servo.gain,
        .kd = watched * chart->servo.rate_gain,
        .target = chart->servo.target,
    };
    return m;
}

static standing_member standing_fields(const tdmf_runner *runner) {
    const tdmf_chart *chart = &runner->chart;
    const tdmf_model *model = runner->its_case->model;
    const tdmf_mode *mode = &runner->motion.mode;
    const bool retracts = mode->phase == TDMF_PHASE_RETRACT;
    const tdmf_cone cone = tdmf_cone_of(chart->static_friction);
    const standing_member m = {
        .now = progress_of(runner),
        .frame = frame_of(runner),
        .law = tdmf_ground_coefficients(chart),
        .x = chart->start.x,
        .y = chart->start.y,
        .vx = chart->start.vx,
        .vy = chart->start.vy,
        .foot_x = chart->start.foot_x,
        .foot_vx = chart->start.foot_vx,
        .cone_normal = cone.normal,
        .cone_tangential = cone.tangential,
        .slip_sign = tdmf_slip_sign(mode),
        /* A leg that has wound past a half turn passes upright no more. */
        .drives = mode->phase == TDMF_PHASE_DRIVE && chart->turn == 0.0 ? 1.0 : 0.0,
        .angle = chart->start.angle,
        .kp = chart->servo.gain,
        .kd = chart->servo.rate_gain,
        .target = chart->servo.target,
        .stance_law = chart->stance_law.torque,
        .rise_share = retracts ? model->body_share : 0.0,
    };
    return m;
}

int tdmf_runner_board(tdmf_runner *runner, double *fields) {
    const tdmf_motion *motion = &runner->motion;
    tdmf_chart_open(&runner->chart, runner->its_case->model, &runner->its_case->inputs, &tdmf_held_inputs,
                    &motion->mode, motion->state);
    if (motion->mode.contact == TDMF_CONTACT_FLIGHT) {
        const flying_member m = flying_fields(runner);
        memcpy(fields, &m, sizeof m);
        return FLYING_FIELDS;
    }
    const standing_member m = standing_fields(runner);
    memcpy(fields, &m, sizeof m);
    return STANDING_FIELDS;
}

static void read_flying(const double *fields, tdmf_coordinates *at) {
    flying_member m;
    memcpy(&m, fields, offsetof(flying_member, frame));
    at->length = m.length;
    at->angle = m.angle;
    at->length_rate = m.length_rate;
    at->angle_rate = m.angle_rate;
}

static void read_standing(const double *fields, tdmf_coordinates *at) {
    standing_member m;
    memcpy(&m, fields, offsetof(standing_member, frame));
    at->x = m.x;
    at->y = m.y;
    at->vx = m.vx;
    at->vy = m.vy;
    at->foot_x = m.foot_x;
    at->foot_vx = m.foot_vx;
}

/* Writes the state that the lane has come to. */
static void disembark(tdmf_runner *runner, const double *fields) {
    tdmf_motion *motion = &runner->motion;
    tdmf_coordinates at;
    member_progress now;
    memcpy(&now, fields, sizeof now);
    at.work = now.work;
    at.damper_loss = now.damper_loss;
    at.friction_loss = now.friction_loss;
    if (motion->mode.contact == TDMF_CONTACT_FLIGHT) {
        read_flying(fields, &at);
    } else {
        read_standing(fields, &at);
    }
    tdmf_chart_state(&runner->chart, now.elapsed, &at, motion->state);
    motion->record.now = tdmf_instant_after(motion->record.now, now.elapsed);
    motion->time = motion->record.now.time;
    runner->steps_left = (long)now.steps_left;
    runner->span = now.span;
    runner->steps_in_span = now.steps_in_span;
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
    end->work = state[TDMF_HIP_WORK];
    end->damper_loss = state[TDMF_ENERGY_DAMPER_LOSS];
    end->friction_loss = state[TDMF_ENERGY_FRICTION_LOSS];
    end->impact_loss = record->impact_loss;
    end->word_code = record->stride.word_code;
}

/* The gait that an apex is near, or -1. */
static int gait_near(const tdmf_ensemble_case *its_case, const double apex[TDMF_SECTION_COUNT]) {
    const tdmf_ensemble_rules *rules = &its_case->rules;
    double scales[TDMF_SECTION_COUNT];
    tdmf_section_scales(its_case->model, scales);
    for (int gait = 0; gait < rules->gait_count; ++gait) {
        bool is_near = true;
        for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
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
    end->gait = gait_near(its_case, end->apex);
    if (end->gait >= 0) {
        end->fate = TDMF_FATE_SETTLED;
        return false;
    }
    return end->strides < its_case->rules.most_strides;
}

bool tdmf_runner_take_event(tdmf_runner *runner, const double *fields) {
    tdmf_motion *motion = &runner->motion;
    const tdmf_mode before = motion->mode;
    disembark(runner, fields);
    tdmf_run run = {
        runner->its_case->model, &runner->its_case->inputs, motion->time, motion->state, &motion->mode,
        &motion->record};
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
    const double until = runner->stride_began + longest_stride * its_case->model->scales.time;
    const tdmf_stride_outcome stride =
        tdmf_native_stride(solver, its_case->model, &its_case->inputs, until, &runner->motion);
    if (!stride.closed) {
        tdmf_runner_give_up(runner, fate_of(stride.outcome));
        return false;
    }
    return close_stride(runner);
}

void tdmf_runner_give_up(tdmf_runner *runner, tdmf_fate fate) {
    runner->end->fate = (int)fate;
    runner->end->gait = -1;
}
