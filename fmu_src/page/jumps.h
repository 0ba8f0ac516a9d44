/* Jumps of quantities that change other states, such as the work of an actuator whose length is set. */
#ifndef TDMF_PAGE_JUMPS_H
#define TDMF_PAGE_JUMPS_H

#include "page_instant.h"

/* Notes that all jumps so far have changed what they have to change. */
void account_for_all(fmu *fmu);

/* Whether a quantity has jumped since. */
bool quantity_has_jumped(const fmu *fmu);

/* Changes the states that depend on such jumps, and notes that. True where there was one. */
bool account_for_jumps(fmu *fmu);

/* The same for inputs that an importer's solver has moved along the step behind. */
bool account_for_drifts(fmu *fmu);

#endif
