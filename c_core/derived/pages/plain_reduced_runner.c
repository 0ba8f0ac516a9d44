/* Derived from the page PlainReducedRunner: edit the page, not this. */
#include "plain_reduced_runner.h"

/* Constants of start_of_run. */
static void open_start_of_run(const real *parameters, const real *states, real *constants) {
    (void)parameters, (void)states, (void)constants;
}

/* First variation of open_start_of_run. */
static void vary_open_start_of_run(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)constants;
}

/* begins: Every run begins at an apex, with the foot above the ground. */
static int react_start_of_run_begins(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    plain_reduced_runner_states *y = (void *)after;
    (void)tables;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real cosine = real_cos(x->angle);
    const real y_2 = x->length * cosine;
    const real level = x->seen_y + share * y_2;
    const real above = level - share * p->free_length * real_cos(p->touchdown_angle);
    y->liftoff_angle = x->angle;
    if (above <= 0.0) {
        return next[0]; /* no_start */
    }
    const real sine = real_sin(x->angle);
    const real sum_2 = x->seen_x - share * (x->length * sine);
    const real turn = x->length * x->angle_rate;
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real seen_vx_plus_share_times_vx = x->seen_vx + share * vx;
    const real vy = x->length_rate * cosine - turn * sine;
    y->is_open = 1.0;
    y->work_then = x->work;
    y->positive_work_then = x->positive_work_so_far;
    y->peak_force_so_far = 0.0;
    y->touchdowns_so_far = 0.0;
    y->slip_so_far = 0.0;
    y->stance_so_far = 0.0;
    y->word_so_far = 0.0;
    y->last_letter = 0.0;
    y->bar_is_due = 0.0;
    y->x_then = sum_2;
    y->y_then = level;
    y->apex_time = x->time;
    y->apex_com_height = level;
    y->apex_com_speed = seen_vx_plus_share_times_vx;
    y->apex_length = p->free_length;
    y->apex_angle = p->touchdown_angle;
    y->apex_length_rate = 0.0;
    y->apex_angle_rate = 0.0;
    y->length = p->free_length;
    y->angle = p->touchdown_angle;
    y->length_rate = 0.0;
    y->com_x = sum_2;
    y->com_y = level;
    y->com_vx = seen_vx_plus_share_times_vx;
    y->com_vy = x->seen_vy + share * vy;
    y->momentum = 0.0;
    y->swing = 2.0;
    y->placing = 0.0;
    return next[1]; /* flight */
}

/* First variation of begins. */
static void vary_react_start_of_run_begins(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    plain_reduced_runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real cosine = real_cos(x->angle);
    const real y_2 = x->length * cosine;
    const real level = x->seen_y + share * y_2;
    const real above = level - share * p->free_length * real_cos(p->touchdown_angle);
    y->liftoff_angle = dx->angle;
    if (above <= 0.0) {
        return;
    }
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real sine = real_sin(x->angle);
    const real d_sine = cosine * dx->angle;
    const real seen_x_minus_sum = dx->seen_x - (d_share * (x->length * sine) + share * (dx->length * sine
        + x->length * d_sine));
    const real sine_times_angle = sine * dx->angle;
    const real d_y = dx->length * cosine - x->length * sine_times_angle;
    const real d_level = dx->seen_y + (d_share * y_2 + share * d_y);
    const real turn = x->length * x->angle_rate;
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real d_turn = dx->length * x->angle_rate + x->length * dx->angle_rate;
    const real d_vx = -(dx->length_rate * sine + x->length_rate * d_sine) - (d_turn * cosine
        - turn * sine_times_angle);
    const real sum_2 = dx->seen_vx + (d_share * vx + share * d_vx);
    const real vy = x->length_rate * cosine - turn * sine;
    const real d_vy = dx->length_rate * cosine - x->length_rate * sine_times_angle - (d_turn * sine
        + turn * d_sine);
    y->is_open = 0.0;
    y->work_then = dx->work;
    y->positive_work_then = dx->positive_work_so_far;
    y->peak_force_so_far = 0.0;
    y->touchdowns_so_far = 0.0;
    y->slip_so_far = 0.0;
    y->stance_so_far = 0.0;
    y->word_so_far = 0.0;
    y->last_letter = 0.0;
    y->bar_is_due = 0.0;
    y->x_then = seen_x_minus_sum;
    y->y_then = d_level;
    y->apex_time = dx->time;
    y->apex_com_height = d_level;
    y->apex_com_speed = sum_2;
    y->apex_length = dp->free_length;
    y->apex_angle = dp->touchdown_angle;
    y->apex_length_rate = 0.0;
    y->apex_angle_rate = 0.0;
    y->length = dp->free_length;
    y->angle = dp->touchdown_angle;
    y->length_rate = 0.0;
    y->com_x = seen_x_minus_sum;
    y->com_y = d_level;
    y->com_vx = sum_2;
    y->com_vy = dx->seen_vy + (d_share * vy + share * d_vy);
    y->momentum = 0.0;
    y->swing = 0.0;
    y->placing = 0.0;
}

/* First variation of the guard of begins. */
static real vary_guard_start_of_run_begins(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    (void)parameters, (void)states, (void)d_parameters, (void)d_states;
    return 0.0;
}

/* Outputs in start_of_run. */
static void outputs_start_of_run(const real *parameters, const real *states, real *outputs) {
    (void)parameters, (void)states, (void)outputs;
}

/* First variation of outputs_start_of_run. */
static void vary_outputs_start_of_run(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *outputs) {
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)outputs;
}

/* Count the event. A contact mode that lasted adds a letter to the gait word, a new stance a bar. */
static void leave_start_of_run(const real *parameters, const real *states, real counted, real *after) {
    const plain_reduced_runner_states *x = (const void *)states;
    plain_reduced_runner_states *y = (void *)after;
    (void)parameters;
    const real is_new = select(x->time > x->last_event, counted, 0.0);
    y->events = x->events + is_new;
    y->last_event = select(counted > 0.0, x->time, x->last_event);
    y->mode_began = x->time;
}

/* First variation of leave_start_of_run. */
static void vary_leave_start_of_run(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real counted, real *after) {
    const plain_reduced_runner_states *dx = (const void *)d_states;
    plain_reduced_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters;
    y->events = dx->events;
    y->last_event = select(counted > 0.0, dx->time, dx->last_event);
    y->mode_began = dx->time;
}

/* Constants of flight. */
static void open_flight(const real *parameters, const real *states, real *constants) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    flight_constants *c = (void *)constants;
    const real minus_gravity = -p->gravity;
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real is_placing_times_rate = is_placing * rate;
    const real total = p->body_mass + p->foot_mass;
    const real share = p->body_mass / total;
    const real by_1_minus_share_times_length = (1.0 - share) * x->length;
    const real share_times_length = share * x->length;
    c->com_vx = x->com_vx;
    c->minus_gravity = minus_gravity;
    c->is_placing = is_placing;
    c->is_placing_times_rate = is_placing_times_rate;
    c->by_1_minus_share_times_length = by_1_minus_share_times_length;
    c->share_times_length = share_times_length;
}

/* First variation of open_flight. */
static void vary_open_flight(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    flight_constants *c = (void *)constants;
    const real d_minus_gravity = -dp->gravity;
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real d_square = 2.0 * (x->length * dx->length);
    const real d_rate = (dx->momentum - rate * d_square) / square;
    const real d_is_placing_times_rate = is_placing * d_rate;
    const real total = p->body_mass + p->foot_mass;
    const real share = p->body_mass / total;
    const real d_total = dp->body_mass + dp->foot_mass;
    const real d_share = (dp->body_mass - share * d_total) / total;
    const real length_times_d_share = x->length * d_share;
    const real d_by_1_minus_share_times_length = (1.0 - share) * dx->length - length_times_d_share;
    const real d_share_times_length = length_times_d_share + share * dx->length;
    c->com_vx = dx->com_vx;
    c->minus_gravity = d_minus_gravity;
    c->is_placing = 0.0;
    c->is_placing_times_rate = d_is_placing_times_rate;
    c->by_1_minus_share_times_length = d_by_1_minus_share_times_length;
    c->share_times_length = d_share_times_length;
}

/* falls: The body reaches the ground. */
static int react_flight_falls(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    plain_reduced_runner_states *y = (void *)after;
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
    return next[0]; /* fallen */
}

/* First variation of falls. */
static void vary_react_flight_falls(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    plain_reduced_runner_states *y = (void *)after;
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
}

/* True if falls is watched. */
static real watches_flight_falls(const real *parameters, const real *states) {
    const plain_reduced_runner_states *x = (const void *)states;
    (void)parameters;
    if (x->swing < 2.0) {
        return 0.0;
    }
    if (real_cos(x->angle) < 0.01) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of falls. */
static real vary_guard_flight_falls(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real by_1_minus_share = 1.0 - share;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_above = dx->com_y + ((by_1_minus_share * dx->length
        - d_share * x->length) * real_cos(x->angle)
        - by_1_minus_share * x->length * (real_sin(x->angle) * dx->angle));
    return d_above;
}

/* apex: A stride closes, and the leg is placed anew. */
static int react_flight_apex(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    plain_reduced_runner_states *y = (void *)after;
    (void)tables;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real cosine = real_cos(p->touchdown_angle);
    const real above = x->com_y - share * p->free_length * cosine;
    const real count_plus_by_1_or_count = select(x->is_open > 0.0, x->count + 1.0, x->count);
    const real word_so_far_or_word_code = select(x->is_open > 0.0, x->word_so_far, x->word_code);
    const real period = x->time - x->apex_time;
    const real period_or_period = select(x->is_open > 0.0, period, x->period);
    const real distance = x->com_x - x->x_then;
    const real distance_or_distance = select(x->is_open > 0.0, distance, x->distance);
    const real com_y_minus_y_then_or_rise_of_stride = select(x->is_open > 0.0, x->com_y - x->y_then,
        x->rise_of_stride);
    const real hip = x->work - x->work_then;
    const real hip_or_work_of_stride = select(x->is_open > 0.0, hip, x->work_of_stride);
    const real hip_or_hip_work = select(x->is_open > 0.0, hip, x->hip_work);
    const real sum_or_positive_work = select(x->is_open > 0.0, x->positive_work_so_far
        - x->positive_work_then, x->positive_work);
    const real distance_over_period_or_com_vx_or_speed = select(x->is_open > 0.0, select(period > 0.0,
        distance / period, x->com_vx), x->speed);
    const real weight = body_mass_plus_foot_mass * p->gravity;
    const real select_2 = select(x->is_open > 0.0, select(period > 0.0, hip / (weight * distance), 0.0),
        x->cost_of_transport);
    const real touchdowns_so_far_or_touchdowns = select(x->is_open > 0.0, x->touchdowns_so_far,
        x->touchdowns);
    const real stance_so_far_or_stance_time = select(x->is_open > 0.0, x->stance_so_far, x->stance_time);
    const real select_3 = select(x->is_open > 0.0, select(period > 0.0, x->stance_so_far / period, 0.0),
        x->duty_factor);
    const real slip_so_far_or_slip_distance = select(x->is_open > 0.0, x->slip_so_far, x->slip_distance);
    const real peak_force_so_far_or_peak_force = select(x->is_open > 0.0, x->peak_force_so_far,
        x->peak_force);
    const real select_4 = select(x->is_open > 0.0, x->peak_force_so_far, x->peak_vertical_force);
    y->is_open = 1.0;
    y->work_then = x->work;
    y->positive_work_then = x->positive_work_so_far;
    y->peak_force_so_far = 0.0;
    y->touchdowns_so_far = 0.0;
    y->slip_so_far = 0.0;
    y->stance_so_far = 0.0;
    y->word_so_far = 0.0;
    y->last_letter = 0.0;
    y->bar_is_due = 0.0;
    y->x_then = x->com_x;
    y->y_then = x->com_y;
    y->count = count_plus_by_1_or_count;
    y->word_code = word_so_far_or_word_code;
    y->period = period_or_period;
    y->distance = distance_or_distance;
    y->rise_of_stride = com_y_minus_y_then_or_rise_of_stride;
    y->work_of_stride = hip_or_work_of_stride;
    y->hip_work = hip_or_hip_work;
    y->positive_work = sum_or_positive_work;
    y->speed = distance_over_period_or_com_vx_or_speed;
    y->cost_of_transport = select_2;
    y->touchdowns = touchdowns_so_far_or_touchdowns;
    y->stance_time = stance_so_far_or_stance_time;
    y->duty_factor = select_3;
    y->slip_distance = slip_so_far_or_slip_distance;
    y->peak_force = peak_force_so_far_or_peak_force;
    y->peak_vertical_force = select_4;
    y->apex_time = x->time;
    y->apex_com_height = x->com_y;
    y->apex_com_speed = x->com_vx;
    y->apex_length = p->free_length;
    y->apex_angle = p->touchdown_angle;
    y->apex_length_rate = 0.0;
    y->apex_angle_rate = 0.0;
    y->length = p->free_length;
    y->angle = p->touchdown_angle;
    y->length_rate = 0.0;
    y->swing = 2.0;
    y->placing = 0.0;
    if (above <= 0.0) {
        const real sine = real_sin(p->touchdown_angle);
        const real y_2 = p->free_length * cosine;
        y->seen_x = x->com_x + share * (p->free_length * sine);
        y->seen_y = x->com_y - share * y_2;
        y->seen_vx = x->com_vx;
        y->seen_vy = x->com_vy;
        y->angle_rate = 0.0;
        return next[0]; /* no_start */
    }
    y->momentum = 0.0;
    return next[1]; /* flight */
}

/* First variation of apex. */
static void vary_react_flight_apex(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    plain_reduced_runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real cosine = real_cos(p->touchdown_angle);
    const real above = x->com_y - share * p->free_length * cosine;
    const real word_so_far_or_word_code = select(x->is_open > 0.0, dx->word_so_far, dx->word_code);
    const real d_period = dx->time - dx->apex_time;
    const real d_period_or_period = select(x->is_open > 0.0, d_period, dx->period);
    const real d_distance = dx->com_x - dx->x_then;
    const real d_distance_or_distance = select(x->is_open > 0.0, d_distance, dx->distance);
    const real com_y_minus_y_then_or_rise_of_stride = select(x->is_open > 0.0, dx->com_y - dx->y_then,
        dx->rise_of_stride);
    const real d_hip = dx->work - dx->work_then;
    const real d_hip_or_work_of_stride = select(x->is_open > 0.0, d_hip, dx->work_of_stride);
    const real d_hip_or_hip_work = select(x->is_open > 0.0, d_hip, dx->hip_work);
    const real sum_or_positive_work = select(x->is_open > 0.0, dx->positive_work_so_far
        - dx->positive_work_then, dx->positive_work);
    const real period = x->time - x->apex_time;
    const real distance = x->com_x - x->x_then;
    const real sum_over_period_or_com_vx_or_speed = select(x->is_open > 0.0, select(period > 0.0,
        (d_distance - distance / period * d_period) / period, dx->com_vx), dx->speed);
    const real weight = body_mass_plus_foot_mass * p->gravity;
    const real weight_times_distance = weight * distance;
    const real body_mass_plus_foot_mass_2 = dp->body_mass + dp->foot_mass;
    const real hip = x->work - x->work_then;
    const real d_weight = p->gravity * body_mass_plus_foot_mass_2 + body_mass_plus_foot_mass * dp->gravity;
    const real ratio_or_by_0_or_cost_of_transport = select(x->is_open > 0.0, select(period > 0.0, (d_hip
        - hip / weight_times_distance * (d_weight * distance + weight * d_distance)) / weight_times_distance,
        0.0), dx->cost_of_transport);
    const real touchdowns_so_far_or_touchdowns = select(x->is_open > 0.0, dx->touchdowns_so_far,
        dx->touchdowns);
    const real stance_so_far_or_stance_time = select(x->is_open > 0.0, dx->stance_so_far, dx->stance_time);
    const real select_or_duty_factor = select(x->is_open > 0.0, select(period > 0.0, (dx->stance_so_far
        - x->stance_so_far / period * d_period) / period, 0.0), dx->duty_factor);
    const real slip_so_far_or_slip_distance = select(x->is_open > 0.0, dx->slip_so_far, dx->slip_distance);
    const real peak_force_so_far_or_peak_force = select(x->is_open > 0.0, dx->peak_force_so_far,
        dx->peak_force);
    const real select_2 = select(x->is_open > 0.0, dx->peak_force_so_far, dx->peak_vertical_force);
    y->is_open = 0.0;
    y->work_then = dx->work;
    y->positive_work_then = dx->positive_work_so_far;
    y->peak_force_so_far = 0.0;
    y->touchdowns_so_far = 0.0;
    y->slip_so_far = 0.0;
    y->stance_so_far = 0.0;
    y->word_so_far = 0.0;
    y->last_letter = 0.0;
    y->bar_is_due = 0.0;
    y->x_then = dx->com_x;
    y->y_then = dx->com_y;
    y->count = dx->count;
    y->word_code = word_so_far_or_word_code;
    y->period = d_period_or_period;
    y->distance = d_distance_or_distance;
    y->rise_of_stride = com_y_minus_y_then_or_rise_of_stride;
    y->work_of_stride = d_hip_or_work_of_stride;
    y->hip_work = d_hip_or_hip_work;
    y->positive_work = sum_or_positive_work;
    y->speed = sum_over_period_or_com_vx_or_speed;
    y->cost_of_transport = ratio_or_by_0_or_cost_of_transport;
    y->touchdowns = touchdowns_so_far_or_touchdowns;
    y->stance_time = stance_so_far_or_stance_time;
    y->duty_factor = select_or_duty_factor;
    y->slip_distance = slip_so_far_or_slip_distance;
    y->peak_force = peak_force_so_far_or_peak_force;
    y->peak_vertical_force = select_2;
    y->apex_time = dx->time;
    y->apex_com_height = dx->com_y;
    y->apex_com_speed = dx->com_vx;
    y->apex_length = dp->free_length;
    y->apex_angle = dp->touchdown_angle;
    y->apex_length_rate = 0.0;
    y->apex_angle_rate = 0.0;
    y->length = dp->free_length;
    y->angle = dp->touchdown_angle;
    y->length_rate = 0.0;
    y->swing = 0.0;
    y->placing = 0.0;
    if (above <= 0.0) {
        const real sine = real_sin(p->touchdown_angle);
        const real d_share = (dp->body_mass - share * body_mass_plus_foot_mass_2) / body_mass_plus_foot_mass;
        const real d_sine = cosine * dp->touchdown_angle;
        const real y_2 = p->free_length * cosine;
        const real d_y = cosine * dp->free_length - p->free_length * (sine * dp->touchdown_angle);
        y->seen_x = dx->com_x + (p->free_length * sine * d_share + share * (sine * dp->free_length
            + p->free_length * d_sine));
        y->seen_y = dx->com_y - (y_2 * d_share + share * d_y);
        y->seen_vx = dx->com_vx;
        y->seen_vy = dx->com_vy;
        y->angle_rate = 0.0;
        return;
    }
    y->momentum = 0.0;
}

/* True if apex is watched. */
static real watches_flight_apex(const real *parameters, const real *states) {
    const plain_reduced_runner_states *x = (const void *)states;
    (void)parameters;
    if (x->swing < 2.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of apex. */
static real vary_guard_flight_apex(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const plain_reduced_runner_states *dx = (const void *)d_states;
    (void)parameters, (void)states, (void)d_parameters;
    return dx->com_vy;
}

/* touchdown: The foot reaches the ground. */
static int react_flight_touchdown(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    plain_reduced_runner_states *y = (void *)after;
    (void)tables;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real sine = real_sin(x->angle);
    const real turn = x->momentum / x->length;
    const real cosine = real_cos(x->angle);
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real along = x->com_vx - share * vx;
    const real way = select(along >= 0.0, 1.0, -1.0);
    const real way_times_along = way * along;
    const real vy = x->length_rate * cosine - turn * sine;
    const real off = x->com_vy - share * vy;
    const real friction_times_off = x->friction * off;
    const real stopped_speed = -friction_times_off;
    const real speed_left = way_times_along + friction_times_off;
    const real speed_after_impact = select(way_times_along <= stopped_speed, 0.0, speed_left);
    const real after_2 = way * speed_after_impact;
    const real touchdowns_so_far_plus_by_1 = x->touchdowns_so_far + 1.0;
    const real length_times_sine = x->length * sine;
    const real sum_2 = x->com_x + share * length_times_sine;
    const real x_2 = -length_times_sine;
    const real y_2 = x->length * cosine;
    const real foot_mass_over_body_mass_plus_foot_mass = p->foot_mass / body_mass_plus_foot_mass;
    const real com_vx_plus_product_minus_after = x->com_vx + foot_mass_over_body_mass_plus_foot_mass * vx
        - after_2;
    const real com_vy_plus_product = x->com_vy + foot_mass_over_body_mass_plus_foot_mass * vy;
    const real angle_minus_length_times_sineatan2_of_y = x->angle - real_atan2(length_times_sine, y_2);
    const real speeds = along * along + off * off - after_2 * after_2;
    const real lost = 0.5 * (p->foot_mass * speeds);
    const real impact_loss_plus_lost = x->impact_loss + lost;
    const real by_1_or_by_0 = select(x->angle >= 0.0, 1.0, 0.0);
    y->touchdowns_so_far = touchdowns_so_far_plus_by_1;
    y->slid_from = sum_2;
    y->bar_is_due = 1.0;
    y->x_ = x_2;
    y->y_ = y_2;
    y->vx = com_vx_plus_product_minus_after;
    y->vy = com_vy_plus_product;
    y->foot_x = sum_2;
    y->foot_vx = after_2;
    y->winding = angle_minus_length_times_sineatan2_of_y;
    y->impact_loss = impact_loss_plus_lost;
    y->driving = by_1_or_by_0;
    y->placing = 0.0;
    y->touchdown_time = x->time;
    if (way * after_2 > 0.0) {
        y->way = way;
        return next[0]; /* slip */
    }
    return next[1]; /* stick */
}

/* First variation of touchdown. */
static void vary_react_flight_touchdown(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    plain_reduced_runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real sine = real_sin(x->angle);
    const real turn = x->momentum / x->length;
    const real cosine = real_cos(x->angle);
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real along = x->com_vx - share * vx;
    const real way = select(along >= 0.0, 1.0, -1.0);
    const real way_times_along = way * along;
    const real vy = x->length_rate * cosine - turn * sine;
    const real off = x->com_vy - share * vy;
    const real friction_times_off = x->friction * off;
    const real stopped_speed = -friction_times_off;
    const real speed_left = way_times_along + friction_times_off;
    const real speed_after_impact = select(way_times_along <= stopped_speed, 0.0, speed_left);
    const real after_2 = way * speed_after_impact;
    const real body_mass_plus_foot_mass_2 = dp->body_mass + dp->foot_mass;
    const real d_share = (dp->body_mass - share * body_mass_plus_foot_mass_2) / body_mass_plus_foot_mass;
    const real length_times_sine = x->length * sine;
    const real d_sine = cosine * dx->angle;
    const real sum_2 = dx->length * sine + x->length * d_sine;
    const real com_x_plus_sum = dx->com_x + (d_share * length_times_sine + share * sum_2);
    const real d_x = -sum_2;
    const real sine_times_angle = sine * dx->angle;
    const real d_y = dx->length * cosine - x->length * sine_times_angle;
    const real foot_mass_over_body_mass_plus_foot_mass = p->foot_mass / body_mass_plus_foot_mass;
    const real ratio = (dp->foot_mass
        - foot_mass_over_body_mass_plus_foot_mass * body_mass_plus_foot_mass_2) / body_mass_plus_foot_mass;
    const real d_turn = (dx->momentum - turn * dx->length) / x->length;
    const real d_vx = -(dx->length_rate * sine + x->length_rate * d_sine) - (d_turn * cosine
        - turn * sine_times_angle);
    const real d_along = dx->com_vx - (d_share * vx + share * d_vx);
    const real d_vy = dx->length_rate * cosine - x->length_rate * sine_times_angle - (d_turn * sine
        + turn * d_sine);
    const real d_off = dx->com_vy - (d_share * vy + share * d_vy);
    const real d_speed_left = way * d_along + (dx->friction * off + x->friction * d_off);
    const real d_speed_after_impact = select(way_times_along <= stopped_speed, 0.0, d_speed_left);
    const real d_after = way * d_speed_after_impact;
    const real sum_3 = dx->com_vx + (ratio * vx + foot_mass_over_body_mass_plus_foot_mass * d_vx) - d_after;
    const real com_vy_plus_ratio_times_vy_plus_product = dx->com_vy + (ratio * vy
        + foot_mass_over_body_mass_plus_foot_mass * d_vy);
    const real y_2 = x->length * cosine;
    const real sum_4 = dx->angle - (y_2 * sum_2
        - length_times_sine * d_y) / (length_times_sine * length_times_sine + y_2 * y_2);
    const real speeds = along * along + off * off - after_2 * after_2;
    const real d_speeds = 2.0 * (along * d_along) + 2.0 * (off * d_off) - 2.0 * (after_2 * d_after);
    const real d_lost = 0.5 * (dp->foot_mass * speeds + p->foot_mass * d_speeds);
    const real impact_loss_plus_d_lost = dx->impact_loss + d_lost;
    y->touchdowns_so_far = dx->touchdowns_so_far;
    y->slid_from = com_x_plus_sum;
    y->bar_is_due = 0.0;
    y->x_ = d_x;
    y->y_ = d_y;
    y->vx = sum_3;
    y->vy = com_vy_plus_ratio_times_vy_plus_product;
    y->foot_x = com_x_plus_sum;
    y->foot_vx = d_after;
    y->winding = sum_4;
    y->impact_loss = impact_loss_plus_d_lost;
    y->driving = 0.0;
    y->placing = 0.0;
    y->touchdown_time = dx->time;
    if (way * after_2 > 0.0) {
        y->way = 0.0;
        return;
    }
}

/* True if touchdown is watched. */
static real watches_flight_touchdown(const real *parameters, const real *states) {
    const plain_reduced_runner_states *x = (const void *)states;
    (void)parameters;
    if (x->swing > 1.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of touchdown. */
static real vary_guard_flight_touchdown(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_above = dx->com_y - ((d_share * x->length + share * dx->length) * real_cos(x->angle)
        - share * x->length * (real_sin(x->angle) * dx->angle));
    return d_above;
}

/* from world, in flight. */
static void from_world_flight(const real *parameters, const real *states, real *after) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    plain_reduced_runner_states *y = (void *)after;
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

/* First variation of from_world_flight. */
static void vary_from_world_flight(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *after) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    plain_reduced_runner_states *y = (void *)after;
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
static void to_world_flight(const real *parameters, const real *states, real *after) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    plain_reduced_runner_states *y = (void *)after;
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

/* First variation of to_world_flight. */
static void vary_to_world_flight(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *after) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    plain_reduced_runner_states *y = (void *)after;
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

/* Constants of slip_constant. */
static void open_slip_constant(const real *parameters, const real *states, real *constants) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    slip_constant_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real stance_torque = x->external_torque - x->driving * p->drive_torque;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real way_times_friction = x->way * x->friction;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    c->inverse_body_mass = inverse_body_mass;
    c->stiffness = p->stiffness;
    c->free_length = p->free_length;
    c->damping = p->damping;
    c->stance_torque = stance_torque;
    c->inverse_foot_mass = inverse_foot_mass;
    c->way = x->way;
    c->way_times_friction = way_times_friction;
    c->gravity = p->gravity;
    c->foot_mass_times_gravity = foot_mass_times_gravity;
    c->least_length = p->least_length;
    c->winding = x->winding;
}

/* First variation of open_slip_constant. */
static void vary_open_slip_constant(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    slip_constant_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real d_inverse_body_mass = -(inverse_body_mass * dp->body_mass / p->body_mass);
    const real d_stance_torque = dx->external_torque - (p->drive_torque * dx->driving
        + x->driving * dp->drive_torque);
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real d_inverse_foot_mass = -(inverse_foot_mass * dp->foot_mass / p->foot_mass);
    const real d_way_times_friction = x->friction * dx->way + x->way * dx->friction;
    const real d_foot_mass_times_gravity = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    c->inverse_body_mass = d_inverse_body_mass;
    c->stiffness = dp->stiffness;
    c->free_length = dp->free_length;
    c->damping = dp->damping;
    c->stance_torque = d_stance_torque;
    c->inverse_foot_mass = d_inverse_foot_mass;
    c->way = dx->way;
    c->way_times_friction = d_way_times_friction;
    c->gravity = dp->gravity;
    c->foot_mass_times_gravity = d_foot_mass_times_gravity;
    c->least_length = dp->least_length;
    c->winding = dx->winding;
}

/* falls: The body reaches the ground. */
static int react_slip_constant_falls(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const plain_reduced_runner_states *x = (const void *)states;
    plain_reduced_runner_states *y = (void *)after;
    (void)parameters, (void)tables;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    y->seen_x = x->foot_x;
    y->seen_y = 0.0;
    y->length = length;
    y->angle = angle;
    y->seen_vx = x->foot_vx;
    y->seen_vy = 0.0;
    y->length_rate = length_rate;
    y->angle_rate = angle_rate;
    return next[0]; /* fallen */
}

/* First variation of falls. */
static void vary_react_slip_constant_falls(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    plain_reduced_runner_states *y = (void *)after;
    (void)parameters, (void)d_parameters, (void)tables, (void)seed;
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
    y->seen_x = dx->foot_x;
    y->seen_y = 0.0;
    y->length = d_length;
    y->angle = d_angle;
    y->seen_vx = dx->foot_vx;
    y->seen_vy = 0.0;
    y->length_rate = d_length_rate;
    y->angle_rate = d_angle_rate;
}

/* First variation of the guard of falls. */
static real vary_guard_slip_constant_falls(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_reduced_runner_states *dx = (const void *)d_states;
    (void)parameters, (void)states, (void)d_parameters;
    return dx->y_;
}

/* First variation of the guard of collapses. */
static real vary_guard_slip_constant_collapses(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    (void)parameters;
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real d_length = 0.5 * d_square / length;
    return d_length - dp->least_length;
}

/* mid_stance: Drive ends where the leg is upright, once per stance. */
static int react_slip_constant_mid_stance(const real *parameters, const real *states,
    const tdmf_table *tables, real *after, const int *next) {
    plain_reduced_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->driving = 0.0;
    return next[0]; /* slip */
}

/* First variation of mid_stance. */
static void vary_react_slip_constant_mid_stance(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    plain_reduced_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed;
    y->driving = 0.0;
}

/* True if mid_stance is watched. */
static real watches_slip_constant_mid_stance(const real *parameters, const real *states) {
    const plain_reduced_runner_states *x = (const void *)states;
    (void)parameters;
    if (x->driving > 0.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of mid_stance. */
static real vary_guard_slip_constant_mid_stance(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    (void)parameters, (void)d_parameters;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
    return d_angle;
}

/* lift_off: The centre of mass flies to the next apex. */
static int react_slip_constant_lift_off(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    plain_reduced_runner_states *y = (void *)after;
    (void)tables;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    y->length = length;
    y->angle = angle;
    y->length_rate = length_rate;
    if (x->time <= x->touchdown_time) {
        y->seen_x = x->foot_x;
        y->seen_y = 0.0;
        y->seen_vx = x->foot_vx;
        y->seen_vy = 0.0;
        y->angle_rate = angle_rate;
        return next[0]; /* no_stance */
    }
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real rise = share * x->vy;
    if (rise <= 0.0 || body_mass_plus_foot_mass * p->gravity <= 0.0) {
        y->seen_x = x->foot_x;
        y->seen_y = 0.0;
        y->seen_vx = x->foot_vx;
        y->seen_vy = 0.0;
        y->angle_rate = angle_rate;
        return next[1]; /* no_apex */
    }
    const real x_2 = x->foot_x + share * x->x_;
    const real y_2 = share * x->y_;
    const real along = x->foot_vx + share * x->vx;
    y->com_x = x_2;
    y->com_y = y_2;
    y->com_vx = along;
    y->com_vy = rise;
    y->momentum = moment;
    y->liftoff_angle = angle;
    y->swing = 1.0;
    y->placing = 0.0;
    return next[2]; /* flight */
}

/* First variation of lift_off. */
static void vary_react_slip_constant_lift_off(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    plain_reduced_runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real rise = share * x->vy;
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real d_length = 0.5 * d_square / length;
    const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    y->length = d_length;
    y->angle = d_angle;
    y->length_rate = d_length_rate;
    if (x->time <= x->touchdown_time || rise <= 0.0 || body_mass_plus_foot_mass * p->gravity <= 0.0) {
        const real moment = x->x_ * x->vy - x->y_ * x->vx;
        const real angle_rate = moment / square;
        const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
        y->seen_x = dx->foot_x;
        y->seen_y = 0.0;
        y->seen_vx = dx->foot_vx;
        y->seen_vy = 0.0;
        y->angle_rate = d_angle_rate;
        return;
    }
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_x = dx->foot_x + (d_share * x->x_ + share * dx->x_);
    const real d_y = d_share * x->y_ + share * dx->y_;
    const real d_along = dx->foot_vx + (d_share * x->vx + share * dx->vx);
    const real d_rise = d_share * x->vy + share * dx->vy;
    y->com_x = d_x;
    y->com_y = d_y;
    y->com_vx = d_along;
    y->com_vy = d_rise;
    y->momentum = d_moment;
    y->liftoff_angle = d_angle;
    y->swing = 0.0;
    y->placing = 0.0;
}

/* First variation of the guard of lift_off. */
static real vary_guard_slip_constant_lift_off(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real free_length_minus_length = p->free_length - length;
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * free_length_minus_length + p->stiffness * (dp->free_length
        - d_length) - (dp->damping * length_rate + p->damping * d_length_rate);
    const real spring = p->stiffness * free_length_minus_length - p->damping * length_rate;
    const real axial = spring / length;
    const real d_axial = (d_spring - axial * d_length) / length;
    const real d_stance_torque = dx->external_torque - (dp->drive_torque * x->driving
        + p->drive_torque * dx->driving);
    const real stance_torque = x->external_torque - p->drive_torque * x->driving;
    const real turning = stance_torque / square;
    const real d_turning = (d_stance_torque - turning * d_square) / square;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real d_normal = d_off + (p->gravity * dp->foot_mass + p->foot_mass * dp->gravity);
    return d_normal;
}

/* comes_to_rest: The slip velocity reaches 0: the foot sticks, or slips the other way. */
static int react_slip_constant_comes_to_rest(const real *parameters, const real *states,
    const tdmf_table *tables, real *after, const int *next) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    plain_reduced_runner_states *y = (void *)after;
    (void)tables;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real vx_plus_foot_vx = x->vx + x->foot_vx;
    const real length_rate = (x->x_ * vx_plus_foot_vx + x->y_ * x->vy) / length;
    const real spring = p->stiffness * (p->free_length - length) - p->damping * length_rate;
    const real axial = spring / length;
    const real stance_torque = x->external_torque - p->drive_torque * x->driving;
    const real turning = stance_torque / square;
    const real along = axial * x->x_ - turning * x->y_;
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + p->foot_mass * p->gravity;
    const real cone = x->friction * normal;
    y->vx = vx_plus_foot_vx;
    y->foot_vx = 0.0;
    if (real_abs(along) <= cone) {
        return next[0]; /* stick */
    }
    const real way = select(along > 0.0, -1.0, 1.0);
    y->way = way;
    return next[1]; /* slip */
}

/* First variation of comes_to_rest. */
static void vary_react_slip_constant_comes_to_rest(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    plain_reduced_runner_states *y = (void *)after;
    (void)d_parameters, (void)tables, (void)seed;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real length_rate = (x->x_ * (x->vx + x->foot_vx) + x->y_ * x->vy) / length;
    const real spring = p->stiffness * (p->free_length - length) - p->damping * length_rate;
    const real axial = spring / length;
    const real stance_torque = x->external_torque - p->drive_torque * x->driving;
    const real turning = stance_torque / square;
    const real along = axial * x->x_ - turning * x->y_;
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + p->foot_mass * p->gravity;
    const real cone = x->friction * normal;
    const real vx_plus_foot_vx = dx->vx + dx->foot_vx;
    y->vx = vx_plus_foot_vx;
    y->foot_vx = 0.0;
    if (real_abs(along) <= cone) {
        return;
    }
    y->way = 0.0;
}

/* First variation of the guard of comes_to_rest. */
static real vary_guard_slip_constant_comes_to_rest(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    (void)parameters, (void)d_parameters;
    return dx->way * x->foot_vx + x->way * dx->foot_vx;
}

/* Count the event. A contact mode that lasted adds a letter to the gait word, a new stance a bar. */
static void leave_slip_constant(const real *parameters, const real *states, real counted, real *after) {
    const plain_reduced_runner_states *x = (const void *)states;
    plain_reduced_runner_states *y = (void *)after;
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
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    plain_reduced_runner_states *y = (void *)after;
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
    const plain_reduced_runner_states *x = (const void *)states;
    plain_reduced_runner_states *y = (void *)after;
    (void)parameters;
    const real sine = real_sin(x->angle);
    const real length_times_sine = x->length * sine;
    const real x_2 = -length_times_sine;
    const real cosine = real_cos(x->angle);
    const real y_2 = x->length * cosine;
    const real turn = x->length * x->angle_rate;
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real vy = x->length_rate * cosine - turn * sine;
    y->foot_x = x->seen_x;
    y->foot_vx = x->seen_vx;
    y->x_ = x_2;
    y->y_ = y_2;
    y->vx = vx;
    y->vy = vy;
    y->winding = x->angle - real_atan2(length_times_sine, y_2);
}

/* First variation of from_world_slip_constant. */
static void vary_from_world_slip_constant(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, real *after) {
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    plain_reduced_runner_states *y = (void *)after;
    (void)parameters, (void)d_parameters;
    const real sine = real_sin(x->angle);
    const real cosine = real_cos(x->angle);
    const real d_sine = cosine * dx->angle;
    const real sum_2 = dx->length * sine + x->length * d_sine;
    const real d_x = -sum_2;
    const real sine_times_angle = sine * dx->angle;
    const real d_y = dx->length * cosine - x->length * sine_times_angle;
    const real d_turn = dx->length * x->angle_rate + x->length * dx->angle_rate;
    const real turn = x->length * x->angle_rate;
    const real d_vx = -(dx->length_rate * sine + x->length_rate * d_sine) - (d_turn * cosine
        - turn * sine_times_angle);
    const real d_vy = dx->length_rate * cosine - x->length_rate * sine_times_angle - (d_turn * sine
        + turn * d_sine);
    const real y_2 = x->length * cosine;
    const real length_times_sine = x->length * sine;
    y->foot_x = dx->seen_x;
    y->foot_vx = dx->seen_vx;
    y->x_ = d_x;
    y->y_ = d_y;
    y->vx = d_vx;
    y->vy = d_vy;
    y->winding = dx->angle - (y_2 * sum_2
        - length_times_sine * d_y) / (length_times_sine * length_times_sine + y_2 * y_2);
}

/* to world, in slip. */
static void to_world_slip_constant(const real *parameters, const real *states, real *after) {
    const plain_reduced_runner_states *x = (const void *)states;
    plain_reduced_runner_states *y = (void *)after;
    (void)parameters;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    y->seen_x = x->foot_x;
    y->seen_y = 0.0;
    y->seen_vx = x->foot_vx;
    y->seen_vy = 0.0;
    y->length = length;
    y->angle = angle;
    y->length_rate = length_rate;
    y->angle_rate = angle_rate;
}

/* First variation of to_world_slip_constant. */
static void vary_to_world_slip_constant(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *after) {
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    plain_reduced_runner_states *y = (void *)after;
    (void)parameters, (void)d_parameters;
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
    y->seen_x = dx->foot_x;
    y->seen_y = 0.0;
    y->seen_vx = dx->foot_vx;
    y->seen_vy = 0.0;
    y->length = d_length;
    y->angle = d_angle;
    y->length_rate = d_length_rate;
    y->angle_rate = d_angle_rate;
}

/* Constants of stick. */
static void open_stick(const real *parameters, const real *states, real *constants) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    stick_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real stance_torque = x->external_torque - x->driving * p->drive_torque;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    c->inverse_body_mass = inverse_body_mass;
    c->stiffness = p->stiffness;
    c->free_length = p->free_length;
    c->damping = p->damping;
    c->stance_torque = stance_torque;
    c->gravity = p->gravity;
    c->foot_vx = x->foot_vx;
    c->least_length = p->least_length;
    c->winding = x->winding;
    c->foot_mass_times_gravity = foot_mass_times_gravity;
    c->friction = x->friction;
}

/* First variation of open_stick. */
static void vary_open_stick(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    stick_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real d_inverse_body_mass = -(inverse_body_mass * dp->body_mass / p->body_mass);
    const real d_stance_torque = dx->external_torque - (p->drive_torque * dx->driving
        + x->driving * dp->drive_torque);
    const real d_foot_mass_times_gravity = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    c->inverse_body_mass = d_inverse_body_mass;
    c->stiffness = dp->stiffness;
    c->free_length = dp->free_length;
    c->damping = dp->damping;
    c->stance_torque = d_stance_torque;
    c->gravity = dp->gravity;
    c->foot_vx = dx->foot_vx;
    c->least_length = dp->least_length;
    c->winding = dx->winding;
    c->foot_mass_times_gravity = d_foot_mass_times_gravity;
    c->friction = dx->friction;
}

/* mid_stance: Drive ends where the leg is upright, once per stance. */
static int react_stick_mid_stance(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    plain_reduced_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->driving = 0.0;
    return next[0]; /* stick */
}

/* slips_forward: The push of the leg exceeds static friction, and the foot slips forward. */
static int react_stick_slips_forward(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    plain_reduced_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->way = 1.0;
    return next[0]; /* slip */
}

/* First variation of slips_forward. */
static void vary_react_stick_slips_forward(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    plain_reduced_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed;
    y->way = 0.0;
}

/* First variation of the guard of slips_forward. */
static real vary_guard_stick_slips_forward(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real free_length_minus_length = p->free_length - length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real spring = p->stiffness * free_length_minus_length - p->damping * length_rate;
    const real axial = spring / length;
    const real stance_torque = x->external_torque - p->drive_torque * x->driving;
    const real turning = stance_torque / square;
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + p->foot_mass * p->gravity;
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * free_length_minus_length + p->stiffness * (dp->free_length
        - d_length) - (dp->damping * length_rate + p->damping * d_length_rate);
    const real d_axial = (d_spring - axial * d_length) / length;
    const real d_stance_torque = dx->external_torque - (dp->drive_torque * x->driving
        + p->drive_torque * dx->driving);
    const real d_turning = (d_stance_torque - turning * d_square) / square;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real d_normal = d_off + (p->gravity * dp->foot_mass + p->foot_mass * dp->gravity);
    const real d_cone = dx->friction * normal + x->friction * d_normal;
    const real d_along = d_axial * x->x_ + axial * dx->x_ - (d_turning * x->y_ + turning * dx->y_);
    return d_cone + d_along;
}

/* slips_backward: The push of the leg exceeds static friction, and the foot slips backward. */
static int react_stick_slips_backward(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    plain_reduced_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->way = -1.0;
    return next[0]; /* slip */
}

/* First variation of the guard of slips_backward. */
static real vary_guard_stick_slips_backward(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real free_length_minus_length = p->free_length - length;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real spring = p->stiffness * free_length_minus_length - p->damping * length_rate;
    const real axial = spring / length;
    const real stance_torque = x->external_torque - p->drive_torque * x->driving;
    const real turning = stance_torque / square;
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + p->foot_mass * p->gravity;
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real d_spring = dp->stiffness * free_length_minus_length + p->stiffness * (dp->free_length
        - d_length) - (dp->damping * length_rate + p->damping * d_length_rate);
    const real d_axial = (d_spring - axial * d_length) / length;
    const real d_stance_torque = dx->external_torque - (dp->drive_torque * x->driving
        + p->drive_torque * dx->driving);
    const real d_turning = (d_stance_torque - turning * d_square) / square;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real d_normal = d_off + (p->gravity * dp->foot_mass + p->foot_mass * dp->gravity);
    const real d_cone = dx->friction * normal + x->friction * d_normal;
    const real d_along = d_axial * x->x_ + axial * dx->x_ - (d_turning * x->y_ + turning * dx->y_);
    return d_cone - d_along;
}

/* Count the event. A contact mode that lasted adds a letter to the gait word, a new stance a bar. */
static void leave_stick(const real *parameters, const real *states, real counted, real *after) {
    const plain_reduced_runner_states *x = (const void *)states;
    plain_reduced_runner_states *y = (void *)after;
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
    const plain_reduced_runner_states *x = (const void *)states;
    const plain_reduced_runner_states *dx = (const void *)d_states;
    plain_reduced_runner_states *y = (void *)after;
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

/* at_apex: A start at an apex, with the centre of mass at x = 0 and the leg at rest. */
static void enter_at_apex(const real *parameters, const real *states, const real *at, real *after) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    plain_reduced_runner_states *y = (void *)after;
    (void)states;
    const real at_apex_com_height = at[0];
    const real at_apex_com_speed = at[1];
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real sine = real_sin(p->touchdown_angle);
    const real cosine = real_cos(p->touchdown_angle);
    const real y_2 = p->free_length * cosine;
    y->seen_x = share * (p->free_length * sine);
    y->seen_y = at_apex_com_height - share * y_2;
    y->length = p->free_length;
    y->angle = p->touchdown_angle;
    y->seen_vx = at_apex_com_speed;
    y->seen_vy = 0.0;
    y->length_rate = 0.0;
    y->angle_rate = 0.0;
}

/* First variation of enter_at_apex. */
static void vary_enter_at_apex(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const real *at, const real *d_at, real *after) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const plain_reduced_runner_parameters *dp = (const void *)d_parameters;
    plain_reduced_runner_states *y = (void *)after;
    (void)states, (void)d_states, (void)at;
    const real d_at_apex_com_height = d_at[0];
    const real d_at_apex_com_speed = d_at[1];
    const real sine = real_sin(p->touchdown_angle);
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real cosine = real_cos(p->touchdown_angle);
    const real d_sine = cosine * dp->touchdown_angle;
    const real y_2 = p->free_length * cosine;
    const real d_y = cosine * dp->free_length - p->free_length * (sine * dp->touchdown_angle);
    y->seen_x = p->free_length * sine * d_share + share * (sine * dp->free_length + p->free_length * d_sine);
    y->seen_y = d_at_apex_com_height - (y_2 * d_share + share * d_y);
    y->length = dp->free_length;
    y->angle = dp->touchdown_angle;
    y->seen_vx = d_at_apex_com_speed;
    y->seen_vy = 0.0;
    y->length_rate = 0.0;
    y->angle_rate = 0.0;
}

/* Typical size of each state and guard. */
static void scales(const real *parameters, real *of_states, real *of_events) {
    const plain_reduced_runner_parameters *p = (const void *)parameters;
    const real sqrt_of_stiffness_over_body_mass = real_sqrt(p->stiffness / p->body_mass);
    of_states[0] = real_sqrt(p->body_mass / p->stiffness);
    of_states[1] = 1.0;
    of_states[2] = real_sqrt(p->body_mass / p->stiffness);
    of_states[3] = 1.0;
    of_states[4] = p->stiffness * p->free_length * p->free_length;
    of_states[5] = p->stiffness * p->free_length * p->free_length;
    of_states[6] = p->stiffness * p->free_length * p->free_length;
    of_states[7] = p->stiffness * p->free_length;
    of_states[8] = 1.0;
    of_states[9] = p->free_length;
    of_states[10] = p->free_length;
    of_states[11] = real_sqrt(p->body_mass / p->stiffness);
    of_states[12] = 1.0;
    of_states[13] = 1.0;
    of_states[14] = 1.0;
    of_states[15] = real_sqrt(p->body_mass / p->stiffness);
    of_states[16] = p->free_length;
    of_states[17] = p->free_length;
    of_states[18] = 1.0;
    of_states[19] = 1.0;
    of_states[20] = real_sqrt(p->body_mass / p->stiffness);
    of_states[21] = p->free_length;
    of_states[22] = p->free_length;
    of_states[23] = p->stiffness * p->free_length * p->free_length;
    of_states[24] = p->stiffness * p->free_length * p->free_length;
    of_states[25] = p->stiffness * p->free_length * p->free_length;
    of_states[26] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[27] = 1.0;
    of_states[28] = 1.0;
    of_states[29] = real_sqrt(p->body_mass / p->stiffness);
    of_states[30] = 1.0;
    of_states[31] = p->free_length;
    of_states[32] = p->stiffness * p->free_length;
    of_states[33] = p->stiffness * p->free_length;
    of_states[34] = real_sqrt(p->body_mass / p->stiffness);
    of_states[35] = p->free_length;
    of_states[36] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[37] = p->free_length;
    of_states[38] = 1.0;
    of_states[39] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[40] = sqrt_of_stiffness_over_body_mass;
    of_states[41] = p->free_length;
    of_states[42] = p->free_length;
    of_states[43] = p->free_length;
    of_states[44] = 1.0;
    of_states[45] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[46] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[47] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[48] = sqrt_of_stiffness_over_body_mass;
    of_states[49] = p->free_length;
    of_states[50] = p->free_length;
    of_states[51] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[52] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[53] = p->free_length * p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[54] = p->free_length;
    of_states[55] = p->free_length;
    of_states[56] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[57] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[58] = p->free_length;
    of_states[59] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[60] = 1.0;
    of_states[61] = p->stiffness * p->free_length * p->free_length;
    of_states[62] = 1.0;
    of_states[63] = 1.0;
    of_states[64] = p->stiffness * p->free_length * p->free_length;
    of_states[65] = p->stiffness * p->free_length * p->free_length;
    of_states[66] = p->stiffness * p->free_length * p->free_length;
    of_states[67] = 1.0;
    of_states[68] = 1.0;
    of_states[69] = 1.0;
    of_states[70] = real_sqrt(p->body_mass / p->stiffness);
    of_states[71] = real_sqrt(p->body_mass / p->stiffness);
    of_states[72] = p->stiffness * p->free_length * p->free_length;
    of_states[73] = 1.0;
    of_events[EVENT_begins] = 1.0;
    of_events[EVENT_falls] = p->free_length;
    of_events[EVENT_collapses] = p->free_length;
    of_events[EVENT_apex] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_events[EVENT_touchdown] = p->free_length;
    of_events[EVENT_mid_stance] = 1.0;
    of_events[EVENT_lift_off] = p->stiffness * p->free_length;
    of_events[EVENT_slips_forward] = p->stiffness * p->free_length;
    of_events[EVENT_slips_backward] = p->stiffness * p->free_length;
    of_events[EVENT_comes_to_rest] = p->free_length * sqrt_of_stiffness_over_body_mass;
}

static const tdmf_guard_kind guards_start_of_run[] = {
    {.event = EVENT_begins, .react = react_start_of_run_begins, .vary_react = vary_react_start_of_run_begins,
        .vary_guard = vary_guard_start_of_run_begins, .next = {MODE_no_start, MODE_flight}},
    {.event = -1},
};
static const tdmf_watch_kind watches_start_of_run[] = {
    {.into = -1},
};
static const tdmf_guard_kind guards_no_start[] = {
    {.event = -1},
};
static const tdmf_watch_kind watches_no_start[] = {
    {.into = -1},
};
static const tdmf_guard_kind guards_flight[] = {
    {.event = EVENT_falls, .is_counted = true, .react = react_flight_falls,
        .vary_react = vary_react_flight_falls, .is_watched = watches_flight_falls, .looks_again = true,
        .vary_guard = vary_guard_flight_falls, .next = {MODE_fallen}},
    {.event = EVENT_apex, .is_counted = true, .react = react_flight_apex,
        .vary_react = vary_react_flight_apex, .is_watched = watches_flight_apex,
        .vary_guard = vary_guard_flight_apex, .next = {MODE_no_start, MODE_flight}},
    {.event = EVENT_touchdown, .is_counted = true, .react = react_flight_touchdown,
        .vary_react = vary_react_flight_touchdown, .is_watched = watches_flight_touchdown,
        .vary_guard = vary_guard_flight_touchdown, .next = {MODE_slip_constant, MODE_stick}},
    {.event = -1},
};
static const tdmf_watch_kind watches_flight[] = {
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 5},
    {.into = -1},
};
static const tdmf_guard_kind guards_fallen[] = {
    {.event = -1},
};
static const tdmf_watch_kind watches_fallen[] = {
    {.into = -1},
};
static const tdmf_guard_kind guards_slip_constant[] = {
    {.event = EVENT_falls, .is_counted = true, .react = react_slip_constant_falls,
        .vary_react = vary_react_slip_constant_falls, .looks_again = true,
        .vary_guard = vary_guard_slip_constant_falls, .next = {MODE_fallen}},
    {.event = EVENT_collapses, .is_counted = true, .react = react_slip_constant_falls,
        .vary_react = vary_react_slip_constant_falls, .looks_again = true,
        .vary_guard = vary_guard_slip_constant_collapses, .next = {MODE_fallen}},
    {.event = EVENT_mid_stance, .is_counted = true, .react = react_slip_constant_mid_stance,
        .vary_react = vary_react_slip_constant_mid_stance, .is_watched = watches_slip_constant_mid_stance,
        .vary_guard = vary_guard_slip_constant_mid_stance, .next = {MODE_slip_constant}},
    {.event = EVENT_lift_off, .is_counted = true, .react = react_slip_constant_lift_off,
        .vary_react = vary_react_slip_constant_lift_off, .vary_guard = vary_guard_slip_constant_lift_off,
        .next = {MODE_no_stance, MODE_no_apex, MODE_flight}},
    {.event = EVENT_comes_to_rest, .is_counted = true, .react = react_slip_constant_comes_to_rest,
        .vary_react = vary_react_slip_constant_comes_to_rest,
        .vary_guard = vary_guard_slip_constant_comes_to_rest, .next = {MODE_stick, MODE_slip_constant}},
    {.event = -1},
};
static const tdmf_watch_kind watches_slip_constant[] = {
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 5},
    {.part = TDMF_LARGEST, .into = 7},
    {.into = -1},
};
static const tdmf_guard_kind guards_stick[] = {
    {.event = EVENT_falls, .is_counted = true, .react = react_slip_constant_falls,
        .vary_react = vary_react_slip_constant_falls, .looks_again = true,
        .vary_guard = vary_guard_slip_constant_falls, .next = {MODE_fallen}},
    {.event = EVENT_collapses, .is_counted = true, .react = react_slip_constant_falls,
        .vary_react = vary_react_slip_constant_falls, .looks_again = true,
        .vary_guard = vary_guard_slip_constant_collapses, .next = {MODE_fallen}},
    {.event = EVENT_mid_stance, .is_counted = true, .react = react_stick_mid_stance,
        .vary_react = vary_react_slip_constant_mid_stance, .is_watched = watches_slip_constant_mid_stance,
        .vary_guard = vary_guard_slip_constant_mid_stance, .next = {MODE_stick}},
    {.event = EVENT_lift_off, .is_counted = true, .react = react_slip_constant_lift_off,
        .vary_react = vary_react_slip_constant_lift_off, .vary_guard = vary_guard_slip_constant_lift_off,
        .next = {MODE_no_stance, MODE_no_apex, MODE_flight}},
    {.event = EVENT_slips_forward, .is_counted = true, .react = react_stick_slips_forward,
        .vary_react = vary_react_stick_slips_forward, .vary_guard = vary_guard_stick_slips_forward,
        .next = {MODE_slip_constant}},
    {.event = EVENT_slips_backward, .is_counted = true, .react = react_stick_slips_backward,
        .vary_react = vary_react_stick_slips_forward, .vary_guard = vary_guard_stick_slips_backward,
        .next = {MODE_slip_constant}},
    {.event = -1},
};
static const tdmf_watch_kind watches_stick[] = {
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 5},
    {.part = TDMF_LARGEST, .into = 7},
    {.into = -1},
};
static const tdmf_guard_kind guards_no_stance[] = {
    {.event = -1},
};
static const tdmf_watch_kind watches_no_stance[] = {
    {.into = -1},
};
static const tdmf_guard_kind guards_no_apex[] = {
    {.event = -1},
};
static const tdmf_watch_kind watches_no_apex[] = {
    {.into = -1},
};
static const int coordinates_at_apex[] = {35, 36};

static const tdmf_mode_kind modes[] = {
    {.motion = &tdmf_plain_reduced_runner_motions[MODE_start_of_run], .open = open_start_of_run,
        .vary_open = vary_open_start_of_run, .guard_count = 1, .guards = guards_start_of_run,
        .watch_count = 0, .usual_count = 0, .watches = watches_start_of_run, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run},
    {.motion = &tdmf_plain_reduced_runner_motions[MODE_no_start], .ends = true, .open = open_start_of_run,
        .vary_open = vary_open_start_of_run, .guard_count = 0, .guards = guards_no_start, .watch_count = 0,
        .usual_count = 0, .watches = watches_no_start, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run},
    {.motion = &tdmf_plain_reduced_runner_motions[MODE_flight], .open = open_flight,
        .vary_open = vary_open_flight, .guard_count = 3, .guards = guards_flight, .watch_count = 1,
        .usual_count = 1, .watches = watches_flight, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run, .from_world = from_world_flight,
        .vary_from_world = vary_from_world_flight, .to_world = to_world_flight,
        .vary_to_world = vary_to_world_flight},
    {.motion = &tdmf_plain_reduced_runner_motions[MODE_fallen], .ends = true, .keeps_outputs = true,
        .open = open_start_of_run, .vary_open = vary_open_start_of_run, .guard_count = 0,
        .guards = guards_fallen, .watch_count = 0, .usual_count = 0, .watches = watches_fallen,
        .outputs = outputs_start_of_run, .vary_outputs = vary_outputs_start_of_run,
        .leave = leave_start_of_run, .vary_leave = vary_leave_start_of_run},
    {.motion = &tdmf_plain_reduced_runner_motions[MODE_slip_constant], .open = open_slip_constant,
        .vary_open = vary_open_slip_constant, .guard_count = 5, .guards = guards_slip_constant,
        .watch_count = 2, .usual_count = 2, .watches = watches_slip_constant, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_slip_constant,
        .vary_leave = vary_leave_slip_constant, .from_world = from_world_slip_constant,
        .vary_from_world = vary_from_world_slip_constant, .to_world = to_world_slip_constant,
        .vary_to_world = vary_to_world_slip_constant},
    {.motion = &tdmf_plain_reduced_runner_motions[MODE_stick], .open = open_stick,
        .vary_open = vary_open_stick, .guard_count = 6, .guards = guards_stick, .watch_count = 2,
        .usual_count = 2, .watches = watches_stick, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_stick, .vary_leave = vary_leave_stick,
        .from_world = from_world_slip_constant, .vary_from_world = vary_from_world_slip_constant,
        .to_world = to_world_slip_constant, .vary_to_world = vary_to_world_slip_constant},
    {.motion = &tdmf_plain_reduced_runner_motions[MODE_no_stance], .ends = true, .open = open_start_of_run,
        .vary_open = vary_open_start_of_run, .guard_count = 0, .guards = guards_no_stance, .watch_count = 0,
        .usual_count = 0, .watches = watches_no_stance, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run},
    {.motion = &tdmf_plain_reduced_runner_motions[MODE_no_apex], .ends = true, .open = open_start_of_run,
        .vary_open = vary_open_start_of_run, .guard_count = 0, .guards = guards_no_apex, .watch_count = 0,
        .usual_count = 0, .watches = watches_no_apex, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run},
};

static const tdmf_set_kind sets[] = {
    {.index = -1},
};
static const tdmf_section_kind sections[] = {
    {.enter = enter_at_apex, .vary_enter = vary_enter_at_apex, .event = EVENT_apex, .count = 2,
        .coordinates = coordinates_at_apex},
    {.event = -1},
};

static const char *const mode_names[] = {"start_of_run", "no_start", "flight", "fallen", "slip_constant",
    "stick", "no_stance", "no_apex"};
static const char *const state_names[] = {"time", "events", "last_event", "is_open", "work_then",
    "positive_work_so_far", "positive_work_then", "peak_force_so_far", "touchdowns_so_far", "slip_so_far",
    "slid_from", "stance_so_far", "word_so_far", "last_letter", "bar_is_due", "mode_began", "x_then",
    "y_then", "count", "word_code", "period", "distance", "rise_of_stride", "work_of_stride", "hip_work",
    "positive_work", "speed", "cost_of_transport", "touchdowns", "stance_time", "duty_factor",
    "slip_distance", "peak_force", "peak_vertical_force", "apex_time", "apex_com_height", "apex_com_speed",
    "apex_length", "apex_angle", "apex_length_rate", "apex_angle_rate", "seen_x", "seen_y", "length", "angle",
    "seen_vx", "seen_vy", "length_rate", "angle_rate", "com_x", "com_y", "com_vx", "com_vy", "momentum", "x",
    "y", "vx", "vy", "foot_x", "foot_vx", "winding", "damper_loss", "friction", "way", "friction_loss",
    "impact_loss", "external_torque", "liftoff_angle", "driving", "swing", "placing", "touchdown_time",
    "work", "has_fallen"};
static const char *const parameter_names[] = {"body_mass", "foot_mass", "stiffness", "damping", "free_length",
    "least_length", "gravity", "drive_torque", "touchdown_angle"};
static const char *const event_names[] = {"begins", "falls", "collapses", "apex", "touchdown", "mid_stance",
    "lift_off", "slips_forward", "slips_backward", "comes_to_rest"};
static const char *const output_names[] = {0};
static const char *const table_names[] = {0};
static const char *const section_names[] = {"at_apex"};
static const double state_defaults[] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.4722627765193387, 0.6417114468531165, 0.9999993776846997,
    -0.5462532571145313, 1.062035591761993, -1.9951712441925837e-05, 1.1268102275039307e-06,
    4.039363331769765e-05, 0.0, 1.4, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.6, 1.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0};
static const double parameter_defaults[] = {1.0, 0.1, 1.0, 0.2, 1.0, 0.05, 0.01, 0.2, 0.6981317007977318};
static const double parameter_least[] = {1e-09, 1e-12, 1e-09, 0.0, 1e-06, 1e-09, 1e-09, -1e+18,
    -1.5707963267948966};
static const double parameter_most[] = {1000000000.0, 1000000000.0, 1000000000000.0, 1000000000000.0,
    1000000.0, 1000000.0, 1000000.0, 1e+18, 1.5707963267948966};

const tdmf_model_kind tdmf_plain_reduced_runner_model = {
    .modes = modes,
    .sets = sets,
    .set_count = 0,
    .sections = sections,
    .scales = scales,
    .series_count = 28,
    .constant_count = 12,
    .lanes = {TDMF_TWO_LANES(tdmf_plain_reduced_runner_motions_of_2),
        TDMF_FOUR_LANES(tdmf_plain_reduced_runner_motions_of_4),
        TDMF_EIGHT_LANES(tdmf_plain_reduced_runner_motions_of_8)},
    .seeds = TDMF_FOR_SEEDS(tdmf_plain_reduced_runner_seeds),
    .mode_count = 8,
    .mode_names = mode_names,
    .state_count = 74,
    .state_names = state_names,
    .parameter_count = 9,
    .parameter_names = parameter_names,
    .event_count = 10,
    .event_names = event_names,
    .output_count = 0,
    .output_names = output_names,
    .table_count = 0,
    .table_names = table_names,
    .section_count = 1,
    .section_names = section_names,
    .state_defaults = state_defaults,
    .parameter_defaults = parameter_defaults,
    .parameter_least = parameter_least,
    .parameter_most = parameter_most,
};
