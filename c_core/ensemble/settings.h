/* Settings and inputs by their numbers. */
#ifndef TDMF_ENSEMBLE_SETTINGS_H
#define TDMF_ENSEMBLE_SETTINGS_H

#include "ranges.h"

/* The range of a setting; NULL if there is no setting of this number. */
const tdmf_range *tdmf_setting_range(int setting);

/* Writes the value of a setting into the parameters or the inputs. */
void tdmf_write_setting(int setting, double value, tdmf_parameters *parameters, tdmf_inputs *inputs);

#endif
