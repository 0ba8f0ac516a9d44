/* Parameters, inputs, states and guards. Derived from c_core/pages by scripts/derive_equations: edit the
 * pages, not this. */
#ifndef TDMF_SLIP_VARIABLES_H
#define TDMF_SLIP_VARIABLES_H

#include <stdbool.h>

/* SI units, angles in rad. A member's path is the variable's name in the FMU: `leg.stiffness`. The defaults
 * are Table 1 of the paper with m = k = l0 = 1. */
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
        double min_length;  /* Leg length below which the runner falls, m */
        double thrust; /* Thrust: increase of the rest length from greatest compression to lift-off, epsilon,
                          m */
    } leg;
    double gravity; /* Acceleration of gravity, g, m/s2 */
    struct {
        double static_friction_ratio; /* Static over kinetic friction coefficient, rho */
        double stribeck_velocity;     /* Stribeck velocity: scale of the slip speed over which friction falls,
                                         v_s; 0 for none, m/s */
        double patch_begin;           /* Position where the patch begins, m */
        double patch_end;             /* Position where the patch ends; ground.patch_begin for no patch, m */
        double patch_friction;        /* Friction coefficient on the patch, mu_p */
    } ground;
    struct {
        double stance_torque;   /* Hip torque in the first half of a stance, tau0, N.m */
        double touchdown_angle; /* Touchdown angle: target of the leg angle before touchdown, theta0, rad */
        double kp;              /* Proportional gain of the hip in flight, N.m/rad */
        double kd;              /* Derivative gain of the hip in flight, N.m.s/rad */
        double liftoff_angle_factor; /* Target of the leg angle after lift-off, over the angle at lift-off,
                                        eta */
        double retraction_rate; /* Swing-leg retraction: rate at which the target angle falls after the apex,
                                   omega, rad/s */
        bool swing_clamp;       /* True if the torque that retracts the leg is clamped at 0 from below */
    } hip;
} tdmf_parameters;

/* Inputs, which may change during a run. Their rates, per second, have the same shape; the rate of an input
 * that is held is zero. Discrete inputs, such as ground.height, ground.slope and control, change at events
 * only: their rates are always zero. */
typedef struct {
    struct {
        double friction; /* Friction coefficient between foot and ground, mu */
        double height;   /* Height of the ground at x = 0, h, m */
        double slope;    /* Slope of the ground, positive uphill, sigma, rad */
    } ground;
    struct {
        double external_torque; /* Torque added to the hip law, N.m */
    } hip;
    struct {
        double extension; /* Change of the rest length of the leg, m */
    } leg;
    struct {
        double external_fx; /* Horizontal external force on the body, N */
        double external_fy; /* Vertical external force on the body, N */
    } body;
    struct {
        double touchdown_angle; /* Added to hip.touchdown_angle, rad */
        double stance_torque;   /* Added to hip.stance_torque, N.m */
        double thrust;          /* Added to leg.thrust, m */
    } control;
} tdmf_inputs;

/* Counts of the numbers among the parameters, which come first in their struct, of the inputs, and of the
 * settings: inputs and tunable parameters. */
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
    TDMF_LEG_WORK,        /* Work of thrust and leg extension since the start, J */
    TDMF_ENERGY_DAMPER_LOSS,   /* Energy lost in the damper since the start, J */
    TDMF_ENERGY_FRICTION_LOSS, /* Energy lost to sliding friction since the start, J */
    TDMF_HIP_POSITIVE_WORK,    /* Positive work of the hip since the start, J */
    TDMF_ENERGY_EXTERNAL_WORK, /* Work of external forces on the body since the start, J */
    TDMF_STATE_COUNT
};

/* Each guard is a pure number, positive while its event is to come; at zero or below, the event is due. A
 * guard that the present mode does not watch is 1. Every armed guard carries a margin of TDMF_GUARD_MARGIN,
 * so that it is positive even where its event has just happened. */
typedef enum {
    TDMF_GUARD_TOUCHDOWN, /* the foot reaches the ground */
    TDMF_GUARD_APEX,      /* a stride closes and place begins */
    TDMF_GUARD_CLAMP,     /* the clamp of the hip torque closes: it holds the retracting torque at 0 */
    TDMF_GUARD_LIFT_OFF, /* the normal force ends: flight if the flight law lifts the foot, too, else graze */
    TDMF_GUARD_SLIP_ONSET_POSITIVE, /* the push of the leg exceeds static friction, and the foot slips forward
                                     */
    TDMF_GUARD_SLIP_ONSET_NEGATIVE, /* the push of the leg exceeds static friction, and the foot slips
                                       backward */
    TDMF_GUARD_SLIP_VELOCITY_ZERO,  /* the slip velocity reaches 0: the foot sticks, or slips the other way */
    TDMF_GUARD_MID_STANCE,          /* drive ends where the leg is upright, once per stance */
    TDMF_GUARD_FORCE_PEAK,          /* rate of the normal force of a sticking or slipping foot */
    TDMF_GUARD_GRAZE_TO_CONTACT,    /* the stance law presses the foot on the ground again */
    TDMF_GUARD_GRAZE_TO_FLIGHT,     /* the flight law lifts the foot */
    TDMF_GUARD_BODY_DOWN,           /* the body reaches the ground */
    TDMF_GUARD_LEG_TOO_SHORT,       /* the leg is shorter than leg.min_length */
    TDMF_GUARD_GREATEST_COMPRESSION, /* thrust begins where the leg is shortest, once per stance */
    TDMF_GUARD_NEW_GROUND,           /* the foot is above the pending ground line, which comes into force */
    TDMF_GUARD_VERTICAL_FORCE_PEAK, /* rate of the vertical force of the ground on a sticking or slipping foot
                                     */
    TDMF_GUARD_PATCH_BORDER, /* the foot slips onto the next segment, whose line waits until the foot lifts
                                off */
    TDMF_GUARD_COUNT
} tdmf_guard;

#endif
