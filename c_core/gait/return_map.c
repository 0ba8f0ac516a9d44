/* A point of the section is a state with vy_c = 0; x is dropped, because nothing depends on it but where
 * there is a patch of ground. With the variation d_x of the state at a fixed time, the next section is met
 * later by dT = -d_vy_c/a_y, so that on it the variation is d_x + f dT. */
#include "tdmf_slip/return_map.h"

#include "coordinate_laws.h"
#include "free_fall_laws.h"
#include "ground_line.h"
#include "leg.h"
#include "patch.h"
#include "request.h"
#include "return_record.h"
#include "seed.h"
#include "stride_measures.h"
#include "tdmf_slip/automaton.h"
#include "tdmf_slip/dynamics.h"

#include <math.h>
#include <string.h>

/* The leg of a point of the section, or of a variation on it; the rest is zero. */
static void write_leg(const double section[TDMF_SECTION_COUNT], double state[TDMF_STATE_COUNT]) {
    double written[TDMF_STATE_COUNT] = {[TDMF_LEG_LENGTH] = section[TDMF_SECTION_LEG_LENGTH],
                                        [TDMF_LEG_ANGLE] = section[TDMF_SECTION_LEG_ANGLE],
                                        [TDMF_LEG_LENGTH_RATE] = section[TDMF_SECTION_LEG_LENGTH_RATE],
                                        [TDMF_LEG_ANGLE_RATE] = section[TDMF_SECTION_LEG_ANGLE_RATE]};
    memcpy(state, written, sizeof written);
}

void tdmf_section_state(tdmf_system system, const double section[TDMF_SECTION_COUNT],
                        double state[TDMF_STATE_COUNT]) {
    const double com_height = section[TDMF_SECTION_COM_HEIGHT], com_speed = section[TDMF_SECTION_COM_SPEED];
    write_leg(section, state);
    const tdmf_ground_line ground = tdmf_ground_line_set(system.inputs);
    const tdmf_point body = tdmf_body_from_foot(state, tdmf_leg_direction_of(state));
    const double ground_height = tdmf_ground_height_at(&ground, system.model->body_share * body.x);
    state[TDMF_FOOT_Y] = com_height + ground_height - system.model->body_share * body.y;
    state[TDMF_FOOT_VX] = com_speed - system.model->body_share * body.vx;
    state[TDMF_FOOT_VY] = -system.model->body_share * body.vy;
}

void tdmf_section_state_at(tdmf_system system, double foot_x, const double section[TDMF_SECTION_COUNT],
                           double state[TDMF_STATE_COUNT]) {
    const tdmf_ground_line ground = tdmf_ground_line_set(system.inputs);
    tdmf_section_state(system, section, state);
    state[TDMF_FOOT_Y] += tdmf_ground_height_at(&ground, foot_x) - tdmf_ground_height_at(&ground, 0.0);
    state[TDMF_FOOT_X] = foot_x;
}

void tdmf_section_of_state(const tdmf_model *model, const tdmf_ground_line *ground,
                           const double state[TDMF_STATE_COUNT], double section[TDMF_SECTION_COUNT]) {
    const tdmf_point com = tdmf_center_of_mass(model, state);
    const double coordinates[TDMF_SECTION_COUNT] = {
        [TDMF_SECTION_COM_HEIGHT] = com.y - tdmf_ground_height_at(ground, com.x),
        [TDMF_SECTION_COM_SPEED] = com.vx,
        [TDMF_SECTION_LEG_LENGTH] = state[TDMF_LEG_LENGTH],
        [TDMF_SECTION_LEG_ANGLE] = state[TDMF_LEG_ANGLE],
        [TDMF_SECTION_LEG_LENGTH_RATE] = state[TDMF_LEG_LENGTH_RATE],
        [TDMF_SECTION_LEG_ANGLE_RATE] = state[TDMF_LEG_ANGLE_RATE]};
    memcpy(section, coordinates, sizeof coordinates);
}

/* Varies the map above, which has made `state`, along a seed on the section and in masses and ground. */
static void vary_section_state(const tdmf_model *model, const tdmf_ground_line *ground,
                               const double state[TDMF_STATE_COUNT],
                               const double d_section[TDMF_SECTION_COUNT], const tdmf_local_seed *d,
                               double d_state[TDMF_STATE_COUNT]) {
    write_leg(d_section, d_state);
    /* The foot does not move yet: this is how the centre of mass moves from it. */
    const tdmf_point from_foot =
        tdmf_vary_center_of_mass_along(model, state, tdmf_leg_direction_of(state), &d->model, d_state);
    const double d_ground_height =
        tdmf_vary_ground_height_at(ground, tdmf_center_of_mass(model, state).x, &d->mode.ground, from_foot.x);
    d_state[TDMF_FOOT_Y] = d_section[TDMF_SECTION_COM_HEIGHT] + d_ground_height - from_foot.y;
    d_state[TDMF_FOOT_VX] = d_section[TDMF_SECTION_COM_SPEED] - from_foot.vx;
    d_state[TDMF_FOOT_VY] = -from_foot.vy;
}

/* Projects a variation at the time of an apex on the section. */
static tdmf_stride_variation on_section(tdmf_system system, const tdmf_motion *motion,
                                        const double derivatives[TDMF_STATE_COUNT], const tdmf_seed *seed,
                                        const double start_com_x, const tdmf_variation *variation) {
    const double *d_state = variation->state;
    const tdmf_point com = tdmf_center_of_mass(system.model, motion->state);
    const tdmf_local_seed d = tdmf_local_seed_of(system.model, seed, NULL);
    const tdmf_point d_com = tdmf_vary_center_of_mass_along(
        system.model, motion->state, tdmf_leg_direction_of(motion->state), &d.model, d_state);
    const tdmf_vector acceleration = tdmf_falling_acceleration(system.model, system.inputs);
    const double shift = d_com.vy / -acceleration.y;
    const double d_com_x = d_com.x + com.vx * shift;
    const double d_ground_height =
        tdmf_vary_ground_height_at(&motion->mode.ground, com.x, &d.mode.ground, d_com_x);
    tdmf_stride_variation result = {
        .apex = {d_com.y + com.vy * shift - d_ground_height, d_com.vx + acceleration.x * shift,
                 d_state[TDMF_LEG_LENGTH] + derivatives[TDMF_LEG_LENGTH] * shift,
                 d_state[TDMF_LEG_ANGLE] + derivatives[TDMF_LEG_ANGLE] * shift,
                 d_state[TDMF_LEG_LENGTH_RATE] + derivatives[TDMF_LEG_LENGTH_RATE] * shift,
                 d_state[TDMF_LEG_ANGLE_RATE] + derivatives[TDMF_LEG_ANGLE_RATE] * shift},
        .foot_x = d_state[TDMF_FOOT_X] + derivatives[TDMF_FOOT_X] * shift,
        .period = shift,
        .length = d_com_x - start_com_x,
        .work = d_state[TDMF_HIP_WORK] + d_state[TDMF_LEG_WORK] + derivatives[TDMF_HIP_WORK] * shift,
    };
    tdmf_write_stance_variation(&variation->stance, &result);
    return result;
}

/* What is asked for. */
typedef struct {
    tdmf_system system;
    const double *section;
    const double *foot_x; /* or NULL: 0, and there is no patch */
    double until;
    bool derivatives, measures;
    const tdmf_seed *seeds;
    int count;
} stride_request;

typedef struct {
    int count;
    tdmf_seed seeds[TDMF_VARIATION_LIMIT];
    tdmf_variation variations[TDMF_VARIATION_LIMIT];
    double start_com_x[TDMF_VARIATION_LIMIT];
    double foot_clearance[TDMF_VARIATION_LIMIT]; /* at the start */
    tdmf_measured measured;
} stride_variations;

/* What a variation begins with: of a coordinate, of a seed, or last of the place of the foot. */
static void begin_variation(const stride_request *request, const tdmf_ground_line *ground,
                            const double state[TDMF_STATE_COUNT], int i, const tdmf_local_seed *d,
                            tdmf_variation *variation) {
    double d_section[TDMF_SECTION_COUNT] = {0.0};
    if (i < TDMF_SECTION_COUNT) {
        d_section[i] = 1.0;
    }
    vary_section_state(request->system.model, ground, state, d_section, d, variation->state);
    if (i == TDMF_SECTION_COUNT + request->count) {
        variation->state[TDMF_FOOT_X] = 1.0;
        variation->state[TDMF_FOOT_Y] =
            tdmf_vary_ground_height_at(ground, state[TDMF_FOOT_X], &d->mode.ground, 1.0);
    }
    variation->liftoff_angle = d_section[TDMF_SECTION_LEG_ANGLE];
    memset(&variation->stance, 0, sizeof variation->stance);
}

static void open_variations(stride_variations *varied, const stride_request *request,
                            const tdmf_ground_line *ground, const double state[TDMF_STATE_COUNT]) {
    static const tdmf_seed none = {0};
    const tdmf_model *model = request->system.model;
    varied->count = TDMF_SECTION_COUNT + request->count + (request->foot_x != NULL);
    for (int i = 0; i < varied->count; ++i) {
        const int given = i - TDMF_SECTION_COUNT;
        varied->seeds[i] = given >= 0 && given < request->count ? request->seeds[given] : none;
        tdmf_variation *variation = &varied->variations[i];
        const tdmf_local_seed d = tdmf_local_seed_of(model, &varied->seeds[i], NULL);
        begin_variation(request, ground, state, i, &d, variation);
        varied->start_com_x[i] = tdmf_vary_center_of_mass_along(model, state, tdmf_leg_direction_of(state),
                                                                &d.model, variation->state)
                                     .x;
        varied->foot_clearance[i] = variation->state[TDMF_FOOT_Y] -
                                    tdmf_vary_ground_height_at(ground, state[TDMF_FOOT_X], &d.mode.ground,
                                                               variation->state[TDMF_FOOT_X]);
    }
}

static void close_variations(stride_variations *varied, const stride_request *request,
                             const tdmf_motion *motion, tdmf_return *result) {
    const tdmf_system system = request->system;
    double derivatives[TDMF_STATE_COUNT];
    tdmf_derivatives(system, &motion->mode, motion->state, derivatives);
    for (int i = 0; i < varied->count; ++i) {
        tdmf_stride_variation at_section = on_section(system, motion, derivatives, &varied->seeds[i],
                                                      varied->start_com_x[i], &varied->variations[i]);
        at_section.foot_clearance = varied->foot_clearance[i];
        if (request->measures) {
            tdmf_vary_measured_end(&varied->measured, i, system, motion, derivatives, at_section.period);
            at_section.measures = varied->measured.varied[i];
        }
        result->variations[i] = at_section;
    }
}

static bool is_sound(const tdmf_solver *solver, const stride_request *request) {
    const bool has_foot_x = request->foot_x != NULL;
    return tdmf_is_sound_solver(solver) && request->system.model != NULL && request->system.inputs != NULL &&
           request->section != NULL &&
           tdmf_are_sound_seeds(request->seeds, request->count, TDMF_RETURN_MAP_SEEDS - has_foot_x) &&
           (has_foot_x || !tdmf_has_patch(request->system.model));
}

/* False where the start is no apex. */
static bool begin_motion(const stride_request *request, tdmf_motion *motion) {
    const double foot_x = request->foot_x == NULL ? 0.0 : *request->foot_x;
    motion->time = 0.0;
    tdmf_section_state_at(request->system, foot_x, request->section, motion->state);
    return tdmf_start(request->system, motion).variable == NULL && motion->record.progress.open.began_at_apex;
}

static tdmf_return stride_from(tdmf_solver *solver, const stride_request *request) {
    const tdmf_system system = request->system;
    tdmf_return result;
    tdmf_motion motion;
    stride_variations varied;
    memset(&result, 0, sizeof result);
    if (!is_sound(solver, request)) {
        result.outcome = TDMF_RETURN_REFUSED;
        return result;
    }
    if (!begin_motion(request, &motion)) {
        result.outcome = TDMF_RETURN_NO_START;
        return result;
    }
    varied.count = 0;
    if (request->derivatives) {
        open_variations(&varied, request, &motion.mode.ground, motion.state);
    }
    result.foot_clearance =
        motion.state[TDMF_FOOT_Y] - tdmf_ground_height_at(&motion.mode.ground, motion.state[TDMF_FOOT_X]);
    const tdmf_stride_outcome ended =
        request->measures ? tdmf_native_stride_measured(solver, system, request->until, &motion, varied.seeds,
                                                        varied.variations, varied.count, &varied.measured)
                          : tdmf_map_stride(solver, system, request->until, &motion, varied.seeds,
                                            varied.variations, varied.count);
    result.outcome = tdmf_return_outcome_of(ended);
    result.solver = ended.outcome;
    if (!ended.closed) {
        return result;
    }
    tdmf_section_of_state(system.model, &motion.mode.ground, motion.state, result.apex);
    result.foot_x = motion.state[TDMF_FOOT_X];
    result.liftoff_angle = motion.mode.liftoff_angle;
    tdmf_write_return(&motion.record, motion.state, &result);
    if (request->measures) {
        result.measures = varied.measured.so_far;
    }
    if (request->derivatives) {
        close_variations(&varied, request, &motion, &result);
    }
    return result;
}

tdmf_return tdmf_return_map(tdmf_solver *solver, tdmf_system system, const double section[TDMF_SECTION_COUNT],
                            double until, bool derivatives, const tdmf_seed *seeds, int count) {
    const stride_request request = {system, section, NULL, until, derivatives, false, seeds, count};
    return stride_from(solver, &request);
}

tdmf_return tdmf_return_map_at(tdmf_solver *solver, tdmf_system system, double foot_x,
                               const double section[TDMF_SECTION_COUNT], double until, bool derivatives,
                               const tdmf_seed *seeds, int count) {
    const stride_request request = {system, section, &foot_x, until, derivatives, false, seeds, count};
    return stride_from(solver, &request);
}

tdmf_return tdmf_measured_return_map(tdmf_solver *solver, tdmf_system system,
                                     const double section[TDMF_SECTION_COUNT], double until, bool derivatives,
                                     const tdmf_seed *seeds, int count) {
    const stride_request request = {system, section, NULL, until, derivatives, true, seeds, count};
    return stride_from(solver, &request);
}
