/* First variations along two seeds, side by side in the lanes of a register. The bits are those of one seed
 * after the other. A page's file includes this behind its motions of two lanes. */
#ifndef TDMF_KERNEL_SEEDS_H
#define TDMF_KERNEL_SEEDS_H

#include "driver.h"

/* Arrays in the working memory, one after the other. */
typedef struct {
    real *c, *d;
    real (*s)[TERMS], (*t)[TERMS];
} seed_arrays;

static seed_arrays seed_arrays_in(const tdmf_seed_lanes *lanes) {
    seed_arrays of;
    of.c = (real *)(((uintptr_t)lanes->memory + sizeof(real) - 1) / sizeof(real) * sizeof(real));
    of.d = of.c + lanes->constant_count;
    of.s = (void *)(of.d + lanes->constant_count);
    of.t = of.s + lanes->series_count;
    return of;
}

/* Repeats the constants and the series of a step in both lanes. */
static void fill_seed_lanes(const void *motions, int mode, const tdmf_seed_lanes *lanes, const void *c,
                            const void *s, int order) {
    const tdmf_motion_kind *m = (const tdmf_motion_kind *)motions + mode;
    const seed_arrays of = seed_arrays_in(lanes);
    const double *constants = c, *series = s;
    for (int i = 0; i < m->constant_count; ++i) {
        of.c[i] = broadcast(constants[i]);
    }
    for (int i = 0; i < m->series_count; ++i) {
        for (int k = 0; k <= order; ++k) {
            of.s[i][k] = broadcast(series[i * TERMS + k]);
        }
    }
}

/* Expands the variations of two seeds from those of the constants and of the states that move. */
static void vary_seed_lanes(const void *motions, int mode, const tdmf_seed_lanes *lanes,
                            const void *const d[2], const void *const dx[2], int order) {
    const tdmf_motion_kind *m = (const tdmf_motion_kind *)motions + mode;
    const seed_arrays of = seed_arrays_in(lanes);
    const double *d_first = d[0], *d_second = d[1], *first = dx[0], *second = dx[1];
    for (int i = 0; i < m->constant_count; ++i) {
        of.d[i] = (real){d_first[i], d_second[i]};
    }
    for (int i = 0; i < m->moving_count; ++i) {
        of.t[i][0] = (real){first[i], second[i]};
    }
    m->vary(of.c, of.s[0], of.d, order, of.t[0]);
}

/* Copies the variations of one of the two seeds, in memory: compilers would move whole registers for one
 * lane. Two coefficients at a time: there is room for one more than asked for. */
static void read_seed_lane(const void *motions, int mode, const tdmf_seed_lanes *lanes, int lane, int order,
                           void *t) {
    const tdmf_motion_kind *m = (const tdmf_motion_kind *)motions + mode;
    const seed_arrays of = seed_arrays_in(lanes);
    const int count = m->moving_count + m->extra_count;
    double(*into)[TERMS] = t;
    for (int i = 0; i < count; ++i) {
        const double *from = (const double *)of.t[i] + lane;
        for (int k = 0; k <= order; k += 2) {
            into[i][k] = from[2 * k];
            into[i][k + 1] = from[2 * k + 2];
        }
    }
}

#endif
