/* Checks of a request for runners: functions of tdmf_member_kind. */
#ifndef TDMF_ENSEMBLE_RUNNER_CHECKS_H
#define TDMF_ENSEMBLE_RUNNER_CHECKS_H

#include "tdmf_slip/ensemble.h"

bool tdmf_are_sound_runners(tdmf_refusal *why, const tdmf_ensemble *ensemble);
bool tdmf_is_runner_case(tdmf_refusal *why, const tdmf_ensemble_case *its_case,
                         const tdmf_ensemble *ensemble);
bool tdmf_is_runner_checkpoint(const tdmf_ensemble_checkpoint *from, const tdmf_ensemble *ensemble);
bool tdmf_range_of_setting(const tdmf_ensemble *ensemble, int setting, double *least, double *most);
int tdmf_runner_coordinates(const tdmf_ensemble *ensemble);

#endif
