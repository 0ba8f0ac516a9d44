/* The derivative of a run by the damping of the leg, beside a difference quotient. */
#include <stdio.h>
#include <string.h>
#include <tdmf_slip/tdmf_slip.h>

static const double end = 14.0; /* s, in the first stance */

/* The height of the centre of mass at the end, and its derivative by leg.damping. */
static double height_at_end(double damping, double *by_damping) {
    tdmf_parameters parameters = tdmf_default_parameters();
    const tdmf_inputs inputs = tdmf_default_inputs();
    tdmf_solver solver = tdmf_solver_default();
    tdmf_motion motion = {.time = 0.0};
    tdmf_seed seed = {.parameters = {.leg = {.damping = 1.0}}};
    double start[TDMF_STATE_COUNT], unchanged[TDMF_STATE_COUNT] = {0.0}, rates[TDMF_STATE_COUNT];
    tdmf_variation variation;
    tdmf_outputs now, varied;
    tdmf_model model;
    const tdmf_system system = {&model, &inputs};

    parameters.leg.damping = damping;
    tdmf_default_state(start);
    memcpy(motion.state, start, sizeof start);
    tdmf_model_create(&model, &parameters);
    tdmf_start(system, &motion);
    tdmf_vary_start(system, start, &seed, unchanged, &variation);
    while (motion.time < end)
        tdmf_native_stride_varied(&solver, system, end, &motion, &seed, &variation, 1);
    tdmf_outputs_of(system, &motion, &now);
    tdmf_vary_outputs(system, &motion.mode, motion.state, &seed, &variation, rates, &varied);
    *by_damping = varied.com.y;
    return now.com.y;
}

int main(void) {
    const double step = 1e-5;
    double exact, unused;
    height_at_end(0.1, &exact);
    const double above = height_at_end(0.1 + step, &unused), below = height_at_end(0.1 - step, &unused);
    printf("d com.y / d leg.damping = %.5f, by differences %.5f\n", exact, (above - below) / (2.0 * step));
    return 0;
}
