/* Jumps of quantities that change other states, such as the work of an actuator whose length is set. */
#ifndef TDMF_PAGE_JUMPS_H
#define TDMF_PAGE_JUMPS_H

#include "unit_instant.h"

/* Records that all jumps so far have had their effects. */
void account_for_all(fmu *fmu);

/* Whether a quantity has jumped since the last such record. */
bool quantity_has_jumped(const fmu *fmu);

/* Changes the states that depend on jumps since then, and records it. True where there was one. */
bool account_for_jumps(fmu *fmu);

/* Changes the states that depend on inputs that an importer's solver has moved along the last step. */
bool account_for_drifts(fmu *fmu);

/* Takes events that are due wherever their conditions hold, such as that an input acts: no indicator shows
 * them. */
void take_immediate_events(fmu *fmu);

#endif
