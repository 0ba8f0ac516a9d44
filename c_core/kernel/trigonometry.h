/* Sine and cosine that give equal bits in lanes and alone. */
#ifndef TDMF_KERNEL_TRIGONOMETRY_H
#define TDMF_KERNEL_TRIGONOMETRY_H

/* Both hold on [-pi/4, pi/4] and have the coefficients of fdlibm's __kernel_sin and __kernel_cos. */
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

/* Angles beyond this are left to the library. */
static const double farthest_angle = 1e5;

/* Angle minus the nearest multiple of pi/2. pi/2 is the sum of three parts; the first two have trailing
 * zeros, so that their multiples are exact. */
static inline real without_quarters(real x, real quarters) {
    return ((x - quarters * 1.57079632673412561417e+00) - quarters * 6.07710050630396597660e-11) -
           quarters * 2.02226624879595063154e-21;
}

static inline real nearest_quarters(real x) {
    return (x * 0.63661977236758134308 + integer_bias) - integer_bias;
}

#endif
