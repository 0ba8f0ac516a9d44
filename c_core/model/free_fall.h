/* Free fall: gravity and the external force on the body, as what they accelerate the body alone by, and the
 * centre of mass in flight. */
#ifndef TDMF_MODEL_FREE_FALL_H
#define TDMF_MODEL_FREE_FALL_H

#include "ground_line.h"

#include <stdbool.h>

/* An acceleration, m/s2, or its rate. */
typedef struct {
    double x, y;
} tdmf_fall;

static inline bool tdmf_is_pushed(const tdmf_inputs *inputs) {
    return inputs->body.external_fx != 0.0 || inputs->body.external_fy != 0.0;
}

/* The external force by the body's mass. It is linear in the inputs, so that it serves their rates, too. */
static inline tdmf_fall tdmf_push_on_body(const tdmf_model *model, const tdmf_inputs *inputs) {
    const tdmf_fall push = {inputs->body.external_fx * model->inverse_body_mass,
                            inputs->body.external_fy * model->inverse_body_mass};
    return push;
}

/* Its change. */
static inline tdmf_fall tdmf_vary_push_on_body(const tdmf_model *model, const tdmf_inputs *inputs,
                                               const tdmf_model *d, const tdmf_inputs *d_inputs) {
    const tdmf_fall by_mass = tdmf_push_on_body(d, inputs), by_force = tdmf_push_on_body(model, d_inputs);
    const tdmf_fall d_push = {by_mass.x + by_force.x, by_mass.y + by_force.y};
    return d_push;
}

/* Of the body alone, where it is pushed by so much; and its change. */
static inline tdmf_fall tdmf_fall_of_body(const tdmf_model *model, tdmf_fall push) {
    push.y -= model->parameters.gravity;
    return push;
}

/* Of the centre of mass, where the body is pushed by so much. */
static inline tdmf_fall tdmf_fall_of_center(const tdmf_model *model, tdmf_fall push) {
    const tdmf_fall fall = {model->body_share * push.x,
                            model->body_share * push.y - model->parameters.gravity};
    return fall;
}

/* Its change. */
static inline tdmf_fall tdmf_vary_fall_of_center(const tdmf_model *model, tdmf_fall push, const tdmf_model *d,
                                                 tdmf_fall d_push) {
    const tdmf_fall d_fall = {model->body_share * d_push.x + d->body_share * push.x,
                              model->body_share * d_push.y + d->body_share * push.y - d->parameters.gravity};
    return d_fall;
}

/* What of it is along a line and away from it. */
static inline double tdmf_along_line(const tdmf_ground_line *line, tdmf_fall fall) {
    return tdmf_velocity_along(line, fall.x, fall.y);
}

static inline double tdmf_off_line(const tdmf_ground_line *line, tdmf_fall fall) {
    return tdmf_velocity_off(line, fall.x, fall.y);
}

#endif
