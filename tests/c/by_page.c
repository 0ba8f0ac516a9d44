#include "by_page.h"

#include "input_rates.h"
#include "motion_instant.h"
#include "page_fields.h"
#include "page_variation.h"
#include "test.h"

#include <string.h>

void vary_run(tdmf_system system, const double start[TDMF_STATE_COUNT], const tdmf_seed *seed,
              const double d_start[TDMF_STATE_COUNT], double time, double d_states[TDMF_STATE_COUNT]) {
    runner_parameters p = tdmf_page_parameters(&system.model->parameters, system.inputs);
    tdmf_page_direction d = tdmf_direction_of_seed(seed);
    double states[TDMF_STATE_COUNT], ends[TDMF_STATE_COUNT], outputs[OUTPUT_COUNT], d_outputs[OUTPUT_COUNT];
    int mode, sampled = 0;
    p.notes_compression = 1.0; /* as a motion has it */
    const size_t size = TDMF_MECHANICAL_COUNT * sizeof *states;
    tdmf_page_defaults(tdmf_page_named("runner"), NULL, states);
    memcpy(states + TDMF_FOOT_X, start + TDMF_FOOT_X, size);
    memcpy(&d.x.seen_x, d_start + TDMF_FOOT_X, size);
    tdmf_write_page_inputs(system.inputs, (runner_states *)(void *)states);
    const tdmf_page_map map = {.page = tdmf_page_named("runner"),
                               .parameters = (double *)&p,
                               .states = states,
                               .tolerance = 1e-11,
                               .longest = 1.0,
                               .seed_count = 1,
                               .d_parameters = (double *)&d.p,
                               .d_states = (double *)&d.x};
    const tdmf_page_samples samples = {.count = 1,
                                       .times = &time,
                                       .states = ends,
                                       .outputs = outputs,
                                       .d_states = d_states,
                                       .d_outputs = d_outputs,
                                       .modes = &mode};
    double end[TDMF_STATE_COUNT];
    tdmf_page_begin(&map, end, &samples, &sampled);
    assert_int_equal(sampled, 1);
}

void vary_instant(tdmf_system system, const tdmf_motion *motion, const tdmf_seed *seed,
                  const double d_state[TDMF_STATE_COUNT], double d_rates[TDMF_STATE_COUNT],
                  double d_outputs[VARIED_OUTPUTS]) {
    const tdmf_inputs rates = tdmf_rates_with_varied_push(&tdmf_zero_input_rates, seed, 1);
    const tdmf_page_point point = tdmf_page_of_motion(system, &rates, motion);
    tdmf_page_direction d = tdmf_direction_of_seed(seed);
    tdmf_motion_instant instant;
    double o[OUTPUT_COUNT];
    tdmf_begin_instant_of_point(&instant, &point);
    const tdmf_mode_kind *mode = instant.at.mode;
    const double *p = instant.at.p, *x = instant.at.x, *dp = (const double *)&d.p;
    memcpy(&d.x, d_state, sizeof d.x);
    tdmf_write_page_inputs(&seed->inputs, &d.x);
    d.x.height = d.p.ground_height; /* the line in force changes with the one that is set */
    d.x.slope = d.p.ground_slope;
    const runner_states d_seen = d.x;
    if (mode->vary_from_world) {
        mode->vary_from_world(p, x, dp, (const double *)&d_seen, (double *)&d.x);
    }
    mode->vary_outputs(p, x, dp, (const double *)&d.x, o);
    tdmf_vary_page_rates(&instant.at, dp, (const double *)&d.x, d_rates);
    const double d_mass = seed->parameters.body.mass + seed->parameters.foot.mass;
    const double d_energy_of_base = point.base * (d_mass * system.model->parameters.gravity +
                                                  system.model->total_mass * seed->parameters.gravity);
    const double all[VARIED_OUTPUTS] = {
        o[OUTPUT_body_x],         o[OUTPUT_body_y],
        o[OUTPUT_body_vx],        o[OUTPUT_body_vy],
        o[OUTPUT_center_x],       o[OUTPUT_center_y],
        o[OUTPUT_center_vx],      o[OUTPUT_center_vy],
        o[OUTPUT_normal_force],   o[OUTPUT_ground_force_x],
        o[OUTPUT_ground_force_y], o[OUTPUT_tangential_force],
        o[OUTPUT_torque],         o[OUTPUT_force_of_leg],
        o[OUTPUT_kinetic_energy], d_energy_of_base + o[OUTPUT_potential_energy],
        o[OUTPUT_elastic_energy], d_energy_of_base + o[OUTPUT_energy]};
    memcpy(d_outputs, all, sizeof all);
}
