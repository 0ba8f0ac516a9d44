/* Graze: the foot rests on the ground without force, between the stance law that lifts it and the flight law
 * that holds it down. See equations/graze.py. */
#ifndef TDMF_MODEL_GRAZE_H
#define TDMF_MODEL_GRAZE_H

#include "evaluation.h"

/* The contact mode of a foot at rest on the ground after an impact or at a start: flight, graze, or stick,
 * which stands for any loaded contact. The mode of `off_ground` has the phase and theta_LO of the flight law.
 */
tdmf_contact_mode tdmf_contact_of_resting_foot(const tdmf_evaluation *off_ground);

/* The contact mode, flight or graze, of a foot whose contact force has just vanished. */
tdmf_contact_mode tdmf_contact_after_lift_off(const tdmf_evaluation *off_ground);

#endif
