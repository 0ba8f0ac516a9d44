/* Periodic gaits: fixed points of the return map, stable or not. */
#ifndef TDMF_SLIP_ORBIT_H
#define TDMF_SLIP_ORBIT_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/return_map.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Tells how the search for a gait ended. */
typedef enum {
    TDMF_ORBIT_FOUND,     /* a gait */
    TDMF_ORBIT_NOT_FOUND, /* Newton's method did not converge: no gait near the guess */
    TDMF_ORBIT_FELL,      /* the runner falls from the guess */
    TDMF_ORBIT_NO_START,  /* the guess is no apex: below the ground, or refused, as is what is asked for */
    TDMF_ORBIT_UNSOLVED,  /* the solver could not follow the runner: see stride.solver */
    TDMF_ORBIT_NO_STRIDE  /* no stride closes from the guess within 1e4 sqrt(m/k), as where it stands still */
} tdmf_orbit_outcome;

/* A gait and its stride. Values other than the outcome are those of the last apex tried. */
typedef struct {
    tdmf_orbit_outcome outcome; /* whether it was found, and else why not */
    int iterations;             /* of Newton's method */
    double error; /* largest difference of the apex and the next, over the coordinates' scales */
    double apex[TDMF_SECTION_COUNT]; /* the gait's; of the reduced map the first two coordinates */
    tdmf_return stride;              /* from `apex`, with variations, also along the seeds given */
} tdmf_orbit;

/* Scales of the section's coordinates: l0, l0 sqrt(k/m), l0, 1 rad, l0 sqrt(k/m), sqrt(k/m). */
TDMF_API void tdmf_section_scales(const tdmf_model *model, double scales[TDMF_SECTION_COUNT]);

/* Newton's method on the return map from a guess, down to rounding: where the solver's tolerance is as tight,
 * the next apex is within 1e-11 of the scales; so is the gait, unless I - J is nearly singular, as at a fold.
 * Iterations that make the error larger are shortened. Of `count` seeds, which may be 0, the stride has
 * variations, too. With NULL for anything else there is no start. */
TDMF_API tdmf_orbit tdmf_find_orbit(tdmf_solver *solver, tdmf_system system,
                                    const double guess[TDMF_SECTION_COUNT], const tdmf_seed *seeds,
                                    int count);

/* Runs up to `strides` strides from an apex and writes the last one into `section`; less where one does not
 * close: tdmf_find_orbit from there says why. Returns how many were run: 0 for a number below 0, or with
 * NULL. */
TDMF_API int tdmf_settle(tdmf_solver *solver, tdmf_system system, int strides,
                         double section[TDMF_SECTION_COUNT]);

#ifdef __cplusplus
}
#endif
#endif
