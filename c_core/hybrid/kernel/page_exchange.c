/* Guards as another solver sees them, and chains of events at an instant. */
#include "page_exchange.h"

#include "page_margins.h"
#include "run_state.h"

#include <math.h>

void tdmf_view_guards(const tdmf_page_instant *at, const unsigned char *watch,
                      guard_state guards[TDMF_GUARD_LIMIT]) {
    for (int i = 0; i < at->mode->guard_count; ++i) {
        const tdmf_guard_kind *kind = &at->mode->guards[i];
        const watch_state seen = (watch_state)watch[kind->event];
        const bool must_rise = tdmf_has_to_cross(kind, at->p, at->x) && seen != WATCH_ABOVE;
        double value, rate;
        tdmf_page_guard(at, i, &value, &rate);
        value = value / at->event_scales[kind->event] + (must_rise ? -zero_margin : zero_margin);
        const bool rises = seen == WATCH_RISING && value <= 0.0 && rate > 0.0;
        guards[i].is_watched = tdmf_is_watched(kind, at->p, at->x);
        guards[i].rises = rises;
        guards[i].value = rises || !guards[i].is_watched ? 1.0 : value;
        guards[i].is_due = guards[i].value <= 0.0 && !must_rise;
    }
}

void tdmf_note_guards(const tdmf_page_instant *at, const guard_state *guards, unsigned char *watch) {
    bool is_watched[TDMF_PAGE_EVENT_LIMIT] = {false};
    for (int i = 0; i < at->mode->guard_count; ++i) {
        const int event = at->mode->guards[i].event;
        is_watched[event] = guards[i].is_watched;
        if (guards[i].is_watched && !guards[i].rises && guards[i].value > 0.0) {
            watch[event] = WATCH_ABOVE;
        }
    }
    for (int i = 0; i < at->model->event_count; ++i) {
        if (!is_watched[i]) {
            watch[i] = WATCH_BELOW;
        }
    }
}

void tdmf_note_largest(const tdmf_page_instant *at, double *x) {
    for (int i = 0; i < at->mode->usual_count; ++i) {
        double value, rate, *into = &x[at->mode->watches[i].into];
        if (at->mode->watches[i].part == TDMF_LARGEST) {
            tdmf_page_observed(at, i, &value, &rate);
            *into = fmax(*into, value);
        }
    }
}

void tdmf_note_taken(const tdmf_model_kind *model, int event, unsigned char *watch) {
    for (int i = 0; i < model->event_count; ++i) {
        watch[i] = watch[i] == WATCH_RISING ? WATCH_RISING : WATCH_BELOW;
    }
    watch[event] = WATCH_RISING;
}

tdmf_event_row tdmf_take_event_now(const tdmf_model_kind *model, const tdmf_guard_kind *kind,
                                   tdmf_page_run *r, unsigned char *watch) {
    tdmf_event_row row;
    run_state state;
    mode_start at;
    r->log = &row;
    r->log_size = 1;
    r->log_count = 0;
    tdmf_begin_in_memory(&state, &at, model, r);
    tdmf_take_event(&state, kind, &at);
    tdmf_note_taken(model, kind->event, watch);
    return row;
}

bool tdmf_take_due_events(const tdmf_model_kind *model, tdmf_page_run *r, unsigned char *watch,
                          double *memory, tdmf_chain *chain) {
    tdmf_page_run run = *r; /* without the caller's log */
    run.log_states = NULL;
    run.chain = 0;
    run.taken = 0;
    chain->count = 0;
    bool is_settled = false;
    while (!is_settled && run.chain <= TDMF_PAGE_CHAIN_LIMIT) {
        const tdmf_page_instant at = tdmf_instant_at(model, run.mode, run.p, run.x, memory);
        guard_state guards[TDMF_GUARD_LIMIT];
        int first = 0;
        tdmf_view_guards(&at, watch, guards);
        while (first < at.mode->guard_count && !guards[first].is_due) {
            ++first;
        }
        tdmf_note_guards(&at, guards, watch);
        is_settled = first == at.mode->guard_count;
        if (!is_settled) {
            chain->last = tdmf_take_event_now(model, &at.mode->guards[first], &run, watch);
            chain->first = chain->count++ == 0 ? chain->last : chain->first;
        }
    }
    r->mode = run.mode;
    r->left = run.left;
    r->events = run.events;
    r->chain = run.chain;
    r->taken = run.taken;
    r->above = run.above;
    r->late = run.late;
    return is_settled;
}
