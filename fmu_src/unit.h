/* The seam between the physics and FMI: a runner with its settings, whatever FMI version drives it. Plain
 * data, so that copying a unit copies the whole run; what of it a saved state holds is in saved_fields.c. */
#ifndef TDMF_UNIT_H
#define TDMF_UNIT_H

#include "tdmf_slip/tdmf_slip.h"

typedef enum { SOLVER_NATIVE = 1, SOLVER_CVODE } solver_method;

/* Parameters of the unit rather than of the runner. Member paths are variable names, as in the core. */
typedef struct {
    struct {
        int terminate_on_fall;
    } status;
    struct {
        int method; /* solver_method */
        double relative_tolerance;
    } solver;
} unit_settings;

typedef struct unit {
    unit_settings settings;
    tdmf_parameters parameters;
    tdmf_inputs inputs;
    tdmf_inputs input_rates;   /* Co-Simulation: how the inputs go on from the communication point */
    double importer_tolerance; /* infinite where the importer has none */
    tdmf_model model;
    tdmf_motion motion;
    tdmf_solver solver;
    /* Model Exchange: the leg where leg.work was accounted for last, and work that its state does not have
     * yet. */
    tdmf_leg_sample accounted_leg;
    double leg_work_due;
    double stop_time; /* Co-Simulation goes no farther; infinite where the importer has none */
    /* Co-Simulation with event mode: the motion stands at an event, not yet taken, its state that of
     * `event_lead` before. What comes of it under these parameters and inputs. */
    bool event_is_pending;
    double event_lead;
    int event_guard; /* the tdmf_guard that fired */
    tdmf_parameters event_parameters;
    tdmf_inputs event_inputs;
    tdmf_motion after_event;
} unit;

/* Told of every event that the unit takes, if an observer is given. */
typedef struct {
    void (*note)(void *subject, const tdmf_event *event); /* or NULL */
    void *subject;
} unit_observer;

/* What the solver of Co-Simulation has done; stops counting at the largest Integer. */
typedef struct {
    struct {
        int steps;
        int evaluations;
    } solver;
} unit_work;

/* What follows from a unit and is computed when it is asked for. */
typedef struct {
    tdmf_outputs outputs;
    unit_work work;
    double states[TDMF_STATE_COUNT]; /* of a run that has not begun: those that it would begin with */
    double derivatives[TDMF_STATE_COUNT];
    double guards[TDMF_GUARD_COUNT];
} unit_view;

/* Back to the start values of modelDescription.xml, at time 0. */
void unit_reset(unit *unit);

/* Makes model and solver of the parameters, settings and tolerances set; on refusal the unit is left as it
 * was. */
tdmf_refusal unit_prepare(unit *unit);

/* Begins the run at unit->motion.time from the values set so far; on refusal the unit is left as it was. */
tdmf_refusal unit_start(unit *unit);

bool unit_has_begun(const unit *unit);

void unit_evaluate(const unit *unit, unit_view *view);

/* How all that follows from states, inputs and settings changes along a direction: a unit whose states,
 * inputs and parameters are the seed. Discrete outputs do not change, nor does the ground in force. */
void unit_differentiate(const unit *unit, const struct unit *direction, unit_view *change);

/* The same at the start of a run, for all that a start follows from: the seed is in the direction's
 * parameters, inputs, states and time. `given` is the unit before unit_start, `started` the one after. */
void unit_differentiate_start(const unit *given, const struct unit *started, const struct unit *direction,
                              unit_view *change);

/* The direction in which the unit itself moves: derivatives of its states, rates of its inputs. */
void unit_flow(const unit *unit, struct unit *direction);

/* Far beyond any motion, and far enough from overflow for every product of the equations. */
extern const double unit_largest_state;

/* Whether a clock may show this time: differences, sums and ratios of such times are numbers. */
bool unit_is_time(double time);

/* Takes a solver's trial state. Values beyond any motion are cut, so that all that follows stays finite;
 * false, and nothing taken, if one is not a number. */
bool unit_try_state(unit *unit, const double state[TDMF_STATE_COUNT]);

void unit_event_indicators(const unit *unit, double indicators[TDMF_GUARD_COUNT]);

/* Typical magnitudes of the states, from the parameters; importers make absolute tolerances of them. */
void unit_nominals(const unit *unit, double nominals[TDMF_STATE_COUNT]);

/* To be called before an input may jump. */
void unit_observe(unit *unit);

/* Model Exchange: leg.extension has no rate, and may change between events all the same. An update accounts
 * for the leg's work up to where unit_account_for_extension was called last, before inputs may jump there. */
bool unit_extension_has_changed(const unit *unit);
void unit_account_for_extension(unit *unit);

/* Takes a pending event and resolves whatever else is due at unit->motion.time. */
tdmf_resolution unit_update(unit *unit, const unit_observer *observer);

/* Co-Simulation: moves the run on to `until` by the solver chosen. A run that fell stays readable, frozen.
 * Returns NULL, or why it got no farther than unit->motion.time. */
const char *unit_advance(unit *unit, double until, const unit_observer *observer);

/* The same, but stops at the first event on the way (a change of contact mode, hip phase or stride count, an
 * impact, a fall): at its exact time, before it is taken, with unit->event_is_pending. */
const char *unit_advance_to_event(unit *unit, double until, const unit_observer *observer);

/* Why the settings cannot be met by this build, or NULL. */
const char *unit_settings_obstacle(const unit *unit);

#endif
