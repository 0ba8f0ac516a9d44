/* Coordinates that a solver integrates in one contact mode: only what moves there.
 *
 * In flight the centre of mass is exactly ballistic, so only the leg is integrated, and gravity drops out of
 * its equations with every sine and cosine. On the ground the foot's height is fixed. */
#ifndef TDMF_SOLVER_CHART_H
#define TDMF_SOLVER_CHART_H

#include "tdmf_slip/parameters.h"
#include "tdmf_slip/solver.h"
#include "tdmf_slip/state.h"

enum {
    CHART_LEG_LENGTH,
    CHART_LEG_ANGLE,
    CHART_LEG_LENGTH_RATE,
    CHART_LEG_ANGLE_RATE,
    CHART_HIP_WORK,
    CHART_DAMPER_LOSS,
    CHART_FLIGHT_COUNT, /* the coordinates of flight end here */
    CHART_FOOT_X = CHART_FLIGHT_COUNT,
    CHART_FOOT_VX,
    CHART_FRICTION_LOSS,
    CHART_UNUSED, /* an even number of coordinates fills vector registers */
    CHART_COUNT
};

/* The equations of one contact mode from one instant on, with all that is constant in them at hand. */
typedef struct {
    const tdmf_model *model;
    bool in_flight;
    bool grazes;
    double angle_target, angle_gain,
        rate_gain;              /* flight: torque = angle_gain (target - theta) - rate_gain thetadot */
    double torque, torque_rate; /* the rest of the torque, linear in time */
    double signed_friction, signed_friction_rate;
    double foot_is_free; /* 0 where it sticks */
    double foot_weight;
    double leg_floor; /* see leg.h */
    double com_x, com_y, com_vx, com_vy;
    double positive_work;
} tdmf_chart;

/* The chart of a mode at an instant, and that instant's coordinates. */
void tdmf_chart_open(tdmf_chart *chart, const tdmf_model *model, const tdmf_inputs *inputs,
                     const tdmf_input_rates *rates, const tdmf_mode *mode,
                     const double state[TDMF_STATE_COUNT], double z[CHART_COUNT]);

/* Moves the chart's instant on by `elapsed`. */
void tdmf_chart_shift(tdmf_chart *chart, double elapsed);

/* Number of coordinates that move. */
static inline int tdmf_chart_count(const tdmf_chart *chart) {
    return chart->in_flight ? CHART_FLIGHT_COUNT : CHART_COUNT;
}

/* Writes coordinates back; the positive work is the chart's. */
void tdmf_chart_state(const tdmf_chart *chart, double elapsed, const double z[CHART_COUNT],
                      double state[TDMF_STATE_COUNT]);

#endif
