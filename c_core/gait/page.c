/* Return maps of models that are written as pages. */
#include "tdmf_slip/page.h"

#include "section.h"

#include <math.h>
#include <string.h>

extern const tdmf_model_kind tdmf_classic_slip_model, tdmf_reduced_runner_model;

static const tdmf_model_kind *model_of(const tdmf_page *page) {
    return (const tdmf_model_kind *)page;
}

const tdmf_page *tdmf_page_named(const char *name) {
    static const struct {
        const char *name;
        const tdmf_model_kind *model;
    } pages[] = {{"classic_slip", &tdmf_classic_slip_model}, {"reduced_runner", &tdmf_reduced_runner_model}};
    for (size_t i = 0; name && i < sizeof pages / sizeof *pages; ++i) {
        if (strcmp(name, pages[i].name) == 0) {
            return (const tdmf_page *)pages[i].model;
        }
    }
    return NULL;
}

const char *tdmf_page_name(const tdmf_page *page, tdmf_page_item kind, int number) {
    const tdmf_model_kind *model = model_of(page);
    if (!model) {
        return NULL;
    }
    const struct {
        int count;
        const char *const *names;
    } lists[] = {
        [TDMF_PAGE_PARAMETER] = {model->parameter_count, model->parameter_names},
        [TDMF_PAGE_STATE] = {model->state_count, model->state_names},
        [TDMF_PAGE_MODE] = {model->mode_count, model->mode_names},
        [TDMF_PAGE_EVENT] = {model->event_count, model->event_names},
        [TDMF_PAGE_SECTION] = {model->section_count, model->section_names},
    };
    const bool is_there =
        (unsigned)kind < sizeof lists / sizeof *lists && number >= 0 && number < lists[(unsigned)kind].count;
    return is_there ? lists[(unsigned)kind].names[number] : NULL;
}

void tdmf_page_defaults(const tdmf_page *page, double *parameters, double *states) {
    const tdmf_model_kind *model = model_of(page);
    if (model && parameters) {
        memcpy(parameters, model->parameter_defaults, (size_t)model->parameter_count * sizeof *parameters);
    }
    if (model && states) {
        memcpy(states, model->state_defaults, (size_t)model->state_count * sizeof *states);
    }
}

void tdmf_page_range(const tdmf_page *page, int parameter, double *least, double *most) {
    const tdmf_model_kind *model = model_of(page);
    if (tdmf_page_name(page, TDMF_PAGE_PARAMETER, parameter) && least && most) {
        *least = model->parameter_least[parameter];
        *most = model->parameter_most[parameter];
    }
}

/* Working memory for the library's largest page with all seeds, which a test runs. */
enum { MEMORY = 8192 };

static bool are_finite(const double *values, int count) {
    double sum = 0.0; /* 0, or not a number */
    for (int i = 0; i < count; ++i) {
        sum += 0.0 * values[i];
    }
    return sum == 0.0;
}

static bool is_sound(const tdmf_page_map *map, const double *point) {
    const tdmf_model_kind *model = map ? model_of(map->page) : NULL;
    if (!model || !point || !map->parameters || !map->states || map->section < 0 ||
        map->section >= model->section_count || map->seed_count < 0 || map->seed_count > TDMF_MAP_LIMIT ||
        (map->seed_count > 0 && !map->d_parameters)) {
        return false;
    }
    for (int i = 0; i < model->parameter_count; ++i) {
        if (!(map->parameters[i] >= model->parameter_least[i] &&
              map->parameters[i] <= model->parameter_most[i])) {
            return false;
        }
    }
    return map->tolerance >= 1e-16 && map->tolerance <= 1e-2 && map->longest >= 0.0 &&
           isfinite(map->longest) &&
           tdmf_section_memory_size(model, map->section, map->seed_count) <= MEMORY &&
           are_finite(map->states, model->state_count) &&
           are_finite(map->d_parameters, map->seed_count * model->parameter_count) &&
           are_finite(point, model->sections[map->section].count);
}

static tdmf_page_run run_of(const tdmf_page_map *map) {
    const tdmf_page_run run = {.p = map->parameters,
                               .x = map->states,
                               .tolerance = map->tolerance,
                               .order = tdmf_page_order(map->tolerance),
                               .observes = true,
                               .step_limit = 100000,
                               .event_limit = 100000,
                               .seed_count = map->seed_count,
                               .dp = map->d_parameters};
    return run;
}

static tdmf_section_map section_of(const tdmf_page_map *map, const tdmf_page_run *run,
                                   double memory[MEMORY]) {
    const tdmf_section_map section = {model_of(map->page), map->section, run, map->longest, memory};
    return section;
}

tdmf_page_end tdmf_page_stride(const tdmf_page_map *map, const double *point, double *states,
                               double *d_states) {
    if (!is_sound(map, point) || !states) {
        return (tdmf_page_end){.outcome = TDMF_PAGE_REFUSED};
    }
    const tdmf_page_run run = run_of(map);
    double memory[MEMORY];
    const tdmf_section_map section = section_of(map, &run, memory);
    const tdmf_crossing crossing = tdmf_next_crossing(&section, point, d_states != NULL, states, d_states);
    const tdmf_page_outcome outcome = crossing.outcome == TDMF_RUN_STOPPED   ? TDMF_PAGE_CROSSED
                                      : crossing.outcome == TDMF_RUN_ENDED   ? TDMF_PAGE_ENDED
                                      : crossing.outcome == TDMF_RUN_ARRIVED ? TDMF_PAGE_TOO_LONG
                                                                             : TDMF_PAGE_UNSOLVED;
    return (tdmf_page_end){outcome, crossing.mode, crossing.time};
}

bool tdmf_page_fixed_point(const tdmf_page_map *map, double *point) {
    if (!is_sound(map, point)) {
        return false;
    }
    const tdmf_page_run run = run_of(map);
    double memory[MEMORY];
    const tdmf_section_map section = section_of(map, &run, memory);
    tdmf_crossing last;
    const tdmf_fixed_point found = tdmf_find_crossing(&section, point, &last);
    if (found.outcome == TDMF_FIXED_POINT_FOUND) {
        memcpy(point, found.point, (size_t)section.model->sections[map->section].count * sizeof *point);
    }
    return found.outcome == TDMF_FIXED_POINT_FOUND;
}
