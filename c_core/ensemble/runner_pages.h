/* The pages on which ensembles run. Parameters, states, modes and events of each are some of those of the
 * runner's page, and members of an ensemble are read and written in its terms.
 */
#ifndef TDMF_ENSEMBLE_RUNNER_PAGES_H
#define TDMF_ENSEMBLE_RUNNER_PAGES_H

#include "runner.h"
#include "tdmf_slip/ensemble.h"

/* The tables hold places on the runner's page. -1: the runner's page has no such mode; NULL: this is the
 * runner's page. */
typedef struct {
    const tdmf_model_kind *model;
    tdmf_motions_of_width *lanes[3]; /* motions for 2, 4 and 8 lanes; NULL: this build has none */
    const int *parameters, *states, *modes, *events;
} tdmf_runner_page;

/* Numbers of the runner's page, which has most of them. */
enum {
    TDMF_RUNNER_PARAMETERS = sizeof(runner_parameters) / sizeof(double),
    TDMF_RUNNER_STATES = sizeof(runner_states) / sizeof(double)
};

/* The page for a map. `is_plain`: for runners that tdmf_suits_plain_page finds plain. */
const tdmf_runner_page *tdmf_page_for(tdmf_ensemble_map map, bool is_plain);

/* The model of a page with its motions in lanes. */
tdmf_model_kind tdmf_model_in_lanes(const tdmf_runner_page *page);

/* Copies parameters or states of the runner's page to those of a page, and back. */
void tdmf_take_from_runner(const int *places, int count, const double *of_runner, double *own);
void tdmf_give_to_runner(const int *places, int count, const double *own, double *of_runner);

/* The place on a page of a mode or an event of the runner's page; -1: the page has none. */
int tdmf_place_of(const int *places, int count, int of_runner);

/* The places on a page of all the runner's states. */
void tdmf_find_places(const tdmf_runner_page *page, int places[TDMF_RUNNER_STATES]);

int tdmf_mode_in_runner(const tdmf_runner_page *page, int mode);

/* Sets of events, with a bit for each. */
uint64_t tdmf_events_in_runner(const tdmf_runner_page *page, uint64_t own);
uint64_t tdmf_events_on_page(const tdmf_runner_page *page, uint64_t of_runner);

#endif
