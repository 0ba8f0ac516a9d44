/* Flight in the reduced map: the centre of mass is ballistic, and from the apex on the leg is where the hip
 * is to place it, with r = l0 and theta = theta0 - omega t, as one rigid body. */
#ifndef TDMF_GAIT_PRESCRIBED_FLIGHT_H
#define TDMF_GAIT_PRESCRIBED_FLIGHT_H

#include "tdmf_slip/kinematics.h"

/* The first contact after an apex: of the foot, or of the body, which is a fall. */
typedef struct {
    double time; /* s, infinite where nothing comes down */
    bool body_first;
} tdmf_descent;

tdmf_descent tdmf_descend(tdmf_system system, const tdmf_ground_line *ground, tdmf_point apex);

#endif
