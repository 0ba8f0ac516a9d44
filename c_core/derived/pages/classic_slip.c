/* Derived from the page ClassicSlip: edit the page, not this. */
#include "classic_slip.h"

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
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    classic_slip_states *y = (void *)after;
    (void)tables;
    const real sin_of_slope_over_cos_of_slope = real_sin(p->slope) / real_cos(p->slope);
    const real above_ground = x->y_ - sin_of_slope_over_cos_of_slope * x->x_;
    y->apex_x = x->x_;
    y->apex_height = above_ground;
    if (x->vx <= 0.0) {
        return next[0]; /* no_start */
    }
    y->angle = p->touchdown_angle;
    if (x->y_ - p->free_length * real_cos(p->touchdown_angle) - sin_of_slope_over_cos_of_slope * (x->x_
        + p->free_length * real_sin(p->touchdown_angle)) > 0.0) {
        return next[1]; /* flight */
    }
    return next[0]; /* no_start */
}

/* First variation of begins. */
static void vary_react_start_of_run_begins(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    const classic_slip_parameters *dp = (const void *)d_parameters;
    const classic_slip_states *dx = (const void *)d_states;
    classic_slip_states *y = (void *)after;
    (void)tables, (void)seed;
    const real cos_of_slope = real_cos(p->slope);
    const real sin_of_slope = real_sin(p->slope);
    const real sin_of_slope_over_cos_of_slope = sin_of_slope / cos_of_slope;
    const real d_above_ground = dx->y_ - ((cos_of_slope * dp->slope
        + sin_of_slope_over_cos_of_slope * (sin_of_slope * dp->slope)) / cos_of_slope * x->x_
        + sin_of_slope_over_cos_of_slope * dx->x_);
    y->apex_x = dx->x_;
    y->apex_height = d_above_ground;
    if (x->vx <= 0.0) {
        return;
    }
    y->angle = dp->touchdown_angle;
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

/* Constants of flight_down. */
static void open_flight_down(const real *parameters, const real *states, real *constants) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    flight_down_constants *c = (void *)constants;
    const real minus_gravity = -p->gravity;
    const real minus_retraction_rate = -p->retraction_rate;
    const real sin_of_slope_over_cos_of_slope = real_sin(p->slope) / real_cos(p->slope);
    c->vx = x->vx;
    c->minus_gravity = minus_gravity;
    c->minus_retraction_rate = minus_retraction_rate;
    c->free_length = p->free_length;
    c->sin_of_slope_over_cos_of_slope = sin_of_slope_over_cos_of_slope;
}

/* First variation of open_flight_down. */
static void vary_open_flight_down(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_parameters *dp = (const void *)d_parameters;
    const classic_slip_states *dx = (const void *)d_states;
    (void)states;
    flight_down_constants *c = (void *)constants;
    const real d_minus_gravity = -dp->gravity;
    const real d_minus_retraction_rate = -dp->retraction_rate;
    const real cos_of_slope = real_cos(p->slope);
    const real sin_of_slope = real_sin(p->slope);
    const real sin_of_slope_over_cos_of_slope = sin_of_slope / cos_of_slope;
    const real d_sin_of_slope_over_cos_of_slope = (cos_of_slope * dp->slope
        + sin_of_slope_over_cos_of_slope * (sin_of_slope * dp->slope)) / cos_of_slope;
    c->vx = dx->vx;
    c->minus_gravity = d_minus_gravity;
    c->minus_retraction_rate = d_minus_retraction_rate;
    c->free_length = dp->free_length;
    c->sin_of_slope_over_cos_of_slope = d_sin_of_slope_over_cos_of_slope;
}

/* touchdown: The foot reaches the ground. It slides at once outside the friction cone. */
static int react_flight_down_touchdown(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    classic_slip_states *y = (void *)after;
    (void)tables;
    const real cos_of_slope = real_cos(p->slope);
    const real foot_y = x->y_ - p->free_length * real_cos(x->angle);
    const real y__minus_foot_y = x->y_ - foot_y;
    const real sin_of_slope = real_sin(p->slope);
    const real foot_x = x->x_ + p->free_length * real_sin(x->angle);
    const real x__minus_foot_x = x->x_ - foot_x;
    const real off = cos_of_slope * y__minus_foot_y - sin_of_slope * x__minus_foot_x;
    const real along = cos_of_slope * x__minus_foot_x + sin_of_slope * y__minus_foot_y;
    const real abs_of_along_over_off = real_abs(along / off);
    const real foot_vx = x->vx - p->retraction_rate * y__minus_foot_y;
    const real foot_vy = x->vy + p->retraction_rate * x__minus_foot_x;
    const real slip = cos_of_slope * foot_vx + sin_of_slope * foot_vy;
    const real fall = cos_of_slope * foot_vy - sin_of_slope * foot_vx;
    const real abs_of_slip_over_fall = real_abs(slip / fall);
    const real abs_of_along_over_free_length = real_abs(along / p->free_length);
    y->foot_x = foot_x;
    y->foot_y = foot_y;
    y->touchdown_time = x->time;
    y->impact_friction = abs_of_slip_over_fall;
    y->stance_friction = abs_of_along_over_off;
    y->tilt = abs_of_along_over_free_length;
    y->left_early = 0.0;
    if (off <= 0.0) {
        return next[0]; /* fallen */
    }
    if (abs_of_along_over_off > p->friction) {
        return next[1]; /* slides */
    }
    return next[2]; /* stance */
}

/* First variation of touchdown. */
static void vary_react_flight_down_touchdown(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    const classic_slip_parameters *dp = (const void *)d_parameters;
    const classic_slip_states *dx = (const void *)d_states;
    classic_slip_states *y = (void *)after;
    (void)tables, (void)seed;
    const real sin_of_angle = real_sin(x->angle);
    const real cos_of_angle = real_cos(x->angle);
    const real d_foot_x = dx->x_ + (dp->free_length * sin_of_angle
        + p->free_length * (cos_of_angle * dx->angle));
    const real d_foot_y = dx->y_ - (dp->free_length * cos_of_angle
        - p->free_length * (sin_of_angle * dx->angle));
    const real cos_of_slope = real_cos(p->slope);
    const real foot_y = x->y_ - p->free_length * cos_of_angle;
    const real y__minus_foot_y = x->y_ - foot_y;
    const real foot_vx = x->vx - p->retraction_rate * y__minus_foot_y;
    const real sin_of_slope = real_sin(p->slope);
    const real foot_x = x->x_ + p->free_length * sin_of_angle;
    const real x__minus_foot_x = x->x_ - foot_x;
    const real foot_vy = x->vy + p->retraction_rate * x__minus_foot_x;
    const real slip = cos_of_slope * foot_vx + sin_of_slope * foot_vy;
    const real fall = cos_of_slope * foot_vy - sin_of_slope * foot_vx;
    const real slip_over_fall = slip / fall;
    const real y__minus_d_foot_y = dx->y_ - d_foot_y;
    const real d_foot_vx = dx->vx - (dp->retraction_rate * y__minus_foot_y
        + p->retraction_rate * y__minus_d_foot_y);
    const real sin_of_slope_times_slope = sin_of_slope * dp->slope;
    const real cos_of_slope_times_slope = cos_of_slope * dp->slope;
    const real x__minus_d_foot_x = dx->x_ - d_foot_x;
    const real d_foot_vy = dx->vy + (dp->retraction_rate * x__minus_foot_x
        + p->retraction_rate * x__minus_d_foot_x);
    const real d_slip = cos_of_slope * d_foot_vx - sin_of_slope_times_slope * foot_vx
        + (cos_of_slope_times_slope * foot_vy + sin_of_slope * d_foot_vy);
    const real d_fall = cos_of_slope * d_foot_vy - sin_of_slope_times_slope * foot_vy
        - (cos_of_slope_times_slope * foot_vx + sin_of_slope * d_foot_vx);
    const real along = cos_of_slope * x__minus_foot_x + sin_of_slope * y__minus_foot_y;
    const real off = cos_of_slope * y__minus_foot_y - sin_of_slope * x__minus_foot_x;
    const real along_over_off = along / off;
    const real d_along = cos_of_slope * x__minus_d_foot_x - sin_of_slope_times_slope * x__minus_foot_x
        + (cos_of_slope_times_slope * y__minus_foot_y + sin_of_slope * y__minus_d_foot_y);
    const real d_off = cos_of_slope * y__minus_d_foot_y - sin_of_slope_times_slope * y__minus_foot_y
        - (cos_of_slope_times_slope * x__minus_foot_x + sin_of_slope * x__minus_d_foot_x);
    const real along_over_free_length = along / p->free_length;
    y->foot_x = d_foot_x;
    y->foot_y = d_foot_y;
    y->touchdown_time = dx->time;
    y->impact_friction = slip_over_fall / real_abs(slip_over_fall) * ((d_slip
        - slip_over_fall * d_fall) / fall);
    y->stance_friction = along_over_off / real_abs(along_over_off) * ((d_along
        - along_over_off * d_off) / off);
    y->tilt = along_over_free_length / real_abs(along_over_free_length) * ((d_along
        - along_over_free_length * dp->free_length) / p->free_length);
    y->left_early = 0.0;
}

/* First variation of the guard of touchdown. */
static real vary_guard_flight_down_touchdown(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    const classic_slip_parameters *dp = (const void *)d_parameters;
    const classic_slip_states *dx = (const void *)d_states;
    const real cos_of_angle = real_cos(x->angle);
    const real sin_of_angle = real_sin(x->angle);
    const real cos_of_slope = real_cos(p->slope);
    const real sin_of_slope = real_sin(p->slope);
    const real sin_of_slope_over_cos_of_slope = sin_of_slope / cos_of_slope;
    const real d_above_ground = dx->y_ - (dp->free_length * cos_of_angle
        - p->free_length * (sin_of_angle * dx->angle)) - ((cos_of_slope * dp->slope
        + sin_of_slope_over_cos_of_slope * (sin_of_slope * dp->slope)) / cos_of_slope * (x->x_
        + p->free_length * sin_of_angle) + sin_of_slope_over_cos_of_slope * (dx->x_
        + (dp->free_length * sin_of_angle + p->free_length * (cos_of_angle * dx->angle))));
    return d_above_ground;
}

/* falls: The mass reaches the ground. */
static int react_flight_down_falls(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    (void)parameters, (void)states, (void)tables, (void)after;
    return next[0]; /* fallen */
}

/* First variation of falls. */
static void vary_react_flight_down_falls(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const tdmf_table *tables, int seed, real *after) {
    (void)parameters, (void)states, (void)d_parameters, (void)d_states, (void)tables, (void)seed, (void)after;
}

/* First variation of the guard of falls. */
static real vary_guard_flight_down_falls(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    const classic_slip_parameters *dp = (const void *)d_parameters;
    const classic_slip_states *dx = (const void *)d_states;
    const real cos_of_slope = real_cos(p->slope);
    const real sin_of_slope = real_sin(p->slope);
    const real sin_of_slope_over_cos_of_slope = sin_of_slope / cos_of_slope;
    const real d_above_ground = dx->y_ - ((cos_of_slope * dp->slope
        + sin_of_slope_over_cos_of_slope * (sin_of_slope * dp->slope)) / cos_of_slope * x->x_
        + sin_of_slope_over_cos_of_slope * dx->x_);
    return d_above_ground;
}

/* Constants of stance. */
static void open_stance(const real *parameters, const real *states, real *constants) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    stance_constants *c = (void *)constants;
    const real stiffness_over_mass = p->stiffness / p->mass;
    const real free_length_times_free_length = p->free_length * p->free_length;
    const real inverse_by_1_plus_friction = 1.0 / (1.0 + p->friction);
    const real cos_of_slope = real_cos(p->slope);
    const real sin_of_slope = real_sin(p->slope);
    c->stiffness_over_mass = stiffness_over_mass;
    c->free_length = p->free_length;
    c->foot_x = x->foot_x;
    c->foot_y = x->foot_y;
    c->gravity = p->gravity;
    c->free_length_times_free_length = free_length_times_free_length;
    c->friction = p->friction;
    c->inverse_by_1_plus_friction = inverse_by_1_plus_friction;
    c->cos_of_slope = cos_of_slope;
    c->sin_of_slope = sin_of_slope;
}

/* First variation of open_stance. */
static void vary_open_stance(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_parameters *dp = (const void *)d_parameters;
    const classic_slip_states *dx = (const void *)d_states;
    (void)states;
    stance_constants *c = (void *)constants;
    const real stiffness_over_mass = p->stiffness / p->mass;
    const real d_stiffness_over_mass = (dp->stiffness - stiffness_over_mass * dp->mass) / p->mass;
    const real d_free_length_times_free_length = 2.0 * (p->free_length * dp->free_length);
    const real by_1_plus_friction = 1.0 + p->friction;
    const real inverse_by_1_plus_friction = 1.0 / by_1_plus_friction;
    const real d_inverse_by_1_plus_friction = -(inverse_by_1_plus_friction * dp->friction /
        by_1_plus_friction);
    const real sin_of_slope = real_sin(p->slope);
    const real d_cos_of_slope = -(sin_of_slope * dp->slope);
    const real cos_of_slope = real_cos(p->slope);
    const real d_sin_of_slope = cos_of_slope * dp->slope;
    c->stiffness_over_mass = d_stiffness_over_mass;
    c->free_length = dp->free_length;
    c->foot_x = dx->foot_x;
    c->foot_y = dx->foot_y;
    c->gravity = dp->gravity;
    c->free_length_times_free_length = d_free_length_times_free_length;
    c->friction = dp->friction;
    c->inverse_by_1_plus_friction = d_inverse_by_1_plus_friction;
    c->cos_of_slope = d_cos_of_slope;
    c->sin_of_slope = d_sin_of_slope;
}

/* take_off: The spring is relaxed. */
static int react_stance_take_off(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const classic_slip_states *x = (const void *)states;
    classic_slip_states *y = (void *)after;
    (void)parameters, (void)tables;
    const real time_minus_touchdown_time = x->time - x->touchdown_time;
    const real squared_cosine = 1.0 - x->tilt * x->tilt;
    const real cosine = real_sqrt(select(squared_cosine > 1e-18, squared_cosine, 1e-18));
    const real tilt_over_cosine = x->tilt / cosine;
    y->stance_time = time_minus_touchdown_time;
    y->stance_friction = tilt_over_cosine;
    if (x->vy <= 0.0) {
        return next[0]; /* fallen */
    }
    return next[1]; /* flight */
}

/* First variation of take_off. */
static void vary_react_stance_take_off(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const classic_slip_states *x = (const void *)states;
    const classic_slip_states *dx = (const void *)d_states;
    classic_slip_states *y = (void *)after;
    (void)parameters, (void)d_parameters, (void)tables, (void)seed;
    const real squared_cosine = 1.0 - x->tilt * x->tilt;
    const real cosine = real_sqrt(select(squared_cosine > 1e-18, squared_cosine, 1e-18));
    const real d_squared_cosine = -(2.0 * (x->tilt * dx->tilt));
    const real d_cosine = 0.5 * select(squared_cosine > 1e-18, d_squared_cosine, 0.0) / cosine;
    y->stance_time = dx->time - dx->touchdown_time;
    y->stance_friction = (dx->tilt - x->tilt / cosine * d_cosine) / cosine;
}

/* First variation of the guard of take_off. */
static real vary_guard_stance_take_off(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    const classic_slip_parameters *dp = (const void *)d_parameters;
    const classic_slip_states *dx = (const void *)d_states;
    return 2.0 * (p->free_length * dp->free_length) - 2.0 * ((x->x_ - x->foot_x) * (dx->x_ - dx->foot_x))
        - 2.0 * ((x->y_ - x->foot_y) * (dx->y_ - dx->foot_y));
}

/* leaves_cone: The leg reaches theta = -arctan mu: the energy left in the spring is lost. */
static int react_stance_leaves_cone(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const classic_slip_states *x = (const void *)states;
    classic_slip_states *y = (void *)after;
    (void)parameters, (void)tables;
    const real time_minus_touchdown_time = x->time - x->touchdown_time;
    const real squared_cosine = 1.0 - x->tilt * x->tilt;
    const real cosine = real_sqrt(select(squared_cosine > 1e-18, squared_cosine, 1e-18));
    const real tilt_over_cosine = x->tilt / cosine;
    y->stance_time = time_minus_touchdown_time;
    y->stance_friction = tilt_over_cosine;
    y->left_early = 1.0;
    if (x->vy <= 0.0) {
        return next[0]; /* fallen */
    }
    return next[1]; /* flight */
}

/* First variation of leaves_cone. */
static void vary_react_stance_leaves_cone(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const classic_slip_states *x = (const void *)states;
    const classic_slip_states *dx = (const void *)d_states;
    classic_slip_states *y = (void *)after;
    (void)parameters, (void)d_parameters, (void)tables, (void)seed;
    const real squared_cosine = 1.0 - x->tilt * x->tilt;
    const real cosine = real_sqrt(select(squared_cosine > 1e-18, squared_cosine, 1e-18));
    const real d_squared_cosine = -(2.0 * (x->tilt * dx->tilt));
    const real d_cosine = 0.5 * select(squared_cosine > 1e-18, d_squared_cosine, 0.0) / cosine;
    y->stance_time = dx->time - dx->touchdown_time;
    y->stance_friction = (dx->tilt - x->tilt / cosine * d_cosine) / cosine;
    y->left_early = 0.0;
}

/* First variation of the guard of leaves_cone. */
static real vary_guard_stance_leaves_cone(const real *parameters, const real *states,
    const real *d_parameters, const real *d_states) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    const classic_slip_parameters *dp = (const void *)d_parameters;
    const classic_slip_states *dx = (const void *)d_states;
    const real cos_of_slope = real_cos(p->slope);
    const real y__minus_foot_y = x->y_ - x->foot_y;
    const real sin_of_slope = real_sin(p->slope);
    const real x__minus_foot_x = x->x_ - x->foot_x;
    const real off = cos_of_slope * y__minus_foot_y - sin_of_slope * x__minus_foot_x;
    const real y__minus_foot_y_2 = dx->y_ - dx->foot_y;
    const real sin_of_slope_times_slope = sin_of_slope * dp->slope;
    const real cos_of_slope_times_slope = cos_of_slope * dp->slope;
    const real x__minus_foot_x_2 = dx->x_ - dx->foot_x;
    const real d_off = cos_of_slope * y__minus_foot_y_2 - sin_of_slope_times_slope * y__minus_foot_y
        - (cos_of_slope_times_slope * x__minus_foot_x + sin_of_slope * x__minus_foot_x_2);
    const real d_along = cos_of_slope * x__minus_foot_x_2 - sin_of_slope_times_slope * x__minus_foot_x
        + (cos_of_slope_times_slope * y__minus_foot_y + sin_of_slope * y__minus_foot_y_2);
    const real along = cos_of_slope * x__minus_foot_x + sin_of_slope * y__minus_foot_y;
    const real by_1_plus_friction = 1.0 + p->friction;
    const real in_cone = (p->friction * off - along) / by_1_plus_friction;
    const real d_in_cone = (dp->friction * off + p->friction * d_off - d_along
        - in_cone * dp->friction) / by_1_plus_friction;
    return d_in_cone;
}

/* slides_out: The leg turns back and leaves the friction cone. */
static int react_stance_slides_out(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const classic_slip_states *x = (const void *)states;
    classic_slip_states *y = (void *)after;
    (void)parameters, (void)tables;
    const real squared_cosine = 1.0 - x->tilt * x->tilt;
    const real cosine = real_sqrt(select(squared_cosine > 1e-18, squared_cosine, 1e-18));
    y->stance_time = x->time - x->touchdown_time;
    y->stance_friction = x->tilt / cosine;
    return next[0]; /* slides */
}

/* First variation of the guard of slides_out. */
static real vary_guard_stance_slides_out(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    const classic_slip_parameters *dp = (const void *)d_parameters;
    const classic_slip_states *dx = (const void *)d_states;
    const real cos_of_slope = real_cos(p->slope);
    const real y__minus_foot_y = x->y_ - x->foot_y;
    const real sin_of_slope = real_sin(p->slope);
    const real x__minus_foot_x = x->x_ - x->foot_x;
    const real off = cos_of_slope * y__minus_foot_y - sin_of_slope * x__minus_foot_x;
    const real y__minus_foot_y_2 = dx->y_ - dx->foot_y;
    const real sin_of_slope_times_slope = sin_of_slope * dp->slope;
    const real cos_of_slope_times_slope = cos_of_slope * dp->slope;
    const real x__minus_foot_x_2 = dx->x_ - dx->foot_x;
    const real d_off = cos_of_slope * y__minus_foot_y_2 - sin_of_slope_times_slope * y__minus_foot_y
        - (cos_of_slope_times_slope * x__minus_foot_x + sin_of_slope * x__minus_foot_x_2);
    const real d_along = cos_of_slope * x__minus_foot_x_2 - sin_of_slope_times_slope * x__minus_foot_x
        + (cos_of_slope_times_slope * y__minus_foot_y + sin_of_slope * y__minus_foot_y_2);
    const real along = cos_of_slope * x__minus_foot_x + sin_of_slope * y__minus_foot_y;
    const real by_1_plus_friction = 1.0 + p->friction;
    const real in_cone = (p->friction * off + along) / by_1_plus_friction;
    const real d_in_cone = (dp->friction * off + p->friction * d_off + d_along
        - in_cone * dp->friction) / by_1_plus_friction;
    return d_in_cone;
}

/* First variation of the guard of collapses. */
static real vary_guard_stance_collapses(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    const classic_slip_parameters *dp = (const void *)d_parameters;
    const classic_slip_states *dx = (const void *)d_states;
    const real cos_of_slope = real_cos(p->slope);
    const real sin_of_slope = real_sin(p->slope);
    const real d_off = cos_of_slope * (dx->y_ - dx->foot_y) - sin_of_slope * dp->slope * (x->y_ - x->foot_y)
        - (cos_of_slope * dp->slope * (x->x_ - x->foot_x) + sin_of_slope * (dx->x_ - dx->foot_x));
    return d_off;
}

/* Constants of flight_up. */
static void open_flight_up(const real *parameters, const real *states, real *constants) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    flight_up_constants *c = (void *)constants;
    const real minus_gravity = -p->gravity;
    const real sin_of_slope_over_cos_of_slope = real_sin(p->slope) / real_cos(p->slope);
    c->vx = x->vx;
    c->minus_gravity = minus_gravity;
    c->sin_of_slope_over_cos_of_slope = sin_of_slope_over_cos_of_slope;
}

/* First variation of open_flight_up. */
static void vary_open_flight_up(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, real *constants) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_parameters *dp = (const void *)d_parameters;
    const classic_slip_states *dx = (const void *)d_states;
    (void)states;
    flight_up_constants *c = (void *)constants;
    const real d_minus_gravity = -dp->gravity;
    const real cos_of_slope = real_cos(p->slope);
    const real sin_of_slope = real_sin(p->slope);
    const real sin_of_slope_over_cos_of_slope = sin_of_slope / cos_of_slope;
    const real d_sin_of_slope_over_cos_of_slope = (cos_of_slope * dp->slope
        + sin_of_slope_over_cos_of_slope * (sin_of_slope * dp->slope)) / cos_of_slope;
    c->vx = dx->vx;
    c->minus_gravity = d_minus_gravity;
    c->sin_of_slope_over_cos_of_slope = d_sin_of_slope_over_cos_of_slope;
}

/* apex: The mass rises no more, and the leg is put to its angle. */
static int react_flight_up_apex(const real *parameters, const real *states, const tdmf_table *tables,
    real *after, const int *next) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    classic_slip_states *y = (void *)after;
    (void)tables;
    const real sin_of_slope_over_cos_of_slope = real_sin(p->slope) / real_cos(p->slope);
    const real above_ground = x->y_ - sin_of_slope_over_cos_of_slope * x->x_;
    const real energy = p->mass * (0.5 * (x->vx * x->vx) + p->gravity * above_ground);
    const real x__minus_apex_x = x->x_ - x->apex_x;
    y->angle = p->touchdown_angle;
    y->apex_x = x->x_;
    y->apex_height = above_ground;
    y->apex_energy = energy;
    y->step_length = x__minus_apex_x;
    if (x->y_ - p->free_length * real_cos(p->touchdown_angle) - sin_of_slope_over_cos_of_slope * (x->x_
        + p->free_length * real_sin(p->touchdown_angle)) > 0.0) {
        return next[0]; /* flight */
    }
    return next[1]; /* no_start */
}

/* First variation of apex. */
static void vary_react_flight_up_apex(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const tdmf_table *tables, int seed, real *after) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_states *x = (const void *)states;
    const classic_slip_parameters *dp = (const void *)d_parameters;
    const classic_slip_states *dx = (const void *)d_states;
    classic_slip_states *y = (void *)after;
    (void)tables, (void)seed;
    const real cos_of_slope = real_cos(p->slope);
    const real sin_of_slope = real_sin(p->slope);
    const real sin_of_slope_over_cos_of_slope = sin_of_slope / cos_of_slope;
    const real d_above_ground = dx->y_ - ((cos_of_slope * dp->slope
        + sin_of_slope_over_cos_of_slope * (sin_of_slope * dp->slope)) / cos_of_slope * x->x_
        + sin_of_slope_over_cos_of_slope * dx->x_);
    const real above_ground = x->y_ - sin_of_slope_over_cos_of_slope * x->x_;
    const real d_energy = dp->mass * (0.5 * (x->vx * x->vx) + p->gravity * above_ground)
        + p->mass * (0.5 * (2.0 * (x->vx * dx->vx)) + (dp->gravity * above_ground
        + p->gravity * d_above_ground));
    y->angle = dp->touchdown_angle;
    y->apex_x = dx->x_;
    y->apex_height = d_above_ground;
    y->apex_energy = d_energy;
    y->step_length = dx->x_ - dx->apex_x;
}

/* First variation of the guard of apex. */
static real vary_guard_flight_up_apex(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states) {
    const classic_slip_states *dx = (const void *)d_states;
    (void)parameters, (void)states, (void)d_parameters;
    return dx->vy;
}

/* at_energy: Apices of the energy `energy`. */
static void enter_at_energy(const real *parameters, const real *states, const real *at, real *after) {
    const classic_slip_parameters *p = (const void *)parameters;
    classic_slip_states *y = (void *)after;
    (void)states;
    const real at_apex_height = at[0];
    const real kinetic = p->energy / p->mass - p->gravity * at_apex_height;
    const real speed = real_sqrt(2.0 * select(kinetic > 0.0, kinetic, 0.0));
    y->y_ = at_apex_height;
    y->vx = speed;
    y->vy = 0.0;
    y->angle = p->touchdown_angle;
}

/* First variation of enter_at_energy. */
static void vary_enter_at_energy(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const real *at, const real *d_at, real *after) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_parameters *dp = (const void *)d_parameters;
    classic_slip_states *y = (void *)after;
    (void)states, (void)d_states;
    const real at_apex_height = at[0];
    const real d_at_apex_height = d_at[0];
    const real energy_over_mass = p->energy / p->mass;
    const real kinetic = energy_over_mass - p->gravity * at_apex_height;
    const real d_kinetic = (dp->energy - energy_over_mass * dp->mass) / p->mass
        - (dp->gravity * at_apex_height + p->gravity * d_at_apex_height);
    const real speed = real_sqrt(2.0 * select(kinetic > 0.0, kinetic, 0.0));
    const real d_speed = 0.5 * (2.0 * select(kinetic > 0.0, d_kinetic, 0.0)) / speed;
    y->y_ = d_at_apex_height;
    y->vx = d_speed;
    y->vy = 0.0;
    y->angle = dp->touchdown_angle;
}

/* at_apex: All apices. */
static void enter_at_apex(const real *parameters, const real *states, const real *at, real *after) {
    const classic_slip_parameters *p = (const void *)parameters;
    classic_slip_states *y = (void *)after;
    (void)states;
    const real at_apex_height = at[0];
    const real at_apex_energy = at[1];
    const real kinetic = at_apex_energy / p->mass - p->gravity * at_apex_height;
    const real speed = real_sqrt(2.0 * select(kinetic > 0.0, kinetic, 0.0));
    y->y_ = at_apex_height;
    y->vx = speed;
    y->vy = 0.0;
    y->angle = p->touchdown_angle;
}

/* First variation of enter_at_apex. */
static void vary_enter_at_apex(const real *parameters, const real *states, const real *d_parameters,
    const real *d_states, const real *at, const real *d_at, real *after) {
    const classic_slip_parameters *p = (const void *)parameters;
    const classic_slip_parameters *dp = (const void *)d_parameters;
    classic_slip_states *y = (void *)after;
    (void)states, (void)d_states;
    const real at_apex_height = at[0];
    const real at_apex_energy = at[1];
    const real d_at_apex_height = d_at[0];
    const real d_at_apex_energy = d_at[1];
    const real at_apex_energy_over_mass = at_apex_energy / p->mass;
    const real kinetic = at_apex_energy_over_mass - p->gravity * at_apex_height;
    const real d_kinetic = (d_at_apex_energy - at_apex_energy_over_mass * dp->mass) / p->mass
        - (dp->gravity * at_apex_height + p->gravity * d_at_apex_height);
    const real speed = real_sqrt(2.0 * select(kinetic > 0.0, kinetic, 0.0));
    const real d_speed = 0.5 * (2.0 * select(kinetic > 0.0, d_kinetic, 0.0)) / speed;
    y->y_ = d_at_apex_height;
    y->vx = d_speed;
    y->vy = 0.0;
    y->angle = dp->touchdown_angle;
}

/* Typical size of each state and guard. */
static void scales(const real *parameters, real *of_states, real *of_events) {
    const classic_slip_parameters *p = (const void *)parameters;
    of_states[0] = real_sqrt(p->mass / p->stiffness);
    of_states[1] = p->free_length;
    of_states[2] = p->free_length;
    of_states[3] = p->free_length * real_sqrt(p->stiffness / p->mass);
    of_states[4] = p->free_length * real_sqrt(p->stiffness / p->mass);
    of_states[5] = 1.0;
    of_states[6] = p->free_length;
    of_states[7] = p->free_length;
    of_states[8] = real_sqrt(p->mass / p->stiffness);
    of_states[9] = real_sqrt(p->mass / p->stiffness);
    of_states[10] = 1.0;
    of_states[11] = 1.0;
    of_states[12] = 1.0;
    of_states[13] = 1.0;
    of_states[14] = p->free_length;
    of_states[15] = p->free_length;
    of_states[16] = p->stiffness * p->free_length * p->free_length;
    of_states[17] = p->free_length;
    of_events[EVENT_begins] = 1.0;
    of_events[EVENT_touchdown] = p->free_length;
    of_events[EVENT_falls] = p->free_length;
    of_events[EVENT_take_off] = p->free_length * p->free_length;
    of_events[EVENT_leaves_cone] = p->free_length;
    of_events[EVENT_slides_out] = p->free_length;
    of_events[EVENT_collapses] = p->free_length;
    of_events[EVENT_apex] = p->free_length * real_sqrt(p->stiffness / p->mass);
}

static const tdmf_guard_kind guards_start_of_run[] = {
    {.event = EVENT_begins, .react = react_start_of_run_begins, .vary_react = vary_react_start_of_run_begins,
        .vary_guard = vary_guard_start_of_run_begins, .next = {MODE_no_start, MODE_flight_down}},
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
static const tdmf_guard_kind guards_flight_down[] = {
    {.event = EVENT_touchdown, .is_counted = true, .react = react_flight_down_touchdown,
        .vary_react = vary_react_flight_down_touchdown, .vary_guard = vary_guard_flight_down_touchdown,
        .next = {MODE_fallen, MODE_slides, MODE_stance}},
    {.event = EVENT_falls, .is_counted = true, .react = react_flight_down_falls,
        .vary_react = vary_react_flight_down_falls, .looks_again = true,
        .vary_guard = vary_guard_flight_down_falls, .next = {MODE_fallen}},
    {.event = -1},
};
static const tdmf_watch_kind watches_flight_down[] = {
    {.into = -1},
};
static const tdmf_guard_kind guards_fallen[] = {
    {.event = -1},
};
static const tdmf_watch_kind watches_fallen[] = {
    {.into = -1},
};
static const tdmf_guard_kind guards_slides[] = {
    {.event = -1},
};
static const tdmf_watch_kind watches_slides[] = {
    {.into = -1},
};
static const tdmf_guard_kind guards_stance[] = {
    {.event = EVENT_take_off, .is_counted = true, .react = react_stance_take_off,
        .vary_react = vary_react_stance_take_off, .vary_guard = vary_guard_stance_take_off,
        .next = {MODE_fallen, MODE_flight_up}},
    {.event = EVENT_leaves_cone, .is_counted = true, .react = react_stance_leaves_cone,
        .vary_react = vary_react_stance_leaves_cone, .vary_guard = vary_guard_stance_leaves_cone,
        .next = {MODE_fallen, MODE_flight_up}},
    {.event = EVENT_slides_out, .is_counted = true, .react = react_stance_slides_out,
        .vary_react = vary_react_stance_take_off, .looks_again = true,
        .vary_guard = vary_guard_stance_slides_out, .next = {MODE_slides}},
    {.event = EVENT_collapses, .is_counted = true, .react = react_flight_down_falls,
        .vary_react = vary_react_flight_down_falls, .looks_again = true,
        .vary_guard = vary_guard_stance_collapses, .next = {MODE_fallen}},
    {.event = -1},
};
static const tdmf_watch_kind watches_stance[] = {
    {.part = TDMF_LARGEST, .into = 12},
    {.part = TDMF_LARGEST, .into = 12},
    {.into = -1},
};
static const tdmf_guard_kind guards_flight_up[] = {
    {.event = EVENT_falls, .is_counted = true, .react = react_flight_down_falls,
        .vary_react = vary_react_flight_down_falls, .looks_again = true,
        .vary_guard = vary_guard_flight_down_falls, .next = {MODE_fallen}},
    {.event = EVENT_apex, .is_counted = true, .react = react_flight_up_apex,
        .vary_react = vary_react_flight_up_apex, .vary_guard = vary_guard_flight_up_apex,
        .next = {MODE_flight_down, MODE_no_start}},
    {.event = -1},
};
static const tdmf_watch_kind watches_flight_up[] = {
    {.into = -1},
};
static const int coordinates_at_energy[] = {15};
static const int coordinates_at_apex[] = {15, 16};

static const tdmf_mode_kind modes[] = {
    {.motion = &tdmf_classic_slip_motions[MODE_start_of_run], .open = open_start_of_run,
        .vary_open = vary_open_start_of_run, .guard_count = 1, .guards = guards_start_of_run,
        .watch_count = 0, .usual_count = 0, .watches = watches_start_of_run, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run},
    {.motion = &tdmf_classic_slip_motions[MODE_no_start], .ends = true, .open = open_start_of_run,
        .vary_open = vary_open_start_of_run, .guard_count = 0, .guards = guards_no_start, .watch_count = 0,
        .usual_count = 0, .watches = watches_no_start, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run},
    {.motion = &tdmf_classic_slip_motions[MODE_flight_down], .open = open_flight_down,
        .vary_open = vary_open_flight_down, .guard_count = 2, .guards = guards_flight_down, .watch_count = 0,
        .usual_count = 0, .watches = watches_flight_down, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run},
    {.motion = &tdmf_classic_slip_motions[MODE_fallen], .ends = true, .open = open_start_of_run,
        .vary_open = vary_open_start_of_run, .guard_count = 0, .guards = guards_fallen, .watch_count = 0,
        .usual_count = 0, .watches = watches_fallen, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run},
    {.motion = &tdmf_classic_slip_motions[MODE_slides], .ends = true, .open = open_start_of_run,
        .vary_open = vary_open_start_of_run, .guard_count = 0, .guards = guards_slides, .watch_count = 0,
        .usual_count = 0, .watches = watches_slides, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run},
    {.motion = &tdmf_classic_slip_motions[MODE_stance], .open = open_stance, .vary_open = vary_open_stance,
        .guard_count = 4, .guards = guards_stance, .watch_count = 2, .usual_count = 2,
        .watches = watches_stance, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run},
    {.motion = &tdmf_classic_slip_motions[MODE_flight_up], .open = open_flight_up,
        .vary_open = vary_open_flight_up, .guard_count = 2, .guards = guards_flight_up, .watch_count = 0,
        .usual_count = 0, .watches = watches_flight_up, .outputs = outputs_start_of_run,
        .vary_outputs = vary_outputs_start_of_run},
};

static const tdmf_set_kind sets[] = {
    {.index = -1},
};
static const tdmf_section_kind sections[] = {
    {.enter = enter_at_energy, .vary_enter = vary_enter_at_energy, .event = EVENT_apex, .count = 1,
        .coordinates = coordinates_at_energy},
    {.enter = enter_at_apex, .vary_enter = vary_enter_at_apex, .event = EVENT_apex, .count = 2,
        .coordinates = coordinates_at_apex},
    {.event = -1},
};

static const char *const mode_names[] = {"start_of_run", "no_start", "flight_down", "fallen", "slides",
    "stance", "flight_up"};
static const char *const state_names[] = {"time", "x", "y", "vx", "vy", "angle", "foot_x", "foot_y",
    "touchdown_time", "stance_time", "impact_friction", "stance_friction", "tilt", "left_early", "apex_x",
    "apex_height", "apex_energy", "step_length"};
static const char *const parameter_names[] = {"mass", "stiffness", "free_length", "gravity",
    "touchdown_angle", "retraction_rate", "friction", "slope", "energy"};
static const char *const event_names[] = {"begins", "touchdown", "falls", "take_off", "leaves_cone",
    "slides_out", "collapses", "apex"};
static const char *const output_names[] = {0};
static const char *const table_names[] = {0};
static const char *const section_names[] = {"at_energy", "at_apex"};
static const double state_defaults[] = {0.0, 0.0, 1.04, 5.0, 0.0, 0.6981317007977318, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
static const double parameter_defaults[] = {80.0, 20000.0, 1.0, 9.81, 0.6981317007977318, 0.0, 1000000000.0,
    0.0, 6000.0};
static const double parameter_least[] = {1e-09, 1e-09, 1e-06, 1e-09, -1.5707963267948963, -1000000000.0, 0.0,
    -0.9999999999999999, 0.0};
static const double parameter_most[] = {1000000000.0, 1000000000000.0, 1000000.0, 1000000.0,
    1.5707963267948963, 1000000000.0, 1000000000.0, 0.9999999999999999, 1.7976931348623157e+308};

const tdmf_model_kind tdmf_classic_slip_model = {
    .modes = modes,
    .sets = sets,
    .set_count = 0,
    .sections = sections,
    .scales = scales,
    .series_count = 13,
    .constant_count = 10,
    .lanes = {TDMF_TWO_LANES(tdmf_classic_slip_motions_of_2), TDMF_FOUR_LANES(tdmf_classic_slip_motions_of_4),
        TDMF_EIGHT_LANES(tdmf_classic_slip_motions_of_8)},
    .seeds = TDMF_FOR_SEEDS(tdmf_classic_slip_seeds),
    .mode_count = 7,
    .mode_names = mode_names,
    .state_count = 18,
    .state_names = state_names,
    .parameter_count = 9,
    .parameter_names = parameter_names,
    .event_count = 8,
    .event_names = event_names,
    .output_count = 0,
    .output_names = output_names,
    .table_count = 0,
    .table_names = table_names,
    .section_count = 2,
    .section_names = section_names,
    .state_defaults = state_defaults,
    .parameter_defaults = parameter_defaults,
    .parameter_least = parameter_least,
    .parameter_most = parameter_most,
};
