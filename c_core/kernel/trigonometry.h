/* Sine, cosine and the angle of a vector, which give equal bits in lanes and alone. */
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

/* The arctangent on [0, 0.66], with the coefficients of Cephes' atan. */
static inline real arctangent_near_zero(real x) {
    const real z = x * x;
    real p = broadcast(-8.750608600031904122785e-01), q = z + 2.485846490142306297962e+01;
    p = p * z - 1.615753718733365076637e+01;
    q = q * z + 1.650270098316988542046e+02;
    p = p * z - 7.500855792314704667340e+01;
    q = q * z + 4.328810604912902668951e+02;
    p = p * z - 1.228866684490136173410e+02;
    q = q * z + 4.853903996359136964868e+02;
    p = p * z - 6.485021904942025371773e+01;
    q = q * z + 1.945506571482613964425e+02;
    return x + x * (z * (p / q));
}

/* The angle of the vector (x, y) from the x axis, as atan2 has it; pi/4 is the sum of two parts. */
static inline real real_atan2(real y, real x) {
    const real across = real_abs(y), along = real_abs(x);
    const real smaller = real_min(across, along), larger = real_max(across, along);
    const real ratio = select(larger > 0.0, smaller / larger, broadcast(0.0));
    const mask is_steep = ratio > 0.66;
    const real from = select(is_steep, (ratio - 1.0) / (ratio + 1.0), ratio);
    const real rest = select(is_steep, broadcast(3.061616997868382943065e-17), broadcast(0.0));
    real angle = select(is_steep, broadcast(7.853981633974482789995e-01), broadcast(0.0)) +
                 (arctangent_near_zero(from) + rest);
    angle = select(across > along, 1.570796326794896557999e+00 - angle, angle);
    angle = select(x < 0.0, 3.141592653589793115998e+00 - angle, angle);
    angle = select(y < 0.0, -angle, angle);
    return select(is_finite(x + y), angle, x + y + broadcast(NAN));
}

#endif
