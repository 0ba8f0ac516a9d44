/* Calls that advance time. In Model Exchange the importer integrates; the unit gives derivatives and event
 * indicators, and takes events. In Co-Simulation the unit integrates. Both interfaces have event mode. */
#include "instance.h"
#include "run.h"
#include "run_state.h"

#include <float.h>

static const unsigned evaluable =
    INITIALIZATION_MODE | EVENT_MODE | CONTINUOUS_TIME_MODE | TERMINATED | FAILED;

/* ---- events -------------------------------------------------------------------------------------------- */

call_status enter_event_mode(instance *instance, const char *call, unsigned allowed_states) {
    if (!call_is_allowed(instance, call, allowed_states)) {
        return CALL_ERROR;
    }
    fmu_enter_event_mode(&instance->fmu);
    discard_view(instance);
    instance->state = EVENT_MODE;
    return CALL_OK;
}

/* The longest step of an importer's solver is reported as a time event, which no solver steps over. */
call_status update_discrete_states(instance *instance, const char *call, discrete_update *update) {
    if (!call_is_allowed(instance, call, EVENT_MODE)) {
        return CALL_ERROR;
    }
    fmu *fmu = &instance->fmu;
    char text[FMU_TEXT];
    const char *obstacle = fmu_update(fmu, observer_of(instance), &update->states_changed, text);
    discard_view(instance);
    if (obstacle != NULL) {
        instance->state = FAILED;
        return answer(instance, CALL_ERROR, call, "%s", obstacle);
    }
    const tdmf_mode_kind *mode = mode_of(fmu);
    const double longest = tdmf_longest_step_of_law(mode, parameters_of(fmu), states_of(fmu));
    update->terminate = fmu->is_exchange && mode->ends && fmu->settings[SETTING_TERMINATES] != 0.0;
    update->next_time_defined = fmu->is_exchange && isfinite(longest);
    update->next_time = update->next_time_defined ? fmu->time + longest : 0.0;
    return CALL_OK;
}

/* ---- Model Exchange ------------------------------------------------------------------------------------ */

call_status complete_step(instance *instance, const char *call, const void *event_mode, const void *terminate,
                          bool *asks) {
    if (!MAY_BEGIN(instance, call, CONTINUOUS_TIME_MODE, 1, event_mode, terminate)) {
        return CALL_ERROR;
    }
    *asks = fmu_complete_step(&instance->fmu);
    discard_view(instance);
    return CALL_OK;
}

call_status set_time(instance *instance, const char *call, double time) {
    if (!call_is_allowed(instance, call, EVENT_MODE | CONTINUOUS_TIME_MODE)) {
        return CALL_ERROR;
    }
    if (!fmu_is_time(time)) {
        return answer(instance, CALL_ERROR, call, "the time is not finite or beyond 1e100 s");
    }
    fmu_set_time(&instance->fmu, time);
    discard_view(instance);
    return CALL_OK;
}

call_status set_states(instance *instance, const char *call, const double states[], size_t count) {
    if (!call_is_allowed(instance, call, CONTINUOUS_TIME_MODE) ||
        !array_is_given(instance, call, states, count, UNIT_CONTINUOUS_COUNT)) {
        return CALL_ERROR;
    }
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        if (isnan(states[i])) {
            return answer(instance, CALL_DISCARD, call, "a state is not a number");
        }
    }
    fmu_try_states(&instance->fmu, states);
    discard_view(instance);
    return CALL_OK;
}

call_status get_states(instance *instance, const char *call, double states[], size_t count) {
    if (!call_is_allowed(instance, call, evaluable) ||
        !array_is_given(instance, call, states, count, UNIT_CONTINUOUS_COUNT)) {
        return CALL_ERROR;
    }
    call_status status = CALL_OK;
    const fmu_view *view = instance->fmu.has_begun ? NULL : current_view(instance, call, &status);
    fmu_states(&instance->fmu, view, states);
    return status;
}

/* Writes values of the run or, before it begins, of the run that would start now. */
static call_status get_values(const instance *instance, const char *call, double values[], size_t count,
                              size_t wanted, void (*write)(const fmu *fmu, double values[])) {
    if (!call_is_allowed(instance, call, evaluable) ||
        !array_is_given(instance, call, values, count, wanted)) {
        return CALL_ERROR;
    }
    fmu preview;
    call_status status = CALL_OK;
    const fmu *fmu = present_fmu(instance, call, &preview, &status);
    if (fmu != NULL) {
        write(fmu, values);
    }
    return status;
}

call_status get_derivatives(instance *instance, const char *call, double derivatives[], size_t count) {
    return get_values(instance, call, derivatives, count, UNIT_CONTINUOUS_COUNT, fmu_derivatives);
}

call_status get_indicators(instance *instance, const char *call, double indicators[], size_t count) {
    return get_values(instance, call, indicators, count, UNIT_GUARD_COUNT, fmu_event_indicators);
}

call_status get_nominals(instance *instance, const char *call, double nominals[], size_t count) {
    if (!call_is_allowed(instance, call, INSTANTIATED | evaluable) ||
        !array_is_given(instance, call, nominals, count, UNIT_CONTINUOUS_COUNT)) {
        return CALL_ERROR;
    }
    fmu_nominals(&instance->fmu, nominals);
    return CALL_OK;
}

/* ---- Co-Simulation ------------------------------------------------------------------------------------- */

/* Error that is tolerated in the times of importers, which add them up or scale them: rounding, and a share
 * of the step. */
static double clock_rounding(double time, double step) {
    return 16.0 * DBL_EPSILON * fabs(time) + 1e-6 * step;
}

/* Steps without event mode: the unit locates and takes events inside a step, and the step ends where the
 * importer wants it. */
call_status step_on(instance *instance, const char *call, double time, double step, bool stop_at_event,
                    bool *event) {
    char text[FMU_TEXT], length[NUMBER_CAPACITY], clock[NUMBER_CAPACITY];
    if (!call_is_allowed(instance, call, STEP_MODE)) {
        return CALL_ERROR;
    }
    fmu *fmu = &instance->fmu;
    if (!(step > 0.0 && fmu_is_time(time + step))) {
        return answer(instance, CALL_ERROR, call, "the step is not a positive number");
    }
    if (!(time + step > time)) {
        return answer(instance, CALL_ERROR, call, "a step of %s s is lost in the rounding of the time, %s s",
                      number_text(step, length), number_text(time, clock));
    }
    const double allowed = clock_rounding(time, step);
    if (!(fabs(time - fmu->time) <= allowed)) {
        return answer(instance, CALL_ERROR, call, "the communication point is not where the last step ended");
    }
    if (time + step > fmu->stop_time + allowed) {
        return answer(instance, CALL_ERROR, call, "the step goes beyond the stop time, %s s",
                      number_text(fmu->stop_time, clock));
    }
    const char *obstacle = fmu_advance(fmu, time + step, stop_at_event, observer_of(instance), text);
    discard_view(instance);
    *event = fmu->event_is_pending;
    if (obstacle != NULL) {
        instance->state = FAILED;
        return answer(instance, CALL_ERROR, call, "%s", obstacle);
    }
    return CALL_OK;
}
