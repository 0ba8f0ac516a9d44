/* A law that sets the touchdown angle at each apex, for many runners on rough ground; and many strides at
 * once. */
#include <stdio.h>
#include <string.h>
#include <tdmf_slip/ensemble.h>
#include <tdmf_slip/tdmf_slip.h>

enum { RUNNERS = 64 };

static tdmf_ensemble_end ends[RUNNERS];
static tdmf_return strides[RUNNERS];

int main(void) {
    static double starts[RUNNERS][TDMF_POINT_LIMIT];
    const double gait[TDMF_POINT_LIMIT] = {
        1.418508152745958, 1.0620047462715507, 0.9999993776846997, -0.5462532571145313, 0.0, 0.0};
    const tdmf_parameters parameters = tdmf_default_parameters();
    const int setting = tdmf_setting_of("hip.touchdown_angle");
    const double nominal = parameters.hip.touchdown_angle, low = nominal - 0.1, high = nominal + 0.1;
    const double gain[1][TDMF_POINT_LIMIT] = {{0.0, 0.1, 0.0, 0.0, 0.0, 0.0}};
    tdmf_affine_law law;
    tdmf_model model;
    double angle, until[RUNNERS];
    long closed = 0;

    memset(&law, 0, sizeof law);
    law.count = 1;
    law.settings = &setting;
    law.nominal = &nominal;
    law.gain = gain;
    law.low = &low;
    law.high = &high;
    memcpy(law.apex, gait, sizeof law.apex);
    if (tdmf_model_create(&model, &parameters).code != TDMF_ACCEPTED)
        return 1;
    for (int i = 0; i < RUNNERS; ++i) {
        memcpy(starts[i], gait, sizeof gait);
        starts[i][TDMF_SECTION_COM_SPEED] += 0.001 * i;
        until[i] = 0.0;
    }
    tdmf_affine_settings(&law, starts[10], 10, 0, &angle);
    printf("runner 10 begins with touchdown angle %.4f rad\n", angle);

    tdmf_ensemble_case on_rough_ground = {.model = &model, .inputs = tdmf_default_inputs()};
    on_rough_ground.rules.max_strides = 20;
    on_rough_ground.rules.roughness = 0.002;
    on_rough_ground.rules.law = &law;
    const tdmf_ensemble ensemble = {.cases = &on_rough_ground,
                                    .case_count = 1,
                                    .starts = (const double(*)[TDMF_POINT_LIMIT])starts,
                                    .count = RUNNERS,
                                    .relative_tolerance = 1e-8,
                                    .threads = 1};
    printf("by %s: step %.3f, friction %.3f, noise %.3f\n",
           tdmf_instructions_name(tdmf_has_instructions(TDMF_TWO_LANES) ? TDMF_TWO_LANES : TDMF_ONE_BY_ONE),
           tdmf_ground_step(0, 10, 0), tdmf_friction_deviate(0, 10, 0), tdmf_sensor_noise(0, 10, 0, 0));
    const tdmf_refusal refusal = tdmf_run_ensemble(&ensemble, ends, NULL);
    if (refusal.code != TDMF_ACCEPTED) {
        char text[256];
        fprintf(stderr, "%s\n", tdmf_refusal_text(&refusal, text, sizeof text));
        return 1;
    }
    for (int i = 0; i < RUNNERS; ++i)
        closed += ends[i].strides;
    printf("%ld strides on rough ground\n", closed);

    tdmf_system systems[RUNNERS];
    tdmf_stride_batch batch = {.systems = systems, .until = until, .count = RUNNERS, .threads = 1};
    tdmf_solver solver = tdmf_solver_default();
    batch.sections = (const double(*)[TDMF_POINT_LIMIT])starts;
    for (int i = 0; i < RUNNERS; ++i) {
        systems[i].model = &model;
        systems[i].inputs = &on_rough_ground.inputs;
    }
    if (tdmf_run_strides(&solver, &batch, strides).code != TDMF_ACCEPTED)
        return 1;
    printf("the last of the level strides has the word %s\n", strides[RUNNERS - 1].stride.word);
    return 0;
}
