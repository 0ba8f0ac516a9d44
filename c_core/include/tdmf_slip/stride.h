/* The quantities of a stride, and the apex at which it closes. */
#ifndef TDMF_SLIP_STRIDE_H
#define TDMF_SLIP_STRIDE_H

#ifdef __cplusplus
extern "C" {
#endif

/* Room for a gait word and its terminator. A word of more than 26 letters keeps the first 26 and ends in '~'.
 */
enum { TDMF_WORD_CAPACITY = 28 };

/* A completed stride, apex to apex; all zero and the word empty until one closes. */
typedef struct {
    int count;                     /* completed strides so far */
    double period;                 /* T, s */
    double length;                 /* travel of the centre of mass, m */
    double rise;                   /* height that it gained, m */
    double speed;                  /* length / period, m/s */
    double work;                   /* W, net work of hip and leg, J */
    double hip_work;               /* work of the total hip torque, J */
    double leg_work;               /* work of the leg by changes of its rest length, J */
    double positive_work;          /* the part of the hip's work done at positive power, J */
    double cost_of_transport;      /* W / ((m + m_f) g length)  (13); 0 where length is 0 */
    int touchdowns;                /* every impact counts */
    double stance_time;            /* time in stick and slip, s */
    double duty_factor;            /* stance_time / period */
    double slip_distance;          /* path the foot slid, m */
    double peak_force;             /* largest ground force across the ground, N */
    double peak_vertical_force;    /* largest vertical ground force, which differs on a slope, N */
    char word[TDMF_WORD_CAPACITY]; /* the gait word: a letter for each contact mode that lasted */
    int word_code; /* the word in base 4 ('|' 0, '-' 1, '0' 2, '+' 3, first letter most significant); -1 where
                      it has more than 15 letters */
} tdmf_stride;

/* The section of the return map: where an apex found the runner. */
typedef struct {
    double time;            /* s */
    double com_height;      /* m, above the ground vertically below */
    double com_speed;       /* m/s */
    double leg_length;      /* m */
    double leg_angle;       /* rad */
    double leg_length_rate; /* m/s */
    double leg_angle_rate;  /* rad/s */
} tdmf_apex;

#ifdef __cplusplus
}
#endif
#endif
