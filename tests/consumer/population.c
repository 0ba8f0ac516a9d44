/* Many runners, each with its own disturbance, return to the default gait. */
#include <tdmf_slip/ensemble.h>
#include <tdmf_slip/tdmf_slip.h>

#include <stdio.h>

enum { RUNNERS = 200, PROCESSORS = 2 };

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
    return 0;
}
