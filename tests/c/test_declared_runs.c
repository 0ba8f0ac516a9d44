/* Random runs of the native solver over the ranges that the unit declares: parameters, inputs,
 * starts and tolerances. Half of them are over uneven ground as well, with pushes, a leg that is extended and
 * a controller that changes inputs and settings in mid-run. A run goes on, falls or is given up with a
 * reason, within its steps; its numbers are numbers, its energy ledger closes, its foot keeps to the ground
 * in force and to its mode, and it falls only where the state that is handed back has fallen.
 *
 *     test_declared_runs [RUNS [FIRST SEED]] */
#include "compare.h"
#include "declared.h"
#include "ground_line.h"
#include "sample.h"
#include "simulation.h"
#include "system_of.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PARTS = 8, STEPS_OF_A_PART = 2000, OUTCOMES = TDMF_REFUSED + 1 };

/* Error of the ledger from rounding and from the margins of guards, relative to the largest energy met. */
static const double ledger_rounding = 1e-12;

static long runs = TDMF_SAMPLE_DIVISOR > 10 ? 1500 : 5000;
static long first_seed = 0;

typedef struct {
    bool has_further_inputs;       /* see declared_further_inputs */
    random_source source, further; /* `further` draws the further inputs */
    tdmf_model model;
    tdmf_inputs inputs;
    double decades;
    tdmf_solver solver;
    tdmf_motion motion;
    double start_energy;
    double farthest;    /* the largest distance of the foot from the origin met, m */
    double turnover;    /* the largest energy met, J */
    double push_energy; /* the largest product of a push and of the body's place met, J */
    double body_energy; /* the largest product of the body's momentum and of the speeds that its own is the
                           sum of: those of the foot and of the leg, J */
} run;

/* Counts of outcomes, modes and features over the sample. */
typedef struct {
    long refused, outcomes[OUTCOMES], contact[TDMF_CONTACT_GRAZE + 1], strides;
    long with_further_inputs, waiting, leg_work, external_work;
} tally;

/* ---- what must hold -------------------------------------------------------------------------------------
 */

static double loss_of_ledger(const run *run) {
    const double *state = run->motion.state;
    return OUTPUTS_OF(run).energy.total - run->start_energy - state[TDMF_HIP_WORK] - state[TDMF_LEG_WORK] -
           state[TDMF_ENERGY_EXTERNAL_WORK] + state[TDMF_ENERGY_DAMPER_LOSS] +
           state[TDMF_ENERGY_FRICTION_LOSS] + run->motion.state[TDMF_ENERGY_IMPACT_LOSS];
}

static double largest_energy(const run *run) {
    const double *state = run->motion.state;
    const tdmf_outputs now = OUTPUTS_OF(run);
    const double thrust = run->model.parameters.leg.thrust + run->inputs.control.thrust;
    const double of_thrust = run->model.parameters.leg.stiffness * thrust * thrust; /* off again, maybe */
    return now.energy.kinetic + fabs(now.energy.potential) + now.energy.elastic + of_thrust +
           fabs(state[TDMF_HIP_WORK]) + fabs(state[TDMF_LEG_WORK]) + fabs(state[TDMF_ENERGY_EXTERNAL_WORK]) +
           state[TDMF_HIP_POSITIVE_WORK] + state[TDMF_ENERGY_DAMPER_LOSS] + state[TDMF_ENERGY_FRICTION_LOSS] +
           run->motion.state[TDMF_ENERGY_IMPACT_LOSS];
}

static double push_energy(const run *run, const tdmf_inputs *inputs) {
    const double *state = run->motion.state;
    const double length = state[TDMF_LEG_LENGTH];
    return fabs(inputs->body.external_fx) * (fabs(state[TDMF_FOOT_X]) + length) +
           fabs(inputs->body.external_fy) * (fabs(state[TDMF_FOOT_Y]) + length);
}

static double body_energy(const run *run, const double *state) {
    const tdmf_point body = tdmf_body(state);
    const double of_leg =
        fabs(state[TDMF_LEG_LENGTH_RATE]) + state[TDMF_LEG_LENGTH] * fabs(state[TDMF_LEG_ANGLE_RATE]);
    return run->model.parameters.body.mass * hypot(body.vx, body.vy) *
           (hypot(state[TDMF_FOOT_VX], state[TDMF_FOOT_VY]) + of_leg);
}

/* Within a piece, a light foot may be faster than at its ends. */
static void record_event(void *subject, const tdmf_event *event) {
    run *run = subject;
    run->body_energy = fmax(run->body_energy, body_energy(run, event->state));
}

/* Records the largest energies of a run's last piece, which began with the inputs `from`. */
static void record_energies(run *run, const tdmf_inputs *from) {
    const double *state = run->motion.state;
    run->farthest = fmax(run->farthest, hypot(state[TDMF_FOOT_X], state[TDMF_FOOT_Y]));
    run->body_energy = fmax(run->body_energy, body_energy(run, state));
    run->turnover = fmax(run->turnover, largest_energy(run));
    run->push_energy = fmax(run->push_energy, fmax(push_energy(run, from), push_energy(run, &run->inputs)));
}

static const char *not_a_number(const run *run) {
    const tdmf_motion *motion = &run->motion;
    const tdmf_outputs outputs = outputs_of(SYSTEM_OF(run), motion);
    const double numbers[] = {motion->time,           outputs.body.y,
                              outputs.com.vx,         outputs.contact.fx,
                              outputs.contact.fy,     outputs.hip.torque,
                              outputs.energy.total,   outputs.energy.impact_loss,
                              outputs.stride.speed,   outputs.stride.cost_of_transport,
                              outputs.apex.com_height};
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        /* A stride that leads nowhere has an infinite cost of transport. */
        if (i != TDMF_STRIDE_COST_OF_TRANSPORT && !isfinite(motion->state[i])) {
            return "a state is not finite";
        }
    }
    for (size_t i = 0; i < COUNT_OF(numbers); ++i) {
        if (isnan(numbers[i])) {
            return "an output is not a number";
        }
    }
    return NULL;
}

/* Rounding error of heights, which grows with the leg length and the place of the foot. A short leg may have
 * come from far away. */
static double rounding_of(const run *run) {
    const double *state = run->motion.state;
    const tdmf_ground_line *ground = &run->motion.mode.ground;
    return 1e-12 * (run->model.scales.length + fabs(state[TDMF_FOOT_Y]) + state[TDMF_LEG_LENGTH] +
                    fabs(ground->height) + fabs(ground->sine * state[TDMF_FOOT_X])) +
           4.0 * DBL_EPSILON * run->farthest;
}

static const char *false_fall(const run *run, tdmf_outcome outcome) {
    const double *state = run->motion.state;
    const double rounding = rounding_of(run);
    if (run->motion.mode.fallen != (outcome == TDMF_FELL)) {
        return "the outcome and the mode disagree about a fall";
    }
    const tdmf_point body = tdmf_body(state);
    const bool down = tdmf_height_over(&run->motion.mode.ground, body.x, body.y) <= rounding;
    const bool short_leg = state[TDMF_LEG_LENGTH] <= run->model.parameters.leg.min_length + rounding;
    return outcome == TDMF_FELL && !down && !short_leg ? "a fall that is none" : NULL;
}

/* A step errs by the tolerance, in the scales of the runner or of its motion, whichever are larger; an event
 * by the margin of its guard; the work of a push by the rounding of the places that it leads from and to; the
 * speed of a body by the rounding of a light foot's, which may be millions of times as fast. */
static const char *open_ledger(const run *run) {
    const double scale = run->turnover + run->model.scales.energy +
                         run->model.total_mass * run->model.parameters.gravity * run->model.scales.length;
    const double steps = (double)(run->solver.steps + run->solver.events) + 10.0;
    const double allowed = (10.0 * run->solver.relative_tolerance * steps + ledger_rounding) * scale +
                           4.0 * DBL_EPSILON * steps * (run->push_energy + run->body_energy);
    return fabs(loss_of_ledger(run)) <= allowed ? NULL : "the energy ledger does not close";
}

/* Up to which a foot is at a line: to the guard's margin, and of a leg that has become long to what a step is
 * trusted for, which is relative to the length. */
static double nearest_to_line(const run *run) {
    const double lengths = run->model.scales.length + run->motion.state[TDMF_LEG_LENGTH];
    const double error = 2.0 * TDMF_GUARD_MARGIN + fmin(1e-3 * run->solver.relative_tolerance, 1e-8);
    return 1e-9 * run->model.scales.length + error * lengths + rounding_of(run);
}

static double height_of_foot(const run *run, const tdmf_ground_line *line) {
    return tdmf_height_over(line, run->motion.state[TDMF_FOOT_X], run->motion.state[TDMF_FOOT_Y]);
}

static const char *foot_in_the_ground(const run *run) {
    const tdmf_ground_line *ground = &run->motion.mode.ground;
    const bool flies = run->motion.mode.contact == TDMF_CONTACT_FLIGHT;
    const bool is_axis = ground->height == 0.0 && ground->sine == 0.0;
    const double allowed = flies ? nearest_to_line(run) : is_axis ? 0.0 : rounding_of(run);
    return -height_of_foot(run, ground) > allowed ? "the foot is in the ground" : NULL;
}

/* A new line waits for a foot that stands or is below it. */
static const char *waits_for_nothing(const run *run) {
    const tdmf_mode *mode = &run->motion.mode;
    const tdmf_ground_line line = tdmf_ground_line_set(&run->inputs);
    const bool may_wait = mode->contact != TDMF_CONTACT_FLIGHT || mode->fallen ||
                          height_of_foot(run, &line) <= nearest_to_line(run);
    return tdmf_ground_is_pending(&run->inputs, mode) && !may_wait ? "new ground is not in force" : NULL;
}

/* Contact, phase and what is noted with them go together. */
static const char *broken_mode(const run *run) {
    const tdmf_mode *mode = &run->motion.mode;
    const bool in_contact = tdmf_is_loaded(mode);
    const bool may_clamp = mode->phase == TDMF_PHASE_RETRACT && run->model.parameters.hip.swing_clamp;
    const bool sound = in_contact == (mode->phase == TDMF_PHASE_DRIVE || mode->phase == TDMF_PHASE_COAST) &&
                       (!in_contact || mode->mid_stance_pending == (mode->phase == TDMF_PHASE_DRIVE)) &&
                       (!mode->clamp_closed || may_clamp);
    return sound ? NULL : "contact and phase do not go together";
}

/* A foot at the ground stays there; one that sticks rests, and one that slips does so its own way. The ground
 * never pulls, and friction stays in its cone. (A run that is given up at once may stand before an event.) */
static const char *broken_contact(const run *run, tdmf_outcome outcome) {
    const tdmf_mode *mode = &run->motion.mode;
    const double *state = run->motion.state;
    const tdmf_point foot = tdmf_foot_over_ground(&mode->ground, state);
    const tdmf_outputs now = OUTPUTS_OF(run);
    const double turning = state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE];
    const double speed = run->model.scales.speed + fabs(turning) + fabs(foot.vx);
    const double share = 2.0 * TDMF_GUARD_MARGIN + 1e2 * run->solver.relative_tolerance;
    const double forces = run->model.scales.force + fabs(now.contact.tangential) +
                          run->model.parameters.leg.damping * speed +
                          run->model.parameters.leg.stiffness * fabs(state[TDMF_LEG_LENGTH]);
    /* static friction, because slow slips may have it, too */
    const tdmf_parameters *p = &run->model.parameters;
    const double friction =
        p->ground.static_friction_ratio * fmax(run->inputs.ground.friction, p->ground.patch_friction);
    if (mode->contact == TDMF_CONTACT_FLIGHT || outcome != TDMF_ARRIVED) {
        return NULL;
    }
    if (fabs(foot.vy) > 1e-12 * speed || (mode->contact == TDMF_CONTACT_STICK && foot.vx != 0.0) ||
        tdmf_sign_of_slip(mode) * foot.vx < -share * speed) {
        return "a foot at the ground moves as it must not";
    }
    return now.contact.normal < -share * forces ||
                   fabs(now.contact.tangential) >
                       friction * now.contact.normal + share * (1.0 + friction) * forces
               ? "the ground pulls, or friction leaves its cone"
               : NULL;
}

static const char *what_is_wrong(const run *run, tdmf_outcome outcome) {
    const char *wrong = not_a_number(run);
    if (wrong != NULL || outcome == TDMF_REFUSED) {
        return wrong;
    }
    if (outcome == TDMF_TOO_MANY_EVENTS) {
        return "a chain of events does not end";
    }
    const char *found[] = {false_fall(run, outcome), open_ledger(run), foot_in_the_ground(run),
                           waits_for_nothing(run),   broken_mode(run), broken_contact(run, outcome)};
    for (size_t i = 0; i < COUNT_OF(found) && wrong == NULL; ++i) {
        wrong = found[i];
    }
    return wrong;
}

/* ---- a run ----------------------------------------------------------------------------------------------
 */

static void change_inputs(run *run) {
    tdmf_observe(SYSTEM_OF(run), &run->motion);
    run->inputs = declared_inputs(&run->source, &run->model.parameters, run->decades);
}

/* One event changes the foot's ground, pushes, control inputs, settings, or all of them. */
static void change_further(run *run) {
    tdmf_parameters parameters = run->model.parameters;
    tdmf_observe(SYSTEM_OF(run), &run->motion);
    if (random_chance(&run->further, 0.7)) {
        declared_further_inputs(&run->further, &parameters, run->decades, &run->inputs);
    }
    if (random_chance(&run->further, 0.5)) {
        declared_settings(&run->further, run->decades, &parameters);
        run->model = accepted_model(&parameters);
    }
}

/* Ramps of what need not be held, of the size that inputs have. */
static void add_further_rates(run *run, double duration, tdmf_inputs *rates) {
    tdmf_inputs sizes = tdmf_default_inputs();
    declared_further_inputs(&run->further, &run->model.parameters, run->decades, &sizes);
    rates->leg.extension = sizes.leg.extension / duration;
    rates->body.external_fx = sizes.body.external_fx / duration;
    rates->body.external_fy = sizes.body.external_fy / duration;
}

static tdmf_inputs random_rates(run *run, double duration) {
    tdmf_inputs rates = {.ground = {.friction = 0.0}};
    if (random_chance(&run->source, 0.2)) {
        rates.ground.friction = random_uniform(&run->source, -1.0, 1.0) / duration;
        rates.hip.external_torque =
            random_uniform(&run->source, -0.1, 0.1) * run->model.scales.energy / duration;
    }
    if (run->has_further_inputs && random_chance(&run->further, 0.3)) {
        add_further_rates(run, duration, &rates);
    }
    return rates;
}

static tdmf_outcome advance(run *run) {
    const double duration = run->model.scales.time * random_magnitude(&run->source, 0.1, 30.0);
    const tdmf_inputs rates = random_rates(run, duration);
    const tdmf_motion before = run->motion;
    const int64_t steps = run->solver.steps;
    const tdmf_outcome outcome =
        tdmf_native_advance(&run->solver, SYSTEM_OF(run), &rates, before.time + duration, &run->motion);
    assert_true(run->solver.steps - steps <= STEPS_OF_A_PART);
    assert_true(outcome != TDMF_ARRIVED || run->motion.time == before.time + duration);
    if (outcome == TDMF_REFUSED) {
        assert_memory_equal(&run->motion, &before, sizeof before);
        return outcome;
    }
    const tdmf_inputs from = run->inputs;
    run->inputs = tdmf_inputs_after(&from, &rates, run->motion.time - before.time);
    record_energies(run, &from);
    return outcome;
}

/* Moves the foot from its height above level ground to the same height above the run's own ground. */
static void lift_to_ground(run *run) {
    declared_further_inputs(&run->further, &run->model.parameters, run->decades, &run->inputs);
    const tdmf_ground_line line = tdmf_ground_line_set(&run->inputs);
    run->motion.state[TDMF_FOOT_Y] += tdmf_ground_height_at(&line, run->motion.state[TDMF_FOOT_X]);
}

/* False where the start is refused. */
static bool begin(uint64_t seed, run *run) {
    static const double decades[] = {0.1, 0.3, 1.0, 3.0, INFINITY};
    memset(run, 0, sizeof *run);
    run->source.state = seed;
    run->further.state = ~seed;
    run->has_further_inputs = random_chance(&run->further, 0.5);
    run->decades = decades[(int)random_uniform(&run->source, 0.0, 5.0) % 5];
    const declared_runner runner = declared_random(&run->source, run->decades);
    run->solver = tdmf_solver_default();
    run->solver.relative_tolerance = random_magnitude(&run->source, 1e-14, 1e-2);
    run->solver.step_limit = STEPS_OF_A_PART;
    run->solver.event_limit = STEPS_OF_A_PART;
    run->solver.on_event = record_event;
    run->solver.subject = run;
    run->inputs = runner.inputs;
    memcpy(run->motion.state, runner.state, sizeof runner.state);
    run->model = accepted_model(&runner.parameters);
    if (run->has_further_inputs) {
        lift_to_ground(run);
    }
    tdmf_motion *motion = &run->motion;
    motion->mode.ground = tdmf_ground_line_set(&run->inputs);
    run->start_energy = OUTPUTS_OF(run).energy.total;
    motion->time = 0.0;
    if (tdmf_start(SYSTEM_OF(run), motion).variable != NULL) {
        return false;
    }
    record_energies(run, &run->inputs);
    return true;
}

static void record_what_is_met(const run *run, tally *seen) {
    const double *state = run->motion.state;
    seen->waiting += tdmf_ground_is_pending(&run->inputs, &run->motion.mode);
    seen->leg_work += state[TDMF_LEG_WORK] != 0.0;
    seen->external_work += state[TDMF_ENERGY_EXTERNAL_WORK] != 0.0;
}

/* Runs a seed. Returns the first fault, or NULL. */
static const char *follow(uint64_t seed, tally *seen) {
    run run;
    if (!begin(seed, &run)) {
        ++seen->refused;
        return NULL;
    }
    const char *wrong = NULL;
    tdmf_outcome outcome = TDMF_ARRIVED;
    for (int i = 0; i < PARTS && outcome == TDMF_ARRIVED && wrong == NULL; ++i) {
        if (random_chance(&run.source, 0.3)) {
            change_inputs(&run);
        }
        if (run.has_further_inputs && random_chance(&run.further, 0.5)) {
            change_further(&run);
        }
        outcome = advance(&run);
        wrong = what_is_wrong(&run, outcome);
        ++seen->outcomes[outcome];
        ++seen->contact[run.motion.mode.contact];
        record_what_is_met(&run, seen);
    }
    seen->strides += (long)run.motion.state[TDMF_STRIDE_COUNT];
    seen->with_further_inputs += run.has_further_inputs;
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
    assert_true(seen->with_further_inputs > runs / 5 && seen->waiting > runs / 25);
    assert_true(seen->leg_work > runs / 5 && seen->external_work > runs / 5);
}

TEST(any_declared_runner_goes_on_or_falls_or_is_given_up) {
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
    print_message(
        " strides: %ld; runs with further inputs: %ld; instants at which new ground waits: %ld, with work of "
        "the leg: %ld, of pushes: %ld\n",
        seen.strides, seen.with_further_inputs, seen.waiting, seen.leg_work, seen.external_work);
    assert_int_equal(wrongs, 0);
    assert_saw_everything(&seen);
}

/* Guards of these runs are zero to more than their first derivative, or differences of numbers 1e16 times
 * their scale. They have hopped for ever, sunk into the ground, or changed their mode for ever. */
TEST(runs_whose_guards_are_hardly_zero_go_on_as_well) {
    static const uint64_t seeds[] = {109214, 295867, 79179,  8868, 164289, 453,    30665,  105067, 113220,
                                     115691, 132324, 139180, 1387, 2910,   227374, 296310, 332412, 348395};
    tally seen = {0};
    for (size_t i = 0; i < sizeof seeds / sizeof seeds[0]; ++i) {
        const char *wrong = follow(seeds[i], &seen);
        if (wrong != NULL) {
            print_message("seed %d: %s\n", (int)seeds[i], wrong);
        }
        assert_null(wrong);
    }
    assert_int_equal(seen.refused + seen.outcomes[TDMF_NO_PROGRESS], 0);
}

int main(int count, char **arguments) {
    runs = count > 1 ? atol(arguments[1]) : runs;
    first_seed = count > 2 ? atol(arguments[2]) : first_seed;
    return run_registered_tests();
}
