/* A model of any page as a member of an ensemble. A model whose page has ground goes on from apex to apex,
 * because its strides depend on where it is. Each stride of another model begins anew at the point of the
 * section that the last one has reached, with the numbers of the case. */
#include "ground.h"
#include "page_map.h"
#include "refusal.h"

#include <limits.h>
#include <math.h>
#include <string.h>

/* s. A stride that takes longer counts as none. */
static const double longest = 1e4;

static const tdmf_model_kind *model_of(const tdmf_ensemble *ensemble) {
    return (const tdmf_model_kind *)ensemble->page;
}

static const tdmf_section_kind *section(const tdmf_ensemble *ensemble) {
    return &model_of(ensemble)->sections[ensemble->section];
}

/* ---- requests ------------------------------------------------------------------------------------------ */

static bool are_notes(tdmf_refusal *why, const tdmf_ensemble_notes *notes, int state_count) {
    if (!tdmf_accepts_array(why, "notes.states", notes->states, "notes.count", notes->count, INT_MAX) ||
        !tdmf_accepts_array(why, "notes.values", notes->values, "notes.count", notes->count, INT_MAX) ||
        !tdmf_accepts_array(why, "notes.events", notes->events, "notes.event_room", notes->event_room,
                            INT_MAX)) {
        return false;
    }
    for (int i = 0; i < notes->count; ++i) {
        if (!tdmf_accepts_element(why, "notes.states[]", i, notes->states[i], 0.0, state_count - 1)) {
            return false;
        }
    }
    return true;
}

static bool is_sound(tdmf_refusal *why, const tdmf_ensemble *ensemble) {
    const tdmf_model_kind *model = model_of(ensemble);
    return (!ensemble->notes || are_notes(why, ensemble->notes, model->state_count)) &&
           tdmf_accepts_if(why, !ensemble->notes || ensemble->strides, TDMF_EXCLUDED, "notes", 0,
                           "they are those of recorded strides, and no strides are recorded") &&
           tdmf_accepts_number(why, "section", "1", ensemble->section, 0.0, model->section_count - 1) &&
           tdmf_accepts_if(why, !ensemble->foot_x || tdmf_has_ground(model), TDMF_EXCLUDED, "foot_x", 0,
                           "the page has no ground") &&
           tdmf_are_foot_positions(why, ensemble);
}

static bool is_case(tdmf_refusal *why, const tdmf_ensemble_case *its_case, const tdmf_ensemble *ensemble) {
    return tdmf_accepts_pointer(why, "cases[].parameters", its_case->parameters) &&
           tdmf_accepts_pointer(why, "cases[].states", its_case->states) &&
           tdmf_is_sound_ground(why, its_case, ensemble);
}

/* A stride that begins anew begins in the first mode. */
static bool is_checkpoint(const tdmf_ensemble_checkpoint *from, const tdmf_ensemble *ensemble) {
    const tdmf_model_kind *model = model_of(ensemble);
    return from->mode == 0 || (from->mode > 0 && from->mode < model->mode_count && tdmf_has_ground(model));
}

static bool range(const tdmf_ensemble *ensemble, int setting, double *least, double *most) {
    const tdmf_model_kind *model = model_of(ensemble);
    const bool is_parameter = setting >= 0 && setting < model->parameter_count;
    *least = is_parameter ? model->parameter_least[setting] : -INFINITY;
    *most = is_parameter ? model->parameter_most[setting] : INFINITY;
    return setting >= 0 && setting < model->parameter_count + model->state_count;
}

static void numbers(const tdmf_ensemble_case *its_case, const tdmf_model_kind *model, double *parameters,
                    double *states) {
    memcpy(parameters, its_case->parameters, (size_t)model->parameter_count * sizeof *parameters);
    memcpy(states, its_case->states, (size_t)model->state_count * sizeof *states);
}

static int place(int setting) {
    return setting;
}

static tdmf_model_kind model(const tdmf_ensemble *ensemble, bool is_plain) {
    (void)is_plain;
    return tdmf_model_in_lanes(model_of(ensemble));
}

static bool is_plain(const tdmf_ensemble *ensemble, int64_t index) {
    (void)ensemble, (void)index;
    return false;
}

static void settle_in(tdmf_member *member, bool is_plain_page) {
    const tdmf_page_part whole = {.model = model_of(member->ensemble)};
    (void)is_plain_page;
    member->page = whole;
    member->whole = whole.model;
    member->section = section(member->ensemble);
    member->begins_anew = !tdmf_has_ground(whole.model);
}

/* ---- strides ------------------------------------------------------------------------------------------- */

static double longest_stride(const tdmf_member *member) {
    (void)member;
    return longest;
}

static void prepare(tdmf_member *member) {
    numbers(member->its_case, member->model, member->run->p, member->held);
    if (!member->begins_anew) {
        tdmf_lay_ground(member);
    }
}

/* Begins a run at the last point, as it is set. */
static bool start(tdmf_member *member) {
    const tdmf_section_kind *from = member->section;
    const tdmf_model_kind *of = member->page.model;
    tdmf_page_run *run = member->run;
    const double *point = member->end->apex;
    run->time = run->time_rest = 0.0;
    run->log_count = 0;
    tdmf_restart(run);
    *member->until = longest;
    if (!tdmf_is_page_point_sound(from, point) || !tdmf_are_page_values_sound(of, run->p, member->held)) {
        return tdmf_give_up(member, TDMF_FATE_NO_START);
    }
    if (!member->begins_anew) {
        tdmf_enter_segment(member, member->held);
    }
    memcpy(run->x, member->held, (size_t)of->state_count * sizeof *run->x);
    from->enter(run->p, member->held, point, run->x);
    if (member->end->foot_x != 0.0) { /* as high above the ground there */
        const int slope = member->ground.slope;
        run->x[member->ground.foot_x] += member->end->foot_x;
        run->x[member->ground.foot_y] += member->end->foot_x * (slope < 0 ? 0.0 : tan(run->p[slope]));
    }
    if (tdmf_unmet_requirement(member->ensemble->page, run) != 0) {
        return tdmf_give_up(member, TDMF_FATE_NO_START);
    }
    member->has_started = member->begins_anew;
    run->stop_event = member->begins_anew ? from->event : member->ground.begins;
    return !member->begins_anew || tdmf_begin_stride(member);
}

/* ---- results ------------------------------------------------------------------------------------------- */

static void record_stride(const tdmf_member *member, const tdmf_ensemble_end *before,
                          tdmf_ensemble_stride *record) {
    const tdmf_ensemble_notes *notes = member->ensemble->notes;
    const tdmf_page_run *run = member->run;
    const int64_t number = tdmf_open_record(member);
    memcpy(record->apex, member->end->apex, sizeof record->apex);
    record->foot_x = member->end->foot_x;
    record->stride.period = member->begins_anew ? run->time : run->time - before->time;
    for (int i = 0; notes && i < notes->count; ++i) {
        notes->values[number * notes->count + i] = run->x[notes->states[i]];
    }
    for (int i = 0; notes && i < notes->event_room; ++i) {
        notes->events[number * notes->event_room + i] =
            (unsigned char)(i < run->log_count ? run->log[i].event + 1 : 0);
    }
}

static const tdmf_member_kind kind = {
    .is_sound = is_sound,
    .is_case = is_case,
    .is_checkpoint = is_checkpoint,
    .range = range,
    .section = section,
    .numbers = numbers,
    .place = place,
    .model = model,
    .is_plain = is_plain,
    .settle_in = settle_in,
    .longest_stride = longest_stride,
    .prepare = prepare,
    .start = start,
    .record_stride = record_stride,
};

const tdmf_member_kind *tdmf_kind_of(const tdmf_ensemble *ensemble) {
    return ensemble->page ? &kind : tdmf_runner_kind;
}
