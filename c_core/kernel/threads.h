/* The same work in several threads at once. */
#ifndef TDMF_KERNEL_THREADS_H
#define TDMF_KERNEL_THREADS_H

#include <stdbool.h>
#include <stdint.h>

typedef void tdmf_work(void *shared, int number);

/* Calls `work` for each number below `count`, side by side, and waits for all; for fewer, and at the least
 * for 0, where there are no more threads to be had. */
void tdmf_run_in_threads(tdmf_work *work, void *shared, int count);

/* Adds one to a counter that threads share, and returns what it was. */
int64_t tdmf_take_number(int64_t *counter);

/* True if a flag is no longer 0; another thread may set it meanwhile. False for NULL. */
bool tdmf_is_raised(const int *flag);

#endif
