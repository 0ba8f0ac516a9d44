/* Sine and cosine of lanes. */
#ifndef TDMF_KERNEL_LANE_MATH_H
#define TDMF_KERNEL_LANE_MATH_H

#include "lanes.h"

/* On [-pi/4, pi/4], by the coefficients of fdlibm's __kernel_sin and __kernel_cos. */
static inline real sine_near_zero(real x) {
    const real z = x * x;
    real p = broadcast(1.58969099521155010221e-10);
    p = p * z - 2.50507602534068634195e-08;
    p = p * z + 2.75573137070700676789e-06;
    p = p * z - 1.98412698298579493134e-04;
    p = p * z + 8.33333333332248946124e-03;
    p = p * z - 1.66666666666666324348e-01;
    return x + x * z * p;
}

static inline real cosine_near_zero(real x) {
    const real z = x * x;
    real p = broadcast(-1.13596475577881948265e-11);
    p = p * z + 2.08757232129817482790e-09;
    p = p * z - 2.75573143513906633035e-07;
    p = p * z + 2.48015872894767294178e-05;
    p = p * z - 1.38888888888741095749e-03;
    p = p * z + 4.16666666666666019037e-02;
    return 1.0 - (0.5 * z - z * z * p);
}

/* Angles beyond this many turns are left to the library; no leg winds that far and runs on. */
static const double farthest_angle = 1e5;

/* pi/2 in three parts, the first two with trailing zeros, so that their multiples are exact. */
static inline void sine_and_cosine(real x, real *sine, real *cosine) {
    const real quarter = (x * 0.63661977236758134308 + integer_bias) - integer_bias;
    const bits quadrant = bits_of_integer(quarter);
    const real rest = ((x - quarter * 1.57079632673412561417e+00) - quarter * 6.07710050630396597660e-11) -
                      quarter * 2.02226624879595063154e-21;
    const mask swap = (quadrant & 1) != 0;
    const real s = sine_near_zero(rest);
    const real c = cosine_near_zero(rest);
    const bits sine_sign = (bits)((pattern)(quadrant & 2) << 62);
    const bits cosine_sign = (bits)((pattern)((quadrant + 1) & 2) << 62);
    *sine = (real)((bits)select(swap, c, s) ^ sine_sign);
    *cosine = (real)((bits)select(swap, s, c) ^ cosine_sign);
    const unsigned far = movemask(~(real_abs(x) < broadcast(farthest_angle)));
    for (int lane = 0; far >> lane != 0; ++lane) {
        if (far >> lane & 1) {
            (*sine)[lane] = sin(x[lane]);
            (*cosine)[lane] = cos(x[lane]);
        }
    }
}

#endif
