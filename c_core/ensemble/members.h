/* What a runner takes along into a lane. Included with `real` as a number, to fill one lane, and with `real`
 * as a vector of lanes: the fields are the same, in the same order. */
#ifndef TDMF_ENSEMBLE_MEMBERS_H
#define TDMF_ENSEMBLE_MEMBERS_H

#include "flight_step.h"
#include "ground_step.h"
#include "step_limits.h"

#include <stddef.h>

typedef struct {
    real elapsed; /* since the runner came */
    step_count steps;
} member_progress;

/* What changes from step to step comes first, up to time_left. */
typedef struct {
    member_progress now;
    flight_coordinates at;
    real time_left;   /* when the runner came; its stride is given up then */
    height_above com; /* when the runner came */
    real rise_rate;   /* then, of the centre of mass */
    flight_constants constants;
    height_above com_over_new_ground; /* when the runner came */
} flying_member;

typedef struct {
    member_progress now;
    ground_coordinates at;
    real time_left;
    ground_constants constants;
    friction_layer layer; /* slip, where friction falls with speed */
} standing_member;

/* Fields of either kind of member, those that some modes do without being the last, and those that change. */
enum {
    FLYING_FIELDS = offsetof(flying_member, constants.servo) / sizeof(real),
    CLAMPED_FIELDS = offsetof(flying_member, constants.new_slope) / sizeof(real),
    RARE_FIELDS = sizeof(flying_member) / sizeof(real), /* with a pending ground line, or forced */
    STANDING_FIELDS = offsetof(standing_member, constants.law.rest_length_rate) / sizeof(real), /* no ramps */
    GRAZING_FIELDS = offsetof(standing_member, constants.border) / sizeof(real),
    /* where friction falls with speed, or the foot meets the border of a patch */
    RARE_STANDING_FIELDS = sizeof(standing_member) / sizeof(real),
    MEMBER_FIELDS = RARE_FIELDS > RARE_STANDING_FIELDS ? RARE_FIELDS : RARE_STANDING_FIELDS,
    FLYING_CHANGING = offsetof(flying_member, time_left) / sizeof(real),
    STANDING_CHANGING = offsetof(standing_member, time_left) / sizeof(real),
    CHANGING_FIELDS = FLYING_CHANGING > STANDING_CHANGING ? FLYING_CHANGING : STANDING_CHANGING
};

#endif
