/* The variations of the model's files put together: one direction, everything that changes along it. */
#include "tdmf_slip/output_variation.h"

#include "coordinate_laws.h"
#include "dynamics_laws.h"
#include "energy_laws.h"
#include "evaluation.h"

tdmf_output_variation tdmf_vary_outputs(tdmf_system system, const tdmf_mode *mode,
                                        const double state[TDMF_STATE_COUNT], const tdmf_seed *seed,
                                        const tdmf_variation *variation) {
    const tdmf_local_seed d = tdmf_local_seed_of(system.model, seed, variation);
    const tdmf_evaluation at = tdmf_evaluate(system, mode, state);
    const tdmf_evaluation d_at = tdmf_vary_evaluation(&at, &d, d.state);
    const tdmf_leg_direction direction = {at.leg.sine, at.leg.cosine};
    const tdmf_vector force = tdmf_vary_vector_on(&mode->ground, at.force, &d.mode.ground, d_at.force);
    tdmf_output_variation varied = {
        .body = tdmf_vary_body_along(state, direction, d.state),
        .com = tdmf_vary_center_of_mass_along(system.model, state, direction, &d.model, d.state),
        .contact = d_at.force,
        .contact_fx = force.x,
        .contact_fy = force.y,
        .torque = d_at.torque,
        .leg_force = d_at.leg.axial_force,
        .energy = tdmf_vary_energy_with(system.model, state, &at.leg, &d.model, d.state, &d_at.leg),
    };
    if (!mode->fallen) {
        tdmf_vary_rates_at(&at, 0.0, &d_at, tdmf_vary_external_power(&at, &d_at), varied.derivatives);
    }
    return varied;
}
