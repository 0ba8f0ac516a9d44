/* A runner at an apex: the start of its run, the end of each stride, its settings, and the end of its run. */
#include "member.h"

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

static void set_all(tdmf_member *member, const int *settings, const double *values, int count) {
    for (int i = 0; i < count; ++i) {
        member->kind->set(member, settings[i], values[i]);
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

void tdmf_apply_settings(tdmf_member *member) {
    if (member->ensemble->given) {
        set_given(member, member->ensemble->given);
    }
    if (member->its_case->rules.law) {
        set_by_law(member, member->its_case->rules.law);
    }
}

bool tdmf_member_changes(const tdmf_member *member) {
    return tdmf_has_settings(member) || member->kind->changes(member);
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
           (size_t)tdmf_kind_of(ensemble)->coordinates(ensemble) * sizeof *end->apex);
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

/* Goes on from the checkpoint of an earlier call. */
static bool go_on(tdmf_member *member) {
    tdmf_ensemble_checkpoint *checkpoint = &member->ensemble->checkpoints[member->index];
    if (!checkpoint->stands || member->end->strides >= member->its_case->rules.max_strides) {
        return false;
    }
    checkpoint->stands = false;
    member->end->fate = TDMF_FATE_UNDECIDED;
    member->has_started = true;
    member->kind->load(member, checkpoint);
    open_stride(member, step_limit(member->ensemble));
    return member->kind->begin_next(member);
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

static void write_checkpoint(const tdmf_member *member) {
    if (member->ensemble->checkpoints) {
        tdmf_ensemble_checkpoint *checkpoint = &member->ensemble->checkpoints[member->index];
        *checkpoint = checkpoint_of(member->ensemble);
        member->kind->save(member, checkpoint);
    }
}

static bool close_stride(tdmf_member *member) {
    tdmf_ensemble_end *end = member->end;
    const int64_t record = tdmf_open_record(member);
    const tdmf_ensemble_end before = *end;
    const double steps_left = member->steps_left - (double)(member->run->steps - member->steps_before);
    member->kind->record_apex(member);
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
    return member->kind->begin_next(member);
}

bool tdmf_member_goes_on(tdmf_member *member, tdmf_run_outcome outcome) {
    const tdmf_member_kind *kind = member->kind;
    const bool goes_on = !member->has_started            ? kind->goes_on_from_start(member, outcome)
                         : kind->closes(member, outcome) ? close_stride(member)
                                                         : kind->ends_elsewhere(member, outcome);
    if (!goes_on) {
        member->events += member->run->events - member->first_event;
    }
    return goes_on;
}
