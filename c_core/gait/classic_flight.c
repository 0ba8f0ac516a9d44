/* An apex is at the height h over the ground below it, with the speed v of the energy m (v^2/2 + g h). With
 * t the time since and phi = theta0 - omega t the leg's angle, the foot comes down where
 *
 *     F = h - g t^2/2 - l0 cos(phi) - (v t + l0 sin(phi)) tan(sigma)
 *
 * first falls to 0. Along a change with something, the time of touchdown changes by dt = -dF/F', dF being the
 * change at one time. As the spring is relaxed at touchdown and at take-off, and the acceleration that of
 * flight, nothing else changes with these instants: no saltation is needed. */
#include "classic_flight.h"

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

/* What the fall begins with: the height and the forward speed, the ground, and the leg's way down, F for phi
 * = theta0 at t = 0. */
typedef struct {
    double height, speed;
    tdmf_ground_line ground;
    double tangent, clearance;
} apex;

static bool begins(const tdmf_classic *slip, double energy, double height, apex *from) {
    if (!is_allowed(slip)) {
        return false;
    }
    const double speed_square = 2.0 * (energy / slip->mass - slip->gravity * height);
    if (!(speed_square > 0.0)) {
        return false;
    }
    const double length = slip->free_length;
    from->height = height;
    from->speed = sqrt(speed_square);
    from->ground = tdmf_classic_ground(slip);
    from->tangent = from->ground.sine / from->ground.cosine;
    from->clearance =
        height - length * cos(slip->touchdown_angle) - length * sin(slip->touchdown_angle) * from->tangent;
    return from->clearance > 0.0;
}

/* How fast a leg that is held comes down: then F is a parabola. */
static double fall_speed_of_fixed_leg(const tdmf_classic *slip, const apex *from) {
    const double climb = from->speed * from->tangent;
    const double root = sqrt(climb * climb + 2.0 * slip->gravity * from->clearance);
    return climb > 0.0 ? 2.0 * slip->gravity * from->clearance / (climb + root) : root - climb;
}

static double fall_speed_of_retracted_leg(const tdmf_classic *slip, const apex *from) {
    const tdmf_swinging_height over_ground = {
        from->height * from->ground.cosine,         -from->speed * from->ground.sine,
        -slip->gravity * from->ground.cosine,       slip->free_length,
        slip->touchdown_angle - slip->ground_slope, slip->retraction_rate};
    return slip->gravity * tdmf_first_zero(&over_ground);
}

/* The change of F, at one time, with each argument, times g. */
static void vary_clearance(const tdmf_classic *slip, const apex *from, double time, double sine,
                           double cosine, double varied[TDMF_CLASSIC_VARIATIONS]) {
    const double g = slip->gravity;
    const double length = slip->free_length;
    const double by_angle = g * length * (sine - from->tangent * cosine);
    const double forwards = from->tangent * time;
    const double secant = 1.0 / from->ground.cosine;
    varied[TDMF_CLASSIC_BY_HEIGHT] = g * (1.0 + forwards * g / from->speed);
    varied[TDMF_CLASSIC_BY_ENERGY] = -g * forwards / (slip->mass * from->speed);
    varied[TDMF_CLASSIC_BY_TOUCHDOWN_ANGLE] = by_angle;
    varied[TDMF_CLASSIC_BY_GROUND_SLOPE] = -g * secant * secant * (from->speed * time + length * sine);
    varied[TDMF_CLASSIC_BY_RETRACTION_RATE] = -time * by_angle;
}

/* The standing foot's variations: d_ stands for the change of what follows. */
static void vary_landing(const tdmf_classic *slip, const apex *from, double time,
                         tdmf_classic_standing *standing) {
    const double length = slip->free_length;
    const double rate = slip->retraction_rate;
    const tdmf_classic_point *at = &standing->at;
    const double sine = -at->x / length, cosine = at->y / length;
    const double d_speed[TDMF_CLASSIC_VARIATIONS] = {[TDMF_CLASSIC_BY_HEIGHT] = -slip->gravity / from->speed,
                                                     [TDMF_CLASSIC_BY_ENERGY] =
                                                         1.0 / (slip->mass * from->speed)};
    const double d_angle_at_one_time[TDMF_CLASSIC_VARIATIONS] = {
        [TDMF_CLASSIC_BY_TOUCHDOWN_ANGLE] = 1.0, [TDMF_CLASSIC_BY_RETRACTION_RATE] = -time};
    const double clearance_rate =
        at->vy - from->tangent * (at->vx - rate * length * cosine) - rate * length * sine;
    double d_clearance[TDMF_CLASSIC_VARIATIONS];
    vary_clearance(slip, from, time, sine, cosine, d_clearance);
    for (int k = 0; k < TDMF_CLASSIC_VARIATIONS; ++k) {
        const double d_vy = d_clearance[k] / clearance_rate;
        const double d_time = -d_vy / slip->gravity;
        const double d_angle = d_angle_at_one_time[k] - rate * d_time;
        const tdmf_classic_point varied = {-length * cosine * d_angle, -length * sine * d_angle, d_speed[k],
                                           d_vy};
        standing->varied[k] = varied;
        standing->foot_varied[k] = from->speed * d_time + time * d_speed[k] - varied.x;
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
    const double angle = slip->touchdown_angle - slip->retraction_rate * time;
    const tdmf_classic_point at = {-slip->free_length * sin(angle), slip->free_length * cos(angle),
                                   from.speed, -fall_speed};
    standing->touchdown_angle = angle;
    standing->at = at;
    standing->foot = from.speed * time - at.x;
    vary_landing(slip, &from, time, standing);
    return tdmf_height_over(&from.ground, at.x, at.y) > 0.0 ? TDMF_CLASSIC_FLIES : TDMF_CLASSIC_FALLS;
}

double tdmf_classic_impact_friction(const tdmf_classic *slip, tdmf_classic_point touchdown) {
    const tdmf_ground_line ground = tdmf_classic_ground(slip);
    const double foot_vx = touchdown.vx - slip->retraction_rate * touchdown.y;
    const double foot_vy = touchdown.vy + slip->retraction_rate * touchdown.x;
    return fabs(tdmf_velocity_along(&ground, foot_vx, foot_vy) /
                tdmf_velocity_off(&ground, foot_vx, foot_vy));
}

/* ---- from take-off ------------------------------------------------------------------------------------ */

static tdmf_classic_variation vary_apex(const tdmf_classic *slip, const tdmf_classic_standing *standing,
                                        int k, double d_tangent) {
    const double g = slip->gravity;
    const tdmf_ground_line ground = tdmf_classic_ground(slip);
    const tdmf_classic_point *at = &standing->at, *d = &standing->varied[k];
    const double ahead = at->x + at->vx * at->vy / g;
    const double d_ahead = d->x + (d->vx * at->vy + at->vx * d->vy) / g;
    tdmf_classic_variation change;
    change.height = d->y + at->vy * d->vy / g - ground.sine / ground.cosine * d_ahead - d_tangent * ahead;
    change.length = standing->foot_varied[k] + d_ahead;
    change.energy = slip->mass * (at->vx * d->vx + g * change.height);
    return change;
}

void tdmf_classic_fly(const tdmf_classic *slip, const tdmf_classic_standing *standing,
                      tdmf_classic_step *step) {
    const double g = slip->gravity;
    const tdmf_ground_line ground = tdmf_classic_ground(slip);
    const double secant = 1.0 / ground.cosine;
    const tdmf_classic_point *at = &standing->at;
    const double ahead = at->x + at->vx * at->vy / g;
    const double next_height = at->y + 0.5 * at->vy * at->vy / g - ground.sine / ground.cosine * ahead;
    if (!(next_height > 0.0)) {
        step->outcome = TDMF_CLASSIC_FALLS;
        return;
    }
    step->outcome = at->vx > 0.0 ? TDMF_CLASSIC_FLIES : TDMF_CLASSIC_TURNS_BACK;
    step->next_height = next_height;
    step->next_speed = at->vx;
    step->next_energy = slip->mass * (0.5 * at->vx * at->vx + g * next_height);
    step->length = standing->foot + ahead;
    step->by_height = vary_apex(slip, standing, TDMF_CLASSIC_BY_HEIGHT, 0.0);
    step->by_energy = vary_apex(slip, standing, TDMF_CLASSIC_BY_ENERGY, 0.0);
    step->by_touchdown_angle = vary_apex(slip, standing, TDMF_CLASSIC_BY_TOUCHDOWN_ANGLE, 0.0);
    step->by_ground_slope = vary_apex(slip, standing, TDMF_CLASSIC_BY_GROUND_SLOPE, secant * secant);
    step->by_retraction_rate = vary_apex(slip, standing, TDMF_CLASSIC_BY_RETRACTION_RATE, 0.0);
}
