/* What the apex of a flight makes of a run. */
#ifndef TDMF_MODEL_APEX_H
#define TDMF_MODEL_APEX_H

#include "events.h"

/* Goes on from retract to place, latches the section and closes the stride; a start at an apex does so too.
 */
void tdmf_pass_apex(tdmf_run *run);

#endif
