/* Exact derivatives: of state derivatives and outputs by states and inputs, and of outputs along the run.
 *
 * The knowns of a run are its states, inputs and tunable parameters. Before the start they are all variables
 * with a start value, because the start follows from these (FMI 2.0, section 2.2.8, and 3.0, 2.4.8: inputs,
 * and variables with initial = exact). Time is always a known, although only the instants of events depend on
 * it.
 *
 * A direction is an instance whose run holds the seeds of parameters, inputs, states and the time, and whose
 * view receives the derivatives along it. */
#include "run.h"

#include <float.h>
#include <string.h>

/* ---- directions ---------------------------------------------------------------------------------------- */

/* Writes the view of a direction, along variations of parameters and of the states of the mode. */
static void vary_view(const instance *fmu, const double *dp, const double *dx, unit_view *variation) {
    const tdmf_page_instant at = instant_of(fmu);
    double d_rates[UNIT_STATE_COUNT + 1];
    memset(variation, 0, sizeof *variation);
    memcpy(variation->numbers, dp, UNIT_PARAMETER_COUNT * sizeof *dp);
    memcpy(variation->numbers + UNIT_PARAMETER_COUNT, dx, UNIT_STATE_COUNT * sizeof *dx);
    tdmf_vary_page_rates(&at, dp, dx, d_rates);
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        variation->derivatives[i] = d_rates[unit_states[i].index];
    }
    shown_mode_of(fmu)->vary_outputs(at.p, at.x, dp, dx, variation->outputs);
}

/* The run just after inputs that are 0 have begun to move along a direction: some inputs act from then on. */
static instance moved_along(const instance *fmu, const instance *direction) {
    instance moved = *fmu;
    double *x = states_in(&moved);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        if (unit_input_rates[i] >= 0 && x[i] == 0.0 && states_of(direction)[i] != 0.0) {
            x[i] = copysign(DBL_MIN, states_of(direction)[i]);
        }
    }
    take_immediate_events(&moved);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        x[i] = unit_input_rates[i] >= 0 ? states_of(fmu)[i] : x[i];
    }
    return moved;
}

/* Differentiates a run that has begun. */
static void differentiate(const instance *fmu, instance *direction) {
    const instance moved = moved_along(fmu, direction);
    const tdmf_mode_kind *mode = shown_mode_of(&moved);
    const double *dp = parameters_of(direction);
    double dx[UNIT_STATE_COUNT + 1];
    memcpy(dx, states_of(direction), UNIT_STATE_COUNT * sizeof *dx);
    if (mode->vary_from_world != NULL) {
        mode->vary_from_world(parameters_of(fmu), states_of(fmu), dp, states_of(direction), dx);
    }
    vary_view(&moved, dp, dx, &direction->view);
}

/* Differentiates the start of a run. `given` is the instance before it, `started` the one after. Variations
 * of states that the start calculates are written into the run of the direction. */
static void differentiate_start(const instance *given, const instance *started, instance *direction) {
    instance begun = *given;
    double shift = 0.0, dx[UNIT_STATE_COUNT + 1], shown[UNIT_STATE_COUNT + 1];
    double *seeds = states_in(direction), *shown_times = direction->view.numbers + UNIT_PARAMETER_COUNT;
    const tdmf_mode_kind *mode = mode_of(started);
    begin_time(&begun);
    begin_time(direction);
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        double *seed = &seeds[unit_states[i].index];
        *seed = unit_states[i].has_start ? *seed : 0.0; /* the value that it had does not matter */
    }
    memcpy(dx, seeds, sizeof dx);
    tdmf_page_run run = run_of(&begun);
    run.seed_count = 1;
    run.dp = parameters_of(direction);
    run.dx = dx;
    run.shift = &shift;
    tdmf_page_run_to(unit_model, &run, run.time);
    const instance moved = moved_along(started, direction);
    vary_view(&moved, parameters_of(direction), dx, &direction->view);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        const bool is_time = unit_holds_time[i] && states_of(started)[i] >= 0.0;
        shown_times[i] += is_time ? direction->run.epoch : 0.0;
    }
    memcpy(shown, dx, sizeof shown);
    if (mode->vary_to_world != NULL) {
        mode->vary_to_world(parameters_of(started), states_of(started), parameters_of(direction), dx, shown);
    }
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        const int index = unit_states[i].index;
        seeds[index] = unit_states[i].has_start ? seeds[index] : shown[index];
    }
}

/* ---- calls --------------------------------------------------------------------------------------------- */

static bool is_known(const instance *fmu, const fmu_variable *variable) {
    return variable->storage == STORED_STATE || variable->storage == STORED_INPUT ||
           variable->storage == STORED_TIME || variable->variability == VARIABILITY_TUNABLE ||
           (variable->settable_before_start && !fmu->run.has_begun);
}

static bool is_unknown(const fmu_variable *variable) {
    return variable->storage == STORED_STATE || variable->storage == STORED_DERIVATIVE ||
           variable->storage == STORED_OUTPUT || variable->storage == STORED_HELD;
}

typedef struct {
    const uint32_t *references;
    size_t count;
} variable_list;

static bool are_suitable(const instance *fmu, variable_list list, bool as_known) {
    bool suit = ARE_GIVEN(fmu, list.count, list.references);
    for (size_t i = 0; i < list.count && suit; ++i) {
        const fmu_variable *variable = find_variable(fmu, list.references[i], VARIABLE_REAL);
        if (variable == NULL) {
            return false;
        }
        suit = as_known ? is_known(fmu, variable) : is_unknown(variable);
        if (!suit) {
            answer(fmu, CALL_ERROR, "%s is neither %s%s", variable->name,
                   as_known ? "a state nor an input nor tunable" : "an output nor a state derivative",
                   as_known && variable->settable_before_start ? ", and the run has begun" : "");
        }
    }
    return suit;
}

/* Refuses derivatives that are NaN, for example where states are so large that their products overflow. */
static call_status check_derivatives(const instance *fmu, variable_list list, const double values[]) {
    for (size_t i = 0; i < list.count; ++i) {
        if (isnan(values[i])) {
            return answer(fmu, CALL_ERROR, "%s: there is no derivative at this state",
                          fmu_variables[list.references[i]].name);
        }
    }
    return CALL_OK;
}

/* The place of a variable in a direction. */
static double *variation_in(instance *direction, uint32_t reference) {
    return place_in(direction, fmu_variables[reference].storage, fmu_variables[reference].offset);
}

/* The derivative of each unknown along the seeds of the knowns, in one pass. For the adjoint, the derivative
 * by each known of the sum of the unknowns, weighted by the seeds: a pass for each known. */
call_status directional_derivative(instance *fmu, bool is_adjoint, const uint32_t unknowns[],
                                   size_t unknown_count, const uint32_t knowns[], size_t known_count,
                                   const double seeds[], double values[]) {
    const variable_list of = {unknowns, unknown_count}, by = {knowns, known_count};
    const variable_list seeded = is_adjoint ? of : by, written = is_adjoint ? by : of;
    if (!are_suitable(fmu, by, true) || !are_suitable(fmu, of, false) ||
        !ARE_GIVEN(fmu, seeded.count, seeds) || !ARE_GIVEN(fmu, written.count, values)) {
        return CALL_ERROR;
    }
    for (size_t i = 0; i < seeded.count; ++i) {
        if (!isfinite(seeds[i])) {
            return answer(fmu, CALL_DISCARD, "the seed of %s is not finite",
                          fmu_variables[seeded.references[i]].name);
        }
    }
    instance preview, direction;
    const instance *present = present_instance(fmu, &preview);
    if (present == NULL) {
        return CALL_DISCARD;
    }
    for (size_t pass = 0; pass < (is_adjoint ? known_count : 1); ++pass) {
        const size_t first = is_adjoint ? pass : 0, end = is_adjoint ? pass + 1 : known_count;
        double sum = 0.0;
        memset(&direction, 0, sizeof direction);
        for (size_t i = first; i < end; ++i) {
            *variation_in(&direction, knowns[i]) += is_adjoint ? 1.0 : seeds[i];
        }
        if (fmu->run.has_begun) {
            differentiate(present, &direction);
        } else {
            differentiate_start(fmu, present, &direction);
        }
        for (size_t i = 0; i < unknown_count; ++i) {
            const double value = *variation_in(&direction, unknowns[i]);
            sum += is_adjoint ? seeds[i] * value : 0.0;
            values[is_adjoint ? pass : i] = is_adjoint ? sum : value;
        }
    }
    return check_derivatives(fmu, written, values);
}

/* The direction in which the unit itself moves: derivatives of its states, rates of its inputs. */
static void write_flow(const instance *fmu, instance *direction) {
    const tdmf_page_instant at = instant_of(fmu);
    memset(direction, 0, sizeof *direction);
    tdmf_page_world_rates(&at, states_in(direction));
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        double *rate = &states_in(direction)[unit_states[i].index];
        *rate = within_largest(*rate);
    }
}

call_status output_derivatives(const instance *fmu, const uint32_t references[], size_t count,
                               const int orders[], double values[]) {
    const variable_list outputs = {references, count};
    instance flow;
    if (!ARE_GIVEN(fmu, count, references, orders, values)) {
        return CALL_ERROR;
    }
    write_flow(fmu, &flow);
    differentiate(fmu, &flow);
    for (size_t i = 0; i < count; ++i) {
        const fmu_variable *variable = find_variable(fmu, references[i], VARIABLE_REAL);
        if (variable == NULL) {
            return CALL_ERROR;
        }
        if (orders[i] != 1 || (variable->storage != STORED_OUTPUT && variable->storage != STORED_STATE)) {
            return answer(fmu, CALL_ERROR, "only first derivatives of outputs are given: %s, order %d",
                          variable->name, orders[i]);
        }
        values[i] = *variation_in(&flow, references[i]);
    }
    return check_derivatives(fmu, outputs, values);
}
