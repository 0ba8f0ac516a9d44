/* The same work in several threads at once. */
#ifndef TDMF_ENSEMBLE_THREADS_H
#define TDMF_ENSEMBLE_THREADS_H

typedef void tdmf_work(void *shared, int number);

/* Calls `work` for each number below `count`, side by side, and waits for all. What finds no thread of its
 * own is done by the caller's. */
void tdmf_side_by_side(tdmf_work *work, void *shared, int count);

/* Adds one to a counter that threads share, and returns what it was. */
long tdmf_take_number(long *counter);

#endif
