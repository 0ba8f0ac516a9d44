#include "references.h"

#include "compare.h"
#include "extended_strides_table.h"
#include "free_borders_table.h"
#include "free_strides_table.h"
#include "further_gaits_table.h"
#include "patch_runs_table.h"
#include "proved_gaits_table.h"
#include "reduced_gaits_table.h"

#include <math.h>

static const double degree = 0.017453292519943295;

/* Default inputs but for the ground; slope in rad. */
static tdmf_inputs inputs_on(double friction, double slope) {
    tdmf_inputs inputs = tdmf_default_inputs();
    inputs.ground.friction = friction;
    inputs.ground.slope = slope;
    return inputs;
}

/* ---- gaits beyond the paper ---------------------------------------------------------------------------- */

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
    parameters.hip.touchdown_angle = further->touchdown_angle * degree;
    parameters.hip.retraction_rate = further->retraction_rate;
    parameters.ground.static_friction_ratio = further->static_friction_ratio;
    parameters.ground.stribeck_velocity = further->stribeck_velocity;
    parameters.leg.thrust = further->thrust;
    return parameters;
}

tdmf_inputs inputs_of_further_gait(const further_gait *further) {
    tdmf_inputs inputs = inputs_on(further->gait.friction, further->slope * degree);
    inputs.body.external_fx = further->external_fx;
    inputs.body.external_fy = further->external_fy;
    return inputs;
}

/* ---- a swing without the clamp ------------------------------------------------------------------------- */

tdmf_model model_of_free_stride(const free_stride *stride, bool swing_clamp) {
    tdmf_parameters p = tdmf_default_parameters();
    tdmf_model model;
    p.body.mass = stride->body_mass;
    p.foot.mass = stride->foot_mass;
    p.leg.stiffness = stride->stiffness;
    p.leg.damping = stride->damping;
    p.leg.free_length = stride->free_length;
    p.gravity = stride->gravity;
    p.hip.stance_torque = stride->stance_torque;
    p.hip.touchdown_angle = stride->touchdown_angle;
    p.hip.kp = stride->kp;
    p.hip.kd = stride->kd;
    p.hip.liftoff_angle_factor = stride->liftoff_angle_factor;
    p.hip.swing_clamp = swing_clamp;
    assert_null(tdmf_model_create(&model, &p).variable);
    return model;
}

/* ---- runs over a patch --------------------------------------------------------------------------------- */

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
    return inputs_on(run->friction, run->slope);
}

/* ---- gaits of the reduced map -------------------------------------------------------------------------- */

tdmf_parameters parameters_of_reduced_gait(const reduced_gait *gait) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.hip.touchdown_angle = gait->touchdown_angle * degree;
    parameters.hip.retraction_rate = gait->retraction_rate;
    parameters.ground.static_friction_ratio = gait->static_friction_ratio;
    return parameters;
}

tdmf_inputs inputs_of_reduced_gait(const reduced_gait *gait) {
    return inputs_on(gait->friction, gait->slope * degree);
}
