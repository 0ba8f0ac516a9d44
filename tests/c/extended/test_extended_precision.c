/* The exact derivatives of the return map against differences in extended precision: the core compiled once
 * more, with `double` meaning long double. A central difference over a step h errs by h^2 of a third
 * derivative, and by the map's own error over h: that of its events, which are located to a part of their
 * margin. */
#include "tdmf_slip/orbit.h"

enum { GAITS = 5, PARAMETERS = sizeof(tdmf_parameters) / sizeof(double) };

static const double step = 1e-6L;
static const double allowed = 2e-10L;

static const double frictions[GAITS] = {10.0L, 1.2L, 0.6L, 0.43L, 0.2L};

/* Of the reference gaits; see reference_gaits.c. */
static const double apices[GAITS][TDMF_SECTION_COUNT] = {
    {1.335681084574639L, 0.95460064906904L, 1.003468056490547L, 0.9264410563264225L, -4.473205042769141e-06L,
     0.1949581135034323L},
    {1.368813195564043L, 1.015067679911492L, 1.003911694284511L, 1.088966741995681L, -2.210891594266132e-06L,
     0.2070426488477578L},
    {1.406106854441984L, 1.062891224817656L, 1.004282245348082L, 1.242779537928858L, 9.84952562003722e-07L,
     0.2165916273954818L},
    {1.441887324102063L, 1.034090452026958L, 1.004638100817883L, 1.390973195188192L, 1.786781830291911e-06L,
     0.2253582638618812L},
    {1.583107783307573L, 0.8348521986773341L, 1.005710963304427L, 1.904748062999908L, -5.374819445992559e-07L,
     0.2499278780100866L}};

/* What a stride starts from. */
typedef struct {
    tdmf_parameters parameters;
    tdmf_inputs inputs;
    double apex[TDMF_SECTION_COUNT];
} scene;

static tdmf_return stride_of(const scene *scene, const tdmf_change *change) {
    tdmf_model model;
    tdmf_solver solver = tdmf_solver_default();
    solver.relative_tolerance = 1e-18L;
    if (tdmf_model_create(&model, &scene->parameters).variable) {
        printf("the parameters are refused\n");
        exit(1);
    }
    return tdmf_return_map(&solver, &model, &scene->inputs, scene->apex, 1e4L, true, change, change ? 1 : 0);
}

/* The largest difference between a derivative and a difference, of all that is differentiated. */
static double farthest(const scene *more, const scene *less, const tdmf_stride_change *exact) {
    const tdmf_return a = stride_of(more, NULL), b = stride_of(less, NULL);
    double off = fmax(fabs((a.stride.period - b.stride.period) / (2.0L * step) - exact->period),
                      fmax(fabs((a.stride.length - b.stride.length) / (2.0L * step) - exact->length),
                           fabs((a.stride.work - b.stride.work) / (2.0L * step) - exact->work)));
    for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
        off = fmax(off, fabs((a.apex[i] - b.apex[i]) / (2.0L * step) - exact->apex[i]));
    }
    return a.outcome.closed && b.outcome.closed ? off : INFINITY;
}

static double check_section(const scene *scene_at) {
    const tdmf_return stride = stride_of(scene_at, NULL);
    double worst = 0.0L;
    for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
        scene more = *scene_at, less = *scene_at;
        more.apex[k] += step;
        less.apex[k] -= step;
        worst = fmax(worst, farthest(&more, &less, &stride.by_section[k]));
    }
    return worst;
}

/* Member k of parameters, or the friction after the last. */
static double *member(tdmf_parameters *parameters, tdmf_inputs *inputs, int k) {
    return k == PARAMETERS ? &inputs->ground.friction : (double *)parameters + k;
}

/* By the parameters and the friction, each in units of its own size. */
static double check_parameters(const scene *scene_at) {
    double worst = 0.0L;
    for (int k = 0; k <= PARAMETERS; ++k) {
        tdmf_change change;
        memset(&change, 0, sizeof change);
        scene more = *scene_at, less = *scene_at;
        const double unit = *member(&more.parameters, &more.inputs, k);
        *member(&change.parameters, &change.inputs, k) = unit;
        *member(&more.parameters, &more.inputs, k) += step * unit;
        *member(&less.parameters, &less.inputs, k) -= step * unit;
        const tdmf_return stride = stride_of(scene_at, &change);
        worst = fmax(worst, farthest(&more, &less, &stride.by_parameter[0]));
    }
    return worst;
}

int main(void) {
    int failures = 0;
    for (int i = 0; i < GAITS; ++i) {
        scene scene = {tdmf_default_parameters(), tdmf_default_inputs(), {0.0L}};
        scene.inputs.ground.friction = frictions[i];
        memcpy(scene.apex, apices[i], sizeof scene.apex);
        const double section = check_section(&scene), parameters = check_parameters(&scene);
        printf("friction %5.2Lf: by the section within %.1Le, by parameters within %.1Le\n", frictions[i],
               section, parameters);
        failures += !(section <= allowed) + !(parameters <= allowed);
    }
    return failures > 0;
}
