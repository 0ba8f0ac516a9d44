/* CVODE on a mode of a page: all states that move and all integrals of positive parts, by BDF and dense
 * Newton; root functions are the guards of the mode and the rates of what it observes the largest value of.
 * Where a mode has coordinates of its own, those of the world are integrated, as an importer does. States
 * that change at a constant rate, such as clocks and ramped inputs, are left to a product. CVODE's own time
 * counts from the beginning of a call: whatever the clock says, it has all digits. */
#include "page_cvode.h"

#include "run_state.h"

#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

bool tdmf_page_cvode_is_available(void) {
    return true;
}

/* A rate of an observed quantity that may settle at zero counts as unchanged up to this, in 1/s. */
static const double dead_band = 1e-10;

typedef struct {
    const tdmf_model_kind *model;
    tdmf_page_run *run; /* while CVODE runs, as it was at the beginning */
    unsigned char *watch;
    int64_t *evaluations;
    int *indices; /* indices of the integrated states, then of those with a constant rate */
    int count, steady_count, root_count;
    bool rises[TDMF_WATCH_LIMIT];      /* observed quantities, at the beginning */
    double *x, *rates, *room, *memory; /* a trial state, its rates, and memory for an instant */
    double *steady_rates;              /* indexed by state */
} problem;

/* All that CVODE allocates. */
typedef struct {
    SUNContext context;
    N_Vector state, tolerances;
    SUNMatrix matrix;
    SUNLinearSolver linear_solver;
    void *integrator;
} workspace;

static const tdmf_mode_kind *mode_of(const problem *problem) {
    return &problem->model->modes[problem->run->mode];
}

/* ---- what CVODE calls --------------------------------------------------------------------------------- */

static tdmf_page_instant instant_at(const problem *problem, const double *x) {
    return tdmf_instant_at(problem->model, problem->run->mode, problem->run->p, x, problem->memory);
}

static void pick(const problem *problem, const double *values, N_Vector integrated) {
    double *elements = N_VGetArrayPointer(integrated);
    for (int i = 0; i < problem->count; ++i) {
        elements[i] = values[problem->indices[i]];
    }
}

static void put(const problem *problem, double time, N_Vector integrated, double *values) {
    const double *elements = N_VGetArrayPointer(integrated);
    for (int i = 0; i < problem->count; ++i) {
        values[problem->indices[i]] = elements[i];
    }
    for (int i = 0; i < problem->steady_count; ++i) {
        const int state = problem->indices[problem->count + i];
        values[state] = problem->run->x[state] + time * problem->steady_rates[state];
    }
    tdmf_take_from_world(problem->model, problem->run->mode, problem->run->p, values, problem->room);
}

static int right_hand_side(realtype time, N_Vector integrated, N_Vector slope, void *data) {
    problem *problem = data;
    put(problem, time, integrated, problem->x);
    const tdmf_page_instant at = instant_at(problem, problem->x);
    tdmf_page_world_rates(&at, problem->rates);
    pick(problem, problem->rates, slope);
    ++*problem->evaluations;
    const double *rates = N_VGetArrayPointer(slope);
    for (int i = 0; i < problem->count; ++i) {
        if (!isfinite(rates[i])) {
            return 1; /* a trial beyond all numbers is made again, with a shorter step */
        }
    }
    return 0;
}

static int root_functions(realtype time, N_Vector integrated, realtype *roots, void *data) {
    const problem *problem = data;
    const tdmf_mode_kind *mode = mode_of(problem);
    guard_state guards[TDMF_GUARD_LIMIT];
    int count = mode->guard_count;
    put(problem, time, integrated, problem->x);
    const tdmf_page_instant at = instant_at(problem, problem->x);
    tdmf_view_guards(&at, problem->watch, guards);
    for (int i = 0; i < mode->guard_count; ++i) {
        roots[i] = guards[i].value;
    }
    for (int i = 0; i < mode->usual_count; ++i) {
        double value, rate;
        if (mode->watches[i].part == TDMF_LARGEST) {
            tdmf_page_observed(&at, i, &value, &rate);
            rate /= at.scales[mode->watches[i].into];
            roots[count++] = (problem->rises[i] ? rate : -rate) + dead_band;
        }
    }
    return 0;
}

/* Failures are reported by return codes, which every caller checks; nothing goes to stderr. */
static void stay_silent(int code, const char *module, const char *function, char *message, void *data) {
    (void)code;
    (void)module;
    (void)function;
    (void)message;
    (void)data;
}

/* ---- setting up --------------------------------------------------------------------------------------- */

static void destroy(workspace *space, problem *problem) {
    if (space->integrator != NULL) {
        CVodeFree(&space->integrator);
    }
    if (space->linear_solver != NULL) {
        SUNLinSolFree(space->linear_solver);
    }
    if (space->matrix != NULL) {
        SUNMatDestroy(space->matrix);
    }
    if (space->tolerances != NULL) {
        N_VDestroy(space->tolerances);
    }
    if (space->state != NULL) {
        N_VDestroy(space->state);
    }
    if (space->context != NULL) {
        SUNContext_Free(&space->context);
    }
    free(problem->x);
    free(problem->indices);
}

/* Marks the states that a function writes in `is_written`. */
static void find_written(const problem *problem, tdmf_change *function, bool *is_written) {
    for (int i = 0; i < problem->model->state_count; ++i) {
        problem->room[i] = NAN;
    }
    function(problem->run->p, problem->run->x, problem->room);
    for (int i = 0; i < problem->model->state_count; ++i) {
        is_written[i] = !isnan(problem->room[i]);
    }
}

/* The states that move; where the mode has coordinates of its own, the world's in their place. */
static void find_integrated(problem *problem, bool *of_mode, bool *of_world, bool *of_steady) {
    const tdmf_mode_kind *mode = mode_of(problem);
    problem->root_count = mode->guard_count;
    if (mode->world_rates != NULL) {
        find_written(problem, mode->from_world, of_mode);
        find_written(problem, mode->world_rates, of_world);
    }
    for (int i = 0; i < mode->motion->moving_count; ++i) {
        const int state = mode->motion->moving[i];
        const bool is_steady = mode->motion->degrees[i] <= 1 && !of_mode[state] && !of_world[state];
        of_world[state] |= !of_mode[state] && !is_steady;
        of_steady[state] = is_steady;
    }
    for (int i = 0; i < mode->usual_count; ++i) {
        of_world[mode->watches[i].into] |= mode->watches[i].part == TDMF_POSITIVE_INTEGRAL;
        problem->root_count += mode->watches[i].part == TDMF_LARGEST;
    }
    for (int i = 0; i < problem->model->state_count; ++i) {
        if (of_world[i]) {
            problem->indices[problem->count++] = i;
        }
    }
    for (int i = 0; i < problem->model->state_count; ++i) {
        if (of_steady[i]) {
            problem->indices[problem->count + problem->steady_count++] = i;
        }
    }
}

static bool allocate(workspace *space, problem *problem) {
    const size_t states = (size_t)problem->model->state_count;
    problem->x = malloc((4 * states + tdmf_size_of_instant(problem->model)) * sizeof *problem->x);
    problem->indices = malloc(states * sizeof *problem->indices);
    bool *marks = calloc(3 * states, sizeof *marks);
    if (problem->x != NULL && problem->indices != NULL && marks != NULL) {
        problem->rates = problem->x + states;
        problem->room = problem->rates + states;
        problem->steady_rates = problem->room + states;
        problem->memory = problem->steady_rates + states;
        tdmf_show_to_world(problem->model, problem->run->mode, problem->run->p, problem->run->x,
                           problem->room);
        find_integrated(problem, marks, marks + states, marks + 2 * states);
        memcpy(problem->x, problem->run->x, states * sizeof *problem->x);
    }
    free(marks);
    if (problem->count == 0 || SUNContext_Create(NULL, &space->context) != 0) {
        return false;
    }
    space->state = N_VNew_Serial(problem->count, space->context);
    space->tolerances = N_VNew_Serial(problem->count, space->context);
    space->matrix = SUNDenseMatrix(problem->count, problem->count, space->context);
    if (space->state == NULL || space->tolerances == NULL || space->matrix == NULL) {
        return false;
    }
    space->linear_solver = SUNLinSol_Dense(space->state, space->matrix, space->context);
    space->integrator = CVodeCreate(CV_BDF, space->context);
    return space->linear_solver != NULL && space->integrator != NULL;
}

static bool configure(workspace *space, problem *problem) {
    void *cvode = space->integrator;
    const double tolerance = problem->run->tolerance;
    const tdmf_page_instant at = instant_at(problem, problem->run->x);
    pick(problem, at.scales, space->tolerances);
    N_VScale(tolerance, space->tolerances, space->tolerances);
    tdmf_page_rates(&at, problem->steady_rates);
    for (int i = 0; i < at.mode->usual_count; ++i) {
        double value, rate;
        tdmf_page_observed(&at, i, &value, &rate);
        problem->rises[i] = rate > 0.0;
    }
    pick(problem, problem->run->x, space->state);
    return CVodeSetErrHandlerFn(cvode, stay_silent, NULL) == CV_SUCCESS &&
           CVodeInit(cvode, right_hand_side, 0.0, space->state) == CV_SUCCESS &&
           CVodeSetUserData(cvode, problem) == CV_SUCCESS &&
           CVodeSVtolerances(cvode, tolerance, space->tolerances) == CV_SUCCESS &&
           CVodeSetLinearSolver(cvode, space->linear_solver, space->matrix) == CV_SUCCESS &&
           CVodeRootInit(cvode, problem->root_count, root_functions) == CV_SUCCESS &&
           CVodeSetNoInactiveRootWarn(cvode) == CV_SUCCESS;
}

/* ---- the run ------------------------------------------------------------------------------------------ */

/* Notes guards and largest values where CVODE stands. True if an event is due there. */
static bool look_around(const workspace *space, problem *problem, double time) {
    guard_state guards[TDMF_GUARD_LIMIT];
    bool is_due = false;
    put(problem, time, space->state, problem->x);
    const tdmf_page_instant at = instant_at(problem, problem->x);
    tdmf_view_guards(&at, problem->watch, guards);
    tdmf_note_guards(&at, guards, problem->watch);
    tdmf_note_largest(&at, problem->run->x);
    for (int i = 0; i < at.mode->guard_count; ++i) {
        is_due |= guards[i].is_due;
    }
    return is_due;
}

/* Goes on until `left` later or to the first root, and says when that is. Where a law has a time scale,
 * CVODE is called for every step, and stopped where that may be no longer: a maximum of its own would bind
 * the step after the next only. */
static int go_on(workspace *space, problem *problem, double left, long limit, realtype *time) {
    for (*time = 0.0;;) {
        long steps = 0;
        put(problem, *time, space->state, problem->x);
        const double longest = tdmf_longest_step_of_solver(mode_of(problem), problem->run->p, problem->x);
        const bool is_limited = *time + longest < left;
        const double before = *time;
        if (CVodeGetNumSteps(space->integrator, &steps) != CV_SUCCESS ||
            CVodeSetMaxNumSteps(space->integrator, limit - steps) != CV_SUCCESS ||
            CVodeSetStopTime(space->integrator, is_limited ? *time + longest : left) != CV_SUCCESS) {
            return CV_ILL_INPUT;
        }
        const int flag =
            CVode(space->integrator, left, space->state, time, isfinite(longest) ? CV_ONE_STEP : CV_NORMAL);
        problem->run->limited_steps += is_limited && *time - before > 0.5 * longest;
        if (flag < 0 || flag == CV_ROOT_RETURN || !(*time < left)) {
            return flag;
        }
        if (steps + 1 >= limit) {
            return CV_TOO_MUCH_WORK;
        }
    }
}

/* TDMF_RUN_GOES_ON: the step ended at a largest value, and no event is due. */
static tdmf_run_outcome go_to_root(workspace *space, problem *problem, double left, long limit) {
    tdmf_page_run *run = problem->run;
    realtype time = 0.0;
    long steps = 0;
    look_around(space, problem, 0.0);
    const int flag = go_on(space, problem, left, limit, &time);
    CVodeGetNumSteps(space->integrator, &steps);
    run->steps += steps;
    /* If CVODE failed, it returns the last time and state that it reached. */
    const bool is_due = look_around(space, problem, time);
    put(problem, time, space->state, run->x);
    tdmf_pass_time(run, time);
    if (flag < 0) {
        return flag == CV_TOO_MUCH_WORK ? TDMF_RUN_TOO_MANY_STEPS : TDMF_RUN_NO_PROGRESS;
    }
    return is_due ? TDMF_RUN_STOPPED : time < left ? TDMF_RUN_GOES_ON : TDMF_RUN_ARRIVED;
}

/* CVODE is reinitialized at each root, because it takes two close roots for an error. */
static tdmf_run_outcome begin_anew(problem *problem, double left, long limit) {
    workspace space = {0};
    tdmf_run_outcome outcome = TDMF_RUN_NO_PROGRESS;
    if (limit <= 0) {
        return TDMF_RUN_TOO_MANY_STEPS;
    }
    if (allocate(&space, problem) && configure(&space, problem)) {
        outcome = go_to_root(&space, problem, left, limit);
    }
    destroy(&space, problem);
    return outcome;
}

tdmf_run_outcome tdmf_cvode_to_event(const tdmf_model_kind *model, tdmf_page_run *run, unsigned char *watch,
                                     double until, int64_t *evaluations) {
    const long last_step = run->steps + run->step_limit;
    double left = until - run->time - run->time_rest;
    while (left > 0.0) {
        problem problem = {.model = model, .run = run, .watch = watch, .evaluations = evaluations};
        const tdmf_run_outcome outcome = begin_anew(&problem, left, last_step - run->steps);
        if (outcome != TDMF_RUN_GOES_ON) {
            return outcome;
        }
        left = until - run->time - run->time_rest;
    }
    return TDMF_RUN_ARRIVED;
}
