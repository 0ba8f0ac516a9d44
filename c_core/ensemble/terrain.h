/* Terrain below a runner: level segments, and the two heights of them between which the foot is. */
#ifndef TDMF_ENSEMBLE_TERRAIN_H
#define TDMF_ENSEMBLE_TERRAIN_H

#include "tdmf_slip/ensemble.h"

/* Heights of segments that were looked up last. */
enum { TDMF_KNOWN_SEGMENTS = 64 };
typedef struct {
    double x, y; /* of the foot, where its segment was looked at last */
    int64_t segments[TDMF_KNOWN_SEGMENTS];
    double heights[TDMF_KNOWN_SEGMENTS];
} tdmf_terrain_view;

typedef struct tdmf_runner tdmf_runner;

static inline bool tdmf_has_terrain(const tdmf_ensemble_rules *rules) {
    return rules->terrain.length != 0.0;
}

/* Gives the height of the segment below the foot. */
double tdmf_height_below(tdmf_runner *runner);

/* The runner is about to start with its foot over this place. Returns the height of the segment there. */
double tdmf_enter_terrain(tdmf_runner *runner, double x);

/* The runner goes on from an apex; its foot was at this place when its segment was looked at last. */
void tdmf_resume_terrain(tdmf_runner *runner, double x, double y);

/* Sets the lines that the foot in flight can come to next. False where the runner has ended: the foot has
 * met a face, or is farther from the centre of mass than is looked at. */
bool tdmf_look_at_terrain(tdmf_runner *runner);

/* To be called where the foot has come to the line in force: whether the segment below the foot is there, and
 * so a touchdown due. Else its lines are set anew, or the runner has ended, which `ended` tells. */
bool tdmf_meets_segment(tdmf_runner *runner, bool *ended);

#endif
