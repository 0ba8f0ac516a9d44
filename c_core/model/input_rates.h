/* Rates of inputs where none need be given. */
#ifndef TDMF_MODEL_INPUT_RATES_H
#define TDMF_MODEL_INPUT_RATES_H

#include "tdmf_slip/parameters.h"

static inline const tdmf_input_rates *tdmf_rates_or_held(const tdmf_input_rates *rates) {
    static const tdmf_input_rates held = {0.0, 0.0};
    return rates != NULL ? rates : &held;
}

#endif
