/* The flights of the classic SLIP: from an apex to touchdown, and from take-off to the next apex, with their
 * variations. */
#ifndef TDMF_GAIT_CLASSIC_FLIGHT_H
#define TDMF_GAIT_CLASSIC_FLIGHT_H

#include "quantities.h"
#include "tdmf_slip/classic_slip.h"

/* What a step is varied by. */
typedef enum {
    TDMF_CLASSIC_BY_HEIGHT,
    TDMF_CLASSIC_BY_ENERGY,
    TDMF_CLASSIC_BY_TOUCHDOWN_ANGLE,
    TDMF_CLASSIC_BY_GROUND_SLOPE,
    TDMF_CLASSIC_BY_RETRACTION_RATE,
    TDMF_CLASSIC_VARIATIONS
} tdmf_classic_argument;

/* A foot that stands, from the apex before, with the leg's angle in which it came down, and the mass as seen
 * from it. */
typedef struct {
    double touchdown_angle;
    tdmf_classic_point at;
    tdmf_classic_point varied[TDMF_CLASSIC_VARIATIONS];
    double foot, foot_varied[TDMF_CLASSIC_VARIATIONS];
} tdmf_classic_standing;

/* Gives the ground, whose line passes through the foot. */
tdmf_ground_line tdmf_classic_ground(const tdmf_classic *slip);

/* Flies from an apex to touchdown. Returns TDMF_CLASSIC_FLIES where it gets there, TDMF_CLASSIC_NO_START
 * where it cannot begin, TDMF_CLASSIC_FALLS where the mass comes down before the foot. */
tdmf_classic_outcome tdmf_classic_land(const tdmf_classic *slip, double energy, double height,
                                       tdmf_classic_standing *standing);

/* Friction that the impact of an infinitesimal foot mass needs to stick (5). */
double tdmf_classic_impact_friction(const tdmf_classic *slip, tdmf_classic_point touchdown);

/* Flies from take-off to the next apex. */
void tdmf_classic_fly(const tdmf_classic *slip, const tdmf_classic_standing *standing,
                      tdmf_classic_step *step);

#endif
