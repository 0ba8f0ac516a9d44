/* Derived from the page Runner: edit the page, not this. */
#ifndef RUNNER_H
#define RUNNER_H

#include "driver.h"

enum {MODE_start_of_run, MODE_slip_constant, MODE_stick, MODE_flight_calm, MODE_fallen, MODE_graze,
    MODE_slip_falling, MODE_flight_pushed, MODE_COUNT};
enum {EVENT_passes_end, EVENT_passes_begin, EVENT_ramp_ends, EVENT_begins, EVENT_wind_rises, EVENT_new_ground,
    EVENT_falls, EVENT_collapses, EVENT_apex, EVENT_apex_in_graze, EVENT_touchdown, EVENT_clamp,
    EVENT_release, EVENT_greatest_compression, EVENT_mid_stance, EVENT_lift_off, EVENT_enters_layer,
    EVENT_leaves_layer, EVENT_slips_forward, EVENT_slips_backward, EVENT_comes_to_rest, EVENT_crosses_border,
    EVENT_graze_to_contact, EVENT_graze_to_flight, EVENT_COUNT};
enum {OUTPUT_pending, OUTPUT_torque, OUTPUT_normal_force, OUTPUT_tangential_force, OUTPUT_ground_force_x,
    OUTPUT_ground_force_y, OUTPUT_force_of_leg, OUTPUT_body_x, OUTPUT_body_y, OUTPUT_body_vx, OUTPUT_body_vy,
    OUTPUT_center_x, OUTPUT_center_y, OUTPUT_center_vx, OUTPUT_center_vy, OUTPUT_kinetic_energy,
    OUTPUT_potential_energy, OUTPUT_elastic_energy, OUTPUT_energy, OUTPUT_kind_of_contact,
    OUTPUT_phase_of_hip, OUTPUT_COUNT};

enum {TABLE_ground_segment, TABLE_COUNT};
enum {COLUMN_ground_segment_begin, COLUMN_ground_segment_end, COLUMN_ground_segment_height,
    COLUMN_ground_segment_slope, COLUMN_ground_segment_friction, COLUMN_ground_segment_COUNT};

typedef struct {
    real ground_height; /* m: Height of the ground at x = 0, h */
    real ground_slope; /* rad: Slope of the ground, positive uphill, sigma */
    real patch_begin; /* m: Position where the patch begins */
    real patch_end; /* m: Position where the patch ends; ground.patch_begin for no patch */
    real patch_friction; /* 1: Friction coefficient on the patch, mu_p */
    real trips; /* 1: True if a foot that meets the face of a higher segment falls */
    real keeps_friction; /* 1: True if a stance keeps the friction of the segment on which it began */
    real body_mass; /* kg: Mass of the body, m */
    real foot_mass; /* kg: Mass of the foot, m_f */
    real stiffness; /* N/m: Stiffness of the leg spring, k */
    real damping; /* N.s/m: Damping of the leg, c */
    real free_length; /* m: Length of the unloaded leg, l0 */
    real least_length; /* m: Leg length below which the runner falls */
    real gravity; /* m/s2: Acceleration of gravity, g */
    real thrust; /* m: Thrust: increase of the rest length from greatest compression to lift-off, epsilon */
    real notes_compression; /* 1: Whether a thrust that is set later acts at once if the leg has been shortest
        before */
    real more_thrust; /* m: Added to leg.thrust */
    real static_ratio; /* 1: Static over kinetic friction coefficient, rho */
    real stribeck_velocity; /* m/s: Stribeck velocity: scale of the slip speed over which friction falls,
        v_s; 0 for none */
    real drive_torque; /* N.m: Hip torque in the first half of a stance, tau0 */
    real kp; /* N.m/rad: Proportional gain of the hip in flight */
    real kd; /* N.m.s/rad: Derivative gain of the hip in flight */
    real touchdown_angle; /* rad: Touchdown angle: target of the leg angle before touchdown, theta0 */
    real liftoff_factor; /* 1: Target of the leg angle after lift-off, over the angle at lift-off, eta */
    real retraction_rate; /* rad/s: Swing-leg retraction: rate at which the target angle falls after the apex,
        omega */
    real swing_clamp; /* 1: True if the torque that retracts the leg is clamped at 0 from below */
    real more_angle; /* rad: Added to hip.touchdown_angle */
    real more_torque; /* N.m: Added to hip.stance_torque */
} runner_parameters;

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
    real leg_work_then; /* J: Work of the leg at the start of the stride */
    real positive_work_so_far; /* J: Positive work of the hip since the start */
    real positive_work_then; /* J: Positive work of the hip at the start of the stride */
    real peak_force_so_far; /* N: Largest normal force in the open stride */
    real vertical_so_far; /* N: Largest vertical ground force in the open stride */
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
    real leg_work_of_stride; /* J: Net work of thrust and leg extension in the stride */
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
    real height; /* m: Height at x = 0 of the ground line in force */
    real slope; /* rad: Slope of the ground line in force */
    real segment; /* 1: Segment of the ground below the foot; a run starts before the first */
    real segment_begin; /* m: Position where the segment begins */
    real segment_end; /* m: Position where the segment ends */
    real segment_height; /* m: Height of the segment's line at x = 0, above ground.height */
    real segment_slope; /* rad: Slope of the segment's line, added to ground.slope */
    real friction_ahead; /* 1: Friction that the foot would slip into, forward; see ground_segment */
    real friction_behind; /* 1: Friction that the foot would slip into, backward */
    real extension; /* m: Change of the rest length of the leg */
    real external_fx; /* N: Horizontal external force on the body */
    real external_fy; /* N: Vertical external force on the body */
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
    real leg_work; /* J: Work of thrust and leg extension since the start */
    real positive_leg_work; /* J: Positive works of jumps of the rest length since the start */
    real external_work; /* J: Work of external forces on the body since the start */
    real damper_loss; /* J: Energy lost in the damper since the start */
    real extension_rate; /* m/s: Rate at which `extension` is ramped */
    real external_fx_rate; /* N/s: Rate at which `external_fx` is ramped */
    real external_fy_rate; /* N/s: Rate at which `external_fy` is ramped */
    real friction; /* 1: Friction coefficient between foot and ground, mu */
    real way; /* 1: Direction of slip, 1 or -1 */
    real friction_loss; /* J: Energy lost to sliding friction since the start */
    real impact_loss; /* J: Energy lost in impacts since the start */
    real friction_rate; /* 1/s: Rate at which `friction` is ramped */
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
    real external_torque_rate; /* N.m/s: Rate at which `external_torque` is ramped */
    real has_fallen; /* 1: True after a fall, which freezes the motion */
} runner_states;

typedef struct {
    real extension_rate, external_fx_rate, external_fy_rate, friction_rate, external_torque_rate,
        segment_end_minus_seen_x, seen_x_minus_segment_begin;
} start_of_run_constants;

typedef struct {
    real inverse_body_mass, stiffness, free_length, thrusting_times_longer_or_by_0, damping, product_2,
        cosine, sine, gravity_times_sine, inverse_foot_mass, foot_mass_times_gravity_times_sine, way,
        is_own_times_own, by_1_minus_is_own, foot_mass_times_gravity_times_cosine, gravity_times_cosine,
        extension_rate, stiffness_times_extension_rate, external_fx_rate, external_fy_rate, friction_rate,
        external_torque_rate, least_length, winding, inverse_stribeck_velocity_or_by_1,
        segment_end_or_segment_begin;
} slip_constant_constants;

typedef struct {
    real inverse_body_mass, stiffness, free_length, thrusting_times_longer_or_by_0, damping, product_2,
        cosine, sine, gravity_times_sine, gravity_times_cosine, extension_rate,
        stiffness_times_extension_rate, foot_vx, external_fx_rate, external_fy_rate, friction_rate,
        external_torque_rate, least_length, winding, foot_mass_times_gravity_times_cosine, static_ratio,
        is_own_times_friction_ahead, by_1_minus_is_own, foot_mass_times_gravity_times_sine,
        by_0_or_by_1_times_friction_behind, by_1_minus_by_0_or_by_1;
} stick_constants;

typedef struct {
    real mobility, stiffness, free_length, thrusting_times_longer_or_by_0, damping, kp, share_times_kp,
        liftoff_factor_times_liftoff_angle, first, is_placing, turn, kd, share_times_kd, extension_rate,
        stiffness_times_extension_rate, external_fx_rate, external_fy_rate, friction_rate,
        external_torque_rate, com_vx, minus_gravity, segment_end, body_mass_over_body_mass_plus_foot_mass,
        segment_begin, set_slope, cos_of_set_slope, set_height, sin_of_set_slope, slope, cos_of_slope, height,
        sin_of_slope, sum_2, least_length, inverse_cos_of_slope;
} flight_calm_constants;

typedef struct {
    real none;
} fallen_constants;

typedef struct {
    real inverse_body_mass, stiffness, free_length, thrusting_times_longer_or_by_0, damping, cosine, off,
        sine, gravity_times_sine, inverse_foot_mass, along, gravity_times_cosine, extension_rate,
        stiffness_times_extension_rate, external_fx_rate, external_fy_rate, friction_rate,
        external_torque_rate, is_placing, segment_end, segment_begin, least_length, share, kp, winding,
        liftoff_factor_times_liftoff_angle, kd, product_2, by_1_or_by_0_times_kp, first, turn,
        by_1_or_by_0_times_kd;
} graze_constants;

typedef struct {
    real inverse_body_mass, stiffness, free_length, thrusting_times_longer_or_by_0, damping, product_2,
        cosine, sine, gravity_times_sine, inverse_foot_mass, foot_mass_times_gravity_times_sine, way,
        is_own_times_own, by_1_minus_is_own, static_ratio_minus_by_1, inverse_stribeck_velocity,
        foot_mass_times_gravity_times_cosine, gravity_times_cosine, extension_rate,
        stiffness_times_extension_rate, external_fx_rate, external_fy_rate, friction_rate,
        external_torque_rate, least_length, winding, inverse_stribeck_velocity_or_by_1,
        segment_end_or_segment_begin;
} slip_falling_constants;

typedef struct {
    real inverse_body_mass, mobility, stiffness, free_length, thrusting_times_longer_or_by_0, damping,
        inverse_total_mass, gravity, kp, share_times_kp, liftoff_factor_times_liftoff_angle, first,
        is_placing, turn, kd, share_times_kd, extension_rate, stiffness_times_extension_rate,
        body_mass_over_total_mass, by_1_minus_body_mass_over_total_mass, external_fx_rate, external_fy_rate,
        friction_rate, external_torque_rate, segment_end, segment_begin, set_slope, cos_of_set_slope,
        set_height, sin_of_set_slope, slope, cos_of_slope, height, sin_of_slope, least_length,
        inverse_cos_of_slope;
} flight_pushed_constants;

extern const tdmf_motion_kind TDMF_OF_WIDTH(tdmf_runner_motions)[];
tdmf_motions_of_width tdmf_runner_motions_of_2, tdmf_runner_motions_of_4, tdmf_runner_motions_of_8;
extern const tdmf_seed_kind tdmf_runner_seeds;
extern const tdmf_model_kind tdmf_runner_model;

#endif
