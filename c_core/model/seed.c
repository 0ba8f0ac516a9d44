/* Seeds, along which variations are taken. */
#include "seed.h"

const tdmf_local_seed tdmf_no_seed = {.state = NULL};

tdmf_local_seed tdmf_local_seed_of(const tdmf_model *model, const tdmf_seed *seed,
                                   const tdmf_variation *variation) {
    static const tdmf_seed unchanged = {0};
    static const tdmf_variation unvaried = {0};
    const tdmf_seed *given = seed != NULL ? seed : &unchanged;
    const tdmf_variation *varied = variation != NULL ? variation : &unvaried;
    const tdmf_local_seed local = {
        .model = tdmf_vary_model(model, &given->parameters),
        .inputs = given->inputs,
        /* The line in force changes with the one that is set. */
        .mode = {.liftoff_angle = varied->liftoff_angle,
                 .ground = {.height = given->inputs.ground.height, .slope = given->inputs.ground.slope}},
        .state = varied->state,
    };
    return local;
}
