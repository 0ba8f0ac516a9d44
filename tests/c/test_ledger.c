/* The energy ledger of a run: change = work - damper - friction - impact, each integrated on its own. */
#include "compare.h"
#include "integrate.h"
#include "sample.h"

#include <math.h>

typedef struct {
    double work, damper, friction, impact;
} ledger;

static ledger ledger_of(const runner *runner) {
    const ledger ledger = {runner->motion.state[TDMF_HIP_WORK], runner->motion.state[TDMF_ENERGY_DAMPER_LOSS],
                           runner->motion.state[TDMF_ENERGY_FRICTION_LOSS],
                           runner->motion.record.impact_loss};
    return ledger;
}

static double energy_of(const runner *runner) {
    return tdmf_mechanical_energy(SYSTEM_OF(runner), &runner->motion.mode, runner->motion.state).total;
}

/* A slip's last instant may run backward by the margin of its guard. */
static void assert_losses_grow(const ledger *before, const ledger *after) {
    assert_true(after->damper >= before->damper && after->damper >= 0.0);
    assert_true(after->friction >= before->friction - 1e-20 && after->friction >= 0.0);
    assert_true(after->impact >= before->impact && after->impact >= 0.0);
}

static void advance_a_stride(runner *runner, double step) {
    const int count = runner->motion.record.stride.count;
    while (runner->motion.record.stride.count == count) {
        const ledger before = ledger_of(runner);
        assert_true(runner_advance(runner, step));
        const ledger after = ledger_of(runner);
        assert_losses_grow(&before, &after);
    }
}

/* To what a fixed step of Runge-Kutta leaves, against the energy turned over. */
TEST(closes_over_many_strides) {
    enum { STRIDES = sample_of(100) };
    static const double frictions[] = {10.0, 0.6, 0.2};
    for (int i = 0; i < 3; ++i) {
        runner runner = runner_default(frictions[i]);
        runner_start(&runner);
        const double energy = energy_of(&runner);
        for (int stride = 0; stride < STRIDES; ++stride) {
            advance_a_stride(&runner, 2e-3);
            const ledger l = ledger_of(&runner);
            assert_close(energy_of(&runner) - energy, l.work - l.damper - l.friction - l.impact,
                         1e-9 * (l.work + l.damper));
        }
        const ledger total = ledger_of(&runner);
        assert_true(total.damper > 0.0 && total.friction > 0.0 && total.impact > 0.0);
    }
}

/* Backward, under an external torque: signs of work and travel turn, the ledger closes. */
TEST(closes_whatever_the_motion) {
    static const double torques[] = {0.02, -0.02};
    for (int i = 0; i < 2; ++i) {
        runner runner = runner_default(0.4);
        runner.inputs.hip.external_torque = torques[i];
        runner.motion.state[TDMF_FOOT_VX] = -1.0;
        runner_start(&runner);
        const double energy = energy_of(&runner);
        while (runner.motion.time < 60.0 && runner_advance(&runner, 1e-3)) {
        }
        const ledger l = ledger_of(&runner);
        assert_close(energy_of(&runner) - energy, l.work - l.damper - l.friction - l.impact,
                     1e-9 * (fabs(energy) + fabs(l.work)));
    }
}
