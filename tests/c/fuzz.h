/* Shared by the fuzzers: random values drawn from the input's bytes, and what must hold after any call.
 *
 * Each fuzzer is a LLVMFuzzerTestOneInput, whose bytes choose the calls; libFuzzer looks for bytes that reach
 * new code. Without libFuzzer, fuzz_main.c replays saved inputs and makes up some of its own. */
#ifndef TDMF_TESTS_FUZZ_H
#define TDMF_TESTS_FUZZ_H

#include "count_of.h"
#include "random.h"
#include "variables.h"

enum { STEPS_OF_A_CALL = 2000 /* step limit of the solver */ };

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

/* Ends the program with the unit's last message. */
void die(const char *what);

size_t random_index(random_source *source, size_t count);
double random_value(random_source *source);

/* A value near the variable's own start, or within its range some hundredths off 0: these instances run. */
double tame_value(random_source *source, const fmu_variable *variable);

/* A variable that may be set in a run: a continuous input, or also what is set at events only. */
uint32_t random_setting(random_source *source, bool at_event);

uint32_t random_reference(random_source *source);

/* Changes some bytes of a serialized state, mostly with a right checksum. */
void forge(random_source *source, unsigned char *bytes, size_t size);

/* Dies if one of the values is not a number and the call was fine. */
void expect_numbers(int status, const double *values, size_t count);

/* Makes calls on a subject, each one of `count`, until the input's bytes are used up. */
void call_until_used_up(random_source *source, void (*const calls[])(void *), size_t count, void *subject);

#endif
