/* Steps of rough ground and noise of sensors: normal deviates, each of its own counter, without a rounded
 * operation before the last sum. They come by comparing uniform numbers only, hence the same bits from every
 * compiler and processor: algorithm N of C. F. F. Karney, "Sampling exactly from the normal distribution",
 * ACM Trans. Math. Softw. 42, 3 (2016), which goes back to von Neumann. */
#include "tdmf_slip/ensemble.h"

#include "philox.h"

/* Uniform numbers of one deviate: 64 bits stand for a fraction of 1. */
typedef struct {
    uint32_t counter[4], key[2];
    uint32_t words[4];
    int left; /* of the words */
} uniform_source;

/* Deviates of a stride are so many counters apart; none takes a millionth of them. */
static const uint32_t counters_of_deviate = (uint32_t)1 << 28;

static uniform_source source_of(uint64_t seed, uint64_t runner, uint32_t stride, uint32_t deviate) {
    const uniform_source source = {
        .counter = {deviate * counters_of_deviate, stride, (uint32_t)runner, (uint32_t)(runner >> 32)},
        .key = {(uint32_t)seed, (uint32_t)(seed >> 32)},
    };
    return source;
}

static uint64_t draw(uniform_source *source) {
    if (source->left == 0) {
        tdmf_philox(source->counter, source->key, source->words);
        ++source->counter[0];
        source->left = 4;
    }
    source->left -= 2;
    return (uint64_t)source->words[source->left] << 32 | source->words[source->left + 1];
}

/* True with probability exp(-1/2): the length of a falling run that begins below 1/2 is even. */
static bool passes_half(uniform_source *source) {
    uint64_t last = (uint64_t)1 << 63;
    for (bool even = true;; even = !even) {
        const uint64_t next = draw(source);
        if (next >= last) {
            return even;
        }
        last = next;
    }
}

/* Is true with probability (2 k + x)/(2 k + 2). */
static bool passes_share(uniform_source *source, uint32_t k, uint64_t x) {
    const uint32_t parts = 2 * k + 2;
    const uint32_t high = (uint32_t)(draw(source) >> 32);
    const uint32_t part = (uint32_t)(((uint64_t)high * parts) >> 32);
    return part < 2 * k || (part == 2 * k && draw(source) < x);
}

/* Is true with probability exp(-x (2 k + x)/(2 k + 2)). */
static bool passes_part(uniform_source *source, uint32_t k, uint64_t x) {
    uint64_t last = x;
    for (bool even = true;; even = !even) {
        const uint64_t next = draw(source);
        if (next >= last || !passes_share(source, k, x)) {
            return even;
        }
        last = next;
    }
}

/* k with probability proportional to exp(-k^2/2): exp(-k/2), accepted with exp(-k (k - 1)/2). */
static uint32_t draw_integer_part(uniform_source *source) {
    for (;;) {
        uint32_t k = 0;
        while (passes_half(source)) {
            ++k;
        }
        uint32_t tests = k < 2 ? 0 : k * (k - 1);
        while (tests > 0 && passes_half(source)) {
            --tests;
        }
        if (tests == 0) {
            return k;
        }
    }
}

static double draw_normal(uniform_source *source) {
    for (;;) {
        const uint32_t k = draw_integer_part(source);
        const uint64_t x = draw(source);
        uint32_t tests = k + 1;
        while (tests > 0 && passes_part(source, k, x)) {
            --tests;
        }
        if (tests == 0) {
            /* 53 bits are exact in a double, and 2^-53 is a power of two. */
            const double size = (double)k + (double)(x >> 11) / 9007199254740992.0;
            return draw(source) >> 63 ? -size : size;
        }
    }
}

double tdmf_ground_step(uint64_t seed, uint64_t runner, uint32_t stride) {
    uniform_source source = source_of(seed, runner, stride, 0);
    return draw_normal(&source);
}

/* The number of the deviate of friction, which no coordinate has. */
static const uint32_t of_friction = 7;

double tdmf_sensor_noise(uint64_t seed, uint64_t runner, uint32_t stride, int coordinate) {
    const uint32_t number = (uint32_t)coordinate + 1;
    uniform_source source = source_of(seed, runner, stride, number < of_friction ? number : number + 1);
    return draw_normal(&source);
}

double tdmf_friction_deviate(uint64_t seed, uint64_t runner, uint32_t stride) {
    uniform_source source = source_of(seed, runner, stride, of_friction);
    return draw_normal(&source);
}
