/* A seed in all that a runner's motion depends on at an instant: it has the shapes of what it varies. */
#ifndef TDMF_MODEL_SEED_H
#define TDMF_MODEL_SEED_H

#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"
#include "tdmf_slip/variation.h"

typedef struct {
    tdmf_model model; /* parameters and what is derived from them; the scales do not change */
    tdmf_inputs inputs;
    tdmf_mode mode; /* of its members only the lift-off angle and the ground's height and slope change */
    const double *state;
} tdmf_local_seed;

/* Varies the parameters and all constants that are derived from them. */
tdmf_model tdmf_vary_model(const tdmf_model *model, const tdmf_parameters *seed);

/* Either may be NULL: it does not change. The variation's state is not copied. */
tdmf_local_seed tdmf_local_seed_of(const tdmf_model *model, const tdmf_seed *seed,
                                   const tdmf_variation *variation);

/* The seed of what the state alone changes, which is handed on beside it. */
extern const tdmf_local_seed tdmf_no_seed;

#endif
