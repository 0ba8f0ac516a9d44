/* Segments of a terrain: their borders, heights, and frictions where these are drawn. */
#include "terrain.h"

#include "drawn_ground.h"

#include <math.h>

/* The number of a segment is exact up to here. */
static const double last_segment = 1e15;

/* Stands for the friction that is set. */
static const double own_friction = -1.0;

static double height_given(const tdmf_terrain *terrain, uint64_t runner, int64_t segment) {
    const int64_t count = terrain->height_count;
    const int64_t first = (int64_t)(runner % (uint64_t)count);
    const int64_t shifted = (segment % count + first) % count;
    return terrain->heights[shifted < 0 ? shifted + count : shifted];
}

bool tdmf_is_one_line(const tdmf_ensemble_rules *rules) {
    return rules->roughness == 0.0 && rules->friction_spread == 0.0 && !rules->terrain.heights;
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
                   : tdmf_drawn_friction(rules, member->its_case->inputs.ground.friction, member->number,
                                         (uint32_t)segment);
    }
}

void tdmf_lay_terrain(tdmf_member *member) {
    const tdmf_table ground = {.entry = entry, .context = member};
    member->ground = ground;
    member->run->tables = tdmf_has_terrain(&member->its_case->rules) ? &member->ground : NULL;
}

void tdmf_enter_terrain(const tdmf_member *member, double foot_x, runner_states *x) {
    const double length = member->its_case->rules.terrain.length;
    const double segment = fmin(fmax(floor(foot_x / length), -last_segment), last_segment);
    x->segment = segment;
    x->segment_begin = entry(member, segment, 0);
    x->segment_end = entry(member, segment, 1);
    x->segment_height = entry(member, segment, 2);
    x->friction_ahead = x->friction_behind = entry(member, segment, 4);
}
