/* Terrain. In flight the foot is between two heights of those segments that it can reach: the one below
 * is the line in force, the one above waits. Where it comes to either, the segment below it is looked up. As
 * no such height lies between the two, nothing can happen at an edge before. What can be reached is bounded
 * by the centre of mass, which is ballistic, and is down before it is below the line in force. */
#include "terrain.h"

#include "drawn_ground.h"
#include "ground_line.h"
#include "runner.h"
#include "tdmf_slip/kinematics.h"

#include <math.h>

/* Heights that differ by less, over l0, are one. */
static const double same_height = 1e-12;

/* The foot is this near the centre of mass, over l0: half as much is common. */
static const double farthest_foot = 2.0;

/* Farther than so many segments nobody looks. */
static const double max_segments = 1e5;

/* The number of a segment is exact up to here; farther away there are none. */
static const double last_segment = 1e15;

static const tdmf_terrain *terrain_of(const tdmf_runner *runner) {
    return &runner->its_case->rules.terrain;
}

static double height_given(const tdmf_terrain *terrain, uint64_t runner, int64_t segment) {
    const int64_t count = terrain->height_count;
    const int64_t first = (int64_t)(runner % (uint64_t)count);
    const int64_t shifted = (segment % count + first) % count;
    return terrain->heights[shifted < 0 ? shifted + count : shifted];
}

static int64_t segment_at(const tdmf_runner *runner, double x) {
    return (int64_t)fmin(fmax(floor(x / terrain_of(runner)->length), -last_segment), last_segment);
}

static double height_of(tdmf_runner *runner, int64_t segment) {
    tdmf_terrain_view *view = &runner->terrain;
    const tdmf_terrain *terrain = terrain_of(runner);
    const int slot = (int)((uint64_t)segment % TDMF_KNOWN_SEGMENTS);
    const double base = runner->its_case->inputs.ground.height;
    if (terrain->heights) {
        return base + height_given(terrain, runner->number, segment);
    }
    if (view->segments[slot] != segment) {
        view->segments[slot] = segment;
        view->heights[slot] = base + tdmf_segment_height(&runner->its_case->rules, runner->number, segment);
    }
    return view->heights[slot];
}

double tdmf_height_below(tdmf_runner *runner) {
    return height_of(runner, segment_at(runner, runner->motion.state[TDMF_FOOT_X]));
}

static void record_foot(tdmf_runner *runner) {
    runner->terrain.x = runner->motion.state[TDMF_FOOT_X];
    runner->terrain.y = runner->motion.state[TDMF_FOOT_Y];
}

void tdmf_resume_terrain(tdmf_runner *runner, double x, double y) {
    for (int slot = 0; slot < TDMF_KNOWN_SEGMENTS; ++slot) {
        runner->terrain.segments[slot] = slot + 1; /* which belongs into another slot */
    }
    runner->terrain.x = x;
    runner->terrain.y = y;
}

double tdmf_enter_terrain(tdmf_runner *runner, double x) {
    tdmf_resume_terrain(runner, x, INFINITY);
    return height_of(runner, segment_at(runner, x));
}

/* By their numbers, which are whole. */
typedef struct {
    double first, last;
} segments_in_reach;

static bool is_too_wide(segments_in_reach segments) {
    return !(segments.last - segments.first < max_segments && segments.first >= -last_segment &&
             segments.last <= last_segment); /* NaN is */
}

/* Those that the foot has been over since it was looked at. */
static segments_in_reach passed(const tdmf_runner *runner) {
    const double length = terrain_of(runner)->length;
    const double before = runner->terrain.x, now = runner->motion.state[TDMF_FOOT_X];
    const segments_in_reach segments = {floor(fmin(before, now) / length), floor(fmax(before, now) / length)};
    return segments;
}

/* Those that the foot can be over until the centre of mass is down at a height. */
static segments_in_reach reach(const tdmf_runner *runner, const tdmf_point *com, double height) {
    const double length = terrain_of(runner)->length;
    const double gravity = runner->model->parameters.gravity;
    const double over = fmax(0.0, com->y - height);
    const double time = (com->vy + sqrt(com->vy * com->vy + 2.0 * gravity * over)) / gravity;
    const double there = com->x + com->vx * time;
    const double foot = farthest_foot * runner->model->scales.length;
    const segments_in_reach segments = {floor((fmin(com->x, there) - foot) / length),
                                        floor((fmax(com->x, there) + foot) / length)};
    return segments;
}

typedef struct {
    double below, above; /* the nearest heights; infinite where there are none */
} neighbours;

static neighbours neighbours_of(tdmf_runner *runner, segments_in_reach segments, double height) {
    neighbours found = {-INFINITY, INFINITY};
    for (int64_t segment = (int64_t)segments.first; segment <= (int64_t)segments.last; ++segment) {
        const double its = height_of(runner, segment);
        if (its <= height) {
            found.below = fmax(found.below, its);
        } else {
            found.above = fmin(found.above, its);
        }
    }
    return found;
}

/* Whether the foot has swung, or slipped, into the face of a segment since it was looked at: it has been
 * between heights of segments, so each that is higher than it was at one end is above it. */
static bool has_met_face(tdmf_runner *runner) {
    const tdmf_terrain_view *view = &runner->terrain;
    const double *state = runner->motion.state;
    const double low = fmin(view->y, state[TDMF_FOOT_Y]) + same_height * runner->model->scales.length;
    const segments_in_reach between = passed(runner);
    for (int64_t segment = (int64_t)between.first; segment <= (int64_t)between.last; ++segment) {
        if (height_of(runner, segment) > low) {
            return true;
        }
    }
    return false;
}

static bool give_up(tdmf_runner *runner, tdmf_fate fate) {
    tdmf_runner_give_up(runner, fate);
    return false;
}

/* Whether a foot that trips ends the run where it has come to: at a face, or with too many segments behind it
 * to tell. */
static bool trips(tdmf_runner *runner) {
    if (!runner->its_case->rules.trips) {
        return false;
    }
    const bool knows = !is_too_wide(passed(runner));
    if (knows && !has_met_face(runner)) {
        return false;
    }
    return !give_up(runner, knows ? TDMF_FATE_FELL : TDMF_FATE_UNSOLVED);
}

/* The height of the segment that bears a foot at this height: the one below it, or, where that is higher, the
 * one from which the foot came to its face. */
static double height_that_bears(tdmf_runner *runner, double foot) {
    const tdmf_point com = tdmf_center_of_mass(runner->model, runner->motion.state);
    const int64_t below = segment_at(runner, runner->motion.state[TDMF_FOOT_X]);
    const int64_t back = com.vx > 0.0 ? -1 : 1;
    for (int64_t steps = 0; steps < (int64_t)max_segments; ++steps) {
        const double height = height_of(runner, below + back * steps);
        if (height <= foot) {
            return height;
        }
    }
    return -INFINITY;
}

/* The lines next to a height at which the foot is; below all that is in reach the runner has fallen. */
static bool set_lines(tdmf_runner *runner, double height) {
    tdmf_motion *motion = &runner->motion;
    const tdmf_point com = tdmf_center_of_mass(runner->model, motion->state);
    const double away = fabs(com.x - motion->state[TDMF_FOOT_X]);
    segments_in_reach segments = reach(runner, &com, height);
    if (away > farthest_foot * runner->model->scales.length || is_too_wide(segments)) {
        return give_up(runner, TDMF_FATE_UNSOLVED);
    }
    /* A line lower than the foot is met later, and more can be reached until then. */
    const double bearing = height_that_bears(runner, height);
    const double lower = fmax(bearing, neighbours_of(runner, segments, height).below);
    if (!isfinite(lower)) {
        return give_up(runner, TDMF_FATE_FELL);
    }
    segments = reach(runner, &com, lower);
    if (is_too_wide(segments)) {
        return give_up(runner, TDMF_FATE_UNSOLVED);
    }
    const neighbours next = neighbours_of(runner, segments, height);
    const double below = fmax(bearing, next.below);
    motion->mode.ground = tdmf_ground_line_of(below, 0.0);
    runner->inputs.ground.height = isfinite(next.above) ? next.above : below;
    return true;
}

bool tdmf_look_at_terrain(tdmf_runner *runner) {
    const double margin = same_height * runner->model->scales.length;
    const double foot = runner->motion.state[TDMF_FOOT_Y];
    if (trips(runner)) {
        return false;
    }
    record_foot(runner);
    return set_lines(runner, foot + margin);
}

/* The segment below the foot has a friction of its own. */
static void land_on(tdmf_runner *runner) {
    const tdmf_ensemble_case *its_case = runner->its_case;
    if (its_case->rules.friction_spread != 0.0) {
        const int64_t segment = segment_at(runner, runner->motion.state[TDMF_FOOT_X]);
        runner->inputs.ground.friction = tdmf_drawn_friction(
            &its_case->rules, its_case->inputs.ground.friction, runner->number, (uint32_t)segment);
    }
}

bool tdmf_meets_segment(tdmf_runner *runner, bool *ended) {
    const double margin = same_height * runner->model->scales.length;
    const double line = runner->motion.mode.ground.height;
    *ended = trips(runner);
    if (*ended) {
        return false;
    }
    record_foot(runner);
    if (fabs(height_that_bears(runner, line + margin) - line) <= margin) {
        runner->inputs.ground.height = line;
        land_on(runner);
        return true;
    }
    *ended = !set_lines(runner, line - margin);
    return false;
}
