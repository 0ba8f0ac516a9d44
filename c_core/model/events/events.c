/* Which mode watches which event, and in what order those are taken that are due at one instant. */
#include "events.h"

enum {
    FLIGHT = 1 << TDMF_CONTACT_FLIGHT,
    STICK = 1 << TDMF_CONTACT_STICK,
    SLIP = 1 << TDMF_CONTACT_SLIP_POSITIVE | 1 << TDMF_CONTACT_SLIP_NEGATIVE,
    GRAZE = 1 << TDMF_CONTACT_GRAZE,
    CONTACT = STICK | SLIP,
    ANYWHERE = FLIGHT | CONTACT | GRAZE,
    DRIVE = 1 << TDMF_PHASE_DRIVE,
    RETRACT = 1 << TDMF_PHASE_RETRACT,
    ALWAYS = DRIVE | RETRACT | 1 << TDMF_PHASE_COAST | 1 << TDMF_PHASE_PLACE
};

typedef struct {
    tdmf_guard guard;
    const tdmf_event_kind *kind;
    int contacts, phases; /* in which it is watched */
} row;

static const row table[] = {
    {TDMF_GUARD_BODY_DOWN, &tdmf_body_down, ANYWHERE, ALWAYS},
    {TDMF_GUARD_LEG_TOO_SHORT, &tdmf_leg_too_short, ANYWHERE, ALWAYS},
    {TDMF_GUARD_APEX, &tdmf_apex_event, FLIGHT | GRAZE, RETRACT},
    {TDMF_GUARD_TOUCHDOWN, &tdmf_touchdown, FLIGHT, ALWAYS},
    {TDMF_GUARD_CLAMP, &tdmf_clamp, FLIGHT, RETRACT},
    {TDMF_GUARD_GRAZE_TO_CONTACT, &tdmf_graze_to_contact, GRAZE, ALWAYS},
    {TDMF_GUARD_GRAZE_TO_FLIGHT, &tdmf_graze_to_flight, GRAZE, ALWAYS},
    {TDMF_GUARD_MID_STANCE, &tdmf_mid_stance, CONTACT, DRIVE},
    {TDMF_GUARD_LIFT_OFF, &tdmf_lift_off, CONTACT, ALWAYS},
    {TDMF_GUARD_SLIP_ONSET_POSITIVE, &tdmf_slip_onset_positive, STICK, ALWAYS},
    {TDMF_GUARD_SLIP_ONSET_NEGATIVE, &tdmf_slip_onset_negative, STICK, ALWAYS},
    {TDMF_GUARD_SLIP_VELOCITY_ZERO, &tdmf_slip_end, SLIP, ALWAYS},
    {TDMF_GUARD_FORCE_PEAK, &tdmf_force_peak, CONTACT, ALWAYS},
};

enum { ROWS = sizeof table / sizeof table[0] };

static bool is_watched(const row *row, const tdmf_mode *mode) {
    return !mode->fallen && (row->contacts & 1 << mode->contact) != 0 &&
           (row->phases & 1 << mode->phase) != 0;
}

const tdmf_event_kind *tdmf_event_kind_of(tdmf_guard guard) {
    int i = 0;
    while (table[i].guard != guard) {
        ++i;
    }
    return table[i].kind;
}

void tdmf_guards(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                 const double state[TDMF_STATE_COUNT], double guards[TDMF_GUARD_COUNT]) {
    const tdmf_evaluation at = tdmf_evaluate(model, inputs, mode, state);
    for (int i = 0; i < ROWS; ++i) {
        guards[table[i].guard] = is_watched(&table[i], mode) ? table[i].kind->guard(&at) : 1.0;
    }
}

/* The row of the transition that is taken first, if any is due. */
static const row *first_due(const tdmf_evaluation *at) {
    for (int i = 0; i < ROWS; ++i) {
        if (table[i].kind->reset != NULL && is_watched(&table[i], at->mode) &&
            table[i].kind->guard(at) <= 0.0) {
            return &table[i];
        }
    }
    return NULL;
}

tdmf_guard tdmf_first_due(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                          const double state[TDMF_STATE_COUNT]) {
    const tdmf_evaluation at = tdmf_evaluate(model, inputs, mode, state);
    const row *due = first_due(&at);
    return due != NULL ? due->guard : TDMF_GUARD_COUNT;
}

/* Takes the one transition that is due first, if any is. */
static bool take_transition(tdmf_run *run, double sine, double cosine) {
    const tdmf_leg leg = tdmf_leg_at(run->model, run->state, sine, cosine);
    const tdmf_evaluation at = tdmf_evaluate_leg(run->model, run->inputs, run->mode, run->state, &leg);
    const row *due = first_due(&at);
    if (due != NULL) {
        due->kind->reset(run);
    }
    return due != NULL;
}

bool tdmf_take_transitions(tdmf_run *run) {
    /* No reset moves the leg. */
    const double sine = sin(run->state[TDMF_LEG_ANGLE]);
    const double cosine = cos(run->state[TDMF_LEG_ANGLE]);
    int links = 0;
    while (links < TDMF_CHAIN_LIMIT && take_transition(run, sine, cosine)) {
        ++links;
    }
    return links < TDMF_CHAIN_LIMIT;
}
