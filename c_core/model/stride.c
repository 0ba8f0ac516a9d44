/* Stride quantities: T, dx, V = dx/T, W and the cost of transport W/((m + m_f) g dx) (13), and the gait word,
 * one letter for every contact mode that lasts. */
#include "instant.h"
#include "record.h"

#include "ground_line.h"
#include "words.h"

#include "tdmf_slip/kinematics.h"

#include <limits.h>
#include <math.h>
#include <string.h>

static void append(char word[TDMF_WORD_CAPACITY], char letter) {
    const size_t length = strlen(word);
    if (length + 2 < TDMF_WORD_CAPACITY) {
        word[length] = letter;
        word[length + 1] = '\0';
    } else {
        word[TDMF_WORD_CAPACITY - 2] = '~';
        word[TDMF_WORD_CAPACITY - 1] = '\0';
    }
}

static char letter_of(const tdmf_mode *mode) {
    const double sign = tdmf_slip_sign(mode);
    return sign > 0.0 ? '+' : sign < 0.0 ? '-' : '0';
}

/* A stance that was interrupted by graze goes on with its last letter; one that follows a flight is new. */
static void write_letter(tdmf_open_stride *open, char letter) {
    const size_t length = strlen(open->word);
    if (length > 0 && open->flew_since_letter) {
        append(open->word, '|');
        append(open->word, letter);
    } else if (length == 0 || open->word[length - 1] != letter) {
        append(open->word, letter);
    }
    open->flew_since_letter = false;
}

/* Stops at the largest int. */
static void count(int *counter) {
    *counter += *counter < INT_MAX;
}

tdmf_instant tdmf_instant_of(const tdmf_motion *motion) {
    const tdmf_instant rounded = {motion->time, 0.0};
    return motion->record.progress.now.time == motion->time ? motion->record.progress.now : rounded;
}

static void open_stride(tdmf_open_stride *open, tdmf_instant now, tdmf_point com,
                        const double state[TDMF_STATE_COUNT]) {
    memset(open, 0, sizeof *open);
    open->start = now;
    open->start_com_x = com.x;
    open->start_com_y = com.y;
    open->start_hip_work = state[TDMF_HIP_WORK];
    open->start_leg_work = state[TDMF_LEG_WORK];
    open->start_positive_work = state[TDMF_HIP_POSITIVE_WORK];
    open->contact_start = now;
    open->contact_start_x = state[TDMF_FOOT_X];
}

void tdmf_record_start(tdmf_motion *motion) {
    tdmf_record *record = &motion->record;
    memset(record, 0, sizeof *record);
    record->last_event_time = motion->time;
    record->progress.now.time = motion->time;
    /* Not begun at an apex, so never counted: the centre of mass may as well start at 0. */
    const tdmf_point nowhere = {0.0, 0.0, 0.0, 0.0};
    open_stride(&record->progress.open, record->progress.now, nowhere, motion->state);
}

void tdmf_record_event(tdmf_motion *motion) {
    count(&motion->record.event_count);
    motion->record.last_event_time = motion->time;
}

void tdmf_record_impact(tdmf_record *record, double loss) {
    record->impact_loss += loss;
    count(&record->progress.open.touchdowns);
}

void tdmf_record_contact_change(tdmf_motion *motion, tdmf_contact_mode entered) {
    const tdmf_mode *left = &motion->mode;
    tdmf_open_stride *open = &motion->record.progress.open;
    const tdmf_instant now = tdmf_instant_of(motion);
    const double foot_x = motion->state[TDMF_FOOT_X];
    const double duration = tdmf_time_between(open->contact_start, now);
    if (tdmf_in_contact(left) && duration > 0.0) {
        write_letter(open, letter_of(left));
        open->stance_time += duration;
        open->slip_distance += fabs(foot_x - open->contact_start_x) / left->ground.cosine;
    }
    if (entered == TDMF_CONTACT_FLIGHT) {
        open->flew_since_letter = true;
    }
    open->contact_start = now;
    open->contact_start_x = foot_x;
}

void tdmf_record_force(tdmf_record *record, double normal, double vertical) {
    record->progress.open.peak_force = fmax(record->progress.open.peak_force, normal);
    record->progress.open.peak_vertical_force = fmax(record->progress.open.peak_vertical_force, vertical);
}

static double ratio_or_zero(double numerator, double denominator) {
    return denominator == 0.0 ? 0.0 : numerator / denominator;
}

static void close_stride(tdmf_stride *stride, const tdmf_open_stride *open, const tdmf_model *model,
                         tdmf_instant now, tdmf_point com, const double state[TDMF_STATE_COUNT]) {
    const double weight = model->total_mass * model->parameters.gravity;
    count(&stride->count);
    stride->period = tdmf_time_between(open->start, now);
    stride->length = com.x - open->start_com_x;
    stride->rise = com.y - open->start_com_y;
    stride->speed = ratio_or_zero(stride->length, stride->period);
    stride->hip_work = state[TDMF_HIP_WORK] - open->start_hip_work;
    stride->leg_work = state[TDMF_LEG_WORK] - open->start_leg_work;
    stride->work = stride->hip_work + stride->leg_work;
    stride->positive_work = state[TDMF_HIP_POSITIVE_WORK] - open->start_positive_work;
    stride->cost_of_transport = ratio_or_zero(stride->work, weight * stride->length);
    stride->touchdowns = open->touchdowns;
    stride->stance_time = open->stance_time;
    stride->duty_factor = ratio_or_zero(open->stance_time, stride->period);
    stride->slip_distance = open->slip_distance;
    stride->peak_force = open->peak_force;
    stride->peak_vertical_force = open->peak_vertical_force;
    memcpy(stride->word, open->word, sizeof stride->word);
    stride->word_code = tdmf_short_word_code(tdmf_code_of_word(stride->word));
}

void tdmf_record_apex(tdmf_motion *motion, const tdmf_model *model) {
    const double *state = motion->state;
    tdmf_record *record = &motion->record;
    const tdmf_point com = tdmf_center_of_mass(model, state);
    const tdmf_instant now = tdmf_instant_of(motion);
    if (record->progress.open.began_at_apex) {
        close_stride(&record->stride, &record->progress.open, model, now, com, state);
    }
    open_stride(&record->progress.open, now, com, state);
    record->progress.open.began_at_apex = true;
    record->apex.time = motion->time;
    record->apex.com_height = com.y - tdmf_ground_height_at(&motion->mode.ground, com.x);
    record->apex.com_speed = com.vx;
    record->apex.leg_length = state[TDMF_LEG_LENGTH];
    record->apex.leg_angle = state[TDMF_LEG_ANGLE];
    record->apex.leg_length_rate = state[TDMF_LEG_LENGTH_RATE];
    record->apex.leg_angle_rate = state[TDMF_LEG_ANGLE_RATE];
}
