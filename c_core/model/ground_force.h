/* Ground force and graze torque at an instant whose leg is evaluated, and their variations.
 *
 * With the foot on the ground, a line of slope sigma, sticking or slipping along it, and theta' = theta -
 * sigma:
 *
 *     f_n = F_s cos(theta') - (tau/r) sin(theta') + m_f g cos(sigma)                   (10)
 *     stick:  f_t = -F_s sin(theta') - (tau/r) cos(theta') + m_f g sin(sigma)          (10)
 *     slip:   f_t = -mu sgn(v_t) f_n
 *
 * f_n is the same in stick and slip, so friction never feeds back on it: no Painleve paradox. */
#ifndef TDMF_MODEL_GROUND_FORCE_H
#define TDMF_MODEL_GROUND_FORCE_H

#include "evaluated.h"
#include "friction.h"
#include "margins.h"

/* m_f g, and its change. */
static inline double tdmf_foot_weight(const tdmf_model *model) {
    return model->parameters.foot.mass * model->parameters.gravity;
}

static inline double tdmf_vary_foot_weight(const tdmf_model *model, const tdmf_model *d) {
    return d->parameters.foot.mass * model->parameters.gravity +
           model->parameters.foot.mass * d->parameters.gravity;
}

/* ---- the force that would hold the foot still under a torque (10), whatever the mode ------------------- */

static inline tdmf_ground_force tdmf_force_under(const tdmf_evaluation *at, double torque) {
    const tdmf_leg *leg = &at->leg;
    const double across = torque * leg->inverse_length;
    const double weight = tdmf_foot_weight(at->model);
    const tdmf_ground_line *line = &at->mode->ground;
    const tdmf_ground_force force = {
        .tangential =
            -leg->axial_force * leg->ground_sine - across * leg->ground_cosine + weight * line->sine,
        .normal = leg->axial_force * leg->ground_cosine - across * leg->ground_sine + weight * line->cosine,
    };
    return force;
}

static inline tdmf_ground_force tdmf_vary_force_under(const tdmf_evaluation *at, const tdmf_evaluation *d,
                                                      double torque, double d_torque) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg *d_leg = &d->leg;
    const double across = torque * leg->inverse_length;
    const double d_across = d_torque * leg->inverse_length + torque * d_leg->inverse_length;
    const double weight = tdmf_foot_weight(at->model);
    const double d_weight = tdmf_vary_foot_weight(at->model, d->model);
    const tdmf_ground_line *line = &at->mode->ground;
    const double d_slope = d->mode->ground.slope;
    const tdmf_ground_force d_force = {
        .tangential = -d_leg->axial_force * leg->ground_sine - leg->axial_force * d_leg->ground_sine -
                      d_across * leg->ground_cosine - across * d_leg->ground_cosine + d_weight * line->sine +
                      weight * line->cosine * d_slope,
        .normal = d_leg->axial_force * leg->ground_cosine + leg->axial_force * d_leg->ground_cosine -
                  d_across * leg->ground_sine - across * d_leg->ground_sine + d_weight * line->cosine -
                  weight * line->sine * d_slope,
    };
    return d_force;
}

/* ---- the force in the mode, where the torque is evaluated ---------------------------------------------- */

static inline tdmf_ground_force tdmf_force_in_mode(const tdmf_evaluation *at) {
    tdmf_ground_force force = {0.0, 0.0};
    if (tdmf_is_loaded(at->mode)) {
        force = tdmf_force_under(at, at->torque);
        if (at->mode->contact != TDMF_CONTACT_STICK) {
            force.tangential = -tdmf_signed_friction(at->inputs, at->mode) * force.normal;
        }
    }
    return force;
}

static inline tdmf_ground_force tdmf_vary_force_in_mode(const tdmf_evaluation *at, const tdmf_evaluation *d) {
    tdmf_ground_force d_force = {0.0, 0.0};
    if (tdmf_is_loaded(at->mode)) {
        d_force = tdmf_vary_force_under(at, d, at->torque, d->torque);
        if (at->mode->contact != TDMF_CONTACT_STICK) {
            d_force.tangential = -tdmf_signed_friction(d->inputs, at->mode) * at->force.normal -
                                 tdmf_signed_friction(at->inputs, at->mode) * d_force.normal;
        }
    }
    return d_force;
}

/* ---- the total torque that keeps an unloaded foot at the ground; see graze.c --------------------------- */

/* sin(theta') with its zero kept out of the denominator. */
static inline double tdmf_bounded_sine(const tdmf_leg *leg) {
    const double size = fabs(leg->ground_sine);
    return copysign(size > TDMF_SMALLEST_SINE ? size : TDMF_SMALLEST_SINE, leg->ground_sine);
}

static inline double tdmf_graze_torque(const tdmf_evaluation *at) {
    const tdmf_leg *leg = &at->leg;
    const double load =
        leg->axial_force * leg->ground_cosine + tdmf_foot_weight(at->model) * at->mode->ground.cosine;
    return load / (tdmf_bounded_sine(leg) * leg->inverse_length);
}

static inline double tdmf_vary_graze_torque(const tdmf_evaluation *at, const tdmf_leg *d_leg,
                                            const tdmf_direction *d) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_ground_line *line = &at->mode->ground;
    const double d_load = d_leg->axial_force * leg->ground_cosine + leg->axial_force * d_leg->ground_cosine +
                          tdmf_vary_foot_weight(at->model, &d->model) * line->cosine -
                          tdmf_foot_weight(at->model) * line->sine * d->mode.ground.slope;
    const double sine = tdmf_bounded_sine(leg);
    const double d_sine = sine == leg->ground_sine ? d_leg->ground_sine : 0.0;
    const double lever = sine * leg->inverse_length;
    const double d_lever = d_sine * leg->inverse_length + sine * d_leg->inverse_length;
    return (d_load - at->torque * d_lever) / lever;
}

/* ---- horizontal and vertical --------------------------------------------------------------------------- */

typedef struct {
    double x, y;
} tdmf_world_force;

static inline tdmf_world_force tdmf_force_in_world(const tdmf_ground_line *line, tdmf_ground_force force) {
    const tdmf_world_force in_world = {force.tangential * line->cosine - force.normal * line->sine,
                                       force.tangential * line->sine + force.normal * line->cosine};
    return in_world;
}

static inline tdmf_world_force tdmf_vary_force_in_world(const tdmf_evaluation *at, const tdmf_evaluation *d) {
    const tdmf_world_force force = tdmf_force_in_world(&at->mode->ground, at->force);
    tdmf_world_force d_force = tdmf_force_in_world(&at->mode->ground, d->force);
    d_force.x -= force.y * d->mode->ground.slope;
    d_force.y += force.x * d->mode->ground.slope;
    return d_force;
}

#endif
