/* The classic spring-loaded inverted pendulum: a point mass on a massless spring leg, with and without
 * friction (sections 2 and 3 of the paper). Its leg is put to the touchdown angle in flight at no cost.
 *
 * Energy is conserved while the foot holds, so that the return map from apex to apex is a scalar map of
 * heights. */
#ifndef TDMF_SLIP_CLASSIC_SLIP_H
#define TDMF_SLIP_CLASSIC_SLIP_H

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
    double touchdown_angle; /* theta0, between 0 and pi/2: foot ahead of the body */
    double friction;        /* mu; INFINITY for a foot that never slips */
} tdmf_classic;

/* The paper's: 80 kg, 20 kN/m, 1 m, 9.81 m/s2, 40 degrees, no slip. */
tdmf_classic tdmf_classic_default(void);

/* How a step ends. */
typedef enum {
    TDMF_CLASSIC_FLIES,     /* to the next apex */
    TDMF_CLASSIC_NO_START,  /* parameters out of range, the apex below touchdown, or the energy too small for
                               it */
    TDMF_CLASSIC_SLIDES,    /* the leg is outside the friction cone at touchdown, or leaves it where it turns
                               back: the foot slides out forwards, the mass falls */
    TDMF_CLASSIC_FALLS,     /* the mass reaches the ground in stance, or leaves it moving downwards */
    TDMF_CLASSIC_TURNS_BACK /* it flies, but backwards, and falls at the next step */
} tdmf_classic_outcome;

/* The mass seen from the foot, m, and its velocity, m/s. */
typedef struct {
    double x, y;   /* m */
    double vx, vy; /* m/s */
} tdmf_classic_point;

/* One step. From the next apex on, values are there if it flies or turns back. */
typedef struct {
    tdmf_classic_outcome outcome;           /* how it ends */
    tdmf_classic_point touchdown, take_off; /* first and last of the stance */
    double stance_time;                     /* s */
    bool early_take_off;    /* the leg reached -arctan mu: the energy left in the spring is lost */
    double stance_friction; /* mu needed in stance: the largest tan of the leg's angle (3) */
    double impact_friction; /* mu needed at the impact of an infinitesimal foot mass (5) */
    double next_height;     /* of the next apex, m */
    double next_speed;      /* m/s, negative backwards */
    double next_energy;     /* J */
    double slope, by_angle; /* change of the next height with this one at the same energy, and with theta0,
                               m/rad; where the foot does not slip */
} tdmf_classic_step;

/* The return map at an energy, J, from an apex of a height, m, running forwards. */
tdmf_classic_step tdmf_classic_return_map(const tdmf_classic *slip, double energy, double height);

/* The mass a time after touchdown of such a step, while the foot holds. */
tdmf_classic_point tdmf_classic_stance(const tdmf_classic *slip, double energy, double height, double time);

/* The height of a periodic gait near a guess, by Newton's method; false if none is found. */
bool tdmf_classic_fixed_point(const tdmf_classic *slip, double energy, double guess, double *height);

/* The touchdown angle and height at which two gaits meet and vanish (slope 1), by Newton's method from a
 * guess in *angle and *height; false if it isn't found. */
bool tdmf_classic_fold(const tdmf_classic *slip, double energy, double *angle, double *height);

#ifdef __cplusplus
}
#endif
#endif
