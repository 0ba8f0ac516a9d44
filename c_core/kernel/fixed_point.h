/* Fixed points of a map by Newton's method. */
#ifndef TDMF_KERNEL_FIXED_POINT_H
#define TDMF_KERNEL_FIXED_POINT_H

#include "linear_equations.h"

/* A point and its image. Each array is used up to the number of the map's coordinates. */
typedef struct {
    double point[TDMF_MAP_LIMIT];
    double next[TDMF_MAP_LIMIT];
    double jacobian[TDMF_MAP_LIMIT][TDMF_MAP_LIMIT]; /* [i][k]: coordinate i of next by k of point */
} tdmf_image;

/* A map: how many coordinates it has, their scales, and how it is evaluated. `evaluate` is given the image's
 * point, fills in the rest, and may keep in its context, at number `slot`, 0 or 1, what else it has found.
 * False where the point has no image. */
typedef struct {
    int count;
    double scales[TDMF_MAP_LIMIT];
    bool (*evaluate)(void *context, int slot, tdmf_image *image);
    void *context;
} tdmf_map;

typedef enum {
    TDMF_FIXED_POINT_FOUND,
    TDMF_FIXED_POINT_NOT_FOUND,
    TDMF_FIXED_POINT_NO_IMAGE /* the guess has none */
} tdmf_fixed_point_outcome;

typedef struct {
    tdmf_fixed_point_outcome outcome;
    int iterations;
    double error;                 /* largest difference of point and image, over the scales */
    double point[TDMF_MAP_LIMIT]; /* the best, or the guess */
    int slot;                     /* slot of its evaluation */
} tdmf_fixed_point;

/* Searches from a guess, down to rounding. Steps that make the error larger are shortened. */
tdmf_fixed_point tdmf_find_fixed_point(const tdmf_map *map, const double *guess);

#endif
