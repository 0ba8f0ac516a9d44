/* The affine law from apex to settings. */
#include "tdmf_slip/ensemble.h"

#include <math.h>

void tdmf_affine_settings(const tdmf_affine_law *law, const double apex[TDMF_POINT_LIMIT], uint64_t runner,
                          uint32_t stride, double *values) {
    double deviation[TDMF_POINT_LIMIT];
    for (int j = 0; j < TDMF_POINT_LIMIT; ++j) {
        const double noise =
            law->noise[j] == 0.0 ? 0.0 : law->noise[j] * tdmf_sensor_noise(law->seed, runner, stride, j);
        deviation[j] = apex[j] + noise - law->apex[j];
    }
    for (int i = 0; i < law->count; ++i) {
        double value = law->nominal[i];
        for (int j = 0; j < TDMF_POINT_LIMIT; ++j) {
            value += law->gain[i][j] * deviation[j];
        }
        values[i] = fmin(fmax(value, law->low[i]), law->high[i]);
    }
}
