/* Checks of a solver's request. A request without sense must be refused at the start: no step would reveal
 * it. */
#ifndef TDMF_SOLVER_REQUEST_H
#define TDMF_SOLVER_REQUEST_H

#include "tdmf_slip/solver.h"

/* Checks that say why, as those of refusal.h. */
bool tdmf_is_sound_solver(tdmf_refusal *why, const tdmf_solver *solver);
bool tdmf_is_sound_system(tdmf_refusal *why, tdmf_system system);

/* Checks the seeds, at most `limit` of them. */
bool tdmf_are_sound_seeds(tdmf_refusal *why, const tdmf_seed *seeds, int count, int limit);

/* A run from a motion to a time. Says why in solver->refusal, if there is a solver. */
bool tdmf_is_sound_request(tdmf_solver *solver, tdmf_system system, const tdmf_inputs *rates, double until,
                           const tdmf_motion *motion);

#endif
