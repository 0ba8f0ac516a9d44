/* Derived from the page ClassicSlip: edit the page, not this. */
#ifndef CLASSIC_SLIP_H
#define CLASSIC_SLIP_H

#include "driver.h"

enum {MODE_start_of_run, MODE_no_start, MODE_flight_down, MODE_fallen, MODE_slides, MODE_stance,
    MODE_flight_up, MODE_COUNT};
enum {EVENT_begins, EVENT_touchdown, EVENT_falls, EVENT_take_off, EVENT_leaves_cone, EVENT_slides_out,
    EVENT_collapses, EVENT_apex, EVENT_COUNT};
enum {OUTPUT_COUNT};

enum {TABLE_COUNT};

typedef struct {
    real mass; /* kg: Mass of the body, m */
    real stiffness; /* N/m: Stiffness of the leg spring, k */
    real free_length; /* m: Length of the unloaded leg, l0 */
    real gravity; /* m/s2: Acceleration of gravity, g */
    real touchdown_angle; /* rad: Leg angle at the apex, positive with the foot ahead, theta0 */
    real retraction_rate; /* rad/s: Rate at which the leg angle falls after the apex, omega */
    real friction; /* 1: Friction coefficient; by default the foot holds, mu */
    real slope; /* rad: Slope of the ground, positive uphill, sigma */
    real energy; /* J: Energy at the start, above the ground vertically below */
} classic_slip_parameters;

typedef struct {
    real time; /* s: Time */
    real x_; /* m: Horizontal position of the mass */
    real y_; /* m: Height of the mass */
    real vx; /* m/s: Horizontal velocity of the mass */
    real vy; /* m/s: Vertical velocity */
    real angle; /* rad: Leg angle from the vertical in flight, positive with the foot ahead */
    real foot_x; /* m: Position of the foot in stance */
    real foot_y; /* m: Height of the foot */
    real touchdown_time; /* s: Time of the last touchdown */
    real stance_time; /* s: Duration of the last stance */
    real impact_friction; /* 1: Friction that a small foot mass needs to stick at the impact  (5) */
    real stance_friction; /* 1: Friction that the stance needs  (3) */
    real tilt; /* 1: Sine of the largest angle between the leg and the normal of the ground in stance */
    real left_early; /* 1: 1 if the leg left the friction cone with energy in its spring, else 0 */
    real apex_x; /* m: Position of the mass at the last apex */
    real apex_height; /* m: Height of the mass above the ground at the last apex */
    real apex_energy; /* J: Energy at the last apex, above the ground vertically below */
    real step_length; /* m: Distance between the last two apices */
} classic_slip_states;

typedef struct {
    real none;
} start_of_run_constants;

typedef struct {
    real none;
} no_start_constants;

typedef struct {
    real vx, minus_gravity, minus_retraction_rate, free_length, sin_of_slope_over_cos_of_slope;
} flight_down_constants;

typedef struct {
    real none;
} fallen_constants;

typedef struct {
    real none;
} slides_constants;

typedef struct {
    real stiffness_over_mass, free_length, foot_x, foot_y, gravity, free_length_times_free_length, friction,
        inverse_by_1_plus_friction, cos_of_slope, sin_of_slope;
} stance_constants;

typedef struct {
    real vx, minus_gravity, sin_of_slope_over_cos_of_slope;
} flight_up_constants;

extern const tdmf_motion_kind TDMF_OF_WIDTH(tdmf_classic_slip_motions)[];
tdmf_motions_of_width tdmf_classic_slip_motions_of_2, tdmf_classic_slip_motions_of_4,
    tdmf_classic_slip_motions_of_8;
extern const tdmf_seed_kind tdmf_classic_slip_seeds;
extern const tdmf_model_kind tdmf_classic_slip_model;

#endif
