/* The hip's law as modes have it; the laws are in equations/hip.py. */
#ifndef TDMF_MODEL_HIP_LAW_H
#define TDMF_MODEL_HIP_LAW_H

#include "hip_laws.h"

/* Whether the law has the clamp of (12): in retract, with hip.swing_clamp. */
static inline bool tdmf_has_clamp(const tdmf_model *model, const tdmf_mode *mode) {
    return model->parameters.hip.swing_clamp && mode->phase == TDMF_PHASE_RETRACT;
}

#endif
