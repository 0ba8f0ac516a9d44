/* A step of flight: its size, and where it leads. */
#ifndef TDMF_KERNEL_FLIGHT_STEP_H
#define TDMF_KERNEL_FLIGHT_STEP_H

#include "guard_series.h"
#include "mode_constants.h"
#include "motion_ends.h"
#include "step_size.h"
#include "step_sums.h"

typedef struct {
    flight_start leg;
    energy_sums done;
} flight_coordinates;

typedef struct {
    mode_constants mode;
    flight_coefficients law;
    real body_share;     /* of the mass */
    real slope;          /* of the ground */
    real normal_gravity; /* away from it */
    signed_law servo;    /* where clamped: the sign of its torque decides the clamp; with the present sign */
    real new_slope, new_normal_gravity; /* of a ground that waits to be in force */
} flight_constants;

/* Which events and terms there are. A leg whose torque is clamped rises. */
typedef struct {
    bool rising, clamped, awaits_ground, forced;
} flight_case;

/* The height of a point above a line, and its rate. */
typedef struct {
    real height, rate;
} height_above;

/* The centre of mass: above the ground, vertically, and above a ground that waits to be in force. Where the
 * push on the body ramps, the acceleration away from each of them changes. */
typedef struct {
    height_above ground;
    real rise_rate;
    height_above new_ground;
    real normal_jerk, rise_jerk, new_normal_jerk;
} ballistic;

/* Gives a height some time later. */
static inline height_above height_after(height_above from, real gravity, real elapsed) {
    const height_above to = {from.height + elapsed * (from.rate - 0.5 * gravity * elapsed),
                             from.rate - gravity * elapsed};
    return to;
}

/* Expands the motion and returns how far it may be trusted; `longest` is what its law allows. */
static inline real expand_flight_step(const flight_constants *c, const flight_coordinates *at, bool forced,
                                      int order, double tolerance, flight_series *f, real *longest) {
    series_remainder remainder = {broadcast(0.0), broadcast(0.0)};
    expand_flight_by_case(&c->law, &at->leg, order, forced, f);
    *longest = longest_flight_step(&c->law, at->leg.length, order, forced);
    add_to_remainder(&remainder, f->length_rate, order - 1, c->mode.speed_scale);
    add_to_remainder(&remainder, f->angle_rate, order - 1, 1.0 / c->mode.time_scale);
    return size_for_loss(f->speed_square, c->mode.energy_scale / (c->mode.damping * c->mode.time_scale),
                         trusted_size(&remainder, *longest, order - 1, broadcast(tolerance)), order - 1,
                         tolerance);
}

/* Goes on to a time within the step. The turn is no difference of angles, each of which is rounded: a strong
 * servo would do work through that. */
static inline void fly_on(const flight_constants *c, const flight_series *f, int order,
                          const elapsed_time *elapsed, flight_coordinates *at) {
    const real turned = change_to(f->angle, elapsed, order);
    at->leg = tdmf_end_flight(f, elapsed, order);
    at->leg.angle = f->angle[0] + turned; /* The same angle, so that its series is summed once. */
    at->done.work += tdmf_flight_work(&c->law, f, elapsed, order, turned);
    at->done.damper_loss += c->mode.damping * integral_to(f->speed_square, elapsed, order - 1);
}

#endif
