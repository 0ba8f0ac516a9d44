/* The first zero is found by steps that cannot pass one: with the least curvature that the sum can have,
 * h + h' t + h'' t^2/2 is below it. */
#include "swinging_height.h"

#include <math.h>

enum { STEP_LIMIT = 10000 };

/* When a parabola that falls reaches a level, at or after t = 0. */
static double time_to_level(double above, double rate, double curvature) {
    if (above <= 0.0) {
        return 0.0;
    }
    const double root = sqrt(rate * rate - 2.0 * curvature * above);
    return rate > 0.0 ? (rate + root) / -curvature : 2.0 * above / (root - rate);
}

/* While the parabola is beyond the reach of the swing, its own fall is what to wait for. */
double tdmf_first_zero(const tdmf_swinging_height *h) {
    const double reach = fabs(h->swing);
    const double lowest = h->curvature - reach * h->turning * h->turning;
    double t = 0.0;
    for (int i = 0; i < STEP_LIMIT; ++i) {
        const double angle = h->angle - h->turning * t;
        const double parabola = h->start + t * (h->rate + 0.5 * t * h->curvature);
        const double its_rate = h->rate + t * h->curvature;
        const double beyond = time_to_level(parabola - reach, its_rate, h->curvature);
        const double within = time_to_level(parabola - h->swing * cos(angle),
                                            its_rate - h->swing * h->turning * sin(angle), lowest);
        const double next = t + (beyond > within ? beyond : within); /* not a number if either is none */
        if (!(next > t)) {
            return next == t ? t : NAN;
        }
        t = next;
    }
    return NAN;
}
