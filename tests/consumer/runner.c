/* A C program against the installed library: drops the default runner, by Euler steps, to its first
 * touchdown. */
#include <stdio.h>
#include <tdmf_slip/tdmf_slip.h>

int main(void) {
    tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_inputs inputs = tdmf_default_inputs();
    tdmf_model model;
    tdmf_refusal refusal = tdmf_model_create(&model, &parameters);
    double time = 0.0, step = 1e-4, state[TDMF_STATE_COUNT], rate[TDMF_STATE_COUNT];
    tdmf_mode mode;
    tdmf_record record;
    char text[256];

    tdmf_default_state(state);
    if (refusal.variable == NULL)
        refusal = tdmf_start(&model, &inputs, time, state, &mode, &record);
    if (refusal.variable != NULL) {
        fprintf(stderr, "%s\n", tdmf_refusal_text(&refusal, text, sizeof text));
        return 1;
    }
    while (mode.contact == TDMF_CONTACT_FLIGHT && time < 100.0) {
        tdmf_derivatives(&model, &inputs, &mode, state, rate);
        for (int i = 0; i < TDMF_STATE_COUNT; ++i)
            state[i] += step * rate[i];
        time += step;
        tdmf_resolve(&model, &inputs, time, state, &mode, &record);
    }
    printf("tdmf_slip %s: touchdown at t = %.3f\n", tdmf_version(), time);
    return 0;
}
