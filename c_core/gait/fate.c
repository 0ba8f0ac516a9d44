/* Following runners stride by stride. */
#include "tdmf_slip/fate.h"

#include "tdmf_slip/orbit.h"

#include <math.h>
#include <string.h>

/* In sqrt(m/k): a stride that takes longer counts as none. */
static const double longest_stride = 1e4;

/* The gait that an apex is near, or -1. */
static int gait_near(const tdmf_model *model, const tdmf_fate_rules *rules,
                     const double section[TDMF_SECTION_COUNT]) {
    double scales[TDMF_SECTION_COUNT];
    tdmf_section_scales(model, scales);
    for (int gait = 0; gait < rules->gait_count; ++gait) {
        double farthest = 0.0;
        for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
            farthest = fmax(farthest, fabs(section[i] - rules->gaits[gait][i]) / scales[i]);
        }
        if (farthest <= rules->distance) {
            return gait;
        }
    }
    return -1;
}

static tdmf_fate fate_of(tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs,
                         const tdmf_fate_rules *rules, const double start[TDMF_SECTION_COUNT]) {
    tdmf_fate fate = {TDMF_FATE_UNDECIDED, -1, 0};
    double section[TDMF_SECTION_COUNT];
    memcpy(section, start, sizeof section);
    while (fate.strides < rules->most_strides) {
        const tdmf_return stride = tdmf_return_map(solver, model, inputs, section,
                                                   longest_stride * model->scales.time, false, NULL, 0);
        if (!stride.outcome.closed) {
            fate.kind = stride.began_at_apex ? TDMF_FATE_FELL : TDMF_FATE_NO_START;
            return fate;
        }
        ++fate.strides;
        memcpy(section, stride.apex, sizeof section);
        fate.gait = gait_near(model, rules, section);
        if (fate.gait >= 0) {
            fate.kind = TDMF_FATE_SETTLED;
            return fate;
        }
    }
    return fate;
}

void tdmf_find_fates(tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs,
                     const tdmf_fate_rules *rules, const double (*sections)[TDMF_SECTION_COUNT], long count,
                     tdmf_fate *fates) {
    for (long i = 0; i < count; ++i) {
        fates[i] = fate_of(solver, model, inputs, rules, sections[i]);
    }
}
