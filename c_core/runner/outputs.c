/* Outputs and rates of the runner's page at an instant of a motion, and their variations. */
#include "tdmf_slip/outputs.h"

#include "contact_mode.h"
#include "ground_line.h"
#include "input_rates.h"
#include "motion_instant.h"
#include "page_fields.h"
#include "run_state.h"
#include "tdmf_slip/contact.h"
#include "tdmf_slip/dynamics.h"
#include "tdmf_slip/energy.h"
#include "tdmf_slip/hip.h"
#include "tdmf_slip/impact.h"
#include "tdmf_slip/kinematics.h"
#include "tdmf_slip/output_variation.h"

#include <math.h>
#include <string.h>

/* ---- outputs ------------------------------------------------------------------------------------------- */

static void evaluate(tdmf_motion_instant *instant, tdmf_system system, const tdmf_mode *mode,
                     const double state[TDMF_STATE_COUNT]) {
    tdmf_begin_instant(instant, system, mode, state);
    tdmf_write_outputs(instant);
    if (!tdmf_is_mode(mode)) { /* nothing that follows from the laws passes for a result */
        double *o = instant->outputs;
        o[OUTPUT_torque] = o[OUTPUT_normal_force] = o[OUTPUT_tangential_force] = NAN;
        o[OUTPUT_ground_force_x] = o[OUTPUT_ground_force_y] = NAN;
    }
}

/* Points and energies of the page, with heights above y = `base`, or their variations. */
static tdmf_point body_of(const double *o, double base) {
    const tdmf_point body = {o[OUTPUT_body_x], base + o[OUTPUT_body_y], o[OUTPUT_body_vx], o[OUTPUT_body_vy]};
    return body;
}

static tdmf_point center_of(const double *o, double base) {
    const tdmf_point center = {o[OUTPUT_center_x], base + o[OUTPUT_center_y], o[OUTPUT_center_vx],
                               o[OUTPUT_center_vy]};
    return center;
}

static tdmf_energy energy_of(const double *o, double of_base) {
    const tdmf_energy energy = {o[OUTPUT_kinetic_energy], of_base + o[OUTPUT_potential_energy],
                                o[OUTPUT_elastic_energy], of_base + o[OUTPUT_energy]};
    return energy;
}

static tdmf_ground_force force_of(const double *o) {
    const tdmf_ground_force force = {o[OUTPUT_tangential_force], o[OUTPUT_normal_force]};
    return force;
}

static double energy_of_base(const tdmf_model *model, double base) {
    return model->total_mass * model->parameters.gravity * base;
}

double tdmf_hip_torque(tdmf_system system, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]) {
    tdmf_motion_instant instant;
    evaluate(&instant, system, mode, state);
    return instant.outputs[OUTPUT_torque];
}

tdmf_ground_force tdmf_contact_force(tdmf_system system, const tdmf_mode *mode,
                                     const double state[TDMF_STATE_COUNT]) {
    tdmf_motion_instant instant;
    evaluate(&instant, system, mode, state);
    return force_of(instant.outputs);
}

tdmf_ground_force tdmf_sticking_force(tdmf_system system, const tdmf_mode *mode, double torque,
                                      const double state[TDMF_STATE_COUNT]) {
    tdmf_inputs inputs = *system.inputs;
    tdmf_mode coasts = *mode;
    inputs.hip.external_torque = torque;
    coasts.contact = TDMF_CONTACT_STICK;
    coasts.phase = TDMF_PHASE_COAST;
    coasts.fallen = false;
    return tdmf_contact_force((tdmf_system){system.model, &inputs}, &coasts, state);
}

tdmf_energy tdmf_mechanical_energy(tdmf_system system, const tdmf_mode *mode,
                                   const double state[TDMF_STATE_COUNT]) {
    tdmf_motion_instant instant;
    evaluate(&instant, system, mode, state);
    return energy_of(instant.outputs, energy_of_base(system.model, instant.point.base));
}

tdmf_outputs tdmf_outputs_of(tdmf_system system, const tdmf_motion *motion) {
    const tdmf_mode *mode = &motion->mode;
    const tdmf_record *record = &motion->record;
    tdmf_motion_instant instant;
    evaluate(&instant, system, mode, motion->state);
    const double *o = instant.outputs, base = instant.point.base;
    const tdmf_point body = body_of(o, base), com = center_of(o, base);
    const tdmf_energy energy = energy_of(o, energy_of_base(system.model, base));
    const tdmf_outputs outputs = {
        .body = {body.x, body.y, body.vx, body.vy},
        .com = {com.x, com.y, com.vx, com.vy},
        .contact = {o[OUTPUT_ground_force_x], o[OUTPUT_ground_force_y], o[OUTPUT_normal_force],
                    o[OUTPUT_tangential_force], (int)mode->contact, (int)mode->contact},
        .ground = {tdmf_ground_is_pending(system.inputs, mode)},
        .leg = {o[OUTPUT_force_of_leg]},
        .hip = {o[OUTPUT_torque], mode->liftoff_angle, (int)mode->phase, (int)mode->phase},
        .energy = {energy.kinetic, energy.potential, energy.elastic, energy.total, record->impact_loss},
        .event = {record->event_count, record->last_event_time},
        .status = {mode->fallen},
        .stride = record->stride,
        .apex = record->apex,
    };
    return outputs;
}

/* ---- positions: the world's states are enough ------------------------------------------------------------
 */

static void evaluate_world(const runner_parameters *p, const double state[TDMF_STATE_COUNT],
                           double outputs[OUTPUT_COUNT]) {
    runner_states x;
    memcpy(&x, tdmf_runner_model.state_defaults, sizeof x);
    tdmf_read_page_state(state, &x);
    tdmf_runner_model.modes[MODE_start_of_run].outputs((const double *)p, (const double *)&x, outputs);
}

tdmf_point tdmf_body(const double state[TDMF_STATE_COUNT]) {
    runner_parameters p;
    double outputs[OUTPUT_COUNT];
    memcpy(&p, tdmf_runner_model.parameter_defaults, sizeof p);
    evaluate_world(&p, state, outputs);
    return body_of(outputs, 0.0);
}

tdmf_point tdmf_center_of_mass(const tdmf_model *model, const double state[TDMF_STATE_COUNT]) {
    const tdmf_inputs inputs = tdmf_default_inputs();
    const runner_parameters p = tdmf_page_parameters(&model->parameters, &inputs);
    double outputs[OUTPUT_COUNT];
    evaluate_world(&p, state, outputs);
    return center_of(outputs, 0.0);
}

tdmf_point tdmf_foot_over_ground(const tdmf_ground_line *ground, const double state[TDMF_STATE_COUNT]) {
    const double x = state[TDMF_FOOT_X], y = state[TDMF_FOOT_Y] - ground->height;
    const double vx = state[TDMF_FOOT_VX], vy = state[TDMF_FOOT_VY];
    const tdmf_point foot = {ground->cosine * x + ground->sine * y, ground->cosine * y - ground->sine * x,
                             ground->cosine * vx + ground->sine * vy,
                             ground->cosine * vy - ground->sine * vx};
    return foot;
}

/* ---- impact -------------------------------------------------------------------------------------------- */

double tdmf_impact(tdmf_system system, const tdmf_ground_line *ground, double state[TDMF_STATE_COUNT]) {
    const tdmf_mode flies = {.contact = TDMF_CONTACT_FLIGHT,
                             .phase = TDMF_PHASE_PLACE,
                             .rest_length = system.model->parameters.leg.free_length,
                             .ground = *ground};
    tdmf_motion_instant instant;
    tdmf_begin_instant(&instant, system, &flies, state);
    const tdmf_mode_kind *mode = instant.at.mode;
    const double *p = instant.at.p, *x = instant.at.x;
    runner_states after = instant.point.x, seen;
    for (int i = 0; i < mode->guard_count; ++i) {
        const tdmf_guard_kind *kind = &mode->guards[i];
        if (kind->event == EVENT_touchdown) {
            const int next = kind->react(p, x, NULL, (double *)&after, kind->next);
            tdmf_show_to_world(&tdmf_runner_model, next, p, (double *)&after, (double *)&seen);
        }
    }
    after.seen_y += instant.point.base;
    tdmf_write_page_state(&after, state);
    return after.impact_loss;
}

/* ---- rates --------------------------------------------------------------------------------------------- */

void tdmf_derivatives(tdmf_system system, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                      double derivatives[TDMF_STATE_COUNT]) {
    tdmf_motion_instant instant;
    runner_states rates;
    tdmf_begin_instant(&instant, system, mode, state);
    tdmf_page_world_rates(&instant.at, (double *)&rates);
    tdmf_write_page_state(&rates, derivatives);
    if (!tdmf_is_mode(mode)) {
        derivatives[TDMF_LEG_LENGTH_RATE] = derivatives[TDMF_LEG_ANGLE_RATE] = NAN;
    }
}

/* Friction falls with the foot's speed. */
static bool friction_falls(const tdmf_model *model) {
    return model->parameters.ground.stribeck_velocity > 0.0 &&
           model->parameters.ground.static_friction_ratio > 1.0;
}

void tdmf_state_scales(const tdmf_model *model, double scales[TDMF_STATE_COUNT]) {
    const tdmf_inputs inputs = tdmf_default_inputs();
    const runner_parameters p = tdmf_page_parameters(&model->parameters, &inputs);
    runner_states of_states;
    double of_events[EVENT_COUNT];
    tdmf_runner_model.scales((const double *)&p, (double *)&of_states, of_events);
    tdmf_write_page_state(&of_states, scales);
    if (friction_falls(model)) {
        const double speed = fmin(model->scales.speed, model->parameters.ground.stribeck_velocity);
        scales[TDMF_FOOT_VX] = scales[TDMF_FOOT_VY] = speed;
    }
}

/* ---- variations ---------------------------------------------------------------------------------------- */

tdmf_output_variation tdmf_vary_outputs(tdmf_system system, const tdmf_mode *mode,
                                        const double state[TDMF_STATE_COUNT], const tdmf_seed *seed,
                                        const tdmf_variation *variation) {
    static const tdmf_seed unchanged = {.inputs = {.ground = {.friction = 0.0}}};
    static const tdmf_variation unvaried = {.liftoff_angle = 0.0};
    tdmf_motion_instant instant;
    double o[OUTPUT_COUNT];
    runner_states d_rates;
    const tdmf_seed *given = seed != NULL ? seed : &unchanged;
    const tdmf_inputs rates = tdmf_rates_with_varied_push(&tdmf_zero_input_rates, given, 1);
    tdmf_begin_ramped_instant(&instant, system, &rates, mode, state);
    tdmf_page_direction d =
        tdmf_page_of_variation(&instant.point, state, given, variation != NULL ? variation : &unvaried);
    d.x.height = d.p.ground_height; /* the line in force changes with the one that is set */
    d.x.slope = d.p.ground_slope;
    const double *dp = (const double *)&d.p, *dx = (const double *)&d.x;
    instant.at.mode->vary_outputs(instant.at.p, instant.at.x, dp, dx, o);
    tdmf_vary_page_rates(&instant.at, dp, dx, (double *)&d_rates);
    const double d_mass = given->parameters.body.mass + given->parameters.foot.mass;
    const double of_base = instant.point.base * (d_mass * system.model->parameters.gravity +
                                                 system.model->total_mass * given->parameters.gravity);
    tdmf_output_variation varied = {
        .body = body_of(o, 0.0),
        .com = center_of(o, 0.0),
        .contact = force_of(o),
        .contact_fx = o[OUTPUT_ground_force_x],
        .contact_fy = o[OUTPUT_ground_force_y],
        .torque = o[OUTPUT_torque],
        .leg_force = o[OUTPUT_force_of_leg],
        .energy = energy_of(o, of_base),
    };
    tdmf_write_page_state(&d_rates, varied.derivatives);
    return varied;
}
