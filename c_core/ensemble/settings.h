/* Settings and inputs by their numbers. */
#ifndef TDMF_ENSEMBLE_SETTINGS_H
#define TDMF_ENSEMBLE_SETTINGS_H

#include "ranges.h"

/* The range of a setting; NULL where the number is of none. */
const tdmf_range *tdmf_setting_range(int setting);

/* Gives it a value, in the parameters or the inputs. */
void tdmf_write_setting(int setting, double value, tdmf_parameters *parameters, tdmf_inputs *inputs);

#endif
