/* Derived from the page Runner: edit the page, not this. */
#include "runner.h"

/* Constants of start_of_run. */
static void open_start_of_run(const real *parameters, const real *states, real *constants) {
    const runner_states *x = (const void *)states;
    (void)parameters;
    start_of_run_constants *c = (void *)constants;
    const real segment_end_minus_seen_x = x->segment_end - x->seen_x;
    const real seen_x_minus_segment_begin = x->seen_x - x->segment_begin;
    c->extension_rate = x->extension_rate;
    c->external_fx_rate = x->external_fx_rate;
    c->external_fy_rate = x->external_fy_rate;
    c->friction_rate = x->friction_rate;
    c->external_torque_rate = x->external_torque_rate;
    c->segment_end_minus_seen_x = segment_end_minus_seen_x;
    c->seen_x_minus_segment_begin = seen_x_minus_segment_begin;
}

/* First variation of open_start_of_run. */
static void vary_open_start_of_run(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const runner_states *dx = (const void *)d_states;
    (void)parameters, (void)states, (void)d_parameters;
    start_of_run_constants *c = (void *)constants;
    const real d_segment_end_minus_seen_x = dx->segment_end - dx->seen_x;
    const real d_seen_x_minus_segment_begin = dx->seen_x - dx->segment_begin;
    c->extension_rate = dx->extension_rate;
    c->external_fx_rate = dx->external_fx_rate;
    c->external_fy_rate = dx->external_fy_rate;
    c->friction_rate = dx->friction_rate;
    c->external_torque_rate = dx->external_torque_rate;
    c->segment_end_minus_seen_x = d_segment_end_minus_seen_x;
    c->seen_x_minus_segment_begin = d_seen_x_minus_segment_begin;
}

/* passes_end: The foot is above the next segment. */
static int react_start_of_run_passes_end(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real segment_plus_by_1 = x->segment + 1.0;
    const real end = select(p->patch_end > p->patch_begin, p->patch_end, 1000000000000.0);
    const real begin = select(p->patch_end > p->patch_begin, p->patch_begin, 1000000000000.0);
    const real friction = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        segment_plus_by_1, select(real_abs(segment_plus_by_1 - 1.0) > 0.0, -1.0, p->patch_friction));
    y->segment = segment_plus_by_1;
    y->segment_begin = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, segment_plus_by_1,
        select(segment_plus_by_1 > 0.0, select(segment_plus_by_1 > 1.0, end, begin), -1000000000000.0));
    y->segment_end = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, segment_plus_by_1,
        select(segment_plus_by_1 > 0.0, select(segment_plus_by_1 > 1.0, 1000000000000.0, end), begin));
    y->segment_height = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height,
        segment_plus_by_1, 0.0);
    y->segment_slope = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, segment_plus_by_1,
        0.0);
    y->friction_ahead = friction;
    y->friction_behind = friction;
    return next[0]; /* start_of_run */
}

/* First variation of passes_end. */
static void vary_react_start_of_run_passes_end(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real segment_plus_by_1 = x->segment + 1.0;
    const real d_end = select(p->patch_end > p->patch_begin, dp->patch_end, 0.0);
    const real d_begin = select(p->patch_end > p->patch_begin, dp->patch_begin, 0.0);
    const real d_friction = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        seed, segment_plus_by_1, select(real_abs(segment_plus_by_1 - 1.0) > 0.0, 0.0, dp->patch_friction));
    y->segment = dx->segment;
    y->segment_begin = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, seed,
        segment_plus_by_1, select(segment_plus_by_1 > 0.0, select(segment_plus_by_1 > 1.0, d_end, d_begin),
        0.0));
    y->segment_end = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, seed,
        segment_plus_by_1, select(segment_plus_by_1 > 0.0, select(segment_plus_by_1 > 1.0, 0.0, d_end),
        d_begin));
    y->segment_height = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height, seed,
        segment_plus_by_1, 0.0);
    y->segment_slope = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, seed,
        segment_plus_by_1, 0.0);
    y->friction_ahead = d_friction;
    y->friction_behind = d_friction;
}

/* First variation of the guard of passes_end. */
static real vary_guard_start_of_run_passes_end(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_states *dx = (const void *)d_states;
    (void)parameters, (void)states, (void)d_parameters;
    return dx->segment_end - dx->seen_x;
}

/* passes_begin: The foot is above the segment before. */
static int react_start_of_run_passes_begin(const real *parameters, const real *states,
    const tdmf_table *tables, real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real segment_minus_by_1 = x->segment - 1.0;
    const real end = select(p->patch_end > p->patch_begin, p->patch_end, 1000000000000.0);
    const real begin = select(p->patch_end > p->patch_begin, p->patch_begin, 1000000000000.0);
    const real friction = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        segment_minus_by_1, select(real_abs(segment_minus_by_1 - 1.0) > 0.0, -1.0, p->patch_friction));
    y->segment = segment_minus_by_1;
    y->segment_begin = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin,
        segment_minus_by_1, select(segment_minus_by_1 > 0.0, select(segment_minus_by_1 > 1.0, end, begin),
        -1000000000000.0));
    y->segment_end = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, segment_minus_by_1,
        select(segment_minus_by_1 > 0.0, select(segment_minus_by_1 > 1.0, 1000000000000.0, end), begin));
    y->segment_height = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height,
        segment_minus_by_1, 0.0);
    y->segment_slope = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope,
        segment_minus_by_1, 0.0);
    y->friction_ahead = friction;
    y->friction_behind = friction;
    return next[0]; /* start_of_run */
}

/* First variation of passes_begin. */
static void vary_react_start_of_run_passes_begin(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real segment_minus_by_1 = x->segment - 1.0;
    const real d_end = select(p->patch_end > p->patch_begin, dp->patch_end, 0.0);
    const real d_begin = select(p->patch_end > p->patch_begin, dp->patch_begin, 0.0);
    const real d_friction = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        seed, segment_minus_by_1, select(real_abs(segment_minus_by_1 - 1.0) > 0.0, 0.0, dp->patch_friction));
    y->segment = dx->segment;
    y->segment_begin = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, seed,
        segment_minus_by_1, select(segment_minus_by_1 > 0.0, select(segment_minus_by_1 > 1.0, d_end, d_begin),
        0.0));
    y->segment_end = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, seed,
        segment_minus_by_1, select(segment_minus_by_1 > 0.0, select(segment_minus_by_1 > 1.0, 0.0, d_end),
        d_begin));
    y->segment_height = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height, seed,
        segment_minus_by_1, 0.0);
    y->segment_slope = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, seed,
        segment_minus_by_1, 0.0);
    y->friction_ahead = d_friction;
    y->friction_behind = d_friction;
}

/* First variation of the guard of passes_begin. */
static real vary_guard_start_of_run_passes_begin(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_states *dx = (const void *)d_states;
    (void)parameters, (void)states, (void)d_parameters;
    return dx->seen_x - dx->segment_begin;
}

/* begins: An impact if the foot is on the ground and does not rise, else flight. An apex opens a stride. */
static int react_start_of_run_begins(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real set_slope = p->ground_slope + x->segment_slope;
    const real cosine = real_cos(set_slope);
    const real set_height = p->ground_height + x->segment_height;
    const real seen_y_minus_set_height = x->seen_y - set_height;
    const real sine = real_sin(set_slope);
    const real foot_above = cosine * seen_y_minus_set_height - sine * x->seen_x;
    const real by_1eminus_12_times_free_length = 1e-12 * p->free_length;
    const real off = x->seen_vy * cosine - x->seen_vx * sine;
    const real slow = 1e-12 * (p->free_length * real_sqrt(p->stiffness / p->body_mass));
    const real cos_of_angle = real_cos(x->angle);
    const real turn = x->length * x->angle_rate;
    const real sin_of_angle = real_sin(x->angle);
    const real vy = x->length_rate * cos_of_angle - turn * sin_of_angle;
    const real y_2 = x->length * cos_of_angle;
    const real length_times_sin_of_angle = x->length * sin_of_angle;
    const real vx = -(x->length_rate * sin_of_angle) - turn * cos_of_angle;
    y->height = set_height;
    y->slope = set_slope;
    y->liftoff_angle = x->angle;
    y->placing = 0.0;
    if (foot_above <= by_1eminus_12_times_free_length && off <= slow) {
        const real along = x->seen_vx * cosine + x->seen_vy * sine;
        const real way = select(along >= 0.0, 1.0, -1.0);
        const real way_times_along = way * along;
        const real ends = select(x->segment_end < 1000000000000.0, 1.0, 0.0);
        const real x_2 = x->seen_x + by_1eminus_12_times_free_length;
        const real begins = select(x->segment_begin > -1000000000000.0, 1.0, 0.0);
        const real segment_towards = x->segment + ends * select(x_2 > x->segment_end, 1.0, 0.0)
            - begins * select(x_2 < x->segment_begin, 1.0, 0.0);
        const real friction = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
            segment_towards, select(real_abs(segment_towards - 1.0) > 0.0, -1.0, p->patch_friction));
        const real sum_2 = x->seen_x - by_1eminus_12_times_free_length;
        const real sum_3 = x->segment + ends * select(sum_2 > x->segment_end, 1.0, 0.0)
            - begins * select(sum_2 < x->segment_begin, 1.0, 0.0);
        const real friction_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, sum_3,
            select(real_abs(sum_3 - 1.0) > 0.0, -1.0, p->patch_friction));
        const real own = select(way > 0.0, friction, friction_2);
        const real is_own = select(own < 0.0, 0.0, 1.0);
        const real friction_along = is_own * own + (1.0 - is_own) * x->friction;
        const real friction_along_times_off = friction_along * off;
        const real sum_4 = way_times_along + friction_along_times_off;
        const real touchdowns_so_far_plus_by_1 = x->touchdowns_so_far + 1.0;
        const real sum_5 = x->seen_x * cosine + seen_y_minus_set_height * sine;
        const real sum_times_cosine_plus_product = sum_5 * cosine + by_1eminus_12_times_free_length * way;
        const real sum_6 = x->segment + ends * select(sum_times_cosine_plus_product > x->segment_end, 1.0,
            0.0) - begins * select(sum_times_cosine_plus_product < x->segment_begin, 1.0, 0.0);
        const real end = select(p->patch_end > p->patch_begin, p->patch_end, 1000000000000.0);
        const real begin = select(p->patch_end > p->patch_begin, p->patch_begin, 1000000000000.0);
        const real begin_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, sum_6,
            select(sum_6 > 0.0, select(sum_6 > 1.0, end, begin), -1000000000000.0));
        const real end_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, sum_6,
            select(sum_6 > 0.0, select(sum_6 > 1.0, 1000000000000.0, end), begin));
        const real height = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height, sum_6, 0.0);
        const real slope = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, sum_6, 0.0);
        const real friction_3 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, sum_6,
            select(real_abs(sum_6 - 1.0) > 0.0, -1.0, p->patch_friction));
        const real friction_or_friction = select(p->keeps_friction > 0.0, friction, friction_3);
        const real friction_or_friction_2 = select(p->keeps_friction > 0.0, friction_2, friction_3);
        const real sum_7 = y_2 * sine - length_times_sin_of_angle * cosine;
        const real sum_8 = y_2 * cosine + length_times_sin_of_angle * sine;
        const real seen_vx_plus_vx = x->seen_vx + vx;
        const real seen_vy_plus_vy = x->seen_vy + vy;
        const real sum_9 = seen_vx_plus_vx * cosine + seen_vy_plus_vy * sine;
        const real sum_10 = seen_vy_plus_vy * cosine - seen_vx_plus_vx * sine;
        const real angle_minus_minus_sumatan2_of_sum = x->angle - real_atan2(-sum_7, sum_8);
        const real along_times_along_plus_off_times_off = along * along + off * off;
        const real by_1_or_by_0 = select(x->angle >= 0.0, 1.0, 0.0);
        y->touchdowns_so_far = touchdowns_so_far_plus_by_1;
        y->slid_from = sum_5;
        y->bar_is_due = 1.0;
        y->x_ = sum_7;
        y->y_ = sum_8;
        y->vy = sum_10;
        y->foot_x = sum_5;
        y->winding = angle_minus_minus_sumatan2_of_sum;
        y->driving = by_1_or_by_0;
        y->touchdown_time = x->time;
        y->was_placed = 0.0;
        y->placed_for = x->placing;
        if (p->stribeck_velocity > 0.0 && p->static_ratio > 1.0) {
            const real product_2 = (p->static_ratio
                - 1.0) * real_expm1(friction_along_times_off / p->stribeck_velocity);
            const real gained = -product_2;
            const real stopped_speed = p->stribeck_velocity * real_log1p(gained) - friction_along_times_off;
            const real left = sum_4
                + p->stribeck_velocity * real_log1p(product_2 * real_exp(-(sum_4 / p->stribeck_velocity)));
            const real speed_left = select(left > 0.0, left, 0.0);
            const real speed_after_impact = select(way_times_along <= stopped_speed, 0.0, speed_left);
            const real after_2 = way * speed_after_impact;
            const real sum_minus_after = sum_9 - after_2;
            const real speeds = along_times_along_plus_off_times_off - after_2 * after_2;
            const real sum_11 = x->impact_loss + 0.5 * (p->foot_mass * speeds);
            y->vx = sum_minus_after;
            y->foot_vx = after_2;
            y->impact_loss = sum_11;
            if (way * after_2 > 0.0) {
                y->segment = sum_6;
                y->segment_begin = begin_2;
                y->segment_end = end_2;
                y->segment_height = height;
                y->segment_slope = slope;
                y->friction_ahead = friction_or_friction;
                y->friction_behind = friction_or_friction_2;
                y->way = way;
                return next[0]; /* slip */
            }
            y->friction_ahead = friction;
            y->friction_behind = friction_2;
            return next[1]; /* stick */
        }
        const real way_times_by_0_or_sum = way * select(way_times_along <= -(p->static_ratio *
            friction_along_times_off), 0.0, sum_4);
        const real sum_minus_way_times_by_0_or_sum = sum_9 - way_times_by_0_or_sum;
        const real sum_11 = x->impact_loss + 0.5 * (p->foot_mass * (along_times_along_plus_off_times_off
            - way_times_by_0_or_sum * way_times_by_0_or_sum));
        y->vx = sum_minus_way_times_by_0_or_sum;
        y->foot_vx = way_times_by_0_or_sum;
        y->impact_loss = sum_11;
        if (way * way_times_by_0_or_sum > 0.0) {
            y->segment = sum_6;
            y->segment_begin = begin_2;
            y->segment_end = end_2;
            y->segment_height = height;
            y->segment_slope = slope;
            y->friction_ahead = friction_or_friction;
            y->friction_behind = friction_or_friction_2;
            y->way = way;
            return next[0]; /* slip */
        }
        y->friction_ahead = friction;
        y->friction_behind = friction_2;
        return next[1]; /* stick */
    }
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real rise = x->seen_vy + share * vy;
    const real sum_2 = x->seen_x - share * length_times_sin_of_angle;
    const real seen_y_plus_share_times_y = x->seen_y + share * y_2;
    const real seen_vx_plus_share_times_vx = x->seen_vx + share * vx;
    const real square = x->length * x->length;
    const real moment = square * x->angle_rate;
    y->com_x = sum_2;
    y->com_y = seen_y_plus_share_times_y;
    y->com_vx = seen_vx_plus_share_times_vx;
    y->com_vy = rise;
    y->momentum = moment;
    if (real_abs(rise) <= slow) {
        const real height_of_section = seen_y_plus_share_times_y - set_height - sum_2 * (sine / cosine);
        const real rate = moment / square;
        y->is_open = 1.0;
        y->work_then = x->work;
        y->leg_work_then = x->leg_work;
        y->positive_work_then = x->positive_work_so_far;
        y->peak_force_so_far = 0.0;
        y->vertical_so_far = 0.0;
        y->touchdowns_so_far = 0.0;
        y->slip_so_far = 0.0;
        y->stance_so_far = 0.0;
        y->word_so_far = 0.0;
        y->last_letter = 0.0;
        y->bar_is_due = 0.0;
        y->x_then = sum_2;
        y->y_then = seen_y_plus_share_times_y;
        y->apex_time = x->time;
        y->apex_com_height = height_of_section;
        y->apex_com_speed = seen_vx_plus_share_times_vx;
        y->apex_length = x->length;
        y->apex_angle = x->angle;
        y->apex_length_rate = x->length_rate;
        y->apex_angle_rate = rate;
        y->swing = 2.0;
        return next[2]; /* flight */
    }
    if (rise < 0.0) {
        y->swing = 2.0;
        return next[2]; /* flight */
    }
    const real servo = -(p->kp * (x->angle - p->liftoff_factor * x->angle)) - p->kd * x->angle_rate;
    if (p->swing_clamp > 0.0 && servo <= 0.0) {
        y->swing = 0.0;
        return next[2]; /* flight */
    }
    y->swing = 1.0;
    return next[2]; /* flight */
}

/* First variation of begins. */
static void vary_react_start_of_run_begins(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real set_slope = p->ground_slope + x->segment_slope;
    const real cosine = real_cos(set_slope);
    const real set_height = p->ground_height + x->segment_height;
    const real seen_y_minus_set_height = x->seen_y - set_height;
    const real sine = real_sin(set_slope);
    const real foot_above = cosine * seen_y_minus_set_height - sine * x->seen_x;
    const real by_1eminus_12_times_free_length = 1e-12 * p->free_length;
    const real off = x->seen_vy * cosine - x->seen_vx * sine;
    const real slow = 1e-12 * (p->free_length * real_sqrt(p->stiffness / p->body_mass));
    const real cos_of_angle = real_cos(x->angle);
    const real turn = x->length * x->angle_rate;
    const real sin_of_angle = real_sin(x->angle);
    const real vy = x->length_rate * cos_of_angle - turn * sin_of_angle;
    const real d_set_slope = dp->ground_slope + dx->segment_slope;
    const real sine_times_d_set_slope = sine * d_set_slope;
    const real d_set_height = dp->ground_height + dx->segment_height;
    const real d_sine = cosine * d_set_slope;
    const real sin_of_angle_times_angle = sin_of_angle * dx->angle;
    const real d_y = dx->length * cos_of_angle - x->length * sin_of_angle_times_angle;
    const real y_2 = x->length * cos_of_angle;
    const real cos_of_angle_times_angle = cos_of_angle * dx->angle;
    const real sum_2 = dx->length * sin_of_angle + x->length * cos_of_angle_times_angle;
    const real length_times_sin_of_angle = x->length * sin_of_angle;
    const real d_turn = dx->length * x->angle_rate + x->length * dx->angle_rate;
    const real d_vx = -(dx->length_rate * sin_of_angle + x->length_rate * cos_of_angle_times_angle)
        - (d_turn * cos_of_angle - turn * sin_of_angle_times_angle);
    const real vx = -(x->length_rate * sin_of_angle) - turn * cos_of_angle;
    const real d_vy = dx->length_rate * cos_of_angle - x->length_rate * sin_of_angle_times_angle
        - (d_turn * sin_of_angle + turn * cos_of_angle_times_angle);
    y->height = d_set_height;
    y->slope = d_set_slope;
    y->liftoff_angle = dx->angle;
    y->placing = 0.0;
    if (foot_above <= by_1eminus_12_times_free_length && off <= slow) {
        const real along = x->seen_vx * cosine + x->seen_vy * sine;
        const real way = select(along >= 0.0, 1.0, -1.0);
        const real way_times_along = way * along;
        const real ends = select(x->segment_end < 1000000000000.0, 1.0, 0.0);
        const real x_2 = x->seen_x + by_1eminus_12_times_free_length;
        const real begins = select(x->segment_begin > -1000000000000.0, 1.0, 0.0);
        const real segment_towards = x->segment + ends * select(x_2 > x->segment_end, 1.0, 0.0)
            - begins * select(x_2 < x->segment_begin, 1.0, 0.0);
        const real abs_of_segment_towards_minus_by_1 = real_abs(segment_towards - 1.0);
        const real sum_3 = x->seen_x - by_1eminus_12_times_free_length;
        const real sum_4 = x->segment + ends * select(sum_3 > x->segment_end, 1.0, 0.0)
            - begins * select(sum_3 < x->segment_begin, 1.0, 0.0);
        const real abs_of_sum_minus_by_1 = real_abs(sum_4 - 1.0);
        const real own = select(way > 0.0, looked_up(tables, TABLE_ground_segment,
            COLUMN_ground_segment_friction, segment_towards, select(abs_of_segment_towards_minus_by_1 > 0.0,
            -1.0, p->patch_friction)), looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
            sum_4, select(abs_of_sum_minus_by_1 > 0.0, -1.0, p->patch_friction)));
        const real is_own = select(own < 0.0, 0.0, 1.0);
        const real by_1_minus_is_own = 1.0 - is_own;
        const real friction_along = is_own * own + by_1_minus_is_own * x->friction;
        const real friction_along_times_off = friction_along * off;
        const real sum_5 = way_times_along + friction_along_times_off;
        const real sum_plus_sum = dx->seen_x * cosine - x->seen_x * sine_times_d_set_slope + ((dx->seen_y
            - d_set_height) * sine + seen_y_minus_set_height * d_sine);
        const real sum_times_cosine_plus_product = (x->seen_x * cosine
            + seen_y_minus_set_height * sine) * cosine + by_1eminus_12_times_free_length * way;
        const real sum_6 = x->segment + ends * select(sum_times_cosine_plus_product > x->segment_end, 1.0,
            0.0) - begins * select(sum_times_cosine_plus_product < x->segment_begin, 1.0, 0.0);
        const real d_end = select(p->patch_end > p->patch_begin, dp->patch_end, 0.0);
        const real d_begin = select(p->patch_end > p->patch_begin, dp->patch_begin, 0.0);
        const real d_begin_2 = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin,
            seed, sum_6, select(sum_6 > 0.0, select(sum_6 > 1.0, d_end, d_begin), 0.0));
        const real d_end_2 = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end,
            seed, sum_6, select(sum_6 > 0.0, select(sum_6 > 1.0, 0.0, d_end), d_begin));
        const real d_height = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height,
            seed, sum_6, 0.0);
        const real d_slope = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope,
            seed, sum_6, 0.0);
        const real d_friction = variation_looked_up(tables, TABLE_ground_segment,
            COLUMN_ground_segment_friction, seed, segment_towards,
            select(abs_of_segment_towards_minus_by_1 > 0.0, 0.0, dp->patch_friction));
        const real d_friction_2 = variation_looked_up(tables, TABLE_ground_segment,
            COLUMN_ground_segment_friction, seed, sum_6, select(real_abs(sum_6 - 1.0) > 0.0, 0.0,
            dp->patch_friction));
        const real d_friction_or_d_friction = select(p->keeps_friction > 0.0, d_friction, d_friction_2);
        const real d_friction_3 = variation_looked_up(tables, TABLE_ground_segment,
            COLUMN_ground_segment_friction, seed, sum_4, select(abs_of_sum_minus_by_1 > 0.0, 0.0,
            dp->patch_friction));
        const real d_friction_or_d_friction_2 = select(p->keeps_friction > 0.0, d_friction_3, d_friction_2);
        const real sum_7 = d_y * sine + y_2 * d_sine - (sum_2 * cosine
            - length_times_sin_of_angle * sine_times_d_set_slope);
        const real sum_plus_sum_2 = d_y * cosine - y_2 * sine_times_d_set_slope + (sum_2 * sine
            + length_times_sin_of_angle * d_sine);
        const real seen_vx_plus_d_vx = dx->seen_vx + d_vx;
        const real seen_vx_plus_vx = x->seen_vx + vx;
        const real seen_vy_plus_d_vy = dx->seen_vy + d_vy;
        const real seen_vy_plus_vy = x->seen_vy + vy;
        const real sum_plus_sum_3 = seen_vx_plus_d_vx * cosine - seen_vx_plus_vx * sine_times_d_set_slope
            + (seen_vy_plus_d_vy * sine + seen_vy_plus_vy * d_sine);
        const real d_along = dx->seen_vx * cosine - x->seen_vx * sine_times_d_set_slope
            + (dx->seen_vy * sine + x->seen_vy * d_sine);
        const real d_off = dx->seen_vy * cosine - x->seen_vy * sine_times_d_set_slope - (dx->seen_vx * sine
            + x->seen_vx * d_sine);
        const real d_own = select(way > 0.0, d_friction, d_friction_3);
        const real d_friction_along = is_own * d_own + by_1_minus_is_own * dx->friction;
        const real sum_8 = d_friction_along * off + friction_along * d_off;
        const real way_times_d_along_plus_sum = way * d_along + sum_8;
        const real sum_minus_sum = seen_vy_plus_d_vy * cosine - seen_vy_plus_vy * sine_times_d_set_slope
            - (seen_vx_plus_d_vx * sine + seen_vx_plus_vx * d_sine);
        const real sum_9 = y_2 * sine - length_times_sin_of_angle * cosine;
        const real sum_10 = y_2 * cosine + length_times_sin_of_angle * sine;
        const real angle_minus_ratio = dx->angle - (sum_9 * sum_plus_sum_2
            - sum_10 * sum_7) / (sum_9 * sum_9 + sum_10 * sum_10);
        const real along_times_along_plus_off_times_off = along * along + off * off;
        const real sum_11 = 2.0 * (along * d_along) + 2.0 * (off * d_off);
        y->touchdowns_so_far = dx->touchdowns_so_far;
        y->slid_from = sum_plus_sum;
        y->bar_is_due = 0.0;
        y->x_ = sum_7;
        y->y_ = sum_plus_sum_2;
        y->vy = sum_minus_sum;
        y->foot_x = sum_plus_sum;
        y->winding = angle_minus_ratio;
        y->driving = 0.0;
        y->touchdown_time = dx->time;
        y->was_placed = 0.0;
        y->placed_for = dx->placing;
        if (p->stribeck_velocity > 0.0 && p->static_ratio > 1.0) {
            const real static_ratio_minus_by_1 = p->static_ratio - 1.0;
            const real ratio = friction_along_times_off / p->stribeck_velocity;
            const real expm1_of_ratio = real_expm1(ratio);
            const real product_2 = static_ratio_minus_by_1 * expm1_of_ratio;
            const real gained = -product_2;
            const real stopped_speed = p->stribeck_velocity * real_log1p(gained) - friction_along_times_off;
            const real sum_over_stribeck_velocity = sum_5 / p->stribeck_velocity;
            const real exp_of_minus_sum_over_stribeck_velocity = real_exp(-sum_over_stribeck_velocity);
            const real product_3 = product_2 * exp_of_minus_sum_over_stribeck_velocity;
            const real log1p_of_product = real_log1p(product_3);
            const real left = sum_5 + p->stribeck_velocity * log1p_of_product;
            const real speed_left = select(left > 0.0, left, 0.0);
            const real speed_after_impact = select(way_times_along <= stopped_speed, 0.0, speed_left);
            const real after_2 = way * speed_after_impact;
            const real d_left = way_times_d_along_plus_sum + (dp->stribeck_velocity * log1p_of_product
                + p->stribeck_velocity * (((dp->static_ratio * expm1_of_ratio
                + static_ratio_minus_by_1 * ((expm1_of_ratio + 1.0) * ((sum_8
                - ratio * dp->stribeck_velocity) / p->stribeck_velocity))) *
                exp_of_minus_sum_over_stribeck_velocity
                - product_2 * (exp_of_minus_sum_over_stribeck_velocity * ((way_times_d_along_plus_sum
                - sum_over_stribeck_velocity * dp->stribeck_velocity) / p->stribeck_velocity))) / (1.0
                + product_3)));
            const real d_speed_left = select(left > 0.0, d_left, 0.0);
            const real d_speed_after_impact = select(way_times_along <= stopped_speed, 0.0, d_speed_left);
            const real d_after = way * d_speed_after_impact;
            const real sum_plus_sum_minus_d_after = sum_plus_sum_3 - d_after;
            const real speeds = along_times_along_plus_off_times_off - after_2 * after_2;
            const real d_speeds = sum_11 - 2.0 * (after_2 * d_after);
            const real impact_loss_plus_by_0_5_times_sum = dx->impact_loss + 0.5 * (dp->foot_mass * speeds
                + p->foot_mass * d_speeds);
            y->vx = sum_plus_sum_minus_d_after;
            y->foot_vx = d_after;
            y->impact_loss = impact_loss_plus_by_0_5_times_sum;
            if (way * after_2 > 0.0) {
                y->segment = dx->segment;
                y->segment_begin = d_begin_2;
                y->segment_end = d_end_2;
                y->segment_height = d_height;
                y->segment_slope = d_slope;
                y->friction_ahead = d_friction_or_d_friction;
                y->friction_behind = d_friction_or_d_friction_2;
                y->way = 0.0;
                return;
            }
            y->friction_ahead = d_friction;
            y->friction_behind = d_friction_3;
            return;
        }
        const real minus_product = -(p->static_ratio * friction_along_times_off);
        const real way_times_by_0_or_sum = way * select(way_times_along <= minus_product, 0.0, sum_5);
        const real product_2 = way * select(way_times_along <= minus_product, 0.0,
            way_times_d_along_plus_sum);
        const real sum_plus_sum_minus_product = sum_plus_sum_3 - product_2;
        const real impact_loss_plus_by_0_5_times_sum = dx->impact_loss
            + 0.5 * (dp->foot_mass * (along_times_along_plus_off_times_off
            - way_times_by_0_or_sum * way_times_by_0_or_sum) + p->foot_mass * (sum_11
            - 2.0 * (way_times_by_0_or_sum * product_2)));
        y->vx = sum_plus_sum_minus_product;
        y->foot_vx = product_2;
        y->impact_loss = impact_loss_plus_by_0_5_times_sum;
        if (way * way_times_by_0_or_sum > 0.0) {
            y->segment = dx->segment;
            y->segment_begin = d_begin_2;
            y->segment_end = d_end_2;
            y->segment_height = d_height;
            y->segment_slope = d_slope;
            y->friction_ahead = d_friction_or_d_friction;
            y->friction_behind = d_friction_or_d_friction_2;
            y->way = 0.0;
            return;
        }
        y->friction_ahead = d_friction;
        y->friction_behind = d_friction_3;
        return;
    }
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real rise = x->seen_vy + share * vy;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real seen_x_minus_sum = dx->seen_x - (d_share * length_times_sin_of_angle + share * sum_2);
    const real sum_3 = dx->seen_y + (d_share * y_2 + share * d_y);
    const real sum_4 = dx->seen_vx + (d_share * vx + share * d_vx);
    const real d_square = 2.0 * (x->length * dx->length);
    const real square = x->length * x->length;
    const real d_moment = d_square * x->angle_rate + square * dx->angle_rate;
    const real d_rise = dx->seen_vy + (d_share * vy + share * d_vy);
    y->com_x = seen_x_minus_sum;
    y->com_y = sum_3;
    y->com_vx = sum_4;
    y->com_vy = d_rise;
    y->momentum = d_moment;
    y->swing = 0.0;
    if (real_abs(rise) <= slow) {
        const real sine_over_cosine = sine / cosine;
        const real d_height_of_section = sum_3 - d_set_height - (seen_x_minus_sum * sine_over_cosine
            + (x->seen_x - share * length_times_sin_of_angle) * ((d_sine
            + sine_over_cosine * sine_times_d_set_slope) / cosine));
        const real moment = square * x->angle_rate;
        const real rate = moment / square;
        const real d_rate = (d_moment - rate * d_square) / square;
        y->is_open = 0.0;
        y->work_then = dx->work;
        y->leg_work_then = dx->leg_work;
        y->positive_work_then = dx->positive_work_so_far;
        y->peak_force_so_far = 0.0;
        y->vertical_so_far = 0.0;
        y->touchdowns_so_far = 0.0;
        y->slip_so_far = 0.0;
        y->stance_so_far = 0.0;
        y->word_so_far = 0.0;
        y->last_letter = 0.0;
        y->bar_is_due = 0.0;
        y->x_then = seen_x_minus_sum;
        y->y_then = sum_3;
        y->apex_time = dx->time;
        y->apex_com_height = d_height_of_section;
        y->apex_com_speed = sum_4;
        y->apex_length = dx->length;
        y->apex_angle = dx->angle;
        y->apex_length_rate = dx->length_rate;
        y->apex_angle_rate = d_rate;
        return;
    }
}

/* First variation of the guard of begins. */
static real vary_guard_start_of_run_begins(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    (void)parameters, (void)states, (void)d_parameters, (void)d_states;
    return 0.0;
}

/* Outputs in start_of_run. */
static void outputs_start_of_run(const real *parameters, const real *states, real *outputs) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const real set_height = p->ground_height + x->segment_height;
    const real set_slope = p->ground_slope + x->segment_slope;
    const real pending = select(real_abs(set_height - x->height) + real_abs(p->free_length * (set_slope
        - x->slope)) > 0.0, 1.0, 0.0);
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real shorter = rest_length - x->length;
    const real spring = p->stiffness * shorter - p->damping * x->length_rate;
    const real sin_of_angle = real_sin(x->angle);
    const real length_times_sin_of_angle = x->length * sin_of_angle;
    const real body_x = x->seen_x - length_times_sin_of_angle;
    const real cos_of_angle = real_cos(x->angle);
    const real y_2 = x->length * cos_of_angle;
    const real body_y = x->seen_y + y_2;
    const real turn = x->length * x->angle_rate;
    const real vx = -(x->length_rate * sin_of_angle) - turn * cos_of_angle;
    const real body_vx = x->seen_vx + vx;
    const real vy = x->length_rate * cos_of_angle - turn * sin_of_angle;
    const real body_vy = x->seen_vy + vy;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real center_x = x->seen_x - share * length_times_sin_of_angle;
    const real center_y = x->seen_y + share * y_2;
    const real center_vx = x->seen_vx + share * vx;
    const real center_vy = x->seen_vy + share * vy;
    const real of_body = p->body_mass * (body_vx * body_vx + body_vy * body_vy);
    const real kinetic_energy = 0.5 * (of_body + p->foot_mass * (x->seen_vx * x->seen_vx
        + x->seen_vy * x->seen_vy));
    const real potential_energy = p->gravity * (p->body_mass * body_y + p->foot_mass * x->seen_y);
    const real elastic_energy = 0.5 * (p->stiffness * (shorter * shorter));
    const real energy = kinetic_energy + potential_energy + elastic_energy;
    outputs[OUTPUT_pending] = pending;
    outputs[OUTPUT_torque] = 0.0;
    outputs[OUTPUT_normal_force] = 0.0;
    outputs[OUTPUT_tangential_force] = 0.0;
    outputs[OUTPUT_ground_force_x] = 0.0;
    outputs[OUTPUT_ground_force_y] = 0.0;
    outputs[OUTPUT_force_of_leg] = spring;
    outputs[OUTPUT_body_x] = body_x;
    outputs[OUTPUT_body_y] = body_y;
    outputs[OUTPUT_body_vx] = body_vx;
    outputs[OUTPUT_body_vy] = body_vy;
    outputs[OUTPUT_center_x] = center_x;
    outputs[OUTPUT_center_y] = center_y;
    outputs[OUTPUT_center_vx] = center_vx;
    outputs[OUTPUT_center_vy] = center_vy;
    outputs[OUTPUT_kinetic_energy] = kinetic_energy;
    outputs[OUTPUT_potential_energy] = potential_energy;
    outputs[OUTPUT_elastic_energy] = elastic_energy;
    outputs[OUTPUT_energy] = energy;
    outputs[OUTPUT_kind_of_contact] = 1.0;
    outputs[OUTPUT_phase_of_hip] = 4.0;
}

/* First variation of outputs_start_of_run. */
static void vary_outputs_start_of_run(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *outputs) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real shorter = rest_length - x->length;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_shorter = d_rest_length - dx->length;
    const real d_spring = dp->stiffness * shorter + p->stiffness * d_shorter - (dp->damping * x->length_rate
        + p->damping * dx->length_rate);
    const real sin_of_angle = real_sin(x->angle);
    const real cos_of_angle = real_cos(x->angle);
    const real cos_of_angle_times_angle = cos_of_angle * dx->angle;
    const real sum_2 = dx->length * sin_of_angle + x->length * cos_of_angle_times_angle;
    const real d_body_x = dx->seen_x - sum_2;
    const real sin_of_angle_times_angle = sin_of_angle * dx->angle;
    const real d_y = dx->length * cos_of_angle - x->length * sin_of_angle_times_angle;
    const real d_body_y = dx->seen_y + d_y;
    const real d_turn = dx->length * x->angle_rate + x->length * dx->angle_rate;
    const real turn = x->length * x->angle_rate;
    const real d_vx = -(dx->length_rate * sin_of_angle + x->length_rate * cos_of_angle_times_angle)
        - (d_turn * cos_of_angle - turn * sin_of_angle_times_angle);
    const real d_body_vx = dx->seen_vx + d_vx;
    const real d_vy = dx->length_rate * cos_of_angle - x->length_rate * sin_of_angle_times_angle
        - (d_turn * sin_of_angle + turn * cos_of_angle_times_angle);
    const real d_body_vy = dx->seen_vy + d_vy;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_center_x = dx->seen_x - (d_share * (x->length * sin_of_angle) + share * sum_2);
    const real y_2 = x->length * cos_of_angle;
    const real d_center_y = dx->seen_y + (d_share * y_2 + share * d_y);
    const real vx = -(x->length_rate * sin_of_angle) - turn * cos_of_angle;
    const real d_center_vx = dx->seen_vx + (d_share * vx + share * d_vx);
    const real vy = x->length_rate * cos_of_angle - turn * sin_of_angle;
    const real d_center_vy = dx->seen_vy + (d_share * vy + share * d_vy);
    const real body_vx = x->seen_vx + vx;
    const real body_vy = x->seen_vy + vy;
    const real d_of_body = dp->body_mass * (body_vx * body_vx + body_vy * body_vy)
        + p->body_mass * (2.0 * (body_vx * d_body_vx) + 2.0 * (body_vy * d_body_vy));
    const real d_kinetic_energy = 0.5 * (d_of_body + (dp->foot_mass * (x->seen_vx * x->seen_vx
        + x->seen_vy * x->seen_vy) + p->foot_mass * (2.0 * (x->seen_vx * dx->seen_vx)
        + 2.0 * (x->seen_vy * dx->seen_vy))));
    const real body_y = x->seen_y + y_2;
    const real d_potential_energy = dp->gravity * (p->body_mass * body_y + p->foot_mass * x->seen_y)
        + p->gravity * (dp->body_mass * body_y + p->body_mass * d_body_y + (dp->foot_mass * x->seen_y
        + p->foot_mass * dx->seen_y));
    const real d_elastic_energy = 0.5 * (dp->stiffness * (shorter * shorter)
        + p->stiffness * (2.0 * (shorter * d_shorter)));
    const real d_energy = d_kinetic_energy + d_potential_energy + d_elastic_energy;
    outputs[OUTPUT_pending] = 0.0;
    outputs[OUTPUT_torque] = 0.0;
    outputs[OUTPUT_normal_force] = 0.0;
    outputs[OUTPUT_tangential_force] = 0.0;
    outputs[OUTPUT_ground_force_x] = 0.0;
    outputs[OUTPUT_ground_force_y] = 0.0;
    outputs[OUTPUT_force_of_leg] = d_spring;
    outputs[OUTPUT_body_x] = d_body_x;
    outputs[OUTPUT_body_y] = d_body_y;
    outputs[OUTPUT_body_vx] = d_body_vx;
    outputs[OUTPUT_body_vy] = d_body_vy;
    outputs[OUTPUT_center_x] = d_center_x;
    outputs[OUTPUT_center_y] = d_center_y;
    outputs[OUTPUT_center_vx] = d_center_vx;
    outputs[OUTPUT_center_vy] = d_center_vy;
    outputs[OUTPUT_kinetic_energy] = d_kinetic_energy;
    outputs[OUTPUT_potential_energy] = d_potential_energy;
    outputs[OUTPUT_elastic_energy] = d_elastic_energy;
    outputs[OUTPUT_energy] = d_energy;
    outputs[OUTPUT_kind_of_contact] = 0.0;
    outputs[OUTPUT_phase_of_hip] = 0.0;
}

/* Count the event. A contact mode that lasted adds a letter to the gait word, a new stance a bar. */
static void leave_start_of_run(const real *parameters, const real *states, real counted, real *after) {
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    (void)parameters;
    const real is_new = select(x->time > x->last_event, counted, 0.0);
    y->events = x->events + is_new;
    y->last_event = select(counted > 0.0, x->time, x->last_event);
    y->mode_began = x->time;
}

/* First variation of leave_start_of_run. */
static void vary_leave_start_of_run(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real counted, real *after) {
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters;
    y->events = dx->events;
    y->last_event = select(counted > 0.0, dx->time, dx->last_event);
    y->mode_began = dx->time;
}

/* Constants of slip_constant. */
static void open_slip_constant(const real *parameters, const real *states, real *constants) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    slip_constant_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real longer = p->thrust + p->more_thrust;
    const real thrusting_times_longer_or_by_0 = x->thrusting * select(longer >= 0.0, longer, 0.0);
    const real product_2 = x->driving * (p->drive_torque + p->more_torque);
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real gravity_times_sine = p->gravity * sine;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real foot_mass_times_gravity_times_sine = foot_mass_times_gravity * sine;
    const real own = select(x->way > 0.0, x->friction_ahead, x->friction_behind);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real is_own_times_own = is_own * own;
    const real by_1_minus_is_own = 1.0 - is_own;
    const real foot_mass_times_gravity_times_cosine = foot_mass_times_gravity * cosine;
    const real gravity_times_cosine = p->gravity * cosine;
    const real stiffness_times_extension_rate = p->stiffness * x->extension_rate;
    const real inverse_stribeck_velocity_or_by_1 = 1.0 / select(p->stribeck_velocity > 0.0,
        p->stribeck_velocity, 1.0);
    const real segment_end_or_segment_begin = select(x->way > 0.0, x->segment_end, x->segment_begin);
    c->inverse_body_mass = inverse_body_mass;
    c->stiffness = p->stiffness;
    c->free_length = p->free_length;
    c->thrusting_times_longer_or_by_0 = thrusting_times_longer_or_by_0;
    c->damping = p->damping;
    c->product_2 = product_2;
    c->cosine = cosine;
    c->sine = sine;
    c->gravity_times_sine = gravity_times_sine;
    c->inverse_foot_mass = inverse_foot_mass;
    c->foot_mass_times_gravity_times_sine = foot_mass_times_gravity_times_sine;
    c->way = x->way;
    c->is_own_times_own = is_own_times_own;
    c->by_1_minus_is_own = by_1_minus_is_own;
    c->foot_mass_times_gravity_times_cosine = foot_mass_times_gravity_times_cosine;
    c->gravity_times_cosine = gravity_times_cosine;
    c->extension_rate = x->extension_rate;
    c->stiffness_times_extension_rate = stiffness_times_extension_rate;
    c->external_fx_rate = x->external_fx_rate;
    c->external_fy_rate = x->external_fy_rate;
    c->friction_rate = x->friction_rate;
    c->external_torque_rate = x->external_torque_rate;
    c->least_length = p->least_length;
    c->winding = x->winding;
    c->inverse_stribeck_velocity_or_by_1 = inverse_stribeck_velocity_or_by_1;
    c->segment_end_or_segment_begin = segment_end_or_segment_begin;
}

/* First variation of open_slip_constant. */
static void vary_open_slip_constant(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    slip_constant_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real d_inverse_body_mass = -(inverse_body_mass * dp->body_mass / p->body_mass);
    const real longer = p->thrust + p->more_thrust;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_thrusting_times_longer_or_by_0 = select(longer >= 0.0, longer, 0.0) * dx->thrusting
        + x->thrusting * select(longer >= 0.0, d_longer, 0.0);
    const real d_product_2 = (p->drive_torque + p->more_torque) * dx->driving
        + x->driving * (dp->drive_torque + dp->more_torque);
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_cosine = -sine_times_slope;
    const real cosine = real_cos(x->slope);
    const real d_sine = cosine * dx->slope;
    const real d_gravity_times_sine = sine * dp->gravity + p->gravity * d_sine;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real d_inverse_foot_mass = -(inverse_foot_mass * dp->foot_mass / p->foot_mass);
    const real sum_2 = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real d_foot_mass_times_gravity_times_sine = sine * sum_2 + foot_mass_times_gravity * d_sine;
    const real own = select(x->way > 0.0, x->friction_ahead, x->friction_behind);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real d_own = select(x->way > 0.0, dx->friction_ahead, dx->friction_behind);
    const real d_is_own_times_own = is_own * d_own;
    const real d_foot_mass_times_gravity_times_cosine = cosine * sum_2
        - foot_mass_times_gravity * sine_times_slope;
    const real d_gravity_times_cosine = cosine * dp->gravity - p->gravity * sine_times_slope;
    const real d_stiffness_times_extension_rate = x->extension_rate * dp->stiffness
        + p->stiffness * dx->extension_rate;
    const real stribeck_velocity_or_by_1 = select(p->stribeck_velocity > 0.0, p->stribeck_velocity, 1.0);
    const real inverse_stribeck_velocity_or_by_1 = 1.0 / stribeck_velocity_or_by_1;
    const real d_inverse_stribeck_velocity_or_by_1 = -(inverse_stribeck_velocity_or_by_1 *
        select(p->stribeck_velocity > 0.0, dp->stribeck_velocity, 0.0) / stribeck_velocity_or_by_1);
    const real d_segment_end_or_segment_begin = select(x->way > 0.0, dx->segment_end, dx->segment_begin);
    c->inverse_body_mass = d_inverse_body_mass;
    c->stiffness = dp->stiffness;
    c->free_length = dp->free_length;
    c->thrusting_times_longer_or_by_0 = d_thrusting_times_longer_or_by_0;
    c->damping = dp->damping;
    c->product_2 = d_product_2;
    c->cosine = d_cosine;
    c->sine = d_sine;
    c->gravity_times_sine = d_gravity_times_sine;
    c->inverse_foot_mass = d_inverse_foot_mass;
    c->foot_mass_times_gravity_times_sine = d_foot_mass_times_gravity_times_sine;
    c->way = dx->way;
    c->is_own_times_own = d_is_own_times_own;
    c->by_1_minus_is_own = 0.0;
    c->foot_mass_times_gravity_times_cosine = d_foot_mass_times_gravity_times_cosine;
    c->gravity_times_cosine = d_gravity_times_cosine;
    c->extension_rate = dx->extension_rate;
    c->stiffness_times_extension_rate = d_stiffness_times_extension_rate;
    c->external_fx_rate = dx->external_fx_rate;
    c->external_fy_rate = dx->external_fy_rate;
    c->friction_rate = dx->friction_rate;
    c->external_torque_rate = dx->external_torque_rate;
    c->least_length = dp->least_length;
    c->winding = dx->winding;
    c->inverse_stribeck_velocity_or_by_1 = d_inverse_stribeck_velocity_or_by_1;
    c->segment_end_or_segment_begin = d_segment_end_or_segment_begin;
}

/* ramp_ends: A ramp of the friction coefficient ends at 0. */
static int react_slip_constant_ramp_ends(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->friction = 0.0;
    y->friction_rate = 0.0;
    return next[0]; /* slip */
}

/* First variation of ramp_ends. */
static void vary_react_slip_constant_ramp_ends(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed;
    y->friction = 0.0;
    y->friction_rate = 0.0;
}

/* True if ramp_ends is watched. */
static real watches_slip_constant_ramp_ends(const real *parameters, const real *states) {
    const runner_states *x = (const void *)states;
    (void)parameters;
    if (x->friction_rate < 0.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of ramp_ends. */
static real vary_guard_slip_constant_ramp_ends(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_states *dx = (const void *)d_states;
    (void)parameters, (void)states, (void)d_parameters;
    return dx->friction;
}

/* falls: The body reaches the ground. */
static int react_slip_constant_falls(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    (void)parameters, (void)tables;
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real sine = real_sin(x->slope);
    const real y_2 = x->foot_x * sine;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real vx = x->foot_vx * cosine;
    const real vy = x->foot_vx * sine;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    y->seen_x = x_2;
    y->seen_y = x->height + y_2;
    y->length = length;
    y->angle = angle;
    y->seen_vx = vx;
    y->seen_vy = vy;
    y->length_rate = length_rate;
    y->angle_rate = angle_rate;
    y->has_fallen = 1.0;
    return next[0]; /* fallen */
}

/* First variation of falls. */
static void vary_react_slip_constant_falls(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_states *x = (const void *)states;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    (void)parameters, (void)d_parameters, (void)tables, (void)seed;
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_x = dx->foot_x * cosine - x->foot_x * sine_times_slope;
    const real d_sine = cosine * dx->slope;
    const real d_y = dx->foot_x * sine + x->foot_x * d_sine;
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real d_length = 0.5 * d_square / length;
    const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
    const real d_vx = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
    const real d_vy = dx->foot_vx * sine + x->foot_vx * d_sine;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
    y->seen_x = d_x;
    y->seen_y = dx->height + d_y;
    y->length = d_length;
    y->angle = d_angle;
    y->seen_vx = d_vx;
    y->seen_vy = d_vy;
    y->length_rate = d_length_rate;
    y->angle_rate = d_angle_rate;
    y->has_fallen = 0.0;
}

/* First variation of the guard of falls. */
static real vary_guard_slip_constant_falls(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_states *dx = (const void *)d_states;
    (void)parameters, (void)states, (void)d_parameters;
    return dx->y_;
}

/* First variation of the guard of collapses. */
static real vary_guard_slip_constant_collapses(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    (void)parameters;
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real d_length = 0.5 * d_square / length;
    return d_length - dp->least_length;
}

/* greatest_compression: Thrust begins where the leg is shortest, once per stance. A thrust of 0 is not
 * counted. */
static int react_slip_constant_greatest_compression(const real *parameters, const real *states,
    const tdmf_table *tables, real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    (void)tables;
    const real longer = p->thrust + p->more_thrust;
    const real by_1_or_by_0 = select(longer > 0.0, 1.0, 0.0);
    const real is_new = select(x->time > x->last_event, by_1_or_by_0, 0.0);
    const real free_length_plus_extension = p->free_length + x->extension;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = free_length_plus_extension + longer_or_by_0;
    const real sum_2 = free_length_plus_extension + longer_or_by_0 * x->thrusting;
    const real jump = rest_length - sum_2;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real middle = sum_2 + 0.5 * jump - length;
    const real work = p->stiffness * jump * middle;
    const real begins = select(x->thrusting < 1.0, select(work >= 0.0, work, 0.0), 0.0);
    y->events = x->events + is_new;
    y->last_event = select(by_1_or_by_0 > 0.0, x->time, x->last_event);
    y->thrusting = 1.0;
    y->leg_work = x->leg_work + work;
    y->positive_leg_work = x->positive_leg_work + select(work > 0.0, work, begins);
    return next[0]; /* slip */
}

/* First variation of greatest_compression. */
static void vary_react_slip_constant_greatest_compression(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real longer = p->thrust + p->more_thrust;
    const real free_length_plus_extension = p->free_length + x->extension;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = free_length_plus_extension + longer_or_by_0;
    const real sum_2 = free_length_plus_extension + longer_or_by_0 * x->thrusting;
    const real jump = rest_length - sum_2;
    const real free_length_plus_extension_2 = dp->free_length + dx->extension;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_longer_or_by_0 = select(longer >= 0.0, d_longer, 0.0);
    const real d_rest_length = free_length_plus_extension_2 + d_longer_or_by_0;
    const real free_length_plus_extension_plus_sum = free_length_plus_extension_2
        + (d_longer_or_by_0 * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_jump = d_rest_length - free_length_plus_extension_plus_sum;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real middle = sum_2 + 0.5 * jump - length;
    const real stiffness_times_jump = p->stiffness * jump;
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real d_middle = free_length_plus_extension_plus_sum + 0.5 * d_jump - d_length;
    const real d_work = (dp->stiffness * jump + p->stiffness * d_jump) * middle
        + stiffness_times_jump * d_middle;
    const real work = stiffness_times_jump * middle;
    const real d_begins = select(x->thrusting < 1.0, select(work >= 0.0, d_work, 0.0), 0.0);
    y->events = dx->events;
    y->last_event = select(select(longer > 0.0, 1.0, 0.0) > 0.0, dx->time, dx->last_event);
    y->thrusting = 0.0;
    y->leg_work = dx->leg_work + d_work;
    y->positive_leg_work = dx->positive_leg_work + select(work > 0.0, d_work, d_begins);
}

/* True if greatest_compression is watched. */
static real watches_slip_constant_greatest_compression(const real *parameters, const real *states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    if (x->thrusting <= 0.0 && p->notes_compression > 0.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of greatest_compression. */
static real vary_guard_slip_constant_greatest_compression(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_states *x = (const void *)states;
    const runner_states *dx = (const void *)d_states;
    (void)parameters, (void)d_parameters;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    return -d_length_rate;
}

/* mid_stance: Drive ends where the leg is upright, once per stance. */
static int react_slip_constant_mid_stance(const real *parameters, const real *states,
    const tdmf_table *tables, real *after, const int *next) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->driving = 0.0;
    return next[0]; /* slip */
}

/* First variation of mid_stance. */
static void vary_react_slip_constant_mid_stance(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed;
    y->driving = 0.0;
}

/* True if mid_stance is watched. */
static real watches_slip_constant_mid_stance(const real *parameters, const real *states) {
    const runner_states *x = (const void *)states;
    (void)parameters;
    if (x->driving > 0.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of mid_stance. */
static real vary_guard_slip_constant_mid_stance(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_states *x = (const void *)states;
    const runner_states *dx = (const void *)d_states;
    (void)parameters, (void)d_parameters;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
    return d_angle;
}

/* lift_off: The normal force ends: flight if the flight law lifts the foot, too, else graze. A foot that is
 * hardly lifted grazes, too: the guard of its flight decides by its rate. Not so below an upright leg, whose
 * torque does not act along the normal. */
static int react_slip_constant_lift_off(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    (void)tables;
    const real sine = real_sin(x->slope);
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real along = x->foot_vx + share * x->vx;
    const real cosine = real_cos(x->slope);
    const real rise = sine * along + cosine * (share * x->vy);
    const real goes_on = select(x->time <= x->touchdown_time, x->was_placed, 0.0);
    const real free_length_plus_extension = p->free_length + x->extension;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = free_length_plus_extension + select(longer >= 0.0, longer, 0.0) * x->thrusting;
    const real x__times_x_ = x->x_ * x->x_;
    const real square = x__times_x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real spring = p->stiffness * (rest_length - length) - p->damping * length_rate;
    const real axial = spring / length;
    const real axial_times_y_ = axial * x->y_;
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real goes_on_times_placed_for = goes_on * x->placed_for;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real foot_mass_times_gravity_times_cosine = p->foot_mass * p->gravity * cosine;
    const real by_1eminus_06_times_free_length = 1e-06 * p->free_length;
    const real product_2 = by_1eminus_06_times_free_length * by_1eminus_06_times_free_length;
    const real stiffness_times_free_length = p->stiffness * p->free_length;
    const real hardly = select(x__times_x_ > product_2, 1e-09 * stiffness_times_free_length,
        -(1e-12 * stiffness_times_free_length));
    const real x_2 = x->foot_x * cosine;
    const real x_plus_product = x_2 + share * (x->x_ * cosine - x->y_ * sine);
    const real y_2 = x->foot_x * sine;
    const real height_plus_y_plus_product = x->height + y_2 + share * (x->x_ * sine + x->y_ * cosine);
    const real vx = x->foot_vx * cosine;
    const real vx_plus_product = vx + share * (x->vx * cosine - x->vy * sine);
    const real vy = x->foot_vx * sine;
    const real vy_plus_product = vy + share * (x->vx * sine + x->vy * cosine);
    const real jump = free_length_plus_extension - rest_length;
    const real middle = rest_length + 0.5 * jump - length;
    const real work = p->stiffness * jump * middle;
    const real leg_work_plus_work = x->leg_work + work;
    const real begins = select(x->thrusting < 0.0, select(work >= 0.0, work, 0.0), 0.0);
    const real positive_leg_work_plus_work_or_begins = x->positive_leg_work + select(work > 0.0, work,
        begins);
    const real product_3 = 1e-06 * stiffness_times_free_length;
    y->liftoff_angle = angle;
    y->placing = goes_on_times_placed_for;
    y->rises_again = goes_on;
    if (rise < 0.0 || goes_on > 0.0) {
        const real placing_angle = p->touchdown_angle + p->more_angle;
        const real servo = -(p->kp * (angle - (placing_angle
            - p->retraction_rate * goes_on_times_placed_for))) - p->kd * (angle_rate + p->retraction_rate);
        const real swing_torque = x->external_torque + servo;
        const real turning = swing_torque / square;
        const real off = axial_times_y_ + turning * x->x_;
        const real normal = off + foot_mass_times_gravity_times_cosine;
        const real lift = -normal;
        y->swing = 2.0;
        if (lift > hardly) {
            const real hops = select(x__times_x_ > product_2, product_3 + normal, -1.0);
            const real hopped = select(hops > 0.0, 1.0, x->has_hopped);
            const real hop_time = select(hops > 0.0, x->time, x->hop_time);
            y->length = length;
            y->angle = angle;
            y->length_rate = length_rate;
            y->com_x = x_plus_product;
            y->com_y = height_plus_y_plus_product;
            y->com_vx = vx_plus_product;
            y->com_vy = vy_plus_product;
            y->momentum = moment;
            y->thrusting = 0.0;
            y->leg_work = leg_work_plus_work;
            y->positive_leg_work = positive_leg_work_plus_work_or_begins;
            y->has_hopped = hopped;
            y->hop_time = hop_time;
            return next[0]; /* flight */
        }
        return next[1]; /* graze */
    }
    const real first = p->liftoff_factor * angle;
    const real retracting_torque = -(p->kp * (angle - first)) - p->kd * angle_rate;
    if (p->swing_clamp > 0.0 && retracting_torque <= 0.0) {
        const real flight_lifts = axial_times_y_ + x->external_torque / square * x->x_
            + foot_mass_times_gravity_times_cosine;
        y->swing = 0.0;
        if (-flight_lifts > hardly) {
            const real product_plus_flight_lifts_or_by_minus_1 = select(x__times_x_ > product_2, product_3
                + flight_lifts, -1.0);
            y->length = length;
            y->angle = angle;
            y->length_rate = length_rate;
            y->com_x = x_plus_product;
            y->com_y = height_plus_y_plus_product;
            y->com_vx = vx_plus_product;
            y->com_vy = vy_plus_product;
            y->momentum = moment;
            y->thrusting = 0.0;
            y->leg_work = leg_work_plus_work;
            y->positive_leg_work = positive_leg_work_plus_work_or_begins;
            y->has_hopped = select(product_plus_flight_lifts_or_by_minus_1 > 0.0, 1.0, x->has_hopped);
            y->hop_time = select(product_plus_flight_lifts_or_by_minus_1 > 0.0, x->time, x->hop_time);
            return next[0]; /* flight */
        }
        return next[1]; /* graze */
    }
    const real sum_2 = axial_times_y_ + (x->external_torque + retracting_torque) / square * x->x_
        + foot_mass_times_gravity_times_cosine;
    y->swing = 1.0;
    if (-sum_2 > hardly) {
        const real product_plus_sum_or_by_minus_1 = select(x__times_x_ > product_2, product_3 + sum_2, -1.0);
        y->length = length;
        y->angle = angle;
        y->length_rate = length_rate;
        y->com_x = x_plus_product;
        y->com_y = height_plus_y_plus_product;
        y->com_vx = vx_plus_product;
        y->com_vy = vy_plus_product;
        y->momentum = moment;
        y->thrusting = 0.0;
        y->leg_work = leg_work_plus_work;
        y->positive_leg_work = positive_leg_work_plus_work_or_begins;
        y->has_hopped = select(product_plus_sum_or_by_minus_1 > 0.0, 1.0, x->has_hopped);
        y->hop_time = select(product_plus_sum_or_by_minus_1 > 0.0, x->time, x->hop_time);
        return next[0]; /* flight */
    }
    return next[1]; /* graze */
}

/* First variation of lift_off. */
static void vary_react_slip_constant_lift_off(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real sine = real_sin(x->slope);
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real along = x->foot_vx + share * x->vx;
    const real cosine = real_cos(x->slope);
    const real rise = sine * along + cosine * (share * x->vy);
    const real goes_on = select(x->time <= x->touchdown_time, x->was_placed, 0.0);
    const real free_length_plus_extension = p->free_length + x->extension;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = free_length_plus_extension + longer_or_by_0 * x->thrusting;
    const real x__times_x_ = x->x_ * x->x_;
    const real square = x__times_x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real spring = p->stiffness * (rest_length - length) - p->damping * length_rate;
    const real axial = spring / length;
    const real axial_times_y_ = axial * x->y_;
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real foot_mass_times_gravity_times_cosine = p->foot_mass * p->gravity * cosine;
    const real by_1eminus_06_times_free_length = 1e-06 * p->free_length;
    const real product_2 = by_1eminus_06_times_free_length * by_1eminus_06_times_free_length;
    const real stiffness_times_free_length = p->stiffness * p->free_length;
    const real hardly = select(x__times_x_ > product_2, 1e-09 * stiffness_times_free_length,
        -(1e-12 * stiffness_times_free_length));
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real sine_times_slope = sine * dx->slope;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_sine = cosine * dx->slope;
    const real d_x = dx->foot_x * cosine - x->foot_x * sine_times_slope;
    const real d_x_plus_product_plus_share_times_sum = d_x + (d_share * (x->x_ * cosine - x->y_ * sine)
        + share * (dx->x_ * cosine - x->x_ * sine_times_slope - (dx->y_ * sine + x->y_ * d_sine)));
    const real d_y = dx->foot_x * sine + x->foot_x * d_sine;
    const real sum_2 = dx->height + d_y + (d_share * (x->x_ * sine + x->y_ * cosine)
        + share * (dx->x_ * sine + x->x_ * d_sine + (dx->y_ * cosine - x->y_ * sine_times_slope)));
    const real d_vx = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
    const real d_vx_plus_product_plus_share_times_sum = d_vx + (d_share * (x->vx * cosine - x->vy * sine)
        + share * (dx->vx * cosine - x->vx * sine_times_slope - (dx->vy * sine + x->vy * d_sine)));
    const real d_vy = dx->foot_vx * sine + x->foot_vx * d_sine;
    const real d_vy_plus_product_plus_share_times_sum = d_vy + (d_share * (x->vx * sine + x->vy * cosine)
        + share * (dx->vx * sine + x->vx * d_sine + (dx->vy * cosine - x->vy * sine_times_slope)));
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    const real jump = free_length_plus_extension - rest_length;
    const real free_length_plus_extension_2 = dp->free_length + dx->extension;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = free_length_plus_extension_2 + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_jump = free_length_plus_extension_2 - d_rest_length;
    const real middle = rest_length + 0.5 * jump - length;
    const real stiffness_times_jump = p->stiffness * jump;
    const real d_middle = d_rest_length + 0.5 * d_jump - d_length;
    const real d_work = (dp->stiffness * jump + p->stiffness * d_jump) * middle
        + stiffness_times_jump * d_middle;
    const real leg_work_plus_d_work = dx->leg_work + d_work;
    const real work = stiffness_times_jump * middle;
    const real d_begins = select(x->thrusting < 0.0, select(work >= 0.0, d_work, 0.0), 0.0);
    const real sum_3 = dx->positive_leg_work + select(work > 0.0, d_work, d_begins);
    const real d_goes_on = select(x->time <= x->touchdown_time, dx->was_placed, 0.0);
    const real sum_4 = d_goes_on * x->placed_for + goes_on * dx->placed_for;
    const real product_3 = 1e-06 * stiffness_times_free_length;
    y->liftoff_angle = d_angle;
    y->swing = 0.0;
    y->placing = sum_4;
    y->rises_again = d_goes_on;
    if (rise < 0.0 || goes_on > 0.0) {
        const real placing_angle = p->touchdown_angle + p->more_angle;
        const real servo = -(p->kp * (angle - (placing_angle
            - p->retraction_rate * (goes_on * x->placed_for)))) - p->kd * (angle_rate + p->retraction_rate);
        const real swing_torque = x->external_torque + servo;
        const real turning = swing_torque / square;
        const real off = axial_times_y_ + turning * x->x_;
        const real normal = off + foot_mass_times_gravity_times_cosine;
        const real lift = -normal;
        if (lift > hardly) {
            const real hops = select(x__times_x_ > product_2, product_3 + normal, -1.0);
            const real d_hopped = select(hops > 0.0, 0.0, dx->has_hopped);
            const real d_hop_time = select(hops > 0.0, dx->time, dx->hop_time);
            y->length = d_length;
            y->angle = d_angle;
            y->length_rate = d_length_rate;
            y->com_x = d_x_plus_product_plus_share_times_sum;
            y->com_y = sum_2;
            y->com_vx = d_vx_plus_product_plus_share_times_sum;
            y->com_vy = d_vy_plus_product_plus_share_times_sum;
            y->momentum = d_moment;
            y->thrusting = 0.0;
            y->leg_work = leg_work_plus_d_work;
            y->positive_leg_work = sum_3;
            y->has_hopped = d_hopped;
            y->hop_time = d_hop_time;
            return;
        }
        return;
    }
    const real first = p->liftoff_factor * angle;
    const real retracting_torque = -(p->kp * (angle - first)) - p->kd * angle_rate;
    if (p->swing_clamp > 0.0 && retracting_torque <= 0.0) {
        const real flight_lifts = axial_times_y_ + x->external_torque / square * x->x_
            + foot_mass_times_gravity_times_cosine;
        if (-flight_lifts > hardly) {
            const real product_plus_flight_lifts_or_by_minus_1 = select(x__times_x_ > product_2, product_3
                + flight_lifts, -1.0);
            y->length = d_length;
            y->angle = d_angle;
            y->length_rate = d_length_rate;
            y->com_x = d_x_plus_product_plus_share_times_sum;
            y->com_y = sum_2;
            y->com_vx = d_vx_plus_product_plus_share_times_sum;
            y->com_vy = d_vy_plus_product_plus_share_times_sum;
            y->momentum = d_moment;
            y->thrusting = 0.0;
            y->leg_work = leg_work_plus_d_work;
            y->positive_leg_work = sum_3;
            y->has_hopped = select(product_plus_flight_lifts_or_by_minus_1 > 0.0, 0.0, dx->has_hopped);
            y->hop_time = select(product_plus_flight_lifts_or_by_minus_1 > 0.0, dx->time, dx->hop_time);
            return;
        }
        return;
    }
    const real sum_5 = axial_times_y_ + (x->external_torque + retracting_torque) / square * x->x_
        + foot_mass_times_gravity_times_cosine;
    if (-sum_5 > hardly) {
        const real product_plus_sum_or_by_minus_1 = select(x__times_x_ > product_2, product_3 + sum_5, -1.0);
        y->length = d_length;
        y->angle = d_angle;
        y->length_rate = d_length_rate;
        y->com_x = d_x_plus_product_plus_share_times_sum;
        y->com_y = sum_2;
        y->com_vx = d_vx_plus_product_plus_share_times_sum;
        y->com_vy = d_vy_plus_product_plus_share_times_sum;
        y->momentum = d_moment;
        y->thrusting = 0.0;
        y->leg_work = leg_work_plus_d_work;
        y->positive_leg_work = sum_3;
        y->has_hopped = select(product_plus_sum_or_by_minus_1 > 0.0, 0.0, dx->has_hopped);
        y->hop_time = select(product_plus_sum_or_by_minus_1 > 0.0, dx->time, dx->hop_time);
        return;
    }
}

/* First variation of the guard of lift_off. */
static real vary_guard_slip_constant_lift_off(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real rest_length_minus_length = rest_length - length;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * rest_length_minus_length + p->stiffness * (d_rest_length
        - d_length) - (dp->damping * length_rate + p->damping * d_length_rate);
    const real spring = p->stiffness * rest_length_minus_length - p->damping * length_rate;
    const real axial = spring / length;
    const real d_axial = (d_spring - axial * d_length) / length;
    const real drive_torque_plus_more_torque = p->drive_torque + p->more_torque;
    const real d_stance_torque = dx->external_torque - ((dp->drive_torque + dp->more_torque) * x->driving
        + drive_torque_plus_more_torque * dx->driving);
    const real stance_torque = x->external_torque - drive_torque_plus_more_torque * x->driving;
    const real turning = stance_torque / square;
    const real d_turning = (d_stance_torque - turning * d_square) / square;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real d_normal = d_off + ((p->gravity * dp->foot_mass + p->foot_mass * dp->gravity) * cosine
        - p->foot_mass * p->gravity * (sine * dx->slope));
    return d_normal;
}

/* enters_layer: Slip is slow enough for friction to depend on the speed. */
static int react_slip_constant_enters_layer(const real *parameters, const real *states,
    const tdmf_table *tables, real *after, const int *next) {
    (void)parameters, (void)states, (void)tables, (void)after;
    return next[0]; /* slip */
}

/* First variation of enters_layer. */
static void vary_react_slip_constant_enters_layer(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed, (void)after;
}

/* True if enters_layer is watched. */
static real watches_slip_constant_enters_layer(const real *parameters, const real *states) {
    const runner_parameters *p = (const void *)parameters;
    (void)states;
    if (p->stribeck_velocity > 0.0 && p->static_ratio > 1.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of enters_layer. */
static real vary_guard_slip_constant_enters_layer(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real stribeck_velocity_or_by_1 = select(p->stribeck_velocity > 0.0, p->stribeck_velocity, 1.0);
    const real speed_in_layer = x->way * x->foot_vx / stribeck_velocity_or_by_1;
    const real d_speed_in_layer = (dx->way * x->foot_vx + x->way * dx->foot_vx
        - speed_in_layer * select(p->stribeck_velocity > 0.0, dp->stribeck_velocity,
        0.0)) / stribeck_velocity_or_by_1;
    return d_speed_in_layer;
}

/* comes_to_rest: The slip velocity reaches 0: the foot sticks, or slips the other way. */
static int react_slip_constant_comes_to_rest(const real *parameters, const real *states,
    const tdmf_table *tables, real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real vx_plus_foot_vx = x->vx + x->foot_vx;
    const real length_rate = (x->x_ * vx_plus_foot_vx + x->y_ * x->vy) / length;
    const real spring = p->stiffness * (rest_length - length) - p->damping * length_rate;
    const real axial = spring / length;
    const real stance_torque = x->external_torque - (p->drive_torque + p->more_torque) * x->driving;
    const real turning = stance_torque / square;
    const real along = axial * x->x_ - turning * x->y_;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real sine = real_sin(x->slope);
    const real sum_2 = along + foot_mass_times_gravity * sine;
    const real way = select(sum_2 > 0.0, -1.0, 1.0);
    const real ends = select(x->segment_end < 1000000000000.0, 1.0, 0.0);
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real by_1eminus_12_times_free_length = 1e-12 * p->free_length;
    const real x_plus_by_1eminus_12_times_free_length = x_2 + by_1eminus_12_times_free_length;
    const real begins = select(x->segment_begin > -1000000000000.0, 1.0, 0.0);
    const real segment_towards = x->segment
        + ends * select(x_plus_by_1eminus_12_times_free_length > x->segment_end, 1.0, 0.0)
        - begins * select(x_plus_by_1eminus_12_times_free_length < x->segment_begin, 1.0, 0.0);
    const real friction_ahead_or_friction = select(p->keeps_friction > 0.0, x->friction_ahead,
        looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, segment_towards,
        select(real_abs(segment_towards - 1.0) > 0.0, -1.0, p->patch_friction)));
    const real x_minus_by_1eminus_12_times_free_length = x_2 - by_1eminus_12_times_free_length;
    const real sum_3 = x->segment + ends * select(x_minus_by_1eminus_12_times_free_length > x->segment_end,
        1.0, 0.0) - begins * select(x_minus_by_1eminus_12_times_free_length < x->segment_begin, 1.0, 0.0);
    const real friction_behind_or_friction = select(p->keeps_friction > 0.0, x->friction_behind,
        looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, sum_3, select(real_abs(sum_3
        - 1.0) > 0.0, -1.0, p->patch_friction)));
    const real own = select(way > 0.0, friction_ahead_or_friction, friction_behind_or_friction);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real friction_along = is_own * own + (1.0 - is_own) * x->friction;
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + foot_mass_times_gravity * cosine;
    const real cone = p->static_ratio * friction_along * normal;
    y->vx = vx_plus_foot_vx;
    y->foot_vx = 0.0;
    if (real_abs(sum_2) <= cone) {
        y->friction_ahead = friction_ahead_or_friction;
        y->friction_behind = friction_behind_or_friction;
        return next[0]; /* stick */
    }
    const real x_plus_product = x_2 + by_1eminus_12_times_free_length * way;
    const real sum_4 = x->segment + ends * select(x_plus_product > x->segment_end, 1.0, 0.0)
        - begins * select(x_plus_product < x->segment_begin, 1.0, 0.0);
    const real end = select(p->patch_end > p->patch_begin, p->patch_end, 1000000000000.0);
    const real begin = select(p->patch_end > p->patch_begin, p->patch_begin, 1000000000000.0);
    const real friction = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, sum_4,
        select(real_abs(sum_4 - 1.0) > 0.0, -1.0, p->patch_friction));
    y->segment = sum_4;
    y->segment_begin = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, sum_4,
        select(sum_4 > 0.0, select(sum_4 > 1.0, end, begin), -1000000000000.0));
    y->segment_end = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, sum_4,
        select(sum_4 > 0.0, select(sum_4 > 1.0, 1000000000000.0, end), begin));
    y->segment_height = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height, sum_4, 0.0);
    y->segment_slope = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, sum_4, 0.0);
    y->friction_ahead = select(p->keeps_friction > 0.0, friction_ahead_or_friction, friction);
    y->friction_behind = select(p->keeps_friction > 0.0, friction_behind_or_friction, friction);
    y->way = way;
    return next[1]; /* slip */
}

/* First variation of comes_to_rest. */
static void vary_react_slip_constant_comes_to_rest(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real length_rate = (x->x_ * (x->vx + x->foot_vx) + x->y_ * x->vy) / length;
    const real spring = p->stiffness * (rest_length - length) - p->damping * length_rate;
    const real axial = spring / length;
    const real stance_torque = x->external_torque - (p->drive_torque + p->more_torque) * x->driving;
    const real turning = stance_torque / square;
    const real along = axial * x->x_ - turning * x->y_;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real sine = real_sin(x->slope);
    const real sum_2 = along + foot_mass_times_gravity * sine;
    const real way = select(sum_2 > 0.0, -1.0, 1.0);
    const real ends = select(x->segment_end < 1000000000000.0, 1.0, 0.0);
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real by_1eminus_12_times_free_length = 1e-12 * p->free_length;
    const real x_plus_by_1eminus_12_times_free_length = x_2 + by_1eminus_12_times_free_length;
    const real begins = select(x->segment_begin > -1000000000000.0, 1.0, 0.0);
    const real segment_towards = x->segment
        + ends * select(x_plus_by_1eminus_12_times_free_length > x->segment_end, 1.0, 0.0)
        - begins * select(x_plus_by_1eminus_12_times_free_length < x->segment_begin, 1.0, 0.0);
    const real abs_of_segment_towards_minus_by_1 = real_abs(segment_towards - 1.0);
    const real x_minus_by_1eminus_12_times_free_length = x_2 - by_1eminus_12_times_free_length;
    const real sum_3 = x->segment + ends * select(x_minus_by_1eminus_12_times_free_length > x->segment_end,
        1.0, 0.0) - begins * select(x_minus_by_1eminus_12_times_free_length < x->segment_begin, 1.0, 0.0);
    const real abs_of_sum_minus_by_1 = real_abs(sum_3 - 1.0);
    const real own = select(way > 0.0, select(p->keeps_friction > 0.0, x->friction_ahead, looked_up(tables,
        TABLE_ground_segment, COLUMN_ground_segment_friction, segment_towards,
        select(abs_of_segment_towards_minus_by_1 > 0.0, -1.0, p->patch_friction))),
        select(p->keeps_friction > 0.0, x->friction_behind, looked_up(tables, TABLE_ground_segment,
        COLUMN_ground_segment_friction, sum_3, select(abs_of_sum_minus_by_1 > 0.0, -1.0,
        p->patch_friction))));
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real friction_along = is_own * own + (1.0 - is_own) * x->friction;
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + foot_mass_times_gravity * cosine;
    const real cone = p->static_ratio * friction_along * normal;
    const real friction_ahead_or_d_friction = select(p->keeps_friction > 0.0, dx->friction_ahead,
        variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, seed,
        segment_towards, select(abs_of_segment_towards_minus_by_1 > 0.0, 0.0, dp->patch_friction)));
    const real friction_behind_or_d_friction = select(p->keeps_friction > 0.0, dx->friction_behind,
        variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, seed, sum_3,
        select(abs_of_sum_minus_by_1 > 0.0, 0.0, dp->patch_friction)));
    const real vx_plus_foot_vx = dx->vx + dx->foot_vx;
    y->vx = vx_plus_foot_vx;
    y->foot_vx = 0.0;
    if (real_abs(sum_2) <= cone) {
        y->friction_ahead = friction_ahead_or_d_friction;
        y->friction_behind = friction_behind_or_d_friction;
        return;
    }
    const real x_plus_product = x_2 + by_1eminus_12_times_free_length * way;
    const real sum_4 = x->segment + ends * select(x_plus_product > x->segment_end, 1.0, 0.0)
        - begins * select(x_plus_product < x->segment_begin, 1.0, 0.0);
    const real d_end = select(p->patch_end > p->patch_begin, dp->patch_end, 0.0);
    const real d_begin = select(p->patch_end > p->patch_begin, dp->patch_begin, 0.0);
    const real d_friction = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        seed, sum_4, select(real_abs(sum_4 - 1.0) > 0.0, 0.0, dp->patch_friction));
    y->segment = dx->segment;
    y->segment_begin = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, seed,
        sum_4, select(sum_4 > 0.0, select(sum_4 > 1.0, d_end, d_begin), 0.0));
    y->segment_end = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, seed, sum_4,
        select(sum_4 > 0.0, select(sum_4 > 1.0, 0.0, d_end), d_begin));
    y->segment_height = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height, seed,
        sum_4, 0.0);
    y->segment_slope = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, seed,
        sum_4, 0.0);
    y->friction_ahead = select(p->keeps_friction > 0.0, friction_ahead_or_d_friction, d_friction);
    y->friction_behind = select(p->keeps_friction > 0.0, friction_behind_or_d_friction, d_friction);
    y->way = 0.0;
}

/* First variation of the guard of comes_to_rest. */
static real vary_guard_slip_constant_comes_to_rest(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_states *x = (const void *)states;
    const runner_states *dx = (const void *)d_states;
    (void)parameters, (void)d_parameters;
    return dx->way * x->foot_vx + x->way * dx->foot_vx;
}

/* crosses_border: The foot slips onto the next segment, whose line waits until the foot lifts off. */
static int react_slip_constant_crosses_border(const real *parameters, const real *states,
    const tdmf_table *tables, real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real number = x->segment + x->way;
    const real slope = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, number, 0.0);
    const real height = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height, number, 0.0);
    const real end = select(p->patch_end > p->patch_begin, p->patch_end, 1000000000000.0);
    const real begin = select(p->patch_end > p->patch_begin, p->patch_begin, 1000000000000.0);
    const real begin_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, number,
        select(number > 0.0, select(number > 1.0, end, begin), -1000000000000.0));
    const real end_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, number,
        select(number > 0.0, select(number > 1.0, 1000000000000.0, end), begin));
    const real friction = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, number,
        select(real_abs(number - 1.0) > 0.0, -1.0, p->patch_friction));
    const real friction_ahead_or_friction = select(p->keeps_friction > 0.0, x->friction_ahead, friction);
    const real friction_behind_or_friction = select(p->keeps_friction > 0.0, x->friction_behind, friction);
    y->segment = number;
    y->segment_begin = begin_2;
    y->segment_end = end_2;
    y->segment_height = height;
    y->segment_slope = slope;
    y->friction_ahead = friction_ahead_or_friction;
    y->friction_behind = friction_behind_or_friction;
    if (p->trips <= 0.0) {
        return next[0]; /* slip */
    }
    const real set_slope = p->ground_slope + slope;
    const real sine = real_sin(x->slope);
    const real y_2 = x->foot_x * sine;
    const real height_plus_y = x->height + y_2;
    const real set_height = p->ground_height + height;
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real foot_above = real_cos(set_slope) * (height_plus_y - set_height) - real_sin(set_slope) * x_2;
    if (foot_above < -(1e-12 * p->free_length)) {
        const real square = x->x_ * x->x_ + x->y_ * x->y_;
        const real length = real_sqrt(square);
        const real angle = real_atan2(-x->x_, x->y_) + x->winding;
        const real vx = x->foot_vx * cosine;
        const real vy = x->foot_vx * sine;
        const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
        const real moment = x->x_ * x->vy - x->y_ * x->vx;
        const real angle_rate = moment / square;
        y->seen_x = x_2;
        y->seen_y = height_plus_y;
        y->length = length;
        y->angle = angle;
        y->seen_vx = vx;
        y->seen_vy = vy;
        y->length_rate = length_rate;
        y->angle_rate = angle_rate;
        y->has_fallen = 1.0;
        return next[1]; /* fallen */
    }
    return next[0]; /* slip */
}

/* First variation of crosses_border. */
static void vary_react_slip_constant_crosses_border(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real number = x->segment + x->way;
    const real d_number = dx->segment + dx->way;
    const real d_end = select(p->patch_end > p->patch_begin, dp->patch_end, 0.0);
    const real d_begin = select(p->patch_end > p->patch_begin, dp->patch_begin, 0.0);
    const real d_begin_2 = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin,
        seed, number, select(number > 0.0, select(number > 1.0, d_end, d_begin), 0.0));
    const real d_end_2 = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, seed,
        number, select(number > 0.0, select(number > 1.0, 0.0, d_end), d_begin));
    const real d_height = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height,
        seed, number, 0.0);
    const real d_slope = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, seed,
        number, 0.0);
    const real d_friction = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        seed, number, select(real_abs(number - 1.0) > 0.0, 0.0, dp->patch_friction));
    const real friction_ahead_or_d_friction = select(p->keeps_friction > 0.0, dx->friction_ahead, d_friction);
    const real friction_behind_or_d_friction = select(p->keeps_friction > 0.0, dx->friction_behind,
        d_friction);
    y->segment = d_number;
    y->segment_begin = d_begin_2;
    y->segment_end = d_end_2;
    y->segment_height = d_height;
    y->segment_slope = d_slope;
    y->friction_ahead = friction_ahead_or_d_friction;
    y->friction_behind = friction_behind_or_d_friction;
    if (p->trips <= 0.0) {
        return;
    }
    const real set_slope = p->ground_slope + looked_up(tables, TABLE_ground_segment,
        COLUMN_ground_segment_slope, number, 0.0);
    const real sine = real_sin(x->slope);
    const real y_2 = x->foot_x * sine;
    const real set_height = p->ground_height + looked_up(tables, TABLE_ground_segment,
        COLUMN_ground_segment_height, number, 0.0);
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real foot_above = real_cos(set_slope) * (x->height + y_2 - set_height) - real_sin(set_slope) * x_2;
    if (foot_above < -(1e-12 * p->free_length)) {
        const real sine_times_slope = sine * dx->slope;
        const real d_x = dx->foot_x * cosine - x->foot_x * sine_times_slope;
        const real d_sine = cosine * dx->slope;
        const real d_y = dx->foot_x * sine + x->foot_x * d_sine;
        const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
        const real square = x->x_ * x->x_ + x->y_ * x->y_;
        const real length = real_sqrt(square);
        const real d_length = 0.5 * d_square / length;
        const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
        const real d_vx = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
        const real d_vy = dx->foot_vx * sine + x->foot_vx * d_sine;
        const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
        const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
            - length_rate * d_length) / length;
        const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
        const real moment = x->x_ * x->vy - x->y_ * x->vx;
        const real angle_rate = moment / square;
        const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
        y->seen_x = d_x;
        y->seen_y = dx->height + d_y;
        y->length = d_length;
        y->angle = d_angle;
        y->seen_vx = d_vx;
        y->seen_vy = d_vy;
        y->length_rate = d_length_rate;
        y->angle_rate = d_angle_rate;
        y->has_fallen = 0.0;
        return;
    }
}

/* True if crosses_border is watched. */
static real watches_slip_constant_crosses_border(const real *parameters, const real *states) {
    const runner_states *x = (const void *)states;
    (void)parameters;
    if (select(x->way > 0.0, x->segment_end, -x->segment_begin) < 1000000000000.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of crosses_border. */
static real vary_guard_slip_constant_crosses_border(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_states *x = (const void *)states;
    const runner_states *dx = (const void *)d_states;
    (void)parameters, (void)d_parameters;
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real sine = real_sin(x->slope);
    const real d_x = dx->foot_x * cosine - x->foot_x * (sine * dx->slope);
    const real d_border_distance = dx->way * (select(x->way > 0.0, x->segment_end, x->segment_begin) - x_2)
        + x->way * (select(x->way > 0.0, dx->segment_end, dx->segment_begin) - d_x);
    return d_border_distance;
}

/* Outputs in slip_constant. */
static void outputs_slip_constant(const real *parameters, const real *states, real *outputs) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const real set_height = p->ground_height + x->segment_height;
    const real set_slope = p->ground_slope + x->segment_slope;
    const real pending = select(real_abs(set_height - x->height) + real_abs(p->free_length * (set_slope
        - x->slope)) > 0.0, 1.0, 0.0);
    const real stance_torque = x->external_torque - (p->drive_torque + p->more_torque) * x->driving;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real shorter = rest_length - length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real spring = p->stiffness * shorter - p->damping * length_rate;
    const real axial = spring / length;
    const real turning = stance_torque / square;
    const real off = axial * x->y_ + turning * x->x_;
    const real cosine = real_cos(x->slope);
    const real normal = off + p->foot_mass * p->gravity * cosine;
    const real own = select(x->way > 0.0, x->friction_ahead, x->friction_behind);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real friction_along = is_own * own + (1.0 - is_own) * x->friction;
    const real way_times_friction_along_times_normal = x->way * friction_along * normal;
    const real tangential_force = -way_times_friction_along_times_normal;
    const real sine = real_sin(x->slope);
    const real x_2 = -(way_times_friction_along_times_normal * cosine) - normal * sine;
    const real y_2 = normal * cosine - way_times_friction_along_times_normal * sine;
    const real foot_x_times_cosine = x->foot_x * cosine;
    const real x__times_cosine_minus_y__times_sine = x->x_ * cosine - x->y_ * sine;
    const real body_x = foot_x_times_cosine + x__times_cosine_minus_y__times_sine;
    const real height_plus_foot_x_times_sine = x->height + x->foot_x * sine;
    const real x__times_sine_plus_y__times_cosine = x->x_ * sine + x->y_ * cosine;
    const real body_y = height_plus_foot_x_times_sine + x__times_sine_plus_y__times_cosine;
    const real foot_vx_times_cosine = x->foot_vx * cosine;
    const real vx = x->vx * cosine - x->vy * sine;
    const real body_vx = foot_vx_times_cosine + vx;
    const real foot_vx_times_sine = x->foot_vx * sine;
    const real vy = x->vx * sine + x->vy * cosine;
    const real body_vy = foot_vx_times_sine + vy;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real center_x = foot_x_times_cosine + share * x__times_cosine_minus_y__times_sine;
    const real center_y = height_plus_foot_x_times_sine + share * x__times_sine_plus_y__times_cosine;
    const real center_vx = foot_vx_times_cosine + share * vx;
    const real center_vy = foot_vx_times_sine + share * vy;
    const real of_body = p->body_mass * (body_vx * body_vx + body_vy * body_vy);
    const real kinetic_energy = 0.5 * (of_body + p->foot_mass * (foot_vx_times_cosine * foot_vx_times_cosine
        + foot_vx_times_sine * foot_vx_times_sine));
    const real potential_energy = p->gravity * (p->body_mass * body_y
        + p->foot_mass * height_plus_foot_x_times_sine);
    const real elastic_energy = 0.5 * (p->stiffness * (shorter * shorter));
    const real energy = kinetic_energy + potential_energy + elastic_energy;
    const real kind_of_contact = select(x->way > 0.0, 3.0, 4.0);
    const real phase_of_hip = select(x->driving > 0.0, 1.0, 2.0);
    outputs[OUTPUT_pending] = pending;
    outputs[OUTPUT_torque] = stance_torque;
    outputs[OUTPUT_normal_force] = normal;
    outputs[OUTPUT_tangential_force] = tangential_force;
    outputs[OUTPUT_ground_force_x] = x_2;
    outputs[OUTPUT_ground_force_y] = y_2;
    outputs[OUTPUT_force_of_leg] = spring;
    outputs[OUTPUT_body_x] = body_x;
    outputs[OUTPUT_body_y] = body_y;
    outputs[OUTPUT_body_vx] = body_vx;
    outputs[OUTPUT_body_vy] = body_vy;
    outputs[OUTPUT_center_x] = center_x;
    outputs[OUTPUT_center_y] = center_y;
    outputs[OUTPUT_center_vx] = center_vx;
    outputs[OUTPUT_center_vy] = center_vy;
    outputs[OUTPUT_kinetic_energy] = kinetic_energy;
    outputs[OUTPUT_potential_energy] = potential_energy;
    outputs[OUTPUT_elastic_energy] = elastic_energy;
    outputs[OUTPUT_energy] = energy;
    outputs[OUTPUT_kind_of_contact] = kind_of_contact;
    outputs[OUTPUT_phase_of_hip] = phase_of_hip;
}

/* First variation of outputs_slip_constant. */
static void vary_outputs_slip_constant(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *outputs) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real drive_torque_plus_more_torque = p->drive_torque + p->more_torque;
    const real d_stance_torque = dx->external_torque - ((dp->drive_torque + dp->more_torque) * x->driving
        + drive_torque_plus_more_torque * dx->driving);
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real shorter = rest_length - length;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real d_shorter = d_rest_length - d_length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * shorter + p->stiffness * d_shorter - (dp->damping * length_rate
        + p->damping * d_length_rate);
    const real spring = p->stiffness * shorter - p->damping * length_rate;
    const real axial = spring / length;
    const real d_axial = (d_spring - axial * d_length) / length;
    const real stance_torque = x->external_torque - drive_torque_plus_more_torque * x->driving;
    const real turning = stance_torque / square;
    const real d_turning = (d_stance_torque - turning * d_square) / square;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real cosine = real_cos(x->slope);
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_normal = d_off + ((p->gravity * dp->foot_mass + p->foot_mass * dp->gravity) * cosine
        - foot_mass_times_gravity * sine_times_slope);
    const real own = select(x->way > 0.0, x->friction_ahead, x->friction_behind);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real by_1_minus_is_own = 1.0 - is_own;
    const real friction_along = is_own * own + by_1_minus_is_own * x->friction;
    const real d_own = select(x->way > 0.0, dx->friction_ahead, dx->friction_behind);
    const real d_friction_along = is_own * d_own + by_1_minus_is_own * dx->friction;
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + foot_mass_times_gravity * cosine;
    const real way_times_friction_along = x->way * friction_along;
    const real sum_2 = (dx->way * friction_along + x->way * d_friction_along) * normal
        + way_times_friction_along * d_normal;
    const real d_tangential_force = -sum_2;
    const real way_times_friction_along_times_normal = way_times_friction_along * normal;
    const real d_sine = cosine * dx->slope;
    const real d_x = -(sum_2 * cosine - way_times_friction_along_times_normal * sine_times_slope)
        - (d_normal * sine + normal * d_sine);
    const real d_y = d_normal * cosine - normal * sine_times_slope - (sum_2 * sine
        + way_times_friction_along_times_normal * d_sine);
    const real sum_3 = dx->foot_x * cosine - x->foot_x * sine_times_slope;
    const real sum_4 = dx->x_ * cosine - x->x_ * sine_times_slope - (dx->y_ * sine + x->y_ * d_sine);
    const real d_body_x = sum_3 + sum_4;
    const real height_plus_sum = dx->height + (dx->foot_x * sine + x->foot_x * d_sine);
    const real sum_5 = dx->x_ * sine + x->x_ * d_sine + (dx->y_ * cosine - x->y_ * sine_times_slope);
    const real d_body_y = height_plus_sum + sum_5;
    const real sum_6 = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
    const real d_vx = dx->vx * cosine - x->vx * sine_times_slope - (dx->vy * sine + x->vy * d_sine);
    const real d_body_vx = sum_6 + d_vx;
    const real sum_7 = dx->foot_vx * sine + x->foot_vx * d_sine;
    const real d_vy = dx->vx * sine + x->vx * d_sine + (dx->vy * cosine - x->vy * sine_times_slope);
    const real d_body_vy = sum_7 + d_vy;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_center_x = sum_3 + (d_share * (x->x_ * cosine - x->y_ * sine) + share * sum_4);
    const real x__times_sine_plus_y__times_cosine = x->x_ * sine + x->y_ * cosine;
    const real d_center_y = height_plus_sum + (d_share * x__times_sine_plus_y__times_cosine + share * sum_5);
    const real vx = x->vx * cosine - x->vy * sine;
    const real d_center_vx = sum_6 + (d_share * vx + share * d_vx);
    const real vy = x->vx * sine + x->vy * cosine;
    const real d_center_vy = sum_7 + (d_share * vy + share * d_vy);
    const real foot_vx_times_cosine = x->foot_vx * cosine;
    const real body_vx = foot_vx_times_cosine + vx;
    const real foot_vx_times_sine = x->foot_vx * sine;
    const real body_vy = foot_vx_times_sine + vy;
    const real d_of_body = dp->body_mass * (body_vx * body_vx + body_vy * body_vy)
        + p->body_mass * (2.0 * (body_vx * d_body_vx) + 2.0 * (body_vy * d_body_vy));
    const real d_kinetic_energy = 0.5 * (d_of_body
        + (dp->foot_mass * (foot_vx_times_cosine * foot_vx_times_cosine
        + foot_vx_times_sine * foot_vx_times_sine) + p->foot_mass * (2.0 * (foot_vx_times_cosine * sum_6)
        + 2.0 * (foot_vx_times_sine * sum_7))));
    const real height_plus_foot_x_times_sine = x->height + x->foot_x * sine;
    const real body_y = height_plus_foot_x_times_sine + x__times_sine_plus_y__times_cosine;
    const real d_potential_energy = dp->gravity * (p->body_mass * body_y
        + p->foot_mass * height_plus_foot_x_times_sine) + p->gravity * (dp->body_mass * body_y
        + p->body_mass * d_body_y + (dp->foot_mass * height_plus_foot_x_times_sine
        + p->foot_mass * height_plus_sum));
    const real d_elastic_energy = 0.5 * (dp->stiffness * (shorter * shorter)
        + p->stiffness * (2.0 * (shorter * d_shorter)));
    const real d_energy = d_kinetic_energy + d_potential_energy + d_elastic_energy;
    outputs[OUTPUT_pending] = 0.0;
    outputs[OUTPUT_torque] = d_stance_torque;
    outputs[OUTPUT_normal_force] = d_normal;
    outputs[OUTPUT_tangential_force] = d_tangential_force;
    outputs[OUTPUT_ground_force_x] = d_x;
    outputs[OUTPUT_ground_force_y] = d_y;
    outputs[OUTPUT_force_of_leg] = d_spring;
    outputs[OUTPUT_body_x] = d_body_x;
    outputs[OUTPUT_body_y] = d_body_y;
    outputs[OUTPUT_body_vx] = d_body_vx;
    outputs[OUTPUT_body_vy] = d_body_vy;
    outputs[OUTPUT_center_x] = d_center_x;
    outputs[OUTPUT_center_y] = d_center_y;
    outputs[OUTPUT_center_vx] = d_center_vx;
    outputs[OUTPUT_center_vy] = d_center_vy;
    outputs[OUTPUT_kinetic_energy] = d_kinetic_energy;
    outputs[OUTPUT_potential_energy] = d_potential_energy;
    outputs[OUTPUT_elastic_energy] = d_elastic_energy;
    outputs[OUTPUT_energy] = d_energy;
    outputs[OUTPUT_kind_of_contact] = 0.0;
    outputs[OUTPUT_phase_of_hip] = 0.0;
}

/* Count the event. A contact mode that lasted adds a letter to the gait word, a new stance a bar. */
static void leave_slip_constant(const real *parameters, const real *states, real counted, real *after) {
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    (void)parameters;
    const real is_new = select(x->time > x->last_event, counted, 0.0);
    const real slid = x->way * (x->foot_x - x->slid_from);
    const real lasted = x->time - x->mode_began;
    const real letter = select(x->way > 0.0, 3.0, 1.0);
    const real adds = select(lasted > 0.0, select(real_abs(letter - x->last_letter) > 0.0, 1.0,
        x->bar_is_due), 0.0);
    const real after_bar = select(x->bar_is_due * x->word_so_far > 0.0, 4.0 * x->word_so_far, x->word_so_far);
    const real by_4_times_after_bar_plus_letter = 4.0 * after_bar + letter;
    const real longer = select(x->word_so_far < 0.0, x->word_so_far,
        select(by_4_times_after_bar_plus_letter < 4503599627370496.0, by_4_times_after_bar_plus_letter,
        -select(after_bar < 4503599627370496.0, after_bar, x->word_so_far)));
    y->events = x->events + is_new;
    y->last_event = select(counted > 0.0, x->time, x->last_event);
    y->slip_so_far = x->slip_so_far + slid;
    y->slid_from = x->foot_x;
    y->stance_so_far = x->stance_so_far + lasted;
    y->word_so_far = select(adds > 0.0, longer, x->word_so_far);
    y->last_letter = select(lasted > 0.0, letter, x->last_letter);
    y->bar_is_due = select(lasted > 0.0, 0.0, x->bar_is_due);
    y->mode_began = x->time;
}

/* First variation of leave_slip_constant. */
static void vary_leave_slip_constant(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real counted, real *after) {
    const runner_states *x = (const void *)states;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    (void)parameters, (void)d_parameters;
    const real d_slid = dx->way * (x->foot_x - x->slid_from) + x->way * (dx->foot_x - dx->slid_from);
    const real d_lasted = dx->time - dx->mode_began;
    const real lasted = x->time - x->mode_began;
    const real letter = select(x->way > 0.0, 3.0, 1.0);
    const real adds = select(lasted > 0.0, select(real_abs(letter - x->last_letter) > 0.0, 1.0,
        x->bar_is_due), 0.0);
    const real bar_is_due_times_word_so_far = x->bar_is_due * x->word_so_far;
    const real after_bar = select(bar_is_due_times_word_so_far > 0.0, 4.0 * x->word_so_far, x->word_so_far);
    const real d_after_bar = select(bar_is_due_times_word_so_far > 0.0, 4.0 * dx->word_so_far,
        dx->word_so_far);
    const real d_longer = select(x->word_so_far < 0.0, dx->word_so_far, select(4.0 * after_bar
        + letter < 4503599627370496.0, 4.0 * d_after_bar, -select(after_bar < 4503599627370496.0, d_after_bar,
        dx->word_so_far)));
    y->events = dx->events;
    y->last_event = select(counted > 0.0, dx->time, dx->last_event);
    y->slip_so_far = dx->slip_so_far + d_slid;
    y->slid_from = dx->foot_x;
    y->stance_so_far = dx->stance_so_far + d_lasted;
    y->word_so_far = select(adds > 0.0, d_longer, dx->word_so_far);
    y->last_letter = select(lasted > 0.0, 0.0, dx->last_letter);
    y->bar_is_due = select(lasted > 0.0, 0.0, dx->bar_is_due);
    y->mode_began = dx->time;
}

/* from world, in slip. */
static void from_world_slip_constant(const real *parameters, const real *states, real *after) {
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    (void)parameters;
    const real cos_of_slope = real_cos(x->slope);
    const real sin_of_slope = real_sin(x->slope);
    const real along = x->seen_x * cos_of_slope + (x->seen_y - x->height) * sin_of_slope;
    const real cosine = real_cos(x->angle);
    const real y_2 = x->length * cosine;
    const real sine = real_sin(x->angle);
    const real length_times_sine = x->length * sine;
    const real turn = x->length * x->angle_rate;
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real vy = x->length_rate * cosine - turn * sine;
    y->foot_x = along;
    y->foot_vx = x->seen_vx * cos_of_slope + x->seen_vy * sin_of_slope;
    y->x_ = y_2 * sin_of_slope - length_times_sine * cos_of_slope;
    y->y_ = y_2 * cos_of_slope + length_times_sine * sin_of_slope;
    y->vx = vx * cos_of_slope + vy * sin_of_slope;
    y->vy = vy * cos_of_slope - vx * sin_of_slope;
    y->winding = x->angle - real_atan2(-(y_2 * sin_of_slope - length_times_sine * cos_of_slope),
        y_2 * cos_of_slope + length_times_sine * sin_of_slope);
}

/* First variation of from_world_slip_constant. */
static void vary_from_world_slip_constant(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, real *after) {
    const runner_states *x = (const void *)states;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    (void)parameters, (void)d_parameters;
    const real cos_of_slope = real_cos(x->slope);
    const real sin_of_slope = real_sin(x->slope);
    const real sin_of_slope_times_slope = sin_of_slope * dx->slope;
    const real cos_of_slope_times_slope = cos_of_slope * dx->slope;
    const real d_along = dx->seen_x * cos_of_slope - x->seen_x * sin_of_slope_times_slope + ((dx->seen_y
        - dx->height) * sin_of_slope + (x->seen_y - x->height) * cos_of_slope_times_slope);
    const real cosine = real_cos(x->angle);
    const real sine = real_sin(x->angle);
    const real sine_times_angle = sine * dx->angle;
    const real d_y = dx->length * cosine - x->length * sine_times_angle;
    const real y_2 = x->length * cosine;
    const real d_sine = cosine * dx->angle;
    const real sum_2 = dx->length * sine + x->length * d_sine;
    const real length_times_sine = x->length * sine;
    const real d_turn = dx->length * x->angle_rate + x->length * dx->angle_rate;
    const real turn = x->length * x->angle_rate;
    const real d_vx = -(dx->length_rate * sine + x->length_rate * d_sine) - (d_turn * cosine
        - turn * sine_times_angle);
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real d_vy = dx->length_rate * cosine - x->length_rate * sine_times_angle - (d_turn * sine
        + turn * d_sine);
    const real vy = x->length_rate * cosine - turn * sine;
    const real sum_3 = y_2 * sin_of_slope - length_times_sine * cos_of_slope;
    const real sum_4 = y_2 * cos_of_slope + length_times_sine * sin_of_slope;
    y->foot_x = d_along;
    y->foot_vx = dx->seen_vx * cos_of_slope - x->seen_vx * sin_of_slope_times_slope
        + (dx->seen_vy * sin_of_slope + x->seen_vy * cos_of_slope_times_slope);
    y->x_ = d_y * sin_of_slope + y_2 * cos_of_slope_times_slope - (sum_2 * cos_of_slope
        - length_times_sine * sin_of_slope_times_slope);
    y->y_ = d_y * cos_of_slope - y_2 * sin_of_slope_times_slope + (sum_2 * sin_of_slope
        + length_times_sine * cos_of_slope_times_slope);
    y->vx = d_vx * cos_of_slope - vx * sin_of_slope_times_slope + (d_vy * sin_of_slope
        + vy * cos_of_slope_times_slope);
    y->vy = d_vy * cos_of_slope - vy * sin_of_slope_times_slope - (d_vx * sin_of_slope
        + vx * cos_of_slope_times_slope);
    y->winding = dx->angle - (sum_3 * (d_y * cos_of_slope - y_2 * sin_of_slope_times_slope
        + (sum_2 * sin_of_slope + length_times_sine * cos_of_slope_times_slope))
        - sum_4 * (d_y * sin_of_slope + y_2 * cos_of_slope_times_slope - (sum_2 * cos_of_slope
        - length_times_sine * sin_of_slope_times_slope))) / (sum_3 * sum_3 + sum_4 * sum_4);
}

/* to world, in slip. */
static void to_world_slip_constant(const real *parameters, const real *states, real *after) {
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    (void)parameters;
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real sine = real_sin(x->slope);
    const real y_2 = x->foot_x * sine;
    const real vx = x->foot_vx * cosine;
    const real vy = x->foot_vx * sine;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    y->seen_x = x_2;
    y->seen_y = x->height + y_2;
    y->seen_vx = vx;
    y->seen_vy = vy;
    y->length = length;
    y->angle = angle;
    y->length_rate = length_rate;
    y->angle_rate = angle_rate;
}

/* First variation of to_world_slip_constant. */
static void vary_to_world_slip_constant(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *after) {
    const runner_states *x = (const void *)states;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    (void)parameters, (void)d_parameters;
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_x = dx->foot_x * cosine - x->foot_x * sine_times_slope;
    const real d_sine = cosine * dx->slope;
    const real d_y = dx->foot_x * sine + x->foot_x * d_sine;
    const real d_vx = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
    const real d_vy = dx->foot_vx * sine + x->foot_vx * d_sine;
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real d_length = 0.5 * d_square / length;
    const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
    y->seen_x = d_x;
    y->seen_y = dx->height + d_y;
    y->seen_vx = d_vx;
    y->seen_vy = d_vy;
    y->length = d_length;
    y->angle = d_angle;
    y->length_rate = d_length_rate;
    y->angle_rate = d_angle_rate;
}

/* Rates of the world's states in slip. */
static void world_rates_slip_constant(const real *parameters, const real *states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real cosine = real_cos(x->slope);
    const real vx = x->foot_vx * cosine;
    const real sine = real_sin(x->slope);
    const real vy = x->foot_vx * sine;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real x__times_vx = x->x_ * x->vx;
    const real y__times_vy = x->y_ * x->vy;
    const real length_rate = (x__times_vx + y__times_vy) / length;
    const real spring = p->stiffness * (rest_length - length) - p->damping * length_rate;
    const real axial = spring / length;
    const real stance_torque = x->external_torque - (p->drive_torque + p->more_torque) * x->driving;
    const real turning = stance_torque / square;
    const real along = axial * x->x_ - turning * x->y_;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real own = select(x->way > 0.0, x->friction_ahead, x->friction_behind);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real friction_along = is_own * own + (1.0 - is_own) * x->friction;
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + foot_mass_times_gravity * cosine;
    const real friction_force = x->way * friction_along * normal;
    const real acceleration = (-(along + foot_mass_times_gravity * sine) - friction_force) / p->foot_mass;
    const real sum_2 = 2.0 * x__times_vx + 2.0 * y__times_vy;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real sum_minus_acceleration = (along + (x->external_fx * cosine
        + x->external_fy * sine)) / p->body_mass - p->gravity * sine - acceleration;
    const real sum_3 = (off + (x->external_fy * cosine - x->external_fx * sine)) / p->body_mass
        - p->gravity * cosine;
    y->seen_x = vx;
    y->seen_y = vy;
    y->seen_vx = acceleration * cosine;
    y->seen_vy = acceleration * sine;
    y->length = 0.5 * sum_2 / length;
    y->angle = angle_rate;
    y->length_rate = (x->vx * x->vx + x->x_ * sum_minus_acceleration + (x->vy * x->vy + x->y_ * sum_3)
        - length_rate * (0.5 * sum_2 / length)) / length;
    y->angle_rate = (x->vx * x->vy + x->x_ * sum_3 - (x->vy * x->vx + x->y_ * sum_minus_acceleration)
        - angle_rate * sum_2) / square;
}

/* First variation of world_rates_slip_constant. */
static void vary_world_rates_slip_constant(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_vx = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
    const real d_sine = cosine * dx->slope;
    const real d_vy = dx->foot_vx * sine + x->foot_vx * d_sine;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real rest_length_minus_length = rest_length - length;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real x__times_vx = x->x_ * x->vx;
    const real y__times_vy = x->y_ * x->vy;
    const real length_rate = (x__times_vx + y__times_vy) / length;
    const real x__times_vx_plus_x__times_vx = dx->x_ * x->vx + x->x_ * dx->vx;
    const real y__times_vy_plus_y__times_vy = dx->y_ * x->vy + x->y_ * dx->vy;
    const real d_length_rate = (x__times_vx_plus_x__times_vx + y__times_vy_plus_y__times_vy
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * rest_length_minus_length + p->stiffness * (d_rest_length
        - d_length) - (dp->damping * length_rate + p->damping * d_length_rate);
    const real spring = p->stiffness * rest_length_minus_length - p->damping * length_rate;
    const real axial = spring / length;
    const real d_axial = (d_spring - axial * d_length) / length;
    const real drive_torque_plus_more_torque = p->drive_torque + p->more_torque;
    const real d_stance_torque = dx->external_torque - ((dp->drive_torque + dp->more_torque) * x->driving
        + drive_torque_plus_more_torque * dx->driving);
    const real stance_torque = x->external_torque - drive_torque_plus_more_torque * x->driving;
    const real turning = stance_torque / square;
    const real d_turning = (d_stance_torque - turning * d_square) / square;
    const real d_along = d_axial * x->x_ + axial * dx->x_ - (d_turning * x->y_ + turning * dx->y_);
    const real sum_2 = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real own = select(x->way > 0.0, x->friction_ahead, x->friction_behind);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real by_1_minus_is_own = 1.0 - is_own;
    const real friction_along = is_own * own + by_1_minus_is_own * x->friction;
    const real d_own = select(x->way > 0.0, dx->friction_ahead, dx->friction_behind);
    const real d_friction_along = is_own * d_own + by_1_minus_is_own * dx->friction;
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + foot_mass_times_gravity * cosine;
    const real way_times_friction_along = x->way * friction_along;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real d_normal = d_off + (sum_2 * cosine - foot_mass_times_gravity * sine_times_slope);
    const real d_friction_force = (dx->way * friction_along + x->way * d_friction_along) * normal
        + way_times_friction_along * d_normal;
    const real along = axial * x->x_ - turning * x->y_;
    const real friction_force = way_times_friction_along * normal;
    const real acceleration = (-(along + foot_mass_times_gravity * sine) - friction_force) / p->foot_mass;
    const real d_acceleration = (-(d_along + (sum_2 * sine + foot_mass_times_gravity * d_sine))
        - d_friction_force - acceleration * dp->foot_mass) / p->foot_mass;
    const real sum_3 = 2.0 * x__times_vx_plus_x__times_vx + 2.0 * y__times_vy_plus_y__times_vy;
    const real sum_4 = 2.0 * x__times_vx + 2.0 * y__times_vy;
    const real by_0_5_times_sum_over_length = 0.5 * sum_4 / length;
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
    const real along_plus_sum_over_body_mass = (along + (x->external_fx * cosine
        + x->external_fy * sine)) / p->body_mass;
    const real sum_minus_acceleration = along_plus_sum_over_body_mass - p->gravity * sine - acceleration;
    const real ratio_minus_sum_minus_d_acceleration = (d_along + (dx->external_fx * cosine
        - x->external_fx * sine_times_slope + (dx->external_fy * sine + x->external_fy * d_sine))
        - along_plus_sum_over_body_mass * dp->body_mass) / p->body_mass - (dp->gravity * sine
        + p->gravity * d_sine) - d_acceleration;
    const real off_plus_sum_over_body_mass = (off + (x->external_fy * cosine
        - x->external_fx * sine)) / p->body_mass;
    const real sum_5 = off_plus_sum_over_body_mass - p->gravity * cosine;
    const real ratio_minus_sum = (d_off + (dx->external_fy * cosine - x->external_fy * sine_times_slope
        - (dx->external_fx * sine + x->external_fx * d_sine))
        - off_plus_sum_over_body_mass * dp->body_mass) / p->body_mass - (dp->gravity * cosine
        - p->gravity * sine_times_slope);
    y->seen_x = d_vx;
    y->seen_y = d_vy;
    y->seen_vx = d_acceleration * cosine - acceleration * sine_times_slope;
    y->seen_vy = d_acceleration * sine + acceleration * d_sine;
    y->length = (0.5 * sum_3 - by_0_5_times_sum_over_length * d_length) / length;
    y->angle = d_angle_rate;
    y->length_rate = (2.0 * (x->vx * dx->vx) + (dx->x_ * sum_minus_acceleration
        + x->x_ * ratio_minus_sum_minus_d_acceleration) + (2.0 * (x->vy * dx->vy) + (dx->y_ * sum_5
        + x->y_ * ratio_minus_sum)) - (d_length_rate * by_0_5_times_sum_over_length
        + length_rate * ((0.5 * sum_3 - by_0_5_times_sum_over_length * d_length) / length)) - (x->vx * x->vx
        + x->x_ * sum_minus_acceleration + (x->vy * x->vy + x->y_ * sum_5)
        - length_rate * by_0_5_times_sum_over_length) / length * d_length) / length;
    y->angle_rate = (dx->vx * x->vy + x->vx * dx->vy + (dx->x_ * sum_5 + x->x_ * ratio_minus_sum)
        - (dx->vy * x->vx + x->vy * dx->vx + (dx->y_ * sum_minus_acceleration
        + x->y_ * ratio_minus_sum_minus_d_acceleration)) - (d_angle_rate * sum_4 + angle_rate * sum_3)
        - (x->vx * x->vy + x->x_ * sum_5 - (x->vy * x->vx + x->y_ * sum_minus_acceleration)
        - angle_rate * sum_4) / square * d_square) / square;
}

/* Constants of stick. */
static void open_stick(const real *parameters, const real *states, real *constants) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    stick_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real longer = p->thrust + p->more_thrust;
    const real thrusting_times_longer_or_by_0 = x->thrusting * select(longer >= 0.0, longer, 0.0);
    const real product_2 = x->driving * (p->drive_torque + p->more_torque);
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real gravity_times_sine = p->gravity * sine;
    const real gravity_times_cosine = p->gravity * cosine;
    const real stiffness_times_extension_rate = p->stiffness * x->extension_rate;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real foot_mass_times_gravity_times_cosine = foot_mass_times_gravity * cosine;
    const real is_own = select(x->friction_ahead < 0.0, 0.0, 1.0);
    const real is_own_times_friction_ahead = is_own * x->friction_ahead;
    const real by_1_minus_is_own = 1.0 - is_own;
    const real foot_mass_times_gravity_times_sine = foot_mass_times_gravity * sine;
    const real by_0_or_by_1 = select(x->friction_behind < 0.0, 0.0, 1.0);
    const real by_0_or_by_1_times_friction_behind = by_0_or_by_1 * x->friction_behind;
    const real by_1_minus_by_0_or_by_1 = 1.0 - by_0_or_by_1;
    c->inverse_body_mass = inverse_body_mass;
    c->stiffness = p->stiffness;
    c->free_length = p->free_length;
    c->thrusting_times_longer_or_by_0 = thrusting_times_longer_or_by_0;
    c->damping = p->damping;
    c->product_2 = product_2;
    c->cosine = cosine;
    c->sine = sine;
    c->gravity_times_sine = gravity_times_sine;
    c->gravity_times_cosine = gravity_times_cosine;
    c->extension_rate = x->extension_rate;
    c->stiffness_times_extension_rate = stiffness_times_extension_rate;
    c->foot_vx = x->foot_vx;
    c->external_fx_rate = x->external_fx_rate;
    c->external_fy_rate = x->external_fy_rate;
    c->friction_rate = x->friction_rate;
    c->external_torque_rate = x->external_torque_rate;
    c->least_length = p->least_length;
    c->winding = x->winding;
    c->foot_mass_times_gravity_times_cosine = foot_mass_times_gravity_times_cosine;
    c->static_ratio = p->static_ratio;
    c->is_own_times_friction_ahead = is_own_times_friction_ahead;
    c->by_1_minus_is_own = by_1_minus_is_own;
    c->foot_mass_times_gravity_times_sine = foot_mass_times_gravity_times_sine;
    c->by_0_or_by_1_times_friction_behind = by_0_or_by_1_times_friction_behind;
    c->by_1_minus_by_0_or_by_1 = by_1_minus_by_0_or_by_1;
}

/* First variation of open_stick. */
static void vary_open_stick(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    stick_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real d_inverse_body_mass = -(inverse_body_mass * dp->body_mass / p->body_mass);
    const real longer = p->thrust + p->more_thrust;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_thrusting_times_longer_or_by_0 = select(longer >= 0.0, longer, 0.0) * dx->thrusting
        + x->thrusting * select(longer >= 0.0, d_longer, 0.0);
    const real d_product_2 = (p->drive_torque + p->more_torque) * dx->driving
        + x->driving * (dp->drive_torque + dp->more_torque);
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_cosine = -sine_times_slope;
    const real cosine = real_cos(x->slope);
    const real d_sine = cosine * dx->slope;
    const real d_gravity_times_sine = sine * dp->gravity + p->gravity * d_sine;
    const real d_gravity_times_cosine = cosine * dp->gravity - p->gravity * sine_times_slope;
    const real d_stiffness_times_extension_rate = x->extension_rate * dp->stiffness
        + p->stiffness * dx->extension_rate;
    const real sum_2 = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real d_foot_mass_times_gravity_times_cosine = cosine * sum_2
        - foot_mass_times_gravity * sine_times_slope;
    const real is_own = select(x->friction_ahead < 0.0, 0.0, 1.0);
    const real d_is_own_times_friction_ahead = is_own * dx->friction_ahead;
    const real d_foot_mass_times_gravity_times_sine = sine * sum_2 + foot_mass_times_gravity * d_sine;
    const real d_by_0_or_by_1_times_friction_behind = select(x->friction_behind < 0.0, 0.0,
        1.0) * dx->friction_behind;
    c->inverse_body_mass = d_inverse_body_mass;
    c->stiffness = dp->stiffness;
    c->free_length = dp->free_length;
    c->thrusting_times_longer_or_by_0 = d_thrusting_times_longer_or_by_0;
    c->damping = dp->damping;
    c->product_2 = d_product_2;
    c->cosine = d_cosine;
    c->sine = d_sine;
    c->gravity_times_sine = d_gravity_times_sine;
    c->gravity_times_cosine = d_gravity_times_cosine;
    c->extension_rate = dx->extension_rate;
    c->stiffness_times_extension_rate = d_stiffness_times_extension_rate;
    c->foot_vx = dx->foot_vx;
    c->external_fx_rate = dx->external_fx_rate;
    c->external_fy_rate = dx->external_fy_rate;
    c->friction_rate = dx->friction_rate;
    c->external_torque_rate = dx->external_torque_rate;
    c->least_length = dp->least_length;
    c->winding = dx->winding;
    c->foot_mass_times_gravity_times_cosine = d_foot_mass_times_gravity_times_cosine;
    c->static_ratio = dp->static_ratio;
    c->is_own_times_friction_ahead = d_is_own_times_friction_ahead;
    c->by_1_minus_is_own = 0.0;
    c->foot_mass_times_gravity_times_sine = d_foot_mass_times_gravity_times_sine;
    c->by_0_or_by_1_times_friction_behind = d_by_0_or_by_1_times_friction_behind;
    c->by_1_minus_by_0_or_by_1 = 0.0;
}

/* ramp_ends: A ramp of the friction coefficient ends at 0. */
static int react_stick_ramp_ends(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->friction = 0.0;
    y->friction_rate = 0.0;
    return next[0]; /* stick */
}

/* greatest_compression: Thrust begins where the leg is shortest, once per stance. A thrust of 0 is not
 * counted. */
static int react_stick_greatest_compression(const real *parameters, const real *states,
    const tdmf_table *tables, real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    (void)tables;
    const real longer = p->thrust + p->more_thrust;
    const real by_1_or_by_0 = select(longer > 0.0, 1.0, 0.0);
    const real is_new = select(x->time > x->last_event, by_1_or_by_0, 0.0);
    const real free_length_plus_extension = p->free_length + x->extension;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = free_length_plus_extension + longer_or_by_0;
    const real sum_2 = free_length_plus_extension + longer_or_by_0 * x->thrusting;
    const real jump = rest_length - sum_2;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real middle = sum_2 + 0.5 * jump - length;
    const real work = p->stiffness * jump * middle;
    const real begins = select(x->thrusting < 1.0, select(work >= 0.0, work, 0.0), 0.0);
    y->events = x->events + is_new;
    y->last_event = select(by_1_or_by_0 > 0.0, x->time, x->last_event);
    y->thrusting = 1.0;
    y->leg_work = x->leg_work + work;
    y->positive_leg_work = x->positive_leg_work + select(work > 0.0, work, begins);
    return next[0]; /* stick */
}

/* mid_stance: Drive ends where the leg is upright, once per stance. */
static int react_stick_mid_stance(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->driving = 0.0;
    return next[0]; /* stick */
}

/* slips_forward: The push of the leg exceeds static friction, and the foot slips forward. */
static int react_stick_slips_forward(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real ends = select(x->segment_end < 1000000000000.0, 1.0, 0.0);
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real x_plus_by_1eminus_12_times_free_length = x_2 + 1e-12 * p->free_length;
    const real begins = select(x->segment_begin > -1000000000000.0, 1.0, 0.0);
    const real segment_towards = x->segment
        + ends * select(x_plus_by_1eminus_12_times_free_length > x->segment_end, 1.0, 0.0)
        - begins * select(x_plus_by_1eminus_12_times_free_length < x->segment_begin, 1.0, 0.0);
    const real end = select(p->patch_end > p->patch_begin, p->patch_end, 1000000000000.0);
    const real begin = select(p->patch_end > p->patch_begin, p->patch_begin, 1000000000000.0);
    const real friction = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        segment_towards, select(real_abs(segment_towards - 1.0) > 0.0, -1.0, p->patch_friction));
    y->segment = segment_towards;
    y->segment_begin = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, segment_towards,
        select(segment_towards > 0.0, select(segment_towards > 1.0, end, begin), -1000000000000.0));
    y->segment_end = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, segment_towards,
        select(segment_towards > 0.0, select(segment_towards > 1.0, 1000000000000.0, end), begin));
    y->segment_height = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height, segment_towards,
        0.0);
    y->segment_slope = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, segment_towards,
        0.0);
    y->friction_ahead = select(p->keeps_friction > 0.0, x->friction_ahead, friction);
    y->friction_behind = select(p->keeps_friction > 0.0, x->friction_behind, friction);
    y->way = 1.0;
    return next[0]; /* slip */
}

/* First variation of slips_forward. */
static void vary_react_stick_slips_forward(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real ends = select(x->segment_end < 1000000000000.0, 1.0, 0.0);
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real x_plus_by_1eminus_12_times_free_length = x_2 + 1e-12 * p->free_length;
    const real begins = select(x->segment_begin > -1000000000000.0, 1.0, 0.0);
    const real segment_towards = x->segment
        + ends * select(x_plus_by_1eminus_12_times_free_length > x->segment_end, 1.0, 0.0)
        - begins * select(x_plus_by_1eminus_12_times_free_length < x->segment_begin, 1.0, 0.0);
    const real d_end = select(p->patch_end > p->patch_begin, dp->patch_end, 0.0);
    const real d_begin = select(p->patch_end > p->patch_begin, dp->patch_begin, 0.0);
    const real d_friction = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        seed, segment_towards, select(real_abs(segment_towards - 1.0) > 0.0, 0.0, dp->patch_friction));
    y->segment = dx->segment;
    y->segment_begin = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, seed,
        segment_towards, select(segment_towards > 0.0, select(segment_towards > 1.0, d_end, d_begin), 0.0));
    y->segment_end = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, seed,
        segment_towards, select(segment_towards > 0.0, select(segment_towards > 1.0, 0.0, d_end), d_begin));
    y->segment_height = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height, seed,
        segment_towards, 0.0);
    y->segment_slope = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, seed,
        segment_towards, 0.0);
    y->friction_ahead = select(p->keeps_friction > 0.0, dx->friction_ahead, d_friction);
    y->friction_behind = select(p->keeps_friction > 0.0, dx->friction_behind, d_friction);
    y->way = 0.0;
}

/* First variation of the guard of slips_forward. */
static real vary_guard_stick_slips_forward(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real is_own = select(x->friction_ahead < 0.0, 0.0, 1.0);
    const real by_1_minus_is_own = 1.0 - is_own;
    const real friction_along = is_own * x->friction_ahead + by_1_minus_is_own * x->friction;
    const real d_friction_along = is_own * dx->friction_ahead + by_1_minus_is_own * dx->friction;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real rest_length_minus_length = rest_length - length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real spring = p->stiffness * rest_length_minus_length - p->damping * length_rate;
    const real axial = spring / length;
    const real drive_torque_plus_more_torque = p->drive_torque + p->more_torque;
    const real stance_torque = x->external_torque - drive_torque_plus_more_torque * x->driving;
    const real turning = stance_torque / square;
    const real off = axial * x->y_ + turning * x->x_;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real cosine = real_cos(x->slope);
    const real normal = off + foot_mass_times_gravity * cosine;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * rest_length_minus_length + p->stiffness * (d_rest_length
        - d_length) - (dp->damping * length_rate + p->damping * d_length_rate);
    const real d_axial = (d_spring - axial * d_length) / length;
    const real d_stance_torque = dx->external_torque - ((dp->drive_torque + dp->more_torque) * x->driving
        + drive_torque_plus_more_torque * dx->driving);
    const real d_turning = (d_stance_torque - turning * d_square) / square;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real sum_2 = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real sine = real_sin(x->slope);
    const real d_normal = d_off + (sum_2 * cosine - foot_mass_times_gravity * (sine * dx->slope));
    const real d_cone = (dp->static_ratio * friction_along + p->static_ratio * d_friction_along) * normal
        + p->static_ratio * friction_along * d_normal;
    const real d_along = d_axial * x->x_ + axial * dx->x_ - (d_turning * x->y_ + turning * dx->y_);
    const real d_sine = cosine * dx->slope;
    return d_cone + (d_along + (sum_2 * sine + foot_mass_times_gravity * d_sine));
}

/* slips_backward: The push of the leg exceeds static friction, and the foot slips backward. */
static int react_stick_slips_backward(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real ends = select(x->segment_end < 1000000000000.0, 1.0, 0.0);
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real x_minus_by_1eminus_12_times_free_length = x_2 - 1e-12 * p->free_length;
    const real begins = select(x->segment_begin > -1000000000000.0, 1.0, 0.0);
    const real segment_towards = x->segment
        + ends * select(x_minus_by_1eminus_12_times_free_length > x->segment_end, 1.0, 0.0)
        - begins * select(x_minus_by_1eminus_12_times_free_length < x->segment_begin, 1.0, 0.0);
    const real end = select(p->patch_end > p->patch_begin, p->patch_end, 1000000000000.0);
    const real begin = select(p->patch_end > p->patch_begin, p->patch_begin, 1000000000000.0);
    const real friction = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        segment_towards, select(real_abs(segment_towards - 1.0) > 0.0, -1.0, p->patch_friction));
    y->segment = segment_towards;
    y->segment_begin = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, segment_towards,
        select(segment_towards > 0.0, select(segment_towards > 1.0, end, begin), -1000000000000.0));
    y->segment_end = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, segment_towards,
        select(segment_towards > 0.0, select(segment_towards > 1.0, 1000000000000.0, end), begin));
    y->segment_height = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height, segment_towards,
        0.0);
    y->segment_slope = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, segment_towards,
        0.0);
    y->friction_ahead = select(p->keeps_friction > 0.0, x->friction_ahead, friction);
    y->friction_behind = select(p->keeps_friction > 0.0, x->friction_behind, friction);
    y->way = -1.0;
    return next[0]; /* slip */
}

/* First variation of slips_backward. */
static void vary_react_stick_slips_backward(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real ends = select(x->segment_end < 1000000000000.0, 1.0, 0.0);
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real x_minus_by_1eminus_12_times_free_length = x_2 - 1e-12 * p->free_length;
    const real begins = select(x->segment_begin > -1000000000000.0, 1.0, 0.0);
    const real segment_towards = x->segment
        + ends * select(x_minus_by_1eminus_12_times_free_length > x->segment_end, 1.0, 0.0)
        - begins * select(x_minus_by_1eminus_12_times_free_length < x->segment_begin, 1.0, 0.0);
    const real d_end = select(p->patch_end > p->patch_begin, dp->patch_end, 0.0);
    const real d_begin = select(p->patch_end > p->patch_begin, dp->patch_begin, 0.0);
    const real d_friction = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        seed, segment_towards, select(real_abs(segment_towards - 1.0) > 0.0, 0.0, dp->patch_friction));
    y->segment = dx->segment;
    y->segment_begin = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, seed,
        segment_towards, select(segment_towards > 0.0, select(segment_towards > 1.0, d_end, d_begin), 0.0));
    y->segment_end = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, seed,
        segment_towards, select(segment_towards > 0.0, select(segment_towards > 1.0, 0.0, d_end), d_begin));
    y->segment_height = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height, seed,
        segment_towards, 0.0);
    y->segment_slope = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, seed,
        segment_towards, 0.0);
    y->friction_ahead = select(p->keeps_friction > 0.0, dx->friction_ahead, d_friction);
    y->friction_behind = select(p->keeps_friction > 0.0, dx->friction_behind, d_friction);
    y->way = 0.0;
}

/* First variation of the guard of slips_backward. */
static real vary_guard_stick_slips_backward(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real is_own = select(x->friction_behind < 0.0, 0.0, 1.0);
    const real by_1_minus_is_own = 1.0 - is_own;
    const real friction_along = is_own * x->friction_behind + by_1_minus_is_own * x->friction;
    const real d_friction_along = is_own * dx->friction_behind + by_1_minus_is_own * dx->friction;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real rest_length_minus_length = rest_length - length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real spring = p->stiffness * rest_length_minus_length - p->damping * length_rate;
    const real axial = spring / length;
    const real drive_torque_plus_more_torque = p->drive_torque + p->more_torque;
    const real stance_torque = x->external_torque - drive_torque_plus_more_torque * x->driving;
    const real turning = stance_torque / square;
    const real off = axial * x->y_ + turning * x->x_;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real cosine = real_cos(x->slope);
    const real normal = off + foot_mass_times_gravity * cosine;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * rest_length_minus_length + p->stiffness * (d_rest_length
        - d_length) - (dp->damping * length_rate + p->damping * d_length_rate);
    const real d_axial = (d_spring - axial * d_length) / length;
    const real d_stance_torque = dx->external_torque - ((dp->drive_torque + dp->more_torque) * x->driving
        + drive_torque_plus_more_torque * dx->driving);
    const real d_turning = (d_stance_torque - turning * d_square) / square;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real sum_2 = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real sine = real_sin(x->slope);
    const real d_normal = d_off + (sum_2 * cosine - foot_mass_times_gravity * (sine * dx->slope));
    const real d_cone = (dp->static_ratio * friction_along + p->static_ratio * d_friction_along) * normal
        + p->static_ratio * friction_along * d_normal;
    const real d_along = d_axial * x->x_ + axial * dx->x_ - (d_turning * x->y_ + turning * dx->y_);
    const real d_sine = cosine * dx->slope;
    return d_cone - (d_along + (sum_2 * sine + foot_mass_times_gravity * d_sine));
}

/* Outputs in stick. */
static void outputs_stick(const real *parameters, const real *states, real *outputs) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const real set_height = p->ground_height + x->segment_height;
    const real set_slope = p->ground_slope + x->segment_slope;
    const real pending = select(real_abs(set_height - x->height) + real_abs(p->free_length * (set_slope
        - x->slope)) > 0.0, 1.0, 0.0);
    const real stance_torque = x->external_torque - (p->drive_torque + p->more_torque) * x->driving;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real shorter = rest_length - length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real spring = p->stiffness * shorter - p->damping * length_rate;
    const real axial = spring / length;
    const real turning = stance_torque / square;
    const real off = axial * x->y_ + turning * x->x_;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real cosine = real_cos(x->slope);
    const real normal = off + foot_mass_times_gravity * cosine;
    const real along = axial * x->x_ - turning * x->y_;
    const real sine = real_sin(x->slope);
    const real tangential_force = along + foot_mass_times_gravity * sine;
    const real x_2 = tangential_force * cosine - normal * sine;
    const real y_2 = tangential_force * sine + normal * cosine;
    const real foot_x_times_cosine = x->foot_x * cosine;
    const real x__times_cosine_minus_y__times_sine = x->x_ * cosine - x->y_ * sine;
    const real body_x = foot_x_times_cosine + x__times_cosine_minus_y__times_sine;
    const real height_plus_foot_x_times_sine = x->height + x->foot_x * sine;
    const real x__times_sine_plus_y__times_cosine = x->x_ * sine + x->y_ * cosine;
    const real body_y = height_plus_foot_x_times_sine + x__times_sine_plus_y__times_cosine;
    const real foot_vx_times_cosine = x->foot_vx * cosine;
    const real vx = x->vx * cosine - x->vy * sine;
    const real body_vx = foot_vx_times_cosine + vx;
    const real foot_vx_times_sine = x->foot_vx * sine;
    const real vy = x->vx * sine + x->vy * cosine;
    const real body_vy = foot_vx_times_sine + vy;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real center_x = foot_x_times_cosine + share * x__times_cosine_minus_y__times_sine;
    const real center_y = height_plus_foot_x_times_sine + share * x__times_sine_plus_y__times_cosine;
    const real center_vx = foot_vx_times_cosine + share * vx;
    const real center_vy = foot_vx_times_sine + share * vy;
    const real of_body = p->body_mass * (body_vx * body_vx + body_vy * body_vy);
    const real kinetic_energy = 0.5 * (of_body + p->foot_mass * (foot_vx_times_cosine * foot_vx_times_cosine
        + foot_vx_times_sine * foot_vx_times_sine));
    const real potential_energy = p->gravity * (p->body_mass * body_y
        + p->foot_mass * height_plus_foot_x_times_sine);
    const real elastic_energy = 0.5 * (p->stiffness * (shorter * shorter));
    const real energy = kinetic_energy + potential_energy + elastic_energy;
    const real phase_of_hip = select(x->driving > 0.0, 1.0, 2.0);
    outputs[OUTPUT_pending] = pending;
    outputs[OUTPUT_torque] = stance_torque;
    outputs[OUTPUT_normal_force] = normal;
    outputs[OUTPUT_tangential_force] = tangential_force;
    outputs[OUTPUT_ground_force_x] = x_2;
    outputs[OUTPUT_ground_force_y] = y_2;
    outputs[OUTPUT_force_of_leg] = spring;
    outputs[OUTPUT_body_x] = body_x;
    outputs[OUTPUT_body_y] = body_y;
    outputs[OUTPUT_body_vx] = body_vx;
    outputs[OUTPUT_body_vy] = body_vy;
    outputs[OUTPUT_center_x] = center_x;
    outputs[OUTPUT_center_y] = center_y;
    outputs[OUTPUT_center_vx] = center_vx;
    outputs[OUTPUT_center_vy] = center_vy;
    outputs[OUTPUT_kinetic_energy] = kinetic_energy;
    outputs[OUTPUT_potential_energy] = potential_energy;
    outputs[OUTPUT_elastic_energy] = elastic_energy;
    outputs[OUTPUT_energy] = energy;
    outputs[OUTPUT_kind_of_contact] = 2.0;
    outputs[OUTPUT_phase_of_hip] = phase_of_hip;
}

/* First variation of outputs_stick. */
static void vary_outputs_stick(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *outputs) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real drive_torque_plus_more_torque = p->drive_torque + p->more_torque;
    const real d_stance_torque = dx->external_torque - ((dp->drive_torque + dp->more_torque) * x->driving
        + drive_torque_plus_more_torque * dx->driving);
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real shorter = rest_length - length;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real d_shorter = d_rest_length - d_length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * shorter + p->stiffness * d_shorter - (dp->damping * length_rate
        + p->damping * d_length_rate);
    const real spring = p->stiffness * shorter - p->damping * length_rate;
    const real axial = spring / length;
    const real d_axial = (d_spring - axial * d_length) / length;
    const real stance_torque = x->external_torque - drive_torque_plus_more_torque * x->driving;
    const real turning = stance_torque / square;
    const real d_turning = (d_stance_torque - turning * d_square) / square;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real sum_2 = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real cosine = real_cos(x->slope);
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_normal = d_off + (sum_2 * cosine - foot_mass_times_gravity * sine_times_slope);
    const real d_along = d_axial * x->x_ + axial * dx->x_ - (d_turning * x->y_ + turning * dx->y_);
    const real d_sine = cosine * dx->slope;
    const real d_tangential_force = d_along + (sum_2 * sine + foot_mass_times_gravity * d_sine);
    const real along = axial * x->x_ - turning * x->y_;
    const real tangential_force = along + foot_mass_times_gravity * sine;
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + foot_mass_times_gravity * cosine;
    const real d_x = d_tangential_force * cosine - tangential_force * sine_times_slope - (d_normal * sine
        + normal * d_sine);
    const real d_y = d_tangential_force * sine + tangential_force * d_sine + (d_normal * cosine
        - normal * sine_times_slope);
    const real sum_3 = dx->foot_x * cosine - x->foot_x * sine_times_slope;
    const real sum_4 = dx->x_ * cosine - x->x_ * sine_times_slope - (dx->y_ * sine + x->y_ * d_sine);
    const real d_body_x = sum_3 + sum_4;
    const real height_plus_sum = dx->height + (dx->foot_x * sine + x->foot_x * d_sine);
    const real sum_5 = dx->x_ * sine + x->x_ * d_sine + (dx->y_ * cosine - x->y_ * sine_times_slope);
    const real d_body_y = height_plus_sum + sum_5;
    const real sum_6 = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
    const real d_vx = dx->vx * cosine - x->vx * sine_times_slope - (dx->vy * sine + x->vy * d_sine);
    const real d_body_vx = sum_6 + d_vx;
    const real sum_7 = dx->foot_vx * sine + x->foot_vx * d_sine;
    const real d_vy = dx->vx * sine + x->vx * d_sine + (dx->vy * cosine - x->vy * sine_times_slope);
    const real d_body_vy = sum_7 + d_vy;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_center_x = sum_3 + (d_share * (x->x_ * cosine - x->y_ * sine) + share * sum_4);
    const real x__times_sine_plus_y__times_cosine = x->x_ * sine + x->y_ * cosine;
    const real d_center_y = height_plus_sum + (d_share * x__times_sine_plus_y__times_cosine + share * sum_5);
    const real vx = x->vx * cosine - x->vy * sine;
    const real d_center_vx = sum_6 + (d_share * vx + share * d_vx);
    const real vy = x->vx * sine + x->vy * cosine;
    const real d_center_vy = sum_7 + (d_share * vy + share * d_vy);
    const real foot_vx_times_cosine = x->foot_vx * cosine;
    const real body_vx = foot_vx_times_cosine + vx;
    const real foot_vx_times_sine = x->foot_vx * sine;
    const real body_vy = foot_vx_times_sine + vy;
    const real d_of_body = dp->body_mass * (body_vx * body_vx + body_vy * body_vy)
        + p->body_mass * (2.0 * (body_vx * d_body_vx) + 2.0 * (body_vy * d_body_vy));
    const real d_kinetic_energy = 0.5 * (d_of_body
        + (dp->foot_mass * (foot_vx_times_cosine * foot_vx_times_cosine
        + foot_vx_times_sine * foot_vx_times_sine) + p->foot_mass * (2.0 * (foot_vx_times_cosine * sum_6)
        + 2.0 * (foot_vx_times_sine * sum_7))));
    const real height_plus_foot_x_times_sine = x->height + x->foot_x * sine;
    const real body_y = height_plus_foot_x_times_sine + x__times_sine_plus_y__times_cosine;
    const real d_potential_energy = dp->gravity * (p->body_mass * body_y
        + p->foot_mass * height_plus_foot_x_times_sine) + p->gravity * (dp->body_mass * body_y
        + p->body_mass * d_body_y + (dp->foot_mass * height_plus_foot_x_times_sine
        + p->foot_mass * height_plus_sum));
    const real d_elastic_energy = 0.5 * (dp->stiffness * (shorter * shorter)
        + p->stiffness * (2.0 * (shorter * d_shorter)));
    const real d_energy = d_kinetic_energy + d_potential_energy + d_elastic_energy;
    outputs[OUTPUT_pending] = 0.0;
    outputs[OUTPUT_torque] = d_stance_torque;
    outputs[OUTPUT_normal_force] = d_normal;
    outputs[OUTPUT_tangential_force] = d_tangential_force;
    outputs[OUTPUT_ground_force_x] = d_x;
    outputs[OUTPUT_ground_force_y] = d_y;
    outputs[OUTPUT_force_of_leg] = d_spring;
    outputs[OUTPUT_body_x] = d_body_x;
    outputs[OUTPUT_body_y] = d_body_y;
    outputs[OUTPUT_body_vx] = d_body_vx;
    outputs[OUTPUT_body_vy] = d_body_vy;
    outputs[OUTPUT_center_x] = d_center_x;
    outputs[OUTPUT_center_y] = d_center_y;
    outputs[OUTPUT_center_vx] = d_center_vx;
    outputs[OUTPUT_center_vy] = d_center_vy;
    outputs[OUTPUT_kinetic_energy] = d_kinetic_energy;
    outputs[OUTPUT_potential_energy] = d_potential_energy;
    outputs[OUTPUT_elastic_energy] = d_elastic_energy;
    outputs[OUTPUT_energy] = d_energy;
    outputs[OUTPUT_kind_of_contact] = 0.0;
    outputs[OUTPUT_phase_of_hip] = 0.0;
}

/* Count the event. A contact mode that lasted adds a letter to the gait word, a new stance a bar. */
static void leave_stick(const real *parameters, const real *states, real counted, real *after) {
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    (void)parameters;
    const real is_new = select(x->time > x->last_event, counted, 0.0);
    const real lasted = x->time - x->mode_began;
    const real adds = select(lasted > 0.0, select(real_abs(2.0 - x->last_letter) > 0.0, 1.0, x->bar_is_due),
        0.0);
    const real after_bar = select(x->bar_is_due * x->word_so_far > 0.0, 4.0 * x->word_so_far, x->word_so_far);
    const real by_4_times_after_bar_plus_by_2 = 4.0 * after_bar + 2.0;
    const real longer = select(x->word_so_far < 0.0, x->word_so_far,
        select(by_4_times_after_bar_plus_by_2 < 4503599627370496.0, by_4_times_after_bar_plus_by_2,
        -select(after_bar < 4503599627370496.0, after_bar, x->word_so_far)));
    y->events = x->events + is_new;
    y->last_event = select(counted > 0.0, x->time, x->last_event);
    y->slid_from = x->foot_x;
    y->stance_so_far = x->stance_so_far + lasted;
    y->word_so_far = select(adds > 0.0, longer, x->word_so_far);
    y->last_letter = select(lasted > 0.0, 2.0, x->last_letter);
    y->bar_is_due = select(lasted > 0.0, 0.0, x->bar_is_due);
    y->mode_began = x->time;
}

/* First variation of leave_stick. */
static void vary_leave_stick(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real counted, real *after) {
    const runner_states *x = (const void *)states;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    (void)parameters, (void)d_parameters;
    const real d_lasted = dx->time - dx->mode_began;
    const real lasted = x->time - x->mode_began;
    const real adds = select(lasted > 0.0, select(real_abs(2.0 - x->last_letter) > 0.0, 1.0, x->bar_is_due),
        0.0);
    const real bar_is_due_times_word_so_far = x->bar_is_due * x->word_so_far;
    const real after_bar = select(bar_is_due_times_word_so_far > 0.0, 4.0 * x->word_so_far, x->word_so_far);
    const real d_after_bar = select(bar_is_due_times_word_so_far > 0.0, 4.0 * dx->word_so_far,
        dx->word_so_far);
    const real d_longer = select(x->word_so_far < 0.0, dx->word_so_far, select(4.0 * after_bar
        + 2.0 < 4503599627370496.0, 4.0 * d_after_bar, -select(after_bar < 4503599627370496.0, d_after_bar,
        dx->word_so_far)));
    y->events = dx->events;
    y->last_event = select(counted > 0.0, dx->time, dx->last_event);
    y->slid_from = dx->foot_x;
    y->stance_so_far = dx->stance_so_far + d_lasted;
    y->word_so_far = select(adds > 0.0, d_longer, dx->word_so_far);
    y->last_letter = select(lasted > 0.0, 0.0, dx->last_letter);
    y->bar_is_due = select(lasted > 0.0, 0.0, dx->bar_is_due);
    y->mode_began = dx->time;
}

/* Rates of the world's states in stick. */
static void world_rates_stick(const real *parameters, const real *states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real cosine = real_cos(x->slope);
    const real vx = x->foot_vx * cosine;
    const real sine = real_sin(x->slope);
    const real vy = x->foot_vx * sine;
    const real x__times_vx = x->x_ * x->vx;
    const real y__times_vy = x->y_ * x->vy;
    const real sum_2 = 2.0 * x__times_vx + 2.0 * y__times_vy;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real length_rate = (x__times_vx + y__times_vy) / length;
    const real spring = p->stiffness * (rest_length - length) - p->damping * length_rate;
    const real axial = spring / length;
    const real stance_torque = x->external_torque - (p->drive_torque + p->more_torque) * x->driving;
    const real turning = stance_torque / square;
    const real along = axial * x->x_ - turning * x->y_;
    const real sum_3 = (along + (x->external_fx * cosine + x->external_fy * sine)) / p->body_mass
        - p->gravity * sine;
    const real off = axial * x->y_ + turning * x->x_;
    const real sum_4 = (off + (x->external_fy * cosine - x->external_fx * sine)) / p->body_mass
        - p->gravity * cosine;
    y->seen_x = vx;
    y->seen_y = vy;
    y->seen_vx = 0.0;
    y->seen_vy = 0.0;
    y->length = 0.5 * sum_2 / length;
    y->angle = angle_rate;
    y->length_rate = (x->vx * x->vx + x->x_ * sum_3 + (x->vy * x->vy + x->y_ * sum_4)
        - length_rate * (0.5 * sum_2 / length)) / length;
    y->angle_rate = (x->vx * x->vy + x->x_ * sum_4 - (x->vy * x->vx + x->y_ * sum_3)
        - angle_rate * sum_2) / square;
}

/* First variation of world_rates_stick. */
static void vary_world_rates_stick(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_vx = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
    const real d_sine = cosine * dx->slope;
    const real d_vy = dx->foot_vx * sine + x->foot_vx * d_sine;
    const real x__times_vx_plus_x__times_vx = dx->x_ * x->vx + x->x_ * dx->vx;
    const real y__times_vy_plus_y__times_vy = dx->y_ * x->vy + x->y_ * dx->vy;
    const real sum_2 = 2.0 * x__times_vx_plus_x__times_vx + 2.0 * y__times_vy_plus_y__times_vy;
    const real x__times_vx = x->x_ * x->vx;
    const real y__times_vy = x->y_ * x->vy;
    const real sum_3 = 2.0 * x__times_vx + 2.0 * y__times_vy;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real by_0_5_times_sum_over_length = 0.5 * sum_3 / length;
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real rest_length_minus_length = rest_length - length;
    const real length_rate = (x__times_vx + y__times_vy) / length;
    const real spring = p->stiffness * rest_length_minus_length - p->damping * length_rate;
    const real axial = spring / length;
    const real drive_torque_plus_more_torque = p->drive_torque + p->more_torque;
    const real stance_torque = x->external_torque - drive_torque_plus_more_torque * x->driving;
    const real turning = stance_torque / square;
    const real along = axial * x->x_ - turning * x->y_;
    const real along_plus_sum_over_body_mass = (along + (x->external_fx * cosine
        + x->external_fy * sine)) / p->body_mass;
    const real sum_4 = along_plus_sum_over_body_mass - p->gravity * sine;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_length_rate = (x__times_vx_plus_x__times_vx + y__times_vy_plus_y__times_vy
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * rest_length_minus_length + p->stiffness * (d_rest_length
        - d_length) - (dp->damping * length_rate + p->damping * d_length_rate);
    const real d_axial = (d_spring - axial * d_length) / length;
    const real d_stance_torque = dx->external_torque - ((dp->drive_torque + dp->more_torque) * x->driving
        + drive_torque_plus_more_torque * dx->driving);
    const real d_turning = (d_stance_torque - turning * d_square) / square;
    const real d_along = d_axial * x->x_ + axial * dx->x_ - (d_turning * x->y_ + turning * dx->y_);
    const real ratio_minus_sum = (d_along + (dx->external_fx * cosine - x->external_fx * sine_times_slope
        + (dx->external_fy * sine + x->external_fy * d_sine))
        - along_plus_sum_over_body_mass * dp->body_mass) / p->body_mass - (dp->gravity * sine
        + p->gravity * d_sine);
    const real off = axial * x->y_ + turning * x->x_;
    const real off_plus_sum_over_body_mass = (off + (x->external_fy * cosine
        - x->external_fx * sine)) / p->body_mass;
    const real sum_5 = off_plus_sum_over_body_mass - p->gravity * cosine;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real ratio_minus_sum_2 = (d_off + (dx->external_fy * cosine - x->external_fy * sine_times_slope
        - (dx->external_fx * sine + x->external_fx * d_sine))
        - off_plus_sum_over_body_mass * dp->body_mass) / p->body_mass - (dp->gravity * cosine
        - p->gravity * sine_times_slope);
    y->seen_x = d_vx;
    y->seen_y = d_vy;
    y->seen_vx = 0.0;
    y->seen_vy = 0.0;
    y->length = (0.5 * sum_2 - by_0_5_times_sum_over_length * d_length) / length;
    y->angle = d_angle_rate;
    y->length_rate = (2.0 * (x->vx * dx->vx) + (dx->x_ * sum_4 + x->x_ * ratio_minus_sum)
        + (2.0 * (x->vy * dx->vy) + (dx->y_ * sum_5 + x->y_ * ratio_minus_sum_2))
        - (d_length_rate * by_0_5_times_sum_over_length + length_rate * ((0.5 * sum_2
        - by_0_5_times_sum_over_length * d_length) / length)) - (x->vx * x->vx + x->x_ * sum_4
        + (x->vy * x->vy + x->y_ * sum_5)
        - length_rate * by_0_5_times_sum_over_length) / length * d_length) / length;
    y->angle_rate = (dx->vx * x->vy + x->vx * dx->vy + (dx->x_ * sum_5 + x->x_ * ratio_minus_sum_2)
        - (dx->vy * x->vx + x->vy * dx->vx + (dx->y_ * sum_4 + x->y_ * ratio_minus_sum))
        - (d_angle_rate * sum_3 + angle_rate * sum_2) - (x->vx * x->vy + x->x_ * sum_5 - (x->vy * x->vx
        + x->y_ * sum_4) - angle_rate * sum_3) / square * d_square) / square;
}

/* Constants of flight_calm. */
static void open_flight_calm(const real *parameters, const real *states, real *constants) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    flight_calm_constants *c = (void *)constants;
    const real mobility = 1.0 / p->body_mass + 1.0 / p->foot_mass;
    const real longer = p->thrust + p->more_thrust;
    const real thrusting_times_longer_or_by_0 = x->thrusting * select(longer >= 0.0, longer, 0.0);
    const real share = select(x->swing > 0.0, 1.0, 0.0);
    const real share_times_kp = share * p->kp;
    const real liftoff_factor_times_liftoff_angle = p->liftoff_factor * x->liftoff_angle;
    const real placing_angle = p->touchdown_angle + p->more_angle;
    const real first = select(x->swing < 2.0, liftoff_factor_times_liftoff_angle, placing_angle);
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real turn = is_placing * p->retraction_rate;
    const real share_times_kd = share * p->kd;
    const real stiffness_times_extension_rate = p->stiffness * x->extension_rate;
    const real minus_gravity = -p->gravity;
    const real body_mass_over_body_mass_plus_foot_mass = p->body_mass / (p->body_mass + p->foot_mass);
    const real set_slope = p->ground_slope + x->segment_slope;
    const real cos_of_set_slope = real_cos(set_slope);
    const real set_height = p->ground_height + x->segment_height;
    const real sin_of_set_slope = real_sin(set_slope);
    const real cos_of_slope = real_cos(x->slope);
    const real sin_of_slope = real_sin(x->slope);
    const real sum_2 = 1.0 - body_mass_over_body_mass_plus_foot_mass;
    const real inverse_cos_of_slope = 1.0 / cos_of_slope;
    c->mobility = mobility;
    c->stiffness = p->stiffness;
    c->free_length = p->free_length;
    c->thrusting_times_longer_or_by_0 = thrusting_times_longer_or_by_0;
    c->damping = p->damping;
    c->kp = p->kp;
    c->share_times_kp = share_times_kp;
    c->liftoff_factor_times_liftoff_angle = liftoff_factor_times_liftoff_angle;
    c->first = first;
    c->is_placing = is_placing;
    c->turn = turn;
    c->kd = p->kd;
    c->share_times_kd = share_times_kd;
    c->extension_rate = x->extension_rate;
    c->stiffness_times_extension_rate = stiffness_times_extension_rate;
    c->external_fx_rate = x->external_fx_rate;
    c->external_fy_rate = x->external_fy_rate;
    c->friction_rate = x->friction_rate;
    c->external_torque_rate = x->external_torque_rate;
    c->com_vx = x->com_vx;
    c->minus_gravity = minus_gravity;
    c->segment_end = x->segment_end;
    c->body_mass_over_body_mass_plus_foot_mass = body_mass_over_body_mass_plus_foot_mass;
    c->segment_begin = x->segment_begin;
    c->set_slope = set_slope;
    c->cos_of_set_slope = cos_of_set_slope;
    c->set_height = set_height;
    c->sin_of_set_slope = sin_of_set_slope;
    c->slope = x->slope;
    c->cos_of_slope = cos_of_slope;
    c->height = x->height;
    c->sin_of_slope = sin_of_slope;
    c->sum_2 = sum_2;
    c->least_length = p->least_length;
    c->inverse_cos_of_slope = inverse_cos_of_slope;
}

/* First variation of open_flight_calm. */
static void vary_open_flight_calm(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    flight_calm_constants *c = (void *)constants;
    const real d_mobility = -(1.0 / p->body_mass * dp->body_mass / p->body_mass)
        - 1.0 / p->foot_mass * dp->foot_mass / p->foot_mass;
    const real longer = p->thrust + p->more_thrust;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_thrusting_times_longer_or_by_0 = select(longer >= 0.0, longer, 0.0) * dx->thrusting
        + x->thrusting * select(longer >= 0.0, d_longer, 0.0);
    const real share = select(x->swing > 0.0, 1.0, 0.0);
    const real d_share_times_kp = share * dp->kp;
    const real d_liftoff_factor_times_liftoff_angle = x->liftoff_angle * dp->liftoff_factor
        + p->liftoff_factor * dx->liftoff_angle;
    const real d_placing_angle = dp->touchdown_angle + dp->more_angle;
    const real d_first = select(x->swing < 2.0, d_liftoff_factor_times_liftoff_angle, d_placing_angle);
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real d_turn = is_placing * dp->retraction_rate;
    const real d_share_times_kd = share * dp->kd;
    const real d_stiffness_times_extension_rate = x->extension_rate * dp->stiffness
        + p->stiffness * dx->extension_rate;
    const real d_minus_gravity = -dp->gravity;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real body_mass_over_body_mass_plus_foot_mass = p->body_mass / body_mass_plus_foot_mass;
    const real d_body_mass_over_body_mass_plus_foot_mass = (dp->body_mass
        - body_mass_over_body_mass_plus_foot_mass * (dp->body_mass
        + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_set_slope = dp->ground_slope + dx->segment_slope;
    const real set_slope = p->ground_slope + x->segment_slope;
    const real sin_of_set_slope = real_sin(set_slope);
    const real d_cos_of_set_slope = -(sin_of_set_slope * d_set_slope);
    const real d_set_height = dp->ground_height + dx->segment_height;
    const real cos_of_set_slope = real_cos(set_slope);
    const real d_sin_of_set_slope = cos_of_set_slope * d_set_slope;
    const real sin_of_slope = real_sin(x->slope);
    const real sin_of_slope_times_slope = sin_of_slope * dx->slope;
    const real d_cos_of_slope = -sin_of_slope_times_slope;
    const real cos_of_slope = real_cos(x->slope);
    const real d_sin_of_slope = cos_of_slope * dx->slope;
    const real d_sum_2 = -d_body_mass_over_body_mass_plus_foot_mass;
    const real inverse_cos_of_slope = 1.0 / cos_of_slope;
    const real d_inverse_cos_of_slope = inverse_cos_of_slope * sin_of_slope_times_slope / cos_of_slope;
    c->mobility = d_mobility;
    c->stiffness = dp->stiffness;
    c->free_length = dp->free_length;
    c->thrusting_times_longer_or_by_0 = d_thrusting_times_longer_or_by_0;
    c->damping = dp->damping;
    c->kp = dp->kp;
    c->share_times_kp = d_share_times_kp;
    c->liftoff_factor_times_liftoff_angle = d_liftoff_factor_times_liftoff_angle;
    c->first = d_first;
    c->is_placing = 0.0;
    c->turn = d_turn;
    c->kd = dp->kd;
    c->share_times_kd = d_share_times_kd;
    c->extension_rate = dx->extension_rate;
    c->stiffness_times_extension_rate = d_stiffness_times_extension_rate;
    c->external_fx_rate = dx->external_fx_rate;
    c->external_fy_rate = dx->external_fy_rate;
    c->friction_rate = dx->friction_rate;
    c->external_torque_rate = dx->external_torque_rate;
    c->com_vx = dx->com_vx;
    c->minus_gravity = d_minus_gravity;
    c->segment_end = dx->segment_end;
    c->body_mass_over_body_mass_plus_foot_mass = d_body_mass_over_body_mass_plus_foot_mass;
    c->segment_begin = dx->segment_begin;
    c->set_slope = d_set_slope;
    c->cos_of_set_slope = d_cos_of_set_slope;
    c->set_height = d_set_height;
    c->sin_of_set_slope = d_sin_of_set_slope;
    c->slope = dx->slope;
    c->cos_of_slope = d_cos_of_slope;
    c->height = dx->height;
    c->sin_of_slope = d_sin_of_slope;
    c->sum_2 = d_sum_2;
    c->least_length = dp->least_length;
    c->inverse_cos_of_slope = d_inverse_cos_of_slope;
}

/* passes_end: The foot is above the next segment. */
static int react_flight_calm_passes_end(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real segment_plus_by_1 = x->segment + 1.0;
    const real slope = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, segment_plus_by_1,
        0.0);
    const real height = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height,
        segment_plus_by_1, 0.0);
    const real end = select(p->patch_end > p->patch_begin, p->patch_end, 1000000000000.0);
    const real begin = select(p->patch_end > p->patch_begin, p->patch_begin, 1000000000000.0);
    const real begin_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin,
        segment_plus_by_1, select(segment_plus_by_1 > 0.0, select(segment_plus_by_1 > 1.0, end, begin),
        -1000000000000.0));
    const real end_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, segment_plus_by_1,
        select(segment_plus_by_1 > 0.0, select(segment_plus_by_1 > 1.0, 1000000000000.0, end), begin));
    const real friction = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        segment_plus_by_1, select(real_abs(segment_plus_by_1 - 1.0) > 0.0, -1.0, p->patch_friction));
    y->segment = segment_plus_by_1;
    y->segment_begin = begin_2;
    y->segment_end = end_2;
    y->segment_height = height;
    y->segment_slope = slope;
    y->friction_ahead = friction;
    y->friction_behind = friction;
    if (p->trips <= 0.0) {
        return next[0]; /* flight */
    }
    const real set_slope = p->ground_slope + slope;
    const real set_height = p->ground_height + height;
    const real level = real_cos(set_slope) * (x->com_y - set_height) - real_sin(set_slope) * x->com_x;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real above = level - share * x->length * real_cos(x->angle - set_slope);
    if (above < -(1e-12 * p->free_length)) {
        const real sine = real_sin(x->angle);
        const real cosine = real_cos(x->angle);
        const real y_2 = x->length * cosine;
        const real turn = x->momentum / x->length;
        const real vx = -(x->length_rate * sine) - turn * cosine;
        const real vy = x->length_rate * cosine - turn * sine;
        const real square = x->length * x->length;
        const real rate = x->momentum / square;
        y->seen_x = x->com_x + share * (x->length * sine);
        y->seen_y = x->com_y - share * y_2;
        y->seen_vx = x->com_vx - share * vx;
        y->seen_vy = x->com_vy - share * vy;
        y->angle_rate = rate;
        y->has_fallen = 1.0;
        return next[1]; /* fallen */
    }
    return next[0]; /* flight */
}

/* First variation of passes_end. */
static void vary_react_flight_calm_passes_end(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real segment_plus_by_1 = x->segment + 1.0;
    const real d_end = select(p->patch_end > p->patch_begin, dp->patch_end, 0.0);
    const real d_begin = select(p->patch_end > p->patch_begin, dp->patch_begin, 0.0);
    const real d_begin_2 = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin,
        seed, segment_plus_by_1, select(segment_plus_by_1 > 0.0, select(segment_plus_by_1 > 1.0, d_end,
        d_begin), 0.0));
    const real d_end_2 = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, seed,
        segment_plus_by_1, select(segment_plus_by_1 > 0.0, select(segment_plus_by_1 > 1.0, 0.0, d_end),
        d_begin));
    const real d_height = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height,
        seed, segment_plus_by_1, 0.0);
    const real d_slope = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, seed,
        segment_plus_by_1, 0.0);
    const real d_friction = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        seed, segment_plus_by_1, select(real_abs(segment_plus_by_1 - 1.0) > 0.0, 0.0, dp->patch_friction));
    y->segment = dx->segment;
    y->segment_begin = d_begin_2;
    y->segment_end = d_end_2;
    y->segment_height = d_height;
    y->segment_slope = d_slope;
    y->friction_ahead = d_friction;
    y->friction_behind = d_friction;
    if (p->trips <= 0.0) {
        return;
    }
    const real set_slope = p->ground_slope + looked_up(tables, TABLE_ground_segment,
        COLUMN_ground_segment_slope, segment_plus_by_1, 0.0);
    const real set_height = p->ground_height + looked_up(tables, TABLE_ground_segment,
        COLUMN_ground_segment_height, segment_plus_by_1, 0.0);
    const real level = real_cos(set_slope) * (x->com_y - set_height) - real_sin(set_slope) * x->com_x;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real above = level - share * x->length * real_cos(x->angle - set_slope);
    if (above < -(1e-12 * p->free_length)) {
        const real d_share = (dp->body_mass - share * (dp->body_mass
            + dp->foot_mass)) / body_mass_plus_foot_mass;
        const real sine = real_sin(x->angle);
        const real cosine = real_cos(x->angle);
        const real d_sine = cosine * dx->angle;
        const real y_2 = x->length * cosine;
        const real sine_times_angle = sine * dx->angle;
        const real d_y = dx->length * cosine - x->length * sine_times_angle;
        const real turn = x->momentum / x->length;
        const real vx = -(x->length_rate * sine) - turn * cosine;
        const real d_turn = (dx->momentum - turn * dx->length) / x->length;
        const real d_vx = -(dx->length_rate * sine + x->length_rate * d_sine) - (d_turn * cosine
            - turn * sine_times_angle);
        const real vy = x->length_rate * cosine - turn * sine;
        const real d_vy = dx->length_rate * cosine - x->length_rate * sine_times_angle - (d_turn * sine
            + turn * d_sine);
        const real square = x->length * x->length;
        const real rate = x->momentum / square;
        const real d_square = 2.0 * (x->length * dx->length);
        const real d_rate = (dx->momentum - rate * d_square) / square;
        y->seen_x = dx->com_x + (d_share * (x->length * sine) + share * (dx->length * sine
            + x->length * d_sine));
        y->seen_y = dx->com_y - (d_share * y_2 + share * d_y);
        y->seen_vx = dx->com_vx - (d_share * vx + share * d_vx);
        y->seen_vy = dx->com_vy - (d_share * vy + share * d_vy);
        y->angle_rate = d_rate;
        y->has_fallen = 0.0;
        return;
    }
}

/* True if passes_end is watched. */
static real watches_flight_calm_passes_end(const real *parameters, const real *states) {
    const runner_states *x = (const void *)states;
    (void)parameters;
    if (x->segment_end < 1000000000000.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of passes_end. */
static real vary_guard_flight_calm_passes_end(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real sine = real_sin(x->angle);
    const real cosine = real_cos(x->angle);
    const real d_sine = cosine * dx->angle;
    return dx->segment_end - (dx->com_x + (d_share * (x->length * sine) + share * (dx->length * sine
        + x->length * d_sine)));
}

/* passes_begin: The foot is above the segment before. */
static int react_flight_calm_passes_begin(const real *parameters, const real *states,
    const tdmf_table *tables, real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real segment_minus_by_1 = x->segment - 1.0;
    const real slope = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope,
        segment_minus_by_1, 0.0);
    const real height = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height,
        segment_minus_by_1, 0.0);
    const real end = select(p->patch_end > p->patch_begin, p->patch_end, 1000000000000.0);
    const real begin = select(p->patch_end > p->patch_begin, p->patch_begin, 1000000000000.0);
    const real begin_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin,
        segment_minus_by_1, select(segment_minus_by_1 > 0.0, select(segment_minus_by_1 > 1.0, end, begin),
        -1000000000000.0));
    const real end_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, segment_minus_by_1,
        select(segment_minus_by_1 > 0.0, select(segment_minus_by_1 > 1.0, 1000000000000.0, end), begin));
    const real friction = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        segment_minus_by_1, select(real_abs(segment_minus_by_1 - 1.0) > 0.0, -1.0, p->patch_friction));
    y->segment = segment_minus_by_1;
    y->segment_begin = begin_2;
    y->segment_end = end_2;
    y->segment_height = height;
    y->segment_slope = slope;
    y->friction_ahead = friction;
    y->friction_behind = friction;
    if (p->trips <= 0.0) {
        return next[0]; /* flight */
    }
    const real set_slope = p->ground_slope + slope;
    const real set_height = p->ground_height + height;
    const real level = real_cos(set_slope) * (x->com_y - set_height) - real_sin(set_slope) * x->com_x;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real above = level - share * x->length * real_cos(x->angle - set_slope);
    if (above < -(1e-12 * p->free_length)) {
        const real sine = real_sin(x->angle);
        const real cosine = real_cos(x->angle);
        const real y_2 = x->length * cosine;
        const real turn = x->momentum / x->length;
        const real vx = -(x->length_rate * sine) - turn * cosine;
        const real vy = x->length_rate * cosine - turn * sine;
        const real square = x->length * x->length;
        const real rate = x->momentum / square;
        y->seen_x = x->com_x + share * (x->length * sine);
        y->seen_y = x->com_y - share * y_2;
        y->seen_vx = x->com_vx - share * vx;
        y->seen_vy = x->com_vy - share * vy;
        y->angle_rate = rate;
        y->has_fallen = 1.0;
        return next[1]; /* fallen */
    }
    return next[0]; /* flight */
}

/* First variation of passes_begin. */
static void vary_react_flight_calm_passes_begin(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real segment_minus_by_1 = x->segment - 1.0;
    const real d_end = select(p->patch_end > p->patch_begin, dp->patch_end, 0.0);
    const real d_begin = select(p->patch_end > p->patch_begin, dp->patch_begin, 0.0);
    const real d_begin_2 = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin,
        seed, segment_minus_by_1, select(segment_minus_by_1 > 0.0, select(segment_minus_by_1 > 1.0, d_end,
        d_begin), 0.0));
    const real d_end_2 = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, seed,
        segment_minus_by_1, select(segment_minus_by_1 > 0.0, select(segment_minus_by_1 > 1.0, 0.0, d_end),
        d_begin));
    const real d_height = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height,
        seed, segment_minus_by_1, 0.0);
    const real d_slope = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, seed,
        segment_minus_by_1, 0.0);
    const real d_friction = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        seed, segment_minus_by_1, select(real_abs(segment_minus_by_1 - 1.0) > 0.0, 0.0, dp->patch_friction));
    y->segment = dx->segment;
    y->segment_begin = d_begin_2;
    y->segment_end = d_end_2;
    y->segment_height = d_height;
    y->segment_slope = d_slope;
    y->friction_ahead = d_friction;
    y->friction_behind = d_friction;
    if (p->trips <= 0.0) {
        return;
    }
    const real set_slope = p->ground_slope + looked_up(tables, TABLE_ground_segment,
        COLUMN_ground_segment_slope, segment_minus_by_1, 0.0);
    const real set_height = p->ground_height + looked_up(tables, TABLE_ground_segment,
        COLUMN_ground_segment_height, segment_minus_by_1, 0.0);
    const real level = real_cos(set_slope) * (x->com_y - set_height) - real_sin(set_slope) * x->com_x;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real above = level - share * x->length * real_cos(x->angle - set_slope);
    if (above < -(1e-12 * p->free_length)) {
        const real d_share = (dp->body_mass - share * (dp->body_mass
            + dp->foot_mass)) / body_mass_plus_foot_mass;
        const real sine = real_sin(x->angle);
        const real cosine = real_cos(x->angle);
        const real d_sine = cosine * dx->angle;
        const real y_2 = x->length * cosine;
        const real sine_times_angle = sine * dx->angle;
        const real d_y = dx->length * cosine - x->length * sine_times_angle;
        const real turn = x->momentum / x->length;
        const real vx = -(x->length_rate * sine) - turn * cosine;
        const real d_turn = (dx->momentum - turn * dx->length) / x->length;
        const real d_vx = -(dx->length_rate * sine + x->length_rate * d_sine) - (d_turn * cosine
            - turn * sine_times_angle);
        const real vy = x->length_rate * cosine - turn * sine;
        const real d_vy = dx->length_rate * cosine - x->length_rate * sine_times_angle - (d_turn * sine
            + turn * d_sine);
        const real square = x->length * x->length;
        const real rate = x->momentum / square;
        const real d_square = 2.0 * (x->length * dx->length);
        const real d_rate = (dx->momentum - rate * d_square) / square;
        y->seen_x = dx->com_x + (d_share * (x->length * sine) + share * (dx->length * sine
            + x->length * d_sine));
        y->seen_y = dx->com_y - (d_share * y_2 + share * d_y);
        y->seen_vx = dx->com_vx - (d_share * vx + share * d_vx);
        y->seen_vy = dx->com_vy - (d_share * vy + share * d_vy);
        y->angle_rate = d_rate;
        y->has_fallen = 0.0;
        return;
    }
}

/* True if passes_begin is watched. */
static real watches_flight_calm_passes_begin(const real *parameters, const real *states) {
    const runner_states *x = (const void *)states;
    (void)parameters;
    if (x->segment_begin > -1000000000000.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of passes_begin. */
static real vary_guard_flight_calm_passes_begin(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real sine = real_sin(x->angle);
    const real cosine = real_cos(x->angle);
    const real d_sine = cosine * dx->angle;
    return dx->com_x + (d_share * (x->length * sine) + share * (dx->length * sine + x->length * d_sine))
        - dx->segment_begin;
}

/* ramp_ends: A ramp of the friction coefficient ends at 0. */
static int react_flight_calm_ramp_ends(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->friction = 0.0;
    y->friction_rate = 0.0;
    return next[0]; /* flight */
}

/* wind_rises: An external force acts, so flight is no longer ballistic. */
static int react_flight_calm_wind_rises(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    (void)parameters, (void)states, (void)tables, (void)after;
    return next[0]; /* flight */
}

/* True if wind_rises is watched. */
static real watches_flight_calm_wind_rises(const real *parameters, const real *states) {
    const runner_states *x = (const void *)states;
    (void)parameters;
    const real now = real_abs(x->external_fx) + real_abs(x->external_fy);
    const real soon = real_abs(x->external_fx_rate) + real_abs(x->external_fy_rate);
    if (now > 0.0 || soon > 0.0) {
        return 1.0;
    }
    return 0.0;
}

/* new_ground: The foot is above the pending ground line, which comes into force. */
static int react_flight_calm_new_ground(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    (void)tables;
    const real set_height = p->ground_height + x->segment_height;
    const real set_slope = p->ground_slope + x->segment_slope;
    y->height = set_height;
    y->slope = set_slope;
    return next[0]; /* flight */
}

/* First variation of new_ground. */
static void vary_react_flight_calm_new_ground(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables, (void)seed;
    const real d_set_height = dp->ground_height + dx->segment_height;
    const real d_set_slope = dp->ground_slope + dx->segment_slope;
    y->height = d_set_height;
    y->slope = d_set_slope;
}

/* True if new_ground is watched. */
static real watches_flight_calm_new_ground(const real *parameters, const real *states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const real set_height = p->ground_height + x->segment_height;
    const real set_slope = p->ground_slope + x->segment_slope;
    if (real_abs(set_height - x->height) + real_abs(p->free_length * (set_slope - x->slope)) > 0.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of new_ground. */
static real vary_guard_flight_calm_new_ground(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real set_slope = p->ground_slope + x->segment_slope;
    const real cos_of_set_slope = real_cos(set_slope);
    const real d_set_height = dp->ground_height + dx->segment_height;
    const real sin_of_set_slope = real_sin(set_slope);
    const real d_set_slope = dp->ground_slope + dx->segment_slope;
    const real set_height = p->ground_height + x->segment_height;
    const real d_level = cos_of_set_slope * (dx->com_y - d_set_height)
        - sin_of_set_slope * d_set_slope * (x->com_y - set_height)
        - (cos_of_set_slope * d_set_slope * x->com_x + sin_of_set_slope * dx->com_x);
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real angle_minus_set_slope = x->angle - set_slope;
    const real d_above = d_level - ((d_share * x->length
        + share * dx->length) * real_cos(angle_minus_set_slope)
        - share * x->length * (real_sin(angle_minus_set_slope) * (dx->angle - d_set_slope)));
    return -d_above;
}

/* falls: The body reaches the ground. */
static int react_flight_calm_falls(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    (void)tables;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real sine = real_sin(x->angle);
    const real cosine = real_cos(x->angle);
    const real y_2 = x->length * cosine;
    const real turn = x->momentum / x->length;
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real vy = x->length_rate * cosine - turn * sine;
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    y->seen_x = x->com_x + share * (x->length * sine);
    y->seen_y = x->com_y - share * y_2;
    y->seen_vx = x->com_vx - share * vx;
    y->seen_vy = x->com_vy - share * vy;
    y->angle_rate = rate;
    y->has_fallen = 1.0;
    return next[0]; /* fallen */
}

/* First variation of falls. */
static void vary_react_flight_calm_falls(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real sine = real_sin(x->angle);
    const real cosine = real_cos(x->angle);
    const real d_sine = cosine * dx->angle;
    const real y_2 = x->length * cosine;
    const real sine_times_angle = sine * dx->angle;
    const real d_y = dx->length * cosine - x->length * sine_times_angle;
    const real turn = x->momentum / x->length;
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real d_turn = (dx->momentum - turn * dx->length) / x->length;
    const real d_vx = -(dx->length_rate * sine + x->length_rate * d_sine) - (d_turn * cosine
        - turn * sine_times_angle);
    const real vy = x->length_rate * cosine - turn * sine;
    const real d_vy = dx->length_rate * cosine - x->length_rate * sine_times_angle - (d_turn * sine
        + turn * d_sine);
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real d_square = 2.0 * (x->length * dx->length);
    const real d_rate = (dx->momentum - rate * d_square) / square;
    y->seen_x = dx->com_x + (d_share * (x->length * sine) + share * (dx->length * sine + x->length * d_sine));
    y->seen_y = dx->com_y - (d_share * y_2 + share * d_y);
    y->seen_vx = dx->com_vx - (d_share * vx + share * d_vx);
    y->seen_vy = dx->com_vy - (d_share * vy + share * d_vy);
    y->angle_rate = d_rate;
    y->has_fallen = 0.0;
}

/* First variation of the guard of falls. */
static real vary_guard_flight_calm_falls(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real cos_of_slope = real_cos(x->slope);
    const real sin_of_slope = real_sin(x->slope);
    const real d_level = cos_of_slope * (dx->com_y - dx->height) - sin_of_slope * dx->slope * (x->com_y
        - x->height) - (cos_of_slope * dx->slope * x->com_x + sin_of_slope * dx->com_x);
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real by_1_minus_share = 1.0 - share;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real angle_minus_slope = x->angle - x->slope;
    const real d_above = d_level + ((by_1_minus_share * dx->length
        - d_share * x->length) * real_cos(angle_minus_slope)
        - by_1_minus_share * x->length * (real_sin(angle_minus_slope) * (dx->angle - dx->slope)));
    return d_above;
}

/* First variation of the guard of collapses. */
static real vary_guard_flight_calm_collapses(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    (void)parameters, (void)states;
    return dx->length - dp->least_length;
}

/* apex: A stride closes and place begins. An external force can cause further apices in place. */
static int react_flight_calm_apex(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    (void)tables;
    const real period = x->time - x->apex_time;
    const real distance = x->com_x - x->x_then;
    const real hip = x->work - x->work_then;
    const real leg = x->leg_work - x->leg_work_then;
    const real work = hip + leg;
    const real weight = (p->body_mass + p->foot_mass) * p->gravity;
    const real height_of_section = x->com_y - x->height
        - x->com_x * (real_sin(x->slope) / real_cos(x->slope));
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    y->is_open = 1.0;
    y->work_then = x->work;
    y->leg_work_then = x->leg_work;
    y->positive_work_then = x->positive_work_so_far;
    y->peak_force_so_far = 0.0;
    y->vertical_so_far = 0.0;
    y->touchdowns_so_far = 0.0;
    y->slip_so_far = 0.0;
    y->stance_so_far = 0.0;
    y->word_so_far = 0.0;
    y->last_letter = 0.0;
    y->bar_is_due = 0.0;
    y->x_then = x->com_x;
    y->y_then = x->com_y;
    y->count = select(x->is_open > 0.0, x->count + 1.0, x->count);
    y->word_code = select(x->is_open > 0.0, x->word_so_far, x->word_code);
    y->period = select(x->is_open > 0.0, period, x->period);
    y->distance = select(x->is_open > 0.0, distance, x->distance);
    y->rise_of_stride = select(x->is_open > 0.0, x->com_y - x->y_then, x->rise_of_stride);
    y->work_of_stride = select(x->is_open > 0.0, work, x->work_of_stride);
    y->hip_work = select(x->is_open > 0.0, hip, x->hip_work);
    y->leg_work_of_stride = select(x->is_open > 0.0, leg, x->leg_work_of_stride);
    y->positive_work = select(x->is_open > 0.0, x->positive_work_so_far - x->positive_work_then,
        x->positive_work);
    y->speed = select(x->is_open > 0.0, select(period > 0.0, distance / period, x->com_vx), x->speed);
    y->cost_of_transport = select(x->is_open > 0.0, select(period > 0.0, work / (weight * distance), 0.0),
        x->cost_of_transport);
    y->touchdowns = select(x->is_open > 0.0, x->touchdowns_so_far, x->touchdowns);
    y->stance_time = select(x->is_open > 0.0, x->stance_so_far, x->stance_time);
    y->duty_factor = select(x->is_open > 0.0, select(period > 0.0, x->stance_so_far / period, 0.0),
        x->duty_factor);
    y->slip_distance = select(x->is_open > 0.0, x->slip_so_far, x->slip_distance);
    y->peak_force = select(x->is_open > 0.0, x->peak_force_so_far, x->peak_force);
    y->peak_vertical_force = select(x->is_open > 0.0, x->vertical_so_far, x->peak_vertical_force);
    y->apex_time = x->time;
    y->apex_com_height = height_of_section;
    y->apex_com_speed = x->com_vx;
    y->apex_length = x->length;
    y->apex_angle = x->angle;
    y->apex_length_rate = x->length_rate;
    y->apex_angle_rate = rate;
    y->swing = 2.0;
    y->placing = 0.0;
    y->rises_again = 0.0;
    return next[0]; /* flight */
}

/* First variation of apex. */
static void vary_react_flight_calm_apex(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real d_period = dx->time - dx->apex_time;
    const real d_distance = dx->com_x - dx->x_then;
    const real d_hip = dx->work - dx->work_then;
    const real d_leg = dx->leg_work - dx->leg_work_then;
    const real d_work = d_hip + d_leg;
    const real period = x->time - x->apex_time;
    const real distance = x->com_x - x->x_then;
    const real hip = x->work - x->work_then;
    const real leg = x->leg_work - x->leg_work_then;
    const real work = hip + leg;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real weight = body_mass_plus_foot_mass * p->gravity;
    const real weight_times_distance = weight * distance;
    const real d_weight = p->gravity * (dp->body_mass + dp->foot_mass)
        + body_mass_plus_foot_mass * dp->gravity;
    const real sin_of_slope = real_sin(x->slope);
    const real cos_of_slope = real_cos(x->slope);
    const real sin_of_slope_over_cos_of_slope = sin_of_slope / cos_of_slope;
    const real d_height_of_section = dx->com_y - dx->height - (dx->com_x * sin_of_slope_over_cos_of_slope
        + x->com_x * ((cos_of_slope * dx->slope
        + sin_of_slope_over_cos_of_slope * (sin_of_slope * dx->slope)) / cos_of_slope));
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real d_square = 2.0 * (x->length * dx->length);
    const real d_rate = (dx->momentum - rate * d_square) / square;
    y->is_open = 0.0;
    y->work_then = dx->work;
    y->leg_work_then = dx->leg_work;
    y->positive_work_then = dx->positive_work_so_far;
    y->peak_force_so_far = 0.0;
    y->vertical_so_far = 0.0;
    y->touchdowns_so_far = 0.0;
    y->slip_so_far = 0.0;
    y->stance_so_far = 0.0;
    y->word_so_far = 0.0;
    y->last_letter = 0.0;
    y->bar_is_due = 0.0;
    y->x_then = dx->com_x;
    y->y_then = dx->com_y;
    y->count = dx->count;
    y->word_code = select(x->is_open > 0.0, dx->word_so_far, dx->word_code);
    y->period = select(x->is_open > 0.0, d_period, dx->period);
    y->distance = select(x->is_open > 0.0, d_distance, dx->distance);
    y->rise_of_stride = select(x->is_open > 0.0, dx->com_y - dx->y_then, dx->rise_of_stride);
    y->work_of_stride = select(x->is_open > 0.0, d_work, dx->work_of_stride);
    y->hip_work = select(x->is_open > 0.0, d_hip, dx->hip_work);
    y->leg_work_of_stride = select(x->is_open > 0.0, d_leg, dx->leg_work_of_stride);
    y->positive_work = select(x->is_open > 0.0, dx->positive_work_so_far - dx->positive_work_then,
        dx->positive_work);
    y->speed = select(x->is_open > 0.0, select(period > 0.0, (d_distance
        - distance / period * d_period) / period, dx->com_vx), dx->speed);
    y->cost_of_transport = select(x->is_open > 0.0, select(period > 0.0, (d_work
        - work / weight_times_distance * (d_weight * distance + weight * d_distance)) / weight_times_distance,
        0.0), dx->cost_of_transport);
    y->touchdowns = select(x->is_open > 0.0, dx->touchdowns_so_far, dx->touchdowns);
    y->stance_time = select(x->is_open > 0.0, dx->stance_so_far, dx->stance_time);
    y->duty_factor = select(x->is_open > 0.0, select(period > 0.0, (dx->stance_so_far
        - x->stance_so_far / period * d_period) / period, 0.0), dx->duty_factor);
    y->slip_distance = select(x->is_open > 0.0, dx->slip_so_far, dx->slip_distance);
    y->peak_force = select(x->is_open > 0.0, dx->peak_force_so_far, dx->peak_force);
    y->peak_vertical_force = select(x->is_open > 0.0, dx->vertical_so_far, dx->peak_vertical_force);
    y->apex_time = dx->time;
    y->apex_com_height = d_height_of_section;
    y->apex_com_speed = dx->com_vx;
    y->apex_length = dx->length;
    y->apex_angle = dx->angle;
    y->apex_length_rate = dx->length_rate;
    y->apex_angle_rate = d_rate;
    y->swing = 0.0;
    y->placing = 0.0;
    y->rises_again = 0.0;
}

/* True if apex is watched. */
static real watches_flight_calm_apex(const real *parameters, const real *states) {
    const runner_states *x = (const void *)states;
    (void)parameters;
    if (x->swing < 2.0 || x->rises_again > 0.0) {
        return 1.0;
    }
    return 0.0;
}

/* True if apex has to cross zero. */
static real crosses_flight_calm_apex(const real *parameters, const real *states) {
    const runner_states *x = (const void *)states;
    (void)parameters;
    if (x->swing > 1.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of apex. */
static real vary_guard_flight_calm_apex(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const runner_states *dx = (const void *)d_states;
    (void)parameters, (void)states, (void)d_parameters;
    return dx->com_vy;
}

/* touchdown: The foot reaches the ground. Where the lift of the flight law vanishes, shorter and shorter
 * hops follow each other. After one of no time the foot grazes, until the flight law has ceased to lift it
 * and lifts it again. */
static int react_flight_calm_touchdown(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real sine = real_sin(x->angle);
    const real turn = x->momentum / x->length;
    const real cosine = real_cos(x->angle);
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real com_vx_minus_share_times_vx = x->com_vx - share * vx;
    const real cos_of_slope = real_cos(x->slope);
    const real vy = x->length_rate * cosine - turn * sine;
    const real com_vy_minus_share_times_vy = x->com_vy - share * vy;
    const real sin_of_slope = real_sin(x->slope);
    const real product_plus_product = com_vx_minus_share_times_vx * cos_of_slope
        + com_vy_minus_share_times_vy * sin_of_slope;
    const real length_times_sine = x->length * sine;
    const real sum_2 = x->com_x + share * length_times_sine;
    const real y_2 = x->length * cosine;
    const real sum_3 = y_2 * sin_of_slope - length_times_sine * cos_of_slope;
    const real sum_4 = y_2 * cos_of_slope + length_times_sine * sin_of_slope;
    const real along = sum_2 * cos_of_slope + (x->com_y - share * y_2 - x->height) * sin_of_slope;
    const real angle_minus_minus_sumatan2_of_sum = x->angle - real_atan2(-sum_3, sum_4);
    y->x_ = sum_3;
    y->y_ = sum_4;
    y->foot_x = along;
    y->winding = angle_minus_minus_sumatan2_of_sum;
    if (x->has_hopped > 0.0 && x->time <= x->hop_time) {
        y->vx = vx * cos_of_slope + vy * sin_of_slope;
        y->vy = vy * cos_of_slope - vx * sin_of_slope;
        y->foot_vx = product_plus_product;
        return next[0]; /* graze */
    }
    const real way = select(product_plus_product >= 0.0, 1.0, -1.0);
    const real way_times_product_plus_product = way * product_plus_product;
    const real ends = select(x->segment_end < 1000000000000.0, 1.0, 0.0);
    const real by_1eminus_12_times_free_length = 1e-12 * p->free_length;
    const real sum_5 = sum_2 + by_1eminus_12_times_free_length;
    const real begins = select(x->segment_begin > -1000000000000.0, 1.0, 0.0);
    const real segment_towards = x->segment + ends * select(sum_5 > x->segment_end, 1.0, 0.0)
        - begins * select(sum_5 < x->segment_begin, 1.0, 0.0);
    const real friction = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        segment_towards, select(real_abs(segment_towards - 1.0) > 0.0, -1.0, p->patch_friction));
    const real sum_6 = sum_2 - by_1eminus_12_times_free_length;
    const real sum_7 = x->segment + ends * select(sum_6 > x->segment_end, 1.0, 0.0)
        - begins * select(sum_6 < x->segment_begin, 1.0, 0.0);
    const real friction_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, sum_7,
        select(real_abs(sum_7 - 1.0) > 0.0, -1.0, p->patch_friction));
    const real own = select(way > 0.0, friction, friction_2);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real product_minus_product = com_vy_minus_share_times_vy * cos_of_slope
        - com_vx_minus_share_times_vx * sin_of_slope;
    const real friction_along = is_own * own + (1.0 - is_own) * x->friction;
    const real product_2 = friction_along * product_minus_product;
    const real sum_8 = way_times_product_plus_product + product_2;
    const real touchdowns_so_far_plus_by_1 = x->touchdowns_so_far + 1.0;
    const real along_times_cos_of_slope_plus_product = along * cos_of_slope
        + by_1eminus_12_times_free_length * way;
    const real sum_9 = x->segment + ends * select(along_times_cos_of_slope_plus_product > x->segment_end, 1.0,
        0.0) - begins * select(along_times_cos_of_slope_plus_product < x->segment_begin, 1.0, 0.0);
    const real end = select(p->patch_end > p->patch_begin, p->patch_end, 1000000000000.0);
    const real begin = select(p->patch_end > p->patch_begin, p->patch_begin, 1000000000000.0);
    const real begin_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, sum_9,
        select(sum_9 > 0.0, select(sum_9 > 1.0, end, begin), -1000000000000.0));
    const real end_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, sum_9,
        select(sum_9 > 0.0, select(sum_9 > 1.0, 1000000000000.0, end), begin));
    const real height = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height, sum_9, 0.0);
    const real slope = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, sum_9, 0.0);
    const real friction_3 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, sum_9,
        select(real_abs(sum_9 - 1.0) > 0.0, -1.0, p->patch_friction));
    const real friction_or_friction = select(p->keeps_friction > 0.0, friction, friction_3);
    const real friction_or_friction_2 = select(p->keeps_friction > 0.0, friction_2, friction_3);
    const real foot_mass_over_body_mass_plus_foot_mass = p->foot_mass / body_mass_plus_foot_mass;
    const real com_vx_plus_product = x->com_vx + foot_mass_over_body_mass_plus_foot_mass * vx;
    const real com_vy_plus_product = x->com_vy + foot_mass_over_body_mass_plus_foot_mass * vy;
    const real sum_10 = com_vx_plus_product * cos_of_slope + com_vy_plus_product * sin_of_slope;
    const real sum_11 = com_vy_plus_product * cos_of_slope - com_vx_plus_product * sin_of_slope;
    const real product_plus_product_2 = product_plus_product * product_plus_product
        + product_minus_product * product_minus_product;
    const real by_1_or_by_0 = select(x->angle >= 0.0, 1.0, 0.0);
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    y->touchdowns_so_far = touchdowns_so_far_plus_by_1;
    y->slid_from = along;
    y->bar_is_due = 1.0;
    y->vy = sum_11;
    y->driving = by_1_or_by_0;
    y->placing = 0.0;
    y->touchdown_time = x->time;
    y->was_placed = is_placing;
    y->placed_for = x->placing;
    if (p->stribeck_velocity > 0.0 && p->static_ratio > 1.0) {
        const real product_3 = (p->static_ratio - 1.0) * real_expm1(product_2 / p->stribeck_velocity);
        const real gained = -product_3;
        const real stopped_speed = p->stribeck_velocity * real_log1p(gained) - product_2;
        const real left = sum_8
            + p->stribeck_velocity * real_log1p(product_3 * real_exp(-(sum_8 / p->stribeck_velocity)));
        const real speed_left = select(left > 0.0, left, 0.0);
        const real speed_after_impact = select(way_times_product_plus_product <= stopped_speed, 0.0,
            speed_left);
        const real after_2 = way * speed_after_impact;
        const real sum_minus_after = sum_10 - after_2;
        const real speeds = product_plus_product_2 - after_2 * after_2;
        const real sum_12 = x->impact_loss + 0.5 * (p->foot_mass * speeds);
        y->vx = sum_minus_after;
        y->foot_vx = after_2;
        y->impact_loss = sum_12;
        if (way * after_2 > 0.0) {
            y->segment = sum_9;
            y->segment_begin = begin_2;
            y->segment_end = end_2;
            y->segment_height = height;
            y->segment_slope = slope;
            y->friction_ahead = friction_or_friction;
            y->friction_behind = friction_or_friction_2;
            y->way = way;
            return next[1]; /* slip */
        }
        y->friction_ahead = friction;
        y->friction_behind = friction_2;
        return next[2]; /* stick */
    }
    const real way_times_by_0_or_sum = way * select(way_times_product_plus_product <= -(p->static_ratio *
        product_2), 0.0, sum_8);
    const real sum_minus_way_times_by_0_or_sum = sum_10 - way_times_by_0_or_sum;
    const real impact_loss_plus_by_0_5_times_product = x->impact_loss
        + 0.5 * (p->foot_mass * (product_plus_product_2 - way_times_by_0_or_sum * way_times_by_0_or_sum));
    y->vx = sum_minus_way_times_by_0_or_sum;
    y->foot_vx = way_times_by_0_or_sum;
    y->impact_loss = impact_loss_plus_by_0_5_times_product;
    if (way * way_times_by_0_or_sum > 0.0) {
        y->segment = sum_9;
        y->segment_begin = begin_2;
        y->segment_end = end_2;
        y->segment_height = height;
        y->segment_slope = slope;
        y->friction_ahead = friction_or_friction;
        y->friction_behind = friction_or_friction_2;
        y->way = way;
        return next[1]; /* slip */
    }
    y->friction_ahead = friction;
    y->friction_behind = friction_2;
    return next[2]; /* stick */
}

/* First variation of touchdown. */
static void vary_react_flight_calm_touchdown(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real sine = real_sin(x->angle);
    const real turn = x->momentum / x->length;
    const real cosine = real_cos(x->angle);
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real com_vx_minus_share_times_vx = x->com_vx - share * vx;
    const real cos_of_slope = real_cos(x->slope);
    const real vy = x->length_rate * cosine - turn * sine;
    const real com_vy_minus_share_times_vy = x->com_vy - share * vy;
    const real sin_of_slope = real_sin(x->slope);
    const real length_times_sine = x->length * sine;
    const real sum_2 = x->com_x + share * length_times_sine;
    const real sine_times_angle = sine * dx->angle;
    const real d_y = dx->length * cosine - x->length * sine_times_angle;
    const real y_2 = x->length * cosine;
    const real cos_of_slope_times_slope = cos_of_slope * dx->slope;
    const real d_sine = cosine * dx->angle;
    const real sum_3 = dx->length * sine + x->length * d_sine;
    const real sin_of_slope_times_slope = sin_of_slope * dx->slope;
    const real sum_4 = d_y * sin_of_slope + y_2 * cos_of_slope_times_slope - (sum_3 * cos_of_slope
        - length_times_sine * sin_of_slope_times_slope);
    const real sum_5 = d_y * cos_of_slope - y_2 * sin_of_slope_times_slope + (sum_3 * sin_of_slope
        + length_times_sine * cos_of_slope_times_slope);
    const real d_turn = (dx->momentum - turn * dx->length) / x->length;
    const real d_vx = -(dx->length_rate * sine + x->length_rate * d_sine) - (d_turn * cosine
        - turn * sine_times_angle);
    const real d_vy = dx->length_rate * cosine - x->length_rate * sine_times_angle - (d_turn * sine
        + turn * d_sine);
    const real body_mass_plus_foot_mass_2 = dp->body_mass + dp->foot_mass;
    const real d_share = (dp->body_mass - share * body_mass_plus_foot_mass_2) / body_mass_plus_foot_mass;
    const real com_y_minus_share_times_y_minus_height = x->com_y - share * y_2 - x->height;
    const real d_along = (dx->com_x + (d_share * length_times_sine + share * sum_3)) * cos_of_slope
        - sum_2 * sin_of_slope_times_slope + ((dx->com_y - (d_share * y_2 + share * d_y)
        - dx->height) * sin_of_slope + com_y_minus_share_times_y_minus_height * cos_of_slope_times_slope);
    const real sum_6 = dx->com_vx - (d_share * vx + share * d_vx);
    const real sum_7 = dx->com_vy - (d_share * vy + share * d_vy);
    const real sum_8 = sum_6 * cos_of_slope - com_vx_minus_share_times_vx * sin_of_slope_times_slope
        + (sum_7 * sin_of_slope + com_vy_minus_share_times_vy * cos_of_slope_times_slope);
    const real sum_9 = y_2 * sin_of_slope - length_times_sine * cos_of_slope;
    const real sum_10 = y_2 * cos_of_slope + length_times_sine * sin_of_slope;
    const real angle_minus_ratio = dx->angle - (sum_9 * sum_5 - sum_10 * sum_4) / (sum_9 * sum_9
        + sum_10 * sum_10);
    y->x_ = sum_4;
    y->y_ = sum_5;
    y->foot_x = d_along;
    y->winding = angle_minus_ratio;
    if (x->has_hopped > 0.0 && x->time <= x->hop_time) {
        y->vx = d_vx * cos_of_slope - vx * sin_of_slope_times_slope + (d_vy * sin_of_slope
            + vy * cos_of_slope_times_slope);
        y->vy = d_vy * cos_of_slope - vy * sin_of_slope_times_slope - (d_vx * sin_of_slope
            + vx * cos_of_slope_times_slope);
        y->foot_vx = sum_8;
        return;
    }
    const real product_plus_product = com_vx_minus_share_times_vx * cos_of_slope
        + com_vy_minus_share_times_vy * sin_of_slope;
    const real way = select(product_plus_product >= 0.0, 1.0, -1.0);
    const real way_times_product_plus_product = way * product_plus_product;
    const real ends = select(x->segment_end < 1000000000000.0, 1.0, 0.0);
    const real by_1eminus_12_times_free_length = 1e-12 * p->free_length;
    const real sum_11 = sum_2 + by_1eminus_12_times_free_length;
    const real begins = select(x->segment_begin > -1000000000000.0, 1.0, 0.0);
    const real segment_towards = x->segment + ends * select(sum_11 > x->segment_end, 1.0, 0.0)
        - begins * select(sum_11 < x->segment_begin, 1.0, 0.0);
    const real abs_of_segment_towards_minus_by_1 = real_abs(segment_towards - 1.0);
    const real sum_12 = sum_2 - by_1eminus_12_times_free_length;
    const real sum_13 = x->segment + ends * select(sum_12 > x->segment_end, 1.0, 0.0)
        - begins * select(sum_12 < x->segment_begin, 1.0, 0.0);
    const real abs_of_sum_minus_by_1 = real_abs(sum_13 - 1.0);
    const real own = select(way > 0.0, looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        segment_towards, select(abs_of_segment_towards_minus_by_1 > 0.0, -1.0, p->patch_friction)),
        looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, sum_13,
        select(abs_of_sum_minus_by_1 > 0.0, -1.0, p->patch_friction)));
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real by_1_minus_is_own = 1.0 - is_own;
    const real friction_along = is_own * own + by_1_minus_is_own * x->friction;
    const real product_minus_product = com_vy_minus_share_times_vy * cos_of_slope
        - com_vx_minus_share_times_vx * sin_of_slope;
    const real product_2 = friction_along * product_minus_product;
    const real sum_14 = way_times_product_plus_product + product_2;
    const real along = sum_2 * cos_of_slope + com_y_minus_share_times_y_minus_height * sin_of_slope;
    const real along_times_cos_of_slope_plus_product = along * cos_of_slope
        + by_1eminus_12_times_free_length * way;
    const real sum_15 = x->segment + ends * select(along_times_cos_of_slope_plus_product > x->segment_end,
        1.0, 0.0) - begins * select(along_times_cos_of_slope_plus_product < x->segment_begin, 1.0, 0.0);
    const real d_end = select(p->patch_end > p->patch_begin, dp->patch_end, 0.0);
    const real d_begin = select(p->patch_end > p->patch_begin, dp->patch_begin, 0.0);
    const real d_begin_2 = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin,
        seed, sum_15, select(sum_15 > 0.0, select(sum_15 > 1.0, d_end, d_begin), 0.0));
    const real d_end_2 = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, seed,
        sum_15, select(sum_15 > 0.0, select(sum_15 > 1.0, 0.0, d_end), d_begin));
    const real d_height = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height,
        seed, sum_15, 0.0);
    const real d_slope = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, seed,
        sum_15, 0.0);
    const real d_friction = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        seed, segment_towards, select(abs_of_segment_towards_minus_by_1 > 0.0, 0.0, dp->patch_friction));
    const real d_friction_2 = variation_looked_up(tables, TABLE_ground_segment,
        COLUMN_ground_segment_friction, seed, sum_15, select(real_abs(sum_15 - 1.0) > 0.0, 0.0,
        dp->patch_friction));
    const real d_friction_or_d_friction = select(p->keeps_friction > 0.0, d_friction, d_friction_2);
    const real d_friction_3 = variation_looked_up(tables, TABLE_ground_segment,
        COLUMN_ground_segment_friction, seed, sum_13, select(abs_of_sum_minus_by_1 > 0.0, 0.0,
        dp->patch_friction));
    const real d_friction_or_d_friction_2 = select(p->keeps_friction > 0.0, d_friction_3, d_friction_2);
    const real foot_mass_over_body_mass_plus_foot_mass = p->foot_mass / body_mass_plus_foot_mass;
    const real ratio = (dp->foot_mass
        - foot_mass_over_body_mass_plus_foot_mass * body_mass_plus_foot_mass_2) / body_mass_plus_foot_mass;
    const real com_vx_plus_ratio_times_vx_plus_product = dx->com_vx + (ratio * vx
        + foot_mass_over_body_mass_plus_foot_mass * d_vx);
    const real com_vx_plus_product = x->com_vx + foot_mass_over_body_mass_plus_foot_mass * vx;
    const real com_vy_plus_ratio_times_vy_plus_product = dx->com_vy + (ratio * vy
        + foot_mass_over_body_mass_plus_foot_mass * d_vy);
    const real com_vy_plus_product = x->com_vy + foot_mass_over_body_mass_plus_foot_mass * vy;
    const real sum_16 = com_vx_plus_ratio_times_vx_plus_product * cos_of_slope
        - com_vx_plus_product * sin_of_slope_times_slope
        + (com_vy_plus_ratio_times_vy_plus_product * sin_of_slope
        + com_vy_plus_product * cos_of_slope_times_slope);
    const real sum_17 = sum_7 * cos_of_slope - com_vy_minus_share_times_vy * sin_of_slope_times_slope
        - (sum_6 * sin_of_slope + com_vx_minus_share_times_vx * cos_of_slope_times_slope);
    const real d_own = select(way > 0.0, d_friction, d_friction_3);
    const real d_friction_along = is_own * d_own + by_1_minus_is_own * dx->friction;
    const real product_plus_friction_along_times_sum = d_friction_along * product_minus_product
        + friction_along * sum_17;
    const real sum_18 = way * sum_8 + product_plus_friction_along_times_sum;
    const real sum_19 = com_vy_plus_ratio_times_vy_plus_product * cos_of_slope
        - com_vy_plus_product * sin_of_slope_times_slope
        - (com_vx_plus_ratio_times_vx_plus_product * sin_of_slope
        + com_vx_plus_product * cos_of_slope_times_slope);
    const real product_plus_product_2 = product_plus_product * product_plus_product
        + product_minus_product * product_minus_product;
    const real product_plus_product_3 = 2.0 * (product_plus_product * sum_8)
        + 2.0 * (product_minus_product * sum_17);
    y->touchdowns_so_far = dx->touchdowns_so_far;
    y->slid_from = d_along;
    y->bar_is_due = 0.0;
    y->vy = sum_19;
    y->driving = 0.0;
    y->placing = 0.0;
    y->touchdown_time = dx->time;
    y->was_placed = 0.0;
    y->placed_for = dx->placing;
    if (p->stribeck_velocity > 0.0 && p->static_ratio > 1.0) {
        const real static_ratio_minus_by_1 = p->static_ratio - 1.0;
        const real product_over_stribeck_velocity = product_2 / p->stribeck_velocity;
        const real expm1_of_product_over_stribeck_velocity = real_expm1(product_over_stribeck_velocity);
        const real product_3 = static_ratio_minus_by_1 * expm1_of_product_over_stribeck_velocity;
        const real gained = -product_3;
        const real stopped_speed = p->stribeck_velocity * real_log1p(gained) - product_2;
        const real sum_over_stribeck_velocity = sum_14 / p->stribeck_velocity;
        const real exp_of_minus_sum_over_stribeck_velocity = real_exp(-sum_over_stribeck_velocity);
        const real product_4 = product_3 * exp_of_minus_sum_over_stribeck_velocity;
        const real log1p_of_product = real_log1p(product_4);
        const real left = sum_14 + p->stribeck_velocity * log1p_of_product;
        const real speed_left = select(left > 0.0, left, 0.0);
        const real speed_after_impact = select(way_times_product_plus_product <= stopped_speed, 0.0,
            speed_left);
        const real after_2 = way * speed_after_impact;
        const real d_left = sum_18 + (dp->stribeck_velocity * log1p_of_product
            + p->stribeck_velocity * (((dp->static_ratio * expm1_of_product_over_stribeck_velocity
            + static_ratio_minus_by_1 * ((expm1_of_product_over_stribeck_velocity
            + 1.0) * ((product_plus_friction_along_times_sum
            - product_over_stribeck_velocity * dp->stribeck_velocity) / p->stribeck_velocity))) *
            exp_of_minus_sum_over_stribeck_velocity
            - product_3 * (exp_of_minus_sum_over_stribeck_velocity * ((sum_18
            - sum_over_stribeck_velocity * dp->stribeck_velocity) / p->stribeck_velocity))) / (1.0
            + product_4)));
        const real d_speed_left = select(left > 0.0, d_left, 0.0);
        const real d_speed_after_impact = select(way_times_product_plus_product <= stopped_speed, 0.0,
            d_speed_left);
        const real d_after = way * d_speed_after_impact;
        const real sum_minus_d_after = sum_16 - d_after;
        const real speeds = product_plus_product_2 - after_2 * after_2;
        const real d_speeds = product_plus_product_3 - 2.0 * (after_2 * d_after);
        const real impact_loss_plus_by_0_5_times_sum = dx->impact_loss + 0.5 * (dp->foot_mass * speeds
            + p->foot_mass * d_speeds);
        y->vx = sum_minus_d_after;
        y->foot_vx = d_after;
        y->impact_loss = impact_loss_plus_by_0_5_times_sum;
        if (way * after_2 > 0.0) {
            y->segment = dx->segment;
            y->segment_begin = d_begin_2;
            y->segment_end = d_end_2;
            y->segment_height = d_height;
            y->segment_slope = d_slope;
            y->friction_ahead = d_friction_or_d_friction;
            y->friction_behind = d_friction_or_d_friction_2;
            y->way = 0.0;
            return;
        }
        y->friction_ahead = d_friction;
        y->friction_behind = d_friction_3;
        return;
    }
    const real minus_static_ratio_times_product = -(p->static_ratio * product_2);
    const real way_times_by_0_or_sum = way * select(way_times_product_plus_product <=
        minus_static_ratio_times_product, 0.0, sum_14);
    const real way_times_by_0_or_sum_2 = way * select(way_times_product_plus_product <=
        minus_static_ratio_times_product, 0.0, sum_18);
    const real sum_minus_way_times_by_0_or_sum = sum_16 - way_times_by_0_or_sum_2;
    const real impact_loss_plus_product = dx->impact_loss + 0.5 * (dp->foot_mass * (product_plus_product_2
        - way_times_by_0_or_sum * way_times_by_0_or_sum) + p->foot_mass * (product_plus_product_3
        - 2.0 * (way_times_by_0_or_sum * way_times_by_0_or_sum_2)));
    y->vx = sum_minus_way_times_by_0_or_sum;
    y->foot_vx = way_times_by_0_or_sum_2;
    y->impact_loss = impact_loss_plus_product;
    if (way * way_times_by_0_or_sum > 0.0) {
        y->segment = dx->segment;
        y->segment_begin = d_begin_2;
        y->segment_end = d_end_2;
        y->segment_height = d_height;
        y->segment_slope = d_slope;
        y->friction_ahead = d_friction_or_d_friction;
        y->friction_behind = d_friction_or_d_friction_2;
        y->way = 0.0;
        return;
    }
    y->friction_ahead = d_friction;
    y->friction_behind = d_friction_3;
}

/* First variation of the guard of touchdown. */
static real vary_guard_flight_calm_touchdown(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real cos_of_slope = real_cos(x->slope);
    const real sin_of_slope = real_sin(x->slope);
    const real d_level = cos_of_slope * (dx->com_y - dx->height) - sin_of_slope * dx->slope * (x->com_y
        - x->height) - (cos_of_slope * dx->slope * x->com_x + sin_of_slope * dx->com_x);
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real angle_minus_slope = x->angle - x->slope;
    const real d_above = d_level - ((d_share * x->length + share * dx->length) * real_cos(angle_minus_slope)
        - share * x->length * (real_sin(angle_minus_slope) * (dx->angle - dx->slope)));
    return d_above;
}

/* clamp: The clamp of the hip torque closes: it holds the retracting torque at 0. */
static int react_flight_calm_clamp(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->swing = 0.0;
    return next[0]; /* flight */
}

/* First variation of clamp. */
static void vary_react_flight_calm_clamp(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const tdmf_table *tables, int seed, real *after) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed;
    y->swing = 0.0;
}

/* True if clamp is watched. */
static real watches_flight_calm_clamp(const real *parameters, const real *states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    if (p->swing_clamp > 0.0 && real_abs(x->swing - 1.0) <= 0.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of clamp. */
static real vary_guard_flight_calm_clamp(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real d_square = 2.0 * (x->length * dx->length);
    const real d_rate = (dx->momentum - rate * d_square) / square;
    const real d_servo = -(dp->kp * (x->angle - p->liftoff_factor * x->liftoff_angle) + p->kp * (dx->angle
        - (dp->liftoff_factor * x->liftoff_angle + p->liftoff_factor * dx->liftoff_angle))) - (dp->kd * rate
        + p->kd * d_rate);
    return d_servo;
}

/* release: The clamp of the hip torque opens: it releases the retracting torque. */
static int react_flight_calm_release(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->swing = 1.0;
    return next[0]; /* flight */
}

/* True if release is watched. */
static real watches_flight_calm_release(const real *parameters, const real *states) {
    const runner_states *x = (const void *)states;
    (void)parameters;
    if (x->swing < 1.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of release. */
static real vary_guard_flight_calm_release(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real d_square = 2.0 * (x->length * dx->length);
    const real d_rate = (dx->momentum - rate * d_square) / square;
    const real d_servo = -(dp->kp * (x->angle - p->liftoff_factor * x->liftoff_angle) + p->kp * (dx->angle
        - (dp->liftoff_factor * x->liftoff_angle + p->liftoff_factor * dx->liftoff_angle))) - (dp->kd * rate
        + p->kd * d_rate);
    return -d_servo;
}

/* Outputs in flight_calm. */
static void outputs_flight_calm(const real *parameters, const real *states, real *outputs) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const real set_height = p->ground_height + x->segment_height;
    const real set_slope = p->ground_slope + x->segment_slope;
    const real pending = select(real_abs(set_height - x->height) + real_abs(p->free_length * (set_slope
        - x->slope)) > 0.0, 1.0, 0.0);
    const real share = select(x->swing > 0.0, 1.0, 0.0);
    const real placing_angle = p->touchdown_angle + p->more_angle;
    const real first = select(x->swing < 2.0, p->liftoff_factor * x->liftoff_angle, placing_angle);
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real turn = p->retraction_rate * is_placing;
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real servo = -(p->kp * share * (x->angle - (first - turn * x->placing))) - p->kd * share * (rate
        + turn);
    const real swing_torque = x->external_torque + servo;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real shorter = rest_length - x->length;
    const real spring = p->stiffness * shorter - p->damping * x->length_rate;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real foot_mass_over_body_mass_plus_foot_mass = p->foot_mass / body_mass_plus_foot_mass;
    const real sin_of_angle = real_sin(x->angle);
    const real body_x = x->com_x - foot_mass_over_body_mass_plus_foot_mass * (x->length * sin_of_angle);
    const real cos_of_angle = real_cos(x->angle);
    const real y_2 = x->length * cos_of_angle;
    const real body_y = x->com_y + foot_mass_over_body_mass_plus_foot_mass * y_2;
    const real momentum_over_length = x->momentum / x->length;
    const real vx = -(x->length_rate * sin_of_angle) - momentum_over_length * cos_of_angle;
    const real body_vx = x->com_vx + foot_mass_over_body_mass_plus_foot_mass * vx;
    const real vy = x->length_rate * cos_of_angle - momentum_over_length * sin_of_angle;
    const real body_vy = x->com_vy + foot_mass_over_body_mass_plus_foot_mass * vy;
    const real of_body = p->body_mass * (body_vx * body_vx + body_vy * body_vy);
    const real body_mass_over_body_mass_plus_foot_mass = p->body_mass / body_mass_plus_foot_mass;
    const real com_vx_minus_product = x->com_vx - body_mass_over_body_mass_plus_foot_mass * vx;
    const real com_vy_minus_product = x->com_vy - body_mass_over_body_mass_plus_foot_mass * vy;
    const real kinetic_energy = 0.5 * (of_body + p->foot_mass * (com_vx_minus_product * com_vx_minus_product
        + com_vy_minus_product * com_vy_minus_product));
    const real potential_energy = p->gravity * (p->body_mass * body_y + p->foot_mass * (x->com_y
        - body_mass_over_body_mass_plus_foot_mass * y_2));
    const real elastic_energy = 0.5 * (p->stiffness * (shorter * shorter));
    const real energy = kinetic_energy + potential_energy + elastic_energy;
    const real phase_of_hip = select(x->swing < 2.0, 3.0, 4.0);
    outputs[OUTPUT_pending] = pending;
    outputs[OUTPUT_torque] = swing_torque;
    outputs[OUTPUT_normal_force] = 0.0;
    outputs[OUTPUT_tangential_force] = 0.0;
    outputs[OUTPUT_ground_force_x] = 0.0;
    outputs[OUTPUT_ground_force_y] = 0.0;
    outputs[OUTPUT_force_of_leg] = spring;
    outputs[OUTPUT_body_x] = body_x;
    outputs[OUTPUT_body_y] = body_y;
    outputs[OUTPUT_body_vx] = body_vx;
    outputs[OUTPUT_body_vy] = body_vy;
    outputs[OUTPUT_center_x] = x->com_x;
    outputs[OUTPUT_center_y] = x->com_y;
    outputs[OUTPUT_center_vx] = x->com_vx;
    outputs[OUTPUT_center_vy] = x->com_vy;
    outputs[OUTPUT_kinetic_energy] = kinetic_energy;
    outputs[OUTPUT_potential_energy] = potential_energy;
    outputs[OUTPUT_elastic_energy] = elastic_energy;
    outputs[OUTPUT_energy] = energy;
    outputs[OUTPUT_kind_of_contact] = 1.0;
    outputs[OUTPUT_phase_of_hip] = phase_of_hip;
}

/* First variation of outputs_flight_calm. */
static void vary_outputs_flight_calm(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *outputs) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real share = select(x->swing > 0.0, 1.0, 0.0);
    const real placing_angle = p->touchdown_angle + p->more_angle;
    const real first = select(x->swing < 2.0, p->liftoff_factor * x->liftoff_angle, placing_angle);
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real turn = p->retraction_rate * is_placing;
    const real d_placing_angle = dp->touchdown_angle + dp->more_angle;
    const real d_first = select(x->swing < 2.0, dp->liftoff_factor * x->liftoff_angle
        + p->liftoff_factor * dx->liftoff_angle, d_placing_angle);
    const real d_turn = dp->retraction_rate * is_placing;
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real d_square = 2.0 * (x->length * dx->length);
    const real d_rate = (dx->momentum - rate * d_square) / square;
    const real d_servo = -(dp->kp * share * (x->angle - (first - turn * x->placing))
        + p->kp * share * (dx->angle - (d_first - (d_turn * x->placing + turn * dx->placing))))
        - (dp->kd * share * (rate + turn) + p->kd * share * (d_rate + d_turn));
    const real d_swing_torque = dx->external_torque + d_servo;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real shorter = rest_length - x->length;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_shorter = d_rest_length - dx->length;
    const real d_spring = dp->stiffness * shorter + p->stiffness * d_shorter - (dp->damping * x->length_rate
        + p->damping * dx->length_rate);
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real foot_mass_over_body_mass_plus_foot_mass = p->foot_mass / body_mass_plus_foot_mass;
    const real body_mass_plus_foot_mass_2 = dp->body_mass + dp->foot_mass;
    const real ratio = (dp->foot_mass
        - foot_mass_over_body_mass_plus_foot_mass * body_mass_plus_foot_mass_2) / body_mass_plus_foot_mass;
    const real sin_of_angle = real_sin(x->angle);
    const real cos_of_angle = real_cos(x->angle);
    const real cos_of_angle_times_angle = cos_of_angle * dx->angle;
    const real d_body_x = dx->com_x - (ratio * (x->length * sin_of_angle)
        + foot_mass_over_body_mass_plus_foot_mass * (dx->length * sin_of_angle
        + x->length * cos_of_angle_times_angle));
    const real y_2 = x->length * cos_of_angle;
    const real sin_of_angle_times_angle = sin_of_angle * dx->angle;
    const real d_y = dx->length * cos_of_angle - x->length * sin_of_angle_times_angle;
    const real d_body_y = dx->com_y + (ratio * y_2 + foot_mass_over_body_mass_plus_foot_mass * d_y);
    const real momentum_over_length = x->momentum / x->length;
    const real vx = -(x->length_rate * sin_of_angle) - momentum_over_length * cos_of_angle;
    const real sum_over_length = (dx->momentum - momentum_over_length * dx->length) / x->length;
    const real d_vx = -(dx->length_rate * sin_of_angle + x->length_rate * cos_of_angle_times_angle)
        - (sum_over_length * cos_of_angle - momentum_over_length * sin_of_angle_times_angle);
    const real d_body_vx = dx->com_vx + (ratio * vx + foot_mass_over_body_mass_plus_foot_mass * d_vx);
    const real vy = x->length_rate * cos_of_angle - momentum_over_length * sin_of_angle;
    const real d_vy = dx->length_rate * cos_of_angle - x->length_rate * sin_of_angle_times_angle
        - (sum_over_length * sin_of_angle + momentum_over_length * cos_of_angle_times_angle);
    const real d_body_vy = dx->com_vy + (ratio * vy + foot_mass_over_body_mass_plus_foot_mass * d_vy);
    const real body_vx = x->com_vx + foot_mass_over_body_mass_plus_foot_mass * vx;
    const real body_vy = x->com_vy + foot_mass_over_body_mass_plus_foot_mass * vy;
    const real d_of_body = dp->body_mass * (body_vx * body_vx + body_vy * body_vy)
        + p->body_mass * (2.0 * (body_vx * d_body_vx) + 2.0 * (body_vy * d_body_vy));
    const real body_mass_over_body_mass_plus_foot_mass = p->body_mass / body_mass_plus_foot_mass;
    const real com_vx_minus_product = x->com_vx - body_mass_over_body_mass_plus_foot_mass * vx;
    const real com_vy_minus_product = x->com_vy - body_mass_over_body_mass_plus_foot_mass * vy;
    const real ratio_2 = (dp->body_mass
        - body_mass_over_body_mass_plus_foot_mass * body_mass_plus_foot_mass_2) / body_mass_plus_foot_mass;
    const real d_kinetic_energy = 0.5 * (d_of_body
        + (dp->foot_mass * (com_vx_minus_product * com_vx_minus_product
        + com_vy_minus_product * com_vy_minus_product)
        + p->foot_mass * (2.0 * (com_vx_minus_product * (dx->com_vx - (ratio_2 * vx
        + body_mass_over_body_mass_plus_foot_mass * d_vx))) + 2.0 * (com_vy_minus_product * (dx->com_vy
        - (ratio_2 * vy + body_mass_over_body_mass_plus_foot_mass * d_vy))))));
    const real body_y = x->com_y + foot_mass_over_body_mass_plus_foot_mass * y_2;
    const real com_y_minus_product = x->com_y - body_mass_over_body_mass_plus_foot_mass * y_2;
    const real d_potential_energy = dp->gravity * (p->body_mass * body_y
        + p->foot_mass * com_y_minus_product) + p->gravity * (dp->body_mass * body_y
        + p->body_mass * d_body_y + (dp->foot_mass * com_y_minus_product + p->foot_mass * (dx->com_y
        - (ratio_2 * y_2 + body_mass_over_body_mass_plus_foot_mass * d_y))));
    const real d_elastic_energy = 0.5 * (dp->stiffness * (shorter * shorter)
        + p->stiffness * (2.0 * (shorter * d_shorter)));
    const real d_energy = d_kinetic_energy + d_potential_energy + d_elastic_energy;
    outputs[OUTPUT_pending] = 0.0;
    outputs[OUTPUT_torque] = d_swing_torque;
    outputs[OUTPUT_normal_force] = 0.0;
    outputs[OUTPUT_tangential_force] = 0.0;
    outputs[OUTPUT_ground_force_x] = 0.0;
    outputs[OUTPUT_ground_force_y] = 0.0;
    outputs[OUTPUT_force_of_leg] = d_spring;
    outputs[OUTPUT_body_x] = d_body_x;
    outputs[OUTPUT_body_y] = d_body_y;
    outputs[OUTPUT_body_vx] = d_body_vx;
    outputs[OUTPUT_body_vy] = d_body_vy;
    outputs[OUTPUT_center_x] = dx->com_x;
    outputs[OUTPUT_center_y] = dx->com_y;
    outputs[OUTPUT_center_vx] = dx->com_vx;
    outputs[OUTPUT_center_vy] = dx->com_vy;
    outputs[OUTPUT_kinetic_energy] = d_kinetic_energy;
    outputs[OUTPUT_potential_energy] = d_potential_energy;
    outputs[OUTPUT_elastic_energy] = d_elastic_energy;
    outputs[OUTPUT_energy] = d_energy;
    outputs[OUTPUT_kind_of_contact] = 0.0;
    outputs[OUTPUT_phase_of_hip] = 0.0;
}

/* from world, in flight. */
static void from_world_flight_calm(const real *parameters, const real *states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real sine = real_sin(x->angle);
    const real cosine = real_cos(x->angle);
    const real y_2 = x->length * cosine;
    const real turn = x->length * x->angle_rate;
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real vy = x->length_rate * cosine - turn * sine;
    const real square = x->length * x->length;
    const real moment = square * x->angle_rate;
    y->com_x = x->seen_x - share * (x->length * sine);
    y->com_y = x->seen_y + share * y_2;
    y->com_vx = x->seen_vx + share * vx;
    y->com_vy = x->seen_vy + share * vy;
    y->momentum = moment;
}

/* First variation of from_world_flight_calm. */
static void vary_from_world_flight_calm(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real sine = real_sin(x->angle);
    const real cosine = real_cos(x->angle);
    const real d_sine = cosine * dx->angle;
    const real y_2 = x->length * cosine;
    const real sine_times_angle = sine * dx->angle;
    const real d_y = dx->length * cosine - x->length * sine_times_angle;
    const real turn = x->length * x->angle_rate;
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real d_turn = dx->length * x->angle_rate + x->length * dx->angle_rate;
    const real d_vx = -(dx->length_rate * sine + x->length_rate * d_sine) - (d_turn * cosine
        - turn * sine_times_angle);
    const real vy = x->length_rate * cosine - turn * sine;
    const real d_vy = dx->length_rate * cosine - x->length_rate * sine_times_angle - (d_turn * sine
        + turn * d_sine);
    const real d_square = 2.0 * (x->length * dx->length);
    const real square = x->length * x->length;
    const real d_moment = d_square * x->angle_rate + square * dx->angle_rate;
    y->com_x = dx->seen_x - (d_share * (x->length * sine) + share * (dx->length * sine + x->length * d_sine));
    y->com_y = dx->seen_y + (d_share * y_2 + share * d_y);
    y->com_vx = dx->seen_vx + (d_share * vx + share * d_vx);
    y->com_vy = dx->seen_vy + (d_share * vy + share * d_vy);
    y->momentum = d_moment;
}

/* to world, in flight. */
static void to_world_flight_calm(const real *parameters, const real *states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real sine = real_sin(x->angle);
    const real cosine = real_cos(x->angle);
    const real y_2 = x->length * cosine;
    const real turn = x->momentum / x->length;
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real vy = x->length_rate * cosine - turn * sine;
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    y->seen_x = x->com_x + share * (x->length * sine);
    y->seen_y = x->com_y - share * y_2;
    y->seen_vx = x->com_vx - share * vx;
    y->seen_vy = x->com_vy - share * vy;
    y->angle_rate = rate;
}

/* First variation of to_world_flight_calm. */
static void vary_to_world_flight_calm(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real sine = real_sin(x->angle);
    const real cosine = real_cos(x->angle);
    const real d_sine = cosine * dx->angle;
    const real y_2 = x->length * cosine;
    const real sine_times_angle = sine * dx->angle;
    const real d_y = dx->length * cosine - x->length * sine_times_angle;
    const real turn = x->momentum / x->length;
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real d_turn = (dx->momentum - turn * dx->length) / x->length;
    const real d_vx = -(dx->length_rate * sine + x->length_rate * d_sine) - (d_turn * cosine
        - turn * sine_times_angle);
    const real vy = x->length_rate * cosine - turn * sine;
    const real d_vy = dx->length_rate * cosine - x->length_rate * sine_times_angle - (d_turn * sine
        + turn * d_sine);
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real d_square = 2.0 * (x->length * dx->length);
    const real d_rate = (dx->momentum - rate * d_square) / square;
    y->seen_x = dx->com_x + (d_share * (x->length * sine) + share * (dx->length * sine + x->length * d_sine));
    y->seen_y = dx->com_y - (d_share * y_2 + share * d_y);
    y->seen_vx = dx->com_vx - (d_share * vx + share * d_vx);
    y->seen_vy = dx->com_vy - (d_share * vy + share * d_vy);
    y->angle_rate = d_rate;
}

/* Rates of the world's states in flight. */
static void world_rates_flight_calm(const real *parameters, const real *states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real sine = real_sin(x->angle);
    const real cosine = real_cos(x->angle);
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real cosine_times_rate = cosine * rate;
    const real sine_times_rate = sine * rate;
    const real mobility = 1.0 / p->body_mass + 1.0 / p->foot_mass;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real spring = p->stiffness * (rest_length - x->length) - p->damping * x->length_rate;
    const real sum_2 = x->length * (rate * rate) + mobility * spring;
    const real by_1_or_by_0 = select(x->swing > 0.0, 1.0, 0.0);
    const real placing_angle = p->touchdown_angle + p->more_angle;
    const real first = select(x->swing < 2.0, p->liftoff_factor * x->liftoff_angle, placing_angle);
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real retraction_rate_times_is_placing = p->retraction_rate * is_placing;
    const real servo = -(p->kp * by_1_or_by_0 * (x->angle - (first
        - retraction_rate_times_is_placing * x->placing))) - p->kd * by_1_or_by_0 * (rate
        + retraction_rate_times_is_placing);
    const real swing_torque = x->external_torque + servo;
    const real mobility_times_swing_torque = mobility * swing_torque;
    const real turn = x->momentum / x->length;
    const real sum_over_length = (mobility_times_swing_torque - turn * x->length_rate) / x->length;
    y->seen_x = x->com_vx + share * (x->length_rate * sine + x->length * cosine_times_rate);
    y->seen_y = x->com_vy - share * (x->length_rate * cosine - x->length * sine_times_rate);
    y->seen_vx = -(share * (-(sum_2 * sine + x->length_rate * cosine_times_rate) - (sum_over_length * cosine
        - turn * sine_times_rate)));
    y->seen_vy = -p->gravity - share * (sum_2 * cosine - x->length_rate * sine_times_rate
        - (sum_over_length * sine + turn * cosine_times_rate));
    y->length = x->length_rate;
    y->angle = rate;
    y->length_rate = sum_2;
    y->angle_rate = (mobility_times_swing_torque - rate * (2.0 * (x->length * x->length_rate))) / square;
}

/* First variation of world_rates_flight_calm. */
static void vary_world_rates_flight_calm(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real sine = real_sin(x->angle);
    const real cosine = real_cos(x->angle);
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real cosine_times_rate = cosine * rate;
    const real d_sine = cosine * dx->angle;
    const real d_square = 2.0 * (x->length * dx->length);
    const real d_rate = (dx->momentum - rate * d_square) / square;
    const real sine_times_angle = sine * dx->angle;
    const real sum_2 = cosine * d_rate - sine_times_angle * rate;
    const real sine_times_rate = sine * rate;
    const real sum_3 = d_sine * rate + sine * d_rate;
    const real rate_times_rate = rate * rate;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real mobility = inverse_body_mass + inverse_foot_mass;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real rest_length_minus_length = rest_length - x->length;
    const real spring = p->stiffness * rest_length_minus_length - p->damping * x->length_rate;
    const real sum_4 = x->length * rate_times_rate + mobility * spring;
    const real by_1_or_by_0 = select(x->swing > 0.0, 1.0, 0.0);
    const real kp_times_by_1_or_by_0 = p->kp * by_1_or_by_0;
    const real placing_angle = p->touchdown_angle + p->more_angle;
    const real first = select(x->swing < 2.0, p->liftoff_factor * x->liftoff_angle, placing_angle);
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real retraction_rate_times_is_placing = p->retraction_rate * is_placing;
    const real angle_minus_first_minus_product = x->angle - (first
        - retraction_rate_times_is_placing * x->placing);
    const real kd_times_by_1_or_by_0 = p->kd * by_1_or_by_0;
    const real sum_5 = rate + retraction_rate_times_is_placing;
    const real servo = -(kp_times_by_1_or_by_0 * angle_minus_first_minus_product)
        - kd_times_by_1_or_by_0 * sum_5;
    const real swing_torque = x->external_torque + servo;
    const real mobility_times_swing_torque = mobility * swing_torque;
    const real turn = x->momentum / x->length;
    const real sum_over_length = (mobility_times_swing_torque - turn * x->length_rate) / x->length;
    const real d_mobility = -(inverse_body_mass * dp->body_mass / p->body_mass)
        - inverse_foot_mass * dp->foot_mass / p->foot_mass;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_spring = dp->stiffness * rest_length_minus_length + p->stiffness * (d_rest_length
        - dx->length) - (dp->damping * x->length_rate + p->damping * dx->length_rate);
    const real sum_plus_sum = dx->length * rate_times_rate + x->length * (2.0 * (rate * d_rate))
        + (d_mobility * spring + mobility * d_spring);
    const real d_placing_angle = dp->touchdown_angle + dp->more_angle;
    const real d_first = select(x->swing < 2.0, dp->liftoff_factor * x->liftoff_angle
        + p->liftoff_factor * dx->liftoff_angle, d_placing_angle);
    const real retraction_rate_times_is_placing_2 = dp->retraction_rate * is_placing;
    const real d_servo = -(dp->kp * by_1_or_by_0 * angle_minus_first_minus_product
        + kp_times_by_1_or_by_0 * (dx->angle - (d_first - (retraction_rate_times_is_placing_2 * x->placing
        + retraction_rate_times_is_placing * dx->placing)))) - (dp->kd * by_1_or_by_0 * sum_5
        + kd_times_by_1_or_by_0 * (d_rate + retraction_rate_times_is_placing_2));
    const real d_swing_torque = dx->external_torque + d_servo;
    const real sum_6 = d_mobility * swing_torque + mobility * d_swing_torque;
    const real d_turn = (dx->momentum - turn * dx->length) / x->length;
    const real sum_over_length_2 = (sum_6 - (d_turn * x->length_rate + turn * dx->length_rate)
        - sum_over_length * dx->length) / x->length;
    const real by_2_times_length_times_length_rate = 2.0 * (x->length * x->length_rate);
    y->seen_x = dx->com_vx + (d_share * (x->length_rate * sine + x->length * cosine_times_rate)
        + share * (dx->length_rate * sine + x->length_rate * d_sine + (dx->length * cosine_times_rate
        + x->length * sum_2)));
    y->seen_y = dx->com_vy - (d_share * (x->length_rate * cosine - x->length * sine_times_rate)
        + share * (dx->length_rate * cosine - x->length_rate * sine_times_angle
        - (dx->length * sine_times_rate + x->length * sum_3)));
    y->seen_vx = -(d_share * (-(sum_4 * sine + x->length_rate * cosine_times_rate)
        - (sum_over_length * cosine - turn * sine_times_rate)) + share * (-(sum_plus_sum * sine
        + sum_4 * d_sine + (dx->length_rate * cosine_times_rate + x->length_rate * sum_2))
        - (sum_over_length_2 * cosine - sum_over_length * sine_times_angle - (d_turn * sine_times_rate
        + turn * sum_3))));
    y->seen_vy = -dp->gravity - (d_share * (sum_4 * cosine - x->length_rate * sine_times_rate
        - (sum_over_length * sine + turn * cosine_times_rate)) + share * (sum_plus_sum * cosine
        - sum_4 * sine_times_angle - (dx->length_rate * sine_times_rate + x->length_rate * sum_3)
        - (sum_over_length_2 * sine + sum_over_length * d_sine + (d_turn * cosine_times_rate
        + turn * sum_2))));
    y->length = dx->length_rate;
    y->angle = d_rate;
    y->length_rate = sum_plus_sum;
    y->angle_rate = (sum_6 - (d_rate * by_2_times_length_times_length_rate
        + rate * (2.0 * (dx->length * x->length_rate + x->length * dx->length_rate)))
        - (mobility_times_swing_torque
        - rate * by_2_times_length_times_length_rate) / square * d_square) / square;
}

/* Constants of fallen. */
static void open_fallen(const real *parameters, const real *states, real *constants) {
    (void)parameters, (void)states, (void)constants;
}

/* First variation of open_fallen. */
static void vary_open_fallen(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)constants;
}

/* Constants of graze. */
static void open_graze(const real *parameters, const real *states, real *constants) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    graze_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real longer = p->thrust + p->more_thrust;
    const real thrusting_times_longer_or_by_0 = x->thrusting * select(longer >= 0.0, longer, 0.0);
    const real cosine = real_cos(x->slope);
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real off = foot_mass_times_gravity * cosine;
    const real sine = real_sin(x->slope);
    const real gravity_times_sine = p->gravity * sine;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real along = foot_mass_times_gravity * sine;
    const real gravity_times_cosine = p->gravity * cosine;
    const real stiffness_times_extension_rate = p->stiffness * x->extension_rate;
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real liftoff_factor_times_liftoff_angle = p->liftoff_factor * x->liftoff_angle;
    const real product_2 = x->driving * (p->drive_torque + p->more_torque);
    const real by_1_or_by_0 = select(x->swing > 0.0, 1.0, 0.0);
    const real by_1_or_by_0_times_kp = by_1_or_by_0 * p->kp;
    const real placing_angle = p->touchdown_angle + p->more_angle;
    const real first = select(x->swing < 2.0, liftoff_factor_times_liftoff_angle, placing_angle);
    const real turn = is_placing * p->retraction_rate;
    const real by_1_or_by_0_times_kd = by_1_or_by_0 * p->kd;
    c->inverse_body_mass = inverse_body_mass;
    c->stiffness = p->stiffness;
    c->free_length = p->free_length;
    c->thrusting_times_longer_or_by_0 = thrusting_times_longer_or_by_0;
    c->damping = p->damping;
    c->cosine = cosine;
    c->off = off;
    c->sine = sine;
    c->gravity_times_sine = gravity_times_sine;
    c->inverse_foot_mass = inverse_foot_mass;
    c->along = along;
    c->gravity_times_cosine = gravity_times_cosine;
    c->extension_rate = x->extension_rate;
    c->stiffness_times_extension_rate = stiffness_times_extension_rate;
    c->external_fx_rate = x->external_fx_rate;
    c->external_fy_rate = x->external_fy_rate;
    c->friction_rate = x->friction_rate;
    c->external_torque_rate = x->external_torque_rate;
    c->is_placing = is_placing;
    c->segment_end = x->segment_end;
    c->segment_begin = x->segment_begin;
    c->least_length = p->least_length;
    c->share = share;
    c->kp = p->kp;
    c->winding = x->winding;
    c->liftoff_factor_times_liftoff_angle = liftoff_factor_times_liftoff_angle;
    c->kd = p->kd;
    c->product_2 = product_2;
    c->by_1_or_by_0_times_kp = by_1_or_by_0_times_kp;
    c->first = first;
    c->turn = turn;
    c->by_1_or_by_0_times_kd = by_1_or_by_0_times_kd;
}

/* First variation of open_graze. */
static void vary_open_graze(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    graze_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real d_inverse_body_mass = -(inverse_body_mass * dp->body_mass / p->body_mass);
    const real longer = p->thrust + p->more_thrust;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_thrusting_times_longer_or_by_0 = select(longer >= 0.0, longer, 0.0) * dx->thrusting
        + x->thrusting * select(longer >= 0.0, d_longer, 0.0);
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_cosine = -sine_times_slope;
    const real cosine = real_cos(x->slope);
    const real sum_2 = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real d_off = cosine * sum_2 - foot_mass_times_gravity * sine_times_slope;
    const real d_sine = cosine * dx->slope;
    const real d_gravity_times_sine = sine * dp->gravity + p->gravity * d_sine;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real d_inverse_foot_mass = -(inverse_foot_mass * dp->foot_mass / p->foot_mass);
    const real d_along = sine * sum_2 + foot_mass_times_gravity * d_sine;
    const real d_gravity_times_cosine = cosine * dp->gravity - p->gravity * sine_times_slope;
    const real d_stiffness_times_extension_rate = x->extension_rate * dp->stiffness
        + p->stiffness * dx->extension_rate;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_liftoff_factor_times_liftoff_angle = x->liftoff_angle * dp->liftoff_factor
        + p->liftoff_factor * dx->liftoff_angle;
    const real by_1_or_by_0 = select(x->swing > 0.0, 1.0, 0.0);
    const real d_by_1_or_by_0_times_kp = by_1_or_by_0 * dp->kp;
    const real d_placing_angle = dp->touchdown_angle + dp->more_angle;
    const real d_first = select(x->swing < 2.0, d_liftoff_factor_times_liftoff_angle, d_placing_angle);
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real d_turn = is_placing * dp->retraction_rate;
    const real d_by_1_or_by_0_times_kd = by_1_or_by_0 * dp->kd;
    c->inverse_body_mass = d_inverse_body_mass;
    c->stiffness = dp->stiffness;
    c->free_length = dp->free_length;
    c->thrusting_times_longer_or_by_0 = d_thrusting_times_longer_or_by_0;
    c->damping = dp->damping;
    c->cosine = d_cosine;
    c->off = d_off;
    c->sine = d_sine;
    c->gravity_times_sine = d_gravity_times_sine;
    c->inverse_foot_mass = d_inverse_foot_mass;
    c->along = d_along;
    c->gravity_times_cosine = d_gravity_times_cosine;
    c->extension_rate = dx->extension_rate;
    c->stiffness_times_extension_rate = d_stiffness_times_extension_rate;
    c->external_fx_rate = dx->external_fx_rate;
    c->external_fy_rate = dx->external_fy_rate;
    c->friction_rate = dx->friction_rate;
    c->external_torque_rate = dx->external_torque_rate;
    c->is_placing = 0.0;
    c->segment_end = dx->segment_end;
    c->segment_begin = dx->segment_begin;
    c->least_length = dp->least_length;
    c->share = d_share;
    c->kp = dp->kp;
    c->winding = dx->winding;
    c->liftoff_factor_times_liftoff_angle = d_liftoff_factor_times_liftoff_angle;
    c->kd = dp->kd;
    c->product_2 = (p->drive_torque + p->more_torque) * dx->driving + x->driving * (dp->drive_torque
        + dp->more_torque);
    c->by_1_or_by_0_times_kp = d_by_1_or_by_0_times_kp;
    c->first = d_first;
    c->turn = d_turn;
    c->by_1_or_by_0_times_kd = d_by_1_or_by_0_times_kd;
}

/* passes_end: The foot is above the next segment. */
static int react_graze_passes_end(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real segment_plus_by_1 = x->segment + 1.0;
    const real slope = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, segment_plus_by_1,
        0.0);
    const real height = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height,
        segment_plus_by_1, 0.0);
    const real end = select(p->patch_end > p->patch_begin, p->patch_end, 1000000000000.0);
    const real begin = select(p->patch_end > p->patch_begin, p->patch_begin, 1000000000000.0);
    const real begin_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin,
        segment_plus_by_1, select(segment_plus_by_1 > 0.0, select(segment_plus_by_1 > 1.0, end, begin),
        -1000000000000.0));
    const real end_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, segment_plus_by_1,
        select(segment_plus_by_1 > 0.0, select(segment_plus_by_1 > 1.0, 1000000000000.0, end), begin));
    const real friction = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        segment_plus_by_1, select(real_abs(segment_plus_by_1 - 1.0) > 0.0, -1.0, p->patch_friction));
    y->segment = segment_plus_by_1;
    y->segment_begin = begin_2;
    y->segment_end = end_2;
    y->segment_height = height;
    y->segment_slope = slope;
    y->friction_ahead = friction;
    y->friction_behind = friction;
    if (p->trips <= 0.0) {
        return next[0]; /* graze */
    }
    const real set_slope = p->ground_slope + slope;
    const real sine = real_sin(x->slope);
    const real y_2 = x->foot_x * sine;
    const real height_plus_y = x->height + y_2;
    const real set_height = p->ground_height + height;
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real foot_above = real_cos(set_slope) * (height_plus_y - set_height) - real_sin(set_slope) * x_2;
    if (foot_above < -(1e-12 * p->free_length)) {
        const real square = x->x_ * x->x_ + x->y_ * x->y_;
        const real length = real_sqrt(square);
        const real angle = real_atan2(-x->x_, x->y_) + x->winding;
        const real vx = x->foot_vx * cosine;
        const real vy = x->foot_vx * sine;
        const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
        const real moment = x->x_ * x->vy - x->y_ * x->vx;
        const real angle_rate = moment / square;
        y->seen_x = x_2;
        y->seen_y = height_plus_y;
        y->length = length;
        y->angle = angle;
        y->seen_vx = vx;
        y->seen_vy = vy;
        y->length_rate = length_rate;
        y->angle_rate = angle_rate;
        y->has_fallen = 1.0;
        return next[1]; /* fallen */
    }
    return next[0]; /* graze */
}

/* First variation of passes_end. */
static void vary_react_graze_passes_end(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real segment_plus_by_1 = x->segment + 1.0;
    const real d_end = select(p->patch_end > p->patch_begin, dp->patch_end, 0.0);
    const real d_begin = select(p->patch_end > p->patch_begin, dp->patch_begin, 0.0);
    const real d_begin_2 = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin,
        seed, segment_plus_by_1, select(segment_plus_by_1 > 0.0, select(segment_plus_by_1 > 1.0, d_end,
        d_begin), 0.0));
    const real d_end_2 = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, seed,
        segment_plus_by_1, select(segment_plus_by_1 > 0.0, select(segment_plus_by_1 > 1.0, 0.0, d_end),
        d_begin));
    const real d_height = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height,
        seed, segment_plus_by_1, 0.0);
    const real d_slope = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, seed,
        segment_plus_by_1, 0.0);
    const real d_friction = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        seed, segment_plus_by_1, select(real_abs(segment_plus_by_1 - 1.0) > 0.0, 0.0, dp->patch_friction));
    y->segment = dx->segment;
    y->segment_begin = d_begin_2;
    y->segment_end = d_end_2;
    y->segment_height = d_height;
    y->segment_slope = d_slope;
    y->friction_ahead = d_friction;
    y->friction_behind = d_friction;
    if (p->trips <= 0.0) {
        return;
    }
    const real set_slope = p->ground_slope + looked_up(tables, TABLE_ground_segment,
        COLUMN_ground_segment_slope, segment_plus_by_1, 0.0);
    const real sine = real_sin(x->slope);
    const real y_2 = x->foot_x * sine;
    const real set_height = p->ground_height + looked_up(tables, TABLE_ground_segment,
        COLUMN_ground_segment_height, segment_plus_by_1, 0.0);
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real foot_above = real_cos(set_slope) * (x->height + y_2 - set_height) - real_sin(set_slope) * x_2;
    if (foot_above < -(1e-12 * p->free_length)) {
        const real sine_times_slope = sine * dx->slope;
        const real d_x = dx->foot_x * cosine - x->foot_x * sine_times_slope;
        const real d_sine = cosine * dx->slope;
        const real d_y = dx->foot_x * sine + x->foot_x * d_sine;
        const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
        const real square = x->x_ * x->x_ + x->y_ * x->y_;
        const real length = real_sqrt(square);
        const real d_length = 0.5 * d_square / length;
        const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
        const real d_vx = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
        const real d_vy = dx->foot_vx * sine + x->foot_vx * d_sine;
        const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
        const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
            - length_rate * d_length) / length;
        const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
        const real moment = x->x_ * x->vy - x->y_ * x->vx;
        const real angle_rate = moment / square;
        const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
        y->seen_x = d_x;
        y->seen_y = dx->height + d_y;
        y->length = d_length;
        y->angle = d_angle;
        y->seen_vx = d_vx;
        y->seen_vy = d_vy;
        y->length_rate = d_length_rate;
        y->angle_rate = d_angle_rate;
        y->has_fallen = 0.0;
        return;
    }
}

/* First variation of the guard of passes_end. */
static real vary_guard_graze_passes_end(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const runner_states *x = (const void *)states;
    const runner_states *dx = (const void *)d_states;
    (void)parameters, (void)d_parameters;
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real d_x = dx->foot_x * cosine - x->foot_x * (sine * dx->slope);
    return dx->segment_end - d_x;
}

/* passes_begin: The foot is above the segment before. */
static int react_graze_passes_begin(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real segment_minus_by_1 = x->segment - 1.0;
    const real slope = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope,
        segment_minus_by_1, 0.0);
    const real height = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height,
        segment_minus_by_1, 0.0);
    const real end = select(p->patch_end > p->patch_begin, p->patch_end, 1000000000000.0);
    const real begin = select(p->patch_end > p->patch_begin, p->patch_begin, 1000000000000.0);
    const real begin_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin,
        segment_minus_by_1, select(segment_minus_by_1 > 0.0, select(segment_minus_by_1 > 1.0, end, begin),
        -1000000000000.0));
    const real end_2 = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, segment_minus_by_1,
        select(segment_minus_by_1 > 0.0, select(segment_minus_by_1 > 1.0, 1000000000000.0, end), begin));
    const real friction = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        segment_minus_by_1, select(real_abs(segment_minus_by_1 - 1.0) > 0.0, -1.0, p->patch_friction));
    y->segment = segment_minus_by_1;
    y->segment_begin = begin_2;
    y->segment_end = end_2;
    y->segment_height = height;
    y->segment_slope = slope;
    y->friction_ahead = friction;
    y->friction_behind = friction;
    if (p->trips <= 0.0) {
        return next[0]; /* graze */
    }
    const real set_slope = p->ground_slope + slope;
    const real sine = real_sin(x->slope);
    const real y_2 = x->foot_x * sine;
    const real height_plus_y = x->height + y_2;
    const real set_height = p->ground_height + height;
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real foot_above = real_cos(set_slope) * (height_plus_y - set_height) - real_sin(set_slope) * x_2;
    if (foot_above < -(1e-12 * p->free_length)) {
        const real square = x->x_ * x->x_ + x->y_ * x->y_;
        const real length = real_sqrt(square);
        const real angle = real_atan2(-x->x_, x->y_) + x->winding;
        const real vx = x->foot_vx * cosine;
        const real vy = x->foot_vx * sine;
        const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
        const real moment = x->x_ * x->vy - x->y_ * x->vx;
        const real angle_rate = moment / square;
        y->seen_x = x_2;
        y->seen_y = height_plus_y;
        y->length = length;
        y->angle = angle;
        y->seen_vx = vx;
        y->seen_vy = vy;
        y->length_rate = length_rate;
        y->angle_rate = angle_rate;
        y->has_fallen = 1.0;
        return next[1]; /* fallen */
    }
    return next[0]; /* graze */
}

/* First variation of passes_begin. */
static void vary_react_graze_passes_begin(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real segment_minus_by_1 = x->segment - 1.0;
    const real d_end = select(p->patch_end > p->patch_begin, dp->patch_end, 0.0);
    const real d_begin = select(p->patch_end > p->patch_begin, dp->patch_begin, 0.0);
    const real d_begin_2 = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin,
        seed, segment_minus_by_1, select(segment_minus_by_1 > 0.0, select(segment_minus_by_1 > 1.0, d_end,
        d_begin), 0.0));
    const real d_end_2 = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, seed,
        segment_minus_by_1, select(segment_minus_by_1 > 0.0, select(segment_minus_by_1 > 1.0, 0.0, d_end),
        d_begin));
    const real d_height = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height,
        seed, segment_minus_by_1, 0.0);
    const real d_slope = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, seed,
        segment_minus_by_1, 0.0);
    const real d_friction = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        seed, segment_minus_by_1, select(real_abs(segment_minus_by_1 - 1.0) > 0.0, 0.0, dp->patch_friction));
    y->segment = dx->segment;
    y->segment_begin = d_begin_2;
    y->segment_end = d_end_2;
    y->segment_height = d_height;
    y->segment_slope = d_slope;
    y->friction_ahead = d_friction;
    y->friction_behind = d_friction;
    if (p->trips <= 0.0) {
        return;
    }
    const real set_slope = p->ground_slope + looked_up(tables, TABLE_ground_segment,
        COLUMN_ground_segment_slope, segment_minus_by_1, 0.0);
    const real sine = real_sin(x->slope);
    const real y_2 = x->foot_x * sine;
    const real set_height = p->ground_height + looked_up(tables, TABLE_ground_segment,
        COLUMN_ground_segment_height, segment_minus_by_1, 0.0);
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real foot_above = real_cos(set_slope) * (x->height + y_2 - set_height) - real_sin(set_slope) * x_2;
    if (foot_above < -(1e-12 * p->free_length)) {
        const real sine_times_slope = sine * dx->slope;
        const real d_x = dx->foot_x * cosine - x->foot_x * sine_times_slope;
        const real d_sine = cosine * dx->slope;
        const real d_y = dx->foot_x * sine + x->foot_x * d_sine;
        const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
        const real square = x->x_ * x->x_ + x->y_ * x->y_;
        const real length = real_sqrt(square);
        const real d_length = 0.5 * d_square / length;
        const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
        const real d_vx = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
        const real d_vy = dx->foot_vx * sine + x->foot_vx * d_sine;
        const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
        const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
            - length_rate * d_length) / length;
        const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
        const real moment = x->x_ * x->vy - x->y_ * x->vx;
        const real angle_rate = moment / square;
        const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
        y->seen_x = d_x;
        y->seen_y = dx->height + d_y;
        y->length = d_length;
        y->angle = d_angle;
        y->seen_vx = d_vx;
        y->seen_vy = d_vy;
        y->length_rate = d_length_rate;
        y->angle_rate = d_angle_rate;
        y->has_fallen = 0.0;
        return;
    }
}

/* First variation of the guard of passes_begin. */
static real vary_guard_graze_passes_begin(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_states *x = (const void *)states;
    const runner_states *dx = (const void *)d_states;
    (void)parameters, (void)d_parameters;
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real d_x = dx->foot_x * cosine - x->foot_x * (sine * dx->slope);
    return d_x - dx->segment_begin;
}

/* ramp_ends: A ramp of the friction coefficient ends at 0. */
static int react_graze_ramp_ends(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->friction = 0.0;
    y->friction_rate = 0.0;
    return next[0]; /* graze */
}

/* apex_in_graze: Place begins. No stride closes, because the foot is on the ground. */
static int react_graze_apex_in_graze(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->swing = 2.0;
    y->placing = 0.0;
    return next[0]; /* graze */
}

/* First variation of apex_in_graze. */
static void vary_react_graze_apex_in_graze(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed;
    y->swing = 0.0;
    y->placing = 0.0;
}

/* True if apex_in_graze is watched. */
static real watches_graze_apex_in_graze(const real *parameters, const real *states) {
    const runner_states *x = (const void *)states;
    (void)parameters;
    if (x->swing < 2.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of apex_in_graze. */
static real vary_guard_graze_apex_in_graze(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real cos_of_slope = real_cos(x->slope);
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real along = x->foot_vx + share * x->vx;
    const real sin_of_slope = real_sin(x->slope);
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_along = dx->foot_vx + (d_share * x->vx + share * dx->vx);
    const real d_rise = cos_of_slope * dx->slope * along + sin_of_slope * d_along
        + (cos_of_slope * (d_share * x->vy + share * dx->vy) - sin_of_slope * dx->slope * (share * x->vy));
    return d_rise;
}

/* clamp: The clamp of the hip torque closes: it holds the retracting torque at 0. */
static int react_graze_clamp(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->swing = 0.0;
    return next[0]; /* graze */
}

/* First variation of the guard of clamp. */
static real vary_guard_graze_clamp(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
    const real d_servo = -(dp->kp * (angle - p->liftoff_factor * x->liftoff_angle) + p->kp * (d_angle
        - (dp->liftoff_factor * x->liftoff_angle + p->liftoff_factor * dx->liftoff_angle)))
        - (dp->kd * angle_rate + p->kd * d_angle_rate);
    return d_servo;
}

/* release: The clamp of the hip torque opens: it releases the retracting torque. */
static int react_graze_release(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->swing = 1.0;
    return next[0]; /* graze */
}

/* First variation of the guard of release. */
static real vary_guard_graze_release(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
    const real d_servo = -(dp->kp * (angle - p->liftoff_factor * x->liftoff_angle) + p->kp * (d_angle
        - (dp->liftoff_factor * x->liftoff_angle + p->liftoff_factor * dx->liftoff_angle)))
        - (dp->kd * angle_rate + p->kd * d_angle_rate);
    return -d_servo;
}

/* mid_stance: Drive ends where the leg is upright, once per stance. */
static int react_graze_mid_stance(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->driving = 0.0;
    return next[0]; /* graze */
}

/* graze_to_contact: The stance law presses the foot on the ground again. */
static int react_graze_graze_to_contact(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real ends = select(x->segment_end < 1000000000000.0, 1.0, 0.0);
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real by_1eminus_12_times_free_length = 1e-12 * p->free_length;
    const real x_plus_by_1eminus_12_times_free_length = x_2 + by_1eminus_12_times_free_length;
    const real begins = select(x->segment_begin > -1000000000000.0, 1.0, 0.0);
    const real segment_towards = x->segment
        + ends * select(x_plus_by_1eminus_12_times_free_length > x->segment_end, 1.0, 0.0)
        - begins * select(x_plus_by_1eminus_12_times_free_length < x->segment_begin, 1.0, 0.0);
    const real friction_ahead_or_friction = select(p->keeps_friction > 0.0, x->friction_ahead,
        looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, segment_towards,
        select(real_abs(segment_towards - 1.0) > 0.0, -1.0, p->patch_friction)));
    const real x_minus_by_1eminus_12_times_free_length = x_2 - by_1eminus_12_times_free_length;
    const real sum_2 = x->segment + ends * select(x_minus_by_1eminus_12_times_free_length > x->segment_end,
        1.0, 0.0) - begins * select(x_minus_by_1eminus_12_times_free_length < x->segment_begin, 1.0, 0.0);
    const real friction_behind_or_friction = select(p->keeps_friction > 0.0, x->friction_behind,
        looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, sum_2, select(real_abs(sum_2
        - 1.0) > 0.0, -1.0, p->patch_friction)));
    const real end = select(p->patch_end > p->patch_begin, p->patch_end, 1000000000000.0);
    const real begin = select(p->patch_end > p->patch_begin, p->patch_begin, 1000000000000.0);
    y->placing = 0.0;
    if (real_abs(x->foot_vx) > 0.0) {
        const real by_1_or_by_minus_1 = select(x->foot_vx > 0.0, 1.0, -1.0);
        const real x_plus_product = x_2 + by_1eminus_12_times_free_length * by_1_or_by_minus_1;
        const real sum_3 = x->segment + ends * select(x_plus_product > x->segment_end, 1.0, 0.0)
            - begins * select(x_plus_product < x->segment_begin, 1.0, 0.0);
        const real friction = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, sum_3,
            select(real_abs(sum_3 - 1.0) > 0.0, -1.0, p->patch_friction));
        y->segment = sum_3;
        y->segment_begin = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, sum_3,
            select(sum_3 > 0.0, select(sum_3 > 1.0, end, begin), -1000000000000.0));
        y->segment_end = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, sum_3,
            select(sum_3 > 0.0, select(sum_3 > 1.0, 1000000000000.0, end), begin));
        y->segment_height = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height, sum_3, 0.0);
        y->segment_slope = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, sum_3, 0.0);
        y->friction_ahead = select(p->keeps_friction > 0.0, friction_ahead_or_friction, friction);
        y->friction_behind = select(p->keeps_friction > 0.0, friction_behind_or_friction, friction);
        y->way = by_1_or_by_minus_1;
        return next[0]; /* slip */
    }
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real vx_plus_foot_vx = x->vx + x->foot_vx;
    const real length_rate = (x->x_ * vx_plus_foot_vx + x->y_ * x->vy) / length;
    const real spring = p->stiffness * (rest_length - length) - p->damping * length_rate;
    const real axial = spring / length;
    const real stance_torque = x->external_torque - (p->drive_torque + p->more_torque) * x->driving;
    const real turning = stance_torque / square;
    const real along = axial * x->x_ - turning * x->y_;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real sine = real_sin(x->slope);
    const real sum_3 = along + foot_mass_times_gravity * sine;
    const real way = select(sum_3 > 0.0, -1.0, 1.0);
    const real own = select(way > 0.0, friction_ahead_or_friction, friction_behind_or_friction);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real friction_along = is_own * own + (1.0 - is_own) * x->friction;
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + foot_mass_times_gravity * cosine;
    const real cone = p->static_ratio * friction_along * normal;
    y->vx = vx_plus_foot_vx;
    y->foot_vx = 0.0;
    if (real_abs(sum_3) <= cone) {
        y->friction_ahead = friction_ahead_or_friction;
        y->friction_behind = friction_behind_or_friction;
        return next[1]; /* stick */
    }
    const real x_plus_product = x_2 + by_1eminus_12_times_free_length * way;
    const real sum_4 = x->segment + ends * select(x_plus_product > x->segment_end, 1.0, 0.0)
        - begins * select(x_plus_product < x->segment_begin, 1.0, 0.0);
    const real friction = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, sum_4,
        select(real_abs(sum_4 - 1.0) > 0.0, -1.0, p->patch_friction));
    y->segment = sum_4;
    y->segment_begin = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, sum_4,
        select(sum_4 > 0.0, select(sum_4 > 1.0, end, begin), -1000000000000.0));
    y->segment_end = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, sum_4,
        select(sum_4 > 0.0, select(sum_4 > 1.0, 1000000000000.0, end), begin));
    y->segment_height = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height, sum_4, 0.0);
    y->segment_slope = looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, sum_4, 0.0);
    y->friction_ahead = select(p->keeps_friction > 0.0, friction_ahead_or_friction, friction);
    y->friction_behind = select(p->keeps_friction > 0.0, friction_behind_or_friction, friction);
    y->way = way;
    return next[0]; /* slip */
}

/* First variation of graze_to_contact. */
static void vary_react_graze_graze_to_contact(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real ends = select(x->segment_end < 1000000000000.0, 1.0, 0.0);
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real by_1eminus_12_times_free_length = 1e-12 * p->free_length;
    const real x_plus_by_1eminus_12_times_free_length = x_2 + by_1eminus_12_times_free_length;
    const real begins = select(x->segment_begin > -1000000000000.0, 1.0, 0.0);
    const real segment_towards = x->segment
        + ends * select(x_plus_by_1eminus_12_times_free_length > x->segment_end, 1.0, 0.0)
        - begins * select(x_plus_by_1eminus_12_times_free_length < x->segment_begin, 1.0, 0.0);
    const real abs_of_segment_towards_minus_by_1 = real_abs(segment_towards - 1.0);
    const real x_minus_by_1eminus_12_times_free_length = x_2 - by_1eminus_12_times_free_length;
    const real sum_2 = x->segment + ends * select(x_minus_by_1eminus_12_times_free_length > x->segment_end,
        1.0, 0.0) - begins * select(x_minus_by_1eminus_12_times_free_length < x->segment_begin, 1.0, 0.0);
    const real abs_of_sum_minus_by_1 = real_abs(sum_2 - 1.0);
    const real d_end = select(p->patch_end > p->patch_begin, dp->patch_end, 0.0);
    const real d_begin = select(p->patch_end > p->patch_begin, dp->patch_begin, 0.0);
    const real friction_ahead_or_d_friction = select(p->keeps_friction > 0.0, dx->friction_ahead,
        variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, seed,
        segment_towards, select(abs_of_segment_towards_minus_by_1 > 0.0, 0.0, dp->patch_friction)));
    const real friction_behind_or_d_friction = select(p->keeps_friction > 0.0, dx->friction_behind,
        variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction, seed, sum_2,
        select(abs_of_sum_minus_by_1 > 0.0, 0.0, dp->patch_friction)));
    y->placing = 0.0;
    if (real_abs(x->foot_vx) > 0.0) {
        const real x_plus_product = x_2 + by_1eminus_12_times_free_length * select(x->foot_vx > 0.0, 1.0,
            -1.0);
        const real sum_3 = x->segment + ends * select(x_plus_product > x->segment_end, 1.0, 0.0)
            - begins * select(x_plus_product < x->segment_begin, 1.0, 0.0);
        const real d_friction = variation_looked_up(tables, TABLE_ground_segment,
            COLUMN_ground_segment_friction, seed, sum_3, select(real_abs(sum_3 - 1.0) > 0.0, 0.0,
            dp->patch_friction));
        y->segment = dx->segment;
        y->segment_begin = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin,
            seed, sum_3, select(sum_3 > 0.0, select(sum_3 > 1.0, d_end, d_begin), 0.0));
        y->segment_end = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, seed,
            sum_3, select(sum_3 > 0.0, select(sum_3 > 1.0, 0.0, d_end), d_begin));
        y->segment_height = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height,
            seed, sum_3, 0.0);
        y->segment_slope = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope,
            seed, sum_3, 0.0);
        y->friction_ahead = select(p->keeps_friction > 0.0, friction_ahead_or_d_friction, d_friction);
        y->friction_behind = select(p->keeps_friction > 0.0, friction_behind_or_d_friction, d_friction);
        y->way = 0.0;
        return;
    }
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real length_rate = (x->x_ * (x->vx + x->foot_vx) + x->y_ * x->vy) / length;
    const real spring = p->stiffness * (rest_length - length) - p->damping * length_rate;
    const real axial = spring / length;
    const real stance_torque = x->external_torque - (p->drive_torque + p->more_torque) * x->driving;
    const real turning = stance_torque / square;
    const real along = axial * x->x_ - turning * x->y_;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real sine = real_sin(x->slope);
    const real sum_3 = along + foot_mass_times_gravity * sine;
    const real way = select(sum_3 > 0.0, -1.0, 1.0);
    const real own = select(way > 0.0, select(p->keeps_friction > 0.0, x->friction_ahead, looked_up(tables,
        TABLE_ground_segment, COLUMN_ground_segment_friction, segment_towards,
        select(abs_of_segment_towards_minus_by_1 > 0.0, -1.0, p->patch_friction))),
        select(p->keeps_friction > 0.0, x->friction_behind, looked_up(tables, TABLE_ground_segment,
        COLUMN_ground_segment_friction, sum_2, select(abs_of_sum_minus_by_1 > 0.0, -1.0,
        p->patch_friction))));
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real friction_along = is_own * own + (1.0 - is_own) * x->friction;
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + foot_mass_times_gravity * cosine;
    const real cone = p->static_ratio * friction_along * normal;
    const real vx_plus_foot_vx = dx->vx + dx->foot_vx;
    y->vx = vx_plus_foot_vx;
    y->foot_vx = 0.0;
    if (real_abs(sum_3) <= cone) {
        y->friction_ahead = friction_ahead_or_d_friction;
        y->friction_behind = friction_behind_or_d_friction;
        return;
    }
    const real x_plus_product = x_2 + by_1eminus_12_times_free_length * way;
    const real sum_4 = x->segment + ends * select(x_plus_product > x->segment_end, 1.0, 0.0)
        - begins * select(x_plus_product < x->segment_begin, 1.0, 0.0);
    const real d_friction = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_friction,
        seed, sum_4, select(real_abs(sum_4 - 1.0) > 0.0, 0.0, dp->patch_friction));
    y->segment = dx->segment;
    y->segment_begin = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_begin, seed,
        sum_4, select(sum_4 > 0.0, select(sum_4 > 1.0, d_end, d_begin), 0.0));
    y->segment_end = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_end, seed, sum_4,
        select(sum_4 > 0.0, select(sum_4 > 1.0, 0.0, d_end), d_begin));
    y->segment_height = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_height, seed,
        sum_4, 0.0);
    y->segment_slope = variation_looked_up(tables, TABLE_ground_segment, COLUMN_ground_segment_slope, seed,
        sum_4, 0.0);
    y->friction_ahead = select(p->keeps_friction > 0.0, friction_ahead_or_d_friction, d_friction);
    y->friction_behind = select(p->keeps_friction > 0.0, friction_behind_or_d_friction, d_friction);
    y->way = 0.0;
}

/* First variation of the guard of graze_to_contact. */
static real vary_guard_graze_graze_to_contact(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real rest_length_minus_length = rest_length - length;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * rest_length_minus_length + p->stiffness * (d_rest_length
        - d_length) - (dp->damping * length_rate + p->damping * d_length_rate);
    const real spring = p->stiffness * rest_length_minus_length - p->damping * length_rate;
    const real axial = spring / length;
    const real d_axial = (d_spring - axial * d_length) / length;
    const real drive_torque_plus_more_torque = p->drive_torque + p->more_torque;
    const real d_stance_torque = dx->external_torque - ((dp->drive_torque + dp->more_torque) * x->driving
        + drive_torque_plus_more_torque * dx->driving);
    const real stance_torque = x->external_torque - drive_torque_plus_more_torque * x->driving;
    const real turning = stance_torque / square;
    const real d_turning = (d_stance_torque - turning * d_square) / square;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real d_normal = d_off + ((p->gravity * dp->foot_mass + p->foot_mass * dp->gravity) * cosine
        - p->foot_mass * p->gravity * (sine * dx->slope));
    return -d_normal;
}

/* graze_to_flight: The flight law lifts the foot. */
static int react_graze_graze_to_flight(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    (void)tables;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real sine = real_sin(x->slope);
    const real y_2 = x->foot_x * sine;
    const real vx = x->foot_vx * cosine;
    const real vy = x->foot_vx * sine;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real rest_length = p->free_length + x->extension;
    const real longer = p->thrust + p->more_thrust;
    const real sum_2 = rest_length + select(longer >= 0.0, longer, 0.0) * x->thrusting;
    const real jump = rest_length - sum_2;
    const real middle = sum_2 + 0.5 * jump - length;
    const real work = p->stiffness * jump * middle;
    const real begins = select(x->thrusting < 0.0, select(work >= 0.0, work, 0.0), 0.0);
    y->length = length;
    y->angle = angle;
    y->length_rate = length_rate;
    y->com_x = x_2 + share * (x->x_ * cosine - x->y_ * sine);
    y->com_y = x->height + y_2 + share * (x->x_ * sine + x->y_ * cosine);
    y->com_vx = vx + share * (x->vx * cosine - x->vy * sine);
    y->com_vy = vy + share * (x->vx * sine + x->vy * cosine);
    y->momentum = moment;
    y->thrusting = 0.0;
    y->leg_work = x->leg_work + work;
    y->positive_leg_work = x->positive_leg_work + select(work > 0.0, work, begins);
    return next[0]; /* flight */
}

/* First variation of graze_to_flight. */
static void vary_react_graze_graze_to_flight(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real d_length = 0.5 * d_square / length;
    const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_x = dx->foot_x * cosine - x->foot_x * sine_times_slope;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_sine = cosine * dx->slope;
    const real d_y = dx->foot_x * sine + x->foot_x * d_sine;
    const real d_vx = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
    const real d_vy = dx->foot_vx * sine + x->foot_vx * d_sine;
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    const real rest_length = p->free_length + x->extension;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real sum_2 = rest_length + longer_or_by_0 * x->thrusting;
    const real jump = rest_length - sum_2;
    const real d_rest_length = dp->free_length + dx->extension;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length_plus_sum = d_rest_length + (select(longer >= 0.0, d_longer, 0.0) * x->thrusting
        + longer_or_by_0 * dx->thrusting);
    const real d_jump = d_rest_length - d_rest_length_plus_sum;
    const real middle = sum_2 + 0.5 * jump - length;
    const real stiffness_times_jump = p->stiffness * jump;
    const real d_middle = d_rest_length_plus_sum + 0.5 * d_jump - d_length;
    const real d_work = (dp->stiffness * jump + p->stiffness * d_jump) * middle
        + stiffness_times_jump * d_middle;
    const real work = stiffness_times_jump * middle;
    const real d_begins = select(x->thrusting < 0.0, select(work >= 0.0, d_work, 0.0), 0.0);
    y->length = d_length;
    y->angle = d_angle;
    y->length_rate = d_length_rate;
    y->com_x = d_x + (d_share * (x->x_ * cosine - x->y_ * sine) + share * (dx->x_ * cosine
        - x->x_ * sine_times_slope - (dx->y_ * sine + x->y_ * d_sine)));
    y->com_y = dx->height + d_y + (d_share * (x->x_ * sine + x->y_ * cosine) + share * (dx->x_ * sine
        + x->x_ * d_sine + (dx->y_ * cosine - x->y_ * sine_times_slope)));
    y->com_vx = d_vx + (d_share * (x->vx * cosine - x->vy * sine) + share * (dx->vx * cosine
        - x->vx * sine_times_slope - (dx->vy * sine + x->vy * d_sine)));
    y->com_vy = d_vy + (d_share * (x->vx * sine + x->vy * cosine) + share * (dx->vx * sine + x->vx * d_sine
        + (dx->vy * cosine - x->vy * sine_times_slope)));
    y->momentum = d_moment;
    y->thrusting = 0.0;
    y->leg_work = dx->leg_work + d_work;
    y->positive_leg_work = dx->positive_leg_work + select(work > 0.0, d_work, d_begins);
}

/* True if graze_to_flight has to cross zero. */
static real crosses_graze_graze_to_flight(const real *parameters, const real *states) {
    const runner_states *x = (const void *)states;
    (void)parameters;
    if (x->has_hopped > 0.0 && x->mode_began <= x->hop_time) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of graze_to_flight. */
static real vary_guard_graze_graze_to_flight(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real rest_length_minus_length = rest_length - length;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * rest_length_minus_length + p->stiffness * (d_rest_length
        - d_length) - (dp->damping * length_rate + p->damping * d_length_rate);
    const real spring = p->stiffness * rest_length_minus_length - p->damping * length_rate;
    const real axial = spring / length;
    const real d_axial = (d_spring - axial * d_length) / length;
    const real share = select(x->swing > 0.0, 1.0, 0.0);
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real placing_angle = p->touchdown_angle + p->more_angle;
    const real first = select(x->swing < 2.0, p->liftoff_factor * x->liftoff_angle, placing_angle);
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real turn = p->retraction_rate * is_placing;
    const real sum_2 = angle - (first - turn * x->placing);
    const real kp_times_share = p->kp * share;
    const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
    const real d_placing_angle = dp->touchdown_angle + dp->more_angle;
    const real d_first = select(x->swing < 2.0, dp->liftoff_factor * x->liftoff_angle
        + p->liftoff_factor * dx->liftoff_angle, d_placing_angle);
    const real d_turn = dp->retraction_rate * is_placing;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real angle_rate_plus_turn = angle_rate + turn;
    const real kd_times_share = p->kd * share;
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
    const real d_servo = -(dp->kp * share * sum_2 + kp_times_share * (d_angle - (d_first
        - (d_turn * x->placing + turn * dx->placing)))) - (dp->kd * share * angle_rate_plus_turn
        + kd_times_share * (d_angle_rate + d_turn));
    const real d_swing_torque = dx->external_torque + d_servo;
    const real servo = -(kp_times_share * sum_2) - kd_times_share * angle_rate_plus_turn;
    const real swing_torque = x->external_torque + servo;
    const real turning = swing_torque / square;
    const real d_turning = (d_swing_torque - turning * d_square) / square;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real d_normal = d_off + ((p->gravity * dp->foot_mass + p->foot_mass * dp->gravity) * cosine
        - p->foot_mass * p->gravity * (sine * dx->slope));
    return d_normal;
}

/* Outputs in graze. */
static void outputs_graze(const real *parameters, const real *states, real *outputs) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const real set_height = p->ground_height + x->segment_height;
    const real set_slope = p->ground_slope + x->segment_slope;
    const real pending = select(real_abs(set_height - x->height) + real_abs(p->free_length * (set_slope
        - x->slope)) > 0.0, 1.0, 0.0);
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real shorter = rest_length - length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real spring = p->stiffness * shorter - p->damping * length_rate;
    const real cosine = real_cos(x->slope);
    const real off = p->foot_mass * p->gravity * cosine;
    const real torque = -((spring / length * x->y_ + off) / x->x_ * square);
    const real foot_x_times_cosine = x->foot_x * cosine;
    const real sine = real_sin(x->slope);
    const real x_2 = x->x_ * cosine - x->y_ * sine;
    const real body_x = foot_x_times_cosine + x_2;
    const real height_plus_foot_x_times_sine = x->height + x->foot_x * sine;
    const real y_2 = x->x_ * sine + x->y_ * cosine;
    const real body_y = height_plus_foot_x_times_sine + y_2;
    const real foot_vx_times_cosine = x->foot_vx * cosine;
    const real vx = x->vx * cosine - x->vy * sine;
    const real body_vx = foot_vx_times_cosine + vx;
    const real foot_vx_times_sine = x->foot_vx * sine;
    const real vy = x->vx * sine + x->vy * cosine;
    const real body_vy = foot_vx_times_sine + vy;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real center_x = foot_x_times_cosine + share * x_2;
    const real center_y = height_plus_foot_x_times_sine + share * y_2;
    const real center_vx = foot_vx_times_cosine + share * vx;
    const real center_vy = foot_vx_times_sine + share * vy;
    const real of_body = p->body_mass * (body_vx * body_vx + body_vy * body_vy);
    const real kinetic_energy = 0.5 * (of_body + p->foot_mass * (foot_vx_times_cosine * foot_vx_times_cosine
        + foot_vx_times_sine * foot_vx_times_sine));
    const real potential_energy = p->gravity * (p->body_mass * body_y
        + p->foot_mass * height_plus_foot_x_times_sine);
    const real elastic_energy = 0.5 * (p->stiffness * (shorter * shorter));
    const real energy = kinetic_energy + potential_energy + elastic_energy;
    const real phase_of_hip = select(x->swing < 2.0, 3.0, 4.0);
    outputs[OUTPUT_pending] = pending;
    outputs[OUTPUT_torque] = torque;
    outputs[OUTPUT_normal_force] = 0.0;
    outputs[OUTPUT_tangential_force] = 0.0;
    outputs[OUTPUT_ground_force_x] = 0.0;
    outputs[OUTPUT_ground_force_y] = 0.0;
    outputs[OUTPUT_force_of_leg] = spring;
    outputs[OUTPUT_body_x] = body_x;
    outputs[OUTPUT_body_y] = body_y;
    outputs[OUTPUT_body_vx] = body_vx;
    outputs[OUTPUT_body_vy] = body_vy;
    outputs[OUTPUT_center_x] = center_x;
    outputs[OUTPUT_center_y] = center_y;
    outputs[OUTPUT_center_vx] = center_vx;
    outputs[OUTPUT_center_vy] = center_vy;
    outputs[OUTPUT_kinetic_energy] = kinetic_energy;
    outputs[OUTPUT_potential_energy] = potential_energy;
    outputs[OUTPUT_elastic_energy] = elastic_energy;
    outputs[OUTPUT_energy] = energy;
    outputs[OUTPUT_kind_of_contact] = 5.0;
    outputs[OUTPUT_phase_of_hip] = phase_of_hip;
}

/* First variation of outputs_graze. */
static void vary_outputs_graze(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *outputs) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real shorter = rest_length - length;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real d_shorter = d_rest_length - d_length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * shorter + p->stiffness * d_shorter - (dp->damping * length_rate
        + p->damping * d_length_rate);
    const real spring = p->stiffness * shorter - p->damping * length_rate;
    const real spring_over_length = spring / length;
    const real cosine = real_cos(x->slope);
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_off = (p->gravity * dp->foot_mass + p->foot_mass * dp->gravity) * cosine
        - foot_mass_times_gravity * sine_times_slope;
    const real off = foot_mass_times_gravity * cosine;
    const real ratio = (spring_over_length * x->y_ + off) / x->x_;
    const real d_torque = -(((d_spring - spring_over_length * d_length) / length * x->y_
        + spring_over_length * dx->y_ + d_off - ratio * dx->x_) / x->x_ * square + ratio * d_square);
    const real sum_2 = dx->foot_x * cosine - x->foot_x * sine_times_slope;
    const real d_sine = cosine * dx->slope;
    const real d_x = dx->x_ * cosine - x->x_ * sine_times_slope - (dx->y_ * sine + x->y_ * d_sine);
    const real d_body_x = sum_2 + d_x;
    const real height_plus_sum = dx->height + (dx->foot_x * sine + x->foot_x * d_sine);
    const real d_y = dx->x_ * sine + x->x_ * d_sine + (dx->y_ * cosine - x->y_ * sine_times_slope);
    const real d_body_y = height_plus_sum + d_y;
    const real sum_3 = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
    const real d_vx = dx->vx * cosine - x->vx * sine_times_slope - (dx->vy * sine + x->vy * d_sine);
    const real d_body_vx = sum_3 + d_vx;
    const real sum_4 = dx->foot_vx * sine + x->foot_vx * d_sine;
    const real d_vy = dx->vx * sine + x->vx * d_sine + (dx->vy * cosine - x->vy * sine_times_slope);
    const real d_body_vy = sum_4 + d_vy;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real x_2 = x->x_ * cosine - x->y_ * sine;
    const real d_center_x = sum_2 + (d_share * x_2 + share * d_x);
    const real y_2 = x->x_ * sine + x->y_ * cosine;
    const real d_center_y = height_plus_sum + (d_share * y_2 + share * d_y);
    const real vx = x->vx * cosine - x->vy * sine;
    const real d_center_vx = sum_3 + (d_share * vx + share * d_vx);
    const real vy = x->vx * sine + x->vy * cosine;
    const real d_center_vy = sum_4 + (d_share * vy + share * d_vy);
    const real foot_vx_times_cosine = x->foot_vx * cosine;
    const real body_vx = foot_vx_times_cosine + vx;
    const real foot_vx_times_sine = x->foot_vx * sine;
    const real body_vy = foot_vx_times_sine + vy;
    const real d_of_body = dp->body_mass * (body_vx * body_vx + body_vy * body_vy)
        + p->body_mass * (2.0 * (body_vx * d_body_vx) + 2.0 * (body_vy * d_body_vy));
    const real d_kinetic_energy = 0.5 * (d_of_body
        + (dp->foot_mass * (foot_vx_times_cosine * foot_vx_times_cosine
        + foot_vx_times_sine * foot_vx_times_sine) + p->foot_mass * (2.0 * (foot_vx_times_cosine * sum_3)
        + 2.0 * (foot_vx_times_sine * sum_4))));
    const real height_plus_foot_x_times_sine = x->height + x->foot_x * sine;
    const real body_y = height_plus_foot_x_times_sine + y_2;
    const real d_potential_energy = dp->gravity * (p->body_mass * body_y
        + p->foot_mass * height_plus_foot_x_times_sine) + p->gravity * (dp->body_mass * body_y
        + p->body_mass * d_body_y + (dp->foot_mass * height_plus_foot_x_times_sine
        + p->foot_mass * height_plus_sum));
    const real d_elastic_energy = 0.5 * (dp->stiffness * (shorter * shorter)
        + p->stiffness * (2.0 * (shorter * d_shorter)));
    const real d_energy = d_kinetic_energy + d_potential_energy + d_elastic_energy;
    outputs[OUTPUT_pending] = 0.0;
    outputs[OUTPUT_torque] = d_torque;
    outputs[OUTPUT_normal_force] = 0.0;
    outputs[OUTPUT_tangential_force] = 0.0;
    outputs[OUTPUT_ground_force_x] = 0.0;
    outputs[OUTPUT_ground_force_y] = 0.0;
    outputs[OUTPUT_force_of_leg] = d_spring;
    outputs[OUTPUT_body_x] = d_body_x;
    outputs[OUTPUT_body_y] = d_body_y;
    outputs[OUTPUT_body_vx] = d_body_vx;
    outputs[OUTPUT_body_vy] = d_body_vy;
    outputs[OUTPUT_center_x] = d_center_x;
    outputs[OUTPUT_center_y] = d_center_y;
    outputs[OUTPUT_center_vx] = d_center_vx;
    outputs[OUTPUT_center_vy] = d_center_vy;
    outputs[OUTPUT_kinetic_energy] = d_kinetic_energy;
    outputs[OUTPUT_potential_energy] = d_potential_energy;
    outputs[OUTPUT_elastic_energy] = d_elastic_energy;
    outputs[OUTPUT_energy] = d_energy;
    outputs[OUTPUT_kind_of_contact] = 0.0;
    outputs[OUTPUT_phase_of_hip] = 0.0;
}

/* Count the event. A contact mode that lasted adds a letter to the gait word, a new stance a bar. */
static void leave_graze(const real *parameters, const real *states, real counted, real *after) {
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    (void)parameters;
    const real is_new = select(x->time > x->last_event, counted, 0.0);
    y->events = x->events + is_new;
    y->last_event = select(counted > 0.0, x->time, x->last_event);
    y->slid_from = x->foot_x;
    y->mode_began = x->time;
}

/* First variation of leave_graze. */
static void vary_leave_graze(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real counted, real *after) {
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters;
    y->events = dx->events;
    y->last_event = select(counted > 0.0, dx->time, dx->last_event);
    y->slid_from = dx->foot_x;
    y->mode_began = dx->time;
}

/* Rates of the world's states in graze. */
static void world_rates_graze(const real *parameters, const real *states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real cosine = real_cos(x->slope);
    const real vx = x->foot_vx * cosine;
    const real sine = real_sin(x->slope);
    const real vy = x->foot_vx * sine;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real x__times_vx = x->x_ * x->vx;
    const real y__times_vy = x->y_ * x->vy;
    const real length_rate = (x__times_vx + y__times_vy) / length;
    const real spring = p->stiffness * (rest_length - length) - p->damping * length_rate;
    const real axial = spring / length;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real off = foot_mass_times_gravity * cosine;
    const real axial_times_x__plus_product = axial * x->x_ + (axial * x->y_ + off) / x->x_ * x->y_;
    const real along = foot_mass_times_gravity * sine;
    const real ratio = (axial_times_x__plus_product + along) / p->foot_mass;
    const real sum_2 = 2.0 * x__times_vx + 2.0 * y__times_vy;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real sum_3 = (axial_times_x__plus_product + (x->external_fx * cosine
        + x->external_fy * sine)) / p->body_mass - p->gravity * sine + ratio;
    const real sum_4 = (x->external_fy * cosine - x->external_fx * sine - off) / p->body_mass
        - p->gravity * cosine;
    y->seen_x = vx;
    y->seen_y = vy;
    y->seen_vx = -(ratio * cosine);
    y->seen_vy = -(ratio * sine);
    y->length = 0.5 * sum_2 / length;
    y->angle = angle_rate;
    y->length_rate = (x->vx * x->vx + x->x_ * sum_3 + (x->vy * x->vy + x->y_ * sum_4)
        - length_rate * (0.5 * sum_2 / length)) / length;
    y->angle_rate = (x->vx * x->vy + x->x_ * sum_4 - (x->vy * x->vx + x->y_ * sum_3)
        - angle_rate * sum_2) / square;
}

/* First variation of world_rates_graze. */
static void vary_world_rates_graze(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_vx = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
    const real d_sine = cosine * dx->slope;
    const real d_vy = dx->foot_vx * sine + x->foot_vx * d_sine;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real rest_length_minus_length = rest_length - length;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real x__times_vx = x->x_ * x->vx;
    const real y__times_vy = x->y_ * x->vy;
    const real length_rate = (x__times_vx + y__times_vy) / length;
    const real x__times_vx_plus_x__times_vx = dx->x_ * x->vx + x->x_ * dx->vx;
    const real y__times_vy_plus_y__times_vy = dx->y_ * x->vy + x->y_ * dx->vy;
    const real d_length_rate = (x__times_vx_plus_x__times_vx + y__times_vy_plus_y__times_vy
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * rest_length_minus_length + p->stiffness * (d_rest_length
        - d_length) - (dp->damping * length_rate + p->damping * d_length_rate);
    const real spring = p->stiffness * rest_length_minus_length - p->damping * length_rate;
    const real axial = spring / length;
    const real d_axial = (d_spring - axial * d_length) / length;
    const real sum_2 = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real d_off = sum_2 * cosine - foot_mass_times_gravity * sine_times_slope;
    const real off = foot_mass_times_gravity * cosine;
    const real axial_times_y__plus_off_over_x_ = (axial * x->y_ + off) / x->x_;
    const real sum_3 = d_axial * x->x_ + axial * dx->x_ + ((d_axial * x->y_ + axial * dx->y_ + d_off
        - axial_times_y__plus_off_over_x_ * dx->x_) / x->x_ * x->y_
        + axial_times_y__plus_off_over_x_ * dx->y_);
    const real d_along = sum_2 * sine + foot_mass_times_gravity * d_sine;
    const real axial_times_x__plus_product = axial * x->x_ + axial_times_y__plus_off_over_x_ * x->y_;
    const real along = foot_mass_times_gravity * sine;
    const real ratio = (axial_times_x__plus_product + along) / p->foot_mass;
    const real sum_over_foot_mass = (sum_3 + d_along - ratio * dp->foot_mass) / p->foot_mass;
    const real sum_4 = 2.0 * x__times_vx_plus_x__times_vx + 2.0 * y__times_vy_plus_y__times_vy;
    const real sum_5 = 2.0 * x__times_vx + 2.0 * y__times_vy;
    const real by_0_5_times_sum_over_length = 0.5 * sum_5 / length;
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
    const real ratio_2 = (axial_times_x__plus_product + (x->external_fx * cosine
        + x->external_fy * sine)) / p->body_mass;
    const real sum_6 = ratio_2 - p->gravity * sine + ratio;
    const real sum_7 = (sum_3 + (dx->external_fx * cosine - x->external_fx * sine_times_slope
        + (dx->external_fy * sine + x->external_fy * d_sine)) - ratio_2 * dp->body_mass) / p->body_mass
        - (dp->gravity * sine + p->gravity * d_sine) + sum_over_foot_mass;
    const real sum_minus_off_over_body_mass = (x->external_fy * cosine - x->external_fx * sine
        - off) / p->body_mass;
    const real sum_8 = sum_minus_off_over_body_mass - p->gravity * cosine;
    const real ratio_minus_sum = (dx->external_fy * cosine - x->external_fy * sine_times_slope
        - (dx->external_fx * sine + x->external_fx * d_sine) - d_off
        - sum_minus_off_over_body_mass * dp->body_mass) / p->body_mass - (dp->gravity * cosine
        - p->gravity * sine_times_slope);
    y->seen_x = d_vx;
    y->seen_y = d_vy;
    y->seen_vx = -(sum_over_foot_mass * cosine - ratio * sine_times_slope);
    y->seen_vy = -(sum_over_foot_mass * sine + ratio * d_sine);
    y->length = (0.5 * sum_4 - by_0_5_times_sum_over_length * d_length) / length;
    y->angle = d_angle_rate;
    y->length_rate = (2.0 * (x->vx * dx->vx) + (dx->x_ * sum_6 + x->x_ * sum_7) + (2.0 * (x->vy * dx->vy)
        + (dx->y_ * sum_8 + x->y_ * ratio_minus_sum)) - (d_length_rate * by_0_5_times_sum_over_length
        + length_rate * ((0.5 * sum_4 - by_0_5_times_sum_over_length * d_length) / length)) - (x->vx * x->vx
        + x->x_ * sum_6 + (x->vy * x->vy + x->y_ * sum_8)
        - length_rate * by_0_5_times_sum_over_length) / length * d_length) / length;
    y->angle_rate = (dx->vx * x->vy + x->vx * dx->vy + (dx->x_ * sum_8 + x->x_ * ratio_minus_sum)
        - (dx->vy * x->vx + x->vy * dx->vx + (dx->y_ * sum_6 + x->y_ * sum_7)) - (d_angle_rate * sum_5
        + angle_rate * sum_4) - (x->vx * x->vy + x->x_ * sum_8 - (x->vy * x->vx + x->y_ * sum_6)
        - angle_rate * sum_5) / square * d_square) / square;
}

/* Constants of slip_falling. */
static void open_slip_falling(const real *parameters, const real *states, real *constants) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    slip_falling_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real longer = p->thrust + p->more_thrust;
    const real thrusting_times_longer_or_by_0 = x->thrusting * select(longer >= 0.0, longer, 0.0);
    const real product_2 = x->driving * (p->drive_torque + p->more_torque);
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real gravity_times_sine = p->gravity * sine;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real foot_mass_times_gravity_times_sine = foot_mass_times_gravity * sine;
    const real own = select(x->way > 0.0, x->friction_ahead, x->friction_behind);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real is_own_times_own = is_own * own;
    const real by_1_minus_is_own = 1.0 - is_own;
    const real static_ratio_minus_by_1 = p->static_ratio - 1.0;
    const real inverse_stribeck_velocity = 1.0 / p->stribeck_velocity;
    const real foot_mass_times_gravity_times_cosine = foot_mass_times_gravity * cosine;
    const real gravity_times_cosine = p->gravity * cosine;
    const real stiffness_times_extension_rate = p->stiffness * x->extension_rate;
    const real inverse_stribeck_velocity_or_by_1 = 1.0 / select(p->stribeck_velocity > 0.0,
        p->stribeck_velocity, 1.0);
    const real segment_end_or_segment_begin = select(x->way > 0.0, x->segment_end, x->segment_begin);
    c->inverse_body_mass = inverse_body_mass;
    c->stiffness = p->stiffness;
    c->free_length = p->free_length;
    c->thrusting_times_longer_or_by_0 = thrusting_times_longer_or_by_0;
    c->damping = p->damping;
    c->product_2 = product_2;
    c->cosine = cosine;
    c->sine = sine;
    c->gravity_times_sine = gravity_times_sine;
    c->inverse_foot_mass = inverse_foot_mass;
    c->foot_mass_times_gravity_times_sine = foot_mass_times_gravity_times_sine;
    c->way = x->way;
    c->is_own_times_own = is_own_times_own;
    c->by_1_minus_is_own = by_1_minus_is_own;
    c->static_ratio_minus_by_1 = static_ratio_minus_by_1;
    c->inverse_stribeck_velocity = inverse_stribeck_velocity;
    c->foot_mass_times_gravity_times_cosine = foot_mass_times_gravity_times_cosine;
    c->gravity_times_cosine = gravity_times_cosine;
    c->extension_rate = x->extension_rate;
    c->stiffness_times_extension_rate = stiffness_times_extension_rate;
    c->external_fx_rate = x->external_fx_rate;
    c->external_fy_rate = x->external_fy_rate;
    c->friction_rate = x->friction_rate;
    c->external_torque_rate = x->external_torque_rate;
    c->least_length = p->least_length;
    c->winding = x->winding;
    c->inverse_stribeck_velocity_or_by_1 = inverse_stribeck_velocity_or_by_1;
    c->segment_end_or_segment_begin = segment_end_or_segment_begin;
}

/* First variation of open_slip_falling. */
static void vary_open_slip_falling(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    slip_falling_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real d_inverse_body_mass = -(inverse_body_mass * dp->body_mass / p->body_mass);
    const real longer = p->thrust + p->more_thrust;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_thrusting_times_longer_or_by_0 = select(longer >= 0.0, longer, 0.0) * dx->thrusting
        + x->thrusting * select(longer >= 0.0, d_longer, 0.0);
    const real d_product_2 = (p->drive_torque + p->more_torque) * dx->driving
        + x->driving * (dp->drive_torque + dp->more_torque);
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_cosine = -sine_times_slope;
    const real cosine = real_cos(x->slope);
    const real d_sine = cosine * dx->slope;
    const real d_gravity_times_sine = sine * dp->gravity + p->gravity * d_sine;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real d_inverse_foot_mass = -(inverse_foot_mass * dp->foot_mass / p->foot_mass);
    const real sum_2 = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real d_foot_mass_times_gravity_times_sine = sine * sum_2 + foot_mass_times_gravity * d_sine;
    const real own = select(x->way > 0.0, x->friction_ahead, x->friction_behind);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real d_own = select(x->way > 0.0, dx->friction_ahead, dx->friction_behind);
    const real d_is_own_times_own = is_own * d_own;
    const real inverse_stribeck_velocity = 1.0 / p->stribeck_velocity;
    const real d_inverse_stribeck_velocity = -(inverse_stribeck_velocity * dp->stribeck_velocity /
        p->stribeck_velocity);
    const real d_foot_mass_times_gravity_times_cosine = cosine * sum_2
        - foot_mass_times_gravity * sine_times_slope;
    const real d_gravity_times_cosine = cosine * dp->gravity - p->gravity * sine_times_slope;
    const real d_stiffness_times_extension_rate = x->extension_rate * dp->stiffness
        + p->stiffness * dx->extension_rate;
    const real stribeck_velocity_or_by_1 = select(p->stribeck_velocity > 0.0, p->stribeck_velocity, 1.0);
    const real inverse_stribeck_velocity_or_by_1 = 1.0 / stribeck_velocity_or_by_1;
    const real d_inverse_stribeck_velocity_or_by_1 = -(inverse_stribeck_velocity_or_by_1 *
        select(p->stribeck_velocity > 0.0, dp->stribeck_velocity, 0.0) / stribeck_velocity_or_by_1);
    const real d_segment_end_or_segment_begin = select(x->way > 0.0, dx->segment_end, dx->segment_begin);
    c->inverse_body_mass = d_inverse_body_mass;
    c->stiffness = dp->stiffness;
    c->free_length = dp->free_length;
    c->thrusting_times_longer_or_by_0 = d_thrusting_times_longer_or_by_0;
    c->damping = dp->damping;
    c->product_2 = d_product_2;
    c->cosine = d_cosine;
    c->sine = d_sine;
    c->gravity_times_sine = d_gravity_times_sine;
    c->inverse_foot_mass = d_inverse_foot_mass;
    c->foot_mass_times_gravity_times_sine = d_foot_mass_times_gravity_times_sine;
    c->way = dx->way;
    c->is_own_times_own = d_is_own_times_own;
    c->by_1_minus_is_own = 0.0;
    c->static_ratio_minus_by_1 = dp->static_ratio;
    c->inverse_stribeck_velocity = d_inverse_stribeck_velocity;
    c->foot_mass_times_gravity_times_cosine = d_foot_mass_times_gravity_times_cosine;
    c->gravity_times_cosine = d_gravity_times_cosine;
    c->extension_rate = dx->extension_rate;
    c->stiffness_times_extension_rate = d_stiffness_times_extension_rate;
    c->external_fx_rate = dx->external_fx_rate;
    c->external_fy_rate = dx->external_fy_rate;
    c->friction_rate = dx->friction_rate;
    c->external_torque_rate = dx->external_torque_rate;
    c->least_length = dp->least_length;
    c->winding = dx->winding;
    c->inverse_stribeck_velocity_or_by_1 = d_inverse_stribeck_velocity_or_by_1;
    c->segment_end_or_segment_begin = d_segment_end_or_segment_begin;
}

/* First variation of the guard of leaves_layer. */
static real vary_guard_slip_falling_leaves_layer(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real stribeck_velocity_or_by_1 = select(p->stribeck_velocity > 0.0, p->stribeck_velocity, 1.0);
    const real speed_in_layer = x->way * x->foot_vx / stribeck_velocity_or_by_1;
    const real d_speed_in_layer = (dx->way * x->foot_vx + x->way * dx->foot_vx
        - speed_in_layer * select(p->stribeck_velocity > 0.0, dp->stribeck_velocity,
        0.0)) / stribeck_velocity_or_by_1;
    return -d_speed_in_layer;
}

/* Outputs in slip_falling. */
static void outputs_slip_falling(const real *parameters, const real *states, real *outputs) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const real set_height = p->ground_height + x->segment_height;
    const real set_slope = p->ground_slope + x->segment_slope;
    const real pending = select(real_abs(set_height - x->height) + real_abs(p->free_length * (set_slope
        - x->slope)) > 0.0, 1.0, 0.0);
    const real stance_torque = x->external_torque - (p->drive_torque + p->more_torque) * x->driving;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real shorter = rest_length - length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real spring = p->stiffness * shorter - p->damping * length_rate;
    const real axial = spring / length;
    const real turning = stance_torque / square;
    const real off = axial * x->y_ + turning * x->x_;
    const real cosine = real_cos(x->slope);
    const real normal = off + p->foot_mass * p->gravity * cosine;
    const real own = select(x->way > 0.0, x->friction_ahead, x->friction_behind);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real friction_along = is_own * own + (1.0 - is_own) * x->friction;
    const real fading = real_exp(-(x->way * x->foot_vx / p->stribeck_velocity));
    const real slip_friction = friction_along * (1.0 + (p->static_ratio - 1.0) * fading);
    const real way_times_slip_friction_times_normal = x->way * slip_friction * normal;
    const real tangential_force = -way_times_slip_friction_times_normal;
    const real sine = real_sin(x->slope);
    const real x_2 = -(way_times_slip_friction_times_normal * cosine) - normal * sine;
    const real y_2 = normal * cosine - way_times_slip_friction_times_normal * sine;
    const real foot_x_times_cosine = x->foot_x * cosine;
    const real x__times_cosine_minus_y__times_sine = x->x_ * cosine - x->y_ * sine;
    const real body_x = foot_x_times_cosine + x__times_cosine_minus_y__times_sine;
    const real height_plus_foot_x_times_sine = x->height + x->foot_x * sine;
    const real x__times_sine_plus_y__times_cosine = x->x_ * sine + x->y_ * cosine;
    const real body_y = height_plus_foot_x_times_sine + x__times_sine_plus_y__times_cosine;
    const real foot_vx_times_cosine = x->foot_vx * cosine;
    const real vx = x->vx * cosine - x->vy * sine;
    const real body_vx = foot_vx_times_cosine + vx;
    const real foot_vx_times_sine = x->foot_vx * sine;
    const real vy = x->vx * sine + x->vy * cosine;
    const real body_vy = foot_vx_times_sine + vy;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real center_x = foot_x_times_cosine + share * x__times_cosine_minus_y__times_sine;
    const real center_y = height_plus_foot_x_times_sine + share * x__times_sine_plus_y__times_cosine;
    const real center_vx = foot_vx_times_cosine + share * vx;
    const real center_vy = foot_vx_times_sine + share * vy;
    const real of_body = p->body_mass * (body_vx * body_vx + body_vy * body_vy);
    const real kinetic_energy = 0.5 * (of_body + p->foot_mass * (foot_vx_times_cosine * foot_vx_times_cosine
        + foot_vx_times_sine * foot_vx_times_sine));
    const real potential_energy = p->gravity * (p->body_mass * body_y
        + p->foot_mass * height_plus_foot_x_times_sine);
    const real elastic_energy = 0.5 * (p->stiffness * (shorter * shorter));
    const real energy = kinetic_energy + potential_energy + elastic_energy;
    const real kind_of_contact = select(x->way > 0.0, 3.0, 4.0);
    const real phase_of_hip = select(x->driving > 0.0, 1.0, 2.0);
    outputs[OUTPUT_pending] = pending;
    outputs[OUTPUT_torque] = stance_torque;
    outputs[OUTPUT_normal_force] = normal;
    outputs[OUTPUT_tangential_force] = tangential_force;
    outputs[OUTPUT_ground_force_x] = x_2;
    outputs[OUTPUT_ground_force_y] = y_2;
    outputs[OUTPUT_force_of_leg] = spring;
    outputs[OUTPUT_body_x] = body_x;
    outputs[OUTPUT_body_y] = body_y;
    outputs[OUTPUT_body_vx] = body_vx;
    outputs[OUTPUT_body_vy] = body_vy;
    outputs[OUTPUT_center_x] = center_x;
    outputs[OUTPUT_center_y] = center_y;
    outputs[OUTPUT_center_vx] = center_vx;
    outputs[OUTPUT_center_vy] = center_vy;
    outputs[OUTPUT_kinetic_energy] = kinetic_energy;
    outputs[OUTPUT_potential_energy] = potential_energy;
    outputs[OUTPUT_elastic_energy] = elastic_energy;
    outputs[OUTPUT_energy] = energy;
    outputs[OUTPUT_kind_of_contact] = kind_of_contact;
    outputs[OUTPUT_phase_of_hip] = phase_of_hip;
}

/* First variation of outputs_slip_falling. */
static void vary_outputs_slip_falling(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *outputs) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    const real drive_torque_plus_more_torque = p->drive_torque + p->more_torque;
    const real d_stance_torque = dx->external_torque - ((dp->drive_torque + dp->more_torque) * x->driving
        + drive_torque_plus_more_torque * dx->driving);
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real shorter = rest_length - length;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real d_shorter = d_rest_length - d_length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * shorter + p->stiffness * d_shorter - (dp->damping * length_rate
        + p->damping * d_length_rate);
    const real spring = p->stiffness * shorter - p->damping * length_rate;
    const real axial = spring / length;
    const real d_axial = (d_spring - axial * d_length) / length;
    const real stance_torque = x->external_torque - drive_torque_plus_more_torque * x->driving;
    const real turning = stance_torque / square;
    const real d_turning = (d_stance_torque - turning * d_square) / square;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real cosine = real_cos(x->slope);
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_normal = d_off + ((p->gravity * dp->foot_mass + p->foot_mass * dp->gravity) * cosine
        - foot_mass_times_gravity * sine_times_slope);
    const real own = select(x->way > 0.0, x->friction_ahead, x->friction_behind);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real by_1_minus_is_own = 1.0 - is_own;
    const real friction_along = is_own * own + by_1_minus_is_own * x->friction;
    const real static_ratio_minus_by_1 = p->static_ratio - 1.0;
    const real ratio = x->way * x->foot_vx / p->stribeck_velocity;
    const real fading = real_exp(-ratio);
    const real sum_2 = 1.0 + static_ratio_minus_by_1 * fading;
    const real slip_friction = friction_along * sum_2;
    const real d_own = select(x->way > 0.0, dx->friction_ahead, dx->friction_behind);
    const real d_friction_along = is_own * d_own + by_1_minus_is_own * dx->friction;
    const real d_slip_friction = d_friction_along * sum_2 + friction_along * (dp->static_ratio * fading
        - static_ratio_minus_by_1 * (fading * ((dx->way * x->foot_vx + x->way * dx->foot_vx
        - ratio * dp->stribeck_velocity) / p->stribeck_velocity)));
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + foot_mass_times_gravity * cosine;
    const real way_times_slip_friction = x->way * slip_friction;
    const real sum_3 = (dx->way * slip_friction + x->way * d_slip_friction) * normal
        + way_times_slip_friction * d_normal;
    const real d_tangential_force = -sum_3;
    const real way_times_slip_friction_times_normal = way_times_slip_friction * normal;
    const real d_sine = cosine * dx->slope;
    const real d_x = -(sum_3 * cosine - way_times_slip_friction_times_normal * sine_times_slope)
        - (d_normal * sine + normal * d_sine);
    const real d_y = d_normal * cosine - normal * sine_times_slope - (sum_3 * sine
        + way_times_slip_friction_times_normal * d_sine);
    const real sum_4 = dx->foot_x * cosine - x->foot_x * sine_times_slope;
    const real sum_5 = dx->x_ * cosine - x->x_ * sine_times_slope - (dx->y_ * sine + x->y_ * d_sine);
    const real d_body_x = sum_4 + sum_5;
    const real height_plus_sum = dx->height + (dx->foot_x * sine + x->foot_x * d_sine);
    const real sum_6 = dx->x_ * sine + x->x_ * d_sine + (dx->y_ * cosine - x->y_ * sine_times_slope);
    const real d_body_y = height_plus_sum + sum_6;
    const real sum_7 = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
    const real d_vx = dx->vx * cosine - x->vx * sine_times_slope - (dx->vy * sine + x->vy * d_sine);
    const real d_body_vx = sum_7 + d_vx;
    const real sum_8 = dx->foot_vx * sine + x->foot_vx * d_sine;
    const real d_vy = dx->vx * sine + x->vx * d_sine + (dx->vy * cosine - x->vy * sine_times_slope);
    const real d_body_vy = sum_8 + d_vy;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_center_x = sum_4 + (d_share * (x->x_ * cosine - x->y_ * sine) + share * sum_5);
    const real x__times_sine_plus_y__times_cosine = x->x_ * sine + x->y_ * cosine;
    const real d_center_y = height_plus_sum + (d_share * x__times_sine_plus_y__times_cosine + share * sum_6);
    const real vx = x->vx * cosine - x->vy * sine;
    const real d_center_vx = sum_7 + (d_share * vx + share * d_vx);
    const real vy = x->vx * sine + x->vy * cosine;
    const real d_center_vy = sum_8 + (d_share * vy + share * d_vy);
    const real foot_vx_times_cosine = x->foot_vx * cosine;
    const real body_vx = foot_vx_times_cosine + vx;
    const real foot_vx_times_sine = x->foot_vx * sine;
    const real body_vy = foot_vx_times_sine + vy;
    const real d_of_body = dp->body_mass * (body_vx * body_vx + body_vy * body_vy)
        + p->body_mass * (2.0 * (body_vx * d_body_vx) + 2.0 * (body_vy * d_body_vy));
    const real d_kinetic_energy = 0.5 * (d_of_body
        + (dp->foot_mass * (foot_vx_times_cosine * foot_vx_times_cosine
        + foot_vx_times_sine * foot_vx_times_sine) + p->foot_mass * (2.0 * (foot_vx_times_cosine * sum_7)
        + 2.0 * (foot_vx_times_sine * sum_8))));
    const real height_plus_foot_x_times_sine = x->height + x->foot_x * sine;
    const real body_y = height_plus_foot_x_times_sine + x__times_sine_plus_y__times_cosine;
    const real d_potential_energy = dp->gravity * (p->body_mass * body_y
        + p->foot_mass * height_plus_foot_x_times_sine) + p->gravity * (dp->body_mass * body_y
        + p->body_mass * d_body_y + (dp->foot_mass * height_plus_foot_x_times_sine
        + p->foot_mass * height_plus_sum));
    const real d_elastic_energy = 0.5 * (dp->stiffness * (shorter * shorter)
        + p->stiffness * (2.0 * (shorter * d_shorter)));
    const real d_energy = d_kinetic_energy + d_potential_energy + d_elastic_energy;
    outputs[OUTPUT_pending] = 0.0;
    outputs[OUTPUT_torque] = d_stance_torque;
    outputs[OUTPUT_normal_force] = d_normal;
    outputs[OUTPUT_tangential_force] = d_tangential_force;
    outputs[OUTPUT_ground_force_x] = d_x;
    outputs[OUTPUT_ground_force_y] = d_y;
    outputs[OUTPUT_force_of_leg] = d_spring;
    outputs[OUTPUT_body_x] = d_body_x;
    outputs[OUTPUT_body_y] = d_body_y;
    outputs[OUTPUT_body_vx] = d_body_vx;
    outputs[OUTPUT_body_vy] = d_body_vy;
    outputs[OUTPUT_center_x] = d_center_x;
    outputs[OUTPUT_center_y] = d_center_y;
    outputs[OUTPUT_center_vx] = d_center_vx;
    outputs[OUTPUT_center_vy] = d_center_vy;
    outputs[OUTPUT_kinetic_energy] = d_kinetic_energy;
    outputs[OUTPUT_potential_energy] = d_potential_energy;
    outputs[OUTPUT_elastic_energy] = d_elastic_energy;
    outputs[OUTPUT_energy] = d_energy;
    outputs[OUTPUT_kind_of_contact] = 0.0;
    outputs[OUTPUT_phase_of_hip] = 0.0;
}

/* Time scale. */
static real time_scale_slip_falling(const real *parameters, const real *states) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const real static_ratio_minus_by_1 = p->static_ratio - 1.0;
    const real own = select(x->way > 0.0, x->friction_ahead, x->friction_behind);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real friction_along = is_own * own + (1.0 - is_own) * x->friction;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real spring = p->stiffness * (rest_length - length) - p->damping * length_rate;
    const real axial = spring / length;
    const real stance_torque = x->external_torque - (p->drive_torque + p->more_torque) * x->driving;
    const real turning = stance_torque / square;
    const real off = axial * x->y_ + turning * x->x_;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real cosine = real_cos(x->slope);
    const real normal = off + foot_mass_times_gravity * cosine;
    const real growth = static_ratio_minus_by_1 * friction_along * normal / p->stribeck_velocity;
    const real by_growth = p->foot_mass / real_abs(growth);
    const real along = axial * x->x_ - turning * x->y_;
    const real sine = real_sin(x->slope);
    const real fading = real_exp(-(x->way * x->foot_vx / p->stribeck_velocity));
    const real slip_friction = friction_along * (1.0 + static_ratio_minus_by_1 * fading);
    const real force = along + foot_mass_times_gravity * sine + x->way * slip_friction * normal;
    const real by_speed = p->stribeck_velocity * p->foot_mass / real_abs(force);
    const real time_scale_of_slip = select(by_growth < by_speed, by_growth, by_speed);
    return time_scale_of_slip;
}

/* Rates of the world's states in slip. */
static void world_rates_slip_falling(const real *parameters, const real *states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real cosine = real_cos(x->slope);
    const real vx = x->foot_vx * cosine;
    const real sine = real_sin(x->slope);
    const real vy = x->foot_vx * sine;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real x__times_vx = x->x_ * x->vx;
    const real y__times_vy = x->y_ * x->vy;
    const real length_rate = (x__times_vx + y__times_vy) / length;
    const real spring = p->stiffness * (rest_length - length) - p->damping * length_rate;
    const real axial = spring / length;
    const real stance_torque = x->external_torque - (p->drive_torque + p->more_torque) * x->driving;
    const real turning = stance_torque / square;
    const real along = axial * x->x_ - turning * x->y_;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real own = select(x->way > 0.0, x->friction_ahead, x->friction_behind);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real friction_along = is_own * own + (1.0 - is_own) * x->friction;
    const real fading = real_exp(-(x->way * x->foot_vx / p->stribeck_velocity));
    const real slip_friction = friction_along * (1.0 + (p->static_ratio - 1.0) * fading);
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + foot_mass_times_gravity * cosine;
    const real friction_force = x->way * slip_friction * normal;
    const real acceleration = (-(along + foot_mass_times_gravity * sine) - friction_force) / p->foot_mass;
    const real sum_2 = 2.0 * x__times_vx + 2.0 * y__times_vy;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real sum_minus_acceleration = (along + (x->external_fx * cosine
        + x->external_fy * sine)) / p->body_mass - p->gravity * sine - acceleration;
    const real sum_3 = (off + (x->external_fy * cosine - x->external_fx * sine)) / p->body_mass
        - p->gravity * cosine;
    y->seen_x = vx;
    y->seen_y = vy;
    y->seen_vx = acceleration * cosine;
    y->seen_vy = acceleration * sine;
    y->length = 0.5 * sum_2 / length;
    y->angle = angle_rate;
    y->length_rate = (x->vx * x->vx + x->x_ * sum_minus_acceleration + (x->vy * x->vy + x->y_ * sum_3)
        - length_rate * (0.5 * sum_2 / length)) / length;
    y->angle_rate = (x->vx * x->vy + x->x_ * sum_3 - (x->vy * x->vx + x->y_ * sum_minus_acceleration)
        - angle_rate * sum_2) / square;
}

/* First variation of world_rates_slip_falling. */
static void vary_world_rates_slip_falling(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_vx = dx->foot_vx * cosine - x->foot_vx * sine_times_slope;
    const real d_sine = cosine * dx->slope;
    const real d_vy = dx->foot_vx * sine + x->foot_vx * d_sine;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real rest_length_minus_length = rest_length - length;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real x__times_vx = x->x_ * x->vx;
    const real y__times_vy = x->y_ * x->vy;
    const real length_rate = (x__times_vx + y__times_vy) / length;
    const real x__times_vx_plus_x__times_vx = dx->x_ * x->vx + x->x_ * dx->vx;
    const real y__times_vy_plus_y__times_vy = dx->y_ * x->vy + x->y_ * dx->vy;
    const real d_length_rate = (x__times_vx_plus_x__times_vx + y__times_vy_plus_y__times_vy
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * rest_length_minus_length + p->stiffness * (d_rest_length
        - d_length) - (dp->damping * length_rate + p->damping * d_length_rate);
    const real spring = p->stiffness * rest_length_minus_length - p->damping * length_rate;
    const real axial = spring / length;
    const real d_axial = (d_spring - axial * d_length) / length;
    const real drive_torque_plus_more_torque = p->drive_torque + p->more_torque;
    const real d_stance_torque = dx->external_torque - ((dp->drive_torque + dp->more_torque) * x->driving
        + drive_torque_plus_more_torque * dx->driving);
    const real stance_torque = x->external_torque - drive_torque_plus_more_torque * x->driving;
    const real turning = stance_torque / square;
    const real d_turning = (d_stance_torque - turning * d_square) / square;
    const real d_along = d_axial * x->x_ + axial * dx->x_ - (d_turning * x->y_ + turning * dx->y_);
    const real sum_2 = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real own = select(x->way > 0.0, x->friction_ahead, x->friction_behind);
    const real is_own = select(own < 0.0, 0.0, 1.0);
    const real by_1_minus_is_own = 1.0 - is_own;
    const real friction_along = is_own * own + by_1_minus_is_own * x->friction;
    const real static_ratio_minus_by_1 = p->static_ratio - 1.0;
    const real ratio = x->way * x->foot_vx / p->stribeck_velocity;
    const real fading = real_exp(-ratio);
    const real sum_3 = 1.0 + static_ratio_minus_by_1 * fading;
    const real slip_friction = friction_along * sum_3;
    const real d_own = select(x->way > 0.0, dx->friction_ahead, dx->friction_behind);
    const real d_friction_along = is_own * d_own + by_1_minus_is_own * dx->friction;
    const real d_slip_friction = d_friction_along * sum_3 + friction_along * (dp->static_ratio * fading
        - static_ratio_minus_by_1 * (fading * ((dx->way * x->foot_vx + x->way * dx->foot_vx
        - ratio * dp->stribeck_velocity) / p->stribeck_velocity)));
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + foot_mass_times_gravity * cosine;
    const real way_times_slip_friction = x->way * slip_friction;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real d_normal = d_off + (sum_2 * cosine - foot_mass_times_gravity * sine_times_slope);
    const real d_friction_force = (dx->way * slip_friction + x->way * d_slip_friction) * normal
        + way_times_slip_friction * d_normal;
    const real along = axial * x->x_ - turning * x->y_;
    const real friction_force = way_times_slip_friction * normal;
    const real acceleration = (-(along + foot_mass_times_gravity * sine) - friction_force) / p->foot_mass;
    const real d_acceleration = (-(d_along + (sum_2 * sine + foot_mass_times_gravity * d_sine))
        - d_friction_force - acceleration * dp->foot_mass) / p->foot_mass;
    const real sum_4 = 2.0 * x__times_vx_plus_x__times_vx + 2.0 * y__times_vy_plus_y__times_vy;
    const real sum_5 = 2.0 * x__times_vx + 2.0 * y__times_vy;
    const real by_0_5_times_sum_over_length = 0.5 * sum_5 / length;
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
    const real along_plus_sum_over_body_mass = (along + (x->external_fx * cosine
        + x->external_fy * sine)) / p->body_mass;
    const real sum_minus_acceleration = along_plus_sum_over_body_mass - p->gravity * sine - acceleration;
    const real ratio_minus_sum_minus_d_acceleration = (d_along + (dx->external_fx * cosine
        - x->external_fx * sine_times_slope + (dx->external_fy * sine + x->external_fy * d_sine))
        - along_plus_sum_over_body_mass * dp->body_mass) / p->body_mass - (dp->gravity * sine
        + p->gravity * d_sine) - d_acceleration;
    const real off_plus_sum_over_body_mass = (off + (x->external_fy * cosine
        - x->external_fx * sine)) / p->body_mass;
    const real sum_6 = off_plus_sum_over_body_mass - p->gravity * cosine;
    const real ratio_minus_sum = (d_off + (dx->external_fy * cosine - x->external_fy * sine_times_slope
        - (dx->external_fx * sine + x->external_fx * d_sine))
        - off_plus_sum_over_body_mass * dp->body_mass) / p->body_mass - (dp->gravity * cosine
        - p->gravity * sine_times_slope);
    y->seen_x = d_vx;
    y->seen_y = d_vy;
    y->seen_vx = d_acceleration * cosine - acceleration * sine_times_slope;
    y->seen_vy = d_acceleration * sine + acceleration * d_sine;
    y->length = (0.5 * sum_4 - by_0_5_times_sum_over_length * d_length) / length;
    y->angle = d_angle_rate;
    y->length_rate = (2.0 * (x->vx * dx->vx) + (dx->x_ * sum_minus_acceleration
        + x->x_ * ratio_minus_sum_minus_d_acceleration) + (2.0 * (x->vy * dx->vy) + (dx->y_ * sum_6
        + x->y_ * ratio_minus_sum)) - (d_length_rate * by_0_5_times_sum_over_length
        + length_rate * ((0.5 * sum_4 - by_0_5_times_sum_over_length * d_length) / length)) - (x->vx * x->vx
        + x->x_ * sum_minus_acceleration + (x->vy * x->vy + x->y_ * sum_6)
        - length_rate * by_0_5_times_sum_over_length) / length * d_length) / length;
    y->angle_rate = (dx->vx * x->vy + x->vx * dx->vy + (dx->x_ * sum_6 + x->x_ * ratio_minus_sum)
        - (dx->vy * x->vx + x->vy * dx->vx + (dx->y_ * sum_minus_acceleration
        + x->y_ * ratio_minus_sum_minus_d_acceleration)) - (d_angle_rate * sum_5 + angle_rate * sum_4)
        - (x->vx * x->vy + x->x_ * sum_6 - (x->vy * x->vx + x->y_ * sum_minus_acceleration)
        - angle_rate * sum_5) / square * d_square) / square;
}

/* Constants of flight_pushed. */
static void open_flight_pushed(const real *parameters, const real *states, real *constants) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    flight_pushed_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real mobility = inverse_body_mass + 1.0 / p->foot_mass;
    const real longer = p->thrust + p->more_thrust;
    const real thrusting_times_longer_or_by_0 = x->thrusting * select(longer >= 0.0, longer, 0.0);
    const real total_mass = p->body_mass + p->foot_mass;
    const real inverse_total_mass = 1.0 / total_mass;
    const real share = select(x->swing > 0.0, 1.0, 0.0);
    const real share_times_kp = share * p->kp;
    const real liftoff_factor_times_liftoff_angle = p->liftoff_factor * x->liftoff_angle;
    const real placing_angle = p->touchdown_angle + p->more_angle;
    const real first = select(x->swing < 2.0, liftoff_factor_times_liftoff_angle, placing_angle);
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real turn = is_placing * p->retraction_rate;
    const real share_times_kd = share * p->kd;
    const real stiffness_times_extension_rate = p->stiffness * x->extension_rate;
    const real body_mass_over_total_mass = p->body_mass / total_mass;
    const real by_1_minus_body_mass_over_total_mass = 1.0 - body_mass_over_total_mass;
    const real set_slope = p->ground_slope + x->segment_slope;
    const real cos_of_set_slope = real_cos(set_slope);
    const real set_height = p->ground_height + x->segment_height;
    const real sin_of_set_slope = real_sin(set_slope);
    const real cos_of_slope = real_cos(x->slope);
    const real sin_of_slope = real_sin(x->slope);
    const real inverse_cos_of_slope = 1.0 / cos_of_slope;
    c->inverse_body_mass = inverse_body_mass;
    c->mobility = mobility;
    c->stiffness = p->stiffness;
    c->free_length = p->free_length;
    c->thrusting_times_longer_or_by_0 = thrusting_times_longer_or_by_0;
    c->damping = p->damping;
    c->inverse_total_mass = inverse_total_mass;
    c->gravity = p->gravity;
    c->kp = p->kp;
    c->share_times_kp = share_times_kp;
    c->liftoff_factor_times_liftoff_angle = liftoff_factor_times_liftoff_angle;
    c->first = first;
    c->is_placing = is_placing;
    c->turn = turn;
    c->kd = p->kd;
    c->share_times_kd = share_times_kd;
    c->extension_rate = x->extension_rate;
    c->stiffness_times_extension_rate = stiffness_times_extension_rate;
    c->body_mass_over_total_mass = body_mass_over_total_mass;
    c->by_1_minus_body_mass_over_total_mass = by_1_minus_body_mass_over_total_mass;
    c->external_fx_rate = x->external_fx_rate;
    c->external_fy_rate = x->external_fy_rate;
    c->friction_rate = x->friction_rate;
    c->external_torque_rate = x->external_torque_rate;
    c->segment_end = x->segment_end;
    c->segment_begin = x->segment_begin;
    c->set_slope = set_slope;
    c->cos_of_set_slope = cos_of_set_slope;
    c->set_height = set_height;
    c->sin_of_set_slope = sin_of_set_slope;
    c->slope = x->slope;
    c->cos_of_slope = cos_of_slope;
    c->height = x->height;
    c->sin_of_slope = sin_of_slope;
    c->least_length = p->least_length;
    c->inverse_cos_of_slope = inverse_cos_of_slope;
}

/* First variation of open_flight_pushed. */
static void vary_open_flight_pushed(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    flight_pushed_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real d_inverse_body_mass = -(inverse_body_mass * dp->body_mass / p->body_mass);
    const real d_mobility = d_inverse_body_mass - 1.0 / p->foot_mass * dp->foot_mass / p->foot_mass;
    const real longer = p->thrust + p->more_thrust;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_thrusting_times_longer_or_by_0 = select(longer >= 0.0, longer, 0.0) * dx->thrusting
        + x->thrusting * select(longer >= 0.0, d_longer, 0.0);
    const real total_mass = p->body_mass + p->foot_mass;
    const real inverse_total_mass = 1.0 / total_mass;
    const real d_total_mass = dp->body_mass + dp->foot_mass;
    const real d_inverse_total_mass = -(inverse_total_mass * d_total_mass / total_mass);
    const real share = select(x->swing > 0.0, 1.0, 0.0);
    const real d_share_times_kp = share * dp->kp;
    const real d_liftoff_factor_times_liftoff_angle = x->liftoff_angle * dp->liftoff_factor
        + p->liftoff_factor * dx->liftoff_angle;
    const real d_placing_angle = dp->touchdown_angle + dp->more_angle;
    const real d_first = select(x->swing < 2.0, d_liftoff_factor_times_liftoff_angle, d_placing_angle);
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real d_turn = is_placing * dp->retraction_rate;
    const real d_share_times_kd = share * dp->kd;
    const real d_stiffness_times_extension_rate = x->extension_rate * dp->stiffness
        + p->stiffness * dx->extension_rate;
    const real body_mass_over_total_mass = p->body_mass / total_mass;
    const real d_body_mass_over_total_mass = (dp->body_mass
        - body_mass_over_total_mass * d_total_mass) / total_mass;
    const real d_by_1_minus_body_mass_over_total_mass = -d_body_mass_over_total_mass;
    const real d_set_slope = dp->ground_slope + dx->segment_slope;
    const real set_slope = p->ground_slope + x->segment_slope;
    const real sin_of_set_slope = real_sin(set_slope);
    const real d_cos_of_set_slope = -(sin_of_set_slope * d_set_slope);
    const real d_set_height = dp->ground_height + dx->segment_height;
    const real cos_of_set_slope = real_cos(set_slope);
    const real d_sin_of_set_slope = cos_of_set_slope * d_set_slope;
    const real sin_of_slope = real_sin(x->slope);
    const real sin_of_slope_times_slope = sin_of_slope * dx->slope;
    const real d_cos_of_slope = -sin_of_slope_times_slope;
    const real cos_of_slope = real_cos(x->slope);
    const real d_sin_of_slope = cos_of_slope * dx->slope;
    const real inverse_cos_of_slope = 1.0 / cos_of_slope;
    const real d_inverse_cos_of_slope = inverse_cos_of_slope * sin_of_slope_times_slope / cos_of_slope;
    c->inverse_body_mass = d_inverse_body_mass;
    c->mobility = d_mobility;
    c->stiffness = dp->stiffness;
    c->free_length = dp->free_length;
    c->thrusting_times_longer_or_by_0 = d_thrusting_times_longer_or_by_0;
    c->damping = dp->damping;
    c->inverse_total_mass = d_inverse_total_mass;
    c->gravity = dp->gravity;
    c->kp = dp->kp;
    c->share_times_kp = d_share_times_kp;
    c->liftoff_factor_times_liftoff_angle = d_liftoff_factor_times_liftoff_angle;
    c->first = d_first;
    c->is_placing = 0.0;
    c->turn = d_turn;
    c->kd = dp->kd;
    c->share_times_kd = d_share_times_kd;
    c->extension_rate = dx->extension_rate;
    c->stiffness_times_extension_rate = d_stiffness_times_extension_rate;
    c->body_mass_over_total_mass = d_body_mass_over_total_mass;
    c->by_1_minus_body_mass_over_total_mass = d_by_1_minus_body_mass_over_total_mass;
    c->external_fx_rate = dx->external_fx_rate;
    c->external_fy_rate = dx->external_fy_rate;
    c->friction_rate = dx->friction_rate;
    c->external_torque_rate = dx->external_torque_rate;
    c->segment_end = dx->segment_end;
    c->segment_begin = dx->segment_begin;
    c->set_slope = d_set_slope;
    c->cos_of_set_slope = d_cos_of_set_slope;
    c->set_height = d_set_height;
    c->sin_of_set_slope = d_sin_of_set_slope;
    c->slope = dx->slope;
    c->cos_of_slope = d_cos_of_slope;
    c->height = dx->height;
    c->sin_of_slope = d_sin_of_slope;
    c->least_length = dp->least_length;
    c->inverse_cos_of_slope = d_inverse_cos_of_slope;
}

/* Rates of the world's states in flight. */
static void world_rates_flight_pushed(const real *parameters, const real *states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real total_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / total_mass;
    const real sine = real_sin(x->angle);
    const real cosine = real_cos(x->angle);
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real cosine_times_rate = cosine * rate;
    const real sine_times_rate = sine * rate;
    const real mobility = 1.0 / p->body_mass + 1.0 / p->foot_mass;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real spring = p->stiffness * (rest_length - x->length) - p->damping * x->length_rate;
    const real axial = x->external_fy * cosine - x->external_fx * sine;
    const real sum_plus_axial_over_body_mass = x->length * (rate * rate) + mobility * spring
        + axial / p->body_mass;
    const real by_1_or_by_0 = select(x->swing > 0.0, 1.0, 0.0);
    const real placing_angle = p->touchdown_angle + p->more_angle;
    const real first = select(x->swing < 2.0, p->liftoff_factor * x->liftoff_angle, placing_angle);
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real retraction_rate_times_is_placing = p->retraction_rate * is_placing;
    const real servo = -(p->kp * by_1_or_by_0 * (x->angle - (first
        - retraction_rate_times_is_placing * x->placing))) - p->kd * by_1_or_by_0 * (rate
        + retraction_rate_times_is_placing);
    const real swing_torque = x->external_torque + servo;
    const real sum_2 = mobility * swing_torque - x->length * (x->external_fx * cosine
        + x->external_fy * sine) / p->body_mass;
    const real turn = x->momentum / x->length;
    const real ratio = (sum_2 - turn * x->length_rate) / x->length;
    y->seen_x = x->com_vx + share * (x->length_rate * sine + x->length * cosine_times_rate);
    y->seen_y = x->com_vy - share * (x->length_rate * cosine - x->length * sine_times_rate);
    y->seen_vx = x->external_fx / total_mass - share * (-(sum_plus_axial_over_body_mass * sine
        + x->length_rate * cosine_times_rate) - (ratio * cosine - turn * sine_times_rate));
    y->seen_vy = x->external_fy / total_mass - p->gravity - share * (sum_plus_axial_over_body_mass * cosine
        - x->length_rate * sine_times_rate - (ratio * sine + turn * cosine_times_rate));
    y->length = x->length_rate;
    y->angle = rate;
    y->length_rate = sum_plus_axial_over_body_mass;
    y->angle_rate = (sum_2 - rate * (2.0 * (x->length * x->length_rate))) / square;
}

/* First variation of world_rates_flight_pushed. */
static void vary_world_rates_flight_pushed(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real total_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / total_mass;
    const real d_total_mass = dp->body_mass + dp->foot_mass;
    const real d_share = (dp->body_mass - share * d_total_mass) / total_mass;
    const real sine = real_sin(x->angle);
    const real cosine = real_cos(x->angle);
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real cosine_times_rate = cosine * rate;
    const real d_sine = cosine * dx->angle;
    const real d_square = 2.0 * (x->length * dx->length);
    const real d_rate = (dx->momentum - rate * d_square) / square;
    const real sine_times_angle = sine * dx->angle;
    const real sum_2 = cosine * d_rate - sine_times_angle * rate;
    const real sine_times_rate = sine * rate;
    const real sum_3 = d_sine * rate + sine * d_rate;
    const real rate_times_rate = rate * rate;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real mobility = inverse_body_mass + inverse_foot_mass;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = p->free_length + x->extension + longer_or_by_0 * x->thrusting;
    const real rest_length_minus_length = rest_length - x->length;
    const real spring = p->stiffness * rest_length_minus_length - p->damping * x->length_rate;
    const real axial = x->external_fy * cosine - x->external_fx * sine;
    const real axial_over_body_mass = axial / p->body_mass;
    const real sum_plus_axial_over_body_mass = x->length * rate_times_rate + mobility * spring
        + axial_over_body_mass;
    const real by_1_or_by_0 = select(x->swing > 0.0, 1.0, 0.0);
    const real kp_times_by_1_or_by_0 = p->kp * by_1_or_by_0;
    const real placing_angle = p->touchdown_angle + p->more_angle;
    const real first = select(x->swing < 2.0, p->liftoff_factor * x->liftoff_angle, placing_angle);
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real retraction_rate_times_is_placing = p->retraction_rate * is_placing;
    const real angle_minus_first_minus_product = x->angle - (first
        - retraction_rate_times_is_placing * x->placing);
    const real kd_times_by_1_or_by_0 = p->kd * by_1_or_by_0;
    const real sum_4 = rate + retraction_rate_times_is_placing;
    const real servo = -(kp_times_by_1_or_by_0 * angle_minus_first_minus_product)
        - kd_times_by_1_or_by_0 * sum_4;
    const real swing_torque = x->external_torque + servo;
    const real sum_5 = x->external_fx * cosine + x->external_fy * sine;
    const real length_times_sum_over_body_mass = x->length * sum_5 / p->body_mass;
    const real sum_6 = mobility * swing_torque - length_times_sum_over_body_mass;
    const real turn = x->momentum / x->length;
    const real ratio = (sum_6 - turn * x->length_rate) / x->length;
    const real d_mobility = -(inverse_body_mass * dp->body_mass / p->body_mass)
        - inverse_foot_mass * dp->foot_mass / p->foot_mass;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, d_longer,
        0.0) * x->thrusting + longer_or_by_0 * dx->thrusting);
    const real d_spring = dp->stiffness * rest_length_minus_length + p->stiffness * (d_rest_length
        - dx->length) - (dp->damping * x->length_rate + p->damping * dx->length_rate);
    const real d_axial = dx->external_fy * cosine - x->external_fy * sine_times_angle
        - (dx->external_fx * sine + x->external_fx * d_sine);
    const real sum_plus_sum_plus_sum_over_body_mass = dx->length * rate_times_rate
        + x->length * (2.0 * (rate * d_rate)) + (d_mobility * spring + mobility * d_spring) + (d_axial
        - axial_over_body_mass * dp->body_mass) / p->body_mass;
    const real d_placing_angle = dp->touchdown_angle + dp->more_angle;
    const real d_first = select(x->swing < 2.0, dp->liftoff_factor * x->liftoff_angle
        + p->liftoff_factor * dx->liftoff_angle, d_placing_angle);
    const real retraction_rate_times_is_placing_2 = dp->retraction_rate * is_placing;
    const real d_servo = -(dp->kp * by_1_or_by_0 * angle_minus_first_minus_product
        + kp_times_by_1_or_by_0 * (dx->angle - (d_first - (retraction_rate_times_is_placing_2 * x->placing
        + retraction_rate_times_is_placing * dx->placing)))) - (dp->kd * by_1_or_by_0 * sum_4
        + kd_times_by_1_or_by_0 * (d_rate + retraction_rate_times_is_placing_2));
    const real d_swing_torque = dx->external_torque + d_servo;
    const real sum_7 = d_mobility * swing_torque + mobility * d_swing_torque - (dx->length * sum_5
        + x->length * (dx->external_fx * cosine - x->external_fx * sine_times_angle
        + (dx->external_fy * sine + x->external_fy * d_sine))
        - length_times_sum_over_body_mass * dp->body_mass) / p->body_mass;
    const real d_turn = (dx->momentum - turn * dx->length) / x->length;
    const real ratio_2 = (sum_7 - (d_turn * x->length_rate + turn * dx->length_rate)
        - ratio * dx->length) / x->length;
    const real by_2_times_length_times_length_rate = 2.0 * (x->length * x->length_rate);
    y->seen_x = dx->com_vx + (d_share * (x->length_rate * sine + x->length * cosine_times_rate)
        + share * (dx->length_rate * sine + x->length_rate * d_sine + (dx->length * cosine_times_rate
        + x->length * sum_2)));
    y->seen_y = dx->com_vy - (d_share * (x->length_rate * cosine - x->length * sine_times_rate)
        + share * (dx->length_rate * cosine - x->length_rate * sine_times_angle
        - (dx->length * sine_times_rate + x->length * sum_3)));
    y->seen_vx = (dx->external_fx - x->external_fx / total_mass * d_total_mass) / total_mass
        - (d_share * (-(sum_plus_axial_over_body_mass * sine + x->length_rate * cosine_times_rate)
        - (ratio * cosine - turn * sine_times_rate))
        + share * (-(sum_plus_sum_plus_sum_over_body_mass * sine + sum_plus_axial_over_body_mass * d_sine
        + (dx->length_rate * cosine_times_rate + x->length_rate * sum_2)) - (ratio_2 * cosine
        - ratio * sine_times_angle - (d_turn * sine_times_rate + turn * sum_3))));
    y->seen_vy = (dx->external_fy - x->external_fy / total_mass * d_total_mass) / total_mass - dp->gravity
        - (d_share * (sum_plus_axial_over_body_mass * cosine - x->length_rate * sine_times_rate
        - (ratio * sine + turn * cosine_times_rate))
        + share * (sum_plus_sum_plus_sum_over_body_mass * cosine
        - sum_plus_axial_over_body_mass * sine_times_angle - (dx->length_rate * sine_times_rate
        + x->length_rate * sum_3) - (ratio_2 * sine + ratio * d_sine + (d_turn * cosine_times_rate
        + turn * sum_2))));
    y->length = dx->length_rate;
    y->angle = d_rate;
    y->length_rate = sum_plus_sum_plus_sum_over_body_mass;
    y->angle_rate = (sum_7 - (d_rate * by_2_times_length_times_length_rate
        + rate * (2.0 * (dx->length * x->length_rate + x->length * dx->length_rate))) - (sum_6
        - rate * by_2_times_length_times_length_rate) / square * d_square) / square;
}

/* extension is set: Work that a jump of the rest length does on the spring. */
static void set_extension_start_of_run(const real *parameters, const real *states, real given, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0_times_thrusting = select(longer >= 0.0, longer, 0.0) * x->thrusting;
    const real rest_length = p->free_length + given + longer_or_by_0_times_thrusting;
    const real sum_2 = p->free_length + x->extension + longer_or_by_0_times_thrusting;
    const real jump = rest_length - sum_2;
    const real middle = sum_2 + 0.5 * jump - x->length;
    const real work = p->stiffness * jump * middle;
    const real begins = select(x->thrusting > x->thrusting, select(work >= 0.0, work, 0.0), 0.0);
    y->leg_work = x->leg_work + work;
    y->positive_leg_work = x->positive_leg_work + select(work > 0.0, work, begins);
}

/* extension is set: Work that a jump of the rest length does on the spring. */
static void set_extension_slip_constant(const real *parameters, const real *states, real given, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0_times_thrusting = select(longer >= 0.0, longer, 0.0) * x->thrusting;
    const real rest_length = p->free_length + given + longer_or_by_0_times_thrusting;
    const real sum_2 = p->free_length + x->extension + longer_or_by_0_times_thrusting;
    const real jump = rest_length - sum_2;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real middle = sum_2 + 0.5 * jump - length;
    const real work = p->stiffness * jump * middle;
    const real begins = select(x->thrusting > x->thrusting, select(work >= 0.0, work, 0.0), 0.0);
    y->leg_work = x->leg_work + work;
    y->positive_leg_work = x->positive_leg_work + select(work > 0.0, work, begins);
}

/* thrust is set: Work that a jump of the rest length does on the spring. */
static void set_thrust_start_of_run(const real *parameters, const real *states, real given, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real free_length_plus_extension = p->free_length + x->extension;
    const real longer = given + p->more_thrust;
    const real rest_length = free_length_plus_extension + select(longer >= 0.0, longer, 0.0) * x->thrusting;
    const real thrust_plus_more_thrust = p->thrust + p->more_thrust;
    const real free_length_plus_extension_plus_product = free_length_plus_extension
        + select(thrust_plus_more_thrust >= 0.0, thrust_plus_more_thrust, 0.0) * x->thrusting;
    const real jump = rest_length - free_length_plus_extension_plus_product;
    const real middle = free_length_plus_extension_plus_product + 0.5 * jump - x->length;
    const real work = p->stiffness * jump * middle;
    const real begins = select(x->thrusting > x->thrusting, select(work >= 0.0, work, 0.0), 0.0);
    y->leg_work = x->leg_work + work;
    y->positive_leg_work = x->positive_leg_work + select(work > 0.0, work, begins);
}

/* thrust is set: Work that a jump of the rest length does on the spring. */
static void set_thrust_slip_constant(const real *parameters, const real *states, real given, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real free_length_plus_extension = p->free_length + x->extension;
    const real longer = given + p->more_thrust;
    const real rest_length = free_length_plus_extension + select(longer >= 0.0, longer, 0.0) * x->thrusting;
    const real thrust_plus_more_thrust = p->thrust + p->more_thrust;
    const real free_length_plus_extension_plus_product = free_length_plus_extension
        + select(thrust_plus_more_thrust >= 0.0, thrust_plus_more_thrust, 0.0) * x->thrusting;
    const real jump = rest_length - free_length_plus_extension_plus_product;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real middle = free_length_plus_extension_plus_product + 0.5 * jump - length;
    const real work = p->stiffness * jump * middle;
    const real begins = select(x->thrusting > x->thrusting, select(work >= 0.0, work, 0.0), 0.0);
    y->leg_work = x->leg_work + work;
    y->positive_leg_work = x->positive_leg_work + select(work > 0.0, work, begins);
}

/* more_thrust is set: Work that a jump of the rest length does on the spring. */
static void set_more_thrust_start_of_run(const real *parameters, const real *states, real given,
    real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real free_length_plus_extension = p->free_length + x->extension;
    const real longer = p->thrust + given;
    const real rest_length = free_length_plus_extension + select(longer >= 0.0, longer, 0.0) * x->thrusting;
    const real thrust_plus_more_thrust = p->thrust + p->more_thrust;
    const real free_length_plus_extension_plus_product = free_length_plus_extension
        + select(thrust_plus_more_thrust >= 0.0, thrust_plus_more_thrust, 0.0) * x->thrusting;
    const real jump = rest_length - free_length_plus_extension_plus_product;
    const real middle = free_length_plus_extension_plus_product + 0.5 * jump - x->length;
    const real work = p->stiffness * jump * middle;
    const real begins = select(x->thrusting > x->thrusting, select(work >= 0.0, work, 0.0), 0.0);
    y->leg_work = x->leg_work + work;
    y->positive_leg_work = x->positive_leg_work + select(work > 0.0, work, begins);
}

/* more_thrust is set: Work that a jump of the rest length does on the spring. */
static void set_more_thrust_slip_constant(const real *parameters, const real *states, real given,
    real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real free_length_plus_extension = p->free_length + x->extension;
    const real longer = p->thrust + given;
    const real rest_length = free_length_plus_extension + select(longer >= 0.0, longer, 0.0) * x->thrusting;
    const real thrust_plus_more_thrust = p->thrust + p->more_thrust;
    const real free_length_plus_extension_plus_product = free_length_plus_extension
        + select(thrust_plus_more_thrust >= 0.0, thrust_plus_more_thrust, 0.0) * x->thrusting;
    const real jump = rest_length - free_length_plus_extension_plus_product;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real middle = free_length_plus_extension_plus_product + 0.5 * jump - length;
    const real work = p->stiffness * jump * middle;
    const real begins = select(x->thrusting > x->thrusting, select(work >= 0.0, work, 0.0), 0.0);
    y->leg_work = x->leg_work + work;
    y->positive_leg_work = x->positive_leg_work + select(work > 0.0, work, begins);
}

/* at_apex: A start at an apex, with the foot at x = 0. */
static void enter_at_apex(const real *parameters, const real *states, const real *at, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    runner_states *y = (void *)after;
    const real at_apex_com_height = at[0];
    const real at_apex_com_speed = at[1];
    const real at_apex_length = at[2];
    const real at_apex_angle = at[3];
    const real at_apex_length_rate = at[4];
    const real at_apex_angle_rate = at[5];
    const real set_height = p->ground_height + x->segment_height;
    const real set_slope = p->ground_slope + x->segment_slope;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real sine = real_sin(at_apex_angle);
    const real ground = set_height
        - real_sin(set_slope) / real_cos(set_slope) * (share * (at_apex_length * sine));
    const real cosine = real_cos(at_apex_angle);
    const real y_2 = at_apex_length * cosine;
    const real turn = at_apex_length * at_apex_angle_rate;
    const real vx = -(at_apex_length_rate * sine) - turn * cosine;
    const real vy = at_apex_length_rate * cosine - turn * sine;
    y->seen_x = 0.0;
    y->seen_y = ground + at_apex_com_height - share * y_2;
    y->length = at_apex_length;
    y->angle = at_apex_angle;
    y->seen_vx = at_apex_com_speed - share * vx;
    y->seen_vy = -(share * vy);
    y->length_rate = at_apex_length_rate;
    y->angle_rate = at_apex_angle_rate;
}

/* First variation of enter_at_apex. */
static void vary_enter_at_apex(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const real *at, const real *d_at, real *after) {
    const runner_parameters *p = (const void *)parameters;
    const runner_states *x = (const void *)states;
    const runner_parameters *dp = (const void *)d_parameters;
    const runner_states *dx = (const void *)d_states;
    runner_states *y = (void *)after;
    const real at_apex_length = at[2];
    const real at_apex_angle = at[3];
    const real at_apex_length_rate = at[4];
    const real at_apex_angle_rate = at[5];
    const real d_at_apex_com_height = d_at[0];
    const real d_at_apex_com_speed = d_at[1];
    const real d_at_apex_length = d_at[2];
    const real d_at_apex_angle = d_at[3];
    const real d_at_apex_length_rate = d_at[4];
    const real d_at_apex_angle_rate = d_at[5];
    const real d_set_height = dp->ground_height + dx->segment_height;
    const real set_slope = p->ground_slope + x->segment_slope;
    const real cos_of_set_slope = real_cos(set_slope);
    const real d_set_slope = dp->ground_slope + dx->segment_slope;
    const real sin_of_set_slope = real_sin(set_slope);
    const real sin_of_set_slope_over_cos_of_set_slope = sin_of_set_slope / cos_of_set_slope;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real sine = real_sin(at_apex_angle);
    const real at_apex_length_times_sine = at_apex_length * sine;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real cosine = real_cos(at_apex_angle);
    const real d_sine = cosine * d_at_apex_angle;
    const real d_ground = d_set_height - ((cos_of_set_slope * d_set_slope
        + sin_of_set_slope_over_cos_of_set_slope * (sin_of_set_slope * d_set_slope)) / cos_of_set_slope *
        (share * at_apex_length_times_sine)
        + sin_of_set_slope_over_cos_of_set_slope * (d_share * at_apex_length_times_sine
        + share * (d_at_apex_length * sine + at_apex_length * d_sine)));
    const real y_2 = at_apex_length * cosine;
    const real sine_times_d_at_apex_angle = sine * d_at_apex_angle;
    const real d_y = d_at_apex_length * cosine - at_apex_length * sine_times_d_at_apex_angle;
    const real turn = at_apex_length * at_apex_angle_rate;
    const real vx = -(at_apex_length_rate * sine) - turn * cosine;
    const real d_turn = d_at_apex_length * at_apex_angle_rate + at_apex_length * d_at_apex_angle_rate;
    const real d_vx = -(d_at_apex_length_rate * sine + at_apex_length_rate * d_sine) - (d_turn * cosine
        - turn * sine_times_d_at_apex_angle);
    const real vy = at_apex_length_rate * cosine - turn * sine;
    const real d_vy = d_at_apex_length_rate * cosine - at_apex_length_rate * sine_times_d_at_apex_angle
        - (d_turn * sine + turn * d_sine);
    y->seen_x = 0.0;
    y->seen_y = d_ground + d_at_apex_com_height - (d_share * y_2 + share * d_y);
    y->length = d_at_apex_length;
    y->angle = d_at_apex_angle;
    y->seen_vx = d_at_apex_com_speed - (d_share * vx + share * d_vx);
    y->seen_vy = -(d_share * vy + share * d_vy);
    y->length_rate = d_at_apex_length_rate;
    y->angle_rate = d_at_apex_angle_rate;
}

/* Typical size of each state and guard. */
static void scales(const real *parameters, real *of_states, real *of_events) {
    const runner_parameters *p = (const void *)parameters;
    const real sqrt_of_stiffness_over_body_mass = real_sqrt(p->stiffness / p->body_mass);
    const real product_2 = p->stiffness * p->free_length * p->free_length;
    of_states[0] = real_sqrt(p->body_mass / p->stiffness);
    of_states[1] = 1.0;
    of_states[2] = real_sqrt(p->body_mass / p->stiffness);
    of_states[3] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[4] = p->free_length;
    of_states[5] = product_2 * product_2 * real_sqrt(p->body_mass / p->stiffness);
    of_states[6] = 1.0;
    of_states[7] = product_2;
    of_states[8] = product_2;
    of_states[9] = product_2;
    of_states[10] = product_2;
    of_states[11] = p->stiffness * p->free_length;
    of_states[12] = p->stiffness * p->free_length;
    of_states[13] = 1.0;
    of_states[14] = p->free_length;
    of_states[15] = p->free_length;
    of_states[16] = real_sqrt(p->body_mass / p->stiffness);
    of_states[17] = 1.0;
    of_states[18] = 1.0;
    of_states[19] = 1.0;
    of_states[20] = real_sqrt(p->body_mass / p->stiffness);
    of_states[21] = p->free_length;
    of_states[22] = p->free_length;
    of_states[23] = 1.0;
    of_states[24] = 1.0;
    of_states[25] = real_sqrt(p->body_mass / p->stiffness);
    of_states[26] = p->free_length;
    of_states[27] = p->free_length;
    of_states[28] = product_2;
    of_states[29] = product_2;
    of_states[30] = product_2;
    of_states[31] = product_2;
    of_states[32] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[33] = 1.0;
    of_states[34] = 1.0;
    of_states[35] = real_sqrt(p->body_mass / p->stiffness);
    of_states[36] = 1.0;
    of_states[37] = p->free_length;
    of_states[38] = p->stiffness * p->free_length;
    of_states[39] = p->stiffness * p->free_length;
    of_states[40] = real_sqrt(p->body_mass / p->stiffness);
    of_states[41] = p->free_length;
    of_states[42] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[43] = p->free_length;
    of_states[44] = 1.0;
    of_states[45] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[46] = sqrt_of_stiffness_over_body_mass;
    of_states[47] = p->free_length;
    of_states[48] = 1.0;
    of_states[49] = 1.0;
    of_states[50] = p->free_length;
    of_states[51] = p->free_length;
    of_states[52] = p->free_length;
    of_states[53] = 1.0;
    of_states[54] = 1.0;
    of_states[55] = 1.0;
    of_states[56] = p->free_length;
    of_states[57] = p->stiffness * p->free_length;
    of_states[58] = p->stiffness * p->free_length;
    of_states[59] = p->free_length;
    of_states[60] = p->free_length;
    of_states[61] = p->free_length;
    of_states[62] = 1.0;
    of_states[63] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[64] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[65] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[66] = sqrt_of_stiffness_over_body_mass;
    of_states[67] = p->free_length;
    of_states[68] = p->free_length;
    of_states[69] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[70] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[71] = p->free_length * p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[72] = p->free_length;
    of_states[73] = p->free_length;
    of_states[74] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[75] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[76] = p->free_length;
    of_states[77] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[78] = 1.0;
    of_states[79] = 1.0;
    of_states[80] = product_2;
    of_states[81] = product_2;
    of_states[82] = product_2;
    of_states[83] = product_2;
    of_states[84] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[85] = 1.0;
    of_states[86] = 1.0;
    of_states[87] = 1.0;
    of_states[88] = 1.0;
    of_states[89] = product_2;
    of_states[90] = product_2;
    of_states[91] = 1.0;
    of_states[92] = product_2;
    of_states[93] = 1.0;
    of_states[94] = 1.0;
    of_states[95] = 1.0;
    of_states[96] = real_sqrt(p->body_mass / p->stiffness);
    of_states[97] = real_sqrt(p->body_mass / p->stiffness);
    of_states[98] = 1.0;
    of_states[99] = real_sqrt(p->body_mass / p->stiffness);
    of_states[100] = 1.0;
    of_states[101] = real_sqrt(p->body_mass / p->stiffness);
    of_states[102] = 1.0;
    of_states[103] = product_2;
    of_states[104] = 1.0;
    of_states[105] = 1.0;
    of_events[EVENT_passes_end] = p->free_length;
    of_events[EVENT_passes_begin] = p->free_length;
    of_events[EVENT_ramp_ends] = 1.0;
    of_events[EVENT_begins] = 1.0;
    of_events[EVENT_wind_rises] = 1.0;
    of_events[EVENT_new_ground] = p->free_length;
    of_events[EVENT_falls] = p->free_length;
    of_events[EVENT_collapses] = p->free_length;
    of_events[EVENT_apex] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_events[EVENT_apex_in_graze] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_events[EVENT_touchdown] = p->free_length;
    of_events[EVENT_clamp] = product_2;
    of_events[EVENT_release] = product_2;
    of_events[EVENT_greatest_compression] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_events[EVENT_mid_stance] = 1.0;
    of_events[EVENT_lift_off] = p->stiffness * p->free_length;
    of_events[EVENT_enters_layer] = 1.0;
    of_events[EVENT_leaves_layer] = 1.0;
    of_events[EVENT_slips_forward] = p->stiffness * p->free_length;
    of_events[EVENT_slips_backward] = p->stiffness * p->free_length;
    of_events[EVENT_comes_to_rest] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_events[EVENT_crosses_border] = p->free_length;
    of_events[EVENT_graze_to_contact] = p->stiffness * p->free_length;
    of_events[EVENT_graze_to_flight] = p->stiffness * p->free_length;
}

static const tdmf_guard_kind guards_start_of_run[] = {
    {.event = EVENT_passes_end, .react = react_start_of_run_passes_end,
        .vary_react = vary_react_start_of_run_passes_end, .vary_guard = vary_guard_start_of_run_passes_end,
        .next = {MODE_start_of_run}},
    {.event = EVENT_passes_begin, .react = react_start_of_run_passes_begin,
        .vary_react = vary_react_start_of_run_passes_begin,
        .vary_guard = vary_guard_start_of_run_passes_begin, .next = {MODE_start_of_run}},
    {.event = EVENT_begins, .react = react_start_of_run_begins, .vary_react = vary_react_start_of_run_begins,
        .vary_guard = vary_guard_start_of_run_begins, .next = {MODE_slip_constant, MODE_stick,
        MODE_flight_calm}},
    {.event = -1},
};
static const tdmf_watch_kind watches_start_of_run[] = {
    {.into = -1},
};
static const tdmf_guard_kind guards_slip_constant[] = {
    {.event = EVENT_ramp_ends, .react = react_slip_constant_ramp_ends,
        .vary_react = vary_react_slip_constant_ramp_ends, .is_watched = watches_slip_constant_ramp_ends,
        .vary_guard = vary_guard_slip_constant_ramp_ends, .next = {MODE_slip_constant}},
    {.event = EVENT_falls, .react = react_slip_constant_falls, .vary_react = vary_react_slip_constant_falls,
        .looks_again = true, .vary_guard = vary_guard_slip_constant_falls, .next = {MODE_fallen}},
    {.event = EVENT_collapses, .react = react_slip_constant_falls,
        .vary_react = vary_react_slip_constant_falls, .looks_again = true,
        .vary_guard = vary_guard_slip_constant_collapses, .next = {MODE_fallen}},
    {.event = EVENT_greatest_compression, .react = react_slip_constant_greatest_compression,
        .vary_react = vary_react_slip_constant_greatest_compression,
        .is_watched = watches_slip_constant_greatest_compression,
        .vary_guard = vary_guard_slip_constant_greatest_compression, .next = {MODE_slip_constant}},
    {.event = EVENT_mid_stance, .is_counted = true, .react = react_slip_constant_mid_stance,
        .vary_react = vary_react_slip_constant_mid_stance, .is_watched = watches_slip_constant_mid_stance,
        .vary_guard = vary_guard_slip_constant_mid_stance, .next = {MODE_slip_constant}},
    {.event = EVENT_lift_off, .is_counted = true, .react = react_slip_constant_lift_off,
        .vary_react = vary_react_slip_constant_lift_off, .vary_guard = vary_guard_slip_constant_lift_off,
        .next = {MODE_flight_calm, MODE_graze}},
    {.event = EVENT_enters_layer, .react = react_slip_constant_enters_layer,
        .vary_react = vary_react_slip_constant_enters_layer, .is_watched = watches_slip_constant_enters_layer,
        .vary_guard = vary_guard_slip_constant_enters_layer, .next = {MODE_slip_falling}},
    {.event = EVENT_comes_to_rest, .is_counted = true, .react = react_slip_constant_comes_to_rest,
        .vary_react = vary_react_slip_constant_comes_to_rest,
        .vary_guard = vary_guard_slip_constant_comes_to_rest, .next = {MODE_stick, MODE_slip_constant}},
    {.event = EVENT_crosses_border, .is_counted = true, .react = react_slip_constant_crosses_border,
        .vary_react = vary_react_slip_constant_crosses_border,
        .is_watched = watches_slip_constant_crosses_border,
        .vary_guard = vary_guard_slip_constant_crosses_border, .next = {MODE_slip_constant, MODE_fallen}},
    {.event = -1},
};
static const tdmf_watch_kind watches_slip_constant[] = {
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 9},
    {.part = TDMF_LARGEST, .into = 12},
    {.part = TDMF_LARGEST, .into = 11},
    {.part = TDMF_LARGEST, .into = 3},
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 5},
    {.into = -1},
};
static const tdmf_guard_kind guards_stick[] = {
    {.event = EVENT_ramp_ends, .react = react_stick_ramp_ends,
        .vary_react = vary_react_slip_constant_ramp_ends, .is_watched = watches_slip_constant_ramp_ends,
        .vary_guard = vary_guard_slip_constant_ramp_ends, .next = {MODE_stick}},
    {.event = EVENT_falls, .react = react_slip_constant_falls, .vary_react = vary_react_slip_constant_falls,
        .looks_again = true, .vary_guard = vary_guard_slip_constant_falls, .next = {MODE_fallen}},
    {.event = EVENT_collapses, .react = react_slip_constant_falls,
        .vary_react = vary_react_slip_constant_falls, .looks_again = true,
        .vary_guard = vary_guard_slip_constant_collapses, .next = {MODE_fallen}},
    {.event = EVENT_greatest_compression, .react = react_stick_greatest_compression,
        .vary_react = vary_react_slip_constant_greatest_compression,
        .is_watched = watches_slip_constant_greatest_compression,
        .vary_guard = vary_guard_slip_constant_greatest_compression, .next = {MODE_stick}},
    {.event = EVENT_mid_stance, .is_counted = true, .react = react_stick_mid_stance,
        .vary_react = vary_react_slip_constant_mid_stance, .is_watched = watches_slip_constant_mid_stance,
        .vary_guard = vary_guard_slip_constant_mid_stance, .next = {MODE_stick}},
    {.event = EVENT_lift_off, .is_counted = true, .react = react_slip_constant_lift_off,
        .vary_react = vary_react_slip_constant_lift_off, .vary_guard = vary_guard_slip_constant_lift_off,
        .next = {MODE_flight_calm, MODE_graze}},
    {.event = EVENT_slips_forward, .is_counted = true, .react = react_stick_slips_forward,
        .vary_react = vary_react_stick_slips_forward, .vary_guard = vary_guard_stick_slips_forward,
        .next = {MODE_slip_constant}},
    {.event = EVENT_slips_backward, .is_counted = true, .react = react_stick_slips_backward,
        .vary_react = vary_react_stick_slips_backward, .vary_guard = vary_guard_stick_slips_backward,
        .next = {MODE_slip_constant}},
    {.event = -1},
};
static const tdmf_watch_kind watches_stick[] = {
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 9},
    {.part = TDMF_LARGEST, .into = 12},
    {.part = TDMF_LARGEST, .into = 11},
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 5},
    {.into = -1},
};
static const tdmf_guard_kind guards_flight_calm[] = {
    {.event = EVENT_passes_end, .react = react_flight_calm_passes_end,
        .vary_react = vary_react_flight_calm_passes_end, .is_watched = watches_flight_calm_passes_end,
        .vary_guard = vary_guard_flight_calm_passes_end, .next = {MODE_flight_calm, MODE_fallen}},
    {.event = EVENT_passes_begin, .react = react_flight_calm_passes_begin,
        .vary_react = vary_react_flight_calm_passes_begin, .is_watched = watches_flight_calm_passes_begin,
        .vary_guard = vary_guard_flight_calm_passes_begin, .next = {MODE_flight_calm, MODE_fallen}},
    {.event = EVENT_ramp_ends, .react = react_flight_calm_ramp_ends,
        .vary_react = vary_react_slip_constant_ramp_ends, .is_watched = watches_slip_constant_ramp_ends,
        .vary_guard = vary_guard_slip_constant_ramp_ends, .next = {MODE_flight_calm}},
    {.event = EVENT_wind_rises, .react = react_flight_calm_wind_rises,
        .vary_react = vary_react_slip_constant_enters_layer, .is_watched = watches_flight_calm_wind_rises,
        .vary_guard = vary_guard_start_of_run_begins, .next = {MODE_flight_pushed}},
    {.event = EVENT_new_ground, .is_counted = true, .react = react_flight_calm_new_ground,
        .vary_react = vary_react_flight_calm_new_ground, .is_watched = watches_flight_calm_new_ground,
        .looks_again = true, .vary_guard = vary_guard_flight_calm_new_ground, .next = {MODE_flight_calm}},
    {.event = EVENT_falls, .react = react_flight_calm_falls, .vary_react = vary_react_flight_calm_falls,
        .looks_again = true, .vary_guard = vary_guard_flight_calm_falls, .next = {MODE_fallen}},
    {.event = EVENT_collapses, .react = react_flight_calm_falls, .vary_react = vary_react_flight_calm_falls,
        .looks_again = true, .vary_guard = vary_guard_flight_calm_collapses, .next = {MODE_fallen}},
    {.event = EVENT_apex, .is_counted = true, .react = react_flight_calm_apex,
        .vary_react = vary_react_flight_calm_apex, .is_watched = watches_flight_calm_apex,
        .is_crossing = crosses_flight_calm_apex, .vary_guard = vary_guard_flight_calm_apex,
        .next = {MODE_flight_calm}},
    {.event = EVENT_touchdown, .is_counted = true, .react = react_flight_calm_touchdown,
        .vary_react = vary_react_flight_calm_touchdown, .vary_guard = vary_guard_flight_calm_touchdown,
        .next = {MODE_graze, MODE_slip_constant, MODE_stick}},
    {.event = EVENT_clamp, .react = react_flight_calm_clamp, .vary_react = vary_react_flight_calm_clamp,
        .is_watched = watches_flight_calm_clamp, .vary_guard = vary_guard_flight_calm_clamp,
        .next = {MODE_flight_calm}},
    {.event = EVENT_release, .react = react_flight_calm_release, .vary_react = vary_react_flight_calm_clamp,
        .is_watched = watches_flight_calm_release, .vary_guard = vary_guard_flight_calm_release,
        .next = {MODE_flight_calm}},
    {.event = -1},
};
static const tdmf_watch_kind watches_flight_calm[] = {
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 9},
    {.part = TDMF_LARGEST, .into = 4},
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 5},
    {.into = -1},
};
static const tdmf_guard_kind guards_fallen[] = {
    {.event = -1},
};
static const tdmf_watch_kind watches_fallen[] = {
    {.into = -1},
};
static const tdmf_guard_kind guards_graze[] = {
    {.event = EVENT_passes_end, .react = react_graze_passes_end, .vary_react = vary_react_graze_passes_end,
        .is_watched = watches_flight_calm_passes_end, .vary_guard = vary_guard_graze_passes_end,
        .next = {MODE_graze, MODE_fallen}},
    {.event = EVENT_passes_begin, .react = react_graze_passes_begin,
        .vary_react = vary_react_graze_passes_begin, .is_watched = watches_flight_calm_passes_begin,
        .vary_guard = vary_guard_graze_passes_begin, .next = {MODE_graze, MODE_fallen}},
    {.event = EVENT_ramp_ends, .react = react_graze_ramp_ends,
        .vary_react = vary_react_slip_constant_ramp_ends, .is_watched = watches_slip_constant_ramp_ends,
        .vary_guard = vary_guard_slip_constant_ramp_ends, .next = {MODE_graze}},
    {.event = EVENT_falls, .react = react_slip_constant_falls, .vary_react = vary_react_slip_constant_falls,
        .looks_again = true, .vary_guard = vary_guard_slip_constant_falls, .next = {MODE_fallen}},
    {.event = EVENT_collapses, .react = react_slip_constant_falls,
        .vary_react = vary_react_slip_constant_falls, .looks_again = true,
        .vary_guard = vary_guard_slip_constant_collapses, .next = {MODE_fallen}},
    {.event = EVENT_apex_in_graze, .is_counted = true, .react = react_graze_apex_in_graze,
        .vary_react = vary_react_graze_apex_in_graze, .is_watched = watches_graze_apex_in_graze,
        .vary_guard = vary_guard_graze_apex_in_graze, .next = {MODE_graze}},
    {.event = EVENT_clamp, .react = react_graze_clamp, .vary_react = vary_react_flight_calm_clamp,
        .is_watched = watches_flight_calm_clamp, .vary_guard = vary_guard_graze_clamp, .next = {MODE_graze}},
    {.event = EVENT_release, .react = react_graze_release, .vary_react = vary_react_flight_calm_clamp,
        .is_watched = watches_flight_calm_release, .vary_guard = vary_guard_graze_release,
        .next = {MODE_graze}},
    {.event = EVENT_mid_stance, .is_counted = true, .react = react_graze_mid_stance,
        .vary_react = vary_react_slip_constant_mid_stance, .is_watched = watches_slip_constant_mid_stance,
        .vary_guard = vary_guard_slip_constant_mid_stance, .next = {MODE_graze}},
    {.event = EVENT_graze_to_contact, .is_counted = true, .react = react_graze_graze_to_contact,
        .vary_react = vary_react_graze_graze_to_contact, .vary_guard = vary_guard_graze_graze_to_contact,
        .next = {MODE_slip_constant, MODE_stick}},
    {.event = EVENT_graze_to_flight, .is_counted = true, .react = react_graze_graze_to_flight,
        .vary_react = vary_react_graze_graze_to_flight, .is_crossing = crosses_graze_graze_to_flight,
        .vary_guard = vary_guard_graze_graze_to_flight, .next = {MODE_flight_calm}},
    {.event = -1},
};
static const tdmf_watch_kind watches_graze[] = {
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 9},
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 5},
    {.into = -1},
};
static const tdmf_guard_kind guards_slip_falling[] = {
    {.event = EVENT_ramp_ends, .react = react_slip_constant_ramp_ends,
        .vary_react = vary_react_slip_constant_ramp_ends, .is_watched = watches_slip_constant_ramp_ends,
        .vary_guard = vary_guard_slip_constant_ramp_ends, .next = {MODE_slip_falling}},
    {.event = EVENT_falls, .react = react_slip_constant_falls, .vary_react = vary_react_slip_constant_falls,
        .looks_again = true, .vary_guard = vary_guard_slip_constant_falls, .next = {MODE_fallen}},
    {.event = EVENT_collapses, .react = react_slip_constant_falls,
        .vary_react = vary_react_slip_constant_falls, .looks_again = true,
        .vary_guard = vary_guard_slip_constant_collapses, .next = {MODE_fallen}},
    {.event = EVENT_greatest_compression, .react = react_slip_constant_greatest_compression,
        .vary_react = vary_react_slip_constant_greatest_compression,
        .is_watched = watches_slip_constant_greatest_compression,
        .vary_guard = vary_guard_slip_constant_greatest_compression, .next = {MODE_slip_falling}},
    {.event = EVENT_mid_stance, .is_counted = true, .react = react_slip_constant_mid_stance,
        .vary_react = vary_react_slip_constant_mid_stance, .is_watched = watches_slip_constant_mid_stance,
        .vary_guard = vary_guard_slip_constant_mid_stance, .next = {MODE_slip_falling}},
    {.event = EVENT_lift_off, .is_counted = true, .react = react_slip_constant_lift_off,
        .vary_react = vary_react_slip_constant_lift_off, .vary_guard = vary_guard_slip_constant_lift_off,
        .next = {MODE_flight_calm, MODE_graze}},
    {.event = EVENT_leaves_layer, .react = react_slip_constant_enters_layer,
        .vary_react = vary_react_slip_constant_enters_layer,
        .vary_guard = vary_guard_slip_falling_leaves_layer, .next = {MODE_slip_constant}},
    {.event = EVENT_comes_to_rest, .is_counted = true, .react = react_slip_constant_comes_to_rest,
        .vary_react = vary_react_slip_constant_comes_to_rest,
        .vary_guard = vary_guard_slip_constant_comes_to_rest, .next = {MODE_stick, MODE_slip_constant}},
    {.event = EVENT_crosses_border, .is_counted = true, .react = react_slip_constant_crosses_border,
        .vary_react = vary_react_slip_constant_crosses_border,
        .is_watched = watches_slip_constant_crosses_border,
        .vary_guard = vary_guard_slip_constant_crosses_border, .next = {MODE_slip_falling, MODE_fallen}},
    {.event = -1},
};
static const tdmf_watch_kind watches_slip_falling[] = {
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 9},
    {.part = TDMF_LARGEST, .into = 12},
    {.part = TDMF_LARGEST, .into = 11},
    {.part = TDMF_LARGEST, .into = 3},
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 5},
    {.into = -1},
};
static const tdmf_guard_kind guards_flight_pushed[] = {
    {.event = EVENT_passes_end, .react = react_flight_calm_passes_end,
        .vary_react = vary_react_flight_calm_passes_end, .is_watched = watches_flight_calm_passes_end,
        .vary_guard = vary_guard_flight_calm_passes_end, .next = {MODE_flight_pushed, MODE_fallen}},
    {.event = EVENT_passes_begin, .react = react_flight_calm_passes_begin,
        .vary_react = vary_react_flight_calm_passes_begin, .is_watched = watches_flight_calm_passes_begin,
        .vary_guard = vary_guard_flight_calm_passes_begin, .next = {MODE_flight_pushed, MODE_fallen}},
    {.event = EVENT_ramp_ends, .react = react_flight_calm_ramp_ends,
        .vary_react = vary_react_slip_constant_ramp_ends, .is_watched = watches_slip_constant_ramp_ends,
        .vary_guard = vary_guard_slip_constant_ramp_ends, .next = {MODE_flight_pushed}},
    {.event = EVENT_new_ground, .is_counted = true, .react = react_flight_calm_new_ground,
        .vary_react = vary_react_flight_calm_new_ground, .is_watched = watches_flight_calm_new_ground,
        .looks_again = true, .vary_guard = vary_guard_flight_calm_new_ground, .next = {MODE_flight_pushed}},
    {.event = EVENT_falls, .react = react_flight_calm_falls, .vary_react = vary_react_flight_calm_falls,
        .looks_again = true, .vary_guard = vary_guard_flight_calm_falls, .next = {MODE_fallen}},
    {.event = EVENT_collapses, .react = react_flight_calm_falls, .vary_react = vary_react_flight_calm_falls,
        .looks_again = true, .vary_guard = vary_guard_flight_calm_collapses, .next = {MODE_fallen}},
    {.event = EVENT_apex, .is_counted = true, .react = react_flight_calm_apex,
        .vary_react = vary_react_flight_calm_apex, .is_crossing = crosses_flight_calm_apex,
        .vary_guard = vary_guard_flight_calm_apex, .next = {MODE_flight_pushed}},
    {.event = EVENT_touchdown, .is_counted = true, .react = react_flight_calm_touchdown,
        .vary_react = vary_react_flight_calm_touchdown, .vary_guard = vary_guard_flight_calm_touchdown,
        .next = {MODE_graze, MODE_slip_constant, MODE_stick}},
    {.event = EVENT_clamp, .react = react_flight_calm_clamp, .vary_react = vary_react_flight_calm_clamp,
        .is_watched = watches_flight_calm_clamp, .vary_guard = vary_guard_flight_calm_clamp,
        .next = {MODE_flight_pushed}},
    {.event = EVENT_release, .react = react_flight_calm_release, .vary_react = vary_react_flight_calm_clamp,
        .is_watched = watches_flight_calm_release, .vary_guard = vary_guard_flight_calm_release,
        .next = {MODE_flight_pushed}},
    {.event = -1},
};
static const tdmf_watch_kind watches_flight_pushed[] = {
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 9},
    {.part = TDMF_LARGEST, .into = 4},
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 5},
    {.into = -1},
};
static const tdmf_set set_extension[] = {set_extension_start_of_run, set_extension_slip_constant,
    set_extension_slip_constant, set_extension_start_of_run, set_extension_start_of_run,
    set_extension_slip_constant, set_extension_slip_constant, set_extension_start_of_run};
static const tdmf_set set_thrust[] = {set_thrust_start_of_run, set_thrust_slip_constant,
    set_thrust_slip_constant, set_thrust_start_of_run, set_thrust_start_of_run, set_thrust_slip_constant,
    set_thrust_slip_constant, set_thrust_start_of_run};
static const tdmf_set set_more_thrust[] = {set_more_thrust_start_of_run, set_more_thrust_slip_constant,
    set_more_thrust_slip_constant, set_more_thrust_start_of_run, set_more_thrust_start_of_run,
    set_more_thrust_slip_constant, set_more_thrust_slip_constant, set_more_thrust_start_of_run};
static const int coordinates_at_apex[] = {41, 42, 43, 44, 45, 46};

static const tdmf_mode_kind modes[] = {
    {.motion = &tdmf_runner_motions[MODE_start_of_run], .open = open_start_of_run,
        .vary_open = vary_open_start_of_run, .guard_count = 3, .guards = guards_start_of_run,
        .watch_count = 0, .usual_count = 0, .watches = watches_start_of_run, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run},
    {.motion = &tdmf_runner_motions[MODE_slip_constant], .open = open_slip_constant,
        .vary_open = vary_open_slip_constant, .guard_count = 9, .guards = guards_slip_constant,
        .watch_count = 5, .usual_count = 3, .watches = watches_slip_constant,
        .outputs = outputs_slip_constant, .vary_outputs = vary_outputs_slip_constant,
        .leave = leave_slip_constant, .vary_leave = vary_leave_slip_constant,
        .from_world = from_world_slip_constant, .vary_from_world = vary_from_world_slip_constant,
        .to_world = to_world_slip_constant, .vary_to_world = vary_to_world_slip_constant,
        .world_rates = world_rates_slip_constant, .vary_world_rates = vary_world_rates_slip_constant},
    {.motion = &tdmf_runner_motions[MODE_stick], .open = open_stick, .vary_open = vary_open_stick,
        .guard_count = 8, .guards = guards_stick, .watch_count = 4, .usual_count = 3,
        .watches = watches_stick, .outputs = outputs_stick, .vary_outputs = vary_outputs_stick,
        .leave = leave_stick, .vary_leave = vary_leave_stick, .from_world = from_world_slip_constant,
        .vary_from_world = vary_from_world_slip_constant, .to_world = to_world_slip_constant,
        .vary_to_world = vary_to_world_slip_constant, .world_rates = world_rates_stick,
        .vary_world_rates = vary_world_rates_stick},
    {.motion = &tdmf_runner_motions[MODE_flight_calm], .open = open_flight_calm,
        .vary_open = vary_open_flight_calm, .guard_count = 11, .guards = guards_flight_calm, .watch_count = 3,
        .usual_count = 1, .watches = watches_flight_calm, .outputs = outputs_flight_calm,
        .vary_outputs = vary_outputs_flight_calm, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run, .from_world = from_world_flight_calm,
        .vary_from_world = vary_from_world_flight_calm, .to_world = to_world_flight_calm,
        .vary_to_world = vary_to_world_flight_calm, .world_rates = world_rates_flight_calm,
        .vary_world_rates = vary_world_rates_flight_calm},
    {.motion = &tdmf_runner_motions[MODE_fallen], .ends = true, .keeps_outputs = true, .open = open_fallen,
        .vary_open = vary_open_fallen, .guard_count = 0, .guards = guards_fallen, .watch_count = 0,
        .usual_count = 0, .watches = watches_fallen, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run},
    {.motion = &tdmf_runner_motions[MODE_graze], .open = open_graze, .vary_open = vary_open_graze,
        .guard_count = 11, .guards = guards_graze, .watch_count = 2, .usual_count = 1,
        .watches = watches_graze, .outputs = outputs_graze, .vary_outputs = vary_outputs_graze,
        .leave = leave_graze, .vary_leave = vary_leave_graze, .from_world = from_world_slip_constant,
        .vary_from_world = vary_from_world_slip_constant, .to_world = to_world_slip_constant,
        .vary_to_world = vary_to_world_slip_constant, .world_rates = world_rates_graze,
        .vary_world_rates = vary_world_rates_graze},
    {.motion = &tdmf_runner_motions[MODE_slip_falling], .open = open_slip_falling,
        .vary_open = vary_open_slip_falling, .guard_count = 9, .guards = guards_slip_falling,
        .watch_count = 5, .usual_count = 3, .watches = watches_slip_falling, .outputs = outputs_slip_falling,
        .vary_outputs = vary_outputs_slip_falling, .time_scale = time_scale_slip_falling,
        .leave = leave_slip_constant, .vary_leave = vary_leave_slip_constant,
        .from_world = from_world_slip_constant, .vary_from_world = vary_from_world_slip_constant,
        .to_world = to_world_slip_constant, .vary_to_world = vary_to_world_slip_constant,
        .world_rates = world_rates_slip_falling, .vary_world_rates = vary_world_rates_slip_falling},
    {.motion = &tdmf_runner_motions[MODE_flight_pushed], .open = open_flight_pushed,
        .vary_open = vary_open_flight_pushed, .guard_count = 10, .guards = guards_flight_pushed,
        .watch_count = 3, .usual_count = 1, .watches = watches_flight_pushed, .outputs = outputs_flight_calm,
        .vary_outputs = vary_outputs_flight_calm, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run, .from_world = from_world_flight_calm,
        .vary_from_world = vary_from_world_flight_calm, .to_world = to_world_flight_calm,
        .vary_to_world = vary_to_world_flight_calm, .world_rates = world_rates_flight_pushed,
        .vary_world_rates = vary_world_rates_flight_pushed},
};

static const tdmf_set_kind sets[] = {
    {.is_state = true, .index = 56, .set = set_extension},
    {.is_state = false, .index = 14, .set = set_thrust},
    {.is_state = false, .index = 16, .set = set_more_thrust},
    {.index = -1},
};
static const tdmf_section_kind sections[] = {
    {.enter = enter_at_apex, .vary_enter = vary_enter_at_apex, .event = EVENT_apex, .count = 6,
        .coordinates = coordinates_at_apex},
    {.event = -1},
};

static const char *const mode_names[] = {"start_of_run", "slip_constant", "stick", "flight_calm", "fallen",
    "graze", "slip_falling", "flight_pushed"};
static const char *const state_names[] = {"time", "events", "last_event", "greatest_slip_velocity",
    "greatest_foot_height", "squared_torque", "is_open", "work_then", "leg_work_then", "positive_work_so_far",
    "positive_work_then", "peak_force_so_far", "vertical_so_far", "touchdowns_so_far", "slip_so_far",
    "slid_from", "stance_so_far", "word_so_far", "last_letter", "bar_is_due", "mode_began", "x_then",
    "y_then", "count", "word_code", "period", "distance", "rise_of_stride", "work_of_stride", "hip_work",
    "leg_work_of_stride", "positive_work", "speed", "cost_of_transport", "touchdowns", "stance_time",
    "duty_factor", "slip_distance", "peak_force", "peak_vertical_force", "apex_time", "apex_com_height",
    "apex_com_speed", "apex_length", "apex_angle", "apex_length_rate", "apex_angle_rate", "height", "slope",
    "segment", "segment_begin", "segment_end", "segment_height", "segment_slope", "friction_ahead",
    "friction_behind", "extension", "external_fx", "external_fy", "seen_x", "seen_y", "length", "angle",
    "seen_vx", "seen_vy", "length_rate", "angle_rate", "com_x", "com_y", "com_vx", "com_vy", "momentum", "x",
    "y", "vx", "vy", "foot_x", "foot_vx", "winding", "thrusting", "leg_work", "positive_leg_work",
    "external_work", "damper_loss", "extension_rate", "external_fx_rate", "external_fy_rate", "friction",
    "way", "friction_loss", "impact_loss", "friction_rate", "external_torque", "liftoff_angle", "driving",
    "swing", "placing", "touchdown_time", "has_hopped", "hop_time", "was_placed", "placed_for", "rises_again",
    "work", "external_torque_rate", "has_fallen"};
static const char *const parameter_names[] = {"ground_height", "ground_slope", "patch_begin", "patch_end",
    "patch_friction", "trips", "keeps_friction", "body_mass", "foot_mass", "stiffness", "damping",
    "free_length", "least_length", "gravity", "thrust", "notes_compression", "more_thrust", "static_ratio",
    "stribeck_velocity", "drive_torque", "kp", "kd", "touchdown_angle", "liftoff_factor", "retraction_rate",
    "swing_clamp", "more_angle", "more_torque"};
static const char *const event_names[] = {"passes_end", "passes_begin", "ramp_ends", "begins", "wind_rises",
    "new_ground", "falls", "collapses", "apex", "apex_in_graze", "touchdown", "clamp", "release",
    "greatest_compression", "mid_stance", "lift_off", "enters_layer", "leaves_layer", "slips_forward",
    "slips_backward", "comes_to_rest", "crosses_border", "graze_to_contact", "graze_to_flight"};
static const char *const output_names[] = {"pending", "torque", "normal_force", "tangential_force",
    "ground_force_x", "ground_force_y", "force_of_leg", "body_x", "body_y", "body_vx", "body_vy", "center_x",
    "center_y", "center_vx", "center_vy", "kinetic_energy", "potential_energy", "elastic_energy", "energy",
    "kind_of_contact", "phase_of_hip"};
static const char *const table_names[] = {"ground_segment"};
static const char *const section_names[] = {"at_apex"};
static const double state_defaults[] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, -1000000000000.0,
    -1000000000000.0, 0.0, 0.0, -1.0, -1.0, 0.0, 0.0, 0.0, -0.4722627765193387, 0.6417114468531165,
    0.9999993776846997, -0.5462532571145313, 1.062035591761993, -1.9951712441925837e-05,
    1.1268102275039307e-06, 4.039363331769765e-05, 0.0, 1.4, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.6, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double parameter_defaults[] = {0.0, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 1.0, 0.1, 1.0, 0.2, 1.0, 0.05,
    0.01, 0.0, 1.0, 0.0, 1.0, 0.0, 0.2, 0.1, 0.1, 0.6981317007977318, 1.2, 0.0, 0.0, 0.0, 0.0};
static const double parameter_least[] = {-1000000000.0, -1.0, -1000000000.0, -1000000000.0, 0.0,
    -1.7976931348623157e+308, -1.7976931348623157e+308, 1e-09, 1e-12, 1e-09, 0.0, 1e-06, 1e-09, 1e-09, 0.0,
    -1.7976931348623157e+308, -1000000.0, 1.0, 0.0, -1e+18, 0.0, 0.0, -1.5707963267948966, 0.0, -1000000000.0,
    -1.7976931348623157e+308, -3.141592653589793, -1e+18};
static const double parameter_most[] = {1000000000.0, 1.0, 1000000000.0, 1000000000.0, 1000000.0,
    1.7976931348623157e+308, 1.7976931348623157e+308, 1000000000.0, 1000000000.0, 1000000000000.0,
    1000000000000.0, 1000000.0, 1000000.0, 1000000.0, 1000000.0, 1.7976931348623157e+308, 1000000.0,
    1000000.0, 1000000000.0, 1e+18, 1e+18, 1e+18, 1.5707963267948966, 100.0, 1000000000.0,
    1.7976931348623157e+308, 3.141592653589793, 1e+18};

const tdmf_model_kind tdmf_runner_model = {
    .modes = modes,
    .sets = sets,
    .set_count = 3,
    .sections = sections,
    .scales = scales,
    .series_count = 45,
    .constant_count = 36,
    .lanes = {TDMF_TWO_LANES(tdmf_runner_motions_of_2), TDMF_FOUR_LANES(tdmf_runner_motions_of_4),
        TDMF_EIGHT_LANES(tdmf_runner_motions_of_8)},
    .seeds = TDMF_FOR_SEEDS(tdmf_runner_seeds),
    .mode_count = 8,
    .mode_names = mode_names,
    .state_count = 106,
    .state_names = state_names,
    .parameter_count = 28,
    .parameter_names = parameter_names,
    .event_count = 24,
    .event_names = event_names,
    .output_count = 21,
    .output_names = output_names,
    .table_count = 1,
    .table_names = table_names,
    .section_count = 1,
    .section_names = section_names,
    .state_defaults = state_defaults,
    .parameter_defaults = parameter_defaults,
    .parameter_least = parameter_least,
    .parameter_most = parameter_most,
};
