/* Everything that you can read off a run besides its state. Member paths are the names of the unit's
 * variables. */
#ifndef TDMF_SLIP_OUTPUTS_H
#define TDMF_SLIP_OUTPUTS_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/motion.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/stride.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A point that moves. */
typedef struct {
    double x, y, vx, vy; /* m, m/s */
} tdmf_point;

/* The outputs at an instant. Works and losses since the start are elements of the state. The energy ledger
 * closes: energy.total changes by the works of hip, leg and external forces, less the losses in the damper,
 * by friction and at impacts. */
typedef struct {
    tdmf_point body; /* the body's mass */
    tdmf_point com;  /* the centre of mass of body and foot */
    struct {
        double fx, fy;     /* force of the ground on the foot, N: zero in flight and graze */
        double normal;     /* its part away from the ground, N */
        double tangential; /* its part along the ground, N; -friction times normal where the foot slips
                              forward */
        int mode;          /* the tdmf_contact_mode */
        int mode_index;    /* the same number, for tools without enumerations */
    } contact;
    struct {
        bool pending; /* the line of ground set last is not in force yet */
    } ground;
    struct {
        double force; /* force of spring and damper, N */
    } leg;
    struct {
        double torque;        /* total: the hip's law and the external torque, N.m */
        double liftoff_angle; /* leg angle at the last lift-off, rad */
        int phase;            /* the tdmf_hip_phase */
        int phase_index;      /* the same number */
    } hip;
    struct {
        double kinetic;     /* kinetic energy of body and foot, J */
        double potential;   /* potential energy, zero at y = 0, J */
        double elastic;     /* elastic energy of the leg's spring, J */
        double total;       /* kinetic + potential + elastic, J */
        double impact_loss; /* lost at impacts since the start, J */
    } energy;
    struct {
        int count;        /* changes of contact, phase or ground since the start; an instant counts once */
        double last_time; /* time of the last change, or of the start, s */
    } event;
    struct {
        bool fallen; /* true from a fall on */
    } status;
    tdmf_stride stride;                 /* the last completed stride */
    tdmf_apex apex;                     /* the last apex */
    char open_word[TDMF_WORD_CAPACITY]; /* gait word of the stride under way; a contact joins it when it ends
                                         */
} tdmf_outputs;

/* Writes the outputs of a motion that tdmf_start has begun.
 *
 *     tdmf_outputs now;
 *     tdmf_outputs_of(system, &motion, &now);
 *     printf("%g N at x = %g m\n", now.contact.normal, now.com.x);
 */
TDMF_API void tdmf_outputs_of(tdmf_system system, const tdmf_motion *motion, tdmf_outputs *outputs);

#ifdef __cplusplus
}
#endif
#endif
