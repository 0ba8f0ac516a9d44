#include "reference_gaits.h"

#include "compare.h"

#include <math.h>

const reference_gait reference_gaits[REFERENCE_GAITS] = {
    {10.0,
     "0+",
     23.39379057088886,
     22.29241906218161,
     0.9529203484416162,
     0.1130627533052803,
     0.4610729813570963,
     -0.4566802857027719,
     {1.335681084574639, 0.95460064906904, 1.003468056490547, 0.9264410563264225, -4.473205042769141e-06,
      0.1949581135034323},
     {{TOUCHDOWN, 11.303144350308},
      {MID_STANCE, 11.954496018262},
      {SLIP_ONSET, 12.328155794844},
      {LIFT_OFF_INTO_GRAZE, 12.328225567943},
      {GRAZE_END, 12.404408134173},
      {CLAMP_RELEASE, 14.845956005836},
      {APEX, 23.393790570889}}},
    {1.2,
     "+0+",
     24.06043607572909,
     24.38959432345031,
     1.013680477223489,
     0.1099910614714827,
     0.4099776024927288,
     -0.455929026228832,
     {1.368813195564043, 1.015067679911492, 1.003911694284511, 1.088966741995681, -2.210891594266132e-06,
      0.2070426488477578},
     {{TOUCHDOWN, 11.591278896325},
      {SLIP_VELOCITY_ZERO, 11.832846796001},
      {MID_STANCE, 12.307654007441},
      {SLIP_ONSET, 12.655496864225},
      {LIFT_OFF_INTO_GRAZE, 12.655897730094},
      {GRAZE_END, 12.732966938548},
      {CLAMP_RELEASE, 15.174582613224},
      {APEX, 24.060436075729}}},
    {0.6,
     "+0-0+",
     24.76444922801218,
     26.29345008469551,
     1.061741767103539,
     0.1075073759660946,
     0.3717046558598356,
     -0.4539526081517742,
     {1.406106854441984, 1.062891224817656, 1.004282245348082, 1.242779537928858, 9.84952562003722e-07,
      0.2165916273954818},
     {{TOUCHDOWN, 11.908554644999},
      {SLIP_VELOCITY_ZERO, 12.326307826983},
      {SLIP_ONSET, 12.546509757405},
      {MID_STANCE, 12.682271253117},
      {SLIP_VELOCITY_ZERO, 12.755683573994},
      {SLIP_ONSET, 13.008463610519},
      {LIFT_OFF_INTO_GRAZE, 13.009048799101},
      {GRAZE_END, 13.086558255299},
      {CLAMP_RELEASE, 15.528770835708},
      {APEX, 24.764449228012}}},
    {0.43,
     "+0-",
     25.39956335689851,
     26.24053584845259,
     1.033109722389211,
     0.105220758867353,
     0.3645323246689646,
     -0.4499421270300924,
     {1.441887324102063, 1.034090452026958, 1.004638100817883, 1.390973195188192, 1.786781830291911e-06,
      0.2253582638618812},
     {{TOUCHDOWN, 12.20593249064},
      {SLIP_VELOCITY_ZERO, 12.697929571545},
      {SLIP_ONSET, 12.813212145965},
      {MID_STANCE, 13.022393471656},
      {LIFT_OFF_INTO_GRAZE, 13.329275168911},
      {GRAZE_END, 13.406966810093},
      {CLAMP_RELEASE, 15.849533072963},
      {APEX, 25.399563356899}}},
    {0.2,
     "+-",
     27.72699170339096,
     23.13400987121727,
     0.8343497959927628,
     0.09901900355452967,
     0.3891122916423601,
     -0.4350486040646275,
     {1.583107783307573, 0.8348521986773341, 1.005710963304427, 1.904748062999908, -5.374819445992559e-07,
      0.2499278780100866},
     {{TOUCHDOWN, 13.317696813513},
      {SLIP_VELOCITY_ZERO, 13.882510067286},
      {MID_STANCE, 14.242804084602},
      {LIFT_OFF_INTO_GRAZE, 14.514470832417},
      {GRAZE_END, 14.591878882636},
      {CLAMP_RELEASE, 17.037569762259},
      {APEX, 27.726991703391}}},
};

/* Section coordinates fix the foot: v_c = v + share (v_body - v), vy_c = 0, x_c = 0. */
runner runner_at_reference_apex(const reference_gait *gait) {
    runner runner = runner_default(gait->friction);
    const double share = runner.model.parameters.body.mass / runner.model.total_mass;
    const double r = gait->apex.leg_length;
    const double sine = sin(gait->apex.leg_angle);
    const double cosine = cos(gait->apex.leg_angle);
    const double along = gait->apex.leg_length_rate;
    const double across = r * gait->apex.leg_angle_rate;
    double *state = runner.motion.state;
    state[TDMF_FOOT_X] = share * r * sine;
    state[TDMF_FOOT_Y] = gait->apex.com_height - share * r * cosine;
    state[TDMF_LEG_LENGTH] = r;
    state[TDMF_LEG_ANGLE] = gait->apex.leg_angle;
    state[TDMF_FOOT_VX] = gait->apex.com_speed + share * (along * sine + across * cosine);
    state[TDMF_FOOT_VY] = -share * (along * cosine - across * sine);
    state[TDMF_LEG_LENGTH_RATE] = along;
    state[TDMF_LEG_ANGLE_RATE] = gait->apex.leg_angle_rate;
    runner_start(&runner);
    assert_true(runner.motion.record.progress.open.began_at_apex);
    return runner;
}

void assert_reference_apex(const tdmf_apex *apex, const reference_gait *gait, double tolerance) {
    assert_close(apex->com_height, gait->apex.com_height, tolerance);
    assert_close(apex->com_speed, gait->apex.com_speed, tolerance);
    assert_close(apex->leg_length, gait->apex.leg_length, tolerance);
    assert_close(apex->leg_angle, gait->apex.leg_angle, tolerance);
    assert_close(apex->leg_length_rate, gait->apex.leg_length_rate, tolerance);
    assert_close(apex->leg_angle_rate, gait->apex.leg_angle_rate, tolerance);
}
