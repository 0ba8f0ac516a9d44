#include "line.h"

#include "compare.h"

#include <math.h>

/* The model with the parameters as they are, even those of damper, hip and ground that would be refused.
 * Derived numbers do not depend on them. */
static tdmf_model model_of(const tdmf_parameters *parameters) {
    tdmf_parameters accepted = *parameters;
    tdmf_model model;
    accepted.leg.damping = 0.0;
    accepted.leg.thrust = 0.0;
    accepted.hip = tdmf_default_parameters().hip;
    accepted.ground = tdmf_default_parameters().ground;
    assert_null(tdmf_model_create(&model, &accepted).variable);
    model.parameters = *parameters;
    return model;
}

runner line_at(const line *line, double t) {
    runner moved = *line->runner;
    tdmf_parameters parameters = moved.model.parameters;
    double *values = (double *)&parameters;
    const double *seeds = (const double *)&line->seed.parameters;
    for (int i = 0; i < PARAMETERS; ++i) {
        values[i] += t * seeds[i];
    }
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        moved.motion.state[i] += t * line->d_state[i];
    }
    moved.model = model_of(&parameters);
    double *inputs = (double *)&moved.inputs;
    const double *of_inputs = (const double *)&line->seed.inputs;
    for (size_t i = 0; i < sizeof moved.inputs / sizeof *inputs; ++i) {
        inputs[i] += t * of_inputs[i];
    }
    /* The line in force changes with the one that is set, which may be another. */
    moved.motion.mode.ground =
        tdmf_ground_line_of(moved.motion.mode.ground.height + t * line->seed.inputs.ground.height,
                            moved.motion.mode.ground.slope + t * line->seed.inputs.ground.slope);
    return moved;
}

static tdmf_parameters units_of(const tdmf_model *model) {
    const tdmf_scales *scales = &model->scales;
    tdmf_parameters units = model->parameters;
    units.leg.thrust = scales->length;
    units.leg.damping = units.leg.stiffness * scales->time;
    units.hip.stance_torque = scales->energy;
    units.hip.touchdown_angle = 1.0;
    units.hip.kp = scales->energy;
    units.hip.kd = scales->energy * scales->time;
    units.hip.liftoff_angle_factor = 1.0;
    units.hip.retraction_rate = 1.0 / scales->time;
    units.ground.static_friction_ratio = 1.0;
    units.ground.patch_friction = 0.0; /* there is no patch */
    return units;
}

line line_random(random_source *source, const runner *runner) {
    const tdmf_scales *scales = &runner->model.scales;
    const double of_state[TDMF_MECHANICAL_COUNT] = {
        scales->length, scales->length, scales->length, 1.0,
        scales->speed,  scales->speed,  scales->speed,  1.0 / scales->time};
    const tdmf_parameters units = units_of(&runner->model);
    const double *of_parameters = (const double *)&units;
    line line = {.runner = runner};
    double *seeds = (double *)&line.seed.parameters;
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        line.d_state[TDMF_FOOT_X + i] = of_state[i] * random_uniform(source, -1.0, 1.0);
    }
    if (runner->motion.mode.phase == TDMF_PHASE_PLACE) {
        line.d_state[TDMF_HIP_PLACE_TIME] = scales->time * random_uniform(source, -1.0, 1.0);
    }
    for (int i = 0; i < PARAMETERS; ++i) {
        seeds[i] = of_parameters[i] != 0.0 ? of_parameters[i] * random_uniform(source, -1.0, 1.0) : 0.0;
    }
    line.d_state[TDMF_HIP_LIFTOFF_ANGLE] = random_uniform(source, -1.0, 1.0);
    line.seed.inputs.ground.friction = random_uniform(source, -1.0, 1.0);
    line.seed.inputs.hip.external_torque = scales->energy * random_uniform(source, -1.0, 1.0);
    random_source copy = *source; /* all else is as it would be on ground that is held */
    line.seed.inputs.ground.height = scales->length * random_uniform(&copy, -1.0, 1.0);
    line.seed.inputs.ground.slope = random_uniform(&copy, -1.0, 1.0);
    line.seed.inputs.leg.extension = scales->length * random_uniform(&copy, -1.0, 1.0);
    line.seed.inputs.body.external_fx = scales->force * random_uniform(&copy, -1.0, 1.0);
    line.seed.inputs.body.external_fy = scales->force * random_uniform(&copy, -1.0, 1.0);
    line.seed.inputs.control.thrust = scales->length * random_uniform(&copy, -1.0, 1.0);
    line.seed.inputs.control.stance_torque = scales->energy * random_uniform(&copy, -1.0, 1.0);
    line.seed.inputs.control.touchdown_angle = random_uniform(&copy, -1.0, 1.0);
    return line;
}
