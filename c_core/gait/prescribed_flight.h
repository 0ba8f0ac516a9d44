/* Flight in the reduced map: the centre of mass is ballistic, and from the apex on the leg is where the hip
 * is to place it, with r = l0 and theta = theta0 - omega t, as one rigid body. */
#ifndef TDMF_GAIT_PRESCRIBED_FLIGHT_H
#define TDMF_GAIT_PRESCRIBED_FLIGHT_H

#include "kinematics.h"
#include "seed.h"

/* The change of tdmf_center_of_mass_after, where the time changes, too. */
tdmf_point tdmf_vary_ballistic(tdmf_system system, const tdmf_local_seed *d, tdmf_point from,
                               tdmf_point d_from, double time, double d_time);

/* How long a centre of mass rises, and its change; infinite where nothing pulls it down. */
double tdmf_time_to_apex(tdmf_system system, tdmf_point from);
double tdmf_vary_time_to_apex(tdmf_system system, const tdmf_local_seed *d, tdmf_point from,
                              tdmf_point d_from);

/* The first contact after an apex: of the foot, or of the body, which is a fall. */
typedef struct {
    double time; /* s, infinite where nothing comes down */
    bool body_first;
} tdmf_descent;

tdmf_descent tdmf_descend(tdmf_system system, const tdmf_ground_line *ground, tdmf_point apex);

/* The mechanical state `time` after an apex, its rate, and its change at that time; what a state has besides
 * is the clock of place. */
void tdmf_prescribed_state(tdmf_system system, tdmf_point apex, double time, double state[TDMF_STATE_COUNT]);
void tdmf_prescribed_derivatives(tdmf_system system, const double state[TDMF_STATE_COUNT],
                                 double derivatives[TDMF_STATE_COUNT]);
void tdmf_vary_prescribed_state(tdmf_system system, const tdmf_local_seed *d, tdmf_point apex,
                                tdmf_point d_apex, double time, const double state[TDMF_STATE_COUNT],
                                double d_state[TDMF_STATE_COUNT]);

#endif
