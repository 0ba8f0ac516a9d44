/* Runs a page: Taylor steps, the first event of any guard, chains of events in zero time, saltation.
 *
 * A step is as long as its series can be trusted. Each guard is a polynomial in the step, and the first root
 * of any ends it. A guard that is below zero where a mode begins is due at once, in the page's order.
 *
 * With guard g, reset R and rates f- and f+ before and after, a variation dx passes an event by
 *
 *     dt = -(g_x dx + g_p dp)/(g_x f-),      dx+ = R_x (dx + f- dt) + R_p dp - f+ dt,
 *
 * and resets that follow in zero time, which inequalities decide, shift with the first one. A step is in
 * page_lanes.h, where a mode begins and events are in run_state.h.
 */
#include "driver.h"

#include "page_lanes.h"

#include <stdio.h>

struct tdmf_driver {
    lane_room room;
    page_lanes lane;
    double *memory; /* memory of the lane's arrays */
};

/* Loads a run, whose mode `at` holds. */
static page_lanes *load(tdmf_driver *w, run_state *state, const mode_start *at, double until) {
    const tdmf_mode_kind *mode = &state->model->modes[state->r->mode];
    w->room.tolerance = state->r->tolerance;
    w->room.order = state->r->order;
    w->room.seed_count = state->r->seed_count;
    w->room.observes = state->r->observes;
    open_lanes(&w->lane, &w->room, mode, mode->motion, w->memory);
    w->lane.step.c = at->c;
    w->lane.d = at->d;
    w->lane.d_stride = state->model->constant_count;
    load_run(&w->lane, 0, state, at, until);
    w->lane.live = true;
    return &w->lane;
}

/* Raises largest values to those of an instant after an event. */
static void observe_instant(page_lanes *b) {
    page_step *step = &b->step;
    for (int i = 0; i < step->observed_count; ++i) {
        double *largest = &b->x[step->places[i]];
        const double now = is_largest(step, i) ? expanded(step, i)[0] : *largest;
        const bool is_raised = now > *largest + zero_margin * scale_of_observed(step, i);
        step->observed[i].share = is_raised ? 0.0 : -1.0;
        for (int seed = 0; seed < b->room->seed_count && is_raised; ++seed) {
            double *varied = &b->dx[seed * changing_count(step) + step->places[i]];
            const double *d = b->d + seed * b->d_stride;
            read_seed(b, 0, vary_seeds(b, seed));
            *varied = observed_variation(step, i, d, b->room->t, b->shift[seed], *varied);
        }
        *largest = real_max(now, *largest);
    }
}

void tdmf_leave_guard(tdmf_driver *w, run_state *state, mode_start *at) {
    page_lanes *b = load(w, state, at, -INFINITY);
    if (b->is_shifted) {
        const lane_ends ends = begin_step(b);
        if (!ends.overflows && !ends.fails) {
            shift_back(b, true);
            observe_instant(b);
        }
        unload_run(b, 0);
    }
}

/* Makes steps up to the next event, and takes it. */
static tdmf_run_outcome to_event(page_lanes *b, run_state *state, mode_start *at) {
    tdmf_run_outcome outcome = TDMF_RUN_TOO_MANY_STEPS;
    bool goes_on = b->steps < b->last_step;
    lane_ends ends = {0};
    while (goes_on) {
        ends = begin_step(b);
        if (ends.overflows || ends.fails || ends.stops) {
            outcome = ends.stops ? TDMF_RUN_STOPPED : TDMF_RUN_NO_PROGRESS;
            break;
        }
        finish_step(b, &ends);
        outcome = ends.arrives ? TDMF_RUN_ARRIVED : outcome;
        goes_on = !ends.arrives && !ends.takes && !ends.is_late;
    }
    unload_run(b, 0);
    keep_guards(b, 0, at);
    if (ends.takes) {
        const bool may_go_on = take_event(b, 0, &ends, state, at);
        tdmf_begin_mode(state, at);
        return may_go_on ? TDMF_RUN_GOES_ON : tdmf_limit_reached(state);
    }
    return outcome;
}

tdmf_run_outcome tdmf_drive_to_event(tdmf_driver *w, run_state *state, mode_start *at, double until) {
    tdmf_run_outcome outcome = TDMF_RUN_ENDED;
    if (state->model->modes[state->r->mode].ends) {
        tdmf_sample_here(state->model, state->r);
    } else {
        outcome = to_event(load(w, state, at, until), state, at);
    }
    if (outcome != TDMF_RUN_GOES_ON) {
        tdmf_keep_guards(state, at);
    }
    return outcome;
}

/* ---- memory -------------------------------------------------------------------------------------------- */

/* Numbers of memory that hold a driver. */
static const size_t driver_size = (sizeof(tdmf_driver) + sizeof(double) - 1) / sizeof(double);

/* Numbers of the lane's arrays in any mode. */
static size_t most_of_mode(const tdmf_model_kind *model, int seed_count) {
    size_t most = 0;
    for (int mode = 0; mode < model->mode_count; ++mode) {
        const size_t size = reals_of_mode(&model->modes[mode], seed_count, TDMF_OBSERVE_ALL);
        most = size > most ? size : most;
    }
    return most;
}

/* Numbers for the constants and series of two lanes, which are aligned, and for their variations. */
static size_t size_of_two_seeds(const tdmf_model_kind *model, int seed_count) {
    const size_t constants = (size_t)model->constant_count;
    const size_t series = (size_t)model->series_count + most_moving(model);
    return model->seeds && seed_count > 1 ? 2 * (1 + 2 * constants + series * TERMS) : 0;
}

size_t tdmf_size_of_driver(const tdmf_model_kind *model, int seed_count) {
    return driver_size + reals_of_room(model, seed_count) + most_of_mode(model, seed_count) +
           size_of_two_seeds(model, seed_count);
}

tdmf_driver *tdmf_place_driver(const tdmf_model_kind *model, int seed_count, double *memory) {
    tdmf_driver *w = (void *)memory;
    w->room.model = model;
    w->room.seed_count = seed_count;
    w->memory = place_room(&w->room, memory + driver_size);
    double *next = w->memory + most_of_mode(model, seed_count);
    w->room.two_seeds.memory = size_of_two_seeds(model, seed_count) > 0 ? next : NULL;
    w->room.two_seeds.series_count = model->series_count;
    w->room.two_seeds.constant_count = model->constant_count;
    return w;
}

/* ---- runs ---------------------------------------------------------------------------------------------- */

size_t tdmf_run_memory_size(const tdmf_model_kind *model, int seed_count) {
    return tdmf_size_of_mode_start(model, seed_count) + tdmf_size_of_run_state(model) +
           tdmf_size_of_driver(model, seed_count);
}

tdmf_driver *tdmf_begin_in_memory(run_state *state, mode_start *at, const tdmf_model_kind *model,
                                  tdmf_page_run *r) {
    double *of_state = r->memory + tdmf_size_of_mode_start(model, r->seed_count);
    tdmf_place_mode_start(at, model, r->seed_count, r->memory);
    tdmf_begin_run(state, model, r, of_state);
    tdmf_begin_mode(state, at);
    return tdmf_place_driver(model, r->seed_count, of_state + tdmf_size_of_run_state(model));
}

tdmf_run_outcome tdmf_page_run_to(const tdmf_model_kind *model, tdmf_page_run *r, double until) {
    run_state state;
    mode_start at;
    tdmf_run_outcome outcome;
    if (!tdmf_is_order(r->order)) {
        return TDMF_RUN_BAD_ORDER;
    }
    tdmf_driver *driver = tdmf_begin_in_memory(&state, &at, model, r);
    do {
        outcome = tdmf_drive_to_event(driver, &state, &at, until);
    } while (outcome == TDMF_RUN_GOES_ON);
    return outcome;
}

int tdmf_page_order(double tolerance) {
    const double half = 2.0 - 0.75 * log10(tolerance); /* infinite for 0, and NaN below 0 */
    return half >= 0.5 * SERIES_ORDER_LIMIT ? SERIES_ORDER_LIMIT : half >= 4.0 ? 2 * (int)half : 8;
}

tdmf_page_run tdmf_run_default(const tdmf_model_kind *model, double *p, double *x, double *memory) {
    const double tolerance = 1e-11;
    memcpy(p, model->parameter_defaults, (size_t)model->parameter_count * sizeof *p);
    memcpy(x, model->state_defaults, (size_t)model->state_count * sizeof *x);
    const tdmf_page_run run = {.p = p,
                               .x = x,
                               .memory = memory,
                               .tolerance = tolerance,
                               .order = tdmf_page_order(tolerance),
                               .stop_event = -1,
                               .observes = TDMF_OBSERVE_USUAL,
                               .step_limit = 100000,
                               .event_limit = 100000};
    return run;
}

void tdmf_page_set(const tdmf_model_kind *model, tdmf_page_run *r, bool is_state, int index, double value) {
    const size_t size = (size_t)model->state_count * sizeof(double);
    double *after = r->memory;
    for (int i = 0; i < model->set_count; ++i) {
        const tdmf_set_kind *kind = &model->sets[i];
        if (kind->is_state == is_state && kind->index == index && kind->set[r->mode]) {
            memcpy(after, r->x, size);
            kind->set[r->mode](r->p, r->x, value, after);
            memcpy(r->x, after, size);
        }
    }
    *(is_state ? &r->x[index] : &r->p[index]) = value;
}

/* ---- the message --------------------------------------------------------------------------------------- */

static const char *const endings[] = {
    [TDMF_RUN_ARRIVED] = "The run has arrived",
    [TDMF_RUN_STOPPED] = "The run has stopped at the event asked for",
    [TDMF_RUN_ENDED] = "The run has ended",
    [TDMF_RUN_NO_PROGRESS] = "No step, however short, has a finite result",
    [TDMF_RUN_TOO_MANY_STEPS] = "The run takes more steps than its limit",
    [TDMF_RUN_TOO_STIFF] = "The run is too stiff for this solver; CVODE (solver.method = cvode) follows it,",
    [TDMF_RUN_ENDLESS_CHAIN] = "Events whose guards do not rise above 0 are due again and again",
    [TDMF_RUN_TOO_MANY_EVENTS] = "The run has more events than its limit",
    [TDMF_RUN_NO_MEMORY] = "There is no memory for the run",
    [TDMF_RUN_CANCELLED] = "The run was cancelled",
};

void tdmf_run_message(const tdmf_model_kind *model, const tdmf_page_run *r, tdmf_run_outcome outcome,
                      char *text, size_t size) {
    if (outcome == TDMF_RUN_BAD_ORDER) {
        snprintf(text, size, "The order of the series is %d; it has to be even, from %d to %d", r->order,
                 LEAST_ORDER, SERIES_ORDER_LIMIT);
        return;
    }
    if (outcome == TDMF_RUN_TOO_MANY_SEEDS) {
        snprintf(text, size, "The return map has %d seeds; with its coordinates, at most %d are allowed",
                 r->seed_count, TDMF_VARIED_LIMIT);
        return;
    }
    int length = snprintf(text, size, "%s in the mode `%s` at t = %g", endings[outcome],
                          model->mode_names[r->mode], r->time);
    const char *before = ": ";
    for (int i = 0; i < model->event_count && outcome == TDMF_RUN_ENDLESS_CHAIN; ++i) {
        if ((r->taken >> i & 1) != 0 && length >= 0 && (size_t)length < size) {
            length += snprintf(text + length, size - (size_t)length, "%s`%s`", before, model->event_names[i]);
            before = ", ";
        }
    }
}
