/* Parameters, inputs, states and guards, derived from modelDescription.xml by
 * scripts/generate_variables.py: edit that, not this. */
#ifndef TDMF_SLIP_VARIABLES_H
#define TDMF_SLIP_VARIABLES_H

#include <stdbool.h>

/* SI units, angles in rad. A member's path is the variable's name in the FMU: `leg.stiffness`. Ranges and
 * defaults (Table 1 of the paper with m = k = l0 = 1) come from modelDescription.xml. */
typedef struct {
    struct {
        double mass; /* Mass of the body, m, kg */
    } body;
    struct {
        double mass; /* Mass of the foot, m_f, kg */
    } foot;
    struct {
        double stiffness;   /* Stiffness of the leg spring, k, N/m */
        double damping;     /* Damping of the leg, c, N.s/m */
        double free_length; /* Length of the unloaded leg, l0, m */
        double min_length;  /* A leg shorter than this ends the run as a fall, m */
        double thrust; /* Thrust: length added to the rest length of the leg from its greatest compression to
                          the end of the stance, epsilon, m */
    } leg;
    double gravity; /* Acceleration of gravity, g, m/s2 */
    struct {
        double static_friction_ratio; /* Ratio of static to sliding friction, rho */
        double stribeck_velocity; /* Stribeck velocity: slip speed over which friction falls from its static
                                     to its sliding value, v_s; 0, or at least 1e-11 l0 sqrt(k/m), m/s */
        double patch_begin;       /* Horizontal position at which the patch begins; no patch if it equals
                                     ground.patch_end, m */
        double patch_end; /* Horizontal position at which the patch ends, at least ground.patch_begin, m */
        double patch_friction; /* Coefficient of friction of foot and patch, mu_p */
    } ground;
    struct {
        double stance_torque;        /* Hip torque in the first half of a stance, tau0, N.m */
        double touchdown_angle;      /* Touchdown angle: leg angle at which the hip places the leg before
                                        touchdown, theta0, rad */
        double kp;                   /* Proportional gain of the hip in flight, N.m/rad */
        double kd;                   /* Derivative gain of the hip in flight, N.m.s/rad */
        double liftoff_angle_factor; /* Reference leg angle after lift-off, relative to the leg angle at
                                        lift-off, eta */
        double retraction_rate; /* Swing-leg retraction: rate at which the reference leg angle decreases from
                                   theta0 in the phase place, omega, rad/s */
        bool swing_clamp; /* After lift-off, until the apex, the hip torque is never negative: it only stops
                             the leg's backward rotation */
    } hip;
} tdmf_parameters;

/* What may change during a run. Rates of inputs, per second, have the same shape; zero where they are held.
 * Discrete inputs, such as ground.height, ground.slope and control, change at events only: their rates are
 * always zero. */
typedef struct {
    struct {
        double friction; /* Coefficient of friction of foot and ground, mu */
        double height;   /* Height of the ground at x = 0, h, m */
        double slope;    /* Slope of the ground, positive uphill, sigma, rad */
    } ground;
    struct {
        double external_torque; /* Torque added to the hip law, N.m */
    } hip;
    struct {
        double extension; /* Length added to the rest length of the leg, m */
    } leg;
    struct {
        double external_fx; /* External horizontal force on the body, N */
        double external_fy; /* External vertical force on the body, N */
    } body;
    struct {
        double touchdown_angle; /* Added to hip.touchdown_angle, rad */
        double stance_torque;   /* Added to hip.stance_torque, N.m */
        double thrust;          /* Added to leg.thrust, m */
    } control;
} tdmf_inputs;

/* How many numbers there are among the parameters, which come first in their struct; how many inputs; and how
 * many settings: inputs and tunable parameters. */
enum { TDMF_PARAMETER_COUNT = 19, TDMF_INPUT_COUNT = 10, TDMF_SETTING_LIMIT = 17 };

/* Indices into a state vector of TDMF_STATE_COUNT doubles. The first eight are q and its rate, in the order
 * of the paper's q = (x, y, r, theta); the rest are integrals along the run and a clock. The leg's angle is
 * never wrapped: the hip unwinds a leg that has wound. After a thousand turns an angle is known to 1e-12,
 * and so is all that follows from it. */
enum {
    TDMF_FOOT_X,          /* Horizontal position of the foot, x, m */
    TDMF_FOOT_Y,          /* Height of the foot, y, m */
    TDMF_LEG_LENGTH,      /* Length of the leg, r, m */
    TDMF_LEG_ANGLE,       /* Angle of the leg from the vertical, positive with the foot ahead, theta, rad */
    TDMF_FOOT_VX,         /* Horizontal velocity of the foot, m/s */
    TDMF_FOOT_VY,         /* Vertical velocity of the foot, m/s */
    TDMF_LEG_LENGTH_RATE, /* Rate of the leg length, m/s */
    TDMF_LEG_ANGLE_RATE,  /* Rate of the leg angle, rad/s */
    TDMF_HIP_WORK,        /* Work of the total hip torque since the start, W, J */
    TDMF_HIP_PLACE_TIME,  /* Time since the phase place began; 0 in other phases, s */
    TDMF_LEG_WORK,        /* Work of the leg by thrust and extension since the start, J */
    TDMF_ENERGY_DAMPER_LOSS,   /* Energy lost in the damper since the start, J */
    TDMF_ENERGY_FRICTION_LOSS, /* Energy lost to sliding friction since the start, J */
    TDMF_HIP_POSITIVE_WORK,    /* Work of the hip at positive power since the start, J */
    TDMF_ENERGY_EXTERNAL_WORK, /* Work of the external forces on the body since the start, J */
    TDMF_STATE_COUNT
};

/* Each guard is a pure number, positive while its event is to come; at zero or below, the event is due. A
 * guard that the present mode does not watch is 1. Every armed guard carries a margin of TDMF_GUARD_MARGIN,
 * so that it is positive even where its event has just happened. */
typedef enum {
    TDMF_GUARD_TOUCHDOWN,            /* the foot's height in flight */
    TDMF_GUARD_APEX,                 /* vertical velocity of the rising centre of mass, off the ground */
    TDMF_GUARD_CLAMP,                /* the clamp of the hip torque opens or closes */
    TDMF_GUARD_LIFT_OFF,             /* normal force of the ground in contact */
    TDMF_GUARD_SLIP_ONSET_POSITIVE,  /* distance of the ground force from the edge of the friction cone at
                                        which the foot slips forward */
    TDMF_GUARD_SLIP_ONSET_NEGATIVE,  /* distance of the ground force from the edge of the friction cone at
                                        which the foot slips backward */
    TDMF_GUARD_SLIP_VELOCITY_ZERO,   /* speed in the direction of slip */
    TDMF_GUARD_MID_STANCE,           /* the leg angle until mid-stance */
    TDMF_GUARD_FORCE_PEAK,           /* rate of the normal force, with either sign */
    TDMF_GUARD_GRAZE_TO_CONTACT,     /* the stance law lifts the grazing foot no more */
    TDMF_GUARD_GRAZE_TO_FLIGHT,      /* the flight law presses the grazing foot down no more */
    TDMF_GUARD_BODY_DOWN,            /* the body's height */
    TDMF_GUARD_LEG_TOO_SHORT,        /* leg length above its minimum */
    TDMF_GUARD_GREATEST_COMPRESSION, /* the leg is compressed further, and is to be extended by its thrust
                                        after that */
    TDMF_GUARD_NEW_GROUND,           /* depth of the foot below a line of ground that waits to take effect */
    TDMF_GUARD_VERTICAL_FORCE_PEAK,  /* on a slope, rate of the vertical ground force, with either sign */
    TDMF_GUARD_PATCH_BORDER, /* distance of the slipping foot from the border of the patch ahead of it */
    TDMF_GUARD_COUNT
} tdmf_guard;

#endif
