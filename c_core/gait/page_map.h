/* Return maps of pages as runs of the driver, between page.c and page_batch.c. */
#ifndef TDMF_GAIT_PAGE_MAP_H
#define TDMF_GAIT_PAGE_MAP_H

#include "tdmf_slip/page.h"

#include "page_part.h"
#include "section.h"

/* The models of this library by name. */
typedef struct {
    const char *name;
    tdmf_page_part whole;
    const tdmf_page_part *plain;      /* faster, for runs that need no more; NULL: there is none */
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

/* A model with its motions in lanes. */
tdmf_model_kind tdmf_model_in_lanes(const tdmf_model_kind *model);

/* The model's entry. */
const tdmf_page_entry *tdmf_entry_of(const tdmf_page *page);

/* The page on which a stride of a map runs: the plain one where it has all that acts and all that varies. */
const tdmf_page_part *tdmf_part_for_stride(const tdmf_page_map *map);

/* Size of the memory for a stride of a map, in numbers. A run in a batch needs no working memory of its own.
 */
size_t tdmf_stride_memory_size(const tdmf_page_map *map, bool is_in_batch);

/* A stride of a map from a point of its section, as a run on a part in memory. */
tdmf_page_run tdmf_begin_page_stride(const tdmf_page_map *map, const tdmf_page_part *part,
                                     const double *point, bool varies, double *memory);

/* The number, from 1, of the requirement that the start of a run does not meet; 0 where all are met. */
int tdmf_unmet_requirement(const tdmf_page *page, const tdmf_page_run *r);

/* Writes the states of a stride on a part and, unless `d_states` is NULL, their variations: a row for each.
 */
void tdmf_read_page_stride(const tdmf_page_map *map, const tdmf_page_part *part, const tdmf_page_run *r,
                           double *states, double *d_states);

/* Result of a stride on a part. Writes the map's events. A run that ends at the section has crossed it. */
tdmf_page_end tdmf_end_of_page_stride(const tdmf_page_map *map, const tdmf_page_part *part,
                                      const tdmf_page_run *r, tdmf_run_outcome outcome);

#endif
