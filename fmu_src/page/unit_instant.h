/* An instant of a run: what follows from parameters and states, by the derived functions of the page. */
#ifndef TDMF_PAGE_UNIT_INSTANT_H
#define TDMF_PAGE_UNIT_INSTANT_H

#include "page_exchange.h"
#include "unit.h"
#include "unit_tables.h"

size_t instant_size(void);

/* The instant of a run, with the series of its mode up to the second coefficient. */
tdmf_page_instant instant_of(const fmu *fmu);
double *memory_of_instant(const fmu *fmu);

const tdmf_mode_kind *mode_of(const fmu *fmu);

/* The mode of a run, or the one before if its outputs and coordinates are kept. */
const tdmf_mode_kind *shown_mode_of(const fmu *fmu);
double *parameters_of(const fmu *fmu);
double *states_of(const fmu *fmu);

/* Writes the world's states that follow from those of the mode, or the mode's from the world's. */
void show_to_world(fmu *fmu);
void take_from_world(fmu *fmu);

/* The variation of all that follows, along variations of parameters and of the states of the mode. */
void vary_at(const fmu *fmu, const double *dp, const double *dx, fmu_view *variation);

#endif
