/* Derived from the page PlainRunner: edit the page, not this. */
#include "plain_runner.h"

/* Constants of start_of_run. */
static void open_start_of_run(const real *parameters, const real *states, real *constants) {
    (void)parameters, (void)states, (void)constants;
}

/* First variation of open_start_of_run. */
static void vary_open_start_of_run(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)constants;
}

/* begins: An impact if the foot is on the ground and does not rise, else flight. An apex opens a stride. */
static int react_start_of_run_begins(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
    (void)tables;
    const real slow = 1e-12 * (p->free_length * real_sqrt(p->stiffness / p->body_mass));
    const real cosine = real_cos(x->angle);
    const real turn = x->length * x->angle_rate;
    const real sine = real_sin(x->angle);
    const real vy = x->length_rate * cosine - turn * sine;
    const real length_times_sine = x->length * sine;
    const real y_2 = x->length * cosine;
    const real vx = -(x->length_rate * sine) - turn * cosine;
    y->liftoff_angle = x->angle;
    y->placing = 0.0;
    if (x->seen_y <= 1e-12 * p->free_length && x->seen_vy <= slow) {
        const real way = select(x->seen_vx >= 0.0, 1.0, -1.0);
        const real way_times_seen_vx = way * x->seen_vx;
        const real friction_times_seen_vy = x->friction * x->seen_vy;
        const real stopped_speed = -friction_times_seen_vy;
        const real speed_left = way_times_seen_vx + friction_times_seen_vy;
        const real speed_after_impact = select(way_times_seen_vx <= stopped_speed, 0.0, speed_left);
        const real after_2 = way * speed_after_impact;
        const real touchdowns_so_far_plus_by_1 = x->touchdowns_so_far + 1.0;
        const real x_2 = -length_times_sine;
        const real along = x->seen_vx + vx;
        const real along_minus_after = along - after_2;
        const real off = x->seen_vy + vy;
        const real angle_minus_length_times_sineatan2_of_y = x->angle - real_atan2(length_times_sine, y_2);
        const real speeds = x->seen_vx * x->seen_vx + x->seen_vy * x->seen_vy - after_2 * after_2;
        const real lost = 0.5 * (p->foot_mass * speeds);
        const real impact_loss_plus_lost = x->impact_loss + lost;
        const real by_1_or_by_0 = select(x->angle >= 0.0, 1.0, 0.0);
        y->touchdowns_so_far = touchdowns_so_far_plus_by_1;
        y->slid_from = x->seen_x;
        y->bar_is_due = 1.0;
        y->x_ = x_2;
        y->y_ = y_2;
        y->vx = along_minus_after;
        y->vy = off;
        y->foot_x = x->seen_x;
        y->foot_vx = after_2;
        y->winding = angle_minus_length_times_sineatan2_of_y;
        y->impact_loss = impact_loss_plus_lost;
        y->driving = by_1_or_by_0;
        y->touchdown_time = x->time;
        y->was_placed = 0.0;
        y->placed_for = x->placing;
        if (way * after_2 > 0.0) {
            y->way = way;
            return next[0]; /* slip */
        }
        return next[1]; /* stick */
    }
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real rise = x->seen_vy + share * vy;
    const real sum_2 = x->seen_x - share * length_times_sine;
    const real height_of_section = x->seen_y + share * y_2;
    const real seen_vx_plus_share_times_vx = x->seen_vx + share * vx;
    const real square = x->length * x->length;
    const real moment = square * x->angle_rate;
    y->com_x = sum_2;
    y->com_y = height_of_section;
    y->com_vx = seen_vx_plus_share_times_vx;
    y->com_vy = rise;
    y->momentum = moment;
    if (real_abs(rise) <= slow) {
        const real rate = moment / square;
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
        y->y_then = height_of_section;
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
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real slow = 1e-12 * (p->free_length * real_sqrt(p->stiffness / p->body_mass));
    const real cosine = real_cos(x->angle);
    const real turn = x->length * x->angle_rate;
    const real sine = real_sin(x->angle);
    const real d_sine = cosine * dx->angle;
    const real sum_2 = dx->length * sine + x->length * d_sine;
    const real sine_times_angle = sine * dx->angle;
    const real d_y = dx->length * cosine - x->length * sine_times_angle;
    const real d_turn = dx->length * x->angle_rate + x->length * dx->angle_rate;
    const real d_vx = -(dx->length_rate * sine + x->length_rate * d_sine) - (d_turn * cosine
        - turn * sine_times_angle);
    const real d_vy = dx->length_rate * cosine - x->length_rate * sine_times_angle - (d_turn * sine
        + turn * d_sine);
    const real y_2 = x->length * cosine;
    const real length_times_sine = x->length * sine;
    y->liftoff_angle = dx->angle;
    y->placing = 0.0;
    if (x->seen_y <= 1e-12 * p->free_length && x->seen_vy <= slow) {
        const real way = select(x->seen_vx >= 0.0, 1.0, -1.0);
        const real way_times_seen_vx = way * x->seen_vx;
        const real friction_times_seen_vy = x->friction * x->seen_vy;
        const real stopped_speed = -friction_times_seen_vy;
        const real speed_left = way_times_seen_vx + friction_times_seen_vy;
        const real speed_after_impact = select(way_times_seen_vx <= stopped_speed, 0.0, speed_left);
        const real after_2 = way * speed_after_impact;
        const real d_x = -sum_2;
        const real d_speed_left = way * dx->seen_vx + (dx->friction * x->seen_vy + x->friction * dx->seen_vy);
        const real d_speed_after_impact = select(way_times_seen_vx <= stopped_speed, 0.0, d_speed_left);
        const real d_after = way * d_speed_after_impact;
        const real d_along = dx->seen_vx + d_vx;
        const real d_along_minus_d_after = d_along - d_after;
        const real d_off = dx->seen_vy + d_vy;
        const real sum_3 = dx->angle - (y_2 * sum_2
            - length_times_sine * d_y) / (length_times_sine * length_times_sine + y_2 * y_2);
        const real speeds = x->seen_vx * x->seen_vx + x->seen_vy * x->seen_vy - after_2 * after_2;
        const real d_speeds = 2.0 * (x->seen_vx * dx->seen_vx) + 2.0 * (x->seen_vy * dx->seen_vy)
            - 2.0 * (after_2 * d_after);
        const real d_lost = 0.5 * (dp->foot_mass * speeds + p->foot_mass * d_speeds);
        const real impact_loss_plus_d_lost = dx->impact_loss + d_lost;
        y->touchdowns_so_far = dx->touchdowns_so_far;
        y->slid_from = dx->seen_x;
        y->bar_is_due = 0.0;
        y->x_ = d_x;
        y->y_ = d_y;
        y->vx = d_along_minus_d_after;
        y->vy = d_off;
        y->foot_x = dx->seen_x;
        y->foot_vx = d_after;
        y->winding = sum_3;
        y->impact_loss = impact_loss_plus_d_lost;
        y->driving = 0.0;
        y->touchdown_time = dx->time;
        y->was_placed = 0.0;
        y->placed_for = dx->placing;
        if (way * after_2 > 0.0) {
            y->way = 0.0;
            return;
        }
        return;
    }
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real vy = x->length_rate * cosine - turn * sine;
    const real rise = x->seen_vy + share * vy;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real seen_x_minus_sum = dx->seen_x - (d_share * length_times_sine + share * sum_2);
    const real d_height_of_section = dx->seen_y + (d_share * y_2 + share * d_y);
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real sum_3 = dx->seen_vx + (d_share * vx + share * d_vx);
    const real d_square = 2.0 * (x->length * dx->length);
    const real square = x->length * x->length;
    const real d_moment = d_square * x->angle_rate + square * dx->angle_rate;
    const real d_rise = dx->seen_vy + (d_share * vy + share * d_vy);
    y->com_x = seen_x_minus_sum;
    y->com_y = d_height_of_section;
    y->com_vx = sum_3;
    y->com_vy = d_rise;
    y->momentum = d_moment;
    y->swing = 0.0;
    if (real_abs(rise) <= slow) {
        const real moment = square * x->angle_rate;
        const real rate = moment / square;
        const real d_rate = (d_moment - rate * d_square) / square;
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
        y->y_then = d_height_of_section;
        y->apex_time = dx->time;
        y->apex_com_height = d_height_of_section;
        y->apex_com_speed = sum_3;
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
    (void)parameters, (void)states, (void)outputs;
}

/* First variation of outputs_start_of_run. */
static void vary_outputs_start_of_run(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *outputs) {
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)outputs;
}

/* Count the event. A contact mode that lasted adds a letter to the gait word, a new stance a bar. */
static void leave_start_of_run(const real *parameters, const real *states, real counted, real *after) {
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
    (void)parameters;
    const real is_new = select(x->time > x->last_event, counted, 0.0);
    y->events = x->events + is_new;
    y->last_event = select(counted > 0.0, x->time, x->last_event);
    y->mode_began = x->time;
}

/* First variation of leave_start_of_run. */
static void vary_leave_start_of_run(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real counted, real *after) {
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters;
    y->events = dx->events;
    y->last_event = select(counted > 0.0, dx->time, dx->last_event);
    y->mode_began = dx->time;
}

/* Constants of slip_constant. */
static void open_slip_constant(const real *parameters, const real *states, real *constants) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    slip_constant_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real stance_torque = x->external_torque - x->driving * p->drive_torque;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real way_times_friction = x->way * x->friction;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real square_of_torque = stance_torque * stance_torque;
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
    c->square_of_torque = square_of_torque;
}

/* First variation of open_slip_constant. */
static void vary_open_slip_constant(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    slip_constant_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real d_inverse_body_mass = -(inverse_body_mass * dp->body_mass / p->body_mass);
    const real d_stance_torque = dx->external_torque - (p->drive_torque * dx->driving
        + x->driving * dp->drive_torque);
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real d_inverse_foot_mass = -(inverse_foot_mass * dp->foot_mass / p->foot_mass);
    const real d_way_times_friction = x->friction * dx->way + x->way * dx->friction;
    const real d_foot_mass_times_gravity = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real stance_torque = x->external_torque - x->driving * p->drive_torque;
    const real d_square_of_torque = 2.0 * (stance_torque * d_stance_torque);
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
    c->square_of_torque = d_square_of_torque;
}

/* falls: The body reaches the ground. */
static int react_slip_constant_falls(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
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
    y->has_fallen = 1.0;
    return next[0]; /* fallen */
}

/* First variation of falls. */
static void vary_react_slip_constant_falls(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const plain_runner_states *x = (const void *)states;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
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
    y->has_fallen = 0.0;
}

/* First variation of the guard of falls. */
static real vary_guard_slip_constant_falls(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_runner_states *dx = (const void *)d_states;
    (void)parameters, (void)states, (void)d_parameters;
    return dx->y_;
}

/* First variation of the guard of collapses. */
static real vary_guard_slip_constant_collapses(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
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
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->thrusting = 1.0;
    return next[0]; /* slip */
}

/* First variation of greatest_compression. */
static void vary_react_slip_constant_greatest_compression(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed;
    y->thrusting = 0.0;
}

/* True if greatest_compression is watched. */
static real watches_slip_constant_greatest_compression(const real *parameters, const real *states) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    if (x->thrusting <= 0.0 && p->notes_compression > 0.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of greatest_compression. */
static real vary_guard_slip_constant_greatest_compression(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_runner_states *x = (const void *)states;
    const plain_runner_states *dx = (const void *)d_states;
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
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->driving = 0.0;
    return next[0]; /* slip */
}

/* First variation of mid_stance. */
static void vary_react_slip_constant_mid_stance(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed;
    y->driving = 0.0;
}

/* True if mid_stance is watched. */
static real watches_slip_constant_mid_stance(const real *parameters, const real *states) {
    const plain_runner_states *x = (const void *)states;
    (void)parameters;
    if (x->driving > 0.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of mid_stance. */
static real vary_guard_slip_constant_mid_stance(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_runner_states *x = (const void *)states;
    const plain_runner_states *dx = (const void *)d_states;
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
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
    (void)tables;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real rise = share * x->vy;
    const real goes_on = select(x->time <= x->touchdown_time, x->was_placed, 0.0);
    const real x__times_x_ = x->x_ * x->x_;
    const real square = x__times_x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real middle = p->free_length - length;
    const real spring = p->stiffness * middle - p->damping * length_rate;
    const real axial = spring / length;
    const real axial_times_y_ = axial * x->y_;
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real kd_times_angle_rate = p->kd * angle_rate;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real by_1eminus_06_times_free_length = 1e-06 * p->free_length;
    const real product_2 = by_1eminus_06_times_free_length * by_1eminus_06_times_free_length;
    const real stiffness_times_free_length = p->stiffness * p->free_length;
    const real hardly = select(x__times_x_ > product_2, 1e-09 * stiffness_times_free_length,
        -(1e-12 * stiffness_times_free_length));
    const real x_2 = x->foot_x + share * x->x_;
    const real y_2 = share * x->y_;
    const real along = x->foot_vx + share * x->vx;
    const real goes_on_times_placed_for = goes_on * x->placed_for;
    const real product_3 = 1e-06 * stiffness_times_free_length;
    y->liftoff_angle = angle;
    y->placing = goes_on_times_placed_for;
    y->rises_again = goes_on;
    if (rise < 0.0 || goes_on > 0.0) {
        const real servo = -(p->kp * (angle - p->touchdown_angle)) - kd_times_angle_rate;
        const real swing_torque = x->external_torque + servo;
        const real turning = swing_torque / square;
        const real off = axial_times_y_ + turning * x->x_;
        const real normal = off + foot_mass_times_gravity;
        const real lift = -normal;
        y->swing = 2.0;
        if (lift > hardly) {
            const real hops = select(x__times_x_ > product_2, product_3 + normal, -1.0);
            const real hopped = select(hops > 0.0, 1.0, x->has_hopped);
            const real hop_time = select(hops > 0.0, x->time, x->hop_time);
            y->length = length;
            y->angle = angle;
            y->length_rate = length_rate;
            y->com_x = x_2;
            y->com_y = y_2;
            y->com_vx = along;
            y->com_vy = rise;
            y->momentum = moment;
            y->thrusting = 0.0;
            y->has_hopped = hopped;
            y->hop_time = hop_time;
            return next[0]; /* flight */
        }
        return next[1]; /* graze */
    }
    const real first = p->liftoff_factor * angle;
    const real retracting_torque = -(p->kp * (angle - first)) - kd_times_angle_rate;
    if (p->swing_clamp > 0.0 && retracting_torque <= 0.0) {
        const real flight_lifts = axial_times_y_ + x->external_torque / square * x->x_
            + foot_mass_times_gravity;
        y->swing = 0.0;
        if (-flight_lifts > hardly) {
            const real product_plus_flight_lifts_or_by_minus_1 = select(x__times_x_ > product_2, product_3
                + flight_lifts, -1.0);
            y->length = length;
            y->angle = angle;
            y->length_rate = length_rate;
            y->com_x = x_2;
            y->com_y = y_2;
            y->com_vx = along;
            y->com_vy = rise;
            y->momentum = moment;
            y->thrusting = 0.0;
            y->has_hopped = select(product_plus_flight_lifts_or_by_minus_1 > 0.0, 1.0, x->has_hopped);
            y->hop_time = select(product_plus_flight_lifts_or_by_minus_1 > 0.0, x->time, x->hop_time);
            return next[0]; /* flight */
        }
        return next[1]; /* graze */
    }
    const real sum_2 = axial_times_y_ + (x->external_torque + retracting_torque) / square * x->x_
        + foot_mass_times_gravity;
    y->swing = 1.0;
    if (-sum_2 > hardly) {
        const real product_plus_sum_or_by_minus_1 = select(x__times_x_ > product_2, product_3 + sum_2, -1.0);
        y->length = length;
        y->angle = angle;
        y->length_rate = length_rate;
        y->com_x = x_2;
        y->com_y = y_2;
        y->com_vx = along;
        y->com_vy = rise;
        y->momentum = moment;
        y->thrusting = 0.0;
        y->has_hopped = select(product_plus_sum_or_by_minus_1 > 0.0, 1.0, x->has_hopped);
        y->hop_time = select(product_plus_sum_or_by_minus_1 > 0.0, x->time, x->hop_time);
        return next[0]; /* flight */
    }
    return next[1]; /* graze */
}

/* First variation of lift_off. */
static void vary_react_slip_constant_lift_off(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real rise = share * x->vy;
    const real goes_on = select(x->time <= x->touchdown_time, x->was_placed, 0.0);
    const real x__times_x_ = x->x_ * x->x_;
    const real square = x__times_x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real middle = p->free_length - length;
    const real spring = p->stiffness * middle - p->damping * length_rate;
    const real axial = spring / length;
    const real axial_times_y_ = axial * x->y_;
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real kd_times_angle_rate = p->kd * angle_rate;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
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
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_x = dx->foot_x + (d_share * x->x_ + share * dx->x_);
    const real d_y = d_share * x->y_ + share * dx->y_;
    const real d_along = dx->foot_vx + (d_share * x->vx + share * dx->vx);
    const real d_rise = d_share * x->vy + share * dx->vy;
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    const real d_goes_on = select(x->time <= x->touchdown_time, dx->was_placed, 0.0);
    const real sum_2 = d_goes_on * x->placed_for + goes_on * dx->placed_for;
    const real product_3 = 1e-06 * stiffness_times_free_length;
    y->liftoff_angle = d_angle;
    y->swing = 0.0;
    y->placing = sum_2;
    y->rises_again = d_goes_on;
    if (rise < 0.0 || goes_on > 0.0) {
        const real servo = -(p->kp * (angle - p->touchdown_angle)) - kd_times_angle_rate;
        const real swing_torque = x->external_torque + servo;
        const real turning = swing_torque / square;
        const real off = axial_times_y_ + turning * x->x_;
        const real normal = off + foot_mass_times_gravity;
        const real lift = -normal;
        if (lift > hardly) {
            const real hops = select(x__times_x_ > product_2, product_3 + normal, -1.0);
            const real d_hopped = select(hops > 0.0, 0.0, dx->has_hopped);
            const real d_hop_time = select(hops > 0.0, dx->time, dx->hop_time);
            y->length = d_length;
            y->angle = d_angle;
            y->length_rate = d_length_rate;
            y->com_x = d_x;
            y->com_y = d_y;
            y->com_vx = d_along;
            y->com_vy = d_rise;
            y->momentum = d_moment;
            y->thrusting = 0.0;
            y->has_hopped = d_hopped;
            y->hop_time = d_hop_time;
            return;
        }
        return;
    }
    const real first = p->liftoff_factor * angle;
    const real retracting_torque = -(p->kp * (angle - first)) - kd_times_angle_rate;
    if (p->swing_clamp > 0.0 && retracting_torque <= 0.0) {
        const real flight_lifts = axial_times_y_ + x->external_torque / square * x->x_
            + foot_mass_times_gravity;
        if (-flight_lifts > hardly) {
            const real product_plus_flight_lifts_or_by_minus_1 = select(x__times_x_ > product_2, product_3
                + flight_lifts, -1.0);
            y->length = d_length;
            y->angle = d_angle;
            y->length_rate = d_length_rate;
            y->com_x = d_x;
            y->com_y = d_y;
            y->com_vx = d_along;
            y->com_vy = d_rise;
            y->momentum = d_moment;
            y->thrusting = 0.0;
            y->has_hopped = select(product_plus_flight_lifts_or_by_minus_1 > 0.0, 0.0, dx->has_hopped);
            y->hop_time = select(product_plus_flight_lifts_or_by_minus_1 > 0.0, dx->time, dx->hop_time);
            return;
        }
        return;
    }
    const real sum_3 = axial_times_y_ + (x->external_torque + retracting_torque) / square * x->x_
        + foot_mass_times_gravity;
    if (-sum_3 > hardly) {
        const real product_plus_sum_or_by_minus_1 = select(x__times_x_ > product_2, product_3 + sum_3, -1.0);
        y->length = d_length;
        y->angle = d_angle;
        y->length_rate = d_length_rate;
        y->com_x = d_x;
        y->com_y = d_y;
        y->com_vx = d_along;
        y->com_vy = d_rise;
        y->momentum = d_moment;
        y->thrusting = 0.0;
        y->has_hopped = select(product_plus_sum_or_by_minus_1 > 0.0, 0.0, dx->has_hopped);
        y->hop_time = select(product_plus_sum_or_by_minus_1 > 0.0, dx->time, dx->hop_time);
        return;
    }
}

/* First variation of the guard of lift_off. */
static real vary_guard_slip_constant_lift_off(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
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
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_states *x = (const void *)states;
    const plain_runner_states *dx = (const void *)d_states;
    (void)parameters, (void)d_parameters;
    return dx->way * x->foot_vx + x->way * dx->foot_vx;
}

/* Count the event. A contact mode that lasted adds a letter to the gait word, a new stance a bar. */
static void leave_slip_constant(const real *parameters, const real *states, real counted, real *after) {
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_states *x = (const void *)states;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_states *x = (const void *)states;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_states *x = (const void *)states;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    stick_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real stance_torque = x->external_torque - x->driving * p->drive_torque;
    const real foot_mass_times_gravity = p->foot_mass * p->gravity;
    const real square_of_torque = stance_torque * stance_torque;
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
    c->square_of_torque = square_of_torque;
}

/* First variation of open_stick. */
static void vary_open_stick(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    stick_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real d_inverse_body_mass = -(inverse_body_mass * dp->body_mass / p->body_mass);
    const real d_stance_torque = dx->external_torque - (p->drive_torque * dx->driving
        + x->driving * dp->drive_torque);
    const real d_foot_mass_times_gravity = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real stance_torque = x->external_torque - x->driving * p->drive_torque;
    const real d_square_of_torque = 2.0 * (stance_torque * d_stance_torque);
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
    c->square_of_torque = d_square_of_torque;
}

/* greatest_compression: Thrust begins where the leg is shortest, once per stance. A thrust of 0 is not
 * counted. */
static int react_stick_greatest_compression(const real *parameters, const real *states,
    const tdmf_table *tables, real *after, const int *next) {
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->thrusting = 1.0;
    return next[0]; /* stick */
}

/* mid_stance: Drive ends where the leg is upright, once per stance. */
static int react_stick_mid_stance(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->driving = 0.0;
    return next[0]; /* stick */
}

/* slips_forward: The push of the leg exceeds static friction, and the foot slips forward. */
static int react_stick_slips_forward(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->way = 1.0;
    return next[0]; /* slip */
}

/* First variation of slips_forward. */
static void vary_react_stick_slips_forward(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed;
    y->way = 0.0;
}

/* First variation of the guard of slips_forward. */
static real vary_guard_stick_slips_forward(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
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
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->way = -1.0;
    return next[0]; /* slip */
}

/* First variation of the guard of slips_backward. */
static real vary_guard_stick_slips_backward(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
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
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_states *x = (const void *)states;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
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

/* Constants of flight_calm. */
static void open_flight_calm(const real *parameters, const real *states, real *constants) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    flight_calm_constants *c = (void *)constants;
    const real mobility = 1.0 / p->body_mass + 1.0 / p->foot_mass;
    const real share = select(x->swing > 0.0, 1.0, 0.0);
    const real share_times_kp = share * p->kp;
    const real liftoff_factor_times_liftoff_angle = p->liftoff_factor * x->liftoff_angle;
    const real first = select(x->swing < 2.0, liftoff_factor_times_liftoff_angle, p->touchdown_angle);
    const real share_times_kd = share * p->kd;
    const real minus_gravity = -p->gravity;
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real body_mass_over_body_mass_plus_foot_mass = p->body_mass / (p->body_mass + p->foot_mass);
    const real sum_2 = 1.0 - body_mass_over_body_mass_plus_foot_mass;
    c->mobility = mobility;
    c->stiffness = p->stiffness;
    c->free_length = p->free_length;
    c->damping = p->damping;
    c->external_torque = x->external_torque;
    c->kp = p->kp;
    c->share_times_kp = share_times_kp;
    c->liftoff_factor_times_liftoff_angle = liftoff_factor_times_liftoff_angle;
    c->first = first;
    c->kd = p->kd;
    c->share_times_kd = share_times_kd;
    c->com_vx = x->com_vx;
    c->minus_gravity = minus_gravity;
    c->is_placing = is_placing;
    c->body_mass_over_body_mass_plus_foot_mass = body_mass_over_body_mass_plus_foot_mass;
    c->sum_2 = sum_2;
    c->least_length = p->least_length;
}

/* First variation of open_flight_calm. */
static void vary_open_flight_calm(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    flight_calm_constants *c = (void *)constants;
    const real d_mobility = -(1.0 / p->body_mass * dp->body_mass / p->body_mass)
        - 1.0 / p->foot_mass * dp->foot_mass / p->foot_mass;
    const real share = select(x->swing > 0.0, 1.0, 0.0);
    const real d_share_times_kp = share * dp->kp;
    const real d_liftoff_factor_times_liftoff_angle = x->liftoff_angle * dp->liftoff_factor
        + p->liftoff_factor * dx->liftoff_angle;
    const real d_first = select(x->swing < 2.0, d_liftoff_factor_times_liftoff_angle, dp->touchdown_angle);
    const real d_share_times_kd = share * dp->kd;
    const real d_minus_gravity = -dp->gravity;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real body_mass_over_body_mass_plus_foot_mass = p->body_mass / body_mass_plus_foot_mass;
    const real d_body_mass_over_body_mass_plus_foot_mass = (dp->body_mass
        - body_mass_over_body_mass_plus_foot_mass * (dp->body_mass
        + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_sum_2 = -d_body_mass_over_body_mass_plus_foot_mass;
    c->mobility = d_mobility;
    c->stiffness = dp->stiffness;
    c->free_length = dp->free_length;
    c->damping = dp->damping;
    c->external_torque = dx->external_torque;
    c->kp = dp->kp;
    c->share_times_kp = d_share_times_kp;
    c->liftoff_factor_times_liftoff_angle = d_liftoff_factor_times_liftoff_angle;
    c->first = d_first;
    c->kd = dp->kd;
    c->share_times_kd = d_share_times_kd;
    c->com_vx = dx->com_vx;
    c->minus_gravity = d_minus_gravity;
    c->is_placing = 0.0;
    c->body_mass_over_body_mass_plus_foot_mass = d_body_mass_over_body_mass_plus_foot_mass;
    c->sum_2 = d_sum_2;
    c->least_length = dp->least_length;
}

/* falls: The body reaches the ground. */
static int react_flight_calm_falls(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real by_1_minus_share = 1.0 - share;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_above = dx->com_y + ((by_1_minus_share * dx->length
        - d_share * x->length) * real_cos(x->angle)
        - by_1_minus_share * x->length * (real_sin(x->angle) * dx->angle));
    return d_above;
}

/* First variation of the guard of collapses. */
static real vary_guard_flight_calm_collapses(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    (void)parameters, (void)states;
    return dx->length - dp->least_length;
}

/* apex: A stride closes and place begins. An external force can cause further apices in place. */
static int react_flight_calm_apex(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
    (void)tables;
    const real period = x->time - x->apex_time;
    const real distance = x->com_x - x->x_then;
    const real hip = x->work - x->work_then;
    const real weight = (p->body_mass + p->foot_mass) * p->gravity;
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
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
    y->count = select(x->is_open > 0.0, x->count + 1.0, x->count);
    y->word_code = select(x->is_open > 0.0, x->word_so_far, x->word_code);
    y->period = select(x->is_open > 0.0, period, x->period);
    y->distance = select(x->is_open > 0.0, distance, x->distance);
    y->rise_of_stride = select(x->is_open > 0.0, x->com_y - x->y_then, x->rise_of_stride);
    y->work_of_stride = select(x->is_open > 0.0, hip, x->work_of_stride);
    y->hip_work = select(x->is_open > 0.0, hip, x->hip_work);
    y->positive_work = select(x->is_open > 0.0, x->positive_work_so_far - x->positive_work_then,
        x->positive_work);
    y->speed = select(x->is_open > 0.0, select(period > 0.0, distance / period, x->com_vx), x->speed);
    y->cost_of_transport = select(x->is_open > 0.0, select(period > 0.0, hip / (weight * distance), 0.0),
        x->cost_of_transport);
    y->touchdowns = select(x->is_open > 0.0, x->touchdowns_so_far, x->touchdowns);
    y->stance_time = select(x->is_open > 0.0, x->stance_so_far, x->stance_time);
    y->duty_factor = select(x->is_open > 0.0, select(period > 0.0, x->stance_so_far / period, 0.0),
        x->duty_factor);
    y->slip_distance = select(x->is_open > 0.0, x->slip_so_far, x->slip_distance);
    y->peak_force = select(x->is_open > 0.0, x->peak_force_so_far, x->peak_force);
    y->peak_vertical_force = select(x->is_open > 0.0, x->peak_force_so_far, x->peak_vertical_force);
    y->apex_time = x->time;
    y->apex_com_height = x->com_y;
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
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real d_period = dx->time - dx->apex_time;
    const real d_distance = dx->com_x - dx->x_then;
    const real d_hip = dx->work - dx->work_then;
    const real period = x->time - x->apex_time;
    const real distance = x->com_x - x->x_then;
    const real hip = x->work - x->work_then;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real weight = body_mass_plus_foot_mass * p->gravity;
    const real weight_times_distance = weight * distance;
    const real d_weight = p->gravity * (dp->body_mass + dp->foot_mass)
        + body_mass_plus_foot_mass * dp->gravity;
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real d_square = 2.0 * (x->length * dx->length);
    const real d_rate = (dx->momentum - rate * d_square) / square;
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
    y->word_code = select(x->is_open > 0.0, dx->word_so_far, dx->word_code);
    y->period = select(x->is_open > 0.0, d_period, dx->period);
    y->distance = select(x->is_open > 0.0, d_distance, dx->distance);
    y->rise_of_stride = select(x->is_open > 0.0, dx->com_y - dx->y_then, dx->rise_of_stride);
    y->work_of_stride = select(x->is_open > 0.0, d_hip, dx->work_of_stride);
    y->hip_work = select(x->is_open > 0.0, d_hip, dx->hip_work);
    y->positive_work = select(x->is_open > 0.0, dx->positive_work_so_far - dx->positive_work_then,
        dx->positive_work);
    y->speed = select(x->is_open > 0.0, select(period > 0.0, (d_distance
        - distance / period * d_period) / period, dx->com_vx), dx->speed);
    y->cost_of_transport = select(x->is_open > 0.0, select(period > 0.0, (d_hip
        - hip / weight_times_distance * (d_weight * distance + weight * d_distance)) / weight_times_distance,
        0.0), dx->cost_of_transport);
    y->touchdowns = select(x->is_open > 0.0, dx->touchdowns_so_far, dx->touchdowns);
    y->stance_time = select(x->is_open > 0.0, dx->stance_so_far, dx->stance_time);
    y->duty_factor = select(x->is_open > 0.0, select(period > 0.0, (dx->stance_so_far
        - x->stance_so_far / period * d_period) / period, 0.0), dx->duty_factor);
    y->slip_distance = select(x->is_open > 0.0, dx->slip_so_far, dx->slip_distance);
    y->peak_force = select(x->is_open > 0.0, dx->peak_force_so_far, dx->peak_force);
    y->peak_vertical_force = select(x->is_open > 0.0, dx->peak_force_so_far, dx->peak_vertical_force);
    y->apex_time = dx->time;
    y->apex_com_height = dx->com_y;
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
    const plain_runner_states *x = (const void *)states;
    (void)parameters;
    if (x->swing < 2.0 || x->rises_again > 0.0) {
        return 1.0;
    }
    return 0.0;
}

/* True if apex has to cross zero. */
static real crosses_flight_calm_apex(const real *parameters, const real *states) {
    const plain_runner_states *x = (const void *)states;
    (void)parameters;
    if (x->swing > 1.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of apex. */
static real vary_guard_flight_calm_apex(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const plain_runner_states *dx = (const void *)d_states;
    (void)parameters, (void)states, (void)d_parameters;
    return dx->com_vy;
}

/* touchdown: The foot reaches the ground. Where the lift of the flight law vanishes, shorter and shorter
 * hops follow each other. After one of no time the foot grazes, until the flight law has ceased to lift it
 * and lifts it again. */
static int react_flight_calm_touchdown(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
    (void)tables;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real sine = real_sin(x->angle);
    const real turn = x->momentum / x->length;
    const real cosine = real_cos(x->angle);
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real com_vx_minus_share_times_vx = x->com_vx - share * vx;
    const real vy = x->length_rate * cosine - turn * sine;
    const real length_times_sine = x->length * sine;
    const real x_2 = -length_times_sine;
    const real y_2 = x->length * cosine;
    const real along = x->com_x + share * length_times_sine;
    const real angle_minus_length_times_sineatan2_of_y = x->angle - real_atan2(length_times_sine, y_2);
    y->x_ = x_2;
    y->y_ = y_2;
    y->foot_x = along;
    y->winding = angle_minus_length_times_sineatan2_of_y;
    if (x->has_hopped > 0.0 && x->time <= x->hop_time) {
        y->vx = vx;
        y->vy = vy;
        y->foot_vx = com_vx_minus_share_times_vx;
        return next[0]; /* graze */
    }
    const real way = select(com_vx_minus_share_times_vx >= 0.0, 1.0, -1.0);
    const real way_times_com_vx_minus_share_times_vx = way * com_vx_minus_share_times_vx;
    const real com_vy_minus_share_times_vy = x->com_vy - share * vy;
    const real product_2 = x->friction * com_vy_minus_share_times_vy;
    const real stopped_speed = -product_2;
    const real speed_left = way_times_com_vx_minus_share_times_vx + product_2;
    const real speed_after_impact = select(way_times_com_vx_minus_share_times_vx <= stopped_speed, 0.0,
        speed_left);
    const real after_2 = way * speed_after_impact;
    const real touchdowns_so_far_plus_by_1 = x->touchdowns_so_far + 1.0;
    const real foot_mass_over_body_mass_plus_foot_mass = p->foot_mass / body_mass_plus_foot_mass;
    const real com_vx_plus_product_minus_after = x->com_vx + foot_mass_over_body_mass_plus_foot_mass * vx
        - after_2;
    const real com_vy_plus_product = x->com_vy + foot_mass_over_body_mass_plus_foot_mass * vy;
    const real speeds = com_vx_minus_share_times_vx * com_vx_minus_share_times_vx
        + com_vy_minus_share_times_vy * com_vy_minus_share_times_vy - after_2 * after_2;
    const real lost = 0.5 * (p->foot_mass * speeds);
    const real impact_loss_plus_lost = x->impact_loss + lost;
    const real by_1_or_by_0 = select(x->angle >= 0.0, 1.0, 0.0);
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    y->touchdowns_so_far = touchdowns_so_far_plus_by_1;
    y->slid_from = along;
    y->bar_is_due = 1.0;
    y->vx = com_vx_plus_product_minus_after;
    y->vy = com_vy_plus_product;
    y->foot_vx = after_2;
    y->impact_loss = impact_loss_plus_lost;
    y->driving = by_1_or_by_0;
    y->placing = 0.0;
    y->touchdown_time = x->time;
    y->was_placed = is_placing;
    y->placed_for = x->placing;
    if (way * after_2 > 0.0) {
        y->way = way;
        return next[1]; /* slip */
    }
    return next[2]; /* stick */
}

/* First variation of touchdown. */
static void vary_react_flight_calm_touchdown(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real sine = real_sin(x->angle);
    const real turn = x->momentum / x->length;
    const real cosine = real_cos(x->angle);
    const real vx = -(x->length_rate * sine) - turn * cosine;
    const real d_sine = cosine * dx->angle;
    const real sum_2 = dx->length * sine + x->length * d_sine;
    const real d_x = -sum_2;
    const real sine_times_angle = sine * dx->angle;
    const real d_y = dx->length * cosine - x->length * sine_times_angle;
    const real d_turn = (dx->momentum - turn * dx->length) / x->length;
    const real d_vx = -(dx->length_rate * sine + x->length_rate * d_sine) - (d_turn * cosine
        - turn * sine_times_angle);
    const real d_vy = dx->length_rate * cosine - x->length_rate * sine_times_angle - (d_turn * sine
        + turn * d_sine);
    const real body_mass_plus_foot_mass_2 = dp->body_mass + dp->foot_mass;
    const real d_share = (dp->body_mass - share * body_mass_plus_foot_mass_2) / body_mass_plus_foot_mass;
    const real length_times_sine = x->length * sine;
    const real d_along = dx->com_x + (d_share * length_times_sine + share * sum_2);
    const real sum_3 = dx->com_vx - (d_share * vx + share * d_vx);
    const real y_2 = x->length * cosine;
    const real sum_4 = dx->angle - (y_2 * sum_2
        - length_times_sine * d_y) / (length_times_sine * length_times_sine + y_2 * y_2);
    y->x_ = d_x;
    y->y_ = d_y;
    y->foot_x = d_along;
    y->winding = sum_4;
    if (x->has_hopped > 0.0 && x->time <= x->hop_time) {
        y->vx = d_vx;
        y->vy = d_vy;
        y->foot_vx = sum_3;
        return;
    }
    const real com_vx_minus_share_times_vx = x->com_vx - share * vx;
    const real way = select(com_vx_minus_share_times_vx >= 0.0, 1.0, -1.0);
    const real way_times_com_vx_minus_share_times_vx = way * com_vx_minus_share_times_vx;
    const real vy = x->length_rate * cosine - turn * sine;
    const real com_vy_minus_share_times_vy = x->com_vy - share * vy;
    const real product_2 = x->friction * com_vy_minus_share_times_vy;
    const real stopped_speed = -product_2;
    const real speed_left = way_times_com_vx_minus_share_times_vx + product_2;
    const real speed_after_impact = select(way_times_com_vx_minus_share_times_vx <= stopped_speed, 0.0,
        speed_left);
    const real after_2 = way * speed_after_impact;
    const real foot_mass_over_body_mass_plus_foot_mass = p->foot_mass / body_mass_plus_foot_mass;
    const real ratio = (dp->foot_mass
        - foot_mass_over_body_mass_plus_foot_mass * body_mass_plus_foot_mass_2) / body_mass_plus_foot_mass;
    const real sum_5 = dx->com_vy - (d_share * vy + share * d_vy);
    const real d_speed_left = way * sum_3 + (dx->friction * com_vy_minus_share_times_vy
        + x->friction * sum_5);
    const real d_speed_after_impact = select(way_times_com_vx_minus_share_times_vx <= stopped_speed, 0.0,
        d_speed_left);
    const real d_after = way * d_speed_after_impact;
    const real sum_6 = dx->com_vx + (ratio * vx + foot_mass_over_body_mass_plus_foot_mass * d_vx) - d_after;
    const real com_vy_plus_ratio_times_vy_plus_product = dx->com_vy + (ratio * vy
        + foot_mass_over_body_mass_plus_foot_mass * d_vy);
    const real speeds = com_vx_minus_share_times_vx * com_vx_minus_share_times_vx
        + com_vy_minus_share_times_vy * com_vy_minus_share_times_vy - after_2 * after_2;
    const real d_speeds = 2.0 * (com_vx_minus_share_times_vx * sum_3)
        + 2.0 * (com_vy_minus_share_times_vy * sum_5) - 2.0 * (after_2 * d_after);
    const real d_lost = 0.5 * (dp->foot_mass * speeds + p->foot_mass * d_speeds);
    const real impact_loss_plus_d_lost = dx->impact_loss + d_lost;
    y->touchdowns_so_far = dx->touchdowns_so_far;
    y->slid_from = d_along;
    y->bar_is_due = 0.0;
    y->vx = sum_6;
    y->vy = com_vy_plus_ratio_times_vy_plus_product;
    y->foot_vx = d_after;
    y->impact_loss = impact_loss_plus_d_lost;
    y->driving = 0.0;
    y->placing = 0.0;
    y->touchdown_time = dx->time;
    y->was_placed = 0.0;
    y->placed_for = dx->placing;
    if (way * after_2 > 0.0) {
        y->way = 0.0;
        return;
    }
}

/* First variation of the guard of touchdown. */
static real vary_guard_flight_calm_touchdown(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_above = dx->com_y - ((d_share * x->length + share * dx->length) * real_cos(x->angle)
        - share * x->length * (real_sin(x->angle) * dx->angle));
    return d_above;
}

/* clamp: The clamp of the hip torque closes: it holds the retracting torque at 0. */
static int react_flight_calm_clamp(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->swing = 0.0;
    return next[0]; /* flight */
}

/* First variation of clamp. */
static void vary_react_flight_calm_clamp(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const tdmf_table *tables, int seed, real *after) {
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed;
    y->swing = 0.0;
}

/* True if clamp is watched. */
static real watches_flight_calm_clamp(const real *parameters, const real *states) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    if (p->swing_clamp > 0.0 && real_abs(x->swing - 1.0) <= 0.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of clamp. */
static real vary_guard_flight_calm_clamp(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
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
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->swing = 1.0;
    return next[0]; /* flight */
}

/* True if release is watched. */
static real watches_flight_calm_release(const real *parameters, const real *states) {
    const plain_runner_states *x = (const void *)states;
    (void)parameters;
    if (x->swing < 1.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of release. */
static real vary_guard_flight_calm_release(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    const real square = x->length * x->length;
    const real rate = x->momentum / square;
    const real d_square = 2.0 * (x->length * dx->length);
    const real d_rate = (dx->momentum - rate * d_square) / square;
    const real d_servo = -(dp->kp * (x->angle - p->liftoff_factor * x->liftoff_angle) + p->kp * (dx->angle
        - (dp->liftoff_factor * x->liftoff_angle + p->liftoff_factor * dx->liftoff_angle))) - (dp->kd * rate
        + p->kd * d_rate);
    return -d_servo;
}

/* from world, in flight. */
static void from_world_flight_calm(const real *parameters, const real *states, real *after) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
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

/* Constants of graze. */
static void open_graze(const real *parameters, const real *states, real *constants) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    graze_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real off = p->foot_mass * p->gravity;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real minus_off_over_body_mass_minus_gravity = -(off / p->body_mass) - p->gravity;
    const real is_placing = select(x->swing < 2.0, 0.0, 1.0);
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real liftoff_factor_times_liftoff_angle = p->liftoff_factor * x->liftoff_angle;
    const real stance_torque = x->external_torque - x->driving * p->drive_torque;
    const real by_1_or_by_0 = select(x->swing > 0.0, 1.0, 0.0);
    const real by_1_or_by_0_times_kp = by_1_or_by_0 * p->kp;
    const real first = select(x->swing < 2.0, liftoff_factor_times_liftoff_angle, p->touchdown_angle);
    const real by_1_or_by_0_times_kd = by_1_or_by_0 * p->kd;
    c->inverse_body_mass = inverse_body_mass;
    c->stiffness = p->stiffness;
    c->free_length = p->free_length;
    c->damping = p->damping;
    c->off = off;
    c->inverse_foot_mass = inverse_foot_mass;
    c->minus_off_over_body_mass_minus_gravity = minus_off_over_body_mass_minus_gravity;
    c->is_placing = is_placing;
    c->least_length = p->least_length;
    c->share = share;
    c->kp = p->kp;
    c->winding = x->winding;
    c->liftoff_factor_times_liftoff_angle = liftoff_factor_times_liftoff_angle;
    c->kd = p->kd;
    c->external_torque = x->external_torque;
    c->stance_torque = stance_torque;
    c->by_1_or_by_0_times_kp = by_1_or_by_0_times_kp;
    c->first = first;
    c->by_1_or_by_0_times_kd = by_1_or_by_0_times_kd;
}

/* First variation of open_graze. */
static void vary_open_graze(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    graze_constants *c = (void *)constants;
    const real inverse_body_mass = 1.0 / p->body_mass;
    const real d_inverse_body_mass = -(inverse_body_mass * dp->body_mass / p->body_mass);
    const real d_off = p->gravity * dp->foot_mass + p->foot_mass * dp->gravity;
    const real inverse_foot_mass = 1.0 / p->foot_mass;
    const real d_inverse_foot_mass = -(inverse_foot_mass * dp->foot_mass / p->foot_mass);
    const real off = p->foot_mass * p->gravity;
    const real d_minus_off_over_body_mass_minus_gravity = -((d_off
        - off / p->body_mass * dp->body_mass) / p->body_mass) - dp->gravity;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_liftoff_factor_times_liftoff_angle = x->liftoff_angle * dp->liftoff_factor
        + p->liftoff_factor * dx->liftoff_angle;
    const real d_stance_torque = dx->external_torque - (p->drive_torque * dx->driving
        + x->driving * dp->drive_torque);
    const real by_1_or_by_0 = select(x->swing > 0.0, 1.0, 0.0);
    const real d_by_1_or_by_0_times_kp = by_1_or_by_0 * dp->kp;
    const real d_first = select(x->swing < 2.0, d_liftoff_factor_times_liftoff_angle, dp->touchdown_angle);
    const real d_by_1_or_by_0_times_kd = by_1_or_by_0 * dp->kd;
    c->inverse_body_mass = d_inverse_body_mass;
    c->stiffness = dp->stiffness;
    c->free_length = dp->free_length;
    c->damping = dp->damping;
    c->off = d_off;
    c->inverse_foot_mass = d_inverse_foot_mass;
    c->minus_off_over_body_mass_minus_gravity = d_minus_off_over_body_mass_minus_gravity;
    c->is_placing = 0.0;
    c->least_length = dp->least_length;
    c->share = d_share;
    c->kp = dp->kp;
    c->winding = dx->winding;
    c->liftoff_factor_times_liftoff_angle = d_liftoff_factor_times_liftoff_angle;
    c->kd = dp->kd;
    c->external_torque = dx->external_torque;
    c->stance_torque = d_stance_torque;
    c->by_1_or_by_0_times_kp = d_by_1_or_by_0_times_kp;
    c->first = d_first;
    c->by_1_or_by_0_times_kd = d_by_1_or_by_0_times_kd;
}

/* apex_in_graze: Place begins. No stride closes, because the foot is on the ground. */
static int react_graze_apex_in_graze(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->swing = 2.0;
    y->placing = 0.0;
    return next[0]; /* graze */
}

/* First variation of apex_in_graze. */
static void vary_react_graze_apex_in_graze(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed;
    y->swing = 0.0;
    y->placing = 0.0;
}

/* True if apex_in_graze is watched. */
static real watches_graze_apex_in_graze(const real *parameters, const real *states) {
    const plain_runner_states *x = (const void *)states;
    (void)parameters;
    if (x->swing < 2.0) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of apex_in_graze. */
static real vary_guard_graze_apex_in_graze(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_rise = d_share * x->vy + share * dx->vy;
    return d_rise;
}

/* clamp: The clamp of the hip torque closes: it holds the retracting torque at 0. */
static int react_graze_clamp(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->swing = 0.0;
    return next[0]; /* graze */
}

/* First variation of the guard of clamp. */
static real vary_guard_graze_clamp(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
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
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->swing = 1.0;
    return next[0]; /* graze */
}

/* First variation of the guard of release. */
static real vary_guard_graze_release(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
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
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)tables;
    y->driving = 0.0;
    return next[0]; /* graze */
}

/* graze_to_contact: The stance law presses the foot on the ground again. */
static int react_graze_graze_to_contact(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
    (void)tables;
    y->placing = 0.0;
    if (real_abs(x->foot_vx) > 0.0) {
        y->way = select(x->foot_vx > 0.0, 1.0, -1.0);
        return next[0]; /* slip */
    }
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
        return next[1]; /* stick */
    }
    const real way = select(along > 0.0, -1.0, 1.0);
    y->way = way;
    return next[0]; /* slip */
}

/* First variation of graze_to_contact. */
static void vary_react_graze_graze_to_contact(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
    (void)d_parameters, (void)tables, (void)seed;
    y->placing = 0.0;
    if (real_abs(x->foot_vx) > 0.0) {
        y->way = 0.0;
        return;
    }
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

/* First variation of the guard of graze_to_contact. */
static real vary_guard_graze_graze_to_contact(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
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
    return -d_normal;
}

/* graze_to_flight: The flight law lifts the foot. */
static int react_graze_graze_to_flight(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
    (void)tables;
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real x_2 = x->foot_x + share * x->x_;
    const real y_2 = share * x->y_;
    const real vx = x->foot_vx + share * x->vx;
    const real vy = share * x->vy;
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    y->length = length;
    y->angle = angle;
    y->length_rate = length_rate;
    y->com_x = x_2;
    y->com_y = y_2;
    y->com_vx = vx;
    y->com_vy = vy;
    y->momentum = moment;
    y->thrusting = 0.0;
    return next[0]; /* flight */
}

/* First variation of graze_to_flight. */
static void vary_react_graze_graze_to_flight(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
    (void)tables, (void)seed;
    const real d_square = 2.0 * (x->x_ * dx->x_) + 2.0 * (x->y_ * dx->y_);
    const real square = x->x_ * x->x_ + x->y_ * x->y_;
    const real length = real_sqrt(square);
    const real d_length = 0.5 * d_square / length;
    const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
    const real length_rate = (x->x_ * x->vx + x->y_ * x->vy) / length;
    const real d_length_rate = (dx->x_ * x->vx + x->x_ * dx->vx + (dx->y_ * x->vy + x->y_ * dx->vy)
        - length_rate * d_length) / length;
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real d_x = dx->foot_x + (d_share * x->x_ + share * dx->x_);
    const real d_y = d_share * x->y_ + share * dx->y_;
    const real d_vx = dx->foot_vx + (d_share * x->vx + share * dx->vx);
    const real d_vy = d_share * x->vy + share * dx->vy;
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    y->length = d_length;
    y->angle = d_angle;
    y->length_rate = d_length_rate;
    y->com_x = d_x;
    y->com_y = d_y;
    y->com_vx = d_vx;
    y->com_vy = d_vy;
    y->momentum = d_moment;
    y->thrusting = 0.0;
}

/* True if graze_to_flight has to cross zero. */
static real crosses_graze_graze_to_flight(const real *parameters, const real *states) {
    const plain_runner_states *x = (const void *)states;
    (void)parameters;
    if (x->has_hopped > 0.0 && x->mode_began <= x->hop_time) {
        return 1.0;
    }
    return 0.0;
}

/* First variation of the guard of graze_to_flight. */
static real vary_guard_graze_graze_to_flight(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_states *x = (const void *)states;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    const plain_runner_states *dx = (const void *)d_states;
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
    const real share = select(x->swing > 0.0, 1.0, 0.0);
    const real angle = real_atan2(-x->x_, x->y_) + x->winding;
    const real first = select(x->swing < 2.0, p->liftoff_factor * x->liftoff_angle, p->touchdown_angle);
    const real angle_minus_first = angle - first;
    const real kp_times_share = p->kp * share;
    const real d_angle = (x->x_ * dx->y_ - x->y_ * dx->x_) / square + dx->winding;
    const real d_first = select(x->swing < 2.0, dp->liftoff_factor * x->liftoff_angle
        + p->liftoff_factor * dx->liftoff_angle, dp->touchdown_angle);
    const real moment = x->x_ * x->vy - x->y_ * x->vx;
    const real angle_rate = moment / square;
    const real kd_times_share = p->kd * share;
    const real d_moment = dx->x_ * x->vy + x->x_ * dx->vy - (dx->y_ * x->vx + x->y_ * dx->vx);
    const real d_angle_rate = (d_moment - angle_rate * d_square) / square;
    const real d_servo = -(dp->kp * share * angle_minus_first + kp_times_share * (d_angle - d_first))
        - (dp->kd * share * angle_rate + kd_times_share * d_angle_rate);
    const real d_swing_torque = dx->external_torque + d_servo;
    const real servo = -(kp_times_share * angle_minus_first) - kd_times_share * angle_rate;
    const real swing_torque = x->external_torque + servo;
    const real turning = swing_torque / square;
    const real d_turning = (d_swing_torque - turning * d_square) / square;
    const real d_off = d_axial * x->y_ + axial * dx->y_ + (d_turning * x->x_ + turning * dx->x_);
    const real d_normal = d_off + (p->gravity * dp->foot_mass + p->foot_mass * dp->gravity);
    return d_normal;
}

/* Count the event. A contact mode that lasted adds a letter to the gait word, a new stance a bar. */
static void leave_graze(const real *parameters, const real *states, real counted, real *after) {
    const plain_runner_states *x = (const void *)states;
    plain_runner_states *y = (void *)after;
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
    const plain_runner_states *dx = (const void *)d_states;
    plain_runner_states *y = (void *)after;
    (void)parameters, (void)states, (void)d_parameters;
    y->events = dx->events;
    y->last_event = select(counted > 0.0, dx->time, dx->last_event);
    y->slid_from = dx->foot_x;
    y->mode_began = dx->time;
}

/* at_apex: A start at an apex, with the foot at x = 0. */
static void enter_at_apex(const real *parameters, const real *states, const real *at, real *after) {
    const plain_runner_parameters *p = (const void *)parameters;
    plain_runner_states *y = (void *)after;
    (void)states;
    const real at_apex_com_height = at[0];
    const real at_apex_com_speed = at[1];
    const real at_apex_length = at[2];
    const real at_apex_angle = at[3];
    const real at_apex_length_rate = at[4];
    const real at_apex_angle_rate = at[5];
    const real share = p->body_mass / (p->body_mass + p->foot_mass);
    const real cosine = real_cos(at_apex_angle);
    const real y_2 = at_apex_length * cosine;
    const real sine = real_sin(at_apex_angle);
    const real turn = at_apex_length * at_apex_angle_rate;
    const real vx = -(at_apex_length_rate * sine) - turn * cosine;
    const real vy = at_apex_length_rate * cosine - turn * sine;
    y->seen_x = 0.0;
    y->seen_y = at_apex_com_height - share * y_2;
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
    const plain_runner_parameters *p = (const void *)parameters;
    const plain_runner_parameters *dp = (const void *)d_parameters;
    plain_runner_states *y = (void *)after;
    (void)states, (void)d_states;
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
    const real body_mass_plus_foot_mass = p->body_mass + p->foot_mass;
    const real share = p->body_mass / body_mass_plus_foot_mass;
    const real d_share = (dp->body_mass - share * (dp->body_mass + dp->foot_mass)) / body_mass_plus_foot_mass;
    const real cosine = real_cos(at_apex_angle);
    const real y_2 = at_apex_length * cosine;
    const real sine = real_sin(at_apex_angle);
    const real sine_times_d_at_apex_angle = sine * d_at_apex_angle;
    const real d_y = d_at_apex_length * cosine - at_apex_length * sine_times_d_at_apex_angle;
    const real turn = at_apex_length * at_apex_angle_rate;
    const real vx = -(at_apex_length_rate * sine) - turn * cosine;
    const real d_sine = cosine * d_at_apex_angle;
    const real d_turn = d_at_apex_length * at_apex_angle_rate + at_apex_length * d_at_apex_angle_rate;
    const real d_vx = -(d_at_apex_length_rate * sine + at_apex_length_rate * d_sine) - (d_turn * cosine
        - turn * sine_times_d_at_apex_angle);
    const real vy = at_apex_length_rate * cosine - turn * sine;
    const real d_vy = d_at_apex_length_rate * cosine - at_apex_length_rate * sine_times_d_at_apex_angle
        - (d_turn * sine + turn * d_sine);
    y->seen_x = 0.0;
    y->seen_y = d_at_apex_com_height - (d_share * y_2 + share * d_y);
    y->length = d_at_apex_length;
    y->angle = d_at_apex_angle;
    y->seen_vx = d_at_apex_com_speed - (d_share * vx + share * d_vx);
    y->seen_vy = -(d_share * vy + share * d_vy);
    y->length_rate = d_at_apex_length_rate;
    y->angle_rate = d_at_apex_angle_rate;
}

/* Typical size of each state and guard. */
static void scales(const real *parameters, real *of_states, real *of_events) {
    const plain_runner_parameters *p = (const void *)parameters;
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
    of_states[10] = p->stiffness * p->free_length;
    of_states[11] = 1.0;
    of_states[12] = p->free_length;
    of_states[13] = p->free_length;
    of_states[14] = real_sqrt(p->body_mass / p->stiffness);
    of_states[15] = 1.0;
    of_states[16] = 1.0;
    of_states[17] = 1.0;
    of_states[18] = real_sqrt(p->body_mass / p->stiffness);
    of_states[19] = p->free_length;
    of_states[20] = p->free_length;
    of_states[21] = 1.0;
    of_states[22] = 1.0;
    of_states[23] = real_sqrt(p->body_mass / p->stiffness);
    of_states[24] = p->free_length;
    of_states[25] = p->free_length;
    of_states[26] = product_2;
    of_states[27] = product_2;
    of_states[28] = product_2;
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
    of_states[45] = p->free_length;
    of_states[46] = p->free_length;
    of_states[47] = 1.0;
    of_states[48] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[49] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[50] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[51] = sqrt_of_stiffness_over_body_mass;
    of_states[52] = p->free_length;
    of_states[53] = p->free_length;
    of_states[54] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[55] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[56] = p->free_length * p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[57] = p->free_length;
    of_states[58] = p->free_length;
    of_states[59] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[60] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[61] = p->free_length;
    of_states[62] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_states[63] = 1.0;
    of_states[64] = 1.0;
    of_states[65] = product_2;
    of_states[66] = 1.0;
    of_states[67] = 1.0;
    of_states[68] = product_2;
    of_states[69] = product_2;
    of_states[70] = product_2;
    of_states[71] = 1.0;
    of_states[72] = 1.0;
    of_states[73] = 1.0;
    of_states[74] = real_sqrt(p->body_mass / p->stiffness);
    of_states[75] = real_sqrt(p->body_mass / p->stiffness);
    of_states[76] = 1.0;
    of_states[77] = real_sqrt(p->body_mass / p->stiffness);
    of_states[78] = 1.0;
    of_states[79] = real_sqrt(p->body_mass / p->stiffness);
    of_states[80] = 1.0;
    of_states[81] = product_2;
    of_states[82] = 1.0;
    of_events[EVENT_begins] = 1.0;
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
    of_events[EVENT_slips_forward] = p->stiffness * p->free_length;
    of_events[EVENT_slips_backward] = p->stiffness * p->free_length;
    of_events[EVENT_comes_to_rest] = p->free_length * sqrt_of_stiffness_over_body_mass;
    of_events[EVENT_graze_to_contact] = p->stiffness * p->free_length;
    of_events[EVENT_graze_to_flight] = p->stiffness * p->free_length;
}

static const tdmf_guard_kind guards_start_of_run[] = {
    {.event = EVENT_begins, .react = react_start_of_run_begins, .vary_react = vary_react_start_of_run_begins,
        .vary_guard = vary_guard_start_of_run_begins, .next = {MODE_slip_constant, MODE_stick,
        MODE_flight_calm}},
    {.event = -1},
};
static const tdmf_watch_kind watches_start_of_run[] = {
    {.into = -1},
};
static const tdmf_guard_kind guards_slip_constant[] = {
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
    {.event = EVENT_comes_to_rest, .is_counted = true, .react = react_slip_constant_comes_to_rest,
        .vary_react = vary_react_slip_constant_comes_to_rest,
        .vary_guard = vary_guard_slip_constant_comes_to_rest, .next = {MODE_stick, MODE_slip_constant}},
    {.event = -1},
};
static const tdmf_watch_kind watches_slip_constant[] = {
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 8},
    {.part = TDMF_LARGEST, .into = 10},
    {.part = TDMF_LARGEST, .into = 3},
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 5},
    {.into = -1},
};
static const tdmf_guard_kind guards_stick[] = {
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
        .vary_react = vary_react_stick_slips_forward, .vary_guard = vary_guard_stick_slips_backward,
        .next = {MODE_slip_constant}},
    {.event = -1},
};
static const tdmf_watch_kind watches_stick[] = {
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 8},
    {.part = TDMF_LARGEST, .into = 10},
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 5},
    {.into = -1},
};
static const tdmf_guard_kind guards_flight_calm[] = {
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
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 8},
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
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 8},
    {.part = TDMF_POSITIVE_INTEGRAL, .into = 5},
    {.into = -1},
};
static const int coordinates_at_apex[] = {38, 39, 40, 41, 42, 43};

static const tdmf_mode_kind modes[] = {
    {.motion = &tdmf_plain_runner_motions[MODE_start_of_run], .open = open_start_of_run,
        .vary_open = vary_open_start_of_run, .guard_count = 1, .guards = guards_start_of_run,
        .watch_count = 0, .usual_count = 0, .watches = watches_start_of_run, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run},
    {.motion = &tdmf_plain_runner_motions[MODE_slip_constant], .open = open_slip_constant,
        .vary_open = vary_open_slip_constant, .guard_count = 6, .guards = guards_slip_constant,
        .watch_count = 4, .usual_count = 2, .watches = watches_slip_constant, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_slip_constant,
        .vary_leave = vary_leave_slip_constant, .from_world = from_world_slip_constant,
        .vary_from_world = vary_from_world_slip_constant, .to_world = to_world_slip_constant,
        .vary_to_world = vary_to_world_slip_constant},
    {.motion = &tdmf_plain_runner_motions[MODE_stick], .open = open_stick, .vary_open = vary_open_stick,
        .guard_count = 7, .guards = guards_stick, .watch_count = 3, .usual_count = 2,
        .watches = watches_stick, .outputs = outputs_start_of_run, .vary_outputs = vary_outputs_start_of_run,
        .leave = leave_stick, .vary_leave = vary_leave_stick, .from_world = from_world_slip_constant,
        .vary_from_world = vary_from_world_slip_constant, .to_world = to_world_slip_constant,
        .vary_to_world = vary_to_world_slip_constant},
    {.motion = &tdmf_plain_runner_motions[MODE_flight_calm], .open = open_flight_calm,
        .vary_open = vary_open_flight_calm, .guard_count = 6, .guards = guards_flight_calm, .watch_count = 3,
        .usual_count = 1, .watches = watches_flight_calm, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run, .leave = leave_start_of_run,
        .vary_leave = vary_leave_start_of_run, .from_world = from_world_flight_calm,
        .vary_from_world = vary_from_world_flight_calm, .to_world = to_world_flight_calm,
        .vary_to_world = vary_to_world_flight_calm},
    {.motion = &tdmf_plain_runner_motions[MODE_fallen], .ends = true, .keeps_outputs = true,
        .open = open_start_of_run, .vary_open = vary_open_start_of_run, .guard_count = 0,
        .guards = guards_fallen, .watch_count = 0, .usual_count = 0, .watches = watches_fallen,
        .outputs = outputs_start_of_run, .vary_outputs = vary_outputs_start_of_run,
        .leave = leave_start_of_run, .vary_leave = vary_leave_start_of_run},
    {.motion = &tdmf_plain_runner_motions[MODE_graze], .open = open_graze, .vary_open = vary_open_graze,
        .guard_count = 8, .guards = guards_graze, .watch_count = 2, .usual_count = 1,
        .watches = watches_graze, .outputs = outputs_start_of_run, .vary_outputs = vary_outputs_start_of_run,
        .leave = leave_graze, .vary_leave = vary_leave_graze, .from_world = from_world_slip_constant,
        .vary_from_world = vary_from_world_slip_constant, .to_world = to_world_slip_constant,
        .vary_to_world = vary_to_world_slip_constant},
};

static const tdmf_set_kind sets[] = {
    {.index = -1},
};
static const tdmf_section_kind sections[] = {
    {.enter = enter_at_apex, .vary_enter = vary_enter_at_apex, .event = EVENT_apex, .count = 6,
        .coordinates = coordinates_at_apex},
    {.event = -1},
};

static const char *const mode_names[] = {"start_of_run", "slip_constant", "stick", "flight_calm", "fallen",
    "graze"};
static const char *const state_names[] = {"time", "events", "last_event", "greatest_slip_velocity",
    "greatest_foot_height", "squared_torque", "is_open", "work_then", "positive_work_so_far",
    "positive_work_then", "peak_force_so_far", "touchdowns_so_far", "slip_so_far", "slid_from",
    "stance_so_far", "word_so_far", "last_letter", "bar_is_due", "mode_began", "x_then", "y_then", "count",
    "word_code", "period", "distance", "rise_of_stride", "work_of_stride", "hip_work", "positive_work",
    "speed", "cost_of_transport", "touchdowns", "stance_time", "duty_factor", "slip_distance", "peak_force",
    "peak_vertical_force", "apex_time", "apex_com_height", "apex_com_speed", "apex_length", "apex_angle",
    "apex_length_rate", "apex_angle_rate", "seen_x", "seen_y", "length", "angle", "seen_vx", "seen_vy",
    "length_rate", "angle_rate", "com_x", "com_y", "com_vx", "com_vy", "momentum", "x", "y", "vx", "vy",
    "foot_x", "foot_vx", "winding", "thrusting", "damper_loss", "friction", "way", "friction_loss",
    "impact_loss", "external_torque", "liftoff_angle", "driving", "swing", "placing", "touchdown_time",
    "has_hopped", "hop_time", "was_placed", "placed_for", "rises_again", "work", "has_fallen"};
static const char *const parameter_names[] = {"body_mass", "foot_mass", "stiffness", "damping", "free_length",
    "least_length", "gravity", "notes_compression", "drive_torque", "kp", "kd", "touchdown_angle",
    "liftoff_factor", "swing_clamp"};
static const char *const event_names[] = {"begins", "falls", "collapses", "apex", "apex_in_graze",
    "touchdown", "clamp", "release", "greatest_compression", "mid_stance", "lift_off", "slips_forward",
    "slips_backward", "comes_to_rest", "graze_to_contact", "graze_to_flight"};
static const char *const output_names[] = {0};
static const char *const table_names[] = {0};
static const char *const section_names[] = {"at_apex"};
static const double state_defaults[] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.4722627765193387, 0.6417114468531165, 0.9999993776846997,
    -0.5462532571145313, 1.062035591761993, -1.9951712441925837e-05, 1.1268102275039307e-06,
    4.039363331769765e-05, 0.0, 1.4, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.6, 1.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double parameter_defaults[] = {1.0, 0.1, 1.0, 0.2, 1.0, 0.05, 0.01, 1.0, 0.2, 0.1, 0.1,
    0.6981317007977318, 1.2, 0.0};
static const double parameter_least[] = {1e-09, 1e-12, 1e-09, 0.0, 1e-06, 1e-09, 1e-09,
    -1.7976931348623157e+308, -1e+18, 0.0, 0.0, -1.5707963267948966, 0.0, -1.7976931348623157e+308};
static const double parameter_most[] = {1000000000.0, 1000000000.0, 1000000000000.0, 1000000000000.0,
    1000000.0, 1000000.0, 1000000.0, 1.7976931348623157e+308, 1e+18, 1e+18, 1e+18, 1.5707963267948966, 100.0,
    1.7976931348623157e+308};

const tdmf_model_kind tdmf_plain_runner_model = {
    .modes = modes,
    .sets = sets,
    .set_count = 0,
    .sections = sections,
    .scales = scales,
    .series_count = 28,
    .constant_count = 19,
    .lanes = {TDMF_TWO_LANES(tdmf_plain_runner_motions_of_2), TDMF_FOUR_LANES(tdmf_plain_runner_motions_of_4),
        TDMF_EIGHT_LANES(tdmf_plain_runner_motions_of_8)},
    .seeds = TDMF_FOR_SEEDS(tdmf_plain_runner_seeds),
    .mode_count = 6,
    .mode_names = mode_names,
    .state_count = 83,
    .state_names = state_names,
    .parameter_count = 14,
    .parameter_names = parameter_names,
    .event_count = 16,
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
