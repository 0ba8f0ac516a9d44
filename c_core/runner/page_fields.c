/* Parameters and inputs of the core on the runner's page, and strides and apexes from its states. */
#include "page_fields.h"

#include "words.h"

#include <limits.h>
#include <math.h>

runner_parameters tdmf_page_parameters(const tdmf_parameters *p, const tdmf_inputs *inputs) {
    const runner_parameters of = {
        .ground_height = inputs->ground.height,
        .ground_slope = inputs->ground.slope,
        .patch_begin = p->ground.patch_begin,
        .patch_end = p->ground.patch_end,
        .patch_friction = p->ground.patch_friction,
        .body_mass = p->body.mass,
        .foot_mass = p->foot.mass,
        .stiffness = p->leg.stiffness,
        .damping = p->leg.damping,
        .free_length = p->leg.free_length,
        .least_length = p->leg.min_length,
        .gravity = p->gravity,
        .thrust = p->leg.thrust,
        .more_thrust = inputs->control.thrust,
        .static_ratio = p->ground.static_friction_ratio,
        .stribeck_velocity = p->ground.stribeck_velocity,
        .drive_torque = p->hip.stance_torque,
        .kp = p->hip.kp,
        .kd = p->hip.kd,
        .touchdown_angle = p->hip.touchdown_angle,
        .liftoff_factor = p->hip.liftoff_angle_factor,
        .retraction_rate = p->hip.retraction_rate,
        .swing_clamp = p->hip.swing_clamp,
        .more_angle = inputs->control.touchdown_angle,
        .more_torque = inputs->control.stance_torque,
    };
    return of;
}

void tdmf_write_page_inputs(const tdmf_inputs *inputs, runner_states *x) {
    x->friction = inputs->ground.friction;
    x->external_torque = inputs->hip.external_torque;
    x->extension = inputs->leg.extension;
    x->external_fx = inputs->body.external_fx;
    x->external_fy = inputs->body.external_fy;
}

int tdmf_count_of(double count) {
    return count < INT_MAX ? (int)fmax(count, 0.0) : INT_MAX;
}

tdmf_apex tdmf_page_apex_of(const runner_states *x, double begun) {
    const tdmf_apex none = {.time = 0.0};
    const tdmf_apex apex = {.time = begun + x->apex_time,
                            .com_height = x->apex_com_height,
                            .com_speed = x->apex_com_speed,
                            .leg_length = x->apex_length,
                            .leg_angle = x->apex_angle,
                            .leg_length_rate = x->apex_length_rate,
                            .leg_angle_rate = x->apex_angle_rate};
    return x->is_open > 0.0 ? apex : none;
}

tdmf_stride tdmf_page_stride_of(const runner_states *x) {
    tdmf_stride stride = {
        .count = tdmf_count_of(x->count),
        .period = x->period,
        .length = x->distance,
        .rise = x->rise_of_stride,
        .speed = x->period == 0.0 ? 0.0 : x->speed,
        .work = x->work_of_stride,
        .hip_work = x->hip_work,
        .leg_work = x->leg_work_of_stride,
        .positive_work = x->positive_work,
        .cost_of_transport = x->distance == 0.0 ? 0.0 : x->cost_of_transport,
        .touchdowns = tdmf_count_of(x->touchdowns),
        .stance_time = x->stance_time,
        .duty_factor = x->period == 0.0 ? 0.0 : x->duty_factor,
        .slip_distance = x->slip_distance,
        .peak_force = x->peak_force,
        .peak_vertical_force = x->peak_vertical_force,
        .word_code = tdmf_short_word_code(x->word_code),
    };
    tdmf_write_word(x->word_code, stride.word);
    return stride;
}
