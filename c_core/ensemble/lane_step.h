/* One step of a batch: expansion, first event, evaluation, in all lanes at once. */
#ifndef TDMF_ENSEMBLE_LANE_STEP_H
#define TDMF_ENSEMBLE_LANE_STEP_H

#include "flight_watch.h"
#include "ground_watch.h"
#include "members.h"

/* What a step has come to. */
typedef struct {
    mask at_event;
    integer event; /* see event_search */
    mask late;     /* no time left to close the stride */
    mask stuck;    /* no finite step, none left, or too stiff */
    mask in_layer; /* where friction falls, and a step may be no longer */
    real size;     /* for which its series were expanded */
    real end;      /* of it, or at its event */
} lane_outcome;

/* Begins the search of a step that its series may be trusted for. Returns how much the length may change. */
static inline real begin_lane_search(event_search *search, const member_progress *now, real time_left,
                                     const mode_constants *mode, real trusted, const real *length, int order,
                                     double tolerance, mask live) {
    search->size = real_min(time_left - now->elapsed, trusted);
    const real change = shorten_without_pole(&search->size, search->power, length, order);
    begin_search(search, order, live, tdmf_beyond_margin(tolerance) * mode->margin_factor);
    return change;
}

/* Lanes that have just been loaded and whose laws say that they are too stiff. */
static inline mask lane_opens_too_stiff(const member_progress *now, real time_left,
                                        const mode_constants *mode, real longest) {
    return (now->elapsed == 0.0) & opens_too_stiff(longest, real_min(mode->time_scale, time_left));
}

/* What a size that is not a number, or none left, makes of a step. */
static inline lane_outcome move_on(member_progress *now, real time_left, const mode_constants *mode,
                                   const event_search *search, mask too_stiff, real end) {
    const real elapsed = now->elapsed + end;
    count_step(&now->steps, end, mode->time_scale);
    const lane_outcome outcome = {
        .at_event =
            search->live & (search->end != integer_of(KINK)) & (search->time <= 1.0) & mask_not(too_stiff),
        .event = search->end,
        .late = search->live & (elapsed >= time_left),
        .stuck = search->live & (too_stiff | mask_not(elapsed > now->elapsed) | no_steps_left(&now->steps) |
                                 takes_too_many_steps(&now->steps, mode->time_scale)),
        .size = search->size,
        .end = end,
    };
    now->elapsed = elapsed;
    return outcome;
}

/* The centre of mass where the lanes are. */
static inline ballistic center_of_mass_of(const flying_member *m, bool ground_waits) {
    const flight_constants *c = &m->constants;
    const real gone = m->now.elapsed;
    ballistic com;
    com.ground = height_after(m->com, c->normal_gravity, gone);
    com.rise_rate = m->rise_rate - c->mode.gravity * gone;
    if (ground_waits) {
        com.new_ground = height_after(m->com_over_new_ground, c->new_normal_gravity, gone);
    }
    return com;
}

static inline lane_outcome step_flying(flying_member *m, mask live, flight_case is, int order,
                                       double tolerance, flight_series *f) {
    const flight_constants *c = &m->constants;
    const ballistic com = center_of_mass_of(m, is.awaits_ground);
    event_search search;
    elapsed_time elapsed;
    real longest;
    const real trusted = expand_flight_step(c, &m->at, is.forced, order, tolerance, f, &longest);
    const real change = begin_lane_search(&search, &m->now, m->time_left, &c->mode, trusted, f->length, order,
                                          tolerance, live);
    watch_flight(&search, c, f, &com, is, change, tolerance);
    const real end = search.size * real_min(search.time, broadcast(1.0));
    const mask too_stiff = lane_opens_too_stiff(&m->now, m->time_left, &c->mode, longest);
    set_elapsed(&elapsed, search.power, search.size, end, order);
    fly_on(c, f, order, &elapsed, &m->at);
    tdmf_drift_flight(&c->law, end, &m->constants.law);
    return move_on(&m->now, m->time_left, &c->mode, &search, too_stiff, end);
}

static inline lane_outcome step_standing(standing_member *m, mask live, ground_case is, int order,
                                         double tolerance, ground_series *g) {
    const ground_constants *c = &m->constants;
    event_search search;
    elapsed_time elapsed;
    real longest;
    mask in_layer;
    const real trusted =
        expand_ground_step(c, &m->layer, &m->at, is, order, tolerance, g, &longest, &in_layer);
    const real change = begin_lane_search(&search, &m->now, m->time_left, &c->mode, trusted, g->length, order,
                                          tolerance, live);
    watch_ground(&search, c, g, &m->at, is, change);
    const real end = search.size * real_min(search.time, broadcast(1.0));
    const mask too_stiff =
        mask_of(!foot_is_free(is)) & lane_opens_too_stiff(&m->now, m->time_left, &c->mode, longest);
    set_elapsed(&elapsed, search.power, search.size, end, order);
    stand_on(c, g, is, order, &elapsed, &m->at);
    if (is.grazes) {
        m->constants.servo.torque += end * c->servo.torque_rate;
    }
    lane_outcome outcome = move_on(&m->now, m->time_left, &c->mode, &search, too_stiff, end);
    outcome.in_layer = live & in_layer;
    return outcome;
}

#endif
