/* The hip's law as modes have it; the laws are in equations/hip.py. */
#ifndef TDMF_MODEL_HIP_LAW_H
#define TDMF_MODEL_HIP_LAW_H

#include "hip_laws.h"
#include "input_rates.h"
#include "seed.h"

/* Whether the law has the clamp of (12): in retract, with hip.swing_clamp. */
static inline bool tdmf_has_clamp(const tdmf_model *model, const tdmf_mode *mode) {
    return model->parameters.hip.swing_clamp && mode->phase == TDMF_PHASE_RETRACT;
}

/* Whether both gains are zero but change along the direction: the clamp then has a kink, and the torque no
 * derivative. */
bool tdmf_clamp_has_no_derivative(const tdmf_model *model, const tdmf_mode *mode, const tdmf_local_seed *d);

/* Whether the law makes a torque, sooner or later. */
static inline bool tdmf_law_acts(const tdmf_hip_law *law) {
    return law->gain != 0.0 || law->rate_gain != 0.0 || law->torque != 0.0 || law->torque_rate != 0.0;
}

static inline bool tdmf_law_drifts(const tdmf_hip_law *law) {
    return tdmf_law_drift(law) != 0.0;
}

#endif
