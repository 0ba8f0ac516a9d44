#include <stdio.h>
#include <tdmf_slip/tdmf_slip.h>

int main(void) {
    tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_inputs inputs = tdmf_default_inputs();
    tdmf_solver solver = tdmf_solver_default();
    tdmf_motion motion = {.time = 0.0};
    tdmf_model model;
    const tdmf_system system = {&model, &inputs};

    inputs.ground.friction = 0.43;
    parameters.leg.damping = 0.2;
    tdmf_default_state(motion.state);
    if (tdmf_model_create(&model, &parameters).variable != NULL ||
        tdmf_start(system, &motion).variable != NULL)
        return 1; /* tdmf_refusal_text describes what is out of range */

    const tdmf_stride *stride = &motion.record.stride; /* the last completed stride */
    while (stride->count < 300 && tdmf_native_stride(&solver, system, 1e5, &motion).closed)
        continue;
    printf("%s, speed %.6f, cost of transport %.6f\n", stride->word, stride->speed,
           stride->cost_of_transport);
    return 0;
}
