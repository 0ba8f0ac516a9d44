/* What of a runner is constant in a mode, whatever its motion. */
#ifndef TDMF_KERNEL_MODE_CONSTANTS_H
#define TDMF_KERNEL_MODE_CONSTANTS_H

#include "guard_parameters.h"

typedef struct {
    real margin_factor; /* of guards, see margins.h */
    real damping, gravity;
    real length_scale, time_scale, speed_scale, force_scale, energy_scale;
    guard_parameters guards;
} mode_constants;

/* What has been done and lost since the start of the run. */
typedef struct {
    real work, damper_loss, friction_loss;
} energy_sums;

#endif
