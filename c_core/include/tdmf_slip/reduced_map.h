/* The reduced map: from one apex to the next with the leg placed ideally in flight, so that an apex has two
 * coordinates, the height and the speed of the centre of mass.
 *
 * The foot comes down with r = l0, rdot = 0, theta = theta0 - omega t, thetadot = -omega, at t after the
 * apex. Impact and stance are those of the full model, until the stance law no longer loads the foot. From
 * there the centre of mass flies to the next apex, and the energy left in the leg is lost.
 *
 * The map does not depend on hip.kp, hip.kd, hip.liftoff_angle_factor and hip.swing_clamp, because these only
 * move the leg in flight. */
#ifndef TDMF_SLIP_REDUCED_MAP_H
#define TDMF_SLIP_REDUCED_MAP_H

#include "tdmf_slip/export.h"
#include "tdmf_slip/orbit.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Coordinates of an apex, as in the section of the full model: its first two. */
enum {
    TDMF_REDUCED_COM_HEIGHT = TDMF_SECTION_COM_HEIGHT, /* y_c, m */
    TDMF_REDUCED_COM_SPEED = TDMF_SECTION_COM_SPEED,   /* m/s */
    TDMF_REDUCED_COUNT
};

/* The state at an apex above x = 0, with the leg at rest where it is to be placed, integrals zero. `apex` may
 * lie within `state`. */
TDMF_API void tdmf_reduced_state(tdmf_system system, const double apex[TDMF_REDUCED_COUNT],
                                 double state[TDMF_STATE_COUNT]);

/* Seeds of parameters and inputs along which a stride is differentiated, at the most.
 * Unary plus makes an int: C++20 deprecates arithmetic between two enumerations. */
enum { TDMF_REDUCED_MAP_SEEDS = +TDMF_VARIATION_LIMIT - TDMF_REDUCED_COUNT };

/* One stride from an apex, whose flight down and whose stance take no longer than `until` each. With
 * `derivatives`, also how it changes with the two coordinates and along `count` seeds of parameters and
 * inputs; they are not finite on the edge of an event, see tdmf_native_stride_varied. A log in the solver has
 * touchdown, the events of the stance, and the apex. The energy of the centre of mass changes by the work and
 * the external work less the four losses. */
TDMF_API tdmf_return tdmf_reduced_map(tdmf_solver *solver, tdmf_system system,
                                      const double apex[TDMF_REDUCED_COUNT], double until, bool derivatives,
                                      const tdmf_seed *seeds, int count);

/* Newton's method from a guess, as tdmf_find_orbit; `count` changes, which may be 0. */
TDMF_API tdmf_orbit tdmf_find_reduced_orbit(tdmf_solver *solver, tdmf_system system,
                                            const double guess[TDMF_REDUCED_COUNT], const tdmf_seed *seeds,
                                            int count);

/* Runs up to `strides` strides, as tdmf_settle. */
TDMF_API int tdmf_settle_reduced(tdmf_solver *solver, tdmf_system system, int strides,
                                 double apex[TDMF_REDUCED_COUNT]);

#ifdef __cplusplus
}
#endif
#endif
