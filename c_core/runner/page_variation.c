/* The correspondence of variations. Of the world's states those that a variation has are read and written. */
#include "page_variation.h"

#include "input_rates.h"
#include "page_fields.h"

#include <float.h>
#include <string.h>

/* The plain page lacks these numbers, so that a direction must not change them. */
static bool varies_plain_page(const tdmf_seed *seed) {
    const tdmf_parameters *p = &seed->parameters;
    const tdmf_inputs *i = &seed->inputs;
    return p->leg.thrust == 0.0 && p->ground.static_friction_ratio == 0.0 &&
           p->ground.stribeck_velocity == 0.0 && p->ground.patch_begin == 0.0 && p->ground.patch_end == 0.0 &&
           p->ground.patch_friction == 0.0 && p->hip.retraction_rate == 0.0 && i->ground.height == 0.0 &&
           i->ground.slope == 0.0 && i->leg.extension == 0.0 && i->body.external_fx == 0.0 &&
           i->body.external_fy == 0.0 && i->control.touchdown_angle == 0.0 &&
           i->control.stance_torque == 0.0 && i->control.thrust == 0.0;
}

bool tdmf_suits_plain_page_varied(const tdmf_page_point *point, const tdmf_seed *seeds, int count) {
    bool suits = tdmf_suits_plain_page(point);
    for (int i = 0; i < count; ++i) {
        suits = suits && varies_plain_page(&seeds[i]);
    }
    return suits;
}

tdmf_inputs tdmf_rates_with_varied_push(const tdmf_inputs *rates, const tdmf_seed *seeds, int count) {
    tdmf_inputs with_push = *rates;
    for (int i = 0; i < count; ++i) {
        if (tdmf_is_pushed(&seeds[i].inputs)) {
            with_push.body.external_fx += DBL_MIN;
        }
    }
    return with_push;
}

bool tdmf_is_kinked(const tdmf_parameters *parameters, const tdmf_seed *seed) {
    const tdmf_parameters *p = parameters, *d = &seed->parameters;
    return p->hip.swing_clamp && p->hip.kp == 0.0 && p->hip.kd == 0.0 &&
           (d->hip.kp != 0.0 || d->hip.kd != 0.0);
}

tdmf_page_direction tdmf_direction_of_seed(const tdmf_seed *seed) {
    tdmf_page_direction d = {.p = tdmf_page_parameters(&seed->parameters, &seed->inputs)};
    tdmf_write_page_inputs(&seed->inputs, &d.x);
    return d;
}

tdmf_page_direction tdmf_page_of_variation(const tdmf_page_point *point, const double state[TDMF_STATE_COUNT],
                                           const tdmf_seed *seed, const tdmf_variation *variation) {
    const tdmf_mode_kind *mode = &tdmf_runner_model.modes[point->mode];
    tdmf_page_direction d = tdmf_direction_of_seed(seed);
    double varied[TDMF_STATE_COUNT] = {0.0};
    memcpy(varied, variation->state, TDMF_VARIED_COUNT * sizeof *varied);
    tdmf_read_page_state(varied, &d.x);
    d.x.liftoff_angle = variation->liftoff_angle;
    if (point->x.height == point->p.ground_height && point->x.slope == point->p.ground_slope) {
        d.x.height = d.p.ground_height;
        d.x.slope = d.p.ground_slope;
    }
    d.x.stance_so_far = variation->stance.stance_time;
    d.x.slip_so_far = variation->stance.slip_distance;
    d.x.peak_force_so_far = variation->stance.peak_force;
    d.x.vertical_so_far = variation->stance.peak_vertical_force;
    if (mode->vary_from_world) {
        const runner_states d_seen = d.x;
        runner_states seen = point->x;
        tdmf_read_page_state(state, &seen);
        seen.seen_y -= point->base;
        mode->vary_from_world((const double *)&point->p, (const double *)&seen, (const double *)&d.p,
                              (const double *)&d_seen, (double *)&d.x);
        d.x.slid_from = d.x.foot_x;
    }
    return d;
}

/* Stance of the open stride, to which the mode of the point adds. */
static tdmf_stance_variation stance_so_far(const tdmf_page_point *point, const runner_states *d) {
    tdmf_stance_variation stance = {.stance_time = d->stance_so_far,
                                    .slip_distance = d->slip_so_far,
                                    .peak_force = d->peak_force_so_far,
                                    .peak_vertical_force = d->vertical_so_far};
    const bool slips = point->mode == MODE_slip_constant || point->mode == MODE_slip_falling;
    if (slips || point->mode == MODE_stick) {
        stance.stance_time -= d->mode_began;
    }
    if (slips) {
        stance.slip_distance += point->x.way * (d->foot_x - d->slid_from);
    }
    return stance;
}

tdmf_variation tdmf_variation_of_page(const tdmf_page_point *point, const tdmf_page_direction *d,
                                      bool closed) {
    const tdmf_mode_kind *mode = &tdmf_runner_model.modes[point->mode];
    const tdmf_stance_variation of_stride = {.stance_time = d->x.stance_time,
                                             .slip_distance = d->x.slip_distance,
                                             .peak_force = d->x.peak_force,
                                             .peak_vertical_force = d->x.peak_vertical_force};
    tdmf_variation variation = {.liftoff_angle = d->x.liftoff_angle};
    double varied[TDMF_STATE_COUNT];
    runner_states d_seen = d->x;
    if (mode->vary_to_world) {
        mode->vary_to_world((const double *)&point->p, (const double *)&point->x, (const double *)&d->p,
                            (const double *)&d->x, (double *)&d_seen);
    }
    tdmf_write_page_state(&d_seen, varied);
    memcpy(variation.state, varied, TDMF_VARIED_COUNT * sizeof *varied);
    variation.stance = closed ? of_stride : stance_so_far(point, &d->x);
    return variation;
}
