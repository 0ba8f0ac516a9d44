/* Exact directional derivatives against numerical differentiation, in every mode. */
#include "by_page.h"
#include "compare.h"
#include "differentiate.h"
#include "line.h"
#include "sample.h"
#include "simulation.h"
#include "system_of.h"

#include <math.h>
#include <string.h>

enum { UNKNOWNS = TDMF_STATE_COUNT + VARIED_OUTPUTS };

typedef struct {
    line line;
    int unknown;
} unknown_line;

static void list_outputs(const tdmf_outputs *o, double values[VARIED_OUTPUTS]) {
    const double all[VARIED_OUTPUTS] = {o->body.x,           o->body.y,         o->body.vx,
                                        o->body.vy,          o->com.x,          o->com.y,
                                        o->com.vx,           o->com.vy,         o->contact.normal,
                                        o->contact.fx,       o->contact.fy,     o->contact.tangential,
                                        o->hip.torque,       o->leg.force,      o->energy.kinetic,
                                        o->energy.potential, o->energy.elastic, o->energy.total};
    memcpy(values, all, sizeof all);
}

static void values_of(const runner *runner, double values[UNKNOWNS]) {
    const tdmf_outputs outputs = OUTPUTS_OF(runner);
    tdmf_derivatives(SYSTEM_OF(runner), &runner->motion.mode, runner->motion.state, values);
    list_outputs(&outputs, values + TDMF_STATE_COUNT);
}

static long double unknown_on_line(long double t, const void *context) {
    const unknown_line *on = context;
    double values[UNKNOWNS];
    const runner moved = line_at(&on->line, (double)t);
    values_of(&moved, values);
    return values[on->unknown];
}

/* Rounding of a force or energy among much larger ones, over the step, is what differences cannot see. */
static double numerical_noise(const unknown_line *on) {
    const long double end = 4.0L * (long double)LINE_STEP;
    return fmax(fabs((double)unknown_on_line(-end, on)), fabs((double)unknown_on_line(end, on))) / LINE_STEP;
}

/* Positive work has a kink where the power changes its sign. */
static bool differentiable(const unknown_line *on) {
    double here[UNKNOWNS];
    values_of(on->line.runner, here);
    for (int i = -4; i <= 4; ++i) {
        const runner moved = line_at(&on->line, i * LINE_STEP);
        double there[UNKNOWNS];
        values_of(&moved, there);
        if (on->unknown == TDMF_HIP_POSITIVE_WORK && !(here[TDMF_HIP_WORK] * there[TDMF_HIP_WORK] > 0.0)) {
            return false;
        }
    }
    return true;
}

static void variation_agrees_on(const line *line) {
    const runner *runner = line->runner;
    double exact[UNKNOWNS];
    vary_instant(SYSTEM_OF(runner), &runner->motion, &line->seed, line->d_state, exact,
                 exact + TDMF_STATE_COUNT);
    unknown_line on = {*line, 0};
    for (on.unknown = 0; on.unknown < UNKNOWNS; ++on.unknown) {
        if (differentiable(&on)) {
            const double numerical = (double)derivative_at_zero(unknown_on_line, &on, (long double)LINE_STEP);
            const double tolerance = 1e-8 * fabs(exact[on.unknown]) + 1e-11 * numerical_noise(&on);
            assert_close(numerical, exact[on.unknown], tolerance);
        }
    }
}

static void variation_agrees(random_source *source, const runner *runner) {
    const line line = line_random(source, runner);
    variation_agrees_on(&line);
}

/* In graze the torque is steep near upright. */
static bool leans(const runner *runner) {
    return fabs(sin(runner->motion.state[TDMF_LEG_ANGLE] - runner->motion.mode.ground.slope)) > 0.05;
}

typedef void change(runner *runner);

static void keep(runner *runner) {
    (void)runner;
}

/* A solver's trial length, below the floor of 1/r. */
static void shorten_leg_below_minimum(runner *runner) {
    runner->motion.state[TDMF_LEG_LENGTH] = 0.3 * runner->model.parameters.leg.min_length;
}

TEST(tangents_are_derivatives) {
    static const struct {
        change *change;
        int runners;
    } kinds[] = {{keep, sample_of(300)},
                 {scene_lighten_foot_and_stiffen_leg, sample_of(100)},
                 {shorten_leg_below_minimum, 20}};
    for (uint64_t k = 0; k < COUNT_OF(kinds); ++k) {
        for (int contact = TDMF_CONTACT_FLIGHT; contact <= TDMF_CONTACT_GRAZE; ++contact) {
            random_source source = {5000 + 1000 * k + (uint64_t)contact};
            int compared = 0;
            for (int i = 0; i < kinds[k].runners; ++i) {
                runner runner = scene_random(&source, (tdmf_contact_mode)contact);
                kinds[k].change(&runner);
                if (leans(&runner)) {
                    variation_agrees(&source, &runner);
                    ++compared;
                }
            }
            assert_true(6 * compared > 5 * kinds[k].runners);
        }
    }
}

/* Where graze keeps the sine off zero, its torque still changes with the leg's length and rate. */
TEST(tangents_of_an_upright_leg_in_graze_are_derivatives) {
    random_source source = {8000};
    for (int i = 0; i < 20; ++i) {
        runner runner = scene_random(&source, TDMF_CONTACT_GRAZE);
        runner.inputs.ground.slope = 0.0;
        runner.motion.mode.ground = tdmf_ground_line_of(runner.inputs.ground.height, 0.0);
        runner.motion.state[TDMF_LEG_ANGLE] = 5e-13;
        line line = line_random(&source, &runner);
        line.d_state[TDMF_LEG_ANGLE] *= 1e-13; /* it stays where the sine is bounded */
        line.seed.inputs.ground.slope = 0.0;
        variation_agrees_on(&line);
    }
}

TEST(a_frozen_run_has_derivatives_that_do_not_change) {
    random_source source = {1};
    runner runner = scene_random(&source, TDMF_CONTACT_STICK);
    runner.motion.mode.fallen = true;
    variation_agrees(&source, &runner);
}
