/* The run that the page shows: started, advanced with samples for its plots, read. */
#include "values.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A sample of the run. Where something jumps there are two of the same time. */
enum {
    SAMPLE_TIME,
    SAMPLE_FOOT_X,
    SAMPLE_VELOCITY, /* of the foot along the ground */
    SAMPLE_TANGENTIAL,
    SAMPLE_NORMAL,
    SAMPLE_MODE,
    SAMPLE_SIZE,
    SAMPLE_CAPACITY = 4096,
    ADVANCES_PER_CALL = 2000
};

static tdmf_motion motion;
static double start_state[TDMF_STATE_COUNT];
static double samples[SAMPLE_CAPACITY][SAMPLE_SIZE];
static int sample_count;

/* Mechanical states at which a run begins. */
LIVE_EXPORT(live_state)
double *live_state_address(void) {
    return start_state + TDMF_FOOT_X;
}

LIVE_EXPORT(live_samples)
double *live_samples_address(void) {
    return &samples[0][0];
}

/* Number of samples that the last call of live_advance wrote. */
LIVE_EXPORT(live_sample_count)
int live_samples_counted(void) {
    return sample_count;
}

/* Writes the state at the apex in the section; its foot is at x = 0. */
LIVE_EXPORT(live_state_at_section)
void live_state_at_section(void) {
    tdmf_section_state(live_system(), live.section, start_state);
}

/* Writes the section that has the height above the ground, the forward speed and the leg of the state. */
LIVE_EXPORT(live_section_at_state)
void live_section_at_state(void) {
    const tdmf_ground_line line = tdmf_ground_line_of(live.inputs.ground.height, live.inputs.ground.slope);
    tdmf_section_of_state(&live.model, &line, start_state, live.section);
}

/* Begins a run at time 0. Where it is refused, the run before stays as it is, and the message says why. */
LIVE_EXPORT(live_start)
bool live_start(void) {
    tdmf_motion next = {.time = 0.0};
    memcpy(next.state, start_state, sizeof next.state);
    const tdmf_refusal refusal = tdmf_start(live_system(), &next);
    if (live_refused(&refusal)) {
        return false;
    }
    motion = next;
    sample_count = 0;
    return true;
}

/* Goes on with the values that live_accept took last, as after a jump of an input. */
LIVE_EXPORT(live_go_on)
void live_go_on(void) {
    if (!motion.mode.fallen) {
        tdmf_resolve(live_system(), &motion);
    }
}

static void sample(const tdmf_motion *at) {
    const tdmf_ground_line *ground = &at->mode.ground;
    tdmf_outputs now;
    if (sample_count == SAMPLE_CAPACITY) {
        return;
    }
    tdmf_outputs_of(live_system(), at, &now);
    double *row = samples[sample_count++];
    row[SAMPLE_TIME] = at->time;
    row[SAMPLE_FOOT_X] = at->state[TDMF_FOOT_X];
    row[SAMPLE_VELOCITY] = ground->cosine * at->state[TDMF_FOOT_VX] + ground->sine * at->state[TDMF_FOOT_VY];
    row[SAMPLE_TANGENTIAL] = now.contact.tangential;
    row[SAMPLE_NORMAL] = now.contact.normal;
    row[SAMPLE_MODE] = at->mode.contact;
}

static void sample_events(const tdmf_event_log *log) {
    for (int i = 0; i < log->count && i < TDMF_EVENT_CAPACITY; ++i) {
        const tdmf_event *event = &log->events[i];
        tdmf_motion before = {.time = event->time, .mode = event->before};
        memcpy(before.state, event->state, sizeof before.state);
        sample(&before);
    }
}

/* Advances to a time, or to the next event, whichever comes first; samples the end, and both sides of an
 * event. */
static tdmf_outcome advance_to_event(double until, bool *event) {
    tdmf_event_log log = {.count = 0};
    tdmf_solver solver = tdmf_solver_default();
    solver.log = &log;
    solver.event_limit = 1;
    const tdmf_outcome outcome = tdmf_native_advance(&solver, live_system(), NULL, until, &motion);
    sample_events(&log);
    sample(&motion);
    *event = outcome == TDMF_TOO_MANY_EVENTS;
    return *event ? TDMF_ARRIVED : outcome;
}

/* Advances to a time, stopping after the first event if asked, and before where that is far. On the ground a
 * sample is taken at least every `interval`. Gives the tdmf_outcome; but for arrival and fall, the message
 * says what went wrong. */
LIVE_EXPORT(live_advance)
int live_advance(double until, double interval, bool to_event) {
    tdmf_outcome outcome = TDMF_ARRIVED;
    sample_count = 0;
    live.message[0] = '\0';
    for (int i = 0; i < ADVANCES_PER_CALL && outcome == TDMF_ARRIVED && motion.time < until; ++i) {
        const bool flies = motion.mode.contact == TDMF_CONTACT_FLIGHT;
        bool event = false;
        outcome = advance_to_event(flies ? until : fmin(until, motion.time + interval), &event);
        if (event && to_event) {
            break;
        }
    }
    if (outcome != TDMF_ARRIVED && outcome != TDMF_FELL) {
        snprintf(live.message, sizeof live.message, "The run stopped: %s.", tdmf_outcome_text(outcome));
    }
    return (int)outcome;
}

static const tdmf_outputs *read_outputs(void) {
    static tdmf_outputs outputs;
    tdmf_outputs_of(live_system(), &motion, &outputs);
    return &outputs;
}

/* Fills the outputs with those of the present instant. */
LIVE_EXPORT(live_read)
void live_read(void) {
    live_write_outputs(read_outputs(), motion.state);
}

LIVE_EXPORT(live_time)
double live_time(void) {
    return motion.time;
}

/* Word of the last completed stride. */
LIVE_EXPORT(live_word)
const char *live_word(void) {
    return read_outputs()->stride.word;
}

/* Word of the stride under way; a contact joins it when it ends. */
LIVE_EXPORT(live_open_word)
const char *live_open_word(void) {
    return read_outputs()->open_word;
}

/* The line that is in force: y = height + x tan(slope). */
LIVE_EXPORT(live_ground_height)
double live_ground_height(void) {
    return motion.mode.ground.height;
}

LIVE_EXPORT(live_ground_slope)
double live_ground_slope(void) {
    return motion.mode.ground.slope;
}

/* sqrt(m/k), s. */
LIVE_EXPORT(live_time_scale)
double live_time_scale(void) {
    return live.model.scales.time;
}
