/* One runner of an ensemble, between the events that take it from lane to lane. */
#ifndef TDMF_ENSEMBLE_RUNNER_H
#define TDMF_ENSEMBLE_RUNNER_H

#include "instant.h"
#include "mode_equations.h"
#include "series.h"
#include "step_limits.h"
#include "tdmf_slip/automaton.h"
#include "tdmf_slip/ensemble.h"
#include "tdmf_slip/solver.h"
#include "terrain.h"

/* Runners in the same kind of motion share a batch. */
typedef enum {
    BATCH_PLACE,
    BATCH_RISE,    /* toward an apex: in retract without a clamp, or in place */
    BATCH_CLAMPED, /* in retract with the clamp of (12) */
    BATCH_STICK,   /* with a torque */
    BATCH_STICK_AND_COAST,
    BATCH_SLIP,
    BATCH_SLIP_AND_COAST,
    BATCH_GRAZE,
    BATCH_PLACE_AND_WAIT, /* in flight, toward a ground line that is not in force yet */
    BATCH_RISE_AND_WAIT,
    BATCH_CLAMPED_AND_WAIT,
    BATCH_PLACE_FORCED, /* in flight, with an external force on the body */
    BATCH_RISE_FORCED,
    BATCH_CLAMPED_FORCED,
    BATCH_PLACE_FORCED_AND_WAIT,
    BATCH_RISE_FORCED_AND_WAIT,
    BATCH_CLAMPED_FORCED_AND_WAIT,
    BATCH_FALLING_SLIP,   /* under a friction that falls with speed, with a torque or without */
    BATCH_SLIP_TO_BORDER, /* of a patch of ground, with a torque or without */
    BATCH_FALLING_SLIP_TO_BORDER,
    BATCH_STICK_ON_BORDER,
    BATCH_COUNT,
    COMMON_BATCHES = BATCH_PLACE_AND_WAIT /* the batches that most runners are in */
} batch_kind;

/* Series of a step that peaks of force and signs of power are found by. */
enum {
    TDMF_RECORDED_NORMAL_FORCE, /* on the ground */
    TDMF_RECORDED_TANGENTIAL,   /* against the ground's force along it */
    TDMF_RECORDED_MOMENT,
    TDMF_RECORDED_TORQUE,
    TDMF_RECORDED_POWER,
    TDMF_RECORDED_MOMENTUM = 0, /* in flight */
    TDMF_RECORDED_ANGLE,
    TDMF_RECORDED_RATE_SQUARE,
    TDMF_RECORDED_PUSH_MOMENT,
    TDMF_RECORDED_SERIES = TDMF_RECORDED_POWER + 1
};

struct tdmf_runner {
    const tdmf_ensemble *ensemble;
    int64_t index; /* in the ensemble */
    const tdmf_ensemble_case *its_case;
    const tdmf_model *model; /* the case's, or `set` */
    tdmf_ensemble_map map;
    uint64_t number;    /* by which its ground is drawn */
    tdmf_inputs inputs; /* the case's, but for what is set, at the height that the ground has come to */
    tdmf_ensemble_end *end;
    tdmf_motion motion;
    tdmf_mode_equations equations;
    tdmf_leg_direction direction; /* of the state */
    double stride_began;
    step_count steps; /* in the stride */
    long events_left;
    int false_crossings;       /* since the mode changed */
    tdmf_model set;            /* the case's, with the settings of the stride */
    tdmf_terrain_view terrain; /* terrain, if there is any */
};

static inline tdmf_system tdmf_runner_system(const tdmf_runner *runner) {
    const tdmf_system system = {runner->model, &runner->inputs};
    return system;
}

/* Time goes on, in a lane. */
static inline void tdmf_runner_pass_time(tdmf_runner *runner, double elapsed) {
    tdmf_instant *now = &runner->motion.record.progress.now;
    *now = tdmf_instant_after(*now, elapsed);
    runner->motion.time = now->time;
}

/* Begins at an apex, the start of a runner of the ensemble, or where it stands. False where there is nothing
 * to run: `end` says why. */
bool tdmf_runner_begin(tdmf_runner *runner, const tdmf_ensemble *ensemble, int64_t index,
                       tdmf_ensemble_end *end);

/* Which batch the runner belongs to. */
batch_kind tdmf_runner_batch(const tdmf_runner *runner);

/* Opens its mode and writes what a lane has to know: the fields of a member (members.h), with room for
 * MEMBER_FIELDS. Returns how many they are. */
int tdmf_runner_load(tdmf_runner *runner, double *fields);

/* What a lane has made of a step. */
typedef struct {
    int order;
    double size, end;             /* s: for which it was expanded, and at which it ended */
    const double *before, *after; /* fields of the member */
    double series[TDMF_RECORDED_SERIES][SERIES_TERMS];
} tdmf_lane_step;

/* Whether strides are noted: then each step of a lane is looked at. */
bool tdmf_records_strides(const tdmf_ensemble *ensemble);

/* Notes what a step has passed that is no event: peaks of the ground force, and what of the hip's work was
 * done at positive power. */
void tdmf_runner_record_step(tdmf_runner *runner, const tdmf_lane_step *lane);

/* Takes the event that the lane has come to: its first CHANGING_FIELDS fields, and the guard whose zero it
 * has reached, see tdmf_resolve_along. False where the run has ended. */
bool tdmf_runner_take_event(tdmf_runner *runner, const double *fields, tdmf_guard reached);

/* Whether it may be that an event changes a law of the runner and nothing else of its lane. */
bool tdmf_runner_may_change_law(const tdmf_runner *runner, tdmf_guard reached);

/* Takes such an event, and changes the law in `fields`, all those of the lane. False, with nothing changed,
 * where there is more to it. */
bool tdmf_runner_change_law(tdmf_runner *runner, double *fields, tdmf_guard reached);

/* Makes a stride by the native solver. False where the run has ended. */
bool tdmf_runner_stride(tdmf_runner *runner, tdmf_solver *solver);

/* Is called at the apex at which a stride has closed. Returns false where the run has ended. */
bool tdmf_runner_close_stride(tdmf_runner *runner);

/* Ends a run that closes no more stride: it fell or takes too long, or the solver cannot follow it. */
void tdmf_runner_give_up(tdmf_runner *runner, tdmf_fate fate);

/* Ends a run of the reduced map by a stride that does not close. */
void tdmf_runner_give_up_reduced(tdmf_runner *runner, tdmf_return_outcome outcome);

#endif
