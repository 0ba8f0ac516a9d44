/* Co-Simulation of either version: steps that arrive, and those that are refused. */
#include "compare.h"
#include "fmi_interface.h"
#include "reference_gaits.h"
#include "references.h"

#include "tdmf_slip/cvode.h"
#include "tdmf_slip/tdmf_slip.h"
#include "variables.h"

#include <float.h>
#include <math.h>
#include <string.h>

#ifdef __GLIBC__
#include <fenv.h>
int feenableexcept(int exceptions); /* GNU extensions, hidden by -std=c99 */
int fedisableexcept(int exceptions);
#endif

static const double period = 25.000146165488143; /* period of the gait at the default start */

/* ---- stepping ----------------------------------------------------------------------------------------- */

FMI_TEST(steps_arrive_and_the_grid_does_not_matter) {
    static const double steps[] = {0.01, 0.1, 1.255, 25.1, 251.0};
    for (size_t i = 0; i < COUNT_OF(steps); ++i) {
        void *instance = begun(fmi, STEPS, "");
        run_to(fmi, instance, 251.0, steps[i]);
        assert_true(fabs(value_of(fmi, instance, "time") - 251.0) < 1e-9);
        assert_int_equal(integer_of(fmi, instance, "stride.count"), 10);
        assert_close(value_of(fmi, instance, "stride.period"), period, 1e-8);
        assert_close(value_of(fmi, instance, "stride.cost_of_transport"), 0.373969024460401, 1e-9);
    }
}

/* The unit runs a smaller page if only the hip drives the runner. A negligible extension of the leg makes it
 * run the whole page. */
FMI_TEST(a_smaller_page_changes_no_result) {
    void *plain = new_of_kind(fmi, STEPS), *whole = new_of_kind(fmi, STEPS);
    int compared = 0;
    set_values(fmi, whole, "leg.extension=1e-300");
    initialize_unit(fmi, plain);
    initialize_unit(fmi, whole);
    run_to(fmi, plain, 140.0, 0.5);
    run_to(fmi, whole, 140.0, 0.5);
    for (uint32_t i = 0; i < fmu_variable_count; ++i) {
        const char *name = fmu_variables[i].name;
        double value, expected;
        if (fmu_variables[i].type == VARIABLE_REAL && fmi->get_reals(plain, &i, 1, &value) == FMI_OK) {
            assert_int_equal(fmi->get_reals(whole, &i, 1, &expected), FMI_OK);
            assert_true(fabs(value - expected) <= 1e-9 * (1.0 + fabs(expected)) || strchr(name, '(') != NULL);
            ++compared;
        }
    }
    assert_true(compared > 100);
    assert_int_equal(integer_of(fmi, plain, "event.count"), integer_of(fmi, whole, "event.count"));
    assert_int_equal(integer_of(fmi, plain, "stride.word_code"), integer_of(fmi, whole, "stride.word_code"));
}

/* The latched work of a stride contains no work of an earlier stride. */
FMI_TEST(the_work_of_a_thrust_is_no_more_in_later_strides) {
    void *instance = begun(fmi, STEPS, "leg.thrust=1e-3");
    run_to(fmi, instance, 26.0, 1.0);
    assert_true(value_of(fmi, instance, "stride.leg_work") > 1e-6);
    set_values(fmi, instance, "leg.thrust=0.0");
    run_to(fmi, instance, 52.0, 1.0);
    assert_int_equal(integer_of(fmi, instance, "stride.count"), 2);
    assert_true(value_of(fmi, instance, "stride.leg_work") == 0.0);
}

/* Steps may also end at events. */
FMI_TEST(a_stride_takes_the_proved_time) {
    step_answer answer;
    const tdmf_model model = table_1(true); /* that of the proof */
    for (int i = 0; i < PROVED_GAITS; ++i) {
        const proved_gait *gait = &proved_gaits[i];
        for (int stops = 0; stops < 2; ++stops) {
            void *instance = new_of_kind(fmi, STEPS);
            double time = 0.0;
            set_apex(fmi, instance, &model, gait->friction, gait->apex);
            set_values(fmi, instance, "solver.relative_tolerance=1e-13");
            begin(fmi, instance, STEPS);
            for (int k = 0; k < gait->event_count && stops; ++k) {
                assert_int_equal(fmi->do_step(instance, time, gait->events[k].time - time, &answer), FMI_OK);
                time = gait->events[k].time;
            }
            assert_int_equal(fmi->do_step(instance, time, gait->period + 1.0 - time, &answer), FMI_OK);
            assert_int_equal(integer_of(fmi, instance, "stride.count"), 1);
            assert_close(value_of(fmi, instance, "stride.period"), gait->period, 1e-13 * gait->period);
            assert_close(value_of(fmi, instance, "apex.time"), gait->period, 1e-13 * gait->period);
        }
    }
}

/* Times of importers are off by rounding: they add steps up, or multiply, long after 1970 as well. A refused
 * step leaves the run where it was. */
FMI_TEST(a_step_begins_where_the_last_one_ended_and_is_a_number_within_the_stop_time) {
    static const double epoch = 1.7e9;
    const double after = nextafter(epoch + 1e-3, INFINITY); /* by rounding */
    const struct {
        double start, stop;
        struct {
            double time, step;
            const char *refused;
        } steps[3];
    } cases[] = {
        {0.0, 0.3, {{0.0, 0.1, NULL}, {0.1, 0.2, NULL}}}, /* 0.1 + 0.2 > 0.3 in doubles */
        {0.0, 1.0, {{0.0, 1.0, NULL}, {1.0, 0.1, "stop time, 1 s"}}},
        {0.0, 9.0, {{0.0, 1.0, NULL}, {1.0 + 1e-4, 1.0, "communication point"}, {1.0 + 1e-7, 1.0, NULL}}},
        {epoch, epoch + 1.0, {{epoch, 1e-3, NULL}, {after, 1e-3, NULL}}},
        {0.0, 1.0, {{0.0, 1e-4, NULL}, {1e-4, 1e-4, NULL}, {1e-4, 1e-4, "communication point"}}},
        {1e6, 2e6, {{1e6, 1e-4, NULL}, {1e6 + 1e-4, 1e-4, NULL}, {1e6 + 1e-4, 1e-4, "communication point"}}},
        {epoch, 2e9, {{epoch, 0.1, NULL}, {epoch, 0.1, "communication point"}, {epoch + 0.1, 0.1, NULL}}},
        {1e17, INFINITY, {{1e17, 64.0, NULL}, {1e17 + 64.0, 0.1, "0.1 s is lost"}}},
        {0.0, INFINITY, {{DBL_MAX, DBL_MAX, "not a positive number"}, {0.0, 1.0, NULL}}},
        {0.0, INFINITY, {{0.0, 0.0, "positive"}, {0.0, -1.0, "positive"}, {0.0, 1.0, NULL}}},
        {0.0, INFINITY, {{0.0, NAN, "positive"}, {0.0, INFINITY, "positive"}, {0.0, 1.0, NULL}}},
    };
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        const double stop = cases[i].stop;
        const fmi_experiment given = {.start = cases[i].start, .has_stop = isfinite(stop), .stop = stop};
        void *instance = new_of_kind(fmi, STEPS);
        assert_int_equal(fmi->enter_initialization(instance, &given), FMI_OK);
        assert_int_equal(fmi->exit_initialization(instance), FMI_OK);
        for (int j = 0; j < 3 && (j == 0 || cases[i].steps[j].step != 0.0); ++j) {
            step_answer answer;
            const char *refused = cases[i].steps[j].refused;
            const fmi_status status =
                fmi->do_step(instance, cases[i].steps[j].time, cases[i].steps[j].step, &answer);
            assert_int_equal(status, refused == NULL ? FMI_OK : FMI_ERROR);
            assert_true(refused == NULL || strstr(last_message, refused) != NULL);
        }
    }
}

enum { COMPARED = 8 };
static const char *const compared[COMPARED] = {
    "stride.period", "stride.length",      "stride.speed",      "stride.stance_time",
    "stride.work",   "stride.duty_factor", "stride.peak_force", "stride.peak_vertical_force"};

/* Runs four strides from a start time, and reads the quantities of the last one. */
static void run_from(const fmi_interface *fmi, fmi_kind kind, double start, double step,
                     double quantities[COMPARED]) {
    void *instance = new_of_kind(fmi, kind);
    initialize_unit_at(fmi, instance, start);
    if (kind == STEPS_WITH_EVENTS) {
        update_and_go_on(fmi, instance, kind);
    }
    run_to(fmi, instance, start + 4.0 * step * ceil(period / step), step);
    for (int i = 0; i < COMPARED; ++i) {
        quantities[i] = value_of(fmi, instance, compared[i]);
    }
    assert_int_equal(integer_of(fmi, instance, "stride.count"), 4);
    assert_int_equal(integer_of(fmi, instance, "stride.word_code"), 3 * 256 + 2 * 64 + 1 * 16 + 2 * 4 + 3);
    assert_true(fabs(value_of(fmi, instance, "apex.time") - start - 4.0 * period) < 1e-3 + 1e-15 * start);
}

/* The clock may count the seconds since 1970, or be coarser than the duration of a mode. */
FMI_TEST(strides_do_not_depend_on_the_start_time) {
    static const double starts[] = {1.7e9, 1e13};
    static const double steps[] = {0.1, 0.25, 7.0};
    for (fmi_kind kind = STEPS; kind < fmi->kinds; ++kind) {
        for (size_t i = 0; i < COUNT_OF(steps); ++i) {
            double expected[COMPARED], actual[COMPARED];
            run_from(fmi, kind, 0.0, steps[i], expected);
            for (size_t k = 0; k < COUNT_OF(starts); ++k) {
                run_from(fmi, kind, starts[k], steps[i], actual);
                assert_all_close(actual, expected, COMPARED, 0.0, 1e-9);
            }
        }
    }
}

FMI_TEST(a_fall_is_reported_freezes_and_stays_readable) {
    for (fmi_kind kind = STEPS; kind < fmi->kinds; ++kind) {
        void *instance = new_of_kind(fmi, kind);
        assert_int_equal(fmi->set_logging(instance, true, 1, events_category), FMI_OK);
        set_values(fmi, instance, "foot.y=100");
        begin(fmi, instance, kind);
        run_to(fmi, instance, 2000.0, 100.0);
        assert_true(truth_of(fmi, instance, "status.fallen"));
        assert_non_null(strstr(last_message, ", fallen"));
        assert_true(strncmp(last_message, "body_down", 9) == 0 ||
                    strncmp(last_message, "leg_too_short", 13) == 0);
        const double x = value_of(fmi, instance, "foot.x");
        assert_int_equal(run_to(fmi, instance, 2100.0, 10.0), 0);
        assert_true(value_of(fmi, instance, "foot.x") == x);
        assert_true(value_of(fmi, instance, "time") == 2100.0);
    }
}

/* The leg becomes too short in stance: contact, phase and forces are those of the last moment. */
FMI_TEST(a_fall_leaves_the_last_contact_as_it_was) {
    void *instance = begun(
        fmi, STEPS,
        "foot.y=0 foot.vx=0 foot.vy=0 leg.length=0.06 leg.angle=0.1 leg.length_rate=-1 ground.friction=10");
    run_to(fmi, instance, 1.0, 1.0);
    assert_true(truth_of(fmi, instance, "status.fallen"));
    assert_int_equal(integer_of(fmi, instance, "contact.mode"), TDMF_CONTACT_STICK);
    assert_int_equal(integer_of(fmi, instance, "hip.phase"), TDMF_PHASE_DRIVE);
    assert_true(value_of(fmi, instance, "contact.normal") > 0.5);
    assert_close(value_of(fmi, instance, "hip.torque"), -0.2, 1e-15);
}

FMI_TEST(stiff_parameters_end_in_a_message) {
    step_answer answer;
    void *instance = begun(fmi, STEPS, "hip.kd=2.5e13");
    const double x = value_of(fmi, instance, "foot.x");
    assert_int_equal(fmi->do_step(instance, 0.0, 0.1, &answer), FMI_ERROR);
    assert_true(!answer.event && !answer.early && !answer.terminate && answer.time == 0.0);
    assert_non_null(strstr(last_message, "stiff"));
    assert_non_null(strstr(last_message, "CVODE (solver.method = cvode)"));
    assert_true(value_of(fmi, instance, "foot.x") == x);
    assert_true(integer_of(fmi, instance, "solver.steps") <= 10000);
    assert_false(truth_of(fmi, instance, "status.fallen"));
}

FMI_TEST(the_tighter_tolerance_wins) {
    int steps[2];
    for (int i = 0; i < 2; ++i) {
        void *instance = new_of_kind(fmi, STEPS);
        set_values(fmi, instance, "solver.relative_tolerance=1e-4");
        const fmi_experiment experiment = {.has_tolerance = i == 1, .tolerance = 1e-11};
        assert_int_equal(fmi->enter_initialization(instance, &experiment), FMI_OK);
        assert_int_equal(fmi->exit_initialization(instance), FMI_OK);
        run_to(fmi, instance, period, period);
        steps[i] = integer_of(fmi, instance, "solver.steps");
    }
    assert_true(steps[1] > steps[0]);
}

/* ---- inputs and outputs --------------------------------------------------------------------------- */

FMI_TEST(output_derivatives_are_slopes) {
    step_answer answer;
    void *instance = new_of_kind(fmi, STEPS);
    static const char *names[] = {"body.y",         "com.vx",     "contact.fy",
                                  "energy.kinetic", "hip.torque", "leg.angle"};
    static const double delta = 1e-5;
    initialize_unit(fmi, instance);
    run_to(fmi, instance, 12.0, 12.0);
    for (size_t i = 0; i < COUNT_OF(names); ++i) {
        double slope = 0.0;
        const double time = value_of(fmi, instance, "time");
        const double before = value_of(fmi, instance, names[i]);
        assert_int_equal(fmi->do_step(instance, time, delta, &answer), FMI_OK);
        assert_int_equal(fmi->output_derivative(instance, reference_of(names[i]), 1, &slope), FMI_OK);
        assert_int_equal(fmi->do_step(instance, time + delta, delta, &answer), FMI_OK);
        assert_close((value_of(fmi, instance, names[i]) - before) / (2.0 * delta), slope, 1e-7);
    }
}

FMI_TEST(ten_strides_raise_no_floating_point_exception) {
#ifdef __GLIBC__
    void *instance = begun(fmi, STEPS, "");
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    run_to(fmi, instance, 250.0, 2.5);
    fedisableexcept(FE_ALL_EXCEPT);
#else
    (void)fmi;
    skip();
#endif
}
