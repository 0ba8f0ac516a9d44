/* Places of the core's parameters, inputs and states on the runner's page. Variations use the same places. */
#ifndef TDMF_RUNNER_PAGE_FIELDS_H
#define TDMF_RUNNER_PAGE_FIELDS_H

#include "runner.h"
#include "tdmf_slip/stride.h"
#include "tdmf_slip/variables.h"

runner_parameters tdmf_page_parameters(const tdmf_parameters *p, const tdmf_inputs *inputs);
void tdmf_write_page_inputs(const tdmf_inputs *inputs, runner_states *x);
void tdmf_read_page_state(const double state[TDMF_STATE_COUNT], runner_states *x);
void tdmf_write_page_state(const runner_states *x, double state[TDMF_STATE_COUNT]);

/* The last completed stride. */
tdmf_stride tdmf_page_stride_of(const runner_states *x);

/* A count, which is a double on the page. */
int tdmf_count_of(double count);

#endif
