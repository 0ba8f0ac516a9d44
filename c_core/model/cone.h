/* The edges of the friction cone as guards: mu f_y + f_x and mu f_y - f_x.
 *
 * They carry mu times the rounding of f_y, so that under a large friction no fixed margin would hold. Over
 * max(1, mu) they have the forces' own rounding, and nothing overflows. */
#ifndef TDMF_MODEL_CONE_H
#define TDMF_MODEL_CONE_H

/* Weights of f_y and of f_x in a guard. */
typedef struct {
    double normal, tangential;
} tdmf_cone;

static inline tdmf_cone tdmf_cone_of(double friction) {
    const tdmf_cone narrow = {friction, 1.0};
    const tdmf_cone wide = {1.0, 1.0 / friction};
    return friction > 1.0 ? wide : narrow;
}

/* How the weights change while the friction changes at a rate. */
static inline tdmf_cone tdmf_cone_rate(double friction, double friction_rate) {
    const tdmf_cone narrow = {friction_rate, 0.0};
    const tdmf_cone wide = {0.0, -friction_rate / (friction * friction)};
    return friction > 1.0 ? wide : narrow;
}

#endif
