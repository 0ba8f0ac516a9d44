/* The impact map: a perfectly inelastic impact of the foot under Coulomb friction. */
#include "compare.h"
#include "scene.h"

#include <float.h>
#include <math.h>

/* A foot about to hit the ground at (vx, vy) under a moving body; unit model. */
static runner falling_foot(double vx, double vy) {
    runner runner = scene_in_flight(TDMF_PHASE_PLACE, -1.0);
    runner.motion.state[TDMF_FOOT_Y] = 0.0;
    runner.motion.state[TDMF_LEG_ANGLE] = 0.4;
    runner.motion.state[TDMF_FOOT_VX] = vx;
    runner.motion.state[TDMF_FOOT_VY] = vy;
    return runner;
}

static double impact(runner *runner, double friction) {
    tdmf_inputs inputs = runner->inputs;
    inputs.ground.friction = friction;
    return impact_on((tdmf_system){&runner->model, &inputs}, &runner->motion.mode.ground,
                     runner->motion.state);
}

static double total_energy(const runner *runner) {
    return OUTPUTS_OF(runner).energy.total;
}

static double vx_after(double vx, double vy, double friction) {
    runner runner = falling_foot(vx, vy);
    impact(&runner, friction);
    assert_true(runner.motion.state[TDMF_FOOT_VY] == 0.0);
    assert_true(runner.motion.state[TDMF_FOOT_Y] == 0.0);
    return runner.motion.state[TDMF_FOOT_VX];
}

/* Sum of the sizes of the energy's parts, which may cancel on low ground. */
static double size_of_energy(const runner *runner) {
    const tdmf_outputs now = OUTPUTS_OF(runner);
    return now.energy.kinetic + fabs(now.energy.potential) + now.energy.elastic;
}

/* Newton and Coulomb at one random impact. */
static void assert_is_impact(const runner *before, double friction) {
    runner after = *before;
    const double foot_mass = before->model.parameters.foot.mass;
    const double loss = impact(&after, friction);
    const double energy = total_energy(before);
    const double speed_scale = before->model.scales.speed;
    const tdmf_point body_before = tdmf_body(before->motion.state);
    const tdmf_point body_after = tdmf_body(after.motion.state);
    assert_close(body_after.vx, body_before.vx, 1e-13 * speed_scale);
    assert_close(body_after.vy, body_before.vy, 1e-13 * speed_scale);

    const tdmf_point foot_before = tdmf_foot_over_ground(&before->motion.mode.ground, before->motion.state);
    const tdmf_point foot_after = tdmf_foot_over_ground(&before->motion.mode.ground, after.motion.state);
    const double along = foot_mass * (foot_after.vx - foot_before.vx);
    const double up = foot_mass * (foot_after.vy - foot_before.vy);
    assert_close(foot_after.y, 0.0, 1e-14 * before->model.scales.length);
    assert_close(foot_after.vy, 0.0, 1e-14 * speed_scale);
    assert_true(up > 0.0);
    const double at_rest = before->model.parameters.ground.static_friction_ratio * friction;
    assert_true(fabs(along) <= at_rest * up + 4.0 * DBL_EPSILON * foot_mass * speed_scale);
    if (foot_after.vx != 0.0) {
        /* It slides on in its direction, braked by all that the cone allows. */
        assert_true(foot_after.vx * foot_before.vx > 0.0);
        assert_close(fabs(along), friction * up, 1e-13 * foot_mass * speed_scale);
    }
    assert_true(loss >= 0.0);
    assert_close(energy - total_energy(&after), loss, 1e-12 * size_of_energy(before));
}

/* Onto its ground; false where it moves away from that. */
static bool put_at_impact(runner *runner) {
    const tdmf_ground_line *ground = &runner->motion.mode.ground;
    const tdmf_point foot = tdmf_foot_over_ground(ground, runner->motion.state);
    runner->motion.state[TDMF_FOOT_X] += foot.y * ground->sine;
    runner->motion.state[TDMF_FOOT_Y] -= foot.y * ground->cosine;
    return foot.vy < 0.0;
}

TEST(random_impacts_obey_newton_and_coulomb) {
    random_source source = {11};
    int impacts = 0;
    for (int i = 0; i < 10000; ++i) {
        runner runner = scene_random(&source, TDMF_CONTACT_FLIGHT);
        if (!put_at_impact(&runner)) {
            continue;
        }
        ++impacts;
        assert_is_impact(&runner, runner.inputs.ground.friction);
    }
    assert_true(impacts > 4000);
}

/* 0.75 * 0.5 is exact, so these are the last number inside the cone and the first outside. */
TEST(sticks_up_to_the_edge_of_the_cone) {
    const double edge = 0.75 * 0.5;
    const double outside = nextafter(edge, 1.0);
    assert_true(vx_after(edge, -0.5, 0.75) == 0.0);
    assert_true(vx_after(-edge, -0.5, 0.75) == 0.0);
    assert_true(vx_after(nextafter(edge, 0.0), -0.5, 0.75) == 0.0);
    assert_true(vx_after(outside, -0.5, 0.75) == outside - edge);
    assert_true(vx_after(-outside, -0.5, 0.75) == edge - outside);
    /* Without friction it slides on, with a huge one it sticks. */
    assert_true(vx_after(-0.3, -0.5, 0.0) == -0.3 && vx_after(0.0, -0.5, 0.0) == 0.0);
    assert_true(vx_after(1e3, -0.5, 1e6) == 0.0);
}

/* rho = 1.5: inside its cone of 1.5 * 0.5 * 0.5 the foot sticks, outside it slides with the friction itself.
 */
TEST(static_friction_decides_whether_it_sticks) {
    const double edge = 1.5 * 0.5 * 0.5;
    for (double sign = -1.0; sign < 2.0; sign += 2.0) {
        runner inside = falling_foot(sign * edge, -0.5), outside = falling_foot(sign * 0.4, -0.5);
        inside.model.parameters.ground.static_friction_ratio = 1.5;
        outside.model.parameters.ground.static_friction_ratio = 1.5;
        impact(&inside, 0.5);
        impact(&outside, 0.5);
        assert_true(inside.motion.state[TDMF_FOOT_VX] == 0.0);
        assert_close(outside.motion.state[TDMF_FOOT_VX], sign * 0.15, 1e-15);
    }
}

/* The smallest velocities there are: nothing is gained, nothing turns round. */
TEST(tiny_velocities_are_no_exception) {
    static const double tiny[] = {DBL_MIN, 4.9406564584124654e-324, 1e-310, 1e-200};
    for (int i = 0; i < 16; ++i) {
        runner runner = falling_foot(tiny[i / 4], -tiny[i % 4]);
        const double loss = impact(&runner, 0.5);
        const double vx = runner.motion.state[TDMF_FOOT_VX];
        assert_true(loss >= 0.0 && loss < 1e-300);
        assert_true(vx >= 0.0 && vx <= tiny[i / 4]);
        assert_true(runner.motion.state[TDMF_FOOT_VY] == 0.0);
    }
}
