/* A C program against the installed library: drops the default runner, by Euler steps, to its first
 * touchdown. */
#include <stdio.h>
#include <tdmf_slip/tdmf_slip.h>

int main(void) {
    tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_inputs inputs = tdmf_default_inputs();
    tdmf_model model;
    const tdmf_system system = {&model, &inputs};
    tdmf_refusal refusal = tdmf_model_create(&model, &parameters);
    double step = 1e-4, rate[TDMF_STATE_COUNT], guards[TDMF_GUARD_COUNT];
    tdmf_motion motion = {.time = 0.0};
    char text[256];

    tdmf_default_state(motion.state);
    if (refusal.variable == NULL)
        refusal = tdmf_start(system, &motion);
    if (refusal.variable != NULL) {
        fprintf(stderr, "%s\n", tdmf_refusal_text(&refusal, text, sizeof text));
        return 1;
    }
    tdmf_guards(system, &motion.mode, motion.state, guards); /* pure numbers, positive until their events */
    while (motion.mode.contact == TDMF_CONTACT_FLIGHT && motion.time < 100.0) {
        tdmf_derivatives(system, &motion.mode, motion.state, rate);
        for (int i = 0; i < TDMF_STATE_COUNT; ++i)
            motion.state[i] += step * rate[i];
        motion.time += step;
        tdmf_resolve(system, &motion);
    }
    printf("tdmf_slip %s: touchdown at t = %.3f, its guard was %.3f\n", tdmf_version(), motion.time,
           guards[TDMF_GUARD_TOUCHDOWN]);
    printf("the library was compiled by %s\n", tdmf_compiler());
    return 0;
}
