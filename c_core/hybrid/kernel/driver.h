/* The interface between a derived model and the driver, which knows no model.
 *
 * A model is a table of modes. A mode has a motion, whose states are Taylor series and whose guards are
 * polynomials in time, and functions of an instant: constants, decisions at events, outputs. All are derived
 * from a page.
 */
#ifndef TDMF_KERNEL_DRIVER_H
#define TDMF_KERNEL_DRIVER_H

#include "motion.h"
#include "tables.h"

/* ---- an instant ---------------------------------------------------------------------------------------- */

/* Functions of parameters p and states x, and their first variations by dp and dx. `after` begins as a copy
 * of the states, or of dx. */
typedef int tdmf_react(const double *p, const double *x, const tdmf_table *tables, double *after,
                       const int *next);
typedef void tdmf_vary_react(const double *p, const double *x, const double *dp, const double *dx,
                             const tdmf_table *tables, int seed, double *after);
typedef void tdmf_change(const double *p, const double *x, double *after);
typedef void tdmf_vary_change(const double *p, const double *x, const double *dp, const double *dx,
                              double *after);
typedef double tdmf_vary_guard(const double *p, const double *x, const double *dp, const double *dx);
typedef double tdmf_answer(const double *p, const double *x);
typedef void tdmf_leave(const double *p, const double *x, double counted, double *after);
typedef void tdmf_vary_leave(const double *p, const double *x, const double *dp, const double *dx,
                             double counted, double *after);
typedef void (*tdmf_set)(const double *p, const double *x, double given, double *after);
typedef void tdmf_enter(const double *p, const double *x, const double *at, double *after);
typedef void tdmf_vary_enter(const double *p, const double *x, const double *dp, const double *dx,
                             const double *at, const double *d_at, double *after);
typedef void tdmf_write_scales(const double *p, double *of_states, double *of_events);

/* Limits: modes that an event can lead to, events that a mode watches, quantities that it observes, events of
 * a page, events of a chain in zero time. The generator reads these numbers. */
enum {
    TDMF_NEXT_LIMIT = 16,
    TDMF_GUARD_LIMIT = 32,
    TDMF_WATCH_LIMIT = 8,
    TDMF_PAGE_EVENT_LIMIT = 64,
    TDMF_PAGE_CHAIN_LIMIT = 100
};

/* The least order of series, and the largest number of coordinates and seeds of a return map. */
enum { LEAST_ORDER = 4, TDMF_VARIED_LIMIT = 16 };

/* An event as a mode watches it. */
typedef struct {
    int event;
    bool is_counted;         /* passed to `leave` */
    bool looks_again;        /* it is taken only where a step that begins close to it finds it, too */
    tdmf_answer *is_watched; /* evaluated where the mode begins; NULL: always watched */
    tdmf_answer
        *is_crossing;  /* there, too: the guard has to cross zero, and is not due at once; NULL: never */
    tdmf_react *react; /* writes the states that change and returns the next mode */
    tdmf_vary_react *vary_react;
    tdmf_vary_guard *vary_guard;
    int next[TDMF_NEXT_LIMIT]; /* modes that the event can lead to */
} tdmf_guard_kind;

static inline bool tdmf_is_watched(const tdmf_guard_kind *kind, const double *p, const double *x) {
    return !kind->is_watched || kind->is_watched(p, x) != 0.0;
}

static inline bool tdmf_has_to_cross(const tdmf_guard_kind *kind, const double *p, const double *x) {
    return kind->is_crossing && kind->is_crossing(p, x) != 0.0;
}

/* Observed quantities: their integral or largest value goes into a state. */
typedef enum { TDMF_POSITIVE_INTEGRAL, TDMF_LARGEST } tdmf_part;

/* Quantities that a run observes. */
typedef enum { TDMF_OBSERVE_NOTHING, TDMF_OBSERVE_USUAL, TDMF_OBSERVE_ALL } tdmf_observation;

typedef struct {
    tdmf_part part;
    int into;
} tdmf_watch_kind;

typedef struct {
    const tdmf_motion_kind *motion;
    bool ends;          /* the mode ends the run */
    bool keeps_outputs; /* a unit shows the outputs of the mode before */
    int guard_count;
    const tdmf_guard_kind *guards; /* sorted by precedence of events that are due at one instant */
    int watch_count, usual_count;  /* all observed quantities; those that come first are usual */
    const tdmf_watch_kind *watches;
    tdmf_change *open; /* writes the constants of the mode */
    tdmf_vary_change *vary_open;
    tdmf_change *outputs;
    tdmf_vary_change *vary_outputs;
    tdmf_answer *time_scale; /* time scale of a law whose series does not show it; NULL: there is none */
    tdmf_leave *leave;       /* called before the decision of any event; NULL: nothing to do */
    tdmf_vary_leave *vary_leave;
    tdmf_change *to_world, *from_world, *world_rates; /* NULL where the mode's coordinates are the world's */
    tdmf_vary_change *vary_to_world, *vary_from_world, *vary_world_rates;
} tdmf_mode_kind;

/* Functions, one for each mode, that change other states when a quantity is set. */
typedef struct {
    bool is_state;
    int index;
    const tdmf_set *set;
} tdmf_set_kind;

/* A table of motions of some width. */
typedef const void *tdmf_motions_of_width(void);

#ifdef TDMF_HAS_TWO_LANES
#define TDMF_TWO_LANES(motions) motions
#else
#define TDMF_TWO_LANES(motions) NULL
#endif
#ifdef TDMF_HAS_AVX2
#define TDMF_FOUR_LANES(motions) motions
#else
#define TDMF_FOUR_LANES(motions) NULL
#endif
#ifdef TDMF_HAS_AVX512
#define TDMF_EIGHT_LANES(motions) motions
#else
#define TDMF_EIGHT_LANES(motions) NULL
#endif

/* Memory for the variations of two seeds side by side, and the largest numbers of any mode. */
typedef struct {
    double *memory;
    int series_count, constant_count;
} tdmf_seed_lanes;

/* Variations of two seeds side by side: functions of motions of two lanes; see seeds.h. Constants, series,
 * and variations of states that move are arrays of doubles. */
typedef struct {
    const void *motions; /* motions of all modes */
    void (*fill)(const void *motions, int mode, const tdmf_seed_lanes *lanes, const void *c, const void *s,
                 int order);
    void (*vary)(const void *motions, int mode, const tdmf_seed_lanes *lanes, const void *const d[2],
                 const void *const dx[2], int order);
    void (*read)(const void *motions, int mode, const tdmf_seed_lanes *lanes, int lane, int order, void *t);
} tdmf_seed_kind;

#ifdef TDMF_HAS_SEED_LANES
#define TDMF_FOR_SEEDS(kind) &kind
#else
#define TDMF_FOR_SEEDS(kind) NULL
#endif

/* A section: it is taken at an event, which writes the coordinates. */
typedef struct {
    int event, count;
    const int *coordinates; /* indices of states */
    tdmf_enter *enter;      /* writes the states of a start at a point of the section */
    tdmf_vary_enter *vary_enter;
} tdmf_section_kind;

typedef struct {
    int state_count, parameter_count, event_count, mode_count, output_count, table_count, set_count,
        section_count;
    const tdmf_mode_kind *modes; /* runs start in the first */
    const tdmf_set_kind *sets;
    const tdmf_section_kind *sections;
    tdmf_write_scales *scales;        /* typical size of each state and guard */
    int series_count, constant_count; /* largest numbers of any mode */
    const char *const *mode_names;
    const char *const *event_names;
    const char *const *state_names;
    const char *const *parameter_names;
    const char *const *output_names;
    const char *const *table_names;
    const char *const *section_names;
    const double *parameter_defaults, *state_defaults;
    const double *parameter_least, *parameter_most; /* bounds that are allowed themselves */
    tdmf_motions_of_width
        *lanes[3];               /* motions of all modes for 2, 4 and 8 lanes; NULL: this build has none */
    const tdmf_seed_kind *seeds; /* NULL: this build varies one seed after the other */
} tdmf_model_kind;

/* ---- a run --------------------------------------------------------------------------------------------- */

typedef struct {
    double time;
    int event, before, after; /* the modes */
} tdmf_event_row;

typedef struct {
    double *p;                /* parameters */
    double *x;                /* states */
    double *memory;           /* working memory of tdmf_run_memory_size numbers, which batches do not need */
    const tdmf_table *tables; /* one for each table of the page; NULL: the page's own rows */
    double time;
    int mode;
    double tolerance;
    int order;      /* order of the series: even, from LEAST_ORDER to SERIES_ORDER_LIMIT */
    int stop_event; /* the run stops where this one is taken, and variations are then those on that section;
                       -1: none */
    tdmf_observation observes;
    long step_limit, event_limit; /* limits of a call */
    /* Variations: of each seed those of the parameters and of the states, and of the time of the last event.
     */
    int seed_count;
    const double *dp;
    double *dx, *shift;
    /* The log of events, while there is room; `log_states` may be NULL. */
    tdmf_event_row *log;
    double *log_states;
    int log_size, log_count;
    /* Outputs at given times, which increase, with their variations by seed: `samples` has a row for each
     * time, `d_samples`, which may be NULL, one for each time and seed. Where an event is, outputs are those
     * after it. */
    const double *sample_times;
    double *samples, *d_samples;
    int sample_count, sampled;
    /* Counters, and the events so far of a chain in zero time. */
    long steps, events;
    long limited_steps; /* steps that a mode's time scale limited */
    int chain;
    int left; /* the mode before the last event */
    /* Memory between calls: a saved run is a copy of the struct and of the states. Sets of events have a bit
     * for each event. */
    double time_rest;     /* rounding error of the time */
    bool is_shifted;      /* variations are on the guard of the last event; for a new seed `shift` is 0 */
    uint64_t taken;       /* events taken at this instant */
    uint64_t above, late; /* guards that were above zero since the mode began; that are below zero because
                             their event was just taken */
} tdmf_page_run;

typedef enum {
    TDMF_RUN_ARRIVED,
    TDMF_RUN_STOPPED,         /* the stop event was taken */
    TDMF_RUN_ENDED,           /* the mode ends runs */
    TDMF_RUN_NO_PROGRESS,     /* no step has a finite result */
    TDMF_RUN_TOO_MANY_STEPS,  /* the step limit was reached */
    TDMF_RUN_ENDLESS_CHAIN,   /* the events `taken` are due again and again in zero time */
    TDMF_RUN_TOO_MANY_EVENTS, /* the event limit was reached */
    TDMF_RUN_NO_MEMORY,       /* a batch could not allocate memory for each thread */
    TDMF_RUN_CANCELLED,       /* a batch was cancelled */
    TDMF_RUN_BAD_ORDER,       /* the order of the series is not allowed */
    TDMF_RUN_TOO_MANY_SEEDS,  /* a return map has too many seeds */
    TDMF_RUN_TOO_STIFF,       /* too many steps in a short time; never returned by the driver itself */
    TDMF_RUN_GOES_ON          /* never returned */
} tdmf_run_outcome;

/* Numbers of working memory that a run needs that has at most so many seeds. Runs allocate nothing. One piece
 * of memory serves any number of runs one after the other, and need not be cleared. */
size_t tdmf_run_memory_size(const tdmf_model_kind *model, int seed_count);

/* A run from the start of the page. `p` and `x` receive the defaults; the caller adds arrays for variations,
 * the log and samples. */
tdmf_page_run tdmf_run_default(const tdmf_model_kind *model, double *p, double *x, double *memory);

/* The order of the series that suits a tolerance. */
int tdmf_page_order(double tolerance);

tdmf_run_outcome tdmf_page_run_to(const tdmf_model_kind *model, tdmf_page_run *run, double until);

/* Sets a state or a parameter as an importer does, and changes the states that depend on it. */
void tdmf_page_set(const tdmf_model_kind *model, tdmf_page_run *run, bool is_state, int index, double value);

/* Writes what ended a run to a text of at most `size` characters, in a sentence. It names the mode, the time
 * and, of a chain that does not end, the events. */
void tdmf_run_message(const tdmf_model_kind *model, const tdmf_page_run *run, tdmf_run_outcome outcome,
                      char *text, size_t size);

#endif
