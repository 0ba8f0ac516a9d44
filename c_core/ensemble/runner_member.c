/* The runner as a member of an ensemble: its page, its ground, and what is set at its apices. */
#include "member.h"

#include "drawn_ground.h"
#include "mapped_stride.h"
#include "page_fields.h"
#include "page_run.h"
#include "runner_checks.h"
#include "runner_pages.h"
#include "settings.h"
#include "stride_limits.h"
#include "terrain.h"
#include "words.h"

#include "tdmf_slip/automaton.h"

#include <math.h>
#include <string.h>

/* ---- the page ------------------------------------------------------------------------------------------ */

static runner_states states_of(const tdmf_member *member) {
    runner_states x;
    memcpy(&x, tdmf_runner_model.state_defaults, sizeof x);
    tdmf_give_states(member->page, member->run->x, &x);
    return x;
}

static void write_states(const tdmf_member *member, const runner_states *x) {
    tdmf_take_states(member->page, x, member->run->x);
}

/* One of the runner's states. */
#define STATE(member, name) state_at(member, (int)(offsetof(runner_states, name) / sizeof(double)))

static double state_at(const tdmf_member *member, int of_runner) {
    const int place = member->places[of_runner];
    return place < 0 ? tdmf_runner_model.state_defaults[of_runner] : member->run->x[place];
}

static runner_parameters parameters_of(const tdmf_member *member) {
    const tdmf_ensemble_rules *rules = &member->its_case->rules;
    runner_parameters p = tdmf_page_parameters(&member->parameters, &member->inputs);
    p.notes_compression = member->page->model == &tdmf_runner_model; /* a thrust needs it */
    p.trips = tdmf_has_terrain(rules) && rules->trips;
    p.keeps_friction = tdmf_has_terrain(rules);
    return p;
}

/* Gives the page what is set before the start, on which nothing depends yet. */
static void write_parameters(tdmf_member *member) {
    const runner_parameters p = parameters_of(member);
    tdmf_take_parameters(member->page, &p, member->run->p);
}

/* Gives the page what is set at an apex. The leg does work where its length is set. */
static void write_settings(tdmf_member *member) {
    const tdmf_model_kind *model = member->page->model;
    const runner_parameters p = parameters_of(member);
    double set[TDMF_PAGE_STATE_COUNT], before[TDMF_PAGE_STATE_COUNT];
    tdmf_take_parameters(member->page, &p, set);
    for (int i = 0; i < model->parameter_count; ++i) {
        if (member->run->p[i] != set[i]) {
            tdmf_page_set(model, member->run, false, i, set[i]);
        }
    }
    runner_states x = states_of(member);
    memcpy(before, member->run->x, (size_t)model->state_count * sizeof *before);
    tdmf_write_page_inputs(&member->inputs, &x);
    tdmf_take_states(member->page, &x, set);
    for (int i = 0; i < model->state_count; ++i) {
        if (before[i] != set[i]) { /* an input */
            tdmf_page_set(model, member->run, true, i, set[i]);
        }
    }
}

static double height_set(const tdmf_member *member) {
    return tdmf_has_terrain(&member->its_case->rules)
               ? member->inputs.ground.height + STATE(member, segment_height)
               : member->inputs.ground.height;
}

/* The foot in flight. */
static double foot_x(const tdmf_member *member) {
    const double lower = member->its_case->model->body_share * STATE(member, length);
    return STATE(member, com_x) + lower * sin(STATE(member, angle));
}

static double foot_y(const tdmf_member *member) {
    const double lower = member->its_case->model->body_share * STATE(member, length);
    return STATE(member, com_y) - lower * cos(STATE(member, angle));
}

/* ---- settings ------------------------------------------------------------------------------------------ */

static void set(tdmf_member *member, int setting, double value) {
    tdmf_write_setting(setting, value, &member->parameters, &member->inputs);
}

/* ---- the plain page ------------------------------------------------------------------------------------ */

/* Gives settings a value that the plain page would need for none of them. */
static void set_to_one(const int *settings, int count, tdmf_parameters *parameters, tdmf_inputs *inputs) {
    for (int i = 0; i < count; ++i) {
        tdmf_write_setting(settings[i], 1.0, parameters, inputs);
    }
}

static bool is_plain(const tdmf_ensemble *ensemble, int64_t index) {
    const tdmf_ensemble_case *its_case = tdmf_case_of(ensemble, index);
    const tdmf_ensemble_rules *rules = &its_case->rules;
    tdmf_parameters parameters = its_case->model->parameters;
    tdmf_inputs inputs = its_case->inputs;
    tdmf_page_point point;
    const tdmf_ensemble_checkpoint *from = ensemble->goes_on ? &ensemble->checkpoints[index] : NULL;
    if (rules->roughness != 0.0 || (tdmf_has_terrain(rules) && !tdmf_is_one_line(rules)) ||
        (from && tdmf_mode_on_part(tdmf_page_for(ensemble->map, true), from->mode) < 0)) {
        return false;
    }
    if (rules->law) {
        set_to_one(rules->law->settings, rules->law->count, &parameters, &inputs);
    }
    if (ensemble->given) {
        set_to_one(ensemble->given->settings, ensemble->given->count, &parameters, &inputs);
    }
    memcpy(&point.x, from ? from->states : tdmf_runner_model.state_defaults, sizeof point.x);
    point.p = tdmf_page_parameters(&parameters, &inputs);
    const bool has_extended = point.x.leg_work != 0.0 || point.x.external_work != 0.0;
    tdmf_write_page_inputs(&inputs, &point.x);
    return !has_extended && tdmf_suits_plain_page(&point);
}

/* ---- from an apex on ----------------------------------------------------------------------------------- */

static bool steps_by_stride(const tdmf_member *member) {
    const tdmf_ensemble_rules *rules = &member->its_case->rules;
    return rules->roughness != 0.0 && !tdmf_has_terrain(rules);
}

static bool slips_by_stride(const tdmf_member *member) {
    const tdmf_ensemble_rules *rules = &member->its_case->rules;
    return rules->friction_spread != 0.0 && !tdmf_has_terrain(rules);
}

static bool changes(const tdmf_member *member) {
    return steps_by_stride(member) || slips_by_stride(member);
}

/* Draws the ground of the stride that begins. */
static void draw_ground(tdmf_member *member) {
    const tdmf_ensemble_case *its_case = member->its_case;
    const uint32_t stride = (uint32_t)member->end->strides;
    if (steps_by_stride(member)) {
        member->inputs.ground.height += tdmf_drawn_step(&its_case->rules, member->number, stride);
    }
    if (slips_by_stride(member)) {
        member->inputs.ground.friction =
            tdmf_drawn_friction(&its_case->rules, its_case->inputs.ground.friction, member->number, stride);
    }
}

/* The foot is below the step that has just come. */
static bool trips(const tdmf_member *member) {
    const double slope = member->inputs.ground.slope;
    return steps_by_stride(member) && member->its_case->rules.trips &&
           cos(slope) * (foot_y(member) - height_set(member)) - sin(slope) * foot_x(member) < 0.0;
}

/* A line of the ground waits, because the foot is below it. */
static bool is_below_ground(const tdmf_member *member) {
    const bool may_wait = tdmf_has_settings(member) || steps_by_stride(member);
    return may_wait && !tdmf_has_terrain(&member->its_case->rules) &&
           (height_set(member) != STATE(member, height) ||
            member->inputs.ground.slope != STATE(member, slope));
}

/* Begins a stride, on which its settings act. Returns false where the run has ended. */
static bool begin_stride(tdmf_member *member) {
    const int64_t record = tdmf_open_record(member);
    draw_ground(member);
    if (tdmf_member_changes(member)) {
        write_settings(member);
    }
    if (record >= 0) {
        member->ensemble->strides[record].began = 1;
        member->ensemble->strides[record].ground_height = height_set(member);
    }
    return !trips(member) || tdmf_give_up(member, TDMF_FATE_FELL);
}

/* A run of the reduced map starts anew at an apex where something may change: its leg is placed as it is set.
 */
static void start_anew(tdmf_member *member) {
    tdmf_restart(member->run);
    member->run->stop_event = member->begins;
    member->has_started = false;
}

static void see_from_world(tdmf_member *member) {
    double world[TDMF_PAGE_STATE_COUNT];
    const tdmf_page_run *run = member->run;
    const size_t size = (size_t)member->page->model->state_count * sizeof *world;
    const tdmf_mode_kind *mode = &member->page->model->modes[run->mode];
    if (mode->to_world) {
        memcpy(world, run->x, size);
        mode->to_world(run->p, run->x, world);
        memcpy(run->x, world, size);
    }
}

/* Goes on from the apex at which a stride has closed. A runner that has not got onto its last ground in a
 * whole stride is below it. Returns false where the run has ended. */
static bool begin_next_stride(tdmf_member *member) {
    const bool is_reduced = member->ensemble->map == TDMF_REDUCED_MAP;
    if (!is_reduced && is_below_ground(member)) {
        return tdmf_give_up(member, TDMF_FATE_FELL);
    }
    tdmf_apply_settings(member);
    const bool has_ended = member->page->model->modes[member->run->mode].ends; /* there is no start */
    if (!is_reduced || !(has_ended || tdmf_member_changes(member))) {
        return begin_stride(member);
    }
    if (tdmf_has_settings(member)) {
        write_settings(member);
    }
    see_from_world(member);
    start_anew(member);
    return true;
}

/* ---- the start of a run -------------------------------------------------------------------------------- */

/* Puts the run at the apex that a runner starts from. Returns false where it is none. */
static bool is_placed(tdmf_member *member, const double section[TDMF_SECTION_COUNT]) {
    const tdmf_model_kind *model = member->page->model;
    tdmf_inputs inputs = member->inputs;
    tdmf_motion motion = {.time = 0.0};
    const tdmf_system system = {member->its_case->model, &inputs};
    runner_states x;
    memcpy(&x, tdmf_runner_model.state_defaults, sizeof x);
    if (tdmf_has_terrain(&member->its_case->rules)) {
        tdmf_enter_terrain(member, member->end->foot_x, &x);
    }
    inputs.ground.height += tdmf_has_terrain(&member->its_case->rules) ? x.segment_height : 0.0;
    tdmf_write_page_inputs(&member->inputs, &x);
    if (member->ensemble->map == TDMF_REDUCED_MAP) {
        double before[TDMF_PAGE_STATE_COUNT];
        write_states(member, &x);
        memcpy(before, member->run->x, (size_t)model->state_count * sizeof *before);
        model->sections[0].enter(member->run->p, before, section, member->run->x);
        x = states_of(member);
        memcpy(motion.state, &x, sizeof x);
    } else {
        tdmf_section_state_at(system, member->end->foot_x, section, motion.state);
        memcpy(&x.seen_x, motion.state + TDMF_FOOT_X, TDMF_MECHANICAL_COUNT * sizeof(double));
        write_states(member, &x);
    }
    return !tdmf_start(system, &motion).variable && motion.state[TDMF_STRIDE_IS_OPEN] > 0.0;
}

/* True if damper, springs and inertias of the first mode show that it would take too many steps. */
static bool is_too_stiff(const tdmf_member *member, double length) {
    const tdmf_model *model = member->its_case->model;
    const tdmf_parameters *p = &model->parameters;
    const bool is_reduced = member->ensemble->map == TDMF_REDUCED_MAP;
    const double mobility = is_reduced ? model->inverse_body_mass : model->inverse_reduced_mass;
    const double turning = is_reduced ? 0.0 : mobility / (length * length);
    const double fastest = fmax(fmax(p->leg.damping * mobility, sqrt(p->leg.stiffness * mobility)),
                                fmax(p->hip.kd * turning, sqrt(p->hip.kp * turning)));
    return fastest * model->scales.time > (double)TDMF_STIFFNESS_LIMIT * member->run->order;
}

static bool start(tdmf_member *member) {
    const double *section = member->ensemble->starts[member->index];
    write_parameters(member);
    if (!is_placed(member, section)) {
        return tdmf_give_up(member, TDMF_FATE_NO_START);
    }
    member->run->stop_event = member->begins;
    return !is_too_stiff(member, section[TDMF_SECTION_LEG_LENGTH]) ||
           tdmf_give_up(member, TDMF_FATE_UNSOLVED);
}

static bool ends_elsewhere(tdmf_member *member, tdmf_run_outcome outcome) {
    const int mode = tdmf_mode_in_whole(member->page, member->run->mode);
    if (outcome == TDMF_RUN_ENDED) {
        return tdmf_give_up(member, mode == MODE_fallen ? TDMF_FATE_FELL : TDMF_FATE_NO_STRIDE);
    }
    if (outcome != TDMF_RUN_ARRIVED) {
        return tdmf_give_up(member, TDMF_FATE_UNSOLVED);
    }
    const bool has_no_stride = member->ensemble->map == TDMF_REDUCED_MAP && mode == MODE_flight_calm;
    return tdmf_give_up(member,
                        has_no_stride ? TDMF_FATE_NO_STRIDE : TDMF_FATE_UNDECIDED); /* it takes too long */
}

/* The event of the start has been taken. */
static bool goes_on_from_start(tdmf_member *member, tdmf_run_outcome outcome) {
    if (member->end->strides == 0 && !member->ensemble->goes_on) {
        member->first_event = member->run->events;
    }
    member->has_started = true;
    member->run->stop_event = member->apex;
    return begin_stride(member) && (outcome == TDMF_RUN_STOPPED || ends_elsewhere(member, outcome));
}

/* ---- checkpoints --------------------------------------------------------------------------------------- */

static void save(const tdmf_member *member, tdmf_ensemble_checkpoint *checkpoint) {
    const tdmf_page_run *run = member->run;
    const int mode = tdmf_mode_in_whole(member->page, run->mode);
    const runner_states x = states_of(member);
    checkpoint->mode =
        mode >= 0 ? mode : MODE_fallen; /* an end of the reduced map, in the same coordinates */
    checkpoint->chain = run->chain;
    checkpoint->time = run->time;
    checkpoint->time_rest = run->time_rest;
    checkpoint->taken = tdmf_events_in_whole(member->page, run->taken);
    checkpoint->above = tdmf_events_in_whole(member->page, run->above);
    checkpoint->late = tdmf_events_in_whole(member->page, run->late);
    checkpoint->ground_height = member->inputs.ground.height;
    checkpoint->ground_slope = member->inputs.ground.slope;
    memcpy(checkpoint->states, &x, sizeof x);
}

static void load(tdmf_member *member, const tdmf_ensemble_checkpoint *checkpoint) {
    const tdmf_page_part *page = member->page;
    tdmf_page_run *run = member->run;
    runner_states x;
    run->mode = tdmf_mode_on_part(page, checkpoint->mode);
    run->chain = checkpoint->chain;
    run->time = checkpoint->time;
    run->time_rest = checkpoint->time_rest;
    run->taken = tdmf_events_on_part(page, checkpoint->taken);
    run->above = tdmf_events_on_part(page, checkpoint->above);
    run->late = tdmf_events_on_part(page, checkpoint->late);
    memcpy(&x, checkpoint->states, sizeof x);
    tdmf_take_states(page, &x, run->x);
    member->inputs.ground.height = checkpoint->ground_height;
    member->inputs.ground.slope = checkpoint->ground_slope;
    write_parameters(member);
    run->stop_event = member->apex;
    if (!tdmf_member_changes(member)) { /* what an earlier call has set */
        write_settings(member);
    }
}

/* ---- the end of a stride ------------------------------------------------------------------------------- */

static void record_apex(tdmf_member *member) {
    tdmf_ensemble_end *end = member->end;
    end->apex[TDMF_SECTION_COM_HEIGHT] = STATE(member, apex_com_height);
    end->apex[TDMF_SECTION_COM_SPEED] = STATE(member, apex_com_speed);
    end->apex[TDMF_SECTION_LEG_LENGTH] = STATE(member, apex_length);
    end->apex[TDMF_SECTION_LEG_ANGLE] = STATE(member, apex_angle);
    end->apex[TDMF_SECTION_LEG_LENGTH_RATE] = STATE(member, apex_length_rate);
    end->apex[TDMF_SECTION_LEG_ANGLE_RATE] = STATE(member, apex_angle_rate);
    if (tdmf_has_terrain(&member->its_case->rules)) {
        end->apex[TDMF_SECTION_COM_HEIGHT] += STATE(member, height) - height_set(member);
    }
    end->foot_x = foot_x(member);
    end->time = member->run->time;
    end->distance += STATE(member, distance);
    end->hip_work = STATE(member, work);
    end->leg_work = STATE(member, leg_work);
    end->work = end->hip_work + end->leg_work;
    end->external_work = STATE(member, external_work);
    end->damper_loss = STATE(member, damper_loss);
    end->friction_loss = STATE(member, friction_loss);
    end->impact_loss = STATE(member, impact_loss);
    end->word_code = tdmf_short_word_code(STATE(member, word_code));
}

/* Records the stride that has closed between these ends. */
static void record_stride(const tdmf_member *member, const tdmf_ensemble_end *before,
                          tdmf_ensemble_stride *record) {
    const tdmf_ensemble_end *end = member->end;
    const runner_states x = states_of(member);
    memcpy(record->apex, end->apex, sizeof record->apex);
    record->foot_x = end->foot_x;
    record->stride = tdmf_page_stride_of(&x);
    record->stride.count = end->strides + 1;
    record->liftoff_angle = x.liftoff_angle;
    record->external_work = end->external_work - before->external_work;
    record->damper_loss = end->damper_loss - before->damper_loss;
    record->friction_loss = end->friction_loss - before->friction_loss;
    record->impact_loss = end->impact_loss - before->impact_loss;
}

/* A stride closes at an apex. This includes an apex of the reduced map from which no next stride starts. */
static bool closes(const tdmf_member *member, tdmf_run_outcome outcome) {
    const tdmf_page_run *run = member->run;
    return outcome == TDMF_RUN_STOPPED ||
           (outcome == TDMF_RUN_ENDED && tdmf_mode_in_whole(member->page, run->mode) < 0 &&
            (run->taken >> member->apex & 1) != 0);
}

/* ---- the kind ------------------------------------------------------------------------------------------ */

static void prepare(tdmf_member *member) {
    member->parameters = member->its_case->model->parameters;
    member->inputs = member->its_case->inputs;
    tdmf_lay_terrain(member);
}

static double longest_stride(const tdmf_member *member) {
    return TDMF_LONGEST_STRIDE * member->its_case->model->scales.time;
}

static void scales(const tdmf_member *member, double of[TDMF_POINT_LIMIT]) {
    tdmf_section_scales(member->its_case->model, of);
}

static tdmf_model_kind model(const tdmf_ensemble *ensemble, bool is_plain) {
    return tdmf_model_in_lanes(tdmf_page_for(ensemble->map, is_plain));
}

static void settle_in(tdmf_member *member, bool is_plain, int *places) {
    member->page = tdmf_page_for(member->ensemble->map, is_plain);
    member->begins = tdmf_event_on_part(member->page, EVENT_begins);
    member->apex = tdmf_event_on_part(member->page, EVENT_apex);
    for (int i = 0; i < TDMF_PAGE_STATE_COUNT; ++i) {
        places[i] = tdmf_state_on_part(member->page, i);
    }
    member->places = places;
}

static const tdmf_member_kind kind = {
    .is_sound = tdmf_are_sound_runners,
    .is_case = tdmf_is_runner_case,
    .is_checkpoint = tdmf_is_runner_checkpoint,
    .range = tdmf_range_of_setting,
    .coordinates = tdmf_runner_coordinates,
    .model = model,
    .is_plain = is_plain,
    .settle_in = settle_in,
    .longest_stride = longest_stride,
    .prepare = prepare,
    .set = set,
    .start = start,
    .goes_on_from_start = goes_on_from_start,
    .changes = changes,
    .closes = closes,
    .begin_next = begin_next_stride,
    .ends_elsewhere = ends_elsewhere,
    .record_apex = record_apex,
    .record_stride = record_stride,
    .scales = scales,
    .save = save,
    .load = load,
};
const tdmf_member_kind *const tdmf_runner_kind = &kind;
