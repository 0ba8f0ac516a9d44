/* The return map: from one apex to the next, and its exact Jacobian. */
#ifndef TDMF_SLIP_RETURN_MAP_H
#define TDMF_SLIP_RETURN_MAP_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/solver.h"
#include "tdmf_slip/variation.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Coordinates of the apex section, where the centre of mass is highest: its height above the ground and its
 * speed, and the leg.
 */
enum {
    TDMF_SECTION_COM_HEIGHT,      /* m, above the ground vertically below */
    TDMF_SECTION_COM_SPEED,       /* m/s */
    TDMF_SECTION_LEG_LENGTH,      /* r, m */
    TDMF_SECTION_LEG_ANGLE,       /* theta, rad */
    TDMF_SECTION_LEG_LENGTH_RATE, /* m/s */
    TDMF_SECTION_LEG_ANGLE_RATE,  /* rad/s */
    TDMF_SECTION_COUNT
};

/* The state at an apex with the foot at x = 0 over the ground that the inputs set, integrals zero. `section`
 * may lie within `state`. */
TDMF_API void tdmf_section_state(const tdmf_model *model, const tdmf_inputs *inputs,
                                 const double section[TDMF_SECTION_COUNT], double state[TDMF_STATE_COUNT]);

/* What is measured along a stride besides what its record holds; also the change of each of these. */
typedef struct {
    double positive_hip_work;      /* J, done at positive power: the record's positive_work */
    double positive_leg_work;      /* J, of the jumps of its rest length that do any */
    double squared_torque;         /* integral of tau^2, N^2 m^2 s */
    double friction_loss;          /* J */
    double greatest_slip_velocity; /* m/s, of the foot along the ground, whichever way it slips */
    double greatest_foot_height;   /* m, in flight, above the ground vertically below */
} tdmf_stride_measures;

/* The inverse: the coordinates of a state at an apex over a ground. `section` may lie within `state`. */
TDMF_API void tdmf_section_of_state(const tdmf_model *model, const tdmf_ground_line *ground,
                                    const double state[TDMF_STATE_COUNT], double section[TDMF_SECTION_COUNT]);

/* How the next apex and the stride change with something. */
typedef struct {
    double apex[TDMF_SECTION_COUNT];        /* of the next apex */
    double period, length, work;            /* of the stride's quantities of these names */
    double stance_time, slip_distance;      /* of these, too */
    double peak_force, peak_vertical_force; /* and of these */
    double foot_clearance;                  /* of the return's */
    tdmf_stride_measures measures;          /* and of these, where they were asked for */
} tdmf_stride_variation;

/* Directions of parameters and inputs along which a stride is differentiated, at the most. */
enum { TDMF_RETURN_MAP_SEEDS = TDMF_VARIATION_LIMIT - TDMF_SECTION_COUNT };

/* What became of a stride. The derivatives are there if it closed and they were asked for. */
typedef struct {
    tdmf_stride_outcome outcome;     /* whether it closed, and else why not */
    bool began_at_apex;              /* the start is one: in flight, above the ground, not refused */
    double apex[TDMF_SECTION_COUNT]; /* the next */
    tdmf_stride stride;              /* its quantities */
    double liftoff_angle;            /* theta_LO of the stride, rad */
    double external_work;            /* J, of the stride, as the losses */
    double damper_loss, friction_loss, impact_loss; /* J in the stride */
    double foot_clearance;         /* m, of the foot above the ground at the apex where the stride begins */
    tdmf_stride_measures measures; /* of the stride, where they were asked for */
    tdmf_stride_variation by_section[TDMF_SECTION_COUNT];      /* by each coordinate of the start */
    tdmf_stride_variation by_parameter[TDMF_RETURN_MAP_SEEDS]; /* along each change that was given */
} tdmf_return;

/* One stride from an apex, not longer than `until`. With `derivatives`, also how it changes with the six
 * coordinates and along `count` directions of parameters and inputs; more than TDMF_RETURN_MAP_SEEDS, or less
 * than 0, are refused, as are NULL for any pointer but `seeds` where there are none, and a tolerance out of
 * range. */
TDMF_API tdmf_return tdmf_return_map(tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs,
                                     const double section[TDMF_SECTION_COUNT], double until, bool derivatives,
                                     const tdmf_seed *seeds, int count);

/* The same, with what is measured along the stride: without derivatives it takes twice as long. */
TDMF_API tdmf_return tdmf_measured_return_map(tdmf_solver *solver, const tdmf_model *model,
                                              const tdmf_inputs *inputs,
                                              const double section[TDMF_SECTION_COUNT], double until,
                                              bool derivatives, const tdmf_seed *seeds, int count);

#ifdef __cplusplus
}
#endif
#endif
