/* The same work in several threads at once. */
#ifndef TDMF_KERNEL_THREADS_H
#define TDMF_KERNEL_THREADS_H

#include <stdbool.h>
#include <stdint.h>

typedef void tdmf_work(void *shared, int number);

/* Calls `work` for each number below `count` in parallel and waits for all. If the system has too few
 * threads, fewer numbers are served, but always number 0. */
void tdmf_run_in_threads(tdmf_work *work, void *shared, int count);

/* Adds one to a counter that threads share, and returns its value before. */
int64_t tdmf_take_number(int64_t *counter);

/* True if a flag is no longer 0; another thread may set it meanwhile. False for NULL. */
bool tdmf_is_raised(const int *flag);

#endif
