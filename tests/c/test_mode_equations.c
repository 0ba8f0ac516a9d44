/* The equations of a mode from one instant on: what is put in comes out, and going on is beginning later. */
#include "compare.h"
#include "mode_equations.h"
#include "scene.h"

#include <math.h>
#include <string.h>

/* Rates that double an input or end it in `time`. */
static tdmf_inputs random_rates(random_source *source, const runner *runner, double time) {
    const tdmf_inputs rates = {
        .ground.friction = runner->inputs.ground.friction * random_uniform(source, -1.0, 1.0) / time,
        .hip.external_torque = runner->model.scales.energy * random_uniform(source, -1.0, 1.0) / time};
    return rates;
}

static void assert_same_state(const runner *runner, const double *state) {
    const tdmf_scales *scales = &runner->model.scales;
    const double units[TDMF_MECHANICAL_COUNT] = {
        scales->length, scales->length, scales->length, 1.0,
        scales->speed,  scales->speed,  scales->speed,  1.0 / scales->time};
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        assert_close(state[i], runner->motion.state[i], 1e-13 * units[i]);
    }
    for (int i = TDMF_MECHANICAL_COUNT; i < TDMF_STATE_COUNT; ++i) {
        assert_true(state[i] == runner->motion.state[i]);
    }
}

static void assert_same_law(const tdmf_hip_law *actual, const tdmf_hip_law *expected, double energy) {
    assert_close(actual->torque, expected->torque, 1e-13 * energy);
    assert_close(actual->target, expected->target, 1e-13 * (1.0 + fabs(expected->target)));
    assert_true(actual->torque_rate == expected->torque_rate && actual->gain == expected->gain &&
                actual->rate_gain == expected->rate_gain && actual->target_rate == expected->target_rate);
}

/* The coordinates need not follow the motion: the leg is the same after `elapsed`. */
static void assert_goes_on_as_begun_later(const runner *runner, const tdmf_mode_equations *begun,
                                          const tdmf_inputs *rates, double elapsed) {
    const tdmf_scales *scales = &runner->model.scales;
    const tdmf_inputs inputs = tdmf_inputs_after(&runner->inputs, rates, elapsed);
    double state[TDMF_STATE_COUNT];
    tdmf_mode_equations shifted = *begun, later;
    tdmf_state_in_mode(begun, elapsed, &begun->start, state);
    tdmf_shift_mode(&shifted, elapsed, &begun->start);
    tdmf_open_mode(&later, (tdmf_system){&runner->model, &inputs}, rates, &runner->motion.mode, state,
                   tdmf_leg_direction_of(state));
    assert_same_law(&shifted.law, &later.law, scales->energy);
    assert_same_law(&shifted.stance_law, &later.stance_law, scales->energy);
    assert_same_law(&shifted.servo, &later.servo, scales->energy);
    assert_close(shifted.place_time, later.place_time, 1e-13 * (scales->time + later.place_time));
    assert_close(shifted.friction, later.friction, 1e-14 * fabs(later.friction));
    assert_close(shifted.static_friction, later.static_friction, 1e-14 * later.static_friction);
    assert_true(shifted.friction_rate == later.friction_rate);
    assert_true(shifted.static_friction_rate == later.static_friction_rate);
    if (runner->motion.mode.contact == TDMF_CONTACT_FLIGHT) {
        assert_close(shifted.com.x, later.com.x, 1e-13 * scales->length);
        assert_close(shifted.com.y, later.com.y, 1e-13 * scales->length);
        assert_close(shifted.com.vx, later.com.vx, 1e-13 * scales->speed);
        assert_close(shifted.com.vy, later.com.vy, 1e-13 * scales->speed);
    }
}

static void a_mode_gives_back_its_state_and_goes_on_as_if_begun_later(void **unused) {
    (void)unused;
    for (int contact = TDMF_CONTACT_FLIGHT; contact <= TDMF_CONTACT_GRAZE; ++contact) {
        random_source source = {(uint64_t)(100 + contact)};
        for (int i = 0; i < 100; ++i) {
            runner runner = scene_random(&source, (tdmf_contact_mode)contact);
            const double elapsed = random_uniform(&source, 0.1, 0.9) * runner.model.scales.time;
            const tdmf_inputs rates = random_rates(&source, &runner, runner.model.scales.time);
            double state[TDMF_STATE_COUNT];
            tdmf_mode_equations equations;
            for (int k = TDMF_MECHANICAL_COUNT; k < TDMF_STATE_COUNT; ++k) {
                runner.motion.state[k] = random_uniform(&source, 0.0, 1.0);
            }
            tdmf_open_mode(&equations, SYSTEM_OF(&runner), &rates, &runner.motion.mode, runner.motion.state,
                           tdmf_leg_direction_of(runner.motion.state));
            tdmf_state_in_mode(&equations, 0.0, &equations.start, state);
            assert_same_state(&runner, state);
            assert_goes_on_as_begun_later(&runner, &equations, &rates, elapsed);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mode_gives_back_its_state_and_goes_on_as_if_begun_later)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
