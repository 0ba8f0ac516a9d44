/* The pages of ensembles, and where each has its quantities on the runner's page. */
#include "runner_pages.h"

#include "plain_runner_in_runner.h"
#include "reduced_runner_in_runner.h"

extern const tdmf_model_kind tdmf_plain_runner_model, tdmf_reduced_runner_model;
tdmf_motions_of_width tdmf_plain_runner_motions_of_2, tdmf_plain_runner_motions_of_4,
    tdmf_plain_runner_motions_of_8, tdmf_reduced_runner_motions_of_2, tdmf_reduced_runner_motions_of_4,
    tdmf_reduced_runner_motions_of_8;

#define LANES_OF(page)                                                                                       \
    {                                                                                                        \
        TDMF_TWO_LANES(page##_motions_of_2), TDMF_FOUR_LANES(page##_motions_of_4),                           \
            TDMF_EIGHT_LANES(page##_motions_of_8)                                                            \
    }

static const tdmf_runner_page whole = {.model = &tdmf_runner_model, .lanes = LANES_OF(tdmf_runner)};
static const tdmf_runner_page plain = {
    .model = &tdmf_plain_runner_model,
    .lanes = LANES_OF(tdmf_plain_runner),
    .parameters = parameters_in_whole,
    .states = states_in_whole,
    .modes = modes_in_whole,
    .events = events_in_whole,
};
static const tdmf_runner_page reduced = {
    .model = &tdmf_reduced_runner_model,
    .lanes = LANES_OF(tdmf_reduced_runner),
    .parameters = reduced_parameters_in_whole,
    .states = reduced_states_in_whole,
    .modes = reduced_modes_in_whole,
    .events = reduced_events_in_whole,
};

const tdmf_runner_page *tdmf_page_for(tdmf_ensemble_map map, bool is_plain) {
    return map == TDMF_REDUCED_MAP ? &reduced : is_plain ? &plain : &whole;
}

tdmf_model_kind tdmf_model_in_lanes(const tdmf_runner_page *page) {
    tdmf_model_kind model = *page->model;
    for (int i = 0; i < 3; ++i) {
        model.lanes[i] = page->lanes[i];
    }
    return model;
}

/* The runner's page has all of its own where they are. */
static int place_in(const int *places, int i) {
    return places ? places[i] : i;
}

void tdmf_take_from_runner(const int *places, int count, const double *of_runner, double *own) {
    for (int i = 0; i < count; ++i) {
        own[i] = of_runner[place_in(places, i)];
    }
}

void tdmf_give_to_runner(const int *places, int count, const double *own, double *of_runner) {
    for (int i = 0; i < count; ++i) {
        of_runner[place_in(places, i)] = own[i];
    }
}

int tdmf_place_of(const int *places, int count, int of_runner) {
    for (int i = 0; i < count; ++i) {
        if (place_in(places, i) == of_runner) {
            return i;
        }
    }
    return -1;
}

void tdmf_find_places(const tdmf_runner_page *page, int places[TDMF_RUNNER_STATES]) {
    for (int i = 0; i < TDMF_RUNNER_STATES; ++i) {
        places[i] = -1;
    }
    for (int i = 0; i < page->model->state_count; ++i) {
        places[place_in(page->states, i)] = i;
    }
}

int tdmf_mode_in_runner(const tdmf_runner_page *page, int mode) {
    return place_in(page->modes, mode);
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
