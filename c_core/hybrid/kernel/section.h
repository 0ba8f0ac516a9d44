/* Return maps of a model's sections: their Jacobians, and their fixed points. */
#ifndef TDMF_KERNEL_SECTION_H
#define TDMF_KERNEL_SECTION_H

#include "driver.h"
#include "fixed_point.h"

/* A return map. `run` is as tdmf_run_default makes it, with the parameters of the model, and with the
 * inputs among the states. Its seeds, if there are any, vary the parameters, and the inputs among the states.
 * Its log and samples are not used. */
typedef struct {
    const tdmf_model_kind *model;
    int section;
    const tdmf_page_run *run;
    double longest; /* time to the next crossing, at the most */
    double *memory; /* working memory of tdmf_section_memory_size numbers */
} tdmf_section_map;

/* Numbers of working memory that a return map needs whose run has so many seeds. */
size_t tdmf_section_memory_size(const tdmf_model_kind *model, int section, int seed_count);

/* Numbers of that memory that hold the run itself: all that a batch needs. */
size_t tdmf_section_run_size(const tdmf_model_kind *model, int section, int seed_count);

/* A run that begins at a point of the section and stops at its next event, in the memory of the map. With
 * `varies`, it has variations by the coordinates, then by the seeds: at most TDMF_VARIED_LIMIT in all. */
tdmf_page_run tdmf_run_from_section(const tdmf_section_map *map, const double *point, bool varies);

/* Outcome of a run from the section: a crossing that ends the run is a crossing, too. */
tdmf_run_outcome tdmf_outcome_at_section(const tdmf_section_map *map, const tdmf_page_run *r,
                                         tdmf_run_outcome outcome);

/* The image of a point. Columns of `varied` are the coordinates of the point, then the seeds. */
typedef struct {
    tdmf_run_outcome outcome; /* TDMF_RUN_STOPPED where there is a next crossing */
    int mode;                 /* mode at the end of the run */
    double time;
    double next[TDMF_MAP_LIMIT];
    double varied[TDMF_MAP_LIMIT][TDMF_VARIED_LIMIT];
} tdmf_crossing;

/* The next crossing from a point. `x` receives the states at the end of the run. With `varies`, `dx` receives
 * their variations by coordinates and seeds, and has room for them; it may be NULL. There are at most
 * TDMF_VARIED_LIMIT coordinates and seeds. */
tdmf_crossing tdmf_next_crossing(const tdmf_section_map *map, const double *point, bool varies, double *x,
                                 double *dx);

/* Searches a fixed point from a guess by Newton's method, with scales of the coordinates' units. */
tdmf_fixed_point tdmf_find_crossing(const tdmf_section_map *map, const double *guess, tdmf_crossing *last);

#endif
