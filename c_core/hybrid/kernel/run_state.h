/* A run between its steps: the beginning of a mode, and events. The driver and batches share it. */
#ifndef TDMF_KERNEL_RUN_STATE_H
#define TDMF_KERNEL_RUN_STATE_H

#include "driver.h"

/* Arrays lie in the caller's memory. */
typedef struct {
    const tdmf_model_kind *model;
    tdmf_page_run *r;
    double *scales, *event_scales; /* indexed by state, and by event */
    long last_step, last_event;    /* numbers of steps and events at which the limits are reached */
    bool stops;                    /* unless an event is due at once */
    double reach;                  /* time for which the series of the last step can be trusted */
} run_state;

/* Flags of a guard in a mode. */
enum {
    IS_WATCHED = 1,
    IS_CROSSING = 2, /* it has to cross zero */
    WAS_TAKEN = 4,   /* its event was taken as the mode begins */
    WAS_ABOVE = 8,   /* above zero since the mode began */
    IS_LATE = 16,    /* below zero since its event was taken */
    IS_NEAR = 32,    /* the last step ended at its root, and its event was not taken */
    RISES = 64,      /* it rises from zero as soon as time passes */
    IN_CHAIN = 128   /* its event was taken in a long chain of events */
};

typedef struct {
    int flags;
    double scale;
} guard_start;

/* A mode at its beginning, or under way, and working memory for events. */
typedef struct {
    bool begins;   /* no time has passed in the mode */
    double *c, *d; /* constants of the mode, and their variations for each seed */
    guard_start guards[TDMF_GUARD_LIMIT];
    double *room, *rates, *none; /* arrays of states; `none` holds zeros for parameters that do not vary */
} mode_start;

/* Numbers of doubles that the arrays need. */
size_t tdmf_size_of_run_state(const tdmf_model_kind *model);
size_t tdmf_size_of_mode_start(const tdmf_model_kind *model, int seed_count);

/* Quantities that a run observes in a mode. */
static inline int tdmf_observed_count(const tdmf_mode_kind *mode, tdmf_observation observes) {
    return observes == TDMF_OBSERVE_ALL ? mode->watch_count : observes ? mode->usual_count : 0;
}

static const double most_time_scales = 3.0; /* largest number of a law's time scales in a step */

/* The longest step that the law of a mode allows whose series does not show it; infinite: any. */
static inline double tdmf_longest_step_of_law(const tdmf_mode_kind *mode, const double *p, const double *x) {
    return mode->time_scale ? most_time_scales * mode->time_scale(p, x) : INFINITY;
}

/* True if series can have this order. */
bool tdmf_is_order(int order);

/* Begins another call of a run that has not changed but for its limits and its stop event. */
void tdmf_begin_call(run_state *state);

/* Begins a run in memory for its arrays. */
void tdmf_begin_run(run_state *state, const tdmf_model_kind *model, tdmf_page_run *r, double *memory);
void tdmf_place_mode_start(mode_start *at, const tdmf_model_kind *model, int seed_count, double *memory);

/* Adds to the time and keeps the rounding error. Events that follow are at another instant. */
void tdmf_pass_time(tdmf_page_run *r, double elapsed);

/* Begins or resumes the mode of the run: its constants and their variations, and which guards are watched. */
void tdmf_begin_mode(const run_state *state, mode_start *at);

/* Moves the variations onto a guard, along the rates of all states before its event. */
void tdmf_shift_to_event(run_state *state, const tdmf_guard_kind *kind, const mode_start *at);

/* Stores in the run which guards of its mode were above zero, and which are late. */
void tdmf_keep_guards(run_state *state, const mode_start *at);

/* Takes an event and logs it. Returns whether the run may go on; if not, tdmf_limit_reached gives the reason.
 */
bool tdmf_take_event(run_state *state, const tdmf_guard_kind *kind, const mode_start *at);
tdmf_run_outcome tdmf_limit_reached(const run_state *state);

/* The time of the next sample; infinite: there is none. */
double tdmf_next_sample(const tdmf_page_run *r);

/* Makes all samples that are due where the run is. */
void tdmf_sample_here(const tdmf_model_kind *model, tdmf_page_run *r);

/* Writes a sample at states x, or its variation along a seed, at variations dx. */
void tdmf_write_sample(const tdmf_model_kind *model, const tdmf_page_run *r, int sample, const double *x);
void tdmf_vary_sample(const tdmf_model_kind *model, const tdmf_page_run *r, int sample, int seed,
                      const double *x, const double *dx);

/* The driver of any number of runs of the model, one after the other, and the numbers of memory that it
 * needs. */
typedef struct tdmf_driver tdmf_driver;
size_t tdmf_size_of_driver(const tdmf_model_kind *model, int seed_count);
tdmf_driver *tdmf_place_driver(const tdmf_model_kind *model, int seed_count, double *memory);

/* Begins or resumes a run in its working memory, and returns its driver. */
tdmf_driver *tdmf_begin_in_memory(run_state *state, mode_start *at, const tdmf_model_kind *model,
                                  tdmf_page_run *r);

/* Goes back from the guard of an event at which a run has stopped to a fixed time. */
void tdmf_leave_guard(tdmf_driver *w, run_state *state, mode_start *at);

/* Goes on in a mode up to the next event, and takes it. Returns TDMF_RUN_GOES_ON, or the outcome of the run.
 */
tdmf_run_outcome tdmf_drive_to_event(tdmf_driver *w, run_state *state, mode_start *at, double until);

#endif
