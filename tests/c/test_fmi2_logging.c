/* Messages of the units of both FMI versions: their content, and when the units are silent. */
#include "compare.h"
#include "fmi2_importer.h"
#include "fmi3_importer.h"
#include "fmi_interface.h"

#include "guid.h"
#include "tdmf_slip/cvode.h"
#include "tdmf_slip/tdmf_slip.h"
#include "variables.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { EVENTS_OF_TEN_STRIDES = 90 };
static const double ten_strides = 251.0; /* the stop time of the default experiment */

/* ---- categories --------------------------------------------------------------------------------------- */

static const char *const errors_category[] = {"logStatusError"};
static const char *const discards_category[] = {"logStatusDiscard"};

static fmi2Component logging_instance(fmi2Boolean logging) {
    clear_messages();
    fmi2Component component =
        fmi2Instantiate("runner", fmi2CoSimulation, FMU_GUID, NULL, &importer_callbacks, fmi2False, logging);
    assert_non_null(component);
    return free_after_test(component, fmi2FreeInstance);
}

/* Messages of a call that is out of place, of one whose value is refused, and of a step over two events. */
typedef struct {
    int errors, discards, events;
} heard;

static heard listen(fmi2Component component) {
    heard result;
    const double time = get_real(component, "time");
    clear_messages();
    assert_int_equal(fmi2EnterInitializationMode(component), fmi2Error);
    result.errors = message_count;
    assert_int_equal(set_real(component, "ground.friction", -1.0), fmi2Discard);
    result.discards = message_count - result.errors;
    assert_int_equal(fmi2DoStep(component, time, 25.0, fmi2True), fmi2OK);
    result.events = message_count - result.errors - result.discards;
    return result;
}

static void assert_heard(fmi2Component component, bool errors, bool discards, bool events) {
    const heard result = listen(component);
    assert_int_equal(result.errors, errors ? 1 : 0);
    assert_int_equal(result.discards, discards ? 1 : 0);
    assert_true(events == (result.events > 0));
}

TEST(an_instance_made_without_logging_is_silent) {
    fmi2Component component = logging_instance(fmi2False);
    initialize(component);
    assert_heard(component, false, false, false);
    fmi3Instance instance = free_after_test(
        fmi3InstantiateModelExchange("runner", FMU_GUID, NULL, false, false, NULL, importer_logger),
        fmi3FreeInstance);
    assert_int_equal(fmi3SetTime(instance, 0.0), fmi3Error);
    assert_int_equal(set_float(instance, "body.mass", -1.0), fmi3Discard);
    assert_int_equal(message_count, 0);
}

/* "On" replaces the categories that an instance was made with; "off" switches one category off. */
TEST(categories_are_switched_on_and_off) {
    static const struct {
        bool begins, logging; /* a row that begins makes a new instance, with this logging */
        fmi2Boolean on;
        size_t count;
        const char *const *names;
        bool errors, discards, events;
    } calls[] = {{true, true, fmi2False, 0, NULL, false, false, false},
                 {false, true, fmi2True, 0, NULL, true, true, true},
                 {true, false, fmi2True, 1, errors_category, true, false, false},
                 {true, true, fmi2True, 1, errors_category, true, false, false},
                 {false, true, fmi2True, 1, events_category, true, false, true},
                 {false, true, fmi2True, 1, discards_category, true, true, true},
                 {false, true, fmi2False, 1, errors_category, false, true, true},
                 {true, false, fmi2False, 1, errors_category, false, false, false},
                 {true, true, fmi2False, 1, events_category, true, true, false}};
    fmi2Component component = NULL;
    for (size_t i = 0; i < COUNT_OF(calls); ++i) {
        if (calls[i].begins) {
            component = logging_instance(calls[i].logging);
            initialize(component);
            assert_heard(component, calls[i].logging, calls[i].logging, calls[i].logging);
        }
        assert_int_equal(fmi2SetDebugLogging(component, calls[i].on, calls[i].count, calls[i].names), fmi2OK);
        assert_heard(component, calls[i].errors, calls[i].discards, calls[i].events);
    }
}

TEST(unknown_categories_are_warned_of_and_the_others_taken) {
    static const char *const names[] = {"logEvents", "logWeather", NULL};
    fmi2Component component = logging_instance(fmi2True);
    initialize(component);
    assert_int_equal(fmi2SetDebugLogging(component, fmi2True, 2, names), fmi2Warning);
    assert_string_equal(last_message, "fmi2SetDebugLogging: there is no log category logWeather");
    assert_string_equal(last_category, "logStatusWarning");
    assert_heard(component, false, false, true);
    assert_int_equal(fmi2SetDebugLogging(component, fmi2True, 3, names), fmi2Warning);
    assert_int_equal(fmi2SetDebugLogging(component, fmi2True, 1, names + 1), fmi2Warning);
    assert_heard(component, false, false, true);

    fmi3Instance instance = new_exchange();
    assert_int_equal(fmi3SetDebugLogging(instance, true, 2, names), fmi3Warning);
    initialize3(instance);
}

/* ---- events ------------------------------------------------------------------------------------------- */

static double time_of(const char *message) {
    const char *at = strstr(message, " at ");
    assert_non_null(at);
    return strtod(at + 4, NULL);
}

static bool is_same_event(const char *a, const char *b) {
    const char *name = strstr(a, " at ");
    return strncmp(a, b, (size_t)(name - a)) == 0 && strcmp(strchr(a, ':'), strchr(b, ':')) == 0;
}

static fmi2Component stepped(fmi2Boolean logging, int method, double step) {
    const fmi2ValueReference reference = reference_of("solver.method");
    fmi2Component component = logging_instance(logging);
    assert_int_equal(fmi2SetInteger(component, &reference, 1, &method), fmi2OK);
    initialize(component);
    const int count = (int)lround(ten_strides / step);
    for (int i = 0; i < count; ++i) {
        assert_int_equal(fmi2DoStep(component, i * step, step, fmi2True), fmi2OK);
    }
    return component;
}

/* Ten strides in one step and in short steps: each event is reported once, in order, with its time. */
TEST(every_event_of_a_step_is_logged_with_its_time) {
    static const double steps[] = {251.0, 0.25};
    static char first[EVENTS_OF_TEN_STRIDES][MESSAGE_LENGTH];
    for (int i = 0; i < 2; ++i) {
        fmi2Component component = stepped(fmi2True, SOLVER_NATIVE, steps[i]);
        assert_int_equal(message_count, EVENTS_OF_TEN_STRIDES);
        assert_int_equal(get_whole(component, "event.count"), EVENTS_OF_TEN_STRIDES);
        assert_string_equal(last_category, "logEvents");
        for (int j = 0; j < EVENTS_OF_TEN_STRIDES; ++j) {
            assert_true(j == 0 || time_of(messages[j]) >= time_of(messages[j - 1]));
            if (i == 0) {
                strcpy(first[j], messages[j]);
            }
            assert_true(is_same_event(messages[j], first[j]));
            assert_close(time_of(messages[j]), time_of(first[j]), 1e-8);
        }
        assert_close(time_of(last_message), get_real(component, "event.last_time"), 1e-9);
    }
    assert_non_null(strstr(first[0], "touchdown at 12.0257"));
    assert_non_null(strstr(first[0], " s: flight, place -> slip_positive, drive"));
    assert_non_null(strstr(first[8], "apex at 25.000146165"));
}

/* An event that the importer takes gives the same message as one that the unit takes itself. */
TEST(an_event_is_reported_alike_in_event_mode) {
    static char expected[EVENTS_OF_TEN_STRIDES][MESSAGE_LENGTH];
    stepped(fmi2True, SOLVER_NATIVE, ten_strides);
    memcpy(expected, messages, sizeof expected);
    fmi3Instance instance = begun(&fmi3, STEPS_WITH_EVENTS, "");
    assert_int_equal(fmi3SetDebugLogging(instance, true, 0, NULL), fmi3OK);
    assert_int_equal(run_to(&fmi3, instance, ten_strides, ten_strides), EVENTS_OF_TEN_STRIDES);
    assert_int_equal(message_count, EVENTS_OF_TEN_STRIDES);
    for (int i = 0; i < EVENTS_OF_TEN_STRIDES; ++i) {
        assert_true(is_same_event(messages[i], expected[i]));
        assert_close(time_of(messages[i]), time_of(expected[i]), 1e-8);
    }
}

TEST(logging_changes_no_bit_of_a_run) {
    for (int method = SOLVER_NATIVE; method <= SOLVER_CVODE; ++method) {
        if (method == SOLVER_CVODE && !tdmf_cvode_is_available()) {
            continue;
        }
        fmi2Component silent = stepped(fmi2False, method, ten_strides);
        fmi2Component talking = stepped(fmi2True, method, ten_strides);
        assert_int_equal(message_count, EVENTS_OF_TEN_STRIDES);
        assert_same_states(&fmi2, silent, &fmi2, talking, 0.0);
        assert_true(get_real(silent, "hip.work") == get_real(talking, "hip.work"));
        assert_int_equal(get_whole(silent, "solver.steps"), get_whole(talking, "solver.steps"));
    }
}

/* A logged step runs in portions of events; the silent step after it has no such limit. */
TEST(a_silent_step_after_a_logged_one_goes_as_far) {
    fmi2Component component = stepped(fmi2True, SOLVER_NATIVE, ten_strides);
    assert_int_equal(fmi2SetDebugLogging(component, fmi2False, 0, NULL), fmi2OK);
    assert_int_equal(fmi2DoStep(component, ten_strides, ten_strides, fmi2True), fmi2OK);
    assert_int_equal(message_count, EVENTS_OF_TEN_STRIDES);
    assert_int_equal(get_whole(component, "event.count"), 2 * EVENTS_OF_TEN_STRIDES);
}

/* The driver runs in portions of steps, which share one log of events. The leg is damped so stiffly that one
 * portion ends between both events. */
TEST(events_among_very_many_steps_are_logged_once) {
    fmi2Component component = logging_instance(fmi2True);
    set_values(&fmi2, component,
               "leg.damping=1530 ground.friction=10 hip.stance_torque=0 leg.angle=0 leg.angle_rate=0 "
               "leg.length_rate=0 foot.vx=0 foot.vy=0 foot.y=0.01");
    initialize(component);
    assert_int_equal(fmi2DoStep(component, 0.0, 15.0, fmi2True), fmi2OK);
    assert_true(get_whole(component, "solver.steps") > 30000);
    assert_int_equal(message_count, 2);
    assert_true(strncmp(messages[0], "touchdown at 6.564", 18) == 0);
    assert_non_null(strstr(messages[0], " s: flight, place -> stick, drive"));
    assert_true(strncmp(messages[1], "slip_onset_negative at 12.230", 29) == 0);
    assert_non_null(strstr(messages[1], " s: stick, drive -> slip_negative, drive"));
}

TEST(an_input_that_jumps_between_steps_makes_an_event_too) {
    fmi2Component component = logging_instance(fmi2True);
    initialize(component);
    for (int i = 0; get_whole(component, "contact.mode") != TDMF_CONTACT_STICK; ++i) {
        assert_true(i < 300);
        assert_int_equal(fmi2DoStep(component, 0.05 * i, 0.05, fmi2True), fmi2OK);
    }
    const double time = get_real(component, "time");
    clear_messages();
    set_values(&fmi2, component, "ground.friction=0.01");
    assert_int_equal(fmi2DoStep(component, time, 1e-6, fmi2True), fmi2OK);
    assert_int_equal(message_count, 1);
    assert_true(strncmp(last_message, "slip_onset_", 11) == 0);
    assert_close(time_of(last_message), time, 1e-9);
}

/* Changes a runner on or off the ground by hand in Model Exchange, and goes through event mode there. */
static void update_with(fmi2Component component, const char *name, double value) {
    fmi2EventInfo info;
    assert_int_equal(fmi2SetTime(component, 0.5), fmi2OK); /* no part of the start */
    assert_int_equal(set_real(component, name, value), fmi2OK);
    clear_messages();
    assert_int_equal(fmi2EnterEventMode(component), fmi2OK);
    assert_int_equal(fmi2NewDiscreteStates(component, &info), fmi2OK);
}

TEST(every_guard_gives_its_event_its_name) {
    static const struct {
        const char *name, *changed;
        double value, foot_y, foot_vx, foot_vy;
        const char *text;
    } cases[] = {
        {"touchdown", "foot.y", -1e-12, 0.5, 0.0, -0.4, "touchdown at 0.5 s: flight, place -> "},
        {"apex", "foot.vy", -0.5, 0.5, 0.0, 1.0, "flight, retract -> flight, place"},
        {"lift_off", "leg.length", 1.5, 0.0, 0.0, 0.0, "stick, drive -> "},
        {"mid_stance", "leg.angle", -1e-3, 0.0, 0.0, 0.0, "stick, drive -> stick, coast"},
        {"slip_velocity_zero", "foot.vx", -1e-6, 0.0, 0.5, 0.0, "slip_positive, drive -> "},
        {"slip_onset_", "ground.friction", 0.0, 0.0, 0.0, 0.0, "stick, drive -> slip_"},
        {"body_down", "leg.angle", 2.0, 0.0, 0.0, 0.0, ", fallen"},
        {"leg_too_short", "leg.length", 0.01, 0.0, 0.0, 0.0, ", fallen"},
    };
    for (size_t i = 0; i < COUNT_OF(cases); ++i) {
        fmi2EventInfo info;
        fmi2Component component = new_instance();
        assert_int_equal(fmi2SetDebugLogging(component, fmi2True, 1, events_category), fmi2OK);
        set_values(&fmi2, component, "ground.friction=10.0"); /* the foot at rest sticks */
        assert_int_equal(set_real(component, "foot.y", cases[i].foot_y), fmi2OK);
        assert_int_equal(set_real(component, "foot.vx", cases[i].foot_vx), fmi2OK);
        assert_int_equal(set_real(component, "foot.vy", cases[i].foot_vy), fmi2OK);
        set_values(&fmi2, component, "leg.length=0.8 leg.angle=0.2 leg.angle_rate=-0.1");
        start_running(component);
        update_with(component, cases[i].changed, cases[i].value);
        if (message_count != 1 || strncmp(last_message, cases[i].name, strlen(cases[i].name)) != 0 ||
            strstr(last_message, cases[i].text) == NULL) {
            fail_msg("expected %s, found %s", cases[i].name, last_message);
        }
        assert_int_equal(fmi2NewDiscreteStates(component, &info), fmi2OK);
        assert_int_equal(message_count, 1);
    }
}

/* A foot below the ground that moves up got there by rounding: lifting it is not an event. A landing that
 * throws the foot off again at once is an event, although the mode is the same before and after. */
TEST(what_is_an_event_does_not_go_by_the_modes_alone) {
    for (int i = 0; i < 2; ++i) {
        const double vy = i == 0 ? 1e-3 : -1e-3;
        fmi2Component component = new_instance();
        assert_int_equal(fmi2SetDebugLogging(component, fmi2True, 1, events_category), fmi2OK);
        set_values(&fmi2, component, "foot.y=0.5");
        assert_int_equal(set_real(component, "foot.vy", vy), fmi2OK);
        set_values(&fmi2, component, "leg.length=1.5 leg.angle=0.1 leg.angle_rate=0.0 leg.length_rate=-0.5");
        start_running(component);
        assert_int_equal(get_whole(component, "hip.phase"), TDMF_PHASE_PLACE);
        update_with(component, "foot.y", i == 0 ? -1e-12 : -1e-11);
        assert_int_equal(get_whole(component, "contact.mode"), TDMF_CONTACT_FLIGHT);
        assert_int_equal(get_whole(component, "event.count"), i);
        assert_int_equal(message_count, i);
        assert_true(i == 0 || strstr(last_message, " s: flight, place -> flight, place") != NULL);
    }
}
