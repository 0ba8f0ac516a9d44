/* Touchdown. */
#ifndef TDMF_MODEL_TOUCHDOWN_H
#define TDMF_MODEL_TOUCHDOWN_H

#include "events.h"

/* The foot hits the ground. */
void tdmf_touch_down(tdmf_run *run);

#endif
