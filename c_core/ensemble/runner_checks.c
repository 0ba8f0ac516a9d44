/* What a request for runners has to be. */
#include "runner_checks.h"

#include "patch.h"
#include "request_checks.h"
#include "runner_pages.h"
#include "settings.h"

#include <math.h>

/* The ground is not higher nor deeper than that, m. */
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

/* A size by which something is drawn that nobody else sets; of the return map, unless it is 0. */
static bool is_drawn_alone(double size, const char *what, const tdmf_ensemble_rules *rules,
                           const tdmf_ensemble *ensemble) {
    const int setting = tdmf_setting_of(what);
    const tdmf_given_settings *given = ensemble->given;
    if (size == 0.0) {
        return true;
    }
    return isfinite(size) && size > 0.0 && ensemble->map == TDMF_RETURN_MAP &&
           !(given != NULL && tdmf_has_setting(given->settings, given->count, setting)) &&
           !(rules->law != NULL && tdmf_has_setting(rules->law->settings, rules->law->count, setting));
}

static bool has_ground(const tdmf_ensemble_rules *rules, const tdmf_ensemble *ensemble) {
    return is_drawn_alone(rules->roughness, "ground.height", rules, ensemble) &&
           is_drawn_alone(rules->friction_spread, "ground.friction", rules, ensemble) &&
           tdmf_are_weights(rules->step_weights, rules->step_weight_count) &&
           tdmf_are_weights(rules->friction_weights, rules->friction_weight_count);
}

static bool is_constant(const char *what, const tdmf_ensemble_rules *rules, const tdmf_ensemble *ensemble) {
    return is_drawn_alone(1.0, what, rules, ensemble);
}

static bool are_heights(const tdmf_terrain *terrain) {
    for (int64_t i = 0; terrain->heights != NULL && i < terrain->height_count; ++i) {
        if (!isfinite(terrain->heights[i]) || fabs(terrain->heights[i]) > largest_height) {
            return false;
        }
    }
    return terrain->heights == NULL || terrain->height_count > 0;
}

/* A terrain needs level segments and a ballistic centre of mass, and excludes gaits to settle on. */
static bool is_terrain(const tdmf_ensemble_case *its_case, const tdmf_ensemble *ensemble) {
    static const char *const fixed[] = {"ground.height", "ground.slope", "body.external_fx",
                                        "body.external_fy"};
    const tdmf_ensemble_rules *rules = &its_case->rules;
    const tdmf_inputs *inputs = &its_case->inputs;
    if (rules->terrain.length == 0.0) {
        return true;
    }
    for (size_t i = 0; i < sizeof fixed / sizeof fixed[0]; ++i) {
        if (!is_constant(fixed[i], rules, ensemble)) {
            return false;
        }
    }
    return rules->terrain.length >= TDMF_MIN_SEGMENT * its_case->model->scales.length &&
           isfinite(rules->terrain.length) && are_heights(&rules->terrain) && rules->gait_count == 0 &&
           inputs->ground.slope == 0.0 && inputs->body.external_fx == 0.0 && inputs->body.external_fy == 0.0;
}

/* What a gait or the reduced map is made of does not know where it is. */
static bool may_have_patch(const tdmf_ensemble_case *its_case, const tdmf_ensemble *ensemble) {
    return !tdmf_has_patch(its_case->model) ||
           (its_case->rules.gait_count == 0 && ensemble->map == TDMF_RETURN_MAP);
}

static bool are_foot_positions(const double *foot_x, int64_t count) {
    for (int64_t i = 0; foot_x != NULL && i < count; ++i) {
        if (!tdmf_in_range(&tdmf_state_ranges[TDMF_FOOT_X], foot_x[i])) {
            return false;
        }
    }
    return true;
}

bool tdmf_is_runner_case(const tdmf_ensemble_case *its_case, const tdmf_ensemble *ensemble) {
    return its_case->model != NULL && may_have_patch(its_case, ensemble) &&
           has_ground(&its_case->rules, ensemble) && is_terrain(its_case, ensemble);
}

bool tdmf_is_runner_checkpoint(const tdmf_ensemble_checkpoint *from, const tdmf_ensemble *ensemble) {
    return from->mode >= 0 && tdmf_mode_on_part(tdmf_page_for(ensemble->map, false), from->mode) >= 0;
}

bool tdmf_are_sound_runners(const tdmf_ensemble *ensemble) {
    return !ensemble->notes && are_foot_positions(ensemble->foot_x, ensemble->count) &&
           (ensemble->map == TDMF_RETURN_MAP || ensemble->map == TDMF_REDUCED_MAP);
}
