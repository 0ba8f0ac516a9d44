/* What is given: the runner's parameters, the two inputs, and the model made of them. */
#ifndef TDMF_SLIP_PARAMETERS_H
#define TDMF_SLIP_PARAMETERS_H

#include "tdmf_slip/export.h"

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* SI units, angles in rad. A member's path is the variable's name in the FMU: `leg.stiffness`. Ranges and
 * defaults (Table 1 of the paper with m = k = l0 = 1) come from modelDescription.xml. */
typedef struct {
    struct {
        double mass; /* m, kg */
    } body;
    struct {
        double mass; /* m_f, kg */
    } foot;
    struct {
        double stiffness;   /* k, N/m */
        double damping;     /* c, N.s/m */
        double free_length; /* l0, m */
        double min_length;  /* m; a shorter leg ends the run as a fall */
        double thrust;      /* epsilon, m, that the leg gains from its greatest compression on */
    } leg;
    double gravity; /* g, m/s2 */
    struct {
        double static_friction_ratio; /* rho, of the friction of a foot at rest to that of one that slips */
    } ground;
    struct {
        double stance_torque;        /* tau0, N.m; its negative drives the first half of a stance */
        double touchdown_angle;      /* theta0, rad */
        double kp;                   /* N.m/rad */
        double kd;                   /* N.m.s/rad */
        double liftoff_angle_factor; /* eta */
        double retraction_rate;      /* omega, rad/s, at which the touchdown angle is left in place */
    } hip;
} tdmf_parameters;

/* What may change during a run. Rates of inputs, per second, have the same shape; zero where they are held.
 * ground.height, ground.slope and control change at events only: their rates are always zero. */
typedef struct {
    struct {
        double friction; /* mu, of stick and slip alike */
        double height;   /* h, m: the ground is the line y = h + x tan(slope) */
        double slope;    /* sigma, rad */
    } ground;
    struct {
        double external_torque; /* N.m, added to the hip law */
    } hip;
    struct {
        double extension; /* m, added to the leg's rest length */
    } leg;
    struct {
        double external_fx, external_fy; /* N */
    } body;
    struct {                    /* added to the settings of these names */
        double touchdown_angle; /* rad */
        double stance_torque;   /* N.m */
        double thrust;          /* m; the sum is never below 0 */
    } control;
} tdmf_inputs;

/* The units of a scaled runner; every tolerance of the model is a pure number times one of these. */
typedef struct {
    double length; /* l0 */
    double time;   /* sqrt(m/k) */
    double speed;  /* l0 sqrt(k/m) */
    double force;  /* k l0 */
    double energy; /* k l0^2, also of torque */
} tdmf_scales;

/* Accepted parameters with what is derived from them once. Treat as read-only; made by tdmf_model_create. */
typedef struct {
    tdmf_parameters parameters; /* as they were accepted */
    tdmf_scales scales;         /* of its lengths, times, speeds, forces and energies */
    double inverse_body_mass;   /* 1/m */
    double inverse_foot_mass;   /* 1/m_f */
    double mobility;            /* 1/m + 1/m_f */
    double total_mass;          /* m + m_f */
    double body_share;          /* m/(m + m_f) */
} tdmf_model;

/* Why a value was refused. `variable` is NULL when nothing was. The strings are static. */
typedef struct {
    const char *variable; /* name as in the FMU, "leg.length" */
    const char *unit;     /* of value and limits; NULL where a pointer of that name is NULL */
    double value;         /* what was given */
    double minimum;       /* allowed from */
    double maximum;       /* allowed to */
    const char *bound_by; /* the variable or rule that sets the violated limit, or NULL */
} tdmf_refusal;

/* The defaults: Table 1 and friction 0.6, which make a periodic gait from tdmf_default_state. */
TDMF_API tdmf_parameters tdmf_default_parameters(void);
TDMF_API tdmf_inputs tdmf_default_inputs(void);

/* Checks every parameter (NaN and infinity included) and derives the constants. On refusal `model` is left
 * as it was and the first offending parameter is returned. */
TDMF_API tdmf_refusal tdmf_model_create(tdmf_model *model, const tdmf_parameters *parameters);

/* Checks friction and external torque against their ranges. */
TDMF_API tdmf_refusal tdmf_check_inputs(const tdmf_inputs *inputs);

/* Inputs some time after those given; friction stops at 0. `rates` may be NULL: the inputs are held. */
TDMF_API tdmf_inputs tdmf_inputs_after(const tdmf_inputs *inputs, const tdmf_inputs *rates, double elapsed);

/* Writes "leg.length = 0.01 m is refused: allowed from 0.05 (leg.min_length) to 1e+09 m" into `text`, with a
 * decimal point whatever the locale. Always terminated; returns `text`, which may be NULL: then nothing is
 * written. */
TDMF_API char *tdmf_refusal_text(const tdmf_refusal *refusal, char *text, size_t capacity);

#ifdef __cplusplus
}
#endif
#endif
