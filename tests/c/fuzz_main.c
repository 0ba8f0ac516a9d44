/* A fuzzer without libFuzzer: replays saved inputs, then inputs that are made up, the same on every machine.
 *
 *     fuzz_<name> RUNS [FILE...] */
#include "fuzz.h"

#include <stdio.h>
#include <stdlib.h>

enum { LARGEST_INPUT = 16384, LARGEST_MADE_UP = 512 };

static uint8_t input[LARGEST_INPUT];

static int replay(const char *path) {
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        fprintf(stderr, "%s cannot be opened\n", path);
        return 1;
    }
    const size_t size = fread(input, 1, sizeof input, file);
    fclose(file);
    return LLVMFuzzerTestOneInput(input, size);
}

static void make_up(uint64_t seed) {
    random_source source = {seed};
    random_draw_from(NULL, 0);
    const size_t size = 1 + (size_t)random_uniform(&source, 0.0, LARGEST_MADE_UP);
    for (size_t i = 0; i < size; ++i) {
        input[i] = (uint8_t)random_uniform(&source, 0.0, 256.0);
    }
    LLVMFuzzerTestOneInput(input, size);
}

int main(int count, char **arguments) {
    const long runs = count > 1 ? atol(arguments[1]) : 0;
    int unread = 0;
    for (int i = 2; i < count; ++i) {
        unread += replay(arguments[i]);
    }
    for (long i = 0; i < runs; ++i) {
        make_up((uint64_t)i);
    }
    printf("%d saved inputs and %ld made up, nothing found\n", count > 2 ? count - 2 : 0, runs);
    return unread != 0;
}
