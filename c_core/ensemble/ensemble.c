/* Chooses the number of lanes and the page of each runner, and puts runner after runner into the places of a
 * batch. */
#include "tdmf_slip/ensemble.h"

#include "batch.h"
#include "ground.h"
#include "page_map.h"
#include "request_checks.h"
#include "threads.h"

#include <stdlib.h>
#include <string.h>

/* ---- instructions ------------------------------------------------------------------------------------- */

/* Lanes of each instruction set; 0: as many as pay. */
static const int widths[TDMF_INSTRUCTIONS_COUNT] = {
    [TDMF_ONE_BY_ONE] = 1, [TDMF_TWO_LANES] = 2, [TDMF_AVX2] = 4, [TDMF_AVX512] = 8};

bool tdmf_can_step(const tdmf_ensemble *ensemble) {
    const int number = (int)ensemble->instructions;
    const tdmf_model_kind model = tdmf_kind_of(ensemble)->model(ensemble, false);
    return number >= 0 && number < TDMF_INSTRUCTIONS_COUNT && tdmf_batch_has_width(&model, widths[number]);
}

bool tdmf_has_instructions(tdmf_instructions instructions) {
    const tdmf_ensemble any = {.page = tdmf_runner_kind ? NULL : (const tdmf_page *)tdmf_pages[0].whole.model,
                               .instructions = instructions};
    return tdmf_can_step(&any);
}

const char *tdmf_instructions_name(tdmf_instructions instructions) {
    static const char *const names[TDMF_INSTRUCTIONS_COUNT] = {"best", "one by one", "two lanes", "avx2",
                                                               "avx512"};
    const int number = (int)instructions;
    return number >= 0 && number < TDMF_INSTRUCTIONS_COUNT ? names[number] : "unknown";
}

/* ---- runners ------------------------------------------------------------------------------------------- */

/* The runners of one page; `is_plain` says of each runner of the ensemble whether the plain page suits it. */
typedef struct {
    const tdmf_ensemble *ensemble;
    tdmf_ensemble_end *ends;
    const bool *is_plain;
    bool takes_plain;
    int64_t next; /* start */
    tdmf_member *members;
} page_job;

/* Begins the next runner that has something to run. False where there is none. */
static bool begin_next(page_job *job, tdmf_member *member) {
    while (!tdmf_is_raised(job->ensemble->stop)) {
        const int64_t index = tdmf_take_number(&job->next);
        if (index >= job->ensemble->count) {
            return false;
        }
        if (job->is_plain[index] == job->takes_plain && tdmf_member_begin(member, index, &job->ends[index])) {
            return true;
        }
    }
    return false;
}

static tdmf_continuation at_end(void *context, int64_t number, tdmf_page_run *run, tdmf_run_outcome outcome) {
    page_job *job = context;
    tdmf_member *member = &job->members[number];
    (void)run;
    if (tdmf_member_goes_on(member, outcome)) {
        return tdmf_member_changes(member) ? TDMF_GOES_ON_CHANGED : TDMF_GOES_ON_UNCHANGED;
    }
    return begin_next(job, member) ? TDMF_GOES_ON_CHANGED : TDMF_IS_OVER;
}

/* Memory of a batch, in one piece; `numbers` holds parameters and states of each run, and states held. */
typedef struct {
    tdmf_page_run *runs;
    tdmf_member *members;
    tdmf_event_row *rows; /* `events` of each run */
    tdmf_run_outcome *outcomes;
    double *until, *numbers;
    int events;
} batch_memory;

static bool find_memory(batch_memory *memory, int64_t count, int number_count,
                        const tdmf_ensemble_notes *notes) {
    const size_t places = (size_t)count;
    const size_t numbers = places * (size_t)(number_count + 1) * sizeof(double);
    memory->events = notes ? notes->event_room : 0;
    if ((size_t)memory->events > SIZE_MAX / 2 / sizeof *memory->rows / places) {
        return false;
    }
    const size_t events = places * (size_t)memory->events;
    char *all =
        calloc(1, numbers + events * sizeof *memory->rows +
                      places * (sizeof *memory->runs + sizeof *memory->members + sizeof *memory->outcomes));
    memory->until = (double *)(void *)all;
    if (!all) {
        return false;
    }
    memory->numbers = memory->until + count;
    memory->runs = (tdmf_page_run *)(void *)(all + numbers);
    memory->members = (tdmf_member *)(void *)(memory->runs + count);
    memory->rows = (tdmf_event_row *)(void *)(memory->members + count);
    memory->outcomes = (tdmf_run_outcome *)(void *)(memory->rows + events);
    return true;
}

/* Begins the first runners, one in each place. Returns how many there are. */
static int64_t begin_first(page_job *job, const tdmf_model_kind *model, const batch_memory *memory,
                           int64_t places) {
    const tdmf_ensemble *ensemble = job->ensemble;
    const tdmf_page_run run = {.tolerance = ensemble->relative_tolerance,
                               .order = tdmf_page_order(ensemble->relative_tolerance),
                               .observes = ensemble->strides ? TDMF_OBSERVE_USUAL : TDMF_OBSERVE_NOTHING,
                               .event_limit = TDMF_EVENT_LIMIT};
    tdmf_member member = {.ensemble = ensemble, .kind = tdmf_kind_of(ensemble), .model = model};
    member.kind->settle_in(&member, job->takes_plain);
    member.ground = tdmf_places_of_ground(member.page.model);
    for (int64_t i = 0; i < places; ++i) {
        tdmf_page_run *own = &memory->runs[i];
        *own = run;
        own->p = memory->numbers + i * (model->parameter_count + 2 * model->state_count);
        own->x = own->p + model->parameter_count;
        own->log = memory->rows + i * memory->events;
        own->log_size = memory->events;
        memory->members[i] = member;
        memory->members[i].run = own;
        memory->members[i].held = own->x + model->state_count;
        memory->members[i].until = &memory->until[i];
        if (!begin_next(job, &memory->members[i])) {
            return i;
        }
    }
    return places;
}

static void add_work(const page_job *job, int64_t places, const tdmf_batch_work *made, int order,
                     tdmf_ensemble_work *work) {
    const int64_t steps = made->steps + made->single_steps;
    work->steps += steps;
    work->lane_steps += made->lane_steps + made->single_steps;
    work->evaluations += order * steps;
    for (int64_t i = 0; i < places; ++i) {
        work->strides += job->members[i].strides;
        work->events += job->members[i].events;
        work->layer_steps += job->members[i].run->limited_steps;
    }
}

/* Runs the runners of one page. */
static bool run_on_page(page_job *job, int64_t count, tdmf_ensemble_work *work) {
    const tdmf_ensemble *ensemble = job->ensemble;
    const tdmf_model_kind model = tdmf_kind_of(ensemble)->model(ensemble, job->takes_plain);
    const int width = widths[ensemble->instructions];
    const int64_t most = (int64_t)ensemble->threads * TDMF_RUNS_OF_A_LANE * (width == 0 ? 8 : width);
    const int64_t places = count < most ? count : most;
    batch_memory memory;
    tdmf_batch_work made = {0};
    if (!find_memory(&memory, places, model.parameter_count + 2 * model.state_count, ensemble->notes)) {
        return false;
    }
    job->members = memory.members;
    tdmf_batch batch = {.runs = memory.runs,
                        .count = begin_first(job, &model, &memory, places),
                        .until = memory.until,
                        .outcomes = memory.outcomes,
                        .at_end = at_end,
                        .context = job,
                        .width = width,
                        .threads = ensemble->threads};
    const bool is_done = tdmf_run_batch(&model, &batch, &made);
    add_work(job, batch.count, &made, tdmf_page_order(ensemble->relative_tolerance), work);
    free(memory.until);
    return is_done;
}

static int64_t smaller(int64_t a, int64_t b) {
    return a < b ? a : b;
}

tdmf_refusal tdmf_run_ensemble(const tdmf_ensemble *ensemble, tdmf_ensemble_end *ends,
                               tdmf_ensemble_work *work) {
    tdmf_refusal why = {.code = TDMF_ACCEPTED};
    const tdmf_ensemble_work none = {0};
    tdmf_ensemble_work sum = none;
    int64_t of_page[2] = {0, 0};
    if (!tdmf_is_sound_ensemble(&why, ensemble, ends)) {
        return why;
    }
    const int64_t count = ensemble->count;
    bool *is_plain = calloc((size_t)count + 1, sizeof *is_plain);
    bool is_done = is_plain != NULL;
    for (int64_t i = 0; is_done && i < count; ++i) {
        is_plain[i] = tdmf_kind_of(ensemble)->is_plain(ensemble, i);
        ++of_page[is_plain[i]];
    }
    page_job jobs[2] = {{ensemble, ends, is_plain, false, 0, NULL},
                        {ensemble, ends, is_plain, true, 0, NULL}};
    for (int i = 0; i < 2; ++i) {
        is_done = is_done && (of_page[i] == 0 || run_on_page(&jobs[i], of_page[i], &sum));
        sum.begun = jobs[i].next > sum.begun ? jobs[i].next : sum.begun;
    }
    sum.begun = smaller(sum.begun, count);
    for (int64_t i = 0; is_done && i < sum.begun; ++i) { /* where the run was stopped */
        if (i >= jobs[is_plain[i]].next) {
            tdmf_member_stops(ensemble, i, &ends[i]);
        }
    }
    if (is_done && work) {
        *work = sum;
    }
    free(is_plain);
    tdmf_accepts_if(&why, is_done, TDMF_UNAVAILABLE, "memory", 0, "there is not enough");
    return why;
}
