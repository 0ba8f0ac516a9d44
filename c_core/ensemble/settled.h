/* Whether a runner has settled on a gait. */
#ifndef TDMF_ENSEMBLE_SETTLED_H
#define TDMF_ENSEMBLE_SETTLED_H

#include "member.h"

/* The gait that an apex at which a stride has closed is near, or in whose ball it is; -1 for none. */
int tdmf_gait_reached(const tdmf_member *member, const double apex[TDMF_POINT_LIMIT]);

/* The gait in whose ball an apex is, or -1. */
int tdmf_gait_of_ball(const tdmf_member *member, const double apex[TDMF_POINT_LIMIT]);

#endif
