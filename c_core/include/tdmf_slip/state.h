/* The continuous state of a run and its discrete companion, the mode. */
#ifndef TDMF_SLIP_STATE_H
#define TDMF_SLIP_STATE_H

#include "tdmf_slip/export.h"

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Indices into a state vector of TDMF_STATE_COUNT doubles. The first eight are q and its rate, in the order
 * of the paper's q = (x, y, r, theta); the rest are integrals along the run and a clock. */
enum {
    TDMF_FOOT_X,             /* x, m */
    TDMF_FOOT_Y,             /* y, m */
    TDMF_LEG_LENGTH,         /* r, m */
    TDMF_LEG_ANGLE,          /* theta, rad from the vertical, positive with the foot ahead of the body; never
                                wrapped: the hip unwinds a leg that has wound. After a thousand turns an angle
                                is known to 1e-12, and so is all that follows from it */
    TDMF_FOOT_VX,            /* m/s */
    TDMF_FOOT_VY,            /* m/s */
    TDMF_LEG_LENGTH_RATE,    /* m/s */
    TDMF_LEG_ANGLE_RATE,     /* rad/s */
    TDMF_HIP_WORK,           /* integral of the total torque's power, J */
    TDMF_HIP_PLACE_TIME,     /* in place, the time since it began, s */
    TDMF_LEG_WORK,           /* work of the leg by changes of its rest length, J */
    TDMF_ENERGY_DAMPER_LOSS, /* J */
    TDMF_ENERGY_FRICTION_LOSS, /* J */
    TDMF_HIP_POSITIVE_WORK,    /* the part of the hip's work done at positive power, J */
    TDMF_ENERGY_EXTERNAL_WORK, /* work of the external forces on the body, J */
    TDMF_STATE_COUNT,
    TDMF_MECHANICAL_COUNT = TDMF_HIP_WORK,
    TDMF_VARIED_COUNT = TDMF_LEG_WORK + 1 /* what first variations have of them */
};

/* What the foot does; the numbers are those of `contact.mode` in the unit. */
typedef enum {
    TDMF_CONTACT_FLIGHT = 1,    /* it is off the ground */
    TDMF_CONTACT_STICK,         /* it is loaded and at rest */
    TDMF_CONTACT_SLIP_POSITIVE, /* it is loaded and slides forward, x grows */
    TDMF_CONTACT_SLIP_NEGATIVE, /* it is loaded and slides backward */
    TDMF_CONTACT_GRAZE          /* the foot rests on the ground without force, held there by the hip */
} tdmf_contact_mode;

/* Which part of the hip's control law is in force; the numbers are those of `hip.phase` in the unit. */
typedef enum {
    TDMF_PHASE_DRIVE = 1, /* touchdown to mid-stance: torque -tau0 */
    TDMF_PHASE_COAST,     /* the rest of the stance: no torque */
    TDMF_PHASE_RETRACT,   /* off the ground, centre of mass rising */
    TDMF_PHASE_PLACE      /* off the ground, from the apex on */
} tdmf_hip_phase;

/* The ground: the line y = height + x tan(slope). */
typedef struct {
    double height, slope; /* m, rad */
    double sine, cosine;  /* of the slope */
} tdmf_ground_line;

/* Everything discrete that the motion depends on. */
typedef struct {
    tdmf_contact_mode contact; /* what the foot does */
    tdmf_hip_phase phase;      /* what the hip does */
    double liftoff_angle;      /* theta_LO, rad */
    bool mid_stance_pending;   /* this stance began with theta >= 0 and has not passed upright yet; one that
                                  begins upright, with theta falling, has */
    bool clamp_closed;         /* flight, retract: the clamp in (12) holds the torque at 0; false in place and
                                  in contact */
    bool ground_force_rising;  /* contact: f_n grows; it peaks when this turns false */
    bool vertical_force_rising; /* the same of the vertical force, another on a slope */
    bool thrusts;               /* the leg has been compressed most in this stance: its thrust is on */
    bool rises;                 /* off the ground: an apex is to come */
    double rest_length;         /* m, of the leg, up to which leg.work is accounted for */
    tdmf_ground_line ground;    /* in force */
    bool fallen;                /* the run is over and the motion frozen */
} tdmf_mode;

/* The line y = height + x tan(slope). */
TDMF_API tdmf_ground_line tdmf_ground_line_of(double height, double slope);

/* Foot on the ground and loaded: stick or slip. */
TDMF_API bool tdmf_in_contact(const tdmf_mode *mode);

/* +1 or -1 in a slip mode, the sign of the foot's velocity; 0 in every other mode. */
TDMF_API double tdmf_slip_sign(const tdmf_mode *mode);

/* The apex of the default parameters' periodic gait at friction 0.6, integrals zero. */
TDMF_API void tdmf_default_state(double state[TDMF_STATE_COUNT]);

#ifdef __cplusplus
}
#endif
#endif
