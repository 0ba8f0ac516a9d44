/* What a request has to be, whatever its model. */
#include "request_checks.h"

#include "member.h"

#include <math.h>

/* Beyond this, sums of products would not be finite. */
static const double largest = 1e100;

static bool is_moderate(double value) {
    return fabs(value) <= largest; /* NaN is not */
}

bool tdmf_has_setting(const int *settings, int count, int setting) {
    for (int i = 0; i < count; ++i) {
        if (settings[i] == setting) {
            return true;
        }
    }
    return false;
}

/* An array of no elements may be absent. */
bool tdmf_is_array(const void *elements, int64_t count) {
    return count == 0 || (count > 0 && elements != NULL);
}

static bool has_value(const tdmf_ensemble *ensemble, int setting, double value) {
    double least, most;
    return tdmf_kind_of(ensemble)->range(ensemble, setting, &least, &most) && value >= least &&
           value <= most && isfinite(value);
}

static bool are_settings(const int *settings, int count, const tdmf_ensemble *ensemble) {
    double least, most;
    if (!tdmf_is_array(settings, count) || count > TDMF_SETTING_LIMIT) {
        return false;
    }
    for (int i = 0; i < count; ++i) {
        if (!tdmf_kind_of(ensemble)->range(ensemble, settings[i], &least, &most) ||
            tdmf_has_setting(settings, i, settings[i])) {
            return false;
        }
    }
    return true;
}

/* Coordinates that are measured: the others have neither gain nor noise. */
static bool measures(const tdmf_affine_law *law, int coordinates) {
    for (int j = 0; j < TDMF_POINT_LIMIT; ++j) {
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

static bool has_limits(const tdmf_affine_law *law, const tdmf_ensemble *ensemble) {
    for (int i = 0; i < law->count; ++i) {
        const int setting = law->settings[i];
        if (!is_moderate(law->nominal[i]) || !has_value(ensemble, setting, law->low[i]) ||
            !has_value(ensemble, setting, law->high[i]) || law->low[i] > law->high[i]) {
            return false;
        }
    }
    return true;
}

static bool is_law(const tdmf_affine_law *law, const tdmf_ensemble *ensemble) {
    const tdmf_given_settings *given = ensemble->given;
    if (!are_settings(law->settings, law->count, ensemble) || !tdmf_is_array(law->nominal, law->count) ||
        !tdmf_is_array(law->gain, law->count) || !tdmf_is_array(law->low, law->count) ||
        !tdmf_is_array(law->high, law->count) ||
        !measures(law, tdmf_kind_of(ensemble)->coordinates(ensemble)) || !has_limits(law, ensemble)) {
        return false;
    }
    for (int i = 0; given != NULL && i < given->count; ++i) {
        if (tdmf_has_setting(law->settings, law->count, given->settings[i])) {
            return false;
        }
    }
    return true;
}

static bool are_given(const tdmf_ensemble *ensemble) {
    const tdmf_given_settings *given = ensemble->given;
    const int64_t runners = ensemble->count;
    if (!are_settings(given->settings, given->count, ensemble) || given->first < 0 || given->strides <= 0 ||
        !tdmf_is_array(given->values, given->count * runners)) {
        return false;
    }
    for (int64_t row = 0; row < runners * given->strides; ++row) {
        for (int i = 0; i < given->count; ++i) {
            if (!has_value(ensemble, given->settings[i], given->values[row * given->count + i])) {
                return false;
            }
        }
    }
    return true;
}

bool tdmf_are_weights(const double *weights, int count) {
    if (!tdmf_is_array(weights, count)) {
        return false;
    }
    for (int i = 0; i < count; ++i) {
        if (!is_moderate(weights[i])) {
            return false;
        }
    }
    return true;
}

static bool are_balls(const tdmf_ball *balls, int count) {
    for (int gait = 0; balls && gait < count; ++gait) {
        for (int i = 0; i < TDMF_POINT_LIMIT; ++i) {
            for (int j = 0; j < TDMF_POINT_LIMIT; ++j) {
                if (!is_moderate(balls[gait].matrix[i][j])) {
                    return false;
                }
            }
        }
    }
    return true;
}

static bool is_case(const tdmf_ensemble_case *its_case, const tdmf_ensemble *ensemble) {
    const tdmf_ensemble_rules *rules = &its_case->rules;
    return tdmf_kind_of(ensemble)->is_case(its_case, ensemble) &&
           tdmf_is_array(rules->gaits, rules->gait_count) && are_balls(rules->balls, rules->gait_count) &&
           (rules->law == NULL || is_law(rules->law, ensemble));
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

static bool has_checkpoints(const tdmf_ensemble *ensemble) {
    for (int64_t i = 0; ensemble->goes_on && i < ensemble->count; ++i) {
        if (ensemble->checkpoints == NULL ||
            (ensemble->checkpoints[i].stands &&
             !tdmf_kind_of(ensemble)->is_checkpoint(&ensemble->checkpoints[i], ensemble))) {
            return false;
        }
    }
    return true;
}

bool tdmf_is_sound_ensemble(const tdmf_ensemble *ensemble, const tdmf_ensemble_end *ends) {
    return ensemble != NULL && tdmf_kind_of(ensemble) && tdmf_kind_of(ensemble)->is_sound(ensemble) &&
           tdmf_is_array(ends, ensemble->count) && tdmf_is_array(ensemble->starts, ensemble->count) &&
           tdmf_is_array(ensemble->cases, ensemble->case_count) && ensemble->threads > 0 &&
           ensemble->step_limit >= 0 && ensemble->relative_tolerance > 0.0 &&
           ensemble->relative_tolerance < 1.0 && tdmf_has_instructions(ensemble->instructions) &&
           (ensemble->given == NULL || are_given(ensemble)) && has_cases(ensemble) && has_room(ensemble) &&
           has_checkpoints(ensemble);
}
