/* The runner as a member of an ensemble: its pages, its settings, its start, and the quantities of strides
 * that other pages do not have. */
#include "ground.h"

#include "mapped_stride.h"
#include "page_fields.h"
#include "page_map.h"
#include "page_run.h"
#include "patch.h"
#include "ranges.h"
#include "refusal.h"
#include "runner_pages.h"
#include "stride_limits.h"
#include "words.h"

#include "tdmf_slip/automaton.h"

#include <math.h>
#include <string.h>

/* ---- the page ------------------------------------------------------------------------------------------ */

static runner_states states_of(const tdmf_member *member) {
    runner_states x;
    memcpy(&x, tdmf_runner_model.state_defaults, sizeof x);
    tdmf_give_states(&member->page, member->run->x, &x);
    return x;
}

static void numbers(const tdmf_ensemble_case *its_case, const tdmf_model_kind *model, double *parameters,
                    double *states) {
    (void)model;
    *(runner_parameters *)parameters = tdmf_page_parameters(&its_case->model->parameters, &its_case->inputs);
    memcpy(states, tdmf_runner_model.state_defaults, sizeof(runner_states));
    tdmf_write_page_inputs(&its_case->inputs, (runner_states *)states);
}

/* ---- settings ------------------------------------------------------------------------------------------ */

/* The range of a setting; NULL if there is no setting of this number. The rows of the parameters' table come
 * first, then those of the inputs'. */
static const tdmf_range *range_of(int setting) {
    const int parameters = TDMF_PARAMETER_COUNT;
    if (setting < 0 || setting >= parameters + TDMF_INPUT_COUNT) {
        return NULL;
    }
    const tdmf_range *range =
        setting < parameters ? &tdmf_parameter_ranges[setting] : &tdmf_input_ranges[setting - parameters];
    return range->at_events ? range : NULL;
}

int tdmf_setting_of(const char *name) {
    const int count = TDMF_PARAMETER_COUNT + TDMF_INPUT_COUNT;
    for (int setting = 0; name != NULL && setting < count; ++setting) {
        const tdmf_range *range = range_of(setting);
        if (range != NULL && strcmp(range->name, name) == 0) {
            return setting;
        }
    }
    return -1;
}

static bool range(const tdmf_ensemble *ensemble, int setting, double *least, double *most) {
    const tdmf_range *of = range_of(setting);
    (void)ensemble;
    if (of) {
        *least = of->minimum;
        *most = of->maximum;
    }
    return of != NULL;
}

static int place(int setting) {
    return range_of(setting)->place;
}

/* ---- requests ------------------------------------------------------------------------------------------ */

static const tdmf_section_kind *section(const tdmf_ensemble *ensemble) {
    return &tdmf_page_for(ensemble->map, false)->model->sections[0];
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

static bool is_case(tdmf_refusal *why, const tdmf_ensemble_case *its_case, const tdmf_ensemble *ensemble) {
    return tdmf_accepts_pointer(why, "cases[].model", its_case->model) &&
           may_have_patch(why, its_case, ensemble) && tdmf_is_sound_ground(why, its_case, ensemble);
}

static bool is_checkpoint(const tdmf_ensemble_checkpoint *from, const tdmf_ensemble *ensemble) {
    return from->mode >= 0 && tdmf_mode_on_part(tdmf_page_for(ensemble->map, false), from->mode) >= 0;
}

static bool is_sound(tdmf_refusal *why, const tdmf_ensemble *ensemble) {
    return tdmf_accepts_if(why, !ensemble->notes, TDMF_EXCLUDED, "notes", 0, "only a page has notes") &&
           tdmf_are_foot_positions(why, ensemble) &&
           tdmf_accepts_number(why, "map", "1", (int)ensemble->map, TDMF_RETURN_MAP, TDMF_REDUCED_MAP);
}

/* ---- the plain page ------------------------------------------------------------------------------------ */

/* Gives settings a value that the plain page would need for none of them. */
static void set_to_one(const int *settings, int count, tdmf_page_point *point) {
    for (int i = 0; i < count; ++i) {
        const int at = place(settings[i]);
        double *of = at < TDMF_PAGE_PARAMETER_COUNT ? (double *)&point->p + at
                                                    : (double *)&point->x + (at - TDMF_PAGE_PARAMETER_COUNT);
        *of = 1.0;
    }
}

static bool is_plain(const tdmf_ensemble *ensemble, int64_t index) {
    const tdmf_ensemble_case *its_case = tdmf_case_of(ensemble, index);
    const tdmf_ensemble_rules *rules = &its_case->rules;
    tdmf_page_point point;
    const tdmf_ensemble_checkpoint *from = ensemble->goes_on ? &ensemble->checkpoints[index] : NULL;
    if (rules->roughness != 0.0 || (tdmf_has_terrain(rules) && !tdmf_is_one_line(rules)) ||
        (from && tdmf_mode_on_part(tdmf_page_for(ensemble->map, true), from->mode) < 0)) {
        return false;
    }
    memcpy(&point.x, from ? from->states : tdmf_runner_model.state_defaults, sizeof point.x);
    const bool has_extended = point.x.leg_work != 0.0 || point.x.external_work != 0.0;
    point.p = tdmf_page_parameters(&its_case->model->parameters, &its_case->inputs);
    tdmf_write_page_inputs(&its_case->inputs, &point.x);
    if (rules->law) {
        set_to_one(rules->law->settings, rules->law->count, &point);
    }
    if (ensemble->given) {
        set_to_one(ensemble->given->settings, ensemble->given->count, &point);
    }
    return !has_extended && tdmf_suits_plain_page(&point);
}

/* ---- the start of a run -------------------------------------------------------------------------------- */

static void prepare(tdmf_member *member) {
    const tdmf_page_part *page = &member->page;
    runner_parameters p;
    runner_states x;
    numbers(member->its_case, page->model, (double *)&p, (double *)&x);
    p.notes_compression = page->model == &tdmf_runner_model; /* a thrust needs it */
    tdmf_take_parameters(page, &p, member->run->p);
    tdmf_take_states(page, &x, member->held);
    tdmf_lay_ground(member);
}

/* Puts the run at the apex that a runner starts from. Returns false where it is none. */
static bool is_placed(tdmf_member *member, const double apex[TDMF_SECTION_COUNT]) {
    tdmf_page_run *run = member->run;
    tdmf_inputs inputs = member->its_case->inputs;
    tdmf_motion motion = {.time = 0.0};
    const tdmf_system system = {member->its_case->model, &inputs};
    tdmf_enter_segment(member, member->held);
    memcpy(run->x, member->held, (size_t)member->page.model->state_count * sizeof *run->x);
    if (member->ground.height >= 0) {
        inputs.ground.height = tdmf_ground_height(member);
        inputs.ground.slope = run->p[member->ground.slope];
    }
    if (member->ensemble->map == TDMF_REDUCED_MAP) {
        member->section->enter(run->p, member->held, apex, run->x);
        const runner_states x = states_of(member);
        memcpy(motion.state, &x, sizeof x);
    } else {
        runner_states x = states_of(member);
        tdmf_section_state_at(system, member->end->foot_x, apex, motion.state);
        memcpy(&x.seen_x, motion.state + TDMF_FOOT_X, TDMF_MECHANICAL_COUNT * sizeof(double));
        tdmf_take_states(&member->page, &x, run->x);
    }
    return !tdmf_start(system, &motion).variable && motion.state[TDMF_STRIDE_IS_OPEN] > 0.0;
}

/* True if damper, springs and inertias of the first mode show that it would take too many steps. */
static bool is_too_stiff(const tdmf_member *member, double length) {
    const tdmf_model *model = member->its_case->model;
    const tdmf_parameters *p = &model->parameters;
    const bool is_reduced = member->ensemble->map == TDMF_REDUCED_MAP;
    const double mobility = is_reduced ? model->inverse_body_mass : model->inverse_reduced_mass;
    const double turning = is_reduced ? 0.0 : mobility / (length * length);
    const double fastest = fmax(fmax(p->leg.damping * mobility, sqrt(p->leg.stiffness * mobility)),
                                fmax(p->hip.kd * turning, sqrt(p->hip.kp * turning)));
    return fastest * model->scales.time > (double)TDMF_STIFFNESS_LIMIT * member->run->order;
}

static bool start(tdmf_member *member) {
    const double *apex = member->ensemble->starts[member->index];
    if (!is_placed(member, apex)) {
        return tdmf_give_up(member, TDMF_FATE_NO_START);
    }
    member->run->stop_event = member->ground.begins;
    return !is_too_stiff(member, apex[TDMF_SECTION_LEG_LENGTH]) || tdmf_give_up(member, TDMF_FATE_UNSOLVED);
}

/* A run of the reduced map starts anew at an apex where something may change: its leg is placed as it is set.
 */
static bool start_anew(tdmf_member *member) {
    const tdmf_mode_kind *mode = &member->page.model->modes[member->run->mode];
    if (member->ensemble->map != TDMF_REDUCED_MAP || !(mode->ends || tdmf_member_changes(member))) {
        return false;
    }
    tdmf_see_from_world(member, member->run->x);
    tdmf_restart(member->run);
    member->run->stop_event = member->ground.begins;
    member->has_started = false;
    return true;
}

/* Resets inputs that an earlier call has set, and that nothing sets in this one, to those of the case. */
static void resume(tdmf_member *member) {
    for (int i = 0; i < TDMF_INPUT_COUNT; ++i) {
        const int number = tdmf_input_ranges[i].place - TDMF_PAGE_PARAMETER_COUNT;
        const int at = number < 0 ? -1 : tdmf_state_on_part(&member->page, number);
        if (at >= 0 && !tdmf_is_setting(member, TDMF_PARAMETER_COUNT + i)) {
            tdmf_member_set(member, true, at, member->held[at]);
        }
    }
}

/* The foot of the reduced map may never come down. */
static tdmf_fate too_long(const tdmf_member *member) {
    const int mode = tdmf_mode_in_whole(&member->page, member->run->mode);
    return member->ensemble->map == TDMF_REDUCED_MAP && mode == MODE_flight_calm ? TDMF_FATE_NO_STRIDE
                                                                                 : TDMF_FATE_UNDECIDED;
}

/* ---- the end of a stride ------------------------------------------------------------------------------- */

static void record_apex(tdmf_member *member) {
    tdmf_ensemble_end *end = member->end;
    const tdmf_section_kind *whole = &member->whole->sections[0];
    const runner_states x = states_of(member);
    for (int i = member->section->count; i < whole->count; ++i) { /* the leg as the reduced map places it */
        end->apex[i] = ((const double *)&x)[whole->coordinates[i]];
    }
    end->distance += x.distance;
    end->hip_work = x.work;
    end->leg_work = x.leg_work;
    end->work = end->hip_work + end->leg_work;
    end->external_work = x.external_work;
    end->damper_loss = x.damper_loss;
    end->friction_loss = x.friction_loss;
    end->impact_loss = x.impact_loss;
    end->word_code = tdmf_short_word_code(x.word_code);
}

/* Records the stride that has closed between these ends. */
static void record_stride(const tdmf_member *member, const tdmf_ensemble_end *before,
                          tdmf_ensemble_stride *record) {
    const tdmf_ensemble_end *end = member->end;
    const runner_states x = states_of(member);
    memcpy(record->apex, end->apex, sizeof record->apex);
    record->foot_x = end->foot_x;
    record->stride = tdmf_page_stride_of(&x);
    record->stride.count = end->strides + 1;
    record->liftoff_angle = x.liftoff_angle;
    record->external_work = end->external_work - before->external_work;
    record->damper_loss = end->damper_loss - before->damper_loss;
    record->friction_loss = end->friction_loss - before->friction_loss;
    record->impact_loss = end->impact_loss - before->impact_loss;
}

/* ---- the kind ------------------------------------------------------------------------------------------ */

static double longest_stride(const tdmf_member *member) {
    return TDMF_LONGEST_STRIDE * member->its_case->model->scales.time;
}

static tdmf_model_kind model(const tdmf_ensemble *ensemble, bool is_plain) {
    return tdmf_model_in_lanes(tdmf_page_for(ensemble->map, is_plain)->model);
}

static void settle_in(tdmf_member *member, bool is_plain) {
    member->page = *tdmf_page_for(member->ensemble->map, is_plain);
    member->whole = &tdmf_runner_model;
    member->section = &member->page.model->sections[0];
}

static const tdmf_member_kind kind = {
    .is_sound = is_sound,
    .is_case = is_case,
    .is_checkpoint = is_checkpoint,
    .range = range,
    .section = section,
    .numbers = numbers,
    .place = place,
    .model = model,
    .is_plain = is_plain,
    .settle_in = settle_in,
    .longest_stride = longest_stride,
    .prepare = prepare,
    .start = start,
    .resume = resume,
    .start_anew = start_anew,
    .too_long = too_long,
    .record_apex = record_apex,
    .record_stride = record_stride,
};
const tdmf_member_kind *const tdmf_runner_kind = &kind;
