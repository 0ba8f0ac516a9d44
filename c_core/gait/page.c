/* Runs and return maps of models that are written as pages. */
#include "page_map.h"
#include "refusal.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const tdmf_model_kind *model_of(const tdmf_page *page) {
    return (const tdmf_model_kind *)page;
}

const char *tdmf_page_build(void) {
    return tdmf_build_identity;
}

const tdmf_page *tdmf_page_named(const char *name) {
    for (int i = 0; name && i < tdmf_page_count; ++i) {
        if (strcmp(name, tdmf_pages[i].name) == 0) {
            return (const tdmf_page *)tdmf_pages[i].whole.model;
        }
    }
    return NULL;
}

const tdmf_page_entry *tdmf_entry_of(const tdmf_page *page) {
    const tdmf_page_entry *entry = tdmf_pages;
    while (entry->whole.model != model_of(page)) {
        ++entry;
    }
    return entry;
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
        [TDMF_PAGE_OUTPUT] = {model->output_count, model->output_names},
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

/* ---- what a map is given ------------------------------------------------------------------------------- */

static bool are_finite(const double *values, int count) {
    double sum = 0.0; /* 0, or not a number */
    for (int i = 0; i < count; ++i) {
        sum += 0.0 * values[i];
    }
    return sum == 0.0;
}

bool tdmf_are_page_values_sound(const tdmf_model_kind *model, const double *parameters,
                                const double *states) {
    for (int i = 0; i < model->parameter_count; ++i) {
        if (!(parameters[i] >= model->parameter_least[i] && parameters[i] <= model->parameter_most[i])) {
            return false;
        }
    }
    return are_finite(states, model->state_count);
}

/* Numbers that have to be finite, by the name of their array or, with `names`, by their own. */
static bool are_numbers(tdmf_refusal *why, const char *array, const char *const *names, const double *values,
                        int count) {
    for (int i = 0; i < count; ++i) {
        if (!tdmf_accepts_element(why, names ? names[i] : array, i, values[i], -DBL_MAX, DBL_MAX)) {
            return false;
        }
    }
    return true;
}

static bool are_values_sound(tdmf_refusal *why, const tdmf_page_map *map) {
    const tdmf_model_kind *model = model_of(map->page);
    if (tdmf_are_page_values_sound(model, map->parameters, map->states)) {
        return true;
    }
    for (int i = 0; i < model->parameter_count; ++i) {
        if (!tdmf_accepts_number(why, model->parameter_names[i], "1", map->parameters[i],
                                 model->parameter_least[i], model->parameter_most[i])) {
            return false;
        }
    }
    return are_numbers(why, NULL, model->state_names, map->states, model->state_count);
}

/* A run from the start to given times needs no section. */
static bool is_sound_without_section(tdmf_refusal *why, const tdmf_page_map *map) {
    const tdmf_model_kind *model = map ? model_of(map->page) : NULL;
    return tdmf_accepts_pointer(why, "map", map) && tdmf_accepts_pointer(why, "page", model) &&
           tdmf_accepts_pointer(why, "parameters", map->parameters) &&
           tdmf_accepts_pointer(why, "states", map->states) &&
           tdmf_accepts_array(why, "d_parameters", map->d_parameters, "seed_count", map->seed_count,
                              TDMF_MAP_LIMIT) &&
           tdmf_accepts_number(why, "tolerance", "1", map->tolerance, 1e-16, 1e-2) &&
           tdmf_accepts_number(why, "longest", "s", map->longest, 0.0, DBL_MAX) &&
           tdmf_accepts_number(why, "step_limit", "1", (double)map->step_limit, 0.0, (double)LONG_MAX) &&
           tdmf_accepts_number(why, "event_room", "1", map->event_room, 0.0, INT_MAX) &&
           are_numbers(why, "d_parameters[]", NULL, map->d_parameters,
                       map->seed_count * model->parameter_count) &&
           (!map->d_states ||
            are_numbers(why, "d_states[]", NULL, map->d_states, map->seed_count * model->state_count));
}

bool tdmf_is_page_map_sound(tdmf_refusal *why, const tdmf_page_map *map) {
    return is_sound_without_section(why, map) && tdmf_accepts_number(why, "section", "1", map->section, 0.0,
                                                                     model_of(map->page)->section_count - 1);
}

bool tdmf_is_page_point_sound(const tdmf_section_kind *section, const double *point) {
    return point && are_finite(point, section->count);
}

static const tdmf_section_kind *section_of(const tdmf_page_map *map) {
    return &model_of(map->page)->sections[map->section];
}

static bool is_sound(tdmf_refusal *why, const tdmf_page_map *map, const double *point) {
    return tdmf_is_page_map_sound(why, map) && tdmf_accepts_pointer(why, "point", point) &&
           (tdmf_is_page_point_sound(section_of(map), point) ||
            are_numbers(why, "point[]", NULL, point, section_of(map)->count)) &&
           are_values_sound(why, map);
}

tdmf_refusal tdmf_page_check(const tdmf_page_map *map, const double *point) {
    tdmf_refusal why = {.code = TDMF_ACCEPTED};
    if (point) {
        is_sound(&why, map, point);
    } else if (is_sound_without_section(&why, map)) {
        are_values_sound(&why, map);
    }
    return why;
}

void tdmf_page_scales(const tdmf_page *page, const double *parameters, double *scales) {
    const tdmf_model_kind *model = model_of(page);
    double of_events[TDMF_PAGE_EVENT_LIMIT];
    if (model && parameters && scales) {
        model->scales(parameters, scales, of_events);
    }
}

/* ---- runs ---------------------------------------------------------------------------------------------- */

static tdmf_page_run run_of(const tdmf_page_map *map) {
    const long limit = 100000;
    const tdmf_page_run run = {.p = map->parameters,
                               .x = map->states,
                               .tolerance = map->tolerance,
                               .order = tdmf_page_order(map->tolerance),
                               .stop_event = -1,
                               .observes = map->is_unobserved ? TDMF_OBSERVE_NOTHING : TDMF_OBSERVE_USUAL,
                               .step_limit = map->step_limit > 0 ? map->step_limit : limit,
                               .event_limit = limit,
                               .seed_count = map->seed_count,
                               .dp = map->d_parameters,
                               .dx = map->d_states};
    return run;
}

static tdmf_page_end end_of(const tdmf_page_map *map, const tdmf_page_part *part, const tdmf_page_run *r,
                            tdmf_run_outcome outcome) {
    static const tdmf_page_outcome outcomes[] = {
        [TDMF_RUN_ARRIVED] = TDMF_PAGE_TOO_LONG,
        [TDMF_RUN_STOPPED] = TDMF_PAGE_CROSSED,
        [TDMF_RUN_ENDED] = TDMF_PAGE_ENDED,
        [TDMF_RUN_NO_PROGRESS] = TDMF_PAGE_UNSOLVED,
        [TDMF_RUN_TOO_MANY_STEPS] = TDMF_PAGE_UNSOLVED,
        [TDMF_RUN_ENDLESS_CHAIN] = TDMF_PAGE_UNSOLVED,
        [TDMF_RUN_TOO_MANY_EVENTS] = TDMF_PAGE_UNSOLVED,
        [TDMF_RUN_NO_MEMORY] = TDMF_PAGE_NO_MEMORY,
        [TDMF_RUN_CANCELLED] = TDMF_PAGE_CANCELLED,
        [TDMF_RUN_BAD_ORDER] = TDMF_PAGE_REFUSED,
        [TDMF_RUN_TOO_MANY_SEEDS] = TDMF_PAGE_REFUSED,
    };
    const int logged = r->log_count < map->event_room ? r->log_count : map->event_room;
    for (int i = 0; map->events && i < logged; ++i) {
        const tdmf_event_row *row = &r->log[i];
        map->events[i] =
            (tdmf_page_event){row->time, tdmf_event_in_whole(part, row->event),
                              tdmf_mode_in_whole(part, row->before), tdmf_mode_in_whole(part, row->after)};
    }
    return (tdmf_page_end){
        outcomes[outcome], tdmf_mode_in_whole(part, r->mode), r->time, (int)r->events, r->steps, 0};
}

int tdmf_unmet_requirement(const tdmf_page *page, const tdmf_page_run *r) {
    const tdmf_page_entry *entry = tdmf_entry_of(page);
    for (int k = 0; k < entry->requirement_count; ++k) {
        if (!(entry->requirements[k](r->p, r->x) >= 0.0)) {
            return k + 1;
        }
    }
    return 0;
}

static tdmf_page_end refused(int requirement) {
    return (tdmf_page_end){.outcome = TDMF_PAGE_REFUSED, .requirement = requirement};
}

/* Working memory of a call, which is allocated for large models only. */
enum { MEMORY = 8192 };

typedef struct {
    double own[MEMORY], *numbers;
} memory;

static double *open_memory(memory *of, size_t size) {
    of->numbers = size <= MEMORY ? of->own : malloc(size * sizeof(double));
    return of->numbers;
}

static void close_memory(memory *of) {
    if (of->numbers != of->own) {
        free(of->numbers);
    }
}

/* Numbers that the log of a run takes. */
static size_t size_of_log(const tdmf_page_map *map) {
    return map->events ? (size_t)map->event_room * sizeof(tdmf_event_row) / sizeof(double) : 0;
}

static void keep_log(const tdmf_page_map *map, tdmf_page_run *r, double *numbers) {
    r->log = (void *)numbers;
    r->log_states = NULL;
    r->log_size = map->events ? map->event_room : 0;
}

/* ---- strides ------------------------------------------------------------------------------------------- */

const tdmf_page_part *tdmf_part_for_stride(const tdmf_page_map *map) {
    const tdmf_page_entry *entry = tdmf_entry_of(map->page);
    const tdmf_model_kind *whole = entry->whole.model;
    bool suits = entry->plain && entry->plain->excess(map->parameters, map->states) == 0.0;
    for (int i = 0; suits && i < map->seed_count; ++i) {
        suits = tdmf_part_varies(entry->plain, whole, map->d_parameters + i * whole->parameter_count,
                                 map->d_states ? map->d_states + i * whole->state_count : NULL);
    }
    return suits ? entry->plain : &entry->whole;
}

/* Parameters, states and seeds of a map, as a part has them. */
static size_t size_of_numbers(const tdmf_page_map *map) {
    const tdmf_model_kind *model = model_of(map->page);
    return (size_t)(model->parameter_count + model->state_count) * (size_t)(1 + map->seed_count);
}

size_t tdmf_stride_memory_size(const tdmf_page_map *map, bool is_in_batch) {
    return size_of_numbers(map) + (is_in_batch ? tdmf_section_run_size : tdmf_section_memory_size)(
                                      model_of(map->page), map->section, map->seed_count);
}

tdmf_page_run tdmf_begin_page_stride(const tdmf_page_map *map, const tdmf_page_part *part,
                                     const double *point, bool varies, double *memory) {
    const tdmf_model_kind *whole = model_of(map->page);
    const int parameters = part->model->parameter_count, states = part->model->state_count;
    double *p = memory, *x = p + parameters, *dp = x + states, *dx = dp + map->seed_count * parameters;
    tdmf_page_run run = run_of(map);
    tdmf_take_parameters(part, map->parameters, p);
    tdmf_take_states(part, map->states, x);
    for (int i = 0; varies && i < map->seed_count; ++i) {
        tdmf_take_parameters(part, map->d_parameters + i * whole->parameter_count, dp + i * parameters);
        if (map->d_states) {
            tdmf_take_states(part, map->d_states + i * whole->state_count, dx + i * states);
        }
    }
    run.p = p;
    run.x = x;
    run.dp = dp;
    run.dx = map->d_states ? dx : NULL;
    const tdmf_section_map section = {part->model, map->section, &run, map->longest,
                                      memory + size_of_numbers(map)};
    return tdmf_run_from_section(&section, point, varies);
}

void tdmf_read_page_stride(const tdmf_page_map *map, const tdmf_page_part *part, const tdmf_page_run *r,
                           double *states, double *d_states) {
    const size_t size = (size_t)model_of(map->page)->state_count;
    memcpy(states, map->states, size * sizeof *states);
    tdmf_give_states(part, r->x, states);
    if (d_states) {
        memset(d_states, 0, (size_t)r->seed_count * size * sizeof *d_states);
    }
    for (int i = 0; d_states && i < r->seed_count; ++i) {
        tdmf_give_states(part, r->dx + i * part->model->state_count, d_states + (size_t)i * size);
    }
}

tdmf_page_end tdmf_end_of_page_stride(const tdmf_page_map *map, const tdmf_page_part *part,
                                      const tdmf_page_run *r, tdmf_run_outcome outcome) {
    const tdmf_section_map section = {.model = part->model, .section = map->section};
    return end_of(map, part, r, tdmf_outcome_at_section(&section, r, outcome));
}

tdmf_page_end tdmf_page_stride(const tdmf_page_map *map, const double *point, double *states,
                               double *d_states) {
    tdmf_refusal why;
    if (!is_sound(&why, map, point) || !states) {
        return refused(0);
    }
    const size_t size = tdmf_stride_memory_size(map, false);
    memory of;
    if (!open_memory(&of, size + size_of_log(map))) {
        return (tdmf_page_end){.outcome = TDMF_PAGE_NO_MEMORY};
    }
    const tdmf_page_part *part = tdmf_part_for_stride(map);
    tdmf_page_run r = tdmf_begin_page_stride(map, part, point, d_states != NULL, of.numbers);
    keep_log(map, &r, of.numbers + size);
    const int requirement = tdmf_unmet_requirement(map->page, &r);
    const tdmf_page_end end =
        requirement != 0
            ? refused(requirement)
            : tdmf_end_of_page_stride(map, part, &r, tdmf_page_run_to(part->model, &r, map->longest));
    tdmf_read_page_stride(map, part, &r, states, d_states);
    close_memory(&of);
    return end;
}

bool tdmf_page_fixed_point(const tdmf_page_map *map, double *point) {
    memory of;
    tdmf_refusal why;
    if (!is_sound(&why, map, point) ||
        !open_memory(&of, tdmf_section_memory_size(model_of(map->page), map->section, map->seed_count))) {
        return false;
    }
    const tdmf_page_run run = run_of(map);
    const tdmf_section_map section = {model_of(map->page), map->section, &run, map->longest, of.numbers};
    tdmf_crossing last;
    const tdmf_fixed_point found = tdmf_find_crossing(&section, point, &last);
    close_memory(&of);
    if (found.outcome == TDMF_FIXED_POINT_FOUND) {
        memcpy(point, found.point, (size_t)section_of(map)->count * sizeof *point);
    }
    return found.outcome == TDMF_FIXED_POINT_FOUND;
}

bool tdmf_page_place(const tdmf_page_map *map, const double *point, double *states) {
    tdmf_refusal why;
    if (!is_sound(&why, map, point) || !states) {
        return false;
    }
    const tdmf_model_kind *model = model_of(map->page);
    memcpy(states, map->states, (size_t)model->state_count * sizeof *states);
    section_of(map)->enter(map->parameters, map->states, point, states);
    return true;
}

/* ---- runs from the start ------------------------------------------------------------------------------- */

/* Writes a row of samples at the present states of a run. A mode that ends the run may keep the outputs of
 * the mode before; their states are then written into the memory of the run. */
static void write_sample(const tdmf_model_kind *model, const tdmf_page_run *r,
                         const tdmf_page_samples *samples, int row) {
    const tdmf_mode_kind *mode = &model->modes[r->mode];
    const tdmf_mode_kind *shown = &model->modes[mode->keeps_outputs ? r->left : r->mode];
    const bool is_seen_anew = shown != mode && shown->from_world;
    const size_t size = (size_t)model->state_count, outputs = (size_t)model->output_count;
    double *states = samples->states + (size_t)row * size, *x = is_seen_anew ? r->memory : r->x;
    memcpy(states, r->x, size * sizeof *states);
    if (mode->to_world) {
        mode->to_world(r->p, r->x, states);
    }
    if (is_seen_anew) {
        memcpy(x, states, size * sizeof *x);
        shown->from_world(r->p, states, x);
    }
    if (shown->outputs) {
        shown->outputs(r->p, x, samples->outputs + (size_t)row * outputs);
    }
    samples->modes[row] = r->mode;
    for (int seed = 0; samples->d_states && seed < r->seed_count; ++seed) {
        const size_t of_row = (size_t)row * (size_t)r->seed_count + (size_t)seed;
        const double *dp = r->dp + seed * model->parameter_count;
        double *own = r->dx + (size_t)seed * size, *varied = samples->d_states + of_row * size;
        double *dx = is_seen_anew ? r->memory + size : own;
        memcpy(varied, own, size * sizeof *varied);
        if (mode->vary_to_world) {
            mode->vary_to_world(r->p, r->x, dp, own, varied);
        }
        if (is_seen_anew) {
            memcpy(dx, varied, size * sizeof *dx);
            shown->vary_from_world(r->p, states, dp, varied, dx);
        }
        if (shown->vary_outputs) {
            shown->vary_outputs(r->p, x, dp, dx, samples->d_outputs + of_row * outputs);
        }
    }
}

static tdmf_run_outcome sample(const tdmf_model_kind *model, tdmf_page_run *r,
                               const tdmf_page_samples *samples, int *sampled) {
    tdmf_run_outcome outcome = TDMF_RUN_ARRIVED;
    for (*sampled = 0; *sampled < samples->count; ++*sampled) {
        outcome = outcome == TDMF_RUN_ENDED ? outcome : tdmf_page_run_to(model, r, samples->times[*sampled]);
        if (outcome != TDMF_RUN_ARRIVED && outcome != TDMF_RUN_ENDED) {
            break;
        }
        write_sample(model, r, samples, *sampled);
    }
    return outcome;
}

/* Times are finite, begin at 0 or later and do not decrease. */
static bool are_times(const double *times, int count) {
    for (int i = 0; i < count; ++i) {
        if (!isfinite(times[i]) || times[i] < (i > 0 ? times[i - 1] : 0.0)) {
            return false;
        }
    }
    return true;
}

static bool are_complete(tdmf_refusal *why, const tdmf_page_map *map, const tdmf_page_samples *samples,
                         const int *sampled) {
    return samples->count >= 0 && samples->times && samples->states && samples->outputs && samples->modes &&
           sampled && !samples->d_states == !samples->d_outputs &&
           are_times(samples->times, samples->count) &&
           (samples->point ? tdmf_is_page_map_sound(why, map) &&
                                 tdmf_is_page_point_sound(section_of(map), samples->point)
                           : is_sound_without_section(why, map));
}

/* Numbers that a run from the start, or from a point, takes. */
static size_t size_of_begun(const tdmf_page_map *map, const tdmf_page_samples *samples) {
    const tdmf_model_kind *model = model_of(map->page);
    const size_t seeds = samples && samples->d_states ? (size_t)map->seed_count : 0;
    return samples && samples->point
               ? tdmf_section_memory_size(model, map->section, (int)seeds)
               : (1 + seeds) * ((size_t)model->state_count + 1) + tdmf_run_memory_size(model, (int)seeds);
}

/* A run from the start, or from a point. It varies along the seeds where derivatives are sampled. */
static tdmf_page_run begun(const tdmf_page_map *map, const tdmf_page_samples *samples, double *numbers) {
    const tdmf_model_kind *model = model_of(map->page);
    const tdmf_page_run run = run_of(map);
    const size_t states = (size_t)model->state_count;
    tdmf_page_run r = run;
    if (samples && samples->point) {
        const tdmf_section_map section = {model, map->section, &run, map->longest, numbers};
        r = tdmf_run_from_section(&section, samples->point, samples->d_states != NULL);
        r.stop_event = -1;
        return r;
    }
    r.seed_count = samples && samples->d_states ? map->seed_count : 0;
    r.x = numbers;
    r.dx = r.x + states;
    r.shift = r.dx + (size_t)r.seed_count * states;
    r.memory = r.shift + r.seed_count;
    memcpy(r.x, map->states, states * sizeof *r.x);
    memset(r.dx, 0, (size_t)r.seed_count * (states + 1) * sizeof *r.dx);
    if (map->d_states) {
        memcpy(r.dx, map->d_states, (size_t)r.seed_count * states * sizeof *r.dx);
    }
    return r;
}

tdmf_page_end tdmf_page_begin(const tdmf_page_map *map, double *states, const tdmf_page_samples *samples,
                              int *sampled) {
    tdmf_refusal why;
    if (sampled) {
        *sampled = 0;
    }
    if (!(samples ? are_complete(&why, map, samples, sampled) : tdmf_is_page_map_sound(&why, map)) ||
        !states || !tdmf_are_page_values_sound(model_of(map->page), map->parameters, map->states)) {
        return refused(0);
    }
    const tdmf_model_kind *model = model_of(map->page);
    const size_t size = size_of_begun(map, samples);
    memory of;
    if (!open_memory(&of, size + size_of_log(map))) {
        return (tdmf_page_end){.outcome = TDMF_PAGE_NO_MEMORY};
    }
    tdmf_page_run r = begun(map, samples, of.numbers);
    keep_log(map, &r, of.numbers + size);
    if (!samples) {
        r.stop_event = section_of(map)->event;
    }
    const int requirement = tdmf_unmet_requirement(map->page, &r);
    tdmf_page_end end = refused(requirement);
    if (requirement == 0) {
        const tdmf_run_outcome outcome =
            samples ? sample(model, &r, samples, sampled) : tdmf_page_run_to(model, &r, map->longest);
        end = end_of(map, &tdmf_entry_of(map->page)->whole, &r, outcome);
    }
    memcpy(states, r.x, (size_t)model->state_count * sizeof *states);
    close_memory(&of);
    return end;
}
