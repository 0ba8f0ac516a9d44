/* A runner with its settings, as its unit holds it. What of it a saved state holds is in saved_fields.c. */
#ifndef TDMF_RUNNER_FMU_H
#define TDMF_RUNNER_FMU_H

#include "tdmf_slip/tdmf_slip.h"

enum { FMU_STATE_COUNT = TDMF_STATE_COUNT, FMU_GUARD_COUNT = TDMF_GUARD_COUNT };

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
    bool is_exchange;
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

/* Work of the solver in Co-Simulation; stops counting at the largest Integer. */
typedef struct {
    struct {
        int steps;
        int evaluations;
        int layer_steps;
    } solver;
} fmu_work;

/* Values that follow from a run, computed on request. */
typedef struct {
    tdmf_outputs outputs;
    fmu_work work;
    double states[TDMF_STATE_COUNT]; /* of a run that has not begun: those that it would begin with */
    double derivatives[TDMF_STATE_COUNT];
    double guards[TDMF_GUARD_COUNT];
} fmu_view;

/* Names of the enumerations' items, from value 1 on. */
extern const char *const fmu_contact_mode_names[];
extern const char *const fmu_hip_phase_names[];

#endif
