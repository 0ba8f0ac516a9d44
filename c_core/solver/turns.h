/* What a step passes that is no event, but is noted: peaks of the ground force, the leg's greatest
 * compression where it makes no difference yet, and turns of the hip's power. */
#ifndef TDMF_SOLVER_TURNS_H
#define TDMF_SOLVER_TURNS_H

#include "step.h"

/* The time up to `end` of the largest peak of the ground force; infinity where there is none. In contact
 * only. `rising` is whether the force rises, at the start of the step and on return at `end`. */
double tdmf_largest_peak(const tdmf_step *step, double end, bool *rising);

/* Whether the leg lengthens at some time in the step up to `end`. On the ground only. */
bool tdmf_leg_lengthens(const tdmf_step *step, double end);

/* Of the hip's work since the start of the step, what is done up to `end` at positive power; all of it is
 * `total`.
 */
double tdmf_positive_work(const tdmf_step *step, double end, double total);

#endif
