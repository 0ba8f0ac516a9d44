/* Places of the core's parameters and inputs on the runner's page. Variations use the same places. */
#ifndef TDMF_RUNNER_PAGE_FIELDS_H
#define TDMF_RUNNER_PAGE_FIELDS_H

#include "runner.h"
#include "tdmf_slip/stride.h"
#include "tdmf_slip/variables.h"

runner_parameters tdmf_page_parameters(const tdmf_parameters *p, const tdmf_inputs *inputs);
void tdmf_write_page_inputs(const tdmf_inputs *inputs, runner_states *x);

/* The last completed stride, and the last apex of a run that began at a time. */
tdmf_stride tdmf_page_stride_of(const runner_states *x);
tdmf_apex tdmf_page_apex_of(const runner_states *x, double begun);

/* A count, which is a double on the page. */
int tdmf_count_of(double count);

#endif
