/* Random runs of the native solver over the ranges that modelDescription.xml declares: parameters, inputs,
 * starts and tolerances. A run goes on, falls or is given up with a reason, within its steps; its numbers are
 * numbers, its energy ledger closes, its foot stays out of the ground, and it falls only where the state that
 * is handed back has fallen.
 *
 *     test_declared_runs [RUNS [FIRST SEED]] */
#include "compare.h"
#include "declared.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PIECES = 8, STEPS_OF_A_PIECE = 2000, OUTCOMES = TDMF_REFUSED + 1 };

/* Of the energies met: what rounding and the margins of guards leave open. */
static const double ledger_rounding = 1e-12;

static long runs = 5000;
static long first_seed = 0;

typedef struct {
    tdmf_model model;
    tdmf_inputs inputs;
    double decades;
    tdmf_solver solver;
    tdmf_motion motion;
    double start_energy;
    double turnover; /* the largest energy met, J */
} run;

/* What the sample has met. */
typedef struct {
    long refused, outcomes[OUTCOMES], contact[TDMF_CONTACT_GRAZE + 1], strides;
} tally;

/* ---- what must hold -------------------------------------------------------------------------------------
 */

static double loss_of_ledger(const run *run) {
    const double *state = run->motion.state;
    return tdmf_mechanical_energy(&run->model, &run->inputs, &run->motion.mode, state).total -
           run->start_energy - state[TDMF_HIP_WORK] - state[TDMF_LEG_WORK] -
           state[TDMF_ENERGY_EXTERNAL_WORK] + state[TDMF_ENERGY_DAMPER_LOSS] +
           state[TDMF_ENERGY_FRICTION_LOSS] + run->motion.record.impact_loss;
}

static double largest_energy(const run *run) {
    const double *state = run->motion.state;
    const tdmf_energy energy = tdmf_mechanical_energy(&run->model, &run->inputs, &run->motion.mode, state);
    return energy.kinetic + fabs(energy.potential) + energy.elastic + fabs(state[TDMF_HIP_WORK]) +
           fabs(state[TDMF_LEG_WORK]) + fabs(state[TDMF_ENERGY_EXTERNAL_WORK]) +
           state[TDMF_HIP_POSITIVE_WORK] + state[TDMF_ENERGY_DAMPER_LOSS] + state[TDMF_ENERGY_FRICTION_LOSS] +
           run->motion.record.impact_loss;
}

static const char *not_a_number(const run *run) {
    const tdmf_motion *motion = &run->motion;
    const tdmf_outputs outputs =
        tdmf_outputs_of(&run->model, &run->inputs, &motion->mode, &motion->record, motion->state);
    const double told[] = {motion->time,           outputs.body.y,
                           outputs.com.vx,         outputs.contact.fx,
                           outputs.contact.fy,     outputs.hip.torque,
                           outputs.energy.total,   outputs.energy.impact_loss,
                           outputs.stride.speed,   outputs.stride.cost_of_transport,
                           outputs.apex.com_height};
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        if (!isfinite(motion->state[i])) {
            return "a state is not finite";
        }
    }
    for (size_t i = 0; i < sizeof told / sizeof told[0]; ++i) {
        if (isnan(told[i])) {
            return "an output is not a number";
        }
    }
    return NULL;
}

/* Of heights: a leg may have become ever so long, and have turned ever so often. */
static double rounding_of(const run *run) {
    const double *state = run->motion.state;
    return 1e-12 * (run->model.scales.length + fabs(state[TDMF_FOOT_Y]) + state[TDMF_LEG_LENGTH]);
}

static const char *false_fall(const run *run, tdmf_outcome outcome) {
    const double *state = run->motion.state;
    const double rounding = rounding_of(run);
    if (run->motion.mode.fallen != (outcome == TDMF_FELL)) {
        return "the outcome and the mode disagree about a fall";
    }
    const bool down = tdmf_body(state).y <= rounding;
    const bool short_leg = state[TDMF_LEG_LENGTH] <= run->model.parameters.leg.min_length + rounding;
    return outcome == TDMF_FELL && !down && !short_leg ? "a fall that is none" : NULL;
}

/* A step errs by the tolerance, in the scales of the runner or of its motion, whichever are larger; an event
 * by the margin of its guard. */
static const char *open_ledger(const run *run) {
    const double scale = run->turnover + run->model.scales.energy +
                         run->model.total_mass * run->model.parameters.gravity * run->model.scales.length;
    const double steps = (double)(run->solver.steps + run->solver.events) + 10.0;
    const double allowed = (10.0 * run->solver.relative_tolerance * steps + ledger_rounding) * scale;
    return fabs(loss_of_ledger(run)) <= allowed ? NULL : "the energy ledger does not close";
}

static const char *foot_in_the_ground(const run *run) {
    const double depth = -run->motion.state[TDMF_FOOT_Y];
    const bool flies = run->motion.mode.contact == TDMF_CONTACT_FLIGHT;
    const double allowed = flies ? 1e-6 * run->model.scales.length + rounding_of(run) : 0.0;
    return depth > allowed ? "the foot is in the ground" : NULL;
}

static const char *what_is_wrong(const run *run, tdmf_outcome outcome) {
    const char *wrong = not_a_number(run);
    if (wrong == NULL && outcome != TDMF_REFUSED) {
        wrong = false_fall(run, outcome);
    }
    if (wrong != NULL) {
        return wrong;
    }
    wrong = open_ledger(run);
    return wrong != NULL ? wrong : foot_in_the_ground(run);
}

/* ---- a run ----------------------------------------------------------------------------------------------
 */

static void change_inputs(random_source *source, run *run) {
    tdmf_motion *motion = &run->motion;
    tdmf_observe(&run->model, &run->inputs, motion->state, &motion->mode, &motion->record);
    run->inputs = declared_inputs(source, &run->model.parameters, run->decades);
}

static tdmf_outcome advance(random_source *source, run *run) {
    const double duration = run->model.scales.time * random_magnitude(source, 0.1, 30.0);
    const double start = run->motion.time;
    const int64_t steps = run->solver.steps;
    tdmf_inputs rates = {.ground = {.friction = 0.0}};
    if (random_chance(source, 0.2)) {
        rates.ground.friction = random_uniform(source, -1.0, 1.0) / duration;
        rates.hip.external_torque = random_uniform(source, -0.1, 0.1) * run->model.scales.energy / duration;
    }
    const tdmf_outcome outcome =
        tdmf_native_advance(&run->solver, &run->model, &run->inputs, &rates, start + duration, &run->motion);
    assert_true(run->solver.steps - steps <= STEPS_OF_A_PIECE);
    assert_true(outcome != TDMF_ARRIVED || run->motion.time == start + duration);
    run->inputs = tdmf_inputs_after(&run->inputs, &rates, run->motion.time - start);
    run->turnover = fmax(run->turnover, largest_energy(run));
    return outcome;
}

/* False where the start is refused. */
static bool begin(random_source *source, run *run) {
    static const double decades[] = {0.1, 0.3, 1.0, 3.0, INFINITY};
    run->decades = decades[(int)random_uniform(source, 0.0, 5.0) % 5];
    const declared_runner runner = declared_random(source, run->decades);
    run->solver = tdmf_solver_default();
    run->solver.relative_tolerance = random_magnitude(source, 1e-14, 1e-2);
    run->solver.step_limit = STEPS_OF_A_PIECE;
    run->solver.event_limit = STEPS_OF_A_PIECE;
    run->inputs = runner.inputs;
    memset(&run->motion, 0, sizeof run->motion);
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        run->motion.state[i] = runner.state[i];
    }
    assert_null(tdmf_model_create(&run->model, &runner.parameters).variable);
    const double energy =
        tdmf_mechanical_energy(&run->model, &run->inputs, &run->motion.mode, run->motion.state).total;
    if (tdmf_start(&run->model, &run->inputs, 0.0, run->motion.state, &run->motion.mode, &run->motion.record)
            .variable != NULL) {
        return false;
    }
    run->start_energy = energy;
    run->turnover = largest_energy(run);
    return true;
}

/* What is wrong with the run of this seed, or NULL. */
static const char *follow(uint64_t seed, tally *seen) {
    random_source source = {seed};
    run run;
    if (!begin(&source, &run)) {
        ++seen->refused;
        return NULL;
    }
    const char *wrong = NULL;
    tdmf_outcome outcome = TDMF_ARRIVED;
    for (int i = 0; i < PIECES && outcome == TDMF_ARRIVED && wrong == NULL; ++i) {
        if (random_chance(&source, 0.3)) {
            change_inputs(&source, &run);
        }
        outcome = advance(&source, &run);
        wrong = what_is_wrong(&run, outcome);
        ++seen->outcomes[outcome];
        ++seen->contact[run.motion.mode.contact];
    }
    seen->strides += run.motion.record.stride.count;
    return wrong;
}

/* ---- tests ----------------------------------------------------------------------------------------------
 */

/* The sample must have met what it is meant to meet. */
static void assert_saw_everything(const tally *seen) {
    assert_true(seen->refused < runs / 2);
    assert_true(seen->outcomes[TDMF_ARRIVED] > runs && seen->outcomes[TDMF_FELL] > runs / 20);
    for (int contact = TDMF_CONTACT_FLIGHT; contact <= TDMF_CONTACT_GRAZE; ++contact) {
        assert_true(seen->contact[contact] > runs / 200);
    }
    assert_true(seen->strides > runs / 100);
}

static void any_declared_runner_goes_on_or_falls_or_is_given_up(void **unused) {
    (void)unused;
    tally seen = {0};
    long wrongs = 0;
    for (long i = 0; i < runs; ++i) {
        const char *wrong = follow((uint64_t)(first_seed + i), &seen);
        if (wrong != NULL && ++wrongs <= 10) {
            print_message("seed %ld: %s\n", first_seed + i, wrong);
        }
        if (runs > 10000 && (i + 1) % 10000 == 0) {
            fprintf(stderr, "%ld of %ld runs\n", i + 1, runs);
        }
    }
    print_message("%ld refused; outcomes", seen.refused);
    for (int i = 0; i < OUTCOMES; ++i) {
        print_message(" %s: %ld;", tdmf_outcome_text((tdmf_outcome)i), seen.outcomes[i]);
    }
    print_message(" strides: %ld\n", seen.strides);
    assert_int_equal(wrongs, 0);
    assert_saw_everything(&seen);
}

int main(int count, char **arguments) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_declared_runner_goes_on_or_falls_or_is_given_up),
    };
    runs = count > 1 ? atol(arguments[1]) : runs;
    first_seed = count > 2 ? atol(arguments[2]) : first_seed;
    return cmocka_run_group_tests(tests, NULL, NULL);
}
