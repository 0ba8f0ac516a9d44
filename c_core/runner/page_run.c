/* The choice between the plain and the whole page. The plain one is faster; its parameters, states, modes and
 * events are some of the whole one's. */
#include "page_run.h"

/* The one guard whose place above zero a motion remembers. */
static const uint64_t apex = (uint64_t)1 << EVENT_apex;

const tdmf_page_part tdmf_whole_page = {.model = &tdmf_runner_model};

bool tdmf_suits_plain_page(const tdmf_page_point *point) {
    return tdmf_plain_runner_part.excess((const double *)&point->p, (const double *)&point->x) == 0.0;
}

void tdmf_begin_runner_run(tdmf_runner_run *run, const tdmf_page_point *point, bool is_plain) {
    run->page = is_plain ? &tdmf_plain_runner_part : &tdmf_whole_page;
    run->run = tdmf_run_default(run->page->model, run->p, run->x, NULL);
    tdmf_take_parameters(run->page, &point->p, run->p);
    tdmf_take_states(run->page, &point->x, run->x);
    run->run.time = point->time;
    run->run.time_rest = point->rest;
    run->run.mode = tdmf_mode_on_part(run->page, point->mode);
    run->run.above = tdmf_events_on_part(run->page, point->above & apex);
}

void tdmf_end_runner_run(const tdmf_runner_run *run, tdmf_page_point *point) {
    const tdmf_page_run *r = &run->run;
    tdmf_give_states(run->page, run->x, &point->x);
    point->mode = tdmf_mode_in_whole(run->page, r->mode);
    point->above = tdmf_events_in_whole(run->page, r->above) & apex;
    point->time = r->time;
    point->rest = r->time_rest;
}
