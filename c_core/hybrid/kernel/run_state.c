/* The beginning of a mode in a run, and its events. */
#include "run_state.h"

size_t tdmf_size_of_run_state(const tdmf_model_kind *model) {
    return (size_t)model->state_count + (size_t)model->event_count;
}

size_t tdmf_size_of_mode_start(const tdmf_model_kind *model, int seed_count) {
    const size_t constants = (size_t)model->constant_count, states = (size_t)model->state_count;
    return (1 + (size_t)seed_count) * constants + 2 * states + (size_t)model->parameter_count;
}

bool tdmf_is_order(int order) {
    return order % 2 == 0 && order >= LEAST_ORDER && order <= SERIES_ORDER_LIMIT;
}

void tdmf_begin_call(run_state *state) {
    state->last_step = state->r->steps + state->r->step_limit;
    state->last_event = state->r->events + state->r->event_limit;
    state->stops = false;
}

void tdmf_begin_run(run_state *state, const tdmf_model_kind *model, tdmf_page_run *r, double *memory) {
    const run_state begun = {
        .model = model, .r = r, .scales = memory, .event_scales = memory + model->state_count};
    *state = begun;
    tdmf_begin_call(state);
    model->scales(r->p, state->scales, state->event_scales);
}

void tdmf_place_mode_start(mode_start *at, const tdmf_model_kind *model, int seed_count, double *memory) {
    at->c = memory;
    at->d = at->c + model->constant_count;
    at->room = at->d + seed_count * model->constant_count;
    at->rates = at->room + model->state_count;
    at->none = at->rates + model->state_count;
    memset(at->none, 0, (size_t)model->parameter_count * sizeof *at->none);
}

static bool has_event(uint64_t events, int event) {
    return (events >> event & 1) != 0;
}

/* A longer chain of several events may be one of rounding errors, because a guard is a difference of large
 * numbers. The guards of its events are then measured by these numbers. */
static const int common_chain_limit = 16;

/* The sum of the terms of a guard: of each state and parameter times the guard's derivative by it. */
static double size_of_terms(const tdmf_guard_kind *kind, const tdmf_model_kind *model, const tdmf_page_run *r,
                            const mode_start *at) {
    double *dx = at->room, *dp = at->none, size = 0.0;
    memset(dx, 0, (size_t)model->state_count * sizeof *dx);
    for (int i = 0; i < model->state_count; ++i) {
        dx[i] = r->x[i];
        size += fabs(kind->vary_guard(r->p, r->x, dp, dx));
        dx[i] = 0.0;
    }
    for (int i = 0; i < model->parameter_count; ++i) {
        dp[i] = r->p[i];
        size += fabs(kind->vary_guard(r->p, r->x, dp, dx));
        dp[i] = 0.0;
    }
    return isfinite(size) ? size : 0.0;
}

void tdmf_begin_mode(const run_state *state, mode_start *at) {
    const tdmf_page_run *r = state->r;
    const tdmf_model_kind *model = state->model;
    const tdmf_mode_kind *mode = &model->modes[r->mode];
    const bool in_turns = (r->taken & (r->taken - 1)) != 0;
    at->begins = true;
    mode->open(r->p, r->x, at->c);
    for (int i = 0; i < mode->guard_count; ++i) {
        const tdmf_guard_kind *kind = &mode->guards[i];
        guard_start *guard = &at->guards[i];
        guard->flags =
            IS_WATCHED * tdmf_is_watched(kind, r->p, r->x) |
            IS_CROSSING * tdmf_has_to_cross(kind, r->p, r->x) | WAS_TAKEN * has_event(r->taken, kind->event) |
            WAS_ABOVE * has_event(r->above, kind->event) | IS_LATE * has_event(r->late, kind->event);
        guard->scale = state->event_scales[kind->event];
        if (in_turns && r->chain > common_chain_limit && has_event(r->taken, kind->event)) {
            guard->flags |= IN_CHAIN;
            guard->scale = fmax(guard->scale, size_of_terms(kind, model, r, at));
        }
    }
    for (int seed = 0; seed < r->seed_count; ++seed) {
        mode->vary_open(r->p, r->x, r->dp + seed * model->parameter_count, r->dx + seed * model->state_count,
                        at->d + seed * model->constant_count);
    }
}

void tdmf_shift_to_event(run_state *state, const tdmf_guard_kind *kind, const mode_start *at) {
    tdmf_page_run *r = state->r;
    const tdmf_model_kind *model = state->model;
    const double falls = kind->vary_guard(r->p, r->x, at->none, at->rates);
    for (int seed = 0; seed < r->seed_count; ++seed) {
        double *dx = r->dx + seed * model->state_count;
        r->shift[seed] = -kind->vary_guard(r->p, r->x, r->dp + seed * model->parameter_count, dx) / falls;
        for (int i = 0; i < model->state_count; ++i) {
            dx[i] += at->rates[i] * r->shift[seed];
        }
    }
    r->is_shifted = true;
}

/* Applies the decision of an event, and its variation. Both read a copy, because the states are written in
 * place. */
static void apply(const tdmf_model_kind *model, const tdmf_guard_kind *kind, tdmf_page_run *r,
                  const mode_start *at) {
    const tdmf_mode_kind *left = &model->modes[r->mode];
    const size_t size = (size_t)model->state_count * sizeof *r->x;
    const double counted = kind->is_counted ? 1.0 : 0.0;
    double *x = at->room, *dx = at->rates;
    for (int part = left->leave ? 0 : 1; part < 2; ++part) { /* `leave`, then the decision */
        memcpy(x, r->x, size);
        for (int seed = 0; seed < r->seed_count; ++seed) {
            const double *dp = r->dp + seed * model->parameter_count;
            double *after = r->dx + seed * model->state_count;
            memcpy(dx, after, size);
            if (part == 0) {
                left->vary_leave(r->p, x, dp, dx, counted, after);
            } else {
                kind->vary_react(r->p, x, dp, dx, r->tables, seed, after);
            }
        }
        if (part == 0) {
            left->leave(r->p, x, counted, r->x);
        } else {
            r->mode = kind->react(r->p, x, r->tables, r->x, kind->next);
        }
    }
}

void tdmf_pass_time(tdmf_page_run *r, double elapsed) {
    const double before = r->time, more = elapsed + r->time_rest;
    r->time = before + more;
    r->time_rest = more - (r->time - before);
    if (r->time > before) {
        r->chain = 0;
        r->taken = 0;
    }
}

void tdmf_keep_guards(run_state *state, const mode_start *at) {
    const tdmf_mode_kind *mode = &state->model->modes[state->r->mode];
    uint64_t above = 0, late = 0;
    for (int i = 0; i < mode->guard_count; ++i) {
        const int flags = at->guards[i].flags, event = mode->guards[i].event;
        above |= (uint64_t)((flags & (IS_WATCHED | WAS_ABOVE)) == (IS_WATCHED | WAS_ABOVE)) << event;
        late |= (uint64_t)((flags & (IS_WATCHED | IS_LATE)) == (IS_WATCHED | IS_LATE)) << event;
    }
    state->r->above = above;
    state->r->late = late;
}

/* Forgets the guards of the mode before. A guard that has to cross zero is known to have been above it until
 * its event is taken, if the next mode watches it, too. */
static void forget_guards(run_state *state, int taken) {
    const tdmf_mode_kind *mode = &state->model->modes[state->r->mode];
    uint64_t crossing = 0;
    for (int i = 0; i < mode->guard_count; ++i) {
        const tdmf_guard_kind *kind = &mode->guards[i];
        const bool stays = kind->event != taken && tdmf_has_to_cross(kind, state->r->p, state->r->x);
        crossing |= stays ? (uint64_t)1 << kind->event : 0;
    }
    state->r->above &= crossing;
    state->r->late = 0;
}

bool tdmf_take_event(run_state *state, const tdmf_guard_kind *kind, const mode_start *at) {
    tdmf_page_run *r = state->r;
    const int count = state->model->state_count, before = r->mode;
    if (r->log_count < r->log_size && r->log_states) {
        memcpy(r->log_states + r->log_count * count, r->x, (size_t)count * sizeof *r->x);
    }
    tdmf_keep_guards(state, at);
    apply(state->model, kind, r, at);
    if (r->log_count < r->log_size) {
        const tdmf_event_row row = {r->time, kind->event, before, r->mode};
        r->log[r->log_count++] = row;
    }
    forget_guards(state, kind->event);
    r->taken |= (uint64_t)1 << kind->event;
    r->left = before;
    state->stops |= kind->event == r->stop_event;
    ++r->events;
    ++r->chain;
    return state->model->modes[r->mode].ends ||
           (r->chain <= TDMF_PAGE_CHAIN_LIMIT && r->events < state->last_event);
}

tdmf_run_outcome tdmf_limit_reached(const run_state *state) {
    return state->r->chain > TDMF_PAGE_CHAIN_LIMIT ? TDMF_RUN_ENDLESS_CHAIN : TDMF_RUN_TOO_MANY_EVENTS;
}

/* ---- samples ------------------------------------------------------------------------------------------- */

double tdmf_next_sample(const tdmf_page_run *r) {
    return r->sampled < r->sample_count ? r->sample_times[r->sampled] : INFINITY;
}

void tdmf_write_sample(const tdmf_model_kind *model, const tdmf_page_run *r, int sample, const double *x) {
    model->modes[r->mode].outputs(r->p, x, r->samples + (size_t)sample * (size_t)model->output_count);
}

void tdmf_vary_sample(const tdmf_model_kind *model, const tdmf_page_run *r, int sample, int seed,
                      const double *x, const double *dx) {
    const size_t row = (size_t)sample * (size_t)r->seed_count + (size_t)seed;
    model->modes[r->mode].vary_outputs(r->p, x, r->dp + seed * model->parameter_count, dx,
                                       r->d_samples + row * (size_t)model->output_count);
}

void tdmf_sample_here(const tdmf_model_kind *model, tdmf_page_run *r) {
    while (tdmf_next_sample(r) <= r->time) {
        const int sample = r->sampled++;
        tdmf_write_sample(model, r, sample, r->x);
        for (int seed = 0; seed < r->seed_count && r->d_samples; ++seed) {
            tdmf_vary_sample(model, r, sample, seed, r->x, r->dx + seed * model->state_count);
        }
    }
}
