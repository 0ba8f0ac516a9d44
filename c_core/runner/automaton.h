/* Chains of events in zero time on a motion, for resolution and for CVODE. */
#ifndef TDMF_RUNNER_AUTOMATON_H
#define TDMF_RUNNER_AUTOMATON_H

#include "motion_instant.h"
#include "tdmf_slip/automaton.h"

/* Memory of a run of the runner's page that takes events, which a test checks. */
enum { TDMF_SETTLING_MEMORY = 4096 };

/* A run of the whole page at a point, in which it goes on. */
tdmf_page_run tdmf_run_at(tdmf_page_point *point, double *memory);

/* Takes the events that are due at an instant, and writes the motion that they make of `motion`, which the
 * instant's point was read from. False where they do not come to an end. */
bool tdmf_settle_motion(tdmf_system system, tdmf_motion_instant *instant, tdmf_motion *motion,
                        tdmf_chain *chain);

#endif
