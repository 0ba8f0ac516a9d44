/* A part of a page: another page with some of its parameters, states, modes and events, which is faster where
 * a run needs no more. Runs on either are read and written in the terms of the whole page. */
#ifndef TDMF_KERNEL_PAGE_PART_H
#define TDMF_KERNEL_PAGE_PART_H

#include "driver.h"

/* Tables of places on the whole page; NULL: this is the whole page. */
typedef struct {
    const tdmf_model_kind *model;
    const int *parameters, *states, *events;
    const int *modes;       /* -1: the whole page has no such mode */
    const int (*copies)[2]; /* states of the whole page that are equal to another one */
    int copy_count;
    tdmf_answer *excess; /* computed on the whole page: 0 if the part has all that acts; or NULL */
} tdmf_page_part;

/* The place on the whole page for one of the part's own places. */
int tdmf_mode_in_whole(const tdmf_page_part *part, int own); /* -1: there is none */
int tdmf_event_in_whole(const tdmf_page_part *part, int own);

/* The place on the part for one on the whole page; -1: the part has none. */
int tdmf_parameter_on_part(const tdmf_page_part *part, int of_whole);
int tdmf_state_on_part(const tdmf_page_part *part, int of_whole);
int tdmf_mode_on_part(const tdmf_page_part *part, int of_whole);
int tdmf_event_on_part(const tdmf_page_part *part, int of_whole);

/* True if the part has every parameter and state of the whole page that changes along a direction. Either
 * pointer may be NULL. */
bool tdmf_part_varies(const tdmf_page_part *part, const tdmf_model_kind *whole, const double *dp,
                      const double *dx);

/* Sets of events, with a bit for each. */
uint64_t tdmf_events_in_whole(const tdmf_page_part *part, uint64_t own);
uint64_t tdmf_events_on_part(const tdmf_page_part *part, uint64_t of_whole);

/* Copies those parameters or states of the whole page that the part has, and back. Numbers of the whole page
 * are an array, or a struct of the page. */
void tdmf_take_parameters(const tdmf_page_part *part, const void *of_whole, double *own);
void tdmf_take_states(const tdmf_page_part *part, const void *of_whole, double *own);
void tdmf_give_parameters(const tdmf_page_part *part, const double *own, void *of_whole);
void tdmf_give_states(const tdmf_page_part *part, const double *own, void *of_whole);

#endif
