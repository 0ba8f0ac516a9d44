/* What a step passes that is no event, but is noted: peaks of the ground force, and the leg's greatest
 * compression where it makes no difference yet. */
#ifndef TDMF_SOLVER_EXTREMA_H
#define TDMF_SOLVER_EXTREMA_H

#include "step.h"

/* The largest peak of a force in a step; where there is none, its time is infinite and it is less than any.
 */
typedef struct {
    double time, force;
} tdmf_peak;

typedef struct {
    tdmf_peak normal, vertical;
} tdmf_force_peaks;

/* The largest peaks up to `end` of the ground force, across the ground and vertically, in contact only. The
 * mode says whether either rises, at the start of the step and on return at `end`. */
tdmf_force_peaks tdmf_largest_peaks(const tdmf_step *step, double end, tdmf_mode *mode);

/* Whether the leg, of a foot on the ground, lengthens at some time in the step up to `end`. */
bool tdmf_leg_lengthens(const tdmf_step *step, double end);

#endif
