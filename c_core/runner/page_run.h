/* A run of the runner's page: of the plain page where the runner has no more than that, else of the whole
 * one.
 *
 *     tdmf_page_point point = tdmf_page_of_motion(system, rates, motion);
 *     tdmf_runner_run run;
 *     tdmf_begin_runner_run(&run, &point, tdmf_suits_plain_page(&point));
 *     ... the driver or a batch takes run.run on, a run of run.page->model ...
 *     tdmf_end_runner_run(&run, &point);
 *     tdmf_motion_of_page(system, &point, last_mode, motion);
 */
#ifndef TDMF_RUNNER_PAGE_RUN_H
#define TDMF_RUNNER_PAGE_RUN_H

#include "page_motion.h"
#include "page_places.h"

typedef struct {
    const tdmf_page_part *page;
    tdmf_page_run run;
    double p[TDMF_PAGE_PARAMETER_COUNT], x[TDMF_PAGE_STATE_COUNT]; /* numbers of the page that runs */
} tdmf_runner_run;

/* True if the plain page has all that acts on this runner. */
bool tdmf_suits_plain_page(const tdmf_page_point *point);

/* Begins a run at a point, with the defaults of tdmf_run_default. */
void tdmf_begin_runner_run(tdmf_runner_run *run, const tdmf_page_point *point, bool is_plain);

/* Replaces the point at which the run began by the point that it has reached. */
void tdmf_end_runner_run(const tdmf_runner_run *run, tdmf_page_point *point);

#endif
