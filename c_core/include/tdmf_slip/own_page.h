/* Additions to page.h in a library that `tdmf-slip build` has made of a page: its identity, and strides of
 * many runners, side by side in the lanes of SIMD registers and in threads. */
#ifndef TDMF_SLIP_OWN_PAGE_H
#define TDMF_SLIP_OWN_PAGE_H

#include "tdmf_slip/page.h"

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The identity of the build: another page, compiled text or version has another. */
TDMF_API const char *tdmf_page_build(void);

/* Runs from points of a section. Each ends as tdmf_page_stride would end it, bit for bit; so results do not
 * depend on the number of runs, lanes or threads. */
typedef struct {
    const tdmf_page_map *map;   /* map of all runs; its parameters and states are those of the first run */
    int64_t count;              /* runs */
    int64_t parameters_of_each; /* numbers from the parameters of a run to those of the next; 0: all share */
    int64_t states_of_each;     /* numbers from the states of a run to those of the next; 0: all share */
    const double *points;       /* a row for each run */
    double *states, *d_states;  /* rows at the end, as of tdmf_page_stride; `d_states` may be NULL */
    tdmf_page_end *ends;        /* one for each run */
    const int *cancel;          /* NULL; or runs end as cancelled once it points to another value than 0 */
    int threads;                /* number of threads */
} tdmf_page_batch;

/* Makes all strides, with events in rows of `event_room`. False if the map is refused; then nothing is
 * written. A run whose own numbers are refused has that outcome. */
TDMF_API bool tdmf_page_strides(const tdmf_page_batch *batch);

#ifdef __cplusplus
}
#endif
#endif
