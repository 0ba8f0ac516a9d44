/* This file stands in for page_cvode.c where SUNDIALS is missing. */
#include "page_cvode.h"

bool tdmf_page_cvode_is_available(void) {
    return false;
}

tdmf_run_outcome tdmf_cvode_to_event(const tdmf_model_kind *model, tdmf_page_run *run, unsigned char *watch,
                                     double until, int64_t *evaluations) {
    (void)model;
    (void)run;
    (void)watch;
    (void)until;
    (void)evaluations;
    return TDMF_RUN_NO_PROGRESS;
}
