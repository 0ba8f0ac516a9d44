#include "fuzz.h"

#include "forge.h"
#include "messages.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

void die(const char *what) {
    fprintf(stderr, "fuzz: %s; last message: %s\n", what, last_message);
    abort();
}

size_t random_index(random_source *source, size_t count) {
    return (size_t)random_uniform(source, 0.0, (double)count) % count;
}

double random_value(random_source *source) {
    static const double special[] = {0.0,  -0.0, 1.0,     -1.0,    1e-300,   -1e-300,  5e-324,
                                     1e12, 1e60, DBL_MAX, DBL_MIN, -DBL_MAX, INFINITY, NAN};
    if (random_chance(source, 0.3)) {
        return special[random_index(source, COUNT_OF(special))];
    }
    return random_uniform(source, -1.0, 1.0) * random_magnitude(source, 1e-6, 1e6);
}

double tame_value(random_source *source, const fmu_variable *variable) {
    if (variable->start != 0.0) {
        return variable->start * random_uniform(source, 0.7, 1.4);
    }
    return fmax(variable->minimum, random_uniform(source, -0.05, 0.05));
}

uint32_t random_setting(random_source *source, bool at_event) {
    uint32_t settings[64];
    size_t count = 0;
    for (uint32_t i = 0; i < fmu_variable_count; ++i) {
        const bool waits = fmu_is_set_at_events(&fmu_variables[i]);
        if (waits ? at_event : fmu_variables[i].storage == STORED_INPUT) {
            settings[count++] = i;
        }
    }
    return settings[random_index(source, count)];
}

uint32_t random_reference(random_source *source) {
    return (uint32_t)random_index(source, fmu_variable_count + 2);
}

void forge(random_source *source, unsigned char *bytes, size_t size) {
    const bool in_header = random_chance(source, 0.1);
    size_t offset = in_header ? random_index(source, FORGE_CONTENT)
                              : FORGE_CONTENT + random_index(source, size - FORGE_CONTENT);
    for (size_t left = 1 + random_index(source, sizeof(double)); left > 0 && offset < size; --left) {
        bytes[offset++] = (unsigned char)random_index(source, 256);
    }
    if (!in_header) {
        forge_checksum(bytes, size);
    }
}

void expect_numbers(int status, const double *values, size_t count) {
    for (size_t i = 0; i < count && status == 0; ++i) {
        if (isnan(values[i])) {
            die("not a number, and the call was fine");
        }
    }
}

void call_until_used_up(random_source *source, void (*const calls[])(void *), size_t count, void *subject) {
    while (random_bytes_left() > 0) {
        calls[random_index(source, count)](subject);
    }
}
