/* The parts of a stride of the reduced map: from an apex to touchdown, and from lift-off to the next apex.
 * The stance between them is that of the full model. */
#ifndef TDMF_GAIT_REDUCED_STRIDE_H
#define TDMF_GAIT_REDUCED_STRIDE_H

#include "tdmf_slip/motion.h"
#include "tdmf_slip/reduced_map.h"

/* Begins a motion at an apex, above x = 0. TDMF_RETURN_CLOSED where it is one. */
tdmf_return_outcome tdmf_reduced_begin(tdmf_system system, const double apex[TDMF_REDUCED_COUNT],
                                       tdmf_motion *motion);

/* Sets leg and ground at an apex anew, as other settings have them. */
void tdmf_reduced_reset_leg(tdmf_system system, tdmf_motion *motion);

/* Goes from an apex through the impact into contact. Returns TDMF_RETURN_CLOSED where the foot is loaded
 * then. */
tdmf_return_outcome tdmf_reduced_touch_down(tdmf_system system, double until, tdmf_motion *motion);

/* Flies from lift-off to the next apex, which closes the stride. Returns TDMF_RETURN_CLOSED where there is
 * one. */
tdmf_return_outcome tdmf_reduced_fly(tdmf_system system, tdmf_motion *motion);

#endif
