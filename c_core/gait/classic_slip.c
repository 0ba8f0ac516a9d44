/* Stance (1) is the motion of a foot that sticks, in equations/ground.py, by a leg without mass and damper.
 * Its axes are upright whatever the slope of the ground, against which the mass and the leg are held by the
 * guards alone. */
#include "classic_flight.h"
#include "first_root.h"
#include "friction_laws.h"
#include "ground_line.h"
#include "powers.h"
#include "series_sums.h"
#include "stick_series.h"

#include <float.h>
#include <stddef.h>

enum { ORDER = 20, STEP_LIMIT = 100000, ITERATION_LIMIT = 60 };

static const double tolerance = 1e-15;

/* A guard counts as crossed beyond this, in its scale. */
static const double beyond = -1e-14;

tdmf_classic tdmf_classic_default(void) {
    const tdmf_classic slip = {
        .mass = 80.0,
        .stiffness = 20000.0,
        .free_length = 1.0,
        .gravity = 9.81,
        .touchdown_angle = 0.69813170079773184, /* 40 degrees */
        .friction = INFINITY,
    };
    return slip;
}

/* What the motion depends on: a leg without mass and damper, upright axes. */
static ground_coefficients coefficients_of(const tdmf_classic *slip) {
    const ground_coefficients coefficients = {
        .stiffness = slip->stiffness,
        .rest_length = slip->free_length,
        .inverse_body_mass = 1.0 / slip->mass,
        .gravity_y = slip->gravity,
    };
    return coefficients;
}

static ground_start start_at(tdmf_classic_point point) {
    const ground_start start = {.x = point.x, .y = point.y, .vx = point.vx, .vy = point.vy};
    return start;
}

static void expand_stance(const tdmf_classic *slip, tdmf_classic_point point, ground_series *s) {
    const ground_coefficients coefficients = coefficients_of(slip);
    const ground_start start = start_at(point);
    tdmf_begin_ground(&start, s);
    expand_stick(&coefficients, ORDER, s);
}

/* Where a small change leads in some time. */
static tdmf_classic_point varied_at(const tdmf_classic *slip, const ground_series *s, tdmf_classic_point from,
                                    tdmf_classic_point d_from, double time) {
    static const ground_coefficients unchanged = {.stiffness = 0.0};
    const ground_coefficients coefficients = coefficients_of(slip);
    const ground_start start = start_at(from), d_start = start_at(d_from);
    ground_variation d;
    tdmf_vary_begin_ground(&start, &d_start, &d);
    vary_stick(&coefficients, s, &unchanged, ORDER, &d);
    const tdmf_classic_point point = {series_at(d.x, ORDER, time), series_at(d.y, ORDER, time),
                                      series_at(d.vx, ORDER, time), series_at(d.vy, ORDER, time)};
    return point;
}

static tdmf_classic_point point_at(const ground_series *s, double time) {
    const tdmf_classic_point point = {series_at(s->x, ORDER, time), series_at(s->y, ORDER, time),
                                      series_at(s->vx, ORDER, time), series_at(s->vy, ORDER, time)};
    return point;
}

/* How long the series are as good as rounding. */
static double trusted_size(const tdmf_classic *slip, const ground_series *s) {
    const double speed = slip->free_length * sqrt(slip->stiffness / slip->mass);
    const double last = (fabs(s->vx[ORDER]) + fabs(s->vy[ORDER])) / speed;
    const double last_but_one = (fabs(s->vx[ORDER - 1]) + fabs(s->vy[ORDER - 1])) / speed;
    return fmin(pow(tolerance / fmax(last, DBL_MIN), 1.0 / (double)ORDER),
                pow(tolerance / fmax(last_but_one, DBL_MIN), 1.0 / (double)(ORDER - 1)));
}

/* What ends a stance. */
typedef enum { GOES_ON, TAKES_OFF, LEAVES_CONE, SLIDES_OUT, HITS_GROUND } stance_end;

/* A polynomial in the share of a step, by the size of which a series is scaled. */
typedef struct {
    double c[SERIES_TERMS];
} polynomial;

static double first_time(const polynomial *p, double scale, double size) {
    const root found = first_root(p->c, ORDER, beyond * scale, 0.0, 1.0, true);
    return found.is_root ? found.time * size : INFINITY;
}

/* What the cone leaves for a force along the leg: a foot that never slips is in it while it pushes down. */
static double room_in_cone(const tdmf_classic *slip, double sign, double along, double off) {
    const tdmf_ground_force along_leg = {.tangential = along, .normal = off};
    return isinf(slip->friction) ? off : tdmf_room_in_cone(slip->friction, sign, along_leg);
}

static stance_end find_end(const tdmf_classic *slip, const ground_series *s, double *size) {
    const double length = slip->free_length;
    polynomial compressed, above_ground;
    polynomial inside_cone[2]; /* the mass before the foot, and behind */
    const tdmf_ground_line line = tdmf_classic_ground(slip);
    double power[SERIES_TERMS];
    stance_end end = GOES_ON;
    set_powers(power, *size, ORDER);
    for (int k = 0; k <= ORDER; ++k) {
        const double along = tdmf_offset_along(&line, s->x[k], s->y[k]) * power[k];
        const double off = tdmf_height_over(&line, s->x[k], s->y[k]) * power[k];
        compressed.c[k] = (k == 0 ? length * length : 0.0) - s->square[k] * power[k];
        inside_cone[0].c[k] = room_in_cone(slip, -1.0, along, off);
        inside_cone[1].c[k] = room_in_cone(slip, 1.0, along, off);
        above_ground.c[k] = off;
    }
    const double take_off = first_time(&compressed, length * length, *size);
    const double cone = first_time(&inside_cone[0], length, *size);
    const double slide = first_time(&inside_cone[1], length, *size);
    const double ground = first_time(&above_ground, length, *size);
    if (take_off <= *size) {
        *size = take_off;
        end = TAKES_OFF;
    }
    if (cone < *size) {
        *size = cone;
        end = LEAVES_CONE;
    }
    if (slide < *size) {
        *size = slide;
        end = SLIDES_OUT;
    }
    if (ground < *size) {
        *size = ground;
        end = HITS_GROUND;
    }
    return end;
}

typedef struct {
    tdmf_classic_standing standing;
    double time;
    double steepest; /* the largest |tan| of the leg's angle from the ground's normal so far */
} stance;

static double steepness(const tdmf_classic *slip, tdmf_classic_point at) {
    const tdmf_ground_line line = tdmf_classic_ground(slip);
    return fabs(tdmf_offset_along(&line, at.x, at.y) / tdmf_height_over(&line, at.x, at.y));
}

/* The largest |tan| of that angle in a step: at its end, or where the leg turns back. */
static double steepest_in(const tdmf_classic *slip, const ground_series *s, double size) {
    const double moment = slip->free_length * slip->free_length * sqrt(slip->stiffness / slip->mass);
    double turning[SERIES_TERMS], power[SERIES_TERMS];
    set_powers(power, size, ORDER);
    for (int k = 0; k <= ORDER; ++k) {
        turning[k] = s->moment[k] * power[k];
    }
    const root extremum = first_sign_change(turning, ORDER, 1e-14 * moment, 0.0, 1.0, true);
    const double at_end = steepness(slip, point_at(s, size));
    return extremum.is_root ? fmax(at_end, steepness(slip, point_at(s, extremum.time * size))) : at_end;
}

/* Runs a stance to its end or up to a time; steps that do not end, or are not finite, count as a fall. */
static stance_end run_stance(const tdmf_classic *slip, double until, stance *run) {
    tdmf_classic_standing *standing = &run->standing;
    for (int i = 0; i < STEP_LIMIT; ++i) {
        ground_series series;
        expand_stance(slip, standing->at, &series);
        double size = fmin(trusted_size(slip, &series), until - run->time);
        if (!(size > 0.0) || !isfinite(size)) {
            return run->time < until ? HITS_GROUND : GOES_ON;
        }
        const stance_end end = find_end(slip, &series, &size);
        for (int k = 0; k < TDMF_CLASSIC_VARIATIONS; ++k) {
            standing->varied[k] = varied_at(slip, &series, standing->at, standing->varied[k], size);
        }
        standing->at = point_at(&series, size);
        run->time += size;
        run->steepest = fmax(run->steepest, steepest_in(slip, &series, size));
        if (end != GOES_ON) {
            return end;
        }
    }
    return HITS_GROUND;
}

/* Flies from an apex to touchdown; see tdmf_classic_land. */
static tdmf_classic_outcome touch_down(const tdmf_classic *slip, double energy, double height, stance *run) {
    const tdmf_classic_outcome landed = tdmf_classic_land(slip, energy, height, &run->standing);
    if (landed == TDMF_CLASSIC_FLIES) {
        run->time = 0.0;
        run->steepest = fabs(tan(run->standing.touchdown_angle - slip->ground_slope));
    }
    return landed;
}

tdmf_classic_step tdmf_classic_return_map(const tdmf_classic *slip, double energy, double height) {
    stance run;
    tdmf_classic_step step = {.outcome = touch_down(slip, energy, height, &run)};
    if (step.outcome != TDMF_CLASSIC_FLIES) {
        return step;
    }
    step.touchdown = run.standing.at;
    step.impact_friction = tdmf_classic_impact_friction(slip, step.touchdown);
    step.stance_friction = run.steepest;
    if (step.stance_friction > slip->friction) {
        step.outcome = TDMF_CLASSIC_SLIDES;
        return step;
    }
    const stance_end end = run_stance(slip, INFINITY, &run);
    step.take_off = run.standing.at;
    step.stance_time = run.time;
    step.early_take_off = end == LEAVES_CONE;
    step.stance_friction = run.steepest;
    if (end == SLIDES_OUT) {
        step.outcome = TDMF_CLASSIC_SLIDES;
    } else if ((end == TAKES_OFF || end == LEAVES_CONE) && step.take_off.vy > 0.0) {
        tdmf_classic_fly(slip, &run.standing, &step);
    } else {
        step.outcome = TDMF_CLASSIC_FALLS;
    }
    return step;
}

tdmf_classic_point tdmf_classic_stance(const tdmf_classic *slip, double energy, double height, double time) {
    tdmf_classic_point nothing = {NAN, NAN, NAN, NAN};
    stance run;
    if (touch_down(slip, energy, height, &run) != TDMF_CLASSIC_FLIES || !(time >= 0.0)) {
        return nothing;
    }
    run_stance(slip, time, &run);
    return run.standing.at;
}

bool tdmf_classic_fixed_point(const tdmf_classic *slip, double energy, double guess, double *height) {
    double at = guess;
    for (int i = 0; height != NULL && i < ITERATION_LIMIT; ++i) {
        const tdmf_classic_step step = tdmf_classic_return_map(slip, energy, at);
        if (step.outcome != TDMF_CLASSIC_FLIES || step.early_take_off) {
            return false;
        }
        const double correction = (step.next_height - at) / (1.0 - step.by_height.height);
        at += correction;
        if (!(fabs(correction) > 1e-13 * slip->free_length)) {
            *height = at;
            return isfinite(at);
        }
    }
    return false;
}

bool tdmf_classic_fold(const tdmf_classic *slip, double energy, double *angle, double *height) {
    const double small = 1e-5;
    if (slip == NULL || angle == NULL || height == NULL) {
        return false;
    }
    tdmf_classic at = *slip;
    double y = *height;
    at.touchdown_angle = *angle;
    for (int i = 0; i < ITERATION_LIMIT; ++i) {
        tdmf_classic ahead = at, behind = at;
        ahead.touchdown_angle += small;
        behind.touchdown_angle -= small;
        const double d_y = small * slip->free_length;
        const tdmf_classic_step here = tdmf_classic_return_map(&at, energy, y);
        /* The slope's own derivatives, by differences of the exact slope: they steer the iteration, no more.
         */
        const double curvature = (tdmf_classic_return_map(&at, energy, y + d_y).by_height.height -
                                  tdmf_classic_return_map(&at, energy, y - d_y).by_height.height) /
                                 (2.0 * d_y);
        const double mixed = (tdmf_classic_return_map(&ahead, energy, y).by_height.height -
                              tdmf_classic_return_map(&behind, energy, y).by_height.height) /
                             (2.0 * small);
        if (here.outcome != TDMF_CLASSIC_FLIES) {
            return false;
        }
        const double off = here.next_height - y;
        const double steep = here.by_height.height - 1.0;
        const double determinant = steep * mixed - here.by_touchdown_angle.height * curvature;
        const double correction_y = -(off * mixed - here.by_touchdown_angle.height * steep) / determinant;
        const double correction_angle = -(steep * steep - curvature * off) / determinant;
        y += correction_y;
        at.touchdown_angle += correction_angle;
        if (!(fabs(correction_y) + fabs(correction_angle) * slip->free_length > 1e-9 * slip->free_length)) {
            *angle = at.touchdown_angle;
            *height = y;
            return isfinite(y + at.touchdown_angle);
        }
    }
    return false;
}
