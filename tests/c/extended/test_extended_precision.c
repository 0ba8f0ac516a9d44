/* The exact derivatives of the return map against differences in extended precision: the core compiled once
 * more, with `double` meaning long double. A central difference over a step h errs by h^2 of a third
 * derivative, and by the map's own error over h: that of its events, which are located to a part of their
 * margin. */
#include "random.h"
#include "reference_gaits.h"
#include "reference_gaits_table.h"
#include "stride_results.h"
#include "tdmf_slip/orbit.h"

enum { PARAMETERS = TDMF_PARAMETER_COUNT };

static const double step = 1e-6L;
static const double allowed = 2e-10L;

/* What a stride starts from. */
typedef struct {
    tdmf_parameters parameters;
    tdmf_inputs inputs;
    double apex[TDMF_SECTION_COUNT];
} scene;

static tdmf_return stride_within(double tolerance, const scene *scene, bool derivatives,
                                 const tdmf_seed *seeds, int count) {
    tdmf_model model;
    tdmf_solver solver = tdmf_solver_default();
    solver.relative_tolerance = tolerance;
    if (tdmf_model_create(&model, &scene->parameters).variable) {
        printf("the parameters are refused\n");
        exit(1);
    }
    return tdmf_return_map(&solver, (tdmf_system){&model, &scene->inputs}, scene->apex, 1e4L, derivatives,
                           seeds, count);
}

static tdmf_return stride_of(const scene *scene) {
    return stride_within(1e-18L, scene, false, NULL, 0);
}

/* The largest difference between a derivative and a difference, of all that is differentiated. */
static double farthest(const scene *more, const scene *less, const tdmf_stride_variation *exact) {
    const tdmf_return a = stride_of(more), b = stride_of(less);
    double off = fmax(fabs((a.stride.period - b.stride.period) / (2.0L * step) - exact->period),
                      fmax(fabs((a.stride.length - b.stride.length) / (2.0L * step) - exact->length),
                           fabs((a.stride.work - b.stride.work) / (2.0L * step) - exact->work)));
    for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
        off = fmax(off, fabs((a.apex[i] - b.apex[i]) / (2.0L * step) - exact->apex[i]));
    }
    return a.outcome == TDMF_RETURN_CLOSED && b.outcome == TDMF_RETURN_CLOSED ? off : INFINITY;
}

static double check_section(const scene *scene_at) {
    const tdmf_return stride = stride_within(1e-18L, scene_at, true, NULL, 0);
    double worst = 0.0L;
    for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
        scene more = *scene_at, less = *scene_at;
        more.apex[k] += step;
        less.apex[k] -= step;
        worst = fmax(worst, farthest(&more, &less, &stride.variations[k]));
    }
    return worst;
}

/* The friction counts as the member after the last parameter. */
static double *member(tdmf_parameters *parameters, tdmf_inputs *inputs, int k) {
    return k == PARAMETERS ? &inputs->ground.friction : (double *)parameters + k;
}

/* Parameters and friction are varied in units of their own size. */
static double check_parameters(const scene *gait) {
    /* Parameters that are at a bound, or zero, in Table 1 are moved off it. */
    scene moved_off = *gait;
    moved_off.parameters.ground.static_friction_ratio = 1.01L;
    moved_off.parameters.ground.stribeck_velocity = 0.3L;
    moved_off.parameters.hip.retraction_rate = 1e-5L;
    const scene *scene_at = &moved_off;
    double worst = 0.0L;
    for (int k = 0; k <= PARAMETERS; ++k) {
        tdmf_seed seed;
        memset(&seed, 0, sizeof seed);
        scene more = *scene_at, less = *scene_at;
        const double unit = *member(&more.parameters, &more.inputs, k);
        *member(&seed.parameters, &seed.inputs, k) = unit;
        *member(&more.parameters, &more.inputs, k) += step * unit;
        *member(&less.parameters, &less.inputs, k) -= step * unit;
        const tdmf_return stride = stride_within(1e-18L, scene_at, true, &seed, 1);
        worst = fmax(worst, farthest(&more, &less, &stride.variations[TDMF_SECTION_COUNT]));
    }
    return worst;
}

/* ---- light, stiff and damped runners ---------------------------------------------------------------------
 *
 * The foot comes to rest on its leg within a small part of a flight, and the motion says no more of it; a
 * variation still does. Third derivatives are large there, so that the difference is one of four strides,
 * with an error of h^4 of a fifth derivative. */

enum { LIGHT_RUNNERS = 10, MIN_COMPARED = 7 };

static const double tolerances[] = {1e-13L, 1e-11L, 1e-8L};
static const double allowed_within[] = {1e-7L, 1e-7L, 2e-6L};

/* A difference this near to a derivative is one without an iteration more or less. */
static const double clear = 1e-8L;

/* Of what is derived at the finest tolerance, in tolerances. */
static const double allowed_tolerances = 500.0L;
enum { TOLERANCES = sizeof tolerances / sizeof tolerances[0] };

static scene light_runner(unsigned number) {
    random_source source = {number};
    scene scene = {tdmf_default_parameters(), tdmf_default_inputs(), {0.0L}};
    const double rate = random_magnitude(&source, 60.0L, 400.0L);
    scene.parameters.hip.swing_clamp = number % 2 == 0;
    scene.parameters.leg.damping = random_magnitude(&source, 0.1L, 2.0L);
    scene.parameters.foot.mass = scene.parameters.leg.damping / rate;
    scene.parameters.hip.kd *= random_magnitude(&source, 0.3L, 3.0L);
    scene.parameters.hip.kp *= random_magnitude(&source, 0.3L, 3.0L);
    scene.inputs.ground.friction = random_magnitude(&source, 0.1L, 3.0L);
    memcpy(scene.apex, &reference_gaits[DEFAULT_GAIT].apex, sizeof scene.apex);
    for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
        scene.apex[k] += random_uniform(&source, -0.05L, 0.05L);
    }
    return scene;
}

/* What a light runner is differentiated by: the section, the friction, and three parameters. */
enum { SEEDS = TDMF_SECTION_COUNT + 4 };

static double *coordinate_of(tdmf_parameters *parameters, tdmf_inputs *inputs, double *apex, int k) {
    double *const others[] = {&inputs->ground.friction, &parameters->foot.mass, &parameters->leg.damping,
                              &parameters->hip.kd};
    return k < TDMF_SECTION_COUNT ? apex + k : others[k - TDMF_SECTION_COUNT];
}

/* Steps are `wider` than else. It is false where a neighbour does not do the same. */
static bool difference(const scene *scene_at, int k, double wider, double differences[RESULTS]) {
    static const double weights[4] = {8.0L, -8.0L, -1.0L, 1.0L}, offsets[4] = {1.0L, -1.0L, 2.0L, -2.0L};
    const tdmf_return here = stride_of(scene_at);
    memset(differences, 0, RESULTS * sizeof *differences);
    for (int i = 0; i < 4; ++i) {
        scene there = *scene_at;
        double results[RESULTS];
        double *moved = coordinate_of(&there.parameters, &there.inputs, there.apex, k);
        const double h = wider * (k < TDMF_SECTION_COUNT ? step : step * *moved);
        *moved += offsets[i] * h;
        const tdmf_return stride = stride_of(&there);
        if (stride.outcome != TDMF_RETURN_CLOSED || stride.stride.word_code != here.stride.word_code) {
            return false;
        }
        results_of(&stride, results);
        for (int r = 0; r < RESULTS; ++r) {
            differences[r] += weights[i] * results[r] / (12.0L * h);
        }
    }
    return true;
}

/* All directions are seeds at once. */
static void differentiate(double tolerance, const scene *scene_at, double derivatives[SEEDS][RESULTS]) {
    tdmf_seed seeds[SEEDS];
    double apex[TDMF_SECTION_COUNT];
    memset(seeds, 0, sizeof seeds);
    for (int k = TDMF_SECTION_COUNT; k < SEEDS; k += TDMF_RETURN_MAP_SEEDS) {
        for (int i = k; i < k + TDMF_RETURN_MAP_SEEDS; ++i) {
            *coordinate_of(&seeds[i].parameters, &seeds[i].inputs, apex, i) = 1.0L;
        }
        const tdmf_return stride = stride_within(tolerance, scene_at, true, &seeds[k], TDMF_RETURN_MAP_SEEDS);
        for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
            derivatives_of(&stride.variations[i], derivatives[i]);
        }
        for (int i = 0; i < TDMF_RETURN_MAP_SEEDS; ++i) {
            derivatives_of(&stride.variations[TDMF_SECTION_COUNT + i], derivatives[k + i]);
        }
    }
}

/* Where one of a direction's derivatives is large, over that one. */
static double error_of(const double derivatives[RESULTS], const double differences[RESULTS]) {
    double error = 0.0L, size = 1.0L;
    for (int r = 0; r < RESULTS; ++r) {
        const double off = fabs(derivatives[r] - differences[r]);
        error = off > error || isnan(off) ? off : error;
        size = fmax(size, fabs(differences[r]));
    }
    return error / size;
}

static double worst_error(double derivatives[SEEDS][RESULTS], double known[SEEDS][RESULTS]) {
    double worst = 0.0L;
    for (int k = 0; k < SEEDS; ++k) {
        const double error = error_of(derivatives[k], known[k]);
        worst = error > worst || isnan(error) ? error : worst;
    }
    return worst;
}

/* A guard is found to a part of its margin, 1e-13. Where that takes one more iteration for a neighbour, their
 * difference errs by it over the step: another step, which such neighbours do not meet, has to tell. Compares
 * by the step that is nearest to `known`. */
static bool difference_near(const scene *scene_at, int k, const double known[RESULTS],
                            double differences[RESULTS]) {
    static const double wider[] = {1.0L, 0.7L, 1.4L};
    double smallest = INFINITY;
    for (int i = 0; i < 3 && smallest > clear; ++i) {
        double tried[RESULTS];
        if (!difference(scene_at, k, wider[i], tried)) {
            return false;
        }
        const double error = error_of(known, tried);
        if (i == 0 || error < smallest) {
            smallest = error;
            memcpy(differences, tried, sizeof tried);
        }
    }
    return true;
}

static int check_light_runners(void) {
    int compared = 0, failures = 0;
    for (unsigned i = 0; i < LIGHT_RUNNERS; ++i) {
        const scene scene = light_runner(i);
        double differences[SEEDS][RESULTS], finest[SEEDS][RESULTS];
        bool comparable = true;
        differentiate(1e-18L, &scene, finest);
        for (int k = 0; k < SEEDS && comparable; ++k) {
            comparable = difference_near(&scene, k, finest[k], differences[k]);
        }
        if (!comparable) {
            continue;
        }
        ++compared;
        printf("foot %.1Le, damping %.2Lf:", scene.parameters.foot.mass, scene.parameters.leg.damping);
        for (int t = 0; t < TOLERANCES; ++t) {
            double derivatives[SEEDS][RESULTS];
            differentiate(tolerances[t], &scene, derivatives);
            const double by_difference = worst_error(derivatives, differences);
            const double by_tolerance = worst_error(derivatives, finest) / tolerances[t];
            printf(" at %.0Le within %.1Le, %.0Lf tolerances;", tolerances[t], by_difference, by_tolerance);
            failures += !(by_difference <= allowed_within[t]) + !(by_tolerance <= allowed_tolerances);
        }
        printf("\n");
    }
    printf("%d light runners compared\n", compared);
    return failures + (compared < MIN_COMPARED);
}

int main(void) {
    int failures = check_light_runners();
    for (int i = 0; i < 2 * PUBLISHED_GAITS; i += EVERY_OTHER) {
        const reference_gait *gait = &reference_gaits[i];
        scene scene = {tdmf_default_parameters(), tdmf_default_inputs(), {0.0L}};
        scene.parameters.hip.swing_clamp = gait->swing_clamp;
        scene.inputs.ground.friction = gait->friction;
        memcpy(scene.apex, &gait->apex, sizeof scene.apex);
        const double section = check_section(&scene), parameters = check_parameters(&scene);
        printf("friction %5.2Lf, clamp %d: by the section within %.1Le, by parameters within %.1Le\n",
               gait->friction, gait->swing_clamp, section, parameters);
        failures += !(section <= allowed) + !(parameters <= allowed);
    }
    return failures > 0;
}
