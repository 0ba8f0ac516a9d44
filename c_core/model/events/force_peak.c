/* Force peak: the ground force turns from growing to falling or back. Only the record knows of it. */
#include "dynamics.h"
#include "events.h"

static double force_rate(const tdmf_evaluation *at) {
    const tdmf_scales *scales = &at->model->scales;
    return tdmf_armed_against_turning(tdmf_normal_force_rate(at), scales->force / scales->time,
                                      !at->mode->ground_force_rising);
}

const tdmf_event_kind tdmf_force_peak = {.guard = force_rate};
