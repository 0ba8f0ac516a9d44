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
TDMF_API void tdmf_section_state(tdmf_system system, const double section[TDMF_SECTION_COUNT],
                                 double state[TDMF_STATE_COUNT]);

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

/* How the next apex and the stride change along a seed, per unit of it. */
typedef struct {
    double apex[TDMF_SECTION_COUNT];        /* of the next apex */
    double period, length, work;            /* of the stride's quantities of these names */
    double stance_time, slip_distance;      /* of these, too */
    double peak_force, peak_vertical_force; /* and of these */
    double foot_clearance;                  /* of the return's */
    double foot_x;                          /* and of its place of the foot */
    tdmf_stride_measures measures;          /* and of these, where they were asked for */
} tdmf_stride_variation;

/* Seeds of parameters and inputs along which a stride of the return map is differentiated, at the most.
 * Unary plus makes an int: C++20 deprecates arithmetic between two enumerations. */
enum { TDMF_RETURN_MAP_SEEDS = +TDMF_VARIATION_LIMIT - TDMF_SECTION_COUNT };

/* Whether a stride closed, and else why not. Some of this only the reduced map meets. */
typedef enum {
    TDMF_RETURN_CLOSED,       /* it has a next apex */
    TDMF_RETURN_REFUSED,      /* a value is out of range, a pointer NULL, or there are too many seeds */
    TDMF_RETURN_NO_START,     /* the start is no apex: in flight, above the ground */
    TDMF_RETURN_NO_TOUCHDOWN, /* reduced: the foot does not come down within the time allowed */
    TDMF_RETURN_NO_STANCE,    /* reduced: the impact leaves the foot without load */
    TDMF_RETURN_TOO_LONG,     /* the stride, reduced: the stance, takes longer than the time allowed */
    TDMF_RETURN_NO_APEX,      /* reduced: the centre of mass does not rise at lift-off */
    TDMF_RETURN_FELL,         /* the body or the leg is down */
    TDMF_RETURN_UNSOLVED      /* the solver could not follow the runner: see `solver` */
} tdmf_return_outcome;

/* What became of a stride, by the return map or the reduced one. Where it has not closed, all but the
 * outcomes is zero. The variations are there if derivatives were asked for: along the coordinates of the
 * start, which are six or, in the reduced map, two, and after them along the seeds that were given. */
typedef struct {
    tdmf_return_outcome outcome;     /* whether it closed, and else why not */
    tdmf_outcome solver;             /* how the solver's call ended; TDMF_ARRIVED where there was none */
    double apex[TDMF_SECTION_COUNT]; /* the next; of the reduced map the first two */
    tdmf_stride stride;              /* its quantities; of the reduced map the work is that of the stance */
    double liftoff_angle;            /* theta_LO of the stride, rad */
    double external_work;            /* J, of the stride, as the losses */
    double damper_loss, friction_loss, impact_loss; /* J in the stride */
    double leg_loss;       /* J, reduced: left in the leg at lift-off less what it is given for touchdown */
    double foot_x;         /* m, of the foot at the next apex */
    double foot_clearance; /* m, of the foot above the ground at the apex where the stride begins */
    tdmf_stride_measures measures; /* of the stride, where they were asked for */
    tdmf_stride_variation
        variations[TDMF_VARIATION_LIMIT]; /* along the start's coordinates, then the seeds */
} tdmf_return;

/* One stride from an apex, not longer than `until`. With `derivatives`, also how it changes with the six
 * coordinates and along `count` seeds of parameters and inputs; more than TDMF_RETURN_MAP_SEEDS, or less
 * than 0, are refused, as are NULL for any pointer but `seeds` where there are none, a tolerance out of
 * range, and a patch of ground: on one the stride depends on where the foot is.
 *
 * Derivatives also limit the steps. They are not finite where none exists: where an event's crossing is a
 * touch, and along a gain if both gains are zero and hip.swing_clamp is true. */
TDMF_API tdmf_return tdmf_return_map(tdmf_solver *solver, tdmf_system system,
                                     const double section[TDMF_SECTION_COUNT], double until, bool derivatives,
                                     const tdmf_seed *seeds, int count);

/* One stride from an apex with the foot at x = foot_x, over ground with a patch or without: the seventh
 * coordinate, by which the stride is differentiated after the seeds, of which there may be one less. */
TDMF_API tdmf_return tdmf_return_map_at(tdmf_solver *solver, tdmf_system system, double foot_x,
                                        const double section[TDMF_SECTION_COUNT], double until,
                                        bool derivatives, const tdmf_seed *seeds, int count);

/* The same as tdmf_return_map, with what is measured along the stride. */
TDMF_API tdmf_return tdmf_measured_return_map(tdmf_solver *solver, tdmf_system system,
                                              const double section[TDMF_SECTION_COUNT], double until,
                                              bool derivatives, const tdmf_seed *seeds, int count);

/* Says an outcome in words. */
TDMF_API const char *tdmf_return_outcome_text(tdmf_return_outcome outcome);

#ifdef __cplusplus
}
#endif
#endif
