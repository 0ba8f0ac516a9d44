/* Thousands of random runners from random starts: whatever the parameters, a run goes on or falls, in finite
 * numbers, without endless chains of events, and keeps to the constraints of its modes.
 *
 * A fixed step is stable and fair only if it is short against the fastest rate at hand: the damper and spring
 * of the light foot, the hip's gains on the inertia of the leg, and the present rates of the leg. The step is
 * chosen from these as the run goes on, so that no combination has to be left out. */
#include "compare.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"

#include <math.h>

enum { RUNS = sample_of(4000), STEPS = 3000, STEPS_PER_INPUT = 500, MAX_EVENTS_PER_STEP = 20 };

/* ---- a random run ----------------------------------------------------------------------------------- */

static double reduced_mass(const tdmf_parameters *p) {
    return 1.0 / (1.0 / p->body.mass + 1.0 / p->foot.mass);
}

/* Of foot and body on leg and hip, the leg as it is now. */
static double fastest_rate(const runner *runner) {
    const tdmf_parameters *p = &runner->model.parameters;
    const double mass = reduced_mass(p);
    const double length = runner->motion.state[TDMF_LEG_LENGTH];
    const double inertia = mass * length * length;
    const double linear = p->leg.damping / mass + sqrt(p->leg.stiffness / mass);
    const double angular = p->hip.kd / inertia + sqrt(p->hip.kp / inertia);
    const double moving = fabs(runner->motion.state[TDMF_LEG_ANGLE_RATE]) +
                          fabs(runner->motion.state[TDMF_LEG_LENGTH_RATE]) / length;
    return linear + angular + moving;
}

static double random_step(const runner *runner) {
    return 0.3 / fastest_rate(runner);
}

static void choose_start_on_ground(random_source *source, runner *runner) {
    const tdmf_ground_line *ground = &runner->motion.mode.ground;
    double *state = runner->motion.state;
    tdmf_point foot = tdmf_foot_over_ground(ground, state);
    if (random_chance(source, 0.5)) {
        foot.vy = 0.0;
    }
    if (random_chance(source, 0.5)) {
        foot.vx = 0.0;
    }
    state[TDMF_FOOT_X] = foot.x * ground->cosine;
    state[TDMF_FOOT_Y] = ground->height + foot.x * ground->sine;
    state[TDMF_FOOT_VX] = foot.vx * ground->cosine - foot.vy * ground->sine;
    state[TDMF_FOOT_VY] = foot.vx * ground->sine + foot.vy * ground->cosine;
}

/* Exact zeros, and a leg at its free length, are where comparisons may go either way. */
static void choose_degenerate_values(random_source *source, runner *runner) {
    static const int elements[] = {TDMF_LEG_ANGLE, TDMF_FOOT_VX, TDMF_FOOT_VY, TDMF_LEG_LENGTH_RATE,
                                   TDMF_LEG_ANGLE_RATE};
    for (int i = 0; i < 5; ++i) {
        if (random_chance(source, 0.5)) {
            runner->motion.state[elements[i]] = 0.0;
        }
    }
    if (random_chance(source, 0.5)) {
        runner->motion.state[TDMF_LEG_LENGTH] = runner->model.parameters.leg.free_length;
    }
}

/* Starts lie anywhere in the air, at an apex, or on the ground. */
static void choose_start(random_source *source, runner *runner) {
    if (random_chance(source, 0.2)) {
        choose_degenerate_values(source, runner);
    }
    if (random_chance(source, 0.3)) {
        choose_start_on_ground(source, runner);
    } else if (random_chance(source, 0.2)) {
        scene_set_com_vy(runner, 0.0);
    }
}

static void scale_randomly(random_source *source, double *value, double max_factor) {
    *value *= random_magnitude(source, 1.0 / max_factor, max_factor);
}

/* Table 1 and its gait, each number off by up to a third: these mostly run. */
static runner near_the_gait(random_source *source) {
    static const double max_factor = 1.3;
    runner runner = runner_default(random_magnitude(source, 0.1, 10.0));
    tdmf_parameters p = runner.model.parameters;
    double *const varied[] = {&p.foot.mass,          &p.leg.damping, &p.gravity,
                              &p.hip.stance_torque,  &p.hip.kp,      &p.hip.kd,
                              &p.hip.touchdown_angle};
    for (size_t i = 0; i < sizeof varied / sizeof varied[0]; ++i) {
        scale_randomly(source, varied[i], max_factor);
    }
    p.hip.swing_clamp = random_truth(*source);
    runner.model = accepted_model(&p);
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        scale_randomly(source, &runner.motion.state[i], i == TDMF_LEG_LENGTH ? 1.05 : max_factor);
    }
    runner.inputs.hip.external_torque =
        random_chance(source, 0.5) ? 0.0 : random_uniform(source, -0.02, 0.02);
    return runner;
}

/* A line that passes above or below the foot. */
static void set_ground_near_foot(random_source *source, runner *runner) {
    const double slope = random_uniform(source, -0.6, 0.6);
    const double step = random_uniform(source, -1.0, 1.0) * runner->model.scales.length;
    runner->inputs.ground.slope = slope;
    runner->inputs.ground.height =
        runner->motion.state[TDMF_FOOT_Y] - runner->motion.state[TDMF_FOOT_X] * tan(slope) + step;
}

/* Below the line that has been set last. */
static bool foot_waits_below(const runner *runner) {
    const tdmf_ground_line line =
        tdmf_ground_line_of(runner->inputs.ground.height, runner->inputs.ground.slope);
    return tdmf_foot_over_ground(&line, runner->motion.state).y < 0.0;
}

static void switch_inputs(random_source *source, runner *runner) {
    const tdmf_inputs before = runner->inputs;
    runner->inputs = scene_random_inputs(source, &runner->model);
    runner->inputs.ground.height = before.ground.height;
    runner->inputs.ground.slope = before.ground.slope;
    if (random_chance(source, 0.3)) {
        set_ground_near_foot(source, runner);
    }
    scene_resolve(runner);
    assert_true(runner->motion.mode.contact != TDMF_CONTACT_FLIGHT || foot_waits_below(runner) ||
                (runner->motion.mode.ground.height == runner->inputs.ground.height &&
                 runner->motion.mode.ground.slope == runner->inputs.ground.slope));
}

/* ---- what must hold --------------------------------------------------------------------------------- */

static void assert_finite(const runner *runner) {
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        assert_true(isfinite(runner->motion.state[i]));
    }
    assert_true(isfinite(runner->motion.record.impact_loss));
    assert_true(isfinite(runner->motion.mode.liftoff_angle));
}

static void assert_mode_invariants(const runner *runner) {
    const tdmf_mode *mode = &runner->motion.mode;
    const double *state = runner->motion.state;
    const double margin = 2.0 * TDMF_GUARD_MARGIN * runner->model.scales.speed;
    const bool in_contact = tdmf_in_contact(mode);
    const tdmf_point foot = tdmf_foot_over_ground(&mode->ground, state);
    if (mode->contact != TDMF_CONTACT_FLIGHT) {
        assert_close(foot.y, 0.0, 1e-12 * runner->model.scales.length);
        assert_close(foot.vy, 0.0, 1e-12 * runner->model.scales.speed);
    }
    assert_true(mode->contact != TDMF_CONTACT_STICK || foot.vx == 0.0);
    assert_true(tdmf_slip_sign(mode) * foot.vx >= -margin);
    assert_true(in_contact == (mode->phase == TDMF_PHASE_DRIVE || mode->phase == TDMF_PHASE_COAST));
    assert_true(!in_contact || mode->mid_stance_pending == (mode->phase == TDMF_PHASE_DRIVE));
    assert_true(!mode->clamp_closed ||
                (mode->phase == TDMF_PHASE_RETRACT && runner->model.parameters.hip.swing_clamp));
}

static void assert_above_ground(const runner *runner) {
    const double length = runner->model.scales.length;
    const tdmf_ground_line *ground = &runner->motion.mode.ground;
    const tdmf_point body = tdmf_body(runner->motion.state);
    const double body_height = ground->cosine * (body.y - ground->height) - ground->sine * body.x;
    assert_true(tdmf_foot_over_ground(ground, runner->motion.state).y >= -1e-9 * length);
    assert_true(runner->motion.mode.fallen || body_height >= -1e-9 * length);
}

/* The vertical ground force never pulls, friction never exceeds its cone. */
static void assert_force_is_possible(const runner *runner) {
    const tdmf_ground_force force =
        tdmf_contact_force(SYSTEM_OF(runner), &runner->motion.mode, runner->motion.state);
    const double slack = 1e-9 * (runner->model.scales.force + fabs(force.tangential));
    assert_true(force.normal >= -slack);
    const double ratio = runner->motion.mode.contact == TDMF_CONTACT_STICK
                             ? runner->model.parameters.ground.static_friction_ratio
                             : 1.0;
    assert_true(fabs(force.tangential) <= ratio * runner->inputs.ground.friction * force.normal + slack);
}

static void assert_sound(const runner *runner) {
    assert_finite(runner);
    assert_above_ground(runner);
    if (!runner->motion.mode.fallen) {
        assert_mode_invariants(runner);
        assert_force_is_possible(runner);
    }
}

/* A full step forward; however many events it is cut into, they are few. */
static bool step_forward(runner *runner) {
    const double end = runner->motion.time + random_step(runner);
    const long before = runner->resolutions;
    while (runner->motion.time < end) {
        const double left = end - runner->motion.time;
        const double time = runner->motion.time;
        if (!runner_advance(runner, left)) {
            return false;
        }
        assert_true(runner->resolutions - before <= MAX_EVENTS_PER_STEP);
        if (runner->motion.time == time) {
            return true; /* what is left is less than the clock resolves */
        }
    }
    return true;
}

/* How many steps ended in which mode, how many strides closed, how many runs fell. */
typedef struct {
    long contact[TDMF_CONTACT_GRAZE + 1], phase[TDMF_PHASE_PLACE + 1], strides, falls;
} tally;

static void count(tally *tally, const runner *runner) {
    ++tally->contact[runner->motion.mode.contact];
    ++tally->phase[runner->motion.mode.phase];
    tally->falls += runner->motion.mode.fallen;
}

static void run(random_source *source, runner *runner, bool switching, tally *tally) {
    bool goes_on = true;
    for (int i = 1; i <= STEPS && goes_on; ++i) {
        goes_on = step_forward(runner);
        assert_sound(runner);
        assert_true(goes_on || runner->motion.mode.fallen);
        count(tally, runner);
        if (goes_on && switching && i % STEPS_PER_INPUT == 0) {
            switch_inputs(source, runner);
            assert_sound(runner);
            goes_on = !runner->motion.mode.fallen;
        }
    }
    tally->strides += runner->motion.record.stride.count;
}

static void begin(runner *runner) {
    runner_start(runner);
    assert_sound(runner);
}

/* ---- tests ------------------------------------------------------------------------------------------ */

/* The sample must have met what it is meant to meet. */
static void assert_saw_everything(const tally *seen) {
    for (int contact = TDMF_CONTACT_FLIGHT; contact <= TDMF_CONTACT_GRAZE; ++contact) {
        assert_true(seen->contact[contact] > sample_of(500));
    }
    for (int phase = TDMF_PHASE_DRIVE; phase <= TDMF_PHASE_PLACE; ++phase) {
        assert_true(seen->phase[phase] > sample_of(500));
    }
    assert_true(seen->strides > sample_of(50) && seen->falls > sample_of(50));
}

TEST(any_runner_goes_on_or_falls) {
    tally seen = {{0}, {0}, 0, 0};
    for (uint64_t seed = 0; seed < RUNS; ++seed) {
        random_source source = {seed};
        runner runner = scene_random(&source, TDMF_CONTACT_FLIGHT);
        runner.inputs.ground.height = runner.motion.mode.ground.height;
        runner.inputs.ground.slope = runner.motion.mode.ground.slope;
        choose_start(&source, &runner);
        begin(&runner);
        run(&source, &runner, random_chance(&source, 0.5), &seen);
    }
    assert_saw_everything(&seen);
}

TEST(runner_near_the_gait_goes_on_or_falls) {
    tally seen = {{0}, {0}, 0, 0};
    for (uint64_t seed = 0; seed < RUNS / 4; ++seed) {
        random_source source = {seed};
        runner runner = near_the_gait(&source);
        begin(&runner);
        run(&source, &runner, random_chance(&source, 0.2), &seen);
    }
    assert_saw_everything(&seen);
}
