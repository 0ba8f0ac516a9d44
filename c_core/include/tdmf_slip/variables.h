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
        double thrust; /* Length that the leg gains from its greatest compression to the end of the stance,
                          epsilon, m */
    } leg;
    double gravity; /* Acceleration of gravity, g, m/s2 */
    struct {
        double static_friction_ratio; /* Friction of a foot at rest over that of one that slips, rho */
        double stribeck_velocity; /* Speed over which friction falls from that of a foot at rest to that of
                                     one that slips, v_s: at least 1e-11 l0 sqrt(k/m); 0: at once, m/s */
        double patch_begin;    /* Where a patch of ground with a friction of its own begins, horizontally; no
                                  patch where it is the end, m */
        double patch_end;      /* Where the patch ends, no less than where it begins, m */
        double patch_friction; /* Coefficient of friction of foot and patch, mu_p */
    } ground;
    struct {
        double stance_torque;        /* Torque that drives the first half of a stance, tau0, N.m */
        double touchdown_angle;      /* Leg angle that the leg is placed at before touchdown, theta0, rad */
        double kp;                   /* Proportional gain of the hip in flight, N.m/rad */
        double kd;                   /* Derivative gain of the hip in flight, N.m.s/rad */
        double liftoff_angle_factor; /* Leg angle aimed at after lift-off, over the angle at lift-off, eta */
        double retraction_rate;      /* Rate at which the leg is retracted before it lands: in place the angle
                                        aimed at falls so fast from theta0 on, rad/s */
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
        double extension; /* Length added to the leg at rest, m */
    } leg;
    struct {
        double external_fx; /* Horizontal force from outside on the body, N */
        double external_fy; /* Vertical force from outside on the body, N */
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
    TDMF_HIP_PLACE_TIME,  /* In place, the time since it began; else 0, s */
    TDMF_LEG_WORK,        /* Work of the leg by thrust and extension since the start, J */
    TDMF_ENERGY_DAMPER_LOSS,   /* Energy lost in the damper since the start, J */
    TDMF_ENERGY_FRICTION_LOSS, /* Energy lost to sliding friction since the start, J */
    TDMF_HIP_POSITIVE_WORK,    /* Work of the hip at positive power since the start, J */
    TDMF_ENERGY_EXTERNAL_WORK, /* Work of the forces from outside on the body since the start, J */
    TDMF_STATE_COUNT
};

/* Each guard is a pure number, positive while its event is to come; at zero or below, the event is due. A
 * guard that the present mode does not watch is 1. Every armed guard carries a margin of TDMF_GUARD_MARGIN,
 * so that it is positive even where its event has just happened; that of the apex, which cannot happen
 * twice, a thousandth of it. */
typedef enum {
    TDMF_GUARD_TOUCHDOWN,            /* the foot's height in flight */
    TDMF_GUARD_APEX,                 /* vertical velocity of the rising centre of mass, off the ground */
    TDMF_GUARD_CLAMP,                /* the clamp of the hip torque opens or closes */
    TDMF_GUARD_LIFT_OFF,             /* ground force across the ground in contact */
    TDMF_GUARD_SLIP_ONSET_POSITIVE,  /* distance to the friction cone's edge, foot to slip forward */
    TDMF_GUARD_SLIP_ONSET_NEGATIVE,  /* distance to the friction cone's edge, foot to slip backward */
    TDMF_GUARD_SLIP_VELOCITY_ZERO,   /* speed in the direction of slip */
    TDMF_GUARD_MID_STANCE,           /* the leg angle until mid-stance */
    TDMF_GUARD_FORCE_PEAK,           /* rate of the ground force across the ground, up or down */
    TDMF_GUARD_GRAZE_TO_CONTACT,     /* the stance law lifts the grazing foot no more */
    TDMF_GUARD_GRAZE_TO_FLIGHT,      /* the flight law presses the grazing foot down no more */
    TDMF_GUARD_BODY_DOWN,            /* the body's height */
    TDMF_GUARD_LEG_TOO_SHORT,        /* leg length above its minimum */
    TDMF_GUARD_GREATEST_COMPRESSION, /* the leg is compressed further, and is to be extended by its thrust
                                        after that */
    TDMF_GUARD_NEW_GROUND,           /* how far the foot is below a ground that waits to be in force */
    TDMF_GUARD_VERTICAL_FORCE_PEAK,  /* on a slope, rate of the vertical ground force, up or down */
    TDMF_GUARD_PATCH_BORDER, /* how far the slipping foot is from the border of the patch ahead of it */
    TDMF_GUARD_COUNT
} tdmf_guard;

#endif
