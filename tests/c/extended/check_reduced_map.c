/* A central difference over a step h errs by h^2 of a third derivative, and by what events are located to
 * over h. */
#include "check_reduced_map.h"

#include "tdmf_slip/reduced_map.h"

enum {
    GAITS = 6,
    PARAMETERS = TDMF_PARAMETER_COUNT,
    INPUTS = sizeof(tdmf_inputs) / sizeof(double),
    COORDINATES = TDMF_REDUCED_COUNT + PARAMETERS + INPUTS,
    QUANTITIES = TDMF_REDUCED_COUNT + 3
};

static const double step = 1e-6L;
static const double allowed = 5e-10L;

/* Each row has a friction, and an apex near that of its gait. */
static const double near_gaits[GAITS][1 + TDMF_REDUCED_COUNT] = {
    {10.0L, 1.34L, 0.955L}, {1.2L, 1.37L, 1.015L}, {0.6L, 1.41L, 1.06L},
    {0.43L, 1.45L, 1.03L},  {0.2L, 1.58L, 0.835L}, {0.05L, 1.72L, 0.668L}};

typedef struct {
    tdmf_parameters parameters;
    tdmf_inputs inputs;
    double apex[TDMF_REDUCED_COUNT];
} scene;

/* Parameters that are at a bound, or zero, in Table 1 are moved off it. */
static scene near_gait(int number) {
    scene scene = {tdmf_default_parameters(), tdmf_default_inputs(), {0.0L}};
    scene.parameters.ground.static_friction_ratio = 1.01L;
    scene.parameters.ground.stribeck_velocity = 0.3L;
    scene.parameters.hip.retraction_rate = 1e-3L;
    scene.inputs.ground.friction = near_gaits[number][0];
    scene.parameters.leg.thrust = 0.01L;
    scene.inputs.hip.external_torque = -0.003L;
    scene.inputs.body.external_fx = 3e-4L;
    scene.inputs.body.external_fy = -2e-4L;
    scene.inputs.ground.height = 0.3L;
    scene.inputs.ground.slope = 0.02L;
    scene.inputs.leg.extension = 0.02L;
    scene.inputs.control.touchdown_angle = 0.01L;
    scene.inputs.control.stance_torque = 0.01L;
    scene.inputs.control.thrust = 0.005L;
    memcpy(scene.apex, &near_gaits[number][1], sizeof scene.apex);
    return scene;
}

static double *coordinate(scene *scene, int k) {
    if (k < TDMF_REDUCED_COUNT) {
        return &scene->apex[k];
    }
    k -= TDMF_REDUCED_COUNT;
    return k < PARAMETERS ? (double *)&scene->parameters + k : (double *)&scene->inputs + (k - PARAMETERS);
}

static tdmf_return stride_of(const scene *scene, const tdmf_seed *seed) {
    tdmf_model model;
    tdmf_solver solver = tdmf_solver_default();
    solver.relative_tolerance = 1e-18L;
    tdmf_model_create(&model, &scene->parameters);
    return tdmf_reduced_map(&solver, (tdmf_system){&model, &scene->inputs}, scene->apex, 1e4L, seed != NULL,
                            seed, seed != NULL);
}

/* How far the derivatives by a coordinate are off, each in units of its own size. */
static double error_by(const scene *at, int k) {
    scene more = *at, less = *at, unit;
    const double size = *coordinate(&more, k), h = step * size;
    *coordinate(&more, k) += h;
    *coordinate(&less, k) -= h;
    memset(&unit, 0, sizeof unit);
    *coordinate(&unit, k) = 1.0L;
    const tdmf_seed seed = {unit.parameters, unit.inputs};
    const tdmf_return here = stride_of(at, &seed), a = stride_of(&more, NULL), b = stride_of(&less, NULL);
    const tdmf_stride_variation *exact =
        k < TDMF_REDUCED_COUNT ? &here.variations[k] : &here.variations[TDMF_REDUCED_COUNT];
    const double off[QUANTITIES] = {a.apex[0] - b.apex[0] - 2.0L * h * exact->apex[0],
                                    a.apex[1] - b.apex[1] - 2.0L * h * exact->apex[1],
                                    a.stride.period - b.stride.period - 2.0L * h * exact->period,
                                    a.stride.length - b.stride.length - 2.0L * h * exact->length,
                                    a.stride.work - b.stride.work - 2.0L * h * exact->work};
    double worst = 0.0L;
    for (int i = 0; i < QUANTITIES; ++i) {
        const double error = fabs(off[i]) / (2.0L * step);
        worst = error > worst || isnan(error) ? error : worst;
    }
    return here.outcome + a.outcome + b.outcome == TDMF_RETURN_CLOSED ? worst : INFINITY;
}

int check_reduced_map(void) {
    int failures = 0;
    for (int i = 0; i < GAITS; ++i) {
        const scene at = near_gait(i);
        double worst = 0.0L;
        for (int k = 0; k < COORDINATES; ++k) {
            const double error = error_by(&at, k);
            worst = error > worst || isnan(error) ? error : worst;
        }
        printf("reduced map at friction %5.2Lf: within %.1Le\n", near_gaits[i][0], worst);
        failures += !(worst <= allowed);
    }
    return failures;
}
