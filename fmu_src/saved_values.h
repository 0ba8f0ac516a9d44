/* Single values of a saved run. One call writes a value into the bytes, reads and checks it, or only counts
 * its bytes, so that what is written and what is read cannot differ. */
#ifndef TDMF_FMU_SAVED_VALUES_H
#define TDMF_FMU_SAVED_VALUES_H

#include "saved_fields.h"

typedef struct {
    unsigned char *target;       /* written to, or NULL */
    const unsigned char *source; /* read from, or NULL */
    size_t offset;
    const char *refused; /* the first field that may not be what it is */
} transfer;

/* Largest sum along a run. It is beyond whatever is added up from states below fmu_largest_state, and far
 * enough from overflow for differences and products. */
static const double largest_sum = 1e200;

/* Moves one value between `value` and the bytes; true where it was read. */
bool pass(transfer *bytes, void *value, size_t size);

/* Refuses the bytes for this field unless it is allowed. */
void require(transfer *bytes, bool allowed, const char *name);

/* Values that are checked where they are read. NaN lies between nothing, and an integer that is refused is
 * read as `least`. */
void pass_between(transfer *bytes, const char *name, double *value, double least, double most);
void pass_integer(transfer *bytes, const char *name, int *value, int least, int most);
void pass_time(transfer *bytes, const char *name, double *value);

/* A counter of 64 bits, which no run brings near its end from the largest value that is allowed. */
void pass_work(transfer *bytes, const char *name, int64_t *value);

/* A bool never holds anything but its two values. */
void pass_flag(transfer *bytes, const char *name, bool *value);

/* The interface and the state of the call sequence, and the check that they suit each other and the run. */
void pass_calls(transfer *bytes, saved_run *run);
void require_calls(transfer *bytes, const saved_run *run);

/* The importer's tolerance and stop time. */
void pass_experiment(transfer *bytes, fmu *fmu);

/* Why the bytes are refused, written into `reason`; NULL: they are not. */
const char *reason_of(const transfer *bytes, char *reason, size_t capacity);

#endif
