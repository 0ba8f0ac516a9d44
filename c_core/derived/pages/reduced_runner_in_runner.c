/* ReducedRunner, a part of Runner. */
#include "runner.h"

#include "page_part.h"

extern const tdmf_model_kind tdmf_reduced_runner_model;
extern const tdmf_page_part tdmf_reduced_runner_part;

static const int modes[] = {0, -1, 3, 4, 1, 2, -1, -1, 6};
static const int parameters[] = {0, 1, 7, 8, 9, 10, 11, 12, 13, 14, 16, 17, 18, 19, 22, 24, 26, 27};
static const int states[] = {0, 1, 2, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24,
    25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 56, 57,
    58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 82, 83, 87,
    88, 89, 90, 92, 93, 94, 95, 96, 97, 103, 105};
static const int events[] = {3, 6, 7, 8, 10, 13, 14, 15, 16, 17, 18, 19, 20};
static const int copies[][2] = {{0}};

const tdmf_page_part tdmf_reduced_runner_part = {
    .model = &tdmf_reduced_runner_model, .parameters = parameters, .states = states, .events = events,
        .modes = modes,
    .copies = copies, .copy_count = 0, .excess = NULL,
};
