/* Outputs and rates of the runner's page at an instant of a motion. */
#include "tdmf_slip/outputs.h"

#include "contact_mode.h"
#include "ground_line.h"
#include "input_rates.h"
#include "kinematics.h"
#include "motion_instant.h"
#include "page_fields.h"
#include "tdmf_slip/automaton.h"
#include "words.h"

#include <math.h>
#include <string.h>

/* ---- outputs ------------------------------------------------------------------------------------------- */

/* Points of the page, with heights above a base. */
static tdmf_point body_of(const double *o, double base) {
    const tdmf_point body = {o[OUTPUT_body_x], base + o[OUTPUT_body_y], o[OUTPUT_body_vx], o[OUTPUT_body_vy]};
    return body;
}

static tdmf_point center_of(const double *o, double base) {
    const tdmf_point center = {o[OUTPUT_center_x], base + o[OUTPUT_center_y], o[OUTPUT_center_vx],
                               o[OUTPUT_center_vy]};
    return center;
}

void tdmf_outputs_of(tdmf_system system, const tdmf_motion *motion, tdmf_outputs *outputs) {
    const tdmf_mode *mode = &motion->mode;
    const runner_states *x = (const void *)motion->state;
    tdmf_motion_instant instant;
    tdmf_begin_instant(&instant, system, mode, motion->state);
    tdmf_write_outputs(&instant);
    double *o = instant.outputs, base = instant.point.base;
    if (!tdmf_is_mode(mode)) { /* results of the laws are not available */
        o[OUTPUT_torque] = o[OUTPUT_normal_force] = o[OUTPUT_tangential_force] = NAN;
        o[OUTPUT_ground_force_x] = o[OUTPUT_ground_force_y] = NAN;
    }
    const double energy_of_base = system.model->total_mass * system.model->parameters.gravity * base;
    memset(outputs, 0, sizeof *outputs);
    outputs->body = body_of(o, base);
    outputs->com = center_of(o, base);
    outputs->contact.fx = o[OUTPUT_ground_force_x];
    outputs->contact.fy = o[OUTPUT_ground_force_y];
    outputs->contact.normal = o[OUTPUT_normal_force];
    outputs->contact.tangential = o[OUTPUT_tangential_force];
    outputs->leg.force = o[OUTPUT_force_of_leg];
    outputs->hip.torque = o[OUTPUT_torque];
    outputs->energy.kinetic = o[OUTPUT_kinetic_energy];
    outputs->energy.potential = energy_of_base + o[OUTPUT_potential_energy];
    outputs->energy.elastic = o[OUTPUT_elastic_energy];
    outputs->energy.total = energy_of_base + o[OUTPUT_energy];
    outputs->contact.mode = outputs->contact.mode_index = (int)mode->contact;
    outputs->ground.pending = tdmf_ground_is_pending(system.inputs, mode);
    outputs->hip.liftoff_angle = x->liftoff_angle;
    outputs->hip.phase = outputs->hip.phase_index = (int)mode->phase;
    outputs->energy.impact_loss = x->impact_loss;
    outputs->event.count = tdmf_count_of(x->events);
    outputs->event.last_time = motion->begun + fmax(x->last_event, 0.0);
    outputs->status.fallen = mode->fallen;
    outputs->stride = tdmf_page_stride_of(x);
    outputs->apex = tdmf_page_apex_of(x, motion->begun);
    tdmf_write_word(x->word_so_far, outputs->open_word);
}

/* ---- positions: the world's states are enough ------------------------------------------------------------
 */

static void evaluate_world(const runner_parameters *p, const double state[TDMF_STATE_COUNT],
                           double outputs[OUTPUT_COUNT]) {
    tdmf_runner_model.modes[MODE_start_of_run].outputs((const double *)p, state, outputs);
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

/* ---- rates --------------------------------------------------------------------------------------------- */

void tdmf_derivatives(tdmf_system system, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT],
                      double derivatives[TDMF_STATE_COUNT]) {
    tdmf_motion_instant instant;
    double rates[TDMF_STATE_COUNT];
    tdmf_begin_instant(&instant, system, mode, state);
    tdmf_page_world_rates(&instant.at, rates);
    memcpy(derivatives, rates, sizeof rates);
    if (!tdmf_is_mode(mode)) {
        derivatives[TDMF_LEG_LENGTH_RATE] = derivatives[TDMF_LEG_ANGLE_RATE] = NAN;
    }
}
