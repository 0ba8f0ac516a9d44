/* Fixed points of a map by Newton's method. */
#ifndef TDMF_GAIT_FIXED_POINT_H
#define TDMF_GAIT_FIXED_POINT_H

#include "tdmf_slip/return_map.h"

/* A point and what the map makes of it; of the arrays, as much is used as the map has coordinates. */
typedef struct {
    double point[TDMF_SECTION_COUNT];
    double next[TDMF_SECTION_COUNT];
    double jacobian[TDMF_SECTION_COUNT][TDMF_SECTION_COUNT]; /* [i][k]: coordinate i of next by k of point */
} tdmf_image;

/* A map: how many coordinates it has, their scales, and how it is evaluated. `evaluate` is given the image's
 * point, fills in the rest, and may keep in its context, at number `slot`, 0 or 1, what else it has found.
 * False where the point has no image. */
typedef struct {
    int count;
    double scales[TDMF_SECTION_COUNT];
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
    double error;                     /* largest difference of point and image, over the scales */
    double point[TDMF_SECTION_COUNT]; /* the best, or the guess */
    int slot;                         /* of its evaluation */
} tdmf_fixed_point;

/* Searches from a guess, down to rounding. Steps that make the error larger are shortened. */
tdmf_fixed_point tdmf_find_fixed_point(const tdmf_map *map, const double *guess);

#endif
