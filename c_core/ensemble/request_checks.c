/* Checks of a request that do not depend on its model. Names with "[]" take the number of a case, of a runner
 * or of an element. */
#include "request_checks.h"

#include "member.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

/* Largest number in a request: sums of products of such numbers are finite. */
static const double largest = 1e100;

/* More runners have no room in memory for their ends. */
static const int64_t most_runners = PTRDIFF_MAX / (int64_t)sizeof(tdmf_ensemble_end);

bool tdmf_has_setting(const int *settings, int count, int setting) {
    for (int i = 0; i < count; ++i) {
        if (settings[i] == setting) {
            return true;
        }
    }
    return false;
}

static bool has_value(tdmf_refusal *why, const char *name, int64_t index, const tdmf_ensemble *ensemble,
                      int setting, double value) {
    double least = 0.0, most = 0.0;
    tdmf_kind_of(ensemble)->range(ensemble, setting, &least, &most);
    return tdmf_accepts_element(why, name, index, value, fmax(least, -DBL_MAX), fmin(most, DBL_MAX));
}

static bool are_settings(tdmf_refusal *why, const char *name, const int *settings, const char *count_name,
                         int count, const tdmf_ensemble *ensemble) {
    double least, most;
    if (!tdmf_accepts_array(why, name, settings, count_name, count, TDMF_SETTING_LIMIT)) {
        return false;
    }
    for (int i = 0; i < count; ++i) {
        const bool is_one = tdmf_kind_of(ensemble)->range(ensemble, settings[i], &least, &most);
        if (!tdmf_accepts_if(why, is_one, TDMF_EXCLUDED, name, 0, "there is no such setting") ||
            !tdmf_accepts_if(why, !tdmf_has_setting(settings, i, settings[i]), TDMF_EXCLUDED, name, 0,
                             "a setting is set twice")) {
            return false;
        }
    }
    return true;
}

/* Gain and noise of the measured coordinates; the other coordinates have none. */
static bool measures(tdmf_refusal *why, const tdmf_affine_law *law, int coordinates) {
    for (int j = 0; j < TDMF_POINT_LIMIT; ++j) {
        const double most = j < coordinates ? largest : 0.0;
        if (!tdmf_accepts_element(why, "cases[].rules.law.apex", 0, law->apex[j], -largest, largest) ||
            !tdmf_accepts_element(why, "cases[].rules.law.noise", 0, law->noise[j], 0.0, most)) {
            return false;
        }
        for (int i = 0; i < law->count; ++i) {
            if (!tdmf_accepts_element(why, "cases[].rules.law.gain", 0, law->gain[i][j], 0.0 - most, most)) {
                return false;
            }
        }
    }
    return true;
}

static bool has_limits(tdmf_refusal *why, const tdmf_affine_law *law, const tdmf_ensemble *ensemble) {
    for (int i = 0; i < law->count; ++i) {
        const double low = law->low[i], high = law->high[i];
        const int setting = law->settings[i];
        if (!tdmf_accepts_element(why, "cases[].rules.law.nominal", 0, law->nominal[i], -largest, largest) ||
            !has_value(why, "cases[].rules.law.low", 0, ensemble, setting, low) ||
            !has_value(why, "cases[].rules.law.high", 0, ensemble, setting, high) ||
            !tdmf_accepts_element(why, "cases[].rules.law.high", 0, high, low, largest)) {
            return false;
        }
    }
    return true;
}

static bool is_law(tdmf_refusal *why, const tdmf_affine_law *law, const tdmf_ensemble *ensemble) {
    const tdmf_given_settings *given = ensemble->given;
    const int coordinates = tdmf_kind_of(ensemble)->section(ensemble)->count;
    const struct {
        const char *name;
        const void *values;
    } arrays[] = {{"cases[].rules.law.nominal", law->nominal},
                  {"cases[].rules.law.gain", law->gain},
                  {"cases[].rules.law.low", law->low},
                  {"cases[].rules.law.high", law->high}};
    if (!are_settings(why, "cases[].rules.law.settings", law->settings, "cases[].rules.law.count", law->count,
                      ensemble)) {
        return false;
    }
    for (size_t i = 0; law->count > 0 && i < sizeof arrays / sizeof arrays[0]; ++i) {
        if (!tdmf_accepts_pointer(why, arrays[i].name, arrays[i].values)) {
            return false;
        }
    }
    for (int i = 0; given != NULL && i < given->count; ++i) {
        const bool is_given = tdmf_has_setting(law->settings, law->count, given->settings[i]);
        if (!tdmf_accepts_if(why, !is_given, TDMF_EXCLUDED, "cases[].rules.law.settings", 0,
                             "a setting of the law is also given")) {
            return false;
        }
    }
    return measures(why, law, coordinates) && has_limits(why, law, ensemble);
}

static bool are_given(tdmf_refusal *why, const tdmf_ensemble *ensemble) {
    const tdmf_given_settings *given = ensemble->given;
    if (!are_settings(why, "given.settings", given->settings, "given.count", given->count, ensemble) ||
        !tdmf_accepts_number(why, "given.first", "1", given->first, 0.0, INT_MAX) ||
        !tdmf_accepts_number(why, "given.strides", "1", given->strides, 1.0, INT_MAX) ||
        !tdmf_accepts_array(why, "given.values", given->values, "given.count", given->count * ensemble->count,
                            INT64_MAX)) {
        return false;
    }
    const int64_t values = ensemble->count * given->strides * given->count;
    for (int64_t i = 0; i < values; ++i) {
        const int setting = given->settings[i % given->count];
        if (!has_value(why, "given.values[]", i, ensemble, setting, given->values[i])) {
            return false;
        }
    }
    return true;
}

bool tdmf_are_weights(tdmf_refusal *why, const char *name, const double *weights, const char *count_name,
                      int count) {
    if (!tdmf_accepts_array(why, name, weights, count_name, count, INT_MAX)) {
        return false;
    }
    for (int i = 0; i < count; ++i) {
        if (!tdmf_accepts_element(why, name, i, weights[i], -largest, largest)) {
            return false;
        }
    }
    return true;
}

static bool are_balls(tdmf_refusal *why, const tdmf_ball *balls, int count) {
    for (int gait = 0; balls && gait < count; ++gait) {
        const double *matrix = &balls[gait].matrix[0][0];
        for (int i = 0; i < TDMF_POINT_LIMIT * TDMF_POINT_LIMIT; ++i) {
            if (!tdmf_accepts_element(why, "cases[].rules.balls.matrix", 0, matrix[i], -largest, largest)) {
                return false;
            }
        }
    }
    return true;
}

static bool is_case(tdmf_refusal *why, const tdmf_ensemble *ensemble, int number) {
    const tdmf_ensemble_case *its_case = &ensemble->cases[number];
    const tdmf_ensemble_rules *rules = &its_case->rules;
    const bool is_accepted = (rules->law == NULL || is_law(why, rules->law, ensemble)) &&
                             tdmf_kind_of(ensemble)->is_case(why, its_case, ensemble) &&
                             tdmf_accepts_array(why, "cases[].rules.gaits", rules->gaits,
                                                "cases[].rules.gait_count", rules->gait_count, INT_MAX) &&
                             are_balls(why, rules->balls, rules->gait_count);
    if (!is_accepted && strncmp(why->variable, "cases[]", strlen("cases[]")) == 0) {
        why->index = number;
    }
    return is_accepted;
}

static bool has_cases(tdmf_refusal *why, const tdmf_ensemble *ensemble) {
    const double last = (double)ensemble->case_count - 1.0;
    if (!tdmf_accepts_number(why, "case_count", "1", ensemble->case_count, ensemble->count > 0, INT_MAX)) {
        return false;
    }
    for (int64_t i = 0; ensemble->case_of && i < ensemble->count; ++i) {
        if (!tdmf_accepts_element(why, "case_of[]", i, ensemble->case_of[i], 0.0, last)) {
            return false;
        }
    }
    for (int i = 0; i < ensemble->case_count; ++i) {
        if (!is_case(why, ensemble, i)) {
            return false;
        }
    }
    return true;
}

/* Strides to record: the first one and their number. */
static bool has_room(tdmf_refusal *why, const tdmf_ensemble *ensemble) {
    return ensemble->strides == NULL ||
           (tdmf_accepts_number(why, "first_stride", "1", ensemble->first_stride, 0.0, INT_MAX) &&
            tdmf_accepts_number(why, "stride_count", "1", ensemble->stride_count, 0.0, INT_MAX));
}

static bool has_checkpoints(tdmf_refusal *why, const tdmf_ensemble *ensemble) {
    if (ensemble->goes_on && ensemble->count > 0 &&
        !tdmf_accepts_pointer(why, "checkpoints", ensemble->checkpoints)) {
        return false;
    }
    for (int64_t i = 0; ensemble->goes_on && i < ensemble->count; ++i) {
        const tdmf_ensemble_checkpoint *from = &ensemble->checkpoints[i];
        if (!from->stands) {
            continue;
        }
        if (!tdmf_accepts_if(why, tdmf_is_of_model(from, ensemble), TDMF_EXCLUDED, "checkpoints[]", i,
                             "it is of another model or section") ||
            !tdmf_accepts_if(why, tdmf_kind_of(ensemble)->is_checkpoint(from, ensemble), TDMF_EXCLUDED,
                             "checkpoints[].mode", i, "the model has no such mode")) {
            return false;
        }
    }
    return true;
}

static bool is_tolerance(tdmf_refusal *why, double tolerance) {
    return tdmf_accepts_number(why, "relative_tolerance", "1", tolerance, 1e-300, 1.0 - DBL_EPSILON);
}

bool tdmf_is_sound_ensemble(tdmf_refusal *why, const tdmf_ensemble *ensemble, const tdmf_ensemble_end *ends) {
    return tdmf_accepts_pointer(why, "ensemble", ensemble) &&
           tdmf_accepts_if(why, tdmf_kind_of(ensemble) != NULL, TDMF_UNAVAILABLE, "page", 0,
                           "this library does not have the model") &&
           tdmf_kind_of(ensemble)->is_sound(why, ensemble) &&
           tdmf_accepts_array(why, "ends", ends, "count", ensemble->count, most_runners) &&
           tdmf_accepts_array(why, "starts", ensemble->starts, "count", ensemble->count, INT64_MAX) &&
           tdmf_accepts_array(why, "cases", ensemble->cases, "case_count", ensemble->case_count, INT_MAX) &&
           tdmf_accepts_number(why, "threads", "1", ensemble->threads, 1.0, INT_MAX) &&
           tdmf_accepts_number(why, "step_limit", "1", (double)ensemble->step_limit, 0.0, (double)LONG_MAX) &&
           is_tolerance(why, ensemble->relative_tolerance) &&
           tdmf_accepts_if(why, tdmf_can_step(ensemble), TDMF_UNAVAILABLE, "instructions", 0,
                           "this processor or this build does not have them") &&
           (ensemble->given == NULL || are_given(why, ensemble)) && has_cases(why, ensemble) &&
           has_room(why, ensemble) && has_checkpoints(why, ensemble);
}
