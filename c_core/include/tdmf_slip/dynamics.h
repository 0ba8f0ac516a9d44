/* The right-hand side: one formula for all contact modes. */
#ifndef TDMF_SLIP_DYNAMICS_H
#define TDMF_SLIP_DYNAMICS_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Writes the time derivative of the state in the given mode (8). A frozen run (mode->fallen) gives zeros.
 * Finite for leg lengths at or below zero too, as a solver may probe beyond an event; the leg's rates are not
 * a number where contact or phase are none. `derivatives` may be `state`. */
TDMF_API void tdmf_derivatives(tdmf_system system, const tdmf_mode *mode,
                               const double state[TDMF_STATE_COUNT], double derivatives[TDMF_STATE_COUNT]);

/* The natural unit of each element of the state, by the model's scales; angles are in rad. That of the foot's
 * velocity is v_s where friction falls within less than that of other speeds. */
TDMF_API void tdmf_state_scales(const tdmf_model *model, double scales[TDMF_STATE_COUNT]);

#ifdef __cplusplus
}
#endif
#endif
