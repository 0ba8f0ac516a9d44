/* Derived from c_core/equations/ground_line.py by equations/derive: edit that, not this. */
#ifndef TDMF_DERIVED_GROUND_LINE_LAWS_H
#define TDMF_DERIVED_GROUND_LINE_LAWS_H

#include "quantities.h"

#include <math.h>

/* t.(x, y), what of a vector is along the line. */
static inline double tdmf_velocity_along(const tdmf_ground_line *line, double x, double y) {
    return line->cosine * x + line->sine * y;
}

/* n.(x, y), what of a vector is across the line. */
static inline double tdmf_velocity_off(const tdmf_ground_line *line, double x, double y) {
    return line->cosine * y - line->sine * x;
}

/* t.(p - (0, h)), from the pivot along the line. */
static inline double tdmf_offset_along(const tdmf_ground_line *line, double x, double y) {
    return line->cosine * x + line->sine * (y - line->height);
}

/* n.(p - (0, h)), the distance from the line, negative below. */
static inline double tdmf_height_over(const tdmf_ground_line *line, double x, double y) {
    return line->cosine * (y - line->height) - line->sine * x;
}

/* h + x tan sigma, the height of the line. */
static inline double tdmf_ground_height_at(const tdmf_ground_line *line, double x) {
    return line->height + x * (line->sine / line->cosine);
}

/* Its change. */
static inline double tdmf_vary_ground_height_at(const tdmf_ground_line *line, double x,
                                                const tdmf_ground_line *d_line, double d_x) {
    return d_line->height +
           (d_x * (line->sine / line->cosine) +
            x * ((line->cosine * d_line->slope - line->sine / line->cosine * -(line->sine * d_line->slope)) /
                 line->cosine));
}

/* The point at a distance from the pivot that moves along the line. */
static inline tdmf_point tdmf_point_on(const tdmf_ground_line *line, double along, double velocity) {
    const tdmf_point result = {
        .x = line->cosine * along,
        .y = line->height + line->sine * along,
        .vx = line->cosine * velocity,
        .vy = line->sine * velocity,
    };
    return result;
}

/* f_t t + f_n n, in horizontal and vertical components. */
static inline tdmf_vector tdmf_vector_on(const tdmf_ground_line *line, tdmf_ground_force force) {
    const tdmf_vector result = {
        .x = force.tangential * line->cosine - force.normal * line->sine,
        .y = force.tangential * line->sine + force.normal * line->cosine,
    };
    return result;
}

/* Its change. */
static inline tdmf_vector tdmf_vary_vector_on(const tdmf_ground_line *line, tdmf_ground_force force,
                                              const tdmf_ground_line *d_line, tdmf_ground_force d_force) {
    const tdmf_vector result = {
        .x = d_force.tangential * line->cosine + force.tangential * -(line->sine * d_line->slope) -
             (d_force.normal * line->sine + force.normal * (line->cosine * d_line->slope)),
        .y = d_force.tangential * line->sine + force.tangential * (line->cosine * d_line->slope) +
             (d_force.normal * line->cosine + force.normal * -(line->sine * d_line->slope)),
    };
    return result;
}

#endif
