/* Ground forces and the friction cone. That the forces are right follows from Lagrange's equations in
 * test_dynamics.c; here are their signs and limits. */
#include "compare.h"
#include "scene.h"

#include <math.h>

static tdmf_ground_force force_of(const runner *runner) {
    return tdmf_contact_force(SYSTEM_OF(runner), &runner->motion.mode, runner->motion.state);
}

/* A vertical leg at its free length carries nothing; the foot's own weight rests on the ground. */
TEST(unloaded_leg_leaves_the_weight_of_the_foot) {
    runner runner = scene_on_ground(TDMF_CONTACT_STICK, 0.0, 0.0);
    runner.motion.state[TDMF_LEG_LENGTH] = 1.0;
    assert_close(force_of(&runner).normal, 0.1 * 0.01, 1e-17);
    assert_true(force_of(&runner).tangential == 0.0);
}

/* A still leg pushes the foot away from the body: ahead of it, the ground holds back. */
TEST(sticking_force_points_along_the_leg) {
    const runner ahead = scene_on_ground(TDMF_CONTACT_STICK, 0.5, 0.101);
    const runner behind = scene_on_ground(TDMF_CONTACT_STICK, -0.5, 0.101);
    assert_close(force_of(&ahead).tangential, -0.1 * tan(0.5), 1e-15);
    assert_close(force_of(&behind).tangential, 0.1 * tan(0.5), 1e-15);
}

TEST(friction_opposes_the_slip) {
    runner runner = scene_on_ground(TDMF_CONTACT_SLIP_POSITIVE, 0.5, 0.2);
    runner.inputs.ground.friction = 0.25;
    assert_close(force_of(&runner).tangential, -0.05, 1e-15);
    runner.motion.mode.contact = TDMF_CONTACT_SLIP_NEGATIVE;
    assert_close(force_of(&runner).tangential, 0.05, 1e-15);
}

TEST(no_force_off_the_ground_and_in_graze) {
    random_source source = {21};
    static const tdmf_contact_mode modes[] = {TDMF_CONTACT_FLIGHT, TDMF_CONTACT_GRAZE};
    for (int i = 0; i < 2; ++i) {
        const runner runner = scene_random(&source, modes[i]);
        assert_true(force_of(&runner).tangential == 0.0 && force_of(&runner).normal == 0.0);
    }
}

TEST(only_stick_and_slip_are_contact) {
    static const bool contact[] = {false, true, true, true, false};
    static const double sign[] = {0.0, 0.0, 1.0, -1.0, 0.0};
    for (int i = 0; i < 5; ++i) {
        const tdmf_mode mode = {.contact = (tdmf_contact_mode)(TDMF_CONTACT_FLIGHT + i)};
        assert_true(tdmf_in_contact(&mode) == contact[i]);
        assert_true(tdmf_slip_sign(&mode) == sign[i]);
    }
}
