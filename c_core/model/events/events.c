/* Which mode watches which event, and in what order those are taken that are due at one instant. */
#include "events.h"

#include "contact_mode.h"

/* Phases in which an event is watched. */
enum {
    RETRACT = 1 << TDMF_PHASE_RETRACT,
    PLACE = 1 << TDMF_PHASE_PLACE,
    ALWAYS = 1 << TDMF_PHASE_DRIVE | 1 << TDMF_PHASE_COAST | RETRACT | PLACE
};

typedef struct {
    tdmf_guard guard;
    int phases;
} watched;

static const watched in_flight[] = {{TDMF_GUARD_NEW_GROUND, ALWAYS},    {TDMF_GUARD_BODY_DOWN, ALWAYS},
                                    {TDMF_GUARD_LEG_TOO_SHORT, ALWAYS}, {TDMF_GUARD_APEX, RETRACT | PLACE},
                                    {TDMF_GUARD_TOUCHDOWN, ALWAYS},     {TDMF_GUARD_CLAMP, RETRACT}};

static const watched in_graze[] = {{TDMF_GUARD_BODY_DOWN, ALWAYS},
                                   {TDMF_GUARD_LEG_TOO_SHORT, ALWAYS},
                                   {TDMF_GUARD_APEX, RETRACT},
                                   {TDMF_GUARD_MID_STANCE, ALWAYS},
                                   {TDMF_GUARD_GRAZE_TO_CONTACT, ALWAYS},
                                   {TDMF_GUARD_GRAZE_TO_FLIGHT, ALWAYS}};

static const watched in_stick[] = {{TDMF_GUARD_BODY_DOWN, ALWAYS},
                                   {TDMF_GUARD_LEG_TOO_SHORT, ALWAYS},
                                   {TDMF_GUARD_GREATEST_COMPRESSION, ALWAYS},
                                   {TDMF_GUARD_MID_STANCE, ALWAYS},
                                   {TDMF_GUARD_LIFT_OFF, ALWAYS},
                                   {TDMF_GUARD_SLIP_ONSET_POSITIVE, ALWAYS},
                                   {TDMF_GUARD_SLIP_ONSET_NEGATIVE, ALWAYS},
                                   {TDMF_GUARD_FORCE_PEAK, ALWAYS},
                                   {TDMF_GUARD_VERTICAL_FORCE_PEAK, ALWAYS}};

static const watched in_slip[] = {{TDMF_GUARD_BODY_DOWN, ALWAYS},
                                  {TDMF_GUARD_LEG_TOO_SHORT, ALWAYS},
                                  {TDMF_GUARD_GREATEST_COMPRESSION, ALWAYS},
                                  {TDMF_GUARD_MID_STANCE, ALWAYS},
                                  {TDMF_GUARD_LIFT_OFF, ALWAYS},
                                  {TDMF_GUARD_SLIP_VELOCITY_ZERO, ALWAYS},
                                  {TDMF_GUARD_FORCE_PEAK, ALWAYS},
                                  {TDMF_GUARD_VERTICAL_FORCE_PEAK, ALWAYS}};

typedef struct {
    const watched *first, *end;
} watch_list;

#define LIST(events)                                                                                         \
    { events, (events) + sizeof(events) / sizeof((events)[0]) }

/* By contact mode, in the order in which they are taken at one instant. */
static const watch_list watched_by[] = {[TDMF_CONTACT_FLIGHT] = LIST(in_flight),
                                        [TDMF_CONTACT_STICK] = LIST(in_stick),
                                        [TDMF_CONTACT_SLIP_POSITIVE] = LIST(in_slip),
                                        [TDMF_CONTACT_SLIP_NEGATIVE] = LIST(in_slip),
                                        [TDMF_CONTACT_GRAZE] = LIST(in_graze)};

static const tdmf_event_kind *const kinds[TDMF_GUARD_COUNT] = {
    [TDMF_GUARD_TOUCHDOWN] = &tdmf_touchdown,
    [TDMF_GUARD_APEX] = &tdmf_apex_event,
    [TDMF_GUARD_CLAMP] = &tdmf_clamp,
    [TDMF_GUARD_LIFT_OFF] = &tdmf_lift_off,
    [TDMF_GUARD_SLIP_ONSET_POSITIVE] = &tdmf_slip_onset_positive,
    [TDMF_GUARD_SLIP_ONSET_NEGATIVE] = &tdmf_slip_onset_negative,
    [TDMF_GUARD_SLIP_VELOCITY_ZERO] = &tdmf_slip_end,
    [TDMF_GUARD_MID_STANCE] = &tdmf_mid_stance,
    [TDMF_GUARD_FORCE_PEAK] = &tdmf_force_peak,
    [TDMF_GUARD_GRAZE_TO_CONTACT] = &tdmf_graze_to_contact,
    [TDMF_GUARD_GRAZE_TO_FLIGHT] = &tdmf_graze_to_flight,
    [TDMF_GUARD_BODY_DOWN] = &tdmf_body_down,
    [TDMF_GUARD_LEG_TOO_SHORT] = &tdmf_leg_too_short,
    [TDMF_GUARD_GREATEST_COMPRESSION] = &tdmf_greatest_compression,
    [TDMF_GUARD_NEW_GROUND] = &tdmf_new_ground,
    [TDMF_GUARD_VERTICAL_FORCE_PEAK] = &tdmf_vertical_force_peak,
};

const tdmf_event_kind *tdmf_event_kind_of(tdmf_guard guard) {
    return kinds[guard];
}

void tdmf_guards(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                 const double state[TDMF_STATE_COUNT], double guards[TDMF_GUARD_COUNT]) {
    for (int i = 0; i < TDMF_GUARD_COUNT; ++i) {
        guards[i] = tdmf_is_mode(mode) ? 1.0 : (double)NAN;
    }
    if (mode->fallen || !tdmf_is_mode(mode)) {
        return;
    }
    const tdmf_evaluation at = tdmf_evaluate(model, inputs, mode, state);
    const watch_list list = watched_by[mode->contact];
    const int phase = 1 << mode->phase;
    for (const watched *event = list.first; event != list.end; ++event) {
        if ((event->phases & phase) != 0) {
            guards[event->guard] = kinds[event->guard]->guard(&at);
        }
    }
}

/* The guard of the transition that is taken first, if any is due. */
static tdmf_guard first_due(const tdmf_evaluation *at) {
    const watch_list list = watched_by[at->mode->contact];
    const int phase = at->mode->fallen ? 0 : 1 << at->mode->phase;
    for (const watched *event = list.first; event != list.end; ++event) {
        const tdmf_event_kind *kind = kinds[event->guard];
        if (kind->reset != NULL && (event->phases & phase) != 0 && kind->guard(at) <= 0.0) {
            return event->guard;
        }
    }
    return TDMF_GUARD_COUNT;
}

tdmf_guard tdmf_first_due(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                          const double state[TDMF_STATE_COUNT]) {
    const tdmf_evaluation at = tdmf_evaluate(model, inputs, mode, state);
    return tdmf_is_mode(mode) ? first_due(&at) : TDMF_GUARD_COUNT;
}

tdmf_evaluation tdmf_evaluate_run(const tdmf_run *run, const tdmf_mode *mode) {
    const tdmf_leg leg = tdmf_leg_along(run->model, run->inputs, mode, run->state, run->direction);
    return tdmf_evaluate_leg(run->model, run->inputs, mode, run->state, &leg);
}

bool tdmf_take_transitions(tdmf_run *run) {
    for (int links = 0; links < TDMF_CHAIN_LIMIT; ++links) {
        const tdmf_evaluation at = tdmf_evaluate_run(run, run->mode);
        const tdmf_guard due = first_due(&at);
        if (due == TDMF_GUARD_COUNT) {
            return true;
        }
        kinds[due]->reset(run);
    }
    return false;
}
