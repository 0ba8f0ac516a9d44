/* Lift-off: the ground force vanishes; flight or graze begins. */
#include "contact_change.h"
#include "record.h"

static double normal_force(const tdmf_evaluation *at) {
    return tdmf_armed(at->force.normal, at->model->scales.force);
}

static double vary_normal_force(const tdmf_evaluation *at, const tdmf_direction *d,
                                const tdmf_evaluation *d_at) {
    (void)at;
    (void)d;
    return d_at->force.normal;
}

static void reset(tdmf_run *run) {
    tdmf_unload_foot(run);
    tdmf_record_event(run->record, run->time);
}

const tdmf_event_kind tdmf_lift_off = {normal_force, vary_normal_force, reset, NULL};
