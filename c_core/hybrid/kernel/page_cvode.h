/* CVODE as the solver of any page, to check the driver against and for stiff runs. */
#ifndef TDMF_KERNEL_PAGE_CVODE_H
#define TDMF_KERNEL_PAGE_CVODE_H

#include "page_exchange.h"

#include <stdbool.h>
#include <stdint.h>

/* Whether this build has SUNDIALS. */
bool tdmf_page_cvode_is_available(void);

/* Goes on to `until`, or to where an event is due: it is not taken, the caller does so by
 * tdmf_take_due_events, which is also to be called before the first step. Integrates with the run's
 * tolerance, which is relative to the scales of states, within its limit of steps. Of the run's steps,
 * limited_steps counts those that a law's time scale has limited. `watch` has a watch_state for each event.
 * Adds to `evaluations` those of the rates.
 *
 * Returns TDMF_RUN_ARRIVED, TDMF_RUN_STOPPED at an event, TDMF_RUN_TOO_MANY_STEPS or TDMF_RUN_NO_PROGRESS;
 * the run is then where it got to. Without SUNDIALS it makes no progress. */
tdmf_run_outcome tdmf_cvode_to_event(const tdmf_model_kind *model, tdmf_page_run *run, unsigned char *watch,
                                     double until, int64_t *evaluations);

#endif
