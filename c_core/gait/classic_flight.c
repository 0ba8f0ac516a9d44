/* The foot comes down where its height F first falls to 0. Along a change with something, the time of
 * touchdown changes by dt = -dF/F', dF being the change at one time. As the spring is relaxed at touchdown
 * and at take-off, and the acceleration that of flight, nothing else changes with these instants: no
 * saltation is needed. The laws are in equations/classic_slip.py. */
#include "classic_flight.h"

#include "classic_slip_laws.h"
#include "ground_line.h"
#include "swinging_height.h"

#include <math.h>
#include <stddef.h>

static const double right_angle = 1.5707963267948966;

tdmf_ground_line tdmf_classic_ground(const tdmf_classic *slip) {
    return tdmf_ground_line_of(0.0, slip->ground_slope);
}

static bool is_allowed(const tdmf_classic *slip) {
    return slip != NULL && slip->mass > 0.0 && slip->stiffness > 0.0 && slip->free_length > 0.0 &&
           slip->gravity > 0.0 && fabs(slip->touchdown_angle) < right_angle && slip->friction >= 0.0 &&
           fabs(slip->ground_slope) < 1.0 &&
           isfinite(slip->mass + slip->stiffness + slip->free_length + slip->gravity + slip->retraction_rate);
}

/* ---- to touchdown ------------------------------------------------------------------------------------- */

/* What the fall begins with. */
typedef struct {
    double height, speed;
    tdmf_ground_line ground;
} apex;

static bool begins(const tdmf_classic *slip, double energy, double height, apex *from) {
    if (!is_allowed(slip)) {
        return false;
    }
    from->height = height;
    from->speed = tdmf_classic_speed(slip, energy, height);
    from->ground = tdmf_classic_ground(slip);
    return from->speed > 0.0 && tdmf_classic_clearance(slip, &from->ground, height, from->speed, 0.0) > 0.0;
}

/* How fast a leg that is held comes down: then F is a parabola. */
static double fall_speed_of_fixed_leg(const tdmf_classic *slip, const apex *from) {
    const double clearance = tdmf_classic_clearance(slip, &from->ground, from->height, from->speed, 0.0);
    const double climb = from->speed * (from->ground.sine / from->ground.cosine);
    const double root = sqrt(climb * climb + 2.0 * slip->gravity * clearance);
    return climb > 0.0 ? 2.0 * slip->gravity * clearance / (climb + root) : root - climb;
}

static double fall_speed_of_retracted_leg(const tdmf_classic *slip, const apex *from) {
    const tdmf_swinging_height over_ground = {tdmf_velocity_off(&from->ground, 0.0, from->height),
                                              tdmf_velocity_off(&from->ground, from->speed, 0.0),
                                              tdmf_velocity_off(&from->ground, 0.0, -slip->gravity),
                                              slip->free_length,
                                              slip->touchdown_angle - slip->ground_slope,
                                              slip->retraction_rate};
    return slip->gravity * tdmf_first_zero(&over_ground);
}

/* What a step is varied by, as changes of what it is made with. */
typedef struct {
    tdmf_classic slip;
    double energy, height;
} seed;

static const seed seeds[TDMF_CLASSIC_VARIATIONS] = {
    [TDMF_CLASSIC_BY_HEIGHT] = {.height = 1.0},
    [TDMF_CLASSIC_BY_ENERGY] = {.energy = 1.0},
    [TDMF_CLASSIC_BY_TOUCHDOWN_ANGLE] = {.slip = {.touchdown_angle = 1.0}},
    [TDMF_CLASSIC_BY_GROUND_SLOPE] = {.slip = {.ground_slope = 1.0}},
    [TDMF_CLASSIC_BY_RETRACTION_RATE] = {.slip = {.retraction_rate = 1.0}},
};

static tdmf_ground_line variation_of_ground(const seed *d) {
    const tdmf_ground_line change = {.slope = d->slip.ground_slope};
    return change;
}

/* The standing foot's variations: d_ stands for the change of what follows. */
static void vary_landing(const tdmf_classic *slip, double energy, const apex *from, double time,
                         tdmf_classic_standing *standing) {
    static const seed none = {.height = 0.0};
    static const tdmf_ground_line same = {.slope = 0.0};
    const double clearance_rate = tdmf_vary_classic_clearance(slip, &from->ground, from->height, from->speed,
                                                              time, &none.slip, &same, 0.0, 0.0, 1.0);
    for (int k = 0; k < TDMF_CLASSIC_VARIATIONS; ++k) {
        const seed *d = &seeds[k];
        const tdmf_ground_line d_ground = variation_of_ground(d);
        const double d_speed =
            tdmf_vary_classic_speed(slip, energy, from->height, &d->slip, d->energy, d->height);
        const double d_time =
            -tdmf_vary_classic_clearance(slip, &from->ground, from->height, from->speed, time, &d->slip,
                                         &d_ground, d->height, d_speed, 0.0) /
            clearance_rate;
        standing->varied[k] = tdmf_vary_classic_landing(slip, from->speed, time, &d->slip, d_speed, d_time);
        standing->foot_varied[k] = tdmf_vary_classic_foot_from_apex(from->speed, time, standing->at, d_speed,
                                                                    d_time, standing->varied[k]);
    }
}

tdmf_classic_outcome tdmf_classic_land(const tdmf_classic *slip, double energy, double height,
                                       tdmf_classic_standing *standing) {
    apex from;
    if (!begins(slip, energy, height, &from)) {
        return TDMF_CLASSIC_NO_START;
    }
    const double fall_speed = slip->retraction_rate == 0.0 ? fall_speed_of_fixed_leg(slip, &from)
                                                           : fall_speed_of_retracted_leg(slip, &from);
    if (!(fall_speed > 0.0) || !isfinite(fall_speed)) {
        return TDMF_CLASSIC_NO_START;
    }
    const double time = fall_speed / slip->gravity;
    standing->touchdown_angle = slip->touchdown_angle - slip->retraction_rate * time;
    standing->at = tdmf_classic_landing(slip, from.speed, time);
    standing->foot = tdmf_classic_foot_from_apex(from.speed, time, standing->at);
    vary_landing(slip, energy, &from, time, standing);
    return tdmf_height_over(&from.ground, standing->at.x, standing->at.y) > 0.0 ? TDMF_CLASSIC_FLIES
                                                                                : TDMF_CLASSIC_FALLS;
}

double tdmf_classic_impact_friction(const tdmf_classic *slip, tdmf_classic_point touchdown) {
    const tdmf_ground_line ground = tdmf_classic_ground(slip);
    const tdmf_vector foot = tdmf_classic_foot_velocity(slip, touchdown);
    return fabs(tdmf_velocity_along(&ground, foot.x, foot.y) / tdmf_velocity_off(&ground, foot.x, foot.y));
}

/* ---- from take-off ------------------------------------------------------------------------------------ */

void tdmf_classic_fly(const tdmf_classic *slip, const tdmf_classic_standing *standing,
                      tdmf_classic_step *step) {
    const tdmf_ground_line ground = tdmf_classic_ground(slip);
    const tdmf_classic_point at = standing->at;
    const tdmf_classic_variation next = tdmf_classic_next_apex(slip, &ground, at, standing->foot);
    tdmf_classic_variation *const varied[TDMF_CLASSIC_VARIATIONS] = {
        [TDMF_CLASSIC_BY_HEIGHT] = &step->by_height,
        [TDMF_CLASSIC_BY_ENERGY] = &step->by_energy,
        [TDMF_CLASSIC_BY_TOUCHDOWN_ANGLE] = &step->by_touchdown_angle,
        [TDMF_CLASSIC_BY_GROUND_SLOPE] = &step->by_ground_slope,
        [TDMF_CLASSIC_BY_RETRACTION_RATE] = &step->by_retraction_rate,
    };
    if (!(next.height > 0.0)) {
        step->outcome = TDMF_CLASSIC_FALLS;
        return;
    }
    step->outcome = at.vx > 0.0 ? TDMF_CLASSIC_FLIES : TDMF_CLASSIC_TURNS_BACK;
    step->next_height = next.height;
    step->next_speed = at.vx;
    step->next_energy = next.energy;
    step->length = next.length;
    for (int k = 0; k < TDMF_CLASSIC_VARIATIONS; ++k) {
        const tdmf_ground_line d_ground = variation_of_ground(&seeds[k]);
        *varied[k] = tdmf_vary_classic_next_apex(slip, &ground, at, standing->foot, &seeds[k].slip, &d_ground,
                                                 standing->varied[k], standing->foot_varied[k]);
    }
}
