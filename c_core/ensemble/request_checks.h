/* Whether a request can be met. */
#ifndef TDMF_ENSEMBLE_REQUEST_CHECKS_H
#define TDMF_ENSEMBLE_REQUEST_CHECKS_H

#include "tdmf_slip/ensemble.h"

bool tdmf_is_sound_ensemble(const tdmf_ensemble *ensemble, const tdmf_ensemble_end *ends);

#endif
