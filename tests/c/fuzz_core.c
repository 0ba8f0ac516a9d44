/* The core's C interface with any runner in the declared ranges: starts, both solvers' steps, strides with
 * derivatives and ensembles. No crash, no hang, and no number that is not one behind a success. */
#include "at_instant.h"
#include "declared.h"
#include "fuzz.h"
#include "ground_line.h"
#include "strides.h"
#include "system_of.h"

#include "tdmf_slip/ensemble.h"
#include "tdmf_slip/tdmf_slip.h"

#include <math.h>

enum { MEMBERS = 5, STRIDES = 3 };

typedef struct {
    random_source *source;
    double decades;
    tdmf_model model;
    tdmf_inputs inputs;
    tdmf_solver solver;
    tdmf_motion motion;
    bool has_run_members;
} subject;

static void expect_numbers_of_motion(const subject *on) {
    const tdmf_motion *motion = &on->motion;
    double derivatives[TDMF_STATE_COUNT], guards[TDMF_GUARD_COUNT];
    tdmf_derivatives(SYSTEM_OF(on), &motion->mode, motion->state, derivatives);
    tdmf_guards(SYSTEM_OF(on), &motion->mode, motion->state, guards);
    expect_numbers(0, motion->state, TDMF_STATE_COUNT);
    expect_numbers(0, derivatives, TDMF_STATE_COUNT);
    expect_numbers(0, guards, TDMF_GUARD_COUNT);
    const tdmf_outputs outputs = outputs_of(SYSTEM_OF(on), motion);
    const double numbers[] = {outputs.com.y,        outputs.contact.fx,     outputs.contact.fy,
                              outputs.hip.torque,   outputs.energy.total,   outputs.energy.impact_loss,
                              outputs.stride.speed, outputs.stride.work,    outputs.stride.cost_of_transport,
                              outputs.apex.time,    outputs.apex.com_speed, outputs.apex.com_height};
    expect_numbers(0, numbers, COUNT_OF(numbers));
}

static double random_time(const subject *on) {
    return on->model.scales.time * random_magnitude(on->source, 1e-3, 1e2);
}

/* Rates of inputs that need not be held, of the size that inputs have. */
static tdmf_inputs random_rates(const subject *on, double duration) {
    tdmf_inputs rates = {.ground = {.friction = 0.0}};
    if (random_chance(on->source, 0.3)) {
        tdmf_inputs sizes = tdmf_default_inputs();
        declared_further_inputs(on->source, &on->model.parameters, on->decades, &sizes);
        rates.ground.friction = random_uniform(on->source, -1.0, 1.0) / duration;
        rates.hip.external_torque =
            random_uniform(on->source, -0.1, 0.1) * on->model.scales.energy / duration;
        rates.leg.extension = sizes.leg.extension / duration;
        rates.body.external_fx = sizes.body.external_fx / duration;
        rates.body.external_fy = sizes.body.external_fy / duration;
    }
    return rates;
}

static void advance(void *self) {
    subject *on = self;
    const double duration = random_time(on);
    const tdmf_inputs rates = random_rates(on, duration);
    const double start = on->motion.time;
    const tdmf_outcome outcome =
        tdmf_native_advance(&on->solver, SYSTEM_OF(on), &rates, start + duration, &on->motion);
    if (outcome == TDMF_ARRIVED && on->motion.time != start + duration) {
        die("arrived elsewhere");
    }
    if ((outcome == TDMF_FELL) != on->motion.mode.fallen && outcome != TDMF_REFUSED) {
        die("a fall that is none");
    }
    on->inputs = tdmf_inputs_after(&on->inputs, &rates, on->motion.time - start);
    expect_numbers_of_motion(on);
}

static void close_a_stride(void *self) {
    subject *on = self;
    const double count = on->motion.state[TDMF_STRIDE_COUNT];
    const tdmf_stride_outcome outcome =
        tdmf_native_stride(&on->solver, SYSTEM_OF(on), on->motion.time + random_time(on), &on->motion);
    if (outcome.closed != (on->motion.state[TDMF_STRIDE_COUNT] == count + 1)) {
        die("a stride that is none");
    }
    expect_numbers_of_motion(on);
}

/* All inputs jump and, half of the time, so do settings of the control law. */
static void jump(void *self) {
    subject *on = self;
    tdmf_parameters parameters = on->model.parameters;
    tdmf_observe(SYSTEM_OF(on), &on->motion);
    on->inputs = declared_inputs(on->source, &parameters, on->decades);
    declared_further_inputs(on->source, &parameters, on->decades, &on->inputs);
    if (random_chance(on->source, 0.5)) {
        declared_settings(on->source, on->decades, &parameters);
        if (tdmf_model_create(&on->model, &parameters).variable != NULL) {
            die("settings within their ranges are refused");
        }
    }
    tdmf_resolve(SYSTEM_OF(on), &on->motion);
    expect_numbers_of_motion(on);
}

static void random_section(subject *on, double section[TDMF_SECTION_COUNT]) {
    double scales[TDMF_SECTION_COUNT];
    static const double gait[TDMF_SECTION_COUNT] = {1.4, 1.3, 1.0, 1.2, 0.0, 0.2};
    tdmf_section_scales(&on->model, scales);
    for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
        section[i] = scales[i] * (gait[i] + random_uniform(on->source, -0.5, 0.5));
    }
}

static void map(void *self) {
    subject *on = self;
    double section[TDMF_SECTION_COUNT];
    random_section(on, section);
    const tdmf_return stride =
        return_map(&on->solver, SYSTEM_OF(on), section, 1e3 * on->model.scales.time, true, NULL, 0);
    if (stride.outcome == TDMF_RETURN_CLOSED) {
        expect_numbers(0, stride.apex, TDMF_SECTION_COUNT);
        for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
            expect_numbers(0, stride.variations[i].apex, TDMF_SECTION_COUNT);
        }
    }
}

static void run_members(void *self) {
    subject *on = self;
    double starts[MEMBERS][TDMF_POINT_LIMIT] = {{0.0}};
    tdmf_ensemble_end ends[MEMBERS];
    const double roughness = random_uniform(on->source, 0.0, 0.1) * on->model.scales.length;
    const tdmf_ensemble_case only = {.model = &on->model,
                                     .inputs = on->inputs,
                                     .rules = {.max_strides = STRIDES, .roughness = roughness, .seed = 1}};
    if (on->decades > 1.0 || on->has_run_members) {
        return; /* an ensemble's steps cannot be limited, and stiff runners take many */
    }
    on->has_run_members = true;
    for (int i = 0; i < MEMBERS; ++i) {
        random_section(on, starts[i]);
    }
    const tdmf_ensemble ensemble = {.cases = &only,
                                    .case_count = 1,
                                    .starts = (const double(*)[TDMF_POINT_LIMIT])starts,
                                    .count = MEMBERS,
                                    .relative_tolerance = on->solver.relative_tolerance,
                                    .threads = 1,
                                    .instructions = TDMF_BEST_INSTRUCTIONS};
    if (tdmf_run_ensemble(&ensemble, ends, NULL).code != TDMF_ACCEPTED) {
        die("an ensemble that is sound was not run");
    }
    for (int i = 0; i < MEMBERS; ++i) {
        expect_numbers(0, ends[i].apex, TDMF_SECTION_COUNT);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size) {
    static void (*const calls[])(void *) = {advance, advance, advance, close_a_stride,
                                            jump,    jump,    map,     run_members};
    static const double decades[] = {0.1, 0.5, 1.0, 3.0, INFINITY};
    random_source source = {0};
    subject on = {.source = &source, .solver = tdmf_solver_default()};
    random_draw_from(bytes, size);
    on.decades = decades[random_index(&source, COUNT_OF(decades))];
    const declared_runner runner = declared_random(&source, on.decades);
    on.inputs = runner.inputs;
    if (random_chance(&source, 0.5)) {
        declared_further_inputs(&source, &runner.parameters, on.decades, &on.inputs);
    }
    const tdmf_ground_line ground = tdmf_ground_line_of(on.inputs.ground.height, on.inputs.ground.slope);
    for (int i = 0; i < TDMF_STATE_COUNT; ++i) {
        on.motion.state[i] = runner.state[i];
    }
    on.motion.state[TDMF_FOOT_Y] += tdmf_ground_height_at(&ground, on.motion.state[TDMF_FOOT_X]);
    on.solver.relative_tolerance = random_magnitude(&source, 1e-14, 1e-2);
    on.solver.step_limit = STEPS_OF_A_CALL;
    on.solver.event_limit = STEPS_OF_A_CALL;
    on.motion.time = 0.0;
    if (tdmf_model_create(&on.model, &runner.parameters).variable == NULL &&
        tdmf_start(SYSTEM_OF(&on), &on.motion).variable == NULL) {
        call_until_used_up(&source, calls, COUNT_OF(calls), &on);
    }
    return 0;
}
