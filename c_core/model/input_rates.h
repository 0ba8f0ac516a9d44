/* Rates of inputs: those that need not be given, and questions about those that are. */
#ifndef TDMF_MODEL_INPUT_RATES_H
#define TDMF_MODEL_INPUT_RATES_H

#include "tdmf_slip/parameters.h"

#include <stdbool.h>

extern const tdmf_inputs tdmf_zero_input_rates;

static inline const tdmf_inputs *tdmf_rates_or_zero(const tdmf_inputs *rates) {
    return rates != NULL ? rates : &tdmf_zero_input_rates;
}

/* An external force acts on the body, or begins to. */
static inline bool tdmf_is_pushed(const tdmf_inputs *inputs) {
    return inputs->body.external_fx != 0.0 || inputs->body.external_fy != 0.0;
}

/* All rates are zero. */
bool tdmf_are_zero_rates(const tdmf_inputs *rates);

#endif
