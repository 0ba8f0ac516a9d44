/* What a step passes that is no event, but is recorded: peaks of the ground force, and turns of the hip's
 * power. */
#ifndef TDMF_SOLVER_TURNS_H
#define TDMF_SOLVER_TURNS_H

#include "step.h"

/* As many as a series can have. */
enum { TDMF_TURN_LIMIT = SERIES_ORDER_LIMIT };

/* The first time after `from`, up to `to`, at which the ground force turns from rising to falling or back;
 * else infinity. In contact only. */
double tdmf_force_turn(const tdmf_step *step, bool rising, double from, double to);

/* Of the hip's work since the start of the step, what is done up to `end` at positive power; all of it is
 * `total`.
 */
double tdmf_positive_work(const tdmf_step *step, double end, double total);

#endif
