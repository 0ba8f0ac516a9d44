/* The tables of places, and copies by them. */
#include "page_places.h"

#include "plain_reduced_runner_in_runner.h"
#include "plain_runner_in_runner.h"
#include "reduced_runner_in_runner.h"

extern const tdmf_model_kind tdmf_plain_runner_model, tdmf_reduced_runner_model,
    tdmf_plain_reduced_runner_model;

const tdmf_runner_page tdmf_whole_page = {.model = &tdmf_runner_model};
const tdmf_runner_page tdmf_plain_page = {
    .model = &tdmf_plain_runner_model,
    .parameters = parameters_in_whole,
    .states = states_in_whole,
    .events = events_in_whole,
    .modes = modes_in_whole,
    .is_plain = true,
};
const tdmf_runner_page tdmf_reduced_page = {
    .model = &tdmf_reduced_runner_model,
    .parameters = reduced_parameters_in_whole,
    .states = reduced_states_in_whole,
    .events = reduced_events_in_whole,
    .modes = reduced_modes_in_whole,
};
const tdmf_runner_page tdmf_plain_reduced_page = {
    .model = &tdmf_plain_reduced_runner_model,
    .parameters = plain_reduced_parameters_in_whole,
    .states = plain_reduced_states_in_whole,
    .events = plain_reduced_events_in_whole,
    .modes = plain_reduced_modes_in_whole,
    .is_plain = true,
};

static int place_in(const int *places, int i) {
    return places ? places[i] : i;
}

static int place_of(const int *places, int count, int of_runner) {
    for (int i = 0; i < count; ++i) {
        if (place_in(places, i) == of_runner) {
            return i;
        }
    }
    return -1;
}

int tdmf_mode_in_runner(const tdmf_runner_page *page, int own) {
    return place_in(page->modes, own);
}

int tdmf_event_in_runner(const tdmf_runner_page *page, int own) {
    return place_in(page->events, own);
}

int tdmf_state_on_page(const tdmf_runner_page *page, int of_runner) {
    return place_of(page->states, page->model->state_count, of_runner);
}

int tdmf_mode_on_page(const tdmf_runner_page *page, int of_runner) {
    return place_of(page->modes, page->model->mode_count, of_runner);
}

int tdmf_event_on_page(const tdmf_runner_page *page, int of_runner) {
    return place_of(page->events, page->model->event_count, of_runner);
}

uint64_t tdmf_events_in_runner(const tdmf_runner_page *page, uint64_t own) {
    uint64_t of_runner = 0;
    for (int i = 0; i < page->model->event_count; ++i) {
        of_runner |= (own >> i & 1) << place_in(page->events, i);
    }
    return of_runner;
}

uint64_t tdmf_events_on_page(const tdmf_runner_page *page, uint64_t of_runner) {
    uint64_t own = 0;
    for (int i = 0; i < page->model->event_count; ++i) {
        own |= (of_runner >> place_in(page->events, i) & 1) << i;
    }
    return own;
}

static void take(const int *places, int count, const double *of_runner, double *own) {
    for (int i = 0; i < count; ++i) {
        own[i] = of_runner[place_in(places, i)];
    }
}

static void give(const int *places, int count, const double *own, double *of_runner) {
    for (int i = 0; i < count; ++i) {
        of_runner[place_in(places, i)] = own[i];
    }
}

void tdmf_take_parameters(const tdmf_runner_page *page, const runner_parameters *of_runner, double *own) {
    take(page->parameters, page->model->parameter_count, (const double *)of_runner, own);
}

void tdmf_take_states(const tdmf_runner_page *page, const runner_states *of_runner, double *own) {
    take(page->states, page->model->state_count, (const double *)of_runner, own);
}

void tdmf_give_parameters(const tdmf_runner_page *page, const double *own, runner_parameters *of_runner) {
    give(page->parameters, page->model->parameter_count, own, (double *)of_runner);
}

void tdmf_give_states(const tdmf_runner_page *page, const double *own, runner_states *of_runner) {
    give(page->states, page->model->state_count, own, (double *)of_runner);
    if (page->is_plain) {
        of_runner->vertical_so_far = of_runner->peak_force_so_far;
    }
}
