#include "reference_gaits.h"

#include "compare.h"
#include "reference_gaits_table.h"

#include <math.h>

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
