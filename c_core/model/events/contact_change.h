/* How the foot changes between flight, graze and contact; shared by the events that end in it. */
#ifndef TDMF_MODEL_CONTACT_CHANGE_H
#define TDMF_MODEL_CONTACT_CHANGE_H

#include "events.h"

/* Enters a contact mode; the record notes it. */
void tdmf_enter_contact_mode(tdmf_run *run, tdmf_contact_mode entered);

/* Enters flight with theta_LO unchanged, in the phase that the centre of mass decides. */
void tdmf_fly(tdmf_run *run);

/* Enters flight from graze, in the same phase. */
void tdmf_fly_on(tdmf_run *run);

/* A foot on the ground after an impact or at a start: contact, flight or graze. */
void tdmf_come_to_ground(tdmf_run *run);

/* A grazing foot is loaded again. */
void tdmf_load_foot(tdmf_run *run);

/* A foot in contact is loaded no more: flight or graze. */
void tdmf_unload_foot(tdmf_run *run);

/* Gives the contact mode of a loaded foot at rest whose hip is in the phase of `mode`: stick if friction can
 * hold it, else slip the way the excess force drives it. */
tdmf_contact_mode tdmf_mode_of_resting_foot(const tdmf_run *run, const tdmf_mode *mode);

#endif
