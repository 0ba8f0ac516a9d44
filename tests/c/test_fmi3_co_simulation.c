/* FMI 3.0 Co-Simulation: without event mode like FMI 2.0; with it, steps that end at an event, before it. */
#include "compare.h"
#include "fmi2_importer.h"
#include "fmi3_importer.h"
#include "fmi_interface.h"

#include "tdmf_slip/tdmf_slip.h"
#include "variables.h"

#include <math.h>
#include <string.h>

static const double period = 25.000146165488143; /* period of the gait at the default start */
static const double touchdown = 12.03;           /* time of its first touchdown, roughly */
static const double ten_strides = 251.0;

enum { EVENTS_OF_A_STRIDE = 9, MAX_EVENTS = 1000, STATES_COMPARED = 8 };
static const char *const state_names[STATES_COMPARED] = {
    "foot.x", "foot.y", "leg.length", "leg.angle", "foot.vx", "foot.vy", "leg.length_rate", "leg.angle_rate"};

/* Brings an instance into step mode at a time, through event mode. */
static fmi3Instance started(fmi3Instance instance, double time) {
    update_answer answer;
    initialize_unit_at(&fmi3, instance, time);
    assert_int_equal(update(instance, &answer), fmi3OK);
    assert_false(answer.needs_update || answer.states_changed);
    assert_int_equal(fmi3EnterStepMode(instance), fmi3OK);
    return instance;
}

static fmi3Instance eventful_stepper(void) {
    return started(new_stepper(true, true), 0.0);
}

static fmi3Instance plain_stepper(bool early_return) {
    fmi3Instance instance = new_stepper(false, early_return);
    initialize3(instance);
    return instance;
}

static step_answer step_from(fmi3Instance instance, double time, double step) {
    step_answer answer;
    assert_int_equal(do_step(instance, time, step, &answer), fmi3OK);
    return answer;
}

/* Enters event mode, sets the friction unless it is NAN, and updates. */
static update_answer update_with(fmi3Instance instance, double friction) {
    update_answer answer;
    assert_int_equal(fmi3EnterEventMode(instance), fmi3OK);
    if (!isnan(friction)) {
        assert_int_equal(set_float(instance, "ground.friction", friction), fmi3OK);
    }
    assert_int_equal(update(instance, &answer), fmi3OK);
    assert_false(answer.needs_update || answer.terminate);
    return answer;
}

static update_answer take_event(fmi3Instance instance, double friction) {
    const update_answer answer = update_with(instance, friction);
    assert_int_equal(fmi3EnterStepMode(instance), fmi3OK);
    return answer;
}

/* The time at which the foot has come to rest. */
static double run_until_it_sticks(fmi3Instance instance) {
    double time = 0.0;
    while (get_int(instance, "contact.mode") != TDMF_CONTACT_STICK) {
        time = step_from(instance, time, 20.0).time;
        take_event(instance, (double)NAN);
    }
    return time;
}

/* Runs in steps of a grid, stopping for every event; returns the number of events. */
static int run_by_events(fmi3Instance instance, double from, double to, double step) {
    int events = 0;
    double time = from;
    for (long i = 1; time < to; time = fmin(time, to)) {
        const double grid = from + (double)i * step;
        const step_answer answer = step_from(instance, time, grid - time);
        assert_true(answer.early == (answer.time < grid) && answer.event >= answer.early);
        time = answer.time;
        i += answer.early ? 0 : 1;
        events += answer.event ? 1 : 0;
        assert_true(events < MAX_EVENTS);
        if (answer.event) {
            take_event(instance, (double)NAN);
        }
    }
    return events;
}

/* ---- the same strides --------------------------------------------------------------------------------- */

TEST(without_event_mode_it_is_the_fmi2_unit) {
    fmi2Component old = new_slave();
    fmi3Instance plain = plain_stepper(true), eventful = started(new_stepper(true, false), 0.0);
    initialize(old);
    for (int i = 0; i < 26; ++i) {
        const double time = 10.0 * i;
        assert_int_equal(fmi2DoStep(old, time, 10.0, fmi2True), fmi2OK);
        const step_answer first = step_from(plain, time, 10.0), second = step_from(eventful, time, 10.0);
        assert_true(!first.event && !first.early && !first.terminate && first.time == time + 10.0);
        assert_true(!second.event && !second.early && second.time == time + 10.0);
    }
    for (int i = 0; i < STATES_COMPARED; ++i) {
        const double expected = get_real(old, state_names[i]);
        assert_true(get_float(plain, state_names[i]) == expected);
        assert_true(get_float(eventful, state_names[i]) == expected);
    }
    assert_int_equal(get_int(plain, "stride.count"), 10);
    assert_close(get_float(plain, "stride.period"), period, 1e-8);
}

TEST(stopping_at_every_event_changes_nothing) {
    static const double steps[] = {0.05, 1.0, 251.0};
    for (size_t i = 0; i < COUNT_OF(steps); ++i) {
        fmi3Instance plain = plain_stepper(false), eventful = eventful_stepper();
        const long count = lround(ten_strides / steps[i]);
        for (long j = 0; j < count; ++j) {
            step_from(plain, (double)j * steps[i], steps[i]);
        }
        assert_int_equal(run_by_events(eventful, 0.0, ten_strides, steps[i]), get_int(plain, "event.count"));
        assert_int_equal(get_int(eventful, "event.count"), get_int(plain, "event.count"));
        assert_int_equal(get_int(eventful, "stride.count"), 10);
        for (int k = 0; k < STATES_COMPARED; ++k) {
            assert_close(get_float(eventful, state_names[k]), get_float(plain, state_names[k]), 1e-9);
        }
        assert_close(get_float(eventful, "stride.period"), period, 1e-8);
    }
}

/* Clocks that count the seconds since 1970, and more coarsely yet. */
TEST(strides_stopped_at_events_do_not_depend_on_the_start_time) {
    static const double starts[] = {1.7e9, 1e13};
    static const char *const quantities[] = {"stride.period", "stride.length", "stride.stance_time",
                                             "stride.duty_factor", "stride.work"};
    for (size_t i = 0; i < COUNT_OF(starts); ++i) {
        fmi3Instance at_zero = eventful_stepper(), later = started(new_stepper(true, true), starts[i]);
        const int events = run_by_events(at_zero, 0.0, ten_strides, 0.5);
        assert_int_equal(run_by_events(later, starts[i], starts[i] + ten_strides, 0.5), events);
        assert_int_equal(get_int(later, "stride.word_code"), get_int(at_zero, "stride.word_code"));
        for (size_t k = 0; k < COUNT_OF(quantities); ++k) {
            assert_relatively_close(get_float(later, quantities[k]), get_float(at_zero, quantities[k]), 1e-9);
        }
    }
}

/* ---- events ------------------------------------------------------------------------------------------- */

TEST(the_left_limit_is_as_near_by_a_coarse_clock) {
    const double start = 1.7e9;
    fmi3Instance instance = started(new_stepper(true, true), start);
    const step_answer step = step_from(instance, start, 20.0);
    assert_true(step.event && step.early);
    assert_close(get_float(instance, "foot.y"), 0.0, 1e-11);
    assert_true(get_float(instance, "foot.vy") < -0.1);
    update_with(instance, 100.0);
    assert_true(get_float(instance, "foot.vy") == 0.0);
    assert_close(get_float(instance, "foot.y"), 0.0, 1e-11);
    assert_int_equal(get_int(instance, "contact.mode"), TDMF_CONTACT_STICK);
}

TEST(a_step_ends_at_the_event_and_before_it) {
    update_answer after;
    fmi3Instance instance = eventful_stepper();
    const step_answer step = step_from(instance, 0.0, 20.0);
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
    double time = 0.0;
    for (int i = 0; i < EVENTS_OF_A_STRIDE; ++i) {
        double body[4];
        const step_answer step = step_from(instance, time, 30.0);
        assert_true(step.event);
        time = step.time;
        for (int j = 0; j < 4; ++j) {
            body[j] = get_float(instance, names[j]);
        }
        take_event(instance, (double)NAN);
        for (int j = 0; j < 4; ++j) {
            assert_close(get_float(instance, names[j]), body[j], 1e-9);
        }
    }
    assert_int_equal(get_int(instance, "stride.count"), 1);
    assert_close(time, period, 1e-7);
    assert_true(get_float(instance, "apex.time") == time);
}

TEST(an_event_left_unhandled_is_taken_by_the_next_step) {
    fmi3Instance instance = eventful_stepper();
    const step_answer step = step_from(instance, 0.0, 20.0);
    assert_true(step.early);
    step_from(instance, step.time, 0.01);
    assert_int_equal(get_int(instance, "event.count"), 1);
}

/* The ground turns to ice in event mode, in mid-stance, while the foot sticks: it slips at once. */
TEST(inputs_jump_in_event_mode) {
    fmi3Instance instance = eventful_stepper();
    const step_answer step = step_from(instance, run_until_it_sticks(instance), 1e-3);
    assert_false(step.event);
    take_event(instance, 0.01);
    assert_int_not_equal(get_int(instance, "contact.mode"), TDMF_CONTACT_STICK);
    step_from(instance, step.time, 1e-3);
}

/* The friction changes while the event is handled: the velocity after the impact is that of the impact map
 * with the new friction. */
TEST(inputs_set_at_an_event_act_on_it) {
    static const double frictions[] = {0.0, 0.3, 0.6, 1.0, 10.0};
    for (size_t i = 0; i < COUNT_OF(frictions); ++i) {
        fmi3Instance instance = eventful_stepper();
        const double time = step_from(instance, 0.0, 20.0).time;
        const double vx = get_float(instance, "foot.vx"), vy = get_float(instance, "foot.vy");
        const double braked = fmax(0.0, vx - frictions[i] * fabs(vy));
        assert_true(take_event(instance, frictions[i]).states_changed);
        assert_close(get_float(instance, "foot.vx"), braked, 1e-9);
        assert_true(get_float(instance, "foot.vy") == 0.0);
        assert_int_equal(get_int(instance, "contact.mode"),
                         braked > 0.0 ? TDMF_CONTACT_SLIP_POSITIVE : TDMF_CONTACT_STICK);
        assert_int_equal(get_int(instance, "event.count"), 1);
        assert_true(get_float(instance, "time") == time && get_float(instance, "event.last_time") == time);
        step_from(instance, time, 1e-3);
    }
}

/* An apex that is taken with another friction than it was found with is latched at the time of the unit. The
 * time of a second search would be a rounding error later for a heavy runner. */
TEST(an_apex_taken_anew_has_the_time_of_its_event) {
    static const double starts[] = {0.0, 1.0, 1e3};
    for (size_t i = 0; i < COUNT_OF(starts); ++i) {
        fmi3Instance instance = new_stepper(true, true);
        set_values(&fmi3, instance, "gravity=10.0 foot.vy=5.0");
        const step_answer step = step_from(started(instance, starts[i]), starts[i], 30.0);
        assert_true(step.event && step.time > starts[i]);
        assert_int_equal(get_int(instance, "hip.phase"), TDMF_PHASE_RETRACT);
        update_with(instance, 0.7);
        assert_int_equal(get_int(instance, "hip.phase"), TDMF_PHASE_PLACE);
        assert_true(get_float(instance, "apex.time") == step.time);
        assert_true(get_float(instance, "event.last_time") == step.time);
        assert_true(get_float(instance, "time") == step.time);
    }
}

/* The foot would slip now, but the ground turns rough: it does not. */
TEST(an_event_may_be_averted) {
    fmi3Instance instance = eventful_stepper();
    const step_answer step = step_from(instance, run_until_it_sticks(instance), 20.0);
    const int events = get_int(instance, "event.count");
    assert_true(step.event);
    assert_int_equal(get_int(instance, "contact.mode"), TDMF_CONTACT_STICK);
    take_event(instance, 10.0);
    assert_int_equal(get_int(instance, "contact.mode"), TDMF_CONTACT_STICK);
    assert_int_equal(get_int(instance, "event.count"), events);
    assert_false(step_from(instance, step.time, 0.05).event);
}

TEST(a_fall_is_an_event_and_then_there_are_none) {
    fmi3Instance instance = new_stepper(true, true);
    assert_int_equal(set_float(instance, "foot.y", 100.0), fmi3OK);
    run_by_events(started(instance, 0.0), 0.0, 2000.0, 100.0);
    assert_true(truth_of(&fmi3, instance, "status.fallen"));
    const step_answer step = step_from(instance, 2000.0, 50.0);
    assert_true(!step.event && !step.terminate && step.time == 2050.0);
}

TEST(cvode_stops_at_events_too) {
    const fmi3ValueReference method = reference_of("solver.method");
    const fmi3Int64 cvode = SOLVER_CVODE;
    fmi3Instance instance = new_stepper(true, true);
    assert_int_equal(fmi3SetInt64(instance, &method, 1, &cvode, 1), fmi3OK);
    if (fmi3EnterInitializationMode(instance, false, 0.0, 0.0, false, 0.0) != fmi3OK ||
        fmi3ExitInitializationMode(instance) != fmi3OK) {
        assert_non_null(strstr(last_message, "SUNDIALS"));
        skip();
    }
    assert_int_equal(fmi3EnterStepMode(instance), fmi3OK);
    assert_int_equal(run_by_events(instance, 0.0, period + 0.01, period + 0.01), EVENTS_OF_A_STRIDE);
    assert_close(get_float(instance, "stride.period"), period, 1e-6);
    step_from(instance, period + 0.01, 1.0);
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
    double time = 0.0;
    for (int i = 0; i < MAX_EVENTS; ++i) {
        time = step_from(instance, time, 20.0 - time).time;
        if (get_int(instance, "hip.phase") == TDMF_PHASE_COAST && get_float(instance, "contact.fy") < 1e-6) {
            assert_int_equal(fmi3EnterEventMode(instance), fmi3OK);
            return instance;
        }
        take_event(instance, (double)NAN);
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
    fmi3Byte bytes[SERIALIZED_BYTES];
    update_answer updated;
    set_values(&fmi3, one, "hip.kp=0.0 hip.kd=0.0");
    const size_t size = save_bytes(&fmi3, one, bytes);
    assert_int_equal(restore_bytes(&fmi3, other, bytes, size), FMI_OK);
    assert_true(get_float(other, "hip.kp") == 0.0);
    assert_int_equal(update(other, &updated), fmi3OK);
    assert_int_equal(get_int(other, "contact.mode_index"), TDMF_CONTACT_FLIGHT);
}
