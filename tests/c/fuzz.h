/* What the fuzzers of both FMI versions share: random values, and the loop over lives. */
#ifndef TDMF_TESTS_FUZZ_H
#define TDMF_TESTS_FUZZ_H

#include "random.h"
#include "variables.h"

enum { CALLS_PER_INSTANCE = 200, SLOWEST_CALL = 60 /* s, under the sanitizers */ };

/* Ends the program with the unit's last message. */
void die(const char *what);

size_t pick(random_source *source, size_t count);
double random_value(random_source *source);

/* A value near the variable's own start: these instances run. */
double tame_value(random_source *source, const unit_variable *variable);

uint32_t random_reference(random_source *source);

/* Dies if one of the values is not a number and the call was fine. */
void expect_numbers(int status, const double *values, size_t count);

/* Makes one of `count` calls on a subject and dies if it takes too long. */
void call_one(random_source *source, void (*const calls[])(void *), size_t count, void *subject);

/* The program: arguments are [seconds [seed]]. `live` makes an instance, lets it live and frees it, and
 * returns how many steps of Co-Simulation it took. */
int fuzz(int count, char **arguments, const char *name, long (*live)(random_source *source));

#endif
