/* Derivatives of runs and instants, by the runner's page. */
#ifndef TDMF_TESTS_BY_PAGE_H
#define TDMF_TESTS_BY_PAGE_H

#include "tdmf_slip/tdmf_slip.h"

/* Writes how the states at a time change of a run that starts from a state. `seed` is the change of
 * parameters and inputs, `d_start` that of the mechanical states. */
void vary_run(tdmf_system system, const double start[TDMF_STATE_COUNT], const tdmf_seed *seed,
              const double d_start[TDMF_STATE_COUNT], double time, double d_states[TDMF_STATE_COUNT]);

enum { VARIED_OUTPUTS = 18 };

/* Writes how the rates of the states and the outputs change that have derivatives, of a motion in its mode:
 * points of body and centre of mass, forces on the foot, hip and leg, energies. */
void vary_instant(tdmf_system system, const tdmf_motion *motion, const tdmf_seed *seed,
                  const double d_state[TDMF_STATE_COUNT], double d_rates[TDMF_STATE_COUNT],
                  double d_outputs[VARIED_OUTPUTS]);

#endif
