/* Numbers of one runner, in plain C. */
#ifndef TDMF_KERNEL_WIDTH_ONE_H
#define TDMF_KERNEL_WIDTH_ONE_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Inputs may be ramps. */
enum { INPUTS_RAMP = 1 };

typedef double real;

/* 1 or 0: what comparing yields. */
typedef int mask;

/* A small integer. */
typedef int integer;

static inline real broadcast(double x) {
    return x;
}

static inline integer integer_of(int x) {
    return x;
}

static inline mask mask_of(bool selected) {
    return selected;
}

static inline mask mask_not(mask selected) {
    return !selected;
}

static inline bool any(mask selected) {
    return selected != 0;
}

/* Takes a where it is selected, else b. */
static inline real select(mask selected, real a, real b) {
    return selected ? a : b;
}

static inline integer select_integer(mask selected, integer a, integer b) {
    return selected ? a : b;
}

static inline real real_abs(real x) {
    return fabs(x);
}

static inline real real_min(real a, real b) {
    return a < b ? a : b;
}

static inline real real_max(real a, real b) {
    return a > b ? a : b;
}

static inline real real_sqrt(real x) {
    return sqrt(x);
}

static inline real real_exp(real x) {
    return exp(x);
}

/* Neither infinite nor not a number. */
static inline mask is_finite(real x) {
    return real_abs(x) < INFINITY;
}

static inline void sine_and_cosine(real x, real *sine, real *cosine) {
    *sine = sin(x);
    *cosine = cos(x);
}

#ifndef TDMF_EXTENDED_PRECISION
typedef double binary64;
#endif

/* The high half of the bits of a number in IEEE double precision, and the number that has such a one. */
static inline real high_half(real x) {
    const binary64 number = (binary64)x;
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    return (real)(int32_t)(bits >> 32);
}

static inline real with_high_half(real half) {
    const uint64_t bits = (uint64_t)(int64_t)(half + 0.5) << 32;
    binary64 number;
    memcpy(&number, &bits, sizeof number);
    return number;
}

#endif
