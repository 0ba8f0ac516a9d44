/* An instant of a run: what follows from parameters and states, by the derived functions of the page. */
#ifndef TDMF_PAGE_PAGE_INSTANT_H
#define TDMF_PAGE_PAGE_INSTANT_H

#include "unit.h"
#include "unit_tables.h"

/* Arrays in the working memory of a unit, behind that of the driver. */
typedef struct {
    double *c, *d;                   /* constants of the mode, and their variation */
    double (*s)[TERMS], (*t)[TERMS]; /* series of its states, and their variation */
    double *scales, *event_scales;   /* by state, and by event */
    double *x, *dx, *dp;             /* working memory for states and parameters */
} instant;

/* A guard of the mode, in its scale, shifted so that it is zero where the driver takes the event. */
typedef struct {
    double value;
    bool is_watched;
    bool rises; /* to zero, since its event was taken */
    bool is_due;
} guard_state;

size_t instant_size(void);

/* The instant of a run, with the series of its mode up to the second coefficient. */
instant instant_of(const fmu *fmu);

const tdmf_mode_kind *mode_of(const fmu *fmu);
double *parameters_of(const fmu *fmu);
double *states_of(const fmu *fmu);

/* Writes the world's states that follow from those of the mode, or the mode's from the world's. */
void show_to_world(fmu *fmu);
void take_from_world(fmu *fmu);

/* Rates of all states that move, by their numbers in the page. */
void rates_at(const fmu *fmu, const instant *at, double *rates);

/* The guards of the mode, in their order. */
void guards_at(const fmu *fmu, const instant *at, guard_state guards[TDMF_GUARD_LIMIT]);

/* The value and the rate of an observed quantity of the mode. */
void observed_at(const fmu *fmu, const instant *at, int watch, double *value, double *rate);

/* The variation of all that follows, along variations of parameters and of the states of the mode. */
void vary_at(const fmu *fmu, const double *dp, const double *dx, fmu_view *variation);

#endif
