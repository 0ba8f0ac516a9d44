/* Chooses instructions, shares the starts out among threads, and runs one by one where there are no lanes. */
#include "tdmf_slip/ensemble.h"

#include "batches.h"
#include "processor.h"
#include "request_checks.h"
#include "step.h"
#include "threads.h"

#include <stdlib.h>

struct tdmf_starts {
    int64_t next, count;
    const int *stop;
};

int64_t tdmf_next_start(tdmf_starts *starts) {
    if (tdmf_is_raised(starts->stop)) {
        return -1;
    }
    const int64_t number = tdmf_take_number(&starts->next);
    return number < starts->count ? number : -1;
}

/* ---- instructions ------------------------------------------------------------------------------------- */

static tdmf_run_batches run_one_by_one;

/* What this build has; NULL where it has not. */
static tdmf_run_batches *const runs[TDMF_INSTRUCTIONS_COUNT] = {
    [TDMF_ONE_BY_ONE] = run_one_by_one,
#ifdef TDMF_HAS_TWO_LANES
    [TDMF_TWO_LANES] = tdmf_run_two_lanes,
#endif
#ifdef TDMF_HAS_AVX2
    [TDMF_AVX2] = tdmf_run_avx2,
#endif
#ifdef TDMF_HAS_AVX512
    [TDMF_AVX512] = tdmf_run_avx512,
#endif
};

static bool processor_has(int instructions) {
    return (instructions != TDMF_AVX2 || tdmf_processor_has_avx2()) &&
           (instructions != TDMF_AVX512 || tdmf_processor_has_avx512());
}

bool tdmf_has_instructions(tdmf_instructions instructions) {
    const int number = (int)instructions;
    return number == TDMF_BEST_INSTRUCTIONS ||
           (number > 0 && number < TDMF_INSTRUCTIONS_COUNT && runs[number] && processor_has(number));
}

tdmf_instructions tdmf_best_instructions(void) {
    int best = TDMF_INSTRUCTIONS_COUNT - 1;
    while (!tdmf_has_instructions((tdmf_instructions)best)) {
        --best;
    }
    return (tdmf_instructions)best;
}

const char *tdmf_instructions_name(tdmf_instructions instructions) {
    static const char *const names[TDMF_INSTRUCTIONS_COUNT] = {"best", "one by one", "two lanes", "avx2",
                                                               "avx512"};
    const int number = (int)instructions;
    return number >= 0 && number < TDMF_INSTRUCTIONS_COUNT ? names[number] : "unknown";
}

/* ---- one by one --------------------------------------------------------------------------------------- */

static bool run_one_by_one(const tdmf_ensemble *ensemble, tdmf_starts *starts, series_orders orders,
                           tdmf_ensemble_end *ends, tdmf_ensemble_work *work) {
    tdmf_solver solver = tdmf_solver_default();
    const tdmf_ensemble_work none = {0};
    (void)orders;
    *work = none;
    solver.relative_tolerance = ensemble->relative_tolerance;
    solver.without_peaks_and_positive_work = !tdmf_records_strides(ensemble);
    for (int64_t i = tdmf_next_start(starts); i >= 0; i = tdmf_next_start(starts)) {
        tdmf_runner runner;
        bool goes_on = tdmf_runner_begin(&runner, ensemble, i, &ends[i]);
        while (goes_on) {
            goes_on = tdmf_runner_stride(&runner, &solver);
        }
        work->strides += ends[i].strides;
    }
    work->steps = work->lane_steps = solver.steps;
    work->events = solver.events;
    work->evaluations = solver.evaluations;
    work->layer_steps = solver.layer_steps;
    return true;
}

/* ---- all ---------------------------------------------------------------------------------------------- */

typedef struct {
    const tdmf_ensemble *ensemble;
    tdmf_run_batches *integration;
    tdmf_starts starts;
    series_orders orders;
    tdmf_ensemble_end *ends;
    tdmf_ensemble_work *works; /* of each thread */
} everything;

static void run_share(void *shared, int number) {
    everything *all = shared;
    const tdmf_ensemble *ensemble = all->ensemble;
    /* Without memory for lanes the starts are left to whoever has some. */
    if (!all->integration(ensemble, &all->starts, all->orders, all->ends, &all->works[number]) &&
        number == 0) {
        run_one_by_one(ensemble, &all->starts, all->orders, all->ends, &all->works[number]);
    }
}

static void add_work(tdmf_ensemble_work *sum, const tdmf_ensemble_work *part) {
    sum->strides += part->strides;
    sum->events += part->events;
    sum->steps += part->steps;
    sum->lane_steps += part->lane_steps;
    sum->evaluations += part->evaluations;
    sum->layer_steps += part->layer_steps;
}

bool tdmf_run_ensemble(const tdmf_ensemble *ensemble, tdmf_ensemble_end *ends, tdmf_ensemble_work *work) {
    if (!tdmf_is_sound_ensemble(ensemble, ends)) {
        return false;
    }
    /* No more threads than runners, and one if there are none. */
    const int threads = ensemble->threads <= ensemble->count ? ensemble->threads
                        : ensemble->count > 0                ? (int)ensemble->count
                                                             : 1;
    everything all = {
        .ensemble = ensemble,
        .integration = runs[ensemble->instructions == TDMF_BEST_INSTRUCTIONS ? tdmf_best_instructions()
                                                                             : ensemble->instructions],
        .starts = {0, ensemble->count, ensemble->stop},
        .orders = tdmf_step_orders(ensemble->relative_tolerance),
        .ends = ends,
        .works = calloc((size_t)threads, sizeof *all.works),
    };
    if (all.works == NULL) {
        return false;
    }
    tdmf_run_in_threads(run_share, &all, threads);
    if (work) {
        const tdmf_ensemble_work none = {0};
        *work = none;
        for (int i = 0; i < threads; ++i) {
            add_work(work, &all.works[i]);
        }
        work->begun = all.starts.next < ensemble->count ? all.starts.next : ensemble->count;
    }
    free(all.works);
    return true;
}
