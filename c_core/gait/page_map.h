/* Return maps of pages as runs of the driver, between page.c and page_batch.c. */
#ifndef TDMF_GAIT_PAGE_MAP_H
#define TDMF_GAIT_PAGE_MAP_H

#include "tdmf_slip/page.h"

#include "section.h"

/* The models of this library by name. */
typedef struct {
    const char *name;
    const tdmf_model_kind *model;
    tdmf_answer *const *requirements; /* numbers that must not be negative at a start */
    int requirement_count;
} tdmf_page_entry;

extern const tdmf_page_entry tdmf_pages[];
extern const int tdmf_page_count;
extern const char *const tdmf_build_identity;

/* Checks of a map but for its numbers, of its parameters and states, and of a point of its section. */
bool tdmf_is_page_map_sound(tdmf_refusal *why, const tdmf_page_map *map);
bool tdmf_are_page_values_sound(const tdmf_model_kind *model, const double *parameters, const double *states);
bool tdmf_is_page_point_sound(const tdmf_section_kind *section, const double *point);

/* A run with the settings of a map, which a section starts. */
tdmf_page_run tdmf_run_of_page_map(const tdmf_page_map *map);

/* The number, from 1, of the requirement that the start of a run does not meet; 0 where all are met. */
int tdmf_unmet_requirement(const tdmf_model_kind *model, const tdmf_page_run *r);

/* The states of a run and, unless `d_states` is NULL, their variations: a row for each. */
void tdmf_read_page_run(const tdmf_model_kind *model, const tdmf_page_run *r, double *states,
                        double *d_states);

/* Result of a run; its logged events are written to `events`, which may be NULL. */
tdmf_page_end tdmf_end_of_page_run(const tdmf_page_map *map, const tdmf_page_run *r, tdmf_run_outcome outcome,
                                   tdmf_page_event *events);

#endif
