/* Derivatives of a stride's peaks of the ground force on slopes, across the ground and vertically, against
 * differences: also of a peak at an event, on either side of it, where the force jumps. Lanes find the same
 * peaks. */
#include "compare.h"
#include "reference_gaits.h"
#include "simulation.h"
#include "system_of.h"

#include "tdmf_slip/automaton.h"
#include "tdmf_slip/ensemble.h"
#include "tdmf_slip/outputs.h"
#include "tdmf_slip/return_map.h"

#include <math.h>
#include <string.h>

static const double long_enough = 1e4;

typedef struct {
    tdmf_model model;
    tdmf_inputs inputs;
    double section[TDMF_SECTION_COUNT];
} scene;

static scene scene_on_slope(double friction, double slope) {
    const tdmf_parameters parameters = tdmf_default_parameters();
    scene scene;
    memset(&scene, 0, sizeof scene);
    scene.model = accepted_model(&parameters);
    scene.inputs = tdmf_default_inputs();
    scene.inputs.ground.friction = friction;
    scene.inputs.ground.slope = slope;
    memcpy(scene.section, &reference_gaits[DEFAULT_GAIT].apex, sizeof scene.section);
    return scene;
}

static tdmf_return stride_from(const scene *scene, bool derivatives, tdmf_event_log *log) {
    static const tdmf_seed by_slope = {.inputs = {.ground = {.slope = 1.0}}};
    tdmf_solver solver = solver_to(1e-14);
    solver.log = log;
    const tdmf_return stride =
        tdmf_return_map(&solver, SYSTEM_OF(scene), scene->section, long_enough, derivatives, &by_slope, 1);
    assert_true(stride.outcome == TDMF_RETURN_CLOSED);
    return stride;
}

/* By a coordinate of the start, or, after the last, by the slope. */
static double *moved(scene *scene, int k) {
    return k < TDMF_SECTION_COUNT ? &scene->section[k] : &scene->inputs.ground.slope;
}

static void assert_differentiated(const scene *at) {
    const double step = 1e-4;
    const tdmf_return exact = stride_from(at, true, NULL);
    for (int k = 0; k <= TDMF_SECTION_COUNT; ++k) {
        scene ahead = *at, behind = *at;
        *moved(&ahead, k) += step;
        *moved(&behind, k) -= step;
        const tdmf_stride after = stride_from(&ahead, false, NULL).stride;
        const tdmf_stride before = stride_from(&behind, false, NULL).stride;
        const tdmf_stride_variation *change =
            k < TDMF_SECTION_COUNT ? &exact.variations[k] : &exact.variations[TDMF_SECTION_COUNT];
        assert_close(change->peak_force, (after.peak_force - before.peak_force) / (2.0 * step), 1e-5);
        assert_close(change->peak_vertical_force,
                     (after.peak_vertical_force - before.peak_vertical_force) / (2.0 * step), 1e-5);
    }
}

static double vertical_force(const scene *scene, const tdmf_mode *mode, const double *state) {
    tdmf_motion motion = {.mode = *mode};
    memcpy(motion.state, state, sizeof motion.state);
    return tdmf_outputs_of(SYSTEM_OF(scene), &motion).contact.fy;
}

/* -1 where the peak is met at the end of a mode, 1 at the begin of one, 0 in between. */
static int side_of_peak(const scene *scene) {
    tdmf_event_log log;
    memset(&log, 0, sizeof log);
    const double peak = stride_from(scene, false, &log).stride.peak_vertical_force;
    for (int i = 0; i < log.count; ++i) {
        const tdmf_event *event = &log.events[i];
        const double before = vertical_force(scene, &event->before, event->state);
        const double after = vertical_force(scene, &event->after, event->state);
        if (event->guard != TDMF_GUARD_TOUCHDOWN && fabs(fmax(before, after) - peak) < 1e-12) {
            return before > after ? -1 : 1;
        }
    }
    return 0;
}

TEST(peaks_on_slopes_are_differentiated) {
    static const double slopes[] = {-0.14, -0.1, -0.05, 0.02, 0.05};
    static const double frictions[] = {10.0, 1.2, 0.6, 0.2};
    int ends = 0, begins = 0, inside = 0;
    for (int i = 0; i < 20; ++i) {
        const scene scene = scene_on_slope(frictions[i % 4], slopes[i / 4]);
        const int side = side_of_peak(&scene);
        assert_differentiated(&scene);
        ends += side < 0;
        begins += side > 0;
        inside += side == 0;
    }
    assert_true(ends >= 1 && begins >= 1 && inside >= 1);
}

static tdmf_stride stride_in_lanes(const scene *scene, tdmf_instructions instructions) {
    const tdmf_ensemble_case its_case = {&scene->model, scene->inputs, {.max_strides = 1}};
    tdmf_ensemble_stride stride;
    tdmf_ensemble_end end;
    const tdmf_ensemble ensemble = {.cases = &its_case,
                                    .case_count = 1,
                                    .starts = (const double(*)[TDMF_SECTION_COUNT])scene->section,
                                    .count = 1,
                                    .relative_tolerance = 1e-12,
                                    .threads = 1,
                                    .instructions = instructions,
                                    .strides = &stride,
                                    .stride_count = 1};
    assert_true(tdmf_run_ensemble(&ensemble, &end, NULL));
    assert_int_equal(end.strides, 1);
    return stride.stride;
}

/* At a friction of 0.2 the foot slips while the force is largest. */
TEST(lanes_find_both_peaks_on_slopes) {
    static const double slopes[] = {-0.14, -0.05, 0.02, 0.05};
    static const double frictions[] = {10.0, 0.6, 0.2};
    int compared = 0;
    for (int i = 0; i < 12; ++i) {
        const scene scene = scene_on_slope(frictions[i % 3], slopes[i / 3]);
        const tdmf_stride stride = stride_from(&scene, false, NULL).stride;
        for (int set = TDMF_ONE_BY_ONE; set < TDMF_INSTRUCTIONS_COUNT; ++set) {
            if (tdmf_has_instructions((tdmf_instructions)set)) {
                const tdmf_stride in_lanes = stride_in_lanes(&scene, (tdmf_instructions)set);
                assert_close(in_lanes.peak_force, stride.peak_force, 1e-9);
                assert_close(in_lanes.peak_vertical_force, stride.peak_vertical_force, 1e-9);
                ++compared;
            }
        }
    }
    assert_true(compared >= 12);
}
