/* Progress of the automaton and the solvers between their calls. It is not part of the interface: a program
 * copies it with the motion and does not read it, and any version may change it. */
#ifndef TDMF_SLIP_INTERNAL_PROGRESS_H
#define TDMF_SLIP_INTERNAL_PROGRESS_H

#include "tdmf_slip/stride.h"

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A time as the unevaluated sum of two doubles: where it counts the seconds of an epoch, one double is good
 * to 2e-7 s. */
typedef struct {
    double time; /* s */
    double rest; /* s, what rounding has left out of `time` */
} tdmf_instant;

/* Sums over the stride under way. */
typedef struct {
    bool began_at_apex;                /* else it is not counted */
    bool flew_since_letter;            /* the next letter belongs to a new stance */
    tdmf_instant start, contact_start; /* starts of the stride and of the present contact mode */
    double start_com_x, start_com_y, contact_start_x;           /* m, at these instants */
    double start_hip_work, start_leg_work, start_positive_work; /* J, at the start of the stride */
    /* Quantities of tdmf_stride, so far. */
    double stance_time, slip_distance, peak_force, peak_vertical_force;
    int touchdowns;
    char word[TDMF_WORD_CAPACITY];
} tdmf_open_stride;

/* Kept from call to call. */
typedef struct {
    tdmf_instant now; /* instant that a solver has reached */
    tdmf_open_stride open;
} tdmf_progress;

#ifdef __cplusplus
}
#endif
#endif
