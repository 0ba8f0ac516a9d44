/* "Find the gait": settling, Newton's method, eigenvalues. */
#include "values.h"

#include <stdio.h>
#include <string.h>

static const double tolerance = 1e-13; /* as `tdmf-slip gait` has it */

static double jacobian[TDMF_SECTION_COUNT * TDMF_SECTION_COUNT]; /* by rows */
static double eigenvalues[2 * TDMF_SECTION_COUNT];
static char word[TDMF_WORD_CAPACITY];
static double scales[TDMF_SECTION_COUNT];

LIVE_EXPORT(live_gait_eigenvalues)
double *live_gait_eigenvalues(void) {
    return eigenvalues;
}

LIVE_EXPORT(live_gait_word)
const char *live_gait_word(void) {
    return word;
}

/* Scales of the section's coordinates, for the values accepted last. */
LIVE_EXPORT(live_section_scales)
double *live_section_scales(void) {
    tdmf_section_scales(&live.model, scales);
    return scales;
}

static tdmf_solver tight_solver(void) {
    tdmf_solver solver = tdmf_solver_default();
    solver.relative_tolerance = tolerance;
    return solver;
}

static tdmf_stride_request request_by(tdmf_solver *solver) {
    const tdmf_stride_request request = {.solver = solver, .system = live_system(), .apex = live.section};
    return request;
}

/* Runs so many strides from the apex in the section and writes the last; gives how many closed. */
LIVE_EXPORT(live_settle)
int live_settle(int strides) {
    tdmf_solver solver = tight_solver();
    const tdmf_stride_request request = request_by(&solver);
    return tdmf_settle(&request, strides, live.section);
}

static const char *reason(const tdmf_orbit *orbit) {
    switch (orbit->outcome) {
    case TDMF_ORBIT_NOT_FOUND:
        return "Newton's method did not converge";
    case TDMF_ORBIT_NO_START:
        return "there is no apex above the ground";
    case TDMF_ORBIT_NO_STRIDE:
        return "no stride was completed within the time limit";
    default:
        return tdmf_outcome_text(orbit->stride.solver);
    }
}

static bool find_eigenvalues(const tdmf_orbit *orbit) {
    for (int row = 0; row < TDMF_SECTION_COUNT; ++row) {
        for (int column = 0; column < TDMF_SECTION_COUNT; ++column) {
            jacobian[TDMF_SECTION_COUNT * row + column] = orbit->stride.variations[column].apex[row];
        }
    }
    return tdmf_eigenvalues(TDMF_SECTION_COUNT, jacobian, eigenvalues);
}

static void write_stride(const tdmf_return *stride) {
    const double none[TDMF_STATE_COUNT] = {0.0};
    tdmf_outputs outputs;
    memset(&outputs, 0, sizeof outputs);
    outputs.stride = stride->stride;
    outputs.hip.liftoff_angle = stride->liftoff_angle;
    live_write_outputs(&outputs, none);
    memcpy(word, stride->stride.word, sizeof word);
}

static bool has_patch(void) {
    return live.model.parameters.ground.patch_begin < live.model.parameters.ground.patch_end;
}

/* The gait near the apex in the section, which becomes the gait's; its stride is in the outputs. Where there
 * is none, the message says why. */
LIVE_EXPORT(live_find_gait)
bool live_find_gait(void) {
    tdmf_solver solver = tight_solver();
    live.message[0] = '\0';
    if (!(live.inputs.ground.friction > 0.0)) {
        snprintf(live.message, sizeof live.message,
                 "ground.friction = 0: without friction a gait exists at every speed, so none is isolated; "
                 "allowed for gaits: above 0");
        return false;
    }
    if (has_patch()) {
        snprintf(live.message, sizeof live.message,
                 "No gait was searched for: on a slippery patch a stride depends on where the foot is; "
                 "allowed for gaits: ground.patch_begin = ground.patch_end, for no patch.");
        return false;
    }
    const tdmf_stride_request request = request_by(&solver);
    tdmf_orbit orbit;
    tdmf_find_orbit(&request, &orbit);
    if (orbit.outcome != TDMF_ORBIT_FOUND) {
        snprintf(live.message, sizeof live.message, "No gait was found: %s.", reason(&orbit));
        return false;
    }
    if (!find_eigenvalues(&orbit)) {
        snprintf(live.message, sizeof live.message,
                 "The gait's stride is on the edge of an event or of a law, where it has no derivatives.");
        return false;
    }
    memcpy(live.section, orbit.apex, sizeof live.section);
    write_stride(&orbit.stride);
    return true;
}
