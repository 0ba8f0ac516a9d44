/* Tests whether a runner has settled on a gait. */
#ifndef TDMF_ENSEMBLE_SETTLED_H
#define TDMF_ENSEMBLE_SETTLED_H

#include "member.h"

/* The gait that is near an apex at which a stride has closed, or whose ball contains it; -1: none. */
int tdmf_gait_reached(const tdmf_member *member, const double apex[TDMF_POINT_LIMIT]);

/* The gait whose ball contains an apex; -1: none. */
int tdmf_gait_of_ball(const tdmf_member *member, const double apex[TDMF_POINT_LIMIT]);

#endif
