/* Derived from c_core/equations/impact.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_IMPACT_LAWS_H
#define TDMF_DERIVED_IMPACT_LAWS_H

#include "quantities.h"

#include <math.h>

/* Foot and rates of the leg after an impact that sticks, or slips to the side of `sign` (4)-(6).
 *
 * v_n+ = 0; v_t+ = 0, or v_t- - mu sgn(v_t-) |v_n-|; m_f/2 (v_t-^2 - v_t+^2 + v_n-^2) is lost. */
static inline tdmf_after_impact tdmf_impact_with(const tdmf_model *model, const tdmf_inputs *inputs,
                                                 tdmf_zone zone, const tdmf_ground_line *line,
                                                 const double state[TDMF_STATE_COUNT],
                                                 tdmf_leg_direction direction, double sign, bool sticks,
                                                 bool falls) {
    if (sticks) {
        const double offset =
            line->cosine * state[TDMF_FOOT_X] + line->sine * (state[TDMF_FOOT_Y] - line->height);
        const double along = line->cosine * state[TDMF_FOOT_VX] + line->sine * state[TDMF_FOOT_VY];
        const double off = line->cosine * state[TDMF_FOOT_VY] - line->sine * state[TDMF_FOOT_VX];
        const tdmf_after_impact result = {
            .foot_x = line->cosine * offset,
            .foot_y = line->height + line->sine * offset,
            .leg_length_rate = state[TDMF_LEG_LENGTH_RATE] + (direction.cosine * state[TDMF_FOOT_VY] -
                                                              direction.sine * state[TDMF_FOOT_VX]),
            .leg_angle_rate = state[TDMF_LEG_ANGLE_RATE] - (direction.cosine * state[TDMF_FOOT_VX] +
                                                            direction.sine * state[TDMF_FOOT_VY]) /
                                                               state[TDMF_LEG_LENGTH],
            .loss = 0.5 * (model->parameters.foot.mass * (along * along + off * off)),
        };
        return result;
    }
    if (falls) {
        const double offset =
            line->cosine * state[TDMF_FOOT_X] + line->sine * (state[TDMF_FOOT_Y] - line->height);
        const double along = line->cosine * state[TDMF_FOOT_VX] + line->sine * state[TDMF_FOOT_VY];
        const double friction =
            (zone == TDMF_ZONE_PATCH ? model->parameters.ground.patch_friction : inputs->ground.friction);
        const double off = line->cosine * state[TDMF_FOOT_VY] - line->sine * state[TDMF_FOOT_VX];
        const double taken = friction * -off;
        const double left = sign * along - taken;
        const double speed = left + model->parameters.ground.stribeck_velocity *
                                        log1p(-(-(model->parameters.ground.static_friction_ratio - 1.0) *
                                                expm1(-taken / model->parameters.ground.stribeck_velocity)) *
                                              exp(-left / model->parameters.ground.stribeck_velocity));
        const double along_after = sign * (speed >= 0.0 ? speed : 0.0);
        const double vx = line->cosine * along_after;
        const double vy = line->sine * along_after;
        const double lost_y = state[TDMF_FOOT_VY] - vy;
        const double lost_x = state[TDMF_FOOT_VX] - vx;
        const tdmf_after_impact result = {
            .foot_x = line->cosine * offset,
            .foot_y = line->height + line->sine * offset,
            .foot_vx = vx,
            .foot_vy = vy,
            .leg_length_rate =
                state[TDMF_LEG_LENGTH_RATE] + (direction.cosine * lost_y - direction.sine * lost_x),
            .leg_angle_rate = state[TDMF_LEG_ANGLE_RATE] -
                              (direction.cosine * lost_x + direction.sine * lost_y) / state[TDMF_LEG_LENGTH],
            .loss = 0.5 * (model->parameters.foot.mass *
                           ((along - along_after) * (along + along_after) + off * off)),
        };
        return result;
    }
    const double offset =
        line->cosine * state[TDMF_FOOT_X] + line->sine * (state[TDMF_FOOT_Y] - line->height);
    const double along = line->cosine * state[TDMF_FOOT_VX] + line->sine * state[TDMF_FOOT_VY];
    const double friction =
        (zone == TDMF_ZONE_PATCH ? model->parameters.ground.patch_friction : inputs->ground.friction);
    const double off = line->cosine * state[TDMF_FOOT_VY] - line->sine * state[TDMF_FOOT_VX];
    const double along_after = along + sign * friction * off;
    const double vx = line->cosine * along_after;
    const double vy = line->sine * along_after;
    const double lost_y = state[TDMF_FOOT_VY] - vy;
    const double lost_x = state[TDMF_FOOT_VX] - vx;
    const tdmf_after_impact result = {
        .foot_x = line->cosine * offset,
        .foot_y = line->height + line->sine * offset,
        .foot_vx = vx,
        .foot_vy = vy,
        .leg_length_rate =
            state[TDMF_LEG_LENGTH_RATE] + (direction.cosine * lost_y - direction.sine * lost_x),
        .leg_angle_rate = state[TDMF_LEG_ANGLE_RATE] -
                          (direction.cosine * lost_x + direction.sine * lost_y) / state[TDMF_LEG_LENGTH],
        .loss =
            0.5 * (model->parameters.foot.mass * ((along - along_after) * (along + along_after) + off * off)),
    };
    return result;
}

/* Its change. */
static inline tdmf_after_impact
tdmf_vary_impact_with(const tdmf_model *model, const tdmf_inputs *inputs, tdmf_zone zone,
                      const tdmf_ground_line *line, const double state[TDMF_STATE_COUNT],
                      tdmf_leg_direction direction, double sign, bool sticks, bool falls,
                      const tdmf_model *d_model, const tdmf_inputs *d_inputs, const tdmf_ground_line *d_line,
                      const double d_state[TDMF_STATE_COUNT]) {
    if (sticks) {
        const double offset =
            line->cosine * state[TDMF_FOOT_X] + line->sine * (state[TDMF_FOOT_Y] - line->height);
        const double d_offset = -(line->sine * d_line->slope) * state[TDMF_FOOT_X] +
                                line->cosine * d_state[TDMF_FOOT_X] +
                                (line->cosine * d_line->slope * (state[TDMF_FOOT_Y] - line->height) +
                                 line->sine * (d_state[TDMF_FOOT_Y] - d_line->height));
        const double along = line->cosine * state[TDMF_FOOT_VX] + line->sine * state[TDMF_FOOT_VY];
        const double off = line->cosine * state[TDMF_FOOT_VY] - line->sine * state[TDMF_FOOT_VX];
        const double d_along =
            -(line->sine * d_line->slope) * state[TDMF_FOOT_VX] + line->cosine * d_state[TDMF_FOOT_VX] +
            (line->cosine * d_line->slope * state[TDMF_FOOT_VY] + line->sine * d_state[TDMF_FOOT_VY]);
        const double d_off =
            -(line->sine * d_line->slope) * state[TDMF_FOOT_VY] + line->cosine * d_state[TDMF_FOOT_VY] -
            (line->cosine * d_line->slope * state[TDMF_FOOT_VX] + line->sine * d_state[TDMF_FOOT_VX]);
        const tdmf_after_impact result = {
            .foot_x = -(line->sine * d_line->slope) * offset + line->cosine * d_offset,
            .foot_y = d_line->height + (line->cosine * d_line->slope * offset + line->sine * d_offset),
            .leg_length_rate = d_state[TDMF_LEG_LENGTH_RATE] +
                               (-(direction.sine * d_state[TDMF_LEG_ANGLE]) * state[TDMF_FOOT_VY] +
                                direction.cosine * d_state[TDMF_FOOT_VY] -
                                (direction.cosine * d_state[TDMF_LEG_ANGLE] * state[TDMF_FOOT_VX] +
                                 direction.sine * d_state[TDMF_FOOT_VX])),
            .leg_angle_rate =
                d_state[TDMF_LEG_ANGLE_RATE] -
                (-(direction.sine * d_state[TDMF_LEG_ANGLE]) * state[TDMF_FOOT_VX] +
                 direction.cosine * d_state[TDMF_FOOT_VX] +
                 (direction.cosine * d_state[TDMF_LEG_ANGLE] * state[TDMF_FOOT_VY] +
                  direction.sine * d_state[TDMF_FOOT_VY]) -
                 (direction.cosine * state[TDMF_FOOT_VX] + direction.sine * state[TDMF_FOOT_VY]) /
                     state[TDMF_LEG_LENGTH] * d_state[TDMF_LEG_LENGTH]) /
                    state[TDMF_LEG_LENGTH],
            .loss = 0.5 * (d_model->parameters.foot.mass * (along * along + off * off) +
                           model->parameters.foot.mass * (2.0 * (along * d_along) + 2.0 * (off * d_off))),
        };
        return result;
    }
    if (falls) {
        const double offset =
            line->cosine * state[TDMF_FOOT_X] + line->sine * (state[TDMF_FOOT_Y] - line->height);
        const double d_offset = -(line->sine * d_line->slope) * state[TDMF_FOOT_X] +
                                line->cosine * d_state[TDMF_FOOT_X] +
                                (line->cosine * d_line->slope * (state[TDMF_FOOT_Y] - line->height) +
                                 line->sine * (d_state[TDMF_FOOT_Y] - d_line->height));
        const double along = line->cosine * state[TDMF_FOOT_VX] + line->sine * state[TDMF_FOOT_VY];
        const double friction =
            (zone == TDMF_ZONE_PATCH ? model->parameters.ground.patch_friction : inputs->ground.friction);
        const double off = line->cosine * state[TDMF_FOOT_VY] - line->sine * state[TDMF_FOOT_VX];
        const double taken = friction * -off;
        const double left = sign * along - taken;
        const double speed = left + model->parameters.ground.stribeck_velocity *
                                        log1p(-(-(model->parameters.ground.static_friction_ratio - 1.0) *
                                                expm1(-taken / model->parameters.ground.stribeck_velocity)) *
                                              exp(-left / model->parameters.ground.stribeck_velocity));
        const double along_after = sign * (speed >= 0.0 ? speed : 0.0);
        const double d_along =
            -(line->sine * d_line->slope) * state[TDMF_FOOT_VX] + line->cosine * d_state[TDMF_FOOT_VX] +
            (line->cosine * d_line->slope * state[TDMF_FOOT_VY] + line->sine * d_state[TDMF_FOOT_VY]);
        const double d_friction =
            (zone == TDMF_ZONE_PATCH ? d_model->parameters.ground.patch_friction : d_inputs->ground.friction);
        const double d_off =
            -(line->sine * d_line->slope) * state[TDMF_FOOT_VY] + line->cosine * d_state[TDMF_FOOT_VY] -
            (line->cosine * d_line->slope * state[TDMF_FOOT_VX] + line->sine * d_state[TDMF_FOOT_VX]);
        const double d_taken = d_friction * -off + friction * -d_off;
        const double d_left = sign * d_along - d_taken;
        const double d_speed =
            d_left + (d_model->parameters.ground.stribeck_velocity *
                          log1p(-(-(model->parameters.ground.static_friction_ratio - 1.0) *
                                  expm1(-taken / model->parameters.ground.stribeck_velocity)) *
                                exp(-left / model->parameters.ground.stribeck_velocity)) +
                      model->parameters.ground.stribeck_velocity *
                          ((-(-d_model->parameters.ground.static_friction_ratio *
                                  expm1(-taken / model->parameters.ground.stribeck_velocity) +
                              -(model->parameters.ground.static_friction_ratio - 1.0) *
                                  ((expm1(-taken / model->parameters.ground.stribeck_velocity) + 1.0) *
                                   ((-d_taken - -taken / model->parameters.ground.stribeck_velocity *
                                                    d_model->parameters.ground.stribeck_velocity) /
                                    model->parameters.ground.stribeck_velocity))) *
                                exp(-left / model->parameters.ground.stribeck_velocity) +
                            -(-(model->parameters.ground.static_friction_ratio - 1.0) *
                              expm1(-taken / model->parameters.ground.stribeck_velocity)) *
                                (exp(-left / model->parameters.ground.stribeck_velocity) *
                                 ((-d_left - -left / model->parameters.ground.stribeck_velocity *
                                                 d_model->parameters.ground.stribeck_velocity) /
                                  model->parameters.ground.stribeck_velocity))) /
                           (-(-(model->parameters.ground.static_friction_ratio - 1.0) *
                              expm1(-taken / model->parameters.ground.stribeck_velocity)) *
                                exp(-left / model->parameters.ground.stribeck_velocity) +
                            1.0)));
        const double d_along_after = sign * (speed >= 0.0 ? d_speed : 0.0);
        const double d_vx = -(line->sine * d_line->slope) * along_after + line->cosine * d_along_after;
        const double d_vy = line->cosine * d_line->slope * along_after + line->sine * d_along_after;
        const double vy = line->sine * along_after;
        const double lost_y = state[TDMF_FOOT_VY] - vy;
        const double d_lost_y = d_state[TDMF_FOOT_VY] - d_vy;
        const double vx = line->cosine * along_after;
        const double lost_x = state[TDMF_FOOT_VX] - vx;
        const double d_lost_x = d_state[TDMF_FOOT_VX] - d_vx;
        const tdmf_after_impact result = {
            .foot_x = -(line->sine * d_line->slope) * offset + line->cosine * d_offset,
            .foot_y = d_line->height + (line->cosine * d_line->slope * offset + line->sine * d_offset),
            .foot_vx = d_vx,
            .foot_vy = d_vy,
            .leg_length_rate =
                d_state[TDMF_LEG_LENGTH_RATE] +
                (-(direction.sine * d_state[TDMF_LEG_ANGLE]) * lost_y + direction.cosine * d_lost_y -
                 (direction.cosine * d_state[TDMF_LEG_ANGLE] * lost_x + direction.sine * d_lost_x)),
            .leg_angle_rate =
                d_state[TDMF_LEG_ANGLE_RATE] -
                (-(direction.sine * d_state[TDMF_LEG_ANGLE]) * lost_x + direction.cosine * d_lost_x +
                 (direction.cosine * d_state[TDMF_LEG_ANGLE] * lost_y + direction.sine * d_lost_y) -
                 (direction.cosine * lost_x + direction.sine * lost_y) / state[TDMF_LEG_LENGTH] *
                     d_state[TDMF_LEG_LENGTH]) /
                    state[TDMF_LEG_LENGTH],
            .loss = 0.5 * (d_model->parameters.foot.mass *
                               ((along - along_after) * (along + along_after) + off * off) +
                           model->parameters.foot.mass *
                               ((d_along - d_along_after) * (along + along_after) +
                                (along - along_after) * (d_along + d_along_after) + 2.0 * (off * d_off))),
        };
        return result;
    }
    const double offset =
        line->cosine * state[TDMF_FOOT_X] + line->sine * (state[TDMF_FOOT_Y] - line->height);
    const double d_offset = -(line->sine * d_line->slope) * state[TDMF_FOOT_X] +
                            line->cosine * d_state[TDMF_FOOT_X] +
                            (line->cosine * d_line->slope * (state[TDMF_FOOT_Y] - line->height) +
                             line->sine * (d_state[TDMF_FOOT_Y] - d_line->height));
    const double along = line->cosine * state[TDMF_FOOT_VX] + line->sine * state[TDMF_FOOT_VY];
    const double friction =
        (zone == TDMF_ZONE_PATCH ? model->parameters.ground.patch_friction : inputs->ground.friction);
    const double off = line->cosine * state[TDMF_FOOT_VY] - line->sine * state[TDMF_FOOT_VX];
    const double along_after = along + sign * friction * off;
    const double d_along =
        -(line->sine * d_line->slope) * state[TDMF_FOOT_VX] + line->cosine * d_state[TDMF_FOOT_VX] +
        (line->cosine * d_line->slope * state[TDMF_FOOT_VY] + line->sine * d_state[TDMF_FOOT_VY]);
    const double d_friction =
        (zone == TDMF_ZONE_PATCH ? d_model->parameters.ground.patch_friction : d_inputs->ground.friction);
    const double d_off =
        -(line->sine * d_line->slope) * state[TDMF_FOOT_VY] + line->cosine * d_state[TDMF_FOOT_VY] -
        (line->cosine * d_line->slope * state[TDMF_FOOT_VX] + line->sine * d_state[TDMF_FOOT_VX]);
    const double d_along_after = d_along + (sign * d_friction * off + sign * friction * d_off);
    const double d_vx = -(line->sine * d_line->slope) * along_after + line->cosine * d_along_after;
    const double d_vy = line->cosine * d_line->slope * along_after + line->sine * d_along_after;
    const double vy = line->sine * along_after;
    const double lost_y = state[TDMF_FOOT_VY] - vy;
    const double d_lost_y = d_state[TDMF_FOOT_VY] - d_vy;
    const double vx = line->cosine * along_after;
    const double lost_x = state[TDMF_FOOT_VX] - vx;
    const double d_lost_x = d_state[TDMF_FOOT_VX] - d_vx;
    const tdmf_after_impact result = {
        .foot_x = -(line->sine * d_line->slope) * offset + line->cosine * d_offset,
        .foot_y = d_line->height + (line->cosine * d_line->slope * offset + line->sine * d_offset),
        .foot_vx = d_vx,
        .foot_vy = d_vy,
        .leg_length_rate =
            d_state[TDMF_LEG_LENGTH_RATE] +
            (-(direction.sine * d_state[TDMF_LEG_ANGLE]) * lost_y + direction.cosine * d_lost_y -
             (direction.cosine * d_state[TDMF_LEG_ANGLE] * lost_x + direction.sine * d_lost_x)),
        .leg_angle_rate =
            d_state[TDMF_LEG_ANGLE_RATE] -
            (-(direction.sine * d_state[TDMF_LEG_ANGLE]) * lost_x + direction.cosine * d_lost_x +
             (direction.cosine * d_state[TDMF_LEG_ANGLE] * lost_y + direction.sine * d_lost_y) -
             (direction.cosine * lost_x + direction.sine * lost_y) / state[TDMF_LEG_LENGTH] *
                 d_state[TDMF_LEG_LENGTH]) /
                state[TDMF_LEG_LENGTH],
        .loss = 0.5 *
                (d_model->parameters.foot.mass * ((along - along_after) * (along + along_after) + off * off) +
                 model->parameters.foot.mass *
                     ((d_along - d_along_after) * (along + along_after) +
                      (along - along_after) * (d_along + d_along_after) + 2.0 * (off * d_off))),
    };
    return result;
}

#endif
