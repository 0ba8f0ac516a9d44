/* An importer in a few pages of C, to compare platforms: runs ten strides of a unit in Co-Simulation and in
 * Model Exchange and prints what it saw, to the last digit.
 *
 *     importer <library> <2|3> <guid> <reference of stride.count> <of stride.word> <of a Real>...
 *
 * Prints two lines: the interface, the word, and the Reals after ten strides. Its own integrator for Model
 * Exchange is the classical Runge-Kutta method with events located by bisection; it needs no function of the
 * mathematical library, so that platforms can differ by the unit only. */
#include "fmu_calls.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WANTED_STRIDES = 10, BISECTIONS = 50, MAX_STEPS = 1000000 };

static const double exchange_step = 1.0 / 64.0;
static const double communication_step = 0.125;

typedef struct {
    const fmu_calls *calls;
    void *instance;
    double time;
    double states[STATES];
    bool is_positive[INDICATORS]; /* each event indicator when the step began */
} run;

static void slope_at(const run *run, double elapsed, const double states[STATES], double slope[STATES]) {
    run->calls->set_time(run->instance, run->time + elapsed);
    run->calls->set_states(run->instance, states);
    run->calls->get_derivatives(run->instance, slope);
}

/* The states after a step of the classical Runge-Kutta method; the unit is left there. */
static void integrate(const run *run, double step, double end[STATES]) {
    static const double nodes[4] = {0.0, 0.5, 0.5, 1.0};
    static const double weights[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    double slope[STATES] = {0.0};
    double trial[STATES];
    memcpy(end, run->states, sizeof run->states);
    for (int stage = 0; stage < 4; ++stage) {
        for (int i = 0; i < STATES; ++i) {
            trial[i] = run->states[i] + nodes[stage] * step * slope[i];
        }
        slope_at(run, nodes[stage] * step, trial, slope);
        for (int i = 0; i < STATES; ++i) {
            end[i] += weights[stage] * step * slope[i];
        }
    }
    run->calls->set_time(run->instance, run->time + step);
    run->calls->set_states(run->instance, end);
}

static void begin_step(run *run) {
    double indicators[INDICATORS];
    run->calls->get_indicators(run->instance, indicators);
    for (int i = 0; i < INDICATORS; ++i) {
        run->is_positive[i] = indicators[i] > 0.0;
    }
}

/* True if an indicator has changed its sign since the step began. */
static bool event_is_due(const run *run) {
    double indicators[INDICATORS];
    run->calls->get_indicators(run->instance, indicators);
    for (int i = 0; i < INDICATORS; ++i) {
        if ((indicators[i] > 0.0) != run->is_positive[i]) {
            return true;
        }
    }
    return false;
}

/* A step, or what of it comes before the first event; true if there was one. */
static bool advance(run *run) {
    double end[STATES];
    double before = 0.0;
    double after = exchange_step;
    begin_step(run);
    integrate(run, after, end);
    const bool event = event_is_due(run);
    for (int i = 0; event && i < BISECTIONS; ++i) {
        const double middle = 0.5 * (before + after);
        integrate(run, middle, end);
        if (event_is_due(run)) {
            after = middle;
        } else {
            before = middle;
        }
    }
    integrate(run, after, end);
    memcpy(run->states, end, sizeof end);
    run->time += after;
    if (event) {
        run->calls->take_events(run->instance);
        run->calls->get_states(run->instance, run->states);
    }
    return event;
}

static void *exchange(const fmu_calls *calls, const char *guid, unsigned count) {
    run run = {calls, calls->make(true, guid), 0.0, {0.0}, {false}};
    calls->get_states(run.instance, run.states);
    for (long i = 0; i < MAX_STEPS; ++i) {
        if (advance(&run) && calls->integer(run.instance, count) == WANTED_STRIDES) {
            return run.instance;
        }
    }
    check(false, "ten strides of Model Exchange");
    return NULL;
}

static void *co_simulate(const fmu_calls *calls, const char *guid, unsigned count) {
    void *instance = calls->make(false, guid);
    for (long i = 0; i < MAX_STEPS; ++i) {
        calls->step(instance, (double)i * communication_step, communication_step);
        if (calls->integer(instance, count) == WANTED_STRIDES) {
            return instance;
        }
    }
    check(false, "ten strides of Co-Simulation");
    return NULL;
}

int main(int count, char **arguments) {
    if (count < 6) {
        fprintf(stderr,
                "importer: usage: importer library 2|3 guid count-reference word-reference reference...\n");
        return EXIT_FAILURE;
    }
    load_library(arguments[1]);
    const fmu_calls calls = arguments[2][0] == '2' ? calls_of_fmi2() : calls_of_fmi3();
    const unsigned strides = (unsigned)atoi(arguments[4]);
    const unsigned word = (unsigned)atoi(arguments[5]);
    for (int model_exchange = 0; model_exchange < 2; ++model_exchange) {
        void *instance = (model_exchange ? exchange : co_simulate)(&calls, arguments[3], strides);
        printf("%s %s", model_exchange ? "ModelExchange" : "CoSimulation", calls.text(instance, word));
        for (int i = 6; i < count; ++i) {
            printf(" %.17g", calls.real(instance, (unsigned)atoi(arguments[i])));
        }
        printf("\n");
        calls.free(instance);
    }
    return EXIT_SUCCESS;
}
