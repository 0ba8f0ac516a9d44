/* The variations of the model's laws, each against differences of what it is the variation of. (Forces,
 * accelerations and energies: test_output_variation.c.) */
#include "by_page.h"
#include "compare.h"
#include "differentiate.h"
#include "line.h"
#include "simulation.h"
#include "system_of.h"

#include <math.h>
#include <string.h>

static double static_friction(const runner *runner) {
    return runner->model.parameters.ground.static_friction_ratio * runner->inputs.ground.friction;
}

/* ---- what is made of a runner, value by value -----------------------------------------------------------
 */

enum { LONGEST = 20 };

typedef struct {
    int count;
    double values[LONGEST];
} row;

static void append(row *row, double value) {
    row->values[row->count++] = value;
}

typedef struct {
    const line *line;
    row (*of)(const runner *at);
    int index;
} row_line;

static long double value_on_line(long double t, const void *context) {
    const row_line *on = context;
    const runner moved = line_at(on->line, (double)t);
    return (long double)on->of(&moved).values[on->index];
}

static void assert_row_varies(const line *line, row (*of)(const runner *at), const row *exact) {
    const row here = of(line->runner);
    const tdmf_parameters *p = &line->runner->model.parameters;
    const factors units = {p->body.mass, p->leg.stiffness, p->leg.free_length};
    assert_int_equal(here.count, exact->count);
    for (int i = 0; i < here.count; ++i) {
        const row_line on = {line, of, i};
        const double numerical = (double)derivative_at_zero(value_on_line, &on, (long double)LINE_STEP);
        const double there = (double)value_on_line((long double)LINE_STEP, &on);
        /* A foot that lands and leaves at once is rounded by the sizes of the leg and of its velocity. */
        const double rounding = i < TDMF_MECHANICAL_COUNT ? factor_of_element(&units, TDMF_FOOT_X + i) : 0.0;
        const double size = fmax(fmax(fabs(here.values[i]), fabs(there)), rounding);
        assert_close(numerical, exact->values[i], 1e-9 * fabs(exact->values[i]) + 1e-11 / LINE_STEP * size);
    }
}

/* ---- impact -------------------------------------------------------------------------------------------- */

/* Far enough from the edge of the cone and from feet that do not move. */
static bool is_smooth_impact(const runner *at) {
    const double vx = fabs(at->motion.state[TDMF_FOOT_VX]), vy = fabs(at->motion.state[TDMF_FOOT_VY]);
    const double speed = at->model.scales.speed, friction = static_friction(at);
    return vx > 0.05 * speed && vy > 0.05 * speed &&
           fabs(vx - friction * vy) > 0.05 * (1.0 + friction) * speed;
}

/* ---- start --------------------------------------------------------------------------------------------- */

static row started(const double *state, double liftoff_angle) {
    row row = {0};
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        append(&row, state[TDMF_FOOT_X + i]);
    }
    append(&row, liftoff_angle);
    append(&row, state[TDMF_LEG_WORK]);
    return row;
}

static row start_of(const runner *at) {
    runner begun = *at;
    runner_start(&begun);
    return started(begun.motion.state, begun.motion.state[TDMF_HIP_LIFTOFF_ANGLE]);
}

/* Along what leaves a foot that is at the ground or put on it there, and a thrust of 0 as it is. */
static line line_of_starts(random_source *source, const runner *given) {
    line line = line_random(source, given);
    line.d_state[TDMF_FOOT_Y] = given->motion.state[TDMF_FOOT_Y] == 0.0 ? 0.0 : given->model.scales.length;
    line.seed.inputs.ground.height = line.seed.inputs.ground.slope = 0.0; /* the foot would not meet it */
    if (given->motion.state[TDMF_FOOT_VY] == 0.0) {
        line.d_state[TDMF_FOOT_VY] = 0.0;
    }
    if (given->model.parameters.leg.thrust + given->inputs.control.thrust <= 0.0) {
        line.seed.parameters.leg.thrust = line.seed.inputs.control.thrust = 0.0;
    }
    return line;
}

static void assert_start_varies(const line *line) {
    const runner *given = line->runner;
    double varied[TDMF_STATE_COUNT];
    vary_run(SYSTEM_OF(given), given->motion.state, &line->seed, line->d_state, 0.0, varied);
    const row exact = started(varied, varied[TDMF_HIP_LIFTOFF_ANGLE]);
    assert_row_varies(line, start_of, &exact);
}

/* Falling and rising, in the air and at the ground, where a falling foot has an impact. */
TEST(a_start_varies_as_it_changes) {
    random_source source = {8000};
    int compared = 0;
    for (int i = 0; i < 200; ++i) {
        runner given = scene_random(&source, TDMF_CONTACT_FLIGHT);
        given.inputs.ground.friction = random_uniform(&source, 0.1, 1.0);
        given.inputs.ground.height = given.inputs.ground.slope = 0.0;
        given.motion.state[TDMF_FOOT_Y] = fabs(given.motion.state[TDMF_FOOT_Y]);
        if (i % 2) {
            given.motion.state[TDMF_FOOT_Y] = 0.0;
        } else {
            given.motion.state[TDMF_FOOT_Y] += 0.1 * given.model.scales.length;
        }
        if (is_smooth_impact(&given)) {
            const line line = line_of_starts(&source, &given);
            assert_start_varies(&line);
            ++compared;
        }
    }
    assert_true(compared > 150);
}

/* All neighbours that a difference asks, too. */
static bool thrust_at_once(const line *line) {
    bool all = true;
    for (int i = -4; i <= 4; ++i) {
        runner begun = line_at(line, i * LINE_STEP);
        runner_start(&begun);
        all = all && begun.motion.mode.thrusts;
    }
    return all;
}

/* The foot comes down or is on the ground, and the leg lengthens in contact by the parameter, the input, or
 * both. */
TEST(a_start_that_thrusts_at_once_varies_with_its_work) {
    random_source source = {8100};
    int thrusting = 0;
    for (int i = 0; i < 200; ++i) {
        runner given = scene_random(&source, TDMF_CONTACT_FLIGHT);
        if (i % 4 == 0) {
            scene_lighten_foot_and_stiffen_leg(&given);
        }
        const tdmf_scales *scales = &given.model.scales;
        const double thrust = scales->length * random_uniform(&source, 0.05, 0.2);
        given.inputs.ground.friction = random_uniform(&source, 0.1, 1.0);
        given.inputs.ground.height = given.inputs.ground.slope = 0.0;
        given.model.parameters.leg.thrust = i % 3 ? thrust : 0.0;
        given.inputs.control.thrust = i % 3 == 1 ? -0.2 * thrust : thrust;
        given.motion.state[TDMF_FOOT_Y] = 0.0;
        given.motion.state[TDMF_FOOT_VY] = i % 2 ? -fabs(given.motion.state[TDMF_FOOT_VY]) : 0.0;
        given.motion.state[TDMF_LEG_LENGTH] = scales->length * random_uniform(&source, 0.7, 0.95);
        given.motion.state[TDMF_LEG_ANGLE] = random_uniform(&source, -0.5, 0.5);
        given.motion.state[TDMF_LEG_LENGTH_RATE] = scales->speed * random_uniform(&source, 0.1, 0.5);
        const line line = line_of_starts(&source, &given);
        if ((i % 2 == 0 || is_smooth_impact(&given)) && thrust_at_once(&line)) {
            assert_start_varies(&line);
            ++thrusting;
        }
    }
    assert_true(thrusting > 100);
}
