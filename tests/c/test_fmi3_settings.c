/* Tunable parameters and discrete inputs of FMI 3.0: set in event mode, also at an event that is not yet
 * taken. */
#include "compare.h"
#include "fmi3_importer.h"

#include "fmu.h"
#include "tdmf_slip/tdmf_slip.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum { MAX_EVENTS = 20 };

/* A run with event mode that stands at its first lift-off, in event mode, the event not yet taken; NULL,
 * asserted, if it does not come. */
static fmi3Instance stand_at_lift_off(void) {
    fmi3Instance instance = new_stepper(true, true);
    update_answer updated;
    initialize3(instance);
    assert_int_equal(update(instance, &updated), fmi3OK);
    double time = 0.0;
    for (int i = 0; i < MAX_EVENTS; ++i) {
        step_answer answer;
        assert_int_equal(fmi3EnterStepMode(instance), fmi3OK);
        assert_int_equal(do_step(instance, time, 20.0 - time, &answer), fmi3OK);
        assert_true(answer.event);
        assert_int_equal(fmi3EnterEventMode(instance), fmi3OK);
        time = answer.time;
        if (get_int(instance, "hip.phase_index") == TDMF_PHASE_COAST &&
            get_float(instance, "contact.fy") < 1e-6) {
            return instance;
        }
        assert_int_equal(update(instance, &updated), fmi3OK);
    }
    fail_msg("no lift-off");
    return NULL;
}

/* Where the flight law has no torque, both laws agree at lift-off and there is no graze. */
TEST(a_pending_event_is_that_of_the_settings_in_force) {
    static const char *const gains[] = {"hip.kp", "hip.kd"};
    for (int set = 0; set < 2; ++set) {
        fmi3Instance instance = stand_at_lift_off();
        const int events = get_int(instance, "event.count");
        update_answer updated;
        for (int i = 0; i < 2; ++i) {
            const double gain = set ? 0.0 : get_float(instance, gains[i]);
            assert_int_equal(set_float(instance, gains[i], gain), fmi3OK);
        }
        assert_int_equal(update(instance, &updated), fmi3OK);
        assert_true(updated.states_changed);
        assert_int_equal(get_int(instance, "contact.mode_index"),
                         set ? TDMF_CONTACT_FLIGHT : TDMF_CONTACT_GRAZE);
        assert_int_equal(get_int(instance, "event.count"), events + 1);
        fmi3FreeInstance(instance);
    }
}

/* What was changed at the event is told from what the event came of also by another instance. */
TEST(a_saved_pending_event_knows_its_settings) {
    fmi3Instance one = stand_at_lift_off(), other = new_stepper(true, true);
    fmi3Byte bytes[SERIALIZED_BYTES];
    fmi3FMUState saved = NULL;
    update_answer updated;
    assert_int_equal(set_float(one, "hip.kp", 0.0), fmi3OK);
    assert_int_equal(set_float(one, "hip.kd", 0.0), fmi3OK);
    const size_t size = save_bytes(&fmi3, one, bytes);
    assert_int_equal(fmi3DeserializeFMUState(other, bytes, size, &saved), fmi3OK);
    assert_int_equal(fmi3SetFMUState(other, saved), fmi3OK);
    assert_int_equal(fmi3FreeFMUState(other, &saved), fmi3OK);
    assert_true(get_float(other, "hip.kp") == 0.0);
    assert_int_equal(update(other, &updated), fmi3OK);
    assert_int_equal(get_int(other, "contact.mode_index"), TDMF_CONTACT_FLIGHT);
    fmi3FreeInstance(one);
    fmi3FreeInstance(other);
}

TEST(they_are_set_where_a_run_stands_still) {
    static const char *const names[] = {"hip.touchdown_angle", "ground.height", "control.thrust"};
    for (int i = 0; i < 3; ++i) {
        fmi3Instance exchange = new_exchange(), stepper = new_stepper(false, false);
        initialize3(exchange);
        initialize3(stepper);
        assert_int_equal(set_float(exchange, names[i], 0.01), fmi3OK);
        assert_int_equal(set_float(exchange, names[i], 1e12), fmi3Discard);
        assert_int_equal(fmi3EnterContinuousTimeMode(exchange), fmi3OK);
        assert_int_equal(set_float(exchange, names[i], 0.02), fmi3Warning);
        assert_int_equal(set_float(stepper, names[i], 0.02), fmi3OK);
        assert_true(get_float(exchange, names[i]) == 0.01);
        assert_true(get_float(stepper, names[i]) == 0.02);
        fmi3FreeInstance(exchange);
        fmi3FreeInstance(stepper);
    }
}
