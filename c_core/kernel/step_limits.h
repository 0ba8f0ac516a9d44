/* The limits of steps, and of stiffness: see TDMF_STIFFNESS_LIMIT. */
#ifndef TDMF_KERNEL_STEP_LIMITS_H
#define TDMF_KERNEL_STEP_LIMITS_H

#include "tdmf_slip/solver.h"
#include "width.h"

typedef struct {
    real left;
    real span, in_span; /* time, and steps in it, since the last span of a time scale was over */
} step_count;

static inline step_count opened_steps(real limit) {
    const step_count steps = {limit, broadcast(0.0), broadcast(0.0)};
    return steps;
}

static inline mask span_is_over(const step_count *steps, real time_scale) {
    return steps->span >= time_scale;
}

static inline void count_step(step_count *steps, real time, real time_scale) {
    const mask next = span_is_over(steps, time_scale);
    steps->span = select(next, broadcast(0.0), steps->span) + time;
    steps->in_span = select(next, broadcast(0.0), steps->in_span) + 1.0;
    steps->left -= 1.0;
}

static inline mask no_steps_left(const step_count *steps) {
    return steps->left <= 0.0;
}

static inline mask takes_too_many_steps(const step_count *steps, real time_scale) {
    return (steps->in_span >= (double)TDMF_STIFFNESS_LIMIT) & mask_not(span_is_over(steps, time_scale));
}

/* The longest step that a law allows tells whether its runner is too stiff. */
static inline mask opens_too_stiff(real longest, real ahead) {
    return (double)TDMF_STIFFNESS_LIMIT * longest < ahead;
}

#endif
