/* How long a step may be where friction falls with speed, for solvers that have no series: by the same rule
 * as the page of friction, from one evaluation. */
#include "evaluation.h"
#include "margins.h"
#include "tdmf_slip/dynamics.h"

#include <math.h>

/* kappa, at up to which a slip grows by itself. */
static double growth_rate_of_slip(const tdmf_evaluation *at, double sign) {
    const double friction = tdmf_signed_friction(at->model, at->inputs, at->mode->zone, sign);
    return at->force.normal * tdmf_friction_growth_rate(at->model, friction, tdmf_friction_excess(at->model),
                                                        tdmf_friction_fading(at->model, sign));
}

double tdmf_longest_step(tdmf_system system, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    const double sign = tdmf_sign_of_slip(mode);
    if (sign == 0.0 || mode->fallen || !tdmf_friction_falls(system.model)) {
        return INFINITY;
    }
    double rates[TDMF_STATE_COUNT];
    tdmf_derivatives(system, mode, state, rates);
    const double speed_scale = system.model->parameters.ground.stribeck_velocity;
    const double speed = sign * tdmf_velocity_along(&mode->ground, state[TDMF_FOOT_VX], state[TDMF_FOOT_VY]);
    const double acceleration =
        fabs(tdmf_velocity_along(&mode->ground, rates[TDMF_FOOT_VX], rates[TDMF_FOOT_VY]));
    const double few = TDMF_CHANGE_IN_LAYER * speed_scale, beyond = speed - TDMF_LAYER_WIDTH * speed_scale;
    const double longest = fmin(system.model->scales.time, fmax(beyond, few) / acceleration);
    if (beyond >= few) {
        return longest;
    }
    const tdmf_evaluation at = tdmf_evaluate(system, mode, state);
    return fmin(longest, TDMF_GROWTH_IN_LAYER / fabs(growth_rate_of_slip(&at, sign)));
}
