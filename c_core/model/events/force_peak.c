/* Force peaks: the ground force, across the ground or vertically, turns from growing to falling or back. Only
 * the record knows of it. */
#include "dynamics.h"
#include "event_declarations.h"
#include "record.h"

static double armed(const tdmf_evaluation *at, double rate, bool rising) {
    const double scaled = rate / (at->model->scales.force / at->model->scales.time);
    return (rising ? scaled : -scaled) + TDMF_DEAD_BAND;
}

double tdmf_armed_force_peak(const tdmf_evaluation *at) {
    return armed(at, tdmf_force_rate(at).normal, at->mode->ground_force_rising);
}

/* On level ground it is the same force, and is not watched twice. */
double tdmf_armed_vertical_force_peak(const tdmf_evaluation *at) {
    const tdmf_ground_line *ground = &at->mode->ground;
    return ground->sine == 0.0
               ? 1.0
               : armed(at, tdmf_vector_on(ground, tdmf_force_rate(at)).y, at->mode->vertical_force_rising);
}

void tdmf_observe(tdmf_system system, tdmf_motion *motion) {
    if (tdmf_in_contact(&motion->mode)) {
        const tdmf_evaluation at = tdmf_evaluate(system, &motion->mode, motion->state);
        tdmf_observe_evaluated(&at, motion);
    }
}

void tdmf_observe_evaluated(const tdmf_evaluation *at, tdmf_motion *motion) {
    tdmf_mode *mode = &motion->mode;
    if (tdmf_in_contact(mode)) {
        const tdmf_ground_force rate = tdmf_force_rate(at);
        tdmf_record_force(&motion->record, at->force.normal, tdmf_vector_on(&mode->ground, at->force).y);
        mode->ground_force_rising = rate.normal > 0.0;
        mode->vertical_force_rising = tdmf_vector_on(&mode->ground, rate).y > 0.0;
    }
}
