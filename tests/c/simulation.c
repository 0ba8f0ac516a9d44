#include "simulation.h"

#include "compare.h"

#include <float.h>
#include <math.h>
#include <string.h>

void skip_without_cvode(void) {
    if (!tdmf_cvode_is_available()) {
        skip();
    }
}

tdmf_model accepted_model(const tdmf_parameters *parameters) {
    tdmf_model model;
    assert_null(tdmf_model_create(&model, parameters).variable);
    return model;
}

tdmf_solver solver_to(double relative_tolerance) {
    tdmf_solver solver = tdmf_solver_default();
    solver.relative_tolerance = relative_tolerance;
    return solver;
}

static simulation begun(const tdmf_model *model, const tdmf_inputs *inputs,
                        const double state[TDMF_STATE_COUNT], double relative_tolerance) {
    simulation simulation;
    memset(&simulation, 0, sizeof simulation);
    simulation.model = *model;
    simulation.inputs = *inputs;
    simulation.solver = solver_to(relative_tolerance);
    memcpy(simulation.motion.state, state, sizeof simulation.motion.state);
    simulation_start(&simulation);
    return simulation;
}

simulation simulation_in(const tdmf_parameters *parameters, const tdmf_inputs *inputs,
                         const double state[TDMF_STATE_COUNT], double relative_tolerance) {
    const tdmf_model model = accepted_model(parameters);
    return begun(&model, inputs, state, relative_tolerance);
}

simulation simulation_from(const tdmf_parameters *parameters, const tdmf_inputs *inputs,
                           const double section[TDMF_SECTION_COUNT], double relative_tolerance) {
    const tdmf_model model = accepted_model(parameters);
    double state[TDMF_STATE_COUNT];
    tdmf_section_state((tdmf_system){&model, inputs}, section, state);
    return begun(&model, inputs, state, relative_tolerance);
}

simulation simulation_of(const runner *runner, double relative_tolerance) {
    return begun(&runner->model, &runner->inputs, runner->motion.state, relative_tolerance);
}

void simulation_start(simulation *simulation) {
    simulation->motion.time = 0.0;
    assert_null(tdmf_start(SYSTEM_OF(simulation), &simulation->motion).variable);
    simulation->start_energy = simulation_energy(simulation) +
                               simulation->motion.state[TDMF_ENERGY_IMPACT_LOSS] -
                               simulation->motion.state[TDMF_LEG_WORK];
}

tdmf_outcome simulation_advance_by(solver_call *advance, simulation *simulation, double until) {
    simulation->log.count = 0;
    simulation->solver.log = &simulation->log;
    const tdmf_outcome outcome =
        advance(&simulation->solver, SYSTEM_OF(simulation), &simulation->rates, until, &simulation->motion);
    simulation->solver.log = NULL; /* a copy would note its events here */
    return outcome;
}

tdmf_outcome simulation_advance(simulation *simulation, double until) {
    return simulation_advance_by(tdmf_native_advance, simulation, until);
}

void simulation_stride(simulation *simulation) {
    simulation->log.count = 0;
    simulation->solver.log = &simulation->log;
    assert_true(
        tdmf_native_stride(&simulation->solver, SYSTEM_OF(simulation), DBL_MAX, &simulation->motion).closed);
    simulation->solver.log = NULL;
}

const tdmf_event *simulation_event(const simulation *simulation, tdmf_guard guard) {
    for (int i = 0; i < simulation->log.count && i < TDMF_EVENT_CAPACITY; ++i) {
        if (simulation->log.events[i].guard == (int)guard) {
            return &simulation->log.events[i];
        }
    }
    return NULL;
}

double simulation_energy(const simulation *simulation) {
    return OUTPUTS_OF(simulation).energy.total;
}

double simulation_ledger_error(const simulation *simulation) {
    const double *state = simulation->motion.state;
    return simulation_energy(simulation) - simulation->start_energy - state[TDMF_HIP_WORK] -
           state[TDMF_LEG_WORK] - state[TDMF_ENERGY_EXTERNAL_WORK] + state[TDMF_ENERGY_DAMPER_LOSS] +
           state[TDMF_ENERGY_FRICTION_LOSS] + simulation->motion.state[TDMF_ENERGY_IMPACT_LOSS];
}

void read_apex(const tdmf_motion *motion, double section[TDMF_SECTION_COUNT]) {
    memcpy(section, &motion->state[TDMF_APEX_COM_HEIGHT], TDMF_SECTION_COUNT * sizeof *section);
}

void assert_refusal_text(tdmf_refusal refusal, const char *expected) {
    char text[256];
    assert_string_equal(tdmf_refusal_text(&refusal, text, sizeof text), expected);
}

void assert_same_stride(tdmf_stride a, tdmf_stride b, double tolerance) {
    const double pairs[][2] = {{a.period, b.period},
                               {a.length, b.length},
                               {a.speed, b.speed},
                               {a.rise, b.rise},
                               {a.work, b.work},
                               {a.positive_work, b.positive_work},
                               {a.leg_work, b.leg_work},
                               {a.stance_time, b.stance_time},
                               {a.duty_factor, b.duty_factor},
                               {a.slip_distance, b.slip_distance},
                               {a.peak_force, b.peak_force},
                               {a.peak_vertical_force, b.peak_vertical_force}};
    for (size_t i = 0; i < COUNT_OF(pairs); ++i) {
        assert_close(pairs[i][0], pairs[i][1], tolerance * (1.0 + fabs(pairs[i][1])));
    }
    assert_string_equal(a.word, b.word);
    assert_int_equal(a.touchdowns, b.touchdowns);
}

void assert_same_state(const tdmf_motion *a, const tdmf_motion *b, double tolerance) {
    static const int integrals[] = {TDMF_HIP_WORK,
                                    TDMF_HIP_PLACE_TIME,
                                    TDMF_LEG_WORK,
                                    TDMF_ENERGY_DAMPER_LOSS,
                                    TDMF_ENERGY_FRICTION_LOSS,
                                    TDMF_HIP_POSITIVE_WORK,
                                    TDMF_ENERGY_EXTERNAL_WORK};
    assert_all_close(&a->state[TDMF_FOOT_X], &b->state[TDMF_FOOT_X], TDMF_MECHANICAL_COUNT, tolerance,
                     tolerance);
    for (size_t i = 0; i < COUNT_OF(integrals); ++i) {
        const double expected = b->state[integrals[i]];
        assert_close(a->state[integrals[i]], expected, tolerance * (1.0 + fabs(expected)));
    }
}
