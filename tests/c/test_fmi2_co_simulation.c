/* The unit's Co-Simulation: steps that arrive, inputs that move, what is refused. */
#include "compare.h"
#include "extended_strides.h"
#include "fmi2_importer.h"

#include "fmu.h"
#include "tdmf_slip/cvode.h"

#include <float.h>
#include <math.h>
#include <string.h>

#ifdef __GLIBC__
#include <fenv.h>
int feenableexcept(int exceptions); /* GNU extensions, hidden by -std=c99 */
int fedisableexcept(int exceptions);
#endif

static const double period = 24.76444922801218; /* of the default gait */

static int make(void **state) {
    *state = new_slave();
    return 0;
}

static int release(void **state) {
    fmi2FreeInstance(*state);
    return 0;
}

static void run(fmi2Component component, double from, double to, double step) {
    const long steps = lround((to - from) / step);
    for (long i = 0; i < steps; ++i) {
        const double time = from + (double)i * step;
        assert_int_equal(fmi2DoStep(component, time, step, fmi2True), fmi2OK);
    }
}

/* ---- stepping ----------------------------------------------------------------------------------------- */

static void steps_arrive_and_the_grid_does_not_matter(void **state) {
    static const double steps[] = {0.01, 0.1, 1.25, 25.0, 250.0};
    (void)state;
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; ++i) {
        fmi2Component component = new_slave();
        initialize(component);
        run(component, 0.0, 250.0, steps[i]);
        assert_true(fabs(get_real(component, "time") - 250.0) < 1e-9);
        assert_int_equal(get_integer(component, "stride.count"), 10);
        assert_close(get_real(component, "stride.period"), period, 1e-8);
        assert_close(get_real(component, "stride.cost_of_transport"), 0.3717046558598356, 1e-9);
        fmi2FreeInstance(component);
    }
}

static void start_at_apex(fmi2Component component, double friction, const tdmf_parameters *parameters,
                          const double apex[TDMF_SECTION_COUNT]) {
    static const char *const names[TDMF_MECHANICAL_COUNT] = {"foot.x",          "foot.y",        "leg.length",
                                                             "leg.angle",       "foot.vx",       "foot.vy",
                                                             "leg.length_rate", "leg.angle_rate"};
    const tdmf_inputs inputs = tdmf_default_inputs();
    tdmf_model model;
    double state[TDMF_STATE_COUNT];
    assert_null(tdmf_model_create(&model, parameters).variable);
    tdmf_section_state((tdmf_system){&model, &inputs}, apex, state);
    for (int i = 0; i < TDMF_MECHANICAL_COUNT; ++i) {
        assert_int_equal(set_real(component, names[i], state[i]), fmi2OK);
    }
    assert_int_equal(set_real(component, "ground.friction", friction), fmi2OK);
    assert_int_equal(set_real(component, "solver.relative_tolerance", 1e-13), fmi2OK);
    initialize(component);
}

/* Also where steps end at events. */
static void a_stride_takes_the_proved_time(void **state) {
    const tdmf_parameters parameters = tdmf_default_parameters();
    (void)state;
    for (int i = 0; i < PROVED_GAITS; ++i) {
        const proved_gait *gait = &proved_gaits[i];
        for (int stops = 0; stops < 2; ++stops) {
            fmi2Component component = new_slave();
            double time = 0.0;
            start_at_apex(component, gait->friction, &parameters, gait->apex);
            for (int k = 0; k < gait->event_count && stops; ++k) {
                assert_int_equal(fmi2DoStep(component, time, gait->events[k].time - time, fmi2True), fmi2OK);
                time = gait->events[k].time;
            }
            assert_int_equal(fmi2DoStep(component, time, gait->period + 1.0 - time, fmi2True), fmi2OK);
            assert_int_equal(get_integer(component, "stride.count"), 1);
            assert_close(get_real(component, "stride.period"), gait->period, 1e-13 * gait->period);
            assert_close(get_real(component, "apex.time"), gait->period, 1e-13 * gait->period);
            fmi2FreeInstance(component);
        }
    }
}

static void set_parameters(fmi2Component component, const tdmf_parameters *parameters) {
    assert_int_equal(set_real(component, "gravity", parameters->gravity), fmi2OK);
    assert_int_equal(set_real(component, "leg.stiffness", parameters->leg.stiffness), fmi2OK);
    assert_int_equal(set_real(component, "leg.damping", parameters->leg.damping), fmi2OK);
    assert_int_equal(set_real(component, "hip.stance_torque", parameters->hip.stance_torque), fmi2OK);
    assert_int_equal(set_real(component, "hip.kp", parameters->hip.kp), fmi2OK);
    assert_int_equal(set_real(component, "hip.kd", parameters->hip.kd), fmi2OK);
}

static void a_stride_under_any_gravity_is_that_of_extended_precision(void **state) {
    (void)state;
    for (int i = 0; i < EXTENDED_STRIDES; ++i) {
        const extended_stride *stride = &extended_strides[i];
        const tdmf_parameters parameters = parameters_of_stride(stride);
        const double period = stride->events[stride->event_count - 1].time;
        fmi2Component component = new_slave();
        set_parameters(component, &parameters);
        start_at_apex(component, stride->friction, &parameters, stride->start);
        assert_int_equal(fmi2DoStep(component, 0.0, 1.001 * period, fmi2True), fmi2OK);
        assert_int_equal(get_integer(component, "stride.count"), 1);
        assert_close(get_real(component, "apex.time"), period, 1e-12 * period);
        assert_close(get_real(component, "apex.com_height"), stride->apex[0], 1e-12 * stride->apex[0]);
        if (stride->apex_count == TDMF_SECTION_COUNT) {
            assert_close(get_real(component, "apex.leg_angle"), stride->apex[3], 1e-12);
        }
        fmi2FreeInstance(component);
    }
}

static void rounded_communication_points_are_tolerated_and_wrong_ones_refused(void **state) {
    initialize(*state);
    double time = 0.0;
    for (int i = 0; i < 1000; ++i) {
        assert_int_equal(fmi2DoStep(*state, 0.1 * i, 0.1, fmi2True), fmi2OK); /* not 0.1 + 0.1 + ... */
        time = 0.1 * i + 0.1;
        assert_true(get_real(*state, "time") == time);
    }
    assert_int_equal(fmi2DoStep(*state, time + 0.05, 0.1, fmi2True), fmi2Error);
    assert_non_null(strstr(last_message, "communication point"));
}

static void initialize_between(fmi2Component component, double start, double stop) {
    assert_int_equal(fmi2SetupExperiment(component, fmi2False, 0.0, start, fmi2True, stop), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
    assert_int_equal(fmi2ExitInitializationMode(component), fmi2OK);
}

/* A step that is repeated, long after 1970 as well. */
static void a_step_taken_before_is_refused(void **state) {
    static const double starts[] = {0.0, 1e6, 1.7e9};
    for (size_t i = 0; i < sizeof starts / sizeof starts[0]; ++i) {
        const double step = i == 2 ? 0.1 : 1e-4;
        initialize_between(*state, starts[i], starts[i] + 1.0);
        assert_int_equal(fmi2DoStep(*state, starts[i], step, fmi2True), fmi2OK);
        assert_int_equal(fmi2DoStep(*state, starts[i] + step, step, fmi2True), fmi2OK);
        assert_int_equal(fmi2DoStep(*state, starts[i] + step, step, fmi2True), fmi2Error);
        assert_int_equal(fmi2Reset(*state), fmi2OK);
    }
}

static void no_step_goes_beyond_the_stop_time(void **state) {
    initialize_between(*state, 0.0, 1.0);
    run(*state, 0.0, 1.0, 0.1);
    assert_int_equal(fmi2DoStep(*state, 1.0, 0.1, fmi2True), fmi2Error);
    assert_non_null(strstr(last_message, "stop time, 1 s"));
}

static void steps_that_are_none_are_refused(void **state) {
    static const double steps[] = {0.0, -1.0, NAN, INFINITY};
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; ++i) {
        initialize(*state);
        clear_messages();
        assert_int_equal(fmi2DoStep(*state, 0.0, steps[i], fmi2True), fmi2Error);
        assert_int_equal(message_count, 1);
        assert_int_equal(fmi2Reset(*state), fmi2OK);
    }
}

static void a_run_may_start_at_any_time(void **state) {
    assert_int_equal(fmi2SetupExperiment(*state, fmi2False, 0.0, 1000.0, fmi2False, 0.0), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(*state), fmi2OK);
    assert_int_equal(fmi2ExitInitializationMode(*state), fmi2OK);
    run(*state, 1000.0, 1000.0 + 2.5 * period, period);
    assert_close(get_real(*state, "apex.time"), 1000.0 + 2.0 * period, 1e-6);
}

enum { COMPARED = 8 };
static const char *const compared[COMPARED] = {
    "stride.period", "stride.length",      "stride.speed",      "stride.stance_time",
    "stride.work",   "stride.duty_factor", "stride.peak_force", "stride.peak_vertical_force"};

/* Four strides from a start time; what they were. */
static void run_from(double start, double step, double quantities[COMPARED]) {
    fmi2Component component = new_slave();
    assert_int_equal(fmi2SetupExperiment(component, fmi2False, 0.0, start, fmi2False, 0.0), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
    assert_int_equal(fmi2ExitInitializationMode(component), fmi2OK);
    run(component, start, start + 4.0 * step * ceil(period / step), step);
    for (int i = 0; i < COMPARED; ++i) {
        quantities[i] = get_real(component, compared[i]);
    }
    assert_int_equal(get_integer(component, "stride.count"), 4);
    assert_int_equal(get_integer(component, "stride.word_code"), 3 * 256 + 2 * 64 + 1 * 16 + 2 * 4 + 3);
    assert_true(fabs(get_real(component, "apex.time") - start - 4.0 * period) < 1e-3 + 1e-15 * start);
    fmi2FreeInstance(component);
}

/* The clock may count the seconds of an epoch, or be coarser than a mode is long. */
static void strides_do_not_depend_on_the_start_time(void **state) {
    static const double starts[] = {1.7e9, 1e13};
    static const double steps[] = {0.1, 0.25, 7.0};
    (void)state;
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; ++i) {
        double expected[COMPARED], actual[COMPARED];
        run_from(0.0, steps[i], expected);
        for (size_t k = 0; k < sizeof starts / sizeof starts[0]; ++k) {
            run_from(starts[k], steps[i], actual);
            for (int q = 0; q < COMPARED; ++q) {
                assert_relatively_close(actual[q], expected[q], 1e-9);
            }
        }
    }
}

static void a_step_lost_in_the_clock_is_refused(void **state) {
    assert_int_equal(fmi2SetupExperiment(*state, fmi2False, 0.0, 1e17, fmi2False, 0.0), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(*state), fmi2OK);
    assert_int_equal(fmi2ExitInitializationMode(*state), fmi2OK);
    assert_int_equal(fmi2DoStep(*state, 1e17, 64.0, fmi2True), fmi2OK);
    assert_int_equal(fmi2DoStep(*state, 1e17 + 64.0, 0.1, fmi2True), fmi2Error);
    assert_non_null(strstr(last_message, "0.1 s is lost"));
}

static bool has_fallen(fmi2Component component) {
    const fmi2ValueReference fallen = reference_of("status.fallen");
    fmi2Boolean value = fmi2False;
    assert_int_equal(fmi2GetBoolean(component, &fallen, 1, &value), fmi2OK);
    return value == fmi2True;
}

static void a_fall_freezes_and_stays_readable(void **state) {
    assert_int_equal(set_real(*state, "foot.y", 100.0), fmi2OK);
    initialize(*state);
    run(*state, 0.0, 2000.0, 100.0);
    assert_true(has_fallen(*state));
    const double x = get_real(*state, "foot.x");
    run(*state, 2000.0, 2100.0, 10.0);
    assert_true(get_real(*state, "foot.x") == x);
    assert_true(get_real(*state, "time") == 2100.0);
    /* Inputs are the importer's, and go on at their rate. */
    const fmi2ValueReference friction = reference_of("ground.friction");
    const fmi2Integer first = 1;
    const fmi2Real rate = 1e-3;
    assert_int_equal(fmi2SetRealInputDerivatives(*state, &friction, 1, &first, &rate), fmi2OK);
    run(*state, 2100.0, 2300.0, 10.0);
    assert_close(get_real(*state, "ground.friction"), 0.6 + 0.2, 1e-12);
    assert_true(get_real(*state, "foot.x") == x);
}

static void stiff_parameters_end_in_a_message(void **state) {
    assert_int_equal(set_real(*state, "hip.kd", 2.5e13), fmi2OK);
    initialize(*state);
    const double x = get_real(*state, "foot.x");
    assert_int_equal(fmi2DoStep(*state, 0.0, 0.1, fmi2True), fmi2Error);
    assert_non_null(strstr(last_message, "stiff"));
    assert_non_null(strstr(last_message, "CVODE (solver.method = cvode)"));
    assert_true(get_real(*state, "foot.x") == x);
    assert_int_equal(get_integer(*state, "solver.steps"), 1);
    assert_false(has_fallen(*state));
}

static void the_tighter_tolerance_wins(void **state) {
    (void)state;
    double energies[2];
    for (int i = 0; i < 2; ++i) {
        fmi2Component component = new_slave();
        assert_int_equal(set_real(component, "solver.relative_tolerance", 1e-4), fmi2OK);
        assert_int_equal(fmi2SetupExperiment(component, i == 1, 1e-11, 0.0, fmi2False, 0.0), fmi2OK);
        assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
        assert_int_equal(fmi2ExitInitializationMode(component), fmi2OK);
        run(component, 0.0, period, period);
        energies[i] =
            fabs(get_real(component, "energy.total") - get_real(component, "hip.work") +
                 get_real(component, "energy.damper_loss") + get_real(component, "energy.friction_loss") +
                 get_real(component, "energy.impact_loss") - 0.587225);
        fmi2FreeInstance(component);
    }
    assert_true(energies[0] != energies[1]);
}

/* ---- inputs and outputs that move --------------------------------------------------------------------- */

static fmi2Status set_rate(fmi2Component component, const char *name, fmi2Integer order, double rate) {
    const fmi2ValueReference reference = reference_of(name);
    return fmi2SetRealInputDerivatives(component, &reference, 1, &order, &rate);
}

static void an_input_goes_on_at_its_rate_until_it_is_set(void **state) {
    initialize(*state);
    assert_int_equal(set_rate(*state, "ground.friction", 1, -0.01), fmi2OK);
    run(*state, 0.0, 20.0, 10.0);
    assert_close(get_real(*state, "ground.friction"), 0.4, 1e-12);
    assert_int_equal(set_real(*state, "ground.friction", 0.5), fmi2OK);
    run(*state, 20.0, 40.0, 10.0);
    assert_true(get_real(*state, "ground.friction") == 0.5);
}

static void bad_rates_are_refused(void **state) {
    initialize(*state);
    assert_int_equal(set_rate(*state, "ground.friction", 1, NAN), fmi2Discard);
    assert_int_equal(set_rate(*state, "ground.friction", 2, 0.0), fmi2Error);
    assert_int_equal(fmi2Reset(*state), fmi2OK);
    assert_int_equal(set_rate(*state, "body.mass", 1, 0.0), fmi2Error);
}

/* So steep that the input leaves its range in the step, and would overflow. */
static void rates_beyond_reason_end_in_a_message(void **state) {
    static const double rates[] = {1e7, 1e150, 1e200, 1e300};
    for (size_t i = 0; i < sizeof rates / sizeof rates[0]; ++i) {
        initialize(*state);
        assert_int_equal(set_rate(*state, "ground.friction", 1, rates[i]), fmi2OK);
        assert_int_equal(fmi2DoStep(*state, 0.0, 11.0, fmi2True), fmi2Error);
        assert_non_null(strstr(last_message, "out of range"));
        assert_int_equal(fmi2Reset(*state), fmi2OK);
    }
}

static void bad_inputs_in_mid_run_are_discarded(void **state) {
    static const double bad[] = {NAN, -0.1, INFINITY};
    initialize(*state);
    run(*state, 0.0, 12.0, 12.0);
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        assert_int_equal(set_real(*state, "ground.friction", bad[i]), fmi2Discard);
        assert_true(get_real(*state, "ground.friction") == 0.6);
    }
    run(*state, 12.0, 24.0, 12.0);
}

static void output_derivatives_are_slopes(void **state) {
    static const char *names[] = {"body.y",         "com.vx",     "contact.fy",
                                  "energy.kinetic", "hip.torque", "leg.angle"};
    static const double delta = 1e-5;
    initialize(*state);
    run(*state, 0.0, 12.0, 12.0);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i) {
        const fmi2ValueReference reference = reference_of(names[i]);
        const fmi2Integer order = 1;
        double slope = 0.0;
        const double time = get_real(*state, "time");
        const double before = get_real(*state, names[i]);
        assert_int_equal(fmi2DoStep(*state, time, delta, fmi2True), fmi2OK);
        assert_int_equal(fmi2GetRealOutputDerivatives(*state, &reference, 1, &order, &slope), fmi2OK);
        assert_int_equal(fmi2DoStep(*state, time + delta, delta, fmi2True), fmi2OK);
        assert_close((get_real(*state, names[i]) - before) / (2.0 * delta), slope, 1e-7);
    }
}

static void nothing_is_asynchronous(void **state) {
    fmi2Status status;
    double time = 0.0;
    initialize(*state);
    run(*state, 0.0, 5.0, 5.0);
    assert_int_equal(fmi2GetStatus(*state, fmi2DoStepStatus, &status), fmi2Discard);
    assert_int_equal(fmi2GetRealStatus(*state, fmi2LastSuccessfulTime, &time), fmi2OK);
    assert_true(time == 5.0);
    assert_int_equal(fmi2CancelStep(*state), fmi2Error);
}

static fmi2Status start_with_cvode(fmi2Component component) {
    const fmi2ValueReference method = reference_of("solver.method");
    const fmi2Integer cvode = SOLVER_CVODE;
    assert_int_equal(fmi2SetInteger(component, &method, 1, &cvode), fmi2OK);
    assert_int_equal(set_real(component, "solver.relative_tolerance", 1e-10), fmi2OK);
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2OK);
    return fmi2ExitInitializationMode(component);
}

static void cvode_is_refused_where_it_is_missing(void **state) {
    if (tdmf_cvode_is_available()) {
        skip();
    }
    assert_int_equal(start_with_cvode(*state), fmi2Error);
    assert_non_null(strstr(last_message, "SUNDIALS"));
}

static void cvode_agrees_with_the_native_solver(void **state) {
    static const char *names[] = {
        "stride.period",  "stride.length",      "stride.cost_of_transport", "apex.com_height",
        "apex.leg_angle", "energy.impact_loss", "stride.peak_force",        "stride.peak_vertical_force"};
    if (!tdmf_cvode_is_available()) {
        skip();
    }
    fmi2Component native = new_slave();
    initialize(native);
    assert_int_equal(start_with_cvode(*state), fmi2OK);
    run(native, 0.0, 3.5 * period, 0.5 * period);
    run(*state, 0.0, 3.5 * period, 0.5 * period);
    assert_int_equal(get_integer(*state, "event.count"), get_integer(native, "event.count"));
    for (size_t i = 0; i < sizeof names / sizeof names[0]; ++i) {
        assert_relatively_close(get_real(*state, names[i]), get_real(native, names[i]), 1e-6);
    }
    fmi2FreeInstance(native);
}

static void model_exchange_calls_are_refused(void **state) {
    initialize(*state);
    assert_int_equal(fmi2EnterContinuousTimeMode(*state), fmi2Error);
    assert_non_null(strstr(last_message, "Co-Simulation"));
}

static void ten_strides_raise_no_floating_point_exception(void **state) {
#ifdef __GLIBC__
    initialize(*state);
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    run(*state, 0.0, 250.0, 2.5);
    fedisableexcept(FE_ALL_EXCEPT);
#else
    (void)state;
    skip();
#endif
}

#define ON_FRESH_INSTANCE(test) cmocka_unit_test_setup_teardown(test, make, release)

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(steps_arrive_and_the_grid_does_not_matter),
        cmocka_unit_test(a_stride_takes_the_proved_time),
        cmocka_unit_test(a_stride_under_any_gravity_is_that_of_extended_precision),
        ON_FRESH_INSTANCE(rounded_communication_points_are_tolerated_and_wrong_ones_refused),
        ON_FRESH_INSTANCE(a_step_taken_before_is_refused),
        ON_FRESH_INSTANCE(no_step_goes_beyond_the_stop_time),
        ON_FRESH_INSTANCE(rates_beyond_reason_end_in_a_message),
        ON_FRESH_INSTANCE(steps_that_are_none_are_refused),
        ON_FRESH_INSTANCE(a_run_may_start_at_any_time),
        cmocka_unit_test(strides_do_not_depend_on_the_start_time),
        ON_FRESH_INSTANCE(a_step_lost_in_the_clock_is_refused),
        ON_FRESH_INSTANCE(a_fall_freezes_and_stays_readable),
        ON_FRESH_INSTANCE(stiff_parameters_end_in_a_message),
        cmocka_unit_test(the_tighter_tolerance_wins),
        ON_FRESH_INSTANCE(an_input_goes_on_at_its_rate_until_it_is_set),
        ON_FRESH_INSTANCE(bad_rates_are_refused),
        ON_FRESH_INSTANCE(bad_inputs_in_mid_run_are_discarded),
        ON_FRESH_INSTANCE(output_derivatives_are_slopes),
        ON_FRESH_INSTANCE(nothing_is_asynchronous),
        ON_FRESH_INSTANCE(cvode_is_refused_where_it_is_missing),
        ON_FRESH_INSTANCE(cvode_agrees_with_the_native_solver),
        ON_FRESH_INSTANCE(model_exchange_calls_are_refused),
        ON_FRESH_INSTANCE(ten_strides_raise_no_floating_point_exception),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
