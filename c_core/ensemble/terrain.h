/* Terrain below a runner: level segments of one length, as a page's table. */
#ifndef TDMF_ENSEMBLE_TERRAIN_H
#define TDMF_ENSEMBLE_TERRAIN_H

#include "member.h"
#include "runner_pages.h"

static inline bool tdmf_has_terrain(const tdmf_ensemble_rules *rules) {
    return rules->terrain.length != 0.0;
}

/* True if all segments are alike. The terrain then is a single segment without borders. */
bool tdmf_is_one_line(const tdmf_ensemble_rules *rules);

/* Attaches the terrain, if there is any, to the run. */
void tdmf_lay_terrain(tdmf_member *member);

/* Puts a runner on the segment below its foot, before the start. */
void tdmf_enter_terrain(const tdmf_member *member, double foot_x, runner_states *x);

#endif
