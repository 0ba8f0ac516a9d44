/* The table of events at work: guards, what is due first, and chains of events in zero time. */
#include "events.h"

#include "contact_mode.h"

/* Phases in which an event is watched. */
enum {
    RETRACT = 1 << TDMF_PHASE_RETRACT,
    PLACE = 1 << TDMF_PHASE_PLACE,
    ALWAYS = 1 << TDMF_PHASE_DRIVE | 1 << TDMF_PHASE_COAST | RETRACT | PLACE
};

typedef struct {
    double (*guard)(const tdmf_evaluation *at); /* positive while the event is to come, a pure number */
    /* What the event makes of the run, its record included. NULL: nothing that the motion depends on. */
    void (*reset)(tdmf_run *run);
} event_kind;

typedef struct {
    tdmf_guard guard;
    int phases;
} watched;

typedef struct {
    const watched *first, *end;
    /* Gives the guard of the transition that is taken first, if any is due. */
    tdmf_guard (*first_due)(const tdmf_evaluation *at, int phase);
} watch_list;

#include "event_table.h"

void tdmf_guards(tdmf_system system, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                 double guards[TDMF_GUARD_COUNT]) {
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        guards[i] = tdmf_is_mode(mode) ? 1.0 : (double)NAN;
    }
    if (mode->fallen || !tdmf_is_mode(mode)) {
        return;
    }
    const tdmf_evaluation at = tdmf_evaluate(system, mode, state);
    const watch_list list = watched_by[mode->contact];
    const int phase = 1 << mode->phase;
    for (const watched *event = list.first; event != list.end; ++event) {
        if ((event->phases & phase) != 0) {
            guards[event->guard] = kinds[event->guard].guard(&at);
        }
    }
}

static tdmf_guard first_due(const tdmf_evaluation *at) {
    return at->mode->fallen ? TDMF_GUARD_COUNT
                            : watched_by[at->mode->contact].first_due(at, 1 << at->mode->phase);
}

tdmf_guard tdmf_first_due(tdmf_system system, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    const tdmf_evaluation at = tdmf_evaluate(system, mode, state);
    return tdmf_is_mode(mode) ? first_due(&at) : TDMF_GUARD_COUNT;
}

tdmf_evaluation tdmf_evaluate_run(const tdmf_run *run, const tdmf_mode *mode) {
    return tdmf_evaluate_along(run->system, mode, run->motion->state, run->direction);
}

static bool take_chain(tdmf_run *run) {
    for (int links = 0; links <= TDMF_CHAIN_LIMIT; ++links) {
        const tdmf_evaluation at = tdmf_evaluate_run(run, &run->motion->mode);
        const tdmf_guard due = first_due(&at);
        const bool is_cut = links == TDMF_CHAIN_LIMIT;
        const bool is_last = due == TDMF_GUARD_COUNT || is_cut;
        if (links == 0 || is_last) {
            tdmf_observe_evaluated(&at, run->motion);
        }
        if (is_last) {
            return !is_cut;
        }
        kinds[due].reset(run);
    }
    return false;
}

/* All changes of contact and phase at one instant count as one. */
bool tdmf_take_transitions(tdmf_run *run) {
    int *count = &run->motion->record.event_count;
    const int before = *count;
    const bool resolved = take_chain(run);
    *count = *count > before ? before + 1 : before;
    return resolved;
}
