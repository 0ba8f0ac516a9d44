/* PlainReducedRunner, a part of Runner. */
#include "runner.h"

#include "page_part.h"

extern const tdmf_model_kind tdmf_plain_reduced_runner_model;
extern const tdmf_page_part tdmf_plain_reduced_runner_part;

static const int modes[] = {0, -1, 3, 4, 1, 2, -1, -1};
static const int parameters[] = {7, 8, 9, 10, 11, 12, 13, 19, 22};
static const int states[] = {0, 1, 2, 6, 7, 9, 10, 11, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26,
    27, 28, 29, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 59, 60, 61, 62, 63, 64, 65,
    66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 83, 87, 88, 89, 90, 92, 93, 94, 95, 96, 97, 103, 105};
static const int events[] = {3, 6, 7, 8, 10, 14, 15, 18, 19, 20};
static const int copies[][2] = {{12, 11}};
/* Number of effects that act on the whole runner `r` and are missing on the plain page. */
static real excess(const real *parameters, const real *states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    return select(real_abs(p->ground_height) <= 0.0, 0.0, 1.0) + select(real_abs(p->ground_slope) <= 0.0, 0.0,
        1.0) + select(real_abs(x->height) <= 0.0, 0.0, 1.0) + select(real_abs(x->slope) <= 0.0, 0.0, 1.0)
        + select(real_abs(p->thrust) <= 0.0, 0.0, 1.0) + select(real_abs(p->more_thrust) <= 0.0, 0.0, 1.0)
        + select(real_abs(p->retraction_rate) <= 0.0, 0.0, 1.0) + select(real_abs(p->more_angle) <= 0.0, 0.0,
        1.0) + select(real_abs(p->more_torque) <= 0.0, 0.0, 1.0) + select(real_abs(p->static_ratio
        - 1.0) <= 0.0, 0.0, 1.0) + select(real_abs(x->extension) <= 0.0, 0.0, 1.0)
        + select(real_abs(x->external_fx) <= 0.0, 0.0, 1.0) + select(real_abs(x->external_fy) <= 0.0, 0.0,
        1.0) + select(real_abs(x->friction_rate) <= 0.0, 0.0, 1.0)
        + select(real_abs(x->extension_rate) <= 0.0, 0.0, 1.0) + select(real_abs(x->external_fx_rate) <= 0.0,
        0.0, 1.0) + select(real_abs(x->external_fy_rate) <= 0.0, 0.0, 1.0)
        + select(real_abs(x->external_torque_rate) <= 0.0, 0.0, 1.0) + select(real_abs(x->leg_work
        - x->leg_work_then) <= 0.0, 0.0, 1.0) + select(real_abs(x->leg_work_of_stride) <= 0.0, 0.0, 1.0)
        + select(real_abs(x->peak_force_so_far - x->vertical_so_far) <= 0.0, 0.0, 1.0)
        + select(p->patch_end > p->patch_begin, 1.0, 0.0);
}

const tdmf_page_part tdmf_plain_reduced_runner_part = {
    .model = &tdmf_plain_reduced_runner_model, .parameters = parameters, .states = states, .events = events,
        .modes = modes,
    .copies = copies, .copy_count = 1, .excess = excess,
};
