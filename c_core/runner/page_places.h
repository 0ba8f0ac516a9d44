/* The runner's page, and its parts. */
#ifndef TDMF_RUNNER_PAGE_PLACES_H
#define TDMF_RUNNER_PAGE_PLACES_H

#include "page_part.h"
#include "runner.h"

extern const tdmf_page_part tdmf_whole_page, tdmf_plain_runner_part;
/* Parts of the reduced map. */
extern const tdmf_page_part tdmf_reduced_runner_part, tdmf_plain_reduced_runner_part;

/* Numbers of the runner's page, which has most of them. */
enum {
    TDMF_PAGE_PARAMETER_COUNT = sizeof(runner_parameters) / sizeof(double),
    TDMF_PAGE_STATE_COUNT = sizeof(runner_states) / sizeof(double)
};

#endif
