/* Work of the leg by its extension, the integral of k (rest length - r) over the rest length. With the rest
 * length linear in time from a to b, and the length cubic,
 *
 *     W = k (b - a) ((a + b)/2 - mean of r),   mean of r = (r0 + r1)/2 + h (rdot0 - rdot1)/12 */
#include "tdmf_slip/extension.h"

#include "rest_length.h"

tdmf_leg_sample tdmf_leg_sample_of(double time, const double state[TDMF_STATE_COUNT]) {
    const tdmf_leg_sample sample = {time, state[TDMF_LEG_LENGTH], state[TDMF_LEG_LENGTH_RATE]};
    return sample;
}

double tdmf_account_for_extension(tdmf_system system, const tdmf_leg_sample *before,
                                  const tdmf_leg_sample *after, tdmf_mode *mode) {
    const double from = mode->rest_length;
    const double to = tdmf_rest_length(system.model, system.inputs, mode);
    const double mean_length =
        0.5 * (before->length + after->length) +
        (after->time - before->time) * (before->length_rate - after->length_rate) / 12.0;
    mode->rest_length = to;
    return tdmf_work_of_change(system.model, mean_length, from, to);
}
