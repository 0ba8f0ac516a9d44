/* A run of a page as a unit holds it. But for its working memory it is plain data: copying it copies the run.
 */
#ifndef TDMF_PAGE_FMU_H
#define TDMF_PAGE_FMU_H

#include "unit_page.h" /* the generator's: how many things the page has */

#include <stdbool.h>
#include <stdint.h>

enum {
    UNIT_NUMBER_COUNT = UNIT_PARAMETER_COUNT + UNIT_STATE_COUNT,
    FMU_STATE_COUNT = UNIT_CONTINUOUS_COUNT,
    FMU_GUARD_COUNT = UNIT_GUARD_COUNT,
    WORD_CAPACITY = 64
};

/* Settings of the unit rather than of the page. */
typedef enum { SOLVER_NATIVE = 1, SOLVER_CVODE } solver_method;

typedef enum { SETTING_TOLERANCE, SETTING_TERMINATES, SETTING_METHOD, SETTING_COUNT } fmu_setting;

/* Work of the solver in Co-Simulation. */
typedef enum { WORK_STEPS, WORK_EVALUATIONS, WORK_LAYER_STEPS, WORK_COUNT } fmu_work;

/* State of a run between calls of the driver. Numbers are the page's parameters, then its states. Where
 * a mode has coordinates of its own, the states of the world's coordinates follow from them, or in Model
 * Exchange they from those. */
typedef struct {
    double numbers[UNIT_NUMBER_COUNT + 1];
    double time, time_rest;
    uint64_t taken, above, late;
    int64_t chain;
    int32_t mode;
    int32_t
        shown; /* the mode whose outputs are shown: the one before where the run has ended and keeps them */
} page_motion;

/* Up to `step_limit` it is plain data without padding, of which saved states are copies. */
typedef struct fmu {
    int32_t has_begun;        /* or 0, as in the next two */
    int32_t event_is_pending; /* Co-Simulation with event mode: the run stands at an event that is not yet
                                 taken */
    int32_t has_jumped;       /* an input, so that states changed, since the last update */
    int32_t event;            /* the pending one */
    page_motion motion;
    double time;  /* the importer's; that of the motion is the page's */
    double epoch; /* the importer's time at the page's time 0 */
    double settings[SETTING_COUNT];
    double
        starts[UNIT_STATE_COUNT + 1]; /* of states in other coordinates than the world's, where these begin */
    double importer_tolerance;        /* infinite where the importer has none */
    double stop_time;                 /* infinite where the importer has none */
    /* Numbers up to which jumps have changed other states; in Model Exchange with the rates of states there.
     */
    double accounted[UNIT_NUMBER_COUNT + 1], accounted_rates[UNIT_STATE_COUNT + 1], accounted_time;
    int64_t work[WORK_COUNT];
    unsigned char watch[8 * (UNIT_EVENT_COUNT / 8 + 1)]; /* a watch_state for each event */
    int64_t step_limit;                                  /* of a call; no part of the run */
    double *memory;                                      /* working memory, of no content */
    bool is_exchange;
} fmu;

/* Values that follow from a run, computed on request. */
typedef struct {
    double numbers[UNIT_NUMBER_COUNT + 1];
    double states[FMU_STATE_COUNT + 1]; /* of a run that has not begun: those that it would begin with */
    double derivatives[FMU_STATE_COUNT + 1];
    double guards[FMU_GUARD_COUNT + 1];
    double outputs[UNIT_OUTPUT_COUNT + 1];
    double work[WORK_COUNT];
    char words[UNIT_WORD_COUNT + 1][WORD_CAPACITY];
} fmu_view;

#endif
