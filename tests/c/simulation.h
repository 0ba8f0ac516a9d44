/* A runner that a solver takes from event to event, with its log and its energy ledger; and what accepts
 * parameters, tolerances and sections on the way there. */
#ifndef TDMF_TESTS_SIMULATION_H
#define TDMF_TESTS_SIMULATION_H

#include "integrate.h"
#include "strides.h"
#include "system_of.h"
#include "tdmf_slip/cvode.h"
#include "tdmf_slip/tdmf_slip.h"

typedef struct {
    tdmf_model model;
    tdmf_inputs inputs, rates;
    tdmf_motion motion;
    tdmf_solver solver;
    tdmf_event_log log; /* events of the last call */
    double start_energy;
} simulation;

typedef tdmf_outcome solver_call(tdmf_solver *solver, tdmf_system system, const tdmf_inputs *rates,
                                 double until, tdmf_motion *motion);

/* Skips the test in a build without CVODE. */
void skip_without_cvode(void);

/* The model of these parameters; asserts that the library accepts them. */
tdmf_model accepted_model(const tdmf_parameters *parameters);

/* The default solver with this relative tolerance. */
tdmf_solver solver_to(double relative_tolerance);

/* A simulation from a point of the section at time 0; asserts that a run may start there. */
simulation simulation_from(const tdmf_parameters *parameters, const tdmf_inputs *inputs,
                           const double section[TDMF_SECTION_COUNT], double relative_tolerance);

/* Restarts at time 0 from the present state; asserts that the start is accepted. */
void simulation_start(simulation *simulation);

/* Advance the run by the native solver, or by the given one. */
tdmf_outcome simulation_advance(simulation *simulation, double until);
tdmf_outcome simulation_advance_by(solver_call *advance, simulation *simulation, double until);

/* Runs to the next apex; asserts that there is one. */
void simulation_stride(simulation *simulation);

/* The first event of a kind in the log, or NULL. */
const tdmf_event *simulation_event(const simulation *simulation, tdmf_guard guard);

double simulation_energy(const simulation *simulation);

/* Energy that the ledger does not account for since the start. */
double simulation_ledger_error(const simulation *simulation);

/* Asserts that all numbers of two strides, or of their ends, are as close as `tolerance` of 1 or of
 * themselves. */
void assert_same_stride(tdmf_stride a, tdmf_stride b, double tolerance);
void assert_same_state(const tdmf_motion *a, const tdmf_motion *b, double tolerance);

/* A simulation from a state at time 0; asserts that a run may start there. */
simulation simulation_in(const tdmf_parameters *parameters, const tdmf_inputs *inputs,
                         const double state[TDMF_STATE_COUNT], double relative_tolerance);

/* A simulation by the runner's own model, from its state at time 0; asserts that a run may start there. */
simulation simulation_of(const runner *runner, double relative_tolerance);

/* Asserts the words of a refusal. */
void assert_refusal_text(tdmf_refusal refusal, const char *expected);

/* The section at the last apex. */
void read_apex(const tdmf_motion *motion, double section[TDMF_SECTION_COUNT]);

#endif
