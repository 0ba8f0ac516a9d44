/* The runner's page, and smaller pages with some of its parameters, states, modes and events. Runs on any of
 * them are read and written in the terms of the runner's page. */
#ifndef TDMF_RUNNER_PAGE_PLACES_H
#define TDMF_RUNNER_PAGE_PLACES_H

#include "driver.h"
#include "runner.h"

/* Tables of places on the runner's page; NULL: this is the runner's page. */
typedef struct {
    const tdmf_model_kind *model;
    const int *parameters, *states, *events;
    const int *modes; /* -1: the runner's page has no such mode */
    bool is_plain;    /* the vertical force is the normal force */
} tdmf_runner_page;

extern const tdmf_runner_page tdmf_whole_page, tdmf_plain_page;
extern const tdmf_runner_page tdmf_reduced_page, tdmf_plain_reduced_page; /* of the reduced map */

/* Numbers of the runner's page, which has most of them. */
enum {
    TDMF_PAGE_PARAMETER_COUNT = sizeof(runner_parameters) / sizeof(double),
    TDMF_PAGE_STATE_COUNT = sizeof(runner_states) / sizeof(double)
};

/* The place on the runner's page for one of a page's own places. */
int tdmf_mode_in_runner(const tdmf_runner_page *page, int own); /* -1: there is none */
int tdmf_event_in_runner(const tdmf_runner_page *page, int own);

/* The place on a page for one on the runner's page; -1: the page has none. */
int tdmf_state_on_page(const tdmf_runner_page *page, int of_runner);
int tdmf_mode_on_page(const tdmf_runner_page *page, int of_runner);
int tdmf_event_on_page(const tdmf_runner_page *page, int of_runner);

/* Sets of events, with a bit for each. */
uint64_t tdmf_events_in_runner(const tdmf_runner_page *page, uint64_t own);
uint64_t tdmf_events_on_page(const tdmf_runner_page *page, uint64_t of_runner);

/* Copies those parameters or states of the runner's page that a page has, and back. */
void tdmf_take_parameters(const tdmf_runner_page *page, const runner_parameters *of_runner, double *own);
void tdmf_take_states(const tdmf_runner_page *page, const runner_states *of_runner, double *own);
void tdmf_give_parameters(const tdmf_runner_page *page, const double *own, runner_parameters *of_runner);
void tdmf_give_states(const tdmf_runner_page *page, const double *own, runner_states *of_runner);

#endif
