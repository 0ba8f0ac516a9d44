/* The choice between the plain and the whole page. The plain one is faster; its parameters, states, modes and
 * events are some of the whole one's. */
#include "page_run.h"

#include "plain_runner_in_runner.h"

#include <math.h>
#include <string.h>

extern const tdmf_model_kind tdmf_plain_runner_model;

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

int tdmf_mode_in_whole(bool is_plain, int mode) {
    return is_plain ? modes_in_whole[mode] : mode;
}

int tdmf_event_in_whole(bool is_plain, int event) {
    return is_plain ? events_in_whole[event] : event;
}

static int place_of(const int *places, int count, int wanted) {
    int i = 0;
    while (i < count - 1 && places[i] != wanted) {
        ++i;
    }
    return i;
}

enum {
    PARAMETERS = sizeof parameters_in_whole / sizeof parameters_in_whole[0],
    STATES = sizeof states_in_whole / sizeof states_in_whole[0],
    MODES = sizeof modes_in_whole / sizeof modes_in_whole[0],
    EVENTS = sizeof events_in_whole / sizeof events_in_whole[0]
};

void tdmf_take_parameters(bool is_plain, const double *whole, double *own) {
    for (int i = 0; i < (is_plain ? PARAMETERS : TDMF_PAGE_PARAMETER_COUNT); ++i) {
        own[i] = whole[is_plain ? parameters_in_whole[i] : i];
    }
}

void tdmf_take_states(bool is_plain, const double *whole, double *own) {
    for (int i = 0; i < (is_plain ? STATES : TDMF_PAGE_STATE_COUNT); ++i) {
        own[i] = whole[is_plain ? states_in_whole[i] : i];
    }
}

void tdmf_give_states(bool is_plain, const double *own, double *whole) {
    for (int i = 0; i < (is_plain ? STATES : TDMF_PAGE_STATE_COUNT); ++i) {
        whole[is_plain ? states_in_whole[i] : i] = own[i];
    }
}

void tdmf_give_parameters(bool is_plain, const double *own, double *whole) {
    for (int i = 0; i < (is_plain ? PARAMETERS : TDMF_PAGE_PARAMETER_COUNT); ++i) {
        whole[is_plain ? parameters_in_whole[i] : i] = own[i];
    }
}

int tdmf_event_of_whole(bool is_plain, int event) {
    return is_plain && event >= 0 ? place_of(events_in_whole, EVENTS, event) : event;
}

void tdmf_begin_runner_run(tdmf_runner_run *run, const tdmf_page_point *point, bool is_plain) {
    run->model = is_plain ? &tdmf_plain_runner_model : &tdmf_runner_model;
    run->is_plain = is_plain;
    run->run = tdmf_run_default(run->model, run->p, run->x, NULL);
    tdmf_take_parameters(is_plain, (const double *)&point->p, run->p);
    tdmf_take_states(is_plain, (const double *)&point->x, run->x);
    run->run.mode = is_plain ? place_of(modes_in_whole, MODES, point->mode) : point->mode;
    const int apex = tdmf_event_of_whole(is_plain, EVENT_apex);
    run->run.above = (point->above >> EVENT_apex & 1) << apex;
}

void tdmf_end_runner_run(const tdmf_runner_run *run, tdmf_page_point *point) {
    const tdmf_page_run *r = &run->run;
    const int apex = tdmf_event_of_whole(run->is_plain, EVENT_apex);
    tdmf_give_states(run->is_plain, run->x, (double *)&point->x);
    point->mode = tdmf_mode_in_whole(run->is_plain, r->mode);
    point->above = (r->above >> apex & 1) << EVENT_apex;
    point->time = r->time;
    point->rest = r->time_rest;
    if (run->is_plain) { /* the vertical force is the normal force */
        point->x.vertical_so_far = point->x.peak_force_so_far;
        point->x.peak_vertical_force = point->x.peak_force;
    }
}
