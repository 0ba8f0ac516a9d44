/* FMI 3.0 Co-Simulation: without event mode like FMI 2.0; with it, steps that end at an event, before it. */
#include "compare.h"
#include "fmi2_importer.h"
#include "fmi3_importer.h"
#include "fmi_interface.h"

#include "tdmf_slip/tdmf_slip.h"
#include "variables.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double period = 25.000146165488143; /* period of the gait at the default start */
static const double touchdown = 12.03;           /* time of its first touchdown, roughly */
static const double ten_strides = 251.0;

enum { EVENTS_OF_A_STRIDE = 9, MAX_EVENTS = 1000 };

static fmi3Instance eventful_stepper(void) {
    return begun(&fmi3, STEPS_WITH_EVENTS, "");
}

static fmi3Instance plain_stepper(bool early_return) {
    fmi3Instance instance = new_stepper(false, early_return);
    initialize3(instance);
    return instance;
}

/* Makes a step from the present time. */
static step_answer step_on(fmi3Instance instance, double step) {
    step_answer answer;
    assert_int_equal(do_step(instance, get_float(instance, "time"), step, &answer), fmi3OK);
    return answer;
}

static update_answer take(fmi3Instance instance, const char *values) {
    const update_answer answer = take_event(&fmi3, instance, STEPS_WITH_EVENTS, values);
    assert_false(answer.needs_update || answer.terminate);
    return answer;
}

static void run_until_it_sticks(fmi3Instance instance) {
    while (get_int(instance, "contact.mode") != TDMF_CONTACT_STICK) {
        step_on(instance, 20.0);
        take(instance, "");
    }
}

/* ---- the same strides --------------------------------------------------------------------------------- */

TEST(without_event_mode_it_is_the_fmi2_unit) {
    fmi2Component old = begun(&fmi2, STEPS, "");
    fmi3Instance plain = plain_stepper(true), eventful = new_stepper(true, false);
    begin(&fmi3, eventful, STEPS_WITH_EVENTS);
    for (int i = 0; i < 26; ++i) {
        const double arrival = 10.0 * (i + 1);
        step_by(&fmi2, old, 10.0);
        const step_answer first = step_on(plain, 10.0), second = step_on(eventful, 10.0);
        assert_true(!first.event && !first.early && !first.terminate && first.time == arrival);
        assert_true(!second.event && !second.early && second.time == arrival);
    }
    assert_same_states(&fmi3, plain, &fmi2, old, 0.0);
    assert_same_states(&fmi3, eventful, &fmi2, old, 0.0);
    assert_int_equal(get_int(plain, "stride.count"), 10);
    assert_close(get_float(plain, "stride.period"), period, 1e-8);
}

TEST(stopping_at_every_event_changes_nothing) {
    static const double steps[] = {0.05, 1.0, 251.0};
    for (size_t i = 0; i < COUNT_OF(steps); ++i) {
        fmi3Instance plain = plain_stepper(false), eventful = eventful_stepper();
        run_to(&fmi3, plain, ten_strides, steps[i]);
        assert_int_equal(run_to(&fmi3, eventful, ten_strides, steps[i]), get_int(plain, "event.count"));
        assert_int_equal(get_int(eventful, "event.count"), get_int(plain, "event.count"));
        assert_int_equal(get_int(eventful, "stride.count"), 10);
        assert_same_states(&fmi3, eventful, &fmi3, plain, 1e-9);
        assert_close(get_float(eventful, "stride.period"), period, 1e-8);
    }
}

/* ---- events ------------------------------------------------------------------------------------------- */

TEST(the_left_limit_is_as_near_by_a_coarse_clock) {
    fmi3Instance instance = new_stepper(true, true);
    initialize_unit_at(&fmi3, instance, 1.7e9);
    update_and_go_on(&fmi3, instance, STEPS_WITH_EVENTS);
    const step_answer step = step_on(instance, 20.0);
    assert_true(step.event && step.early);
    assert_close(get_float(instance, "foot.y"), 0.0, 1e-11);
    assert_true(get_float(instance, "foot.vy") < -0.1);
    take(instance, "ground.friction=100");
    assert_true(get_float(instance, "foot.vy") == 0.0);
    assert_close(get_float(instance, "foot.y"), 0.0, 1e-11);
    assert_int_equal(get_int(instance, "contact.mode"), TDMF_CONTACT_STICK);
}

TEST(a_step_ends_at_the_event_and_before_it) {
    update_answer after;
    fmi3Instance instance = eventful_stepper();
    const step_answer step = step_on(instance, 20.0);
    assert_true(step.event && step.early);
    assert_close(step.time, touchdown, 0.01);
    assert_true(get_float(instance, "time") == step.time);
    assert_int_equal(get_int(instance, "event.count"), 0);
    assert_close(get_float(instance, "foot.y"), 0.0, 1e-9);
    assert_true(get_float(instance, "foot.vy") < -0.1);
    assert_int_equal(fmi3EnterEventMode(instance), fmi3OK);
    assert_int_equal(get_int(instance, "contact.mode"), TDMF_CONTACT_FLIGHT);
    assert_int_equal(update(instance, &after), fmi3OK);
    assert_true(after.states_changed && !after.needs_update);
    assert_int_equal(get_int(instance, "contact.mode"), TDMF_CONTACT_SLIP_POSITIVE);
    assert_true(get_float(instance, "foot.vy") == 0.0);
    assert_true(get_float(instance, "event.last_time") == step.time);
    assert_true(get_float(instance, "energy.impact_loss") > 0.0);
    assert_int_equal(update(instance, &after), fmi3OK);
    assert_false(after.states_changed);
    assert_int_equal(fmi3EnterStepMode(instance), fmi3OK);
}

/* Continuous outputs are the same from both sides of an event that moves no state; an impact keeps the body.
 */
TEST(states_before_an_event_are_its_left_limit) {
    static const char *const names[4] = {"body.x", "body.y", "body.vx", "body.vy"};
    fmi3Instance instance = eventful_stepper();
    step_answer step = {.event = false};
    for (int i = 0; i < EVENTS_OF_A_STRIDE; ++i) {
        double body[4];
        step = step_on(instance, 30.0);
        assert_true(step.event);
        for (int j = 0; j < 4; ++j) {
            body[j] = get_float(instance, names[j]);
        }
        take(instance, "");
        for (int j = 0; j < 4; ++j) {
            assert_close(get_float(instance, names[j]), body[j], 1e-9);
        }
    }
    assert_int_equal(get_int(instance, "stride.count"), 1);
    assert_close(step.time, period, 1e-7);
    assert_true(get_float(instance, "apex.time") == step.time);
}

TEST(an_event_left_unhandled_is_taken_by_the_next_step) {
    fmi3Instance instance = eventful_stepper();
    assert_true(step_on(instance, 20.0).early);
    step_on(instance, 0.01);
    assert_int_equal(get_int(instance, "event.count"), 1);
}

/* The ground turns to ice in event mode, in mid-stance, while the foot sticks: it slips at once. */
TEST(inputs_jump_in_event_mode) {
    fmi3Instance instance = eventful_stepper();
    run_until_it_sticks(instance);
    assert_false(step_on(instance, 1e-3).event);
    take(instance, "ground.friction=0.01");
    assert_int_not_equal(get_int(instance, "contact.mode"), TDMF_CONTACT_STICK);
    step_on(instance, 1e-3);
}

/* The friction changes while the event is handled: the velocity after the impact is that of the impact map
 * with the new friction. */
TEST(inputs_set_at_an_event_act_on_it) {
    static const double frictions[] = {0.0, 0.3, 0.6, 1.0, 10.0};
    for (size_t i = 0; i < COUNT_OF(frictions); ++i) {
        char friction[32];
        fmi3Instance instance = eventful_stepper();
        const double time = step_on(instance, 20.0).time;
        const double vx = get_float(instance, "foot.vx"), vy = get_float(instance, "foot.vy");
        const double braked = fmax(0.0, vx - frictions[i] * fabs(vy));
        snprintf(friction, sizeof friction, "ground.friction=%g", frictions[i]);
        assert_true(take(instance, friction).states_changed);
        assert_close(get_float(instance, "foot.vx"), braked, 1e-9);
        assert_true(get_float(instance, "foot.vy") == 0.0);
        assert_int_equal(get_int(instance, "contact.mode"),
                         braked > 0.0 ? TDMF_CONTACT_SLIP_POSITIVE : TDMF_CONTACT_STICK);
        assert_int_equal(get_int(instance, "event.count"), 1);
        assert_true(get_float(instance, "time") == time && get_float(instance, "event.last_time") == time);
        step_on(instance, 1e-3);
    }
}

/* An apex that is taken with another friction than it was found with is latched at the time of the unit. The
 * time of a second search would be a rounding error later for a heavy runner. */
TEST(an_apex_taken_anew_has_the_time_of_its_event) {
    static const double starts[] = {0.0, 1.0, 1e3};
    for (size_t i = 0; i < COUNT_OF(starts); ++i) {
        fmi3Instance instance = new_stepper(true, true);
        set_values(&fmi3, instance, "gravity=10.0 foot.vy=5.0");
        initialize_unit_at(&fmi3, instance, starts[i]);
        update_and_go_on(&fmi3, instance, STEPS_WITH_EVENTS);
        const step_answer step = step_on(instance, 30.0);
        assert_true(step.event && step.time > starts[i]);
        assert_int_equal(get_int(instance, "hip.phase"), TDMF_PHASE_RETRACT);
        take(instance, "ground.friction=0.7");
        assert_int_equal(get_int(instance, "hip.phase"), TDMF_PHASE_PLACE);
        assert_true(get_float(instance, "apex.time") == step.time);
        assert_true(get_float(instance, "event.last_time") == step.time);
        assert_true(get_float(instance, "time") == step.time);
    }
}

/* The foot would slip now, but the ground turns rough: it does not. */
TEST(an_event_may_be_averted) {
    fmi3Instance instance = eventful_stepper();
    run_until_it_sticks(instance);
    assert_true(step_on(instance, 20.0).event);
    const int events = get_int(instance, "event.count");
    assert_int_equal(get_int(instance, "contact.mode"), TDMF_CONTACT_STICK);
    take(instance, "ground.friction=10");
    assert_int_equal(get_int(instance, "contact.mode"), TDMF_CONTACT_STICK);
    assert_int_equal(get_int(instance, "event.count"), events);
    assert_false(step_on(instance, 0.05).event);
}

TEST(cvode_stops_at_events_too) {
    fmi3Instance instance = new_stepper(true, true);
    assert_int_equal(fmi3.set_item(instance, reference_of("solver.method"), SOLVER_CVODE), FMI_OK);
    if (fmi3EnterInitializationMode(instance, false, 0.0, 0.0, false, 0.0) != fmi3OK ||
        fmi3ExitInitializationMode(instance) != fmi3OK) {
        assert_non_null(strstr(last_message, "SUNDIALS"));
        skip();
    }
    assert_int_equal(fmi3EnterStepMode(instance), fmi3OK);
    assert_int_equal(run_to(&fmi3, instance, period + 0.01, period + 0.01), EVENTS_OF_A_STRIDE);
    assert_close(get_float(instance, "stride.period"), period, 1e-6);
    step_on(instance, 1.0);
}

TEST(a_step_wants_room_for_its_answers) {
    fmi3Instance instance = plain_stepper(false);
    assert_int_equal(fmi3DoStep(instance, 0.0, 1.0, true, NULL, NULL, NULL, NULL), fmi3Error);
    assert_non_null(strstr(last_message, "null pointer"));
}

/* ---- settings at an event that is not yet taken ---------------------------------------------------- */

/* A run with event mode that stands at its first lift-off, in event mode, the event not yet taken. */
static fmi3Instance stand_at_lift_off(void) {
    fmi3Instance instance = eventful_stepper();
    for (int i = 0; i < MAX_EVENTS; ++i) {
        step_on(instance, 20.0 - get_float(instance, "time"));
        if (get_int(instance, "hip.phase") == TDMF_PHASE_COAST && get_float(instance, "contact.fy") < 1e-6) {
            assert_int_equal(fmi3EnterEventMode(instance), fmi3OK);
            return instance;
        }
        take(instance, "");
    }
    fail_msg("no lift-off");
    return NULL;
}

/* Both laws agree at lift-off if the flight law has no torque, and there is no graze. */
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
    }
}

/* A saved pending event keeps the settings that were changed after it was found, in another instance, too. */
TEST(a_saved_pending_event_knows_its_settings) {
    fmi3Instance one = stand_at_lift_off(), other = new_stepper(true, true);
    update_answer updated;
    set_values(&fmi3, one, "hip.kp=0.0 hip.kd=0.0");
    assert_int_equal(copy_state(&fmi3, one, other), FMI_OK);
    assert_true(get_float(other, "hip.kp") == 0.0);
    assert_int_equal(update(other, &updated), fmi3OK);
    assert_int_equal(get_int(other, "contact.mode_index"), TDMF_CONTACT_FLIGHT);
}
