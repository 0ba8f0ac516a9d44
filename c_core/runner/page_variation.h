/* First variations of a motion as those of the runner's page, and back. */
#ifndef TDMF_RUNNER_PAGE_VARIATION_H
#define TDMF_RUNNER_PAGE_VARIATION_H

#include "page_run.h"

/* A direction: changes of the parameters and of the states of the whole page. */
typedef struct {
    runner_parameters p;
    runner_states x;
} tdmf_page_direction;

/* Whether the plain page has all that changes along a direction. */
bool tdmf_varies_plain_page(const tdmf_seed *seed);

/* The change of the point of a motion, whose state is `state`. */
tdmf_page_direction tdmf_page_of_variation(const tdmf_page_point *point, const double state[TDMF_STATE_COUNT],
                                           const tdmf_seed *seed, const tdmf_variation *variation);

/* The change of a motion at the time of its point. `closed`: a stride has closed there, whose stance is
 * varied. */
tdmf_variation tdmf_variation_of_page(const tdmf_page_point *point, const tdmf_page_direction *d,
                                      bool closed);

#endif
