/* The native solver's runs on the page, for the return map and for the functions of solver.h. */
#ifndef TDMF_RUNNER_PAGE_SOLVER_H
#define TDMF_RUNNER_PAGE_SOLVER_H

#include "page_variation.h"
#include "tdmf_slip/solver.h"

/* Working memory of the largest page with all variations, which a test checks. */
enum { TDMF_PAGE_MEMORY = 8960 };

/* A run under the limits of a solver, and its variations. */
typedef struct {
    tdmf_solver *solver;
    tdmf_system system;
    const tdmf_motion *motion; /* motion for the log, or NULL */
    tdmf_page_point point;
    tdmf_runner_run run;
    int last_mode;     /* the whole page's mode before the fall */
    double span_began; /* page time since which steps are counted against TDMF_STIFFNESS_LIMIT */
    long events_left;  /* rest of the solver's event limit */
    long chain_began;  /* number of steps at the first event of the chain that the last event belongs to */
    bool is_counted;   /* the chain in zero time that the last event belongs to */
    bool has_event;
    tdmf_event event;    /* the last, if there is one: the chain that it begins may go on */
    bool has_stopped;    /* the run has stopped at the requested event */
    bool stays_on_guard; /* variations at that event are those on its guard, not those at its time */
    /* Variations of all directions, as the page that runs has them. */
    double dp[TDMF_VARIATION_LIMIT * TDMF_PAGE_PARAMETER_COUNT];
    double dx[TDMF_VARIATION_LIMIT * TDMF_PAGE_STATE_COUNT];
    double shift[TDMF_VARIATION_LIMIT];
    double memory[TDMF_PAGE_MEMORY]; /* size: see tdmf_run_memory_size */
} tdmf_page_solver;

/* The guard of an event of the whole page, for the log; TDMF_GUARD_COUNT: the event is the page's own. */
tdmf_guard tdmf_guard_of_event(int event);

/* Begins at a point, which may be one of a motion. `is_plain`: on the plain page. */
void tdmf_begin_page_solver(tdmf_page_solver *s, tdmf_solver *solver, tdmf_system system,
                            const tdmf_page_point *point, bool is_plain);

/* Adds a direction. */
void tdmf_add_direction(tdmf_page_solver *s, const tdmf_page_direction *direction);

/* Runs until a time of the page, or to an event of the whole page; -1: to none. Events are logged by what
 * they make of `motion`. */
tdmf_outcome tdmf_run_page_solver(tdmf_page_solver *s, double until, int stop_event);

/* The direction number i at the end of the run. */
tdmf_page_direction tdmf_direction_at_end(const tdmf_page_solver *s, int i);

#endif
