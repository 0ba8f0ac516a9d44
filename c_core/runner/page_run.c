/* The choice between the plain and the whole page. The plain one is faster; its parameters, states, modes and
 * events are some of the whole one's. */
#include "page_run.h"

/* The one guard whose place above zero a motion remembers. */
static const uint64_t apex = (uint64_t)1 << EVENT_apex;

static bool are_zero(const double *values, int count) {
    for (int i = 0; i < count; ++i) {
        if (values[i] != 0.0) {
            return false;
        }
    }
    return true;
}

bool tdmf_suits_plain_page(const tdmf_page_point *point) {
    const runner_parameters *p = &point->p;
    const runner_states *x = &point->x;
    const double off[] = {
        p->ground_height,
        p->ground_slope,
        x->height,
        x->slope,
        p->thrust,
        p->more_thrust,
        p->retraction_rate,
        p->more_angle,
        p->more_torque,
        p->static_ratio - 1.0,
        x->extension,
        x->external_fx,
        x->external_fy,
        x->friction_rate,
        x->extension_rate,
        x->external_fx_rate,
        x->external_fy_rate,
        x->external_torque_rate,
        x->leg_work - x->leg_work_then,
        x->peak_force_so_far - x->vertical_so_far,
    };
    return are_zero(off, (int)(sizeof off / sizeof off[0])) && !(p->patch_end > p->patch_begin);
}

void tdmf_begin_runner_run(tdmf_runner_run *run, const tdmf_page_point *point, bool is_plain) {
    run->page = is_plain ? &tdmf_plain_page : &tdmf_whole_page;
    run->run = tdmf_run_default(run->page->model, run->p, run->x, NULL);
    tdmf_take_parameters(run->page, &point->p, run->p);
    tdmf_take_states(run->page, &point->x, run->x);
    run->run.mode = tdmf_mode_on_page(run->page, point->mode);
    run->run.above = tdmf_events_on_page(run->page, point->above & apex);
}

void tdmf_end_runner_run(const tdmf_runner_run *run, tdmf_page_point *point) {
    const tdmf_page_run *r = &run->run;
    tdmf_give_states(run->page, run->x, &point->x);
    point->mode = tdmf_mode_in_runner(run->page, r->mode);
    point->above = tdmf_events_in_runner(run->page, r->above) & apex;
    point->time = r->time;
    point->rest = r->time_rest;
}
