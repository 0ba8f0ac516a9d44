/* A run from a point of a section to its event, whose variations are on the guard of the event. */
#include "section.h"

#include <string.h>

/* Starts a run on the section, with the variations of all seeds. */
static void enter(const tdmf_section_map *map, const double *point, tdmf_page_run *r) {
    const tdmf_model_kind *model = map->model;
    const tdmf_section_kind *kind = &model->sections[map->section];
    const size_t size = (size_t)model->state_count * sizeof *r->x;
    memcpy(r->x, map->run->x, size);
    kind->enter(r->p, map->run->x, point, r->x);
    for (int seed = 0; seed < r->seed_count; ++seed) {
        const double *dp = r->dp + seed * model->parameter_count;
        double *dx = r->dx + seed * model->state_count, along[TDMF_MAP_LIMIT] = {0.0};
        const int own = seed - kind->count;
        memset(dx, 0, size);
        if (own < 0) {
            along[seed] = 1.0;
        } else if (map->run->dx) {
            memcpy(dx, map->run->dx + own * model->state_count, size);
        }
        kind->vary_enter(r->p, map->run->x, dp, map->run->dx && own >= 0 ? dx : r->shift + r->seed_count,
                         point, along, dx);
    }
}

/* Numbers of a run with so many coordinates and seeds. */
static size_t size_of_run(const tdmf_model_kind *model, int seeds) {
    return (size_t)(2 + seeds) * (size_t)model->state_count +
           (size_t)seeds * (size_t)(model->parameter_count + 1);
}

size_t tdmf_section_run_size(const tdmf_model_kind *model, int section, int seed_count) {
    return size_of_run(model, model->sections[section].count + seed_count);
}

size_t tdmf_section_memory_size(const tdmf_model_kind *model, int section, int seed_count) {
    const int seeds = model->sections[section].count + seed_count;
    const size_t for_scales = (size_t)model->state_count + (size_t)model->event_count;
    const size_t size = size_of_run(model, seeds) + tdmf_run_memory_size(model, seeds);
    return size > for_scales ? size : for_scales;
}

/* A run with variations by the coordinates, then by the seeds, in the memory of the map. */
static tdmf_page_run run_with_seeds(const tdmf_section_map *map, bool varies) {
    const tdmf_model_kind *model = map->model;
    const int states = model->state_count, parameters = model->parameter_count;
    const int coordinates = map->model->sections[map->section].count;
    tdmf_page_run r = *map->run;
    r.log_size = r.sample_count = 0;
    r.seed_count = varies ? coordinates + map->run->seed_count : 0;
    memset(map->memory, 0, size_of_run(model, r.seed_count) * sizeof *r.x);
    r.memory = map->memory + size_of_run(model, r.seed_count);
    r.x = map->memory;
    r.dx = r.x + states;
    r.shift = r.dx + r.seed_count * states; /* behind it are zeros for states that do not vary */
    double *dp = r.shift + r.seed_count + states;
    if (map->run->dp && varies) {
        const size_t size = (size_t)map->run->seed_count * (size_t)parameters * sizeof *dp;
        memcpy(dp + coordinates * parameters, map->run->dp, size);
    }
    r.dp = dp;
    r.stop_event = model->sections[map->section].event;
    return r;
}

tdmf_page_run tdmf_run_from_section(const tdmf_section_map *map, const double *point, bool varies) {
    tdmf_page_run r = run_with_seeds(map, varies);
    enter(map, point, &r);
    return r;
}

tdmf_run_outcome tdmf_outcome_at_section(const tdmf_section_map *map, const tdmf_page_run *r,
                                         tdmf_run_outcome outcome) {
    const bool is_crossing = r->taken >> map->model->sections[map->section].event & 1u;
    return outcome == TDMF_RUN_ENDED && is_crossing ? TDMF_RUN_STOPPED : outcome;
}

static void read_crossing(const tdmf_section_kind *kind, int state_count, const tdmf_page_run *r,
                          tdmf_crossing *crossing) {
    crossing->mode = r->mode;
    crossing->time = r->time;
    for (int i = 0; i < kind->count; ++i) {
        crossing->next[i] = r->x[kind->coordinates[i]];
        for (int seed = 0; seed < r->seed_count; ++seed) {
            crossing->varied[i][seed] = r->dx[seed * state_count + kind->coordinates[i]];
        }
    }
}

tdmf_crossing tdmf_next_crossing(const tdmf_section_map *map, const double *point, bool varies, double *x,
                                 double *dx) {
    const tdmf_model_kind *model = map->model;
    const tdmf_section_kind *kind = &model->sections[map->section];
    const int seeds = varies ? kind->count + map->run->seed_count : 0, states = model->state_count;
    tdmf_crossing crossing = {.outcome = TDMF_RUN_TOO_MANY_SEEDS};
    if (seeds > TDMF_VARIED_LIMIT) {
        return crossing;
    }
    tdmf_page_run r = tdmf_run_from_section(map, point, varies);
    crossing.outcome = tdmf_outcome_at_section(map, &r, tdmf_page_run_to(model, &r, map->longest));
    read_crossing(kind, states, &r, &crossing);
    if (x) {
        memcpy(x, r.x, (size_t)states * sizeof *x);
    }
    if (dx) {
        memcpy(dx, r.dx, (size_t)(seeds * states) * sizeof *dx);
    }
    return crossing;
}

/* ---- fixed points -------------------------------------------------------------------------------------- */

typedef struct {
    const tdmf_section_map *map;
    tdmf_crossing crossings[2];
} search;

static bool evaluate(void *context, int slot, tdmf_image *image) {
    search *s = context;
    tdmf_crossing *crossing = &s->crossings[slot];
    *crossing = tdmf_next_crossing(s->map, image->point, true, NULL, NULL);
    for (int i = 0; i < s->map->model->sections[s->map->section].count; ++i) {
        image->next[i] = crossing->next[i];
        memcpy(image->jacobian[i], crossing->varied[i], sizeof image->jacobian[i]);
    }
    return crossing->outcome == TDMF_RUN_STOPPED;
}

tdmf_fixed_point tdmf_find_crossing(const tdmf_section_map *map, const double *guess, tdmf_crossing *last) {
    const tdmf_model_kind *model = map->model;
    const tdmf_section_kind *kind = &model->sections[map->section];
    search s = {.map = map};
    tdmf_map newton = {.count = kind->count, .evaluate = evaluate, .context = &s};
    model->scales(map->run->p, map->memory, map->memory + model->state_count);
    for (int i = 0; i < kind->count; ++i) {
        newton.scales[i] = map->memory[kind->coordinates[i]];
    }
    const tdmf_fixed_point found = tdmf_find_fixed_point(&newton, guess);
    *last = s.crossings[found.slot];
    return found;
}
