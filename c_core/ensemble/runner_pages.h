/* The pages on which ensembles run, and their motions in lanes. */
#ifndef TDMF_ENSEMBLE_RUNNER_PAGES_H
#define TDMF_ENSEMBLE_RUNNER_PAGES_H

#include "page_places.h"
#include "tdmf_slip/ensemble.h"

/* The page for a map. `is_plain`: for runners that need no more than the plain page. */
const tdmf_page_part *tdmf_page_for(tdmf_apex_map map, bool is_plain);

#endif
