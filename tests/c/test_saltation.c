/* What an event makes of a variation, against differences of the guards and of the impact map.
 *
 * Sides of an event are made up here: the hip works at a rate of 1 before it and not at all after it, so that
 * the work's variation grows by the time that the event shifts by. */
#include "compare.h"
#include "differentiate.h"
#include "hip_laws.h"
#include "line.h"
#include "saltation.h"
#include "system_of.h"

#include <math.h>
#include <string.h>

enum {
    DRAWS = 60,
    VARIED = TDMF_VARIED_COUNT /* the states that a variation has: a guard depends on all but the work */
};

/* By the law of a contact mode. In retract a negative torque may be clamped. */
static double torque_in(const runner *at, tdmf_contact_mode contact) {
    tdmf_mode mode = at->motion.mode;
    mode.contact = contact;
    mode.clamp_closed =
        at->model.parameters.hip.swing_clamp && mode.phase != TDMF_PHASE_PLACE && scene_retract_law(at) < 0.0;
    return tdmf_hip_torque(SYSTEM_OF(at), &mode, at->motion.state);
}

static double static_friction(const runner *at) {
    return at->model.parameters.ground.static_friction_ratio * at->inputs.ground.friction;
}

/* What a guard watches, in its own unit. */
static double watched(const runner *at, tdmf_guard guard) {
    const tdmf_ground_force force = tdmf_sticking_force(SYSTEM_OF(at), &at->motion.mode,
                                                        torque_in(at, TDMF_CONTACT_STICK), at->motion.state);
    switch (guard) {
    case TDMF_GUARD_TOUCHDOWN:
        return tdmf_foot_over_ground(&at->motion.mode.ground, at->motion.state).y;
    case TDMF_GUARD_NEW_GROUND: {
        const tdmf_ground_line line = tdmf_ground_line_of(at->inputs.ground.height, at->inputs.ground.slope);
        return -tdmf_foot_over_ground(&line, at->motion.state).y;
    }
    case TDMF_GUARD_APEX:
        return tdmf_center_of_mass(&at->model, at->motion.state).vy;
    case TDMF_GUARD_CLAMP:
        return scene_retract_law(at);
    case TDMF_GUARD_SLIP_ONSET_POSITIVE:
        return static_friction(at) * force.normal + force.tangential;
    case TDMF_GUARD_SLIP_ONSET_NEGATIVE:
        return static_friction(at) * force.normal - force.tangential;
    case TDMF_GUARD_SLIP_VELOCITY_ZERO:
        return tdmf_foot_over_ground(&at->motion.mode.ground, at->motion.state).vx;
    case TDMF_GUARD_MID_STANCE:
        return at->motion.state[TDMF_LEG_ANGLE];
    case TDMF_GUARD_GREATEST_COMPRESSION:
        return -at->motion.state[TDMF_LEG_LENGTH_RATE];
    case TDMF_GUARD_GRAZE_TO_FLIGHT:
        return tdmf_sticking_force(SYSTEM_OF(at), &at->motion.mode, torque_in(at, TDMF_CONTACT_FLIGHT),
                                   at->motion.state)
            .normal;
    default:
        return force.normal; /* lift-off, and from graze to contact */
    }
}

typedef struct {
    line line;
    tdmf_guard guard;
} guard_line;

static long double watched_on_line(long double t, const void *context) {
    const guard_line *on = context;
    const runner moved = line_at(&on->line, (double)t);
    return watched(&moved, on->guard);
}

static double rate_along(const guard_line *on) {
    return (double)derivative_at_zero(watched_on_line, on, (long double)LINE_STEP);
}

static tdmf_contact_mode watched_in(tdmf_guard guard) {
    switch (guard) {
    case TDMF_GUARD_TOUCHDOWN:
    case TDMF_GUARD_APEX:
    case TDMF_GUARD_CLAMP:
    case TDMF_GUARD_NEW_GROUND:
        return TDMF_CONTACT_FLIGHT;
    case TDMF_GUARD_GRAZE_TO_CONTACT:
    case TDMF_GUARD_GRAZE_TO_FLIGHT:
        return TDMF_CONTACT_GRAZE;
    case TDMF_GUARD_SLIP_VELOCITY_ZERO:
        return TDMF_CONTACT_SLIP_POSITIVE;
    default:
        return TDMF_CONTACT_STICK;
    }
}

/* In units of one, with a torque or a gain that happens to be zero. */
static runner random_runner(random_source *source, tdmf_guard guard) {
    runner runner = scene_random(source, watched_in(guard));
    tdmf_parameters p = tdmf_default_parameters();
    p.foot.mass = random_uniform(source, 0.1, 0.5);
    p.leg.free_length = runner.motion.state[TDMF_LEG_LENGTH] * random_uniform(source, 0.8, 1.2);
    p.leg.min_length = 0.3 * p.leg.free_length;
    p.gravity = random_uniform(source, 0.1, 1.0);
    p.hip.stance_torque = random_chance(source, 0.5) ? 0.0 : random_uniform(source, -0.5, 0.5);
    p.hip.kp = random_chance(source, 0.3) ? 0.0 : random_uniform(source, 0.1, 1.0);
    p.hip.kd = random_chance(source, 0.3) ? 0.0 : random_uniform(source, 0.1, 1.0);
    p.hip.retraction_rate = random_chance(source, 0.3) ? 0.0 : random_uniform(source, -0.5, 0.5);
    p.ground.static_friction_ratio = random_uniform(source, 1.1, 1.5);
    p.hip.swing_clamp = guard == TDMF_GUARD_CLAMP || runner.model.parameters.hip.swing_clamp;
    assert_null(tdmf_model_create(&runner.model, &p).variable);
    runner.inputs.ground.friction = random_uniform(source, 0.1, 1.0);
    runner.inputs.hip.external_torque = random_chance(source, 0.5) ? 0.0 : random_uniform(source, -0.3, 0.3);
    for (int i = TDMF_FOOT_VX; i < TDMF_MECHANICAL_COUNT; ++i) {
        runner.motion.state[i] = random_uniform(source, -1.0, 1.0);
    }
    if (guard == TDMF_GUARD_APEX || guard == TDMF_GUARD_CLAMP) {
        runner.motion.mode.phase = TDMF_PHASE_RETRACT;
    }
    return runner;
}

static void choose_direction(random_source *source, double state[TDMF_STATE_COUNT]) {
    memset(state, 0, TDMF_STATE_COUNT * sizeof *state);
    for (int i = 0; i < VARIED; ++i) {
        state[i] = random_uniform(source, -1.0, 1.0);
    }
    state[TDMF_HIP_WORK] = 0.0;
}

/* A variation, and the sides of an event that goes on in `after`. */
typedef struct {
    tdmf_event_state before, after;
    tdmf_variation variation;
    tdmf_seed seed;
} event;

/* Has a foot that leaves the ground move into it as fast. */
static void turn_into_ground(const runner *runner, double state[TDMF_STATE_COUNT]) {
    const tdmf_ground_line *ground = &runner->motion.mode.ground;
    const double rate = tdmf_foot_over_ground(ground, state).vy;
    if (rate > 0.0) {
        state[TDMF_FOOT_VX] += 2.0 * rate * ground->sine;
        state[TDMF_FOOT_VY] -= 2.0 * rate * ground->cosine;
    }
}

static event random_event(random_source *source, const runner *runner, tdmf_guard guard,
                          tdmf_contact_mode after) {
    event event;
    memset(&event, 0, sizeof event);
    memcpy(event.before.state, runner->motion.state, sizeof event.before.state);
    memcpy(event.after.state, runner->motion.state, sizeof event.after.state);
    event.before.mode = event.after.mode = runner->motion.mode;
    event.after.mode.contact = after;
    if (guard == TDMF_GUARD_TOUCHDOWN) {
        turn_into_ground(runner, event.before.state);
        memcpy(event.after.state, event.before.state, sizeof event.after.state);
        tdmf_impact(SYSTEM_OF(runner), &runner->motion.mode.ground, event.after.state);
    }
    choose_direction(source, event.before.derivatives);
    event.before.derivatives[TDMF_HIP_WORK] = 1.0;
    const line line = line_random(source, runner);
    event.variation = line.variation;
    event.variation.state[TDMF_HIP_WORK] = random_uniform(source, -1.0, 1.0);
    event.seed = line.seed;
    return event;
}

static tdmf_variation taken(const runner *runner, tdmf_guard guard, const event *event) {
    tdmf_met_event met;
    return tdmf_saltation(SYSTEM_OF(runner), guard, &event->before, &event->after, &event->seed,
                          &event->variation, &met);
}

static bool is_smooth(const guard_line *on) {
    return on->guard != TDMF_GUARD_GRAZE_TO_FLIGHT ||
           on->line.runner->motion.mode.phase == TDMF_PHASE_PLACE || line_keeps_clamp(&on->line, LINE_STEP);
}

static void an_event_shifts_with_what_its_guard_watches(void **state) {
    (void)state;
    for (int g = 0; g < TDMF_GUARD_COUNT; ++g) {
        const tdmf_guard guard = (tdmf_guard)g;
        random_source source = {(uint64_t)g + 100};
        int compared = 0;
        if (!scene_is_varied(guard)) {
            continue;
        }
        for (int i = 0; i < DRAWS; ++i) {
            const runner runner = random_runner(&source, guard);
            const event event = random_event(&source, &runner, guard, TDMF_CONTACT_FLIGHT);
            const guard_line along_variation = {{&runner, event.seed, event.variation}, guard};
            guard_line along_motion = {{.runner = &runner}, guard};
            memcpy(along_motion.line.variation.state, event.before.derivatives,
                   sizeof event.before.derivatives);
            const double moved = rate_along(&along_variation), rate = rate_along(&along_motion);
            const double shift =
                taken(&runner, guard, &event).state[TDMF_HIP_WORK] - event.variation.state[TDMF_HIP_WORK];
            /* A clamp without gains is never due. */
            if (!is_smooth(&along_variation) || !is_smooth(&along_motion) || fabs(rate) < 1e-3) {
                continue;
            }
            ++compared;
            assert_close(moved + shift * rate, 0.0, 1e-9 * (1.0 + fabs(moved)));
        }
        assert_true(compared > DRAWS / 2);
    }
}

static void the_lift_off_angle_is_latched_where_a_contact_or_an_impact_is_left(void **state) {
    static const struct {
        tdmf_guard guard;
        tdmf_contact_mode after;
        bool latches;
    } events[] = {{TDMF_GUARD_LIFT_OFF, TDMF_CONTACT_FLIGHT, true},
                  {TDMF_GUARD_LIFT_OFF, TDMF_CONTACT_GRAZE, true},
                  {TDMF_GUARD_MID_STANCE, TDMF_CONTACT_FLIGHT, true},
                  {TDMF_GUARD_SLIP_VELOCITY_ZERO, TDMF_CONTACT_GRAZE, true},
                  {TDMF_GUARD_TOUCHDOWN, TDMF_CONTACT_FLIGHT, true},
                  {TDMF_GUARD_TOUCHDOWN, TDMF_CONTACT_GRAZE, true},
                  {TDMF_GUARD_TOUCHDOWN, TDMF_CONTACT_STICK, false},
                  {TDMF_GUARD_TOUCHDOWN, TDMF_CONTACT_SLIP_NEGATIVE, false},
                  {TDMF_GUARD_SLIP_ONSET_POSITIVE, TDMF_CONTACT_SLIP_POSITIVE, false},
                  {TDMF_GUARD_MID_STANCE, TDMF_CONTACT_STICK, false},
                  {TDMF_GUARD_APEX, TDMF_CONTACT_FLIGHT, false},
                  {TDMF_GUARD_CLAMP, TDMF_CONTACT_FLIGHT, false},
                  {TDMF_GUARD_GRAZE_TO_FLIGHT, TDMF_CONTACT_FLIGHT, false},
                  {TDMF_GUARD_GRAZE_TO_CONTACT, TDMF_CONTACT_STICK, false}};
    random_source source = {7};
    (void)state;
    for (size_t i = 0; i < sizeof events / sizeof events[0]; ++i) {
        runner runner = random_runner(&source, events[i].guard);
        runner.model.parameters.hip.kp = 0.5;
        const event event = random_event(&source, &runner, events[i].guard, events[i].after);
        const tdmf_variation after = taken(&runner, events[i].guard, &event);
        const double shift = after.state[TDMF_HIP_WORK] - event.variation.state[TDMF_HIP_WORK];
        const double latched =
            event.variation.state[TDMF_LEG_ANGLE] + event.before.derivatives[TDMF_LEG_ANGLE] * shift;
        assert_close(after.liftoff_angle, events[i].latches ? latched : event.variation.liftoff_angle,
                     1e-12 * (1.0 + fabs(shift)));
    }
}

static void a_state_goes_on_at_the_rates_that_follow(void **state) {
    random_source source = {11};
    double of_place[TDMF_STATE_COUNT]; /* 0 of what place begins anew */
    (void)state;
    for (int k = 0; k < TDMF_STATE_COUNT; ++k) {
        of_place[k] = 1.0;
    }
    tdmf_begin_place(of_place);
    assert_true(of_place[TDMF_HIP_PLACE_TIME] == 0.0);
    for (int i = 0; i < DRAWS; ++i) {
        const runner runner = random_runner(&source, TDMF_GUARD_APEX);
        event event = random_event(&source, &runner, TDMF_GUARD_APEX, TDMF_CONTACT_FLIGHT);
        event.after.mode.phase = TDMF_PHASE_PLACE;
        choose_direction(&source, event.after.derivatives);
        const tdmf_variation after = taken(&runner, TDMF_GUARD_APEX, &event);
        const double shift = after.state[TDMF_HIP_WORK] - event.variation.state[TDMF_HIP_WORK];
        for (int k = 0; k < TDMF_STATE_COUNT; ++k) {
            const double seed = k < VARIED ? event.before.derivatives[k] - event.after.derivatives[k] : 0.0;
            const double expected = of_place[k] == 0.0 ? -event.after.derivatives[k] * shift
                                                       : event.variation.state[k] + seed * shift;
            if (k != TDMF_HIP_WORK) {
                assert_close(after.state[k], expected, 1e-12 * (1.0 + fabs(shift)));
            }
        }
    }
}

/* To the last bit, whatever rounding there is in the rates. */
static void a_foot_on_the_ground_stays_there(void **state) {
    static const tdmf_contact_mode grounded[] = {TDMF_CONTACT_STICK, TDMF_CONTACT_SLIP_NEGATIVE,
                                                 TDMF_CONTACT_GRAZE};
    random_source source = {19};
    (void)state;
    for (size_t i = 0; i < sizeof grounded / sizeof grounded[0]; ++i) {
        runner runner = random_runner(&source, TDMF_GUARD_SLIP_VELOCITY_ZERO);
        runner.motion.mode.ground = tdmf_ground_line_of(0.0, 0.0);
        event event = random_event(&source, &runner, TDMF_GUARD_SLIP_VELOCITY_ZERO, grounded[i]);
        event.seed.inputs.ground.height = event.seed.inputs.ground.slope = 0.0;
        choose_direction(&source, event.after.derivatives);
        const tdmf_variation after = taken(&runner, TDMF_GUARD_SLIP_VELOCITY_ZERO, &event);
        assert_true(after.state[TDMF_FOOT_Y] == 0.0 && after.state[TDMF_FOOT_VY] == 0.0);
        assert_true((after.state[TDMF_FOOT_VX] == 0.0) == (grounded[i] == TDMF_CONTACT_STICK));
    }
}

/* ---- impacts ------------------------------------------------------------------------------------------- */

typedef struct {
    line line;
    int coordinate;
} impact_line;

static long double after_impact(long double t, const void *context) {
    const impact_line *impact = context;
    runner moved = line_at(&impact->line, (double)t);
    tdmf_impact(SYSTEM_OF(&moved), &moved.motion.mode.ground, moved.motion.state);
    return moved.motion.state[impact->coordinate];
}

static void assert_impact_is_differentiated(random_source *source, runner *runner) {
    event event = random_event(source, runner, TDMF_GUARD_TOUCHDOWN, TDMF_CONTACT_FLIGHT);
    memcpy(runner->motion.state, event.before.state, sizeof runner->motion.state);
    /* Without a height to vary, the instant does not shift. */
    const tdmf_ground_line *ground = &runner->motion.mode.ground;
    const tdmf_seed *seed = &event.seed;
    const double along = tdmf_foot_over_ground(ground, runner->motion.state).x;
    runner->motion.state[TDMF_FOOT_X] = along * ground->cosine;
    runner->motion.state[TDMF_FOOT_Y] = ground->height + along * ground->sine;
    event.variation.state[TDMF_FOOT_Y] =
        seed->inputs.ground.height +
        (ground->sine * event.variation.state[TDMF_FOOT_X] + along * seed->inputs.ground.slope) /
            ground->cosine;
    memcpy(event.before.state, runner->motion.state, sizeof runner->motion.state);
    impact_line impact = {{runner, event.seed, event.variation}, 0};
    const tdmf_variation after = taken(runner, TDMF_GUARD_TOUCHDOWN, &event);
    for (impact.coordinate = 0; impact.coordinate < VARIED; ++impact.coordinate) {
        const double expected = (double)derivative_at_zero(after_impact, &impact, (long double)LINE_STEP);
        assert_close(after.state[impact.coordinate], expected, 1e-9 * (1.0 + fabs(expected)));
    }
}

static void the_impact_map_is_differentiated(void **state) {
    random_source source = {13};
    int stuck = 0, slid = 0;
    (void)state;
    for (int i = 0; i < 4 * DRAWS; ++i) {
        runner runner = random_runner(&source, TDMF_GUARD_TOUCHDOWN);
        const tdmf_point foot = tdmf_foot_over_ground(&runner.motion.mode.ground, runner.motion.state);
        const double vx = fabs(foot.vx), vy = fabs(foot.vy);
        const double excess = vx - static_friction(&runner) * vy;
        if (fmin(fmin(vx, vy), fabs(excess)) < 0.05 * fmax(1.0, runner.model.scales.speed)) {
            continue;
        }
        stuck += excess < 0.0;
        slid += excess > 0.0;
        assert_impact_is_differentiated(&source, &runner);
    }
    assert_true(stuck > DRAWS / 2 && slid > DRAWS / 2);
}

/* ---- edges --------------------------------------------------------------------------------------------- */

static void assert_no_number(const tdmf_variation *variation) {
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        assert_true(isnan(variation->state[i]));
    }
    assert_true(isnan(variation->liftoff_angle));
}

static void what_has_no_derivative_gets_no_number(void **state) {
    random_source source = {17};
    (void)state;
    runner runner = random_runner(&source, TDMF_GUARD_TOUCHDOWN);
    event event = random_event(&source, &runner, TDMF_GUARD_TOUCHDOWN, TDMF_CONTACT_FLIGHT);
    event.before.mode.phase = TDMF_PHASE_RETRACT;
    tdmf_variation after = taken(&runner, TDMF_GUARD_APEX, &event); /* it landed */
    assert_no_number(&after);
    memcpy(event.after.state, event.before.state, sizeof event.after.state);
    after = taken(&runner, TDMF_GUARD_TOUCHDOWN, &event); /* it did not land */
    assert_no_number(&after);

    runner = random_runner(&source, TDMF_GUARD_SLIP_VELOCITY_ZERO);
    event = random_event(&source, &runner, TDMF_GUARD_SLIP_VELOCITY_ZERO, TDMF_CONTACT_STICK);
    assert_true(isfinite(taken(&runner, TDMF_GUARD_SLIP_VELOCITY_ZERO, &event).state[TDMF_LEG_ANGLE]));
    runner.inputs.ground.friction = 0.0;
    after = taken(&runner, TDMF_GUARD_SLIP_VELOCITY_ZERO, &event);
    assert_no_number(&after);
    event.after.mode.contact = TDMF_CONTACT_SLIP_NEGATIVE; /* on ice, it slides on */
    assert_true(isfinite(taken(&runner, TDMF_GUARD_SLIP_VELOCITY_ZERO, &event).state[TDMF_LEG_ANGLE]));
    after = taken(&runner, TDMF_GUARD_BODY_DOWN, &event); /* no motion goes on from a fall */
    assert_no_number(&after);

    runner = random_runner(&source, TDMF_GUARD_GRAZE_TO_FLIGHT);
    runner.motion.mode.phase = TDMF_PHASE_RETRACT;
    runner.model.parameters.hip.kp = runner.model.parameters.hip.kd = 0.0;
    event = random_event(&source, &runner, TDMF_GUARD_GRAZE_TO_FLIGHT, TDMF_CONTACT_FLIGHT);
    assert_true(isnan(taken(&runner, TDMF_GUARD_GRAZE_TO_FLIGHT, &event).state[TDMF_LEG_ANGLE]));
    event.seed.parameters.hip.kp = event.seed.parameters.hip.kd = 0.0;
    assert_true(isfinite(taken(&runner, TDMF_GUARD_GRAZE_TO_FLIGHT, &event).state[TDMF_LEG_ANGLE]));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_event_shifts_with_what_its_guard_watches),
        cmocka_unit_test(the_lift_off_angle_is_latched_where_a_contact_or_an_impact_is_left),
        cmocka_unit_test(a_state_goes_on_at_the_rates_that_follow),
        cmocka_unit_test(a_foot_on_the_ground_stays_there),
        cmocka_unit_test(the_impact_map_is_differentiated),
        cmocka_unit_test(what_has_no_derivative_gets_no_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
