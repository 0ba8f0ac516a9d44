/* Chooses the width of a batch, shares its runs out among threads, and makes runs one by one where there are
 * no lanes. */
#include "batch.h"

#include "processor.h"
#include "run_state.h"
#include "threads.h"

#include <stdlib.h>
#include <string.h>

enum { WIDTHS = 4 };

static tdmf_run_lanes run_one_by_one;

static const struct {
    int width;
    tdmf_run_lanes *run;
} widths[WIDTHS] = {
    {1, run_one_by_one},
    {2, TDMF_TWO_LANES(tdmf_run_lanes_2)},
    {4, TDMF_FOUR_LANES(tdmf_run_lanes_4)},
    {8, TDMF_EIGHT_LANES(tdmf_run_lanes_8)},
};

static bool has_width(const tdmf_model_kind *model, int i) {
    return i == 0 ||
           (widths[i].run && model->lanes[i - 1] && (widths[i].width != 4 || tdmf_processor_has_avx2()) &&
            (widths[i].width != 8 || tdmf_processor_has_avx512()));
}

/* The row of a width, or -1. Width 0 asks for the largest width whose lanes the runs fill to five eighths. */
static int row_of_width(const tdmf_model_kind *model, int width, int64_t runs) {
    for (int i = WIDTHS - 1; i >= 0; --i) {
        const bool suits = width == 0 ? i == 0 || 8 * runs > 5 * widths[i].width : width == widths[i].width;
        if (suits && has_width(model, i)) {
            return i;
        }
    }
    return -1;
}

bool tdmf_batch_has_width(const tdmf_model_kind *model, int width) {
    return row_of_width(model, width, 0) >= 0;
}

int64_t tdmf_next_run(tdmf_batch_share *share) {
    if (tdmf_is_raised(share->batch->cancel)) {
        return -1;
    }
    const int64_t number = tdmf_take_number(&share->next);
    return number < share->batch->count ? number : -1;
}

tdmf_continuation tdmf_go_on_from(const tdmf_batch *batch, int64_t number, tdmf_run_outcome outcome,
                                  double *memory) {
    tdmf_page_run *r = &batch->runs[number];
    double *own = r->memory;
    batch->outcomes[number] = outcome;
    if (!batch->at_end) {
        return TDMF_IS_OVER;
    }
    r->memory = memory;
    const tdmf_continuation next = batch->at_end(batch->context, number, r, outcome);
    r->memory = own;
    return next;
}

/* Runs to the next stop, in memory of the batch. */
static tdmf_run_outcome run_to_stop(const tdmf_batch_share *share, int64_t number, double *memory) {
    tdmf_page_run *r = &share->batch->runs[number];
    double *own = r->memory;
    r->memory = memory;
    const tdmf_run_outcome outcome = tdmf_page_run_to(share->model, r, share->batch->until[number]);
    r->memory = own;
    return outcome;
}

static bool run_one_by_one(tdmf_batch_share *share, tdmf_batch_work *work) {
    const tdmf_batch *batch = share->batch;
    double *memory = malloc(tdmf_run_memory_size(share->model, batch->runs[0].seed_count) * sizeof *memory);
    for (int64_t i = tdmf_next_run(share); i >= 0; i = tdmf_next_run(share)) {
        const long before = batch->runs[i].steps;
        bool goes_on = true;
        while (goes_on) {
            const tdmf_run_outcome outcome = memory ? run_to_stop(share, i, memory) : TDMF_RUN_NO_MEMORY;
            goes_on = tdmf_go_on_from(batch, i, outcome, memory) != TDMF_IS_OVER;
            if (goes_on && tdmf_is_raised(batch->cancel)) {
                batch->outcomes[i] = TDMF_RUN_CANCELLED;
                goes_on = false;
            }
        }
        work->single_steps += batch->runs[i].steps - before;
    }
    free(memory);
    return true;
}

typedef struct {
    tdmf_batch_share share;
    tdmf_run_lanes *run;
    tdmf_batch_work *works; /* one for each thread */
} job;

static void run_share(void *shared, int number) {
    job *all = shared;
    if (!all->run(&all->share, &all->works[number])) {
        run_one_by_one(&all->share, &all->works[number]);
    }
}

static bool is_sound(const tdmf_batch *batch) {
    for (int64_t i = 1; i < batch->count; ++i) {
        const tdmf_page_run *a = &batch->runs[0], *b = &batch->runs[i];
        if (a->order != b->order || a->tolerance != b->tolerance || a->seed_count != b->seed_count ||
            a->observes != b->observes) {
            return false;
        }
    }
    return batch->count >= 0 && batch->threads >= 1 &&
           (batch->count == 0 || tdmf_is_order(batch->runs[0].order));
}

tdmf_batch tdmf_batch_default(void) {
    const tdmf_batch batch = {.threads = 1};
    return batch;
}

bool tdmf_run_batch(const tdmf_model_kind *model, const tdmf_batch *batch, tdmf_batch_work *work) {
    const int threads = batch->threads <= batch->count ? batch->threads
                        : batch->count > 0             ? (int)batch->count
                                                       : 1;
    const int row = is_sound(batch) ? row_of_width(model, batch->width, batch->count / threads) : -1;
    if (row < 0 || batch->count == 0) {
        if (work) {
            memset(work, 0, sizeof *work);
        }
        return row >= 0;
    }
    job all = {.share = {model, batch, 0, threads},
               .run = widths[row].run,
               .works = calloc((size_t)threads, sizeof *all.works)};
    if (!all.works) {
        return false;
    }
    for (int64_t i = 0; i < batch->count; ++i) {
        batch->outcomes[i] = TDMF_RUN_CANCELLED; /* until it is run */
    }
    tdmf_run_in_threads(run_share, &all, threads);
    if (work) {
        memset(work, 0, sizeof *work);
        for (int i = 0; i < threads; ++i) {
            work->steps += all.works[i].steps;
            work->lane_steps += all.works[i].lane_steps;
            work->single_steps += all.works[i].single_steps;
        }
    }
    free(all.works);
    return true;
}
