/* The choice of a page, and the motions of each page for 2, 4 and 8 lanes. */
#include "runner_pages.h"

#include "page_map.h"

#include <string.h>

tdmf_motions_of_width tdmf_plain_runner_motions_of_2, tdmf_plain_runner_motions_of_4,
    tdmf_plain_runner_motions_of_8, tdmf_reduced_runner_motions_of_2, tdmf_reduced_runner_motions_of_4,
    tdmf_reduced_runner_motions_of_8, tdmf_plain_reduced_runner_motions_of_2,
    tdmf_plain_reduced_runner_motions_of_4, tdmf_plain_reduced_runner_motions_of_8;

/* NULL: this build has no motions of that width. */
#define LANES_OF(page)                                                                                       \
    {                                                                                                        \
        TDMF_TWO_LANES(page##_motions_of_2), TDMF_FOUR_LANES(page##_motions_of_4),                           \
            TDMF_EIGHT_LANES(page##_motions_of_8)                                                            \
    }

static const struct {
    const tdmf_page_part *page;
    tdmf_motions_of_width *lanes[3];
} pages[] = {
    {&tdmf_whole_page, LANES_OF(tdmf_runner)},
    {&tdmf_plain_runner_part, LANES_OF(tdmf_plain_runner)},
    {&tdmf_reduced_runner_part, LANES_OF(tdmf_reduced_runner)},
    {&tdmf_plain_reduced_runner_part, LANES_OF(tdmf_plain_reduced_runner)},
};

const tdmf_page_part *tdmf_page_for(tdmf_apex_map map, bool is_plain) {
    if (map == TDMF_REDUCED_MAP) {
        return is_plain ? &tdmf_plain_reduced_runner_part : &tdmf_reduced_runner_part;
    }
    return is_plain ? &tdmf_plain_runner_part : &tdmf_whole_page;
}

tdmf_model_kind tdmf_model_in_lanes(const tdmf_model_kind *model) {
    tdmf_model_kind wide = *model;
    for (size_t i = 0; i < sizeof pages / sizeof *pages; ++i) {
        if (pages[i].page->model == model) {
            memcpy(wide.lanes, pages[i].lanes, sizeof wide.lanes);
        }
    }
    return wide;
}
