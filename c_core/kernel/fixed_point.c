/* With the map P and its Jacobian J, a step of Newton's method solves (I - J) dz = P(z) - z. */
#include "fixed_point.h"

#include <math.h>
#include <string.h>

enum { ITERATION_LIMIT = 40, SHORTENING_LIMIT = 12 };

/* Errors below this are rounding. */
static const double converged = 1e-13;
static const double good_enough = 1e-11;

static double error_of(const tdmf_map *map, const tdmf_image *image) {
    double error = 0.0;
    for (int i = 0; i < map->count; ++i) {
        const double difference = fabs(image->next[i] - image->point[i]) / map->scales[i];
        error = difference > error || isnan(difference) ? difference : error;
    }
    return error;
}

static bool newton_step(const tdmf_map *map, const tdmf_image *image, double step[TDMF_MAP_LIMIT]) {
    double a[TDMF_MAP_LIMIT][TDMF_MAP_LIMIT + 1];
    for (int i = 0; i < map->count; ++i) {
        for (int k = 0; k < map->count; ++k) {
            a[i][k] = (i == k ? 1.0 : 0.0) - image->jacobian[i][k];
        }
        step[i] = image->next[i] - image->point[i];
    }
    return tdmf_solve_linear(map->count, a, step);
}

/* Takes a step, or the part of it that makes the error smaller, and writes it into the other slot. */
static bool improve(const tdmf_map *map, tdmf_image images[2], tdmf_fixed_point *best,
                    const double step[TDMF_MAP_LIMIT]) {
    const int slot = 1 - best->slot;
    double share = 1.0;
    for (int i = 0; i < SHORTENING_LIMIT; ++i) {
        for (int k = 0; k < map->count; ++k) {
            images[slot].point[k] = best->point[k] + share * step[k];
        }
        if (map->evaluate(map->context, slot, &images[slot])) {
            const double error = error_of(map, &images[slot]);
            if (error < best->error) {
                best->error = error;
                best->slot = slot;
                memcpy(best->point, images[slot].point, sizeof best->point);
                return true;
            }
        }
        share *= 0.5;
    }
    return false;
}

tdmf_fixed_point tdmf_find_fixed_point(const tdmf_map *map, const double *guess) {
    tdmf_image images[2];
    tdmf_fixed_point best;
    memset(images, 0, sizeof images);
    memset(&best, 0, sizeof best);
    memcpy(images[0].point, guess, (size_t)map->count * sizeof *guess);
    memcpy(best.point, images[0].point, sizeof best.point);
    if (!map->evaluate(map->context, 0, &images[0])) {
        best.outcome = TDMF_FIXED_POINT_NO_IMAGE;
        return best;
    }
    best.error = error_of(map, &images[0]);
    for (; best.iterations < ITERATION_LIMIT && best.error > converged; ++best.iterations) {
        double step[TDMF_MAP_LIMIT];
        if (!newton_step(map, &images[best.slot], step) || !improve(map, images, &best, step)) {
            break;
        }
    }
    best.outcome = best.error <= good_enough ? TDMF_FIXED_POINT_FOUND : TDMF_FIXED_POINT_NOT_FOUND;
    return best;
}
