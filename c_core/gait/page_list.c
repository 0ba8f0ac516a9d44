/* The models that this library has as pages. */
#include "page_map.h"

extern const tdmf_model_kind tdmf_classic_slip_model, tdmf_reduced_runner_model, tdmf_runner_model;

const tdmf_page_entry tdmf_pages[] = {
    {"classic_slip", &tdmf_classic_slip_model, NULL, 0},
    {"reduced_runner", &tdmf_reduced_runner_model, NULL, 0},
    {"runner", &tdmf_runner_model, NULL, 0},
};
const char *const tdmf_build_identity = "package";
const int tdmf_page_count = sizeof tdmf_pages / sizeof *tdmf_pages;
