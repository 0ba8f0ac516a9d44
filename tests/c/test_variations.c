/* The variations of the model's laws, each against differences of what it is the variation of. (Forces,
 * accelerations and energies: test_output_variation.c.) */
#include "compare.h"
#include "coordinate_laws.h"
#include "differentiate.h"
#include "impact.h"
#include "leg.h"
#include "line.h"
#include "seed.h"
#include "system_of.h"

#include <math.h>
#include <string.h>

/* ---- runners ------------------------------------------------------------------------------------------- */

enum kind {
    ORDINARY,
    LIGHT_FOOT_ON_STIFF_LEG,
    HEAVY_FOOT,
    ON_GLUE,
    ON_ICE,
    WITHOUT_HIP_AND_DAMPER,
    UPRIGHT,
    SHORTER_THAN_ITS_MINIMUM, /* a solver's trial, above or below the floor of 1/r */
    KINDS
};

static runner random_runner(random_source *source, tdmf_contact_mode contact, enum kind kind) {
    runner runner = scene_random(source, contact);
    tdmf_parameters p = runner.model.parameters;
    if (kind == LIGHT_FOOT_ON_STIFF_LEG) {
        p.foot.mass = 1e-6 * p.body.mass;
        p.leg.stiffness *= 1e4;
    } else if (kind == HEAVY_FOOT) {
        p.foot.mass = 1e3 * p.body.mass;
    } else if (kind == WITHOUT_HIP_AND_DAMPER) {
        p.leg.damping = p.hip.stance_torque = p.hip.kp = p.hip.kd = 0.0;
        runner.inputs.hip.external_torque = 0.0;
        runner.motion.mode.clamp_closed = false;
    } else if (kind == ON_GLUE) {
        runner.inputs.ground.friction = 1e6;
    } else if (kind == ON_ICE) {
        runner.inputs.ground.friction = 0.0;
    } else if (kind == UPRIGHT) {
        runner.motion.state[TDMF_LEG_ANGLE] = 0.0;
    } else if (kind == SHORTER_THAN_ITS_MINIMUM) {
        runner.motion.state[TDMF_LEG_LENGTH] = (random_chance(source, 0.5) ? 0.3 : 0.7) * p.leg.min_length;
    }
    assert_null(tdmf_model_create(&runner.model, &p).variable);
    return runner;
}

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

static void append_point(row *row, tdmf_point point) {
    append(row, point.x);
    append(row, point.y);
    append(row, point.vx);
    append(row, point.vy);
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
    assert_int_equal(here.count, exact->count);
    for (int i = 0; i < here.count; ++i) {
        const row_line on = {line, of, i};
        const double numerical = (double)derivative_at_zero(value_on_line, &on, (long double)LINE_STEP);
        const double there = (double)value_on_line((long double)LINE_STEP, &on);
        const double size = fmax(fabs(here.values[i]), fabs(there));
        assert_close(numerical, exact->values[i], 1e-9 * fabs(exact->values[i]) + 1e-11 / LINE_STEP * size);
    }
}

static row constants(const tdmf_model *model) {
    row row = {0};
    append(&row, model->inverse_body_mass);
    append(&row, model->inverse_foot_mass);
    append(&row, model->inverse_reduced_mass);
    append(&row, model->total_mass);
    append(&row, model->body_share);
    return row;
}

static row constants_of(const runner *at) {
    return constants(&at->model);
}

static void constants_vary_as_they_change(void **state) {
    (void)state;
    for (int kind = 0; kind < KINDS; ++kind) {
        random_source source = {(uint64_t)(4000 + kind)};
        for (int i = 0; i < 20; ++i) {
            const runner at = random_runner(&source, TDMF_CONTACT_FLIGHT, (enum kind)kind);
            const line line = line_random(&source, &at);
            const tdmf_model d = tdmf_vary_model(&at.model, &line.seed.parameters);
            const row exact = constants(&d);
            assert_row_varies(&line, constants_of, &exact);
        }
    }
}

static row leg_and_points(const tdmf_leg *leg, tdmf_point body, tdmf_point com) {
    row row = {0};
    append(&row, leg->length);
    append(&row, leg->inverse_length);
    append(&row, leg->length_rate);
    append(&row, leg->angle_rate);
    append(&row, leg->sine);
    append(&row, leg->cosine);
    append(&row, leg->rest_length);
    append(&row, leg->axial_force);
    append_point(&row, body);
    append_point(&row, com);
    return row;
}

static row leg_and_points_of(const runner *at) {
    const tdmf_leg leg = tdmf_leg_of(SYSTEM_OF(at), &at->motion.mode, at->motion.state);
    return leg_and_points(&leg, tdmf_body(at->motion.state),
                          tdmf_center_of_mass(&at->model, at->motion.state));
}

static void leg_and_points_vary_as_they_change(void **state) {
    (void)state;
    for (int kind = 0; kind < KINDS; ++kind) {
        random_source source = {(uint64_t)(5000 + kind)};
        for (int i = 0; i < 20; ++i) {
            const runner at = random_runner(&source, TDMF_CONTACT_FLIGHT, (enum kind)kind);
            const line line = line_random(&source, &at);
            const tdmf_local_seed d = tdmf_local_seed_of(&at.model, &line.seed, &line.variation);
            const tdmf_leg leg = tdmf_leg_of(SYSTEM_OF(&at), &at.motion.mode, at.motion.state);
            const tdmf_leg_direction direction = tdmf_leg_direction_of(at.motion.state);
            const tdmf_leg d_leg =
                tdmf_vary_leg_along(&at.model, &at.inputs, &at.motion.mode, at.motion.state, direction, &leg,
                                    &d.model, &d.inputs, &d.mode, d.state);
            const row exact = leg_and_points(
                &d_leg,
                tdmf_vary_body_along(at.motion.state, tdmf_leg_direction_of(at.motion.state), d.state),
                tdmf_vary_center_of_mass_along(&at.model, at.motion.state,
                                               tdmf_leg_direction_of(at.motion.state), &d.model, d.state));
            assert_row_varies(&line, leg_and_points_of, &exact);
        }
    }
}

/* ---- impact -------------------------------------------------------------------------------------------- */

static row after_impact(const double *state, double loss) {
    row row = {0};
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        append(&row, state[i]);
    }
    append(&row, loss);
    return row;
}

static row impact_of(const runner *at) {
    runner landed = *at;
    const double loss = tdmf_impact(SYSTEM_OF(&landed), &landed.motion.mode.ground, landed.motion.state);
    return after_impact(landed.motion.state, loss);
}

/* Far enough from the edge of the cone and from feet that do not move. */
static bool is_smooth_impact(const runner *at) {
    const double vx = fabs(at->motion.state[TDMF_FOOT_VX]), vy = fabs(at->motion.state[TDMF_FOOT_VY]);
    const double speed = at->model.scales.speed, friction = static_friction(at);
    return vx > 0.05 * speed && vy > 0.05 * speed &&
           fabs(vx - friction * vy) > 0.05 * (1.0 + friction) * speed;
}

static void an_impact_varies_as_it_changes(void **state) {
    int stuck = 0, slid = 0;
    (void)state;
    for (int kind = 0; kind < KINDS; ++kind) {
        random_source source = {(uint64_t)(7000 + kind)};
        for (int i = 0; i < 40; ++i) {
            runner at = random_runner(&source, TDMF_CONTACT_FLIGHT, (enum kind)kind);
            at.motion.state[TDMF_FOOT_VY] = -fabs(at.motion.state[TDMF_FOOT_VY]);
            if (!is_smooth_impact(&at)) {
                continue;
            }
            line line = line_random(&source, &at);
            if (at.inputs.ground.friction == 0.0) {
                line.seed.inputs.ground.friction = 0.0; /* there is nothing below */
            }
            const tdmf_local_seed d = tdmf_local_seed_of(&at.model, &line.seed, &line.variation);
            runner after = at;
            tdmf_impact(SYSTEM_OF(&after), &after.motion.mode.ground, after.motion.state);
            double d_state[TDMF_STATE_COUNT];
            memcpy(d_state, line.variation.state, sizeof d_state);
            const double d_loss =
                tdmf_vary_impact(SYSTEM_OF(&at), &at.motion.mode.ground, at.motion.state, &d, d_state);
            const row exact = after_impact(d_state, d_loss);
            assert_row_varies(&line, impact_of, &exact);
            stuck += after.motion.state[TDMF_FOOT_VX] == 0.0;
            slid += after.motion.state[TDMF_FOOT_VX] != 0.0;
        }
    }
    assert_true(stuck > 50 && slid > 50);
}

/* ---- start --------------------------------------------------------------------------------------------- */

static row started(const double *state, double liftoff_angle, double loss) {
    row row = after_impact(state, loss);
    append(&row, liftoff_angle);
    append(&row, state[TDMF_LEG_WORK]);
    return row;
}

static row start_of(const runner *at) {
    runner begun = *at;
    runner_start(&begun);
    return started(begun.motion.state, begun.motion.mode.liftoff_angle, begun.motion.record.impact_loss);
}

/* Along what leaves a foot that is at the ground or put on it there, and a thrust of 0 as it is. */
static line line_of_starts(random_source *source, const runner *given) {
    line line = line_random(source, given);
    line.variation.state[TDMF_FOOT_Y] =
        given->motion.state[TDMF_FOOT_Y] == 0.0 ? 0.0 : given->model.scales.length;
    line.seed.inputs.ground.height = line.seed.inputs.ground.slope = 0.0; /* the foot would not meet it */
    if (given->motion.state[TDMF_FOOT_VY] == 0.0) {
        line.variation.state[TDMF_FOOT_VY] = 0.0;
    }
    if (given->model.parameters.leg.thrust + given->inputs.control.thrust <= 0.0) {
        line.seed.parameters.leg.thrust = line.seed.inputs.control.thrust = 0.0;
    }
    return line;
}

static void assert_start_varies(const line *line) {
    const runner *given = line->runner;
    runner begun = *given;
    runner_start(&begun);
    const tdmf_start_variation varied =
        tdmf_vary_start(SYSTEM_OF(given), given->motion.state, begun.motion.state, &begun.motion.mode,
                        &line->seed, line->variation.state);
    const row exact = started(varied.variation.state, varied.variation.liftoff_angle, varied.impact_loss);
    assert_row_varies(line, start_of, &exact);
}

/* Falling and rising, in the air and at the ground, where a falling foot has an impact. */
static void a_start_varies_as_it_changes(void **state) {
    random_source source = {8000};
    int compared = 0;
    (void)state;
    for (int i = 0; i < 200; ++i) {
        runner given = random_runner(&source, TDMF_CONTACT_FLIGHT, ORDINARY);
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
static void a_start_that_thrusts_at_once_varies_with_its_work(void **state) {
    random_source source = {8100};
    int thrusting = 0;
    (void)state;
    for (int i = 0; i < 200; ++i) {
        runner given =
            random_runner(&source, TDMF_CONTACT_FLIGHT, i % 4 ? ORDINARY : LIGHT_FOOT_ON_STIFF_LEG);
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(constants_vary_as_they_change),
        cmocka_unit_test(leg_and_points_vary_as_they_change),
        cmocka_unit_test(an_impact_varies_as_it_changes),
        cmocka_unit_test(a_start_varies_as_it_changes),
        cmocka_unit_test(a_start_that_thrusts_at_once_varies_with_its_work),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
