/* Ground that is drawn, by the number of a stride or of a segment. */
#ifndef TDMF_ENSEMBLE_DRAWN_GROUND_H
#define TDMF_ENSEMBLE_DRAWN_GROUND_H

#include "tdmf_slip/ensemble.h"

/* A step of the height, m, by the number of the stride that it begins. */
double tdmf_drawn_step(const tdmf_ensemble_rules *rules, uint64_t runner, uint32_t number);

/* The height of a segment of terrain that is drawn, m, over the inputs' height. */
double tdmf_segment_height(const tdmf_ensemble_rules *rules, uint64_t runner, int64_t segment);

/* A friction about another, within its range. */
double tdmf_drawn_friction(const tdmf_ensemble_rules *rules, double about, uint64_t runner, uint32_t number);

#endif
