/* Random ground, drawn by the number of a stride or of a segment. */
#ifndef TDMF_ENSEMBLE_DRAWN_GROUND_H
#define TDMF_ENSEMBLE_DRAWN_GROUND_H

#include "tdmf_slip/ensemble.h"

/* Height of the step with which the stride of this number begins, m. */
double tdmf_drawn_step(const tdmf_ensemble_rules *rules, uint64_t runner, uint32_t number);

/* Random height of a segment of terrain, m, above the height that the inputs set. */
double tdmf_segment_height(const tdmf_ensemble_rules *rules, uint64_t runner, int64_t segment);

/* Random friction around the friction `about`, within the range of ground.friction. */
double tdmf_drawn_friction(const tdmf_ensemble_rules *rules, double about, uint64_t runner, uint32_t number);

#endif
