/* Saved and serialized states: the run behind a header that shows whether this unit wrote it. A serialized
 * state has the same bytes as a saved one, so that it restores in any instance and process. Every field is
 * checked before a state is restored: a run can go on from any state that is accepted. */
#include "guid.h"
#include "run.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    uint64_t zero; /* for importers that pass a state to be freed instead of its address */
    char guid[40]; /* guid of the unit that saved the state: its variables and version */
    uint32_t byte_order;
    uint32_t size;
    uint64_t checksum; /* checksum of the run */
    unit_run run;
} saved_state;

static const uint32_t byte_order = 0x01020304; /* reads otherwise on a machine of another kind */

/* FNV-1a */
static uint64_t checksum_of(const unit_run *run) {
    const unsigned char *bytes = (const unsigned char *)run;
    uint64_t hash = UINT64_C(14695981039346656037);
    for (size_t i = 0; i < sizeof *run; ++i) {
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
    saved->checksum = checksum_of(&saved->run);
}

/* ---- fields -------------------------------------------------------------------------------------------- */

typedef enum { FIELD_DOUBLE, FIELD_INT32, FIELD_INT64, FIELD_BYTE } field_type;

static const size_t sizes[] = {sizeof(double), sizeof(int32_t), sizeof(int64_t), 1};

/* A field of the run with the range of its numbers. NaN is out of every range. */
typedef struct {
    const char *name; /* for messages */
    field_type type;
    size_t offset, size;
    double least, most;
} field;

#define FIELD(name, type, member, least, most)                                                               \
    { name, type, offsetof(unit_run, member), sizeof(((unit_run *)0)->member), least, most }

/* Fields that must agree with others are checked below, as are the settings and the numbers of the motion.
 * Any value of `taken`, `above` and `late` is allowed. */
static const field fields[] = {
    FIELD("the interface", FIELD_INT32, interface, MODEL_EXCHANGE, CO_SIMULATION_WITH_EVENT_MODE),
    FIELD("whether the run has begun", FIELD_INT32, has_begun, 0, 1),
    FIELD("the pending event", FIELD_INT32, event_is_pending, 0, 1),
    FIELD("whether an input has jumped", FIELD_INT32, has_jumped, 0, 1),
    FIELD("the pending event", FIELD_INT32, event, 0, UNIT_EVENT_COUNT),
    FIELD("the time", FIELD_DOUBLE, motion.time, -largest_time, largest_time),
    FIELD("the chain of events", FIELD_INT64, motion.chain, 0, TDMF_PAGE_CHAIN_LIMIT + 1),
    FIELD("the mode", FIELD_INT32, motion.mode, 0, UNIT_MODE_COUNT - 1),
    FIELD("the mode that is shown", FIELD_INT32, motion.shown, 0, UNIT_MODE_COUNT - 1),
    FIELD("the time", FIELD_DOUBLE, time, -largest_time, largest_time),
    FIELD("the time", FIELD_DOUBLE, epoch, -largest_time, largest_time),
    FIELD("a start value", FIELD_DOUBLE, starts, -fmu_largest_sum, fmu_largest_sum),
    FIELD("the importer's tolerance", FIELD_DOUBLE, importer_tolerance, (DBL_MIN * DBL_EPSILON), INFINITY),
    FIELD("the stop time", FIELD_DOUBLE, stop_time, -DBL_MAX, INFINITY),
    FIELD("a rate", FIELD_DOUBLE, accounted_rates, -DBL_MAX, DBL_MAX),
    FIELD("the time", FIELD_DOUBLE, accounted_time, -largest_time, largest_time),
    FIELD("the work done", FIELD_INT64, work, 0, (double)(INT64_MAX / 2)), /* half is left for the run */
    FIELD("how a guard was seen", FIELD_BYTE, watch, WATCH_BELOW, WATCH_RISING),
};

static double number_at(field_type type, const unsigned char *place) {
    double number;
    int32_t whole;
    int64_t long_whole;
    switch (type) {
    case FIELD_INT32:
        memcpy(&whole, place, sizeof whole);
        return whole;
    case FIELD_INT64:
        memcpy(&long_whole, place, sizeof long_whole);
        return (double)long_whole;
    case FIELD_BYTE:
        return *place;
    default:
        memcpy(&number, place, sizeof number);
        return number;
    }
}

static bool lies_between(double value, double least, double most) {
    return value >= least && value <= most;
}

/* The name of the first field that is out of its range. */
static const char *wrong_field(const unit_run *run) {
    for (size_t i = 0; i < sizeof fields / sizeof *fields; ++i) {
        const unsigned char *bytes = (const unsigned char *)run + fields[i].offset;
        for (size_t at = 0; at < fields[i].size; at += sizes[fields[i].type]) {
            if (!lies_between(number_at(fields[i].type, bytes + at), fields[i].least, fields[i].most)) {
                return fields[i].name;
            }
        }
    }
    return NULL;
}

/* The name of the first setting that is out of its range, or is not whole but of another type than Real. */
static const char *wrong_setting(const instance *fmu) {
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmu_variable *v = &fmu_variables[i];
        if (v->storage == STORED_SETTING || (v->storage == STORED_PARAMETER && v->type != VARIABLE_REAL)) {
            const double value = number_of(fmu, v);
            if (!lies_between(value, v->minimum, v->maximum) ||
                (v->type != VARIABLE_REAL && value != floor(value))) {
                return v->name;
            }
        }
    }
    return NULL;
}

/* ---- fields beside each other -------------------------------------------------------------------------- */

/* The name of the first field that contradicts others, in any state of the call sequence. */
static const char *wrong_state_of_run(const unit_run *run) {
    const unit_motion *motion = &run->motion;
    const tdmf_mode_kind *modes = unit_model->modes;
    const double digit = DBL_EPSILON * fabs(motion->time);
    const bool may_wait = run->interface == CO_SIMULATION_WITH_EVENT_MODE && run->has_begun;
    if (!lies_between(motion->time_rest, -digit, digit)) {
        return "the rest of the time";
    }
    if (motion->shown != motion->mode && (!modes[motion->mode].keeps_outputs || modes[motion->shown].ends)) {
        return "the mode that is shown";
    }
    if (run->event_is_pending && !may_wait) {
        return "the pending event";
    }
    if (!state_suits_interface((unsigned)run->state, (interface_kind)run->interface, run->has_begun)) {
        return "the state of the call sequence";
    }
    return run->has_begun ? number_out_of_range(run->accounted) : NULL;
}

/* The name of the first state in the world's coordinates that does not follow from those of the mode, as it
 * has to in Co-Simulation. */
static const char *wrong_coordinate(const instance *fmu) {
    instance shown = *fmu;
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
static const char *wrong_state(const instance *fmu) {
    const double *x = states_of(fmu);
    for (int i = 0; i < UNIT_BOUND_COUNT; ++i) {
        const unit_bound *row = &unit_bounds[i];
        const double value = x[row->state];
        if (!(is_exchange(fmu) && row->moves) &&
            !(lies_between(value, row->least, row->most) && (!row->is_whole || value == floor(value)))) {
            return unit_numbers[UNIT_PARAMETER_COUNT + row->state].name;
        }
    }
    for (int i = 0; i < UNIT_STATE_COUNT && !is_exchange(fmu); ++i) {
        if (unit_holds_time[i] && x[i] > fmu->run.motion.time) {
            return unit_numbers[UNIT_PARAMETER_COUNT + i].name;
        }
    }
    return NULL;
}

static bool clocks_agree(const instance *fmu) {
    const unit_run *run = &fmu->run;
    const double digit = 4.0 * DBL_EPSILON * fmax(fabs(run->time), fabs(run->epoch));
    return fabs(run->time - run->epoch - run->motion.time) <= digit &&
           (unit_clock < 0 || states_of(fmu)[unit_clock] == run->motion.time);
}

/* A pending event was due by the numbers with which the run stopped. */
static bool event_may_be_pending(const instance *fmu) {
    instance stopped = *fmu;
    const tdmf_guard_kind *kind;
    memcpy(stopped.run.motion.numbers, fmu->run.accounted, sizeof fmu->run.accounted);
    return guard_of_pending_event(&stopped, &kind) <= rounding_at_event;
}

static bool rates_are_finite(instance *fmu) {
    bool finite = true;
    evaluate(fmu, STORED_DERIVATIVE);
    for (int i = 0; i < UNIT_CONTINUOUS_COUNT; ++i) {
        finite &= fabs(fmu->view.derivatives[i]) < fmu_largest_state;
    }
    return finite;
}

/* The name of the first contradiction in a run that has begun. */
static const char *wrong_run(instance *fmu) {
    const char *wrong = clocks_agree(fmu) ? wrong_state(fmu) : "the time";
    if (wrong == NULL && !is_exchange(fmu)) {
        wrong = wrong_coordinate(fmu);
    }
    if (wrong == NULL && !is_exchange(fmu) && !rates_are_finite(fmu)) {
        wrong = "a state, which has no finite rate";
    }
    return wrong == NULL && fmu->run.event_is_pending && !event_may_be_pending(fmu) ? "the pending event"
                                                                                    : wrong;
}

/* ---- reading and writing ------------------------------------------------------------------------------- */

/* Checks the bytes of a state, and reads the run into `fmu`, a copy of the instance. */
static bool read_state(instance *fmu, const void *bytes) {
    saved_state saved, wanted;
    memcpy(&saved, bytes, sizeof saved);
    wanted = saved;
    write_header(&wanted);
    if (saved.byte_order != wanted.byte_order || saved.size != wanted.size) {
        return refuse(fmu, "it was saved by another program or on another kind of machine");
    }
    if (saved.zero != wanted.zero || memcmp(saved.guid, wanted.guid, sizeof wanted.guid) != 0) {
        return refuse(fmu, "it was saved by another version of the unit");
    }
    if (saved.checksum != wanted.checksum) {
        return refuse(fmu, "its bytes have been changed");
    }
    fmu->run = saved.run;
    const char *wrong = wrong_setting(fmu);
    wrong = wrong == NULL ? wrong_field(&fmu->run) : wrong;
    wrong = wrong == NULL ? number_out_of_range(fmu->run.motion.numbers) : wrong;
    wrong = wrong == NULL ? wrong_state_of_run(&fmu->run) : wrong;
    if (wrong == NULL && fmu->run.has_begun) {
        if (!requirements_are_met(fmu, true)) {
            return false;
        }
        if (is_exchange(fmu)) {
            take_from_world(fmu);
        }
        wrong = wrong_run(fmu);
    }
    return wrong == NULL || refuse(fmu, "%s is out of range or contradicts the rest", wrong);
}

/* Writes a state into the importer's old one, if it passes one, else into new memory. */
static call_status write_state(instance *fmu, const saved_state *saved, void **state) {
    *state = *state != NULL ? *state : malloc(sizeof *saved);
    if (*state == NULL) {
        fmu->run.state = FAILED;
        return answer(fmu, CALL_ERROR, "out of memory");
    }
    memcpy(*state, saved, sizeof *saved);
    return CALL_OK;
}

call_status save_state(instance *fmu, void **state) {
    saved_state saved = {.run = fmu->run};
    write_header(&saved);
    return ARE_GIVEN(fmu, 1, state) ? write_state(fmu, &saved, state) : CALL_ERROR;
}

call_status restore_state(instance *fmu, const void *state) {
    instance read = *fmu;
    if (state == NULL) {
        return answer(fmu, CALL_DISCARD, "the state is a null pointer");
    }
    if (!read_state(&read, state)) {
        return answer(fmu, CALL_DISCARD, "the state is refused: %s", read.reason);
    }
    if (read.run.interface != fmu->run.interface) {
        return answer(fmu, CALL_DISCARD, "the state is refused: it was saved in another interface");
    }
    fmu->run = read.run;
    fmu->current = 0;
    return CALL_OK;
}

call_status free_state(void **state) {
    if (state != NULL) {
        free(*state);
        *state = NULL;
    }
    return CALL_OK;
}

call_status measure_state(const instance *fmu, const void *state, size_t *size) {
    if (!ARE_GIVEN(fmu, 1, state, size)) {
        return CALL_ERROR;
    }
    *size = sizeof(saved_state);
    return CALL_OK;
}

call_status serialize_state(const instance *fmu, const void *state, void *bytes, size_t size) {
    if (!ARE_GIVEN(fmu, 1, state) || !array_is_given(fmu, bytes, size, sizeof(saved_state))) {
        return CALL_ERROR;
    }
    memcpy(bytes, state, sizeof(saved_state));
    return CALL_OK;
}

call_status deserialize_state(instance *fmu, const void *bytes, size_t size, void **state) {
    instance read = *fmu;
    saved_state saved;
    if (!ARE_GIVEN(fmu, 1, bytes, state)) {
        return CALL_ERROR;
    }
    if (size != sizeof saved) {
        return answer(fmu, CALL_DISCARD, "a state of this unit has %lu bytes, not %lu",
                      (unsigned long)sizeof saved, (unsigned long)size);
    }
    if (!read_state(&read, bytes)) {
        return answer(fmu, CALL_DISCARD, "the bytes are refused: %s", read.reason);
    }
    memcpy(&saved, bytes, sizeof saved);
    return write_state(fmu, &saved, state);
}
