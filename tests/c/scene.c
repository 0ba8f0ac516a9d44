#include "scene.h"

#include "compare.h"
#include "ranges.h"

#include <math.h>
#include <string.h>

static const double high_friction = 1000.0;

/* Sets the members of a mode that follow from the others. */
static void complete_mode(runner *runner) {
    runner->motion.mode.rises = runner->motion.mode.phase == TDMF_PHASE_RETRACT;
    runner->motion.mode.rest_length = runner->model.parameters.leg.free_length;
}

runner scene_on_ground(tdmf_contact_mode contact, double leg_angle, double vertical_force) {
    runner runner = runner_default(high_friction);
    runner.model.parameters.hip.swing_clamp = true;
    memset(runner.motion.state, 0, sizeof runner.motion.state);
    runner.motion.state[TDMF_LEG_ANGLE] = leg_angle;
    runner.motion.mode.contact = contact;
    runner.motion.mode.phase = contact == TDMF_CONTACT_GRAZE ? TDMF_PHASE_RETRACT : TDMF_PHASE_COAST;
    runner.motion.state[TDMF_HIP_LIFTOFF_ANGLE] = leg_angle;
    complete_mode(&runner);
    scene_set_vertical_force(&runner, vertical_force);
    return runner;
}

runner scene_in_flight(tdmf_hip_phase phase, double com_vy) {
    runner runner = runner_default(high_friction);
    runner.model.parameters.hip.swing_clamp = true;
    memset(runner.motion.state, 0, sizeof runner.motion.state);
    runner.motion.state[TDMF_FOOT_Y] = 1.0;
    runner.motion.state[TDMF_LEG_LENGTH] = 1.0;
    runner.motion.mode.contact = TDMF_CONTACT_FLIGHT;
    runner.motion.mode.phase = phase;
    complete_mode(&runner);
    scene_set_com_vy(&runner, com_vy);
    return runner;
}

runner scene_at_impact(tdmf_hip_phase phase, double leg_angle, double vertical_force) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, leg_angle, vertical_force);
    runner.motion.mode.contact = TDMF_CONTACT_FLIGHT;
    runner.motion.mode.phase = phase;
    complete_mode(&runner);
    runner.motion.state[TDMF_FOOT_Y] = -1e-9;
    scene_set_foot_velocity(0.05, -0.1, runner.motion.state);
    return runner;
}

static double total_torque(const runner *runner) {
    const tdmf_mode *mode = &runner->motion.mode;
    return mode->contact == TDMF_CONTACT_GRAZE ? runner->inputs.hip.external_torque
                                               : OUTPUTS_OF(runner).hip.torque;
}

/* The torque acts through its lever, the leg length sought: a contracting fixed point. */
void scene_set_vertical_force(runner *runner, double vertical_force) {
    const tdmf_parameters *p = &runner->model.parameters;
    const double angle = runner->motion.state[TDMF_LEG_ANGLE];
    const double torque = total_torque(runner);
    double length = p->leg.free_length;
    for (int i = 0; i < 100; ++i) {
        const double axial_force =
            (vertical_force - p->foot.mass * p->gravity + torque / length * sin(angle)) / cos(angle);
        length =
            p->leg.free_length -
            (axial_force + p->leg.damping * runner->motion.state[TDMF_LEG_LENGTH_RATE]) / p->leg.stiffness;
    }
    runner->motion.state[TDMF_LEG_LENGTH] = length;
}

double scene_retract_law(const runner *runner) {
    const tdmf_parameters *p = &runner->model.parameters;
    const double target = p->hip.liftoff_angle_factor * runner->motion.state[TDMF_HIP_LIFTOFF_ANGLE];
    return -p->hip.kp * (runner->motion.state[TDMF_LEG_ANGLE] - target) -
           p->hip.kd * runner->motion.state[TDMF_LEG_ANGLE_RATE];
}

double scene_place_law(const runner *runner) {
    const tdmf_parameters *p = &runner->model.parameters;
    const double omega = p->hip.retraction_rate;
    const double touchdown_angle = p->hip.touchdown_angle + runner->inputs.control.touchdown_angle;
    const double reference = touchdown_angle - omega * runner->motion.state[TDMF_HIP_PLACE_TIME];
    return -p->hip.kp * (runner->motion.state[TDMF_LEG_ANGLE] - reference) -
           p->hip.kd * (runner->motion.state[TDMF_LEG_ANGLE_RATE] + omega);
}

void scene_set_foot_velocity(double vx, double vy, double state[TDMF_STATE_COUNT]) {
    const double sine = sin(state[TDMF_LEG_ANGLE]), cosine = cos(state[TDMF_LEG_ANGLE]);
    const double lost_x = state[TDMF_FOOT_VX] - vx, lost_y = state[TDMF_FOOT_VY] - vy;
    state[TDMF_FOOT_VX] = vx;
    state[TDMF_FOOT_VY] = vy;
    state[TDMF_LEG_LENGTH_RATE] += cosine * lost_y - sine * lost_x;
    state[TDMF_LEG_ANGLE_RATE] -= (cosine * lost_x + sine * lost_y) / state[TDMF_LEG_LENGTH];
}

void scene_set_com_vy(runner *runner, double com_vy) {
    const double *state = runner->motion.state;
    const double share = runner->model.parameters.body.mass / runner->model.total_mass;
    const double climb_of_leg =
        state[TDMF_LEG_LENGTH_RATE] * cos(state[TDMF_LEG_ANGLE]) -
        state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE] * sin(state[TDMF_LEG_ANGLE]);
    runner->motion.state[TDMF_FOOT_VY] = com_vy - share * climb_of_leg;
}

void scene_set_com_vy_by_leg(runner *runner, double com_vy) {
    const double *state = runner->motion.state;
    const double share = runner->model.parameters.body.mass / runner->model.total_mass;
    const double climb_of_turning =
        -state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE] * sin(state[TDMF_LEG_ANGLE]);
    runner->motion.state[TDMF_LEG_LENGTH_RATE] =
        (com_vy / share - climb_of_turning) / cos(state[TDMF_LEG_ANGLE]);
}

void scene_assert_mode(const runner *runner, tdmf_contact_mode contact, tdmf_hip_phase phase) {
    assert_int_equal(runner->motion.mode.contact, contact);
    assert_int_equal(runner->motion.mode.phase, phase);
    assert_false(runner->motion.mode.fallen);
}

/* Member by member with memcpy, so that padding is copied too. */
void scene_take_snapshot(const runner *runner, scene_snapshot *snapshot) {
    memcpy(snapshot->state, runner->motion.state, sizeof snapshot->state);
    memcpy(&snapshot->mode, &runner->motion.mode, sizeof snapshot->mode);
}

void scene_assert_unchanged(const runner *runner, const scene_snapshot *before) {
    assert_memory_equal(runner->motion.state, before->state, sizeof before->state);
    assert_memory_equal(&runner->motion.mode, &before->mode, sizeof before->mode);
}

double scene_guard(const runner *runner, tdmf_guard guard) {
    double guards[TDMF_GUARD_COUNT];
    tdmf_guards(SYSTEM_OF(runner), &runner->motion.mode, runner->motion.state, guards);
    return guards[guard];
}

tdmf_resolution scene_resolve(runner *runner) {
    const tdmf_resolution resolution = tdmf_resolve(SYSTEM_OF(runner), &runner->motion);
    assert_false(resolution.unresolved);
    assert_true(!runner->motion.mode.clamp_closed || (runner->motion.mode.phase == TDMF_PHASE_RETRACT &&
                                                      runner->model.parameters.hip.swing_clamp));
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        assert_true(scene_guard(runner, (tdmf_guard)i) > 0.0);
    }
    return resolution;
}

/* Draws from a copy of the source, so that the values drawn from the source itself are unchanged. */
static void choose_further_laws(random_source copy, tdmf_parameters *p) {
    copy.state ^= UINT64_C(0x6a09e667f3bcc909);
    p->ground.static_friction_ratio = random_uniform(&copy, 1.1, 1.5);
    if (random_chance(&copy, 0.5)) {
        p->hip.retraction_rate = random_uniform(&copy, -0.05, 0.05) * sqrt(p->leg.stiffness / p->body.mass);
    }
}

void scene_leave_minima(tdmf_parameters *parameters) {
    for (int i = 0; i < TDMF_PARAMETER_COUNT; ++i) {
        const tdmf_range *range = &tdmf_parameter_ranges[i];
        double *value = (double *)((char *)parameters + range->offset);
        if (*value == range->minimum) {
            *value += 0.3;
        }
    }
}

void scene_lighten_foot_and_stiffen_leg(runner *runner) {
    tdmf_parameters parameters = runner->model.parameters;
    parameters.foot.mass = 1e-6 * parameters.body.mass;
    parameters.leg.stiffness *= 1e4;
    assert_null(tdmf_model_create(&runner->model, &parameters).variable);
}

static tdmf_parameters random_parameters(random_source *source) {
    tdmf_parameters p = tdmf_default_parameters();
    p.body.mass = random_magnitude(source, 0.1, 100.0);
    p.leg.stiffness = random_magnitude(source, 0.1, 1e4);
    p.leg.free_length = random_magnitude(source, 0.1, 10.0);
    const double length = p.leg.free_length;
    const double energy = p.leg.stiffness * length * length;
    const double impedance = sqrt(p.body.mass * p.leg.stiffness);
    p.leg.min_length = 0.3 * length;
    p.gravity = random_magnitude(source, 1e-3, 0.1) * p.leg.stiffness * length / p.body.mass;
    p.foot.mass = random_magnitude(source, 0.02, 1.0) * p.body.mass;
    p.leg.damping = random_chance(source, 0.1) ? 0.0 : random_magnitude(source, 0.02, 2.0) * impedance;
    p.hip.stance_torque = random_uniform(source, -0.5, 0.5) * energy;
    p.hip.touchdown_angle = random_uniform(source, -1.2, 1.2);
    p.hip.kp = random_magnitude(source, 0.01, 1.0) * energy;
    p.hip.kd = random_magnitude(source, 0.01, 1.0) * length * length * impedance;
    p.hip.liftoff_angle_factor = random_uniform(source, 0.0, 2.0);
    choose_further_laws(*source, &p);
    p.hip.swing_clamp = random_truth(*source);
    return p;
}

static tdmf_inputs random_inputs(random_source *source, const tdmf_model *model) {
    tdmf_inputs inputs = tdmf_default_inputs();
    inputs.ground.friction = random_chance(source, 0.1) ? 0.0 : random_magnitude(source, 0.01, 10.0);
    if (random_chance(source, 0.5)) {
        inputs.hip.external_torque = random_uniform(source, -0.3, 0.3) * model->scales.energy;
    }
    return inputs;
}

static void random_state(random_source *source, runner *runner) {
    const tdmf_scales *scales = &runner->model.scales;
    double *state = runner->motion.state;
    const double sign = random_chance(source, 0.5) ? 1.0 : -1.0;
    state[TDMF_FOOT_X] = random_uniform(source, -3.0, 3.0) * scales->length;
    state[TDMF_FOOT_Y] = random_uniform(source, 0.0, 3.0) * scales->length;
    state[TDMF_LEG_LENGTH] = random_uniform(source, 0.4, 1.6) * scales->length;
    state[TDMF_LEG_ANGLE] = sign * random_uniform(source, 0.1, 1.4);
    state[TDMF_FOOT_VX] = random_uniform(source, -2.0, 2.0) * scales->speed;
    state[TDMF_FOOT_VY] = random_uniform(source, -2.0, 2.0) * scales->speed;
    state[TDMF_LEG_LENGTH_RATE] = random_uniform(source, -1.0, 1.0) * scales->speed;
    state[TDMF_LEG_ANGLE_RATE] = random_uniform(source, -2.0, 2.0) / scales->time;
}

/* Chooses level ground in half of the cases. Draws from a copy of the source, as choose_further_laws does. */
static void choose_ground(random_source copy, runner *runner) {
    copy.state ^= UINT64_C(0xbb67ae8584caa73b);
    if (random_chance(&copy, 0.5)) {
        runner->inputs.ground.slope = random_uniform(&copy, -0.7, 0.7);
        runner->inputs.ground.height = random_uniform(&copy, -2.0, 2.0) * runner->model.scales.length;
        if (fabs(runner->motion.state[TDMF_LEG_ANGLE] - runner->inputs.ground.slope) > 1.4) {
            runner->inputs.ground.slope *= -1.0; /* the body is above the ground */
        }
    }
    runner->motion.mode.ground =
        tdmf_ground_line_of(runner->inputs.ground.height, runner->inputs.ground.slope);
    if (runner->motion.mode.contact == TDMF_CONTACT_FLIGHT && random_chance(&copy, 0.3)) { /* it waits */
        runner->inputs.ground.height += random_uniform(&copy, 0.0, 6.0) * runner->model.scales.length;
        runner->inputs.ground.slope = random_uniform(&copy, -0.7, 0.7);
    }
}

/* Constrains the foot's motion as its contact mode does. The motion is drawn along the ground and off it. */
static void constrain(runner *runner) {
    const tdmf_ground_line *ground = &runner->motion.mode.ground;
    double *state = runner->motion.state;
    const double sign = tdmf_sign_of_slip(&runner->motion.mode);
    const bool flies = runner->motion.mode.contact == TDMF_CONTACT_FLIGHT;
    const double along = state[TDMF_FOOT_X], off = flies ? state[TDMF_FOOT_Y] : 0.0;
    const double rate = flies ? state[TDMF_FOOT_VY] : 0.0;
    double velocity = state[TDMF_FOOT_VX];
    if (runner->motion.mode.contact == TDMF_CONTACT_STICK) {
        velocity = 0.0;
    } else if (sign != 0.0) {
        velocity = copysign(velocity, sign);
    }
    state[TDMF_FOOT_X] = along * ground->cosine - off * ground->sine;
    state[TDMF_FOOT_Y] = ground->height + along * ground->sine + off * ground->cosine;
    state[TDMF_FOOT_VX] = velocity * ground->cosine - rate * ground->sine;
    state[TDMF_FOOT_VY] = velocity * ground->sine + rate * ground->cosine;
}

runner scene_random(random_source *source, tdmf_contact_mode contact) {
    runner runner = runner_default(0.0);
    const tdmf_parameters parameters = random_parameters(source);
    assert_null(tdmf_model_create(&runner.model, &parameters).variable);
    runner.inputs = random_inputs(source, &runner.model);
    random_state(source, &runner);
    const bool first = random_chance(source, 0.5);
    runner.motion.mode.contact = contact;
    runner.motion.state[TDMF_HIP_LIFTOFF_ANGLE] = random_uniform(source, -1.2, 1.2);
    if (tdmf_is_loaded(&runner.motion.mode)) {
        runner.motion.mode.phase = first ? TDMF_PHASE_DRIVE : TDMF_PHASE_COAST;
        runner.motion.mode.mid_stance_pending = first;
    } else {
        runner.motion.mode.phase = first ? TDMF_PHASE_RETRACT : TDMF_PHASE_PLACE;
        runner.motion.mode.clamp_closed =
            first && parameters.hip.swing_clamp && scene_retract_law(&runner) < 0.0;
        runner.motion.state[TDMF_HIP_PLACE_TIME] =
            first ? 0.0 : random_uniform(source, 0.0, 10.0) * runner.model.scales.time;
    }
    complete_mode(&runner);
    choose_ground(*source, &runner);
    constrain(&runner);
    return runner;
}

double scene_short_time(const runner *runner) {
    return 0.005 / (1.0 / runner->model.scales.time + fabs(runner->motion.state[TDMF_LEG_ANGLE_RATE]));
}

double time_factor(const factors *by) {
    return sqrt(by->mass / by->stiffness);
}

double energy_factor(const factors *by) {
    return by->stiffness * by->length * by->length;
}

tdmf_parameters scaled_parameters(tdmf_parameters p, const factors *by) {
    p.body.mass *= by->mass;
    p.foot.mass *= by->mass;
    p.leg.stiffness *= by->stiffness;
    p.leg.damping *= sqrt(by->mass * by->stiffness);
    p.leg.free_length *= by->length;
    p.leg.min_length *= by->length;
    p.gravity *= by->stiffness * by->length / by->mass;
    p.hip.stance_torque *= energy_factor(by);
    p.hip.kp *= energy_factor(by);
    p.hip.kd *= energy_factor(by) * time_factor(by);
    p.hip.retraction_rate /= time_factor(by);
    p.leg.thrust *= by->length;
    return p;
}

double factor_of_element(const factors *by, int element) {
    const double speed = by->length / time_factor(by);
    const double mechanical[TDMF_MECHANICAL_COUNT] = {
        by->length, by->length, by->length, 1.0, speed, speed, speed, 1.0 / time_factor(by)};
    const bool is_mechanical = element >= TDMF_FOOT_X && element <= TDMF_LEG_ANGLE_RATE;
    const double other = element == TDMF_HIP_PLACE_TIME ? time_factor(by) : energy_factor(by);
    return is_mechanical ? mechanical[element - TDMF_FOOT_X] : other;
}

tdmf_inputs scaled_inputs(tdmf_inputs inputs, const factors *by) {
    inputs.leg.extension *= by->length;
    inputs.ground.height *= by->length;
    inputs.body.external_fx *= by->stiffness * by->length;
    inputs.body.external_fy *= by->stiffness * by->length;
    inputs.control.stance_torque *= energy_factor(by);
    inputs.hip.external_torque *= energy_factor(by);
    return inputs;
}
