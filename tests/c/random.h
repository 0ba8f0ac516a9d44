/* Random numbers that are the same on every machine: splitmix64. */
#ifndef TDMF_TESTS_RANDOM_H
#define TDMF_TESTS_RANDOM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    uint64_t state; /* the seed, to begin with */
} random_source;

double random_uniform(random_source *source, double from, double to);

/* The logarithm is uniform, which serves quantities of unknown magnitude. */
double random_magnitude(random_source *source, double from, double to);

bool random_chance(random_source *source, double probability);

/* True or false with equal probability, from the source's present state. The source does not advance, so the
 * values drawn from it later are unchanged. */
bool random_truth(random_source source);

/* Makes every source draw from these bytes, two for a number, and 0 when they are used up. A fuzzer chooses
 * the random numbers this way. NULL restores the usual sources. */
void random_draw_from(const uint8_t *bytes, size_t size);
size_t random_bytes_left(void);

#endif
