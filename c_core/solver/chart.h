/* What moves in one contact mode, and all that is constant in its equations. */
#ifndef TDMF_SOLVER_CHART_H
#define TDMF_SOLVER_CHART_H

#include "tdmf_slip/parameters.h"
#include "tdmf_slip/state.h"

/* Coordinates of a runner at an instant, as its mode needs them. */
typedef struct {
    /* Flight: the leg. The centre of mass follows from time alone. */
    double length, angle, length_rate, angle_rate;
    /* On the ground: the body as seen from the foot, its velocity, and the foot. */
    double x, y, vx, vy, foot_x, foot_vx;
    double work, damper_loss, friction_loss;
} tdmf_coordinates;

/* The equations of one mode from one instant on. */
typedef struct {
    const tdmf_model *model;
    tdmf_contact_mode contact;
    tdmf_coordinates start;
    double target, gain, rate_gain; /* flight: torque = gain (target - theta) - rate_gain thetadot + ... */
    double torque, torque_rate;     /* the rest of the torque, linear in time */
    double friction, friction_rate; /* in slip, with the sign of the foot's velocity */
    double com_x, com_y, com_vx, com_vy; /* flight, at the start */
    double turn; /* on the ground: theta less the angle that the place of the body gives */
    double positive_work;
} tdmf_chart;

/* The chart of a mode at an instant. */
void tdmf_chart_open(tdmf_chart *chart, const tdmf_model *model, const tdmf_inputs *inputs,
                     const tdmf_inputs *rates, const tdmf_mode *mode, const double state[TDMF_STATE_COUNT]);

/* Goes on from the coordinates reached after `elapsed`. */
void tdmf_chart_shift(tdmf_chart *chart, double elapsed, const tdmf_coordinates *reached);

/* The state that coordinates after `elapsed` stand for; the positive work is the chart's. */
void tdmf_chart_state(const tdmf_chart *chart, double elapsed, const tdmf_coordinates *coordinates,
                      double state[TDMF_STATE_COUNT]);

#endif
