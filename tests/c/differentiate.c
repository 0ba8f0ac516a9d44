#include "differentiate.h"

long double derivative_at_zero(function_of_time f, const void *context, long double step) {
    static const long double weights[] = {4.0L / 5.0L, -1.0L / 5.0L, 4.0L / 105.0L, -1.0L / 280.0L};
    long double sum = 0.0L;
    for (int i = 0; i < 4; ++i) {
        const long double t = (long double)(i + 1) * step;
        sum += weights[i] * (f(t, context) - f(-t, context));
    }
    return sum / step;
}
