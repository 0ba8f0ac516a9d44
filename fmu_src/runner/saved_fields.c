/* The fields of a saved run: one function for each struct. Model, solver's limits and views are left out, as
 * they follow from the rest. */
#include "saved_values.h"

#include "ranges.h"
#include "static_assert.h"
#include "tdmf_slip/kinematics.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* How far, in the runner's scales, a foot on the ground may be off it and the past may reach into the future:
 * rounding, and what an event that was taken anew is moved by. */
static const double margin = 1e-6;

/* ---- one value each ----------------------------------------------------------------------------------- */

static void pass_sum(transfer *bytes, const char *name, double *value) {
    pass_between(bytes, name, value, -largest_sum, largest_sum);
}

static void pass_finite(transfer *bytes, const char *name, double *value) {
    pass_between(bytes, name, value, -DBL_MAX, DBL_MAX);
}

/* A time with the rest that rounding leaves out, which is less than the last digit. */
static void pass_instant(transfer *bytes, const char *name, tdmf_instant *instant) {
    pass_time(bytes, name, &instant->time);
    const double digit = DBL_EPSILON * fabs(instant->time);
    pass_between(bytes, name, &instant->rest, -digit, digit);
}

static void pass_count(transfer *bytes, const char *name, int *value) {
    pass_integer(bytes, name, value, 0, INT_MAX);
}

static bool is_word(const char word[TDMF_WORD_CAPACITY]) {
    return memchr(word, '\0', TDMF_WORD_CAPACITY) != NULL && strspn(word, "|-0+~") == strlen(word);
}

static void pass_word(transfer *bytes, const char *name, char word[TDMF_WORD_CAPACITY]) {
    if (pass(bytes, word, TDMF_WORD_CAPACITY)) {
        require(bytes, is_word(word), name);
    }
}

/* ---- one struct each ---------------------------------------------------------------------------------- */

/* The fields that are passed below, in the structs' order. A field that is added to a struct and forgotten
 * here does not compile, unless it is so small that it fits between two others. */
typedef struct {
    double height, slope, sine, cosine;
} passed_ground_line;
typedef struct {
    int contact, phase, zone;
    double liftoff_angle;
    bool flags[6];
    double rest_length;
    passed_ground_line ground;
    bool fallen;
} passed_mode;
typedef struct {
    int count;
    double period_to_cost[9];
    int touchdowns;
    double stance_time_to_peaks[5];
    char word[TDMF_WORD_CAPACITY];
    int word_code;
} passed_stride;
typedef struct {
    double time_and_section[7];
} passed_apex;
typedef struct {
    bool flags[2];
    double instants[4], starts[3], works[3], so_far[4];
    int touchdowns;
    char word[TDMF_WORD_CAPACITY];
} passed_open_stride;
typedef struct {
    int event_count;
    double last_event_time, impact_loss;
    passed_stride stride;
    passed_apex apex;
    double now[2];
    passed_open_stride open;
} passed_record;
typedef struct {
    double time, state[TDMF_STATE_COUNT];
    passed_mode mode;
    passed_record record;
} passed_motion;
TDMF_STATIC_ASSERT(sizeof(tdmf_ground_line) == sizeof(passed_ground_line),
                   every_field_of_a_ground_line_is_saved);
TDMF_STATIC_ASSERT(sizeof(tdmf_mode) == sizeof(passed_mode), every_field_of_a_mode_is_saved);
TDMF_STATIC_ASSERT(sizeof(tdmf_stride) == sizeof(passed_stride), every_field_of_a_stride_is_saved);
TDMF_STATIC_ASSERT(sizeof(tdmf_apex) == sizeof(passed_apex), every_field_of_an_apex_is_saved);
TDMF_STATIC_ASSERT(sizeof(tdmf_open_stride) == sizeof(passed_open_stride),
                   every_field_of_an_open_stride_is_saved);
TDMF_STATIC_ASSERT(sizeof(tdmf_record) == sizeof(passed_record), every_field_of_a_record_is_saved);
TDMF_STATIC_ASSERT(sizeof(tdmf_motion) == sizeof(passed_motion), every_field_of_a_motion_is_saved);
TDMF_STATIC_ASSERT(sizeof(tdmf_leg_sample) == 3 * sizeof(double), every_field_of_a_leg_sample_is_saved);

static void pass_ground_line(transfer *bytes, tdmf_ground_line *ground) {
    pass_between(bytes, "the height of the ground", &ground->height, -fmu_largest_state, fmu_largest_state);
    pass_between(bytes, "the slope of the ground", &ground->slope, -1.0, 1.0);
    *ground = tdmf_ground_line_of(ground->height, ground->slope);
}

static void pass_mode(transfer *bytes, tdmf_mode *mode) {
    int contact = (int)mode->contact;
    int phase = (int)mode->phase;
    int zone = (int)mode->zone;
    pass_integer(bytes, "contact.mode", &contact, TDMF_CONTACT_FLIGHT, TDMF_CONTACT_GRAZE);
    pass_integer(bytes, "hip.phase", &phase, TDMF_PHASE_DRIVE, TDMF_PHASE_PLACE);
    pass_integer(bytes, "the zone of the ground", &zone, TDMF_ZONE_BEFORE, TDMF_ZONE_BEYOND);
    mode->contact = (tdmf_contact_mode)contact;
    mode->phase = (tdmf_hip_phase)phase;
    mode->zone = (tdmf_zone)zone;
    pass_between(bytes, "hip.liftoff_angle", &mode->liftoff_angle, -fmu_largest_state, fmu_largest_state);
    pass_flag(bytes, "whether mid-stance is to come", &mode->mid_stance_pending);
    pass_flag(bytes, "whether the clamp is closed", &mode->clamp_closed);
    pass_flag(bytes, "whether the ground force rises", &mode->ground_force_rising);
    pass_flag(bytes, "whether the vertical force rises", &mode->vertical_force_rising);
    pass_flag(bytes, "whether the leg thrusts", &mode->thrusts);
    pass_flag(bytes, "whether the centre of mass rises", &mode->rises);
    pass_between(bytes, "the rest length", &mode->rest_length, -fmu_largest_state, fmu_largest_state);
    pass_ground_line(bytes, &mode->ground);
    pass_flag(bytes, "status.fallen", &mode->fallen);
}

static void pass_stride(transfer *bytes, tdmf_stride *stride) {
    pass_count(bytes, "stride.count", &stride->count);
    pass_finite(bytes, "stride.period", &stride->period);
    pass_finite(bytes, "stride.length", &stride->length);
    pass_finite(bytes, "stride.rise", &stride->rise);
    pass_finite(bytes, "stride.speed", &stride->speed);
    pass_finite(bytes, "stride.work", &stride->work);
    pass_finite(bytes, "stride.hip_work", &stride->hip_work);
    pass_finite(bytes, "stride.leg_work", &stride->leg_work);
    pass_finite(bytes, "stride.positive_work", &stride->positive_work);
    pass_finite(bytes, "stride.cost_of_transport", &stride->cost_of_transport);
    pass_count(bytes, "stride.touchdowns", &stride->touchdowns);
    pass_finite(bytes, "stride.stance_time", &stride->stance_time);
    pass_finite(bytes, "stride.duty_factor", &stride->duty_factor);
    pass_finite(bytes, "stride.slip_distance", &stride->slip_distance);
    pass_finite(bytes, "stride.peak_force", &stride->peak_force);
    pass_finite(bytes, "stride.peak_vertical_force", &stride->peak_vertical_force);
    pass_word(bytes, "stride.word", stride->word);
    pass_integer(bytes, "stride.word_code", &stride->word_code, -1, INT_MAX);
}

static void pass_apex(transfer *bytes, tdmf_apex *apex) {
    pass_time(bytes, "apex.time", &apex->time);
    pass_finite(bytes, "apex.com_height", &apex->com_height);
    pass_finite(bytes, "apex.com_speed", &apex->com_speed);
    pass_finite(bytes, "apex.leg_length", &apex->leg_length);
    pass_finite(bytes, "apex.leg_angle", &apex->leg_angle);
    pass_finite(bytes, "apex.leg_length_rate", &apex->leg_length_rate);
    pass_finite(bytes, "apex.leg_angle_rate", &apex->leg_angle_rate);
}

static void pass_open_stride(transfer *bytes, tdmf_open_stride *open) {
    pass_flag(bytes, "whether the open stride began at an apex", &open->began_at_apex);
    pass_flag(bytes, "whether the foot flew since the last letter", &open->flew_since_letter);
    pass_instant(bytes, "the open stride's start time", &open->start);
    pass_sum(bytes, "the open stride's start", &open->start_com_x);
    pass_sum(bytes, "the height of its start", &open->start_com_y);
    pass_sum(bytes, "the open stride's work of the hip", &open->start_hip_work);
    pass_sum(bytes, "the open stride's work of the leg", &open->start_leg_work);
    pass_sum(bytes, "the open stride's positive work", &open->start_positive_work);
    pass_instant(bytes, "the contact's start time", &open->contact_start);
    pass_sum(bytes, "the contact's start", &open->contact_start_x);
    pass_sum(bytes, "the open stride's stance time", &open->stance_time);
    pass_sum(bytes, "the open stride's slip distance", &open->slip_distance);
    pass_sum(bytes, "the open stride's peak force", &open->peak_force);
    pass_sum(bytes, "the open stride's peak vertical force", &open->peak_vertical_force);
    pass_count(bytes, "the open stride's touchdowns", &open->touchdowns);
    pass_word(bytes, "the open stride's word", open->word);
}

static void pass_record(transfer *bytes, tdmf_record *record) {
    pass_count(bytes, "event.count", &record->event_count);
    pass_time(bytes, "event.last_time", &record->last_event_time);
    pass_sum(bytes, "energy.impact_loss", &record->impact_loss);
    pass_instant(bytes, "the instant", &record->progress.now);
    pass_stride(bytes, &record->stride);
    pass_apex(bytes, &record->apex);
    pass_open_stride(bytes, &record->progress.open);
}

static void pass_position(transfer *bytes, tdmf_motion *motion) {
    pass_time(bytes, "time", &motion->time);
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        const bool sums = tdmf_state_quantities[i] == TDMF_QUANTITY_ENERGY;
        const double largest = sums ? largest_sum : fmu_largest_state;
        pass_between(bytes, "a continuous state", &motion->state[i], -largest, largest);
    }
}

static void pass_accounted_leg(transfer *bytes, fmu *fmu) {
    pass_time(bytes, "the time of the leg's work", &fmu->accounted_leg.time);
    pass_between(bytes, "the leg of its work", &fmu->accounted_leg.length, -fmu_largest_state,
                 fmu_largest_state);
    pass_between(bytes, "the leg's rate of its work", &fmu->accounted_leg.length_rate, -fmu_largest_state,
                 fmu_largest_state);
    pass_sum(bytes, "the leg's work to come", &fmu->leg_work_due);
}

static void pass_history(transfer *bytes, tdmf_motion *motion) {
    pass_mode(bytes, &motion->mode);
    pass_record(bytes, &motion->record);
}

/* Parameters, settings and inputs, whose ranges the table of variables has. */
static void pass_variables(transfer *bytes, fmu *fmu, unsigned storages) {
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        const fmu_variable *variable = &fmu_variables[i];
        if ((storages & 1U << variable->storage) == 0) {
            continue;
        }
        double value = fmu_get_number(fmu, NULL, variable);
        if (pass(bytes, &value, sizeof value)) {
            char text[FMU_TEXT];
            const bool allowed = fmu_refuse_value(variable, value, text) == NULL &&
                                 (variable->type == VARIABLE_REAL || value == floor(value));
            require(bytes, allowed, variable->name);
            fmu_set_number(fmu, variable, allowed ? value : variable->start);
        }
    }
}

/* The rate of an input that changes at events only is 0. */
static void pass_rate(transfer *bytes, fmu *fmu, const fmu_variable *input) {
    const double largest = input->variability == VARIABILITY_CONTINUOUS ? DBL_MAX : 0.0;
    double rate = fmu_get_number_rate(fmu, input);
    pass_between(bytes, "the rate of an input", &rate, -largest, largest);
    fmu_set_number_rate(fmu, input, rate);
}

static void pass_surroundings(transfer *bytes, fmu *fmu) {
    pass_variables(bytes, fmu, 1U << STORED_PARAMETER | 1U << STORED_SETTING | 1U << STORED_INPUT);
    for (size_t i = 0; i < fmu_variable_count; ++i) {
        if (fmu_variables[i].storage == STORED_INPUT) {
            pass_rate(bytes, fmu, &fmu_variables[i]);
        }
    }
    pass_experiment(bytes, fmu);
    pass_work(bytes, "the steps done", &fmu->solver.steps);
    pass_work(bytes, "the events found", &fmu->solver.events);
    pass_work(bytes, "the evaluations done", &fmu->solver.evaluations);
    pass_work(bytes, "the steps in the layer", &fmu->solver.layer_steps);
}

/* Parameters and inputs are read and checked as those of a unit. The guard that fired may be unknown. */
static void pass_pending_event(transfer *bytes, fmu *fmu) {
    struct fmu at_event = *fmu;
    at_event.parameters = fmu->event_parameters;
    at_event.inputs = fmu->event_inputs;
    pass_between(bytes, "how far before its event the run stands", &fmu->event_lead, 0.0, DBL_MAX);
    pass_integer(bytes, "the guard of its event", &fmu->event_guard, -1, TDMF_GUARD_COUNT - 1);
    pass_variables(bytes, &at_event, 1U << STORED_PARAMETER | 1U << STORED_INPUT);
    pass_position(bytes, &fmu->after_event);
    pass_history(bytes, &fmu->after_event);
    fmu->event_parameters = at_event.parameters;
    fmu->event_inputs = at_event.inputs;
}

/* Passes a run, which has a history only after its start, and seldom a pending event. */
static void pass_run(transfer *bytes, saved_run *run) {
    bool begun = fmu_has_begun(&run->fmu);
    pass_calls(bytes, run);
    pass_flag(bytes, "whether the run has begun", &begun);
    pass_flag(bytes, "the pending event", &run->fmu.event_is_pending);
    pass_surroundings(bytes, &run->fmu);
    pass_position(bytes, &run->fmu.motion);
    if (begun) {
        pass_history(bytes, &run->fmu.motion);
        pass_accounted_leg(bytes, &run->fmu);
    }
    if (run->fmu.event_is_pending) {
        pass_pending_event(bytes, &run->fmu);
    }
}

/* ---- what has to agree -------------------------------------------------------------------------------- */

static bool event_may_be_pending(const saved_run *run) {
    return run->interface == CO_SIMULATION_WITH_EVENT_MODE && fmu_has_begun(&run->fmu);
}

static bool phase_suits_contact(const tdmf_mode *mode) {
    const bool of_contact = mode->phase == TDMF_PHASE_DRIVE || mode->phase == TDMF_PHASE_COAST;
    return of_contact == tdmf_in_contact(mode) &&
           (!of_contact || mode->mid_stance_pending == (mode->phase == TDMF_PHASE_DRIVE));
}

static bool clamp_suits_phase(const tdmf_model *model, const tdmf_mode *mode) {
    return !mode->clamp_closed || (model->parameters.hip.swing_clamp && mode->phase == TDMF_PHASE_RETRACT);
}

/* Base 4, first letter most significant; see tdmf_stride. */
static bool code_suits_word(const tdmf_stride *stride) {
    int code = stride->word_code;
    size_t left = strlen(stride->word);
    if (code < 0 || strchr(stride->word, '~') != NULL) {
        return code < 0 && left > 15;
    }
    while (left > 0 && stride->word[left - 1] == "|-0+"[code % 4]) {
        --left;
        code /= 4;
    }
    return left == 0 && code == 0;
}

/* The ground's axes are turned against those of the state, whose rounding is left in them. */
static bool foot_suits_contact(const tdmf_model *model, const tdmf_motion *motion) {
    const tdmf_point foot = tdmf_foot_over_ground(&motion->mode.ground, motion->state);
    const double rounding = 4.0 * DBL_EPSILON;
    const double length = margin * model->scales.length +
                          rounding * (fabs(motion->mode.ground.height) + fabs(motion->state[TDMF_FOOT_X]));
    const double speed = margin * model->scales.speed + rounding * fabs(motion->state[TDMF_FOOT_VX]);
    return motion->mode.contact == TDMF_CONTACT_FLIGHT ||
           (fabs(foot.y) <= length && fabs(foot.vy) <= speed &&
            (motion->mode.contact != TDMF_CONTACT_STICK || fabs(foot.vx) <= speed));
}

/* Of a foot that slips: in front of a border or past it by no more than rounding. */
static bool zone_suits_foot(const tdmf_model *model, const tdmf_motion *motion, double allowance) {
    const double begin = model->parameters.ground.patch_begin, end = model->parameters.ground.patch_end;
    const double x = motion->state[TDMF_FOOT_X];
    const tdmf_zone zone = motion->mode.zone;
    if (tdmf_slip_sign(&motion->mode) == 0.0 || begin == end) {
        return zone == TDMF_ZONE_BEFORE;
    }
    return (zone == TDMF_ZONE_BEFORE || x >= (zone == TDMF_ZONE_PATCH ? begin : end) - allowance) &&
           (zone == TDMF_ZONE_BEYOND || x <= (zone == TDMF_ZONE_PATCH ? end : begin) + allowance);
}

static bool clock_suits_phase(const tdmf_motion *motion) {
    const double place_time = motion->state[TDMF_HIP_PLACE_TIME];
    return motion->mode.phase == TDMF_PHASE_PLACE ? place_time >= 0.0 : place_time == 0.0;
}

static bool is_past(const tdmf_model *model, double time, double now) {
    return time <= now + margin * fmax(fabs(now), model->scales.time);
}

static void require_agreement(transfer *bytes, const saved_run *run, const tdmf_motion *motion) {
    const tdmf_model *model = &run->fmu.model;
    const tdmf_record *record = &motion->record;
    require(bytes, phase_suits_contact(&motion->mode), "hip.phase");
    require(bytes, clamp_suits_phase(model, &motion->mode), "whether the clamp is closed");
    require(bytes,
            zone_suits_foot(model, motion,
                            run->interface == MODEL_EXCHANGE ? INFINITY : margin * model->scales.length),
            "the zone of the ground");
    require(bytes, code_suits_word(&record->stride), "stride.word_code");
    if (run->interface != MODEL_EXCHANGE) { /* there, time and states are the importer's */
        require(bytes, foot_suits_contact(model, motion), "foot.y");
        require(bytes, clock_suits_phase(motion), "hip.place_time");
        require(bytes, is_past(model, record->last_event_time, motion->time), "event.last_time");
        require(bytes, is_past(model, record->progress.open.start.time, motion->time),
                "the open stride's start time");
        require(bytes, is_past(model, record->progress.open.contact_start.time, motion->time),
                "the contact's start time");
    }
}

static void require_agreement_of_fmu(transfer *bytes, const saved_run *run) {
    const fmu *fmu = &run->fmu;
    require(bytes, fmu_has_solver(fmu), "solver.method");
    require_agreement(bytes, run, &fmu->motion);
    if (fmu->event_is_pending) {
        require(bytes, fmu->after_event.time == fmu->motion.time, "the pending event");
        require_agreement(bytes, run, &fmu->after_event);
    }
}

/* ---- a run -------------------------------------------------------------------------------------------- */

size_t saved_run_size(void) {
    saved_run run = {.interface = CO_SIMULATION_WITH_EVENT_MODE, .state = EVENT_MODE};
    transfer bytes = {0};
    run.fmu.motion.mode.contact = TDMF_CONTACT_FLIGHT;
    run.fmu.event_is_pending = true;
    pass_run(&bytes, &run);
    return bytes.offset;
}

void write_saved_run(saved_run *run, unsigned char *bytes) {
    transfer target = {.target = bytes};
    memset(bytes, 0, saved_run_size());
    pass_run(&target, run);
}

const char *read_saved_run(const unsigned char *bytes, saved_run *run, char *reason, size_t capacity) {
    transfer source = {.source = bytes};
    fmu_reset(&run->fmu);
    pass_run(&source, run);
    require_calls(&source, run);
    require(&source, !run->fmu.event_is_pending || event_may_be_pending(run), "the pending event");
    if (source.refused == NULL && fmu_has_begun(&run->fmu)) {
        char text[FMU_TEXT];
        if (fmu_prepare(&run->fmu, text) != NULL) {
            snprintf(reason, capacity, "%s", text);
            return reason;
        }
        require_agreement_of_fmu(&source, run);
    }
    return reason_of(&source, reason, capacity);
}
