/* Models that are written as pages of equations, and their return maps.
 *
 * A model has parameters, states, modes, events, sections and outputs. Each has a name and a number, counted
 * from 0. A section is a place that a run crosses again and again at an event, such as the apex; some of the
 * states are its coordinates. The return map leads from one point of a section to the next. */
#ifndef TDMF_SLIP_PAGE_H
#define TDMF_SLIP_PAGE_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/refusal.h"

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A model. Programs only hold pointers to it. */
typedef struct tdmf_page tdmf_page;

/* Returns the identity of the library that `tdmf-slip build` has made of a page: another page, compiled text
 * or version has another. In the package's library it is "package". */
TDMF_API const char *tdmf_page_build(void);

/* Returns the model with a name: "classic_slip", "reduced_runner" or "runner", or, in a library that
 * `tdmf-slip build` has made, the name of its page. Returns NULL for any other name. */
TDMF_API const tdmf_page *tdmf_page_named(const char *name);

/* Kinds of named parts of a model. */
typedef enum {
    TDMF_PAGE_PARAMETER, /* constant in a run */
    TDMF_PAGE_STATE,     /* changes in a run */
    TDMF_PAGE_MODE,      /* has rates of its own for the states */
    TDMF_PAGE_EVENT,     /* leads from one mode to the next */
    TDMF_PAGE_SECTION,   /* section of a return map */
    TDMF_PAGE_OUTPUT     /* computed from parameters and states */
} tdmf_page_item;

/* Returns the name of the parameter, state, mode, event, section or output with a number, or NULL if there is
 * none: count up to the NULL to list them all. */
TDMF_API const char *tdmf_page_name(const tdmf_page *page, tdmf_page_item kind, int number);

/* Writes the default values of all parameters and states. Either pointer may be NULL. */
TDMF_API void tdmf_page_defaults(const tdmf_page *page, double *parameters, double *states);

/* Writes the smallest and the largest value that a parameter may have. */
TDMF_API void tdmf_page_range(const tdmf_page *page, int parameter, double *least, double *most);

/* Writes a typical size of each state for these parameters. Errors are measured in these units. */
TDMF_API void tdmf_page_scales(const tdmf_page *page, const double *parameters, double *scales);

/* An event of a run. */
typedef struct {
    double time;       /* s, since the run began */
    int event;         /* its number among the page's events */
    int before, after; /* modes */
} tdmf_page_event;

/* A request for runs of a model. Set `page`, `parameters`, `states`, `tolerance` and `longest`, and zero what
 * you do not need. Angles are in rad, everything else in SI units. */
typedef struct {
    const tdmf_page *page;       /* the model */
    int section;                 /* its number */
    double *parameters, *states; /* values in the order of their numbers; not changed. The states begin the
                                    run if a point of the section does not determine them */
    double tolerance;            /* relative tolerance, between 1e-16 and 1e-2 */
    double longest;              /* longest time to the next crossing, s */
    int seed_count;              /* seeds along which derivatives are computed, at most 8 */
    double *d_parameters;        /* change of each parameter along each seed; NULL without seeds */
    double *d_states;        /* change of each state at the beginning along each seed; NULL without seeds */
    long step_limit;         /* steps of a run at the most; 0 for 100,000 */
    int event_room;          /* events that there is room for */
    tdmf_page_event *events; /* receives the events of a run; NULL for none */
    bool is_unobserved;      /* leaves out what the page observes: largest values and positive parts */
} tdmf_page_map;

/* Says why a request is refused: which parameter, state or member, its value and what is allowed. `point` is
 * a point of the section, or NULL for a run from the start. A start may still fail a requirement of the page,
 * see tdmf_page_end. */
TDMF_API tdmf_refusal tdmf_page_check(const tdmf_page_map *map, const double *point);

/* Outcome of a run to the next crossing of the section. */
typedef enum {
    TDMF_PAGE_CROSSED,   /* there is a next crossing */
    TDMF_PAGE_ENDED,     /* the run is in a mode that the model never leaves, such as a fall */
    TDMF_PAGE_TOO_LONG,  /* there is no crossing within the time allowed */
    TDMF_PAGE_REFUSED,   /* a number is out of its range or not finite, a pointer is NULL, or the start does
                            not meet a requirement of the page */
    TDMF_PAGE_UNSOLVED,  /* the run cannot be followed */
    TDMF_PAGE_CANCELLED, /* another thread asked for it */
    TDMF_PAGE_NO_MEMORY  /* memory was refused */
} tdmf_page_outcome;

/* The end of a run. */
typedef struct {
    tdmf_page_outcome outcome; /* outcome of the run */
    int mode;                  /* mode at the end of the run */
    double time;               /* time of the run, s */
    int event_count;           /* events taken, also those for which there was no room */
    long steps;                /* steps made */
    int requirement; /* number, from 1, of the requirement that a refused start does not meet; else 0 */
} tdmf_page_end;

/* Runs from a point of the section, whose coordinates are given in their order, to the next crossing.
 * `states` receives all states at the end of the run, also without a crossing. `d_states`, which may be NULL,
 * receives their derivatives by the coordinates of the point, then along the seeds: a row for each. */
TDMF_API tdmf_page_end tdmf_page_stride(const tdmf_page_map *map, const double *point, double *states,
                                        double *d_states);

/* Finds a fixed point near `point` by Newton's method. Returns false, with `point` unchanged, if there is
 * none. */
TDMF_API bool tdmf_page_fixed_point(const tdmf_page_map *map, double *point);

/* Writes the states with which a run from a point of the section begins. Returns false if the map or the
 * point is refused. */
TDMF_API bool tdmf_page_place(const tdmf_page_map *map, const double *point, double *states);

/* Values at some times of a run, a row for each time. Times increase. A run that has ended stays where it is.
 * Derivatives are those at a fixed time, by the coordinates of the point, where there is one, then along the
 * seeds: a row for each time and each of these. */
typedef struct {
    int count;           /* times */
    const double *times; /* s, from 0 on */
    const double *point; /* point of the section at which the run begins; NULL: the start of the page */
    double *states;      /* states that a unit of the model shows */
    double *outputs;     /* all outputs of the page */
    double *d_states, *d_outputs; /* their derivatives; NULL */
    int *modes;                   /* one for each time */
} tdmf_page_samples;

/* Runs from the start of the model, with the parameters and states of the map, to the first crossing of its
 * section. With `samples`, which may be NULL, the run goes on until the last time, and needs a section only
 * for a point; the first `*sampled` rows are then written, all unless the run cannot be followed. */
TDMF_API tdmf_page_end tdmf_page_begin(const tdmf_page_map *map, double *states,
                                       const tdmf_page_samples *samples, int *sampled);

#ifdef __cplusplus
}
#endif
#endif
