/* The seam between the physics and FMI: a runner with its settings, whatever FMI version drives it. Plain
 * data, so that copying a unit copies the whole run; what of it a saved state holds is in saved_fields.c. */
#ifndef TDMF_FMU_H
#define TDMF_FMU_H

#include "tdmf_slip/tdmf_slip.h"

typedef enum { SOLVER_NATIVE = 1, SOLVER_CVODE } solver_method;

/* Parameters of the unit rather than of the runner. Member paths are variable names, as in the core. */
typedef struct {
    struct {
        bool terminate_on_fall;
    } status;
    struct {
        int method; /* solver_method */
        double relative_tolerance;
    } solver;
} fmu_settings;

typedef struct fmu {
    fmu_settings settings;
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
} fmu;

static inline tdmf_system fmu_system(const fmu *fmu) {
    const tdmf_system system = {&fmu->model, &fmu->inputs};
    return system;
}

/* Told of every event that the unit takes, if an observer is given. */
typedef struct {
    void (*on_event)(void *subject, const tdmf_event *event); /* or NULL */
    void *subject;
} fmu_observer;

/* What the solver of Co-Simulation has done; stops counting at the largest Integer. */
typedef struct {
    struct {
        int steps;
        int evaluations;
        int layer_steps;
    } solver;
} fmu_work;

/* What follows from a unit and is computed when it is asked for. */
typedef struct {
    tdmf_outputs outputs;
    fmu_work work;
    double states[TDMF_STATE_COUNT]; /* of a run that has not begun: those that it would begin with */
    double derivatives[TDMF_STATE_COUNT];
    double guards[TDMF_GUARD_COUNT];
} fmu_view;

/* Back to the start values of modelDescription.xml, at time 0. */
void fmu_reset(fmu *fmu);

/* Makes model and solver of the parameters, settings and tolerances set; on refusal the unit is left as it
 * was. */
tdmf_refusal fmu_prepare(fmu *fmu);

/* Begins the run at fmu->motion.time from the values set so far; on refusal the unit is left as it was. */
tdmf_refusal fmu_start(fmu *fmu);

bool fmu_has_begun(const fmu *fmu);

void fmu_evaluate(const fmu *fmu, fmu_view *view);

/* How all that follows from states, inputs and settings changes along a direction: a unit whose states,
 * inputs and parameters are the seed. Discrete outputs do not change, nor does the ground in force. */
void fmu_differentiate(const fmu *fmu, const struct fmu *seed, fmu_view *variation);

/* The same at the start of a run, for all that a start follows from: the seed is in the direction's
 * parameters, inputs, states and time. `given` is the unit before fmu_start, `started` the one after. */
void fmu_differentiate_start(const fmu *given, const struct fmu *started, const struct fmu *seed,
                             fmu_view *variation);

/* The direction in which the unit itself moves: derivatives of its states, rates of its inputs. */
void fmu_flow(const fmu *fmu, struct fmu *seed);

/* This is far beyond any motion, and far enough from overflow for every product of the equations. */
extern const double fmu_largest_state;

/* Whether a clock may show this time: differences, sums and ratios of such times are numbers. */
bool fmu_is_time(double time);

/* Takes a solver's trial state. Values beyond any motion are cut, so that all that follows stays finite;
 * false, and nothing taken, if one is not a number. */
bool fmu_try_state(fmu *fmu, const double state[TDMF_STATE_COUNT]);

/* Cut as trial states are: a friction that falls with speed grows beyond all numbers where a trial goes past
 * the foot's rest, and an importer's solver then has to see that its step was too long. */
void fmu_derivatives(const fmu *fmu, double derivatives[TDMF_STATE_COUNT]);

void fmu_event_indicators(const fmu *fmu, double indicators[TDMF_GUARD_COUNT]);

/* Typical magnitudes of the states, from the parameters; importers make absolute tolerances of them. */
void fmu_nominals(const fmu *fmu, double nominals[TDMF_STATE_COUNT]);

/* This is to be called before an input may jump. */
void fmu_observe(fmu *fmu);

/* Model Exchange: leg.extension has no rate, and may change between events all the same. An update accounts
 * for the leg's work up to where fmu_account_for_extension was called last, before inputs may jump there. */
bool fmu_extension_has_changed(const fmu *fmu);
void fmu_account_for_extension(fmu *fmu);

/* Takes a pending event and resolves whatever else is due at fmu->motion.time. */
tdmf_resolution fmu_update(fmu *fmu, const fmu_observer *observer);

/* Co-Simulation: moves the run on to `until` by the solver chosen. A run that fell stays readable, frozen.
 * Returns NULL, or why it got no farther than fmu->motion.time. */
const char *fmu_advance(fmu *fmu, double until, const fmu_observer *observer);

/* The same, but stops at the first event on the way (a change of contact mode, hip phase or stride count, an
 * impact, a fall): at its exact time, before it is taken, with fmu->event_is_pending. */
const char *fmu_advance_to_event(fmu *fmu, double until, const fmu_observer *observer);

/* Why the settings cannot be met by this build, or NULL. */
const char *fmu_settings_obstacle(const fmu *fmu);

#endif
