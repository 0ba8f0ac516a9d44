/* An instant of a run: rates, guards and their variations, from the derived functions of any page. Solvers
 * other than the driver integrate these. */
#ifndef TDMF_KERNEL_PAGE_INSTANT_H
#define TDMF_KERNEL_PAGE_INSTANT_H

#include "driver.h"

/* Arrays lie in the caller's memory. */
typedef struct {
    const tdmf_model_kind *model;
    const tdmf_mode_kind *mode;
    const double *p, *x;
    double *c, *d;                   /* constants of the mode, and their variation */
    double (*s)[TERMS], (*t)[TERMS]; /* series of its states, and their variation */
    double *scales, *event_scales;   /* indexed by state, and by event */
} tdmf_page_instant;

/* Numbers of memory that an instant needs. */
size_t tdmf_size_of_instant(const tdmf_model_kind *model);

/* The instant of a mode, at parameters p and states x, which are not copied. */
tdmf_page_instant tdmf_instant_at(const tdmf_model_kind *model, int mode, const double *p, const double *x,
                                  double *memory);

/* Rates of all states of the page in the coordinates of the mode; those of integrals of positive parts are
 * among them. */
void tdmf_page_rates(const tdmf_page_instant *at, double *rates);

/* The same, and those of the states in the world's coordinates. */
void tdmf_page_world_rates(const tdmf_page_instant *at, double *rates);

/* The value and the rate of a guard of the mode, by its number. */
void tdmf_page_guard(const tdmf_page_instant *at, int guard, double *value, double *rate);

/* The value and the rate of an observed quantity of the mode, by its number. */
void tdmf_page_observed(const tdmf_page_instant *at, int watch, double *value, double *rate);

/* First variations of tdmf_page_world_rates, along variations of parameters and of the mode's states. */
void tdmf_vary_page_rates(const tdmf_page_instant *at, const double *dp, const double *dx, double *d_rates);

/* Writes the states in the world's coordinates that follow from those of the mode, or the mode's from the
 * world's. `room` is for as many states as the page has. */
void tdmf_show_to_world(const tdmf_model_kind *model, int mode, const double *p, double *x, double *room);
void tdmf_take_from_world(const tdmf_model_kind *model, int mode, const double *p, double *x, double *room);

#endif
