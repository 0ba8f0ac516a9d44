/* Everything a user reads off a run that is not a state. Member paths are the FMU's variable names. */
#ifndef TDMF_SLIP_OUTPUTS_H
#define TDMF_SLIP_OUTPUTS_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/motion.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/stride.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The unit's outputs, by their names in the unit. */
typedef struct {
    struct {
        double x, y, vx, vy; /* m, m/s */
    } body, com;
    struct {
        double fx, fy;             /* N */
        double normal, tangential; /* the same force across and along the ground, N */
        int mode;                  /* tdmf_contact_mode */
        int mode_index;            /* the same number, for tools without enumerations */
    } contact;
    struct {
        bool pending; /* while the line set last is not in force yet */
    } ground;
    struct {
        double force; /* N, of spring and damper */
    } leg;
    struct {
        double torque;        /* N.m, total */
        double liftoff_angle; /* rad */
        int phase;            /* tdmf_hip_phase */
        int phase_index;      /* the same number */
    } hip;
    struct {
        double kinetic, potential, elastic, total, impact_loss; /* J */
    } energy;
    struct {
        int count;        /* contact and phase changes since the start */
        double last_time; /* s */
    } event;
    struct {
        bool fallen; /* from a fall on */
    } status;
    tdmf_stride stride; /* the last that closed */
    tdmf_apex apex;     /* the last */
} tdmf_outputs;

/* The outputs at an instant of a run that tdmf_start has begun. */
TDMF_API tdmf_outputs tdmf_outputs_of(tdmf_system system, const tdmf_motion *motion);

#ifdef __cplusplus
}
#endif
#endif
