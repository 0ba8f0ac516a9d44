#include "reference_gaits.h"

#include "compare.h"
#include "reference_gaits_table.h"

#include <math.h>

tdmf_model table_1(bool swing_clamp) {
    tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_model model;
    parameters.hip.swing_clamp = swing_clamp;
    assert_null(tdmf_model_create(&model, &parameters).variable);
    return model;
}

tdmf_inputs inputs_at_friction(double friction) {
    tdmf_inputs inputs = tdmf_default_inputs();
    inputs.ground.friction = friction;
    return inputs;
}

/* Section coordinates fix the foot: v_c = v + share (v_body - v), vy_c = 0, x_c = 0. */
runner runner_at_reference_apex(const reference_gait *gait) {
    runner runner = runner_default(gait->friction);
    runner.model = table_1(gait->swing_clamp);
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
    assert_true(runner.motion.state[TDMF_STRIDE_IS_OPEN] > 0.0);
    return runner;
}

void assert_reference_apex(tdmf_apex apex, const reference_gait *gait, double tolerance) {
    assert_close(apex.com_height, gait->apex.com_height, tolerance);
    assert_close(apex.com_speed, gait->apex.com_speed, tolerance);
    assert_close(apex.leg_length, gait->apex.leg_length, tolerance);
    assert_close(apex.leg_angle, gait->apex.leg_angle, tolerance);
    assert_close(apex.leg_length_rate, gait->apex.leg_length_rate, tolerance);
    assert_close(apex.leg_angle_rate, gait->apex.leg_angle_rate, tolerance);
}

void assert_reference_stride(const tdmf_motion *motion, const reference_gait *gait, double tolerance) {
    const tdmf_stride stride = last_stride_of(motion);
    assert_string_equal(stride.word, gait->word);
    assert_int_equal(stride.touchdowns, 1);
    assert_relatively_close(stride.period, gait->period, tolerance);
    assert_relatively_close(stride.length, gait->length, tolerance);
    assert_relatively_close(stride.speed, gait->speed, tolerance);
    assert_relatively_close(stride.work, gait->work, tolerance);
    assert_relatively_close(stride.cost_of_transport, gait->cost_of_transport, tolerance);
    assert_relatively_close(motion->state[TDMF_HIP_LIFTOFF_ANGLE], gait->liftoff_angle, tolerance);
    if (gait->stance_time > 0.0) {
        assert_relatively_close(stride.stance_time, gait->stance_time, tolerance);
        assert_close(stride.slip_distance, gait->slip_distance, tolerance);
    }
    assert_reference_apex(last_apex_of(motion), gait, tolerance);
}

bool assert_reference_jacobian(const tdmf_return *stride, const reference_gait *gait) {
    const bool known = gait->jacobian[0][0] != 0.0;
    for (int row = 0; known && row < TDMF_SECTION_COUNT; ++row) {
        for (int column = 0; column < TDMF_SECTION_COUNT; ++column) {
            assert_close(stride->variations[column].apex[row], gait->jacobian[row][column], 1e-8);
        }
    }
    return known;
}

static reference_event_kind kind_of(const tdmf_event *event) {
    switch (event->guard) {
    case TDMF_GUARD_TOUCHDOWN:
        return TOUCHDOWN;
    case TDMF_GUARD_SLIP_VELOCITY_ZERO:
        return SLIP_VELOCITY_ZERO;
    case TDMF_GUARD_SLIP_ONSET_POSITIVE:
    case TDMF_GUARD_SLIP_ONSET_NEGATIVE:
        return SLIP_ONSET;
    case TDMF_GUARD_MID_STANCE:
        return MID_STANCE;
    case TDMF_GUARD_LIFT_OFF:
        assert_int_equal(event->after.contact, TDMF_CONTACT_GRAZE);
        return LIFT_OFF_INTO_GRAZE;
    case TDMF_GUARD_GRAZE_TO_FLIGHT:
        return GRAZE_END;
    case TDMF_GUARD_CLAMP:
        return CLAMP_RELEASE;
    case TDMF_GUARD_GREATEST_COMPRESSION:
        assert_true(event->after.thrusts);
        return THRUST_BEGINS;
    default:
        assert_int_equal(event->guard, TDMF_GUARD_APEX);
        return APEX;
    }
}

int assert_reference_events(const tdmf_event_log *log, const reference_event *expected, double tolerance) {
    /* The clamp is due at twice its dead band of 1e-10: 1.1e-8 at the slowest. */
    static const double clamp_time = 1.3e-8;
    int compared = 0;
    for (; expected[compared].kind != 0; ++compared) {
        const reference_event_kind kind = expected[compared].kind;
        assert_true(compared < log->count);
        assert_int_equal(kind_of(&log->events[compared]), kind);
        assert_close(log->events[compared].time, expected[compared].time,
                     kind == CLAMP_RELEASE ? clamp_time : tolerance);
    }
    assert_int_equal(log->count, compared);
    return compared;
}
