/* Strides of the return map side by side: some hundred at a time, each in a lane of its page's batch. */
#include "batch.h"
#include "mapped_stride.h"
#include "refusal.h"
#include "runner_pages.h"
#include "tdmf_slip/ensemble.h"

#include <limits.h>
#include <stdlib.h>

enum { STRIDES_AT_ONCE = 512 };

/* Steps that a stride may take in a lane. One that takes more is made alone, by all rules of the solver. */
static const long most_steps = 2000;

typedef struct {
    const tdmf_stride_batch *batch;
    tdmf_solver solver;
    tdmf_stride_request requests[STRIDES_AT_ONCE];
    tdmf_mapped_stride strides[STRIDES_AT_ONCE];
    /* Runs of the strides on one page, and the places of these strides in the arrays above. */
    tdmf_page_run runs[STRIDES_AT_ONCE];
    double until[STRIDES_AT_ONCE];
    tdmf_run_outcome outcomes[STRIDES_AT_ONCE];
    int numbers[STRIDES_AT_ONCE];
} stride_part;

static tdmf_stride_request request_of(stride_part *part, int64_t number) {
    const tdmf_stride_batch *batch = part->batch;
    const tdmf_stride_request request = {.solver = &part->solver,
                                         .system = batch->systems[number],
                                         .map = batch->map,
                                         .apex = batch->sections[number],
                                         .until = batch->until[number],
                                         .derivatives = batch->derivatives,
                                         .measures = batch->measures,
                                         .seeds = batch->seeds,
                                         .seed_count = batch->seed_count};
    return request;
}

/* Begins the run of a stride on its page. */
static void begin_run(stride_part *part, int own, int place) {
    const tdmf_runner_run *run = &part->strides[own].solver.run;
    part->runs[place] = run->run;
    part->runs[place].stop_event = tdmf_event_on_part(run->page, EVENT_apex);
    part->runs[place].step_limit = most_steps;
    part->until[place] = tdmf_longest_of(&part->requests[own]);
    part->numbers[place] = own;
}

/* Writes a stride that has come to its apex. Any other is made once more, alone. */
static void end_run(stride_part *part, int place, tdmf_return *results) {
    const int own = part->numbers[place];
    const tdmf_page_run *run = &part->runs[place];
    if (part->outcomes[place] == TDMF_RUN_STOPPED && (run->taken >> run->stop_event & 1) != 0) {
        part->strides[own].solver.run.run = *run;
        tdmf_close_mapped_stride(&part->strides[own], &results[own]);
    } else {
        tdmf_run_stride(&part->requests[own], &results[own]);
    }
}

/* Runs the strides of a part that were begun on a page. */
static bool run_on_page(stride_part *part, const tdmf_page_part *page, const bool *is_begun, int count,
                        tdmf_return *results) {
    const tdmf_model_kind model = tdmf_model_in_lanes(page);
    tdmf_batch kernel = tdmf_batch_default();
    for (int own = 0; own < count; ++own) {
        if (is_begun[own] && part->strides[own].solver.run.page == page) {
            begin_run(part, own, (int)kernel.count++);
        }
    }
    kernel.runs = part->runs;
    kernel.until = part->until;
    kernel.outcomes = part->outcomes;
    kernel.threads = part->batch->threads;
    if (kernel.count > 0 && !tdmf_run_batch(&model, &kernel, NULL)) {
        return false;
    }
    for (int place = 0; place < kernel.count; ++place) {
        end_run(part, place, results);
    }
    return true;
}

static bool run_part(stride_part *part, int64_t first, int count, tdmf_return *results) {
    bool is_begun[STRIDES_AT_ONCE];
    for (int own = 0; own < count; ++own) {
        part->requests[own] = request_of(part, first + own);
        if (part->batch->map == TDMF_REDUCED_MAP) { /* one by one */
            is_begun[own] = false;
            tdmf_run_stride(&part->requests[own], &results[own]);
        } else {
            is_begun[own] =
                tdmf_begin_mapped_stride(&part->strides[own], &part->requests[own], &results[own]);
        }
    }
    return run_on_page(part, &tdmf_plain_runner_part, is_begun, count, results) &&
           run_on_page(part, &tdmf_whole_page, is_begun, count, results);
}

static bool is_sound_batch(tdmf_refusal *why, const tdmf_solver *solver, const tdmf_stride_batch *batch,
                           const tdmf_return *results) {
    return tdmf_accepts_pointer(why, "solver", solver) && tdmf_accepts_pointer(why, "batch", batch) &&
           tdmf_accepts_array(why, "systems", batch->systems, "count", batch->count, INT64_MAX) &&
           tdmf_accepts_number(why, "threads", "1", batch->threads, 1.0, INT_MAX) &&
           (batch->count == 0 || (tdmf_accepts_pointer(why, "sections", batch->sections) &&
                                  tdmf_accepts_pointer(why, "until", batch->until) &&
                                  tdmf_accepts_pointer(why, "results", results)));
}

tdmf_refusal tdmf_run_strides(const tdmf_solver *solver, const tdmf_stride_batch *batch,
                              tdmf_return *results) {
    tdmf_refusal why = {.code = TDMF_ACCEPTED};
    if (!is_sound_batch(&why, solver, batch, results)) {
        return why;
    }
    stride_part *part = malloc(sizeof *part);
    bool is_made = part != NULL;
    if (is_made) {
        part->batch = batch;
        part->solver = *solver;
        part->solver.log = NULL;
        part->solver.on_event = NULL;
    }
    for (int64_t first = 0; is_made && first < batch->count; first += STRIDES_AT_ONCE) {
        const int64_t left = batch->count - first;
        is_made =
            run_part(part, first, left < STRIDES_AT_ONCE ? (int)left : STRIDES_AT_ONCE, results + first);
    }
    free(part);
    tdmf_accepts_if(&why, is_made, TDMF_UNAVAILABLE, "memory", 0, "there is not enough");
    return why;
}
