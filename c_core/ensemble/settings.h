/* Settings and inputs by their numbers. */
#ifndef TDMF_ENSEMBLE_SETTINGS_H
#define TDMF_ENSEMBLE_SETTINGS_H

#include "ranges.h"

/* The range of a setting; NULL if there is no setting of this number. */
const tdmf_range *tdmf_setting_range(int setting);

#endif
