/* Ground force and graze torque at an instant whose leg is evaluated, and their variations.
 *
 * With the foot on the ground (y = vy = ay = 0), sticking or slipping:
 *
 *     f_y = F_s cos(theta) - (tau/r) sin(theta) + m_f g                               (10)
 *     stick:  f_x = -F_s sin(theta) - (tau/r) cos(theta)                              (10)
 *     slip:   f_x = -mu sgn(vx) f_y
 *
 * f_y is the same in stick and slip, so friction never feeds back on it: no Painleve paradox. */
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
    const tdmf_ground_force force = {
        .fx = -leg->axial_force * leg->sine - across * leg->cosine,
        .fy = leg->axial_force * leg->cosine - across * leg->sine + tdmf_foot_weight(at->model),
    };
    return force;
}

static inline tdmf_ground_force tdmf_vary_force_under(const tdmf_evaluation *at, const tdmf_evaluation *d,
                                                      double torque, double d_torque) {
    const tdmf_leg *leg = &at->leg;
    const tdmf_leg *d_leg = &d->leg;
    const double across = torque * leg->inverse_length;
    const double d_across = d_torque * leg->inverse_length + torque * d_leg->inverse_length;
    const tdmf_ground_force d_force = {
        .fx = -d_leg->axial_force * leg->sine - leg->axial_force * d_leg->sine - d_across * leg->cosine -
              across * d_leg->cosine,
        .fy = d_leg->axial_force * leg->cosine + leg->axial_force * d_leg->cosine - d_across * leg->sine -
              across * d_leg->sine + tdmf_vary_foot_weight(at->model, d->model),
    };
    return d_force;
}

/* ---- the force in the mode, where the torque is evaluated ---------------------------------------------- */

static inline tdmf_ground_force tdmf_force_in_mode(const tdmf_evaluation *at) {
    tdmf_ground_force force = {0.0, 0.0};
    if (tdmf_is_loaded(at->mode)) {
        force = tdmf_force_under(at, at->torque);
        if (at->mode->contact != TDMF_CONTACT_STICK) {
            force.fx = -tdmf_signed_friction(at->inputs, at->mode) * force.fy;
        }
    }
    return force;
}

static inline tdmf_ground_force tdmf_vary_force_in_mode(const tdmf_evaluation *at, const tdmf_evaluation *d) {
    tdmf_ground_force d_force = {0.0, 0.0};
    if (tdmf_is_loaded(at->mode)) {
        d_force = tdmf_vary_force_under(at, d, at->torque, d->torque);
        if (at->mode->contact != TDMF_CONTACT_STICK) {
            d_force.fx = -tdmf_signed_friction(d->inputs, at->mode) * at->force.fy -
                         tdmf_signed_friction(at->inputs, at->mode) * d_force.fy;
        }
    }
    return d_force;
}

/* ---- the total torque that keeps an unloaded foot at the ground; see graze.c --------------------------- */

/* sin(theta) with its zero kept out of the denominator. */
static inline double tdmf_bounded_sine(const tdmf_leg *leg) {
    const double size = fabs(leg->sine);
    return copysign(size > TDMF_SMALLEST_SINE ? size : TDMF_SMALLEST_SINE, leg->sine);
}

static inline double tdmf_graze_torque(const tdmf_evaluation *at) {
    const tdmf_leg *leg = &at->leg;
    const double load = leg->axial_force * leg->cosine + tdmf_foot_weight(at->model);
    return load / (tdmf_bounded_sine(leg) * leg->inverse_length);
}

static inline double tdmf_vary_graze_torque(const tdmf_evaluation *at, const tdmf_leg *d_leg,
                                            const tdmf_direction *d) {
    const tdmf_leg *leg = &at->leg;
    const double d_load = d_leg->axial_force * leg->cosine + leg->axial_force * d_leg->cosine +
                          tdmf_vary_foot_weight(at->model, &d->model);
    const double sine = tdmf_bounded_sine(leg);
    const double d_sine = sine == leg->sine ? d_leg->sine : 0.0;
    const double lever = sine * leg->inverse_length;
    const double d_lever = d_sine * leg->inverse_length + sine * d_leg->inverse_length;
    return (d_load - at->torque * d_lever) / lever;
}

#endif
