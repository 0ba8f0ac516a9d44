/* The derivatives of strides against differences: of random runners, and of gaits under a push. Whatever
 * happens in a stride, it is differentiated, and what is zero is no exception. */
#include "compare.h"
#include "ranges.h"
#include "reference_gaits.h"
#include "sample.h"
#include "scene.h"
#include "simulation.h"
#include "stride_results.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

enum {
    RUNNERS = TDMF_SAMPLE_DIVISOR < 10 ? sample_of(120) : 12,
    GAIT_STEP = TDMF_SAMPLE_DIVISOR == 1 ? 1 : 5, /* odd: pushes alternate */
    PARAMETERS = TDMF_PARAMETER_COUNT,
    INPUTS = sizeof(tdmf_inputs) / sizeof(double),
    STRIBECK_VELOCITY =
        TDMF_SECTION_COUNT + offsetof(tdmf_parameters, ground.stribeck_velocity) / sizeof(double),
    PATCH_BEGIN = TDMF_SECTION_COUNT + offsetof(tdmf_parameters, ground.patch_begin) / sizeof(double),
    PATCH_END = TDMF_SECTION_COUNT + offsetof(tdmf_parameters, ground.patch_end) / sizeof(double),
    SLOPE = TDMF_SECTION_COUNT + PARAMETERS + offsetof(tdmf_inputs, ground.slope) / sizeof(double),
    SEEDS = TDMF_SECTION_COUNT + PARAMETERS + INPUTS,
    PEAK_VERTICAL_FORCE = RESULTS - 1
};

static const double longest = 1e3;

typedef struct {
    tdmf_parameters parameters;
    tdmf_inputs inputs;
    double section[TDMF_SECTION_COUNT];
} start;

static void set_zero(random_source *source, double probability, double *value) {
    *value = random_chance(source, probability) ? 0.0 : *value;
}

/* Draws from a copy of the source, so that the values drawn from the source itself are unchanged. Half of the
 * runners stay on level ground. */
static void choose_ground(random_source copy, tdmf_inputs *inputs) {
    if (random_chance(&copy, 0.5)) {
        inputs->ground.slope = random_uniform(&copy, -0.15, 0.1);
        inputs->ground.height = random_uniform(&copy, -1.0, 1.0);
    }
}

/* Friction falls with speed for half of the runners. The others have v_s = 0, without a derivative by it. */
static void choose_friction(random_source copy, tdmf_parameters *p) {
    if (random_chance(&copy, 0.5)) {
        p->ground.stribeck_velocity = random_magnitude(&copy, 0.03, 1.0);
    }
}

static start random_start(random_source *source) {
    start start = {tdmf_default_parameters(), tdmf_default_inputs(), {0.0}};
    tdmf_parameters *p = &start.parameters;
    p->foot.mass = random_magnitude(source, 0.02, 0.5);
    p->leg.damping = random_magnitude(source, 0.03, 1.0);
    p->gravity *= random_magnitude(source, 0.7, 1.5);
    p->hip.stance_torque = random_uniform(source, -0.1, 0.3);
    p->hip.touchdown_angle += random_uniform(source, -0.4, 0.2);
    p->hip.kp = random_magnitude(source, 0.03, 1.0);
    p->hip.kd = random_magnitude(source, 0.03, 1.0);
    p->hip.liftoff_angle_factor = random_uniform(source, 0.5, 1.5);
    start.inputs.ground.friction = random_magnitude(source, 0.05, 5.0);
    start.inputs.hip.external_torque = random_uniform(source, -0.01, 0.01);
    p->hip.retraction_rate = random_uniform(source, -0.02, 0.02);
    p->ground.static_friction_ratio = random_uniform(source, 1.1, 1.5);
    p->leg.thrust = random_uniform(source, 0.001, 0.02);
    choose_friction(*source, p);
    p->hip.swing_clamp = random_truth(*source);
    set_zero(source, 0.5, &p->hip.retraction_rate);
    set_zero(source, 0.3, &p->hip.stance_torque);
    set_zero(source, 0.2, random_chance(source, 0.5) ? &p->hip.kp : &p->hip.kd);
    set_zero(source, 0.2, &p->leg.damping);
    set_zero(source, 0.5, &start.inputs.hip.external_torque);
    choose_ground(*source, &start.inputs);
    memcpy(start.section, &reference_gaits[DEFAULT_GAIT].apex, sizeof start.section);
    for (int k = 0; k < TDMF_SECTION_COUNT; ++k) {
        start.section[k] += random_uniform(source, -0.1, 0.1);
    }
    return start;
}

static double *coordinate_of(start *start, int k) {
    if (k < TDMF_SECTION_COUNT) {
        return &start->section[k];
    }
    k -= TDMF_SECTION_COUNT;
    return k < PARAMETERS ? (double *)&start->parameters + k : (double *)&start->inputs + (k - PARAMETERS);
}

static tdmf_return stride_of(const start *start, bool derivatives, const tdmf_seed *seed,
                             tdmf_event_log *log) {
    const tdmf_model model = accepted_model(&start->parameters);
    tdmf_solver solver = solver_to(1e-13);
    solver.log = log;
    log->count = 0;
    return measured_return_map(&solver, (tdmf_system){&model, &start->inputs}, start->section, longest,
                               derivatives, seed, seed ? 1 : 0);
}

/* The same events in the same order. */
static bool happens_alike(const tdmf_event_log *a, const tdmf_event_log *b) {
    bool alike = a->count == b->count && a->count <= TDMF_EVENT_CAPACITY;
    for (int i = 0; alike && i < a->count; ++i) {
        alike = a->events[i].guard == b->events[i].guard &&
                a->events[i].after.contact == b->events[i].after.contact &&
                a->events[i].after.phase == b->events[i].after.phase &&
                a->events[i].after.clamp_closed == b->events[i].after.clamp_closed;
    }
    return alike;
}

/* True if the value is the least of its parameter's range. */
static bool is_least(int k, double value) {
    const size_t offset = (size_t)(k - TDMF_SECTION_COUNT) * sizeof(double);
    for (int i = 0; k >= TDMF_SECTION_COUNT && i < TDMF_PARAMETER_COUNT; ++i) {
        if (tdmf_parameter_ranges[i].offset == offset && value == tdmf_parameter_ranges[i].minimum) {
            return true;
        }
    }
    return false;
}

/* Five points, about the middle or, where less is refused, from it on. False where something else
 * happens there. */
static bool difference(const start *at, const tdmf_event_log *events, int k, double step,
                       double differences[RESULTS]) {
    static const double middle[2][5] = {{-2.0, -1.0, 0.0, 1.0, 2.0}, {1.0, -8.0, 0.0, 8.0, -1.0}};
    static const double ahead[2][5] = {{0.0, 1.0, 2.0, 3.0, 4.0}, {-25.0, 48.0, -36.0, 16.0, -3.0}};
    start there = *at;
    double *moved = coordinate_of(&there, k);
    const double value = *moved;
    const double(*points)[5] = is_least(k, value) ? ahead : middle;
    const double h = k < TDMF_SECTION_COUNT ? step : step * fmax(fabs(value), 0.05);
    memset(differences, 0, RESULTS * sizeof *differences);
    for (int i = 0; i < 5; ++i) {
        tdmf_event_log log;
        double results[RESULTS];
        *moved = value + points[0][i] * h;
        const tdmf_return stride = stride_of(&there, false, NULL, &log);
        if (stride.outcome != TDMF_RETURN_CLOSED || !happens_alike(&log, events)) {
            return false;
        }
        results_of(&stride, results);
        for (int r = 0; r < RESULTS; ++r) {
            differences[r] += points[1][i] * results[r] / (12.0 * h);
        }
    }
    return true;
}

/* A difference over a short step, what one over a longer step is off from it, and the largest of it: the
 * error of a long one is the step's fourth power times a fifth derivative, which is large near the edge of an
 * event, that of a short one the motion's, over the step. */
typedef struct {
    double values[RESULTS], error, size;
} estimate;

static bool estimate_difference(const start *at, const tdmf_event_log *events, int k, estimate *estimate) {
    double coarse[RESULTS];
    estimate->error = 0.0;
    estimate->size = 1.0;
    if (!difference(at, events, k, 1e-5, coarse) || !difference(at, events, k, 1e-6, estimate->values)) {
        return false;
    }
    for (int r = 0; r < RESULTS; ++r) {
        estimate->error = fmax(estimate->error, fabs(coarse[r] - estimate->values[r]));
        estimate->size = fmax(estimate->size, fabs(estimate->values[r]));
    }
    return estimate->error < 1e-4 * estimate->size;
}

/* On the level the peak of the vertical force has a kink in the slope if it is where the tangential force
 * jumps: uphill one side of the jump is the larger one, downhill the other. */
static bool has_kink(const start *at, int k, int result) {
    return k == SLOPE && at->inputs.ground.slope == 0.0 && result == PEAK_VERTICAL_FORCE;
}

static void assert_is_differentiated(const start *at, int k, const estimate *estimate) {
    tdmf_event_log log;
    start unit;
    tdmf_seed seed;
    double derivatives[RESULTS];
    memset(&unit, 0, sizeof unit);
    *coordinate_of(&unit, k) = 1.0;
    seed.parameters = unit.parameters;
    seed.inputs = unit.inputs;
    const tdmf_return stride = stride_of(at, true, &seed, &log);
    derivatives_of(k < TDMF_SECTION_COUNT ? &stride.variations[k] : &stride.variations[TDMF_SECTION_COUNT],
                   derivatives);
    for (int r = 0; r < RESULTS; ++r) {
        if (!has_kink(at, k, r)) {
            assert_close(derivatives[r], estimate->values[r], 2e-6 * estimate->size + estimate->error);
        }
    }
}

/* Counts of compared strides, of derivatives by a value of zero, and of events in them. */
typedef struct {
    int compared, zeros, guards[TDMF_GUARD_COUNT];
    int drives_without_torque; /* left by a lift-off */
    int sloped;
} tally;

static void count_events(const start *at, const tdmf_event_log *events, int k, tally *tally) {
    start copy = *at;
    tally->zeros += k >= TDMF_SECTION_COUNT && *coordinate_of(&copy, k) == 0.0;
    ++tally->compared;
    tally->sloped += at->inputs.ground.slope != 0.0;
    for (int i = 0; i < events->count; ++i) {
        const tdmf_event *event = &events->events[i];
        ++tally->guards[event->guard];
        tally->drives_without_torque += event->guard == TDMF_GUARD_LIFT_OFF &&
                                        event->before.mid_stance_pending &&
                                        at->parameters.hip.stance_torque == 0.0;
    }
}

/* A return map begins on its ground, and here without a patch; a fall closes no stride, and a force peak is
 * no event of the solver. */
static bool may_happen_in_a_stride(tdmf_guard guard) {
    switch (guard) {
    case TDMF_GUARD_NEW_GROUND:
    case TDMF_GUARD_PATCH_BORDER:
    case TDMF_GUARD_BODY_DOWN:
    case TDMF_GUARD_LEG_TOO_SHORT:
    case TDMF_GUARD_FORCE_PEAK:
    case TDMF_GUARD_VERTICAL_FORCE_PEAK:
        return false;
    default:
        return true;
    }
}

/* This sample's share of a count that the whole sample reaches. */
#define PART(count) ((count)*RUNNERS / 120)

static void assert_saw_everything(const tally *seen) {
    assert_true(seen->compared > PART(1000) && seen->zeros > PART(50));
    for (int g = 0; g < TDMF_GUARD_COUNT; ++g) {
        assert_true(!may_happen_in_a_stride((tdmf_guard)g) || seen->guards[g] > PART(50));
    }
    assert_true(seen->drives_without_torque > PART(20) && seen->sloped > PART(500));
}

/* A share has seeds of its own, in which everything happens that happens in the whole sample. */
static uint64_t seed_of(int runner) {
    return TDMF_SAMPLE_DIVISOR == 1 ? (uint64_t)runner : runner == 0 ? 84 : 48 + (uint64_t)runner;
}

/* Along each coordinate of the section, each parameter and each input, where neighbours do the same. */
static void assert_stride_is_differentiated(const start *start, tally *seen) {
    tdmf_event_log events;
    if (stride_of(start, false, NULL, &events).outcome != TDMF_RETURN_CLOSED) {
        return;
    }
    for (int k = 0; k < SEEDS; ++k) {
        estimate estimate;
        if (k == PATCH_BEGIN || k == PATCH_END) { /* with a patch there is no map of six coordinates */
            continue;
        }
        if (k == STRIBECK_VELOCITY && start->parameters.ground.stribeck_velocity == 0.0) {
            continue;
        }
        if (estimate_difference(start, &events, k, &estimate)) {
            assert_is_differentiated(start, k, &estimate);
            count_events(start, &events, k, seen);
        }
    }
}

TEST(every_stride_is_differentiated) {
    tally seen;
    memset(&seen, 0, sizeof seen);
    for (int runner = 0; runner < RUNNERS; ++runner) {
        random_source source = {seed_of(runner)};
        const start start = random_start(&source);
        assert_stride_is_differentiated(&start, &seen);
    }
    assert_saw_everything(&seen);
}

/* A push along the ground changes the centre of mass's speed while an apex that comes later is waited for. */
TEST(gaits_are_differentiated_with_a_push_and_without) {
    static const double pushes[] = {0.0, 1e-3};
    tally seen;
    memset(&seen, 0, sizeof seen);
    for (int i = 0; i < 2 * REFERENCE_GAITS; i += GAIT_STEP) {
        const reference_gait *gait = &reference_gaits[i / 2];
        start start = {tdmf_default_parameters(), inputs_at_friction(gait->friction), {0.0}};
        start.parameters.hip.swing_clamp = gait->swing_clamp;
        start.inputs.body.external_fx = pushes[i % 2];
        memcpy(start.section, &gait->apex, sizeof start.section);
        assert_stride_is_differentiated(&start, &seen);
    }
    assert_true(seen.compared > 25 * 2 * REFERENCE_GAITS / GAIT_STEP);
}
