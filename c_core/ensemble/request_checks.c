/* What a request has to be. */
#include "request_checks.h"

#include "patch.h"
#include "ranges.h"
#include "request.h"
#include "runner_pages.h"
#include "settings.h"

#include <math.h>

/* Beyond this, sums of products would not be finite. */
static const double largest = 1e100;

/* The ground is not higher nor deeper than that, m. */
static const double largest_height = 1e9;

static bool is_moderate(double value) {
    return fabs(value) <= largest; /* NaN is not */
}

static bool has(const int *settings, int count, int setting) {
    for (int i = 0; i < count; ++i) {
        if (settings[i] == setting) {
            return true;
        }
    }
    return false;
}

/* An array of no elements may be absent. */
static bool is_array(const void *elements, int64_t count) {
    return count == 0 || (count > 0 && elements != NULL);
}

static bool are_settings(const int *settings, int count) {
    if (!is_array(settings, count) || count > TDMF_SETTING_LIMIT) {
        return false;
    }
    for (int i = 0; i < count; ++i) {
        if (tdmf_setting_range(settings[i]) == NULL || has(settings, i, settings[i])) {
            return false;
        }
    }
    return true;
}

/* Coordinates that are measured: the others have neither gain nor noise. */
static bool measures(const tdmf_affine_law *law, int coordinates) {
    for (int j = 0; j < TDMF_SECTION_COUNT; ++j) {
        const double noise = law->noise[j];
        if (!is_moderate(law->apex[j]) || !(noise >= 0.0 && noise <= largest) ||
            (j >= coordinates && noise != 0.0)) {
            return false;
        }
        for (int i = 0; i < law->count; ++i) {
            const double gain = law->gain[i][j];
            if (!is_moderate(gain) || (j >= coordinates && gain != 0.0)) {
                return false;
            }
        }
    }
    return true;
}

static bool has_limits(const tdmf_affine_law *law) {
    for (int i = 0; i < law->count; ++i) {
        const tdmf_range *range = tdmf_setting_range(law->settings[i]);
        if (!is_moderate(law->nominal[i]) || !tdmf_in_range(range, law->low[i]) ||
            !tdmf_in_range(range, law->high[i]) || law->low[i] > law->high[i]) {
            return false;
        }
    }
    return true;
}

static bool is_law(const tdmf_affine_law *law, const tdmf_ensemble *ensemble) {
    const tdmf_given_settings *given = ensemble->given;
    const int coordinates =
        ensemble->map == TDMF_REDUCED_MAP ? (int)TDMF_REDUCED_COUNT : (int)TDMF_SECTION_COUNT;
    if (!are_settings(law->settings, law->count) || !is_array(law->nominal, law->count) ||
        !is_array(law->gain, law->count) || !is_array(law->low, law->count) ||
        !is_array(law->high, law->count) || !measures(law, coordinates) || !has_limits(law)) {
        return false;
    }
    for (int i = 0; given != NULL && i < given->count; ++i) {
        if (has(law->settings, law->count, given->settings[i])) {
            return false;
        }
    }
    return true;
}

static bool are_given(const tdmf_given_settings *given, int64_t runners) {
    if (!are_settings(given->settings, given->count) || given->first < 0 || given->strides <= 0 ||
        !is_array(given->values, given->count * runners)) {
        return false;
    }
    for (int64_t row = 0; row < runners * given->strides; ++row) {
        for (int i = 0; i < given->count; ++i) {
            if (!tdmf_in_range(tdmf_setting_range(given->settings[i]),
                               given->values[row * given->count + i])) {
                return false;
            }
        }
    }
    return true;
}

static bool are_weights(const double *weights, int count) {
    if (!is_array(weights, count)) {
        return false;
    }
    for (int i = 0; i < count; ++i) {
        if (!is_moderate(weights[i])) {
            return false;
        }
    }
    return true;
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
           !(given != NULL && has(given->settings, given->count, setting)) &&
           !(rules->law != NULL && has(rules->law->settings, rules->law->count, setting));
}

static bool has_ground(const tdmf_ensemble_rules *rules, const tdmf_ensemble *ensemble) {
    return is_drawn_alone(rules->roughness, "ground.height", rules, ensemble) &&
           is_drawn_alone(rules->friction_spread, "ground.friction", rules, ensemble) &&
           are_weights(rules->step_weights, rules->step_weight_count) &&
           are_weights(rules->friction_weights, rules->friction_weight_count);
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

static bool are_balls(const tdmf_ball *balls, int count) {
    for (int gait = 0; balls && gait < count; ++gait) {
        for (int i = 0; i < TDMF_SECTION_COUNT; ++i) {
            for (int j = 0; j < TDMF_SECTION_COUNT; ++j) {
                if (!is_moderate(balls[gait].matrix[i][j])) {
                    return false;
                }
            }
        }
    }
    return true;
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

static bool is_case(const tdmf_ensemble_case *its_case, const tdmf_ensemble *ensemble) {
    const tdmf_ensemble_rules *rules = &its_case->rules;
    return its_case->model != NULL && may_have_patch(its_case, ensemble) &&
           is_array(rules->gaits, rules->gait_count) && are_balls(rules->balls, rules->gait_count) &&
           (rules->law == NULL || is_law(rules->law, ensemble)) && has_ground(rules, ensemble) &&
           is_terrain(its_case, ensemble);
}

static bool has_cases(const tdmf_ensemble *ensemble) {
    for (int64_t i = 0; ensemble->case_of && i < ensemble->count; ++i) {
        if (ensemble->case_of[i] < 0 || ensemble->case_of[i] >= ensemble->case_count) {
            return false;
        }
    }
    for (int i = 0; i < ensemble->case_count; ++i) {
        if (!is_case(&ensemble->cases[i], ensemble)) {
            return false;
        }
    }
    return ensemble->count == 0 || ensemble->case_count > 0;
}

/* Where strides are noted, and what runners go on from. */
static bool has_room(const tdmf_ensemble *ensemble) {
    return ensemble->strides == NULL || (ensemble->first_stride >= 0 && ensemble->stride_count >= 0);
}

/* Whether the page of a map has a mode of the runner's page. */
static bool is_mode(int mode, tdmf_apex_map map) {
    const tdmf_page_part *page = tdmf_page_for(map, false);
    return mode >= 0 && tdmf_mode_on_part(page, mode) >= 0;
}

static bool has_checkpoints(const tdmf_ensemble *ensemble) {
    for (int64_t i = 0; ensemble->goes_on && i < ensemble->count; ++i) {
        if (ensemble->checkpoints == NULL ||
            (ensemble->checkpoints[i].stands && !is_mode(ensemble->checkpoints[i].mode, ensemble->map))) {
            return false;
        }
    }
    return true;
}

bool tdmf_is_sound_ensemble(const tdmf_ensemble *ensemble, const tdmf_ensemble_end *ends) {
    return ensemble != NULL && is_array(ends, ensemble->count) &&
           is_array(ensemble->starts, ensemble->count) &&
           are_foot_positions(ensemble->foot_x, ensemble->count) &&
           is_array(ensemble->cases, ensemble->case_count) && ensemble->threads > 0 &&
           ensemble->step_limit >= 0 && tdmf_is_tolerance(ensemble->relative_tolerance) &&
           tdmf_has_instructions(ensemble->instructions) &&
           (ensemble->map == TDMF_RETURN_MAP || ensemble->map == TDMF_REDUCED_MAP) &&
           (ensemble->given == NULL || are_given(ensemble->given, ensemble->count)) && has_cases(ensemble) &&
           has_room(ensemble) && has_checkpoints(ensemble);
}
