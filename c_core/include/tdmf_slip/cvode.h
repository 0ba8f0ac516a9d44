/* SUNDIALS CVODE as a second solver of the same automaton, to check the native one against. */
#ifndef TDMF_SLIP_CVODE_H
#define TDMF_SLIP_CVODE_H

#include "tdmf_slip/solver.h"

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* True if the library was built with SUNDIALS. */
bool tdmf_cvode_is_available(void);

/* Does what tdmf_native_advance does, by CVODE (BDF) and its root finding. Keeps nothing between calls: its
 * memory is allocated and freed in each. Reads tolerance and limits from `options` and counts its work there.
 * Where SUNDIALS is missing, returns TDMF_REFUSED. */
tdmf_outcome tdmf_cvode_advance(tdmf_solver *options, tdmf_system system, const tdmf_inputs *rates,
                                double until, tdmf_motion *motion);

#ifdef __cplusplus
}
#endif
#endif
