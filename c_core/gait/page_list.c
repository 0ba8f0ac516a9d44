/* The models that this library has as pages. */
#include "page_map.h"

extern const tdmf_model_kind tdmf_classic_slip_model, tdmf_reduced_runner_model, tdmf_runner_model;
extern const tdmf_page_part tdmf_plain_runner_part, tdmf_plain_reduced_runner_in_reduced_runner;

const tdmf_page_entry tdmf_pages[] = {
    {"classic_slip", {.model = &tdmf_classic_slip_model}, NULL, NULL, 0},
    {"reduced_runner",
     {.model = &tdmf_reduced_runner_model},
     &tdmf_plain_reduced_runner_in_reduced_runner,
     NULL,
     0},
    {"runner", {.model = &tdmf_runner_model}, &tdmf_plain_runner_part, NULL, 0},
};
const char *const tdmf_build_identity = "package";
const int tdmf_page_count = sizeof tdmf_pages / sizeof *tdmf_pages;
