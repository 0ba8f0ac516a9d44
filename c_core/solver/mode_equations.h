/* What moves in one contact mode, and all that is constant in its equations. */
#ifndef TDMF_SOLVER_MODE_EQUATIONS_H
#define TDMF_SOLVER_MODE_EQUATIONS_H

#include "coordinate_laws.h"
#include "free_fall_laws.h"
#include "hip_law.h"
#include "leg.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

/* Coordinates of a runner at an instant, as its mode needs them. */
typedef struct {
    tdmf_flying flying;     /* flight: the leg; the centre of mass follows from time alone */
    tdmf_standing standing; /* on the ground, in its own axes */
    double angle;           /* on the ground: theta */
    double work, damper_loss, friction_loss;
    /* Where inputs ramp: the work of the leg, and what the external work falls short of the force now by the
     * body's way since the equations were opened. */
    double leg_work, shortfall;
} tdmf_mode_coordinates;

/* The equations of one mode from one instant on. */
typedef struct {
    const tdmf_model *model;
    tdmf_inputs inputs; /* when they were opened */
    tdmf_contact_mode contact;
    tdmf_ground_line ground; /* in force */
    bool ground_waits;       /* flight: one that has been set waits to be in force */
    tdmf_ground_line new_ground;
    tdmf_mode_coordinates start;
    tdmf_hip_law law; /* of flight or stance; in graze the torque from outside alone */
    /* Laws in guards: where clamped the servo, whose sign decides the clamp; in graze servo and stance law.
     */
    tdmf_hip_law servo, stance_law;
    bool clamped;                                 /* off the ground: a negative servo torque becomes 0 */
    double friction, friction_rate;               /* in slip, with the sign of the foot's velocity */
    double static_friction, static_friction_rate; /* of a foot at rest; on a border, to slip forward */
    bool meets_border; /* of a patch: one that slips has it ahead, one at rest stands on it */
    double border;     /* in slip: where it is along the line */
    double backward_friction, backward_friction_rate; /* at rest on it: to slip backward */
    bool falls;                                       /* slip: friction falls with speed, */
    double friction_excess, friction_fading;          /* so */
    double rest_length, rest_length_rate;             /* of the leg */
    bool awaits_thrust;            /* contact: its greatest compression is an event to come */
    tdmf_vector push, push_rate;   /* of the body by the external force */
    bool is_forced;                /* pushed, or inputs ramp that push or lengthen the leg */
    tdmf_point opened_body;        /* where forced: the body, when the equations were opened */
    tdmf_point com;                /* flight: the centre of mass at the start */
    double place_time, place_rate; /* time since place began, and 1 in place, else 0 */
    double winding;                /* on the ground: theta less the angle that the place of the body gives */
    double positive_work, external_work;
    bool drifts; /* its laws change with time, or have changed since it was opened */
} tdmf_mode_equations;

/* The equations of a mode at an instant. */
void tdmf_open_mode(tdmf_mode_equations *equations, tdmf_system system, const tdmf_inputs *rates,
                    const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                    tdmf_leg_direction direction);

/* Goes on from the coordinates reached after `elapsed`. */
void tdmf_shift_mode(tdmf_mode_equations *equations, double elapsed, const tdmf_mode_coordinates *reached);

/* The ground's friction has fallen to zero and stays there; a patch keeps its own. */
void tdmf_end_friction(tdmf_mode_equations *equations);

/* The state that coordinates after `elapsed` stand for; the positive work is the equations'. Returns
 * the leg's direction. */
tdmf_leg_direction tdmf_state_in_mode(const tdmf_mode_equations *equations, double elapsed,
                                      const tdmf_mode_coordinates *coordinates,
                                      double state[TDMF_STATE_COUNT]);

#endif
