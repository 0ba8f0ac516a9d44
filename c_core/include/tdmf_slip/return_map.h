/* Strides from one apex to the next, their exact derivatives, and periodic gaits.
 *
 * A gait is a fixed point of the return map: the next apex is the one where the stride began. It is stable if
 * all eigenvalues of the map's Jacobian are smaller than 1, see eigenvalues.h.
 *
 *     tdmf_solver solver = tdmf_solver_default();
 *     const tdmf_stride_request request = {.solver = &solver, .system = system, .apex = apex};
 *     tdmf_orbit gait;
 *     tdmf_find_orbit(&request, &gait);
 *     if (gait.outcome == TDMF_ORBIT_FOUND)
 *         printf("%s at %g m/s\n", gait.stride.stride.word, gait.stride.stride.speed);
 */
#ifndef TDMF_SLIP_RETURN_MAP_H
#define TDMF_SLIP_RETURN_MAP_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/solver.h"
#include "tdmf_slip/stride.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Coordinates of the apex section, where the centre of mass is highest: its height above the ground and its
 * speed, and the leg. */
enum {
    TDMF_SECTION_COM_HEIGHT,      /* m, above the ground vertically below */
    TDMF_SECTION_COM_SPEED,       /* m/s */
    TDMF_SECTION_LEG_LENGTH,      /* r, m */
    TDMF_SECTION_LEG_ANGLE,       /* theta, rad */
    TDMF_SECTION_LEG_LENGTH_RATE, /* m/s */
    TDMF_SECTION_LEG_ANGLE_RATE,  /* rad/s */
    TDMF_SECTION_COUNT
};

/* An apex of the reduced map has the first two of these coordinates. */
enum { TDMF_REDUCED_COUNT = +TDMF_SECTION_COM_SPEED + 1 };

/* Writes the state at an apex with the foot at x = 0 over the ground that the inputs set, integrals zero.
 * `section` may lie within `state`. */
TDMF_API void tdmf_section_state(tdmf_system system, const double section[TDMF_SECTION_COUNT],
                                 double state[TDMF_STATE_COUNT]);

/* Writes the state at an apex of the reduced map, at x = 0, with the leg at rest where it is to be placed,
 * integrals zero. `apex` may lie within `state`. */
TDMF_API void tdmf_reduced_state(tdmf_system system, const double apex[TDMF_REDUCED_COUNT],
                                 double state[TDMF_STATE_COUNT]);

/* Writes the coordinates of a state at an apex over a ground: the inverse of tdmf_section_state. `section`
 * may lie within `state`. */
TDMF_API void tdmf_section_of_state(const tdmf_model *model, const tdmf_ground_line *ground,
                                    const double state[TDMF_STATE_COUNT], double section[TDMF_SECTION_COUNT]);

/* Writes scales of the coordinates: l0, l0 sqrt(k/m), l0, 1 rad, l0 sqrt(k/m), sqrt(k/m). */
TDMF_API void tdmf_section_scales(const tdmf_model *model, double scales[TDMF_SECTION_COUNT]);

/* ---- one stride ---------------------------------------------------------------------------------------- */

/* The map that takes a runner from apex to apex. */
typedef enum {
    TDMF_RETURN_MAP, /* the runner's own motion */
    /* The leg is placed ideally in flight, so that an apex has two coordinates. The foot comes down with
     * r = l0, rdot = 0, theta = theta0 - omega t, thetadot = -omega, at t after the apex. Impact and stance
     * are those of the runner, until the stance law no longer loads the foot. From there the centre of mass
     * flies to the next apex, and the energy left in the leg is lost. hip.kp, hip.kd,
     * hip.liftoff_angle_factor and hip.swing_clamp have no effect, because they only move the leg in flight.
     */
    TDMF_REDUCED_MAP
} tdmf_apex_map;

/* The largest numbers of seeds along which a stride is differentiated. With a place of the foot it is one
 * less. Unary plus makes an int: C++20 deprecates arithmetic between two enumerations. */
enum {
    TDMF_RETURN_MAP_SEEDS = +TDMF_VARIATION_LIMIT - TDMF_SECTION_COUNT, /* seeds of the return map */
    TDMF_REDUCED_MAP_SEEDS = +TDMF_VARIATION_LIMIT - TDMF_REDUCED_COUNT /* seeds of the reduced map */
};

/* A request for a stride, a gait or many strides. Set `solver`, `system` and `apex`, and zero what you do not
 * need. */
typedef struct {
    tdmf_solver *solver; /* tolerance and limits; it counts the work and logs the events */
    tdmf_system system;  /* the runner, and its inputs, which are held */
    tdmf_apex_map map;   /* the return map, unless you set it */
    const double *apex; /* coordinates of the apex where the stride begins: TDMF_SECTION_COUNT numbers, of the
                           reduced map TDMF_REDUCED_COUNT */
    const double *foot_x; /* m, where the foot is; NULL: at x = 0, and the ground has no patch. With a place
                             the stride is also differentiated by it, after the seeds */
    double until;         /* s, that the stride may take, of the reduced map each of flight and stance; 0: 1e4
                             sqrt(m/k) */
    bool derivatives;     /* differentiate by the apex's coordinates and along the seeds */
    bool measures;        /* measure the stride, see tdmf_stride_measures; not by the reduced map */
    const tdmf_seed *seeds; /* directions of parameters and inputs */
    int seed_count;         /* how many */
} tdmf_stride_request;

/* Quantities of a stride that are measured on request; also how they change. */
typedef struct {
    double positive_hip_work;      /* J, done at positive power: the record's positive_work */
    double positive_leg_work;      /* J, of the jumps of the leg's rest length that do any */
    double squared_torque;         /* integral of tau^2, N^2 m^2 s */
    double friction_loss;          /* J */
    double greatest_slip_velocity; /* m/s, of the foot along the ground, whichever way it slips */
    double greatest_foot_height;   /* m, in flight, above the ground vertically below */
} tdmf_stride_measures;

/* Derivatives along a direction. */
typedef struct {
    double apex[TDMF_SECTION_COUNT];        /* derivatives of the coordinates of the next apex */
    double period, length, work;            /* derivatives of the stride's quantities with these names */
    double stance_time, slip_distance;      /* of these, too */
    double peak_force, peak_vertical_force; /* and of these */
    double foot_clearance;         /* derivative of the foot's height at the beginning of the stride */
    double foot_x;                 /* derivative of the foot's position at the next apex */
    tdmf_stride_measures measures; /* derivatives of the measures, if requested */
} tdmf_stride_variation;

/* Outcome of a stride. */
typedef enum {
    TDMF_RETURN_CLOSED,       /* it has a next apex */
    TDMF_RETURN_REFUSED,      /* the request was refused: see `refusal` */
    TDMF_RETURN_NO_START,     /* the start is no apex: in flight, above the ground */
    TDMF_RETURN_NO_TOUCHDOWN, /* reduced: the foot does not come down within the time allowed */
    TDMF_RETURN_NO_STANCE,    /* reduced: the impact leaves the foot without load */
    TDMF_RETURN_TOO_LONG,     /* the stride, reduced: the stance, takes longer than the time allowed */
    TDMF_RETURN_NO_APEX,      /* reduced: the centre of mass does not rise at lift-off */
    TDMF_RETURN_FELL,         /* the body or the leg is down */
    TDMF_RETURN_UNSOLVED      /* the solver could not follow the runner: see `solver` */
} tdmf_return_outcome;

/* A stride. If it did not close, everything but the outcomes, the refusal and foot_clearance is zero. The
 * energy of the centre of mass changes by the work and the external work, less the losses. */
typedef struct {
    tdmf_return_outcome outcome;     /* whether the stride closed, and else why not */
    tdmf_outcome solver;             /* how the solver's call ended; TDMF_ARRIVED if there was none */
    tdmf_refusal refusal;            /* which value was refused, of the request or of the start */
    double apex[TDMF_SECTION_COUNT]; /* the next apex; of the reduced map the first two coordinates */
    tdmf_stride stride;              /* quantities; of the reduced map the work is that of the stance */
    double liftoff_angle;            /* theta_LO of the stride, rad */
    double external_work;            /* work of the external forces, J */
    double damper_loss, friction_loss, impact_loss; /* energy lost in the stride, J */
    double leg_loss; /* reduced: energy left in the leg at lift-off, less what it gets for touchdown, J */
    double foot_x;   /* place of the foot at the next apex, m */
    double foot_clearance; /* height of the foot above the ground at the apex where the stride begins, m */
    tdmf_stride_measures measures; /* if they were asked for */
    /* If derivatives were asked for: by the coordinates of the start, six or, in the reduced map, two, then
     * along the seeds, then by foot_x if it was given. */
    tdmf_stride_variation variations[TDMF_VARIATION_LIMIT];
} tdmf_return;

/* Makes one stride from an apex.
 *
 * Derivatives also limit the steps. They are not finite where none exists: where an event is a touch or two
 * events coincide, and along a gain if both gains are zero and hip.swing_clamp is true.
 *
 * A log in the solver of a reduced stride has the touchdown, the events of the stance, and the apex. */
TDMF_API void tdmf_run_stride(const tdmf_stride_request *request, tdmf_return *result);

/* Returns an outcome in words, a static string. */
TDMF_API const char *tdmf_return_outcome_text(tdmf_return_outcome outcome);

/* ---- gaits --------------------------------------------------------------------------------------------- */

/* Outcome of a search for a gait. */
typedef enum {
    TDMF_ORBIT_FOUND,     /* a gait */
    TDMF_ORBIT_NOT_FOUND, /* Newton's method did not converge: no gait near the guess */
    TDMF_ORBIT_FELL,      /* the runner falls from the guess */
    TDMF_ORBIT_NO_START,  /* the guess is no apex: below the ground, or refused, as is what is asked for */
    TDMF_ORBIT_UNSOLVED,  /* the solver could not follow the runner: see stride.solver */
    TDMF_ORBIT_NO_STRIDE  /* no stride closes from the guess within 1e4 sqrt(m/k), as where it stands still */
} tdmf_orbit_outcome;

/* A gait and its stride. Values other than the outcome are those of the last apex tried. */
typedef struct {
    tdmf_orbit_outcome outcome;      /* outcome of the search */
    int iterations;                  /* iterations of Newton's method */
    double error;                    /* largest difference of the apex and the next, over the scales */
    double apex[TDMF_SECTION_COUNT]; /* the gait's; of the reduced map the first two coordinates */
    tdmf_return stride;              /* stride from `apex`, with derivatives */
} tdmf_orbit;

/* Finds a gait, stable or not, by Newton's method from request->apex, down to rounding: if the solver's
 * tolerance is as tight, the next apex is within 1e-11 of the scales; so is the gait, unless I - J is nearly
 * singular, as at a fold. Iterations that make the error larger are shortened. The stride always has
 * derivatives; `until`, `foot_x` and `measures` are not used. */
TDMF_API void tdmf_find_orbit(const tdmf_stride_request *request, tdmf_orbit *orbit);

/* Makes up to `strides` strides from request->apex and writes the last apex, which may be where the request
 * has its own. Returns how many strides closed: fewer where one does not, and tdmf_run_stride from there says
 * why; 0 for a number below 0 or a NULL. */
TDMF_API int tdmf_settle(const tdmf_stride_request *request, int strides, double *apex);

#ifdef __cplusplus
}
#endif
#endif
