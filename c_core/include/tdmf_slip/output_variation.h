/* Exact directional derivatives: how the right-hand side and the outputs change with state, inputs and
 * parameters. */
#ifndef TDMF_SLIP_OUTPUT_VARIATION_H
#define TDMF_SLIP_OUTPUT_VARIATION_H

#include "tdmf_slip/contact.h"
#include "tdmf_slip/energy.h"
#include "tdmf_slip/export.h"
#include "tdmf_slip/kinematics.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"
#include "tdmf_slip/variation.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How everything that follows continuously from state, inputs and parameters varies, per unit of the seed. */
typedef struct {
    double derivatives[TDMF_STATE_COUNT]; /* of the right-hand side */
    tdmf_point body, com;                 /* of body and centre of mass */
    tdmf_ground_force contact;            /* of the ground's force */
    double contact_fx, contact_fy;        /* of the same, horizontal and vertical */
    double torque;                        /* of the total hip torque */
    double leg_force;                     /* N, of spring and damper */
    tdmf_energy energy;                   /* of the energies */
} tdmf_output_variation;

/* The derivative along a direction in parameters and inputs (`seed`), state and theta_LO (`variation`), in
 * the present mode, clamp held. Either may be NULL: it does not change. Where the hip's power is zero,
 * positive work counts as not changing; a frozen run has derivatives that do not change. */
TDMF_API tdmf_output_variation tdmf_vary_outputs(tdmf_system system, const tdmf_mode *mode,
                                                 const double state[TDMF_STATE_COUNT], const tdmf_seed *seed,
                                                 const tdmf_variation *variation);

#ifdef __cplusplus
}
#endif
#endif
