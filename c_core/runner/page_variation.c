/* Directions of parameters and inputs on the runner's page. */
#include "page_variation.h"

#include "input_rates.h"
#include "page_fields.h"

#include <float.h>

/* True if the plain page has all that changes along a seed. */
static bool varies_plain_page(const tdmf_seed *seed) {
    const tdmf_page_direction d = tdmf_direction_of_seed(seed);
    return tdmf_part_varies(&tdmf_plain_runner_part, &tdmf_runner_model, (const double *)&d.p,
                            (const double *)&d.x);
}

bool tdmf_suits_plain_page_varied(const tdmf_page_point *point, const tdmf_seed *seeds, int count) {
    bool suits = tdmf_suits_plain_page(point);
    for (int i = 0; i < count; ++i) {
        suits = suits && varies_plain_page(&seeds[i]);
    }
    return suits;
}

tdmf_inputs tdmf_rates_with_varied_push(const tdmf_inputs *rates, const tdmf_seed *seeds, int count) {
    tdmf_inputs with_push = *rates;
    for (int i = 0; i < count; ++i) {
        if (tdmf_is_pushed(&seeds[i].inputs)) {
            with_push.body.external_fx += DBL_MIN;
        }
    }
    return with_push;
}

bool tdmf_is_kinked(const tdmf_parameters *parameters, const tdmf_seed *seed) {
    const tdmf_parameters *p = parameters, *d = &seed->parameters;
    return p->hip.swing_clamp && p->hip.kp == 0.0 && p->hip.kd == 0.0 &&
           (d->hip.kp != 0.0 || d->hip.kd != 0.0);
}

tdmf_page_direction tdmf_direction_of_seed(const tdmf_seed *seed) {
    tdmf_page_direction d = {.p = tdmf_page_parameters(&seed->parameters, &seed->inputs)};
    tdmf_write_page_inputs(&seed->inputs, &d.x);
    return d;
}
