/* A runner at an apex: the start of its run, the end of each stride, its settings, and the end of its run. */
#include "member.h"

#include "ground.h"
#include "request_checks.h"
#include "settled.h"
#include "stride_limits.h"
#include "threads.h"

#include <string.h>

const tdmf_ensemble_case *tdmf_case_of(const tdmf_ensemble *ensemble, int64_t index) {
    return &ensemble->cases[ensemble->case_of ? ensemble->case_of[index] : 0];
}

bool tdmf_give_up(tdmf_member *member, tdmf_fate fate) {
    member->end->fate = (int)fate;
    member->end->gait = -1;
    return false;
}

/* ---- settings ------------------------------------------------------------------------------------------ */

int64_t tdmf_open_record(const tdmf_member *member) {
    const tdmf_ensemble *ensemble = member->ensemble;
    const int stride = member->end->strides - ensemble->first_stride;
    return ensemble->strides && stride >= 0 && stride < ensemble->stride_count
               ? member->index * ensemble->stride_count + stride
               : -1;
}

/* Before the start nothing depends on a number yet, so that it is written directly. */
void tdmf_member_set(tdmf_member *member, bool is_state, int place, double value) {
    double *states = member->has_started ? member->run->x : member->held;
    double *numbers = is_state ? states : member->run->p;
    if (place >= 0 && !member->has_started) {
        numbers[place] = value;
    } else if (place >= 0 && numbers[place] != value) {
        tdmf_page_set(member->page.model, member->run, is_state, place, value);
    }
}

static void set_all(tdmf_member *member, const int *settings, const double *values, int count) {
    const int parameters = member->whole->parameter_count;
    for (int i = 0; i < count; ++i) {
        const int place = member->kind->place(settings[i]);
        const bool is_state = place >= parameters;
        tdmf_member_set(member, is_state,
                        is_state ? tdmf_state_on_part(&member->page, place - parameters)
                                 : tdmf_parameter_on_part(&member->page, place),
                        values[i]);
    }
}

static void set_given(tdmf_member *member, const tdmf_given_settings *given) {
    int stride = member->end->strides - given->first;
    stride = stride < 0 ? 0 : stride < given->strides ? stride : given->strides - 1;
    const double *values = &given->values[(member->index * given->strides + stride) * given->count];
    set_all(member, given->settings, values, given->count);
}

static void set_by_law(tdmf_member *member, const tdmf_affine_law *law) {
    double values[TDMF_SETTING_LIMIT];
    const int64_t record = tdmf_open_record(member);
    const tdmf_ensemble_end *end = member->end;
    tdmf_affine_settings(law, end->apex, member->number, (uint32_t)end->strides, values);
    set_all(member, law->settings, values, law->count);
    if (record >= 0) {
        memcpy(member->ensemble->strides[record].set, values, (size_t)law->count * sizeof *values);
    }
}

bool tdmf_has_settings(const tdmf_member *member) {
    return member->ensemble->given || member->its_case->rules.law;
}

bool tdmf_is_setting(const tdmf_member *member, int setting) {
    const tdmf_given_settings *given = member->ensemble->given;
    const tdmf_affine_law *law = member->its_case->rules.law;
    return (given && tdmf_has_setting(given->settings, given->count, setting)) ||
           (law && tdmf_has_setting(law->settings, law->count, setting));
}

void tdmf_apply_settings(tdmf_member *member) {
    if (member->ensemble->given) {
        set_given(member, member->ensemble->given);
    }
    if (member->its_case->rules.law) {
        set_by_law(member, member->its_case->rules.law);
    }
}

bool tdmf_member_changes(const tdmf_member *member) {
    return member->begins_anew || tdmf_has_settings(member) || tdmf_draws_ground(member);
}

/* ---- the start of a run -------------------------------------------------------------------------------- */

static double step_limit(const tdmf_ensemble *ensemble) {
    return ensemble->step_limit > 0 ? (double)ensemble->step_limit : (double)TDMF_STEP_LIMIT;
}

static void open_stride(tdmf_member *member, double steps_left) {
    tdmf_page_run *run = member->run;
    member->steps_left = steps_left;
    member->steps_before = run->steps;
    run->step_limit = tdmf_step_limit_of(steps_left);
    member->begun = member->begins_anew ? -1.0 : run->time;
    *member->until = run->time + member->kind->longest_stride(member);
}

void tdmf_restart(tdmf_page_run *run) {
    run->mode = run->chain = 0;
    run->taken = run->above = run->late = 0;
}

/* Clears the time, the mode and the events of a run; its counters go on. */
static void forget(tdmf_member *member) {
    tdmf_page_run *run = member->run;
    run->time = run->time_rest = 0.0;
    tdmf_restart(run);
    member->has_started = false;
    member->first_event = run->events;
}

/* Settles the runner on a gait; -1 stands for none. Returns true if the runner has settled. */
static bool settles(tdmf_member *member, int gait) {
    member->end->gait = gait;
    if (gait >= 0) {
        member->end->fate = TDMF_FATE_SETTLED;
    }
    return gait >= 0;
}

static void write_start(const tdmf_ensemble *ensemble, int64_t index, tdmf_ensemble_end *end) {
    static const tdmf_ensemble_end nothing_yet = {.fate = TDMF_FATE_UNDECIDED, .gait = -1};
    *end = nothing_yet;
    memcpy(end->apex, ensemble->starts[index],
           (size_t)tdmf_kind_of(ensemble)->section(ensemble)->count * sizeof *end->apex);
    end->foot_x = ensemble->foot_x ? ensemble->foot_x[index] : 0.0;
    if (ensemble->checkpoints) {
        ensemble->checkpoints[index].stands = false;
    }
}

static bool begin(tdmf_member *member) {
    const tdmf_ensemble *ensemble = member->ensemble;
    write_start(ensemble, member->index, member->end);
    tdmf_apply_settings(member);
    if (!member->kind->start(member)) {
        return false;
    }
    open_stride(member, step_limit(ensemble));
    return member->its_case->rules.max_strides > 0 &&
           !settles(member, tdmf_gait_of_ball(member, member->end->apex));
}

/* ---- strides ------------------------------------------------------------------------------------------- */

bool tdmf_begin_stride(tdmf_member *member) {
    const int64_t record = tdmf_open_record(member);
    tdmf_draw_ground(member);
    if (record >= 0) {
        member->ensemble->strides[record].began = 1;
        member->ensemble->strides[record].ground_height = tdmf_ground_height(member);
    }
    return !tdmf_has_tripped(member) || tdmf_give_up(member, TDMF_FATE_FELL);
}

/* Writes the fate of a run that ends within a stride. Ends that the whole page does not have are those of the
 * reduced map. Always returns false. */
static bool ends_elsewhere(tdmf_member *member, tdmf_run_outcome outcome) {
    const bool is_known = tdmf_mode_in_whole(&member->page, member->run->mode) >= 0;
    if (outcome == TDMF_RUN_ENDED) {
        return tdmf_give_up(member, is_known ? TDMF_FATE_FELL : TDMF_FATE_NO_STRIDE);
    }
    if (outcome != TDMF_RUN_ARRIVED) {
        return tdmf_give_up(member, TDMF_FATE_UNSOLVED);
    }
    return tdmf_give_up(member,
                        member->kind->too_long ? member->kind->too_long(member) : TDMF_FATE_UNDECIDED);
}

/* The event of the start has been taken. */
static bool goes_on_from_start(tdmf_member *member, tdmf_run_outcome outcome) {
    if (member->end->strides == 0 && !member->ensemble->goes_on) {
        member->first_event = member->run->events;
    }
    member->has_started = true;
    member->run->stop_event = member->section->event;
    member->run->log_count = 0;
    return tdmf_begin_stride(member) && (outcome == TDMF_RUN_STOPPED || ends_elsewhere(member, outcome));
}

/* A stride closes at the event of the section, which may also end the run. */
static bool closes(const tdmf_member *member, tdmf_run_outcome outcome) {
    const tdmf_page_run *run = member->run;
    return outcome == TDMF_RUN_STOPPED ||
           (outcome == TDMF_RUN_ENDED && (run->taken >> member->section->event & 1u) != 0 &&
            run->time > member->begun);
}

/* Begins the next stride at the point where the last one has closed. A runner that has not got onto its last
 * ground in a whole stride is below it. Returns false where the run has ended. */
static bool begin_next(tdmf_member *member) {
    const tdmf_member_kind *kind = member->kind;
    if (member->begins_anew) {
        member->has_started = false;
        kind->prepare(member);
        tdmf_apply_settings(member);
        return kind->start(member);
    }
    if (tdmf_is_below_ground(member)) {
        return tdmf_give_up(member, TDMF_FATE_FELL);
    }
    tdmf_apply_settings(member);
    member->run->log_count = 0;
    return (kind->start_anew && kind->start_anew(member)) || tdmf_begin_stride(member);
}

/* Puts the run where it stood in an earlier call. */
static void load(tdmf_member *member, const tdmf_ensemble_checkpoint *checkpoint) {
    const tdmf_page_part *page = &member->page;
    tdmf_page_run *run = member->run;
    run->mode = tdmf_mode_on_part(page, checkpoint->mode);
    run->chain = checkpoint->chain;
    run->time = checkpoint->time;
    run->time_rest = checkpoint->time_rest;
    run->taken = tdmf_events_on_part(page, checkpoint->taken);
    run->above = tdmf_events_on_part(page, checkpoint->above);
    run->late = tdmf_events_on_part(page, checkpoint->late);
    run->stop_event = member->section->event;
    tdmf_take_states(page, checkpoint->states, run->x);
    tdmf_load_ground(member, checkpoint);
    if (member->kind->resume) {
        member->kind->resume(member);
    }
}

/* Goes on from the checkpoint of an earlier call. */
static bool go_on(tdmf_member *member) {
    tdmf_ensemble_checkpoint *checkpoint = &member->ensemble->checkpoints[member->index];
    if (!checkpoint->stands || member->end->strides >= member->its_case->rules.max_strides) {
        return false;
    }
    checkpoint->stands = false;
    member->end->fate = TDMF_FATE_UNDECIDED;
    member->has_started = true;
    if (!member->begins_anew) {
        load(member, checkpoint);
    }
    open_stride(member, step_limit(member->ensemble));
    return begin_next(member);
}

bool tdmf_member_begin(tdmf_member *member, int64_t index, tdmf_ensemble_end *end) {
    const tdmf_ensemble *ensemble = member->ensemble;
    member->index = index;
    member->number = ensemble->first_number + (uint64_t)index;
    member->its_case = tdmf_case_of(ensemble, index);
    member->end = end;
    forget(member);
    member->kind->prepare(member);
    return ensemble->goes_on ? go_on(member) : begin(member);
}

void tdmf_member_stops(const tdmf_ensemble *ensemble, int64_t index, tdmf_ensemble_end *end) {
    if (!ensemble->goes_on) {
        write_start(ensemble, index, end);
    } else if (!ensemble->checkpoints[index].stands) {
        return;
    }
    end->fate = TDMF_FATE_STOPPED;
}

/* ---- the end of a stride ------------------------------------------------------------------------------- */

/* A checkpoint of the ensemble's model, with nothing else in it. */
static tdmf_ensemble_checkpoint checkpoint_of(const tdmf_ensemble *ensemble) {
    const tdmf_model_kind model = tdmf_kind_of(ensemble)->model(ensemble, false);
    const tdmf_ensemble_checkpoint checkpoint = {.stands = true,
                                                 .parameter_count = model.parameter_count,
                                                 .state_count = model.state_count,
                                                 .mode_count = model.mode_count,
                                                 .event_count = model.event_count,
                                                 .section = ensemble->section};
    return checkpoint;
}

bool tdmf_is_of_model(const tdmf_ensemble_checkpoint *from, const tdmf_ensemble *ensemble) {
    const tdmf_ensemble_checkpoint own = checkpoint_of(ensemble);
    return from->parameter_count == own.parameter_count && from->state_count == own.state_count &&
           from->mode_count == own.mode_count && from->event_count == own.event_count &&
           from->section == own.section;
}

/* The mode of a run on the ensemble's page. An end that this page does not have becomes one of its own ends,
 * which has the same coordinates. */
static int mode_in_whole(const tdmf_member *member) {
    const int known = tdmf_mode_in_whole(&member->page, member->run->mode);
    int mode = known < 0 ? 0 : known;
    while (known < 0 && !member->whole->modes[mode].ends) {
        ++mode;
    }
    return mode;
}

/* A run whose strides begin anew goes on from its end alone. */
static void write_checkpoint(const tdmf_member *member) {
    if (!member->ensemble->checkpoints) {
        return;
    }
    tdmf_ensemble_checkpoint *checkpoint = &member->ensemble->checkpoints[member->index];
    *checkpoint = checkpoint_of(member->ensemble);
    if (!member->begins_anew) {
        const tdmf_page_part *page = &member->page;
        const tdmf_page_run *run = member->run;
        checkpoint->mode = mode_in_whole(member);
        checkpoint->chain = run->chain;
        checkpoint->time = run->time;
        checkpoint->time_rest = run->time_rest;
        checkpoint->taken = tdmf_events_in_whole(page, run->taken);
        checkpoint->above = tdmf_events_in_whole(page, run->above);
        checkpoint->late = tdmf_events_in_whole(page, run->late);
        memcpy(checkpoint->states, member->whole->state_defaults,
               (size_t)member->whole->state_count * sizeof *checkpoint->states);
        tdmf_give_states(page, run->x, checkpoint->states);
        tdmf_save_ground(member, checkpoint);
    }
}

/* Writes the point of the section, the time, and the place into the end. */
static void record_apex(tdmf_member *member) {
    const tdmf_section_kind *section = member->section;
    const tdmf_page_run *run = member->run;
    tdmf_ensemble_end *end = member->end;
    for (int i = 0; i < section->count; ++i) {
        end->apex[i] = run->x[section->coordinates[i]];
    }
    if (member->begins_anew) {
        end->time += run->time;
    } else {
        end->time = run->time;
        tdmf_record_place(member);
    }
    if (member->kind->record_apex) {
        member->kind->record_apex(member);
    }
}

static bool close_stride(tdmf_member *member) {
    tdmf_ensemble_end *end = member->end;
    const int64_t record = tdmf_open_record(member);
    const tdmf_ensemble_end before = *end;
    const double steps_left = member->steps_left - (double)(member->run->steps - member->steps_before);
    record_apex(member);
    if (record >= 0) {
        member->kind->record_stride(member, &before, &member->ensemble->strides[record]);
    }
    open_stride(member, tdmf_steps_of_next_stride(steps_left, step_limit(member->ensemble)));
    ++end->strides;
    ++member->strides;
    if (settles(member, tdmf_gait_reached(member, end->apex))) {
        return false;
    }
    if (tdmf_is_raised(member->ensemble->stop)) {
        tdmf_give_up(member, TDMF_FATE_STOPPED);
        write_checkpoint(member);
        return false;
    }
    if (end->strides >= member->its_case->rules.max_strides) {
        write_checkpoint(member);
        return false;
    }
    return begin_next(member);
}

bool tdmf_member_goes_on(tdmf_member *member, tdmf_run_outcome outcome) {
    const bool goes_on = !member->has_started      ? goes_on_from_start(member, outcome)
                         : closes(member, outcome) ? close_stride(member)
                                                   : ends_elsewhere(member, outcome);
    if (!goes_on) {
        member->events += member->run->events - member->first_event;
    }
    return goes_on;
}
