/* A run sampled in time: friction ramps down, a push begins, and the run goes on from a saved copy. */
#include <stdio.h>
#include <string.h>
#include <tdmf_slip/tdmf_slip.h>

static void print_event(void *subject, const tdmf_event *event) {
    ++*(int *)subject;
    printf("  event at %.4f s: contact %d to %d\n", event->time, event->before.contact, event->after.contact);
}

int main(void) {
    tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_inputs inputs = tdmf_default_inputs(),
                rates = {{0.0, 0.0, 0.0}, {0.0}, {0.0}, {0.0, 0.0}, {0.0, 0.0, 0.0}};
    tdmf_solver solver = tdmf_solver_default();
    tdmf_motion motion = {.time = 0.0}, saved;
    double guards[TDMF_GUARD_COUNT]; /* pure numbers, positive until their events */
    tdmf_outputs now;
    tdmf_model model;
    const tdmf_system system = {&model, &inputs};
    int events = 0;

    rates.ground.friction = -0.001; /* per second */
    tdmf_default_state(motion.state);
    if (tdmf_model_create(&model, &parameters).code != TDMF_ACCEPTED ||
        tdmf_check_inputs(&inputs).code != TDMF_ACCEPTED || tdmf_start(system, &motion).code != TDMF_ACCEPTED)
        return 1;
    solver.on_event = print_event;
    solver.subject = &events;
    for (int i = 1; i <= 5; ++i) {
        const tdmf_outcome outcome = tdmf_native_advance(&solver, system, &rates, 5.0 * i, &motion);
        if (outcome != TDMF_ARRIVED) {
            fprintf(stderr, "%s\n", tdmf_outcome_text(outcome));
            return 1;
        }
        inputs = tdmf_inputs_after(&inputs, &rates, 5.0);
        tdmf_outputs_of(system, &motion, &now);
        printf("t = %.0f, x = %.4f, y = %.4f, normal force %.4f\n", motion.time, now.com.x, now.com.y,
               now.contact.normal);
    }

    saved = motion;                  /* a motion holds no pointer: a copy is a checkpoint */
    tdmf_observe(system, &motion);   /* before an input jumps */
    inputs.body.external_fx = 0.001; /* N */
    tdmf_resolve(system, &motion);   /* after it: a foot may begin to slip at once */
    solver.on_event = NULL;
    tdmf_native_advance(&solver, system, NULL, 50.0, &motion);
    inputs.body.external_fx = 0.0;
    tdmf_native_advance(&solver, system, NULL, 50.0, &saved);
    printf("%d events; pushed, the foot is %.3f m ahead at t = 50\n", events,
           motion.state[TDMF_FOOT_X] - saved.state[TDMF_FOOT_X]);
    tdmf_guards(system, &motion.mode, motion.state, guards);
    printf("the guard of the touchdown is %.3f there\n", guards[TDMF_GUARD_TOUCHDOWN]);
    printf("by tdmf_slip %s, compiled by %s\n", tdmf_version(), tdmf_compiler());
    return 0;
}
