/* What a request has to be. */
#ifndef TDMF_ENSEMBLE_REQUEST_CHECKS_H
#define TDMF_ENSEMBLE_REQUEST_CHECKS_H

#include "tdmf_slip/ensemble.h"

bool tdmf_is_sound_ensemble(const tdmf_ensemble *ensemble, const tdmf_ensemble_end *ends);

/* An array of no elements may be absent. */
bool tdmf_is_array(const void *elements, int64_t count);

/* Whether weights are numbers that sums of products stand. */
bool tdmf_are_weights(const double *weights, int count);

/* Whether a setting is among others. */
bool tdmf_has_setting(const int *settings, int count, int setting);

#endif
