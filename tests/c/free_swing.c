#include "free_swing.h"

#include "compare.h"
#include "free_borders_table.h"
#include "free_strides_table.h"

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
