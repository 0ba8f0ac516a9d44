/* Collects what a user reads off a run. */
#include "tdmf_slip/outputs.h"

#include "coordinate_laws.h"
#include "energy_laws.h"
#include "evaluation.h"
#include "ground_line.h"

tdmf_outputs tdmf_outputs_of(tdmf_system system, const tdmf_motion *motion) {
    const tdmf_mode *mode = &motion->mode;
    const tdmf_record *record = &motion->record;
    const double *state = motion->state;
    const tdmf_evaluation at = tdmf_evaluate(system, mode, state);
    const tdmf_leg_direction direction = {at.leg.sine, at.leg.cosine};
    const tdmf_point body = tdmf_body_along(state, direction);
    const tdmf_point com = tdmf_center_of_mass_along(system.model, state, direction);
    const tdmf_energy energy = tdmf_energy_with(system.model, state, &at.leg);
    const tdmf_vector force = tdmf_vector_on(&mode->ground, at.force);
    const tdmf_outputs outputs = {
        .body = {body.x, body.y, body.vx, body.vy},
        .com = {com.x, com.y, com.vx, com.vy},
        .contact = {force.x, force.y, at.force.normal, at.force.tangential, (int)mode->contact,
                    (int)mode->contact},
        .ground = {tdmf_ground_is_pending(system.inputs, mode)},
        .leg = {at.leg.axial_force},
        .hip = {at.torque, mode->liftoff_angle, (int)mode->phase, (int)mode->phase},
        .energy = {energy.kinetic, energy.potential, energy.elastic, energy.total, record->impact_loss},
        .event = {record->event_count, record->last_event_time},
        .status = {mode->fallen},
        .stride = record->stride,
        .apex = record->apex,
    };
    return outputs;
}
