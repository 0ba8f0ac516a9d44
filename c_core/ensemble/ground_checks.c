/* Checks of the ground of a case, on the page of any model. */
#include "ground.h"
#include "request_checks.h"

#include <float.h>
#include <math.h>

/* Largest distance of a foot from x = 0, m. */
static const double largest_distance = 1e12;

/* True if one of these settings is at this place of the page. */
static bool is_set(const tdmf_ensemble *ensemble, const int *settings, int count, int place) {
    for (int i = 0; i < count; ++i) {
        if (tdmf_kind_of(ensemble)->place(settings[i]) == place) {
            return true;
        }
    }
    return false;
}

/* A value that is drawn, or has to be constant, is set neither by a law nor by the request. */
static bool is_set_alone(tdmf_refusal *why, const char *name, int place, const tdmf_ensemble_rules *rules,
                         const tdmf_ensemble *ensemble) {
    const tdmf_given_settings *given = ensemble->given;
    const tdmf_affine_law *law = rules->law;
    return tdmf_accepts_if(why,
                           !(given && is_set(ensemble, given->settings, given->count, place)) &&
                               !(law && is_set(ensemble, law->settings, law->count, place)),
                           TDMF_EXCLUDED, name, 0, "a setting sets what is drawn or has to be constant");
}

/* Checks a size by which something is drawn. With a size of 0 nothing is drawn. */
static bool is_drawn(tdmf_refusal *why, const char *name, double size, int place,
                     const tdmf_ensemble_rules *rules, const tdmf_ensemble *ensemble) {
    return size == 0.0 || (tdmf_accepts_number(why, name, "1", size, 0.0, DBL_MAX) &&
                           is_set_alone(why, name, place, rules, ensemble));
}

/* Heights of segments have the range of the page's ground height. */
static bool are_heights(tdmf_refusal *why, const tdmf_terrain *terrain, double lowest, double highest) {
    const double least = terrain->heights != NULL ? 1.0 : -DBL_MAX;
    if (!tdmf_accepts_number(why, "cases[].rules.terrain.height_count", "1", (double)terrain->height_count,
                             least, DBL_MAX)) {
        return false;
    }
    for (int64_t i = 0; terrain->heights != NULL && i < terrain->height_count; ++i) {
        if (!tdmf_accepts_element(why, "rules.terrain.heights[]", i, terrain->heights[i], lowest, highest)) {
            return false;
        }
    }
    return true;
}

/* A terrain needs level segments and a ballistic centre of mass, and excludes gaits to settle on. */
static bool is_terrain(tdmf_refusal *why, const tdmf_ensemble_case *its_case, const tdmf_ensemble *ensemble,
                       const tdmf_model_kind *model) {
    const char *const name = "cases[].rules.terrain";
    const tdmf_ensemble_rules *rules = &its_case->rules;
    const tdmf_ground_places places = tdmf_places_of_ground(model);
    const int p = model->parameter_count;
    const int level[] = {places.height, places.slope, p + places.external_fx, p + places.external_fy};
    double numbers[2 * TDMF_PLACE_LIMIT], scales[TDMF_PLACE_LIMIT], of_events[TDMF_PAGE_EVENT_LIMIT];
    tdmf_kind_of(ensemble)->numbers(its_case, model, numbers, numbers + p);
    model->scales(numbers, scales, of_events);
    for (size_t i = 0; i < sizeof level / sizeof *level; ++i) {
        const bool is_there = level[i] >= (i < 2 ? 0 : p);
        if (is_there && (!is_set_alone(why, name, level[i], rules, ensemble) ||
                         !tdmf_accepts_if(why, i == 0 || numbers[level[i]] == 0.0, TDMF_EXCLUDED, name, 0,
                                          "it needs level ground and no push"))) {
            return false;
        }
    }
    return tdmf_accepts_number(why, "cases[].rules.terrain.length", "m", rules->terrain.length,
                               TDMF_MIN_SEGMENT * scales[places.foot_x], DBL_MAX) &&
           are_heights(why, &rules->terrain, fmax(model->parameter_least[places.height], -DBL_MAX),
                       fmin(model->parameter_most[places.height], DBL_MAX)) &&
           tdmf_accepts_if(why, rules->gait_count == 0, TDMF_EXCLUDED, name, 0,
                           "a case with gaits to settle on has no terrain");
}

static bool are_all_weights(tdmf_refusal *why, const tdmf_ensemble_rules *rules) {
    return tdmf_are_weights(why, "rules.step_weights[]", rules->step_weights,
                            "cases[].rules.step_weight_count", rules->step_weight_count) &&
           tdmf_are_weights(why, "rules.friction_weights[]", rules->friction_weights,
                            "cases[].rules.friction_weight_count", rules->friction_weight_count);
}

bool tdmf_is_sound_ground(tdmf_refusal *why, const tdmf_ensemble_case *its_case,
                          const tdmf_ensemble *ensemble) {
    const tdmf_ensemble_rules *rules = &its_case->rules;
    if (rules->roughness == 0.0 && rules->friction_spread == 0.0 && rules->terrain.length == 0.0) {
        return are_all_weights(why, rules);
    }
    const tdmf_model_kind model = tdmf_kind_of(ensemble)->model(ensemble, false);
    const tdmf_ground_places places = tdmf_places_of_ground(&model);
    return tdmf_accepts_if(why, tdmf_has_ground(&model), TDMF_EXCLUDED, "cases[].rules", 0,
                           "the model has no ground that may vary") &&
           is_drawn(why, "cases[].rules.roughness", rules->roughness, places.height, rules, ensemble) &&
           is_drawn(why, "cases[].rules.friction_spread", rules->friction_spread,
                    model.parameter_count + places.friction, rules, ensemble) &&
           are_all_weights(why, rules) &&
           (rules->terrain.length == 0.0 || is_terrain(why, its_case, ensemble, &model));
}

bool tdmf_are_foot_positions(tdmf_refusal *why, const tdmf_ensemble *ensemble) {
    for (int64_t i = 0; ensemble->foot_x != NULL && i < ensemble->count; ++i) {
        if (!tdmf_accepts_element(why, "foot_x[]", i, ensemble->foot_x[i], -largest_distance,
                                  largest_distance)) {
            return false;
        }
    }
    return true;
}
