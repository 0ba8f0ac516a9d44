/* The ground of a page: its names are those of c_core/pages/ground.py. */
#include "ground.h"

#include "drawn_ground.h"

#include <math.h>
#include <string.h>

/* The number of a segment is exact up to here. */
static const double last_segment = 1e15;

/* Stands for the friction that is set. */
static const double own_friction = -1.0;

/* ---- the page ------------------------------------------------------------------------------------------ */

static int place_of(const char *const *names, int count, const char *name) {
    int place = count - 1;
    while (place >= 0 && strcmp(names[place], name) != 0) {
        --place;
    }
    return place;
}

tdmf_ground_places tdmf_places_of_ground(const tdmf_model_kind *m) {
    const tdmf_ground_places places = {
        .begins = place_of(m->event_names, m->event_count, "begins"),
        .segments = place_of(m->table_names, m->table_count, "ground_segment"),
        .height = place_of(m->parameter_names, m->parameter_count, "ground_height"),
        .slope = place_of(m->parameter_names, m->parameter_count, "ground_slope"),
        .trips = place_of(m->parameter_names, m->parameter_count, "trips"),
        .keeps_friction = place_of(m->parameter_names, m->parameter_count, "keeps_friction"),
        .friction = place_of(m->state_names, m->state_count, "friction"),
        .external_fx = place_of(m->state_names, m->state_count, "external_fx"),
        .external_fy = place_of(m->state_names, m->state_count, "external_fy"),
        .line_height = place_of(m->state_names, m->state_count, "height"),
        .line_slope = place_of(m->state_names, m->state_count, "slope"),
        .segment = place_of(m->state_names, m->state_count, "segment"),
        .segment_height = place_of(m->state_names, m->state_count, "segment_height"),
        .foot_x = place_of(m->state_names, m->state_count, "seen_x"),
        .foot_y = place_of(m->state_names, m->state_count, "seen_y"),
        .apex_height = place_of(m->state_names, m->state_count, "apex_com_height"),
    };
    return places;
}

bool tdmf_has_ground(const tdmf_model_kind *model) {
    const tdmf_ground_places g = tdmf_places_of_ground(model);
    return g.begins >= 0 && g.segments >= 0 && g.height >= 0 && g.trips >= 0 && g.keeps_friction >= 0 &&
           g.friction >= 0 && g.line_height >= 0 && g.segment >= 0 && g.segment_height >= 0 &&
           g.foot_x >= 0 && g.foot_y >= 0 && model->table_count <= TDMF_TABLE_LIMIT &&
           model->state_count <= TDMF_PLACE_LIMIT && model->parameter_count <= TDMF_PLACE_LIMIT;
}

bool tdmf_page_has_ground(const tdmf_page *page) {
    return page && tdmf_has_ground((const tdmf_model_kind *)page);
}

/* A number of the page, which is 0 where the page does not have it. */
static double at(const double *numbers, int place) {
    return place < 0 ? 0.0 : numbers[place];
}

/* ---- terrain ------------------------------------------------------------------------------------------- */

bool tdmf_is_one_line(const tdmf_ensemble_rules *rules) {
    return rules->roughness == 0.0 && rules->friction_spread == 0.0 && !rules->terrain.heights;
}

static double height_given(const tdmf_terrain *terrain, uint64_t runner, int64_t segment) {
    const int64_t count = terrain->height_count;
    const int64_t first = (int64_t)(runner % (uint64_t)count);
    const int64_t shifted = (segment % count + first) % count;
    return terrain->heights[shifted < 0 ? shifted + count : shifted];
}

/* An entry of the table `ground_segment`: begin, end, height, slope, friction. */
static double entry(const void *context, double row, int column) {
    const tdmf_member *member = context;
    const tdmf_ensemble_rules *rules = &member->its_case->rules;
    const int64_t segment = (int64_t)fmin(fmax(row, -last_segment), last_segment);
    switch (column) {
    case 0:
    case 1:
        return tdmf_is_one_line(rules) ? (column - 0.5) * INFINITY : (row + column) * rules->terrain.length;
    case 2:
        return rules->terrain.heights ? height_given(&rules->terrain, member->number, segment)
                                      : tdmf_segment_height(rules, member->number, segment);
    case 3:
        return 0.0;
    default:
        return rules->friction_spread == 0.0
                   ? own_friction
                   : tdmf_drawn_friction(rules, member->held[member->ground.friction], member->number,
                                         (uint32_t)segment);
    }
}

void tdmf_lay_ground(tdmf_member *member) {
    const tdmf_ensemble_rules *rules = &member->its_case->rules;
    const tdmf_ground_places *places = &member->ground;
    member->run->tables = NULL;
    if (tdmf_has_terrain(rules) && places->segments >= 0) { /* a page of one line has no table */
        const tdmf_table segments = {.entry = entry, .context = member};
        member->tables[places->segments] = segments;
        member->run->tables = member->tables;
        member->run->p[places->trips] = rules->trips;
        member->run->p[places->keeps_friction] = true;
    }
}

/* The event of the start enters the segment from the one before. */
void tdmf_enter_segment(const tdmf_member *member, double *states) {
    if (member->run->tables) {
        const double number = floor(member->end->foot_x / member->its_case->rules.terrain.length);
        const double segment = fmin(fmax(number, -last_segment), last_segment);
        states[member->ground.segment] = segment - 1.0;
        states[member->ground.segment_height] = entry(member, segment, 2);
    }
}

/* ---- ground by the stride ------------------------------------------------------------------------------ */

static bool steps_by_stride(const tdmf_member *member) {
    const tdmf_ensemble_rules *rules = &member->its_case->rules;
    return rules->roughness != 0.0 && !tdmf_has_terrain(rules);
}

static bool slips_by_stride(const tdmf_member *member) {
    const tdmf_ensemble_rules *rules = &member->its_case->rules;
    return rules->friction_spread != 0.0 && !tdmf_has_terrain(rules);
}

bool tdmf_draws_ground(const tdmf_member *member) {
    return steps_by_stride(member) || slips_by_stride(member);
}

void tdmf_draw_ground(tdmf_member *member) {
    const tdmf_ensemble_rules *rules = &member->its_case->rules;
    const tdmf_ground_places *places = &member->ground;
    const uint32_t stride = (uint32_t)member->end->strides;
    if (steps_by_stride(member)) {
        const double before = member->run->p[places->height];
        tdmf_member_set(member, false, places->height,
                        before + tdmf_drawn_step(rules, member->number, stride));
    }
    if (slips_by_stride(member)) {
        tdmf_member_set(member, true, places->friction,
                        tdmf_drawn_friction(rules, member->held[places->friction], member->number, stride));
    }
}

double tdmf_ground_height(const tdmf_member *member) {
    return at(member->run->p, member->ground.height) + at(member->run->x, member->ground.segment_height);
}

void tdmf_see_from_world(const tdmf_member *member, double *states) {
    double world[TDMF_PLACE_LIMIT];
    const tdmf_page_run *run = member->run;
    const tdmf_mode_kind *mode = &member->page.model->modes[run->mode];
    const size_t size = (size_t)member->page.model->state_count * sizeof *world;
    memcpy(world, run->x, size);
    if (mode->to_world) {
        mode->to_world(run->p, run->x, world);
    }
    memcpy(states, world, size);
}

bool tdmf_has_tripped(const tdmf_member *member) {
    double world[TDMF_PLACE_LIMIT];
    if (!steps_by_stride(member) || !member->its_case->rules.trips) {
        return false;
    }
    tdmf_see_from_world(member, world);
    const double slope = at(member->run->p, member->ground.slope);
    const double x = world[member->ground.foot_x], y = world[member->ground.foot_y];
    return cos(slope) * (y - tdmf_ground_height(member)) - sin(slope) * x < 0.0;
}

bool tdmf_is_below_ground(const tdmf_member *member) {
    const bool may_wait = tdmf_has_settings(member) || steps_by_stride(member);
    const double *p = member->run->p, *x = member->run->x;
    return may_wait && !tdmf_has_terrain(&member->its_case->rules) &&
           (tdmf_ground_height(member) != at(x, member->ground.line_height) ||
            at(p, member->ground.slope) != at(x, member->ground.line_slope));
}

void tdmf_record_place(tdmf_member *member) {
    double world[TDMF_PLACE_LIMIT];
    const tdmf_section_kind *section = member->section;
    const tdmf_ground_places *places = &member->ground;
    tdmf_see_from_world(member, world);
    member->end->foot_x = world[places->foot_x];
    for (int i = 0; i < section->count && tdmf_has_terrain(&member->its_case->rules); ++i) {
        if (section->coordinates[i] == places->apex_height) {
            member->end->apex[i] += at(member->run->x, places->line_height) - tdmf_ground_height(member);
        }
    }
}

/* ---- checkpoints --------------------------------------------------------------------------------------- */

void tdmf_save_ground(const tdmf_member *member, tdmf_ensemble_checkpoint *checkpoint) {
    checkpoint->ground_height = at(member->run->p, member->ground.height);
    checkpoint->ground_slope = at(member->run->p, member->ground.slope);
}

void tdmf_load_ground(tdmf_member *member, const tdmf_ensemble_checkpoint *checkpoint) {
    if (member->ground.height >= 0) {
        member->run->p[member->ground.height] = checkpoint->ground_height;
    }
    if (member->ground.slope >= 0) {
        member->run->p[member->ground.slope] = checkpoint->ground_slope;
    }
}
