/* The ground of a page in an ensemble: steps and friction that are drawn for each stride, or a terrain. */
#ifndef TDMF_ENSEMBLE_GROUND_H
#define TDMF_ENSEMBLE_GROUND_H

#include "member.h"

/* The places of the ground on a page. */
tdmf_ground_places tdmf_places_of_ground(const tdmf_model_kind *model);

/* True if the ground of a page may vary. */
bool tdmf_has_ground(const tdmf_model_kind *model);

static inline bool tdmf_has_terrain(const tdmf_ensemble_rules *rules) {
    return rules->terrain.length != 0.0;
}

/* True if all segments are alike. The terrain then is a single segment without borders. */
bool tdmf_is_one_line(const tdmf_ensemble_rules *rules);

/* ---- requests ------------------------------------------------------------------------------------------ */

/* Checks the ground of a case. */
bool tdmf_is_sound_ground(tdmf_refusal *why, const tdmf_ensemble_case *its_case,
                          const tdmf_ensemble *ensemble);

/* Checks the positions of the feet. */
bool tdmf_are_foot_positions(tdmf_refusal *why, const tdmf_ensemble *ensemble);

/* ---- runs ---------------------------------------------------------------------------------------------- */

/* Attaches the terrain, if there is any, to the run, before the start. */
void tdmf_lay_ground(tdmf_member *member);

/* Writes the segment of a terrain below the foot into the states with which a run starts. */
void tdmf_enter_segment(const tdmf_member *member, double *states);

/* Writes the run's states in the world's coordinates. `states` may be the states of the run themselves. */
void tdmf_see_from_world(const tdmf_member *member, double *states);

/* True if the ground changes at apices. */
bool tdmf_draws_ground(const tdmf_member *member);

/* Draws the ground of the stride that begins. */
void tdmf_draw_ground(tdmf_member *member);

/* Height at x = 0 of the line that is set, which may wait until the foot is above it. */
double tdmf_ground_height(const tdmf_member *member);

/* True if feet trip on steps, and the foot is below the step that has just come. */
bool tdmf_has_tripped(const tdmf_member *member);

/* True if a line that was set still waits, because the foot is below it. */
bool tdmf_is_below_ground(const tdmf_member *member);

/* Writes the place of the foot, and counts the height of an apex from the segment below the foot. */
void tdmf_record_place(tdmf_member *member);

/* Write the line that is set into a checkpoint, and read it. */
void tdmf_save_ground(const tdmf_member *member, tdmf_ensemble_checkpoint *checkpoint);
void tdmf_load_ground(tdmf_member *member, const tdmf_ensemble_checkpoint *checkpoint);

#endif
