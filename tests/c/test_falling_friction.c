/* Friction that falls with speed: the impact's law and its tangent, the limits in which it is Coulomb's
 * again, the energy that it takes, and friction that ramps. The gaits of an independent program are in
 * test_gaits.c. */
#include "by_page.h"
#include "compare.h"
#include "integrate.h"
#include "reference_gaits.h"
#include "scene.h"
#include "simulation.h"

#include "tdmf_slip/cvode.h"
#include "tdmf_slip/tdmf_slip.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* ---- impacts ------------------------------------------------------------------------------------------- */

/* dv = -mu(v) dP, integrated by an independent program. */
typedef struct {
    double speed_before, normal_speed, friction, ratio, velocity; /* `velocity` is v_s */
    double speed_after, stopped;                                  /* up to which it comes to rest */
} reference_impact;

static const reference_impact reference_impacts[] = {
    {1.06, 0.127, 0.6, 1.5, 0.1, 0.9837985765917379, 0.09983629768634218},
    {0.1, 0.127, 0.6, 1.5, 0.1, 0.00020730569894006055, 0.09983629768634218},
    {0.09, 0.127, 0.6, 1.5, 0.1, 0.0, 0.09983629768634218},
    {0.095, 0.127, 0.6, 1.5, 0.1, 0.0, 0.09983629768634218},
    {1.0, 0.12, 0.3, 2.0, 1.0, 0.9504233202384479, 0.07074890886680052},
    {0.25, 0.2, 1.0, 1.5, 0.02, 0.049161868434265274, 0.20810899949367467},
    {0.215, 0.2, 1.0, 1.5, 0.02, 0.009611732581818869, 0.20810899949367467},
    {0.2, 0.2, 1.0, 1.5, 0.02, 0.0, 0.20810899949367467},
    {1.0, 0.12, 0.3, 2.0, 0.001, 0.964, 0.036693147180559944},
};
enum { IMPACTS = COUNT_OF(reference_impacts) };

/* A foot about to hit the ground under that law, at a speed along it. */
static runner falling_foot(const reference_impact *law, double speed) {
    runner runner = scene_in_flight(TDMF_PHASE_PLACE, -1.0);
    runner.model.parameters.ground.static_friction_ratio = law->ratio;
    runner.model.parameters.ground.stribeck_velocity = law->velocity;
    runner.inputs.ground.friction = law->friction;
    runner.motion.state[TDMF_FOOT_Y] = 0.0;
    runner.motion.state[TDMF_LEG_ANGLE] = 0.4;
    runner.motion.state[TDMF_FOOT_VX] = speed;
    runner.motion.state[TDMF_FOOT_VY] = -law->normal_speed;
    return runner;
}

static double speed_after(const reference_impact *law, double speed) {
    runner runner = falling_foot(law, speed);
    impact_on(SYSTEM_OF(&runner), &runner.motion.mode.ground, runner.motion.state);
    return runner.motion.state[TDMF_FOOT_VX];
}

TEST(impacts_are_those_of_the_integral) {
    for (int i = 0; i < IMPACTS; ++i) {
        const reference_impact *law = &reference_impacts[i];
        const double after = speed_after(law, law->speed_before);
        assert_close(after, law->speed_after, 2e-15);
        assert_true(speed_after(law, -law->speed_before) == -after);
        assert_true(speed_after(law, law->stopped * (1.0 - 1e-15)) == 0.0);
        const double just_slips = speed_after(law, law->stopped * (1.0 + 1e-9));
        assert_true(just_slips > 0.0 && just_slips < 1.01e-9 * law->ratio * law->stopped);
    }
}

/* Kinetic energy of the foot that friction dissipates at an impact is impact loss. */
TEST(an_impact_loses_what_the_foot_does) {
    for (int i = 0; i < IMPACTS; ++i) {
        const reference_impact *law = &reference_impacts[i];
        runner runner = falling_foot(law, law->speed_before);
        const double before = OUTPUTS_OF(&runner).energy.total;
        const double loss = impact_on(SYSTEM_OF(&runner), &runner.motion.mode.ground, runner.motion.state);
        const double after = OUTPUTS_OF(&runner).energy.total;
        assert_true(loss > 0.0);
        assert_close(before - after, loss, 1e-14);
    }
}

/* mu(v+)/mu(v-) and the like. */
static double coefficient(const reference_impact *law, double speed) {
    return law->friction * (1.0 + (law->ratio - 1.0) * exp(-fabs(speed) / law->velocity));
}

static double variation_of_speed(const reference_impact *law, double speed, double d_speed, double d_normal,
                                 double d_friction) {
    const runner given = falling_foot(law, speed);
    const double d_state[TDMF_STATE_COUNT] = {[TDMF_FOOT_VX] = d_speed, [TDMF_FOOT_VY] = d_normal};
    const tdmf_seed seed = {.inputs.ground.friction = d_friction};
    double varied[TDMF_STATE_COUNT];
    vary_run(SYSTEM_OF(&given), given.motion.state, &seed, d_state, 0.0, varied);
    return varied[TDMF_FOOT_VX];
}

TEST(the_impacts_tangent_is_a_ratio_of_frictions) {
    int slipped = 0;
    for (int i = 0; i < 2 * IMPACTS; ++i) {
        const reference_impact *law = &reference_impacts[i / 2];
        const double sign = i % 2 == 0 ? 1.0 : -1.0;
        const double speed = sign * law->speed_before;
        const bool slips = law->speed_after != 0.0;
        const double after = coefficient(law, law->speed_after), before = coefficient(law, law->speed_before);
        assert_close(variation_of_speed(law, speed, 1.0, 0.0, 0.0), slips ? after / before : 0.0, 1e-12);
        assert_close(variation_of_speed(law, speed, 0.0, -1.0, 0.0), slips ? -sign * after : 0.0, 1e-12);
        assert_close(variation_of_speed(law, speed, 0.0, 0.0, 1.0),
                     slips ? -sign * after * law->normal_speed / law->friction : 0.0, 1e-12);
        slipped += slips;
    }
    assert_int_equal(slipped, 2 * 6);
}

TEST(the_widest_fall_is_none_and_the_narrowest_is_one_at_once) {
    for (int i = 0; i < IMPACTS; ++i) {
        reference_impact wide = reference_impacts[i], narrow = wide;
        const double taken = wide.friction * wide.normal_speed;
        wide.velocity = 1e9;
        narrow.velocity = 1e-9;
        assert_close(speed_after(&wide, wide.speed_before), fmax(0.0, wide.speed_before - wide.ratio * taken),
                     1e-8);
        assert_close(speed_after(&narrow, narrow.speed_before), fmax(0.0, narrow.speed_before - taken), 1e-8);
    }
}

/* ---- while the friction ramps -------------------------------------------------------------------------- */

/* A runner whose ground gets slippery, or grips more and more, with a patch or without. */
typedef struct {
    double friction, rate, velocity, patch_begin, patch_end;
} ramped_run;

static const ramped_run ramped_runs[] = {{0.6, -0.01, 0.1, 0.0, 0.0},     {0.2, 0.01, 0.1, 0.0, 0.0},
                                         {0.3, -0.01, 1e-3, 0.0, 0.0},    {0.6, -0.01, 0.1, 1.0, 30.0},
                                         {0.2, 0.005, 0.02, 10.0, 40.0},  {0.05, -0.005, 0.1, 0.0, 0.0},
                                         {0.4, -0.005, 10.0, -1.0, 25.0}, {0.4, 0.03, 1e-3, -10.0, 100.0}};
enum { RAMPED_RUNS = COUNT_OF(ramped_runs) };

static int slips_of(const tdmf_event_log *log) {
    int slips = 0;
    for (int i = 0; i < log->count; ++i) {
        slips += log->events[i].guard == TDMF_GUARD_SLIP_VELOCITY_ZERO ||
                 log->events[i].guard == TDMF_GUARD_PATCH_BORDER;
    }
    return slips;
}

/* CVODE asks the right-hand side for mu(t); the native solver has the ramp in its series. */
TEST(series_of_a_ramped_friction_agree_with_cvode) {
    int slips = 0;
    for (int i = 0; i < RAMPED_RUNS && tdmf_cvode_is_available(); ++i) {
        const ramped_run *run = &ramped_runs[i];
        runner runner = runner_default(run->friction);
        runner.model.parameters.ground.static_friction_ratio = 1.5;
        runner.model.parameters.ground.stribeck_velocity = run->velocity;
        runner.model.parameters.ground.patch_begin = run->patch_begin;
        runner.model.parameters.ground.patch_end = run->patch_end;
        simulation native = simulation_of(&runner, 1e-13);
        native.rates.ground.friction = run->rate;
        simulation cvode = native;
        assert_int_equal(simulation_advance(&native, 60.0), TDMF_ARRIVED);
        assert_int_equal(simulation_advance_by(tdmf_cvode_advance, &cvode, 60.0), TDMF_ARRIVED);
        assert_int_equal(native.motion.state[TDMF_EVENT_COUNT], cvode.motion.state[TDMF_EVENT_COUNT]);
        assert_same_state(&native.motion, &cvode.motion, 1e-8);
        slips += slips_of(&native.log);
    }
    assert_true(!tdmf_cvode_is_available() || slips >= RAMPED_RUNS);
}
