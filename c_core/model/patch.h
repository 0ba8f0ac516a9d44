/* A patch of ground with a friction of its own, in three zones along x: before it, the patch, and beyond it.
 *
 * A foot that moves or is pushed in a direction has, on a border, the zone that it is going to. Which zone
 * that is changes nothing but friction. */
#ifndef TDMF_MODEL_PATCH_H
#define TDMF_MODEL_PATCH_H

#include "contact_mode.h"
#include "margins.h"

static inline bool tdmf_has_patch(const tdmf_model *model) {
    return model->parameters.ground.patch_begin < model->parameters.ground.patch_end;
}

/* Zone of a foot at x; a foot without direction, 0, counts as moving forward. */
static inline tdmf_zone tdmf_zone_towards(const tdmf_model *model, double x, double direction) {
    if (!tdmf_has_patch(model)) {
        return TDMF_ZONE_BEFORE;
    }
    const double begin = model->parameters.ground.patch_begin, end = model->parameters.ground.patch_end;
    const double near = TDMF_ON_BORDER * model->scales.length;
    const int passed =
        direction >= 0.0 ? (x >= begin - near) + (x >= end - near) : (x > begin + near) + (x > end + near);
    return (tdmf_zone)passed;
}

#endif
