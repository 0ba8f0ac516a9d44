/* Runs whose motion is known in closed form, under inputs that ramp, with feet heavier than bodies, and their
 * variations. An upright leg without torque moves along the vertical only, as two masses on a spring:
 *
 *     M y_c'' = F - M g,    mu r'' = -k (r - l0) + (m_f/M) F,    mu = m m_f/M,
 *
 * where F is the upward push on the body; with F = F_0 + F_1 t a leg that begins on r = l0 + m_f F/(k M)
 * stays there, and all heights are cubics in time. */
#include "by_page.h"
#include "compare.h"
#include "scene.h"
#include "simulation.h"
#include "tdmf_slip/solver.h"
#include "tdmf_slip/tdmf_slip.h"

#include <math.h>
#include <string.h>

/* ---- a run --------------------------------------------------------------------------------------------- */

/* There is neither torque nor damping. */
static simulation run_without_losses(double foot_mass) {
    simulation run = {.inputs = tdmf_default_inputs(), .solver = tdmf_solver_default()};
    tdmf_parameters parameters = tdmf_default_parameters();
    parameters.foot.mass = foot_mass;
    parameters.leg.damping = 0.0;
    parameters.hip.stance_torque = parameters.hip.kp = parameters.hip.kd = 0.0;
    run.model = accepted_model(&parameters);
    run.motion.state[TDMF_LEG_LENGTH] = parameters.leg.free_length;
    return run;
}

static double time_of(const simulation *run, tdmf_guard guard) {
    const tdmf_event *event = simulation_event(run, guard);
    return event != NULL ? event->time : INFINITY;
}

/* ---- a push that ramps --------------------------------------------------------------------------------- */

/* Heights as cubics in time. */
typedef struct {
    double c[4];
} cubic;

static double value_of(const cubic *p, double t) {
    return p->c[0] + t * (p->c[1] + t * (p->c[2] + t * p->c[3]));
}

/* Zero by bisection of a function that changes its sign between two times. */
static double zero_between(const cubic *p, double from, double to) {
    const bool falls = value_of(p, from) > 0.0;
    assert_true(falls == (value_of(p, to) < 0.0));
    for (int i = 0; i < 100; ++i) {
        const double middle = 0.5 * (from + to);
        if (falls == (value_of(p, middle) > 0.0)) {
            from = middle;
        } else {
            to = middle;
        }
    }
    return from;
}

/* The leg is as long as the push, F_0 + F_1 t, makes it; the centre of mass begins at `height`, at `rate`. */
static cubic fly_under_ramp(simulation *run, double height, double rate, double push, double push_rate) {
    const tdmf_model *model = &run->model;
    const tdmf_parameters *p = &model->parameters;
    const double stretch = p->foot.mass / (p->leg.stiffness * model->total_mass);
    const double share = p->body.mass / model->total_mass;
    double *state = run->motion.state;
    run->inputs.body.external_fy = push;
    run->rates.body.external_fy = push_rate;
    state[TDMF_LEG_LENGTH] = p->leg.free_length + stretch * push;
    state[TDMF_LEG_LENGTH_RATE] = stretch * push_rate;
    state[TDMF_FOOT_Y] = height - share * state[TDMF_LEG_LENGTH];
    state[TDMF_FOOT_VY] = rate - share * state[TDMF_LEG_LENGTH_RATE];
    const cubic foot = {{state[TDMF_FOOT_Y], state[TDMF_FOOT_VY],
                         0.5 * (push / model->total_mass - p->gravity), push_rate / model->total_mass / 6.0}};
    return foot;
}

static cubic rate_of(const cubic *p) {
    const cubic rate = {{p->c[1], 2.0 * p->c[2], 3.0 * p->c[3], 0.0}};
    return rate;
}

/* Along a leaning leg a push turns nothing, and drives the centre of mass that way: over a slope. */
TEST(a_push_that_ramps_along_a_leaning_leg_moves_touchdown) {
    static const double angles[] = {-0.6, 0.3, 1.2};
    static const double slopes[] = {-0.3, 0.0, 0.2};
    for (int i = 0; i < 18; ++i) {
        simulation run = run_without_losses(0.5);
        const tdmf_model *model = &run.model;
        const tdmf_parameters *p = &model->parameters;
        const double angle = angles[i % 3], slope = slopes[i / 3 % 3];
        const double jerk = i < 9 ? 2e-4 : -2e-4, push_rate = jerk * model->total_mass;
        const double stretch_rate = p->foot.mass / (p->leg.stiffness * model->total_mass) * push_rate;
        const double share = model->body_share, height = 4.0;
        double *of = run.motion.state;
        run.inputs.ground.slope = slope;
        run.rates.body.external_fx = -sin(angle) * push_rate;
        run.rates.body.external_fy = cos(angle) * push_rate;
        of[TDMF_LEG_ANGLE] = angle;
        of[TDMF_LEG_LENGTH_RATE] = stretch_rate;
        of[TDMF_FOOT_X] = share * p->leg.free_length * sin(angle);
        of[TDMF_FOOT_Y] = height - share * p->leg.free_length * cos(angle);
        of[TDMF_FOOT_VX] = share * stretch_rate * sin(angle);
        of[TDMF_FOOT_VY] = -share * stretch_rate * cos(angle);
        simulation_start(&run);
        const double along_normal = cos(angle - slope);
        const cubic foot = {{height * cos(slope) - share * p->leg.free_length * along_normal,
                             -share * stretch_rate * along_normal, -0.5 * p->gravity * cos(slope),
                             jerk / 6.0 * along_normal}};
        const double touchdown = zero_between(&foot, 0.0, 45.0);
        assert_int_equal(simulation_advance(&run, touchdown + 0.01), TDMF_ARRIVED);
        assert_close(time_of(&run, TDMF_GUARD_TOUCHDOWN), touchdown, 1e-9);
        assert_close(simulation_event(&run, TDMF_GUARD_TOUCHDOWN)->state[TDMF_LEG_ANGLE], angle, 1e-9);
    }
}

/* A push that grows under an upright leg takes its load: none is left when it carries all of the weight. */
TEST(a_ramped_push_lifts_the_foot_when_it_carries_the_weight) {
    static const double slopes[] = {-0.2, 0.0, 0.2};
    for (int i = 0; i < 3; ++i) {
        simulation run = run_without_losses(0.3);
        const tdmf_parameters *p = &run.model.parameters;
        const double push_rate = 2e-3;
        run.inputs.ground.slope = slopes[i];
        run.rates.body.external_fy = push_rate;
        run.motion.state[TDMF_LEG_LENGTH] = p->leg.free_length - p->body.mass * p->gravity / p->leg.stiffness;
        run.motion.state[TDMF_LEG_LENGTH_RATE] = push_rate / p->leg.stiffness;
        simulation_start(&run);
        assert_int_equal(run.motion.mode.contact, TDMF_CONTACT_STICK);
        const double lift_off = run.model.total_mass * p->gravity / push_rate;
        assert_int_equal(simulation_advance(&run, lift_off + 0.01), TDMF_ARRIVED);
        assert_close(time_of(&run, TDMF_GUARD_LIFT_OFF), lift_off, 1e-8);
        assert_true(time_of(&run, TDMF_GUARD_SLIP_ONSET_POSITIVE) > lift_off - 1e-6);
        assert_true(time_of(&run, TDMF_GUARD_SLIP_ONSET_NEGATIVE) > lift_off - 1e-6);
    }
}

/* The flight rises under a push that grows or falls off. */
TEST(a_ramped_push_moves_the_apex) {
    static const double push_rates[] = {-3e-3, -3e-4, 3e-4};
    for (int i = 0; i < 3; ++i) {
        simulation run = run_without_losses(0.5);
        const cubic foot = fly_under_ramp(&run, 3.0, 0.1, 0.0, push_rates[i] * run.model.total_mass);
        cubic rise = rate_of(&foot);
        rise.c[0] = 0.1; /* centre of mass: the foot moves relative to it */
        const double apex = zero_between(&rise, 0.0, 20.0);
        simulation_start(&run);
        assert_true(run.motion.mode.rises);
        assert_int_equal(simulation_advance(&run, apex + 0.01), TDMF_ARRIVED);
        assert_close(time_of(&run, TDMF_GUARD_APEX), apex, 1e-10);
    }
}

/* The ground is raised above the foot: it is in force once the foot has come up through it. */
TEST(a_ramped_push_moves_the_ground_that_waits) {
    static const double push_rates[] = {-5e-4, 5e-4};
    for (int i = 0; i < 2; ++i) {
        simulation run = run_without_losses(0.5);
        cubic foot = fly_under_ramp(&run, 3.0, 0.15, 0.0, push_rates[i] * run.model.total_mass);
        simulation_start(&run);
        run.inputs.ground.height = foot.c[0] + 0.5;
        foot.c[0] = -0.5;
        const double passed = zero_between(&foot, 0.0, 7.0);
        assert_int_equal(simulation_advance(&run, passed + 0.01), TDMF_ARRIVED);
        assert_close(time_of(&run, TDMF_GUARD_NEW_GROUND), passed, 1e-9);
    }
}

/* ---- the light end of a leg ---------------------------------------------------------------------------- */

/* Upside down under a heavy foot: at rest in itself, and falling. */
TEST(a_light_body_below_its_foot_falls_when_it_is_down) {
    static const double foot_masses[] = {1.0, 10.0, 1000.0};
    for (int i = 0; i < 3; ++i) {
        simulation run = run_without_losses(foot_masses[i]);
        const double height = 0.05;
        const double down = sqrt(2.0 * height / run.model.parameters.gravity);
        run.motion.state[TDMF_LEG_ANGLE] = acos(-1.0);
        run.motion.state[TDMF_FOOT_Y] = height + run.model.parameters.leg.free_length;
        simulation_start(&run);
        assert_int_equal(simulation_advance(&run, down + 0.5), TDMF_FELL);
        assert_close(run.motion.time, down, 1e-9);
    }
}

/* ---- the cone under a ramp of friction ----------------------------------------------------------------- */

/* Upright on a slope a leg presses the ground along the vertical, whatever its load: the foot slips when the
 * friction of rest has fallen to the tangent of the slope. */
TEST(a_foot_slips_when_friction_has_fallen_to_the_slope) {
    static const double ratios[] = {1.0, 1.5};
    static const double dips[] = {0.0, 0.1}; /* a body at rest, and one that bobs */
    int slipped = 0;
    for (int i = 0; i < 8; ++i) {
        simulation run = run_without_losses(0.05);
        const tdmf_parameters *p = &run.model.parameters;
        const double slope = i & 1 ? 0.2 : -0.2, dip = dips[i >> 2];
        run.model.parameters.ground.static_friction_ratio = ratios[i >> 1 & 1];
        run.model.parameters.gravity = 0.2;
        run.inputs.ground.slope = slope;
        run.inputs.ground.friction = 0.6;
        run.rates.ground.friction = -0.04;
        const double slip = (0.6 - tan(fabs(slope)) / p->ground.static_friction_ratio) / 0.04;
        run.motion.state[TDMF_LEG_LENGTH] =
            p->leg.free_length - p->body.mass * p->gravity / p->leg.stiffness - dip;
        simulation_start(&run);
        assert_int_equal(run.motion.mode.contact, TDMF_CONTACT_STICK);
        assert_int_equal(simulation_advance(&run, slip + 1e-3), TDMF_ARRIVED);
        assert_close(
            time_of(&run, slope > 0.0 ? TDMF_GUARD_SLIP_ONSET_NEGATIVE : TDMF_GUARD_SLIP_ONSET_POSITIVE),
            slip, 1e-9);
        ++slipped;
    }
    assert_int_equal(slipped, 8);
}

/* ---- variations of a motion that is simpler than they are ---------------------------------------------- */

static void vary_until(const simulation *run, double until, int varied, double d_states[TDMF_STATE_COUNT]) {
    static const tdmf_seed none = {0};
    double d_start[TDMF_STATE_COUNT] = {0.0};
    d_start[varied] = 1.0;
    vary_run(SYSTEM_OF(run), run->motion.state, &none, d_start, until, d_states);
}

/* A leg that rests in itself flies on a parabola, which one step would do for; a change of its length swings
 * for tens of periods. */
TEST(a_change_of_a_resting_leg_swings_in_flight) {
    static const double foot_masses[] = {0.01, 0.3, 3.0};
    for (int i = 0; i < 3; ++i) {
        simulation run = run_without_losses(foot_masses[i]);
        const tdmf_model *model = &run.model;
        const double until = 60.0;
        const double pulsation = sqrt(model->parameters.leg.stiffness * model->inverse_reduced_mass);
        run.motion.state[TDMF_FOOT_Y] = 10.0;
        run.motion.state[TDMF_FOOT_VY] = 1.0;
        simulation_start(&run);
        double varied[TDMF_STATE_COUNT];
        vary_until(&run, until, TDMF_LEG_LENGTH, varied);
        assert_close(varied[TDMF_LEG_LENGTH], cos(pulsation * until), 1e-8);
        assert_close(varied[TDMF_LEG_LENGTH_RATE], -pulsation * sin(pulsation * until), 1e-8 * pulsation);
        /* The foot was where it is, the body moved, and the centre of mass with it. */
        const double share = model->body_share;
        assert_close(varied[TDMF_FOOT_Y], share * (1.0 - cos(pulsation * until)), 1e-8);
    }
}

/* A leg that is held where the hip wants it; a change of its angle swings by the hip's spring. */
TEST(a_change_of_a_placed_leg_swings_in_flight) {
    static const double foot_masses[] = {0.01, 0.3};
    for (int i = 0; i < 2; ++i) {
        simulation run = run_without_losses(foot_masses[i]);
        run.model.parameters.hip.kp = 1.0;
        run.model.parameters.hip.touchdown_angle = 0.5;
        const double until = 20.0;
        const double pulsation = sqrt(run.model.parameters.hip.kp * run.model.inverse_reduced_mass) /
                                 run.model.parameters.leg.free_length;
        run.motion.state[TDMF_FOOT_Y] = 10.0;
        run.motion.state[TDMF_LEG_ANGLE] = 0.5;
        simulation_start(&run);
        assert_int_equal(run.motion.mode.phase, TDMF_PHASE_PLACE);
        double varied[TDMF_STATE_COUNT];
        vary_until(&run, until, TDMF_LEG_ANGLE, varied);
        assert_close(varied[TDMF_LEG_ANGLE], cos(pulsation * until), 1e-8);
        assert_close(varied[TDMF_LEG_ANGLE_RATE], -pulsation * sin(pulsation * until), 1e-8 * pulsation);
        assert_close(varied[TDMF_LEG_LENGTH], 0.0, 1e-9);
    }
}

/* The same of a leg that stands, balanced: it would stand in one step. */
TEST(a_change_of_a_standing_leg_swings) {
    simulation run = run_without_losses(0.05);
    const tdmf_parameters *p = &run.model.parameters;
    const double until = 60.0, pulsation = sqrt(p->leg.stiffness / p->body.mass);
    run.motion.state[TDMF_LEG_LENGTH] = p->leg.free_length - p->body.mass * p->gravity / p->leg.stiffness;
    simulation_start(&run);
    assert_int_equal(run.motion.mode.contact, TDMF_CONTACT_STICK);
    double varied[TDMF_STATE_COUNT];
    vary_until(&run, until, TDMF_LEG_LENGTH, varied);
    assert_close(varied[TDMF_LEG_LENGTH], cos(pulsation * until), 1e-8);
    assert_close(varied[TDMF_LEG_LENGTH_RATE], -pulsation * sin(pulsation * until), 1e-8);
}
