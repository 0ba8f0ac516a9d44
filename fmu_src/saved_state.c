/* Saved and serialized states: the plain data of a run behind a header that shows whether this unit wrote it.
 * A serialized state has the same bytes as a saved one, so that it restores in any instance and process.
 * Every field is checked before a state is restored: a run can go on from any state that is accepted. */
#include "guid.h"
#include "instance.h"
#include "run.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RUN_SIZE = offsetof(fmu, step_limit) };

typedef struct {
    uint64_t zero; /* for importers that pass a state to be freed instead of its address */
    char guid[40]; /* guid of the unit that saved the state: its variables and version */
    uint32_t byte_order;
    uint32_t size;
    uint64_t checksum; /* checksum of the bytes that follow */
    int32_t interface, state;
    unsigned char run[RUN_SIZE];
} saved_state;

static const uint32_t byte_order = 0x01020304; /* reads otherwise on a machine of another kind */

/* FNV-1a */
static uint64_t checksum_of(const saved_state *saved) {
    const unsigned char *bytes = (const unsigned char *)saved;
    uint64_t hash = UINT64_C(14695981039346656037);
    for (size_t i = offsetof(saved_state, interface); i < sizeof *saved; ++i) {
        hash = (hash ^ bytes[i]) * UINT64_C(1099511628211);
    }
    return hash;
}

static void write_header(saved_state *saved) {
    saved->zero = 0;
    memset(saved->guid, 0, sizeof saved->guid);
    memcpy(saved->guid, FMU_GUID, sizeof FMU_GUID);
    saved->byte_order = byte_order;
    saved->size = sizeof *saved;
    saved->checksum = checksum_of(saved);
}

/* ---- ranges of fields ---------------------------------------------------------------------------------- */

/* False for NaN. */
static bool lies_between(double value, double least, double most) {
    return value >= least && value <= most;
}

/* The name of the first setting that is out of its range, or is not whole but of another type than Real. */
static const char *wrong_setting(const fmu *fmu) {
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmu_variable *v = &fmu_variables[i];
        if (v->storage == STORED_SETTING || (v->storage == STORED_PARAMETER && v->type != VARIABLE_REAL)) {
            const double value = fmu_get_number(fmu, NULL, v);
            if (!lies_between(value, v->minimum, v->maximum) ||
                (v->type != VARIABLE_REAL && value != floor(value))) {
                return v->name;
            }
        }
    }
    return NULL;
}

static const char *wrong_motion(const page_motion *motion) {
    const tdmf_mode_kind *modes = unit_model->modes;
    const double digit = DBL_EPSILON * fabs(motion->time);
    if (!fmu_is_time(motion->time)) {
        return "the time";
    }
    if (!lies_between(motion->time_rest, -digit, digit)) {
        return "the rest of the time";
    }
    if (!(motion->mode >= 0 && motion->mode < unit_model->mode_count)) {
        return "the mode";
    }
    if (!(motion->chain >= 0 && motion->chain <= TDMF_PAGE_CHAIN_LIMIT + 1)) {
        return "the chain of events";
    }
    const bool is_shown =
        motion->shown >= 0 && motion->shown < unit_model->mode_count &&
        (motion->shown == motion->mode || (modes[motion->mode].keeps_outputs && !modes[motion->shown].ends));
    return is_shown ? NULL : "the mode that is shown";
}

static const char *wrong_call(const saved_state *saved, const fmu *fmu) {
    if (!(saved->interface >= MODEL_EXCHANGE && saved->interface <= CO_SIMULATION_WITH_EVENT_MODE)) {
        return "the interface";
    }
    if (fmu->has_begun != 0 && fmu->has_begun != 1) {
        return "whether the run has begun";
    }
    if (fmu->has_jumped != 0 && fmu->has_jumped != 1) {
        return "whether an input has jumped";
    }
    const bool may_wait = saved->interface == CO_SIMULATION_WITH_EVENT_MODE && fmu->has_begun;
    if (!(fmu->event_is_pending == 0 || (fmu->event_is_pending == 1 && may_wait)) ||
        !(fmu->event >= 0 && fmu->event <= UNIT_EVENT_COUNT)) {
        return "the pending event";
    }
    const bool suits =
        state_suits_interface((unsigned)saved->state, (interface_kind)saved->interface, fmu->has_begun);
    return suits ? NULL : "the state of the call sequence";
}

/* Checks fields that do not depend on others. */
static const char *wrong_field(const fmu *fmu) {
    if (!lies_between(fmu->importer_tolerance, DBL_MIN * DBL_EPSILON, INFINITY)) {
        return "the importer's tolerance";
    }
    if (!lies_between(fmu->stop_time, -DBL_MAX, INFINITY)) {
        return "the stop time";
    }
    if (!fmu_is_time(fmu->time) || !fmu_is_time(fmu->epoch) || !fmu_is_time(fmu->accounted_time)) {
        return "the time";
    }
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        if (!lies_between(fmu->starts[i], -fmu_largest_sum, fmu_largest_sum)) {
            return unit_model->state_names[i];
        }
        if (!lies_between(fmu->accounted_rates[i], -DBL_MAX, DBL_MAX)) {
            return "a rate";
        }
    }
    for (int i = 0; i < UNIT_EVENT_COUNT; ++i) {
        if (fmu->watch[i] > WATCH_RISING) {
            return "how a guard was seen";
        }
    }
    for (int i = 0; i < WORK_COUNT; ++i) { /* half the range is left for the run to go on */
        if (!(fmu->work[i] >= 0 && fmu->work[i] <= INT64_MAX / 2)) {
            return "the work done";
        }
    }
    return fmu->has_begun ? number_out_of_range(fmu->accounted) : NULL;
}

/* ---- consistency of a run that has begun --------------------------------------------------------------- */

/* The name of the first state in the world's coordinates that does not follow from those of the mode, as it
 * has to in Co-Simulation. */
static const char *wrong_coordinate(const fmu *fmu) {
    struct fmu shown = *fmu;
    const tdmf_page_instant at = instant_of(fmu);
    show_to_world(&shown);
    for (int i = 0; i < UNIT_STATE_COUNT; ++i) {
        const double value = states_of(fmu)[i], seen = states_of(&shown)[i];
        if (!(fabs(value - seen) <= 1e-9 * (at.scales[i] + fabs(value)))) {
            return unit_numbers[UNIT_PARAMETER_COUNT + i].name;
        }
    }
    return NULL;
}

/* The name of the first state that is beyond the page's bounds, or holds a time in the future. */
static const char *wrong_state(const fmu *fmu) {
    const double *x = states_of(fmu);
    for (int i = 0; i < UNIT_BOUND_COUNT; ++i) {
        const unit_bound *row = &unit_bounds[i];
        const double value = x[row->state];
        if (!(fmu->is_exchange && row->moves) &&
            !(lies_between(value, row->least, row->most) && (!row->is_whole || value == floor(value)))) {
            return unit_numbers[UNIT_PARAMETER_COUNT + row->state].name;
        }
    }
    for (int i = 0; i < UNIT_STATE_COUNT && !fmu->is_exchange; ++i) {
        if (unit_holds_time[i] && x[i] > fmu->motion.time) {
            return unit_numbers[UNIT_PARAMETER_COUNT + i].name;
        }
    }
    return NULL;
}

static bool clocks_agree(const fmu *fmu) {
    const double digit = 4.0 * DBL_EPSILON * fmax(fabs(fmu->time), fabs(fmu->epoch));
    return fabs(fmu->time - fmu->epoch - fmu->motion.time) <= digit &&
           (unit_clock < 0 || states_of(fmu)[unit_clock] == fmu->motion.time);
}

/* A pending event was due by the numbers with which the run stopped. */
static bool event_may_be_pending(const fmu *fmu) {
    struct fmu stopped = *fmu;
    const tdmf_guard_kind *kind;
    memcpy(stopped.motion.numbers, fmu->accounted, sizeof fmu->accounted);
    return guard_of_pending_event(&stopped, &kind) <= rounding_at_event;
}

static bool rates_are_finite(const fmu *fmu) {
    double derivatives[UNIT_CONTINUOUS_COUNT + 1];
    bool finite = true;
    fmu_derivatives(fmu, derivatives);
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        finite &= fabs(derivatives[i]) < fmu_largest_state;
    }
    return finite;
}

static const char *wrong_run(const fmu *fmu) {
    const char *wrong = clocks_agree(fmu) ? wrong_state(fmu) : "the time";
    if (wrong == NULL && !fmu->is_exchange) {
        wrong = wrong_coordinate(fmu);
    }
    if (wrong == NULL && !fmu->is_exchange && !rates_are_finite(fmu)) {
        wrong = "a state, which has no finite rate";
    }
    return wrong == NULL && fmu->event_is_pending && !event_may_be_pending(fmu) ? "the pending event" : wrong;
}

/* ---- reading and writing ------------------------------------------------------------------------------- */

/* Checks the bytes of a state and reads them into `saved` and `fmu`, which has working memory. Returns NULL,
 * or the reason why they are refused, for which `text` is room. */
static const char *read_state(const void *bytes, saved_state *saved, fmu *fmu, char text[FMU_TEXT]) {
    memcpy(saved, bytes, sizeof *saved);
    saved_state wanted = *saved;
    write_header(&wanted);
    if (saved->byte_order != wanted.byte_order || saved->size != wanted.size) {
        return "it was saved by another program or on another kind of machine";
    }
    if (saved->zero != wanted.zero || memcmp(saved->guid, wanted.guid, sizeof wanted.guid) != 0) {
        return "it was saved by another version of the unit";
    }
    if (saved->checksum != wanted.checksum) {
        return "its bytes have been changed";
    }
    memcpy(fmu, saved->run, RUN_SIZE);
    fmu->is_exchange = saved->interface == MODEL_EXCHANGE;
    const char *wrong = wrong_setting(fmu);
    wrong = wrong == NULL ? wrong_motion(&fmu->motion) : wrong;
    wrong = wrong == NULL ? number_out_of_range(fmu->motion.numbers) : wrong;
    wrong = wrong == NULL ? wrong_field(fmu) : wrong;
    wrong = wrong == NULL ? wrong_call(saved, fmu) : wrong;
    if (wrong == NULL && fmu->has_begun) {
        if (unmet_requirement(fmu, true, text) != NULL) {
            return text;
        }
        if (fmu->is_exchange) {
            take_from_world(fmu);
        }
        wrong = wrong_run(fmu);
    }
    if (wrong == NULL) {
        return NULL;
    }
    snprintf(text, FMU_TEXT, "%s is out of range or contradicts the rest", wrong);
    return text;
}

/* Memory for a state: that of the importer's old state, if it passes one. */
static void *room_for_state(void *old) {
    return old != NULL ? old : malloc(sizeof(saved_state));
}

call_status save_state(instance *instance, const char *call, void **state) {
    if (!MAY_BEGIN(instance, call, ANYWHERE, 1, state)) {
        return CALL_ERROR;
    }
    saved_state *saved = room_for_state(*state);
    if (saved == NULL) {
        instance->state = FAILED;
        return answer(instance, CALL_ERROR, call, "out of memory");
    }
    saved->interface = (int32_t)instance->interface;
    saved->state = (int32_t)instance->state;
    memcpy(saved->run, &instance->fmu, RUN_SIZE);
    write_header(saved);
    *state = saved;
    return CALL_OK;
}

call_status restore_state(instance *instance, const char *call, const void *state) {
    char text[FMU_TEXT];
    if (!call_is_allowed(instance, call, ANYWHERE)) {
        return CALL_ERROR;
    }
    if (state == NULL) {
        return answer(instance, CALL_DISCARD, call, "the state is a null pointer");
    }
    fmu fmu = instance->fmu;
    saved_state saved;
    const char *reason = read_state(state, &saved, &fmu, text);
    if (reason == NULL && saved.interface != (int32_t)instance->interface) {
        reason = "it was saved in another interface";
    }
    if (reason != NULL) {
        return answer(instance, CALL_DISCARD, call, "the state is refused: %s", reason);
    }
    instance->fmu = fmu;
    instance->state = (call_state)saved.state;
    discard_view(instance);
    return CALL_OK;
}

call_status free_state(instance *instance, const char *call, void **state) {
    if (!call_is_allowed(instance, call, ANYWHERE)) {
        return CALL_ERROR;
    }
    if (state != NULL) {
        free(*state);
        *state = NULL;
    }
    return CALL_OK;
}

call_status measure_state(instance *instance, const char *call, const void *state, size_t *size) {
    if (!MAY_BEGIN(instance, call, ANYWHERE, 1, state, size)) {
        return CALL_ERROR;
    }
    *size = sizeof(saved_state);
    return CALL_OK;
}

call_status serialize_state(instance *instance, const char *call, const void *state, void *bytes,
                            size_t size) {
    if (!MAY_BEGIN(instance, call, ANYWHERE, 1, state) ||
        !array_is_given(instance, call, bytes, size, sizeof(saved_state))) {
        return CALL_ERROR;
    }
    memcpy(bytes, state, sizeof(saved_state));
    return CALL_OK;
}

call_status deserialize_state(instance *instance, const char *call, const void *bytes, size_t size,
                              void **state) {
    char text[FMU_TEXT];
    if (!MAY_BEGIN(instance, call, ANYWHERE, 1, bytes, state)) {
        return CALL_ERROR;
    }
    if (size != sizeof(saved_state)) {
        return answer(instance, CALL_DISCARD, call, "%lu bytes are no state of this unit, which has %lu",
                      (unsigned long)size, (unsigned long)sizeof(saved_state));
    }
    fmu fmu = instance->fmu;
    saved_state saved;
    const char *reason = read_state(bytes, &saved, &fmu, text);
    if (reason != NULL) {
        return answer(instance, CALL_DISCARD, call, "the bytes are refused: %s", reason);
    }
    void *room = room_for_state(*state);
    if (room == NULL) {
        instance->state = FAILED;
        return answer(instance, CALL_ERROR, call, "out of memory");
    }
    memcpy(room, bytes, sizeof saved);
    *state = room;
    return CALL_OK;
}
