/* Checks of a request for runners. */
#include "runner_checks.h"

#include "ground.h"
#include "patch.h"
#include "ranges.h"
#include "runner_pages.h"
#include "settings.h"

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

/* Gaits and the reduced map do not depend on the place, and a patch of ground does. */
static bool may_have_patch(tdmf_refusal *why, const tdmf_ensemble_case *its_case,
                           const tdmf_ensemble *ensemble) {
    return tdmf_accepts_if(why,
                           !tdmf_has_patch(its_case->model) ||
                               (its_case->rules.gait_count == 0 && ensemble->map == TDMF_RETURN_MAP),
                           TDMF_EXCLUDED, "ground.patch_end", 0,
                           "a patch of ground excludes gaits to settle on and the reduced map");
}

bool tdmf_is_runner_case(tdmf_refusal *why, const tdmf_ensemble_case *its_case,
                         const tdmf_ensemble *ensemble) {
    return tdmf_accepts_pointer(why, "cases[].model", its_case->model) &&
           may_have_patch(why, its_case, ensemble) && tdmf_is_sound_ground(why, its_case, ensemble);
}

bool tdmf_is_runner_checkpoint(const tdmf_ensemble_checkpoint *from, const tdmf_ensemble *ensemble) {
    return from->mode >= 0 && tdmf_mode_on_part(tdmf_page_for(ensemble->map, false), from->mode) >= 0;
}

bool tdmf_are_sound_runners(tdmf_refusal *why, const tdmf_ensemble *ensemble) {
    return tdmf_accepts_if(why, !ensemble->notes, TDMF_EXCLUDED, "notes", 0, "only a page has notes") &&
           tdmf_are_foot_positions(why, ensemble) &&
           tdmf_accepts_number(why, "map", "1", (int)ensemble->map, TDMF_RETURN_MAP, TDMF_REDUCED_MAP);
}
