/* One runner of an ensemble, from apex to apex: the part that all models share, and functions of a kind. */
#ifndef TDMF_ENSEMBLE_MEMBER_H
#define TDMF_ENSEMBLE_MEMBER_H

#include "page_part.h"
#include "tdmf_slip/ensemble.h"

typedef struct tdmf_member_kind tdmf_member_kind;

typedef struct {
    const tdmf_ensemble *ensemble;
    const tdmf_member_kind *kind;
    const tdmf_model_kind *model; /* the page that runs */
    int64_t index;                /* in the ensemble */
    uint64_t number;              /* counter of its random ground and noise */
    const tdmf_ensemble_case *its_case;
    tdmf_ensemble_end *end;
    tdmf_page_run *run;
    double *held;               /* memory for states */
    double *until;              /* time limit of its stride, s */
    bool has_started;           /* false: the event of the start is next */
    double steps_left;          /* step limit of the stride under way */
    long steps_before;          /* steps of the run when the stride began */
    long first_event;           /* number of the run's first event after the start */
    int64_t events, strides;    /* of all runners in this place */
    const tdmf_page_part *page; /* page of the runner; this and the following are not used by other pages */
    const int *places;          /* on the page, of each state of the runner's page; -1: the page has none */
    int begins, apex;           /* events of the page: the start, and where a stride closes */
    tdmf_parameters parameters; /* as they are set */
    tdmf_inputs inputs;
    tdmf_table ground; /* segments of a terrain */
} tdmf_member;

/* The functions in which the runner and the models of other pages differ. */
struct tdmf_member_kind {
    /* ---- requests */
    bool (*is_sound)(tdmf_refusal *why,
                     const tdmf_ensemble *ensemble); /* the model; before anything else is asked */
    bool (*is_case)(tdmf_refusal *why, const tdmf_ensemble_case *its_case, const tdmf_ensemble *ensemble);
    bool (*is_checkpoint)(const tdmf_ensemble_checkpoint *from, const tdmf_ensemble *ensemble);
    bool (*range)(const tdmf_ensemble *ensemble, int setting, double *least, double *most);
    int (*coordinates)(const tdmf_ensemble *ensemble);
    /* ---- models: a plain one where it suits a runner. `places` has room for TDMF_PLACE_LIMIT */
    tdmf_model_kind (*model)(const tdmf_ensemble *ensemble, bool is_plain);
    bool (*is_plain)(const tdmf_ensemble *ensemble, int64_t index);
    void (*settle_in)(tdmf_member *member, bool is_plain, int *places);
    /* ---- runs. A function that returns false has written the fate, and the run is over */
    double (*longest_stride)(const tdmf_member *member); /* s */
    void (*prepare)(tdmf_member *member);                /* before anything is set */
    void (*set)(tdmf_member *member, int setting, double value);
    bool (*start)(tdmf_member *member);
    bool (*goes_on_from_start)(tdmf_member *member, tdmf_run_outcome outcome);
    bool (*changes)(const tdmf_member *member); /* at apices */
    bool (*closes)(const tdmf_member *member, tdmf_run_outcome outcome);
    bool (*begin_next)(tdmf_member *member); /* stride, at an apex */
    bool (*ends_elsewhere)(tdmf_member *member, tdmf_run_outcome outcome);
    /* ---- results */
    void (*record_apex)(tdmf_member *member);
    void (*record_stride)(const tdmf_member *member, const tdmf_ensemble_end *before,
                          tdmf_ensemble_stride *record);
    void (*scales)(const tdmf_member *member, double scales[TDMF_POINT_LIMIT]);
    void (*save)(const tdmf_member *member, tdmf_ensemble_checkpoint *checkpoint);
    void (*load)(tdmf_member *member, const tdmf_ensemble_checkpoint *checkpoint);
};

enum { TDMF_PLACE_LIMIT = 128 };

/* The runner's kind, which the library of another page does not have: there it is NULL. */
extern const tdmf_member_kind *const tdmf_runner_kind;

/* The kind of an ensemble; NULL: the library does not have the model. */
const tdmf_member_kind *tdmf_kind_of(const tdmf_ensemble *ensemble);

/* Begins a run at an apex: the start of the runner, or its checkpoint. Returns false if there is nothing to
 * run; `end` says why. */
bool tdmf_member_begin(tdmf_member *member, int64_t index, tdmf_ensemble_end *end);

/* True if settings, parameters or inputs of the run may change at an apex. */
bool tdmf_member_changes(const tdmf_member *member);

/* Handles a stop of the run at the start, an apex or elsewhere. Returns false if the runner has ended. */
bool tdmf_member_goes_on(tdmf_member *member, tdmf_run_outcome outcome);

/* True if a checkpoint was written for the model and the section of the ensemble. */
bool tdmf_is_of_model(const tdmf_ensemble_checkpoint *from, const tdmf_ensemble *ensemble);

/* Writes the end of a runner that has not begun because the ensemble was stopped. */
void tdmf_member_stops(const tdmf_ensemble *ensemble, int64_t index, tdmf_ensemble_end *end);

/* ---- for the kinds ------------------------------------------------------------------------------------- */

/* The case of a runner. */
const tdmf_ensemble_case *tdmf_case_of(const tdmf_ensemble *ensemble, int64_t index);

/* Puts a run into the first mode, before any event. Its time and its counters go on. */
void tdmf_restart(tdmf_page_run *run);

/* True if a law or the request changes settings at apices. */
bool tdmf_has_settings(const tdmf_member *member);

/* Writes the settings of the stride that begins, if there are any. */
void tdmf_apply_settings(tdmf_member *member);

/* The number of the stride under way among those that are recorded, over all runners; -1: it is not. */
int64_t tdmf_open_record(const tdmf_member *member);

/* Writes a fate. Always returns false. */
bool tdmf_give_up(tdmf_member *member, tdmf_fate fate);

#endif
