/* Derived from the page ReducedRunner: edit the page, not this. */
#include "reduced_runner.h"

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
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
    (void)tables;
    const real cos_of_ground_slope = real_cos(p->ground_slope);
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real cosine = real_cos(x->angle);
    const real y_2 = x->length * cosine;
    const real seen_y_plus_share_times_y = x->seen_y + share * y_2;
    const real sum_2 = seen_y_plus_share_times_y - p->ground_height;
    const real sin_of_ground_slope = real_sin(p->ground_slope);
    const real sine = real_sin(x->angle);
    const real sum_3 = x->seen_x - share * (x->length * sine);
    const real level = cos_of_ground_slope * sum_2 - sin_of_ground_slope * sum_3;
    const real angle = p->touchdown_angle + p->more_angle;
    const real length = p->free_length + x->extension;
    const real above = level - real_cos(angle - p->ground_slope) * (share * length);
    y->height = p->ground_height;
    y->slope = p->ground_slope;
    y->liftoff_angle = x->angle;
    if (above <= 0.0) {
        return next[0]; /* no_start */
    }
    const real height_of_section = sum_2 - sin_of_ground_slope / cos_of_ground_slope * sum_3;
    const real turn = x->length * x->angle_rate;
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real seen_vx_plus_share_times_vx = x->seen_vx + share * vx;
    const real length_times_length = length * length;
    const real product_2 = p->retraction_rate * length_times_length;
    const real rate = -(product_2 / length_times_length);
    const real vy = x->length_rate * cosine - turn * sine;
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
    y->x_then = sum_3;
    y->y_then = seen_y_plus_share_times_y;
    y->apex_time = x->time;
    y->apex_com_height = height_of_section;
    y->apex_com_speed = seen_vx_plus_share_times_vx;
    y->apex_length = length;
    y->apex_angle = angle;
    y->apex_length_rate = 0.0;
    y->apex_angle_rate = rate;
    y->length = length;
    y->angle = angle;
    y->length_rate = 0.0;
    y->com_x = sum_3;
    y->com_y = seen_y_plus_share_times_y;
    y->com_vx = seen_vx_plus_share_times_vx;
    y->com_vy = x->seen_vy + share * vy;
    y->momentum = -product_2;
    y->swing = 2.0;
    y->placing = 0.0;
    return next[1]; /* flight */
}

/* First variation of begins. */
static void vary_react_start_of_run_begins(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real cos_of_ground_slope = real_cos(p->ground_slope);
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real cosine = real_cos(x->angle);
    const real y_2 = x->length * cosine;
    const real sin_of_ground_slope = real_sin(p->ground_slope);
    const real sine = real_sin(x->angle);
    const real length_times_sine = x->length * sine;
    const real sum_2 = x->seen_x - share * length_times_sine;
    const real level = cos_of_ground_slope * (x->seen_y + share * y_2 - p->ground_height)
        - sin_of_ground_slope * sum_2;
    const real angle = p->touchdown_angle + p->more_angle;
    const real length = p->free_length + x->extension;
    const real above = level - real_cos(angle - p->ground_slope) * (share * length);
    y->height = dp->ground_height;
    y->slope = dp->ground_slope;
    y->liftoff_angle = dx->angle;
    if (above <= 0.0) {
        return;
    }
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_sine = cosine * dx->angle;
    const real seen_x_minus_sum = dx->seen_x - (d_share * length_times_sine + share * (dx->length * sine
        + x->length * d_sine));
    const real sine_times_angle = sine * dx->angle;
    const real d_y = dx->length * cosine - x->length * sine_times_angle;
    const real sum_3 = dx->seen_y + (d_share * y_2 + share * d_y);
    const real ratio = sin_of_ground_slope / cos_of_ground_slope;
    const real d_height_of_section = sum_3 - dp->ground_height - ((cos_of_ground_slope * dp->ground_slope
        + ratio * (sin_of_ground_slope * dp->ground_slope)) / cos_of_ground_slope * sum_2
        + ratio * seen_x_minus_sum);
    const real turn = x->length * x->angle_rate;
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real d_turn = dx->length * x->angle_rate + x->length * dx->angle_rate;
    const real d_vx = -(dx->length_rate * sine + x->length_rate * d_sine) - (d_turn * cosine
        - turn * sine_times_angle);
    const real sum_4 = dx->seen_vx + (d_share * vx + share * d_vx);
    const real d_length = dp->free_length + dx->extension;
    const real d_angle = dp->touchdown_angle + dp->more_angle;
    const real length_times_length = length * length;
    const real by_2_times_length_times_d_length = 2.0 * (length * d_length);
    const real product_plus_product = dp->retraction_rate * length_times_length
        + p->retraction_rate * by_2_times_length_times_d_length;
    const real d_rate = -((product_plus_product
        - p->retraction_rate * length_times_length / length_times_length * by_2_times_length_times_d_length) /
        length_times_length);
    const real vy = x->length_rate * cosine - turn * sine;
    const real d_vy = dx->length_rate * cosine - x->length_rate * sine_times_angle - (d_turn * sine
        + turn * d_sine);
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
    y->apex_length = d_length;
    y->apex_angle = d_angle;
    y->apex_length_rate = 0.0;
    y->apex_angle_rate = d_rate;
    y->length = d_length;
    y->angle = d_angle;
    y->length_rate = 0.0;
    y->com_x = seen_x_minus_sum;
    y->com_y = sum_3;
    y->com_vx = sum_4;
    y->com_vy = dx->seen_vy + (d_share * vy + share * d_vy);
    y->momentum = -product_plus_product;
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
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const real pending = select(real_abs(p->ground_height - x->height)
        + real_abs(p->free_length * (p->ground_slope - x->slope)) > 0.0, 1.0, 0.0);
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
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
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
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
    (void)parameters;
    const real is_new = select(x->time > x->last_event, counted, 0.0);
    y->events = x->events + is_new;
    y->last_event = select(counted > 0.0, x->time, x->last_event);
    y->mode_began = x->time;
}

/* First variation of leave_start_of_run. */
static void vary_leave_start_of_run(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real counted, real *after) {
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters;
    y->events = dx->events;
    y->last_event = select(counted > 0.0, dx->time, dx->last_event);
    y->mode_began = dx->time;
}

/* Constants of flight. */
static void open_flight(const real *parameters, const real *states, real *constants) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    flight_constants *c = (void *)constants;
    const real total = p->body_mass + p->foot_mass;
    const real external_fx_over_total = x->external_fx / total;
    const real external_fy_over_total_minus_gravity = x->external_fy / total - p->gravity;
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real is_placing_times_rate = is_placing * rate;
    const real cos_of_slope = real_cos(x->slope);
    const real sin_of_slope = real_sin(x->slope);
    const real share = p->body_mass / total;
    const real by_1_minus_share_times_length = (1.0 - share) * x->length;
    const real share_times_length = share * x->length;
    c->external_fx = x->external_fx;
    c->external_fy = x->external_fy;
    c->external_fx_over_total = external_fx_over_total;
    c->external_fy_over_total_minus_gravity = external_fy_over_total_minus_gravity;
    c->is_placing = is_placing;
    c->is_placing_times_rate = is_placing_times_rate;
    c->slope = x->slope;
    c->cos_of_slope = cos_of_slope;
    c->height = x->height;
    c->sin_of_slope = sin_of_slope;
    c->by_1_minus_share_times_length = by_1_minus_share_times_length;
    c->share_times_length = share_times_length;
}

/* First variation of open_flight. */
static void vary_open_flight(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    flight_constants *c = (void *)constants;
    const real total = p->body_mass + p->foot_mass;
    const real external_fx_over_total = x->external_fx / total;
    const real d_total = dp->body_mass + dp->foot_mass;
    const real d_external_fx_over_total = (dx->external_fx - external_fx_over_total * d_total) / total;
    const real d_external_fy_over_total_minus_gravity = (dx->external_fy
        - x->external_fy / total * d_total) / total - dp->gravity;
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real d_square = 2.0 * (x->length * dx->length);
    const real d_rate = (dx->momentum - rate * d_square) / square;
    const real d_is_placing_times_rate = is_placing * d_rate;
    const real sin_of_slope = real_sin(x->slope);
    const real d_cos_of_slope = -(sin_of_slope * dx->slope);
    const real cos_of_slope = real_cos(x->slope);
    const real d_sin_of_slope = cos_of_slope * dx->slope;
    const real share = p->body_mass / total;
    const real d_share = (dp->body_mass - share * d_total) / total;
    const real length_times_d_share = x->length * d_share;
    const real d_by_1_minus_share_times_length = (1.0 - share) * dx->length - length_times_d_share;
    const real d_share_times_length = length_times_d_share + share * dx->length;
    c->external_fx = dx->external_fx;
    c->external_fy = dx->external_fy;
    c->external_fx_over_total = d_external_fx_over_total;
    c->external_fy_over_total_minus_gravity = d_external_fy_over_total_minus_gravity;
    c->is_placing = 0.0;
    c->is_placing_times_rate = d_is_placing_times_rate;
    c->slope = dx->slope;
    c->cos_of_slope = d_cos_of_slope;
    c->height = dx->height;
    c->sin_of_slope = d_sin_of_slope;
    c->by_1_minus_share_times_length = d_by_1_minus_share_times_length;
    c->share_times_length = d_share_times_length;
}

/* falls: The body reaches the ground. */
static int react_flight_falls(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
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
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
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
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    if (x->swing < 2.0) {
        return 0.0;
    }
    if (real_abs(p->retraction_rate) > 0.0 || real_cos(x->angle - x->slope) < 0.01) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of falls. */
static real vary_guard_flight_falls(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
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

/* apex: A stride closes, and the leg is placed anew. */
static int react_flight_apex(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
    (void)tables;
    const real cos_of_slope = real_cos(x->slope);
    const real com_y_minus_height = x->com_y - x->height;
    const real sin_of_slope = real_sin(x->slope);
    const real level = cos_of_slope * com_y_minus_height - sin_of_slope * x->com_x;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real length = p->free_length + x->extension;
    const real angle = p->touchdown_angle + p->more_angle;
    const real above = level - share * length * real_cos(angle - x->slope);
    const real count_plus_by_1_or_count = select(x->is_open > 0.0, x->count + 1.0, x->count);
    const real word_so_far_or_word_code = select(x->is_open > 0.0, x->word_so_far, x->word_code);
    const real period = x->time - x->apex_time;
    const real period_or_period = select(x->is_open > 0.0, period, x->period);
    const real distance = x->com_x - x->x_then;
    const real distance_or_distance = select(x->is_open > 0.0, distance, x->distance);
    const real com_y_minus_y_then_or_rise_of_stride = select(x->is_open > 0.0, x->com_y - x->y_then,
        x->rise_of_stride);
    const real hip = x->work - x->work_then;
    const real leg = x->leg_work - x->leg_work_then;
    const real work = hip + leg;
    const real work_or_work_of_stride = select(x->is_open > 0.0, work, x->work_of_stride);
    const real hip_or_hip_work = select(x->is_open > 0.0, hip, x->hip_work);
    const real leg_or_leg_work_of_stride = select(x->is_open > 0.0, leg, x->leg_work_of_stride);
    const real sum_or_positive_work = select(x->is_open > 0.0, x->positive_work_so_far
        - x->positive_work_then, x->positive_work);
    const real distance_over_period_or_com_vx_or_speed = select(x->is_open > 0.0, select(period > 0.0,
        distance / period, x->com_vx), x->speed);
    const real weight = body_mass_plus_foot_mass * p->gravity;
    const real select_2 = select(x->is_open > 0.0, select(period > 0.0, work / (weight * distance), 0.0),
        x->cost_of_transport);
    const real touchdowns_so_far_or_touchdowns = select(x->is_open > 0.0, x->touchdowns_so_far,
        x->touchdowns);
    const real stance_so_far_or_stance_time = select(x->is_open > 0.0, x->stance_so_far, x->stance_time);
    const real select_3 = select(x->is_open > 0.0, select(period > 0.0, x->stance_so_far / period, 0.0),
        x->duty_factor);
    const real slip_so_far_or_slip_distance = select(x->is_open > 0.0, x->slip_so_far, x->slip_distance);
    const real peak_force_so_far_or_peak_force = select(x->is_open > 0.0, x->peak_force_so_far,
        x->peak_force);
    const real vertical_so_far_or_peak_vertical_force = select(x->is_open > 0.0, x->vertical_so_far,
        x->peak_vertical_force);
    const real height_of_section = com_y_minus_height - x->com_x * (sin_of_slope / cos_of_slope);
    const real square = length * length;
    const real retraction_rate_times_square = p->retraction_rate * square;
    const real rate = -(retraction_rate_times_square / square);
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
    y->count = count_plus_by_1_or_count;
    y->word_code = word_so_far_or_word_code;
    y->period = period_or_period;
    y->distance = distance_or_distance;
    y->rise_of_stride = com_y_minus_y_then_or_rise_of_stride;
    y->work_of_stride = work_or_work_of_stride;
    y->hip_work = hip_or_hip_work;
    y->leg_work_of_stride = leg_or_leg_work_of_stride;
    y->positive_work = sum_or_positive_work;
    y->speed = distance_over_period_or_com_vx_or_speed;
    y->cost_of_transport = select_2;
    y->touchdowns = touchdowns_so_far_or_touchdowns;
    y->stance_time = stance_so_far_or_stance_time;
    y->duty_factor = select_3;
    y->slip_distance = slip_so_far_or_slip_distance;
    y->peak_force = peak_force_so_far_or_peak_force;
    y->peak_vertical_force = vertical_so_far_or_peak_vertical_force;
    y->apex_time = x->time;
    y->apex_com_height = height_of_section;
    y->apex_com_speed = x->com_vx;
    y->apex_length = length;
    y->apex_angle = angle;
    y->apex_length_rate = 0.0;
    y->apex_angle_rate = rate;
    y->length = length;
    y->angle = angle;
    y->length_rate = 0.0;
    y->swing = 2.0;
    y->placing = 0.0;
    if (above <= 0.0) {
        const real sine = real_sin(angle);
        const real cosine = real_cos(angle);
        const real y_2 = cosine * length;
        const real ratio = retraction_rate_times_square / length;
        const real vx = cosine * ratio;
        const real vy = sine * ratio;
        y->seen_x = x->com_x + share * (sine * length);
        y->seen_y = x->com_y - share * y_2;
        y->seen_vx = x->com_vx - share * vx;
        y->seen_vy = x->com_vy - share * vy;
        y->angle_rate = rate;
        return next[0]; /* no_start */
    }
    const real moment = -retraction_rate_times_square;
    y->momentum = moment;
    return next[1]; /* flight */
}

/* First variation of apex. */
static void vary_react_flight_apex(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real cos_of_slope = real_cos(x->slope);
    const real sin_of_slope = real_sin(x->slope);
    const real level = cos_of_slope * (x->com_y - x->height) - sin_of_slope * x->com_x;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real length = p->free_length + x->extension;
    const real angle = p->touchdown_angle + p->more_angle;
    const real above = level - share * length * real_cos(angle - x->slope);
    const real word_so_far_or_word_code = select(x->is_open > 0.0, dx->word_so_far, dx->word_code);
    const real d_period = dx->time - dx->apex_time;
    const real d_period_or_period = select(x->is_open > 0.0, d_period, dx->period);
    const real d_distance = dx->com_x - dx->x_then;
    const real d_distance_or_distance = select(x->is_open > 0.0, d_distance, dx->distance);
    const real com_y_minus_y_then_or_rise_of_stride = select(x->is_open > 0.0, dx->com_y - dx->y_then,
        dx->rise_of_stride);
    const real d_hip = dx->work - dx->work_then;
    const real d_leg = dx->leg_work - dx->leg_work_then;
    const real d_work = d_hip + d_leg;
    const real d_work_or_work_of_stride = select(x->is_open > 0.0, d_work, dx->work_of_stride);
    const real d_hip_or_hip_work = select(x->is_open > 0.0, d_hip, dx->hip_work);
    const real d_leg_or_leg_work_of_stride = select(x->is_open > 0.0, d_leg, dx->leg_work_of_stride);
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
    const real leg = x->leg_work - x->leg_work_then;
    const real work = hip + leg;
    const real d_weight = p->gravity * body_mass_plus_foot_mass_2 + body_mass_plus_foot_mass * dp->gravity;
    const real ratio_or_by_0_or_cost_of_transport = select(x->is_open > 0.0, select(period > 0.0, (d_work
        - work / weight_times_distance * (d_weight * distance + weight * d_distance)) / weight_times_distance,
        0.0), dx->cost_of_transport);
    const real touchdowns_so_far_or_touchdowns = select(x->is_open > 0.0, dx->touchdowns_so_far,
        dx->touchdowns);
    const real stance_so_far_or_stance_time = select(x->is_open > 0.0, dx->stance_so_far, dx->stance_time);
    const real select_or_duty_factor = select(x->is_open > 0.0, select(period > 0.0, (dx->stance_so_far
        - x->stance_so_far / period * d_period) / period, 0.0), dx->duty_factor);
    const real slip_so_far_or_slip_distance = select(x->is_open > 0.0, dx->slip_so_far, dx->slip_distance);
    const real peak_force_so_far_or_peak_force = select(x->is_open > 0.0, dx->peak_force_so_far,
        dx->peak_force);
    const real vertical_so_far_or_peak_vertical_force = select(x->is_open > 0.0, dx->vertical_so_far,
        dx->peak_vertical_force);
    const real sin_of_slope_over_cos_of_slope = sin_of_slope / cos_of_slope;
    const real d_height_of_section = dx->com_y - dx->height - (dx->com_x * sin_of_slope_over_cos_of_slope
        + x->com_x * ((cos_of_slope * dx->slope
        + sin_of_slope_over_cos_of_slope * (sin_of_slope * dx->slope)) / cos_of_slope));
    const real d_length = dp->free_length + dx->extension;
    const real d_angle = dp->touchdown_angle + dp->more_angle;
    const real square = length * length;
    const real d_square = 2.0 * (length * d_length);
    const real sum_2 = dp->retraction_rate * square + p->retraction_rate * d_square;
    const real retraction_rate_times_square = p->retraction_rate * square;
    const real d_rate = -((sum_2 - retraction_rate_times_square / square * d_square) / square);
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
    y->word_code = word_so_far_or_word_code;
    y->period = d_period_or_period;
    y->distance = d_distance_or_distance;
    y->rise_of_stride = com_y_minus_y_then_or_rise_of_stride;
    y->work_of_stride = d_work_or_work_of_stride;
    y->hip_work = d_hip_or_hip_work;
    y->leg_work_of_stride = d_leg_or_leg_work_of_stride;
    y->positive_work = sum_or_positive_work;
    y->speed = sum_over_period_or_com_vx_or_speed;
    y->cost_of_transport = ratio_or_by_0_or_cost_of_transport;
    y->touchdowns = touchdowns_so_far_or_touchdowns;
    y->stance_time = stance_so_far_or_stance_time;
    y->duty_factor = select_or_duty_factor;
    y->slip_distance = slip_so_far_or_slip_distance;
    y->peak_force = peak_force_so_far_or_peak_force;
    y->peak_vertical_force = vertical_so_far_or_peak_vertical_force;
    y->apex_time = dx->time;
    y->apex_com_height = d_height_of_section;
    y->apex_com_speed = dx->com_vx;
    y->apex_length = d_length;
    y->apex_angle = d_angle;
    y->apex_length_rate = 0.0;
    y->apex_angle_rate = d_rate;
    y->length = d_length;
    y->angle = d_angle;
    y->length_rate = 0.0;
    y->swing = 0.0;
    y->placing = 0.0;
    if (above <= 0.0) {
        const real d_share = (dp->body_mass - share * body_mass_plus_foot_mass_2) / body_mass_plus_foot_mass;
        const real sine = real_sin(angle);
        const real cosine = real_cos(angle);
        const real d_sine = cosine * d_angle;
        const real y_2 = cosine * length;
        const real sine_times_d_angle = sine * d_angle;
        const real d_y = cosine * d_length - sine_times_d_angle * length;
        const real ratio = retraction_rate_times_square / length;
        const real vx = cosine * ratio;
        const real ratio_2 = (sum_2 - ratio * d_length) / length;
        const real d_vx = cosine * ratio_2 - sine_times_d_angle * ratio;
        const real vy = sine * ratio;
        const real d_vy = d_sine * ratio + sine * ratio_2;
        y->seen_x = dx->com_x + (d_share * (sine * length) + share * (d_sine * length + sine * d_length));
        y->seen_y = dx->com_y - (d_share * y_2 + share * d_y);
        y->seen_vx = dx->com_vx - (d_share * vx + share * d_vx);
        y->seen_vy = dx->com_vy - (d_share * vy + share * d_vy);
        y->angle_rate = d_rate;
        return;
    }
    const real d_moment = -sum_2;
    y->momentum = d_moment;
}

/* True if apex is watched. */
static real watches_flight_apex(const real *parameters, const real *states) {
    const reduced_runner_states *x = (const void *)states;
    (void)parameters;
    if (x->swing < 2.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of apex. */
static real vary_guard_flight_apex(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const reduced_runner_states *dx = (const void *)d_states;
    (void)parameters, (void)states, (void)d_parameters;
    return dx->com_vy;
}

/* touchdown: The foot reaches the ground. */
static int react_flight_touchdown(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
    (void)tables;
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
    const real along = com_vx_minus_share_times_vx * cos_of_slope
        + com_vy_minus_share_times_vy * sin_of_slope;
    const real way = select(along >= 0.0, 1.0, -1.0);
    const real way_times_along = way * along;
    const real off = com_vy_minus_share_times_vy * cos_of_slope - com_vx_minus_share_times_vx * sin_of_slope;
    const real friction_times_off = x->friction * off;
    const real way_times_along_plus_friction_times_off = way_times_along + friction_times_off;
    const real touchdowns_so_far_plus_by_1 = x->touchdowns_so_far + 1.0;
    const real length_times_sine = x->length * sine;
    const real y_2 = x->length * cosine;
    const real sum_times_cos_of_slope_plus_product = (x->com_x + share * length_times_sine) * cos_of_slope
        + (x->com_y - share * y_2 - x->height) * sin_of_slope;
    const real sum_2 = y_2 * sin_of_slope - length_times_sine * cos_of_slope;
    const real sum_3 = y_2 * cos_of_slope + length_times_sine * sin_of_slope;
    const real foot_mass_over_body_mass_plus_foot_mass = p->foot_mass / body_mass_plus_foot_mass;
    const real com_vx_plus_product = x->com_vx + foot_mass_over_body_mass_plus_foot_mass * vx;
    const real com_vy_plus_product = x->com_vy + foot_mass_over_body_mass_plus_foot_mass * vy;
    const real sum_4 = com_vx_plus_product * cos_of_slope + com_vy_plus_product * sin_of_slope;
    const real sum_5 = com_vy_plus_product * cos_of_slope - com_vx_plus_product * sin_of_slope;
    const real angle_minus_minus_sumatan2_of_sum = x->angle - real_atan2(-sum_2, sum_3);
    const real along_times_along_plus_off_times_off = along * along + off * off;
    const real by_1_or_by_0 = select(x->angle >= 0.0, 1.0, 0.0);
    y->touchdowns_so_far = touchdowns_so_far_plus_by_1;
    y->slid_from = sum_times_cos_of_slope_plus_product;
    y->bar_is_due = 1.0;
    y->x_ = sum_2;
    y->y_ = sum_3;
    y->vy = sum_5;
    y->foot_x = sum_times_cos_of_slope_plus_product;
    y->winding = angle_minus_minus_sumatan2_of_sum;
    y->driving = by_1_or_by_0;
    y->placing = 0.0;
    y->touchdown_time = x->time;
    if (p->stribeck_velocity > 0.0 && p->static_ratio > 1.0) {
        const real product_2 = (p->static_ratio
            - 1.0) * real_expm1(friction_times_off / p->stribeck_velocity);
        const real gained = -product_2;
        const real stopped_speed = p->stribeck_velocity * real_log1p(gained) - friction_times_off;
        const real left = way_times_along_plus_friction_times_off
            + p->stribeck_velocity * real_log1p(product_2 * real_exp(-(way_times_along_plus_friction_times_off
            / p->stribeck_velocity)));
        const real speed_left = select(left > 0.0, left, 0.0);
        const real speed_after_impact = select(way_times_along <= stopped_speed, 0.0, speed_left);
        const real after_2 = way * speed_after_impact;
        const real sum_minus_after = sum_4 - after_2;
        const real speeds = along_times_along_plus_off_times_off - after_2 * after_2;
        const real sum_6 = x->impact_loss + 0.5 * (p->foot_mass * speeds);
        y->vx = sum_minus_after;
        y->foot_vx = after_2;
        y->impact_loss = sum_6;
        if (way * after_2 > 0.0) {
            y->way = way;
            return next[0]; /* slip */
        }
        return next[1]; /* stick */
    }
    const real way_times_select = way * select(way_times_along <= -(p->static_ratio * friction_times_off),
        0.0, way_times_along_plus_friction_times_off);
    const real sum_minus_way_times_select = sum_4 - way_times_select;
    const real sum_6 = x->impact_loss + 0.5 * (p->foot_mass * (along_times_along_plus_off_times_off
        - way_times_select * way_times_select));
    y->vx = sum_minus_way_times_select;
    y->foot_vx = way_times_select;
    y->impact_loss = sum_6;
    if (way * way_times_select > 0.0) {
        y->way = way;
        return next[0]; /* slip */
    }
    return next[1]; /* stick */
}

/* First variation of touchdown. */
static void vary_react_flight_touchdown(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
    (void)tables, (void)seed;
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
    const real along = com_vx_minus_share_times_vx * cos_of_slope
        + com_vy_minus_share_times_vy * sin_of_slope;
    const real way = select(along >= 0.0, 1.0, -1.0);
    const real way_times_along = way * along;
    const real off = com_vy_minus_share_times_vy * cos_of_slope - com_vx_minus_share_times_vx * sin_of_slope;
    const real friction_times_off = x->friction * off;
    const real way_times_along_plus_friction_times_off = way_times_along + friction_times_off;
    const real body_mass_plus_foot_mass_2 = dp->body_mass + dp->foot_mass;
    const real d_share = (dp->body_mass - share * body_mass_plus_foot_mass_2) / body_mass_plus_foot_mass;
    const real length_times_sine = x->length * sine;
    const real d_sine = cosine * dx->angle;
    const real sum_2 = dx->length * sine + x->length * d_sine;
    const real sin_of_slope_times_slope = sin_of_slope * dx->slope;
    const real y_2 = x->length * cosine;
    const real sine_times_angle = sine * dx->angle;
    const real d_y = dx->length * cosine - x->length * sine_times_angle;
    const real cos_of_slope_times_slope = cos_of_slope * dx->slope;
    const real sum_plus_sum = (dx->com_x + (d_share * length_times_sine + share * sum_2)) * cos_of_slope
        - (x->com_x + share * length_times_sine) * sin_of_slope_times_slope + ((dx->com_y - (d_share * y_2
        + share * d_y) - dx->height) * sin_of_slope + (x->com_y - share * y_2
        - x->height) * cos_of_slope_times_slope);
    const real sum_3 = d_y * sin_of_slope + y_2 * cos_of_slope_times_slope - (sum_2 * cos_of_slope
        - length_times_sine * sin_of_slope_times_slope);
    const real sum_4 = d_y * cos_of_slope - y_2 * sin_of_slope_times_slope + (sum_2 * sin_of_slope
        + length_times_sine * cos_of_slope_times_slope);
    const real foot_mass_over_body_mass_plus_foot_mass = p->foot_mass / body_mass_plus_foot_mass;
    const real ratio = (dp->foot_mass
        - foot_mass_over_body_mass_plus_foot_mass * body_mass_plus_foot_mass_2) / body_mass_plus_foot_mass;
    const real d_turn = (dx->momentum - turn * dx->length) / x->length;
    const real d_vx = -(dx->length_rate * sine + x->length_rate * d_sine) - (d_turn * cosine
        - turn * sine_times_angle);
    const real com_vx_plus_ratio_times_vx_plus_product = dx->com_vx + (ratio * vx
        + foot_mass_over_body_mass_plus_foot_mass * d_vx);
    const real com_vx_plus_product = x->com_vx + foot_mass_over_body_mass_plus_foot_mass * vx;
    const real d_vy = dx->length_rate * cosine - x->length_rate * sine_times_angle - (d_turn * sine
        + turn * d_sine);
    const real com_vy_plus_ratio_times_vy_plus_product = dx->com_vy + (ratio * vy
        + foot_mass_over_body_mass_plus_foot_mass * d_vy);
    const real com_vy_plus_product = x->com_vy + foot_mass_over_body_mass_plus_foot_mass * vy;
    const real sum_5 = com_vx_plus_ratio_times_vx_plus_product * cos_of_slope
        - com_vx_plus_product * sin_of_slope_times_slope
        + (com_vy_plus_ratio_times_vy_plus_product * sin_of_slope
        + com_vy_plus_product * cos_of_slope_times_slope);
    const real sum_6 = dx->com_vx - (d_share * vx + share * d_vx);
    const real sum_7 = dx->com_vy - (d_share * vy + share * d_vy);
    const real d_along = sum_6 * cos_of_slope - com_vx_minus_share_times_vx * sin_of_slope_times_slope
        + (sum_7 * sin_of_slope + com_vy_minus_share_times_vy * cos_of_slope_times_slope);
    const real d_off = sum_7 * cos_of_slope - com_vy_minus_share_times_vy * sin_of_slope_times_slope
        - (sum_6 * sin_of_slope + com_vx_minus_share_times_vx * cos_of_slope_times_slope);
    const real sum_8 = dx->friction * off + x->friction * d_off;
    const real way_times_d_along_plus_sum = way * d_along + sum_8;
    const real sum_9 = com_vy_plus_ratio_times_vy_plus_product * cos_of_slope
        - com_vy_plus_product * sin_of_slope_times_slope
        - (com_vx_plus_ratio_times_vx_plus_product * sin_of_slope
        + com_vx_plus_product * cos_of_slope_times_slope);
    const real sum_10 = y_2 * sin_of_slope - length_times_sine * cos_of_slope;
    const real sum_11 = y_2 * cos_of_slope + length_times_sine * sin_of_slope;
    const real angle_minus_ratio = dx->angle - (sum_10 * sum_4 - sum_11 * sum_3) / (sum_10 * sum_10
        + sum_11 * sum_11);
    const real along_times_along_plus_off_times_off = along * along + off * off;
    const real sum_12 = 2.0 * (along * d_along) + 2.0 * (off * d_off);
    y->touchdowns_so_far = dx->touchdowns_so_far;
    y->slid_from = sum_plus_sum;
    y->bar_is_due = 0.0;
    y->x_ = sum_3;
    y->y_ = sum_4;
    y->vy = sum_9;
    y->foot_x = sum_plus_sum;
    y->winding = angle_minus_ratio;
    y->driving = 0.0;
    y->placing = 0.0;
    y->touchdown_time = dx->time;
    if (p->stribeck_velocity > 0.0 && p->static_ratio > 1.0) {
        const real static_ratio_minus_by_1 = p->static_ratio - 1.0;
        const real ratio_2 = friction_times_off / p->stribeck_velocity;
        const real expm1_of_ratio = real_expm1(ratio_2);
        const real product_2 = static_ratio_minus_by_1 * expm1_of_ratio;
        const real gained = -product_2;
        const real stopped_speed = p->stribeck_velocity * real_log1p(gained) - friction_times_off;
        const real ratio_3 = way_times_along_plus_friction_times_off / p->stribeck_velocity;
        const real exp_of_minus_ratio = real_exp(-ratio_3);
        const real product_times_exp_of_minus_ratio = product_2 * exp_of_minus_ratio;
        const real log1p_2 = real_log1p(product_times_exp_of_minus_ratio);
        const real left = way_times_along_plus_friction_times_off + p->stribeck_velocity * log1p_2;
        const real speed_left = select(left > 0.0, left, 0.0);
        const real speed_after_impact = select(way_times_along <= stopped_speed, 0.0, speed_left);
        const real after_2 = way * speed_after_impact;
        const real d_left = way_times_d_along_plus_sum + (dp->stribeck_velocity * log1p_2
            + p->stribeck_velocity * (((dp->static_ratio * expm1_of_ratio
            + static_ratio_minus_by_1 * ((expm1_of_ratio + 1.0) * ((sum_8
            - ratio_2 * dp->stribeck_velocity) / p->stribeck_velocity))) * exp_of_minus_ratio
            - product_2 * (exp_of_minus_ratio * ((way_times_d_along_plus_sum
            - ratio_3 * dp->stribeck_velocity) / p->stribeck_velocity))) / (1.0
            + product_times_exp_of_minus_ratio)));
        const real d_speed_left = select(left > 0.0, d_left, 0.0);
        const real d_speed_after_impact = select(way_times_along <= stopped_speed, 0.0, d_speed_left);
        const real d_after = way * d_speed_after_impact;
        const real sum_minus_d_after = sum_5 - d_after;
        const real speeds = along_times_along_plus_off_times_off - after_2 * after_2;
        const real d_speeds = sum_12 - 2.0 * (after_2 * d_after);
        const real impact_loss_plus_by_0_5_times_sum = dx->impact_loss + 0.5 * (dp->foot_mass * speeds
            + p->foot_mass * d_speeds);
        y->vx = sum_minus_d_after;
        y->foot_vx = d_after;
        y->impact_loss = impact_loss_plus_by_0_5_times_sum;
        if (way * after_2 > 0.0) {
            y->way = 0.0;
            return;
        }
        return;
    }
    const real negative = -(p->static_ratio * friction_times_off);
    const real way_times_select = way * select(way_times_along <= negative, 0.0,
        way_times_along_plus_friction_times_off);
    const real product_2 = way * select(way_times_along <= negative, 0.0, way_times_d_along_plus_sum);
    const real sum_minus_product = sum_5 - product_2;
    const real impact_loss_plus_by_0_5_times_sum = dx->impact_loss
        + 0.5 * (dp->foot_mass * (along_times_along_plus_off_times_off
        - way_times_select * way_times_select) + p->foot_mass * (sum_12
        - 2.0 * (way_times_select * product_2)));
    y->vx = sum_minus_product;
    y->foot_vx = product_2;
    y->impact_loss = impact_loss_plus_by_0_5_times_sum;
    if (way * way_times_select > 0.0) {
        y->way = 0.0;
        return;
    }
}

/* True if touchdown is watched. */
static real watches_flight_touchdown(const real *parameters, const real *states) {
    const reduced_runner_states *x = (const void *)states;
    (void)parameters;
    if (x->swing > 1.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of touchdown. */
static real vary_guard_flight_touchdown(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
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

/* Outputs in flight. */
static void outputs_flight(const real *parameters, const real *states, real *outputs) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const real pending = select(real_abs(p->ground_height - x->height)
        + real_abs(p->free_length * (p->ground_slope - x->slope)) > 0.0, 1.0, 0.0);
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + select(longer >= 0.0, longer,
        0.0) * x->thrusting;
    const real shorter = rest_length - x->length;
    const real spring = p->stiffness * shorter - p->damping * x->length_rate;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->foot_mass / body_mass_plus_foot_mass;
    const real sin_of_angle = real_sin(x->angle);
    const real body_x = x->com_x - share * (x->length * sin_of_angle);
    const real cos_of_angle = real_cos(x->angle);
    const real y_2 = x->length * cos_of_angle;
    const real body_y = x->com_y + share * y_2;
    const real turn = x->momentum / x->length;
    const real vx = -(x->length_rate * sin_of_angle) - turn * cos_of_angle;
    const real body_vx = x->com_vx + share * vx;
    const real vy = x->length_rate * cos_of_angle - turn * sin_of_angle;
    const real body_vy = x->com_vy + share * vy;
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

/* First variation of outputs_flight. */
static void vary_outputs_flight(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *outputs) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
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
    const real share = p->foot_mass / body_mass_plus_foot_mass;
    const real body_mass_plus_foot_mass_2 = dp->body_mass + dp->foot_mass;
    const real d_share = (dp->foot_mass - share * body_mass_plus_foot_mass_2) / body_mass_plus_foot_mass;
    const real sin_of_angle = real_sin(x->angle);
    const real cos_of_angle = real_cos(x->angle);
    const real cos_of_angle_times_angle = cos_of_angle * dx->angle;
    const real d_body_x = dx->com_x - (d_share * (x->length * sin_of_angle)
        + share * (dx->length * sin_of_angle + x->length * cos_of_angle_times_angle));
    const real y_2 = x->length * cos_of_angle;
    const real sin_of_angle_times_angle = sin_of_angle * dx->angle;
    const real d_y = dx->length * cos_of_angle - x->length * sin_of_angle_times_angle;
    const real d_body_y = dx->com_y + (d_share * y_2 + share * d_y);
    const real turn = x->momentum / x->length;
    const real vx = -(x->length_rate * sin_of_angle) - turn * cos_of_angle;
    const real d_turn = (dx->momentum - turn * dx->length) / x->length;
    const real d_vx = -(dx->length_rate * sin_of_angle + x->length_rate * cos_of_angle_times_angle)
        - (d_turn * cos_of_angle - turn * sin_of_angle_times_angle);
    const real d_body_vx = dx->com_vx + (d_share * vx + share * d_vx);
    const real vy = x->length_rate * cos_of_angle - turn * sin_of_angle;
    const real d_vy = dx->length_rate * cos_of_angle - x->length_rate * sin_of_angle_times_angle
        - (d_turn * sin_of_angle + turn * cos_of_angle_times_angle);
    const real d_body_vy = dx->com_vy + (d_share * vy + share * d_vy);
    const real body_vx = x->com_vx + share * vx;
    const real body_vy = x->com_vy + share * vy;
    const real d_of_body = dp->body_mass * (body_vx * body_vx + body_vy * body_vy)
        + p->body_mass * (2.0 * (body_vx * d_body_vx) + 2.0 * (body_vy * d_body_vy));
    const real body_mass_over_body_mass_plus_foot_mass = p->body_mass / body_mass_plus_foot_mass;
    const real com_vx_minus_product = x->com_vx - body_mass_over_body_mass_plus_foot_mass * vx;
    const real com_vy_minus_product = x->com_vy - body_mass_over_body_mass_plus_foot_mass * vy;
    const real ratio = (dp->body_mass
        - body_mass_over_body_mass_plus_foot_mass * body_mass_plus_foot_mass_2) / body_mass_plus_foot_mass;
    const real d_kinetic_energy = 0.5 * (d_of_body
        + (dp->foot_mass * (com_vx_minus_product * com_vx_minus_product
        + com_vy_minus_product * com_vy_minus_product)
        + p->foot_mass * (2.0 * (com_vx_minus_product * (dx->com_vx - (ratio * vx
        + body_mass_over_body_mass_plus_foot_mass * d_vx))) + 2.0 * (com_vy_minus_product * (dx->com_vy
        - (ratio * vy + body_mass_over_body_mass_plus_foot_mass * d_vy))))));
    const real body_y = x->com_y + share * y_2;
    const real com_y_minus_product = x->com_y - body_mass_over_body_mass_plus_foot_mass * y_2;
    const real d_potential_energy = dp->gravity * (p->body_mass * body_y
        + p->foot_mass * com_y_minus_product) + p->gravity * (dp->body_mass * body_y
        + p->body_mass * d_body_y + (dp->foot_mass * com_y_minus_product + p->foot_mass * (dx->com_y
        - (ratio * y_2 + body_mass_over_body_mass_plus_foot_mass * d_y))));
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
static void from_world_flight(const real *parameters, const real *states, real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
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
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
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
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
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
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
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
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    slip_constant_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + x->thrusting * select(longer >= 0.0, longer,
        0.0);
    const real stance_torque = x->external_torque - x->driving * (p->drive_torque + p->more_torque);
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real sum_2 = x->external_fx * cosine + x->external_fy * sine;
    const real gravity_times_sine = p->gravity * sine;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real foot_mass_times_gravity_times_sine = foot_mass_times_gravity * sine;
    const real way_times_friction = x->way * x->friction;
    const real foot_mass_times_gravity_times_cosine = foot_mass_times_gravity * cosine;
    const real sum_3 = x->external_fy * cosine - x->external_fx * sine;
    const real gravity_times_cosine = p->gravity * cosine;
    const real inverse_stribeck_velocity_or_by_1 = 1.0 / select(p->stribeck_velocity > 0.0,
        p->stribeck_velocity, 1.0);
    c->inverse_body_mass = inverse_body_mass;
    c->stiffness = p->stiffness;
    c->rest_length = rest_length;
    c->damping = p->damping;
    c->stance_torque = stance_torque;
    c->cosine = cosine;
    c->sine = sine;
    c->sum_2 = sum_2;
    c->gravity_times_sine = gravity_times_sine;
    c->inverse_foot_mass = inverse_foot_mass;
    c->foot_mass_times_gravity_times_sine = foot_mass_times_gravity_times_sine;
    c->way = x->way;
    c->way_times_friction = way_times_friction;
    c->foot_mass_times_gravity_times_cosine = foot_mass_times_gravity_times_cosine;
    c->sum_3 = sum_3;
    c->gravity_times_cosine = gravity_times_cosine;
    c->least_length = p->least_length;
    c->winding = x->winding;
    c->inverse_stribeck_velocity_or_by_1 = inverse_stribeck_velocity_or_by_1;
}

/* First variation of open_slip_constant. */
static void vary_open_slip_constant(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    slip_constant_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real d_inverse_body_mass = -(inverse_body_mass * dp->body_mass / p->body_mass);
    const real longer = p->thrust + p->more_thrust;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, longer,
        0.0) * dx->thrusting + x->thrusting * select(longer >= 0.0, d_longer, 0.0));
    const real d_stance_torque = dx->external_torque - ((p->drive_torque + p->more_torque) * dx->driving
        + x->driving * (dp->drive_torque + dp->more_torque));
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_cosine = -sine_times_slope;
    const real cosine = real_cos(x->slope);
    const real d_sine = cosine * dx->slope;
    const real d_sum_2 = cosine * dx->external_fx - x->external_fx * sine_times_slope
        + (sine * dx->external_fy + x->external_fy * d_sine);
    const real d_gravity_times_sine = sine * dp->gravity + p->gravity * d_sine;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real d_inverse_foot_mass = -(inverse_foot_mass * dp->foot_mass / p->foot_mass);
    const real sum_2 = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real d_foot_mass_times_gravity_times_sine = sine * sum_2 + foot_mass_times_gravity * d_sine;
    const real d_way_times_friction = x->friction * dx->way + x->way * dx->friction;
    const real d_foot_mass_times_gravity_times_cosine = cosine * sum_2
        - foot_mass_times_gravity * sine_times_slope;
    const real d_sum_3 = cosine * dx->external_fy - x->external_fy * sine_times_slope
        - (sine * dx->external_fx + x->external_fx * d_sine);
    const real d_gravity_times_cosine = cosine * dp->gravity - p->gravity * sine_times_slope;
    const real stribeck_velocity_or_by_1 = select(p->stribeck_velocity > 0.0, p->stribeck_velocity, 1.0);
    const real inverse_stribeck_velocity_or_by_1 = 1.0 / stribeck_velocity_or_by_1;
    const real d_inverse_stribeck_velocity_or_by_1 = -(inverse_stribeck_velocity_or_by_1 *
        select(p->stribeck_velocity > 0.0, dp->stribeck_velocity, 0.0) / stribeck_velocity_or_by_1);
    c->inverse_body_mass = d_inverse_body_mass;
    c->stiffness = dp->stiffness;
    c->rest_length = d_rest_length;
    c->damping = dp->damping;
    c->stance_torque = d_stance_torque;
    c->cosine = d_cosine;
    c->sine = d_sine;
    c->sum_2 = d_sum_2;
    c->gravity_times_sine = d_gravity_times_sine;
    c->inverse_foot_mass = d_inverse_foot_mass;
    c->foot_mass_times_gravity_times_sine = d_foot_mass_times_gravity_times_sine;
    c->way = dx->way;
    c->way_times_friction = d_way_times_friction;
    c->foot_mass_times_gravity_times_cosine = d_foot_mass_times_gravity_times_cosine;
    c->sum_3 = d_sum_3;
    c->gravity_times_cosine = d_gravity_times_cosine;
    c->least_length = dp->least_length;
    c->winding = dx->winding;
    c->inverse_stribeck_velocity_or_by_1 = d_inverse_stribeck_velocity_or_by_1;
}

/* falls: The body reaches the ground. */
static int react_slip_constant_falls(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
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
    return next[0]; /* fallen */
}

/* First variation of falls. */
static void vary_react_slip_constant_falls(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
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
}

/* First variation of the guard of falls. */
static real vary_guard_slip_constant_falls(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const reduced_runner_states *dx = (const void *)d_states;
    (void)parameters, (void)states, (void)d_parameters;
    return dx->y_;
}

/* First variation of the guard of collapses. */
static real vary_guard_slip_constant_collapses(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    (void)parameters;
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real d_length = 0.5 * d_square / length;
    return d_length - dp->least_length;
}

/* greatest_compression: Thrust begins where the leg is shortest, once per stance. */
static int react_slip_constant_greatest_compression(const real *parameters, const real *states,
    const tdmf_table *tables, real *after, const int *next) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
    (void)tables;
    const real is_new = select(x->time > x->last_event, 1.0, 0.0);
    const real free_length_plus_extension = p->free_length + x->extension;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = free_length_plus_extension + longer_or_by_0;
    const real sum_2 = free_length_plus_extension + longer_or_by_0 * x->thrusting;
    const real jump = rest_length - sum_2;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real middle = sum_2 + 0.5 * jump - length;
    const real work = p->stiffness * jump * middle;
    y->events = x->events + is_new;
    y->last_event = x->time;
    y->thrusting = 1.0;
    y->leg_work = x->leg_work + work;
    return next[0]; /* slip */
}

/* First variation of greatest_compression. */
static void vary_react_slip_constant_greatest_compression(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real free_length_plus_extension = p->free_length + x->extension;
    const real longer = p->thrust + p->more_thrust;
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
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real d_length = 0.5 * d_square / length;
    const real d_middle = free_length_plus_extension_plus_sum + 0.5 * d_jump - d_length;
    const real d_work = (dp->stiffness * jump + p->stiffness * d_jump) * middle
        + p->stiffness * jump * d_middle;
    y->events = dx->events;
    y->last_event = dx->time;
    y->thrusting = 0.0;
    y->leg_work = dx->leg_work + d_work;
}

/* True if greatest_compression is watched. */
static real watches_slip_constant_greatest_compression(const real *parameters, const real *states) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    if (x->thrusting <= 0.0 && p->thrust + p->more_thrust > 0.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of greatest_compression. */
static real vary_guard_slip_constant_greatest_compression(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_states *dx = (const void *)d_states;
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
    reduced_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->driving = 0.0;
    return next[0]; /* slip */
}

/* First variation of mid_stance. */
static void vary_react_slip_constant_mid_stance(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    reduced_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed;
    y->driving = 0.0;
}

/* True if mid_stance is watched. */
static real watches_slip_constant_mid_stance(const real *parameters, const real *states) {
    const reduced_runner_states *x = (const void *)states;
    (void)parameters;
    if (x->driving > 0.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of mid_stance. */
static real vary_guard_slip_constant_mid_stance(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_states *dx = (const void *)d_states;
    (void)parameters, (void)d_parameters;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
    return d_angle;
}

/* lift_off: The centre of mass flies to the next apex. */
static int react_slip_constant_lift_off(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
    (void)tables;
    const real sine = real_sin(x->slope);
    const real cosine = real_cos(x->slope);
    const real x_2 = x->foot_x * cosine;
    const real y_2 = x->foot_x * sine;
    const real height_plus_y = x->height + y_2;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real vx = x->foot_vx * cosine;
    const real vy = x->foot_vx * sine;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    y->length = length;
    y->angle = angle;
    y->length_rate = length_rate;
    if (x->time <= x->touchdown_time) {
        y->seen_x = x_2;
        y->seen_y = height_plus_y;
        y->seen_vx = vx;
        y->seen_vy = vy;
        y->angle_rate = angle_rate;
        return next[0]; /* no_stance */
    }
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real along = x->foot_vx + share * x->vx;
    const real rise = sine * along + cosine * (share * x->vy);
    if (rise <= 0.0 || x->external_fy >= body_mass_plus_foot_mass * p->gravity) {
        y->seen_x = x_2;
        y->seen_y = height_plus_y;
        y->seen_vx = vx;
        y->seen_vy = vy;
        y->angle_rate = angle_rate;
        return next[1]; /* no_apex */
    }
    const real rest_length = p->free_length + x->extension;
    const real longer = p->thrust + p->more_thrust;
    const real sum_2 = rest_length + select(longer >= 0.0, longer, 0.0) * x->thrusting;
    const real jump = rest_length - sum_2;
    const real middle = sum_2 + 0.5 * jump - length;
    const real work = p->stiffness * jump * middle;
    y->com_x = x_2 + share * (x->x_ * cosine - x->y_ * sine);
    y->com_y = height_plus_y + share * (x->x_ * sine + x->y_ * cosine);
    y->com_vx = vx + share * (x->vx * cosine - x->vy * sine);
    y->com_vy = vy + share * (x->vx * sine + x->vy * cosine);
    y->momentum = moment;
    y->thrusting = 0.0;
    y->leg_work = x->leg_work + work;
    y->liftoff_angle = angle;
    y->swing = 1.0;
    y->placing = 0.0;
    return next[2]; /* flight */
}

/* First variation of lift_off. */
static void vary_react_slip_constant_lift_off(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real sine = real_sin(x->slope);
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real along = x->foot_vx + share * x->vx;
    const real cosine = real_cos(x->slope);
    const real rise = sine * along + cosine * (share * x->vy);
    const real sine_times_slope = sine * dx->slope;
    const real d_x = dx->foot_x * cosine - x->foot_x * sine_times_slope;
    const real d_sine = cosine * dx->slope;
    const real d_y = dx->foot_x * sine + x->foot_x * d_sine;
    const real height_plus_d_y = dx->height + d_y;
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
    y->length = d_length;
    y->angle = d_angle;
    y->length_rate = d_length_rate;
    if (x->time <= x->touchdown_time || rise <= 0.0 || x->external_fy >= body_mass_plus_foot_mass *
        p->gravity) {
        const real moment = x->x_ * x->vy - x->y_ * x->vx;
        const real angle_rate = moment / square;
        const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
        y->seen_x = d_x;
        y->seen_y = height_plus_d_y;
        y->seen_vx = d_vx;
        y->seen_vy = d_vy;
        y->angle_rate = d_angle_rate;
        return;
    }
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
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
    const real d_middle = d_rest_length_plus_sum + 0.5 * d_jump - d_length;
    const real d_work = (dp->stiffness * jump + p->stiffness * d_jump) * middle
        + p->stiffness * jump * d_middle;
    y->com_x = d_x + (d_share * (x->x_ * cosine - x->y_ * sine) + share * (dx->x_ * cosine
        - x->x_ * sine_times_slope - (dx->y_ * sine + x->y_ * d_sine)));
    y->com_y = height_plus_d_y + (d_share * (x->x_ * sine + x->y_ * cosine) + share * (dx->x_ * sine
        + x->x_ * d_sine + (dx->y_ * cosine - x->y_ * sine_times_slope)));
    y->com_vx = d_vx + (d_share * (x->vx * cosine - x->vy * sine) + share * (dx->vx * cosine
        - x->vx * sine_times_slope - (dx->vy * sine + x->vy * d_sine)));
    y->com_vy = d_vy + (d_share * (x->vx * sine + x->vy * cosine) + share * (dx->vx * sine + x->vx * d_sine
        + (dx->vy * cosine - x->vy * sine_times_slope)));
    y->momentum = d_moment;
    y->thrusting = 0.0;
    y->leg_work = dx->leg_work + d_work;
    y->liftoff_angle = d_angle;
    y->swing = 0.0;
    y->placing = 0.0;
}

/* First variation of the guard of lift_off. */
static real vary_guard_slip_constant_lift_off(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
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
    const reduced_runner_parameters *p = (const void *)parameters;
    (void)states;
    if (p->stribeck_velocity > 0.0 && p->static_ratio > 1.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of enters_layer. */
static real vary_guard_slip_constant_enters_layer(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
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
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
    (void)tables;
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
    const real off = axial * x->y_ + turning * x->x_;
    const real cosine = real_cos(x->slope);
    const real normal = off + foot_mass_times_gravity * cosine;
    const real cone = p->static_ratio * x->friction * normal;
    y->vx = vx_plus_foot_vx;
    y->foot_vx = 0.0;
    if (real_abs(sum_2) <= cone) {
        return next[0]; /* stick */
    }
    const real way = select(sum_2 > 0.0, -1.0, 1.0);
    y->way = way;
    return next[1]; /* slip */
}

/* First variation of comes_to_rest. */
static void vary_react_slip_constant_comes_to_rest(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
    (void)d_parameters, (void)tables, (void)seed;
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
    const real off = axial * x->y_ + turning * x->x_;
    const real cosine = real_cos(x->slope);
    const real normal = off + foot_mass_times_gravity * cosine;
    const real cone = p->static_ratio * x->friction * normal;
    const real vx_plus_foot_vx = dx->vx + dx->foot_vx;
    y->vx = vx_plus_foot_vx;
    y->foot_vx = 0.0;
    if (real_abs(along + foot_mass_times_gravity * sine) <= cone) {
        return;
    }
    y->way = 0.0;
}

/* First variation of the guard of comes_to_rest. */
static real vary_guard_slip_constant_comes_to_rest(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_states *dx = (const void *)d_states;
    (void)parameters, (void)d_parameters;
    return dx->way * x->foot_vx + x->way * dx->foot_vx;
}

/* Outputs in slip_constant. */
static void outputs_slip_constant(const real *parameters, const real *states, real *outputs) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const real pending = select(real_abs(p->ground_height - x->height)
        + real_abs(p->free_length * (p->ground_slope - x->slope)) > 0.0, 1.0, 0.0);
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
    const real way_times_friction_times_normal = x->way * x->friction * normal;
    const real tangential_force = -way_times_friction_times_normal;
    const real sine = real_sin(x->slope);
    const real x_2 = -(way_times_friction_times_normal * cosine) - normal * sine;
    const real y_2 = normal * cosine - way_times_friction_times_normal * sine;
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
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
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
    const real off = axial * x->y_ + turning * x->x_;
    const real normal = off + foot_mass_times_gravity * cosine;
    const real way_times_friction = x->way * x->friction;
    const real sum_2 = (dx->way * x->friction + x->way * dx->friction) * normal
        + way_times_friction * d_normal;
    const real d_tangential_force = -sum_2;
    const real way_times_friction_times_normal = way_times_friction * normal;
    const real d_sine = cosine * dx->slope;
    const real d_x = -(sum_2 * cosine - way_times_friction_times_normal * sine_times_slope)
        - (d_normal * sine + normal * d_sine);
    const real d_y = d_normal * cosine - normal * sine_times_slope - (sum_2 * sine
        + way_times_friction_times_normal * d_sine);
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
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
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
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
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
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
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
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
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
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
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
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
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

/* Constants of stick. */
static void open_stick(const real *parameters, const real *states, real *constants) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    stick_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + x->thrusting * select(longer >= 0.0, longer,
        0.0);
    const real stance_torque = x->external_torque - x->driving * (p->drive_torque + p->more_torque);
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real sum_2 = x->external_fx * cosine + x->external_fy * sine;
    const real gravity_times_sine = p->gravity * sine;
    const real sum_3 = x->external_fy * cosine - x->external_fx * sine;
    const real gravity_times_cosine = p->gravity * cosine;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real foot_mass_times_gravity_times_cosine = foot_mass_times_gravity * cosine;
    const real static_ratio_times_friction = p->static_ratio * x->friction;
    const real foot_mass_times_gravity_times_sine = foot_mass_times_gravity * sine;
    c->inverse_body_mass = inverse_body_mass;
    c->stiffness = p->stiffness;
    c->rest_length = rest_length;
    c->damping = p->damping;
    c->stance_torque = stance_torque;
    c->cosine = cosine;
    c->sine = sine;
    c->sum_2 = sum_2;
    c->gravity_times_sine = gravity_times_sine;
    c->sum_3 = sum_3;
    c->gravity_times_cosine = gravity_times_cosine;
    c->foot_vx = x->foot_vx;
    c->least_length = p->least_length;
    c->winding = x->winding;
    c->foot_mass_times_gravity_times_cosine = foot_mass_times_gravity_times_cosine;
    c->static_ratio_times_friction = static_ratio_times_friction;
    c->foot_mass_times_gravity_times_sine = foot_mass_times_gravity_times_sine;
}

/* First variation of open_stick. */
static void vary_open_stick(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    stick_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real d_inverse_body_mass = -(inverse_body_mass * dp->body_mass / p->body_mass);
    const real longer = p->thrust + p->more_thrust;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, longer,
        0.0) * dx->thrusting + x->thrusting * select(longer >= 0.0, d_longer, 0.0));
    const real d_stance_torque = dx->external_torque - ((p->drive_torque + p->more_torque) * dx->driving
        + x->driving * (dp->drive_torque + dp->more_torque));
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_cosine = -sine_times_slope;
    const real cosine = real_cos(x->slope);
    const real d_sine = cosine * dx->slope;
    const real d_sum_2 = cosine * dx->external_fx - x->external_fx * sine_times_slope
        + (sine * dx->external_fy + x->external_fy * d_sine);
    const real d_gravity_times_sine = sine * dp->gravity + p->gravity * d_sine;
    const real d_sum_3 = cosine * dx->external_fy - x->external_fy * sine_times_slope
        - (sine * dx->external_fx + x->external_fx * d_sine);
    const real d_gravity_times_cosine = cosine * dp->gravity - p->gravity * sine_times_slope;
    const real sum_2 = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real d_foot_mass_times_gravity_times_cosine = cosine * sum_2
        - foot_mass_times_gravity * sine_times_slope;
    const real d_static_ratio_times_friction = x->friction * dp->static_ratio
        + p->static_ratio * dx->friction;
    const real d_foot_mass_times_gravity_times_sine = sine * sum_2 + foot_mass_times_gravity * d_sine;
    c->inverse_body_mass = d_inverse_body_mass;
    c->stiffness = dp->stiffness;
    c->rest_length = d_rest_length;
    c->damping = dp->damping;
    c->stance_torque = d_stance_torque;
    c->cosine = d_cosine;
    c->sine = d_sine;
    c->sum_2 = d_sum_2;
    c->gravity_times_sine = d_gravity_times_sine;
    c->sum_3 = d_sum_3;
    c->gravity_times_cosine = d_gravity_times_cosine;
    c->foot_vx = dx->foot_vx;
    c->least_length = dp->least_length;
    c->winding = dx->winding;
    c->foot_mass_times_gravity_times_cosine = d_foot_mass_times_gravity_times_cosine;
    c->static_ratio_times_friction = d_static_ratio_times_friction;
    c->foot_mass_times_gravity_times_sine = d_foot_mass_times_gravity_times_sine;
}

/* greatest_compression: Thrust begins where the leg is shortest, once per stance. */
static int react_stick_greatest_compression(const real *parameters, const real *states,
    const tdmf_table *tables, real *after, const int *next) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
    (void)tables;
    const real is_new = select(x->time > x->last_event, 1.0, 0.0);
    const real free_length_plus_extension = p->free_length + x->extension;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0 = select(longer >= 0.0, longer, 0.0);
    const real rest_length = free_length_plus_extension + longer_or_by_0;
    const real sum_2 = free_length_plus_extension + longer_or_by_0 * x->thrusting;
    const real jump = rest_length - sum_2;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real middle = sum_2 + 0.5 * jump - length;
    const real work = p->stiffness * jump * middle;
    y->events = x->events + is_new;
    y->last_event = x->time;
    y->thrusting = 1.0;
    y->leg_work = x->leg_work + work;
    return next[0]; /* stick */
}

/* mid_stance: Drive ends where the leg is upright, once per stance. */
static int react_stick_mid_stance(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    reduced_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->driving = 0.0;
    return next[0]; /* stick */
}

/* slips_forward: The push of the leg exceeds static friction, and the foot slips forward. */
static int react_stick_slips_forward(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    reduced_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->way = 1.0;
    return next[0]; /* slip */
}

/* First variation of slips_forward. */
static void vary_react_stick_slips_forward(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    reduced_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed;
    y->way = 0.0;
}

/* First variation of the guard of slips_forward. */
static real vary_guard_stick_slips_forward(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
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
    const real d_cone = (dp->static_ratio * x->friction + p->static_ratio * dx->friction) * normal
        + p->static_ratio * x->friction * d_normal;
    const real d_along = d_axial * x->x_ + axial * dx->x_ - (d_turning * x->y_ + turning * dx->y_);
    const real d_sine = cosine * dx->slope;
    return d_cone + (d_along + (sum_2 * sine + foot_mass_times_gravity * d_sine));
}

/* slips_backward: The push of the leg exceeds static friction, and the foot slips backward. */
static int react_stick_slips_backward(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    reduced_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->way = -1.0;
    return next[0]; /* slip */
}

/* First variation of the guard of slips_backward. */
static real vary_guard_stick_slips_backward(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
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
    const real d_cone = (dp->static_ratio * x->friction + p->static_ratio * dx->friction) * normal
        + p->static_ratio * x->friction * d_normal;
    const real d_along = d_axial * x->x_ + axial * dx->x_ - (d_turning * x->y_ + turning * dx->y_);
    const real d_sine = cosine * dx->slope;
    return d_cone - (d_along + (sum_2 * sine + foot_mass_times_gravity * d_sine));
}

/* Outputs in stick. */
static void outputs_stick(const real *parameters, const real *states, real *outputs) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const real pending = select(real_abs(p->ground_height - x->height)
        + real_abs(p->free_length * (p->ground_slope - x->slope)) > 0.0, 1.0, 0.0);
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
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
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
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
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
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
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

/* Constants of slip_falling. */
static void open_slip_falling(const real *parameters, const real *states, real *constants) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    slip_falling_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real longer = p->thrust + p->more_thrust;
    const real rest_length = p->free_length + x->extension + x->thrusting * select(longer >= 0.0, longer,
        0.0);
    const real stance_torque = x->external_torque - x->driving * (p->drive_torque + p->more_torque);
    const real cosine = real_cos(x->slope);
    const real sine = real_sin(x->slope);
    const real sum_2 = x->external_fx * cosine + x->external_fy * sine;
    const real gravity_times_sine = p->gravity * sine;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real foot_mass_times_gravity_times_sine = foot_mass_times_gravity * sine;
    const real static_ratio_minus_by_1 = p->static_ratio - 1.0;
    const real inverse_stribeck_velocity = 1.0 / p->stribeck_velocity;
    const real foot_mass_times_gravity_times_cosine = foot_mass_times_gravity * cosine;
    const real sum_3 = x->external_fy * cosine - x->external_fx * sine;
    const real gravity_times_cosine = p->gravity * cosine;
    const real inverse_stribeck_velocity_or_by_1 = 1.0 / select(p->stribeck_velocity > 0.0,
        p->stribeck_velocity, 1.0);
    c->inverse_body_mass = inverse_body_mass;
    c->stiffness = p->stiffness;
    c->rest_length = rest_length;
    c->damping = p->damping;
    c->stance_torque = stance_torque;
    c->cosine = cosine;
    c->sine = sine;
    c->sum_2 = sum_2;
    c->gravity_times_sine = gravity_times_sine;
    c->inverse_foot_mass = inverse_foot_mass;
    c->foot_mass_times_gravity_times_sine = foot_mass_times_gravity_times_sine;
    c->way = x->way;
    c->friction = x->friction;
    c->static_ratio_minus_by_1 = static_ratio_minus_by_1;
    c->inverse_stribeck_velocity = inverse_stribeck_velocity;
    c->foot_mass_times_gravity_times_cosine = foot_mass_times_gravity_times_cosine;
    c->sum_3 = sum_3;
    c->gravity_times_cosine = gravity_times_cosine;
    c->least_length = p->least_length;
    c->winding = x->winding;
    c->inverse_stribeck_velocity_or_by_1 = inverse_stribeck_velocity_or_by_1;
}

/* First variation of open_slip_falling. */
static void vary_open_slip_falling(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    slip_falling_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real d_inverse_body_mass = -(inverse_body_mass * dp->body_mass / p->body_mass);
    const real longer = p->thrust + p->more_thrust;
    const real d_longer = dp->thrust + dp->more_thrust;
    const real d_rest_length = dp->free_length + dx->extension + (select(longer >= 0.0, longer,
        0.0) * dx->thrusting + x->thrusting * select(longer >= 0.0, d_longer, 0.0));
    const real d_stance_torque = dx->external_torque - ((p->drive_torque + p->more_torque) * dx->driving
        + x->driving * (dp->drive_torque + dp->more_torque));
    const real sine = real_sin(x->slope);
    const real sine_times_slope = sine * dx->slope;
    const real d_cosine = -sine_times_slope;
    const real cosine = real_cos(x->slope);
    const real d_sine = cosine * dx->slope;
    const real d_sum_2 = cosine * dx->external_fx - x->external_fx * sine_times_slope
        + (sine * dx->external_fy + x->external_fy * d_sine);
    const real d_gravity_times_sine = sine * dp->gravity + p->gravity * d_sine;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real d_inverse_foot_mass = -(inverse_foot_mass * dp->foot_mass / p->foot_mass);
    const real sum_2 = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real d_foot_mass_times_gravity_times_sine = sine * sum_2 + foot_mass_times_gravity * d_sine;
    const real inverse_stribeck_velocity = 1.0 / p->stribeck_velocity;
    const real d_inverse_stribeck_velocity = -(inverse_stribeck_velocity * dp->stribeck_velocity /
        p->stribeck_velocity);
    const real d_foot_mass_times_gravity_times_cosine = cosine * sum_2
        - foot_mass_times_gravity * sine_times_slope;
    const real d_sum_3 = cosine * dx->external_fy - x->external_fy * sine_times_slope
        - (sine * dx->external_fx + x->external_fx * d_sine);
    const real d_gravity_times_cosine = cosine * dp->gravity - p->gravity * sine_times_slope;
    const real stribeck_velocity_or_by_1 = select(p->stribeck_velocity > 0.0, p->stribeck_velocity, 1.0);
    const real inverse_stribeck_velocity_or_by_1 = 1.0 / stribeck_velocity_or_by_1;
    const real d_inverse_stribeck_velocity_or_by_1 = -(inverse_stribeck_velocity_or_by_1 *
        select(p->stribeck_velocity > 0.0, dp->stribeck_velocity, 0.0) / stribeck_velocity_or_by_1);
    c->inverse_body_mass = d_inverse_body_mass;
    c->stiffness = dp->stiffness;
    c->rest_length = d_rest_length;
    c->damping = dp->damping;
    c->stance_torque = d_stance_torque;
    c->cosine = d_cosine;
    c->sine = d_sine;
    c->sum_2 = d_sum_2;
    c->gravity_times_sine = d_gravity_times_sine;
    c->inverse_foot_mass = d_inverse_foot_mass;
    c->foot_mass_times_gravity_times_sine = d_foot_mass_times_gravity_times_sine;
    c->way = dx->way;
    c->friction = dx->friction;
    c->static_ratio_minus_by_1 = dp->static_ratio;
    c->inverse_stribeck_velocity = d_inverse_stribeck_velocity;
    c->foot_mass_times_gravity_times_cosine = d_foot_mass_times_gravity_times_cosine;
    c->sum_3 = d_sum_3;
    c->gravity_times_cosine = d_gravity_times_cosine;
    c->least_length = dp->least_length;
    c->winding = dx->winding;
    c->inverse_stribeck_velocity_or_by_1 = d_inverse_stribeck_velocity_or_by_1;
}

/* First variation of the guard of leaves_layer. */
static real vary_guard_slip_falling_leaves_layer(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    const real stribeck_velocity_or_by_1 = select(p->stribeck_velocity > 0.0, p->stribeck_velocity, 1.0);
    const real speed_in_layer = x->way * x->foot_vx / stribeck_velocity_or_by_1;
    const real d_speed_in_layer = (dx->way * x->foot_vx + x->way * dx->foot_vx
        - speed_in_layer * select(p->stribeck_velocity > 0.0, dp->stribeck_velocity,
        0.0)) / stribeck_velocity_or_by_1;
    return -d_speed_in_layer;
}

/* Outputs in slip_falling. */
static void outputs_slip_falling(const real *parameters, const real *states, real *outputs) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const real pending = select(real_abs(p->ground_height - x->height)
        + real_abs(p->free_length * (p->ground_slope - x->slope)) > 0.0, 1.0, 0.0);
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
    const real fading = real_exp(-(x->way * x->foot_vx / p->stribeck_velocity));
    const real slip_friction = x->friction * (1.0 + (p->static_ratio - 1.0) * fading);
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
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
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
    const real static_ratio_minus_by_1 = p->static_ratio - 1.0;
    const real ratio = x->way * x->foot_vx / p->stribeck_velocity;
    const real fading = real_exp(-ratio);
    const real sum_2 = 1.0 + static_ratio_minus_by_1 * fading;
    const real slip_friction = x->friction * sum_2;
    const real d_slip_friction = dx->friction * sum_2 + x->friction * (dp->static_ratio * fading
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
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const real static_ratio_minus_by_1 = p->static_ratio - 1.0;
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
    const real growth = static_ratio_minus_by_1 * x->friction * normal / p->stribeck_velocity;
    const real by_growth = p->foot_mass / real_abs(growth);
    const real along = axial * x->x_ - turning * x->y_;
    const real sine = real_sin(x->slope);
    const real fading = real_exp(-(x->way * x->foot_vx / p->stribeck_velocity));
    const real slip_friction = x->friction * (1.0 + static_ratio_minus_by_1 * fading);
    const real force = along + foot_mass_times_gravity * sine + x->way * slip_friction * normal;
    const real by_speed = p->stribeck_velocity * p->foot_mass / real_abs(force);
    const real time_scale_of_slip = select(by_growth < by_speed, by_growth, by_speed);
    return time_scale_of_slip;
}

/* extension is set: Work that a jump of the rest length does on the spring. */
static void set_extension_start_of_run(const real *parameters, const real *states, real given, real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0_times_thrusting = select(longer >= 0.0, longer, 0.0) * x->thrusting;
    const real rest_length = p->free_length + given + longer_or_by_0_times_thrusting;
    const real sum_2 = p->free_length + x->extension + longer_or_by_0_times_thrusting;
    const real jump = rest_length - sum_2;
    const real middle = sum_2 + 0.5 * jump - x->length;
    const real work = p->stiffness * jump * middle;
    y->leg_work = x->leg_work + work;
}

/* extension is set: Work that a jump of the rest length does on the spring. */
static void set_extension_slip_constant(const real *parameters, const real *states, real given, real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
    const real longer = p->thrust + p->more_thrust;
    const real longer_or_by_0_times_thrusting = select(longer >= 0.0, longer, 0.0) * x->thrusting;
    const real rest_length = p->free_length + given + longer_or_by_0_times_thrusting;
    const real sum_2 = p->free_length + x->extension + longer_or_by_0_times_thrusting;
    const real jump = rest_length - sum_2;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real middle = sum_2 + 0.5 * jump - length;
    const real work = p->stiffness * jump * middle;
    y->leg_work = x->leg_work + work;
}

/* thrust is set: Work that a jump of the rest length does on the spring. */
static void set_thrust_start_of_run(const real *parameters, const real *states, real given, real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
    const real free_length_plus_extension = p->free_length + x->extension;
    const real longer = given + p->more_thrust;
    const real rest_length = free_length_plus_extension + select(longer >= 0.0, longer, 0.0) * x->thrusting;
    const real thrust_plus_more_thrust = p->thrust + p->more_thrust;
    const real free_length_plus_extension_plus_product = free_length_plus_extension
        + select(thrust_plus_more_thrust >= 0.0, thrust_plus_more_thrust, 0.0) * x->thrusting;
    const real jump = rest_length - free_length_plus_extension_plus_product;
    const real middle = free_length_plus_extension_plus_product + 0.5 * jump - x->length;
    const real work = p->stiffness * jump * middle;
    y->leg_work = x->leg_work + work;
}

/* thrust is set: Work that a jump of the rest length does on the spring. */
static void set_thrust_slip_constant(const real *parameters, const real *states, real given, real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
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
    y->leg_work = x->leg_work + work;
}

/* more_thrust is set: Work that a jump of the rest length does on the spring. */
static void set_more_thrust_start_of_run(const real *parameters, const real *states, real given,
    real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
    const real free_length_plus_extension = p->free_length + x->extension;
    const real longer = p->thrust + given;
    const real rest_length = free_length_plus_extension + select(longer >= 0.0, longer, 0.0) * x->thrusting;
    const real thrust_plus_more_thrust = p->thrust + p->more_thrust;
    const real free_length_plus_extension_plus_product = free_length_plus_extension
        + select(thrust_plus_more_thrust >= 0.0, thrust_plus_more_thrust, 0.0) * x->thrusting;
    const real jump = rest_length - free_length_plus_extension_plus_product;
    const real middle = free_length_plus_extension_plus_product + 0.5 * jump - x->length;
    const real work = p->stiffness * jump * middle;
    y->leg_work = x->leg_work + work;
}

/* more_thrust is set: Work that a jump of the rest length does on the spring. */
static void set_more_thrust_slip_constant(const real *parameters, const real *states, real given,
    real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
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
    y->leg_work = x->leg_work + work;
}

/* at_apex: A start at an apex, with the centre of mass at x = 0 and the leg at rest. */
static void enter_at_apex(const real *parameters, const real *states, const real *at, real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    reduced_runner_states *y = (void *)after;
    const real at_apex_com_height = at[0];
    const real at_apex_com_speed = at[1];
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real touchdown_angle_plus_more_angle = p->touchdown_angle + p->more_angle;
    const real sine = real_sin(touchdown_angle_plus_more_angle);
    const real free_length_plus_extension = p->free_length + x->extension;
    const real ratio_times_product = real_sin(p->ground_slope) / real_cos(p->ground_slope) * (share * (sine *
        free_length_plus_extension));
    const real ground = p->ground_height - ratio_times_product;
    const real cosine = real_cos(touchdown_angle_plus_more_angle);
    const real y_2 = cosine * free_length_plus_extension;
    y->seen_x = share * (sine * free_length_plus_extension);
    y->seen_y = ground + at_apex_com_height - share * y_2 + ratio_times_product;
    y->length = free_length_plus_extension;
    y->angle = touchdown_angle_plus_more_angle;
    y->seen_vx = at_apex_com_speed;
    y->seen_vy = 0.0;
    y->length_rate = 0.0;
    y->angle_rate = 0.0;
}

/* First variation of enter_at_apex. */
static void vary_enter_at_apex(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const real *at, const real *d_at, real *after) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const reduced_runner_states *x = (const void *)states;
    const reduced_runner_parameters *dp = (const void *)d_parameters;
    const reduced_runner_states *dx = (const void *)d_states;
    reduced_runner_states *y = (void *)after;
    (void)at;
    const real d_at_apex_com_height = d_at[0];
    const real d_at_apex_com_speed = d_at[1];
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real touchdown_angle_plus_more_angle = p->touchdown_angle + p->more_angle;
    const real sine = real_sin(touchdown_angle_plus_more_angle);
    const real free_length_plus_extension = p->free_length + x->extension;
    const real sine_times_free_length_plus_extension = sine * free_length_plus_extension;
    const real cosine = real_cos(touchdown_angle_plus_more_angle);
    const real touchdown_angle_plus_more_angle_2 = dp->touchdown_angle + dp->more_angle;
    const real d_sine = cosine * touchdown_angle_plus_more_angle_2;
    const real free_length_plus_extension_2 = dp->free_length + dx->extension;
    const real cos_of_ground_slope = real_cos(p->ground_slope);
    const real sin_of_ground_slope = real_sin(p->ground_slope);
    const real ratio = sin_of_ground_slope / cos_of_ground_slope;
    const real product_plus_product = (cos_of_ground_slope * dp->ground_slope
        + ratio * (sin_of_ground_slope * dp->ground_slope)) / cos_of_ground_slope * (share *
        sine_times_free_length_plus_extension) + ratio * (d_share * sine_times_free_length_plus_extension
        + share * (d_sine * free_length_plus_extension + sine * free_length_plus_extension_2));
    const real d_ground = dp->ground_height - product_plus_product;
    const real y_2 = cosine * free_length_plus_extension;
    const real d_y = cosine * free_length_plus_extension_2
        - sine * touchdown_angle_plus_more_angle_2 * free_length_plus_extension;
    y->seen_x = d_share * sine_times_free_length_plus_extension
        + share * (d_sine * free_length_plus_extension + sine * free_length_plus_extension_2);
    y->seen_y = d_ground + d_at_apex_com_height - (d_share * y_2 + share * d_y) + product_plus_product;
    y->length = free_length_plus_extension_2;
    y->angle = touchdown_angle_plus_more_angle_2;
    y->seen_vx = d_at_apex_com_speed;
    y->seen_vy = 0.0;
    y->length_rate = 0.0;
    y->angle_rate = 0.0;
}

/* Typical size of each state and guard. */
static void scales(const real *parameters, real *of_states, real *of_events) {
    const reduced_runner_parameters *p = (const void *)parameters;
    const real sqrt_of_stiffness_over_body_mass = real_sqrt(p->stiffness / p->body_mass);
    of_states[0] = real_sqrt(p->body_mass / p->stiffness);
    of_states[1] = 1.0;
    of_states[2] = real_sqrt(p->body_mass / p->stiffness);
    of_states[3] = 1.0;
    of_states[4] = p->stiffness * p->free_length * p->free_length;
    of_states[5] = p->stiffness * p->free_length * p->free_length;
    of_states[6] = p->stiffness * p->free_length * p->free_length;
    of_states[7] = p->stiffness * p->free_length * p->free_length;
    of_states[8] = p->stiffness * p->free_length;
    of_states[9] = p->stiffness * p->free_length;
    of_states[10] = 1.0;
    of_states[11] = p->free_length;
    of_states[12] = p->free_length;
    of_states[13] = real_sqrt(p->body_mass / p->stiffness);
    of_states[14] = 1.0;
    of_states[15] = 1.0;
    of_states[16] = 1.0;
    of_states[17] = real_sqrt(p->body_mass / p->stiffness);
    of_states[18] = p->free_length;
    of_states[19] = p->free_length;
    of_states[20] = 1.0;
    of_states[21] = 1.0;
    of_states[22] = real_sqrt(p->body_mass / p->stiffness);
    of_states[23] = p->free_length;
    of_states[24] = p->free_length;
    of_states[25] = p->stiffness * p->free_length * p->free_length;
    of_states[26] = p->stiffness * p->free_length * p->free_length;
    of_states[27] = p->stiffness * p->free_length * p->free_length;
    of_states[28] = p->stiffness * p->free_length * p->free_length;
    of_states[29] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[30] = 1.0;
    of_states[31] = 1.0;
    of_states[32] = real_sqrt(p->body_mass / p->stiffness);
    of_states[33] = 1.0;
    of_states[34] = p->free_length;
    of_states[35] = p->stiffness * p->free_length;
    of_states[36] = p->stiffness * p->free_length;
    of_states[37] = real_sqrt(p->body_mass / p->stiffness);
    of_states[38] = p->free_length;
    of_states[39] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[40] = p->free_length;
    of_states[41] = 1.0;
    of_states[42] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[43] = sqrt_of_stiffness_over_body_mass;
    of_states[44] = p->free_length;
    of_states[45] = 1.0;
    of_states[46] = p->free_length;
    of_states[47] = p->stiffness * p->free_length;
    of_states[48] = p->stiffness * p->free_length;
    of_states[49] = p->free_length;
    of_states[50] = p->free_length;
    of_states[51] = p->free_length;
    of_states[52] = 1.0;
    of_states[53] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[54] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[55] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[56] = sqrt_of_stiffness_over_body_mass;
    of_states[57] = p->free_length;
    of_states[58] = p->free_length;
    of_states[59] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[60] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[61] = p->free_length * p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[62] = p->free_length;
    of_states[63] = p->free_length;
    of_states[64] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[65] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[66] = p->free_length;
    of_states[67] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[68] = 1.0;
    of_states[69] = 1.0;
    of_states[70] = p->stiffness * p->free_length * p->free_length;
    of_states[71] = p->stiffness * p->free_length * p->free_length;
    of_states[72] = p->stiffness * p->free_length * p->free_length;
    of_states[73] = 1.0;
    of_states[74] = 1.0;
    of_states[75] = p->stiffness * p->free_length * p->free_length;
    of_states[76] = p->stiffness * p->free_length * p->free_length;
    of_states[77] = p->stiffness * p->free_length * p->free_length;
    of_states[78] = 1.0;
    of_states[79] = 1.0;
    of_states[80] = 1.0;
    of_states[81] = real_sqrt(p->body_mass / p->stiffness);
    of_states[82] = real_sqrt(p->body_mass / p->stiffness);
    of_states[83] = p->stiffness * p->free_length * p->free_length;
    of_states[84] = 1.0;
    of_events[EVENT_begins] = 1.0;
    of_events[EVENT_falls] = p->free_length;
    of_events[EVENT_collapses] = p->free_length;
    of_events[EVENT_apex] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_events[EVENT_touchdown] = p->free_length;
    of_events[EVENT_greatest_compression] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_events[EVENT_mid_stance] = 1.0;
    of_events[EVENT_lift_off] = p->stiffness * p->free_length;
    of_events[EVENT_enters_layer] = 1.0;
    of_events[EVENT_leaves_layer] = 1.0;
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
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 6},
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
    {.event = EVENT_greatest_compression, .react = react_slip_constant_greatest_compression,
        .vary_react = vary_react_slip_constant_greatest_compression,
        .is_watched = watches_slip_constant_greatest_compression,
        .vary_guard = vary_guard_slip_constant_greatest_compression, .next = {MODE_slip_constant}},
    {.event = EVENT_mid_stance, .is_counted = true, .react = react_slip_constant_mid_stance,
        .vary_react = vary_react_slip_constant_mid_stance, .is_watched = watches_slip_constant_mid_stance,
        .vary_guard = vary_guard_slip_constant_mid_stance, .next = {MODE_slip_constant}},
    {.event = EVENT_lift_off, .is_counted = true, .react = react_slip_constant_lift_off,
        .vary_react = vary_react_slip_constant_lift_off, .vary_guard = vary_guard_slip_constant_lift_off,
        .next = {MODE_no_stance, MODE_no_apex, MODE_flight}},
    {.event = EVENT_enters_layer, .react = react_slip_constant_enters_layer,
        .vary_react = vary_react_slip_constant_enters_layer, .is_watched = watches_slip_constant_enters_layer,
        .vary_guard = vary_guard_slip_constant_enters_layer, .next = {MODE_slip_falling}},
    {.event = EVENT_comes_to_rest, .is_counted = true, .react = react_slip_constant_comes_to_rest,
        .vary_react = vary_react_slip_constant_comes_to_rest,
        .vary_guard = vary_guard_slip_constant_comes_to_rest, .next = {MODE_stick, MODE_slip_constant}},
    {.event = -1},
};
static const tdmf_watch_kind watches_slip_constant[] = {
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 6},
    {.part = TDMF_LARGEST, .into = 9},
    {.part = TDMF_LARGEST, .into = 8},
    {.into = -1},
};
static const tdmf_guard_kind guards_stick[] = {
    {.event = EVENT_falls, .is_counted = true, .react = react_slip_constant_falls,
        .vary_react = vary_react_slip_constant_falls, .looks_again = true,
        .vary_guard = vary_guard_slip_constant_falls, .next = {MODE_fallen}},
    {.event = EVENT_collapses, .is_counted = true, .react = react_slip_constant_falls,
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
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 6},
    {.part = TDMF_LARGEST, .into = 9},
    {.part = TDMF_LARGEST, .into = 8},
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
static const tdmf_guard_kind guards_slip_falling[] = {
    {.event = EVENT_falls, .is_counted = true, .react = react_slip_constant_falls,
        .vary_react = vary_react_slip_constant_falls, .looks_again = true,
        .vary_guard = vary_guard_slip_constant_falls, .next = {MODE_fallen}},
    {.event = EVENT_collapses, .is_counted = true, .react = react_slip_constant_falls,
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
        .next = {MODE_no_stance, MODE_no_apex, MODE_flight}},
    {.event = EVENT_leaves_layer, .react = react_slip_constant_enters_layer,
        .vary_react = vary_react_slip_constant_enters_layer,
        .vary_guard = vary_guard_slip_falling_leaves_layer, .next = {MODE_slip_constant}},
    {.event = EVENT_comes_to_rest, .is_counted = true, .react = react_slip_constant_comes_to_rest,
        .vary_react = vary_react_slip_constant_comes_to_rest,
        .vary_guard = vary_guard_slip_constant_comes_to_rest, .next = {MODE_stick, MODE_slip_constant}},
    {.event = -1},
};
static const tdmf_watch_kind watches_slip_falling[] = {
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 6},
    {.part = TDMF_LARGEST, .into = 9},
    {.part = TDMF_LARGEST, .into = 8},
    {.into = -1},
};
static const tdmf_set set_extension[] = {set_extension_start_of_run, set_extension_start_of_run,
    set_extension_start_of_run, set_extension_start_of_run, set_extension_slip_constant,
    set_extension_slip_constant, set_extension_start_of_run, set_extension_start_of_run,
    set_extension_slip_constant};
static const tdmf_set set_thrust[] = {set_thrust_start_of_run, set_thrust_start_of_run,
    set_thrust_start_of_run, set_thrust_start_of_run, set_thrust_slip_constant, set_thrust_slip_constant,
    set_thrust_start_of_run, set_thrust_start_of_run, set_thrust_slip_constant};
static const tdmf_set set_more_thrust[] = {set_more_thrust_start_of_run, set_more_thrust_start_of_run,
    set_more_thrust_start_of_run, set_more_thrust_start_of_run, set_more_thrust_slip_constant,
    set_more_thrust_slip_constant, set_more_thrust_start_of_run, set_more_thrust_start_of_run,
    set_more_thrust_slip_constant};
static const int coordinates_at_apex[] = {38, 39};

static const tdmf_mode_kind modes[] = {
    {.motion = &tdmf_reduced_runner_motions[MODE_start_of_run], .open = open_start_of_run,
        .vary_open = vary_open_start_of_run, .guard_count = 1, .guards = guards_start_of_run,
        .watch_count = 0, .usual_count = 0, .watches = watches_start_of_run, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run},
    {.motion = &tdmf_reduced_runner_motions[MODE_no_start], .ends = true, .open = open_start_of_run,
        .vary_open = vary_open_start_of_run, .guard_count = 0, .guards = guards_no_start, .watch_count = 0,
        .usual_count = 0, .watches = watches_no_start, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run},
    {.motion = &tdmf_reduced_runner_motions[MODE_flight], .open = open_flight, .vary_open = vary_open_flight,
        .guard_count = 3, .guards = guards_flight, .watch_count = 1, .usual_count = 1,
        .watches = watches_flight, .outputs = outputs_flight, .vary_outputs = vary_outputs_flight,
        .leave = leave_start_of_run, .vary_leave = vary_leave_start_of_run, .from_world = from_world_flight,
        .vary_from_world = vary_from_world_flight, .to_world = to_world_flight,
        .vary_to_world = vary_to_world_flight},
    {.motion = &tdmf_reduced_runner_motions[MODE_fallen], .ends = true, .keeps_outputs = true,
        .open = open_start_of_run, .vary_open = vary_open_start_of_run, .guard_count = 0,
        .guards = guards_fallen, .watch_count = 0, .usual_count = 0, .watches = watches_fallen,
        .outputs = outputs_start_of_run, .vary_outputs = vary_outputs_start_of_run,
        .leave = leave_start_of_run, .vary_leave = vary_leave_start_of_run},
    {.motion = &tdmf_reduced_runner_motions[MODE_slip_constant], .open = open_slip_constant,
        .vary_open = vary_open_slip_constant, .guard_count = 7, .guards = guards_slip_constant,
        .watch_count = 3, .usual_count = 3, .watches = watches_slip_constant,
        .outputs = outputs_slip_constant, .vary_outputs = vary_outputs_slip_constant,
        .leave = leave_slip_constant, .vary_leave = vary_leave_slip_constant,
        .from_world = from_world_slip_constant, .vary_from_world = vary_from_world_slip_constant,
        .to_world = to_world_slip_constant, .vary_to_world = vary_to_world_slip_constant},
    {.motion = &tdmf_reduced_runner_motions[MODE_stick], .open = open_stick, .vary_open = vary_open_stick,
        .guard_count = 7, .guards = guards_stick, .watch_count = 3, .usual_count = 3,
        .watches = watches_stick, .outputs = outputs_stick, .vary_outputs = vary_outputs_stick,
        .leave = leave_stick, .vary_leave = vary_leave_stick, .from_world = from_world_slip_constant,
        .vary_from_world = vary_from_world_slip_constant, .to_world = to_world_slip_constant,
        .vary_to_world = vary_to_world_slip_constant},
    {.motion = &tdmf_reduced_runner_motions[MODE_no_stance], .ends = true, .open = open_start_of_run,
        .vary_open = vary_open_start_of_run, .guard_count = 0, .guards = guards_no_stance, .watch_count = 0,
        .usual_count = 0, .watches = watches_no_stance, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run},
    {.motion = &tdmf_reduced_runner_motions[MODE_no_apex], .ends = true, .open = open_start_of_run,
        .vary_open = vary_open_start_of_run, .guard_count = 0, .guards = guards_no_apex, .watch_count = 0,
        .usual_count = 0, .watches = watches_no_apex, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run},
    {.motion = &tdmf_reduced_runner_motions[MODE_slip_falling], .open = open_slip_falling,
        .vary_open = vary_open_slip_falling, .guard_count = 7, .guards = guards_slip_falling,
        .watch_count = 3, .usual_count = 3, .watches = watches_slip_falling, .outputs = outputs_slip_falling,
        .vary_outputs = vary_outputs_slip_falling, .time_scale = time_scale_slip_falling,
        .leave = leave_slip_constant, .vary_leave = vary_leave_slip_constant,
        .from_world = from_world_slip_constant, .vary_from_world = vary_from_world_slip_constant,
        .to_world = to_world_slip_constant, .vary_to_world = vary_to_world_slip_constant},
};

static const tdmf_set_kind sets[] = {
    {.is_state = true, .index = 46, .set = set_extension},
    {.is_state = false, .index = 9, .set = set_thrust},
    {.is_state = false, .index = 10, .set = set_more_thrust},
    {.index = -1},
};
static const tdmf_section_kind sections[] = {
    {.enter = enter_at_apex, .vary_enter = vary_enter_at_apex, .event = EVENT_apex, .count = 2,
        .coordinates = coordinates_at_apex},
    {.event = -1},
};

static const char *const mode_names[] = {"start_of_run", "no_start", "flight", "fallen", "slip_constant",
    "stick", "no_stance", "no_apex", "slip_falling"};
static const char *const state_names[] = {"time", "events", "last_event", "is_open", "work_then",
    "leg_work_then", "positive_work_so_far", "positive_work_then", "peak_force_so_far", "vertical_so_far",
    "touchdowns_so_far", "slip_so_far", "slid_from", "stance_so_far", "word_so_far", "last_letter",
    "bar_is_due", "mode_began", "x_then", "y_then", "count", "word_code", "period", "distance",
    "rise_of_stride", "work_of_stride", "hip_work", "leg_work_of_stride", "positive_work", "speed",
    "cost_of_transport", "touchdowns", "stance_time", "duty_factor", "slip_distance", "peak_force",
    "peak_vertical_force", "apex_time", "apex_com_height", "apex_com_speed", "apex_length", "apex_angle",
    "apex_length_rate", "apex_angle_rate", "height", "slope", "extension", "external_fx", "external_fy",
    "seen_x", "seen_y", "length", "angle", "seen_vx", "seen_vy", "length_rate", "angle_rate", "com_x",
    "com_y", "com_vx", "com_vy", "momentum", "x", "y", "vx", "vy", "foot_x", "foot_vx", "winding",
    "thrusting", "leg_work", "external_work", "damper_loss", "friction", "way", "friction_loss",
    "impact_loss", "external_torque", "liftoff_angle", "driving", "swing", "placing", "touchdown_time",
    "work", "has_fallen"};
static const char *const parameter_names[] = {"ground_height", "ground_slope", "body_mass", "foot_mass",
    "stiffness", "damping", "free_length", "least_length", "gravity", "thrust", "more_thrust", "static_ratio",
    "stribeck_velocity", "drive_torque", "touchdown_angle", "retraction_rate", "more_angle", "more_torque"};
static const char *const event_names[] = {"begins", "falls", "collapses", "apex", "touchdown",
    "greatest_compression", "mid_stance", "lift_off", "enters_layer", "leaves_layer", "slips_forward",
    "slips_backward", "comes_to_rest"};
static const char *const output_names[] = {"pending", "torque", "normal_force", "tangential_force",
    "ground_force_x", "ground_force_y", "force_of_leg", "body_x", "body_y", "body_vx", "body_vy", "center_x",
    "center_y", "center_vx", "center_vy", "kinetic_energy", "potential_energy", "elastic_energy", "energy",
    "kind_of_contact", "phase_of_hip"};
static const char *const table_names[] = {0};
static const char *const section_names[] = {"at_apex"};
static const double state_defaults[] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.4722627765193387,
    0.6417114468531165, 0.9999993776846997, -0.5462532571145313, 1.062035591761993, -1.9951712441925837e-05,
    1.1268102275039307e-06, 4.039363331769765e-05, 0.0, 1.4, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.6, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0};
static const double parameter_defaults[] = {0.0, 0.0, 1.0, 0.1, 1.0, 0.2, 1.0, 0.05, 0.01, 0.0, 0.0, 1.0, 0.0,
    0.2, 0.6981317007977318, 0.0, 0.0, 0.0};
static const double parameter_least[] = {-1000000000.0, -1.0, 1e-09, 1e-12, 1e-09, 0.0, 1e-06, 1e-09, 1e-09,
    0.0, -1000000.0, 1.0, 0.0, -1e+18, -1.5707963267948966, -1000000000.0, -3.141592653589793, -1e+18};
static const double parameter_most[] = {1000000000.0, 1.0, 1000000000.0, 1000000000.0, 1000000000000.0,
    1000000000000.0, 1000000.0, 1000000.0, 1000000.0, 1000000.0, 1000000.0, 1000000.0, 1000000000.0, 1e+18,
    1.5707963267948966, 1000000000.0, 3.141592653589793, 1e+18};

const tdmf_model_kind tdmf_reduced_runner_model = {
    .modes = modes,
    .sets = sets,
    .set_count = 3,
    .sections = sections,
    .scales = scales,
    .series_count = 33,
    .constant_count = 21,
    .lanes = {TDMF_TWO_LANES(tdmf_reduced_runner_motions_of_2),
        TDMF_FOUR_LANES(tdmf_reduced_runner_motions_of_4),
        TDMF_EIGHT_LANES(tdmf_reduced_runner_motions_of_8)},
    .seeds = TDMF_FOR_SEEDS(tdmf_reduced_runner_seeds),
    .mode_count = 9,
    .mode_names = mode_names,
    .state_count = 85,
    .state_names = state_names,
    .parameter_count = 18,
    .parameter_names = parameter_names,
    .event_count = 13,
    .event_names = event_names,
    .output_count = 21,
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
