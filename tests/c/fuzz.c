#include "fuzz.h"

#include "messages.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

void die(const char *what) {
    fprintf(stderr, "fuzz: %s; last message: %s\n", what, last_message);
    abort();
}

size_t pick(random_source *source, size_t count) {
    return (size_t)random_uniform(source, 0.0, (double)count) % count;
}

double random_value(random_source *source) {
    static const double special[] = {0.0,  -0.0, 1.0,     -1.0,    1e-300,   -1e-300,  5e-324,
                                     1e12, 1e60, DBL_MAX, DBL_MIN, -DBL_MAX, INFINITY, NAN};
    if (random_chance(source, 0.3)) {
        return special[pick(source, sizeof special / sizeof special[0])];
    }
    return random_uniform(source, -1.0, 1.0) * random_magnitude(source, 1e-6, 1e6);
}

double tame_value(random_source *source, const unit_variable *variable) {
    return variable->start * random_uniform(source, 0.7, 1.4);
}

uint32_t random_reference(random_source *source) {
    return (uint32_t)pick(source, unit_variable_count + 2);
}

void expect_numbers(int status, const double *values, size_t count) {
    for (size_t i = 0; i < count && status == 0; ++i) {
        if (isnan(values[i])) {
            die("not a number, and the call was fine");
        }
    }
}

void call_one(random_source *source, void (*const calls[])(void *), size_t count, void *subject) {
    const time_t before = time(NULL);
    calls[pick(source, count)](subject);
    if (time(NULL) - before > SLOWEST_CALL) {
        die("a call took too long");
    }
}

int fuzz(int count, char **arguments, const char *name, long (*live)(random_source *source)) {
    const double seconds = count > 1 ? atof(arguments[1]) : 5.0;
    random_source source = {count > 2 ? strtoull(arguments[2], NULL, 10) : (uint64_t)time(NULL)};
    const time_t start = time(NULL);
    long lives = 0;
    long steps = 0;
    printf("%s: seed %llu, %g s\n", name, (unsigned long long)source.state, seconds);
    fflush(stdout);
    for (; difftime(time(NULL), start) < seconds; ++lives) {
        steps += live(&source);
    }
    printf("%s: %ld instances of %d calls, %ld steps of Co-Simulation, nothing found\n", name, lives,
           CALLS_PER_INSTANCE, steps);
    return 0;
}
