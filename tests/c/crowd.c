#include "crowd.h"

#include "compare.h"
#include "reference_gaits.h"
#include "simulation.h"

#include <stddef.h>
#include <string.h>

crowd *make_crowd(int count, int max_strides, double relative_tolerance) {
    crowd *made = allocate(1, sizeof *made);
    const tdmf_parameters parameters = tdmf_default_parameters();
    const tdmf_inputs inputs = tdmf_default_inputs();
    made->count = count;
    made->models = allocate(count, sizeof *made->models);
    made->cases = allocate(count, sizeof *made->cases);
    made->case_of = allocate(count, sizeof *made->case_of);
    made->starts = allocate(count, sizeof *made->starts);
    made->ends = allocate(count, sizeof *made->ends);
    for (int i = 0; i < count; ++i) {
        made->case_of[i] = i;
        made->cases[i].model = &made->models[i];
        made->cases[i].rules.max_strides = max_strides;
        place_runner(made, i, &parameters, &inputs, (const double *)&reference_gaits[DEFAULT_GAIT].apex);
    }
    made->ensemble = (tdmf_ensemble){.cases = made->cases,
                                     .case_count = count,
                                     .case_of = made->case_of,
                                     .starts = (const double(*)[TDMF_POINT_LIMIT])made->starts,
                                     .count = count,
                                     .relative_tolerance = relative_tolerance,
                                     .threads = 1};
    return made;
}

void place_runner(crowd *crowd, int number, const tdmf_parameters *parameters, const tdmf_inputs *inputs,
                  const double section[TDMF_SECTION_COUNT]) {
    crowd->models[number] = accepted_model(parameters);
    crowd->cases[number].inputs = *inputs;
    memcpy(crowd->starts[number], section, TDMF_SECTION_COUNT * sizeof *section);
}

tdmf_ensemble_case *share_case(crowd *crowd) {
    crowd->ensemble.case_of = NULL;
    crowd->ensemble.case_count = 1;
    return crowd->cases;
}

void note_strides(crowd *crowd, int count) {
    crowd->strides = allocate(crowd->count * count, sizeof *crowd->strides);
    crowd->checkpoints = allocate(crowd->count, sizeof *crowd->checkpoints);
    crowd->ensemble.strides = crowd->strides;
    crowd->ensemble.stride_count = count;
    crowd->ensemble.checkpoints = crowd->checkpoints;
}

/* Clears the bytes behind an int, up to the next field. */
static void clear_gap(int *field, size_t until) {
    memset((char *)field + sizeof *field, 0, until - sizeof *field);
}

/* Clears what no field fills: strides are compared as memory, and some compilers copy that, too. */
static void clear_gaps(tdmf_ensemble_stride *record) {
    clear_gap(&record->began, offsetof(tdmf_ensemble_stride, apex));
    clear_gap(&record->stride.count, offsetof(tdmf_stride, period));
    clear_gap(&record->stride.touchdowns,
              offsetof(tdmf_stride, stance_time) - offsetof(tdmf_stride, touchdowns));
}

void run_crowd(crowd *crowd, tdmf_instructions instructions) {
    crowd->ensemble.instructions = instructions;
    assert_null(tdmf_run_ensemble(&crowd->ensemble, crowd->ends, NULL).variable);
    for (int i = 0; crowd->strides && i < crowd->count * crowd->ensemble.stride_count; ++i) {
        clear_gaps(&crowd->strides[i]);
    }
}

void assert_crowd_is_refused(crowd *crowd) {
    const tdmf_ensemble_end before = crowd->ends[0];
    assert_non_null(tdmf_run_ensemble(&crowd->ensemble, crowd->ends, NULL).variable);
    assert_memory_equal(&crowd->ends[0], &before, sizeof before);
}

tdmf_instructions next_instructions(tdmf_instructions set) {
    do {
        set = (tdmf_instructions)(set + 1);
    } while (set < TDMF_INSTRUCTIONS_COUNT && !tdmf_has_instructions(set));
    return set;
}
