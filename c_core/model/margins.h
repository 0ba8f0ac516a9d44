/* How near to zero counts as zero: the margins and dead bands of all events, each in units of its quantity's
 * scale. That of guards, TDMF_GUARD_MARGIN, is public. */
#ifndef TDMF_MODEL_MARGINS_H
#define TDMF_MODEL_MARGINS_H

#include "tdmf_slip/automaton.h"

/* Half-width of the band around zero in which a quantity that may settle there counts as unchanged. */
#define TDMF_DEAD_BAND 1e-10

/* Up to this a start's distance from the ground and its velocity across it are zero, and so is the distance
 * of a foot from a ground that waits to be in force. */
#define TDMF_AT_GROUND 1e-12

/* Up to this a foot is on a border of a patch, which belongs to where the foot is going. */
#define TDMF_ON_BORDER 1e-12

/* The layer in which friction falls is so wide, in v_s: e^-60 is 1e-26. In it a step changes the foot's speed
 * by so many v_s at the most, and lasts so long, in 1/kappa: up to there an exponential's series of the least
 * order that steps have is as good as their tolerance. */
#define TDMF_LAYER_WIDTH     60.0
#define TDMF_CHANGE_IN_LAYER 3.0
#define TDMF_GROWTH_IN_LAYER 3.0

/* A layer narrower than this is refused: its v_s would be near to the margins in which a velocity counts as
 * zero, and a slip that it ends would not be told from one that begins. */
#define TDMF_NARROWEST_LAYER 1e-11

/* The apex has a margin of its own, for a centre of mass that rises. */
#define TDMF_APEX_MARGIN (1e-3 * TDMF_GUARD_MARGIN)

/* A start in flight with a vertical velocity of the centre of mass up to this is an apex. */
#define TDMF_APEX_AT_START 1e-12

/* At lift-off P(stance) is 0 up to rounding. Where the laws agree to within this, a graze would have no width
 * and the run would go round in it for ever. */
#define TDMF_NARROWEST_GRAZE 1e-10

/* A force of contact that is further below zero than this, in units of k l0, has not vanished but jumped: no
 * solver locates a lift-off so coarsely. */
#define TDMF_UNLOADED_FORCE 1e-7

/* sin(theta) with its zero kept out of the denominator; the band between the laws closes before it. */
#define TDMF_SMALLEST_SINE 1e-12

#endif
