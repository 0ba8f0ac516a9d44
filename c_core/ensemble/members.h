/* What a runner takes along into a lane. Included with `real` as a number, to fill one lane, and with `real`
 * as a vector of lanes: the fields are the same, in the same order. */

#include <stddef.h>

/* What changes from step to step. */
typedef struct {
    real elapsed;             /* since the runner came */
    real steps_left;          /* after which its stride is given up */
    real span, steps_in_span; /* counted against TDMF_STIFFNESS_LIMIT */
    real work, damper_loss, friction_loss;
} member_progress;

/* What does not. */
typedef struct {
    real time_left;     /* when the runner came; its stride is given up then */
    real margin_factor; /* of guards, see margins.h */
    real min_length, damping, gravity;
    real length_scale, time_scale, speed_scale, force_scale, energy_scale;
} member_frame;

typedef struct {
    member_progress now;
    real length, angle, length_rate, angle_rate;
    member_frame frame;
    flight_coefficients law;
    real inverse_mobility;
    real com_y, com_vy; /* when the runner came */
    real share;         /* of the body in the mass */
    real kp, kd;        /* retract: of the law that the clamp watches, with the sign that is positive now */
    real target;        /* its angle */
} flying_member;

typedef struct {
    member_progress now;
    real x, y, vx, vy, foot_x, foot_vx;
    real angle; /* graze: theta */
    member_frame frame;
    ground_coefficients law;
    real cone_normal, cone_tangential;
    real slip_sign;                  /* of u */
    real drives;                     /* above 0 until mid-stance */
    real kp, kd, target, stance_law; /* graze: the laws that the torque lies between */
    real rise_share;                 /* graze: of the body in the mass while retracting, else 0 */
} standing_member;

/* Fields of either kind of member, and those up to its frame, which are the ones that change. */
enum {
    FLYING_FIELDS = sizeof(flying_member) / sizeof(real),
    STANDING_FIELDS = sizeof(standing_member) / sizeof(real),
    MEMBER_FIELDS = FLYING_FIELDS > STANDING_FIELDS ? FLYING_FIELDS : STANDING_FIELDS,
    FLYING_CHANGING = offsetof(flying_member, frame) / sizeof(real),
    STANDING_CHANGING = offsetof(standing_member, frame) / sizeof(real),
    CHANGING_FIELDS = FLYING_CHANGING > STANDING_CHANGING ? FLYING_CHANGING : STANDING_CHANGING
};
