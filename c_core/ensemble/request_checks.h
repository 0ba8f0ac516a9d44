/* Checks of a request to the ensemble. Like those of refusal.h, they write the refusal into `why`. */
#ifndef TDMF_ENSEMBLE_REQUEST_CHECKS_H
#define TDMF_ENSEMBLE_REQUEST_CHECKS_H

#include "refusal.h"
#include "tdmf_slip/ensemble.h"

bool tdmf_is_sound_ensemble(tdmf_refusal *why, const tdmf_ensemble *ensemble, const tdmf_ensemble_end *ends);

/* True if the model of the ensemble has lanes for the instructions, and the processor has them. */
bool tdmf_can_step(const tdmf_ensemble *ensemble);

/* Checks the weights of correlated deviates. */
bool tdmf_are_weights(tdmf_refusal *why, const char *name, const double *weights, const char *count_name,
                      int count);

/* True if a setting is in the list. */
bool tdmf_has_setting(const int *settings, int count, int setting);

#endif
