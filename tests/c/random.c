#include "random.h"

#include <math.h>

static const uint8_t *drawn;
static size_t drawn_left;

void random_draw_from(const uint8_t *bytes, size_t size) {
    drawn = bytes;
    drawn_left = size;
}

size_t random_bytes_left(void) {
    return drawn_left;
}

static double fmu_from_bytes(void) {
    double unit = 0.0;
    for (int i = 0; i < 2 && drawn_left > 0; ++i) {
        unit = (unit + *drawn++) / 256.0;
        --drawn_left;
    }
    return unit;
}

static uint64_t next(random_source *source) {
    source->state += UINT64_C(0x9e3779b97f4a7c15);
    uint64_t z = source->state;
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

double random_uniform(random_source *source, double from, double to) {
    const double unit = drawn != NULL ? fmu_from_bytes() : ldexp((double)(next(source) >> 11), -53);
    return from + (to - from) * unit;
}

double random_magnitude(random_source *source, double from, double to) {
    return exp(random_uniform(source, log(from), log(to)));
}

bool random_chance(random_source *source, double probability) {
    return random_uniform(source, 0.0, 1.0) < probability;
}

bool random_truth(random_source source) {
    source.state ^= UINT64_C(0xbb67ae8584caa73b);
    return (drawn != NULL ? drawn_left : next(&source)) % 2 == 0;
}
