#include <stdio.h>
#include <tdmf_slip/tdmf_slip.h>

int main(void) {
    tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_inputs inputs = tdmf_default_inputs();
    tdmf_solver solver = tdmf_solver_default();
    tdmf_motion motion = {.time = 0.0};
    tdmf_outputs now;
    tdmf_model model;
    const tdmf_system system = {&model, &inputs};

    inputs.ground.friction = 0.43;
    parameters.leg.damping = 0.2;
    tdmf_default_state(motion.state);
    if (tdmf_model_create(&model, &parameters).variable != NULL ||
        tdmf_start(system, &motion).variable != NULL)
        return 1; /* tdmf_refusal_text describes what is out of range */

    while (motion.state[TDMF_STRIDE_COUNT] < 300.0 &&
           tdmf_native_stride(&solver, system, 1e5, &motion).closed)
        continue;
    tdmf_outputs_of(system, &motion, &now); /* among them the last completed stride */
    printf("%s, speed %.6f, cost of transport %.6f\n", now.stride.word, now.stride.speed,
           now.stride.cost_of_transport);
    return 0;
}
