/* Strides of many runners on a page: runs from a section, some hundred at a time, as a batch of the kernel.
 */
#include "tdmf_slip/ensemble.h"

#include "batch.h"
#include "page_map.h"

#include <stdlib.h>
#include <string.h>

enum { RUNS_AT_ONCE = 512 };

/* Memory for the runs of a part of the batch. */
typedef struct {
    tdmf_page_run *runs;
    tdmf_run_outcome *outcomes;
    int64_t *numbers; /* numbers of the runs in the batch */
    double *until, *arrays;
    tdmf_event_row *rows;
} room;

static const tdmf_model_kind *model_of(const tdmf_page_batch *batch) {
    return (const tdmf_model_kind *)batch->map->page;
}

static bool open_room(const tdmf_page_batch *batch, size_t count, size_t size, room *of) {
    const size_t events = batch->map->events ? (size_t)batch->map->event_room : 0;
    *of = (room){malloc(count * sizeof *of->runs),          malloc(count * sizeof *of->outcomes),
                 malloc(count * sizeof *of->numbers),       malloc(count * sizeof *of->until),
                 malloc(count * size * sizeof *of->arrays), malloc((count * events + 1) * sizeof *of->rows)};
    return of->runs && of->outcomes && of->numbers && of->until && of->arrays && of->rows;
}

static void close_room(room *of) {
    free(of->runs);
    free(of->outcomes);
    free(of->numbers);
    free(of->until);
    free(of->arrays);
    free(of->rows);
}

/* The map of one of the runs. */
static tdmf_page_map map_of_run(const tdmf_page_batch *batch, int64_t number) {
    tdmf_page_map map = *batch->map;
    map.parameters += number * batch->parameters_of_each;
    map.states += number * batch->states_of_each;
    map.events = map.events ? map.events + number * map.event_room : NULL;
    return map;
}

/* Begins a run in memory. False if its numbers are refused, or its start by the page. */
static bool begin(const tdmf_page_batch *batch, int64_t number, const tdmf_page_part *part, double *arrays,
                  tdmf_page_run *r) {
    batch->ends[number] = (tdmf_page_end){.outcome = TDMF_PAGE_REFUSED};
    const tdmf_model_kind *model = model_of(batch);
    const tdmf_page_map map = map_of_run(batch, number);
    const double *point = batch->points + number * model->sections[map.section].count;
    if (!tdmf_is_page_point_sound(&model->sections[map.section], point) ||
        !tdmf_are_page_values_sound(model, map.parameters, map.states)) {
        return false;
    }
    *r = tdmf_begin_page_stride(&map, part, point, batch->d_states != NULL, arrays);
    batch->ends[number].requirement = tdmf_unmet_requirement(map.page, r);
    if (batch->ends[number].requirement != 0) {
        tdmf_read_page_stride(&map, part, r, batch->states + number * model->state_count, NULL);
    }
    return batch->ends[number].requirement == 0;
}

static void finish(const tdmf_page_batch *batch, int64_t number, const tdmf_page_part *part,
                   const tdmf_page_run *r, tdmf_run_outcome outcome) {
    const tdmf_model_kind *model = model_of(batch);
    const tdmf_page_map map = map_of_run(batch, number);
    const int64_t states = model->state_count, seeds = model->sections[map.section].count + map.seed_count;
    double *d_states = batch->d_states ? batch->d_states + number * seeds * states : NULL;
    tdmf_read_page_stride(&map, part, r, batch->states + number * states, d_states);
    batch->ends[number] = tdmf_end_of_page_stride(&map, part, r, outcome);
}

/* Makes the strides of a range that run on a part. Strides whose numbers are refused are left out. */
static bool run_on(const tdmf_page_part *part, const tdmf_page_batch *batch, int64_t first, int64_t count,
                   size_t size, room *of) {
    const tdmf_page_map *map = batch->map;
    int64_t begun = 0;
    for (int64_t number = first; number < first + count; ++number) {
        tdmf_page_run *r = &of->runs[begun];
        const tdmf_page_map own = map_of_run(batch, number);
        if (tdmf_part_for_stride(&own) != part ||
            !begin(batch, number, part, of->arrays + (size_t)begun * size, r)) {
            continue;
        }
        r->log = map->events ? of->rows + begun * map->event_room : NULL;
        r->log_size = map->events ? map->event_room : 0;
        of->until[begun] = map->longest;
        of->numbers[begun++] = number;
    }
    const tdmf_model_kind model = tdmf_model_in_lanes(part->model);
    tdmf_batch kernel = tdmf_batch_default();
    kernel.runs = of->runs;
    kernel.count = begun;
    kernel.until = of->until;
    kernel.outcomes = of->outcomes;
    kernel.cancel = batch->cancel;
    kernel.threads = batch->threads;
    if (!tdmf_run_batch(&model, &kernel, NULL)) {
        return false;
    }
    for (int64_t i = 0; i < begun; ++i) {
        finish(batch, of->numbers[i], part, &of->runs[i], of->outcomes[i]);
    }
    return true;
}

bool tdmf_page_strides(const tdmf_page_batch *batch) {
    tdmf_refusal why;
    if (!batch || !tdmf_is_page_map_sound(&why, batch->map) || batch->count < 0 || batch->threads < 1 ||
        (batch->count > 0 && (!batch->points || !batch->states || !batch->ends))) {
        return false;
    }
    const tdmf_page_map *map = batch->map;
    const size_t size = tdmf_stride_memory_size(map, true);
    const tdmf_page_entry *entry = tdmf_entry_of(map->page);
    const int64_t most = batch->count < RUNS_AT_ONCE ? batch->count : RUNS_AT_ONCE;
    room of;
    bool is_made = open_room(batch, (size_t)most + 1, size, &of);
    for (int64_t first = 0; is_made && first < batch->count; first += most) {
        const int64_t left = batch->count - first, count = left < most ? left : most;
        is_made = run_on(&entry->whole, batch, first, count, size, &of) &&
                  (!entry->plain || run_on(entry->plain, batch, first, count, size, &of));
    }
    close_room(&of);
    return is_made;
}
