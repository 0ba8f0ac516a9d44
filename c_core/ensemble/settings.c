/* Settings and inputs by their numbers: first the rows of the parameters' table, then those of the inputs'.
 */
#include "settings.h"

#include "tdmf_slip/ensemble.h"

#include <string.h>

const tdmf_range *tdmf_setting_range(int setting) {
    const int parameters = TDMF_PARAMETER_COUNT;
    if (setting < 0 || setting >= parameters + TDMF_INPUT_COUNT) {
        return NULL;
    }
    const tdmf_range *range =
        setting < parameters ? &tdmf_parameter_ranges[setting] : &tdmf_input_ranges[setting - parameters];
    return range->at_events ? range : NULL;
}

int tdmf_setting_of(const char *name) {
    const int count = TDMF_PARAMETER_COUNT + TDMF_INPUT_COUNT;
    for (int setting = 0; name != NULL && setting < count; ++setting) {
        const tdmf_range *range = tdmf_setting_range(setting);
        if (range != NULL && strcmp(range->name, name) == 0) {
            return setting;
        }
    }
    return -1;
}
