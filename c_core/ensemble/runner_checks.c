/* Checks of a request for runners. */
#include "runner_checks.h"

#include "patch.h"
#include "ranges.h"
#include "request_checks.h"
#include "runner_pages.h"
#include "settings.h"

#include <float.h>

/* Largest height and depth of the ground, m. */
static const double largest_height = 1e9;

bool tdmf_range_of_setting(const tdmf_ensemble *ensemble, int setting, double *least, double *most) {
    const tdmf_range *range = tdmf_setting_range(setting);
    (void)ensemble;
    if (range) {
        *least = range->minimum;
        *most = range->maximum;
    }
    return range != NULL;
}

int tdmf_runner_coordinates(const tdmf_ensemble *ensemble) {
    return ensemble->map == TDMF_REDUCED_MAP ? (int)TDMF_REDUCED_COUNT : (int)TDMF_SECTION_COUNT;
}

/* A value that is drawn, or has to be constant, is set neither by a law nor by the request. */
static bool is_set_alone(tdmf_refusal *why, const char *name, const char *what,
                         const tdmf_ensemble_rules *rules, const tdmf_ensemble *ensemble) {
    const int setting = tdmf_setting_of(what);
    const tdmf_given_settings *given = ensemble->given;
    return tdmf_accepts_if(why, ensemble->map == TDMF_RETURN_MAP, TDMF_EXCLUDED, name, 0,
                           "the reduced map has no uneven ground") &&
           tdmf_accepts_if(why,
                           !(given != NULL && tdmf_has_setting(given->settings, given->count, setting)) &&
                               !(rules->law != NULL &&
                                 tdmf_has_setting(rules->law->settings, rules->law->count, setting)),
                           TDMF_EXCLUDED, name, 0, "a setting sets what is drawn or has to be constant");
}

/* A size by which something is drawn; 0: it is not. */
static bool is_drawn(tdmf_refusal *why, const char *name, double size, const char *what,
                     const tdmf_ensemble_rules *rules, const tdmf_ensemble *ensemble) {
    return size == 0.0 || (tdmf_accepts_number(why, name, "1", size, 0.0, DBL_MAX) &&
                           is_set_alone(why, name, what, rules, ensemble));
}

static bool has_ground(tdmf_refusal *why, const tdmf_ensemble_rules *rules, const tdmf_ensemble *ensemble) {
    return is_drawn(why, "cases[].rules.roughness", rules->roughness, "ground.height", rules, ensemble) &&
           is_drawn(why, "cases[].rules.friction_spread", rules->friction_spread, "ground.friction", rules,
                    ensemble) &&
           tdmf_are_weights(why, "rules.step_weights[]", rules->step_weights,
                            "cases[].rules.step_weight_count", rules->step_weight_count) &&
           tdmf_are_weights(why, "rules.friction_weights[]", rules->friction_weights,
                            "cases[].rules.friction_weight_count", rules->friction_weight_count);
}

static bool are_heights(tdmf_refusal *why, const tdmf_terrain *terrain) {
    const double least = terrain->heights != NULL ? 1.0 : -DBL_MAX;
    if (!tdmf_accepts_number(why, "cases[].rules.terrain.height_count", "1", (double)terrain->height_count,
                             least, DBL_MAX)) {
        return false;
    }
    for (int64_t i = 0; terrain->heights != NULL && i < terrain->height_count; ++i) {
        if (!tdmf_accepts_element(why, "rules.terrain.heights[]", i, terrain->heights[i], -largest_height,
                                  largest_height)) {
            return false;
        }
    }
    return true;
}

/* A terrain needs level segments and a ballistic centre of mass, and excludes gaits to settle on. */
static bool is_terrain(tdmf_refusal *why, const tdmf_ensemble_case *its_case, const tdmf_ensemble *ensemble) {
    static const char *const fixed[] = {"ground.height", "ground.slope", "body.external_fx",
                                        "body.external_fy"};
    const tdmf_ensemble_rules *rules = &its_case->rules;
    const tdmf_inputs *inputs = &its_case->inputs;
    const double least = TDMF_MIN_SEGMENT * its_case->model->scales.length;
    if (rules->terrain.length == 0.0) {
        return true;
    }
    for (size_t i = 0; i < sizeof fixed / sizeof fixed[0]; ++i) {
        if (!is_set_alone(why, "cases[].rules.terrain", fixed[i], rules, ensemble)) {
            return false;
        }
    }
    return tdmf_accepts_number(why, "cases[].rules.terrain.length", "m", rules->terrain.length, least,
                               DBL_MAX) &&
           are_heights(why, &rules->terrain) &&
           tdmf_accepts_if(why, rules->gait_count == 0, TDMF_EXCLUDED, "cases[].rules.terrain", 0,
                           "a case with gaits to settle on has no terrain") &&
           tdmf_accepts_if(why,
                           inputs->ground.slope == 0.0 && inputs->body.external_fx == 0.0 &&
                               inputs->body.external_fy == 0.0,
                           TDMF_EXCLUDED, "cases[].rules.terrain", 0, "it needs level ground and no push");
}

/* Gaits and the reduced map do not depend on the place, and a patch of ground does. */
static bool may_have_patch(tdmf_refusal *why, const tdmf_ensemble_case *its_case,
                           const tdmf_ensemble *ensemble) {
    return tdmf_accepts_if(why,
                           !tdmf_has_patch(its_case->model) ||
                               (its_case->rules.gait_count == 0 && ensemble->map == TDMF_RETURN_MAP),
                           TDMF_EXCLUDED, "ground.patch_end", 0,
                           "a patch of ground excludes gaits to settle on and the reduced map");
}

static bool are_foot_positions(tdmf_refusal *why, const double *foot_x, int64_t count) {
    const tdmf_range *range = &tdmf_state_ranges[0];
    for (int64_t i = 0; foot_x != NULL && i < count; ++i) {
        if (!tdmf_accepts_element(why, "foot_x[]", i, foot_x[i], range->minimum, range->maximum)) {
            return false;
        }
    }
    return true;
}

bool tdmf_is_runner_case(tdmf_refusal *why, const tdmf_ensemble_case *its_case,
                         const tdmf_ensemble *ensemble) {
    return tdmf_accepts_pointer(why, "cases[].model", its_case->model) &&
           may_have_patch(why, its_case, ensemble) && has_ground(why, &its_case->rules, ensemble) &&
           is_terrain(why, its_case, ensemble);
}

bool tdmf_is_runner_checkpoint(const tdmf_ensemble_checkpoint *from, const tdmf_ensemble *ensemble) {
    return from->mode >= 0 && tdmf_mode_on_part(tdmf_page_for(ensemble->map, false), from->mode) >= 0;
}

bool tdmf_are_sound_runners(tdmf_refusal *why, const tdmf_ensemble *ensemble) {
    return tdmf_accepts_if(why, !ensemble->notes, TDMF_EXCLUDED, "notes", 0, "only a page has notes") &&
           are_foot_positions(why, ensemble->foot_x, ensemble->count) &&
           tdmf_accepts_number(why, "map", "1", (int)ensemble->map, TDMF_RETURN_MAP, TDMF_REDUCED_MAP);
}
