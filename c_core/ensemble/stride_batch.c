/* Batches of strides: runs of the return map, or of the reduced map, in lanes. */
#include "tdmf_slip/ensemble.h"

#include "batch.h"
#include "page_map.h"
#include "reduced_stride.h"
#include "refusal.h"
#include "runner_pages.h"

#include <limits.h>
#include <stdlib.h>

enum { STRIDES_AT_ONCE = 512 };

/* Steps that a stride of the return map may take in a lane. One that takes more is made alone, by all rules
 * of the solver. */
static const long most_steps = 2000;

typedef struct {
    const tdmf_stride_batch *batch;
    tdmf_solver solver;
    tdmf_stride_request requests[STRIDES_AT_ONCE];
    union {
        tdmf_mapped_stride *mapped;
        tdmf_reduced_stride *reduced;
    } strides;
    bool is_begun[STRIDES_AT_ONCE];
    /* Runs of the strides on one page, and the places of these strides in the arrays above. */
    tdmf_page_run runs[STRIDES_AT_ONCE];
    double until[STRIDES_AT_ONCE];
    tdmf_run_outcome outcomes[STRIDES_AT_ONCE];
    int numbers[STRIDES_AT_ONCE];
} stride_part;

static tdmf_stride_request request_of(const tdmf_stride_batch *batch, tdmf_solver *solver, int64_t number) {
    const tdmf_stride_request request = {.solver = solver,
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

static bool is_reduced(const stride_part *part) {
    return part->batch->map == TDMF_REDUCED_MAP;
}

/* Copies the run of a stride into the batch of its page. */
static void begin_run(stride_part *part, int own, int place) {
    tdmf_page_run *run = &part->runs[place];
    part->numbers[place] = own;
    if (is_reduced(part)) {
        *run = part->strides.reduced[own].run;
        part->until[place] = part->strides.reduced[own].end;
    } else {
        *run = part->strides.mapped[own].solver.run.run;
        run->stop_event = tdmf_event_on_part(part->strides.mapped[own].solver.run.page, EVENT_apex);
        run->step_limit = most_steps;
        part->until[place] = tdmf_longest_of(&part->requests[own]);
    }
}

/* The next part of a stride of the reduced map. */
static tdmf_continuation at_end(void *context, int64_t place, tdmf_page_run *run, tdmf_run_outcome outcome) {
    stride_part *part = context;
    tdmf_reduced_stride *s = &part->strides.reduced[part->numbers[place]];
    s->run = *run;
    if (!tdmf_reduced_stride_goes_on(s, outcome)) {
        return TDMF_IS_OVER;
    }
    *run = s->run;
    part->until[place] = s->end;
    return TDMF_GOES_ON_UNCHANGED;
}

/* Writes a stride. One of the return map that has not come to its apex is made once more, alone. */
static void end_run(stride_part *part, int place, tdmf_return *results) {
    const int own = part->numbers[place];
    const tdmf_page_run *run = &part->runs[place];
    if (is_reduced(part)) {
        tdmf_close_reduced_stride(&part->strides.reduced[own], &results[own]);
    } else if (part->outcomes[place] == TDMF_RUN_STOPPED && (run->taken >> run->stop_event & 1) != 0) {
        part->strides.mapped[own].solver.run.run = *run;
        tdmf_close_mapped_stride(&part->strides.mapped[own], &results[own]);
    } else {
        tdmf_run_stride(&part->requests[own], &results[own]);
    }
}

static const tdmf_page_part *page_of(const stride_part *part, int own) {
    return is_reduced(part) ? part->strides.reduced[own].page : part->strides.mapped[own].solver.run.page;
}

/* Runs the strides of a part that were begun on a page. */
static bool run_on_page(stride_part *part, const tdmf_page_part *page, int count, tdmf_return *results) {
    const tdmf_model_kind model = tdmf_model_in_lanes(page->model);
    tdmf_batch kernel = tdmf_batch_default();
    for (int own = 0; own < count; ++own) {
        if (part->is_begun[own] && page_of(part, own) == page) {
            begin_run(part, own, (int)kernel.count++);
        }
    }
    kernel.runs = part->runs;
    kernel.until = part->until;
    kernel.outcomes = part->outcomes;
    kernel.at_end = is_reduced(part) ? at_end : NULL;
    kernel.context = part;
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
    for (int own = 0; own < count; ++own) {
        part->requests[own] = request_of(part->batch, &part->solver, first + own);
        part->is_begun[own] =
            is_reduced(part)
                ? tdmf_begin_reduced_stride(&part->strides.reduced[own], &part->requests[own], &results[own])
                : tdmf_begin_mapped_stride(&part->strides.mapped[own], &part->requests[own], &results[own]);
    }
    return run_on_page(part, tdmf_page_for(part->batch->map, true), count, results) &&
           run_on_page(part, tdmf_page_for(part->batch->map, false), count, results);
}

static bool run_parts(stride_part *part, tdmf_return *results) {
    const int64_t count = part->batch->count;
    bool is_made = true;
    for (int64_t first = 0; is_made && first < count; first += STRIDES_AT_ONCE) {
        const int64_t left = count - first;
        is_made =
            run_part(part, first, left < STRIDES_AT_ONCE ? (int)left : STRIDES_AT_ONCE, results + first);
    }
    return is_made;
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
    tdmf_solver own = *solver;
    own.log = NULL;
    own.on_event = NULL;
    if (batch->count == 1) { /* it needs no memory */
        const tdmf_stride_request request = request_of(batch, &own, 0);
        tdmf_run_stride(&request, results);
        return why;
    }
    const size_t most = batch->count < STRIDES_AT_ONCE ? (size_t)batch->count : STRIDES_AT_ONCE;
    const bool reduced = batch->map == TDMF_REDUCED_MAP;
    stride_part *part = malloc(sizeof *part);
    void *strides = malloc((most + 1) * (reduced ? sizeof(tdmf_reduced_stride) : sizeof(tdmf_mapped_stride)));
    bool is_made = part && strides;
    if (is_made) {
        part->batch = batch;
        part->solver = own;
        if (reduced) {
            part->strides.reduced = strides;
        } else {
            part->strides.mapped = strides;
        }
        is_made = run_parts(part, results);
    }
    free(strides);
    free(part);
    tdmf_accepts_if(&why, is_made, TDMF_UNAVAILABLE, "memory", 0, "there is not enough");
    return why;
}
