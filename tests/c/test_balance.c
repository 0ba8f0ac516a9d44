/* Balance of energy along the flow, by numerical differentiation: it holds in every mode and
 * knows nothing of the equations of motion. */
#include "compare.h"
#include "differentiate.h"
#include "scene.h"

#include <math.h>

enum { STATES_PER_MODE = 300 };

typedef double (*quantity_of_state)(const runner *runner);

typedef struct {
    const runner *runner;
    quantity_of_state quantity;
    double derivatives[TDMF_STATE_COUNT];
} flow;

static long double quantity_on_flow(long double t, const void *context) {
    const flow *flow = context;
    runner moved = *flow->runner;
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        moved.motion.state[i] += (double)t * flow->derivatives[i];
    }
    return (long double)flow->quantity(&moved);
}

/* d/dt of a function of the state, along the tangent of the motion. */
static double rate_of(const runner *runner, quantity_of_state quantity) {
    flow flow = {.runner = runner, .quantity = quantity};
    tdmf_derivatives(SYSTEM_OF(runner), &runner->motion.mode, runner->motion.state, flow.derivatives);
    return (double)derivative_at_zero(quantity_on_flow, &flow, (long double)scene_short_time(runner));
}

typedef void (*check)(const runner *runner);

static void check_in_mode(tdmf_contact_mode contact, check holds) {
    random_source source = {2000 + (uint64_t)contact};
    for (int i = 0; i < STATES_PER_MODE; ++i) {
        const runner runner = scene_random(&source, contact);
        holds(&runner);
    }
}

static void check_in_every_mode(check holds) {
    for (int contact = TDMF_CONTACT_FLIGHT; contact <= TDMF_CONTACT_GRAZE; ++contact) {
        check_in_mode((tdmf_contact_mode)contact, holds);
    }
}

/* ---- energy ----------------------------------------------------------------------------------------- */

static double total_energy(const runner *runner) {
    return OUTPUTS_OF(runner).energy.total;
}

static void power_balances(const runner *runner) {
    double derivatives[TDMF_STATE_COUNT];
    tdmf_derivatives(SYSTEM_OF(runner), &runner->motion.mode, runner->motion.state, derivatives);
    const double power = derivatives[TDMF_HIP_WORK] - derivatives[TDMF_ENERGY_DAMPER_LOSS] -
                         derivatives[TDMF_ENERGY_FRICTION_LOSS];
    const double turning = fabs(runner->motion.state[TDMF_LEG_ANGLE_RATE]) * runner->model.scales.length;
    const double speed = runner->model.scales.speed + turning;
    assert_close(rate_of(runner, total_energy), power, speed * scene_force_tolerance(runner));
}

TEST(hip_power_less_losses_changes_the_energy) {
    check_in_every_mode(power_balances);
}

static void integrals_follow_their_definitions(const runner *runner) {
    double derivatives[TDMF_STATE_COUNT];
    tdmf_derivatives(SYSTEM_OF(runner), &runner->motion.mode, runner->motion.state, derivatives);
    const double length_rate = runner->motion.state[TDMF_LEG_LENGTH_RATE];
    const double power = OUTPUTS_OF(runner).hip.torque * runner->motion.state[TDMF_LEG_ANGLE_RATE];
    const double damped = runner->model.parameters.leg.damping * length_rate * length_rate;
    const double rubbed = -OUTPUTS_OF(runner).contact.tangential *
                          tdmf_foot_over_ground(&runner->motion.mode.ground, runner->motion.state).vx;
    /* On the ground the leg's rates come from the body's velocity, so they round with its size. */
    const double speed = fabs(length_rate) + fabs(runner->motion.state[TDMF_LEG_LENGTH] *
                                                  runner->motion.state[TDMF_LEG_ANGLE_RATE]);
    const double rounding = 1e-15 * runner->model.parameters.leg.damping * fabs(length_rate) * speed;
    const double torque = OUTPUTS_OF(runner).hip.torque;
    const double forces = fabs(torque) / runner->motion.state[TDMF_LEG_LENGTH] + runner->model.scales.force;
    const double rounding_of_power = 1e-14 * forces * (speed + runner->model.scales.speed);
    assert_close(derivatives[TDMF_HIP_WORK], power, rounding_of_power);
    assert_close(derivatives[TDMF_HIP_POSITIVE_WORK], power > 0.0 ? power : 0.0, rounding_of_power);
    assert_close(derivatives[TDMF_ENERGY_DAMPER_LOSS], damped, 1e-14 * damped + rounding);
    assert_relatively_close(derivatives[TDMF_ENERGY_FRICTION_LOSS], rubbed, 1e-13);
    assert_true(derivatives[TDMF_HIP_PLACE_TIME] == (runner->motion.mode.phase == TDMF_PHASE_PLACE));
}

TEST(work_and_losses_are_integrals_of_power) {
    check_in_every_mode(integrals_follow_their_definitions);
}
