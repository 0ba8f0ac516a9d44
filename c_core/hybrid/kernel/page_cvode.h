/* CVODE as the solver of any page, to check the driver against and for stiff runs. */
#ifndef TDMF_KERNEL_PAGE_CVODE_H
#define TDMF_KERNEL_PAGE_CVODE_H

#include "page_exchange.h"

#include <stdbool.h>
#include <stdint.h>

/* True if this build has SUNDIALS. */
bool tdmf_page_cvode_is_available(void);

/* Integrates to `until`, or until an event is due. The caller takes the event by tdmf_take_due_events, which
 * must also be called before the first step. The run's tolerance is relative to the scales of states; its
 * limit of steps holds, and limited_steps counts the steps that a law's time scale has limited. `watch` has a
 * watch_state for each event. `evaluations` is increased by the evaluations of the rates.
 *
 * Returns TDMF_RUN_ARRIVED, TDMF_RUN_STOPPED at an event, TDMF_RUN_TOO_MANY_STEPS or TDMF_RUN_NO_PROGRESS;
 * the run then stands at the time reached. Without SUNDIALS it makes no progress. */
tdmf_run_outcome tdmf_cvode_to_event(const tdmf_model_kind *model, tdmf_page_run *run, unsigned char *watch,
                                     double until, int64_t *evaluations);

#endif
