/* Fixed points of the reduced map in units m = k = l0 = 1, the rest from Table 1. They were computed
 * independently of this project, in extended precision: values to 1e-12, eigenvalues to 1e-9. */
#ifndef TDMF_TESTS_REDUCED_GAITS_H
#define TDMF_TESTS_REDUCED_GAITS_H

#include "tdmf_slip/tdmf_slip.h"

typedef struct {
    double friction, touchdown_angle;                     /* degrees */
    double retraction_rate, static_friction_ratio, slope; /* slope in degrees */
    const char *word;
    double apex[TDMF_REDUCED_COUNT];
    double period, length, speed;
    double eigenvalues[TDMF_REDUCED_COUNT];
    double work;
} reduced_gait;

enum { REDUCED_GAITS = 9 };

extern const reduced_gait reduced_gaits[REDUCED_GAITS];

/* Its parameters and friction. */
tdmf_parameters parameters_of_reduced_gait(const reduced_gait *gait);
tdmf_inputs inputs_of_reduced_gait(const reduced_gait *gait);

#endif
