/* Accelerations, ground forces and the graze torque against Lagrange's equations by numerical
 * differentiation.
 *
 * All that this derivation knows is where the two point masses are, the energy of the spring, and which
 * generalized forces act: damper along r, torque along theta, ground force at the foot. In every mode the
 * unknowns are (xddot, yddot, rddot, thetaddot, f_x, f_y, tau), for which there are four equations of motion
 * and three conditions that define the mode. */
#include "compare.h"
#include "differentiate.h"
#include "sample.h"
#include "scene.h"

#include <float.h>
#include <math.h>
#include <string.h>

enum { X, Y, R, THETA, FREEDOMS, FX = FREEDOMS, FY, TAU, UNKNOWNS };
enum { FOOT_ALONG_X, FOOT_ALONG_Y, BODY_ALONG_X, BODY_ALONG_Y, POSITIONS };

/* ---- Lagrangian of two point masses and a spring ---------------------------------------------------- */

static void positions_of(const long double q[FREEDOMS], long double position[POSITIONS]) {
    position[FOOT_ALONG_X] = q[X];
    position[FOOT_ALONG_Y] = q[Y];
    position[BODY_ALONG_X] = q[X] - q[R] * sinl(q[THETA]);
    position[BODY_ALONG_Y] = q[Y] + q[R] * cosl(q[THETA]);
}

typedef struct {
    const tdmf_parameters *parameters;
    double rest_length;      /* rest length of the spring */
    double force_x, force_y; /* external forces on the body */
    long double q[FREEDOMS];
    long double rate[FREEDOMS];
    long double direction[FREEDOMS]; /* direction of q for the difference */
    int index;                       /* index of the differentiated quantity */
} motion;

static void move(const motion *motion, long double t, long double q[FREEDOMS]) {
    for (int i = 0; i < FREEDOMS; ++i) {
        q[i] = motion->q[i] + t * motion->direction[i];
    }
}

static long double position_on_path(long double t, const void *context) {
    const motion *path = context;
    long double q[FREEDOMS], position[POSITIONS];
    move(path, t, q);
    positions_of(q, position);
    return position[path->index];
}

/* The angle is the only coordinate that enters nonlinearly: the difference moves it by a hundredth. */
static long double differentiate_along(function_of_time f, const motion *motion) {
    return derivative_at_zero(f, motion, 1e-2L / (1.0L + fabsl(motion->direction[THETA])));
}

/* Rate of a position when q moves in `direction`. */
static long double speed_of(motion motion, const long double direction[FREEDOMS], int position) {
    memcpy(motion.direction, direction, sizeof motion.direction);
    motion.index = position;
    return differentiate_along(position_on_path, &motion);
}

static long double kinetic_energy(const motion *motion, const long double rate[FREEDOMS]) {
    long double sum = 0.0L;
    for (int i = 0; i < POSITIONS; ++i) {
        const bool foot = i == FOOT_ALONG_X || i == FOOT_ALONG_Y;
        const double mass = foot ? motion->parameters->foot.mass : motion->parameters->body.mass;
        const long double speed = speed_of(*motion, rate, i);
        sum += 0.5L * (long double)mass * speed * speed;
    }
    return sum;
}

static long double potential_energy(const motion *motion) {
    const tdmf_parameters *p = motion->parameters;
    const long double compression = (long double)motion->rest_length - motion->q[R];
    long double position[POSITIONS];
    positions_of(motion->q, position);
    return (long double)p->gravity * ((long double)p->foot.mass * position[FOOT_ALONG_Y] +
                                      (long double)p->body.mass * position[BODY_ALONG_Y]) +
           0.5L * (long double)p->leg.stiffness * compression * compression -
           (long double)motion->force_x * position[BODY_ALONG_X] -
           (long double)motion->force_y * position[BODY_ALONG_Y];
}

/* dT/d(rate_i). T is a quadratic form of the rates, for which this difference is exact. */
static long double momentum(const motion *motion, const long double rate[FREEDOMS], int i) {
    long double more[FREEDOMS], less[FREEDOMS];
    memcpy(more, rate, sizeof more);
    memcpy(less, rate, sizeof less);
    more[i] += 1.0L;
    less[i] -= 1.0L;
    return 0.5L * (kinetic_energy(motion, more) - kinetic_energy(motion, less));
}

static long double momentum_on_path(long double t, const void *context) {
    motion moved = *(const motion *)context;
    move(context, t, moved.q);
    return momentum(&moved, moved.rate, moved.index);
}

static long double lagrangian_on_path(long double t, const void *context) {
    motion moved = *(const motion *)context;
    move(context, t, moved.q);
    return kinetic_energy(&moved, moved.rate) - potential_energy(&moved);
}

/* ---- equations of motion and of the mode ------------------------------------------------------------ */

typedef long double equation[UNKNOWNS + 1]; /* coefficients of the unknowns, then the right-hand side */

static void fmu_seed(int i, long double direction[FREEDOMS]) {
    memset(direction, 0, FREEDOMS * sizeof *direction);
    direction[i] = 1.0L;
}

/* d/dt dL/d(rate_i) - dL/dq_i = generalized force i */
static void equation_of_motion(motion motion, int i, equation row) {
    long double along[FREEDOMS];
    for (int j = 0; j < FREEDOMS; ++j) {
        fmu_seed(j, along);
        row[j] = momentum(&motion, along, i);
    }
    fmu_seed(i, along);
    row[FX] = -speed_of(motion, along, FOOT_ALONG_X);
    row[FY] = -speed_of(motion, along, FOOT_ALONG_Y);
    row[TAU] = i == THETA ? -1.0L : 0.0L;
    motion.index = i;
    memcpy(motion.direction, motion.rate, sizeof motion.direction);
    row[UNKNOWNS] = -differentiate_along(momentum_on_path, &motion);
    memcpy(motion.direction, along, sizeof motion.direction);
    row[UNKNOWNS] += differentiate_along(lagrangian_on_path, &motion);
    if (i == R) {
        row[UNKNOWNS] -= (long double)motion.parameters->leg.damping * motion.rate[R];
    }
}

/* The control law as the model states it, by phase. */
static double control_law(const runner *runner) {
    const tdmf_parameters *p = &runner->model.parameters;
    const double angle = runner->motion.state[TDMF_LEG_ANGLE];
    const double damping = p->hip.kd * runner->motion.state[TDMF_LEG_ANGLE_RATE];
    switch (runner->motion.mode.phase) {
    case TDMF_PHASE_DRIVE:
        return -p->hip.stance_torque;
    case TDMF_PHASE_COAST:
        return 0.0;
    case TDMF_PHASE_RETRACT: {
        const double target = p->hip.liftoff_angle_factor * runner->motion.state[TDMF_HIP_LIFTOFF_ANGLE];
        const double servo = -p->hip.kp * (angle - target) - damping;
        return p->hip.swing_clamp ? fmax(servo, 0.0) : servo;
    }
    default:
        return scene_place_law(runner);
    }
}

static void require(equation row, int unknown, double value) {
    row[unknown] = 1.0L;
    row[UNKNOWNS] = (long double)value;
}

/* Takes the component along the ground of accelerations or forces as the unknown of a row. */
static void require_along(equation row, const tdmf_ground_line *ground, int x, int y) {
    row[x] = (long double)ground->cosine;
    row[y] = (long double)ground->sine;
}

static void require_off(equation row, const tdmf_ground_line *ground, int x, int y, double factor) {
    row[x] -= (long double)(factor * ground->sine);
    row[y] += (long double)(factor * ground->cosine);
}

/* Writes the conditions of the mode into the last three rows. The ground is a line that the foot cannot
 * leave. */
static void equations_of_mode(const runner *runner, equation rows[UNKNOWNS]) {
    const double torque = control_law(runner) + runner->inputs.hip.external_torque;
    const tdmf_contact_mode contact = runner->motion.mode.contact;
    const tdmf_ground_line *ground = &runner->motion.mode.ground;
    if (contact == TDMF_CONTACT_GRAZE) {
        require(rows[FREEDOMS + 0], FX, 0.0);
        require(rows[FREEDOMS + 1], FY, 0.0);
        require_off(rows[FREEDOMS + 2], ground, X, Y, 1.0);
        return;
    }
    require(rows[FREEDOMS + 0], TAU, torque);
    if (contact == TDMF_CONTACT_FLIGHT) {
        require(rows[FREEDOMS + 1], FX, 0.0);
        require(rows[FREEDOMS + 2], FY, 0.0);
        return;
    }
    require_off(rows[FREEDOMS + 1], ground, X, Y, 1.0);
    if (contact == TDMF_CONTACT_STICK) {
        require_along(rows[FREEDOMS + 2], ground, X, Y);
    } else {
        const double sign = contact == TDMF_CONTACT_SLIP_POSITIVE ? 1.0 : -1.0;
        require_along(rows[FREEDOMS + 2], ground, FX, FY);
        require_off(rows[FREEDOMS + 2], ground, FX, FY, sign * runner->inputs.ground.friction);
    }
}

/* Gauss-Jordan elimination; the solution ends up on the right-hand side. */
static void solve(equation rows[UNKNOWNS]) {
    for (int column = 0; column < UNKNOWNS; ++column) {
        int best = column;
        for (int i = column; i < UNKNOWNS; ++i) {
            best = fabsl(rows[i][column]) > fabsl(rows[best][column]) ? i : best;
        }
        const long double pivot = rows[best][column];
        for (int j = 0; j <= UNKNOWNS; ++j) {
            const long double element = rows[best][j] / pivot;
            rows[best][j] = rows[column][j];
            rows[column][j] = element;
        }
        for (int i = 0; i < UNKNOWNS; ++i) {
            const long double factor = i == column ? 0.0L : rows[i][column];
            for (int j = 0; j <= UNKNOWNS; ++j) {
                rows[i][j] -= factor * rows[column][j];
            }
        }
    }
}

static void solve_lagrange(const runner *runner, double solution[UNKNOWNS]) {
    const tdmf_parameters *p = &runner->model.parameters;
    const tdmf_inputs *inputs = &runner->inputs;
    motion motion = {
        .parameters = p, .force_x = inputs->body.external_fx, .force_y = inputs->body.external_fy};
    motion.rest_length = p->leg.free_length + inputs->leg.extension +
                         (runner->motion.mode.thrusts ? p->leg.thrust + inputs->control.thrust : 0.0);
    equation rows[UNKNOWNS];
    memset(rows, 0, sizeof rows);
    for (int i = 0; i < FREEDOMS; ++i) {
        motion.q[i] = (long double)runner->motion.state[TDMF_FOOT_X + i];
        motion.rate[i] = (long double)runner->motion.state[TDMF_FOOT_VX + i];
    }
    for (int i = 0; i < FREEDOMS; ++i) {
        equation_of_motion(motion, i, rows[i]);
    }
    equations_of_mode(runner, rows);
    solve(rows);
    for (int i = 0; i < UNKNOWNS; ++i) {
        solution[i] = (double)rows[i][UNKNOWNS];
    }
}

/* ---- the core against it ---------------------------------------------------------------------------- */

/* The sum of what is added up in an acceleration may be much larger than the result. */
static double largest_of(const double *values, int count, double smallest) {
    double largest = smallest;
    for (int i = 0; i < count; ++i) {
        largest = fmax(largest, fabs(values[i]));
    }
    return largest;
}

/* Work and losses are integrals of power; the clock of place runs in place only. */
static void compare_integrals(const runner *runner, const double expected[UNKNOWNS],
                              const double rates[TDMF_STATE_COUNT]) {
    const tdmf_scales *scales = &runner->model.scales;
    const double *state = runner->motion.state, damping = runner->model.parameters.leg.damping;
    const double power = expected[TAU] * state[TDMF_LEG_ANGLE_RATE];
    const double rounding = 1e-11 * fmax(fabs(expected[TAU]), scales->energy) *
                            (fabs(state[TDMF_LEG_ANGLE_RATE]) + 1.0 / scales->time);
    assert_close(rates[TDMF_HIP_WORK], power, rounding);
    assert_close(rates[TDMF_HIP_POSITIVE_WORK], fmax(power, 0.0), rounding);
    /* On the ground the leg's rates come from the body's velocity, so they round with its size. */
    const double length_rate = fabs(state[TDMF_LEG_LENGTH_RATE]);
    const double turning = fabs(state[TDMF_LEG_LENGTH] * state[TDMF_LEG_ANGLE_RATE]);
    assert_close(rates[TDMF_ENERGY_DAMPER_LOSS], damping * length_rate * length_rate,
                 1e-14 * damping * length_rate * (length_rate + turning));
    const double friction = -expected[FX] * state[TDMF_FOOT_VX] - expected[FY] * state[TDMF_FOOT_VY];
    assert_close(rates[TDMF_ENERGY_FRICTION_LOSS], friction,
                 1e-11 * largest_of(&expected[FX], 2, scales->force) *
                     (fabs(state[TDMF_FOOT_VX]) + fabs(state[TDMF_FOOT_VY])));
    assert_true(rates[TDMF_HIP_PLACE_TIME] == (runner->motion.mode.phase == TDMF_PHASE_PLACE));
}

static void compare_with_lagrange(const runner *runner) {
    const tdmf_scales *scales = &runner->model.scales;
    double expected[UNKNOWNS], derivatives[TDMF_STATE_COUNT];
    solve_lagrange(runner, expected);
    tdmf_derivatives(SYSTEM_OF(runner), &runner->motion.mode, runner->motion.state, derivatives);
    const double light = runner->model.parameters.body.mass * runner->model.inverse_foot_mass;
    const double largest = largest_of(expected, R + 1, light * scales->speed / scales->time);
    assert_all_close(derivatives + TDMF_FOOT_VX, expected, R + 1, 1e-11 * largest, 0.0);
    assert_close(derivatives[TDMF_LEG_ANGLE_RATE] * scales->length, expected[THETA] * scales->length,
                 1e-11 * fmax(largest, fabs(expected[THETA]) * scales->length));

    const double largest_force = largest_of(&expected[FX], 2, scales->force);
    const tdmf_ground_line *ground = &runner->motion.mode.ground;
    const tdmf_outputs now = OUTPUTS_OF(runner);
    assert_close(now.contact.fx, expected[FX], 1e-11 * largest_force);
    assert_close(now.contact.fy, expected[FY], 1e-11 * largest_force);
    assert_close(now.contact.tangential, ground->cosine * expected[FX] + ground->sine * expected[FY],
                 1e-11 * largest_force);
    assert_close(now.contact.normal, ground->cosine * expected[FY] - ground->sine * expected[FX],
                 1e-11 * largest_force);
    assert_close(now.hip.torque, expected[TAU], 1e-11 * fmax(fabs(expected[TAU]), scales->energy));
    compare_integrals(runner, expected, derivatives);
}

/* A leg that thrusts and is extended, a body that is pushed. */
static void actuate(random_source *source, runner *runner) {
    const tdmf_scales *scales = &runner->model.scales;
    runner->motion.mode.thrusts = tdmf_is_loaded(&runner->motion.mode) && random_chance(source, 0.5);
    runner->model.parameters.leg.thrust = random_uniform(source, 0.0, 0.2) * scales->length;
    runner->inputs.control.thrust = random_uniform(source, 0.0, 0.2) * scales->length;
    runner->inputs.leg.extension = random_uniform(source, -0.3, 0.3) * scales->length;
    runner->inputs.body.external_fx = random_uniform(source, -1.0, 1.0) * scales->force;
    runner->inputs.body.external_fy = random_uniform(source, -1.0, 1.0) * scales->force;
}

TEST(every_mode_obeys_lagrange) {
    for (int contact = TDMF_CONTACT_FLIGHT; contact <= TDMF_CONTACT_GRAZE; ++contact) {
        random_source source = {1000 + (uint64_t)contact};
        for (int i = 0; i < sample_of(500); ++i) {
            runner runner = scene_random(&source, (tdmf_contact_mode)contact);
            compare_with_lagrange(&runner);
            actuate(&source, &runner);
            compare_with_lagrange(&runner);
        }
    }
}

/* Constraints hold to the last bit, or the foot would drift through the ground in a long stance. */
TEST(constrained_accelerations_are_exactly_zero) {
    random_source source = {1};
    for (int i = 0; i < 40; ++i) {
        const int contact = TDMF_CONTACT_STICK + i % 4;
        const runner runner = scene_random(&source, (tdmf_contact_mode)contact);
        double derivatives[TDMF_STATE_COUNT];
        tdmf_derivatives(SYSTEM_OF(&runner), &runner.motion.mode, runner.motion.state, derivatives);
        const tdmf_ground_line *ground = &runner.motion.mode.ground;
        const double along = derivatives[TDMF_FOOT_VX] / ground->cosine;
        assert_true(ground->slope != 0.0 ||
                    (derivatives[TDMF_FOOT_VY] == 0.0 && derivatives[TDMF_FOOT_Y] == 0.0));
        assert_close(derivatives[TDMF_FOOT_VY], along * ground->sine, 4.0 * DBL_EPSILON * fabs(along));
        assert_true(contact != TDMF_CONTACT_STICK || derivatives[TDMF_FOOT_VX] == 0.0);
    }
}

/* ---- robustness ------------------------------------------------------------------------------------- */

static void assert_finite_at(const runner *runner) {
    double derivatives[TDMF_STATE_COUNT], guards[TDMF_GUARD_COUNT];
    tdmf_derivatives(SYSTEM_OF(runner), &runner->motion.mode, runner->motion.state, derivatives);
    assert_all_finite(derivatives, TDMF_STATE_COUNT);
    tdmf_guards(SYSTEM_OF(runner), &runner->motion.mode, runner->motion.state, guards);
    assert_all_finite(guards, TDMF_GUARD_COUNT);
}

/* Solvers probe beyond events, where a leg has any length, angle and speed. */
TEST(trial_states_give_finite_results) {
    static const double lengths[] = {0.0, -0.0, -1e-300, 1e-300, 1e-12, -1.0, -1e6, 1e6};
    static const double angles[] = {0.0, 1e-300, -1e-16, 1.5707963267948966, 1e6, -1e6};
    static const double rates[] = {0.0, -1e6, 1e6};
    random_source source = {2};
    for (int contact = TDMF_CONTACT_FLIGHT; contact <= TDMF_CONTACT_GRAZE; ++contact) {
        runner runner = scene_random(&source, (tdmf_contact_mode)contact);
        for (size_t i = 0; i < 8 * 6 * 3; ++i) {
            runner.motion.state[TDMF_LEG_LENGTH] = lengths[i % 8];
            runner.motion.state[TDMF_LEG_ANGLE] = angles[i / 8 % 6];
            runner.motion.state[TDMF_LEG_LENGTH_RATE] = rates[i / 48];
            runner.motion.state[TDMF_LEG_ANGLE_RATE] = -rates[i / 48];
            assert_finite_at(&runner);
        }
    }
}

TEST(fallen_run_is_frozen) {
    random_source source = {3};
    for (int contact = TDMF_CONTACT_FLIGHT; contact <= TDMF_CONTACT_GRAZE; ++contact) {
        runner runner = scene_random(&source, (tdmf_contact_mode)contact);
        double derivatives[TDMF_STATE_COUNT];
        runner.motion.mode.fallen = true;
        tdmf_derivatives(SYSTEM_OF(&runner), &runner.motion.mode, runner.motion.state, derivatives);
        assert_all_are(derivatives, TDMF_STATE_COUNT, 0.0);
    }
}

/* The torque is smooth while the clamp stands as it was last located: else a solver could not step up to the
 * kink. */
TEST(clamp_stays_as_located) {
    for (int closed = 0; closed < 2; ++closed) {
        runner runner = scene_in_flight(TDMF_PHASE_RETRACT, 0.1);
        runner.motion.mode.clamp_closed = closed == 1;
        runner.motion.state[TDMF_LEG_ANGLE_RATE] = closed ? -1e-11 : 1e-11;
        const double torque = OUTPUTS_OF(&runner).hip.torque;
        assert_close(torque, closed ? 0.0 : -1e-12, closed ? 0.0 : 1e-16);
    }
}
