#include "further_gaits.h"

#include "compare.h"
#include "further_gaits_table.h"

#include <math.h>

runner runner_at_further_apex(const further_gait *further) {
    runner runner = runner_at_reference_apex(&further->gait);
    const tdmf_parameters parameters = parameters_of_further_gait(further);
    assert_null(tdmf_model_create(&runner.model, &parameters).variable);
    runner.inputs = inputs_of_further_gait(further);
    /* The apex is a height above the ground below it. */
    const tdmf_point com = tdmf_center_of_mass(&runner.model, runner.motion.state);
    runner.motion.state[TDMF_FOOT_Y] += com.x * tan(runner.inputs.ground.slope);
    runner_start(&runner);
    return runner;
}

tdmf_parameters parameters_of_further_gait(const further_gait *further) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.hip.swing_clamp = true; /* the reference's setting */
    parameters.hip.touchdown_angle = further->touchdown_angle * (acos(-1.0) / 180.0);
    parameters.hip.retraction_rate = further->retraction_rate;
    parameters.ground.static_friction_ratio = further->static_friction_ratio;
    parameters.ground.stribeck_velocity = further->stribeck_velocity;
    parameters.leg.thrust = further->thrust;
    return parameters;
}

tdmf_inputs inputs_of_further_gait(const further_gait *further) {
    tdmf_inputs inputs = tdmf_default_inputs();
    inputs.ground.friction = further->gait.friction;
    inputs.ground.slope = further->slope * (acos(-1.0) / 180.0);
    inputs.body.external_fx = further->external_fx;
    inputs.body.external_fy = further->external_fy;
    return inputs;
}
