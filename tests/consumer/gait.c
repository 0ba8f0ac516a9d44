/* The default runner's gait: the fixed point of its return map, its Jacobian and its eigenvalues. */
#include <stdio.h>
#include <string.h>
#include <tdmf_slip/tdmf_slip.h>

/* The largest eigenvalue by size, of a stride with derivatives: below 1 for a stable gait. */
static double largest_eigenvalue(const tdmf_return *stride) {
    double jacobian[TDMF_SECTION_COUNT][TDMF_SECTION_COUNT], pairs[2 * TDMF_SECTION_COUNT];
    for (int row = 0; row < TDMF_SECTION_COUNT; ++row)
        for (int column = 0; column < TDMF_SECTION_COUNT; ++column)
            jacobian[row][column] = stride->variations[column].apex[row];
    return tdmf_eigenvalues(TDMF_SECTION_COUNT, &jacobian[0][0], pairs) ? pairs[0] : 1.0;
}

int main(void) {
    const tdmf_parameters parameters = tdmf_default_parameters();
    const tdmf_inputs inputs = tdmf_default_inputs();
    const tdmf_ground_line ground = tdmf_ground_line_of(inputs.ground.height, inputs.ground.slope);
    tdmf_solver solver = tdmf_solver_default();
    tdmf_model model;
    double state[TDMF_STATE_COUNT], apex[TDMF_SECTION_COUNT], scales[TDMF_SECTION_COUNT];
    tdmf_stride_request request;
    tdmf_orbit gait;
    tdmf_return next;

    memset(&request, 0, sizeof request);
    request.solver = &solver;
    request.system.model = &model;
    request.system.inputs = &inputs;
    request.apex = apex;
    if (tdmf_model_create(&model, &parameters).code != TDMF_ACCEPTED)
        return 1;
    tdmf_default_state(state);
    tdmf_section_of_state(&model, &ground, state, apex);
    apex[TDMF_SECTION_COM_SPEED] += 0.02; /* a guess */
    printf("%d strides closed on the way to the gait\n", tdmf_settle(&request, 20, apex));
    tdmf_find_orbit(&request, &gait);
    if (gait.outcome != TDMF_ORBIT_FOUND) {
        fprintf(stderr, "%s\n", tdmf_return_outcome_text(gait.stride.outcome));
        return 1;
    }
    tdmf_section_scales(&model, scales);
    printf("%s at %.6f m/s, largest eigenvalue %.4f, %.4f l0 high\n", gait.stride.stride.word,
           gait.stride.stride.speed, largest_eigenvalue(&gait.stride),
           gait.apex[TDMF_SECTION_COM_HEIGHT] / scales[TDMF_SECTION_COM_HEIGHT]);
    tdmf_section_state(request.system, gait.apex, state); /* as tdmf_start takes it */
    printf("the foot is %.4f m above the ground\n", state[TDMF_FOOT_Y]);

    request.map = TDMF_REDUCED_MAP;
    request.apex = gait.apex;
    tdmf_run_stride(&request, &next);
    tdmf_reduced_state(request.system, next.apex, state);
    printf("reduced map: from %.4f to %.4f m/s, %s; the leg at %.4f rad\n", gait.apex[TDMF_SECTION_COM_SPEED],
           next.apex[TDMF_SECTION_COM_SPEED], tdmf_return_outcome_text(next.outcome), state[TDMF_LEG_ANGLE]);

    apex[TDMF_SECTION_LEG_LENGTH] = -1.0; /* a refusal names what was refused */
    request.map = TDMF_RETURN_MAP;
    request.apex = apex;
    tdmf_run_stride(&request, &next);
    char text[128];
    printf("%s\n", tdmf_refusal_text(&next.refusal, text, sizeof text));
    return 0;
}
