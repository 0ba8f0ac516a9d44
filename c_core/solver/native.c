/* The native solver. Between events it integrates the coordinates of the present mode's chart; a step is
 * taken, judged by its error, searched for the first event, and cut there. */
#include "tdmf_slip/solver.h"

#include "chart_slope.h"
#include "locate.h"
#include "pair.h"
#include "tdmf_slip/automaton.h"
#include "tdmf_slip/contact.h"

#include <limits.h>
#include <math.h>
#include <string.h>

/* Control of the step size. */
static const double safety = 0.9;
static const double largest_growth = 6.0;
static const double strongest_cut = 0.2;

/* The larger, the shorter the first step in a mode; chosen for the fewest evaluations per stride. */
static const double first_step_caution = 0.1;

typedef struct {
    tdmf_solver *solver;
    const tdmf_model *model;
    tdmf_inputs inputs; /* at motion->time */
    tdmf_input_rates rates;
    tdmf_motion *motion;
    double until;
    double size; /* of the next step */
    tdmf_chart chart;
    tdmf_pair_step step;
    tdmf_watch watch;
    double allowed[CHART_COUNT];
    long steps_left, events_left;
} march;

tdmf_solver tdmf_solver_default(void) {
    const tdmf_solver solver = {.relative_tolerance = 1e-11, .step_limit = 1000000, .event_limit = 100000};
    return solver;
}

const char *tdmf_outcome_text(tdmf_outcome outcome) {
    switch (outcome) {
    case TDMF_ARRIVED:
        return "arrived";
    case TDMF_FELL:
        return "the runner fell";
    case TDMF_TOO_MANY_STEPS:
        return "too many steps: the parameters are too stiff for the solver or its tolerance";
    case TDMF_TOO_MANY_EVENTS:
        return "too many events";
    default:
        return "no step, however short, has a finite result";
    }
}

/* Errors are measured in the runner's own units, and relative to what exceeds them; travel and integrals,
 * which grow for ever, in the units alone. */
static void allow_errors(march *march) {
    const tdmf_scales *scales = &march->model->scales;
    const double units[CHART_COUNT] = {scales->length, 1.0,
                                       scales->speed,  1.0 / scales->time,
                                       scales->energy, scales->energy,
                                       scales->length, scales->speed,
                                       scales->energy, 1.0};
    static const bool grows[CHART_COUNT] = {[CHART_HIP_WORK] = true,
                                            [CHART_DAMPER_LOSS] = true,
                                            [CHART_FOOT_X] = true,
                                            [CHART_FRICTION_LOSS] = true};
    for (int i = 0; i < CHART_COUNT; ++i) {
        const double magnitude = grows[i] ? units[i] : fmax(units[i], fabs(march->step.start[i]));
        march->allowed[i] = march->solver->relative_tolerance * magnitude;
    }
}

static void accelerations(const tdmf_chart *chart, const double slope[CHART_COUNT],
                          double derivatives[TDMF_STATE_COUNT]) {
    memset(derivatives, 0, TDMF_STATE_COUNT * sizeof *derivatives);
    derivatives[TDMF_LEG_ANGLE] = slope[CHART_LEG_ANGLE];
    derivatives[TDMF_LEG_LENGTH_RATE] = slope[CHART_LEG_LENGTH_RATE];
    derivatives[TDMF_LEG_ANGLE_RATE] = slope[CHART_LEG_ANGLE_RATE];
    derivatives[TDMF_FOOT_VX] = chart->in_flight ? 0.0 : slope[CHART_FOOT_VX];
}

static tdmf_watch watch_state(const march *march, const tdmf_inputs *inputs,
                              const double state[TDMF_STATE_COUNT], const double slope[CHART_COUNT]) {
    double derivatives[TDMF_STATE_COUNT];
    accelerations(&march->chart, slope, derivatives);
    return tdmf_watch_guards(march->model, inputs, &march->rates, &march->motion->mode, state, derivatives);
}

/* The end of the accepted step becomes the start of the next. */
static void shift(march *march, double elapsed) {
    tdmf_chart_shift(&march->chart, elapsed);
    memcpy(march->step.start, march->step.end, sizeof march->step.start);
    memcpy(march->step.slopes[0], march->step.slopes[PAIR_STAGES], sizeof march->step.slopes[0]);
}

/* The eighth root, by square roots: cheaper than pow, and the same on every platform. */
static double eighth_root(double x) {
    return sqrt(sqrt(sqrt(x)));
}

static double new_size(double size, double error) {
    const double factor = error > 0.0 ? safety / eighth_root(error) : largest_growth;
    return size * fmin(largest_growth, fmax(strongest_cut, factor));
}

/* A first step from the first two derivatives (Hairer, Norsett and Wanner, II.4): neither so long that it is
 * refused, nor so short that the steps must grow. */
static double first_step_size(march *march) {
    const int count = tdmf_chart_count(&march->chart);
    const double time = march->model->scales.time;
    const double probe = 1e-3 * time;
    double z[CHART_COUNT];
    double slope[CHART_COUNT];
    double curvature = 0.0;
    for (int i = 0; i < CHART_COUNT; ++i) {
        z[i] = march->step.start[i] + (i < count ? probe * march->step.slopes[0][i] : 0.0);
    }
    chart_slope(&march->chart, probe, z, slope);
    ++march->solver->evaluations;
    for (int i = 0; i < count; ++i) {
        const double change = fabs(slope[i] - march->step.slopes[0][i]) / march->allowed[i];
        curvature = fmax(curvature, time * time * change / probe);
    }
    return time / fmax(1.0, eighth_root(first_step_caution * curvature));
}

/* Begins integrating in the present mode from the present state. */
static void open_mode(march *march) {
    tdmf_motion *motion = march->motion;
    tdmf_chart_open(&march->chart, march->model, &march->inputs, &march->rates, &motion->mode, motion->state,
                    march->step.start);
    chart_slope(&march->chart, 0.0, march->step.start, march->step.slopes[0]);
    ++march->solver->evaluations;
    march->watch = watch_state(march, &march->inputs, motion->state, march->step.slopes[0]);
    allow_errors(march);
    march->size = first_step_size(march);
}

/* Tries steps until one is accurate enough. */
static tdmf_outcome take_accurate_step(march *march) {
    allow_errors(march);
    for (;;) {
        if (march->steps_left-- <= 0) {
            return TDMF_TOO_MANY_STEPS;
        }
        const double left = march->until - march->motion->time;
        march->step.size = march->size < left ? march->size : left;
        tdmf_pair_take(&march->chart, &march->step);
        march->solver->evaluations += PAIR_STAGES;
        ++march->solver->steps;
        const double error = tdmf_pair_error(&march->chart, &march->step, march->allowed);
        if (error <= 1.0) {
            const double proposal = new_size(march->step.size, error);
            march->size = march->step.size < march->size ? fmax(march->size, proposal) : proposal;
            return TDMF_ARRIVED;
        }
        ++march->solver->rejected_steps;
        march->size = isfinite(error) ? new_size(march->step.size, error) : strongest_cut * march->step.size;
        if (!(march->motion->time + march->size > march->motion->time)) {
            return TDMF_NO_PROGRESS;
        }
    }
}

/* Adds what of the work in the step, up to a fraction, was done at positive power. */
static void sum_positive_work(march *march, const tdmf_search *search, double fraction,
                              const double end[CHART_COUNT], const double end_slope[CHART_COUNT]) {
    const double start_work = march->step.start[CHART_HIP_WORK];
    const double end_work = end[CHART_HIP_WORK];
    const double start_power = march->step.slopes[0][CHART_HIP_WORK];
    const double end_power = end_slope[CHART_HIP_WORK];
    double turning_work = start_work;
    if (start_power * end_power < 0.0) {
        double z[CHART_COUNT];
        tdmf_pair_within(&march->chart, &march->step, tdmf_power_reversal(search, fraction), z);
        turning_work = z[CHART_HIP_WORK];
    }
    march->chart.positive_work += fmax(0.0, turning_work - start_work) + fmax(0.0, end_work - turning_work);
}

/* Notes a peak of the ground force up to a fraction of the step. It changes nothing but the record, so the
 * step goes on. */
static void observe_ground_force(march *march, const tdmf_search *search, double fraction) {
    tdmf_mode *mode = &march->motion->mode;
    const double turn = tdmf_guard_crossing(search, TDMF_GUARD_FORCE_PEAK, fraction);
    if (turn > fraction) {
        return;
    }
    if (mode->ground_force_rising) {
        double state[TDMF_STATE_COUNT];
        double z[CHART_COUNT];
        const tdmf_inputs inputs = tdmf_inputs_after(&march->inputs, &march->rates, turn * march->step.size);
        tdmf_pair_within(&march->chart, &march->step, turn, z);
        tdmf_chart_state(&march->chart, turn * march->step.size, z, state);
        const double force = tdmf_contact_force(march->model, &inputs, mode, state).fy;
        march->motion->record.open.peak_force = fmax(march->motion->record.open.peak_force, force);
    }
    mode->ground_force_rising = !mode->ground_force_rising;
}

static void move_inputs(march *march, double elapsed) {
    march->inputs = tdmf_inputs_after(&march->inputs, &march->rates, elapsed);
}

/* Stops at a fraction of the step, where an event is due, and takes it. */
static void stop_at_event(march *march, const tdmf_search *search, double fraction) {
    tdmf_motion *motion = march->motion;
    double z[CHART_COUNT];
    double slope[CHART_COUNT];
    const double elapsed = fraction * march->step.size;
    tdmf_pair_within(&march->chart, &march->step, fraction, z);
    chart_slope(&march->chart, elapsed, z, slope);
    sum_positive_work(march, search, fraction, z, slope);
    tdmf_chart_state(&march->chart, elapsed, z, motion->state);
    motion->time += elapsed;
    move_inputs(march, elapsed);
    tdmf_resolve(march->model, &march->inputs, motion->time, motion->state, &motion->mode, &motion->record);
    ++march->solver->events;
    --march->events_left;
    open_mode(march);
}

static tdmf_outcome advance_once(march *march) {
    tdmf_motion *motion = march->motion;
    const tdmf_outcome outcome = take_accurate_step(march);
    if (outcome != TDMF_ARRIVED) {
        return outcome;
    }
    const double size = march->step.size;
    const double *end_slope = march->step.slopes[PAIR_STAGES];
    const tdmf_inputs inputs = tdmf_inputs_after(&march->inputs, &march->rates, size);
    double state[TDMF_STATE_COUNT];
    tdmf_chart_state(&march->chart, size, march->step.end, state);
    const tdmf_watch end = watch_state(march, &inputs, state, end_slope);
    const tdmf_search search = {&march->chart, march->model,  &march->inputs,
                                &march->rates, &motion->mode, &march->step};
    const double fraction = tdmf_first_crossing(&search, &march->watch, &end);
    if (fraction <= 1.0 || end.value[TDMF_GUARD_FORCE_PEAK] <= 0.0) {
        observe_ground_force(march, &search, fmin(1.0, fraction));
    }
    march->solver->evaluations += march->step.has_dense ? PAIR_ALL_STAGES - PAIR_STAGES - 1 : 0;
    if (fraction <= 1.0) {
        stop_at_event(march, &search, fraction);
        return TDMF_ARRIVED;
    }
    sum_positive_work(march, &search, 1.0, march->step.end, end_slope);
    state[TDMF_HIP_POSITIVE_WORK] = march->chart.positive_work;
    memcpy(motion->state, state, sizeof state);
    motion->time = size < march->until - motion->time ? motion->time + size : march->until;
    move_inputs(march, size);
    shift(march, size);
    march->watch = end;
    return TDMF_ARRIVED;
}

static march begin(tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs,
                   const tdmf_input_rates *rates, double until, tdmf_motion *motion) {
    march march;
    march.solver = solver;
    march.model = model;
    march.inputs = *inputs;
    march.rates = *rates;
    march.motion = motion;
    march.until = until;
    march.steps_left = solver->step_limit;
    march.events_left = solver->event_limit;
    /* An input may have jumped since the last call. */
    tdmf_resolve(model, inputs, motion->time, motion->state, &motion->mode, &motion->record);
    open_mode(&march);
    return march;
}

/* Until the time asked for, or until `strides` have closed. */
static tdmf_outcome advance(march *march, int strides) {
    tdmf_motion *motion = march->motion;
    while (motion->time < march->until && !motion->mode.fallen && motion->record.stride.count < strides) {
        if (march->events_left <= 0) {
            return TDMF_TOO_MANY_EVENTS;
        }
        const tdmf_outcome outcome = advance_once(march);
        if (outcome != TDMF_ARRIVED) {
            return outcome;
        }
    }
    /* The caller may change an input now. */
    tdmf_observe(march->model, &march->inputs, motion->state, &motion->mode, &motion->record);
    return motion->mode.fallen ? TDMF_FELL : TDMF_ARRIVED;
}

tdmf_outcome tdmf_native_advance(tdmf_solver *solver, const tdmf_model *model, const tdmf_inputs *inputs,
                                 const tdmf_input_rates *rates, double until, tdmf_motion *motion) {
    march march = begin(solver, model, inputs, rates, until, motion);
    return advance(&march, INT_MAX);
}

tdmf_stride_outcome tdmf_native_stride(tdmf_solver *solver, const tdmf_model *model,
                                       const tdmf_inputs *inputs, double until, tdmf_motion *motion) {
    static const tdmf_input_rates held = {0.0, 0.0};
    const int count = motion->record.stride.count;
    march march = begin(solver, model, inputs, &held, until, motion);
    const tdmf_outcome outcome = advance(&march, count + 1);
    const tdmf_stride_outcome result = {outcome, motion->record.stride.count > count};
    return result;
}
