/* Hand-made situations: a runner put into a mode and a state, to see what the core makes of it.
 *
 * Unless said otherwise the model is Table 1 with m = k = l0 = 1, so that forces and speeds are in the units
 * in which the guards are margins. */
#ifndef TDMF_TESTS_SCENE_H
#define TDMF_TESTS_SCENE_H

#include "integrate.h"
#include "random.h"

/* Distance past an event at which a guarded quantity is set, in the quantity's unit. */
#define SCENE_PAST_EVENT (-2.0 * TDMF_GUARD_MARGIN)

/* A foot at rest on the ground in coast, the leg still, carrying `vertical_force`; high friction. */
runner scene_on_ground(tdmf_contact_mode contact, double leg_angle, double vertical_force);

/* A foot one leg length above the ground, moving with the body, the centre of mass rising at `com_vy`. */
runner scene_in_flight(tdmf_hip_phase phase, double com_vy);

/* A runner in flight that hits the ground now and whose leg is, just after the impact, that of
 * scene_on_ground with the same arguments. */
runner scene_at_impact(tdmf_hip_phase phase, double leg_angle, double vertical_force);

/* Adjusts the leg length so that the ground carries `vertical_force` under the present hip torque. */
void scene_set_vertical_force(runner *runner, double vertical_force);

/* The hip's law (12) once more, for the tests, without the external torque: retract without its clamp, and
 * place. */
double scene_retract_law(const runner *runner);
double scene_place_law(const runner *runner);

/* Gives the foot a new velocity and keeps the body's: the leg's rates take up the difference. */
void scene_set_foot_velocity(double vx, double vy, double state[TDMF_STATE_COUNT]);

/* Adjusts the foot's velocity, or, with the foot on the ground, the leg's rate, to this rate of climb. */
void scene_set_com_vy(runner *runner, double com_vy);
void scene_set_com_vy_by_leg(runner *runner, double com_vy);

void scene_assert_mode(const runner *runner, tdmf_contact_mode contact, tdmf_hip_phase phase);

/* State and mode at one time, to assert that they stayed as they were, bit for bit. */
typedef struct {
    double state[TDMF_STATE_COUNT];
    tdmf_mode mode;
} scene_snapshot;

void scene_take_snapshot(const runner *runner, scene_snapshot *snapshot);
void scene_assert_unchanged(const runner *runner, const scene_snapshot *before);

double scene_guard(const runner *runner, tdmf_guard guard);

/* tdmf_resolve at runner->motion.time. Asserts that the chain comes to rest, leaves no guard due, and a clamp
 * closed in retract only. */
tdmf_resolution scene_resolve(runner *runner);

/* Moves each parameter that is at the minimum of its range off it, so that it may differ to both sides. */
void scene_leave_minima(tdmf_parameters *parameters);

/* Makes the foot a millionth of the body, on a leg ten thousand times as stiff. */
void scene_lighten_foot_and_stiffen_leg(runner *runner);

/* A random model, within a decade or so of Table 1 in random units, and an input, state and mode with this
 * contact mode that obey the mode's constraints. */
runner scene_random(random_source *source, tdmf_contact_mode contact);

/* A time in which no coordinate goes far, s. */
double scene_short_time(const runner *runner);

/* A runner in other units, m by `mass`, k by `stiffness`, l0 by `length`, with the dimensionless groups
 * fixed. Elements of the state that are neither clocks nor mechanical are energies. */
typedef struct {
    double mass, stiffness, length;
} factors;

double time_factor(const factors *by);
double energy_factor(const factors *by);
double factor_of_element(const factors *by, int element);
tdmf_parameters scaled_parameters(tdmf_parameters parameters, const factors *by);
tdmf_inputs scaled_inputs(tdmf_inputs inputs, const factors *by);

#endif
