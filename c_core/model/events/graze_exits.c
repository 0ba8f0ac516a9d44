/* The exits of graze: the stance law loads the foot again, or the flight law lifts it. */
#include "contact_change.h"
#include "graze.h"
#include "record.h"

static double stance_lifts(const tdmf_evaluation *at) {
    return tdmf_armed(-tdmf_force_in_stance(at).normal, at->model->scales.force);
}

static double vary_stance_lifts(const tdmf_evaluation *at, const tdmf_direction *d,
                                const tdmf_evaluation *d_at) {
    return -tdmf_vary_force_in_stance(at, d, d_at).normal;
}

static double flight_holds(const tdmf_evaluation *at) {
    return tdmf_armed(tdmf_force_in_flight(at).normal, at->model->scales.force);
}

static double vary_flight_holds(const tdmf_evaluation *at, const tdmf_direction *d,
                                const tdmf_evaluation *d_at) {
    return tdmf_vary_force_in_flight(at, d, d_at).normal;
}

static void load(tdmf_run *run) {
    tdmf_load_foot(run);
    tdmf_record_event(run->record, run->time);
}

static void fly(tdmf_run *run) {
    tdmf_fly_on(run);
    tdmf_record_event(run->record, run->time);
}

const tdmf_event_kind tdmf_graze_to_contact = {stance_lifts, vary_stance_lifts, load, NULL};
const tdmf_event_kind tdmf_graze_to_flight = {flight_holds, vary_flight_holds, fly, NULL};
