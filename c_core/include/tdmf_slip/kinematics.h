/* Positions and velocities of the body and of the centre of mass. */
#ifndef TDMF_SLIP_KINEMATICS_H
#define TDMF_SLIP_KINEMATICS_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A point that moves. */
typedef struct {
    double x, y, vx, vy; /* m, m/s */
} tdmf_point;

/* Gives the body: x_m = x - r sin(theta), y_m = y + r cos(theta)  (7), and its rate. */
TDMF_API tdmf_point tdmf_body(const double state[TDMF_STATE_COUNT]);

/* Gives the centre of mass of body and foot. */
TDMF_API tdmf_point tdmf_center_of_mass(const tdmf_model *model, const double state[TDMF_STATE_COUNT]);

/* Gives the foot in the axes of the ground: x runs along the line from its pivot, y away from it. */
TDMF_API tdmf_point tdmf_foot_over_ground(const tdmf_ground_line *ground,
                                          const double state[TDMF_STATE_COUNT]);

#ifdef __cplusplus
}
#endif
#endif
