/* Places of a part of a page in the tables of the whole page, and copies by them. */
#include "page_part.h"

static int place_in(const int *places, int i) {
    return places ? places[i] : i;
}

static int place_of(const int *places, int count, int of_whole) {
    for (int i = 0; i < count; ++i) {
        if (place_in(places, i) == of_whole) {
            return i;
        }
    }
    return -1;
}

int tdmf_mode_in_whole(const tdmf_page_part *part, int own) {
    return place_in(part->modes, own);
}

int tdmf_event_in_whole(const tdmf_page_part *part, int own) {
    return place_in(part->events, own);
}

int tdmf_parameter_on_part(const tdmf_page_part *part, int of_whole) {
    return place_of(part->parameters, part->model->parameter_count, of_whole);
}

int tdmf_state_on_part(const tdmf_page_part *part, int of_whole) {
    return place_of(part->states, part->model->state_count, of_whole);
}

int tdmf_mode_on_part(const tdmf_page_part *part, int of_whole) {
    return place_of(part->modes, part->model->mode_count, of_whole);
}

int tdmf_event_on_part(const tdmf_page_part *part, int of_whole) {
    return place_of(part->events, part->model->event_count, of_whole);
}

static bool has_all(const int *places, int own_count, const double *of_whole, int count) {
    for (int i = 0; of_whole && i < count; ++i) {
        if (of_whole[i] != 0.0 && place_of(places, own_count, i) < 0) {
            return false;
        }
    }
    return true;
}

bool tdmf_part_varies(const tdmf_page_part *part, const tdmf_model_kind *whole, const double *dp,
                      const double *dx) {
    return has_all(part->parameters, part->model->parameter_count, dp, whole->parameter_count) &&
           has_all(part->states, part->model->state_count, dx, whole->state_count);
}

uint64_t tdmf_events_in_whole(const tdmf_page_part *part, uint64_t own) {
    uint64_t of_whole = 0;
    for (int i = 0; i < part->model->event_count; ++i) {
        of_whole |= (own >> i & 1) << place_in(part->events, i);
    }
    return of_whole;
}

uint64_t tdmf_events_on_part(const tdmf_page_part *part, uint64_t of_whole) {
    uint64_t own = 0;
    for (int i = 0; i < part->model->event_count; ++i) {
        own |= (of_whole >> place_in(part->events, i) & 1) << i;
    }
    return own;
}

static void take(const int *places, int count, const double *of_whole, double *own) {
    for (int i = 0; i < count; ++i) {
        own[i] = of_whole[place_in(places, i)];
    }
}

static void give(const int *places, int count, const double *own, double *of_whole) {
    for (int i = 0; i < count; ++i) {
        of_whole[place_in(places, i)] = own[i];
    }
}

void tdmf_take_parameters(const tdmf_page_part *part, const void *of_whole, double *own) {
    take(part->parameters, part->model->parameter_count, of_whole, own);
}

void tdmf_take_states(const tdmf_page_part *part, const void *of_whole, double *own) {
    take(part->states, part->model->state_count, of_whole, own);
}

void tdmf_give_parameters(const tdmf_page_part *part, const double *own, void *of_whole) {
    give(part->parameters, part->model->parameter_count, own, of_whole);
}

void tdmf_give_states(const tdmf_page_part *part, const double *own, void *of_whole) {
    double *states = of_whole;
    give(part->states, part->model->state_count, own, states);
    for (int i = 0; i < part->copy_count; ++i) {
        states[part->copies[i][0]] = states[part->copies[i][1]];
    }
}
