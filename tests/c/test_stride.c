/* Stride quantities and the gait word. Words are driven by hand: between two calls of tdmf_resolve a test
 * puts the runner where the next event is due, so that every order of contact modes can be written. */
#include "compare.h"
#include "scene.h"
#include "tdmf_slip/cvode.h"

#include <math.h>
#include <string.h>

/* ---- a runner moved by hand ------------------------------------------------------------------------- */

static void at_time(runner *runner, double time) {
    runner->motion.time = time;
    scene_resolve(runner);
}

/* Begins at an apex at time 0, in place. */
static runner begin_stride(void) {
    runner runner = scene_in_flight(TDMF_PHASE_PLACE, 0.0);
    runner_start(&runner);
    assert_true(runner.motion.state[TDMF_STRIDE_IS_OPEN] > 0.0);
    return runner;
}

static void put_on_ground(runner *runner, double force) {
    runner->motion.state[TDMF_FOOT_Y] = 0.0;
    scene_set_foot_velocity(0.0, 0.0, runner->motion.state);
    scene_set_vertical_force(runner, force);
}

/* Lands on a leg behind the body, in coast, and sticks; the body rises, so that this is no apex. */
static void land(runner *runner, double time) {
    memset(&runner->motion.state[TDMF_FOOT_VX], 0, 4 * sizeof *runner->motion.state);
    runner->motion.state[TDMF_LEG_ANGLE] = -0.3;
    runner->motion.state[TDMF_LEG_LENGTH] = 0.9;
    runner->motion.state[TDMF_LEG_LENGTH_RATE] = 0.1;
    runner->motion.state[TDMF_FOOT_Y] = -1e-9;
    runner->inputs.ground.friction = 1000.0;
    scene_set_foot_velocity(0.0, -0.1, runner->motion.state);
    at_time(runner, time);
    assert_int_equal(runner->motion.mode.contact, TDMF_CONTACT_STICK);
}

/* Makes a sticking foot slip; the leg's angle, ahead or behind, decides the direction. */
static void slip(runner *runner, double time, double sign) {
    runner->motion.state[TDMF_LEG_ANGLE] = sign * 0.3;
    put_on_ground(runner, 0.1);
    runner->inputs.ground.friction = 0.0;
    at_time(runner, time);
    assert_true(tdmf_sign_of_slip(&runner->motion.mode) == sign);
}

/* Makes a slipping foot stick. */
static void stick(runner *runner, double time) {
    runner->motion.state[TDMF_FOOT_VX] = -1e-9 * tdmf_sign_of_slip(&runner->motion.mode);
    runner->inputs.ground.friction = 1000.0;
    at_time(runner, time);
    assert_int_equal(runner->motion.mode.contact, TDMF_CONTACT_STICK);
}

/* A climb by the turning leg: clamped if it swings forward, loading the foot if backward. */
static void unload(runner *runner, double time, double angle_rate, tdmf_contact_mode entered) {
    runner->motion.state[TDMF_LEG_ANGLE] = -0.3;
    runner->motion.state[TDMF_LEG_ANGLE_RATE] = angle_rate;
    scene_set_com_vy_by_leg(runner, 0.2);
    scene_set_vertical_force(runner, -1e-3);
    at_time(runner, time);
    assert_int_equal(runner->motion.mode.contact, entered);
}

static void lift_off(runner *runner, double time) {
    unload(runner, time, 0.5, TDMF_CONTACT_FLIGHT);
}

static void graze(runner *runner, double time) {
    unload(runner, time, -1.0, TDMF_CONTACT_GRAZE);
}

/* A foot in graze is loaded again, while it slides or rests. */
static void reload(runner *runner, double time, double vx) {
    scene_set_vertical_force(runner, 0.1);
    runner->motion.state[TDMF_FOOT_VX] = vx;
    at_time(runner, time);
    assert_true(tdmf_is_loaded(&runner->motion.mode));
}

static void reach_apex(runner *runner, double time) {
    runner->motion.state[TDMF_FOOT_Y] = 0.5;
    scene_set_com_vy(runner, -1e-12);
    at_time(runner, time);
    assert_int_equal(runner->motion.mode.phase, TDMF_PHASE_PLACE);
}

static void assert_closed(const runner *runner, const char *word, int code) {
    assert_int_equal(runner->motion.state[TDMF_STRIDE_COUNT], 1);
    assert_string_equal(last_stride_of(&runner->motion).word, word);
    assert_int_equal(last_stride_of(&runner->motion).word_code, code);
}

/* ---- words ------------------------------------------------------------------------------------------ */

/* Takes one event at a time: l is a landing, | a lift-off, g the start of a graze, and a letter of a word the
 * contact that begins. In a graze, f lifts the foot. */
static void follow(runner *runner, char what, double time) {
    const bool grazes = runner->motion.mode.contact == TDMF_CONTACT_GRAZE;
    switch (what) {
    case 'l':
        land(runner, time);
        break;
    case '|':
        lift_off(runner, time);
        break;
    case 'g':
        graze(runner, time);
        break;
    case 'f':
        runner->motion.state[TDMF_LEG_ANGLE_RATE] = 0.5;
        at_time(runner, time);
        assert_int_equal(runner->motion.mode.contact, TDMF_CONTACT_FLIGHT);
        break;
    default:
        if (grazes) {
            reload(runner, time, what == '0' ? 0.0 : 0.1);
        } else if (what == '0') {
            stick(runner, time);
        } else {
            slip(runner, time, what == '+' ? 1.0 : -1.0);
        }
    }
}

static int code_of(const char *word) {
    int code = 0;
    for (; *word != '\0'; ++word) {
        code = 4 * code + (*word == '|' ? 0 : *word == '-' ? 1 : *word == '0' ? 2 : 3);
    }
    return code;
}

/* A mode without duration has no letter, and a stance without one leaves no trace. Flight separates stances,
 * graze does not, nor does it repeat a letter. */
TEST(words_have_a_letter_for_every_mode_that_lasts) {
    static const struct {
        const char *happens, *word;
        double times[8], stance_time;
        int touchdowns;
    } cases[] = {
        {"l+0-0+|", "0+0-0+", {1, 2, 3, 4, 5, 6, 7}, 6.0, 1}, {"l+0-|", "+-", {1, 1, 2, 2, 3}, 2.0, 1},
        {"l|l-|", "0|0-", {1, 2, 3, 4, 5}, 3.0, 2},           {"l|l|l|", "0", {1, 1, 2, 3, 4, 4}, 1.0, 3},
        {"lg0g+|", "0+", {1, 2, 3, 4, 5, 6}, 3.0, 1},         {"lgfl|", "0|0", {1, 2, 2.5, 3, 4}, 2.0, 2}};
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        runner runner = begin_stride();
        for (int k = 0; cases[i].happens[k] != '\0'; ++k) {
            follow(&runner, cases[i].happens[k], cases[i].times[k]);
        }
        reach_apex(&runner, 8.0);
        const tdmf_stride stride = last_stride_of(&runner.motion);
        assert_closed(&runner, cases[i].word, code_of(cases[i].word));
        assert_int_equal(stride.touchdowns, cases[i].touchdowns);
        assert_close(stride.stance_time, cases[i].stance_time, 1e-15);
        assert_close(stride.period, 8.0, 1e-15);
        assert_close(stride.duty_factor, cases[i].stance_time / 8.0, 1e-15);
    }
}

/* Its code holds fifteen letters, and itself what there is room for, with a ~ for the others. */
TEST(long_words_have_no_code_and_the_longest_are_cut) {
    static const int lengths[] = {
        15, 16, TDMF_WORD_CAPACITY - 2, TDMF_WORD_CAPACITY - 1, TDMF_WORD_CAPACITY, TDMF_WORD_CAPACITY + 37};
    for (size_t i = 0; i < COUNT_OF(lengths); ++i) {
        char word[TDMF_WORD_CAPACITY] = "";
        runner runner = begin_stride();
        follow(&runner, 'l', 1.0);
        for (int k = 0; k < lengths[i]; ++k) {
            const char letter = k % 2 ? '+' : '0';
            if (k > 0) {
                follow(&runner, letter, 1.0 + k);
            }
            if (k < TDMF_WORD_CAPACITY - 1) {
                word[k] = k < TDMF_WORD_CAPACITY - 2 ? letter : '~';
            }
        }
        follow(&runner, '|', 1.0 + lengths[i]);
        reach_apex(&runner, 2.0 + lengths[i]);
        assert_closed(&runner, word, lengths[i] <= 15 ? code_of(word) : -1);
        assert_close(last_stride_of(&runner.motion).stance_time, lengths[i], 1e-12);
    }
}

/* ---- quantities ------------------------------------------------------------------------------------- */

TEST(slip_distance_adds_up_both_ways) {
    runner runner = begin_stride();
    land(&runner, 1.0);
    slip(&runner, 2.0, 1.0);
    runner.motion.state[TDMF_FOOT_X] += 0.25;
    stick(&runner, 3.0);
    slip(&runner, 4.0, -1.0);
    runner.motion.state[TDMF_FOOT_X] -= 0.125;
    lift_off(&runner, 5.0);
    runner.motion.state[TDMF_FOOT_X] += 0.5; /* not counted, because the foot is in flight */
    reach_apex(&runner, 6.0);
    assert_close(last_stride_of(&runner.motion).slip_distance, 0.375, 1e-15);
}

TEST(stride_begun_elsewhere_is_not_counted) {
    runner runner = scene_in_flight(TDMF_PHASE_PLACE, -0.1);
    runner_start(&runner);
    land(&runner, 1.0);
    lift_off(&runner, 2.0);
    reach_apex(&runner, 3.0);
    const tdmf_stride stride = last_stride_of(&runner.motion);
    assert_true(stride.period == 0.0 && stride.length == 0.0 && stride.rise == 0.0 && stride.speed == 0.0);
    assert_true(stride.work == 0.0 && stride.hip_work == 0.0 && stride.leg_work == 0.0);
    assert_true(stride.positive_work == 0.0 && stride.cost_of_transport == 0.0);
    assert_true(stride.stance_time == 0.0 && stride.duty_factor == 0.0 && stride.slip_distance == 0.0);
    assert_true(stride.peak_force == 0.0 && stride.peak_vertical_force == 0.0);
    assert_true(stride.count == 0 && stride.touchdowns == 0);
    assert_string_equal(stride.word, "");
    assert_int_equal(stride.word_code, 0);
    assert_true(last_apex_of(&runner.motion).time == 3.0);
    land(&runner, 4.0);
    slip(&runner, 5.0, 1.0);
    lift_off(&runner, 6.0);
    reach_apex(&runner, 7.0);
    assert_closed(&runner, "0+", 2 * 4 + 3);
    assert_close(last_stride_of(&runner.motion).period, 4.0, 1e-15);
}

TEST(stride_that_covers_no_ground_has_no_cost) {
    runner runner = begin_stride();
    runner.motion.mode.phase = TDMF_PHASE_RETRACT;
    runner.motion.mode.rises = true;
    reach_apex(&runner, 0.0);
    assert_closed(&runner, "", 0);
    assert_true(last_stride_of(&runner.motion).speed == 0.0 &&
                last_stride_of(&runner.motion).duty_factor == 0.0);
    assert_true(last_stride_of(&runner.motion).cost_of_transport == 0.0);
}

/* Results of a dense sampling of one stride. */
typedef struct {
    double largest_force, largest_vertical_force, stance_time, slip_distance;
    double com_x[2], work[2], positive_work[2], time[2];
} sampling;

static void sample(sampling *seen, const runner *runner, int end) {
    seen->com_x[end] = tdmf_center_of_mass(&runner->model, runner->motion.state).x;
    seen->work[end] = runner->motion.state[TDMF_HIP_WORK];
    seen->positive_work[end] = runner->motion.state[TDMF_HIP_POSITIVE_WORK];
    seen->time[end] = runner->motion.time;
}

/* Samples the contact force in `mode`: the mode that ends, goes on or begins. */
static void sample_force(sampling *seen, const runner *runner, const tdmf_mode *mode) {
    tdmf_motion motion = runner->motion;
    motion.mode = *mode;
    const tdmf_outputs outputs = outputs_of(SYSTEM_OF(runner), &motion);
    seen->largest_force = fmax(seen->largest_force, outputs.contact.normal);
    seen->largest_vertical_force = fmax(seen->largest_vertical_force, outputs.contact.fy);
}

static sampling sample_stride(runner *runner, double step) {
    sampling seen = {0.0, 0.0, 0.0, 0.0, {0.0}, {0.0}, {0.0}, {0.0}};
    const double count = runner->motion.state[TDMF_STRIDE_COUNT];
    sample(&seen, runner, 0);
    while (runner->motion.state[TDMF_STRIDE_COUNT] == count) {
        const double time = runner->motion.time;
        const double x = runner->motion.state[TDMF_FOOT_X];
        const tdmf_mode mode = runner->motion.mode;
        const bool contact = tdmf_is_loaded(&mode);
        assert_true(runner_advance(runner, step));
        seen.stance_time += contact ? runner->motion.time - time : 0.0;
        seen.slip_distance += contact ? fabs(runner->motion.state[TDMF_FOOT_X] - x) : 0.0;
        sample_force(&seen, runner, &mode);
        sample_force(&seen, runner, &runner->motion.mode);
    }
    sample(&seen, runner, 1);
    return seen;
}

/* The peak is found, not sampled: it exceeds the samples by what a parabola rises within one step. */
TEST(quantities_agree_with_a_dense_sampling) {
    static const double frictions[] = {10.0, 0.6, 0.2};
    const double step = 1e-3;
    for (int i = 0; i < 3; ++i) {
        runner runner = runner_default(frictions[i]);
        runner_start(&runner);
        const sampling seen = sample_stride(&runner, step);
        const tdmf_stride stride = last_stride_of(&runner.motion);
        assert_close(stride.stance_time, seen.stance_time, 1e-11);
        assert_close(stride.slip_distance, seen.slip_distance, 1e-11);
        assert_true(stride.peak_force >= seen.largest_force);
        assert_close(stride.peak_force, seen.largest_force, 10.0 * step * step);
        assert_true(stride.peak_vertical_force == stride.peak_force);
        assert_close(stride.period, seen.time[1] - seen.time[0], 1e-13);
        assert_close(stride.length, seen.com_x[1] - seen.com_x[0], 1e-13);
        assert_close(stride.speed, stride.length / stride.period, 1e-15);
        assert_close(stride.duty_factor, stride.stance_time / stride.period, 1e-15);
        assert_close(stride.work, seen.work[1] - seen.work[0], 1e-15);
        assert_close(stride.positive_work, seen.positive_work[1] - seen.positive_work[0], 1e-15);
        assert_true(stride.positive_work >= stride.work && stride.positive_work > 0.0);
        assert_close(stride.cost_of_transport, stride.work / (1.1 * 0.01 * stride.length), 1e-15);
    }
}

/* On a slope the vertical force differs from the normal force and peaks at another time. It jumps when the
 * foot comes to rest. */
TEST(both_peaks_of_the_force_are_found_on_a_slope) {
    static const double slopes[] = {-0.14, -0.05, 0.02, 0.05};
    static const double frictions[] = {10.0, 0.6, 0.2};
    const double step = 1e-3;
    int apart = 0;
    for (int i = 0; i < 12; ++i) {
        runner runner = runner_default(frictions[i % 3]);
        runner.inputs.ground.slope = slopes[i / 3];
        runner_start(&runner);
        tdmf_motion native = runner.motion, cvode = native;
        tdmf_solver solver = tdmf_solver_default();
        const sampling seen = sample_stride(&runner, step);
        const tdmf_stride stride = last_stride_of(&runner.motion);
        assert_true(tdmf_native_stride(&solver, SYSTEM_OF(&runner), 1e3, &native).closed);
        /* two functions of one force, rounded in two ways */
        assert_true(stride.peak_vertical_force >= seen.largest_vertical_force * (1.0 - 1e-15));
        assert_close(stride.peak_vertical_force, seen.largest_vertical_force, 10.0 * step * step);
        assert_close(last_stride_of(&native).peak_vertical_force, stride.peak_vertical_force, 1e-9);
        assert_close(last_stride_of(&native).peak_force, stride.peak_force, 1e-9);
        apart += fabs(stride.peak_vertical_force - stride.peak_force) > 1e-4;
        if (tdmf_cvode_is_available()) {
            assert_int_equal(
                tdmf_cvode_advance(&solver, SYSTEM_OF(&runner), NULL, runner.motion.time + 1e-3, &cvode),
                TDMF_ARRIVED);
            assert_close(last_stride_of(&cvode).peak_vertical_force, stride.peak_vertical_force, 1e-8);
        }
    }
    assert_true(apart >= 6);
}

/* A still leg at 0.3 rad under 0.101 N, 0.1 N of them from the body. */
TEST(outputs_follow_the_motion) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, 0.3, 0.101);
    const tdmf_outputs outputs = OUTPUTS_OF(&runner);
    const double length = 1.0 - 0.1 / cos(0.3);
    assert_close(outputs.body.x, -length * sin(0.3), 1e-15);
    assert_close(outputs.body.y, length * cos(0.3), 1e-15);
    assert_close(outputs.com.x, outputs.body.x / 1.1, 1e-15);
    assert_close(outputs.com.y, outputs.body.y / 1.1, 1e-15);
    assert_close(outputs.contact.fx, -0.1 * tan(0.3), 1e-15);
    assert_close(outputs.contact.fy, 0.101, 1e-15);
    assert_true(outputs.hip.torque == 0.0 && outputs.energy.kinetic == 0.0);
    assert_close(outputs.energy.elastic, 0.5 * (0.1 / cos(0.3)) * (0.1 / cos(0.3)), 1e-15);
    assert_close(outputs.energy.potential, 0.01 * outputs.body.y, 1e-15);
    assert_close(outputs.energy.total, outputs.energy.potential + outputs.energy.elastic, 1e-15);
    runner.motion.mode.fallen = true;
    assert_int_equal(outputs.status.fallen, 0);
    assert_int_equal(OUTPUTS_OF(&runner).status.fallen, 1);
}

/* Not what the run has done since its start. */
TEST(a_second_stride_counts_its_own_work_only) {
    runner runner = runner_default(0.6);
    runner_start(&runner);
    runner_stride(&runner, 0.01);
    const double work = runner.motion.state[TDMF_HIP_WORK],
                 positive = runner.motion.state[TDMF_HIP_POSITIVE_WORK];
    const double at = tdmf_center_of_mass(&runner.model, runner.motion.state).x;
    runner_stride(&runner, 0.01);
    const tdmf_stride stride = last_stride_of(&runner.motion);
    const tdmf_outputs outputs = OUTPUTS_OF(&runner);
    assert_string_equal(outputs.stride.word, "+0-0+");
    assert_true(outputs.apex.com_height == outputs.com.y && outputs.apex.com_speed == outputs.com.vx);
    assert_true(outputs.apex.time == runner.motion.time && outputs.event.last_time == runner.motion.time);
    assert_true(outputs.energy.impact_loss == runner.motion.state[TDMF_ENERGY_IMPACT_LOSS]);
    assert_true(outputs.hip.liftoff_angle == runner.motion.state[TDMF_HIP_LIFTOFF_ANGLE]);
    assert_int_equal(stride.count, 2);
    assert_close(stride.work, runner.motion.state[TDMF_HIP_WORK] - work, 1e-15);
    assert_close(stride.positive_work, runner.motion.state[TDMF_HIP_POSITIVE_WORK] - positive, 1e-15);
    assert_close(stride.length, tdmf_center_of_mass(&runner.model, runner.motion.state).x - at, 1e-13);
    assert_true(positive > 0.0);
}
