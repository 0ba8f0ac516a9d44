/* The reduced map: from one apex to the next with the leg placed in flight as if by itself, so that an apex
 * is the height and the speed of the centre of mass alone.
 *
 * The foot comes down with r = l0, rdot = 0, theta = theta0 - omega t, thetadot = -omega, at t after the
 * apex. Impact and stance are those of the full model, up to where the stance law loads the foot no more;
 * from there the centre of mass flies to the next apex, and what is left in the leg is lost. */
#ifndef TDMF_SLIP_REDUCED_MAP_H
#define TDMF_SLIP_REDUCED_MAP_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/orbit.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Coordinates of an apex, as in the section of the full model: its first two. */
enum {
    TDMF_REDUCED_COM_HEIGHT = TDMF_SECTION_COM_HEIGHT, /* y_c, m */
    TDMF_REDUCED_COM_SPEED = TDMF_SECTION_COM_SPEED,   /* m/s */
    TDMF_REDUCED_COUNT
};

/* The state at an apex above x = 0, with the leg at rest where it is to be placed, integrals zero. `apex` may
 * lie within `state`. */
TDMF_API void tdmf_reduced_state(const tdmf_model *model, const tdmf_inputs *inputs,
                                 const double apex[TDMF_REDUCED_COUNT], double state[TDMF_STATE_COUNT]);

/* What becomes of a stride. */
typedef enum {
    TDMF_REDUCED_CLOSED,     /* it has a next apex */
    TDMF_REDUCED_REFUSED,    /* a value is out of range, a pointer NULL, or too many changes are asked for */
    TDMF_REDUCED_FOOT_BELOW, /* at the apex the foot is not above the ground */
    TDMF_REDUCED_NO_TOUCHDOWN, /* the foot does not come down within the time allowed */
    TDMF_REDUCED_NO_STANCE,    /* the impact leaves the foot without load */
    TDMF_REDUCED_STUCK,        /* the foot stays on the ground for the time allowed */
    TDMF_REDUCED_NO_APEX,      /* the centre of mass does not rise at lift-off */
    TDMF_REDUCED_FELL,         /* the body or the leg is down */
    TDMF_REDUCED_UNSOLVED      /* the solver did not get through the stance */
} tdmf_reduced_outcome;

/* How the next apex and the stride change with something. */
typedef struct {
    double apex[TDMF_REDUCED_COUNT];        /* of the next apex */
    double period, length, work;            /* of the stride's quantities of these names */
    double stance_time, slip_distance;      /* of these, too */
    double peak_force, peak_vertical_force; /* and of these */
} tdmf_reduced_variation;

/* Directions of parameters and inputs along which a stride is differentiated, at the most. */
enum { TDMF_REDUCED_MAP_SEEDS = TDMF_VARIATION_LIMIT - TDMF_REDUCED_COUNT };

/* A stride; where it has not closed, all but the outcomes is zero. The derivatives are there if they were
 * asked for. The energy of the centre of mass changes by the work and the external work less the four losses.
 */
typedef struct {
    tdmf_reduced_outcome outcome;    /* whether it closed, and else why not */
    tdmf_outcome solver;             /* how the solver's call for the stance ended; else TDMF_ARRIVED */
    double apex[TDMF_REDUCED_COUNT]; /* the next */
    tdmf_stride stride;              /* its quantities; the work is that of the stance */
    double liftoff_angle;            /* theta at lift-off, rad */
    double external_work;            /* J, of the stride, as the losses */
    double damper_loss, friction_loss, impact_loss; /* J in the stride */
    double leg_loss; /* J, left in the leg at lift-off less what it is given for touchdown */
    tdmf_reduced_variation by_section[TDMF_REDUCED_COUNT];       /* by each coordinate of the start */
    tdmf_reduced_variation by_parameter[TDMF_REDUCED_MAP_SEEDS]; /* along each change that was given */
} tdmf_reduced_return;

/* One stride from an apex, whose flight down and whose stance take no longer than `until` each. With
 * `derivatives`, also how it changes with the two coordinates and along `count` directions of parameters and
 * inputs; they are not finite on the edge of an event, see tdmf_native_stride_varied. A log in the solver has
 * touchdown, the events of the stance, and the apex. */
TDMF_API tdmf_reduced_return tdmf_reduced_map(tdmf_solver *solver, const tdmf_model *model,
                                              const tdmf_inputs *inputs,
                                              const double apex[TDMF_REDUCED_COUNT], double until,
                                              bool derivatives, const tdmf_seed *seeds, int count);

/* A fixed point of the map, with its stride. Values other than the outcome are those of the last apex tried.
 */
typedef struct {
    tdmf_orbit_outcome outcome; /* of a guess whose stride does not close, `stride` says more */
    int iterations;             /* of Newton's method */
    double error; /* largest difference of the apex and the next, over the coordinates' scales */
    double apex[TDMF_REDUCED_COUNT]; /* the fixed point */
    tdmf_reduced_return stride;      /* from `apex`, with derivatives, also along the changes given */
} tdmf_reduced_orbit;

/* Newton's method from a guess, as tdmf_find_orbit; `count` changes, which may be 0. */
TDMF_API tdmf_reduced_orbit tdmf_find_reduced_orbit(tdmf_solver *solver, const tdmf_model *model,
                                                    const tdmf_inputs *inputs,
                                                    const double guess[TDMF_REDUCED_COUNT],
                                                    const tdmf_seed *seeds, int count);

/* Runs up to `strides` strides, as tdmf_settle. */
TDMF_API int tdmf_settle_reduced(tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs,
                                 int strides, double apex[TDMF_REDUCED_COUNT]);

/* An outcome in words. */
TDMF_API const char *tdmf_reduced_outcome_text(tdmf_reduced_outcome outcome);

#ifdef __cplusplus
}
#endif
#endif
