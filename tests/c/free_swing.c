#include "free_swing.h"

#include "compare.h"
#include "free_borders_table.h"
#include "free_gaits_table.h"
#include "free_strides_table.h"

static tdmf_model model_of(const tdmf_parameters *parameters) {
    tdmf_model model;
    assert_null(tdmf_model_create(&model, parameters).variable);
    return model;
}

tdmf_model table_1(bool swing_clamp) {
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.hip.swing_clamp = swing_clamp;
    return model_of(&parameters);
}

tdmf_model model_of_free_stride(const free_stride *stride, bool swing_clamp) {
    tdmf_parameters p = tdmf_default_parameters();
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
    return model_of(&p);
}

tdmf_inputs inputs_at_friction(double friction) {
    tdmf_inputs inputs = tdmf_default_inputs();
    inputs.ground.friction = friction;
    return inputs;
}
