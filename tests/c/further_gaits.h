/* Periodic gaits of runners that go beyond the paper: on slopes, with swing-leg retraction, with a static
 * friction larger than the sliding one, also where friction falls with speed, with a thrust of the leg, and
 * pushed by a force; all else is as in Table 1. The swing is clamped.
 * They were computed independently of this project, in extended precision, and are good to 1e-12; their
 * Jacobians, by differences, to 3e-9. */
#ifndef TDMF_TESTS_FURTHER_GAITS_H
#define TDMF_TESTS_FURTHER_GAITS_H

#include "reference_gaits.h"

typedef struct {
    double slope, touchdown_angle; /* degrees */
    double retraction_rate, static_friction_ratio, stribeck_velocity;
    double thrust;
    double external_fx, external_fy;
    reference_gait gait; /* its work is that of hip and leg */
    double rise, leg_work, external_work;
    double damper_loss, friction_loss, impact_loss; /* per stride */
} further_gait;

enum { FURTHER_GAITS = 28 };

extern const further_gait further_gaits[FURTHER_GAITS];

tdmf_parameters parameters_of_further_gait(const further_gait *further);
tdmf_inputs inputs_of_further_gait(const further_gait *further);

/* A runner started at the gait's apex. */
runner runner_at_further_apex(const further_gait *further);

#endif
