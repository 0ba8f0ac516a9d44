/* What the series of a mode depend on, besides the coordinates that they begin at; and how it changes. */
#ifndef TDMF_SOLVER_COEFFICIENTS_H
#define TDMF_SOLVER_COEFFICIENTS_H

#include "guard_series.h"
#include "mode_equations.h"
#include "motion_series.h"
#include "seed.h"

flight_coefficients tdmf_flight_coefficients(const tdmf_mode_equations *equations);
ground_coefficients tdmf_ground_coefficients(const tdmf_mode_equations *equations);

/* Changes along a direction. Not a number where the clamp has no derivative. */
flight_coefficients tdmf_vary_flight_coefficients(const tdmf_mode_equations *equations, const tdmf_mode *mode,
                                                  const tdmf_local_seed *d);
ground_coefficients tdmf_vary_ground_coefficients(const tdmf_mode_equations *equations, const tdmf_mode *mode,
                                                  const tdmf_local_seed *d);

#endif
