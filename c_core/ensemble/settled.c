/* Tests whether an apex is near a gait, or in its ball of attraction. */
#include "settled.h"

#include <math.h>

static bool is_in_ball(const tdmf_ball *ball, const double *gait, const double *apex, int coordinates) {
    double square = 0.0;
    for (int i = 0; i < coordinates; ++i) {
        double sum = 0.0;
        for (int j = 0; j < coordinates; ++j) {
            sum += ball->matrix[i][j] * (apex[j] - gait[j]);
        }
        square += sum * sum;
    }
    return square <= 1.0;
}

static bool is_near(const double *gait, const double *apex, const double *scales, double distance,
                    int coordinates) {
    for (int i = 0; i < coordinates; ++i) {
        if (!(fabs(apex[i] - gait[i]) <= distance * scales[i])) {
            return false;
        }
    }
    return true;
}

/* Where strides begin anew, the page may have more states than there is room for here. The states held are
 * free there, because the next stride restores them. */
static void write_scales(const tdmf_member *member, double scales[TDMF_POINT_LIMIT]) {
    double room[TDMF_PLACE_LIMIT], of_events[TDMF_PAGE_EVENT_LIMIT];
    double *of_states = member->begins_anew ? member->held : room;
    member->page.model->scales(member->run->p, of_states, of_events);
    for (int i = 0; i < member->section->count; ++i) {
        scales[i] = of_states[member->section->coordinates[i]];
    }
}

int tdmf_gait_of_ball(const tdmf_member *member, const double apex[TDMF_POINT_LIMIT]) {
    const tdmf_ensemble_rules *rules = &member->its_case->rules;
    for (int gait = 0; rules->balls && gait < rules->gait_count; ++gait) {
        if (is_in_ball(&rules->balls[gait], rules->gaits[gait], apex, member->section->count)) {
            return gait;
        }
    }
    return -1;
}

int tdmf_gait_reached(const tdmf_member *member, const double apex[TDMF_POINT_LIMIT]) {
    const tdmf_ensemble_rules *rules = &member->its_case->rules;
    double scales[TDMF_POINT_LIMIT];
    if (rules->gait_count == 0) {
        return -1;
    }
    write_scales(member, scales);
    for (int gait = 0; gait < rules->gait_count; ++gait) {
        if (is_near(rules->gaits[gait], apex, scales, rules->distance, member->section->count)) {
            return gait;
        }
    }
    return tdmf_gait_of_ball(member, apex);
}
