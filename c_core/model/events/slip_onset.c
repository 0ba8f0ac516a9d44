/* Slip onset: the force on a sticking foot leaves the friction cone, rho mu f_n + f_t = 0 where the foot then
 * slips forwards, rho mu f_n - f_t = 0 where it slips backwards. */
#include "contact_change.h"
#include "friction.h"
#include "record.h"

static double distance_to_edge(const tdmf_evaluation *at, double sign) {
    const double friction = tdmf_static_friction(at->model, at->inputs);
    return tdmf_armed(tdmf_room_in_cone(friction, friction > 1.0, sign, &at->force), at->model->scales.force);
}

static double vary_distance_to_edge(const tdmf_evaluation *at, const tdmf_evaluation *d_at, double sign) {
    const double friction = tdmf_static_friction(at->model, at->inputs);
    const double d_friction = tdmf_vary_static_friction(at->model, at->inputs, d_at->model, d_at->inputs);
    return tdmf_vary_room_in_cone(friction, false, sign, &at->force, d_friction, &d_at->force);
}

static void slip(tdmf_run *run, tdmf_contact_mode entered) {
    tdmf_enter_contact_mode(run, entered);
    tdmf_record_event(run->record, run->time);
}

static double guard_forwards(const tdmf_evaluation *at) {
    return distance_to_edge(at, 1.0);
}

static double guard_backwards(const tdmf_evaluation *at) {
    return distance_to_edge(at, -1.0);
}

static double vary_guard_forwards(const tdmf_evaluation *at, const tdmf_direction *d,
                                  const tdmf_evaluation *d_at) {
    (void)d;
    return vary_distance_to_edge(at, d_at, 1.0);
}

static double vary_guard_backwards(const tdmf_evaluation *at, const tdmf_direction *d,
                                   const tdmf_evaluation *d_at) {
    (void)d;
    return vary_distance_to_edge(at, d_at, -1.0);
}

static void slip_forwards(tdmf_run *run) {
    slip(run, TDMF_CONTACT_SLIP_POSITIVE);
}

static void slip_backwards(tdmf_run *run) {
    slip(run, TDMF_CONTACT_SLIP_NEGATIVE);
}

const tdmf_event_kind tdmf_slip_onset_positive = {guard_forwards, vary_guard_forwards, slip_forwards, NULL};
const tdmf_event_kind tdmf_slip_onset_negative = {guard_backwards, vary_guard_backwards, slip_backwards,
                                                  NULL};
