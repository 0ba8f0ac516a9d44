/* Steps of the native solver by the kernel, for one runner. */
#include "step.h"

#include "constant_laws.h"
#include "flight_watch.h"
#include "friction.h"
#include "ground_watch.h"
#include "series_sums.h"

/* The nearest even order: inner sums are made by pairs, so that an odd one costs as much as the next. */
static int even_order(double order) {
    const int even = 2 * (int)floor(0.5 * order + 0.5);
    return even < 8 ? 8 : even > SERIES_ORDER_LIMIT ? SERIES_ORDER_LIMIT : even;
}

/* Measured over runners that are stiff, light, fast or on slippery ground. A coefficient costs more on the
 * ground, so that its steps had better be shorter and of a lower order. */
series_orders tdmf_step_orders(double tolerance) {
    const double digits = -log10(tolerance);
    const series_orders orders = {even_order(4.5 + 1.5 * digits), even_order(4.0 + 1.375 * digits)};
    return orders;
}

static bool flies(const tdmf_step *step) {
    return step->equations->contact == TDMF_CONTACT_FLIGHT;
}

ground_case tdmf_step_ground_case(const tdmf_step *step) {
    const tdmf_mode_equations *equations = step->equations;
    const bool grazes = equations->contact == TDMF_CONTACT_GRAZE;
    const ground_case is = {
        .slips = equations->contact != TDMF_CONTACT_STICK && !grazes,
        .grazes = grazes,
        .has_torque = grazes || tdmf_law_acts(&equations->law),
        .falls = equations->falls,
        .meets_border = equations->meets_border,
    };
    return is;
}

/* ---- size --------------------------------------------------------------------------------------------- */

static double expand_leg_in_flight(tdmf_step *step) {
    const flight_coordinates at = tdmf_step_flight_coordinates(&step->equations->start);
    return expand_flight_step(&step->constants.flight, &at, step->equations->is_forced, step->order,
                              step->tolerance, &step->series.flight, &step->longest);
}

static double expand_standing_leg(tdmf_step *step) {
    const ground_coordinates at = tdmf_step_ground_coordinates(&step->equations->start);
    mask in_layer;
    const double size =
        expand_ground_step(&step->constants.ground, &step->layer, &at, tdmf_step_ground_case(step),
                           step->order, step->tolerance, &step->series.ground, &step->longest, &in_layer);
    step->in_layer = in_layer;
    return size;
}

void tdmf_step_open(tdmf_step *step, const tdmf_mode_equations *equations, const tdmf_mode *mode,
                    double margin_factor) {
    step->equations = equations;
    step->margin_factor = margin_factor;
    if (flies(step)) {
        step->constants.flight = tdmf_step_flight_constants(equations, mode, margin_factor);
    } else {
        step->constants.ground = tdmf_step_ground_constants(equations, mode, margin_factor);
        if (equations->falls) {
            step->layer = tdmf_step_friction_layer(equations);
        }
    }
}

void tdmf_step_expand(tdmf_step *step, series_orders orders, double tolerance) {
    step->order = flies(step) ? orders.flight : orders.ground;
    step->tolerance = tolerance;
    step->in_layer = false;
    step->size = flies(step) ? expand_leg_in_flight(step) : expand_standing_leg(step);
}

void tdmf_step_shorten(tdmf_step *step, double longest) {
    const double *length = flies(step) ? step->series.flight.length : step->series.ground.length;
    step->search.size = real_min(longest, step->size);
    step->length_change = shorten_without_pole(&step->search.size, step->search.power, length, step->order);
    step->size = step->search.size;
}

/* Gives the largest term but the last two. */
static double largest_term(const double *sizes, int order, double t) {
    double power = 1.0;
    double largest = 0.0;
    for (int k = 0; k < order - 1; ++k) {
        largest = real_max(largest, sizes[k] * power);
        power *= t;
    }
    return largest;
}

/* In a shorter step the largest term may be smaller, too, so the size is approached from above. */
double tdmf_step_trusts_terms(const tdmf_step *step, const double sizes[SERIES_TERMS]) {
    enum { ITERATION_LIMIT = 40 };
    static const double settled = 0.95;
    const int order = step->order;
    const series_remainder remainder = {sizes[order], sizes[order - 1]};
    double size = step->size;
    for (int i = 0; i < ITERATION_LIMIT; ++i) {
        const double largest = largest_term(sizes, order, size);
        if (!is_finite(largest + remainder.last + remainder.last_but_one)) {
            return INFINITY;
        }
        const double shorter = trusted_size(&remainder, size, order, step->tolerance * largest);
        if (shorter >= settled * size) {
            return shorter;
        }
        size = shorter;
    }
    return size;
}

/* ---- events ------------------------------------------------------------------------------------------- */

static void search_flight(tdmf_step *step, const tdmf_mode *mode) {
    const ballistic com = tdmf_step_center_of_mass(step->equations);
    const flight_case is = {.rising = mode->rises,
                            .clamped = step->equations->clamped,
                            .awaits_ground = step->equations->ground_waits,
                            .forced = step->equations->is_forced};
    watch_flight(&step->search, &step->constants.flight, &step->series.flight, &com, is, step->length_change,
                 step->tolerance);
}

/* Weighs the cone by the largest friction in the step. */
static void weigh_cone(ground_constants *c, const tdmf_mode_equations *equations, double size) {
    if (equations->static_friction_rate != 0.0) {
        c->cone = tdmf_friction_cone_of(equations->static_friction, equations->static_friction_rate, size);
    }
    if (equations->backward_friction_rate != 0.0) {
        c->border.cone =
            tdmf_friction_cone_of(equations->backward_friction, equations->backward_friction_rate, size);
    }
}

static void search_ground(tdmf_step *step) {
    const ground_coordinates at = tdmf_step_ground_coordinates(&step->equations->start);
    ground_constants *c = &step->constants.ground;
    weigh_cone(c, step->equations, step->size);
    watch_ground(&step->search, c, &step->series.ground, &at, tdmf_step_ground_case(step),
                 step->length_change);
}

tdmf_step_end tdmf_step_find_end(tdmf_step *step, const tdmf_mode *mode) {
    event_search *search = &step->search;
    const mode_constants *constants =
        flies(step) ? &step->constants.flight.mode : &step->constants.ground.mode;
    begin_search(search, step->order, mask_of(true),
                 tdmf_beyond_margin(step->tolerance) * constants->margin_factor);
    if (flies(step)) {
        search_flight(step, mode);
    } else {
        search_ground(step);
    }
    const bool within = search->time <= 1.0;
    const tdmf_step_end end = {
        .time = within ? search->time * step->size : step->size,
        .is_event = within && search->end != KINK,
        .guard = guard_of_end(search->end),
        .reached = guard_at_zero(search->end),
    };
    return end;
}

/* ---- values ------------------------------------------------------------------------------------------- */

tdmf_mode_coordinates tdmf_step_at(const tdmf_step *step, double time) {
    tdmf_mode_coordinates at = step->equations->start;
    elapsed_time elapsed;
    set_elapsed(&elapsed, step->search.power, step->size, time, step->order);
    if (flies(step)) {
        flight_coordinates leg = tdmf_step_flight_coordinates(&at);
        fly_on(&step->constants.flight, &step->series.flight, step->order, &elapsed, &leg);
        tdmf_step_set_flight(&at, &leg);
    } else {
        ground_coordinates body = tdmf_step_ground_coordinates(&at);
        stand_on(&step->constants.ground, &step->series.ground, tdmf_step_ground_case(step), step->order,
                 &elapsed, &body);
        tdmf_step_set_ground(&at, &body);
    }
    return at;
}

double tdmf_step_work(const tdmf_step *step, double time) {
    elapsed_time elapsed;
    set_elapsed(&elapsed, step->search.power, step->size, time, step->order);
    if (flies(step)) {
        const flight_series *f = &step->series.flight;
        const double rotation = change_to(f->angle, &elapsed, step->order);
        return tdmf_flight_work(&step->constants.flight.law, f, &elapsed, step->order, rotation);
    }
    return ground_work(&step->series.ground, tdmf_step_ground_case(step), step->order, &elapsed);
}

/* ---- ramps of inputs ---------------------------------------------------------------------------------- */

/* Gives the integral of k (l - r) by the rate of l. */
double tdmf_step_leg_work(const tdmf_step *step, double time) {
    const tdmf_mode_equations *equations = step->equations;
    const double *length = flies(step) ? step->series.flight.length : step->series.ground.length;
    const double rate = equations->rest_length_rate;
    const double rest_length_integral = time * (equations->rest_length + 0.5 * time * rate);
    return equations->model->parameters.leg.stiffness * rate *
           (rest_length_integral - series_integral(length, step->order, time));
}

typedef struct {
    double x, y;
} position_integral; /* m.s */

/* The centre of mass, and the body's way from it. */
static position_integral integrate_body_in_flight(const tdmf_step *step, double t) {
    const tdmf_mode_equations *equations = step->equations;
    const flight_series *f = &step->series.flight;
    const tdmf_vector acceleration = tdmf_com_acceleration(equations->model, equations->push);
    const double share = equations->model->body_share, rest = 1.0 - share;
    const int order = step->order - 1;
    double across[SERIES_TERMS], along[SERIES_TERMS];
    for (int k = 0; k <= order; ++k) {
        across[k] = product(f->length, f->sine, k);
        along[k] = product(f->length, f->cosine, k);
    }
    const position_integral integral = {
        t * (equations->com.x +
             t * (equations->com.vx / 2.0 +
                  t * (acceleration.x / 6.0 + t * share * equations->push_rate.x / 24.0))) -
            rest * series_integral(across, order, t),
        t * (equations->com.y +
             t * (equations->com.vy / 2.0 +
                  t * (acceleration.y / 6.0 + t * share * equations->push_rate.y / 24.0))) +
            rest * series_integral(along, order, t),
    };
    return integral;
}

/* The foot, and the body's place as seen from it. */
static position_integral integrate_body_on_ground(const tdmf_step *step, double t) {
    const ground_series *g = &step->series.ground;
    double foot_way[SERIES_TERMS] = {0.0};
    for (int k = 0; k < step->order; ++k) {
        foot_way[k + 1] = g->foot_vx[k] * series_reciprocal[k + 1];
    }
    const tdmf_ground_line *ground = &step->equations->ground;
    const double along = t * step->equations->start.standing.foot_x +
                         series_integral(foot_way, step->order, t) + series_integral(g->x, step->order, t);
    const double off = series_integral(g->y, step->order, t);
    const position_integral integral = {
        ground->cosine * along - ground->sine * off,
        t * ground->height + ground->sine * along + ground->cosine * off,
    };
    return integral;
}

double tdmf_step_shortfall(const tdmf_step *step, double time) {
    const tdmf_mode_equations *equations = step->equations;
    const position_integral body =
        flies(step) ? integrate_body_in_flight(step, time) : integrate_body_on_ground(step, time);
    const tdmf_point from = equations->opened_body;
    return equations->model->parameters.body.mass * (equations->push_rate.x * (body.x - time * from.x) +
                                                     equations->push_rate.y * (body.y - time * from.y));
}
