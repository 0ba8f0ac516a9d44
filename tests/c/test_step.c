/* What a step of the native solver leaves out, against the same stretch in steps that leave out nothing. */
#include "compare.h"
#include "scene.h"
#include "step.h"

#include <math.h>

static const double tolerances[] = {1e-5, 1e-8, 1e-11};
enum { TOLERANCES = sizeof tolerances / sizeof tolerances[0] };

/* A leg of any sense stays within these. */
static bool is_a_leg(const tdmf_mode_equations *equations) {
    const tdmf_mode_coordinates *at = &equations->start;
    const tdmf_parameters *p = &equations->model->parameters;
    const bool flies = equations->contact == TDMF_CONTACT_FLIGHT;
    const double length = flies ? at->flying.length : hypot(at->standing.x, at->standing.y);
    return length > p->leg.min_length && length < 4.0 * p->leg.free_length && (flies || at->standing.y > 0.0);
}

static void expand(tdmf_step *step, const runner *runner, const tdmf_mode_equations *equations,
                   series_orders orders, double tolerance) {
    tdmf_step_open(step, equations, &runner->motion.mode, 1.0);
    tdmf_step_expand(step, orders, tolerance);
    tdmf_step_shorten(step, INFINITY);
}

/* Goes on by `time`, as exactly as can be, or until the leg makes no sense any more. */
static bool go_on_exactly(const runner *runner, tdmf_mode_equations *equations, double time) {
    const series_orders most = {SERIES_ORDER_LIMIT, SERIES_ORDER_LIMIT};
    double left = time;
    while (left > 0.0 && is_a_leg(equations)) {
        tdmf_step step;
        expand(&step, runner, equations, most, 1e-15);
        const double part = fmin(left, 0.7 * step.size);
        const tdmf_mode_coordinates reached = tdmf_step_at(&step, part);
        tdmf_shift_mode(equations, part, &reached);
        left -= part;
    }
    return is_a_leg(equations);
}

static double off(double actual, double expected, double start, double scale) {
    return fabs(actual - expected) / fmax(scale, fabs(start));
}

/* The largest of the errors of the coordinates of a mode, in its scales. */
static double error_of(const tdmf_mode_equations *from, const tdmf_mode_coordinates *reached,
                       const tdmf_mode_coordinates *exact) {
    const tdmf_scales *scales = &from->model->scales;
    if (from->contact == TDMF_CONTACT_FLIGHT) {
        const tdmf_flying *a = &reached->flying, *b = &exact->flying, *start = &from->start.flying;
        return fmax(fmax(off(a->length, b->length, 0.0, scales->length), off(a->angle, b->angle, 0.0, 1.0)),
                    fmax(off(a->length_rate, b->length_rate, start->length_rate, scales->speed),
                         off(a->angle_rate, b->angle_rate, start->angle_rate, 1.0 / scales->time)));
    }
    const tdmf_standing *a = &reached->standing, *b = &exact->standing, *start = &from->start.standing;
    return fmax(
        fmax(off(a->x, b->x, 0.0, scales->length), off(a->y, b->y, 0.0, scales->length)),
        fmax(off(a->vx, b->vx, start->vx, scales->speed), off(a->vy, b->vy, start->vy, scales->speed)));
}

/* Steps on for as long as the leg makes sense, through settling and beyond, whatever events there are. */
static void assert_steps_are_exact(const runner *runner, double tolerance) {
    enum { STEPS = 100 };
    static const tdmf_inputs no_rates = {.ground = {.friction = 0.0}};
    tdmf_mode_equations equations;
    tdmf_open_mode(&equations, SYSTEM_OF(runner), &no_rates, &runner->motion.mode, runner->motion.state,
                   tdmf_leg_direction_of(runner->motion.state));
    for (int i = 0; i < STEPS; ++i) {
        tdmf_step step;
        tdmf_mode_equations exact = equations;
        expand(&step, runner, &equations, tdmf_step_orders(tolerance), tolerance);
        const tdmf_mode_coordinates reached = tdmf_step_at(&step, step.size);
        if (!go_on_exactly(runner, &exact, step.size)) {
            return;
        }
        assert_close(error_of(&equations, &reached, &exact.start), 0.0, 4.0 * tolerance);
        equations = exact;
    }
}

/* Nearly upright, so that it stands long enough for its spring to settle. */
static void set_upright(random_source *source, runner *runner) {
    const tdmf_parameters *p = &runner->model.parameters;
    const double sag = p->body.mass * p->gravity / p->leg.stiffness;
    runner->motion.state[TDMF_LEG_LENGTH] = p->leg.free_length - random_uniform(source, 0.5, 1.5) * sag;
    runner->motion.state[TDMF_LEG_ANGLE] = random_uniform(source, -1e-7, 1e-7);
    runner->motion.state[TDMF_LEG_ANGLE_RATE] = 0.0;
    runner->inputs.hip.external_torque = 0.0;
    runner->motion.mode.phase = TDMF_PHASE_COAST;
}

static void steps_leave_out_no_more_than_their_tolerance(void **state) {
    enum { RUNNERS = 150 };
    random_source source = {22};
    (void)state;
    for (int i = 0; i < TOLERANCES; ++i) {
        for (int run = 0; run < RUNNERS; ++run) {
            for (int contact = TDMF_CONTACT_FLIGHT; contact < TDMF_CONTACT_GRAZE; ++contact) {
                runner runner = scene_random(&source, (tdmf_contact_mode)contact);
                assert_steps_are_exact(&runner, tolerances[i]);
                if (contact != TDMF_CONTACT_FLIGHT) {
                    set_upright(&source, &runner);
                    assert_steps_are_exact(&runner, tolerances[i]);
                }
            }
        }
    }
}

/* Else a step would be longer than its tolerance allows. */
static void a_rough_root_is_never_too_large(void **state) {
    enum { SAMPLES = 10000 };
    static const double rounding = 2e-6; /* a high half has 20 bits of a fraction */
    random_source source = {5};
    (void)state;
    for (int n = 2; n <= SERIES_ORDER_LIMIT; ++n) {
        for (int i = 0; i < SAMPLES; ++i) {
            const double x = pow(10.0, random_uniform(&source, -300.0, 300.0));
            const double root = pow(x, 1.0 / n);
            const double rough = rough_root(x, n);
            assert_true(rough <= root && rough >= 0.94 * root * (1.0 - rounding));
        }
    }
    assert_true(isinf(rough_root(INFINITY, 9)) && isinf(rough_root(NAN, 9)));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_leave_out_no_more_than_their_tolerance),
        cmocka_unit_test(a_rough_root_is_never_too_large),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
