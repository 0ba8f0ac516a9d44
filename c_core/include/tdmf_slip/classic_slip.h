/* The classic spring-loaded inverted pendulum: a point mass on a massless spring leg, with and without
 * friction (sections 2 and 3 of the paper), on level ground and on a slope. Its leg is put to the touchdown
 * angle in flight at no cost, and may retract from there: t after the apex it is at theta0 - omega t.
 *
 * An apex is where the mass rises no more. Its height is that above the ground vertically below, and its
 * energy m (v^2/2 + g times this height) counts from there, too. The energy of the motion is conserved while
 * the foot holds, so that on level ground the return map from apex to apex is a scalar map of heights. On a
 * slope the ground below the next apex is higher or lower, and the energy above it is less by m g L
 * tan(sigma), L being the length of the step: positive for every step that flies. So the map of height and
 * energy has fixed points on level ground alone; up a slope the runner loses of this energy with every step,
 * down a slope it gains. What there is on a slope are fixed points of the map of heights at one energy: gaits
 * of a runner to which something gives back at each apex, as speed, what the step has cost it, or takes what
 * it has gained. */
#ifndef TDMF_SLIP_CLASSIC_SLIP_H
#define TDMF_SLIP_CLASSIC_SLIP_H

#include "tdmf_slip/export.h"

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* SI units, angles in rad. */
typedef struct {
    double mass;            /* m, kg */
    double stiffness;       /* k, N/m */
    double free_length;     /* l0, m */
    double gravity;         /* g, m/s2 */
    double touchdown_angle; /* theta0, at the apex, from the vertical, below pi/2 in size: above 0 the foot is
                               ahead of the body. A leg that would lengthen from touchdown on takes off at
                               once, downwards, and falls */
    double friction;        /* mu; INFINITY for a foot that never slips */
    double ground_slope;    /* sigma, rad, between -1 and 1, positive where the ground rises */
    double retraction_rate; /* omega, rad/s, from the apex on; positive turns the foot back */
} tdmf_classic;

/* The paper's: 80 kg, 20 kN/m, 1 m, 9.81 m/s2, 40 degrees, no slip, level ground, no retraction. */
TDMF_API tdmf_classic tdmf_classic_default(void);

/* How a step ends. */
typedef enum {
    TDMF_CLASSIC_FLIES,     /* to the next apex */
    TDMF_CLASSIC_NO_START,  /* parameters out of range, the foot not above the ground at the apex, or the
                               energy too small for it */
    TDMF_CLASSIC_SLIDES,    /* the leg is outside the friction cone at touchdown, or leaves it where it turns
                               back: the foot slides out forwards, the mass falls */
    TDMF_CLASSIC_FALLS,     /* the mass reaches the ground before the foot does, in stance or before the next
                               apex, or takes off moving downwards */
    TDMF_CLASSIC_TURNS_BACK /* it flies, but backwards, and falls at the next step */
} tdmf_classic_outcome;

/* The mass seen from the foot, m, and its velocity, m/s. */
typedef struct {
    double x, y;   /* m */
    double vx, vy; /* m/s */
} tdmf_classic_point;

/* How the next apex and the length of the step change with something, per unit of it. */
typedef struct {
    double height; /* of the next height, m */
    double energy; /* of the next energy, J */
    double length; /* of the step, m */
} tdmf_classic_variation;

/* One step. From the next apex on, values are there if it flies or turns back. Its changes are exact where
 * the foot does not slip. */
typedef struct {
    tdmf_classic_outcome outcome;           /* how it ends */
    tdmf_classic_point touchdown, take_off; /* first and last of the stance */
    double stance_time;                     /* s */
    bool early_take_off;    /* the leg reached -arctan mu: the energy left in the spring is lost */
    double stance_friction; /* mu needed in stance: the largest tan of the leg's angle from the ground's
                               normal (3) */
    double impact_friction; /* mu needed at the impact of an infinitesimal foot mass (5) */
    double length;          /* from apex to apex, horizontally, m */
    double next_height;     /* of the next apex, m */
    double next_speed;      /* m/s, negative backwards */
    double next_energy;     /* J */
    tdmf_classic_variation by_height; /* at the same energy; its own is the slope of the map of heights */
    tdmf_classic_variation by_energy; /* at the same height */
    tdmf_classic_variation by_touchdown_angle; /* theta0, as the following */
    tdmf_classic_variation by_ground_slope;    /* sigma, at the same height and energy above the ground */
    tdmf_classic_variation by_retraction_rate; /* omega */
} tdmf_classic_step;

/* The return map at an energy, J, from an apex of a height, m, running forwards; both above the ground. */
TDMF_API tdmf_classic_step tdmf_classic_return_map(const tdmf_classic *slip, double energy, double height);

/* The mass a time after touchdown of such a step, while the foot holds. */
TDMF_API tdmf_classic_point tdmf_classic_stance(const tdmf_classic *slip, double energy, double height,
                                                double time);

/* The height of a gait near a guess that repeats its height at one energy, by Newton's method; false if none
 * is found. On level ground it is periodic. */
TDMF_API bool tdmf_classic_fixed_point(const tdmf_classic *slip, double energy, double guess, double *height);

/* The touchdown angle and height at which two gaits meet and vanish (slope 1), by Newton's method from a
 * guess in *angle and *height; false if it isn't found. */
TDMF_API bool tdmf_classic_fold(const tdmf_classic *slip, double energy, double *angle, double *height);

#ifdef __cplusplus
}
#endif
#endif
