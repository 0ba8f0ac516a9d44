#include "reduced_gaits.h"

#include "reduced_gaits_table.h"

static const double degree = 0.017453292519943295;

tdmf_parameters parameters_of_reduced_gait(const reduced_gait *gait) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.hip.touchdown_angle = gait->touchdown_angle * degree;
    parameters.hip.retraction_rate = gait->retraction_rate;
    parameters.ground.static_friction_ratio = gait->static_friction_ratio;
    return parameters;
}

tdmf_inputs inputs_of_reduced_gait(const reduced_gait *gait) {
    tdmf_inputs inputs = tdmf_default_inputs();
    inputs.ground.friction = gait->friction;
    inputs.ground.slope = gait->slope * degree;
    return inputs;
}
