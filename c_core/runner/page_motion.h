/* A motion as the runner's page sees it, and back.
 *
 * The clock of the page begins at 0 where the run does, so that a run at any time of an epoch is as exact as
 * one at 0, and its heights at the ground line. A motion may be changed in the world's states; the
 * coordinates of its mode follow from them.
 */
#ifndef TDMF_RUNNER_PAGE_MOTION_H
#define TDMF_RUNNER_PAGE_MOTION_H

#include "driver.h"
#include "runner.h"
#include "tdmf_slip/motion.h"
#include "tdmf_slip/parameters.h"

/* Number of coordinates, those of the world and of all modes, from TDMF_FOOT_X on. */
enum { TDMF_COORDINATE_COUNT = TDMF_LEG_WINDING + 1 - TDMF_FOOT_X };

/* A run of the whole page at an instant. */
typedef struct {
    runner_parameters p;
    runner_states x;
    int mode;          /* a MODE_ of the whole page */
    uint64_t above;    /* see tdmf_page_run */
    double base;       /* the page counts heights from here: from the ground line in force, if it is near */
    double time, rest; /* the clock: the sum of both */
} tdmf_page_point;

/* Reads a motion and its inputs, which are ramped. */
tdmf_page_point tdmf_page_of_motion(tdmf_system system, const tdmf_inputs *rates, const tdmf_motion *motion);

/* Writes a point that a run of the page has come to into the motion that it began with. A fallen runner keeps
 * contact and phase of the mode in which it fell, `last_mode`. */
void tdmf_motion_of_page(tdmf_system system, const tdmf_page_point *point, int last_mode,
                         tdmf_motion *motion);

#endif
