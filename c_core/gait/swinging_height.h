/* A height that is a parabola in time less a swing: that of a foot which turns about a ballistic mass. */
#ifndef TDMF_GAIT_SWINGING_HEIGHT_H
#define TDMF_GAIT_SWINGING_HEIGHT_H

/* start + rate t + curvature t^2/2 - swing cos(angle - turning t) */
typedef struct {
    double start, rate, curvature, swing, angle, turning;
} tdmf_swinging_height;

/* The first zero at or after t = 0 of one whose parabola falls in the end; not a number where it is not found
 * because the foot turns too often. */
double tdmf_first_zero(const tdmf_swinging_height *height);

#endif
