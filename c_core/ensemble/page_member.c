/* A model of any page as a member of an ensemble: a stride is a run from a point of the section to the next,
 * and the next stride begins anew at that point, with the numbers of the case. */
#include "member.h"
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

static const tdmf_section_kind *section_of(const tdmf_ensemble *ensemble) {
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
           tdmf_accepts_if(why, !ensemble->foot_x, TDMF_EXCLUDED, "foot_x", 0, "a page has no foot");
}

static bool is_case(tdmf_refusal *why, const tdmf_ensemble_case *its_case, const tdmf_ensemble *ensemble) {
    const tdmf_ensemble_rules *rules = &its_case->rules;
    (void)ensemble;
    return tdmf_accepts_pointer(why, "cases[].parameters", its_case->parameters) &&
           tdmf_accepts_pointer(why, "cases[].states", its_case->states) &&
           tdmf_accepts_if(
               why, rules->roughness == 0.0 && rules->friction_spread == 0.0 && rules->terrain.length == 0.0,
               TDMF_EXCLUDED, "cases[].rules.roughness", 0, "a page has no drawn ground and no terrain");
}

/* A stride begins at the last point of the section, in the first mode. */
static bool is_checkpoint(const tdmf_ensemble_checkpoint *from, const tdmf_ensemble *ensemble) {
    (void)ensemble;
    return from->mode == 0;
}

static bool range(const tdmf_ensemble *ensemble, int setting, double *least, double *most) {
    const tdmf_model_kind *model = model_of(ensemble);
    const bool is_parameter = setting >= 0 && setting < model->parameter_count;
    *least = is_parameter ? model->parameter_least[setting] : -INFINITY;
    *most = is_parameter ? model->parameter_most[setting] : INFINITY;
    return setting >= 0 && setting < model->parameter_count + model->state_count;
}

static int coordinates(const tdmf_ensemble *ensemble) {
    return section_of(ensemble)->count;
}

static tdmf_model_kind model(const tdmf_ensemble *ensemble, bool is_plain) {
    (void)is_plain;
    return *model_of(ensemble);
}

static bool is_plain(const tdmf_ensemble *ensemble, int64_t index) {
    (void)ensemble, (void)index;
    return false;
}

static void settle_in(tdmf_member *member, bool is_plain_page, int *places) {
    (void)member, (void)is_plain_page, (void)places;
}

/* ---- strides ------------------------------------------------------------------------------------------- */

static double longest_stride(const tdmf_member *member) {
    (void)member;
    return longest;
}

static void prepare(tdmf_member *member) {
    const tdmf_model_kind *of = member->model;
    memcpy(member->run->p, member->its_case->parameters, (size_t)of->parameter_count * sizeof *member->held);
    memcpy(member->held, member->its_case->states, (size_t)of->state_count * sizeof *member->held);
}

static void set(tdmf_member *member, int setting, double value) {
    const int state = setting - member->model->parameter_count;
    double *of = state < 0 ? &member->run->p[setting] : &member->held[state];
    *of = value;
}

/* Begins a stride at the last point, as it is set. */
static bool start(tdmf_member *member) {
    const tdmf_section_kind *section = section_of(member->ensemble);
    const tdmf_model_kind *of = model_of(member->ensemble);
    tdmf_page_run *run = member->run;
    const double *point = member->end->apex;
    run->time = run->time_rest = 0.0;
    run->log_count = 0;
    tdmf_restart(run);
    run->stop_event = section->event;
    *member->until = longest;
    member->has_started = true;
    if (!tdmf_is_page_point_sound(section, point) || !tdmf_are_page_values_sound(of, run->p, member->held)) {
        return tdmf_give_up(member, TDMF_FATE_NO_START);
    }
    memcpy(run->x, member->held, (size_t)of->state_count * sizeof *run->x);
    section->enter(run->p, member->held, point, run->x);
    if (tdmf_unmet_requirement(of, run) != 0) {
        return tdmf_give_up(member, TDMF_FATE_NO_START);
    }
    const int64_t record = tdmf_open_record(member);
    if (record >= 0) {
        member->ensemble->strides[record].began = 1;
    }
    return true;
}

static bool changes(const tdmf_member *member) {
    (void)member;
    return true;
}

static bool closes(const tdmf_member *member, tdmf_run_outcome outcome) {
    const tdmf_section_map map = {.model = member->model, .section = member->ensemble->section};
    return tdmf_outcome_at_section(&map, member->run, outcome) == TDMF_RUN_STOPPED;
}

static bool begin_next(tdmf_member *member) {
    prepare(member);
    tdmf_apply_settings(member);
    return start(member);
}

static bool ends_elsewhere(tdmf_member *member, tdmf_run_outcome outcome) {
    return tdmf_give_up(member, outcome == TDMF_RUN_ENDED     ? TDMF_FATE_FELL
                                : outcome == TDMF_RUN_ARRIVED ? TDMF_FATE_UNDECIDED
                                                              : TDMF_FATE_UNSOLVED);
}

/* ---- results ------------------------------------------------------------------------------------------- */

static void record_apex(tdmf_member *member) {
    const tdmf_section_kind *section = section_of(member->ensemble);
    for (int i = 0; i < section->count; ++i) {
        member->end->apex[i] = member->run->x[section->coordinates[i]];
    }
    member->end->time += member->run->time;
}

static void record_stride(const tdmf_member *member, const tdmf_ensemble_end *before,
                          tdmf_ensemble_stride *record) {
    (void)before;
    const tdmf_ensemble_notes *notes = member->ensemble->notes;
    const tdmf_page_run *run = member->run;
    const int64_t number = tdmf_open_record(member);
    memcpy(record->apex, member->end->apex, sizeof record->apex);
    record->stride.period = run->time;
    for (int i = 0; notes && i < notes->count; ++i) {
        notes->values[number * notes->count + i] = run->x[notes->states[i]];
    }
    for (int i = 0; notes && i < notes->event_room; ++i) {
        notes->events[number * notes->event_room + i] =
            (unsigned char)(i < run->log_count ? run->log[i].event + 1 : 0);
    }
}

static void scales(const tdmf_member *member, double of[TDMF_POINT_LIMIT]) {
    const tdmf_section_kind *section = section_of(member->ensemble);
    double of_events[TDMF_PAGE_EVENT_LIMIT];
    /* The states held are restored where the next stride begins. */
    member->model->scales(member->run->p, member->held, of_events);
    for (int i = 0; i < section->count; ++i) {
        of[i] = member->held[section->coordinates[i]];
    }
}

static void save(const tdmf_member *member, tdmf_ensemble_checkpoint *checkpoint) {
    (void)member, (void)checkpoint; /* the end has all of it */
}

static void load(tdmf_member *member, const tdmf_ensemble_checkpoint *checkpoint) {
    (void)member, (void)checkpoint;
}

static const tdmf_member_kind kind = {
    .is_sound = is_sound,
    .is_case = is_case,
    .is_checkpoint = is_checkpoint,
    .range = range,
    .coordinates = coordinates,
    .model = model,
    .is_plain = is_plain,
    .settle_in = settle_in,
    .longest_stride = longest_stride,
    .prepare = prepare,
    .set = set,
    .start = start,
    .changes = changes,
    .closes = closes,
    .begin_next = begin_next,
    .ends_elsewhere = ends_elsewhere,
    .record_apex = record_apex,
    .record_stride = record_stride,
    .scales = scales,
    .save = save,
    .load = load,
};

const tdmf_member_kind *tdmf_kind_of(const tdmf_ensemble *ensemble) {
    return ensemble->page ? &kind : tdmf_runner_kind;
}
