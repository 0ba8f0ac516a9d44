/* First variations: how a run changes with its start and with the parameters, exactly.
 *
 * Between events the variational equations of the mode are solved along with it; at an event the saltation
 * matrix takes over, with the changes of guard and reset. */
#ifndef TDMF_SLIP_VARIATION_H
#define TDMF_SLIP_VARIATION_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A direction in the space of parameters and inputs. */
typedef struct {
    tdmf_parameters parameters; /* change of each parameter, per unit of the direction */
    tdmf_inputs inputs;         /* and of each input */
} tdmf_seed;

/* Change of the states of a run at a fixed time, per unit of a direction. Peaks and positive parts change
 * where they are observed. */
typedef struct {
    double state[TDMF_STATE_COUNT]; /* change of each state */
} tdmf_variation;

/* Writes how the motion that tdmf_start makes of a state changes with it. `given` is the state before the
 * start, `state_seed` its change, `seed` that of parameters and inputs. `seed` may be NULL: they do not
 * change. */
TDMF_API void tdmf_vary_start(tdmf_system system, const double given[TDMF_STATE_COUNT], const tdmf_seed *seed,
                              const double state_seed[TDMF_STATE_COUNT], tdmf_variation *variation);

#ifdef __cplusplus
}
#endif
#endif
