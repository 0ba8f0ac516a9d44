/* The derived functions of a mode at an instant: its series up to the second coefficient. */
#include "page_instant.h"

#include <math.h>
#include <string.h>

enum { FEW_TERMS = 4, FEW_ORDER = 2 }; /* values and rates need no more */

size_t tdmf_size_of_instant(const tdmf_model_kind *model) {
    const size_t series = (size_t)model->series_count * TERMS, constants = (size_t)model->constant_count;
    return 2 * (series + constants) + (size_t)model->state_count + (size_t)model->event_count;
}

tdmf_page_instant tdmf_instant_at(const tdmf_model_kind *model, int mode, const double *p, const double *x,
                                  double *memory) {
    tdmf_page_instant at = {.model = model, .mode = &model->modes[mode], .p = p, .x = x};
    const tdmf_motion_kind *motion = at.mode->motion;
    at.s = (double(*)[TERMS])(void *)memory;
    at.t = at.s + model->series_count;
    at.c = (double *)(at.t + model->series_count);
    at.d = at.c + model->constant_count;
    at.scales = at.d + model->constant_count;
    at.event_scales = at.scales + model->state_count;
    model->scales(p, at.scales, at.event_scales);
    at.mode->open(p, x, at.c);
    for (int i = 0; i < model->series_count; ++i) {
        memset(at.s[i], 0, FEW_TERMS * sizeof(double));
    }
    for (int i = 0; i < motion->moving_count; ++i) {
        at.s[i][0] = x[motion->moving[i]];
    }
    motion->expand(at.c, FEW_ORDER, at.s[0]);
    return at;
}

/* ---- values and rates ---------------------------------------------------------------------------------- */

void tdmf_page_guard(const tdmf_page_instant *at, int guard, double *value, double *rate) {
    double g[TERMS] = {0.0};
    at->mode->motion->polynomials[guard](at->c, at->s[0], FEW_ORDER, g);
    *value = g[0];
    *rate = g[1];
}

void tdmf_page_observed(const tdmf_page_instant *at, int watch, double *value, double *rate) {
    tdmf_page_guard(at, at->mode->guard_count + watch, value, rate);
}

void tdmf_page_rates(const tdmf_page_instant *at, double *rates) {
    const tdmf_mode_kind *mode = at->mode;
    memset(rates, 0, (size_t)at->model->state_count * sizeof *rates);
    for (int i = 0; i < mode->motion->moving_count; ++i) {
        rates[mode->motion->moving[i]] = at->s[i][1];
    }
    for (int i = 0; i < mode->usual_count; ++i) {
        double value, rate;
        if (mode->watches[i].part == TDMF_POSITIVE_INTEGRAL) {
            tdmf_page_observed(at, i, &value, &rate);
            rates[mode->watches[i].into] += fmax(value, 0.0);
        }
    }
}

void tdmf_page_world_rates(const tdmf_page_instant *at, double *rates) {
    tdmf_page_rates(at, rates);
    if (at->mode->world_rates != NULL) {
        at->mode->world_rates(at->p, at->x, rates);
    }
}

/* ---- variations ---------------------------------------------------------------------------------------- */

static void vary_integrals(const tdmf_page_instant *at, double *d_rates) {
    const tdmf_mode_kind *mode = at->mode;
    for (int i = 0; i < mode->usual_count; ++i) {
        double value, rate, dg[TERMS] = {0.0};
        if (mode->watches[i].part == TDMF_POSITIVE_INTEGRAL) {
            tdmf_page_observed(at, i, &value, &rate);
            mode->motion->vary_observed[i](at->c, at->s[0], at->d, at->t[0], FEW_ORDER, dg);
            d_rates[mode->watches[i].into] += value > 0.0 ? dg[0] : 0.0;
        }
    }
}

void tdmf_vary_page_rates(const tdmf_page_instant *at, const double *dp, const double *dx, double *d_rates) {
    const tdmf_mode_kind *mode = at->mode;
    const tdmf_motion_kind *motion = mode->motion;
    memset(d_rates, 0, (size_t)at->model->state_count * sizeof *d_rates);
    mode->vary_open(at->p, at->x, dp, dx, at->d);
    for (int i = 0; i < at->model->series_count; ++i) {
        memset(at->t[i], 0, FEW_TERMS * sizeof(double));
    }
    for (int i = 0; i < motion->moving_count; ++i) {
        at->t[i][0] = dx[motion->moving[i]];
    }
    motion->vary(at->c, at->s[0], at->d, FEW_ORDER, at->t[0]);
    for (int i = 0; i < motion->moving_count; ++i) {
        d_rates[motion->moving[i]] = at->t[i][1];
    }
    vary_integrals(at, d_rates);
    if (mode->vary_world_rates != NULL) {
        mode->vary_world_rates(at->p, at->x, dp, dx, d_rates);
    }
}

/* ---- coordinates --------------------------------------------------------------------------------------- */

static void map_states(const tdmf_model_kind *model, tdmf_change *map, const double *p, double *x,
                       double *room) {
    if (map != NULL) {
        memcpy(room, x, (size_t)model->state_count * sizeof *room);
        map(p, room, x);
    }
}

void tdmf_show_to_world(const tdmf_model_kind *model, int mode, const double *p, double *x, double *room) {
    map_states(model, model->modes[mode].to_world, p, x, room);
}

void tdmf_take_from_world(const tdmf_model_kind *model, int mode, const double *p, double *x, double *room) {
    map_states(model, model->modes[mode].from_world, p, x, room);
}
