/* Derived from the page PlainRunner: edit the page, not this. */
#ifndef PLAIN_RUNNER_H
#define PLAIN_RUNNER_H

#include "driver.h"

enum {MODE_start_of_run, MODE_slip_constant, MODE_stick, MODE_flight_calm, MODE_fallen, MODE_graze,
    MODE_COUNT};
enum {EVENT_begins, EVENT_falls, EVENT_collapses, EVENT_apex, EVENT_apex_in_graze, EVENT_touchdown,
    EVENT_clamp, EVENT_release, EVENT_greatest_compression, EVENT_mid_stance, EVENT_lift_off,
    EVENT_slips_forward, EVENT_slips_backward, EVENT_comes_to_rest, EVENT_graze_to_contact,
    EVENT_graze_to_flight, EVENT_COUNT};
enum {OUTPUT_COUNT};

enum {TABLE_COUNT};

typedef struct {
    real body_mass; /* kg: Mass of the body, m */
    real foot_mass; /* kg: Mass of the foot, m_f */
    real stiffness; /* N/m: Stiffness of the leg spring, k */
    real damping; /* N.s/m: Damping of the leg, c */
    real free_length; /* m: Length of the unloaded leg, l0 */
    real least_length; /* m: Leg length below which the runner falls */
    real gravity; /* m/s2: Acceleration of gravity, g */
    real notes_compression; /* 1: Whether a thrust that is set later acts at once if the leg has been shortest
        before */
    real drive_torque; /* N.m: Hip torque in the first half of a stance, tau0 */
    real kp; /* N.m/rad: Proportional gain of the hip in flight */
    real kd; /* N.m.s/rad: Derivative gain of the hip in flight */
    real touchdown_angle; /* rad: Touchdown angle: target of the leg angle before touchdown, theta0 */
    real liftoff_factor; /* 1: Target of the leg angle after lift-off, over the angle at lift-off, eta */
    real swing_clamp; /* 1: True if the torque that retracts the leg is clamped at 0 from below */
} plain_runner_parameters;

typedef struct {
    real time; /* s: Time */
    real events; /* 1: Changes of contact and phase since the start */
    real last_event; /* s: Time of the last change of contact or phase */
    real greatest_slip_velocity; /* m/s: Largest slip velocity since the start */
    real greatest_foot_height; /* m: Largest height of the foot above the ground, in flight,
        since the start */
    real squared_torque; /* N2.m2.s: Integral of the squared hip torque since the start */
    real is_open; /* 1: 1 if the open stride began at an apex, else 0 */
    real work_then; /* J: Work of the hip at the start of the stride */
    real positive_work_so_far; /* J: Positive work of the hip since the start */
    real positive_work_then; /* J: Positive work of the hip at the start of the stride */
    real peak_force_so_far; /* N: Largest normal force in the open stride */
    real touchdowns_so_far; /* 1: Impacts in the open stride */
    real slip_so_far; /* m: Slip distance in the open stride before the present mode */
    real slid_from; /* m: Position of the foot at the last event */
    real stance_so_far; /* s: Time in contact in the open stride before the present mode */
    real word_so_far; /* 1: Gait word of the open stride, in base 4 */
    real last_letter; /* 1: Last letter of the open stride's gait word */
    real bar_is_due; /* 1: 1 from touchdown until a contact mode lasts, else 0 */
    real mode_began; /* s: Time of the last event */
    real x_then; /* m: Position of the centre of mass at the start of the stride */
    real y_then; /* m: Height of the centre of mass at the start of the stride */
    real count; /* 1: Number of completed strides */
    real word_code; /* 1: Gait word: + slip forward, 0 stick, - slip backward, | new stance */
    real period; /* s: Period of the stride, T */
    real distance; /* m: Distance covered by the centre of mass in the stride */
    real rise_of_stride; /* m: Height gained by the centre of mass in the stride */
    real work_of_stride; /* J: Net work of hip and leg in the stride, W */
    real hip_work; /* J: Net work of the hip in the stride */
    real positive_work; /* J: Positive work of the hip in the stride */
    real speed; /* m/s: Average speed of the stride, V */
    real cost_of_transport; /* 1: Mechanical cost of transport of the stride, c_mt */
    real touchdowns; /* 1: Impacts of the foot in the stride */
    real stance_time; /* s: Time in contact in the stride */
    real duty_factor; /* 1: Share of the stride in which the foot was in contact */
    real slip_distance; /* m: Slip distance of the foot in the stride */
    real peak_force; /* N: Largest normal force in the stride */
    real peak_vertical_force; /* N: Largest vertical ground force in the stride */
    real apex_time; /* s: Time of the last apex */
    real apex_com_height; /* m: Height of the centre of mass at the last apex */
    real apex_com_speed; /* m/s: Speed of the centre of mass at the last apex */
    real apex_length; /* m: Leg length at the last apex */
    real apex_angle; /* rad: Leg angle at the last apex */
    real apex_length_rate; /* m/s: Rate of the leg length at the last apex */
    real apex_angle_rate; /* rad/s: Rate of the leg angle at the last apex */
    real seen_x; /* m: Horizontal position of the foot, x */
    real seen_y; /* m: Height of the foot, y */
    real length; /* m: Length of the leg, r */
    real angle; /* rad: Angle of the leg from the vertical, positive with the foot ahead, theta */
    real seen_vx; /* m/s: Horizontal velocity of the foot */
    real seen_vy; /* m/s: Vertical velocity of the foot */
    real length_rate; /* m/s: Rate of the leg length */
    real angle_rate; /* rad/s: Rate of the leg angle */
    real com_x; /* m: Horizontal position of the centre of mass */
    real com_y; /* m: Height of the centre of mass */
    real com_vx; /* m/s: Horizontal velocity of the centre of mass */
    real com_vy; /* m/s: Vertical velocity of the centre of mass */
    real momentum; /* m2/s: Angular momentum of the leg per reduced mass, r^2 thetadot */
    real x_; /* m: Position of the body relative to the foot, along the ground */
    real y_; /* m: Position of the body relative to the foot, normal to the ground */
    real vx; /* m/s: Velocity of the body relative to the foot, along the ground */
    real vy; /* m/s: Velocity of the body relative to the foot, normal to the ground */
    real foot_x; /* m: Position of the foot along the ground */
    real foot_vx; /* m/s: Velocity of the foot along the ground */
    real winding; /* rad: Leg angle less its principal value: a multiple of 2 pi */
    real thrusting; /* 1: 1 from greatest compression to lift-off, else 0 */
    real damper_loss; /* J: Energy lost in the damper since the start */
    real friction; /* 1: Friction coefficient between foot and ground, mu */
    real way; /* 1: Direction of slip, 1 or -1 */
    real friction_loss; /* J: Energy lost to sliding friction since the start */
    real impact_loss; /* J: Energy lost in impacts since the start */
    real external_torque; /* N.m: Torque added to the hip law */
    real liftoff_angle; /* rad: Leg angle when the foot last left the ground, theta_LO */
    real driving; /* 1: 1 from touchdown to mid-stance, else 0 */
    real swing; /* 1: Law of the hip in flight: 0 rest, 1 retract, 2 place */
    real placing; /* s: Time since the phase place began; 0 in other phases */
    real touchdown_time; /* s: Time of the last impact */
    real has_hopped; /* 1: 1 once the flight law has hardly lifted the foot at a lift-off, else 0 */
    real hop_time; /* s: Time of the last lift-off at which the flight law hardly lifted the foot */
    real was_placed; /* 1: 1 if the leg was being placed at the last impact, else 0 */
    real placed_for; /* s: Time in place at the last impact */
    real rises_again; /* 1: 1 if an impact with immediate lift-off interrupted place, else 0 */
    real work; /* J: Work of the total hip torque since the start, W */
    real has_fallen; /* 1: True after a fall, which freezes the motion */
} plain_runner_states;

typedef struct {
    real none;
} start_of_run_constants;

typedef struct {
    real inverse_body_mass, stiffness, free_length, damping, stance_torque, inverse_foot_mass, way,
        way_times_friction, gravity, foot_mass_times_gravity, least_length, winding, square_of_torque;
} slip_constant_constants;

typedef struct {
    real inverse_body_mass, stiffness, free_length, damping, stance_torque, gravity, foot_vx, least_length,
        winding, foot_mass_times_gravity, friction, square_of_torque;
} stick_constants;

typedef struct {
    real mobility, stiffness, free_length, damping, external_torque, kp, share_times_kp,
        liftoff_factor_times_liftoff_angle, first, kd, share_times_kd, com_vx, minus_gravity, is_placing,
        body_mass_over_body_mass_plus_foot_mass, sum_2, least_length;
} flight_calm_constants;

typedef struct {
    real none;
} fallen_constants;

typedef struct {
    real inverse_body_mass, stiffness, free_length, damping, off, inverse_foot_mass,
        minus_off_over_body_mass_minus_gravity, is_placing, least_length, share, kp, winding,
        liftoff_factor_times_liftoff_angle, kd, external_torque, stance_torque, by_1_or_by_0_times_kp, first,
        by_1_or_by_0_times_kd;
} graze_constants;

extern const tdmf_motion_kind TDMF_OF_WIDTH(tdmf_plain_runner_motions)[];
tdmf_motions_of_width tdmf_plain_runner_motions_of_2, tdmf_plain_runner_motions_of_4,
    tdmf_plain_runner_motions_of_8;
extern const tdmf_seed_kind tdmf_plain_runner_seeds;
extern const tdmf_model_kind tdmf_plain_runner_model;

#endif
