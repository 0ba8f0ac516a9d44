/* CVODE on the automaton: integrate tdmf_derivatives, stop where one of tdmf_guards reaches zero, take the
 * transition, start anew. Problem: all states but the clock, which advances as time does, TDMF_GUARD_COUNT
 * root functions, dense Newton. */
#include "tdmf_slip/cvode.h"

#include "event_log.h"
#include "hip_law.h"
#include "input_rates.h"
#include "instant.h"
#include "leg.h"
#include "record.h"
#include "request.h"
#include "tdmf_slip/automaton.h"
#include "tdmf_slip/dynamics.h"

#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <string.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

bool tdmf_cvode_is_available(void) {
    return true;
}

/* CVODE's own time counts from its last restart: whatever the clock says, it has all digits. */
typedef struct {
    const tdmf_model *model;
    const tdmf_inputs *inputs; /* at `start` */
    const tdmf_inputs *rates;
    tdmf_instant start, restart;
    tdmf_motion *motion; /* while CVODE runs, as it was at `restart` */
    tdmf_solver *options;
} problem;

/* All that CVODE allocates. */
typedef struct {
    SUNContext context;
    N_Vector state, tolerances;
    SUNMatrix matrix;
    SUNLinearSolver linear_solver;
    void *integrator;
} workspace;

static tdmf_inputs inputs_after(const problem *problem, double since_restart) {
    const double elapsed = tdmf_time_between(problem->start, problem->restart) + since_restart;
    return tdmf_inputs_after(problem->inputs, problem->rates, elapsed);
}

/* ---- the state without its clock ---------------------------------------------------------------------- */

enum {
    CLOCK = TDMF_HIP_PLACE_TIME,
    AFTER_CLOCK = TDMF_STATE_COUNT - CLOCK - 1,
    INTEGRATED_COUNT = TDMF_STATE_COUNT - 1
};

static void leave_out_clock(const double full[TDMF_STATE_COUNT], N_Vector integrated) {
    double *elements = N_VGetArrayPointer(integrated);
    memcpy(elements, full, CLOCK * sizeof *full);
    memcpy(elements + CLOCK, full + CLOCK + 1, AFTER_CLOCK * sizeof *full);
}

static void add_clock(const problem *problem, double since_restart, N_Vector integrated,
                      double full[TDMF_STATE_COUNT]) {
    const double *elements = N_VGetArrayPointer(integrated);
    const tdmf_motion *motion = problem->motion;
    full[CLOCK] = motion->state[CLOCK] + since_restart * tdmf_place_time_rate(&motion->mode);
    memcpy(full, elements, CLOCK * sizeof *full);
    memcpy(full + CLOCK + 1, elements + CLOCK, AFTER_CLOCK * sizeof *full);
}

/* ---- what CVODE calls --------------------------------------------------------------------------------- */

static int right_hand_side(realtype time, N_Vector integrated, N_Vector slope, void *data) {
    problem *problem = data;
    const tdmf_inputs inputs = inputs_after(problem, time);
    double state[TDMF_STATE_COUNT], derivatives[TDMF_STATE_COUNT];
    add_clock(problem, time, integrated, state);
    tdmf_derivatives((tdmf_system){problem->model, &inputs}, &problem->motion->mode, state, derivatives);
    derivatives[TDMF_LEG_WORK] +=
        tdmf_leg_power(problem->model, tdmf_rest_length(problem->model, &inputs, &problem->motion->mode),
                       state[TDMF_LEG_LENGTH], problem->rates->leg.extension);
    leave_out_clock(derivatives, slope);
    ++problem->options->evaluations;
    /* A trial past the zero of a speed over which friction falls may be beyond all numbers: it is made again,
     * with a shorter step. */
    return tdmf_is_finite_state(derivatives) ? 0 : 1;
}

static int root_functions(realtype time, N_Vector integrated, realtype *guards, void *data) {
    const problem *problem = data;
    const tdmf_inputs inputs = inputs_after(problem, time);
    double state[TDMF_STATE_COUNT];
    add_clock(problem, time, integrated, state);
    tdmf_guards((tdmf_system){problem->model, &inputs}, &problem->motion->mode, state, guards);
    return 0;
}

/* Failures are told by return codes, which every caller checks; nothing goes to stderr. */
static void stay_silent(int code, const char *module, const char *function, char *message, void *data) {
    (void)code;
    (void)module;
    (void)function;
    (void)message;
    (void)data;
}

/* ---- setting up --------------------------------------------------------------------------------------- */

static void set_tolerances(const tdmf_model *model, double relative, N_Vector tolerances) {
    double units[TDMF_STATE_COUNT];
    tdmf_state_scales(model, units);
    leave_out_clock(units, tolerances);
    N_VScale(relative, tolerances, tolerances);
}

static void destroy(workspace *space) {
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
}

static bool allocate(workspace *space) {
    if (SUNContext_Create(NULL, &space->context) != 0) {
        return false;
    }
    space->state = N_VNew_Serial(INTEGRATED_COUNT, space->context);
    space->tolerances = N_VNew_Serial(INTEGRATED_COUNT, space->context);
    space->matrix = SUNDenseMatrix(INTEGRATED_COUNT, INTEGRATED_COUNT, space->context);
    if (space->state == NULL || space->tolerances == NULL || space->matrix == NULL) {
        return false;
    }
    space->linear_solver = SUNLinSol_Dense(space->state, space->matrix, space->context);
    space->integrator = CVodeCreate(CV_BDF, space->context);
    return space->linear_solver != NULL && space->integrator != NULL;
}

static bool configure(workspace *space, problem *problem) {
    void *cvode = space->integrator;
    const double tolerance = problem->options->relative_tolerance;
    set_tolerances(problem->model, tolerance, space->tolerances);
    leave_out_clock(problem->motion->state, space->state);
    return CVodeSetErrHandlerFn(cvode, stay_silent, NULL) == CV_SUCCESS &&
           CVodeInit(cvode, right_hand_side, 0.0, space->state) == CV_SUCCESS &&
           CVodeSetUserData(cvode, problem) == CV_SUCCESS &&
           CVodeSVtolerances(cvode, tolerance, space->tolerances) == CV_SUCCESS &&
           CVodeSetLinearSolver(cvode, space->linear_solver, space->matrix) == CV_SUCCESS &&
           CVodeRootInit(cvode, TDMF_GUARD_COUNT, root_functions) == CV_SUCCESS &&
           CVodeSetNoInactiveRootWarn(cvode) == CV_SUCCESS;
}

/* ---- the run ------------------------------------------------------------------------------------------ */

/* The first of the guards that CVODE found at zero. */
static int guard_that_fired(void *integrator) {
    int found[TDMF_GUARD_COUNT] = {0};
    int guard = 0;
    CVodeGetRootInfo(integrator, found);
    while (guard < TDMF_GUARD_COUNT - 1 && found[guard] == 0) {
        ++guard;
    }
    return guard;
}

/* Takes the transitions due at CVODE's present time and state, and restarts it there. */
static tdmf_outcome take_events(workspace *space, problem *problem) {
    tdmf_motion *motion = problem->motion;
    problem->restart = motion->record.progress.now;
    const tdmf_inputs inputs = inputs_after(problem, 0.0);
    tdmf_event event = {
        .time = motion->time, .guard = guard_that_fired(space->integrator), .before = motion->mode};
    memcpy(event.state, motion->state, sizeof event.state);
    const bool unresolved = tdmf_resolve((tdmf_system){problem->model, &inputs}, motion).unresolved;
    event.after = motion->mode;
    tdmf_log_event(problem->options, &event);
    ++problem->options->events;
    leave_out_clock(motion->state, space->state);
    if (unresolved) {
        return TDMF_TOO_MANY_EVENTS;
    }
    return CVodeReInit(space->integrator, 0.0, space->state) == CV_SUCCESS ? TDMF_ARRIVED : TDMF_NO_PROGRESS;
}

/* Sets the rest length up to which the work of the leg has been integrated. */
static void update_rest_length(const problem *problem) {
    tdmf_motion *motion = problem->motion;
    const double elapsed = tdmf_time_between(problem->start, motion->record.progress.now);
    const tdmf_inputs inputs = tdmf_inputs_after(problem->inputs, problem->rates, elapsed);
    motion->mode.rest_length = tdmf_rest_length(problem->model, &inputs, &motion->mode);
}

/* How long the next step may be. */
static double longest_step(const workspace *space, const problem *problem, double since_restart) {
    const tdmf_inputs inputs = inputs_after(problem, since_restart);
    double state[TDMF_STATE_COUNT];
    add_clock(problem, since_restart, space->state, state);
    return tdmf_longest_step((tdmf_system){problem->model, &inputs}, &problem->motion->mode, state);
}

/* Goes on from a restart until `left` later or to the first root, and says when that is. Where friction falls
 * with speed CVODE is called for every step, and stopped where that may be no longer: a maximum of its own
 * would bind the step after the next only. */
static int go_on(workspace *space, problem *problem, double left, long steps_left, realtype *time) {
    for (*time = 0.0;;) {
        const double longest = longest_step(space, problem, *time);
        const bool in_layer = *time + longest < left;
        long steps = 0;
        if (CVodeGetNumSteps(space->integrator, &steps) != CV_SUCCESS ||
            CVodeSetMaxNumSteps(space->integrator, steps_left - steps) != CV_SUCCESS ||
            CVodeSetStopTime(space->integrator, in_layer ? *time + longest : left) != CV_SUCCESS) {
            return CV_ILL_INPUT;
        }
        const int flag =
            CVode(space->integrator, left, space->state, time, isfinite(longest) ? CV_ONE_STEP : CV_NORMAL);
        problem->options->layer_steps += flag == CV_TSTOP_RETURN && in_layer;
        if (flag < 0 || flag == CV_ROOT_RETURN || !(*time < left)) {
            return flag;
        }
        if (steps + 1 >= steps_left) {
            return CV_TOO_MUCH_WORK;
        }
    }
}

static tdmf_outcome integrate(workspace *space, problem *problem, double until) {
    tdmf_motion *motion = problem->motion;
    const tdmf_instant end = {until, 0.0};
    long steps_left = problem->options->step_limit;
    for (long events = problem->options->event_limit;
         tdmf_time_between(motion->record.progress.now, end) > 0.0 && !motion->mode.fallen; --events) {
        const double left = tdmf_time_between(motion->record.progress.now, end);
        if (events <= 0) {
            return TDMF_TOO_MANY_EVENTS;
        }
        if (steps_left <= 0) {
            return TDMF_TOO_MANY_STEPS;
        }
        realtype time = 0.0;
        long steps = 0;
        const int flag = go_on(space, problem, left, steps_left, &time);
        CVodeGetNumSteps(space->integrator, &steps); /* since the last restart */
        problem->options->steps += steps;
        steps_left -= steps;
        /* Where it failed CVODE gives the last time and state that it reached. */
        motion->record.progress.now =
            flag == CV_SUCCESS || flag == CV_TSTOP_RETURN ? end : tdmf_instant_after(problem->restart, time);
        motion->time = motion->record.progress.now.time;
        add_clock(problem, time, space->state, motion->state);
        update_rest_length(problem);
        if (flag < 0) {
            return flag == CV_TOO_MUCH_WORK ? TDMF_TOO_MANY_STEPS : TDMF_NO_PROGRESS;
        }
        const tdmf_outcome taken = flag == CV_ROOT_RETURN ? take_events(space, problem) : TDMF_ARRIVED;
        if (taken != TDMF_ARRIVED) {
            return taken;
        }
    }
    return motion->mode.fallen ? TDMF_FELL : TDMF_ARRIVED;
}

tdmf_outcome tdmf_cvode_advance(tdmf_solver *options, tdmf_system system, const tdmf_inputs *rates,
                                double until, tdmf_motion *motion) {
    const tdmf_inputs *given = tdmf_rates_or_zero(rates);
    if (!tdmf_is_sound_request(options, system, given, until, motion)) {
        return TDMF_REFUSED;
    }
    const tdmf_instant start = tdmf_instant_of(motion);
    problem problem = {system.model, system.inputs, given, start, start, motion, options};
    workspace space = {0};
    tdmf_outcome outcome = TDMF_NO_PROGRESS;
    motion->record.progress.now = start;
    /* An input may have jumped since the last call. */
    if (tdmf_resolve(system, motion).unresolved) {
        return TDMF_TOO_MANY_EVENTS;
    }
    if (allocate(&space) && configure(&space, &problem)) {
        outcome = integrate(&space, &problem, until);
    }
    destroy(&space);
    return outcome;
}
