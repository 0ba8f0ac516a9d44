/* Directions of parameters and inputs as those of the runner's page. */
#ifndef TDMF_RUNNER_PAGE_VARIATION_H
#define TDMF_RUNNER_PAGE_VARIATION_H

#include "page_run.h"

/* A direction: changes of the parameters and of the states of the whole page. */
typedef struct {
    runner_parameters p;
    runner_states x;
} tdmf_page_direction;

/* True if the plain page has all that acts on the runner of a point, and all that changes along the seeds. */
bool tdmf_suits_plain_page_varied(const tdmf_page_point *point, const tdmf_seed *seeds, int count);

/* Rates of the inputs for a run with these seeds. A push that is 0 and varies acts as one that is ramped, too
 * slowly for any result. */
tdmf_inputs tdmf_rates_with_varied_push(const tdmf_inputs *rates, const tdmf_seed *seeds, int count);

/* True if there is no derivative along a seed. The clamp has a kink along a gain if both gains are zero. */
bool tdmf_is_kinked(const tdmf_parameters *parameters, const tdmf_seed *seed);

/* The change of parameters and inputs, for states that do not change. */
tdmf_page_direction tdmf_direction_of_seed(const tdmf_seed *seed);

#endif
