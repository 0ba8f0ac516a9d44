/* Features of FMI 3.0 alone: offers to an importer, types, counts of values, and adjoint derivatives. */
#include "compare.h"
#include "fmi3_importer.h"

#include "guid.h"
#include "tdmf_slip/tdmf_slip.h"
#include "variables.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- instantiation ------------------------------------------------------------------------------------ */

TEST(refuses_an_interface_it_does_not_have) {
    clear_messages();
    assert_null(fmi3InstantiateScheduledExecution("runner", FMU_GUID, NULL, false, false, NULL,
                                                  importer_logger, NULL, NULL, NULL));
    assert_non_null(strstr(last_message, "Scheduled Execution"));
}

static void called_back(fmi3InstanceEnvironment environment, fmi3Float64 time, fmi3Boolean set_requested,
                        fmi3Boolean get_allowed, fmi3Boolean step_finished, fmi3Boolean may_return_early,
                        fmi3Boolean *early_return, fmi3Float64 *early_return_time) {
    (void)environment;
    (void)time;
    (void)set_requested;
    (void)get_allowed;
    (void)step_finished;
    (void)may_return_early;
    (void)early_return;
    (void)early_return_time;
    fail_msg("the unit has called back");
}

/* Intermediate updates are an offer that the unit need not take up. */
TEST(an_importer_that_offers_intermediate_updates_is_never_called_back) {
    const fmi3ValueReference wanted[] = {reference_of("foot.x"), reference_of("leg.angle")};
    clear_messages();
    for (int way = 0; way < 4; ++way) {
        const fmi3Boolean event_mode = way >= 2, early_return = way % 2 == 1;
        double foot_x[2];
        for (int offers = 0; offers < 2; ++offers) {
            fmi3Instance instance = fmi3InstantiateCoSimulation(
                "runner", FMU_GUID, NULL, false, false, event_mode, early_return, offers ? wanted : NULL,
                offers ? 2 : 0, NULL, importer_logger, offers ? called_back : NULL);
            step_answer answer;
            assert_non_null(instance);
            free_after_test(instance, fmi3FreeInstance);
            initialize3(instance);
            if (event_mode) {
                update_and_go_on(&fmi3, instance, STEPS_WITH_EVENTS);
            }
            for (int i = 0; i < 4; ++i) { /* early, to the first event */
                assert_int_equal(do_step(instance, get_float(instance, "time"), 40.0, &answer), fmi3OK);
                if (answer.event) {
                    take_event(&fmi3, instance, STEPS_WITH_EVENTS, "");
                }
            }
            assert_int_equal(answer.event, way == 3);
            foot_x[offers] = get_float(instance, "foot.x");
        }
        assert_true(foot_x[0] == foot_x[1]);
    }
    assert_int_equal(message_count, 0);
}

static fmi3Instance in_event_mode(void) {
    fmi3Instance instance = new_exchange();
    initialize3(instance);
    return instance;
}

/* ---- values ------------------------------------------------------------------------------------------- */

TEST(every_variable_is_read_by_its_own_type_only) {
    fmi3Instance instance = in_event_mode();
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmi3ValueReference reference = (fmi3ValueReference)i;
        double real;
        fmi3Int32 integer;
        fmi3Int64 item;
        fmi3Boolean truth;
        fmi3String text;
        const fmu_variable_type type = fmu_variables[i].type;
        const fmi3Status found[] = {fmi3GetFloat64(instance, &reference, 1, &real, 1),
                                    fmi3GetInt32(instance, &reference, 1, &integer, 1),
                                    fmi3GetInt64(instance, &reference, 1, &item, 1),
                                    fmi3GetBoolean(instance, &reference, 1, &truth, 1),
                                    fmi3GetString(instance, &reference, 1, &text, 1)};
        static const fmu_variable_type types[] = {VARIABLE_REAL, VARIABLE_INTEGER, VARIABLE_ENUMERATION,
                                                  VARIABLE_BOOLEAN, VARIABLE_STRING};
        for (size_t j = 0; j < COUNT_OF(types); ++j) {
            assert_int_equal(found[j], types[j] == type ? fmi3OK : fmi3Error);
        }
    }
}

/* The values include some that do not fit an Integer of FMI 2.0. */
TEST(enumerations_are_set_in_range_only) {
    const fmi3ValueReference method = reference_of("solver.method");
    static const fmi3Int64 bad[] = {INT64_MAX, INT64_MIN, (INT64_C(1) << 32) + 2};
    fmi3Instance instance = new_exchange();
    for (size_t i = 0; i < COUNT_OF(bad); ++i) {
        assert_int_equal(fmi3SetInt64(instance, &method, 1, &bad[i], 1), fmi3Discard);
        assert_int_equal(get_int(instance, "solver.method"), 1);
    }
}

TEST(indicators_are_variables_too) {
    double indicators[TDMF_GUARD_COUNT];
    const fmi3ValueReference first = reference_of("guard.touchdown");
    fmi3Instance instance = in_event_mode();
    assert_int_equal(fmi3EnterContinuousTimeMode(instance), fmi3OK);
    assert_int_equal(fmi3GetEventIndicators(instance, indicators, TDMF_GUARD_COUNT), fmi3OK);
    assert_close(indicators[TDMF_GUARD_TOUCHDOWN], get_float(instance, "foot.y"), 1e-9);
    for (fmi3ValueReference i = 0; i < TDMF_GUARD_COUNT; ++i) {
        const fmi3ValueReference reference = first + i;
        double value;
        assert_int_equal(fmi3GetFloat64(instance, &reference, 1, &value, 1), fmi3OK);
        assert_true(value == indicators[i]);
    }
}

/* ---- derivatives -------------------------------------------------------------------------------------- */

TEST(derivatives_by_what_is_fixed_are_refused) {
    const fmi3ValueReference unknown = reference_of("body.x"), mass = reference_of("body.mass"),
                             known = reference_of("leg.angle");
    const double seed = 1.0, bad = NAN;
    double value;
    fmi3Instance instance = in_event_mode();
    assert_int_equal(fmi3GetAdjointDerivative(instance, &unknown, 1, &known, 1, &bad, 1, &value, 1),
                     fmi3Discard);
    assert_int_equal(fmi3GetDirectionalDerivative(instance, &unknown, 1, &known, 1, &bad, 1, &value, 1),
                     fmi3Discard);
    assert_int_equal(fmi3GetAdjointDerivative(instance, &unknown, 1, &mass, 1, &seed, 1, &value, 1),
                     fmi3Error);
    assert_non_null(
        strstr(last_message, "body.mass is neither a state nor an input nor tunable, and the run has begun"));
    assert_int_equal(fmi3GetDirectionalDerivative(instance, &unknown, 1, &unknown, 1, &seed, 1, &value, 1),
                     fmi3Error);
    assert_int_equal(fmi3GetDirectionalDerivative(instance, &mass, 1, &known, 1, &seed, 1, &value, 1),
                     fmi3Error);
}
