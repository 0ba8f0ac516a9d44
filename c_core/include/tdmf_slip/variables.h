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

/* Indices of the states of a run, which are those of its page. TDMF_FOOT_X and the next seven are q and its
 * rate, in the order of the paper's q = (x, y, r, theta). Other states are integrals along the run, its last
 * stride and apex, and its memory. Some states repeat inputs, the mode, or q in other coordinates: each call
 * sets them anew. Times among the states count from the start of the run. The leg's angle is never wrapped:
 * the hip unwinds a leg that has wound. After a thousand turns an angle is known to 1e-12, and so is all that
 * follows from it. */
enum {
    TDMF_STRIDE_TIME,                   /* Time, s */
    TDMF_EVENT_COUNT,                   /* Changes of contact and phase since the start */
    TDMF_EVENT_LAST_TIME,               /* Time of the last change of contact or phase, s */
    TDMF_STRIDE_GREATEST_SLIP_VELOCITY, /* Largest slip velocity since the start, m/s */
    TDMF_STRIDE_GREATEST_FOOT_HEIGHT,   /* Largest height of the foot above the ground, in flight, since the
                                           start, m */
    TDMF_STRIDE_SQUARED_TORQUE,         /* Integral of the squared hip torque since the start, N2.m2.s */
    TDMF_STRIDE_IS_OPEN,                /* 1 if the open stride began at an apex, else 0 */
    TDMF_STRIDE_WORK_THEN,              /* Work of the hip at the start of the stride, J */
    TDMF_STRIDE_LEG_WORK_THEN,          /* Work of the leg at the start of the stride, J */
    TDMF_HIP_POSITIVE_WORK,             /* Positive work of the hip since the start, J */
    TDMF_STRIDE_POSITIVE_WORK_THEN,     /* Positive work of the hip at the start of the stride, J */
    TDMF_STRIDE_PEAK_FORCE_SO_FAR,      /* Largest normal force in the open stride, N */
    TDMF_STRIDE_VERTICAL_SO_FAR,        /* Largest vertical ground force in the open stride, N */
    TDMF_STRIDE_TOUCHDOWNS_SO_FAR,      /* Impacts in the open stride */
    TDMF_STRIDE_SLIP_SO_FAR,            /* Slip distance in the open stride before the present mode, m */
    TDMF_STRIDE_SLID_FROM,              /* Position of the foot at the last event, m */
    TDMF_STRIDE_STANCE_SO_FAR,          /* Time in contact in the open stride before the present mode, s */
    TDMF_STRIDE_WORD_SO_FAR,            /* Gait word of the open stride, in base 4 */
    TDMF_STRIDE_LAST_LETTER,            /* Last letter of the open stride's gait word */
    TDMF_STRIDE_BAR_IS_DUE,             /* 1 from touchdown until a contact mode lasts, else 0 */
    TDMF_STRIDE_MODE_BEGAN,             /* Time of the last event, s */
    TDMF_STRIDE_X_THEN,                 /* Position of the centre of mass at the start of the stride, m */
    TDMF_STRIDE_Y_THEN,                 /* Height of the centre of mass at the start of the stride, m */
    TDMF_STRIDE_COUNT,                  /* Number of completed strides */
    TDMF_STRIDE_WORD,                /* Gait word: + slip forward, 0 stick, - slip backward, | new stance */
    TDMF_STRIDE_PERIOD,              /* Period of the stride, T, s */
    TDMF_STRIDE_LENGTH,              /* Distance covered by the centre of mass in the stride, m */
    TDMF_STRIDE_RISE,                /* Height gained by the centre of mass in the stride, m */
    TDMF_STRIDE_WORK,                /* Net work of hip and leg in the stride, W, J */
    TDMF_STRIDE_HIP_WORK,            /* Net work of the hip in the stride, J */
    TDMF_STRIDE_LEG_WORK,            /* Net work of thrust and leg extension in the stride, J */
    TDMF_STRIDE_POSITIVE_WORK,       /* Positive work of the hip in the stride, J */
    TDMF_STRIDE_SPEED,               /* Average speed of the stride, V, m/s */
    TDMF_STRIDE_COST_OF_TRANSPORT,   /* Mechanical cost of transport of the stride, c_mt */
    TDMF_STRIDE_TOUCHDOWNS,          /* Impacts of the foot in the stride */
    TDMF_STRIDE_STANCE_TIME,         /* Time in contact in the stride, s */
    TDMF_STRIDE_DUTY_FACTOR,         /* Share of the stride in which the foot was in contact */
    TDMF_STRIDE_SLIP_DISTANCE,       /* Slip distance of the foot in the stride, m */
    TDMF_STRIDE_PEAK_FORCE,          /* Largest normal force in the stride, N */
    TDMF_STRIDE_PEAK_VERTICAL_FORCE, /* Largest vertical ground force in the stride, N */
    TDMF_APEX_TIME,                  /* Time of the last apex, s */
    TDMF_APEX_COM_HEIGHT,            /* Height of the centre of mass at the last apex, m */
    TDMF_APEX_COM_SPEED,             /* Speed of the centre of mass at the last apex, m/s */
    TDMF_APEX_LEG_LENGTH,            /* Leg length at the last apex, m */
    TDMF_APEX_LEG_ANGLE,             /* Leg angle at the last apex, rad */
    TDMF_APEX_LEG_LENGTH_RATE,       /* Rate of the leg length at the last apex, m/s */
    TDMF_APEX_LEG_ANGLE_RATE,        /* Rate of the leg angle at the last apex, rad/s */
    TDMF_GROUND_HEIGHT,              /* Height at x = 0 of the ground line in force, m */
    TDMF_GROUND_SLOPE,               /* Slope of the ground line in force, rad */
    TDMF_GROUND_SEGMENT,             /* Segment of the ground below the foot; a run starts before the first */
    TDMF_GROUND_SEGMENT_BEGIN,       /* Position where the segment begins, m */
    TDMF_GROUND_SEGMENT_END,         /* Position where the segment ends, m */
    TDMF_GROUND_SEGMENT_HEIGHT,      /* Height of the segment's line at x = 0, above ground.height, m */
    TDMF_GROUND_SEGMENT_SLOPE,       /* Slope of the segment's line, added to ground.slope, rad */
    TDMF_GROUND_FRICTION_AHEAD,      /* Friction that the foot would slip into, forward; see ground_segment */
    TDMF_GROUND_FRICTION_BEHIND,     /* Friction that the foot would slip into, backward */
    TDMF_LEG_EXTENSION,              /* Change of the rest length of the leg, m */
    TDMF_BODY_EXTERNAL_FX,           /* Horizontal external force on the body, N */
    TDMF_BODY_EXTERNAL_FY,           /* Vertical external force on the body, N */
    TDMF_FOOT_X,                     /* Horizontal position of the foot, x, m */
    TDMF_FOOT_Y,                     /* Height of the foot, y, m */
    TDMF_LEG_LENGTH,                 /* Length of the leg, r, m */
    TDMF_LEG_ANGLE,       /* Angle of the leg from the vertical, positive with the foot ahead, theta, rad */
    TDMF_FOOT_VX,         /* Horizontal velocity of the foot, m/s */
    TDMF_FOOT_VY,         /* Vertical velocity of the foot, m/s */
    TDMF_LEG_LENGTH_RATE, /* Rate of the leg length, m/s */
    TDMF_LEG_ANGLE_RATE,  /* Rate of the leg angle, rad/s */
    TDMF_LEG_COM_X,       /* Horizontal position of the centre of mass, m */
    TDMF_LEG_COM_Y,       /* Height of the centre of mass, m */
    TDMF_LEG_COM_VX,      /* Horizontal velocity of the centre of mass, m/s */
    TDMF_LEG_COM_VY,      /* Vertical velocity of the centre of mass, m/s */
    TDMF_LEG_MOMENTUM,    /* Angular momentum of the leg per reduced mass, r^2 thetadot, m2/s */
    TDMF_LEG_X,           /* Position of the body relative to the foot, along the ground, m */
    TDMF_LEG_Y,           /* Position of the body relative to the foot, normal to the ground, m */
    TDMF_LEG_VX,          /* Velocity of the body relative to the foot, along the ground, m/s */
    TDMF_LEG_VY,          /* Velocity of the body relative to the foot, normal to the ground, m/s */
    TDMF_LEG_FOOT_X,      /* Position of the foot along the ground, m */
    TDMF_LEG_FOOT_VX,     /* Velocity of the foot along the ground, m/s */
    TDMF_LEG_WINDING,     /* Leg angle less its principal value: a multiple of 2 pi, rad */
    TDMF_LEG_THRUSTING,   /* 1 from greatest compression to lift-off, else 0 */
    TDMF_LEG_WORK,        /* Work of thrust and leg extension since the start, J */
    TDMF_LEG_POSITIVE_LEG_WORK, /* Positive works of jumps of the rest length since the start, J */
    TDMF_ENERGY_EXTERNAL_WORK,  /* Work of external forces on the body since the start, J */
    TDMF_ENERGY_DAMPER_LOSS,    /* Energy lost in the damper since the start, J */
    TDMF_LEG_EXTENSION_RATE,    /* Rate at which `extension` is ramped, m/s */
    TDMF_LEG_EXTERNAL_FX_RATE,  /* Rate at which `external_fx` is ramped, N/s */
    TDMF_LEG_EXTERNAL_FY_RATE,  /* Rate at which `external_fy` is ramped, N/s */
    TDMF_GROUND_FRICTION,       /* Friction coefficient between foot and ground, mu */
    TDMF_GROUND_WAY,            /* Direction of slip, 1 or -1 */
    TDMF_ENERGY_FRICTION_LOSS,  /* Energy lost to sliding friction since the start, J */
    TDMF_ENERGY_IMPACT_LOSS,    /* Energy lost in impacts since the start, J */
    TDMF_GROUND_FRICTION_RATE,  /* Rate at which `friction` is ramped, 1/s */
    TDMF_HIP_EXTERNAL_TORQUE,   /* Torque added to the hip law, N.m */
    TDMF_HIP_LIFTOFF_ANGLE,     /* Leg angle when the foot last left the ground, theta_LO, rad */
    TDMF_HIP_DRIVING,           /* 1 from touchdown to mid-stance, else 0 */
    TDMF_HIP_SWING,             /* Law of the hip in flight: 0 rest, 1 retract, 2 place */
    TDMF_HIP_PLACE_TIME,        /* Time since the phase place began; 0 in other phases, s */
    TDMF_HIP_TOUCHDOWN_TIME,    /* Time of the last impact, s */
    TDMF_HIP_HAS_HOPPED,        /* 1 once the flight law has hardly lifted the foot at a lift-off, else 0 */
    TDMF_HIP_HOP_TIME,    /* Time of the last lift-off at which the flight law hardly lifted the foot, s */
    TDMF_HIP_WAS_PLACED,  /* 1 if the leg was being placed at the last impact, else 0 */
    TDMF_HIP_PLACED_FOR,  /* Time in place at the last impact, s */
    TDMF_HIP_RISES_AGAIN, /* 1 if an impact with immediate lift-off interrupted place, else 0 */
    TDMF_HIP_WORK,        /* Work of the total hip torque since the start, W, J */
    TDMF_HIP_EXTERNAL_TORQUE_RATE, /* Rate at which `external_torque` is ramped, N.m/s */
    TDMF_STATUS_FALLEN,            /* True after a fall, which freezes the motion */
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
