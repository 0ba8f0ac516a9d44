/* Collects what a user reads off a run. */
#include "tdmf_slip/outputs.h"

#include "tdmf_slip/contact.h"
#include "tdmf_slip/energy.h"
#include "tdmf_slip/hip.h"
#include "tdmf_slip/kinematics.h"

tdmf_outputs tdmf_outputs_of(const tdmf_model *model, const tdmf_inputs *inputs, const tdmf_mode *mode,
                             const tdmf_record *record, const double state[TDMF_STATE_COUNT]) {
    const tdmf_point body = tdmf_body(state);
    const tdmf_point com = tdmf_center_of_mass(model, state);
    const tdmf_ground_force force = tdmf_contact_force(model, inputs, mode, state);
    const tdmf_energy energy = tdmf_mechanical_energy(model, state);
    const tdmf_outputs outputs = {
        .body = {body.x, body.y, body.vx, body.vy},
        .com = {com.x, com.y, com.vx, com.vy},
        .contact = {force.fx, force.fy, (int)mode->contact, (int)mode->contact},
        .hip = {tdmf_hip_torque(model, inputs, mode, state), mode->liftoff_angle, (int)mode->phase,
                (int)mode->phase},
        .energy = {energy.kinetic, energy.potential, energy.elastic, energy.total, record->impact_loss},
        .event = {record->event_count, record->last_event_time},
        .status = {mode->fallen},
        .stride = record->stride,
        .apex = record->apex,
    };
    return outputs;
}
