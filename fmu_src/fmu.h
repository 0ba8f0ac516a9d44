/* A run of a page in a unit, and the operations that calls of FMI need, independent of FMI's version. */
#ifndef TDMF_FMU_FMU_H
#define TDMF_FMU_FMU_H

#include "unit_page.h" /* generated: sizes of the tables of the page */

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { UNIT_NUMBER_COUNT = UNIT_PARAMETER_COUNT + UNIT_STATE_COUNT, WORD_CAPACITY = 64 };

/* Settings of the unit rather than of the page. */
typedef enum { SOLVER_NATIVE = 1, SOLVER_CVODE } solver_method;

typedef enum { SETTING_TOLERANCE, SETTING_TERMINATES, SETTING_METHOD, SETTING_COUNT } fmu_setting;

/* Work of the solver in Co-Simulation. */
typedef enum { WORK_STEPS, WORK_EVALUATIONS, WORK_LAYER_STEPS, WORK_COUNT } fmu_work;

/* State of a run between calls of the driver. `numbers` holds the page's parameters, then its states. If a
 * mode has its own coordinates, Co-Simulation computes the world's from them, and Model Exchange computes
 * them from the world's. `shown` is the mode whose outputs are shown: the present mode, or the mode before if
 * the run has ended and keeps its outputs. */
typedef struct {
    double numbers[UNIT_NUMBER_COUNT + 1];
    double time, time_rest;
    uint64_t taken, above, late;
    int64_t chain;
    int32_t mode, shown;
} page_motion;

/* The fields before `step_limit` are plain data without padding, which saved states copy. */
typedef struct fmu {
    int32_t has_begun;        /* 0 or 1, as are event_is_pending and has_jumped */
    int32_t event_is_pending; /* in Co-Simulation with event mode: the run stands just before an event */
    int32_t has_jumped;       /* since the last update a jump of an input has changed states */
    int32_t event;            /* number of the pending event */
    page_motion motion;
    double time;  /* the importer's time; the time of the motion is the page's */
    double epoch; /* the importer's time at the page's time 0 */
    double settings[SETTING_COUNT];
    double starts[UNIT_STATE_COUNT + 1]; /* start values of states in other coordinates than the world's */
    double importer_tolerance;           /* infinite if the importer gives none */
    double stop_time;                    /* infinite if the importer gives none */
    /* The numbers when states were last changed for jumps; in Model Exchange also the rates of states then.
     */
    double accounted[UNIT_NUMBER_COUNT + 1], accounted_rates[UNIT_STATE_COUNT + 1], accounted_time;
    int64_t work[WORK_COUNT];
    unsigned char watch[8 * (UNIT_EVENT_COUNT / 8 + 1)]; /* a watch_state for each event */
    int64_t step_limit;                                  /* limit of steps in a call; not part of the run */
    double *memory, *instant; /* working memory of a run and of an instant; it holds nothing between calls */
    bool is_exchange;
} fmu;

/* Values that follow from a run, computed on request. */
typedef struct {
    double numbers[UNIT_NUMBER_COUNT + 1];
    double states[UNIT_CONTINUOUS_COUNT + 1]; /* before the run: the states with which it would begin */
    double derivatives[UNIT_CONTINUOUS_COUNT + 1];
    double guards[UNIT_GUARD_COUNT + 1];
    double outputs[UNIT_OUTPUT_COUNT + 1];
    double work[WORK_COUNT];
    char words[UNIT_WORD_COUNT + 1][WORD_CAPACITY];
} fmu_view;

/* Functions that may refuse write the reason into a text of FMU_TEXT characters and return it; they return
 * NULL for success. `observer` is the instance to which events are reported, or NULL. */
enum { FMU_TEXT = 256 };
struct instance;

/* Resets everything to the start values, at time 0. */
void fmu_reset(fmu *fmu);

/* Refuses if the page has a requirement that is not met: one of parameters alone, or one of a start. */
const char *unmet_requirement(const fmu *fmu, bool of_parameters, char text[FMU_TEXT]);

/* Begins the run at its time from the values set so far; on refusal the unit is left as it was. */
const char *fmu_start(fmu *fmu, char text[FMU_TEXT]);

void fmu_set_time(fmu *fmu, double time);

/* True if a clock may show this time: differences, sums and ratios of such times are numbers. */
static inline bool fmu_is_time(double time) {
    return fabs(time) <= 1e100;
}

void fmu_evaluate(const fmu *fmu, fmu_view *view);

/* The directional derivative of a view by states, inputs and parameters, whose seeds are those of `seed`. */
void fmu_differentiate(const fmu *fmu, const struct fmu *seed, fmu_view *variation);

/* The change at the start of a run, along a direction of all that a start follows from: the seed is in the
 * direction's parameters, inputs, states and time. `given` is the unit before fmu_start, `started` the one
 * after. States that the start calculates are written into the seed. */
void fmu_differentiate_start(const fmu *given, const struct fmu *started, struct fmu *seed,
                             fmu_view *variation);

/* The direction in which the unit itself moves: derivatives of its states, rates of its inputs. */
void fmu_flow(const fmu *fmu, struct fmu *seed);

/* The continuous states as an importer sees them; `view` is that of a run that has not begun, else NULL. */
void fmu_states(const fmu *fmu, const fmu_view *view, double states[]);

/* Largest state and largest sum along a run. The first is far beyond any motion, and no product in the
 * equations overflows with it. The second is beyond every sum of such states, and no product with it
 * overflows either. */
#define fmu_largest_state 1e60
#define fmu_largest_sum   1e200

/* Limits a value to the largest state. NaN counts as large. */
static inline double fmu_within_largest(double value) {
    const double bounded = value < fmu_largest_state ? value : fmu_largest_state;
    return bounded > -fmu_largest_state ? bounded : -fmu_largest_state;
}

/* Sets trial states of a solver, which are not NaN. They are limited, so that all values stay finite.
 */
void fmu_try_states(fmu *fmu, const double states[]);

/* Derivatives are limited as trial states are: the importer's solver then finds that its step was too long.
 */
void fmu_derivatives(const fmu *fmu, double derivatives[]);
void fmu_event_indicators(const fmu *fmu, double indicators[]);

/* Typical magnitudes of the states, from the parameters; importers make absolute tolerances of them. */
void fmu_nominals(const fmu *fmu, double nominals[]);

/* Model Exchange: records the guards and largest values after a completed step. True if event mode is needed,
 * because a guard is due or an input has changed whose jumps change other states. */
bool fmu_complete_step(fmu *fmu);

/* Event mode begins: before inputs may jump. */
void fmu_enter_event_mode(fmu *fmu);

/* Takes a pending event and all others that are due now. If it refuses, the unit is as it was. */
const char *fmu_update(fmu *fmu, const struct instance *observer, bool *state_changed, char text[FMU_TEXT]);

/* Co-Simulation: moves the run on to `until`, or to the first event on the way that counts: at its exact
 * time, before it is taken, with fmu->event_is_pending. A run that has ended stays readable, frozen. Returns
 * why it got no farther than its time. */
const char *fmu_advance(fmu *fmu, double until, bool stops_at_event, const struct instance *observer,
                        char text[FMU_TEXT]);

#endif
