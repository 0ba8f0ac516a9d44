/* One runner of an ensemble on its page, from apex to apex. */
#ifndef TDMF_ENSEMBLE_MEMBER_H
#define TDMF_ENSEMBLE_MEMBER_H

#include "runner_pages.h"

typedef struct {
    const tdmf_ensemble *ensemble;
    const tdmf_page_part *page;
    const int *places; /* on the page, of each state of the runner's page; -1: the page has none */
    int begins, apex;  /* events of the page: the start, and where a stride closes */
    int64_t index;     /* in the ensemble */
    uint64_t number;   /* by which its ground is drawn */
    const tdmf_ensemble_case *its_case;
    tdmf_parameters parameters; /* as they are set */
    tdmf_inputs inputs;
    tdmf_ensemble_end *end;
    tdmf_page_run *run;
    double *until;           /* when its stride is given up */
    bool has_started;        /* else the event of the start is next */
    double steps_left;       /* for the stride under way, when it began */
    long steps_before;       /* of the run, when the stride began */
    long first_event;        /* number of the run's first event after the start */
    int64_t events, strides; /* of all runners in this place */
    tdmf_table ground;       /* segments of a terrain */
} tdmf_member;

/* The runner's states. */
runner_states tdmf_member_states(const tdmf_member *member);
void tdmf_set_member_states(const tdmf_member *member, const runner_states *x);

/* Whether the plain page has the mode of a runner's checkpoint and all that acts on it, whatever is set at
 * its apices. */
bool tdmf_member_is_plain(const tdmf_ensemble *ensemble, int64_t index);

/* Begins at an apex: the start of a runner, or its checkpoint. False where there is nothing to run: `end`
 * says why. */
bool tdmf_member_begin(tdmf_member *member, int64_t index, tdmf_ensemble_end *end);

/* Whether something of the run may change at an apex. */
bool tdmf_member_changes(const tdmf_member *member);

/* Takes the end of a run: at the start, at an apex, or elsewhere. False where the runner has ended. */
bool tdmf_member_goes_on(tdmf_member *member, tdmf_run_outcome outcome);

/* Writes the end of a runner that has not begun because the ensemble was stopped. */
void tdmf_member_stops(const tdmf_ensemble *ensemble, int64_t index, tdmf_ensemble_end *end);

#endif
