/* Derived from c_core/equations/classic_slip.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_CLASSIC_SLIP_LAWS_H
#define TDMF_DERIVED_CLASSIC_SLIP_LAWS_H

#include "quantities.h"

#include <math.h>

/* v = sqrt(2 (E/m - g h)). */
static inline double tdmf_classic_speed(const tdmf_classic *slip, double energy, double height) {
    return sqrt(2.0 * (energy / slip->mass - slip->gravity * height));
}

/* Its change. */
static inline double tdmf_vary_classic_speed(const tdmf_classic *slip, double energy, double height,
                                             const tdmf_classic *d_slip, double d_energy, double d_height) {
    return 0.5 *
           (2.0 * ((d_energy - energy / slip->mass * d_slip->mass) / slip->mass -
                   (d_slip->gravity * height + slip->gravity * d_height))) /
           sqrt(2.0 * (energy / slip->mass - slip->gravity * height));
}

/* -l0 sin phi, l0 cos phi, v, -g t: the mass where the foot comes down at that time. */
static inline tdmf_classic_point tdmf_classic_landing(const tdmf_classic *slip, double speed, double time) {
    const double angle = slip->touchdown_angle - slip->retraction_rate * time;
    const tdmf_classic_point result = {
        .x = -(slip->free_length * sin(angle)),
        .y = slip->free_length * cos(angle),
        .vx = speed,
        .vy = -(slip->gravity * time),
    };
    return result;
}

/* Its change. */
static inline tdmf_classic_point tdmf_vary_classic_landing(const tdmf_classic *slip, double speed,
                                                           double time, const tdmf_classic *d_slip,
                                                           double d_speed, double d_time) {
    (void)speed;
    const double angle = slip->touchdown_angle - slip->retraction_rate * time;
    const double d_angle =
        d_slip->touchdown_angle - (d_slip->retraction_rate * time + slip->retraction_rate * d_time);
    const tdmf_classic_point result = {
        .x = -(d_slip->free_length * sin(angle) + slip->free_length * (cos(angle) * d_angle)),
        .y = d_slip->free_length * cos(angle) + slip->free_length * -(sin(angle) * d_angle),
        .vx = d_speed,
        .vy = -(d_slip->gravity * time + slip->gravity * d_time),
    };
    return result;
}

/* v t + l0 sin phi, how far the foot is ahead of the apex. */
static inline double tdmf_classic_foot_from_apex(double speed, double time, tdmf_classic_point point) {
    return speed * time - point.x;
}

/* Its change. */
static inline double tdmf_vary_classic_foot_from_apex(double speed, double time, tdmf_classic_point point,
                                                      double d_speed, double d_time,
                                                      tdmf_classic_point d_point) {
    (void)point;
    return d_speed * time + speed * d_time - d_point.x;
}

/* F = h - g t^2/2 - l0 cos phi - (v t + l0 sin phi) tan sigma: the foot comes down where F falls to 0. */
static inline double tdmf_classic_clearance(const tdmf_classic *slip, const tdmf_ground_line *line,
                                            double height, double speed, double time) {
    const double fallen = 0.5 * (slip->gravity * time * time);
    const double angle = slip->touchdown_angle - slip->retraction_rate * time;
    const double y = slip->free_length * cos(angle);
    return height - fallen - y -
           (speed * time + slip->free_length * sin(angle)) * (line->sine / line->cosine);
}

/* Its change. */
static inline double tdmf_vary_classic_clearance(const tdmf_classic *slip, const tdmf_ground_line *line,
                                                 double height, double speed, double time,
                                                 const tdmf_classic *d_slip, const tdmf_ground_line *d_line,
                                                 double d_height, double d_speed, double d_time) {
    (void)height;
    const double d_fallen =
        0.5 * ((d_slip->gravity * time + slip->gravity * d_time) * time + slip->gravity * time * d_time);
    const double angle = slip->touchdown_angle - slip->retraction_rate * time;
    const double d_angle =
        d_slip->touchdown_angle - (d_slip->retraction_rate * time + slip->retraction_rate * d_time);
    const double d_y = d_slip->free_length * cos(angle) + slip->free_length * -(sin(angle) * d_angle);
    return d_height - d_fallen - d_y -
           ((d_speed * time + speed * d_time +
             (d_slip->free_length * sin(angle) + slip->free_length * (cos(angle) * d_angle))) *
                (line->sine / line->cosine) +
            (speed * time + slip->free_length * sin(angle)) *
                ((line->cosine * d_line->slope - line->sine / line->cosine * -(line->sine * d_line->slope)) /
                 line->cosine));
}

/* The velocity of the foot of a leg that turns back as it comes down. */
static inline tdmf_vector tdmf_classic_foot_velocity(const tdmf_classic *slip, tdmf_classic_point point) {
    const tdmf_vector result = {
        .x = point.vx - slip->retraction_rate * point.y,
        .y = point.vy + slip->retraction_rate * point.x,
    };
    return result;
}

/* The apex after a take-off: its height over the ground below, its energy there, and the step's length.
 *
 * The mass rises by vy^2/(2 g), and goes vx vy/g ahead. */
static inline tdmf_classic_variation tdmf_classic_next_apex(const tdmf_classic *slip,
                                                            const tdmf_ground_line *line,
                                                            tdmf_classic_point point, double foot_x) {
    const double ahead = point.x + point.vx * point.vy / slip->gravity;
    const double height =
        point.y + point.vy * point.vy / (2.0 * slip->gravity) - line->sine / line->cosine * ahead;
    const tdmf_classic_variation result = {
        .height = height,
        .energy = slip->mass * (0.5 * (point.vx * point.vx) + slip->gravity * height),
        .length = foot_x + ahead,
    };
    return result;
}

/* Its change. */
static inline tdmf_classic_variation
tdmf_vary_classic_next_apex(const tdmf_classic *slip, const tdmf_ground_line *line, tdmf_classic_point point,
                            double foot_x, const tdmf_classic *d_slip, const tdmf_ground_line *d_line,
                            tdmf_classic_point d_point, double d_foot_x) {
    (void)foot_x;
    const double ahead = point.x + point.vx * point.vy / slip->gravity;
    const double d_ahead = d_point.x + (d_point.vx * point.vy + point.vx * d_point.vy -
                                        point.vx * point.vy / slip->gravity * d_slip->gravity) /
                                           slip->gravity;
    const double d_height =
        d_point.y +
        (2.0 * (point.vy * d_point.vy) -
         point.vy * point.vy / (2.0 * slip->gravity) * (2.0 * d_slip->gravity)) /
            (2.0 * slip->gravity) -
        ((line->cosine * d_line->slope - line->sine / line->cosine * -(line->sine * d_line->slope)) /
             line->cosine * ahead +
         line->sine / line->cosine * d_ahead);
    const double height =
        point.y + point.vy * point.vy / (2.0 * slip->gravity) - line->sine / line->cosine * ahead;
    const tdmf_classic_variation result = {
        .height = d_height,
        .energy = d_slip->mass * (0.5 * (point.vx * point.vx) + slip->gravity * height) +
                  slip->mass * (0.5 * (2.0 * (point.vx * d_point.vx)) +
                                (d_slip->gravity * height + slip->gravity * d_height)),
        .length = d_foot_x + d_ahead,
    };
    return result;
}

#endif
