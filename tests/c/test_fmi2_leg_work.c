/* Work of the leg in Model Exchange, where the importer changes leg.extension without telling its rate: the
 * ledger closes in every step that is completed. */
#include "compare.h"
#include "fmi2_importer.h"
#include "integrate.h"

#include "tdmf_slip/tdmf_slip.h"

#include <math.h>
#include <stdio.h>

/* The leg swings once in about two units of time in flight; the default gait lands much later. */
static const double duration = 6.0;

typedef double (*extension_at)(double time);

static double ramp(double time) {
    return 0.05 * time;
}

static double wave(double time) {
    return 0.05 * sin(1.7 * time);
}

static double steps(double time) {
    return 0.01 * floor(time + 0.5);
}

static double none(double time) {
    (void)time;
    return 0.0;
}

/* A unit whose leg is extended by a function of time. */
typedef struct {
    fmi2Component component;
    extension_at extension;
} extended_unit;

static void rates_of_unit(const void *context, double time, const double x[], double rates[]) {
    const extended_unit *unit = context;
    assert_int_equal(fmi2SetTime(unit->component, time), fmi2OK);
    assert_int_equal(set_real(unit->component, "leg.extension", unit->extension(time)), fmi2OK);
    assert_int_equal(fmi2SetContinuousStates(unit->component, x, CONTINUOUS_STATES), fmi2OK);
    assert_int_equal(fmi2GetDerivatives(unit->component, rates, CONTINUOUS_STATES), fmi2OK);
}

/* A step, at whose end the unit stands. */
static void integrate_step(fmi2Component component, double time, double step, extension_at extension,
                           double x[CONTINUOUS_STATES]) {
    const extended_unit unit = {component, extension};
    double rates[CONTINUOUS_STATES];
    runge_kutta(CONTINUOUS_STATES, rates_of_unit, &unit, time, step, x, x);
    rates_of_unit(&unit, time + step, x, rates);
}

/* Event mode, where the extension may jump to `extension`. */
static bool jump_to(fmi2Component component, double extension, double x[CONTINUOUS_STATES]) {
    char value[64];
    snprintf(value, sizeof value, "leg.extension=%.17g", extension);
    const update_answer answer = take_event(&fmi2, component, EXCHANGE, value);
    assert_int_equal(fmi2GetContinuousStates(component, x, CONTINUOUS_STATES), fmi2OK);
    return answer.states_changed;
}

/* Error of the energy balance. */
static double gap(fmi2Component component, double start_energy) {
    return get_real(component, "energy.total") - start_energy - get_real(component, "hip.work") -
           get_real(component, "leg.work") + get_real(component, "energy.damper_loss");
}

typedef struct {
    double gap, work;
    int events;
} flight;

static flight fly(int step_count, extension_at extension) {
    fmi2Component component = begun(&fmi2, EXCHANGE, "leg.length=0.9");
    flight flown = {0.0, 0.0, 0};
    double x[CONTINUOUS_STATES];
    const double energy = get_real(component, "energy.total"), step = duration / step_count;
    assert_int_equal(fmi2GetContinuousStates(component, x, CONTINUOUS_STATES), fmi2OK);
    for (int i = 0; i < step_count; ++i) {
        fmi2Boolean asks = fmi2False, terminate = fmi2False;
        integrate_step(component, i * step, step, extension, x);
        assert_int_equal(fmi2CompletedIntegratorStep(component, fmi2True, &asks, &terminate), fmi2OK);
        assert_false(terminate);
        if (asks) {
            assert_true(jump_to(component, extension((i + 1) * step), x));
            ++flown.events;
        }
        flown.gap = fmax(flown.gap, fabs(gap(component, energy)));
    }
    assert_int_equal(get_whole(component, "contact.mode"), TDMF_CONTACT_FLIGHT);
    flown.work = get_real(component, "leg.work");
    return flown;
}

TEST(the_ledger_closes_along_a_ramp_to_fourth_order) {
    const flight coarse = fly(200, ramp), fine = fly(400, ramp);
    assert_int_equal(coarse.events, 200);
    assert_true(fabs(fine.work) > 1e-4);
    assert_close(fine.work, coarse.work, 1e-6);
    assert_true(fine.gap < 1e-8 && fine.gap < coarse.gap / 12.0);
}

TEST(along_a_curve_it_closes_to_second_order) {
    const flight coarse = fly(400, wave), fine = fly(800, wave);
    assert_true(fine.gap < 1e-5 && fine.gap < coarse.gap / 3.5);
}

TEST(an_extension_that_stays_asks_for_no_event) {
    const flight flown = fly(400, none);
    assert_int_equal(flown.events, 0);
    assert_true(flown.work == 0.0 && flown.gap < 1e-8);
}

/* A jump's work is the spring's energy gained. */
TEST(a_jump_in_event_mode_is_accounted_for_exactly) {
    fmi2Component component = begun(&fmi2, EXCHANGE, "leg.length=0.9");
    double x[CONTINUOUS_STATES];
    for (int i = 1; i <= 3; ++i) {
        const double elastic = get_real(component, "energy.elastic"), work = get_real(component, "leg.work");
        assert_true(jump_to(component, 0.03 * i * i, x));
        assert_close(get_real(component, "leg.work") - work, get_real(component, "energy.elastic") - elastic,
                     1e-16);
        assert_false(jump_to(component, 0.03 * i * i, x));
    }
}

/* An importer that sets a jump without an event spreads it over one step. */
TEST(jumps_without_an_event_are_seen_at_the_next_step) {
    const flight coarse = fly(240, steps), fine = fly(2400, steps);
    assert_int_equal(fine.events, 6);
    assert_true(fine.gap < 0.5 * coarse.gap && fine.gap < 2e-5);
}

/* A leg that lengthens on the ground thrusts from the start on, which is work at once. */
TEST(a_thrust_from_the_start_is_read_before_the_run_begins) {
    const double length = 0.8, thrust = 0.02, free_length = 1.0, stiffness = 1.0;
    const double gained =
        0.5 * stiffness * (pow(free_length + thrust - length, 2.0) - pow(free_length - length, 2.0));
    fmi2Component component = new_instance();
    double x[CONTINUOUS_STATES];
    assert_int_equal(set_real(component, "leg.thrust", thrust), fmi2OK);
    assert_int_equal(set_real(component, "leg.length", length), fmi2OK);
    set_values(&fmi2, component, "leg.length_rate=0.1 leg.angle=-0.2 foot.y=0.0 foot.vx=0.0 foot.vy=0.0");
    assert_close(get_real(component, "leg.work"), gained, 1e-15);
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
    const double before = get_real(component, "leg.work");
    assert_close(before, gained, 1e-15);
    assert_int_equal(fmi2GetContinuousStates(component, x, CONTINUOUS_STATES), fmi2OK);
    assert_true(x[STATE_LEG_WORK] == before && x[STATE_LEG_LENGTH] == length && x[STATE_FOOT_VX] == 0.0);
    assert_int_equal(fmi2ExitInitializationMode(component), fmi2OK);
    assert_true(get_real(component, "leg.work") == before);
}

/* Work that is due in event mode is saved before it is reported. */
TEST(work_that_is_due_is_saved) {
    fmi2Component one = new_instance(), other = new_instance();
    double x[CONTINUOUS_STATES];
    fmi2EventInfo info;
    start_running(one);
    assert_int_equal(fmi2GetContinuousStates(one, x, CONTINUOUS_STATES), fmi2OK);
    integrate_step(one, 0.0, 0.1, ramp, x);
    assert_int_equal(fmi2EnterEventMode(one), fmi2OK);
    assert_int_equal(copy_state(&fmi2, one, other), FMI_OK);
    assert_int_equal(fmi2NewDiscreteStates(one, &info), fmi2OK);
    assert_int_equal(fmi2NewDiscreteStates(other, &info), fmi2OK);
    assert_true(get_real(one, "leg.work") != 0.0);
    assert_true(get_real(other, "leg.work") == get_real(one, "leg.work"));
}
