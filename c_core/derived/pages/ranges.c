/* Derived from c_core/pages by scripts/derive_equations: edit the pages, not this. */
#include "ranges.h"

#include <float.h>

const tdmf_range tdmf_parameter_ranges[TDMF_PARAMETER_COUNT] = {
    {"body.mass", "kg", 1e-09, 1000000000.0, 1.0, false, false, 7, offsetof(tdmf_parameters, body.mass)},
    {"foot.mass", "kg", 1e-12, 1000000000.0, 0.1, false, false, 8, offsetof(tdmf_parameters, foot.mass)},
    {"leg.stiffness", "N/m", 1e-09, 1000000000000.0, 1.0, false, false, 9, offsetof(tdmf_parameters, leg.stiffness)},
    {"leg.damping", "N.s/m", 0.0, 1000000000000.0, 0.2, false, false, 10, offsetof(tdmf_parameters, leg.damping)},
    {"leg.free_length", "m", 1e-06, 1000000.0, 1.0, false, false, 11, offsetof(tdmf_parameters, leg.free_length)},
    {"leg.min_length", "m", 1e-09, 1000000.0, 0.05, false, false, 12, offsetof(tdmf_parameters, leg.min_length)},
    {"gravity", "m/s2", 1e-09, 1000000.0, 0.01, false, false, 13, offsetof(tdmf_parameters, gravity)},
    {"hip.stance_torque", "N.m", -1e+18, 1e+18, 0.2, false, true, 19, offsetof(tdmf_parameters, hip.stance_torque)},
    {"hip.touchdown_angle", "rad", -1.5707963267948966, 1.5707963267948966, 0.6981317007977318, false, true, 22, offsetof(tdmf_parameters, hip.touchdown_angle)},
    {"hip.kp", "N.m/rad", 0.0, 1e+18, 0.1, false, true, 20, offsetof(tdmf_parameters, hip.kp)},
    {"hip.kd", "N.m.s/rad", 0.0, 1e+18, 0.1, false, true, 21, offsetof(tdmf_parameters, hip.kd)},
    {"hip.liftoff_angle_factor", "1", 0.0, 100.0, 1.2, false, true, 23, offsetof(tdmf_parameters, hip.liftoff_angle_factor)},
    {"hip.retraction_rate", "rad/s", -1000000000.0, 1000000000.0, 0.0, false, true, 24, offsetof(tdmf_parameters, hip.retraction_rate)},
    {"ground.static_friction_ratio", "1", 1.0, 1000000.0, 1.0, false, false, 17, offsetof(tdmf_parameters, ground.static_friction_ratio)},
    {"ground.stribeck_velocity", "m/s", 0.0, 1000000000.0, 0.0, false, false, 18, offsetof(tdmf_parameters, ground.stribeck_velocity)},
    {"ground.patch_begin", "m", -1000000000.0, 1000000000.0, 0.0, false, false, 2, offsetof(tdmf_parameters, ground.patch_begin)},
    {"ground.patch_end", "m", -1000000000.0, 1000000000.0, 0.0, false, false, 3, offsetof(tdmf_parameters, ground.patch_end)},
    {"ground.patch_friction", "1", 0.0, 1000000.0, 0.1, false, false, 4, offsetof(tdmf_parameters, ground.patch_friction)},
    {"leg.thrust", "m", 0.0, 1000000.0, 0.0, false, true, 14, offsetof(tdmf_parameters, leg.thrust)},
};

const tdmf_flag tdmf_parameter_flags[] = {
    {"hip.swing_clamp", false, offsetof(tdmf_parameters, hip.swing_clamp)},
};
const size_t tdmf_parameter_flag_count =
    sizeof tdmf_parameter_flags / sizeof tdmf_parameter_flags[0];

const tdmf_range tdmf_input_ranges[TDMF_INPUT_COUNT] = {
    {"ground.friction", "1", 0.0, 1000000.0, 0.6, true, true, 115, offsetof(tdmf_inputs, ground.friction)},
    {"hip.external_torque", "N.m", -1e+18, 1e+18, 0.0, true, true, 120, offsetof(tdmf_inputs, hip.external_torque)},
    {"ground.height", "m", -1000000000.0, 1000000000.0, 0.0, false, true, 0, offsetof(tdmf_inputs, ground.height)},
    {"ground.slope", "rad", -1.0, 1.0, 0.0, false, true, 1, offsetof(tdmf_inputs, ground.slope)},
    {"leg.extension", "m", -1000000.0, 1000000.0, 0.0, true, true, 84, offsetof(tdmf_inputs, leg.extension)},
    {"body.external_fx", "N", -1e+18, 1e+18, 0.0, true, true, 85, offsetof(tdmf_inputs, body.external_fx)},
    {"body.external_fy", "N", -1e+18, 1e+18, 0.0, true, true, 86, offsetof(tdmf_inputs, body.external_fy)},
    {"control.touchdown_angle", "rad", -3.141592653589793, 3.141592653589793, 0.0, false, true, 26, offsetof(tdmf_inputs, control.touchdown_angle)},
    {"control.stance_torque", "N.m", -1e+18, 1e+18, 0.0, false, true, 27, offsetof(tdmf_inputs, control.stance_torque)},
    {"control.thrust", "m", -1000000.0, 1000000.0, 0.0, false, true, 16, offsetof(tdmf_inputs, control.thrust)},
};

const tdmf_range tdmf_state_ranges[TDMF_MECHANICAL_COUNT] = {
    {"foot.x", "m", -1000000000000.0, 1000000000000.0, -0.4722627765193387, true, true, 87, 0},
    {"foot.y", "m", -1000000000.0, 1000000000.0, 0.6417114468531165, true, true, 88, 0},
    {"leg.length", "m", 1e-09, 1000000000.0, 0.9999993776846997, true, true, 89, 0},
    {"leg.angle", "rad", -1000.0, 1000.0, -0.5462532571145313, true, true, 90, 0},
    {"foot.vx", "m/s", -1000000000000.0, 1000000000000.0, 1.062035591761993, true, true, 91, 0},
    {"foot.vy", "m/s", -1000000000000.0, 1000000000000.0, -1.9951712441925837e-05, true, true, 92, 0},
    {"leg.length_rate", "m/s", -1000000000000.0, 1000000000000.0, 1.1268102275039307e-06, true, true, 93, 0},
    {"leg.angle_rate", "rad/s", -1000000000000.0, 1000000000000.0, 4.039363331769765e-05, true, true, 94, 0},
};
