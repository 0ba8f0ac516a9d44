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

tdmf_ensemble_end *ends_of(crowd *crowd, tdmf_instructions instructions) {
    tdmf_ensemble_end *ends = allocate(crowd->count, sizeof *ends);
    run_crowd(crowd, instructions);
    memcpy(ends, crowd->ends, (size_t)crowd->count * sizeof *ends);
    return ends;
}

const tdmf_ensemble_end *assert_independent_runners(crowd *crowd, int step) {
    const tdmf_ensemble_end *together = ends_of(crowd, TDMF_BEST_INSTRUCTIONS);
    for (int threads = 2; threads <= 7; threads += 5) {
        crowd->ensemble.threads = threads;
        run_crowd(crowd, TDMF_BEST_INSTRUCTIONS);
        assert_memory_equal(crowd->ends, together, (size_t)crowd->count * sizeof *together);
    }
    tdmf_ensemble one = crowd->ensemble;
    one.count = 1;
    for (int i = 0; i < crowd->count; i += step) {
        tdmf_ensemble_end alone;
        one.starts = &crowd->ensemble.starts[i];
        one.case_of = &crowd->case_of[i];
        assert_null(tdmf_run_ensemble(&one, &alone, NULL).variable);
        assert_memory_equal(&alone, &together[i], sizeof alone);
    }
    return together;
}

void stride_by_hand(const crowd *crowd, int number, set_at_apex *set, void *context,
                    strides_by_hand *by_hand) {
    const tdmf_ensemble_rules *rules = &crowd->cases[0].rules;
    tdmf_solver solver = solver_to(crowd->ensemble.relative_tolerance);
    tdmf_inputs inputs = crowd->cases[0].inputs;
    tdmf_model model = crowd->models[0];
    tdmf_parameters parameters = model.parameters;
    const tdmf_system system = {&model, &inputs};
    tdmf_motion motion = {.time = 0.0};
    double apex[TDMF_SECTION_COUNT];
    memset(by_hand, 0, sizeof *by_hand);
    memcpy(apex, crowd->starts[number], sizeof apex);
    for (int stride = 0; stride < rules->max_strides; ++stride) {
        if (set != NULL) {
            set(context, number, stride, apex, &parameters, &inputs);
            model = accepted_model(&parameters);
        }
        if (stride == 0) {
            tdmf_section_state(system, apex, motion.state);
            assert_null(tdmf_start(system, &motion).variable);
        }
        inputs.ground.height +=
            rules->roughness * tdmf_ground_step(rules->seed, (uint64_t)number, (uint32_t)stride);
        by_hand->heights[stride] = inputs.ground.height;
        by_hand->begun = stride + 1;
        tdmf_resolve(system, &motion);
        const bool waits = motion.mode.ground.height != inputs.ground.height;
        by_hand->waited += waits;
        if (!tdmf_native_stride(&solver, system, motion.time + 1e4, &motion).closed) {
            return;
        }
        by_hand->motions[stride] = motion;
        by_hand->closed = stride + 1;
        read_apex(&motion, apex);
        if (motion.mode.ground.height != inputs.ground.height ||
            motion.mode.ground.slope != inputs.ground.slope) {
            return;
        }
        by_hand->passed += waits;
    }
}

void assert_strides_by_hand(const crowd *crowd, int number, const strides_by_hand *by_hand) {
    const tdmf_ensemble_end *end = &crowd->ends[number];
    for (int stride = 0; stride < by_hand->begun; ++stride) {
        const tdmf_ensemble_stride *noted = &crowd->strides[number * crowd->ensemble.stride_count + stride];
        assert_close(noted->ground_height, by_hand->heights[stride], 1e-12);
        if (stride < by_hand->closed) {
            const tdmf_motion *motion = &by_hand->motions[stride];
            double apex[TDMF_SECTION_COUNT];
            read_apex(motion, apex);
            assert_all_close(noted->apex, apex, TDMF_SECTION_COUNT, 1e-7, 0.0);
            assert_same_stride(noted->stride, last_stride_of(motion), 1e-7);
            assert_close(noted->liftoff_angle, motion->state[TDMF_HIP_LIFTOFF_ANGLE], 1e-7);
        }
    }
    assert_int_equal(end->strides, by_hand->closed);
    assert_int_equal(end->fate, by_hand->closed == crowd->cases[0].rules.max_strides ? TDMF_FATE_UNDECIDED
                                                                                     : TDMF_FATE_FELL);
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
