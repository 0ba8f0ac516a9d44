/* Your own solver: classical Runge-Kutta steps, events located by bisection. */
#include <stdio.h>
#include <string.h>
#include <tdmf_slip/tdmf_slip.h>

typedef struct {
    tdmf_model model;
    tdmf_inputs inputs;
    tdmf_motion motion;
} run;

static tdmf_system system_of(const run *r) {
    const tdmf_system system = {&r->model, &r->inputs};
    return system;
}

static void shift(const double from[], double step, const double rate[], double to[]) {
    for (int i = 0; i < TDMF_STATE_COUNT; ++i)
        to[i] = from[i] + step * rate[i];
}

/* State after a step in the present mode, without looking for events. */
static void runge_kutta(const run *r, double step, double after[TDMF_STATE_COUNT]) {
    const double *state = r->motion.state, share[4] = {0.0, 0.5, 0.5, 1.0};
    double rate[4][TDMF_STATE_COUNT], point[TDMF_STATE_COUNT];
    for (int stage = 0; stage < 4; ++stage) {
        shift(state, share[stage] * step, rate[stage > 0 ? stage - 1 : 0], point);
        tdmf_derivatives(system_of(r), &r->motion.mode, stage > 0 ? point : state, rate[stage]);
    }
    for (int i = 0; i < TDMF_STATE_COUNT; ++i)
        after[i] = state[i] + step / 6.0 * (rate[0][i] + 2.0 * rate[1][i] + 2.0 * rate[2][i] + rate[3][i]);
}

static bool is_due(const run *r, const double state[TDMF_STATE_COUNT]) {
    return tdmf_first_due(system_of(r), &r->motion.mode, state) != TDMF_GUARD_COUNT;
}

/* Advance by a step, or to the first event in it, and take the event. */
static void advance(run *r, double step) {
    double after[TDMF_STATE_COUNT], before = 0.0;
    runge_kutta(r, step, after);
    if (is_due(r, after)) {
        while (step - before > 1e-13) {
            double middle = 0.5 * (before + step);
            runge_kutta(r, middle, after);
            *(is_due(r, after) ? &step : &before) = middle;
        }
        runge_kutta(r, step, after);
    }
    memcpy(r->motion.state, after, sizeof after);
    r->motion.time += step;
    tdmf_resolve(system_of(r), &r->motion);
}

int main(void) {
    run r = {.inputs = tdmf_default_inputs()};
    tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_outputs now;
    tdmf_default_state(r.motion.state);
    tdmf_refusal refusal = tdmf_model_create(&r.model, &parameters);
    if (refusal.variable == NULL)
        refusal = tdmf_start(system_of(&r), &r.motion);
    if (refusal.variable != NULL) {
        char text[256];
        fprintf(stderr, "%s\n", tdmf_refusal_text(&refusal, text, sizeof text));
        return 1;
    }
    while (r.motion.state[TDMF_STRIDE_COUNT] < 10.0 && !r.motion.mode.fallen)
        advance(&r, 0.002);
    tdmf_outputs_of(system_of(&r), &r.motion, &now);
    printf("%d strides, the last %s at speed %.6f, t = %.6f\n", now.stride.count, now.stride.word,
           now.stride.speed, r.motion.time);
    return 0;
}
