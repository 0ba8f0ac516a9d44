/* Directions of differentiation. */
#include "direction.h"

tdmf_direction tdmf_direction_of(const tdmf_model *model, const tdmf_change *change,
                                 const tdmf_variation *variation) {
    static const tdmf_change unchanged = {0};
    static const tdmf_variation unvaried = {0};
    const tdmf_change *given = change != NULL ? change : &unchanged;
    const tdmf_variation *varied = variation != NULL ? variation : &unvaried;
    const tdmf_direction direction = {
        .model = tdmf_vary_model(model, &given->parameters),
        .inputs = given->inputs,
        /* The line in force changes with the one that is set. */
        .mode = {.liftoff_angle = varied->liftoff_angle,
                 .ground = {.height = given->inputs.ground.height, .slope = given->inputs.ground.slope}},
        .state = varied->state,
    };
    return direction;
}

tdmf_direction tdmf_direction_of_motion(const double derivatives[TDMF_STATE_COUNT]) {
    const tdmf_direction direction = {.state = derivatives};
    return direction;
}
