#include "differentiate.h"

enum { PAIRS = 4 };

static const long double weights[PAIRS] = {4.0L / 5.0L, -1.0L / 5.0L, 4.0L / 105.0L, -1.0L / 280.0L};

long double derivative_at_zero(function_of_time f, const void *context, long double step) {
    long double sum = 0.0L;
    for (int i = 0; i < PAIRS; ++i) {
        const long double t = (long double)(i + 1) * step;
        sum += weights[i] * (f(t, context) - f(-t, context));
    }
    return sum / step;
}

void derivatives_at_zero(functions_of_time f, const void *context, long double step, int count,
                         double derivatives[]) {
    long double sums[FUNCTIONS_LIMIT] = {0.0L};
    for (int i = 0; i < PAIRS; ++i) {
        const long double t = (long double)(i + 1) * step;
        double ahead[FUNCTIONS_LIMIT], behind[FUNCTIONS_LIMIT];
        f(t, context, ahead);
        f(-t, context, behind);
        for (int k = 0; k < count; ++k) {
            sums[k] += weights[i] * ((long double)ahead[k] - (long double)behind[k]);
        }
    }
    for (int k = 0; k < count; ++k) {
        derivatives[k] = (double)(sums[k] / step);
    }
}
