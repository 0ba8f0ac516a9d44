/* One runner of an ensemble, from apex to apex: the part that all models share, and functions of a kind. */
#ifndef TDMF_ENSEMBLE_MEMBER_H
#define TDMF_ENSEMBLE_MEMBER_H

#include "page_part.h"
#include "tdmf_slip/ensemble.h"

typedef struct tdmf_member_kind tdmf_member_kind;

/* Parameters and states of a page whose ground may vary, and its tables: at most. */
enum { TDMF_PLACE_LIMIT = TDMF_CHECKPOINT_STATES, TDMF_TABLE_LIMIT = 4 };

/* Places of the ground on a page; -1: the page does not have it. */
typedef struct {
    int begins;                               /* event of the start */
    int segments;                             /* table */
    int height, slope, trips, keeps_friction; /* parameters */
    int friction, external_fx, external_fy, line_height, line_slope, segment, segment_height, foot_x, foot_y,
        apex_height; /* states */
} tdmf_ground_places;

typedef struct {
    const tdmf_ensemble *ensemble;
    const tdmf_member_kind *kind;
    const tdmf_model_kind *model; /* the page that runs */
    tdmf_page_part page;          /* that page as a part of the ensemble's page */
    const tdmf_model_kind *whole; /* the ensemble's page */
    const tdmf_section_kind *section;
    tdmf_ground_places ground;
    bool begins_anew; /* each stride begins at the point of the section, with the numbers of the case */
    int64_t index;    /* in the ensemble */
    uint64_t number;  /* counter of its random ground and noise */
    const tdmf_ensemble_case *its_case;
    tdmf_ensemble_end *end;
    tdmf_page_run *run;
    double *held;                        /* states of the start, which settings before it change */
    double *until;                       /* time limit of its stride, s */
    double begun;                        /* time at which the stride began, s */
    bool has_started;                    /* false: the event of the start is next */
    double steps_left;                   /* step limit of the stride under way */
    long steps_before;                   /* steps of the run when the stride began */
    long first_event;                    /* number of the run's first event after the start */
    int64_t events, strides;             /* of all runners in this place */
    tdmf_table tables[TDMF_TABLE_LIMIT]; /* of the page: the segments of a terrain */
} tdmf_member;

/* The functions in which the runner and the models of other pages differ. */
struct tdmf_member_kind {
    /* ---- requests */
    bool (*is_sound)(tdmf_refusal *why,
                     const tdmf_ensemble *ensemble); /* the model; before anything else is asked */
    bool (*is_case)(tdmf_refusal *why, const tdmf_ensemble_case *its_case, const tdmf_ensemble *ensemble);
    bool (*is_checkpoint)(const tdmf_ensemble_checkpoint *from, const tdmf_ensemble *ensemble);
    bool (*range)(const tdmf_ensemble *ensemble, int setting, double *least, double *most);
    const tdmf_section_kind *(*section)(const tdmf_ensemble *ensemble);
    /* Parameters and states of a case, and the place of a setting on the page: that of a parameter, or of a
     * state counted on from there. */
    void (*numbers)(const tdmf_ensemble_case *its_case, const tdmf_model_kind *model, double *parameters,
                    double *states);
    int (*place)(int setting);
    /* ---- models: a plain one where it suits a runner */
    tdmf_model_kind (*model)(const tdmf_ensemble *ensemble, bool is_plain);
    bool (*is_plain)(const tdmf_ensemble *ensemble, int64_t index);
    void (*settle_in)(tdmf_member *member, bool is_plain); /* on its page */
    /* ---- runs. A function that returns false has written the fate, and the run is over */
    double (*longest_stride)(const tdmf_member *member); /* s */
    void (*prepare)(tdmf_member *member);                /* before anything is set */
    bool (*start)(tdmf_member *member);
    void (*resume)(tdmf_member *member);              /* a run from a checkpoint; or NULL */
    bool (*start_anew)(tdmf_member *member);          /* at an apex; false: the run goes on from there */
    tdmf_fate (*too_long)(const tdmf_member *member); /* fate of a stride that takes too long; or NULL */
    /* ---- results */
    void (*record_apex)(tdmf_member *member); /* besides coordinates, time and place */
    void (*record_stride)(const tdmf_member *member, const tdmf_ensemble_end *before,
                          tdmf_ensemble_stride *record);
};

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

/* Sets a parameter or a state of the page that runs; -1: the page does not have it. */
void tdmf_member_set(tdmf_member *member, bool is_state, int place, double value);

/* True if a law or the request changes settings at apices. */
bool tdmf_has_settings(const tdmf_member *member);

/* True if a law or the request sets this one. */
bool tdmf_is_setting(const tdmf_member *member, int setting);

/* Begins a stride whose settings are written: draws its ground. Returns false where the foot trips on it. */
bool tdmf_begin_stride(tdmf_member *member);

/* Writes the settings of the stride that begins, if there are any. */
void tdmf_apply_settings(tdmf_member *member);

/* The number of the stride under way among those that are recorded, over all runners; -1: it is not. */
int64_t tdmf_open_record(const tdmf_member *member);

/* Writes a fate. Always returns false. */
bool tdmf_give_up(tdmf_member *member, tdmf_fate fate);

#endif
