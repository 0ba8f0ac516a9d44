/* Many runners, each with its own disturbance, return to the default gait; which pages may run on rough
 * ground; and two steps of the classic SLIP, a model of another page. */
#include <tdmf_slip/ensemble.h>
#include <tdmf_slip/tdmf_slip.h>

#include <stdio.h>

enum { RUNNERS = 200, PROCESSORS = 2 };

/* Two steps of the classic SLIP, side by side. */
static bool classic_steps_cross(void) {
    enum { STEPS = 2, ROOM = 64 };
    static const double heights[STEPS] = {1.00, 1.05};
    double parameters[ROOM], states[ROOM], ends[STEPS * ROOM];
    tdmf_page_end outcomes[STEPS];
    tdmf_page_map map = {.page = tdmf_page_named("classic_slip"),
                         .parameters = parameters,
                         .states = states,
                         .tolerance = 1e-12,
                         .longest = 1e3};
    const tdmf_page_batch batch = {.map = &map,
                                   .count = STEPS,
                                   .points = heights,
                                   .states = ends,
                                   .ends = outcomes,
                                   .threads = PROCESSORS};
    tdmf_page_defaults(map.page, parameters, states);
    return tdmf_page_strides(&batch) && outcomes[0].outcome == TDMF_PAGE_CROSSED &&
           outcomes[1].outcome == TDMF_PAGE_CROSSED;
}

static void print_roughness(const char *name) {
    const bool may_be_rough = tdmf_page_has_ground(tdmf_page_named(name));
    printf("the ground of the page %s %s be rough\n", name, may_be_rough ? "may" : "cannot");
}

int main(void) {
    static const double gait[1][TDMF_POINT_LIMIT] = {
        {1.418508152745958, 1.0620047462715507, 0.9999993776846997, -0.5462532571145313, 0.0, 0.0}};
    static double starts[RUNNERS][TDMF_POINT_LIMIT];
    static tdmf_ensemble_end ends[RUNNERS];
    const tdmf_parameters parameters = tdmf_default_parameters();
    tdmf_model model;
    tdmf_model_create(&model, &parameters);
    for (int i = 0; i < RUNNERS; ++i) {
        for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
            starts[i][k] = gait[0][k];
        }
        starts[i][TDMF_SECTION_COM_SPEED] += 0.5 * (i - RUNNERS / 2) / RUNNERS;
    }
    const tdmf_ensemble_case runner = {
        .model = &model,
        .inputs = tdmf_default_inputs(),
        .rules = {.gaits = gait, .gait_count = 1, .distance = 1e-2, .max_strides = 400}};
    const tdmf_ensemble ensemble = {.cases = &runner,
                                    .case_count = 1,
                                    .starts = (const double(*)[TDMF_POINT_LIMIT])starts,
                                    .count = RUNNERS,
                                    .relative_tolerance = 1e-8,
                                    .threads = PROCESSORS};
    int settled = 0;
    const tdmf_refusal refusal = tdmf_run_ensemble(&ensemble, ends, NULL);
    if (refusal.code != TDMF_ACCEPTED) {
        char text[256];
        fprintf(stderr, "%s\n", tdmf_refusal_text(&refusal, text, sizeof text));
        return 1;
    }
    for (int i = 0; i < RUNNERS; ++i) {
        settled += ends[i].fate == TDMF_FATE_SETTLED;
    }
    printf("%d of %d runners are back on the gait\n", settled, RUNNERS);
    print_roughness("runner");
    print_roughness("classic_slip");
    if (!classic_steps_cross())
        return 1;
    printf("both steps of the classic SLIP reach an apex\n");
    return 0;
}
