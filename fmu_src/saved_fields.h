/* The fields of a saved run, as bytes without padding or pointer, and the values that each may have. */
#ifndef TDMF_FMU_SAVED_FIELDS_H
#define TDMF_FMU_SAVED_FIELDS_H

#include "instance.h"

/* A run with what it belongs to. */
typedef struct {
    interface_kind interface;
    call_state state;
    fmu fmu;
} saved_run;

/* Number of bytes of every saved run. */
size_t saved_run_size(void);

void write_saved_run(saved_run *run, unsigned char *bytes);

/* Reads the bytes and checks each field, however they came about: whatever is accepted may be gone on with.
 * NULL; or why they are refused, written into `reason`. */
const char *read_saved_run(const unsigned char *bytes, saved_run *run, char *reason, size_t capacity);

#endif
