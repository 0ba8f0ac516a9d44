/* The continuous state of a run and its discrete companion, the mode. */
#ifndef TDMF_SLIP_STATE_H
#define TDMF_SLIP_STATE_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/variables.h"

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Number of the mechanical states, from TDMF_FOOT_X on. */
enum { TDMF_MECHANICAL_COUNT = TDMF_LEG_ANGLE_RATE + 1 - TDMF_FOOT_X };

/* Contact mode of the foot; the numbers are those of `contact.mode` in the unit. */
typedef enum {
    TDMF_CONTACT_FLIGHT = 1,    /* off the ground */
    TDMF_CONTACT_STICK,         /* loaded, and at rest */
    TDMF_CONTACT_SLIP_POSITIVE, /* loaded, and sliding forward: x grows */
    TDMF_CONTACT_SLIP_NEGATIVE, /* loaded, and sliding backward */
    TDMF_CONTACT_GRAZE          /* at rest on the ground without force, held there by the hip */
} tdmf_contact_mode;

/* Part of the hip's control law that is in force; the numbers are those of `hip.phase` in the unit. */
typedef enum {
    TDMF_PHASE_DRIVE = 1, /* touchdown to mid-stance: torque -tau0 */
    TDMF_PHASE_COAST,     /* the rest of the stance: no torque */
    TDMF_PHASE_RETRACT,   /* off the ground, centre of mass rising */
    TDMF_PHASE_PLACE      /* off the ground, from the apex on */
} tdmf_hip_phase;

/* The ground below a slipping foot, which may have a patch with a friction of its own. */
typedef enum {
    TDMF_ZONE_BEFORE, /* before the patch, or there is none */
    TDMF_ZONE_PATCH,  /* on the patch */
    TDMF_ZONE_BEYOND  /* past its end */
} tdmf_zone;

/* The ground: the line y = height + x tan(slope). */
typedef struct {
    double height, slope; /* m, rad */
    double sine, cosine;  /* sine and cosine of the slope */
} tdmf_ground_line;

/* Everything discrete that the motion depends on. */
typedef struct {
    tdmf_contact_mode contact;  /* contact mode of the foot */
    tdmf_hip_phase phase;       /* phase of the hip's control law */
    tdmf_zone zone;             /* slip: what it slips on; changed by events only; else TDMF_ZONE_BEFORE */
    bool mid_stance_pending;    /* this stance began with theta >= 0 and has not passed upright yet; one that
                                   begins upright, with theta falling, has */
    bool clamp_closed;          /* flight, retract, with hip.swing_clamp: the clamp in (12) holds the torque
                                   at 0; false in place and in contact */
    bool ground_force_rising;   /* contact: f_n grows; it peaks when this turns false */
    bool vertical_force_rising; /* the same of the vertical force, another on a slope */
    bool thrusts;               /* the leg has been compressed most in this stance: its thrust is on */
    bool rises;                 /* off the ground: an apex is to come */
    double rest_length;         /* rest length of the leg up to which leg.work is accounted for, m */
    tdmf_ground_line ground;    /* ground in force */
    bool fallen;                /* the run is over and the motion frozen */
} tdmf_mode;

/* Returns the line y = height + x tan(slope); height in m, slope in rad. */
TDMF_API tdmf_ground_line tdmf_ground_line_of(double height, double slope);

/* Writes the apex of the default parameters' periodic gait at friction 0.6; other states are zero. */
TDMF_API void tdmf_default_state(double state[TDMF_STATE_COUNT]);

#ifdef __cplusplus
}
#endif
#endif
