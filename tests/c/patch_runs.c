#include "patch_runs.h"

#include "patch_runs_table.h"

tdmf_parameters parameters_of_patch_run(const patch_run *run) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.hip.swing_clamp = true; /* the reference's setting */
    parameters.ground.static_friction_ratio =
        run->static_friction_ratio == 0.0 ? 1.0 : run->static_friction_ratio;
    parameters.ground.stribeck_velocity = run->stribeck_velocity;
    parameters.ground.patch_begin = run->begin;
    parameters.ground.patch_end = run->end;
    parameters.ground.patch_friction = run->patch_friction;
    return parameters;
}

tdmf_inputs inputs_of_patch_run(const patch_run *run) {
    tdmf_inputs inputs = tdmf_default_inputs();
    inputs.ground.friction = run->friction;
    inputs.ground.slope = run->slope;
    return inputs;
}
