/* A step of a mode over `real`, of one runner or of a runner in each lane: how long it may be, which event
 * ends it, and the values at its end. All widths give equal bits.
 */
#ifndef TDMF_KERNEL_PAGE_STEP_H
#define TDMF_KERNEL_PAGE_STEP_H

#include "driver.h"
#include "first_root.h"
#include "page_margins.h"
#include "run_state.h"
#include "step_size.h"

#include <string.h>

static const double largest_size = 1e10;        /* powers of a step do not overflow */
static const double smallest_share = 1e-200;    /* share of a scale: dividing by it raises no exception */
static const double divisor_change = 0.75;      /* largest relative change of a divisor within a step */
static const double guard_tolerance = 10.0;     /* tolerance of a guard's series, relative to a step's */
static const double variation_tolerance = 10.0; /* tolerance of a variation's series, relative to a step's */

/* The search for a single zero ends after a correction this small, as a share of the step. After a Newton
 * correction the remaining error is about its square, so that it may be larger than one by bisection. */
static const double last_newton = 1e-9, last_halving = 4e-16;
static const double short_line = 1e-10; /* share of a step in which a guard is a straight line */

enum { NO_EVENT = -1, NEWTON_LIMIT = 8 };

#ifndef TDMF_LANES
enum { LANES = 1 };
#endif

/* A guard of the mode, with its flags. */
typedef struct {
    integer flags;
    real scale;
} guard_watch;

/* Pieces of a step, as shares of it, in which a polynomial is positive. */
enum { PIECE_LIMIT = 17 };

typedef struct {
    int count;
    double from[PIECE_LIMIT], to[PIECE_LIMIT];
} positive_pieces;

/* An observed quantity in a step. */
typedef struct {
    bool is_expanded;
    real g[TERMS];                /* its polynomial, where it is expanded */
    mask changes[2];              /* lanes in which its factors may change their sign */
    mask is_positive, has_pieces; /* positive in the whole step; in pieces of it */
    positive_pieces pieces[LANES];
    real share; /* share of the step at which the largest value is reached; negative: an earlier one holds */
} observed_part;

typedef struct {
    const tdmf_motion_kind *motion;
    const tdmf_guard_kind *kinds;
    const tdmf_watch_kind *watches;
    int guard_count, observed_count;
    int places[TDMF_WATCH_LIMIT]; /* places of observed quantities: see changing_place */
    double tolerance;
    /* Written where the mode begins. */
    real *c;          /* constants */
    real (*s)[TERMS]; /* series */
    real *units;      /* scales of the states that change */
    observed_part *observed;
    guard_watch guards[TDMF_GUARD_LIMIT];
    mask begins;      /* no time has passed in the mode */
    bool looks;       /* some guard may be near */
    bool rises;       /* some guard rises from zero */
    uint64_t watched; /* a bit for each guard that a lane watches, then for each observed quantity */
    /* Written by each step. */
    int order;         /* order of the series */
    real reach;        /* time for which the series can be trusted */
    real power[TERMS]; /* powers of the step size */
    real size, end;    /* step size, and the share of it at which the step ends */
    integer first;     /* guard whose event ends the step, or is due at once; NO_EVENT */
    mask is_due;       /* lanes in which it is due at once */
    interval bounds[TDMF_GUARD_LIMIT + TDMF_WATCH_LIMIT]; /* bounds of guards and observed quantities */
    mask is_reached; /* due at once, at a time that varies: the guard came down to zero, or begins there and
                        falls */
} page_step;

/* ---- lanes --------------------------------------------------------------------------------------------- */

#ifdef TDMF_LANES
typedef int64_t lane_mask;
#else
typedef mask lane_mask;
#endif

/* Lanes are read and written in memory, as elements of their vector: compilers would move whole registers for
 * one of them. */
static inline double lane_of(const real *x, int lane) {
    return ((const double *)x)[lane];
}

static inline void set_lane(real *x, int lane, double number) {
    ((double *)x)[lane] = number;
}

static inline bool has_lane(const mask *lanes, int lane) {
    return ((const lane_mask *)lanes)[lane] != 0;
}

static inline void set_mask(mask *lanes, int lane, bool selects) {
    ((lane_mask *)lanes)[lane] = -(lane_mask)selects;
}

static inline int flags_of(const integer *flags, int lane) {
    return (int)((const lane_mask *)flags)[lane];
}

static inline void set_flags(integer *flags, int lane, int number) {
    ((lane_mask *)flags)[lane] = number;
}

/* ---- flags of guards ----------------------------------------------------------------------------------- */

static inline mask has_flag(const guard_watch *watch, int flag) {
    return (watch->flags & integer_of(flag)) != integer_of(0);
}

static inline void raise_flag(guard_watch *watch, int flag, mask lanes) {
    watch->flags |= select_integer(lanes, integer_of(flag), integer_of(0));
}

static inline void lower_flag(guard_watch *watch, int flag, mask lanes) {
    watch->flags &= ~select_integer(lanes, integer_of(flag), integer_of(0));
}

/* States that change in a step: those that move, then those of observed quantities. */
static inline int changing_count(const page_step *step) {
    return step->motion->moving_count + step->observed_count;
}

static inline int changing_state(const page_step *step, int i) {
    const int moving_count = step->motion->moving_count;
    return i < moving_count ? step->motion->moving[i] : step->watches[i - moving_count].into;
}

/* The first place at which a state changes: several observed quantities may go into one state. */
static inline int changing_place(const page_step *step, int i) {
    const int moving_count = step->motion->moving_count;
    return i < moving_count ? i : step->places[i - moving_count];
}

/* Clears the series of states that are polynomials in time: a ramp has no other coefficients. */
static inline void clear_polynomials(page_step *step) {
    const tdmf_motion_kind *m = step->motion;
    for (int i = 0; i < m->moving_count + m->extra_count; ++i) {
        if (m->degrees[i] < SERIES_ORDER_LIMIT) {
            memset(step->s[i], 0, sizeof step->s[i]);
        }
    }
}

/* ---- its size ------------------------------------------------------------------------------------------ */

/* Sums up the last terms of the series that control the size. Returns whether the coefficients are finite. */
static inline mask judge_series(const page_step *step, series_remainder *remainder) {
    const tdmf_motion_kind *m = step->motion;
    real left_out = broadcast(0.0);
    remainder->last = remainder->last_but_one = broadcast(0.0);
    for (int i = 0; i < m->judged_count; ++i) {
        const int j = m->judged[i];
        const int over = m->divided[i];
        real unit = j < m->moving_count ? step->units[j] : broadcast(1.0);
        if (over >= 0) {
            const real share = step->s[over][0] / step->units[over];
            unit *= real_min(broadcast(1.0), share * share);
        }
        add_to_remainder(remainder, step->s[j], step->order - 1, unit);
        left_out += real_abs(step->s[j][step->order]);
    }
    return is_finite(remainder->last + remainder->last_but_one + left_out);
}

/* Chooses a step that can be trusted, and in which no divisor comes near zero. It is at most `longest` and
 * ends at most `left` ahead. */
static inline void choose_size(page_step *step, const series_remainder *remainder, real longest, real left) {
    const tdmf_motion_kind *m = step->motion;
    const int order = step->order;
    step->reach = real_min(size_of_remainder(remainder, order - 1, broadcast(step->tolerance)), longest);
    step->size = real_min(real_min(step->reach, left), broadcast(largest_size));
    set_power_pairs(step->power, step->size, order);
    for (int i = 0; i < m->divisor_count; ++i) {
        const real *d = step->s[m->divisors[i]], most = divisor_change * real_abs(d[0]);
        const real change = largest_change(d, step->power, order - 1);
        const mask is_long = change > most;
        if (any(is_long)) {
            step->size = select(is_long, step->size * (most / change), step->size);
            set_power_pairs(step->power, step->size, order);
        }
    }
}

/* ---- its first event ----------------------------------------------------------------------------------- */

/* Scales a polynomial, or its negative, to the step. */
static inline void scale_to_step(const page_step *step, double sign, const real *g, real *scaled) {
    for (int k = 0; k < step->order; ++k) {
        scaled[k] = g[k] * (sign * step->power[k]);
    }
}

static inline void end_without_event(page_step *step, real share, mask lanes) {
    lanes &= share < step->end;
    step->end = select(lanes, share, step->end);
    step->first = select_integer(lanes, integer_of(NO_EVENT), step->first);
}

/* Shortens the step where the last two terms of a series, as they are at its end, are larger than allowed.
 * Returns the lanes in which it does so. An event that was found behind the new end is forgotten. */
static inline mask shorten(page_step *step, const series_remainder *remainder, real allowed, mask lanes) {
    lanes &= (remainder->last > allowed) | (remainder->last_but_one > allowed);
    if (any(lanes)) {
        const real share = size_of_remainder(remainder, step->order - 1, allowed);
        step->size = select(lanes, step->size * share, step->size);
        step->end = select(lanes, step->end / share, step->end);
        step->first = select_integer(lanes & (step->end > 1.0), integer_of(NO_EVENT), step->first);
        set_power_pairs(step->power, step->size, step->order);
    }
    return lanes;
}

/* Shortens the step where the series of a guard or an observed quantity can be trusted no further: a leg that
 * spins steadily has states of few terms, and a sine in its guard. */
static inline void trust_terms(page_step *step, real last_but_one, real last, real allowed, mask lanes) {
    const real *power = step->power + step->order - 1;
    const series_remainder remainder = {real_abs(last) * power[0], real_abs(last_but_one) * power[-1]};
    shorten(step, &remainder, allowed, lanes);
}

static inline void trust(page_step *step, const real *g, real allowed, mask lanes) {
    trust_terms(step, g[step->order - 2], g[step->order - 1], allowed, lanes);
}

/* Shortens the step where variations t of the series can be trusted no further, and returns the lanes in
 * which it does so: a stiff motion that has died out has small coefficients, and variations that are not
 * small. */
static inline mask trust_variation(page_step *step, real (*t)[TERMS], mask lanes) {
    const int last = step->order - 1;
    const real *power = step->power;
    series_remainder remainder = {broadcast(0.0), broadcast(0.0)};
    real first = broadcast(0.0);
    for (int i = 0; i < step->motion->judged_count; ++i) {
        const int j = step->motion->judged[i];
        const real by_unit = 1.0 / (j < step->motion->moving_count ? step->units[j] : broadcast(1.0));
        first += by_unit * (real_abs(t[j][0]) + largest_change(t[j], power, last - 2));
        remainder.last += by_unit * real_abs(t[j][last]);
        remainder.last_but_one += by_unit * real_abs(t[j][last - 1]);
    }
    lanes &= is_finite(remainder.last + remainder.last_but_one) & (first > 0.0);
    remainder.last = real_min(remainder.last * power[last], broadcast(DBL_MAX));
    remainder.last_but_one = real_min(remainder.last_but_one * power[last - 1], broadcast(DBL_MAX));
    return shorten(step, &remainder, variation_tolerance * step->tolerance * first, lanes);
}

static inline void trust_guard(page_step *step, const real *g, real scale, mask lanes) {
    trust(step, g, guard_tolerance * step->tolerance * real_max(scale, real_abs(g[0])), lanes);
}

/* Ends the step where a guard that is below zero rises to a height above it: it is watched from there on. */
static inline void end_where_it_rises(page_step *step, const real *g, real height, mask lanes) {
    lanes &= g[0] + largest_change(g, step->power, step->order - 1) > height;
    if (!any(lanes)) {
        return;
    }
    real negative[TERMS];
    scale_to_step(step, -1.0, g, negative);
    const real to = real_min(broadcast(1.0), step->end);
    const root found = first_root(negative, step->order - 1, -height, broadcast(0.0), to, lanes);
    end_without_event(step, found.time, lanes);
}

static inline void end_at_event(page_step *step, int guard, real share, mask is_root, mask lanes) {
    const integer event = select_integer(is_root, integer_of(guard), integer_of(NO_EVENT));
    lanes &= share < step->end;
    step->end = select(lanes, share, step->end);
    step->first = select_integer(lanes, event, step->first);
}

/* The zero before the time at which a guard has come down to its floor, by Newton's method. A guard that
 * falls slowly is no straight line in between. */
static inline real refined_zero(const real *g, int degree, const root *found, mask lanes) {
    real zero = found->time;
    for (int i = 0; i < NEWTON_LIMIT; ++i) {
        const expansion at = expansion_at(g, degree, zero);
        const real next = zero - at.value / at.slope;
        const mask within = lanes & (at.slope < 0.0) & (next >= 0.0) & (next <= found->time);
        zero = select(within, next, zero);
    }
    return select(lanes, zero, found->zero);
}

/* Ends the step where a guard that falls from above zero throughout the step has its only zero, by Newton's
 * method within bounds. Returns the lanes with such a guard. */
static inline mask end_at_only_zero(page_step *step, int guard, const real *g, real to, mask lanes) {
    real most = g[1];
    for (int k = 2; k < step->order; ++k) {
        most += first_derivative[k] * real_abs(g[k]);
    }
    lanes &= (most < 0.0) & (g[0] > 0.0);
    const real at_end = expansion_at(g, step->order - 1, to).value;
    const mask reaches = lanes & mask_not(at_end > 0.0);
    real from = broadcast(0.0), until = to, zero = to * (g[0] / (g[0] - at_end));
    mask searching = reaches;
    for (int i = 0; i < ROOT_ITERATION_LIMIT && any(searching); ++i) {
        const expansion at = expansion_at(g, step->order - 1, zero);
        const mask is_before = at.value > 0.0;
        from = select(searching & is_before, zero, from);
        until = select(searching & mask_not(is_before), zero, until);
        const real newton = zero - at.value / at.slope;
        const mask is_within = (newton >= from) & (newton <= until);
        const real next = select(is_within, newton, 0.5 * (from + until));
        const real correction = real_abs(next - zero);
        zero = select(searching, next, zero);
        searching &= mask_not((correction <= last_halving) | (is_within & (correction <= last_newton)));
    }
    end_at_event(step, guard, zero, reaches, reaches);
    return lanes;
}

/* Ends the step at the first root of a guard, whose polynomial is g. */
static inline void search_guard(page_step *step, int guard, real *g, real floor, mask lanes) {
    lanes &= mask_not(g[0] > largest_change(g, step->power, step->order - 1));
    if (any(lanes)) {
        lanes &= mask_not(interval_of_series(g, step->power, step->order).low > 0.0);
    }
    if (!any(lanes)) {
        return;
    }
    scale_to_step(step, 1.0, g, g);
    const real to = real_min(broadcast(1.0), step->end);
    lanes &= mask_not(end_at_only_zero(step, guard, g, to, lanes));
    if (!any(lanes)) {
        return;
    }
    root found = first_root(g, step->order - 1, floor, broadcast(0.0), to, lanes);
    const mask passes = lanes & (found.time > to);
    if (any(passes)) { /* it may be below zero at the end, and not at the floor */
        const mask is_below = passes & mask_not(expansion_at(g, step->order - 1, to).value > 0.0);
        found.is_root |= is_below;
        found.time = select(is_below, to, found.time);
        found.zero = select(is_below, to, found.zero);
    }
    const real zero = broadcast(0.0);
    const real since = select(found.is_root, found.time, zero) - select(found.is_root, found.zero, zero);
    const mask is_slow = lanes & found.is_root & mask_not((since > 0.0) & (since < short_line));
    if (any(is_slow)) {
        found.zero = refined_zero(g, step->order - 1, &found, is_slow);
    }
    end_at_event(step, guard, found.zero, found.is_root, lanes & (found.is_root | (found.time < 1.0)));
}

/* The time in which a guard can change by its scale, at most the reach of the step. */
static inline real time_of_change(const page_step *step, const real *g, real scale) {
    real time = step->reach;
    for (int k = 1; k < step->order; ++k) {
        time = real_min(time, rough_root(scale / real_max(real_abs(g[k]), smallest_share * scale), k));
    }
    return time;
}

/* The first coefficient of a guard, but coefficient 0, that is above `up` or below `down` in the time of
 * change decides whether the guard rises. The guard is divided by that power of time, and `floor` with it.
 * Returns the lanes without such a coefficient. */
static inline mask divide_by_time(const page_step *step, real *g, real up, real down, real *floor, real scale,
                                  mask lanes) {
    const real time = time_of_change(step, g, scale);
    mask level = lanes;
    for (int k = 1; k < step->order && any(level); ++k) {
        for (int j = 1; j < step->order; ++j) {
            g[j - 1] = select(level, g[j], g[j - 1]);
        }
        g[step->order - 1] = select(level, broadcast(0.0), g[step->order - 1]);
        up = select(level, up / time, up);
        down = select(level, down / time, down);
        *floor = select(level, *floor / time, *floor);
        level &= mask_not((g[0] > up) | (g[0] < down));
    }
    return level;
}

/* Ends the step where a guard that is almost zero falls through it in a straight line. Returns the lanes with
 * such a guard. */
static inline mask end_on_line(page_step *step, int guard, const real *g, real band, mask lanes) {
    const real since = g[0] / -g[1], until = real_min(since, step->size);
    real bend = broadcast(0.0);
    lanes &= (g[0] <= band) & (g[1] < 0.0);
    for (int k = step->order - 1; k > 1 && any(lanes); --k) {
        bend = (bend + real_abs(g[k])) * until;
    }
    lanes &= bend <= close_enough * real_abs(g[1]);
    if (any(lanes)) {
        const mask within = lanes & (since <= step->size);
        end_at_event(step, guard, since / step->size, within, within);
    }
    return lanes;
}

/* Lanes in which a guard that is near zero comes down to `floor` in the time in which it can change by its
 * scale. */
static inline mask reaches(const page_step *step, const real *g, real floor, real scale, mask lanes) {
    real scaled[TERMS], power = broadcast(1.0);
    if (!any(lanes)) {
        return lanes;
    }
    const real time = time_of_change(step, g, scale);
    for (int k = 0; k < step->order; ++k) {
        scaled[k] = g[k] * power;
        power *= time;
    }
    return first_root(scaled, step->order - 1, floor, broadcast(0.0), broadcast(1.0), lanes).is_root;
}

/* Decides the lanes in which a guard does not begin the step above zero, and returns those in which its event
 * is due at once. In the lanes that remain in `searched`, the polynomial is above zero from now on.
 *
 *  - Zero: the first derivative that is not zero decides. A guard that falls is due, unless it rises again
 *    before it is clearly below zero: an event before it may have been located as roughly as that. If its
 *    event was just taken, its first derivative may be a rounding error, and has to be clear.
 *  - Hardly below zero where a mode begins, as rounding leaves a guard that is zero there: due if it falls.
 *    If its event was just taken, it has to fall clearly.
 *  - Below zero: due, unless it has to cross zero.
 *  - In a long chain, which rounding errors make: an event of the chain is not due again before its guard is
 *    clearly below zero, nor while its guard rises.
 *
 * A guard that is below zero and not due is watched from where it rises above zero. A guard that is near zero
 * and not due is watched for where it falls clearly below zero. */
static inline mask begin_below(page_step *step, int guard, real *g, real *floor, mask *searched, mask lanes) {
    guard_watch *watch = &step->guards[guard];
    const double late =
        late_margin + (rough_share * step->tolerance < roughest ? rough_share * step->tolerance : roughest);
    const real value = g[0], band = -2.0 * *floor, late_band = late * watch->scale;
    const mask is_zero = lanes & (value >= -band), was_taken = has_flag(watch, WAS_TAKEN) & step->begins;
    const mask is_near =
        lanes & mask_not(is_zero) & (step->begins | has_flag(watch, IS_LATE)) & (value > -late_band);
    real divided[TERMS];
    memcpy(divided, g, sizeof divided);
    const mask in_chain = was_taken & has_flag(watch, IN_CHAIN);
    const mask is_far = lanes & in_chain & mask_not(is_zero | is_near);
    const mask undecided = is_zero | is_near | is_far;
    const real down = -select(was_taken, late_band, band);
    const real below_zero = *floor;
    const mask level = divide_by_time(step, divided, band, down, floor, watch->scale, undecided);
    mask falls = undecided & mask_not(level) & (divided[0] < 0.0);
    const mask must_cross = has_flag(watch, IS_CROSSING), was_above = has_flag(watch, WAS_ABOVE);
    const mask may_turn = falls & is_zero & mask_not(must_cross);
    const real clearly_below = select(was_taken, -late_band, below_zero);
    const mask turns = may_turn & mask_not(reaches(step, g, clearly_below, watch->scale, may_turn));
    const mask waits = (falls & in_chain & mask_not(turns | is_far)) | (is_zero & level);
    falls &= mask_not(turns | waits);
    const mask may_be_late = was_taken | has_flag(watch, IS_LATE);
    const mask is_late = (is_near & mask_not(falls) & mask_not(level & mask_not(may_be_late))) |
                         (is_far & mask_not(falls | level));
    const mask crosses = is_zero & falls & was_above & mask_not(was_taken);
    const mask is_below = lanes & mask_not(is_zero | is_late), may_be_due = is_below | falls;
    const mask below = is_late | (must_cross & may_be_due & mask_not(crosses));
    const mask due = may_be_due & (crosses | mask_not(must_cross));
    mask falls_at_once = due & undecided & step->begins & mask_not(was_taken);
    if (any(falls_at_once)) {
        falls_at_once &= g[1] * time_of_change(step, g, watch->scale) < -band;
    }
    /* The step before may end where the guard comes down; rounding then leaves it clearly below zero. */
    const mask came_down = due & was_above & (is_zero | mask_not(step->begins));
    step->is_reached |= came_down | falls_at_once;
    /* Hardly below zero, it has to rise further than rounding: shorter steps might change nothing. */
    const real height = select(mask_not(is_zero) & (value >= -late_band), late_band, band);
    end_where_it_rises(step, g, height, below);
    raise_flag(watch, IS_LATE, is_late);
    const mask rises = is_zero & mask_not(waits | falls | turns);
    lower_flag(watch, WAS_ABOVE, below);
    raise_flag(watch, RISES, rises);
    step->rises |= any(rises);
    const mask stays = ((is_late & mask_not(is_far)) | waits) & mask_not(must_cross);
    *searched = (*searched & mask_not(lanes)) | rises | stays;
    *floor = select(rises, *floor, -0.5 * band);
    for (int k = 0; k < step->order && any(rises); ++k) {
        g[k] = select(rises, divided[k], g[k]);
    }
    g[0] = select(stays, value + 2.0 * late_band, g[0]);
    return due;
}

/* Guards that have risen from zero are above it from now on. */
static inline void note_risen(page_step *step, mask searching) {
    step->rises = false;
    for (int i = 0; i < step->guard_count; ++i) {
        guard_watch *watch = &step->guards[i];
        raise_flag(watch, WAS_ABOVE, searching & has_flag(watch, RISES) & mask_not(step->begins));
        lower_flag(watch, RISES, searching);
        step->rises |= any(has_flag(watch, RISES));
    }
}

/* Searches the step for the first event, or one that is due at once. */
static inline void search_events(page_step *step, mask searching) {
    const interval *bounds = step->motion->bounds ? step->bounds : NULL;
    step->end = broadcast(INFINITY);
    step->first = integer_of(NO_EVENT);
    step->is_due = step->is_reached = mask_of(false);
    for (int i = 0; i < step->observed_count; ++i) {
        step->observed[i].is_expanded = false;
    }
    if (bounds) {
        step->motion->bounds(step->c, step->s[0], step->power, step->order, step->watched, step->bounds);
    }
    if (step->rises) {
        note_risen(step, searching);
    }
    for (int i = 0; i < step->guard_count; ++i) {
        guard_watch *watch = &step->guards[i];
        mask lanes = searching & has_flag(watch, IS_WATCHED);
        if (bounds) { /* most guards are known to be, and to stay, above zero */
            lanes &= mask_not((bounds[i].low > 0.0) & has_flag(watch, WAS_ABOVE));
        }
        if (!any(lanes)) {
            continue;
        }
        real floor = broadcast(-zero_margin) * watch->scale;
        if (bounds) {
            const mask above = lanes & (bounds[i].low > -2.0 * floor);
            raise_flag(watch, WAS_ABOVE, above);
            lower_flag(watch, IS_LATE, above);
            lanes &= mask_not(above);
        }
        if (!any(lanes)) {
            continue;
        }
        real g[TERMS];
        step->motion->polynomials[i](step->c, step->s[0], step->order, g);
        trust_guard(step, g, watch->scale, lanes);
        const real zero =
            select(has_flag(watch, WAS_TAKEN) & step->begins, -2.0 * floor, rounding_margin * watch->scale);
        const mask above = lanes & (g[0] > 0.0) & (has_flag(watch, WAS_ABOVE) | (g[0] > zero));
        raise_flag(watch, WAS_ABOVE, above);
        lower_flag(watch, IS_LATE, above);
        const mask low_lanes = lanes & mask_not(above);
        if (any(low_lanes)) {
            const mask due = begin_below(step, i, g, &floor, &lanes, low_lanes);
            step->is_due |= due;
            step->first = select_integer(due, integer_of(i), step->first);
            searching &= mask_not(due);
        }
        if (any(lanes & (g[0] <= -2.0 * floor))) {
            lanes &= mask_not(end_on_line(step, i, g, -2.0 * floor, lanes & above));
        }
        if (any(lanes)) {
            search_guard(step, i, g, floor, lanes);
        }
    }
}

/* ---- its end ------------------------------------------------------------------------------------------- */

/* Sets the powers to those of the end of the step, and returns how long the step lasts. */
static inline real end_step(page_step *step) {
    const real elapsed = select(step->end <= 1.0, step->end * step->size, step->size);
    if (any(mask_not(elapsed == step->size))) {
        set_power_pairs(step->power, elapsed, step->order);
    }
    return elapsed;
}

/* Lanes in which a guard has come down to zero in almost a straight line, from the beginning of the step to
 * its end. A guard that decays towards zero has roots by error only, further away than the line's. */
static inline mask falls_straight(const page_step *step, int guard) {
    enum { TWO_TERMS = 2 };
    real g[TERMS];
    step->motion->polynomials[guard](step->c, step->s[0], TWO_TERMS, g);
    const real rounding = 4.0 * zero_margin * step->guards[guard].scale;
    return real_abs(g[0] + g[1] * step->power[1]) <= 0.1 * real_abs(g[0]) + rounding;
}

/* Some events are taken only where a step that begins close to them finds them, too. A longer step errs by
 * the tolerance: a fall that it finds may be none, and a foot may yet be below new ground, and land on it as
 * it rises. Returns the lanes that go on without the event. */
static inline mask looks_again(page_step *step, mask reaches) {
    mask again = mask_of(false);
    if (!step->looks && !any(reaches)) {
        return again;
    }
    for (int i = 0; i < step->guard_count; ++i) {
        if (step->kinds[i].looks_again) {
            guard_watch *watch = &step->guards[i];
            mask is_near = reaches & (step->first == integer_of(i)) & has_flag(watch, IS_NEAR);
            if (any(is_near)) {
                is_near &= falls_straight(step, i);
            }
            const mask looks = reaches & (step->first == integer_of(i)) & mask_not(is_near);
            lower_flag(watch, IS_NEAR, mask_of(true));
            raise_flag(watch, IS_NEAR, looks);
            again |= looks;
        }
    }
    step->looks = any(again);
    return again;
}

/* The change of a series in a time whose powers are given. */
static inline real change_of(const real *c, const real *power, int order) {
    pair first = pair_of(broadcast(0.0), broadcast(0.0)), second = first;
    int k = 1;
    for (; k + 3 <= order; k += 4) {
        add_terms(&first, c + k, power + k);
        add_terms(&second, c + k + 2, power + k + 2);
    }
    real sum = part_of(first, 0);
    for (; k <= order; ++k) {
        sum += c[k] * power[k];
    }
    return (sum + part_of(first, 1)) + (part_of(second, 0) + part_of(second, 1));
}

static inline real sum_of(const real *c, const real *power, int order) {
    if (order < 3) { /* as change_of adds its terms */
        return c[0] + (order == 2   ? c[1] * power[1] + c[2] * power[2]
                       : order == 1 ? c[1] * power[1]
                                    : broadcast(0.0));
    }
    return c[0] + change_of(c, power, order);
}

/* The value of a moving state. */
static inline real value_at_end(const page_step *step, int i) {
    const int degree = step->motion->degrees[i];
    return sum_of(step->s[i], step->power, degree < step->order ? degree : step->order);
}

/* The rate of a series at a time whose powers are given. */
static inline real rate_of(const real *c, const real *power, int order) {
    real rate = broadcast(0.0);
    for (int k = 1; k <= order; ++k) {
        rate += (double)k * c[k] * power[k - 1];
    }
    return rate;
}

#endif
