/* What a step passes that is no event, but is noted: peaks of the ground force, the leg's greatest
 * compression where it makes no difference yet, and turns of the hip's power. */
#ifndef TDMF_SOLVER_TURNS_H
#define TDMF_SOLVER_TURNS_H

#include "step.h"

/* As many as a series can have. */
enum { TDMF_TURN_LIMIT = SERIES_ORDER_LIMIT };

/* The first time after `from`, up to `to`, at which the ground force turns from rising to falling or back;
 * else infinity. In contact only. */
double tdmf_force_turn(const tdmf_step *step, bool rising, double from, double to);

/* Whether the leg lengthens at some time in the step up to `end`. On the ground only. */
bool tdmf_leg_lengthens(const tdmf_step *step, double end);

/* Of the hip's work since the start of the step, what is done up to `end` at positive power; all of it is
 * `total`.
 */
double tdmf_positive_work(const tdmf_step *step, double end, double total);

#endif
