/* The exits of graze: the stance law loads the foot again, or the flight law lifts it. */
#include "contact_change.h"
#include "graze.h"
#include "record.h"

static double stance_lifts(const tdmf_evaluation *at) {
    return tdmf_armed(-tdmf_load_in_stance(at), at->model->scales.force);
}

static double vary_stance_lifts(const tdmf_evaluation *at, const tdmf_direction *d,
                                const tdmf_evaluation *d_at) {
    (void)d;
    return -tdmf_vary_load_in_stance(at, d_at);
}

static double flight_holds(const tdmf_evaluation *at) {
    return tdmf_armed(tdmf_load_in_flight(at), at->model->scales.force);
}

static double vary_flight_holds(const tdmf_evaluation *at, const tdmf_direction *d,
                                const tdmf_evaluation *d_at) {
    (void)d;
    return tdmf_vary_load_in_flight(at, d_at);
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
